"""The kernels of both partial derivatives, as expression graphs of two inputs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.vector_measurement import derivatives_by_index, derivatives_by_noise_ratio
from gainproof.derive.vector_measurement.first_derivatives import Rates
from gainproof.derive.vector_measurement.kernels import graph_basis
from gainproof.derive.vector_measurement.process_noise import Noise

BY_INDEX, BY_RATIO = "_by_tracking_index", "_by_velocity_ratio"
SCALE = "_scale"
"""What an output of changing sign is measured by: its name with this is the sum of its parts."""


def _updated_by_index(r: Rates) -> dict[str, Any]:
    return {
        **derivatives_by_index.updated_by_index(r),
        "updated_12": derivatives_by_index.updated_12_parts(r),
    }


def _gains_by_index(r: Rates) -> dict[str, Any]:
    parts = {
        "gain_12": derivatives_by_index.gain_12_parts(r),
        "gain_21": derivatives_by_index.updated_12_parts(r),
    }
    return {**derivatives_by_index.gains_by_index(r), **parts}


def _gains_by_ratio(r: Rates) -> dict[str, Any]:
    return {
        **derivatives_by_noise_ratio.gains_by_ratio(r),
        "gain_12": derivatives_by_noise_ratio.gain_12_parts(r),
    }


DERIVATIVES: Mapping[str, Callable[[Rates], Mapping[str, Any]]] = MappingProxyType(
    {
        f"gains{BY_INDEX}": _gains_by_index,
        f"gains{BY_RATIO}": _gains_by_ratio,
        f"predicted_covariance{BY_INDEX}": derivatives_by_index.predicted_by_index,
        f"predicted_covariance{BY_RATIO}": derivatives_by_noise_ratio.predicted_by_ratio,
        f"updated_covariance{BY_INDEX}": _updated_by_index,
        f"updated_covariance{BY_RATIO}": derivatives_by_noise_ratio.updated_by_ratio,
    }
)
"""What each kernel gives: a value, or the two parts of one whose sign changes."""


def derivative_graph(noise: Noise, kernel: str) -> Graph:
    """The graph of one kernel of derivatives; names hold each difference of two parts."""
    builder = GraphBuilder()
    basis, names = graph_basis(builder, noise)
    outputs: dict[str, Any] = {}
    scales: dict[str, Any] = {}
    found = DERIVATIVES[kernel](Rates(basis))
    for name in sorted(found):
        value = found[name]
        if isinstance(value, tuple):
            grows, falls = value
            names[difference(name)] = value = grows - falls
            scales[name + SCALE] = grows + falls
        outputs[name] = value
    return builder.graph(outputs | scales, names)


def difference(output: str) -> str:
    """The name of the difference that is an output of changing sign."""
    return f"{output}_difference"
