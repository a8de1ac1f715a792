"""Points at which functions have exact values, where a side may have no value or both sides be one
number: ends of domains, multiples of pi/12, logarithms of the numbers of a statement, powers of e.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import partial
from itertools import islice, product
from math import inf, prod

from gainproof.verify.judge.exact.ball_text import value_shown
from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved, compared, enclosed
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    mul,
    neg,
    number,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.exact.polynomial import Ball, rational
from gainproof.verify.judge.exact.simple_points import simple_points
from gainproof.verify.judge.exact.statement import (
    NOT_EVALUATED,
    STRICT,
    Enclosure,
    Outcome,
    Rel,
    Statement,
    Witness,
    refuted,
)
from gainproof.verify.judge.exact.witness import inside
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.algebraic_form import bound_names
from gainproof.verify.judge.transcendental.constant_folding import folded
from gainproof.verify.judge.transcendental.free_values import freely
from gainproof.verify.judge.transcendental.function_variables import ANGLES
from gainproof.verify.judge.transcendental.missing_values import Lack, lacks
from gainproof.verify.judge.transcendental.monomials import UNIT, monomials
from gainproof.verify.judge.transcendental.pi import LABEL, PI, TURN
from gainproof.verify.judge.transcendental.symbols_over_pi import scaled
from gainproof.verify.judge.verdict_words import BOTH_EQUAL, LACKS_VALUE

TWELFTHS = (0, 6, -6, 12, -12, 3, -3, 9, -9, 4, -4, 8, -8, 2, -2, 10, -10, 1, -1, 18, -18, 24, -24)
"""Multiples of pi/12, those where functions of angles are 0 or have no value first."""
SIMPLE = tuple(map(Fraction, (0, 1, -1, 2, -2)))
PRECISION = 192
MOST_POINTS = 400
"""Of those of several symbols all are looked at; of more one symbol after the other is moved."""
MOST_NUMBERS = 12
MOST_BESIDE = 12
"""Simple values of the symbols that take no part."""

Point = Mapping[str, Expr]
Choice = tuple[Expr, Ball | None]
At = Callable[[Iterable[Choice]], Ball | None]


def lacking(statement: Statement, boxes: Boxes) -> Iterator[tuple[Rel, Lack]]:
    """The relations of a statement with what may leave them without a value where all symbols have
    stated domains, of which bounds with pi are conditions.
    """
    if statement.connective != "if" or bound_names(statement):
        return
    turned = scaled(statement, boxes, {})
    stated = {name for name, box in turned.boxes.items() if box.stated}
    stated |= {name for name in statement.symbols() if f"{name}/{LABEL}" in stated}
    seen: set[Expr] = set()
    for rel in statement.relations:
        for lack in (each for side in (rel.left, rel.right) for each in lacks(side)):
            names = symbols_of(lack.zero)
            if names and names <= stated and lack.zero not in seen:
                seen.add(lack.zero)
                yield rel, lack


def without_value(statement: Statement, boxes: Boxes, labels: Mapping[str, str]) -> Outcome | None:
    """`refuted` with a special point of the stated domains where a side has no value; None if none
    is found.
    """
    for rel, lack in lacking(statement, boxes):
        for point in _zeros(lack.zero, statement, boxes):
            left, right = (_told(side, point) for side in (rel.left, rel.right))
            if {left.undefined, right.undefined} <= {None, NOT_EVALUATED}:
                continue
            found = Witness(point_text(point, labels), rel.operator, left, right, note=LACKS_VALUE)
            return refuted(found, "no value at an exact point")
    return None


def equal_sides(statement: Statement, boxes: Boxes, labels: Mapping[str, str]) -> Outcome | None:
    """`refuted` with a special point of the domain where both sides of a strict relation, or of !=,
    are one number; None if none is found.
    """
    if statement.connective != "if":
        return None
    for rel in statement.relations:
        if rel.operator not in STRICT or symbols_of(rel.left, rel.right) & bound_names(statement):
            continue
        for point in _zeros(rel.left - rel.right, statement, boxes):
            left, right = (_told(side, point) for side in (rel.left, rel.right))
            needed = [_told(each, point) for each in statement.needed]
            if any(each.undefined for each in (left, right, *needed)):
                continue
            found = Witness(
                point_text(point, labels), rel.operator, left, left, exact=True, note=BOTH_EQUAL
            )
            return refuted(found, "both sides at an exact point")
    return None


def _zeros(expr: Expr, statement: Statement, boxes: Boxes) -> Iterator[Point]:
    """Special points of the domain at which an expression is 0, exactly."""
    own = sorted(symbols_of(expr))
    others = sorted(statement.symbols() - bound_names(statement) - {*own})
    numbers = _numbers(statement)
    choices = {
        n: _within(_candidates(n, statement, numbers, boxes), boxes.get(n, Box())) for n in own
    }
    if not all(choices.values()):
        return
    for values in _small(expr, own, list(choices.values())):
        here = dict(zip(own, values, strict=True))
        if not is_zero(substituted(expr, here)):
            continue
        for simple in islice(simple_points(others, boxes), MOST_BESIDE):
            point = {**here, **{name: number(value) for name, value in simple.items()}}
            if all(_is_certain(rel, point) for rel in statement.domain):
                yield point
                break


def _candidates(
    name: str, statement: Statement, numbers: Iterable[Fraction], boxes: Boxes
) -> Iterator[Expr]:
    """Values at which functions of a multiple of the symbol have simple values; ends of its domain;
    simple numbers.
    """
    box = boxes.get(name, Box())
    ends = [end for end in (box.lower, box.upper, inside(box, 1)) if end is not None]
    yield from (number(each) for each in (*ends, *SIMPLE, *numbers))
    for rel in statement.domain:
        sides = (rel.left, rel.right)
        if symbol(name) in sides and symbols_of(*sides) == {name}:
            yield from (side for side in sides if not symbols_of(side))
    for node in walk(*statement.exprs()):
        if node.kind != "call" or name not in symbols_of(node) or not node.parts:
            continue
        with suppress(Undecided):
            terms = monomials(node.parts[-1])
            factor = terms.get(frozenset([(symbol(name), 1)]))
            if factor is None:
                continue
            rest = {m: c for m, c in terms.items() if m in (UNIT, TURN)}
            shift = (
                add(*[mul(number(c), PI) if m == TURN else number(c) for m, c in rest.items()])
                if rest
                else None
            )
            for value in _arguments(node, numbers):
                moved = value if shift is None else add(value, neg(shift))
                yield moved if factor == 1 else div(moved, number(factor))


def _arguments(node: Expr, numbers: Iterable[Fraction]) -> Iterator[Expr]:
    """Arguments at which a function has a simple value."""
    if node.name in ANGLES:
        yield from (mul(number(Fraction(each, 12)), PI) for each in TWELFTHS)
    elif node.name == "exp":
        yield from (Expr("call", "log", (number(each),)) for each in numbers if each > 0)
    elif node.name == "log":
        yield from (Expr("call", "exp", (number(each),)) for each in numbers)


def _numbers(statement: Statement) -> list[Fraction]:
    """Those of the statement, their opposites, and 0 and 1."""
    found = dict.fromkeys([Fraction(1), Fraction(0), Fraction(-1)])
    for node in walk(*statement.exprs()):
        if node.kind == "number" and len(found) < MOST_NUMBERS:
            found |= dict.fromkeys([node.fraction, -node.fraction])
    return list(found)


def _within(values: Iterable[Expr], box: Box) -> list[Expr]:
    """Those that are seen to lie in a domain, each once, numbers as numbers."""
    found: dict[Expr, None] = {}
    for each in values:
        value = folded(each)
        if value not in found and _is_within(value, box):
            found[value] = None
    return list(found)


def _is_within(value: Expr, box: Box) -> bool:
    if value.kind == "number":
        return box.holds(value.fraction)
    if box.integer or (ball := _ball(value)) is None:
        return False
    above = box.lower is None or ball > rational(box.lower)
    return bool(above and (box.upper is None or ball < rational(box.upper)))


def _ball(value: Expr) -> Ball | None:
    try:
        ball = enclosed(value, {}, PRECISION)
    except (NoValue, Unresolved):
        return None
    return ball if ball.is_finite() else None


def _small(expr: Expr, names: list[str], choices: list[list[Expr]]) -> Iterator[tuple[Expr, ...]]:
    """Values at which balls do not exclude that the expression is 0: of all, or where too many are
    to be tried of those that are reached by making it smaller in one symbol after the other.
    """
    balls = [[(value, _ball(value)) for value in each] for each in choices]

    def at(values: Iterable[Choice]) -> Ball | None:
        here = {n: ball for n, (_, ball) in zip(names, values, strict=True) if ball is not None}
        try:
            return Balls(here, PRECISION).round(expr)
        except (NoValue, Unresolved):
            return None

    if prod(map(len, balls)) <= MOST_POINTS:
        for values in product(*balls):
            ball = at(values)
            if ball is not None and ball.contains(0):
                yield tuple(value for value, _ in values)
        return
    for start in range(3):
        best = [each[start % len(each)] for each in balls]
        for _ in range(2):
            for k, each in enumerate(balls):
                best[k] = min(each, key=partial(_size_with, at, best, k))
        ball = at(best)
        if ball is not None and ball.contains(0):
            yield tuple(value for value, _ in best)


def _size_with(at: At, best: list[Choice], k: int, choice: Choice) -> float:
    ball = at([*best[:k], choice, *best[k + 1 :]])
    return inf if ball is None else abs(float(ball.mid()))


def is_zero(expr: Expr) -> bool:
    """Whether an expression of numbers only is shown to be 0 exactly."""
    value = folded(expr)
    if value.kind == "number":
        return value.fraction == 0
    ball = _ball(value)
    if ball is None or not ball.contains(0):
        return False
    with suppress(Undecided):
        found = freely(Statement((Rel("=", value, number(0)),)), {}, None, {})
        return found.verdict == "proved"
    return False


def _is_certain(rel: Rel, point: Point) -> bool:
    """Whether a condition is seen to hold at a point."""
    left, right = (substituted(side, point) for side in (rel.left, rel.right))
    a, b = _ball(left), _ball(right)
    if a is None or b is None:
        return False
    known = compared(rel.operator, a, b)
    if known is not None:
        return known
    return rel.operator in ("=", "<=", ">=") and is_zero(left - right)


def _told(side: Expr, point: Point) -> Enclosure:
    here = folded(substituted(side, point))  # what has no value keeps none
    for lack in lacks(here):
        if is_zero(lack.zero):
            return Enclosure("", "", lack.reason)
    return value_shown(here, Balls({}, PRECISION))


def point_text(point: Point, labels: Mapping[str, str]) -> dict[str, str]:
    """Multiples of pi as those of the symbol over pi."""
    found: dict[str, str] = {}
    for name, value in sorted(point.items()):
        label = labels.get(name, name)
        turns = None if value == number(0) else _turns(value)
        if turns is not None:
            found[f"{label}/{LABEL}"] = str(turns)
        else:
            found[label] = written(value)[1][0]
    return found


def _turns(value: Expr) -> Fraction | None:
    if PI not in walk(value):
        return None
    terms = monomials(value)
    return terms[TURN] if set(terms) == {TURN} else None
