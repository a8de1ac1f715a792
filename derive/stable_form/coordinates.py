"""Positive parameters for inputs: what lies above an end of the domain, or between its two ends.

An input x from a on is x = a + t with t > 0; one between a and b is x = (a + b t)/(1 + t), where
t = (x - a)/(b - x). A polynomial in t without negative coefficients is then positive on the domain;
multiplied by (b - x)^n it is one in x - a and b - x, two differences of exact numbers (Bernstein's
form). Where the root of t occurs the parameter is that root.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.domain import input_range
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Input, Limit


@dataclass(frozen=True)
class Coordinate:
    """An input above `low`, and below `high` if that is a number; `rooted`: t is a square."""

    name: str
    low: Fraction
    high: Fraction | None
    rooted: bool = False

    @property
    def parameter(self) -> str:
        """The name of the positive parameter; no input or output has one with such an end."""
        return f"{self.name}_root_" if self.rooted else f"{self.name}_above_"

    @property
    def above(self) -> sp.Expr:
        """t = (x - a)/(b - x), or x - a."""
        symbol = real(self.parameter)
        return symbol**2 if self.rooted else symbol

    @property
    def value(self) -> sp.Expr:
        """The input over the parameter."""
        low, t = rational(self.low), self.above
        if self.high is None:
            return low + t
        return (low + rational(self.high) * t) / (1 + t)


def rational(value: Fraction) -> sp.Rational:
    """A fraction as SymPy's number."""
    return sp.Rational(value.numerator, value.denominator)


def coordinates(inputs: Sequence[Input]) -> Iterator[tuple[Coordinate, ...]]:
    """Positive numbers first, then numbers above the lower ends, then those between both ends.

    What is positive for all positive numbers needs no shift; so the widest domain comes first.
    """
    ends = {given.name: _ends(given) for given in inputs}
    for name, (low, _) in ends.items():
        if low is None or low < 0:
            raise ValueError(f"input {name}: a stable form is looked for on a domain above 0")
    known: list[tuple[Coordinate, ...]] = []
    for shifted, bounded in ((False, False), (True, False), (False, True), (True, True)):
        found = tuple(
            Coordinate(
                name, (low or Fraction(0)) if shifted else Fraction(0), high if bounded else None
            )
            for name, (low, high) in ends.items()
        )
        if found not in known:
            known.append(found)
            yield found


def _ends(given: Input) -> tuple[Fraction | None, Fraction | None]:
    """The ends of a domain, or the numbers of a format that are taken for them and lie outside."""
    low, high = _rational(given.lower), _rational(given.upper)
    if low is not None:
        low = min(low, *(Fraction(input_range(given, form)[0]) for form in FORMATS))
    if high is not None:
        high = max(high, *(Fraction(input_range(given, form)[1]) for form in FORMATS))
    return low, high


def _rational(limit: Limit | None) -> Fraction | None:
    """A limit of a domain, None where it is no rational number."""
    return None if limit is None else constant(limit).rational
