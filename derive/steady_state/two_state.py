"""The whole derivation of a two-state family: towers, steps, programs and kernels."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import sympy as sp

from gainproof.derive.derivation import Derivation, Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.pages.kernel_formulas import FIRST, SECOND, formula_of
from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Kernel, Module, closed
from gainproof.derive.steady_state.context import Context, context
from gainproof.derive.steady_state.gain_towers import (
    Side,
    last_roots,
    range_towers,
    sides,
)
from gainproof.derive.steady_state.kernels import (
    FORMULAS,
    KERNELS,
    accurate_gains,
    alpha_graph,
    beta_graph,
    index_graph,
    largest_beta,
    pole_graph,
)
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX, LATEX, ROOT_3
from gainproof.derive.steady_state.page_slots import (
    TURN_TOWER,
    ends,
    hints,
    inverse_roots,
    inverse_tower,
    pole_limit,
    slots,
    turn_towers,
)
from gainproof.derive.steady_state.pole_towers import (
    ABOVE,
    BELOW,
    SIDE,
    G,
    complex_tower,
    half_width,
    middle_size,
    real_tower,
    turning_root,
)
from gainproof.derive.steady_state.textbook import textbook_forms
from gainproof.derive.steady_state.towers import at_once_roots, graph_roots
from gainproof.derive.subject import Program, Subject, in_double_words

ACCURATE_GAINS = in_double_words("gains")


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    title = f"{c.model.title}: steady state with measured position"
    shown = {name: graph for name, graph in graphs.items() if name != ACCURATE_GAINS}
    found = page_module(FORMULAS, shown, c.model.name, title, _words(c))
    kernels = tuple(_with_more(c, kernel, graphs[ACCURATE_GAINS]) for kernel in found.kernels)
    return replace(found, kernels=kernels, results="_two_state_results")


def _with_more(c: Context, kernel: Kernel, accurate: Graph) -> Kernel:
    """With the graph in double-words, and the end of a domain that is no rational number."""
    (given,) = kernel.inputs
    if kernel.name == "gains":
        wide = closed(given.name, given.meaning, Fraction(1, 2**400), 2**400)
        return replace(kernel, accurate=wide, accurate_graph=accurate)
    if given.name == "beta":
        return replace(kernel, inputs=(replace(given, upper=largest_beta(c.e)),))
    return kernel


def _words(c: Context) -> dict[str, str]:
    e, n = c.e, c.n
    return {
        "noise_ratio": str(c.model.noise_ratio),
        "largest_beta": "2",
        "kappa": "2/Lambda" if e == 0 else f"sqrt(4/Lambda^2 + {e / 4})",
        "beside": str((1 + e) / 4),
        "raised": f"(1 + {e / 2}/kappa)" if e else "1",
        "h": f"sqrt(16/Lambda + {'' if e == 1 else f'{e} '}Lambda)" if e else "4/p",
        "less": str(1 - n),
        "rate": f"(rho - {n})" if n else "rho",
        "e": str(e),
        "product": ""
        if e
        else "\nIt is a product with Lambda - 4/(3 + 2 sqrt(3)), which keeps its digits.",
        "relation": str(c.spectrum.relation),
    }


SCALE = "predicted_11_scale"
"""What the second derivative of M11 is measured by for e > 0: its terms, added."""
ON_TWO_SIDES = ("gains", "predictor_gains")
PAGE = "measured-position-two-states"
POLES = "closed_loop_poles"


def derive_two_state(model: Model, sources: tuple[str, ...], folder: Path = FOLDER) -> Subject:
    """Derive everything about the steady state of a two-state model with measured position.

    The steps are those of the page `measured-position-two-states` in `folder`. Raises ModelError,
    naming the reason, for a model outside the method's reach; PageError for a mistake of the page.
    """
    c = context(model)
    graphs, gain_sides = _graphs(c), sides(c.e, c.n)
    towers = (c.tower, inverse_tower(c), *turn_towers(c))
    if c.e != 1:
        towers += (complex_tower(c.e, c.n), real_tower(c.e, c.n))
    towers += (*(side.tower for side in gain_sides), *range_towers(c.e))
    kernels = (
        *_kernel_steps(c, graphs, gain_sides),
        *_pole_steps(c, graphs[POLES]),
    )
    page = written(
        PAGE,
        Given(
            towers=towers,
            models={"model": c.model_data},
            slots={"": slots(c)},
            hints=hints(c),
            ends=ends(c),
            steps={"kernels": kernels},
        ),
        folder,
    )
    latex = {**LATEX, **{quantity.name: quantity.latex for quantity in model.quantities}}
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(page.opening, page.steps, sources, latex),
        towers={tower.name: tower for tower in towers},
        programs={name: Program(_inputs(name), graph) for name, graph in graphs.items()},
        module=kernel_module(c, graphs),
        textbook=lambda: textbook_forms(c),
    )


def _inputs(name: str) -> Mapping[str, str]:
    for gain in ("alpha", "beta"):
        if name.endswith(f"from_{gain}"):
            return {gain: gain}
    return {"tracking_index": "tracking_index"}


def _graphs(c: Context) -> dict[str, Graph]:
    graphs = {name: index_graph(c.e, c.n, name) for name in KERNELS}
    return graphs | {
        ACCURATE_GAINS: accurate_gains(c.e, c.n),
        POLES: pole_graph(c.e, c.n),
        "index_from_alpha": alpha_graph(c.e, "tracking_index"),
        "beta_from_alpha": alpha_graph(c.e, "beta"),
        "index_from_beta": beta_graph(c.e, "tracking_index"),
        "alpha_from_beta": beta_graph(c.e, "alpha"),
    }


def _kernel_steps(
    c: Context, graphs: Mapping[str, Graph], gain_sides: tuple[Side, ...]
) -> Iterator[Step]:
    """Every kernel but the poles computes what its outputs are called."""
    roots = {
        **graph_roots(c.e),
        **at_once_roots(c.e),
        **inverse_roots(c),
        **last_roots(),
        "root_of_3": ROOT_3,
    }
    towers = {"index_from_beta": inverse_tower(c).name}
    if c.e == 0:
        towers["predicted_covariance_second_derivatives"] = TURN_TOWER
    for name, graph in graphs.items():
        outputs = {output: _meant(name, output) for output in graph["outputs"]}
        if name in ON_TWO_SIDES and gain_sides:
            for side in gain_sides:
                tower, hint = side.tower.name, {"branches": side.branches, "gaps": side.gaps}
                yield kernel_step(
                    name, graph, outputs, tower, f"{name}_{tower}", roots=side.roots, **hint
                )
        elif name != POLES:
            yield kernel_step(name, graph, outputs, towers.get(name, "main"), roots=roots)


def _meant(kernel: str, output: str) -> sp.Expr:
    """What an output of a kernel stands for."""
    if output == SCALE:
        return -_second("alpha") * DEVIATION**4
    name = formula_of(kernel, output)
    plain = name.removeprefix(SECOND).removeprefix(FIRST)
    value = {"position": "predictor_position", "velocity": "beta"}.get(plain, plain)
    if name.startswith(SECOND):
        return _second(value)
    return real(value) if plain == name else sp.Derivative(real(value), INDEX)


def _second(name: str) -> sp.Expr:
    """The second derivative of a named quantity by the index."""
    return sp.Derivative(real(name), (INDEX, 2))


def _pole_steps(c: Context, graph: Graph) -> Iterator[Step]:
    """The kernel of the poles computes those of the derivation, on each side of their limit."""
    roots, limit = graph_roots(c.e), pole_limit(c.e)
    if limit is None:
        found = _pair(1 - (ALPHA + BETA) / 2, half_width(c.e, c.n))
        yield kernel_step(POLES, graph, found, name="poles", roots=roots)
        return
    roots |= {"turning_root": turning_root(c.e), "below": BELOW, "above": ABOVE}
    choices, gap = [f"choice_{number}" for number in range(1, 7)], limit / SIDE
    negative = {"distance": "negative", "middle_size": "negative"}
    yield kernel_step(
        POLES,
        graph,
        _pair(real("pole_real"), real("pole_imaginary")),
        "complex_poles",
        "complex_poles",
        roots=roots,
        branches={**dict.fromkeys(choices, "then"), "distance": "positive"},
        gaps={**dict.fromkeys(choices, gap), "distance": gap / 4},
    )
    yield kernel_step(
        POLES,
        graph,
        _real_poles(),
        "real_poles",
        "real_poles",
        roots=roots,
        branches={**dict.fromkeys(choices, "else"), **negative},
        gaps={
            **dict.fromkeys(choices, G**2),
            "distance": G**2 / 4,
            "middle_size": middle_size(c.e),
        },
    )


def _pair(middle: sp.Expr, width: sp.Expr) -> dict[str, sp.Expr]:
    return {
        "first_real": middle,
        "first_imaginary": width,
        "second_real": middle,
        "second_imaginary": -width,
        "first_modulus": 1 / DEVIATION,
        "second_modulus": 1 / DEVIATION,
    }


def _real_poles() -> dict[str, sp.Expr]:
    first, second = real("first_pole"), real("second_pole")
    return {
        "first_real": first,
        "first_imaginary": sp.Integer(0),
        "second_real": second,
        "second_imaginary": sp.Integer(0),
        "first_modulus": -first,
        "second_modulus": -second,
    }
