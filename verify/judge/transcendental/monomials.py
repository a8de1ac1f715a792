"""Expressions as sums of rational numbers times monomials, in one normal form."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, add, mul, number, power
from gainproof.verify.judge.exact.work_limits import Undecided

MOST_TERMS = 300
MOST_POWER = 16

Monomial = frozenset[tuple[Expr, int]]
Terms = Mapping[Monomial, Fraction]
UNIT: Monomial = frozenset()


def monomials(expr: Expr) -> dict[Monomial, Fraction]:
    """Monomial -> coefficient. What is no sum, product or quotient by one monomial is an atom."""
    match expr.kind:
        case "number":
            return {UNIT: expr.fraction} if expr.fraction else {}
        case "add":
            total: dict[Monomial, Fraction] = {}
            for part in expr.parts:
                for monomial, c in monomials(part).items():
                    total[monomial] = total.get(monomial, Fraction(0)) + c
            return {m: c for m, c in total.items() if c}
        case "neg":
            return {m: -c for m, c in monomials(expr.parts[0]).items()}
        case "mul":
            product: dict[Monomial, Fraction] = {UNIT: Fraction(1)}
            for part in expr.parts:
                product = _times(product, monomials(part))
            return product
        case "div":
            return _times(monomials(expr.parts[0]), _inverse(expr.parts[1]))
        case "pow" if expr.fraction.denominator == 1 and abs(expr.fraction) <= MOST_POWER:
            base = expr.parts[0]
            factor = monomials(base) if expr.fraction >= 0 else _inverse(base)
            product = {UNIT: Fraction(1)}
            for _ in range(abs(int(expr.fraction))):
                product = _times(product, factor)
            return product
        case _:
            return {frozenset([(expr, 1)]): Fraction(1)}


def _inverse(expr: Expr) -> dict[Monomial, Fraction]:
    found = monomials(expr)
    if len(found) != 1:
        return {frozenset([(expr, -1)]): Fraction(1)}
    ((monomial, c),) = found.items()
    return {frozenset((base, -n) for base, n in monomial): 1 / c}


def _times(a: Terms, b: Terms) -> dict[Monomial, Fraction]:
    found: dict[Monomial, Fraction] = {}
    for x, c in a.items():
        for y, d in b.items():
            powers = dict(x)
            for base, n in y:
                powers[base] = powers.get(base, 0) + n
            key = frozenset((base, n) for base, n in powers.items() if n)
            found[key] = found.get(key, Fraction(0)) + c * d
    if len(found) > MOST_TERMS:
        raise Undecided(f"an exponent or angle of more than {MOST_TERMS} terms")
    return {m: c for m, c in found.items() if c}


def ordered(monomial: Monomial) -> list[tuple[Expr, int]]:
    """The factors in one order."""
    return sorted(monomial, key=lambda item: item[0].key)


def monomial_expr(monomial: Monomial) -> Expr:
    """The monomial written out."""
    factors = [base if n == 1 else power(base, n) for base, n in ordered(monomial)]
    return mul(*factors) if factors else number(1)


def terms_expr(terms: Terms) -> Expr:
    """The sum written out, in one order."""
    written = [
        monomial_expr(m) if c == 1 else number(c) * monomial_expr(m)
        for m, c in sorted(terms.items(), key=lambda item: monomial_expr(item[0]).key)
    ]
    return add(*written) if written else number(0)
