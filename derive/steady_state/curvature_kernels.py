"""The kernels of second derivatives by the index, as expression graphs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from types import MappingProxyType
from typing import Any

from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.steady_state import curvature_covariances, curvature_gains
from gainproof.derive.steady_state.forms import Basis
from gainproof.derive.steady_state.kernels import graph_basis

SCALE = "predicted_11_scale"
"""What the second derivative of M11 is measured by for e > 0: its terms, added."""

TURN = "predicted_11_turn"
"""The difference in the second derivative of M11 for e > 0."""


def _predicted(builder: GraphBuilder, x: Basis) -> tuple[dict[str, Any], dict[str, Any]]:
    """Outputs and names."""
    outputs: dict[str, Any] = {}
    names: dict[str, Any] = {}
    scales: dict[str, Any] = {}
    if x.e == 0:
        names["root_of_3"] = root_3 = builder.sqrt(builder.number(3))
        outputs["predicted_11"] = curvature_covariances.first_second_derivative_round_turn(
            x, root_3
        )
    else:
        rising, falling = curvature_covariances.first_second_derivative_parts(x)
        names[TURN] = rising - falling
        outputs["predicted_11"] = names[TURN] * (1 / curvature_covariances.first_unit(x))
        scales[SCALE] = (rising + falling) * (1 / curvature_covariances.first_unit(x))
    outputs["predicted_12"] = curvature_covariances.cross_second_derivative(x)
    outputs["predicted_22"] = curvature_covariances.rate_second_derivative(x) + 2
    return outputs | scales, names


def _updated(_builder: GraphBuilder, x: Basis) -> tuple[dict[str, Any], dict[str, Any]]:
    gain = curvature_gains.gain_second_derivatives(x)
    rate = curvature_covariances.rate_second_derivative(x)
    return {"updated_11": gain["alpha"], "updated_12": gain["beta"], "updated_22": rate}, {}


def _gains(_builder: GraphBuilder, x: Basis) -> tuple[dict[str, Any], dict[str, Any]]:
    return curvature_gains.gain_second_derivatives(x), {}


def _predictor(_builder: GraphBuilder, x: Basis) -> tuple[dict[str, Any], dict[str, Any]]:
    return curvature_gains.predictor_gain_second_derivatives(x), {}


Making = Callable[[GraphBuilder, Basis], tuple[dict[str, Any], dict[str, Any]]]

SECOND_DERIVATIVES: Mapping[str, Making] = MappingProxyType(
    {
        "gain_second_derivatives": _gains,
        "predictor_gain_second_derivatives": _predictor,
        "predicted_covariance_second_derivatives": _predicted,
        "updated_covariance_second_derivatives": _updated,
    }
)


def second_derivative_graph(e: Fraction, n: Fraction, kernel: str) -> Graph:
    """The graph of one kernel of second derivatives."""
    builder = GraphBuilder()
    basis, names = graph_basis(builder, e, n)
    outputs, more = SECOND_DERIVATIVES[kernel](builder, basis)
    return builder.graph(outputs, names | more)
