"""Values with which a program begins: its input, constants, and exact sums of the two."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.affine import AffineSum
from gainproof.derive.printer.constant import Constant
from gainproof.derive.printer.formats import FLOAT64, Format
from gainproof.derive.printer.value import MARGIN, Grid, Signs, Value, absolute


def input_value(grid: Grid) -> Value:
    """The input itself, positive and exact."""
    ones = np.ones(len(grid.low))
    size = np.stack([grid.low, grid.low, grid.high]), np.stack([grid.high, grid.low, grid.high])
    return Value(size, (ones, ones), np.ones(len(grid.low), np.int8))


def constant_value(constant: Constant, count: int, form: Format) -> Value:
    """A constant in `count` boxes, with the rounding that its nearest number costs."""
    low, high = constant.between()
    sign = 0 if high == 0 else 1 if low > 0 else -1
    below, above = sorted((abs(low), abs(high)))
    size = (
        np.full((3, count), FLOAT64.at_most(below)),
        np.full((3, count), FLOAT64.at_least(above)),
    )
    zeros = np.zeros(count)
    value = Value(size, (zeros, zeros), np.full(count, sign, np.int8))
    if not constant.is_exact(form):
        nearest = Fraction(constant.nearest(form))
        error = max(abs(nearest - low), abs(nearest - high)) / below
        value.rounding = float(error) * MARGIN
        value.drift = value.rounding
    return value


def affine_value(affine: AffineSum, grid: Grid, unit: float) -> Value:
    """Constant plus scaled input: monotone, so that the boxes' ends enclose it and its slope."""
    ends = [affine.at(x) for x in (grid.low, grid.high)]
    low = np.minimum(ends[0][0], ends[1][0])
    high = np.maximum(ends[0][1], ends[1][1])
    sign: Signs = np.where(low >= 0, 1, -1).astype(np.int8)
    sign[(low == 0) & (high == 0)] = 0
    crossing = (low < 0) & (high > 0)
    sizes = [absolute(end) for end in ends]
    nearest = np.where(crossing, 0.0, np.minimum(sizes[0][0], sizes[1][0]))
    farthest = np.maximum(sizes[0][1], sizes[1][1])
    size = (
        np.stack([nearest, sizes[0][0], sizes[1][0]]),
        np.stack([farthest, sizes[0][1], sizes[1][1]]),
    )
    steep = []
    for x, end in zip((grid.low, grid.high), sizes, strict=True):
        scaled = x * abs(affine.factor)
        steep.append(interval.divide((scaled, scaled), end))
    least = np.minimum(steep[0][0], steep[1][0])
    most = np.maximum(steep[0][1], steep[1][1])
    falling = sign * affine.factor < 0
    slope = np.where(falling, -most, least), np.where(falling, -least, most)
    value = Value(size, slope, sign, unit * affine.parts, unit * affine.parts)
    value.invalid = crossing if crossing.any() else None
    return value
