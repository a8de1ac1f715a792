"""Expressions with their numbers put together, and as one fraction."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    mul,
    neg,
    number,
    symbols_of,
    whole_power,
)
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.monomials import monomials, terms_expr
from gainproof.verify.judge.transcendental.pi import exact_angles

AT_ZERO: Mapping[str, int] = MappingProxyType(
    {"exp": 1, "sin": 0, "cos": 1, "tan": 0, "atan": 0, "erf": 0}
)
MOST_POWER = 8
"""Of a sum that is written over its divisor's power."""


def folded(expr: Expr) -> Expr:
    """The same with every rational value of numbers written out, also of functions at 0, of the
    logarithm at 1 and of angles without a symbol. What has no value keeps none.
    """

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        made = Expr(node.kind, node.value, parts)
        if node.kind == "call":
            inner = constant_value(parts[0]) if len(parts) == 1 else None
            if inner == 0 and node.name in AT_ZERO:
                return number(AT_ZERO[node.name])
            if inner == 1 and node.name == "log":
                return number(0)
            exact = made if symbols_of(made) else exact_angles(made)
            return exact if exact == made else folded(exact)
        value = constant_value(made) if parts else None
        return made if value is None else number(value)

    return rebuilt(expr, change)


def plain(expr: Expr) -> Expr:
    """A sum of monomials of the same value wherever that of the expression exists, in functions and
    roots too.
    """

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        is_root = node.kind == "pow" and node.fraction.denominator != 1
        if not is_root and node.kind != "call":
            return None
        return Expr(node.kind, node.value, tuple(map(_sum_of_monomials, parts)))

    return _sum_of_monomials(rebuilt(folded(expr), change))


def _sum_of_monomials(expr: Expr) -> Expr:
    try:
        return folded(terms_expr(monomials(expr)))
    except Undecided:
        return expr


def without_common(expr: Expr, is_positive: Callable[[Expr], bool]) -> Expr:
    """A sum of monomials without the factors that all of them share and that are positive."""
    try:
        terms = monomials(expr)
    except Undecided:
        return expr
    powers = [dict(monomial) for monomial in terms]
    shared = {
        base: least
        for base in (powers[0] if powers else {})
        if (least := min(p.get(base, 0) for p in powers)) and is_positive(base)
    }
    rest = {}
    for given, c in zip(powers, terms.values(), strict=True):
        left = {base: given.get(base, 0) - shared.get(base, 0) for base in {*given, *shared}}
        rest[frozenset((base, n) for base, n in left.items() if n)] = c
    return folded(terms_expr(rest))


def fraction(expr: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator, the product of all divisors outside of functions and roots."""
    match expr.kind:
        case "neg":
            top, bottom = fraction(expr.parts[0])
            return neg(top), bottom
        case "mul":
            parts = [fraction(part) for part in expr.parts]
            return mul(*[top for top, _ in parts]), mul(*[bottom for _, bottom in parts])
        case "div":
            (top, below), (bottom, above) = map(fraction, expr.parts)
            return mul(top, above), mul(below, bottom)
        case "add":
            parts = [fraction(part) for part in expr.parts]
            shared = {bottom.key: bottom for _, bottom in parts}
            terms = [
                mul(top, *[other for key, other in shared.items() if key != bottom.key])
                for top, bottom in parts
            ]
            return add(*terms), mul(*shared.values())
        case "pow" if expr.fraction.denominator == 1 and abs(expr.fraction) <= MOST_POWER:
            top, bottom = fraction(expr.parts[0])
            times = int(abs(expr.fraction))
            first, second = (top, bottom) if expr.fraction >= 0 else (bottom, top)
            return whole_power(first, times), whole_power(second, times)
    return expr, number(1)
