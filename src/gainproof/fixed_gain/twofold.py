"""Numbers of twice the precision as sums of two floats, for differences that cancel.

Sums by Knuth, products by Dekker and Veltkamp: a sum errs by at most 3.1 2^-106 of itself, a
product by 7.1 2^-106 (Joldes, Muller and Popescu 2017, algorithms 6 and 10), for magnitudes from
1e-140 to 1e140. Sides of inequalities are evaluated with them as with floats.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Reals

SPLIT = 2.0**27 + 1.0


@dataclass(frozen=True, eq=False)
class Twofold:
    """high + low, |low| at most half a unit in the last place of high."""

    high: Reals
    low: Reals

    @staticmethod
    def of(values: Reals) -> Twofold:
        return Twofold(values, values * 0.0)

    @staticmethod
    def where(mask: NDArray[np.bool_], a: Twofold, b: Twofold) -> Twofold:
        return Twofold(np.where(mask, a.high, b.high), np.where(mask, a.low, b.low))

    def __add__(self, other: Twofold | float) -> Twofold:
        second = other if isinstance(other, Twofold) else Twofold.of(self.high * 0.0 + other)
        total, rest = _sum(self.high, second.high)
        lower, least = _sum(self.low, second.low)
        total, rest = _short(total, rest + lower)
        return Twofold(*_short(total, rest + least))

    __radd__ = __add__

    def __neg__(self) -> Twofold:
        return Twofold(-self.high, -self.low)

    def __sub__(self, other: Twofold | float) -> Twofold:
        return self + (-other)

    def __rsub__(self, other: float) -> Twofold:
        return -self + other

    def __mul__(self, other: Twofold | float) -> Twofold:
        second = other if isinstance(other, Twofold) else Twofold.of(self.high * 0.0 + other)
        product, rest = _product(self.high, second.high)
        return Twofold(*_short(product, rest + (self.high * second.low + self.low * second.high)))

    __rmul__ = __mul__

    def __truediv__(self, power: int) -> Twofold:
        """By a power of two."""
        return Twofold(self.high / power, self.low / power)


def _sum(a: Reals, b: Reals) -> tuple[Reals, Reals]:
    """a + b and what its rounding leaves."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def _short(a: Reals, b: Reals) -> tuple[Reals, Reals]:
    """The same where b is far smaller than a."""
    total = a + b
    return total, b - (total - a)


def _product(a: Reals, b: Reals) -> tuple[Reals, Reals]:
    """a b and what its rounding leaves."""
    product = a * b
    (high, low), (front, back) = _halves(a), _halves(b)
    return product, low * back - (((product - high * front) - low * front) - high * back)


def _halves(a: Reals) -> tuple[Reals, Reals]:
    """Two numbers of 26 bits each whose sum is a."""
    wide = SPLIT * a
    high = wide - (wide - a)
    return high, a - high
