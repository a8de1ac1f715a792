"""How far a computed number is from an enclosed one, decided in balls.

Independent of everything computed: both answers hold for every number that the ball contains.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.oracles.state_space import exact

# The differences are formed with this many bits beyond those of the ball.
GUARD = 64


def within(
    computed: float | Fraction, truth: flint.arb, bound: Fraction, scale: Any = None
) -> bool:
    """Whether |computed - truth| <= bound * |scale| is certain; the scale is the truth itself
    unless another ball is given. A computed NaN or infinity is never within.
    """
    try:
        value = exact(computed)
    except ValueError:
        return False
    with flint.ctx.workprec(_bits(value, truth)):
        apart = abs(_ball(value) - truth)
        return bool(apart <= _ball(bound) * abs(truth if scale is None else scale))


def relative_error(computed: float | Fraction, truth: flint.arb, scale: Any = None) -> float:
    """An upper bound of |computed - truth| / |scale| as a float, rounded up by at most 2^-50."""
    try:
        value = exact(computed)
    except ValueError:
        return float("inf")
    with flint.ctx.workprec(_bits(value, truth)):
        ratio = abs(_ball(value) - truth) / abs(truth if scale is None else scale)
        return float(ratio.upper()) * (1 + 2.0**-51)


def middle(ball: flint.arb) -> Fraction:
    """The midpoint of a ball, exactly."""
    mantissa, exponent = ball.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _bits(value: Fraction, truth: flint.arb) -> int:
    # the number itself must not be rounded; and a midpoint such as 2 has few bits
    return max(int(truth.mid().bits()), value.numerator.bit_length(), 192) + GUARD


def _ball(value: Fraction) -> flint.arb:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))
