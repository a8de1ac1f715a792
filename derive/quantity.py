"""Quantities: a symbol with its meaning and its unit."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp


@dataclass(frozen=True)
class Unit:
    """Rational exponents of metre and second; the radian is a label of dimension one."""

    metre: Fraction = Fraction(0)
    second: Fraction = Fraction(0)

    def __mul__(self, other: Unit) -> Unit:
        return Unit(self.metre + other.metre, self.second + other.second)

    def __truediv__(self, other: Unit) -> Unit:
        return Unit(self.metre - other.metre, self.second - other.second)

    def __pow__(self, exponent: int | Fraction) -> Unit:
        return Unit(self.metre * exponent, self.second * exponent)

    def __str__(self) -> str:
        parts = [
            name if power == 1 else f"{name}^{power}"
            for name, power in (("m", self.metre), ("s", self.second))
            if power
        ]
        return " ".join(parts) or "1"


METRE = Unit(metre=Fraction(1))
SECOND = Unit(second=Fraction(1))


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
