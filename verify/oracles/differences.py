"""Derivatives by central differences with Richardson extrapolation, in multiprecision.

Independent because it only evaluates a function. Meant for functions that come from another
oracle with many digits: with values good to D digits and L levels of extrapolation from a
relative step h, the error is about h^(2 L) from truncation plus 10^-D / h from rounding. Both
show in the differences between the last three extrapolations, the larger of which is returned as
the error.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from gainproof.verify.oracles.multiprecision import bits_for, carried, context, number_in


@dataclass(frozen=True)
class Slope:
    """A derivative and an estimate of its error, as multiprecision floats."""

    value: Any
    error: Any


def derivatives(
    function: Callable[[Fraction], Sequence[Any]],
    point: Fraction,
    levels: int = 6,
    step: Fraction = Fraction(1, 256),
    digits: int = 80,
) -> tuple[Slope, ...]:
    """First derivatives at ``point`` of each component of ``function``.

    ``function`` takes an exact fraction and returns multiprecision floats (or fractions) good to
    ``digits`` digits; it must be smooth within ``step * point`` of the point. The steps are
    exact fractions, so that no rounding of the argument enters. Raises ValueError for point 0.
    """
    if point == 0 or levels < 2:
        raise ValueError(f"needs a point other than 0 and two levels, got {point} and {levels}")
    own = context(bits_for(digits) + 60)
    number = number_in(own)

    def central(width: Fraction) -> list[Any]:
        above, below = function(point + width), function(point - width)
        span = number(2 * width)
        return [
            (carried(x, own) - carried(y, own)) / span for x, y in zip(above, below, strict=True)
        ]

    columns = [central(point * step / 2**level) for level in range(levels)]
    before = columns
    for order in range(1, levels):
        before = columns
        factor = 4**order
        columns = [
            [(factor * fine - coarse) / (factor - 1) for coarse, fine in zip(c, f, strict=True)]
            for c, f in pairwise(columns)
        ]
    coarse, fine = before
    return tuple(
        Slope(x, max(abs(x - y), abs(y - z)))
        for x, y, z in zip(columns[0], fine, coarse, strict=True)
    )
