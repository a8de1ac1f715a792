"""Polynomials of the parameters alone: one form for each zero set, substitution, expressions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.polynomial import (
    Poly,
    Ring,
    coefficients_in,
    fraction,
    rational,
    terms,
)
from gainproof.verify.judge.exact.rational_roots import content_of
from gainproof.verify.judge.exact.simplification import expression_of


def normal(p: Poly) -> Poly:
    """The multiple with integer coefficients, without common factor, the leading one positive."""
    p = p / rational(content_of(p))
    return -p if p.leading_coefficient() < 0 else p


def irreducible(polys: Iterable[Poly]) -> list[Poly]:
    """The distinct irreducible factors in normal form, without constants, simple ones first."""
    found: dict[str, Poly] = {}
    for p in polys:
        if p.is_zero() or p.is_constant():
            continue
        for factor, _ in p.factor()[1]:
            shape = normal(factor)
            found.setdefault(str(shape), shape)
    return sorted(found.values(), key=lambda f: (f.total_degree(), len(f), str(f)))


def over(context: Ring, p: Poly) -> Poly:
    """A polynomial of the parameters in a ring that has no other variables."""
    return p.project_to_context(context)


def put_in(p: Poly, name: str, value: Fraction) -> Poly:
    """The polynomial with a number for one variable."""
    return p.subs({name: rational(value)})


def value_at(p: Poly, point: Sequence[Fraction]) -> Fraction:
    """The polynomial at a rational point."""
    total = Fraction(0)
    for exponents, coefficient in terms(p):
        term = fraction(coefficient)
        for base, exponent in zip(point, exponents, strict=True):
            if exponent:
                term *= base ** int(exponent)
        total += term
    return total


def leading(p: Poly, index: int) -> Poly:
    """The leading coefficient in one variable."""
    return coefficients_in(p, index)[-1]


def as_expr(p: Poly, names: Sequence[str]) -> Expr:
    """The polynomial as an expression of these symbols."""
    return expression_of(p, names)
