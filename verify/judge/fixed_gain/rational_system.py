"""Linear systems whose coefficients are polynomials: solved by elimination without fractions."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm

from gainproof.verify.judge.exact.expression import Expr, mul, number, whole_power
from gainproof.verify.judge.exact.polynomial import (
    Poly,
    Ring,
    fraction,
    from_terms,
    rational,
    ring,
    terms,
)
from gainproof.verify.judge.exact.simplification import expression_of
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.work_limits import Undecided


def solved(matrix: Sequence[Sequence[Poly]], rights: Sequence[Sequence[Poly]]) -> list[list[Poly]]:
    """Solutions for several right sides, each a list of numerators over the determinant, which
    comes last. Raises Undecided if the determinant is zero.

    Bareiss: every division is exact, and the last pivot is the determinant up to its sign, which
    numerators and determinant share.
    """
    size = len(matrix)
    rows = [[*row, *(right[i] for right in rights)] for i, row in enumerate(matrix)]
    before = _one(matrix[0][0])
    for k in range(size):
        pivot = next((i for i in range(k, size) if not rows[i][k].is_zero()), None)
        if pivot is None:
            raise Undecided("a system of linear equations without one solution")
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(size):
            if i != k:
                top, own = rows[k][k], rows[i][k]
                pairs = zip(rows[i], rows[k], strict=True)
                rows[i] = [_exact(top * x - own * y, before) for x, y in pairs]
        before = rows[k][k]
    # all pivots are the determinant now
    return [[*[rows[i][size + j] for i in range(size)], before] for j in range(len(rights))]


def quotient(top: Poly, bottom: Poly, names: Sequence[str]) -> Expr:
    """Numerator over denominator in lowest terms, each written as a product of its factors."""
    common = top.gcd(bottom)
    top, bottom = _exact(top, common), _exact(bottom, common)
    if top.is_zero():
        return number(0)
    (high, above), (low, below) = _factors(top, names), _factors(bottom, names)
    content = high / low
    above = above if content == 1 and above else [number(content), *above]
    return mul(*above) / mul(*below) if below else mul(*above)


def lowest(expr: Expr, names: Sequence[str]) -> Expr:
    """A rational expression of these symbols in lowest terms, as quotient of factored sides."""
    top, bottom = numerator_and_denominator(expr, names)
    return quotient(top, bottom, names)


def numerator_and_denominator(expr: Expr, names: Sequence[str]) -> tuple[Poly, Poly]:
    """Of a rational expression in lowest terms, as polynomials of these symbols; the denominator
    has a positive leading coefficient. Raises Undecided.
    """
    element = build_tower([expr], None, tuple(names), frozenset()).element(expr)
    own = ring(tuple(names))
    top, bottom = (_behind_roots(own, p) for p in (element.num, element.den))
    common = top.gcd(bottom)
    top, bottom = _exact(top, common), _exact(bottom, common)
    return (top, bottom) if fraction(bottom.leading_coefficient()) > 0 else (-top, -bottom)


def _behind_roots(context: Ring, p: Poly) -> Poly:
    """A polynomial of a tower in the last variables alone, as those of a ring of their own; the
    places of roots are before them.
    """
    first = p.context().nvars() - context.nvars()
    found = {}
    for e, c in terms(p):
        if any(e[:first]):
            raise Undecided("a root where a rational function is wanted")
        found[tuple(e[first:])] = c
    return from_terms(context, found)


def primitive(p: Poly) -> Poly:
    """The polynomial over its content, with its sign."""
    return p if p.is_zero() else p / rational(abs(_content(p)))


def _factors(p: Poly, names: Sequence[str]) -> tuple[Fraction, list[Expr]]:
    content = Fraction(1)
    found = []
    constant_part, factors = p.factor()
    content *= fraction(constant_part)
    for factor, exponent in factors:
        part = _content(factor)
        content *= part ** int(exponent)
        found.append(whole_power(expression_of(factor / rational(part), names), int(exponent)))
    return content, found


def _content(p: Poly) -> Fraction:
    """The number that leaves whole coefficients without a common divisor, the first or the constant
    term positive.
    """
    found = [fraction(c) for _, c in terms(p)]
    top, bottom = gcd(*(c.numerator for c in found)), lcm(*(c.denominator for c in found))
    constants = [fraction(c) for e, c in terms(p) if not any(e)]
    leading = constants[0] if constants else fraction(p.leading_coefficient())
    return Fraction(top, bottom) * (1 if leading > 0 else -1)


def _exact(p: Poly, by: Poly) -> Poly:
    found, rest = divmod(p, by)
    if not rest.is_zero():
        raise Undecided("a division that should be exact is not")
    return found


def _one(p: Poly) -> Poly:
    return p.context().constant(1)
