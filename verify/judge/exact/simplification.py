"""Rational expressions multiplied out and cancelled, to be read by people and to be shorter."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.exact.expression import (
    Expr,
    mul,
    number,
    symbol,
    symbols_of,
    walk,
    weighted,
    whole_power,
)
from gainproof.verify.judge.exact.polynomial import Poly, fraction, terms
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.work_limits import Undecided


def tidied(expr: Expr) -> Expr:
    """An expression equal to this one wherever this one has a value; roots are left as they are."""
    if any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(expr)):
        return expr
    names = tuple(sorted(symbols_of(expr)))
    try:
        tower = build_tower([expr], None, names, frozenset())
    except Undecided:
        return expr
    element = tower.element(expr)
    top, bottom = (expression_of(p, names) for p in (element.num, element.den))
    return top if element.den.is_one() else top / bottom


def expression_of(p: Poly, names: Sequence[str]) -> Expr:
    """A polynomial as an expression of these symbols, in the order of its variables."""
    coefficients, monomials = [], []
    for exponents, coefficient in terms(p):
        powers = [
            whole_power(symbol(n), int(e)) for n, e in zip(names, exponents, strict=False) if e
        ]
        coefficients.append(fraction(coefficient))
        monomials.append(mul(*powers) if powers else number(1))
    return weighted(coefficients, monomials)
