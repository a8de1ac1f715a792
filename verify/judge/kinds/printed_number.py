"""Numbers that a printed one may be rounded from.

A tie is rounded away from zero or to the even digit, as sources do: 0.65 is printed as 0.7 or 0.6,
but 0.75 as 0.8 only.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.statement import Enclosure, Rel


@dataclass(frozen=True)
class PrintedNumber:
    """A number with its decimals; fewer than none where its last digits are not shown."""

    value: Fraction
    decimals: int

    @property
    def half(self) -> Fraction:
        """Half a unit of the last digit."""
        return Fraction(1, 2) / Fraction(10) ** self.decimals

    @property
    def low(self) -> Fraction:
        """The lower end of the interval."""
        return self.value - self.half

    @property
    def high(self) -> Fraction:
        """The upper end."""
        return self.value + self.half

    @property
    def is_even(self) -> bool:
        """Whether the last digit is even."""
        units = self.value * Fraction(10) ** self.decimals
        return units.denominator != 1 or units.numerator % 2 == 0

    def bounds(self, exact: Expr) -> tuple[Rel, Rel]:
        """That an exact value lies in the interval, a tie with it where it may be rounded so."""
        low = "<=" if self.value > 0 or self.is_even else "<"
        high = "<=" if self.value < 0 or self.is_even else "<"
        return Rel(low, number(self.low), exact), Rel(high, exact, number(self.high))

    def ball(self) -> Enclosure:
        """The interval, for a witness."""
        return Enclosure(str(float(self.value)), str(float(self.half)))

    def text(self) -> str:
        """`13/20 to 3/4`."""
        return f"{self.low} to {self.high}"

    def note(self) -> str:
        """What the digits stand for, in words."""
        if self.is_even:
            return f"the digits stand for {self.text()}"
        end = self.low if self.value < 0 else self.high
        return f"the digits stand for {self.text()}, {end} left out"
