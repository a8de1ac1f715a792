"""Positive roots that need no evidence: perfect powers, and the tower's own generators."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.ratio import Ratio, number, polynomial

# Numbers whose roots are looked for; longer ones would cost time and are not needed.
_MAXIMUM_BITS = 512


def known_root(value: Ratio, degree: int) -> Ratio | None:
    """The nonnegative root of that degree, if ``value`` visibly has one; else None.

    It has one when it is zero, when it is a perfect power of one positive term over perfect powers,
    or when it equals the radicand of a generator of that degree.
    """
    field = value.field
    if value.is_zero():
        return number(field, 0)
    for index, generator in enumerate(field.generators):
        if generator.power == degree and value.equals(polynomial(field, generator.radicand)):
            return polynomial(field, field.ring.variable(field.position(index)))
    return _perfect(field, value, degree)


def _perfect(field: Field, value: Ratio, degree: int) -> Ratio | None:
    if len(value.numerator.terms) != 1:
        return None
    ((monomial, coefficient),) = value.numerator.coefficients()
    scale = rational_root(coefficient, degree)
    if scale is None or any(e % degree for e in monomial):
        return None
    if any(m % degree or field.has_free(f) for f, m in value.factors.items()):
        return None
    if field.has_free(value.numerator) or any(
        parameter.lower < 0 and monomial[i] for i, parameter in enumerate(field.parameters)
    ):
        return None  # the sign of the base of the power is not known
    base = field.ring.monomial({i: e // degree for i, e in enumerate(monomial)})
    factors = {f: m // degree for f, m in value.factors.items()}
    return Ratio(field, base.times(scale), factors)


def rational_root(value: Fraction, degree: int) -> Fraction | None:
    """The rational number whose power is ``value`` > 0, if there is one."""
    if value <= 0 or max(value.numerator, value.denominator).bit_length() > _MAXIMUM_BITS:
        return None
    above = integer_root(value.numerator, degree)
    below = integer_root(value.denominator, degree)
    if above**degree != value.numerator or below**degree != value.denominator:
        return None
    return Fraction(above, below)


def integer_root(value: int, degree: int) -> int:
    """The largest integer whose power does not exceed ``value`` >= 0 (bisection)."""
    low, high = 0, 1 << (value.bit_length() // degree + 1)
    while high - low > 1:
        middle = (low + high) // 2
        if middle**degree <= value:
            low = middle
        else:
            high = middle
    return low
