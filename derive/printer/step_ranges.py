"""What is known of one step of a program over many boxes of its input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.derive.printer import interval
from gainproof.derive.printer.corners import extremes
from gainproof.derive.printer.interval import Array, Interval

Signs = NDArray[np.int8]
Mask = NDArray[np.bool_]
Box = tuple[tuple[float, float], ...]
"""Least and greatest number of each input."""


# u is taken larger by this: covers 1/(1 - u), a result just below the least normal number,
# and errors of second order in the comparison of exact and computed values.
MARGIN = 1.0 + 2.0**-13

LEAST_NORMAL = 1.0 - 2.0**-14  # times the least normal number: still rounded as if it were one


class PrintingError(ValueError):
    """A graph that cannot be printed with a proved bound; the message names the node."""


@dataclass(frozen=True)
class Grid:
    """Boxes [low, high] with a row for each input and a column for each box.

    `width` is at least high/low - 1, 0 where an input has one value only.
    """

    low: Array
    high: Array
    width: Array

    @property
    def axes(self) -> int:
        """The number of inputs."""
        return len(self.low)

    @property
    def count(self) -> int:
        """The number of boxes."""
        return int(self.low.shape[1])


@dataclass
class Value:
    """What is known of one step; arrays run over boxes, `size` has rows box and its corners.

    `slope` has a row for each input: d log|value| / d log(input) over the box.

    `size` encloses |exact value|; where `loose` (a named cancellation) it is the reference that
    errors are measured by, the sum of the operands' sizes, and `true_size` encloses the value.
    `invalid`: where the step proves nothing; `over`: where it may overflow.
    `tiny` is twice the absolute rounding error where the result may be subnormal, `stray` bounds
    all absolute errors of the step.
    """

    size: Interval
    slope: Interval
    sign: Signs
    drift: float = 0.0
    rounding: float = 0.0
    stray: Array | None = None
    tiny: Array | None = None
    invalid: Mask | None = None
    over: Mask | None = None
    shares: tuple[Interval, Interval] | None = None
    chosen: Mask | None = None
    loose: bool = False
    true_size: Interval | None = None


def true_size(value: Value) -> Interval:
    """The enclosure of |exact value|."""
    return value.size if value.true_size is None else value.true_size


def monotone(value: Value) -> None:
    """Takes the range over each box from its corners where the slopes have signs there."""
    low, high = value.size
    low[0], high[0] = extremes(value.size, value.slope)


def like(part: Value, sign: Signs) -> Value:
    """The same magnitude with another sign."""
    return Value(
        part.size,
        part.slope,
        sign,
        part.drift,
        stray=part.stray,
        loose=part.loose,
        true_size=part.true_size,
    )


def absolute(a: Interval) -> Interval:
    """|a| of an interval of either sign."""
    return interval.mignitude(a), interval.magnitude(a)


def sum_of(*errors: float) -> float:
    """(1 + a)(1 + b) ... - 1 <= s + s^2 for s = a + b + ... <= 1."""
    total = sum(errors)
    return (total + total * total) * (1.0 + 2.0**-40)


def mean_slope(own: Interval, a: Interval, b: Interval) -> Interval:
    """share * a + (1 - share) * b: linear in the share, so that its ends suffice."""
    (first, last), others = own, (1.0 - own[0], 1.0 - own[1])
    room = np.maximum(interval.magnitude(a), interval.magnitude(b))
    room += 1.0
    room *= 2.0**-48
    low = np.minimum(first * a[0] + others[0] * b[0], last * a[0] + others[1] * b[0]) - room
    high = np.maximum(first * a[1] + others[0] * b[1], last * a[1] + others[1] * b[1]) + room
    if interval.everywhere(low <= high):  # there is no NaN
        return low, high
    return np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high)


def difference(a: Value, b: Value, opposite: Mask) -> Interval:
    """An enclosure of |a - b|, or of a + b where the signs agree."""
    (a_low, a_high), (b_low, b_high) = true_size(a), true_size(b)
    apart = np.maximum(np.maximum(a_low - b_high, b_low - a_high), 0.0)
    added = interval.add(true_size(a), true_size(b))
    same = ~opposite if not (a.loose or b.loose) else np.zeros_like(opposite)
    return np.where(same, added[0], interval.down(apart)), added[1]


def none_as_zero(stray: Array | None) -> Any:
    """The absolute errors as numbers."""
    return 0.0 if stray is None else stray


def choose(mask: Mask, x: Interval, y: Interval) -> Interval:
    """The first interval where the mask holds, else the second."""
    return np.where(mask, x[0], y[0]), np.where(mask, x[1], y[1])
