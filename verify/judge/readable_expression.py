"""Expressions as people write them: without factors one and terms zero, numbers put together.

For people only: a factor zero hides whether the rest has a value, so nothing is decided on this.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number


def readable(expr: Expr) -> Expr:
    """The expression as one would write it; equal wherever it has a value. Sums and products keep
    their parts together: each may be a quantity with a name.
    """
    return rebuilt(expr, _change)


def _change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
    match node.kind:
        case "add":
            return _sum(parts)
        case "mul":
            return _product(parts)
        case "neg":
            return number(-parts[0].fraction) if _is_number(parts[0]) else _opposite(parts[0])
        case "div" if _is(parts[1], 1) or _is(parts[0], 0):
            return parts[0]
        case "pow" if node.fraction == 1:
            return parts[0]
        case _:
            return None


def _sum(parts: tuple[Expr, ...]) -> Expr:
    known = sum((part.fraction for part in parts if _is_number(part)), Fraction(0))
    rest = [part for part in parts if not _is_number(part)]
    if known == 0 and rest:
        return add(*rest)
    # a number stays at the end at which it was printed
    return add(number(known), *rest) if _is_number(parts[0]) else add(*rest, number(known))


def _product(parts: tuple[Expr, ...]) -> Expr:
    known = Fraction(1)
    for part in parts:
        if _is_number(part):
            known *= part.fraction
    rest = [part for part in parts if not _is_number(part)]
    if known == 0 or not rest:
        return number(known)
    if known == 1:
        return mul(*rest)
    return neg(mul(*rest)) if known == -1 else mul(number(known), *rest)


def _opposite(part: Expr) -> Expr | None:
    return part.parts[0] if part.kind == "neg" else None


def _is_number(expr: Expr) -> bool:
    return expr.kind == "number"


def _is(expr: Expr, value: int) -> bool:
    return _is_number(expr) and expr.fraction == value
