"""The kernels of the closed-loop poles, as expression graphs."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.vector_measurement import poles
from gainproof.derive.vector_measurement.derivative_kernels import SCALE, difference
from gainproof.derive.vector_measurement.kernels import graph_basis
from gainproof.derive.vector_measurement.process_noise import Noise

POLES = "closed_loop_poles"
REAL = "real_poles"
POSITIVE, NEGATIVE = "positive_from", "negative_up_to"
MEAN, MODULUS, SQUARE = "half_sum", "modulus", "quarter_discriminant"


def pole_graphs(noise: Noise) -> dict[str, Graph]:
    """The graphs by kernel."""
    return {POLES: pole_graph(noise), REAL: real_graph(noise)}


def _inverse_root(builder: GraphBuilder, value: Fraction) -> Node:
    """1/sqrt(value), a rational number where it is one."""
    return builder.number(2) if value == Fraction(1, 4) else builder.sqrt(1 / value)


def pole_graph(noise: Noise) -> Graph:
    """Half the sum of the poles, their geometric mean, the square of half their difference."""
    builder = GraphBuilder()
    x, names = graph_basis(builder, noise)
    outputs: dict[str, Any] = {}
    scales: dict[str, Any] = {}
    if noise.e == 1:
        first, other = poles.half_sum_parts(x, None)
        outputs[MEAN] = first + other
    else:
        names["slope_place"] = _inverse_root(builder, poles.slope(noise))
        first, other = poles.half_sum_parts(x, names["slope_place"])
        outputs[MEAN] = names[difference(MEAN)] = first - other
        names["second_size"] = builder.absolute(other)
        scales[MEAN + SCALE] = first + names["second_size"]
    outputs[MODULUS] = poles.modulus(x)
    place = None
    if poles.centre(noise):
        place = names["centre_place"] = _inverse_root(builder, poles.centre(noise))
    near, far = poles.discriminant_parts(x, place)
    outputs[SQUARE] = names[difference(SQUARE)] = near - far
    scales[SQUARE + SCALE] = near + far
    return builder.graph(outputs | scales, names)


def turning_index(noise: Noise) -> Fraction:
    """8/(1 - e), beyond which the poles turn negative for large S."""
    return 2 / poles.slope(noise)


def real_graph(noise: Noise) -> Graph:
    """The two values of 1/S^2 between which the poles are complex; for e = 1 the second is never
    positive, and left out.
    """
    builder = GraphBuilder()
    index = builder.symbol("tracking_index")
    squared = poles.spread_squared(noise, index)
    names: dict[str, Node] = {}
    root: Any = 1
    if squared is not None:
        root = names["spread_root"] = builder.sqrt(squared)
    positive = poles.positive_from(noise, index, root)
    outputs = {POSITIVE: positive}
    if noise.e != 1:
        limit = turning_index(noise)
        outputs[NEGATIVE] = poles.negative_up_to(noise, index, limit, positive)
    return builder.graph(outputs, names)
