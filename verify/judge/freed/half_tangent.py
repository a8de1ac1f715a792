"""The range of the tangent of half an angle, from that of the angle."""

from __future__ import annotations

from fractions import Fraction

import flint

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.poly import rational

PRECISION = 128
SCALE = 2**40
LARGEST = Fraction(3, 2)
"""Half angles up to here are smaller than a right angle."""


def half_tangent(angle: Box, divisor: int) -> Box | None:
    """An interval that holds tan(x / (2 divisor)) for all x of a bounded domain.

    None where the domain is not bounded, or reaches an angle whose half is close to a right one.
    """
    if angle.lower is None or angle.upper is None:
        return None
    low, high = angle.lower / (2 * divisor), angle.upper / (2 * divisor)
    if max(-low, high) > LARGEST:
        return None
    # the tangent rises; bounds are rounded outwards, but zero stays where it is
    first, last = _scaled(low), _scaled(high)
    if first is None or last is None:
        return None
    lower = Fraction(first - 1, SCALE) if low else Fraction(0)
    upper = Fraction(last + 2, SCALE) if high else Fraction(0)
    lower_open, upper_open = not low and angle.lower_open, not high and angle.upper_open
    return Box(lower=lower, upper=upper, lower_open=lower_open, upper_open=upper_open)


def _scaled(half: Fraction) -> int | None:
    """The tangent times SCALE, rounded down; None if the ball does not tell."""
    with flint.ctx.workprec(PRECISION):
        whole = (flint.arb(rational(half)).tan() * SCALE).floor().unique_fmpz()
    return None if whole is None else int(whole)
