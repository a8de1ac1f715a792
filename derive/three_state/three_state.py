"""The whole derivation of a three-state family: towers, steps, programs and kernels."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Derivation, Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.model import Model, scale
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.pages.kernel_formulas import FIRST, SCALE, SECOND, formula_of
from gainproof.derive.printer.graph import Graph
from gainproof.derive.source import ALGEBRA
from gainproof.derive.subject import Program, Subject
from gainproof.derive.three_state import page_hints, page_slots, pole_tower
from gainproof.derive.three_state.accurate_gains import (
    accurate_graph,
    accurate_inputs,
    accurate_meaning,
    accurate_roots,
    within_reach,
)
from gainproof.derive.three_state.context import Context, context
from gainproof.derive.three_state.kernel_poles import POLES
from gainproof.derive.three_state.kernel_tower import kernel_tower, kernel_tower_steps
from gainproof.derive.three_state.kernels import kernel_graphs, kernel_roots
from gainproof.derive.three_state.module import ACCURATE_GAINS, kernel_module
from gainproof.derive.three_state.names import DEVIATION, INDEX, LATEX, XI
from gainproof.derive.three_state.pole_places import turning
from gainproof.derive.three_state.pole_tower import MEAN, MODULUS, REAL, SQUARE
from gainproof.derive.three_state.second_derivative_tower import bending_tower
from gainproof.derive.three_state.textbook import textbook_forms

NAMED = {
    "position": real("predictor_position"),
    "velocity": real("predictor_velocity"),
    "acceleration": real("gamma"),
    "pole_product": 1 - real("alpha"),
}


def meant(kernel: str, output: str) -> sp.Expr:
    """What an output of a kernel stands for."""
    name = formula_of(kernel, output)
    plain = name.removeprefix(SECOND).removeprefix(FIRST)
    order = 2 if name.startswith(SECOND) else int(plain != name)
    if plain.endswith(SCALE):
        return _parts(plain.removesuffix(SCALE), order)
    value = NAMED.get(plain, real(plain))
    return sp.Derivative(value, (INDEX, order)) if order else value


def _parts(name: str, order: int) -> sp.Expr:
    """The sum of the parts whose difference a derivative is.

    Those of M11 are (sigma psi/Lambda)^2 and sigma^2 psi chi/Lambda^2; the falling part of M12 is
    -M12' xi'/xi; those of X are the derivative of M and of what the update takes from it.
    """
    value = real(name)
    own = sp.Derivative(value, (INDEX, order))
    if name == "predicted_11":
        return -sp.Derivative(real("alpha"), (INDEX, 2)) * DEVIATION**4
    if name == "predicted_12":
        slope = sp.Derivative(value, INDEX)
        return own - 2 * slope * sp.Derivative(XI, INDEX) / XI
    before = real(name.replace("updated", "predicted"))
    return 2 * sp.Derivative(before, (INDEX, order)) - own


PAGE = "measured-position-three-states"


def derive_three_state(
    model: Model, sources: tuple[str, ...], twin: Model | None = None, folder: Path = FOLDER
) -> Subject:
    """Derive everything about the steady state of three kinematic states, position measured.

    `twin` is a model of another process noise with the same spectrum, whose covariances are larger
    by Lambda^2 at place 33: the derivation then says so and proves it.

    Raises ModelError, naming the reason, for a model outside the method's reach.
    """
    c = context(model)
    found = turning(c)
    graphs = kernel_graphs(c)
    if within_reach(c.spectrum):
        graphs[ACCURATE_GAINS] = accurate_graph(c.spectrum)
    roots = kernel_tower(c)
    bent, single = bending_tower(c), _pole_towers(c)
    towers = {tower.name: tower for tower in (c.tower, bent, found.tower, roots, *single)}
    hints = page_hints.hints(c)
    page = written(
        PAGE,
        Given(
            towers=tuple(towers.values()),
            models={"scaled": c.model_data},
            slots={"": page_slots.slots(c, bent, scale(twin) if twin else None, hints)},
            hints=hints,
            ends=page_slots.ends(c),
            steps={
                "equations-of-kernels": kernel_tower_steps(c),
                "kernels": _program_steps(c, graphs),
            },
        ),
        folder,
    )
    latex = {
        **page.latex,
        **LATEX,
        **{name: rf"\sqrt{{{name[5:]}}}" for name in _roots_of_numbers(towers.values())},
        **{quantity.name: quantity.latex for quantity in model.quantities},
    }
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(
            page.opening,
            page.steps,
            sources if found.value is None else (*sources, ALGEBRA.key),
            latex,
        ),
        towers=page.towers,
        programs={name: Program(_inputs(name), graph) for name, graph in graphs.items()},
        module=kernel_module(c, graphs),
        textbook=lambda: textbook_forms(c),
    )


def _roots_of_numbers(towers: Iterable[Tower]) -> list[str]:
    found = (entry.symbol for tower in towers for entry in tower.generators)
    return [symbol for symbol in found if symbol.startswith("root_")]


def _inputs(name: str) -> Mapping[str, str]:
    if name == ACCURATE_GAINS:
        return accurate_inputs()
    entry = "alpha" if name.endswith("from_alpha") else "tracking_index"
    return {entry: entry}


def _tower(name: str) -> str:
    """The name of the tower in which a kernel is evaluated."""
    if name == POLES:
        return pole_tower.NAME
    return "main" if name.endswith("from_alpha") else "kernels"


def _program_steps(c: Context, graphs: Mapping[str, Graph]) -> list[Step]:
    """Every kernel computes what its outputs are called."""
    return [
        kernel_step(name, graph, _meanings(c, name, graph), _tower(name), roots=_roots(c, name))
        for name, graph in graphs.items()
    ]


def _roots(c: Context, name: str) -> Mapping[str, sp.Expr]:
    return accurate_roots() if name == ACCURATE_GAINS else kernel_roots(c, name)


def _meanings(c: Context, name: str, graph: Graph) -> Mapping[str, sp.Expr]:
    if name == POLES:
        return _poles_meant(c)
    if name == ACCURATE_GAINS:
        return {
            output: accurate_meaning(output) or meant("gains", output)
            for output in graph["outputs"]
        }
    return {output: meant(name, output) for output in graph["outputs"]}


def _pole_towers(c: Context) -> tuple[Tower, ...]:
    """That of the poles; none where the noise is out of reach."""
    return (pole_tower.pole_tower(c),) if pole_tower.within_reach(c.spectrum) else ()


def _poles_meant(c: Context) -> dict[str, sp.Expr]:
    """What the outputs of the kernel stand for."""
    if not c.spectrum.rational_in_root:
        return {str(output): output for output in (REAL, MODULUS, MEAN, SQUARE)}
    return {
        "real_pole": real("w"),
        "modulus": MODULUS,
        "half_sum": (XI**2 - 8) / (XI * (XI + 2)),
        "quarter_discriminant": 4 * (16 - 3 * XI**2) / (XI * (XI + 2)) ** 2,
    }
