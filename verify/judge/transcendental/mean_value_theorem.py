"""Inequalities with functions of one variable, by the slope: what is not below 0 at a point and
rises away from it stays above 0.

For g > 0 on an interval and a point c of it or one of its ends: g is continuous up to c and has a
derivative beside it, g(c) >= 0, and beyond c the slope away from c is above 0; by the mean value
theorem g(x) > g(c). Where c belongs to the interval, g(c) > 0 is shown, and a slope of 0 will do.
The slope is an inequality of the same form, which may take the same way again. Divisors of one sign
are multiplied out first. What has the slope 0 throughout and is 0 at a point is 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    div,
    mul,
    neg,
    number,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.statement import ORDERS, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.constant_folding import (
    folded,
    fraction,
    plain,
    without_common,
)
from gainproof.verify.judge.transcendental.growth import ZERO, From, Rising, opened, sides
from gainproof.verify.judge.transcendental.interval_parts import INNER, Part, in_parts
from gainproof.verify.judge.transcendental.positive_by_balls import Pieces
from gainproof.verify.judge.transcendental.smoothness import Proves, is_smooth

MOST_NODES = 80
"""Of g: slopes grow, and each is asked for several times."""
POSITIVE = Box(lower=Fraction(0))
"""Of such a symbol the reciprocal lies there too: what vanishes far out vanishes at 0 then."""


def by_slopes(statement: Statement, boxes: Boxes, proves: Proves) -> list[Part]:
    """How each relation is proved, in parts. Raises Undecided."""
    if statement.connective != "if":
        raise Undecided("a slope for anything but inequalities under conditions")
    whole = {n: replace(boxes.get(n, Box()), stated=True) for n in statement.symbols()}
    found: list[Part] = []
    for where in _without_points(whole, statement.domain):
        if not all(is_smooth(each, where, where, proves) for each in statement.needed):
            raise Undecided("what must have a value may have none")
        for rel in statement.relations:
            parts = _one(rel, where, proves)
            apart = {n: where[n] for n in {part.name for part in parts} if where != whole}
            found += [_told_within(part, apart.get(part.name)) for part in parts]
    return found


def _without_points(boxes: Boxes, conditions: Sequence[Rel]) -> list[Boxes]:
    """The parts of a domain from which numbers are taken out. Raises Undecided for what else is
    asked.
    """
    found: list[Boxes] = [boxes]
    for rel in conditions:
        value = constant_value(rel.right)
        if rel.operator != "!=" or rel.left.kind != "symbol" or value is None:
            raise Undecided("a slope under conditions")
        found = [part for each in found for part in _without(each, rel.left.name, value)]
    return found


def _without(boxes: Boxes, name: str, value: Fraction) -> Iterator[Boxes]:
    box = boxes[name]
    if not replace(box, integer=False).holds(value):
        yield boxes
        return
    for _, side in sides(box, value):
        yield {**boxes, name: side}


def _told_within(part: Part, box: Box | None) -> Part:
    """With the part of the domain, where it is one."""
    if box is None or isinstance(part, Pieces) or part.within is not None:
        return part
    return replace(part, within=box)


def above_zero(rel: Rel) -> Expr:
    """What an inequality says is above 0, or not below it."""
    return rel.left - rel.right if rel.operator in (">", ">=") else rel.right - rel.left


def _one(rel: Rel, boxes: Boxes, proves: Proves) -> tuple[Part, ...]:
    if rel.operator == "=":
        return (_level(rel, boxes, proves),)
    if rel.operator == "!=":
        return _on_one_side(rel, boxes, proves)
    if rel.operator not in ORDERS:
        raise Undecided("a slope for anything but equations and inequalities")
    g = above_zero(rel)
    for name in _variables(g):
        within = {**boxes, name: replace(boxes[name], integer=False)}
        top = _multiplied_out(g, name, within, proves)
        if sum(1 for _ in walk(top)) > MOST_NODES:
            raise Undecided("a formula too large for slopes")
        strict = rel.operator in ("<", ">")
        for point in points(within[name]):
            found = From(top, name, point, within, strict, proves).rising()
            if found is not None:
                return (found,)
        parts = in_parts(top, name, within, strict, proves)
        if parts is not None:
            return parts
        for other in _positive_beside(g, name, within):
            found = _over(top, name, other, within, strict, proves)
            if found is not None:
                return (found,)
        if within[name] == POSITIVE:
            turned = substituted(top, {name: div(number(1), symbol(name))})
            top = _multiplied_out(turned, name, within, proves)
            found = From(top, name, Fraction(0), within, strict, proves).rising()
            if found is not None:
                return (replace(found, turned=True),)
    raise Undecided("no point was found from which slopes show it, which refutes nothing")


def _on_one_side(rel: Rel, boxes: Boxes, proves: Proves) -> tuple[Part, ...]:
    """Of unlike sides one is the greater throughout. Raises Undecided."""
    with suppress(Undecided):
        return _one(replace(rel, operator=">"), boxes, proves)
    return _one(replace(rel, operator="<"), boxes, proves)


def _positive_beside(g: Expr, name: str, boxes: Boxes) -> list[str]:
    """Other symbols that are any number above 0, as this one is."""
    others = sorted(symbols_of(g) - {name})
    return [n for n in others if boxes[n] == boxes[name] == POSITIVE]


def _over(
    g: Expr, name: str, other: str, boxes: Boxes, strict: bool, proves: Proves
) -> Rising | None:
    """From the point where both symbols are equal, seen by their ratio; None if it is not shown."""
    ratio = f"{name} over {other}"
    put_in = substituted(g, {name: mul(symbol(other), symbol(ratio))})
    within = {**{n: b for n, b in boxes.items() if n != name}, ratio: POSITIVE}
    try:
        top = _multiplied_out(put_in, ratio, within, proves)
    except Undecided:
        return None
    found = From(top, ratio, Fraction(1), within, strict, proves).rising()
    return None if found is None else replace(found, ratio=(name, other))


def _level(rel: Rel, boxes: Boxes, proves: Proves) -> Rising:
    """An equation between sides of one slope that are equal at a point. Raises Undecided."""
    printed = rel.left - rel.right
    g = plain(printed)
    for name in _variables(g):
        box = replace(boxes[name], integer=False)
        within, inner = {**boxes, name: box}, {**boxes, name: opened(box)}
        slope = plain(differentiated(g, name))
        level = Rel("=", slope, ZERO)
        # what cancels in g must have a value all the same
        if not is_smooth(printed, inner, within, proves) or not proves(level, inner):
            continue
        others = {n: b for n, b in boxes.items() if n != name}
        for point in filter(box.holds, points(box)):
            value = folded(substituted(g, {name: number(point)}))
            if proves(Rel("=", value, ZERO), others):
                return Rising(Rel("=", g, ZERO), name, point, value, (level,))
    raise Undecided("no symbol was found by which both sides have one slope")


def _multiplied_out(g: Expr, name: str, boxes: Boxes, proves: Proves) -> Expr:
    """Something of the sign of g, which has a value throughout. Raises Undecided."""
    inner = {**boxes, name: opened(boxes[name])}
    if not is_smooth(g, inner, boxes, proves):
        raise Undecided("a formula that may have no slope somewhere")
    top, bottom = fraction(g)
    if constant_value(bottom) is not None:
        top = g
    elif proves(Rel("<", bottom, ZERO), boxes):
        top = neg(top)
    elif not proves(Rel(">", bottom, ZERO), boxes):
        top = g
    return without_common(plain(top), lambda factor: proves(Rel(">", factor, ZERO), boxes))


def _variables(g: Expr) -> list[str]:
    """Symbols that occur in a function."""
    return sorted(symbols_of(*[node for node in walk(g) if node.kind == "call"]))


def points(box: Box) -> Iterator[Fraction]:
    """Ends of the interval, then simple numbers between them."""
    if box.lower is not None and box.lower == box.upper:
        return
    ends = [end for end in (box.lower, box.upper) if end is not None]
    yield from ends
    yield from (point for point in INNER if point not in ends and box.holds(point))
