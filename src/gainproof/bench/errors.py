"""The greatest error of each output at random points of its domain, against its proved bound."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb

from gainproof.bench.accuracy import Ball, ball_outputs, error, log_uniform, signed_points, terms
from gainproof.bench.arguments import fitting
from gainproof.bench.subjects import Measured
from gainproof.derive.printer.kernel import Output
from gainproof.derive.printer.step_ranges import Box

POINTS = 400
Evaluated = tuple[Mapping[str, float], Sequence[float], Mapping[str, Ball]]
"""A point, the kernel's outputs there, and balls of what they should be."""
EPSILON = 2.0**-52


@dataclass(frozen=True)
class OutputError:
    """Of one output: the greatest error met over its scale, in units of 2^-52 and in units in the
    last place of the scale, infinite for NaN; `proved`: the bound in units of 2^-52; `outside`: at
    how many of the points the error was greater than is proved.
    """

    name: str
    worst: float
    ulps: float
    proved: float
    outside: int


def worst_errors(item: Measured) -> tuple[OutputError, ...]:
    """Of every output, at the same points where outputs have the same domain."""
    drawn: dict[Box, list[Evaluated]] = {}
    found = list[OutputError]()
    for number, output in enumerate(item.kernel.outputs):
        bound = item.bound.outputs[number]
        if bound.domain not in drawn:
            drawn[bound.domain] = list(_evaluated(item, bound.domain))
        worst, ulps, outside = 0.0, 0.0, 0
        for point, values, exact in drawn[bound.domain]:
            scale = _scale(item, output, point, exact)
            size = float(abs(scale).mid())
            if scale == 0:
                # no share of nothing: what is stated beside the bound is all that is allowed
                apart = float(abs(arb(values[number]) - exact[output.name]).abs_upper())
                met, allowed = (0.0 if apart <= bound.beside else math.inf), 0.0
            else:
                met = error(values[number], exact[output.name], scale, EPSILON)
                met = math.inf if math.isnan(met) else met
                # an underflow on the way may add what is stated beside the bound
                room = bound.beside / (size * EPSILON) if size else math.inf
                allowed = float(bound.bound) + room
            outside += met > allowed
            worst = max(worst, met)
            if 0 < size < math.inf:
                ulps = max(ulps, met * EPSILON * size / float(np.spacing(size)))
        found.append(OutputError(output.name, worst, ulps, float(bound.bound), int(outside)))
    return tuple(found)


def _evaluated(item: Measured, domain: Box) -> list[Evaluated]:
    """At random points of the domain."""
    generator = np.random.default_rng(21)
    columns = []
    for given, (low, high) in zip(item.kernel.inputs, domain, strict=True):
        if given.signed:
            columns.append(signed_points(high, POINTS, generator))
            continue
        lowest = max(low, 1.0) if given.integer else low
        points = log_uniform(lowest, high, POINTS, generator)
        columns.append([float(round(x)) for x in points] if given.integer else points)
    fit = [x.tolist() for x in fitting(item.signature, list(map(np.array, columns)))]
    values = item.function(*(np.array(column) for column in fit))
    names = [given.name for given in item.kernel.inputs]
    found = list[Evaluated]()
    for place, row in zip(zip(*fit, strict=True), zip(*values, strict=True), strict=True):
        point = dict(zip(names, place, strict=True))
        found.append((point, [float(x) for x in row], ball_outputs(item.kernel.graph, point)))
    return found


def _scale(
    item: Measured, output: Output, point: Mapping[str, float], exact: Mapping[str, Ball]
) -> Ball:
    if output.by_terms:
        return terms(item.kernel.graph, point)[output.name]
    return exact[output.relative_to or output.name]
