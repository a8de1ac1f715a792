"""How far a computed number is from an enclosed one, decided in balls.

Independent of everything computed: both answers hold for every number that the ball contains.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import flint

# The differences are formed with this many bits beyond those of the ball.
GUARD = 64


def within(
    computed: float | Fraction, truth: flint.arb, bound: Fraction, scale: Any = None
) -> bool:
    """Whether |computed - truth| <= bound * |scale| is certain; the scale is the truth itself
    unless another ball is given. A computed NaN or infinity is never within.
    """
    if isinstance(computed, float) and not math.isfinite(computed):
        return False
    with flint.ctx.workprec(_bits(computed, truth)):
        apart = abs(_ball(computed) - truth)
        return bool(apart <= _ball(bound) * abs(truth if scale is None else scale))


def relative_error(computed: float | Fraction, truth: flint.arb, scale: Any = None) -> float:
    """An upper bound of |computed - truth| / |scale| as a float, rounded up by at most 2^-50."""
    if isinstance(computed, float) and not math.isfinite(computed):
        return math.inf
    with flint.ctx.workprec(_bits(computed, truth)):
        ratio = abs(_ball(computed) - truth) / abs(truth if scale is None else scale)
        return float(ratio.upper()) * (1 + 2.0**-51)


def middle(ball: flint.arb) -> Fraction:
    """The midpoint of a ball, exactly."""
    mantissa, exponent = ball.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _bits(value: float | Fraction, truth: flint.arb) -> int:
    own = 53 if isinstance(value, float) else value.numerator.bit_length()
    # the number itself must not be rounded; and a midpoint such as 2 has few bits
    return max(int(truth.mid().bits()), own, 192) + GUARD


def _ball(value: float | Fraction) -> flint.arb:
    if isinstance(value, float):
        return flint.arb(value)  # exactly
    return flint.arb(flint.fmpq(value.numerator, value.denominator))
