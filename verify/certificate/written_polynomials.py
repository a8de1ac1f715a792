"""Polynomials and fractions as they are written in a certificate, read strictly."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Exponents, Polynomial, Ring
from gainproof.verify.certificate.ratio import Ratio, fraction
from gainproof.verify.certificate.rejection import (
    MAXIMUM_EXPONENT,
    MAXIMUM_TERMS,
    MalformedError,
    RejectedError,
)


def polynomial(value: Plain, ring: Ring, place: str) -> Polynomial:
    """A polynomial: [[coefficient, [exponents]], ...], nonzero, exponents strictly descending."""
    terms: dict[Exponents, Fraction] = {}
    previous: Exponents | None = None
    entries = schema.items(value, place)
    if len(entries) > MAXIMUM_TERMS:
        raise MalformedError(f"{place}: more than {MAXIMUM_TERMS} terms")
    ring.meter.spend(len(entries))
    for entry in entries:
        pair = schema.items(entry, place)
        if len(pair) != 2:
            raise MalformedError(f"{place}: a term is a coefficient and a list of exponents")
        exponents = schema.items(pair[1], place)
        if len(exponents) != ring.size:
            raise MalformedError(f"{place}: {ring.size} exponents wanted, {len(exponents)} found")
        monomial = tuple(schema.integer(e, 0, MAXIMUM_EXPONENT, place) for e in exponents)
        if previous is not None and not monomial < previous:
            raise MalformedError(f"{place}: the terms are not in strictly descending order")
        coefficient = schema.number(pair[0], place)
        if not coefficient:
            raise MalformedError(f"{place}: a term with coefficient 0")
        terms[monomial] = coefficient
        previous = monomial
    return ring.polynomial(terms)


@dataclass(frozen=True, slots=True)
class WrittenFraction:
    """Numerator and denominator as the certificate writes them, unreduced."""

    numerator: Polynomial
    denominator: Polynomial
    place: str

    def ratio(self, field: Field) -> Ratio:
        """The value; the denominator must be manifestly positive."""
        return fraction(field, self.numerator, self.denominator, self.place)

    def positive(self, field: Field) -> Ratio:
        """The value, which must be manifestly positive."""
        if not field.positive(self.numerator):
            raise RejectedError(f"{self.place}: the numerator is not manifestly positive")
        return self.ratio(field)

    def positive_along(self, field: Field, position: int) -> Ratio:
        """The value, manifestly positive where one parameter is not at the end of its domain."""
        if not field.positive_along(self.numerator, position):
            raise RejectedError(f"{self.place}: the numerator is not manifestly positive inside")
        return self.ratio(field)

    def nonnegative(self, field: Field) -> Ratio:
        """The value, which must be manifestly nonnegative."""
        if not field.nonnegative(self.numerator):
            raise RejectedError(f"{self.place}: the numerator is not manifestly nonnegative")
        return self.ratio(field)


def read_fraction(value: Plain, ring: Ring, place: str) -> WrittenFraction:
    """A fraction: {"num": polynomial, "den": polynomial}."""
    fields = schema.record(value, ("num", "den"), place)
    return WrittenFraction(
        polynomial(fields["num"], ring, f"{place}.num"),
        polynomial(fields["den"], ring, f"{place}.den"),
        place,
    )
