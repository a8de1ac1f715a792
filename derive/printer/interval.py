"""Outward-rounded intervals of nonnegative numbers, many at once in NumPy arrays.

An interval is a pair (low, high) of float64 arrays with 0 <= low <= high <= infinity. Only
+ - * / and square roots of IEEE arithmetic are used, so that the same numbers come on every
machine. The caller holds ``numpy.errstate(all="ignore")``.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Interval = tuple[Array, Array]

UNIT = 2.0**-52
ABOVE, BELOW = 1.0 + UNIT, 1.0 - UNIT
LEAST, LARGEST = 2.0**-1074, (2.0 - UNIT) * 2.0**1023

# More than all roundings of `spread` and of a widening by two factors together.
SLACK = 1.0 + 2.0**-36


def everywhere(mask: NDArray[np.bool_]) -> bool:
    """Whether all are true. Counting takes a tenth of what `all` does where there are few."""
    return int(np.count_nonzero(mask)) == mask.size


def somewhere(mask: NDArray[np.bool_]) -> bool:
    """Whether one is true."""
    return int(np.count_nonzero(mask)) > 0


def down(x: Array) -> Array:
    """A number below x >= 0, the next or the next but one; 0 below 0, the largest below infinity.

    x (1 - 2^-52) is below the exact x by one unit at least, subnormal numbers apart. NumPy's
    nextafter takes fifty times as long as a product.
    """
    # in place: new arrays of a page's size and more cost more than the arithmetic
    lower = np.minimum(x, LARGEST)
    lower *= BELOW
    lower -= LEAST
    return np.maximum(lower, 0.0)


def up(x: Array) -> Array:
    """A number above x >= 0, the next or the next but one."""
    upper = x * ABOVE
    upper += LEAST
    return upper


def down_or_zero(x: Array) -> Array:
    """The same as `down`; 0 where x is no number."""
    lower = np.minimum(x, LARGEST)
    lower *= BELOW
    lower -= LEAST
    return np.fmax(lower, 0.0)  # fmax and fmin ignore NaN


def up_or_infinite(x: Array) -> Array:
    """A number above x >= 0; infinity where x is no number."""
    upper = x * ABOVE
    upper += LEAST
    return np.fmin(upper, np.inf)


def add(a: Interval, b: Interval) -> Interval:
    """a + b."""
    return down(a[0] + b[0]), up(a[1] + b[1])


def multiply(a: Interval, b: Interval) -> Interval:
    """a b; 0 times infinity gives all that it may stand for."""
    return down_or_zero(a[0] * b[0]), up_or_infinite(a[1] * b[1])


def divide(a: Interval, b: Interval) -> Interval:
    """a / b; 0/0 and infinity/infinity give all that they may stand for."""
    return down_or_zero(a[0] / b[1]), up_or_infinite(a[1] / b[0])


def square_root(a: Interval) -> Interval:
    """The square root."""
    return down(np.sqrt(a[0])), up(np.sqrt(a[1]))


def scale(a: Interval, power: float) -> Interval:
    """a times a power of two: exact unless it leaves the normal range."""
    low, high = a[0] * power, a[1] * power
    tiny = 2.0**-1022
    if everywhere(low >= tiny) and everywhere(high <= LARGEST):
        return low, high
    return np.where((low < tiny) | np.isinf(low), down(low), low), np.where(
        high < tiny, up(high), high
    )


def spread(slope: Array, width: Array) -> Array:
    """An upper bound of (1 + width)^slope for slope >= 0; infinity for a width beyond 2^10.

    (1 + w)^g <= 1 + g w for g <= 1, applied up to three times, or 1/(1 - g w) where g w < 1.
    """
    product = 1.0 + np.minimum(slope, 1.0) * width
    for k in (1.0, 2.0):
        product = product * (1.0 + np.clip(slope - k, 0.0, 1.0) * width)
    steep = slope * width
    small = np.where((slope <= 3.0) & (width <= 1024.0), product, np.inf)
    return np.minimum(small, np.where(steep < 1.0, 1.0 / (1.0 - steep), np.inf)) * SLACK


def share(other_over_own: Interval) -> Interval:
    """own/(own + other) from the ratio other/own."""
    low, high = other_over_own
    return down(1.0 / up(1.0 + high)), np.minimum(up(1.0 / down(1.0 + low)), 1.0)


def reciprocal(a: Interval) -> Interval:
    """1/a."""
    return down(1.0 / a[1]), up(1.0 / a[0])


# Intervals of either sign, used for slopes and adjoints only.


def signed_add(a: Interval, b: Interval) -> Interval:
    """a + b for intervals of either sign; infinity - infinity gives the whole line."""
    return _widened(a[0] + b[0], a[1] + b[1])


def signed_multiply(a: Interval, weight: Interval) -> Interval:
    """a of either sign times a nonnegative weight."""
    low = np.minimum(a[0] * weight[0], a[0] * weight[1])
    high = np.maximum(a[1] * weight[0], a[1] * weight[1])
    return _widened(low, high)


def magnitude(a: Interval) -> Array:
    """The largest |x| of an interval of either sign."""
    return np.maximum(-a[0], a[1]) + 0.0  # never -0, whose reciprocal would be -infinity


def mignitude(a: Interval) -> Array:
    """The smallest |x| of an interval of either sign."""
    return np.maximum(np.maximum(a[0], -a[1]), 0.0) + 0.0


def _widened(low: Array, high: Array) -> Interval:
    """Both ends moved outward by a unit at least; what is lost at infinity may be anything.

    In place: nobody else has the arrays.
    """
    room = np.abs(low)
    room *= UNIT
    room += LEAST
    low -= room
    room = np.abs(high)
    room *= UNIT
    room += LEAST
    high += room
    if everywhere(low <= high):  # there is no NaN
        return low, high
    lost: Any = np.isnan(low) | np.isnan(high)
    return np.where(lost, -np.inf, low), np.where(lost, np.inf, high)
