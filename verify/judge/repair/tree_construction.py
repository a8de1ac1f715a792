"""Printed trees put together the way they are printed: no sum inside a sum, no factor one, signs in
front. And their nodes by place, since an edit touches one occurrence of a node and not its twins.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gainproof.verify.judge.exact.expression import (
    Expr,
    Value,
    add,
    div,
    mul,
    neg,
    number,
    power,
)

Path = tuple[int, ...]
ONE, TWO = number(1), number(2)
HALF = Fraction(1, 2)


def opposite(x: Expr) -> Expr:
    """-x; twice is x again."""
    if x.kind == "neg":
        return x.parts[0]
    return number(-x.fraction) if x.kind == "number" and x.fraction < 0 else neg(x)


def total(*terms: Expr) -> Expr:
    """A flat sum without zeros."""
    flat = [t for term in terms for t in (term.parts if term.kind == "add" else (term,))]
    kept = [t for t in flat if not (t.kind == "number" and t.value == 0)]
    return add(*kept) if kept else number(0)


def product(*factors: Expr) -> Expr:
    """A flat product, numbers one left out, its sign in front."""
    flat: list[Expr] = []
    negative = False
    for factor in factors:
        if factor.kind == "neg":
            negative, factor = not negative, factor.parts[0]
        flat += factor.parts if factor.kind == "mul" else (factor,)
    kept = [f for f in flat if f != ONE]
    made = mul(*kept) if kept else ONE
    return opposite(made) if negative else made


def quotient(top: Expr, bottom: Expr) -> Expr:
    """A quotient; by one it is the numerator. A quotient is not put on a second bar."""
    if top.kind == "div":
        return quotient(top.parts[0], product(top.parts[1], bottom))
    if top.kind == "neg":
        return opposite(quotient(top.parts[0], bottom))
    return top if bottom == ONE else div(top, bottom)


def raised(base: Expr, exponent: Fraction) -> Expr:
    """A power; the first is the base."""
    if exponent == 0:
        return ONE
    return base if exponent == 1 else power(base, exponent)


def remade(kind: str, value: Value, parts: tuple[Expr, ...]) -> Expr:
    """A node of this kind over new parts."""
    match kind:
        case "add":
            return total(*parts)
        case "mul":
            return product(*parts)
        case "neg":
            return opposite(parts[0])
        case "div":
            return quotient(*parts)
        case _:
            return Expr(kind, value, parts)


def multiplied(node: Expr, factor: Expr) -> Expr:
    """The node times a factor, numbers multiplied out, equal bases once."""
    if "neg" in (factor.kind, node.kind):
        inner = multiplied(*(x.parts[0] if x.kind == "neg" else x for x in (node, factor)))
        return inner if factor.kind == node.kind else opposite(inner)
    above, below = factor.parts if factor.kind == "div" else (factor, ONE)
    top, bottom = node.parts if node.kind == "div" else (node, ONE)
    size = Fraction(1)
    powers: dict[Expr, Fraction] = {}
    for side, sign in ((product(above, top), 1), (product(below, bottom), -1)):
        for factor in side.parts if side.kind == "mul" else (side,):
            if factor.kind == "number" and factor.fraction:
                size *= factor.fraction**sign
                continue
            whole = factor.kind == "pow" and factor.fraction.denominator == 1
            base, exponent = (factor.parts[0], factor.fraction) if whole else (factor, Fraction(1))
            powers[base] = powers.get(base, Fraction(0)) + sign * exponent
    tops = [raised(base, e) for base, e in powers.items() if e > 0]
    bottoms = [raised(base, -e) for base, e in powers.items() if e < 0]
    return quotient(
        product(number(size.numerator), *tops), product(number(size.denominator), *bottoms)
    )


def is_of_one_number(node: Expr) -> bool:
    """Whether it is a function's value, as e^{-x} or sin x."""
    return node.kind == "call" and len(node.parts) == 1


def places(expr: Expr) -> Iterator[tuple[Path, Expr]]:
    """Every occurrence of a node, wholes before parts."""
    stack: list[tuple[Path, Expr]] = [((), expr)]
    while stack:
        path, node = stack.pop()
        yield path, node
        stack.extend(((*path, k), part) for k, part in enumerate(node.parts))


def replaced(expr: Expr, path: Path, new: Expr) -> Expr:
    """The tree with the node at one place replaced."""
    if not path:
        return new
    k, rest = path[0], path[1:]
    inner = replaced(expr.parts[k], rest, new)
    return remade(expr.kind, expr.value, (*expr.parts[:k], inner, *expr.parts[k + 1 :]))


def without(parts: tuple[Expr, ...], k: int) -> tuple[Expr, ...]:
    """All parts but one."""
    return (*parts[:k], *parts[k + 1 :])


def exchanged(parts: tuple[Expr, ...], k: int, new: Expr) -> tuple[Expr, ...]:
    """The parts with one of them exchanged."""
    return (*parts[:k], new, *parts[k + 1 :])
