"""The kernels of a three-state family as expression graphs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from fractions import Fraction
from pathlib import Path
from typing import Any

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.pages.kernel_formulas import FIRST, Value, formula_graph, formula_of
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state import pole_tower
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.kernel_basis import UNIT, KernelBasis, kernel_basis
from gainproof.derive.three_state.kernel_poles import POLES, pole_graph
from gainproof.derive.three_state.names import DELTA, ETA, GAINS, PREDICTED, UPDATED, XI

# Where m1 = 1 and m2 = 0 all are rational in w = sqrt(1 - alpha), and 1 - w = alpha/(1 + w):
# beta = 2 (1 - w)^2, gamma = 2 (1 - w)^3/(1 + w), Lambda = gamma/w.

Forms = dict[str, Any]


def gains_from_alpha(alpha: Any, w: Any) -> Forms:
    """beta and gamma; `w` is the root of 1 - alpha."""
    step = alpha / (w + 1)
    square = step * step
    return {"beta": square * 2, "gamma": (square * 2) * (step / (w + 1))}


def index_from_alpha(alpha: Any, w: Any) -> Forms:
    """The index."""
    step = alpha / (w + 1)
    square = step * step
    return {"tracking_index": ((square * 2) * (step / (w + 1))) / w}


FORMULAS = Path(__file__).with_name("kernels.md")
"""What the outputs are computed by; says how a formula is checked and how to make another."""

PREDICTOR = ("position", "velocity", "acceleration")
KERNELS: Mapping[str, tuple[str, ...]] = {
    "gains": GAINS,
    "gain_derivatives": GAINS,
    "gains_with_derivatives": (*GAINS, *(f"{FIRST}{name}" for name in GAINS)),
    "predictor_gains": PREDICTOR,
    "predictor_gain_derivatives": PREDICTOR,
    "innovation_deviation": ("innovation_deviation",),
    "pole_product": ("pole_product",),
    "predicted_covariance": PREDICTED,
    "predicted_covariance_derivatives": PREDICTED,
    "updated_covariance": UPDATED,
    "updated_covariance_derivatives": UPDATED,
    "gain_second_derivatives": GAINS,
    "predictor_gain_second_derivatives": PREDICTOR,
    "predicted_covariance_second_derivatives": PREDICTED[2:],
    "predicted_position_second_derivatives": PREDICTED[:2],
    "updated_covariance_second_derivatives": UPDATED[3:],
}
"""Outputs of the kernels of the index."""


def kernel_graphs(c: Context) -> dict[str, Graph]:
    """Graphs by the names of their kernels."""
    graphs: dict[str, Graph] = {}
    for name in KERNELS:
        # a noise without a form that has no subtraction has no such kernel
        with suppress(ArithmeticError):
            graphs[name] = _index_graph(c, name)
    if pole_tower.within_reach(c.spectrum):
        graphs[POLES] = pole_graph(c.spectrum)
    if c.spectrum.rational_in_root:
        graphs |= {
            "index_from_alpha": _alpha_graph(index_from_alpha),
            "gains_from_alpha": _alpha_graph(gains_from_alpha),
        }
    return graphs


def kernel_roots(c: Context, kernel: str) -> Mapping[str, sp.Expr]:
    """Tower values of the named square roots and of the fixed point.

    The roots b and c stand in every start, which proves nothing.
    """
    if kernel == POLES:
        return pole_tower.kernel_roots(c)
    r = real("fourth_root")
    return {
        "p": r**2,
        "r": r,
        "c_scaled": rational(UNIT) * DELTA * r**2 / 8,
        "x": XI * r / 2,
        "e": ETA * r**2 / 4,
        "eta_of_map": ETA * r**2 / 4,
        "w": real("w"),
    }


def _index_graph(c: Context, kernel: str) -> Graph:
    """The graph of a kernel."""
    builder = GraphBuilder()
    basis = kernel_basis(builder, c.spectrum)
    outputs = {output: formula_of(kernel, output) for output in KERNELS[kernel]}
    return formula_graph(builder, FORMULAS, _known(c, basis), outputs, basis.names)


def _known(c: Context, k: KernelBasis) -> Mapping[str, Value]:
    """The nodes and numbers that formulas are over."""
    s, q = c.spectrum, c.model.process_noise.applyfunc(sp.Rational)
    rate = q[1, 1] - q[0, 1] - q[0, 2] / 2 - q[1, 2] / 4
    nodes = {"Lambda": k.index, "p": k.p, "r": k.r, "x": k.x, "e": k.e, "c": k.c}
    noise = {"q13": q[0, 2], "q23": q[1, 2], "rate": rate}
    numbers = {"m1": s.m1, "m2": s.m2, "a1": s.a1, "a2": s.a2}
    return nodes | numbers | {name: Fraction(str(number)) for name, number in noise.items()}


def _alpha_graph(form: Callable[[Any, Any], Mapping[str, Any]]) -> Graph:
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    w = builder.sqrt(1 - alpha)
    return builder.graph(dict(form(alpha, w)), {"w": w})
