"""A formula in one symbol seen to be above 0 on a bounded interval, by balls over pieces of it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import flint

from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.expression import Expr, symbols_of
from gainproof.verify.judge.exact.polynomial import rational
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.transcendental.constant_folding import plain

PRECISION = 64
MOST_PIECES = 1000
DEEPEST = 12
"""Halvings: beside a point where it is 0 no piece is small enough."""


@dataclass(frozen=True)
class Pieces:
    """On each of so many pieces of a closed interval a relation's balls are apart."""

    relation: Rel
    name: str
    lower: Fraction
    upper: Fraction
    count: int


def seen_above(g: Expr, name: str, lower: Fraction, upper: Fraction) -> int | None:
    """How many pieces show that g has a value and is above 0 throughout; None if they do not."""
    slope = plain(differentiated(g, name))
    todo, tried, count = [(lower, upper, 0)], 0, 0
    while todo:
        a, b, depth = todo.pop()
        tried += 1
        if _is_above(g, slope, name, a, b):
            count += 1
        elif tried > MOST_PIECES or depth == DEEPEST:
            return None
        else:
            middle = (a + b) / 2
            todo += [(middle, b, depth + 1), (a, middle, depth + 1)]
    return count


def by_pieces(rel: Rel, box: Box) -> Pieces | None:
    """An inequality in one symbol on a bounded interval, its ends included."""
    names = symbols_of(rel.left, rel.right)
    if len(names) != 1 or box.lower is None or box.upper is None or rel.operator in ("=", "!="):
        return None
    (name,) = names
    g = rel.left - rel.right if rel.operator in (">", ">=") else rel.right - rel.left
    count = seen_above(g, name, box.lower, box.upper)
    return None if count is None else Pieces(rel, name, box.lower, box.upper, count)


def _is_above(g: Expr, slope: Expr, name: str, lower: Fraction, upper: Fraction) -> bool:
    """By the balls of g; else by the mean value theorem, as what has balls is analytic."""
    middle = (lower + upper) / 2
    with flint.ctx.workprec(PRECISION):
        piece = flint.arb(rational(lower)).union(flint.arb(rational(upper)))
        away = piece - flint.arb(rational(middle))
        try:
            if Balls({name: piece}, PRECISION).round(g) > 0:
                return True
            rise = Balls({name: piece}, PRECISION).round(slope) * away
            return bool(Balls({name: middle}, PRECISION).round(g) + rise > 0)
        except (NoValue, Unresolved):
            return False
