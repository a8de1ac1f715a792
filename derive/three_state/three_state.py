"""The whole derivation of a three-state family: towers, steps, programs and kernels."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.model import Model, ScaledModel, scale
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation
from gainproof.derive.source import ALGEBRA
from gainproof.derive.subject import Program, Subject
from gainproof.derive.three_state import pole_tower
from gainproof.derive.three_state.accurate_gains import (
    accurate_graph,
    accurate_inputs,
    accurate_meaning,
    accurate_roots,
    within_reach,
)
from gainproof.derive.three_state.bending import bending_tower
from gainproof.derive.three_state.context import Context, context
from gainproof.derive.three_state.kernel_meanings import meant
from gainproof.derive.three_state.kernel_poles import POLES
from gainproof.derive.three_state.kernel_tower import kernel_tower, kernel_tower_steps
from gainproof.derive.three_state.kernels import kernel_graphs, kernel_roots
from gainproof.derive.three_state.module import ACCURATE_GAINS, kernel_module
from gainproof.derive.three_state.names import LATEX
from gainproof.derive.three_state.steps_change import change_steps
from gainproof.derive.three_state.steps_curvature import curvature_steps
from gainproof.derive.three_state.steps_curvature_ends import curvature_end_steps
from gainproof.derive.three_state.steps_ends import end_steps
from gainproof.derive.three_state.steps_gains import gain_steps
from gainproof.derive.three_state.steps_inverse import inverse_steps, twin_steps
from gainproof.derive.three_state.steps_model import model_steps
from gainproof.derive.three_state.steps_poles import pole_steps, turning
from gainproof.derive.three_state.steps_proof import covariance_steps, proof_steps
from gainproof.derive.three_state.steps_single_poles import (
    poles_meant,
    single_pole_steps,
    single_pole_towers,
)
from gainproof.derive.three_state.steps_spectrum import spectrum_steps
from gainproof.derive.three_state.textbook import textbook_forms

OPENING = (
    "A position is measured at a fixed interval; the state holds the position, its rate and the "
    "rate of that. How much of each innovation should a Kalman filter in its steady state believe?"
)


def derive_three_state(
    model: Model, sources: tuple[str, ...], twin: Model | None = None
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
    bent, single = bending_tower(c), single_pole_towers(c)
    latex = {
        **LATEX,
        **{name: rf"\sqrt{{{name[5:]}}}" for tower in single for name in _roots_of_numbers(tower)},
        **{quantity.name: quantity.latex for quantity in model.quantities},
    }
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(
            OPENING,
            (*_steps(c, bent, scale(twin) if twin else None), *_program_steps(c, graphs)),
            sources if found.value is None else (*sources, ALGEBRA.key),
            latex,
        ),
        towers={tower.name: tower for tower in (c.tower, bent, found.tower, roots, *single)},
        programs={name: Program(_inputs(name), graph) for name, graph in graphs.items()},
        module=kernel_module(c, graphs),
        textbook=lambda: textbook_forms(c),
    )


def _steps(c: Context, bent: Tower, twin: ScaledModel | None) -> tuple[Step, ...]:
    return (
        *model_steps(c),
        *spectrum_steps(c),
        *gain_steps(c),
        *covariance_steps(c),
        *proof_steps(c),
        *change_steps(c),
        *curvature_steps(c),
        *end_steps(c),
        *curvature_end_steps(c, bent),
        *pole_steps(c),
        *single_pole_steps(c),
        *inverse_steps(c),
        *twin_steps(c, twin),
        *kernel_tower_steps(c),
    )


def _roots_of_numbers(tower: Tower) -> list[str]:
    return [entry.symbol for entry in tower.generators if entry.symbol.startswith("root_")]


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
        Step(
            f"kernel-{name.replace('_', '-')}",
            f"The kernel {name} computes what it says.",
            Relation("program", {"program": name, "outputs": _meanings(c, name, graph)}),
            "Evaluate the kernel's graph in the tower.",
            tower=_tower(name),
            hint={"graph": graph, "roots": _roots(c, name)},
            shown=False,
        )
        for name, graph in graphs.items()
    ]


def _roots(c: Context, name: str) -> Mapping[str, sp.Expr]:
    return accurate_roots() if name == ACCURATE_GAINS else kernel_roots(c, name)


def _meanings(c: Context, name: str, graph: Graph) -> Mapping[str, sp.Expr]:
    if name == POLES:
        return poles_meant(c)
    if name == ACCURATE_GAINS:
        return {
            output: accurate_meaning(output) or meant("gains", output)
            for output in graph["outputs"]
        }
    return {output: meant(name, output) for output in graph["outputs"]}
