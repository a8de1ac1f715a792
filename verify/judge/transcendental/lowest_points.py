"""Simple points near the minimum of a formula in one symbol, at which a false inequality fails.

Nothing rests on the search: what it finds is looked at in balls by the caller.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr

PRECISION = 64
MANY = 160
"""Points of the first look."""
ROUNDS = 30
"""Thirds that are taken off from both sides of the lowest."""
PLACES = (2, 4, 7, 10)
"""Decimals of the points that are given, the simplest first."""


def lowest(g: Expr, name: str, box: Box) -> Iterator[Fraction]:
    """Points of the interval near where g is lowest among many, if it has an inner one."""
    points = sorted(set(filter(box.holds, _spread(box))))
    values = [_value(g, name, point) for point in points]
    inner = [
        place
        for place in range(1, len(points) - 1)
        if (value := values[place]) is not None
        and all(other is None or value <= other for other in (values[place - 1], values[place + 1]))
    ]
    if not inner:
        return
    place = min(inner, key=lambda each: values[each] or 0.0)
    at = _narrowed(g, name, points[place - 1], points[place + 1])
    for places in PLACES:
        rounded = Fraction(round(at * 10**places), 10**places)
        if box.holds(rounded):
            yield rounded


def _spread(box: Box) -> Iterator[Fraction]:
    """Evenly between two ends; from one end, or from 0, in steps that grow."""
    if box.lower is not None and box.upper is not None:
        width = box.upper - box.lower
        yield from (box.lower + width * Fraction(k, MANY) for k in range(MANY + 1))
        return
    start = box.lower if box.lower is not None else box.upper
    for k in range(-MANY // 2, MANY // 2 + 1):
        away = Fraction(round(10 ** (k / 20 + 6)), 10**6)
        yield from ((start or Fraction(0)) + sign * away for sign in (1, -1))


def _narrowed(g: Expr, name: str, low: Fraction, high: Fraction) -> Fraction:
    for _ in range(ROUNDS):
        first, second = low + (high - low) * Fraction(2, 5), low + (high - low) * Fraction(3, 5)
        one, other = _value(g, name, first), _value(g, name, second)
        if one is None or other is None:
            break
        low, high = (low, second) if one < other else (first, high)
        low, high = low.limit_denominator(10**15), high.limit_denominator(10**15)
    return (low + high) / 2


def _value(g: Expr, name: str, point: Fraction) -> float | None:
    try:
        ball = Balls({name: point}, PRECISION).round(g)
    except (NoValue, Unresolved):
        return None
    return float(ball.mid())
