"""Quantities: a symbol with its meaning and its unit."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp


@dataclass(frozen=True)
class Unit:
    """Rational exponents of base units; the radian is a label of dimension one."""

    metre: Fraction = Fraction(0)
    second: Fraction = Fraction(0)
    kilogram: Fraction = Fraction(0)
    kelvin: Fraction = Fraction(0)
    ampere: Fraction = Fraction(0)

    def __mul__(self, other: Unit) -> Unit:
        return Unit(*(a + b for a, b in zip(self.exponents, other.exponents, strict=True)))

    def __truediv__(self, other: Unit) -> Unit:
        return self * other**-1

    def __pow__(self, exponent: int | Fraction) -> Unit:
        return Unit(*(power * exponent for power in self.exponents))

    @property
    def exponents(self) -> tuple[Fraction, ...]:
        """In the order of the fields."""
        return self.metre, self.second, self.kilogram, self.kelvin, self.ampere

    def __str__(self) -> str:
        named = zip(("m", "s", "kg", "K", "A"), self.exponents, strict=True)
        parts = [name if power == 1 else f"{name}^{power}" for name, power in named if power]
        return " ".join(parts) or "1"


METRE = Unit(metre=Fraction(1))
SECOND = Unit(second=Fraction(1))
KILOGRAM = Unit(kilogram=Fraction(1))
KELVIN = Unit(kelvin=Fraction(1))
AMPERE = Unit(ampere=Fraction(1))
ONE = Unit()
"""Of numbers and angles."""


@dataclass(frozen=True)
class Quantity:
    """A named positive quantity.

    Positivity is deliberately not declared to SymPy, which would fold a condition such as `t > 0`
    to `True` so that it could no longer be shown or dropped.
    """

    name: str
    latex: str
    meaning: str
    unit: Unit

    @property
    def symbol(self) -> sp.Symbol:
        """The SymPy symbol, real and otherwise without assumptions."""
        return sp.Symbol(self.name, real=True)


SAMPLING_INTERVAL = Quantity("sampling_interval", "T", "time between two measurements", SECOND)
MEASUREMENT_DEVIATION = Quantity(
    "measurement_deviation", r"\sigma_v", "standard deviation of the measured position", METRE
)
