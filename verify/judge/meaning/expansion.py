"""Expressions multiplied out in some of their symbols: coefficients of a polynomial, sums of
products.
"""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    mul,
    neg,
    number,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided

MOST_DEGREE = 32
MOST_PRODUCTS = 2_000

Product = tuple[Expr, ...]
Polynomial = dict[int, Expr]


def coefficients(expr: Expr, name: str) -> Polynomial | None:
    """Power -> coefficient without the symbol; None if it is no polynomial in it as written."""
    done: dict[bytes, Polynomial | None] = {}
    for node in walk(expr):
        parts = [done[p.key] for p in node.parts]
        if node.kind == "symbol":
            done[node.key] = {1: number(1)} if node.name == name else {0: node}
        elif all(p is not None and set(p) <= {0} for p in parts):
            done[node.key] = {0: node}
        else:
            done[node.key] = _combined(node, [p for p in parts if p is not None], len(parts))
    return done[expr.key]


def _combined(node: Expr, parts: list[Polynomial], wanted: int) -> Polynomial | None:
    if len(parts) != wanted:
        return None
    match node.kind:
        case "add":
            total: Polynomial = {}
            for part in parts:
                total = _plus(total, part)
            return total
        case "mul":
            product = parts[0]
            for part in parts[1:]:
                product = _times(product, part)
            return product
        case "neg":
            return {k: neg(c) for k, c in parts[0].items()}
        case "div" if set(parts[1]) <= {0}:
            bottom = node.parts[1]
            return {k: div(c, bottom) for k, c in parts[0].items()}
        case "pow" if node.fraction == 0 and not is_total(node.parts[0]):
            return None  # the number 1 would hide where the base has no value
        case "pow" if node.fraction.denominator == 1 and 0 <= node.fraction <= MOST_DEGREE:
            product = {0: number(1)}
            for _ in range(int(node.fraction)):
                product = _times(product, parts[0])
            return product
        case _:
            return None


def _plus(a: Polynomial, b: Polynomial) -> Polynomial:
    return {k: a[k] + b[k] if k in a and k in b else a.get(k) or b[k] for k in {**a, **b}}


def _times(a: Polynomial, b: Polynomial) -> Polynomial:
    found: dict[int, list[Expr]] = {}
    for i, x in a.items():
        for j, y in b.items():
            found.setdefault(i + j, []).append(_product(x, y))
    if found and max(found) > MOST_DEGREE:
        raise Undecided(f"a polynomial of degree more than {MOST_DEGREE}")
    return {k: add(*terms) for k, terms in found.items()}


def _product(x: Expr, y: Expr) -> Expr:
    one = number(1)
    return y if x == one else x if y == one else mul(x, y)


def products(expr: Expr, names: Iterable[str]) -> list[Product]:
    """The expression as a sum of products, multiplied out where it holds one of the symbols.

    Factors that hold none of them stay as they are. Raises Undecided if there are too many.
    """
    wanted = set(names)

    def expanded(node: Expr) -> list[Product]:
        if not symbols_of(node) & wanted:
            return [(node,)]
        match node.kind:
            case "add":
                return _few([p for part in node.parts for p in expanded(part)])
            case "neg":
                return [(number(-1), *p) for p in expanded(node.parts[0])]
            case "mul":
                return _crossed([expanded(part) for part in node.parts])
            case "div" if not symbols_of(node.parts[1]) & wanted:
                below = div(number(1), node.parts[1])
                return [(*p, below) for p in expanded(node.parts[0])]
            case "pow" if node.fraction.denominator == 1 and 1 <= node.fraction <= MOST_DEGREE:
                return _crossed([expanded(node.parts[0])] * int(node.fraction))
            case _:
                return [(node,)]

    return expanded(expr)


def _crossed(lists: list[list[Product]]) -> list[Product]:
    found: list[Product] = [()]
    for each in lists:
        found = _few([(*a, *b) for a in found for b in each])
    return found


def _few(found: list[Product]) -> list[Product]:
    if len(found) > MOST_PRODUCTS:
        raise Undecided(f"a sum of more than {MOST_PRODUCTS} products")
    return found
