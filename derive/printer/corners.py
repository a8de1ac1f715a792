"""Ranges over boxes from their corners, where the slopes along the axes have a sign.

A quantity has rows: its range over the whole box, then its values at the 2^n corners of a box of n
inputs, the first input's end changing slowest.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gainproof.derive.printer import interval
from gainproof.derive.printer.interval import Array, Interval

MANY = 4  # a part of the boxes: taking more of them out takes longer than counting with all


def rows(box: Array, low: Array, high: Array, axis: int, axes: int) -> Array:
    """The rows of what depends on one input only, from its values at both ends of that input."""
    ends: Sequence[Array] = (low, high)
    found = np.empty((1 + 2**axes, len(box)))
    found[0] = box
    runs = found[1:].reshape(2**axis, 2, -1, len(box))
    for place, end in enumerate(ends):
        runs[:, place] = end
    return found


def extremes(size: Interval, slope: Interval, width: Array | None = None) -> Interval:
    """The range over each box.

    Along an axis where the slope has one sign an end suffices; else the quantity moves away from
    either end by no more than its largest slope allows over the `width`, if that is given.
    """
    below, above = size
    if width is None:
        return _at_corners(size, slope)
    axes, count = slope[0].shape
    least, most = (end[1:].reshape((2,) * axes + (count,)) for end in size)
    rising = slope[0] >= 0
    unsure = ~(rising | (slope[1] <= 0))
    some = interval.somewhere(unsure)
    for axis, rises in enumerate(rising):
        lows, highs = least, most
        least, most = np.where(rises, lows[0], lows[1]), np.where(rises, highs[1], highs[0])
        away = np.flatnonzero(unsure[axis]) if some else ()
        if len(away) > count // MANY:
            steepest = np.maximum(-slope[0][axis], slope[1][axis])
            factor = interval.spread(steepest, width[axis])
            np.copyto(least, np.fmax(lows[0], lows[1]) / factor, where=unsure[axis])
            np.copyto(most, np.fmin(highs[0], highs[1]) * factor, where=unsure[axis])
        elif len(away):  # boxes without a sign along this axis
            steepest = np.maximum(-slope[0][axis, away], slope[1][axis, away])
            factor = interval.spread(steepest, width[axis, away])
            lows, highs = lows[..., away], highs[..., away]
            least[..., away] = np.fmax(lows[0], lows[1]) / factor
            most[..., away] = np.fmin(highs[0], highs[1]) * factor
    if some:
        left = np.flatnonzero(unsure.any(axis=0))
        least[left] = np.fmax(below[0, left], least[left])
        most[left] = np.fmin(above[0, left], most[left])
    return least, most


def _at_corners(size: Interval, slope: Interval) -> Interval:
    """The range where all slopes have signs: from the corner of the least to that opposite."""
    rises = slope[0] >= 0
    if len(rises) == 1:
        return _at_ends(size, rises[0], rises[0] | (slope[1][0] <= 0))
    settled: NDArray[np.bool_] = np.all(rises | (slope[1] <= 0), axis=0)
    least = 2 ** np.arange(len(rises) - 1, -1, -1) @ ~rises
    boxes = np.arange(len(settled))
    below, above = size
    low, high = below[1 + least, boxes], above[len(above) - 1 - least, boxes]
    if interval.everywhere(settled):
        return low, high
    return (
        np.where(settled, low, np.fmax(below[0], 0.0)),
        np.where(settled, high, np.fmin(above[0], np.inf)),
    )


def _at_ends(size: Interval, rises: NDArray[np.bool_], settled: NDArray[np.bool_]) -> Interval:
    """The same of one input, whose corners are two ends."""
    below, above = size
    least, most = np.where(rises, below[1], below[2]), np.where(rises, above[2], above[1])
    if interval.everywhere(settled):
        return least, most
    return (
        np.where(settled, least, np.fmax(below[0], 0.0)),
        np.where(settled, most, np.fmin(above[0], np.inf)),
    )
