"""How near to 0 sine and cosine come at numbers of a format.

No number of a format but 0 is a multiple of pi/2, so that neither vanishes: least is its magnitude
at a number next to a zero. Found in balls, number by number.
"""

from __future__ import annotations

import math
from fractions import Fraction

import flint

from gainproof.derive.printer.formats import Format

GREATEST = 100.0  # radians: zeros are gone through one by one
BITS = 256
SHORT = 1.0 - 2.0**-20  # of a float for the rounding of its making


def least_cosine(high: float, form: Format) -> float:
    """A positive number below |cos x| for all x of the format with |x| <= high.

    ValueError for angles beyond `GREATEST`.
    """
    with flint.ctx.workprec(BITS):
        ends = [abs(flint.arb(high).cos())]
        return _least([*ends, *_near_zeros(high, form, odd=True)], 1.0)


def least_sine(low: float, high: float, form: Format) -> float:
    """A positive number below |sin x| for all x of the format with low <= |x| <= high."""
    with flint.ctx.workprec(BITS):
        ends = [abs(flint.arb(end).sin()) for end in (low, high)]
        return _least([*ends, *_near_zeros(high, form, odd=False)], 1.0)


def _near_zeros(high: float, form: Format, odd: bool) -> list[flint.arb]:
    """Distances of zeros up to a little beyond `high` from the format's numbers, as values of the
    function there: between its zeros and their neighbours it is larger.
    """
    if high > GREATEST:
        raise ValueError(f"angles of at most {GREATEST} are wanted, got {high!r}")
    found = []
    for turn in range(1, math.ceil(high / (math.pi / 2)) + 2):
        if (turn % 2 == 1) is odd:
            zero = turn * flint.arb.pi() / 2
            near = form.nearest(Fraction(float(zero.mid())))
            around = (form.before(near), near, form.after(near))
            found += [abs((flint.arb(x) - zero).sin()) for x in around]
    return found


def _least(values: list[flint.arb], most: float) -> float:
    return min(most, *(float(value.lower()) * SHORT for value in values))
