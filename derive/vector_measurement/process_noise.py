"""The numbers of a family's process noise, and how sums and products are written with them."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

HALF = Fraction(1, 2)


def times(number: Fraction, value: Any) -> Any:
    """number * value; a quotient by the denominator where the number is one over an integer."""
    if number == 1:
        return value
    return value / number.denominator if number.numerator == 1 else value * number


def total(*terms: Any) -> Any:
    """The sum of the terms that are there: None stands for a term that vanishes in the family."""
    first, *rest = (term for term in terms if term is not None)
    for term in rest:
        first = first + term
    return first


@dataclass(frozen=True)
class Noise:
    """The numbers of a family: e = noise(4)/noise(0) and n = Q12/Q22."""

    e: Fraction
    n: Fraction

    @property
    def first(self) -> Fraction:
        """Q11/Q22."""
        return self.n - (1 - self.e) / 4

    @property
    def determinant(self) -> Fraction:
        """d = det Q/Q22^2."""
        return self.first - self.n * self.n

    @property
    def interval(self) -> bool:
        """Whether n = 1/2: the noise acts all through the interval, and eta is a product."""
        return self.n == HALF

    @property
    def settles(self) -> bool:
        """Whether K21 tends to a positive value with the index; else it rises and falls."""
        return self.interval and not self.e
