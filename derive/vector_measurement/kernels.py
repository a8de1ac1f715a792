"""The kernels of position and velocity measured, as expression graphs of two inputs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.vector_measurement import radicands
from gainproof.derive.vector_measurement.forms import Basis
from gainproof.derive.vector_measurement.process_noise import Noise, times

FormsOf = Callable[[Basis], Mapping[str, Any]]
INPUTS = ("tracking_index", "velocity_ratio")


def graph_basis(builder: GraphBuilder, noise: Noise) -> tuple[Basis, dict[str, Node]]:
    """The inputs and the roots made from them as nodes, with their names."""
    index, ratio = (builder.symbol(name) for name in INPUTS)
    names: dict[str, Node] = {}
    level = None
    if noise.determinant:
        level = names["level_scaled"] = builder.sqrt(radicands.level_squared(noise, index, ratio))
    eta = names["eta_scaled"] = builder.sqrt(radicands.eta_squared(noise, index, ratio))
    width = ratio if level is None else level
    square = radicands.delta_squared(noise, index, ratio, width, eta)
    delta = names["delta_scaled"] = builder.sqrt(square)
    basis = Basis(index, ratio, level, eta, delta, noise)
    names |= {
        "sigma_scaled": basis.sigma_scaled,
        "coupling_scaled": basis.coupling_scaled,
        "cross_share": basis.cross_share,
        "rest_scaled": basis.rest_scaled,
    }
    return basis, names


def steady_graph(noise: Noise, *parts: FormsOf) -> Graph:
    """The graph of the outputs of one or more forms."""
    builder = GraphBuilder()
    basis, names = graph_basis(builder, noise)
    outputs: dict[str, Any] = {}
    for part in parts:
        outputs |= part(basis)
    return builder.graph(outputs, names)


def known_graph(noise: Noise) -> Graph:
    """The position's variances where the velocity is known exactly, those that do not vanish.

    For d = 0 exact velocities leave nothing of the position open, and the prediction has Q11.
    """
    builder = GraphBuilder()
    index = builder.symbol("tracking_index")
    area = index * index
    if not noise.determinant:
        return builder.graph({"predicted_11": times(noise.first, area)})
    far = builder.sqrt(area + 16 / noise.e)
    updated = (index * 2) / (index + far)
    outputs = {
        "predicted_11": updated + times(noise.first, area),
        "updated_11": updated,
    }
    return builder.graph(outputs, {"far": far})
