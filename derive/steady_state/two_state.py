"""The whole derivation of a two-state family: towers, steps, programs and kernels."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation
from gainproof.derive.steady_state import forms
from gainproof.derive.steady_state.context import Context, context
from gainproof.derive.steady_state.curvature_kernels import SCALE
from gainproof.derive.steady_state.curvature_module import second_derivative_graphs
from gainproof.derive.steady_state.gain_towers import (
    Side,
    last_roots,
    range_towers,
    sides,
)
from gainproof.derive.steady_state.kernels import alpha_graph, beta_graph, index_graph, pole_graph
from gainproof.derive.steady_state.module import ACCURATE_GAINS, INDEX_KERNELS, kernel_module
from gainproof.derive.steady_state.names import DEVIATION, INDEX, LATEX
from gainproof.derive.steady_state.steps_curvature import curvature_steps, second
from gainproof.derive.steady_state.steps_curvature_ends import curvature_end_steps
from gainproof.derive.steady_state.steps_ends import end_steps
from gainproof.derive.steady_state.steps_gain_kernels import side_steps
from gainproof.derive.steady_state.steps_gains import gain_steps
from gainproof.derive.steady_state.steps_model import model_steps
from gainproof.derive.steady_state.steps_pole_kernel import pole_programs
from gainproof.derive.steady_state.steps_poles import pole_steps, pole_towers
from gainproof.derive.steady_state.steps_proof import covariance_steps, proof_steps
from gainproof.derive.steady_state.steps_turn import (
    ROOT_3,
    TURN_TOWER,
    turn_steps,
    turn_tower,
)
from gainproof.derive.steady_state.steps_use import (
    derivative_steps,
    inverse_roots,
    inverse_steps,
    inverse_tower,
)
from gainproof.derive.steady_state.textbook import textbook_forms
from gainproof.derive.steady_state.towers import at_once_roots, graph_roots
from gainproof.derive.subject import Program, Subject

ON_TWO_SIDES = ("gains", "predictor_gains")
OPENING = (
    "A position is measured at a fixed interval; the state holds the position and its rate. "
    "How much of each innovation should a Kalman filter in its steady state believe?"
)


def derive_two_state(model: Model, sources: tuple[str, ...]) -> Subject:
    """Derive everything about the steady state of a two-state model with measured position.

    Raises ModelError, naming the reason, for a model outside the method's reach.
    """
    c = context(model)
    graphs, gain_sides = _graphs(c), sides(c.e, c.n)
    steps = (
        *model_steps(c),
        *gain_steps(c),
        *covariance_steps(c),
        *proof_steps(c),
        *pole_steps(c),
        *derivative_steps(c),
        *curvature_steps(c),
        *turn_steps(c),
        *end_steps(c),
        *curvature_end_steps(c),
        *inverse_steps(c),
        *side_steps(c, gain_sides),
        *_program_steps(c, graphs, gain_sides),
        *pole_programs(c, graphs["closed_loop_poles"]),
    )
    latex = {**LATEX, **{quantity.name: quantity.latex for quantity in model.quantities}}
    towers = (c.tower, inverse_tower(c), *turn_tower(c), *pole_towers(c))
    towers += (*(side.tower for side in gain_sides), *range_towers(c.e))
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(OPENING, steps, sources, latex),
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
    graphs = {name: index_graph(c.e, c.n, *parts) for name, parts in INDEX_KERNELS.items()}
    graphs[ACCURATE_GAINS] = index_graph(c.e, c.n, forms.gains)
    graphs |= second_derivative_graphs(c.e, c.n)
    return graphs | {
        "closed_loop_poles": pole_graph(c.e, c.n),
        "index_from_alpha": alpha_graph(c.e, "tracking_index"),
        "beta_from_alpha": alpha_graph(c.e, "beta"),
        "index_from_beta": beta_graph(c.e, "tracking_index"),
        "alpha_from_beta": beta_graph(c.e, "alpha"),
    }


def _program_steps(
    c: Context, graphs: Mapping[str, Graph], gain_sides: tuple[Side, ...]
) -> list[Step]:
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
    found: list[Step] = []
    for name, graph in graphs.items():
        if name == "closed_loop_poles":
            continue
        if name in ON_TWO_SIDES and gain_sides:
            found += [_on_one_side(name, graph, side) for side in gain_sides]
            continue
        sentence = f"The kernel {name} computes what it says."
        hint = {"graph": graph, "roots": roots}
        found.append(_program_step(name, graph, "", sentence, towers.get(name, "main"), hint))
    return found


def _on_one_side(name: str, graph: Graph, side: Side) -> Step:
    """A kernel that chooses, where it chooses so."""
    where = side.tower.name.replace("_", "-")
    sentence = f"The kernel {name} computes what it says, {where.replace('-', ' ')}."
    hint = {"graph": graph, "roots": side.roots, "branches": side.branches, "gaps": side.gaps}
    return _program_step(name, graph, f"-{where}", sentence, side.tower.name, hint)


def _program_step(
    name: str, graph: Graph, ending: str, sentence: str, tower: str, hint: Mapping[str, Any]
) -> Step:
    outputs = {output: _meant(name, output) for output in graph["outputs"]}
    return Step(
        f"kernel-{name.replace('_', '-')}{ending}",
        sentence,
        Relation("program", {"program": name, "outputs": outputs}),
        "Evaluate the kernel's graph in the tower.",
        tower=tower,
        hint=hint,
        shown=False,
    )


def _meant(kernel: str, output: str) -> sp.Expr:
    """What an output of a kernel stands for."""
    named = {"position": "predictor_position", "velocity": "beta"}
    if output == SCALE:
        return -second("alpha") * DEVIATION**4
    if kernel.endswith("_second_derivatives"):
        return second(named.get(output, output))
    if output.startswith("d_"):
        return sp.Derivative(real(named.get(output[2:], output[2:])), INDEX)
    value = real(named.get(output, output))
    return (
        sp.Derivative(value, INDEX)
        if kernel.endswith("_derivatives") and (kernel != "gains_with_derivatives")
        else value
    )
