"""Small services around python-flint polynomials; the only place that knows their types."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import flint

Poly = Any
"""A flint.fmpq_mpoly; python-flint's own annotations are incomplete."""
Ring = Any
"""A flint.fmpq_mpoly_ctx."""
Ball = Any
"""A flint.arb."""


def ring(names: Sequence[str]) -> Ring:
    """Polynomials with rational coefficients, lexicographic order, the first name highest."""
    return flint.fmpq_mpoly_ctx.get(tuple(names), "lex")


def constant(context: Ring, value: Fraction | int) -> Poly:
    """A number as a polynomial."""
    return context.constant(rational(value))


def rational(value: Fraction | int) -> Any:
    """A fraction as flint.fmpq."""
    return flint.fmpq(value.numerator, value.denominator)


def exact_value(ball: Ball) -> Fraction:
    """The number that a ball of radius 0 is."""
    mantissa, exponent = ball.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def fraction(value: Any) -> Fraction:
    """A flint.fmpq or fmpz as a fraction."""
    value = flint.fmpq(value)
    return Fraction(int(value.p), int(value.q))


def terms(p: Poly) -> Iterable[tuple[tuple[int, ...], Any]]:
    """Exponents and coefficient of each term."""
    found: Iterable[tuple[tuple[int, ...], Any]] = p.to_dict().items()
    return found


def from_terms(context: Ring, entries: Mapping[tuple[int, ...], Any]) -> Poly:
    """The polynomial with these terms."""
    return context.from_dict(dict(entries))


def degree(p: Poly, index: int) -> int:
    """Degree in one variable; -1 for the zero polynomial."""
    return -1 if p.is_zero() else int(p.degrees()[index])


def coefficients_in(p: Poly, index: int, least: int = 0) -> list[Poly]:
    """Coefficients in one variable, from power 0 up, at least `least` of them."""
    context = p.context()
    parts: list[dict[tuple[int, ...], Any]] = [{} for _ in range(max(least, degree(p, index) + 1))]
    for exponents, coefficient in terms(p):
        rest = (*exponents[:index], 0, *exponents[index + 1 :])
        parts[exponents[index]][rest] = coefficient
    return [from_terms(context, part) for part in parts]


def grouped(p: Poly, indices: Sequence[int]) -> dict[tuple[int, ...], Poly]:
    """The polynomial split by its monomials in some variables: exponents -> coefficient."""
    context = p.context()
    parts: dict[tuple[int, ...], dict[tuple[int, ...], Any]] = {}
    for exponents, coefficient in terms(p):
        rest = list(exponents)
        for i in indices:
            rest[i] = 0
        label = tuple([exponents[i] for i in indices])
        parts.setdefault(label, {})[tuple(rest)] = coefficient
    return {label: from_terms(context, part) for label, part in parts.items()}


def monomial_content(p: Poly, indices: Sequence[int]) -> tuple[int, ...]:
    """Smallest exponent of each of these variables over all terms."""
    lists = [tuple(e[i] for i in indices) for e, _ in terms(p)]
    return (
        tuple(min(column) for column in zip(*lists, strict=True)) if lists else (0,) * len(indices)
    )


def univariate(p: Poly, index: int) -> Any:
    """A polynomial in one variable only as primitive flint.fmpz_poly. Raises ValueError if others
    occur.
    """
    dense: dict[int, Fraction] = {}
    for exponents, coefficient in terms(p):
        if any(e for i, e in enumerate(exponents) if i != index):
            raise ValueError("more than one variable")
        dense[exponents[index]] = fraction(coefficient)
    if not dense:
        return flint.fmpz_poly([])
    scale = 1
    for value in dense.values():
        scale = scale * value.denominator // _gcd(scale, value.denominator)
    return flint.fmpz_poly([int(dense.get(k, Fraction(0)) * scale) for k in range(max(dense) + 1)])


def _gcd(a: int, b: int) -> int:
    while b:
        a, b = b, a % b
    return a


def text(p: Poly) -> str:
    """Readable text."""
    return str(p)
