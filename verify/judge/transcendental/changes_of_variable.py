"""Inequalities in other variables: x = e^u for positive x, and x = t y where y takes no part.

With x = e^u what is least at x = e is least at u = 1. Where both sides of all relations in positive
x and y have a degree, f(t y, y) = y^d f(t, 1), they hold for all x and y if they do for y = 1.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import permutations

from gainproof.verify.judge.exact.balls import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbol, walk
from gainproof.verify.judge.exact.polynomial import rational
from gainproof.verify.judge.exact.statement import Rel, Statement

Proves = Callable[[Statement, Boxes], bool]

POSITIVE = Box(lower=Fraction(0))
MOST_DEGREE = 6
BITS = 64


def in_other_variables(
    statement: Statement, boxes: Boxes, proves: Proves
) -> Iterator[tuple[Statement, Boxes]]:
    """Statements that hold exactly where this one does, with their domains; none where conditions
    are left that are no bounds.
    """
    names = sorted(statement.symbols())
    if statement.connective != "if" or statement.domain or statement.needed:
        return
    if len(names) == 1:
        yield from _by_exponent(statement, names[0], boxes)
    elif len(names) == 2 and all(boxes.get(name) == POSITIVE for name in names):
        for x, y in permutations(names):
            if (made := _by_ratio(statement, x, y, proves)) is not None:
                yield made, {x: POSITIVE}


def _by_exponent(
    statement: Statement, name: str, boxes: Boxes
) -> Iterator[tuple[Statement, Boxes]]:
    """x = e^u, where x is positive and its domain ends at 0, 1 or nowhere, and has a logarithm."""
    logarithms = [n for n in walk(*statement.exprs()) if n.kind == "call" and n.name == "log"]
    box = boxes.get(name, Box(stated=False))
    if not logarithms or not box.is_positive or box.integer:
        return
    if box.lower not in (0, 1) or box.upper not in (None, 1):
        return
    exponent = f"ln {name}"
    made = Expr("call", "exp", (symbol(exponent),))
    lower, upper = (Fraction(0) if end == 1 else None for end in (box.lower, box.upper))
    over = Box(lower, upper, box.lower_open, box.upper_open)
    yield statement.mapped(lambda e: substituted(e, {name: made})), {exponent: over}


def _by_ratio(statement: Statement, x: str, y: str, proves: Proves) -> Statement | None:
    """The statement for y = 1, where all sides have a degree."""
    both = {x: POSITIVE, y: POSITIVE}
    at_one: list[Rel] = []
    for rel in statement.relations:
        sides = [substituted(side, {y: number(1)}) for side in (rel.left, rel.right)]
        degrees = [_degree(side, x, y) for side in (rel.left, rel.right)]
        known = {d for d in degrees if d is not None}
        if len(known) != 1:
            return None
        factor = power(symbol(y), known.pop())
        for side, one in zip((rel.left, rel.right), sides, strict=True):
            moved = substituted(side, {x: mul(symbol(x), symbol(y))})
            if not proves(Statement((Rel("=", moved, mul(factor, one)),)), both):
                return None
        at_one.append(Rel(rel.operator, *sides))
    return Statement(tuple(at_one))


def _degree(side: Expr, x: str, y: str) -> int | None:
    """The d of f(2 x, 2 y) = 2^d f(x, y), as it looks at one point; None where there is none."""
    try:
        one, two = (enclosed(side, {x: 3 * n, y: 5 * n}, BITS) for n in map(Fraction, (1, 2)))
    except (NoValue, Unresolved):
        return None
    if one.contains(0):
        return None
    degrees = range(-MOST_DEGREE, MOST_DEGREE + 1)
    return next((d for d in degrees if (two / one - rational(Fraction(2) ** d)).contains(0)), None)
