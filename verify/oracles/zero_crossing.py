"""Where a function passes zero, between numbers at which its sign is certain.

Independent because the function is all that is known: its signs in balls of python-flint decide,
and no formula for the place is used.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import flint


def between(
    low: Fraction, high: Fraction, rising: Callable[[flint.arb], flint.arb], bits: int
) -> tuple[Fraction, Fraction]:
    """Two numbers above zero between which a function passes zero upwards, 2^-bits apart.

    Only signs are believed. Where they are looked at the chord says: on both sides of its zero, at
    a distance that is squared each time when the crossing was in between (quadratic refinement of
    intervals, Abbott), else half way.

    Raises ValueError unless the ends have opposite signs, ArithmeticError where a sign is not
    decided at the working precision.
    """
    below, above = rising(_ball(low)), rising(_ball(high))
    if not (below < 0 and above > 0):
        raise ValueError(f"no crossing upwards between {float(low)} and {float(high)}")
    halvings = 1
    while high - low > low * Fraction(1, 2**bits):
        wide, least = high - low, low / (3 * 2**bits)
        if halvings > 1 and high < 16 * low:
            at = low + wide * _exact((below / (below - above)).mid())
            off = max(wide / 2**halvings, least)
            places = [_short(at - off, 3 * bits), _short(at + off, 3 * bits)]
        else:
            places = [_middle(low, high)]
        for place in places:
            if not low < place < high:
                continue
            value = rising(_ball(place))
            if value > 0:
                high, above = place, value
            elif value < 0:
                low, below = place, value
            elif value == 0:
                return place, place
            else:
                raise ArithmeticError("the working precision does not decide a sign")
        near = (high - low) * 2 ** (halvings - 1) <= wide
        halvings = 2 * halvings if near else max(1, halvings // 2)
    return low, high


def _exact(value: flint.arb) -> Fraction:
    """The number that an exact ball is."""
    mantissa, exponent = value.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _short(value: Fraction, bits: int) -> Fraction:
    """The value to so many bits, more or less."""
    place = bits - value.numerator.bit_length() + value.denominator.bit_length()
    return Fraction(round(value * 2**place), 2**place) if place > 0 else value


def _middle(low: Fraction, high: Fraction) -> Fraction:
    """Half way, of logarithms as long as the ends are of another size."""
    if high < 16 * low:
        return (low + high) / 2
    sizes = [x.numerator.bit_length() - x.denominator.bit_length() for x in (low, high)]
    return Fraction(2) ** (sum(sizes) // 2)


def _ball(value: Fraction) -> flint.arb:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))
