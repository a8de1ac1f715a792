"""The range of the tangent of half an angle, from that of the angle."""

from __future__ import annotations

from fractions import Fraction
from types import MappingProxyType

import flint

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.polynomial import rational

PRECISION = 128
SCALE = 2**40
LARGEST = Fraction(3, 2)
"""Half angles up to here are smaller than a right angle."""
EXACT = MappingProxyType(
    {
        Fraction(-1): None,
        Fraction(-1, 2): Fraction(-1),
        Fraction(0): Fraction(0),
        Fraction(1, 2): Fraction(1),
        Fraction(1): None,
    }
)
"""tan(pi u / 2) by u; at half a turn there is none."""


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


def half_tangent_of_turns(turns: Box) -> Box | None:
    """An interval that holds tan(pi u / 2) for all u of a domain between -1 and 1, of which an end
    at -1 or 1 is left out; None for other domains.
    """
    if turns.lower is None or turns.upper is None or turns.lower < -1 or turns.upper > 1:
        return None
    low, high = (_end_of_turns(end, up) for end, up in ((turns.lower, False), (turns.upper, True)))
    exact_low, exact_high = turns.lower in EXACT, turns.upper in EXACT
    return Box(
        lower=low,
        upper=high,
        lower_open=low is None or (exact_low and turns.lower_open),
        upper_open=high is None or (exact_high and turns.upper_open),
    )


def _end_of_turns(end: Fraction, up: bool) -> Fraction | None:
    """The tangent, rounded outwards where it is not exact; None where there is none."""
    if end in EXACT:
        return EXACT[end]
    with flint.ctx.workprec(PRECISION):
        half = flint.arb.pi() * flint.arb(rational(end)) / 2
        whole = (half.tan() * SCALE).floor().unique_fmpz()
    return None if whole is None else Fraction(int(whole) + (2 if up else -1), SCALE)


def _scaled(half: Fraction) -> int | None:
    """The tangent times SCALE, rounded down; None if the ball does not tell."""
    with flint.ctx.workprec(PRECISION):
        whole = (flint.arb(rational(half)).tan() * SCALE).floor().unique_fmpz()
    return None if whole is None else int(whole)
