"""The kernels of a three-state family as expression graphs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state import (
    inverses,
    kernel_curvature_covariances,
    kernel_curvature_gains,
    kernel_derivatives,
    kernel_forms,
    kernel_updated,
    pole_tower,
)
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.kernel_basis import UNIT, KernelBasis, kernel_basis
from gainproof.derive.three_state.kernel_forms import Noise
from gainproof.derive.three_state.kernel_poles import POLES, pole_graph
from gainproof.derive.three_state.names import DELTA, ETA, XI

FormsOf = Callable[[KernelBasis, Noise], Mapping[str, Any]]

INDEX_KERNELS: Mapping[str, tuple[FormsOf, ...]] = {
    "gains": (kernel_forms.gains,),
    "gain_derivatives": (kernel_derivatives.gain_derivatives,),
    "gains_with_derivatives": (kernel_forms.gains, kernel_derivatives.gain_derivatives),
    "predictor_gains": (kernel_forms.predictor_gains,),
    "predictor_gain_derivatives": (kernel_derivatives.predictor_gain_derivatives,),
    "innovation_deviation": (kernel_forms.innovation,),
    "pole_product": (kernel_forms.pole_product,),
    "predicted_covariance": (kernel_forms.predicted_covariance,),
    "predicted_covariance_derivatives": (kernel_derivatives.predicted_covariance_derivatives,),
    "updated_covariance": (kernel_updated.updated_covariance,),
}
FURTHER: Mapping[str, FormsOf] = {
    "updated_covariance_derivatives": kernel_updated.updated_covariance_derivatives,
    "gain_second_derivatives": kernel_curvature_gains.gain_second_derivatives,
    "predictor_gain_second_derivatives": kernel_curvature_gains.predictor_gain_second_derivatives,
    "predicted_covariance_second_derivatives": kernel_curvature_covariances.predicted,
    "predicted_position_second_derivatives": kernel_curvature_covariances.predicted_position,
    "updated_covariance_second_derivatives": kernel_curvature_covariances.updated,
}
"""Kernels that all families of the catalogue have, and some noises of own models have not."""

SCALE = kernel_curvature_covariances.SCALE
TURN = "_turn"
"""Ends the name of a difference."""


def kernel_graphs(c: Context) -> dict[str, Graph]:
    """Graphs by the names of their kernels."""
    graphs = {name: _index_graph(c, parts) for name, parts in INDEX_KERNELS.items()}
    for name, part in FURTHER.items():
        # a noise without a form that has no subtraction has no such kernel
        with suppress(ArithmeticError):
            graphs[name] = _index_graph(c, (part,))
    if pole_tower.within_reach(c.spectrum):
        graphs[POLES] = pole_graph(c.spectrum)
    if c.spectrum.rational_in_root:
        graphs |= {
            "index_from_alpha": _alpha_graph(inverses.index_from_alpha),
            "gains_from_alpha": _alpha_graph(inverses.gains_from_alpha),
        }
    return graphs


def kernel_roots(c: Context, kernel: str) -> Mapping[str, sp.Expr]:
    """Tower values of the named square roots and of the fixed point.

    The roots b and c stand in every start, which proves nothing, and in what holds xi - (1 + b).
    """
    if kernel == POLES:
        return pole_tower.kernel_roots(c)
    r, k = real("fourth_root"), c.constants
    held = kernel in ("updated_covariance", "updated_covariance_derivatives")
    return {
        **({"root_b": k.b, "root_c": k.c} if held else {}),
        "p": r**2,
        "r": r,
        "c_scaled": rational(UNIT) * DELTA * r**2 / 8,
        "x": XI * r / 2,
        "e": ETA * r**2 / 4,
        "eta_of_map": ETA * r**2 / 4,
        "w": real("w"),
    }


def _index_graph(c: Context, parts: tuple[FormsOf, ...]) -> Graph:
    """The graph of the outputs of one or more forms; a name met again is prefixed d_.

    A difference that a scale measures has a name.
    """
    builder = GraphBuilder()
    basis = kernel_basis(builder, c.spectrum)
    noise = _noise(c)
    outputs: dict[str, Any] = {}
    for part in parts:
        for key, value in part(basis, noise).items():
            outputs[f"d_{key}" if key in outputs else key] = value
    turns = {f"{key}{TURN}": value for key, value in outputs.items() if f"{key}{SCALE}" in outputs}
    return builder.graph(outputs, basis.names | turns)


def _noise(c: Context) -> Noise:
    q = c.model.process_noise.applyfunc(sp.Rational)
    rate = q[1, 1] - q[0, 1] - q[0, 2] / 2 - q[1, 2] / 4
    return Noise(*(Fraction(str(entry)) for entry in (q[0, 2], q[1, 2], rate)))


def _alpha_graph(form: Callable[[Any, Any], Mapping[str, Any]]) -> Graph:
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    w = builder.sqrt(1 - alpha)
    return builder.graph(dict(form(alpha, w)), {"w": w})
