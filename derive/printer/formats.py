"""The two floating-point formats of the kernels, as exact numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True)
class Format:
    """A binary format: `digits` of the significand, least and greatest exponent of normal numbers.

    Its numbers are held as Python floats, which is exact for both formats.
    """

    name: str
    digits: int
    least_exponent: int
    greatest_exponent: int

    @property
    def unit_roundoff(self) -> float:
        """u: a rounded operation's relative error where the result is normal."""
        return math.ldexp(1.0, -self.digits)

    @property
    def epsilon(self) -> float:
        """The gap after 1, the unit of the printed bounds."""
        return math.ldexp(1.0, 1 - self.digits)

    @property
    def decimals(self) -> int:
        """Decimal digits of a number: 16 of float64, 7 of float32."""
        return round(self.digits * math.log10(2.0))

    @property
    def least_normal(self) -> float:
        return math.ldexp(1.0, self.least_exponent)

    @property
    def least(self) -> float:
        """The least positive number, a subnormal."""
        return math.ldexp(1.0, self.least_exponent - self.digits + 1)

    @property
    def largest(self) -> float:
        return math.ldexp(2.0 - self.epsilon, self.greatest_exponent)

    def nearest(self, value: Fraction) -> float:
        """The number nearest to `value`, ties to even; OverflowError beyond the largest."""
        # in whole numbers, which take a tenth of the time of fractions
        above, below = abs(value.numerator), value.denominator
        if above == 0:
            return 0.0
        exponent = above.bit_length() - below.bit_length()
        if above << max(-exponent, 0) < below << max(exponent, 0):
            exponent -= 1
        place = max(exponent, self.least_exponent) - self.digits + 1  # of the last digit
        below <<= max(place, 0)
        units, rest = divmod(above << max(-place, 0), below)
        units += 2 * rest > below or (2 * rest == below and units % 2 == 1)
        if units.bit_length() + place > self.greatest_exponent + 1:
            raise OverflowError(f"{float(value)!r} is beyond the largest {self.name}")
        return math.ldexp(float(units if value.numerator > 0 else -units), place)

    def at_least(self, value: Fraction) -> float:
        """The least number that is not below `value`."""
        nearest = self.nearest(value)
        over, under = nearest.as_integer_ratio()
        is_above = over * value.denominator >= value.numerator * under
        return nearest if is_above else self.after(nearest)

    def at_most(self, value: Fraction) -> float:
        """The greatest number that is not above `value`."""
        return -self.at_least(-value)

    def after(self, x: float) -> float:
        """The next number above `x`."""
        return self.from_ordinal(self.ordinal(x) + 1)

    def before(self, x: float) -> float:
        """The next number below `x`."""
        return self.from_ordinal(self.ordinal(x) - 1)

    def ordinal(self, x: float) -> int:
        """The place of `x` among the numbers of the format; zero has 0, the least positive 1."""
        if x == 0:
            return 0
        binade = max(math.frexp(abs(x))[1] - 1, self.least_exponent)
        units = int(math.ldexp(abs(x), self.digits - 1 - binade))
        place = units + ((binade - self.least_exponent) << (self.digits - 1))
        return -place if x < 0 else place

    def from_ordinal(self, place: int) -> float:
        """The number at a place, the inverse of `ordinal`; infinity beyond the largest."""
        size = abs(place)
        binade = max((size >> (self.digits - 1)) - 1, 0)
        units = size - (binade << (self.digits - 1))
        exponent = self.least_exponent - self.digits + 1 + binade
        if exponent > self.greatest_exponent - self.digits + 1:
            return math.copysign(math.inf, place)
        value = math.ldexp(float(units), exponent)
        return -value if place < 0 else value


FLOAT64 = Format("float64", 53, -1022, 1023)
FLOAT32 = Format("float32", 24, -126, 127)
FORMATS = (FLOAT64, FLOAT32)
