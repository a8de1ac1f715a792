"""Values with which a program begins: its input, constants, and exact sums of the two."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.affine import AffineSum
from gainproof.derive.printer.constant import Constant
from gainproof.derive.printer.corners import rows
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.step_ranges import MARGIN, Grid, Signs, Value, absolute


def input_value(grid: Grid, axis: int) -> Value:
    """One of the inputs, positive and exact."""
    low, high = grid.low[axis], grid.high[axis]
    size = tuple(rows(end, low, high, axis, grid.axes) for end in (low, high))
    slope = np.zeros(grid.low.shape)
    slope[axis] = 1.0
    return Value((size[0], size[1]), (slope, slope), np.ones(grid.count, np.int8))


def constant_value(constant: Constant, grid: Grid, form: Format) -> Value:
    """A constant, with the rounding that its nearest number costs."""
    count = grid.count
    least, most, sign, error = constant.size(form)
    shape = 1 + 2**grid.axes, count
    size = np.full(shape, least), np.full(shape, most)
    zeros = np.zeros(grid.low.shape)
    value = Value(size, (zeros, zeros), np.full(count, sign, np.int8))
    if not constant.is_exact(form):
        value.rounding = error * MARGIN
        value.drift = value.rounding
    return value


def affine_value(affine: AffineSum, grid: Grid, axis: int, unit: float) -> Value:
    """Constant plus scaled input: monotone, so that the boxes' ends enclose it and its slope."""
    places = grid.low[axis], grid.high[axis]
    ends = [affine.at(x) for x in places]
    low = np.minimum(ends[0][0], ends[1][0])
    high = np.maximum(ends[0][1], ends[1][1])
    sign: Signs = np.where(low >= 0, 1, -1).astype(np.int8)
    sign[(low == 0) & (high == 0)] = 0
    crossing = (low < 0) & (high > 0)
    sizes = [absolute(end) for end in ends]
    nearest = np.where(crossing, 0.0, np.minimum(sizes[0][0], sizes[1][0]))
    farthest = np.maximum(sizes[0][1], sizes[1][1])
    size = (
        rows(nearest, sizes[0][0], sizes[1][0], axis, grid.axes),
        rows(farthest, sizes[0][1], sizes[1][1], axis, grid.axes),
    )
    steep = []
    for x, end in zip(places, sizes, strict=True):
        scaled = x * abs(affine.factor)
        steep.append(interval.divide((scaled, scaled), end))
    least = np.minimum(steep[0][0], steep[1][0])
    most = np.maximum(steep[0][1], steep[1][1])
    falling = sign * affine.factor < 0
    slope = np.zeros(grid.low.shape), np.zeros(grid.low.shape)
    slope[0][axis], slope[1][axis] = (
        np.where(falling, -most, least),
        np.where(falling, -least, most),
    )
    value = Value(size, slope, sign, unit * affine.parts, unit * affine.parts)
    value.invalid = crossing if interval.somewhere(crossing) else None
    return value
