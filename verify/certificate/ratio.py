"""Quotients over a field: a reduced numerator over a product of factors known not to vanish.

Every factor below the line was shown not to vanish when it was put there: it is manifestly
positive, or it holds free symbols and some coefficient of theirs does not vanish. So a numerator
that reduces to zero means zero at every point (with free symbols: wherever defined).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.rejection import MAXIMUM_EXPONENT, RejectedError

Factors = Mapping[Polynomial, int]


@dataclass(frozen=True, slots=True, eq=False)
class Ratio:
    """``numerator / product of factor^multiplicity``; the numerator is reduced."""

    field: Field
    numerator: Polynomial
    factors: Factors

    def __neg__(self) -> Ratio:
        return Ratio(self.field, -self.numerator, self.factors)

    def __add__(self, other: Ratio) -> Ratio:
        common = dict(self.factors)
        for factor, multiplicity in other.factors.items():
            common[factor] = max(multiplicity, common.get(factor, 0))
        total = self._over(common) + other._over(common)
        return Ratio(self.field, self.field.reduce(total), common if total else {})

    def __sub__(self, other: Ratio) -> Ratio:
        return self + -other

    def __mul__(self, other: Ratio) -> Ratio:
        factors = dict(self.factors)
        for factor, multiplicity in other.factors.items():
            factors[factor] = factors.get(factor, 0) + multiplicity
            if factors[factor] > MAXIMUM_EXPONENT:
                raise RejectedError(f"a multiplicity grew beyond {MAXIMUM_EXPONENT}")
        return Ratio(self.field, self.field.reduce(self.numerator * other.numerator), factors)

    def power(self, exponent: int) -> Ratio:
        """A nonnegative integer power."""
        result = number(self.field, 1)
        for _ in range(exponent):
            result = result * self
        return result

    def equals(self, other: Ratio) -> bool:
        """Whether the two are shown equal everywhere."""
        return not (self - other).numerator

    def is_zero(self) -> bool:
        """Whether this is shown to vanish everywhere."""
        return not self.numerator

    def constant_value(self) -> Fraction | None:
        """The number this is, if it is visibly one."""
        return None if self.factors else self.numerator.constant_value()

    def over(self, divisor: Ratio) -> Ratio:
        """This divided by ``divisor``, whose numerator the caller has shown not to vanish.

        A factor common to both denominators is cancelled.
        """
        if divisor.is_zero():
            raise RejectedError("a division by zero")
        below = dict(self.factors)
        above = self.numerator
        for factor, multiplicity in divisor.factors.items():
            cancelled = min(multiplicity, below.get(factor, 0))
            _put(below, factor, below.get(factor, 0) - cancelled)
            above = self.field.reduce(above * factor ** (multiplicity - cancelled))
        scale, factor = oriented(self.field, divisor.numerator)
        value = factor.constant_value()
        if value is None:
            below[factor] = below.get(factor, 0) + 1
        else:
            scale *= value
        return Ratio(self.field, above.times(1 / scale), below)

    def _over(self, common: Factors) -> Polynomial:
        """The numerator after extension to a common multiple of the factors."""
        extended = self.numerator
        for factor, multiplicity in common.items():
            for _ in range(multiplicity - self.factors.get(factor, 0)):
                extended = self.field.reduce(extended * factor)
        return extended


def oriented(field: Field, divisor: Polynomial) -> tuple[Fraction, Polynomial]:
    """A number and a primitive polynomial with this product; positive if manifestly so."""
    scale, factor = divisor.primitive()
    if field.has_free(factor):
        flip = factor.terms[max(factor.terms)] < 0
    else:
        flip = field.positive(-factor)
    return (-scale, -factor) if flip else (scale, factor)


def number(field: Field, value: Fraction | int) -> Ratio:
    """A number over a field."""
    return Ratio(field, field.ring.constant(value), {})


def polynomial(field: Field, value: Polynomial) -> Ratio:
    """A polynomial over a field."""
    return Ratio(field, field.reduce(value), {})


def fraction(field: Field, numerator: Polynomial, denominator: Polynomial, place: str) -> Ratio:
    """A fraction whose denominator must be manifestly positive."""
    if not field.positive(denominator):
        raise RejectedError(f"{place}: the denominator is not manifestly positive")
    return polynomial(field, numerator).over(polynomial(field, denominator))


def total(field: Field, terms: Iterable[Ratio]) -> Ratio:
    """The sum of any number of terms."""
    result = number(field, 0)
    for term in terms:
        result = result + term
    return result


def _put(factors: dict[Polynomial, int], factor: Polynomial, multiplicity: int) -> None:
    if multiplicity:
        factors[factor] = multiplicity
    else:
        factors.pop(factor, None)
