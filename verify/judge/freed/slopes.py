"""Inequalities with functions of one variable, by the slope: what is not below 0 at a point and
rises away from it stays above 0.

For g > 0 on an interval and a point c of it or one of its ends: g is continuous up to c and has a
derivative beside it, g(c) >= 0, and beyond c the slope away from c is above 0; by the mean value
theorem g(x) > g(c). Where c belongs to the interval, g(c) > 0 is shown, and a slope of 0 will do.
The slope is an inequality of the same form, which may take the same way again. Divisors of one sign
are multiplied out first.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, div, neg, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.points import failure_at
from gainproof.verify.judge.exact.statement import ORDERS, Rel, Statement
from gainproof.verify.judge.exact.witness import inside
from gainproof.verify.judge.freed.folding import folded, fraction, plain, without_common
from gainproof.verify.judge.freed.smooth import Boxes, Proves, is_smooth

MOST_NODES = 80
"""Of g: slopes grow, and each is asked for several times."""
INNER = (Fraction(0), Fraction(1), Fraction(-1))
"""Points within an interval that are tried; its finite ends come first."""
SEEN = (Fraction(1), Fraction(1, 3), Fraction(7))
"""Where a slope is looked at whether it is other than 0."""
ZERO = number(0)
POSITIVE = Box(lower=Fraction(0))
"""Of such a symbol the reciprocal lies there too: what vanishes far out vanishes at 0 then."""


@dataclass(frozen=True)
class Rising:
    """How a relation is proved: of what sign g is, its value at the point of a symbol, and what is
    known of slopes beside it, one for each side; `turned` with the reciprocal for the symbol.
    """

    relation: Rel
    name: str
    point: Fraction
    value: Expr
    slopes: tuple[Rel, ...]
    turned: bool = False


def by_slopes(statement: Statement, boxes: Boxes, proves: Proves) -> list[Rising]:
    """How each relation is proved. Raises Undecided."""
    if statement.connective != "if" or statement.domain:
        raise Undecided("a slope under conditions")
    where = {n: replace(boxes.get(n, Box()), stated=True) for n in statement.symbols()}
    if not all(is_smooth(each, where, where, proves) for each in statement.needed):
        raise Undecided("what must have a value may have none")
    return [_one(rel, where, proves) for rel in statement.relations]


def _one(rel: Rel, boxes: Boxes, proves: Proves) -> Rising:
    if rel.operator not in ORDERS:
        raise Undecided("a slope for anything but inequalities")
    g = rel.left - rel.right if rel.operator in (">", ">=") else rel.right - rel.left
    for name in _variables(g):
        within = {**boxes, name: replace(boxes[name], integer=False)}
        top = _multiplied_out(g, name, within, proves)
        if sum(1 for _ in walk(top)) > MOST_NODES:
            raise Undecided("a formula too large for slopes")
        strict = rel.operator in ("<", ">")
        for point in points(within[name]):
            found = _From(top, name, point, within, strict, proves).rising()
            if found is not None:
                return found
        if within[name] == POSITIVE:
            turned = substituted(top, {name: div(number(1), symbol(name))})
            top = _multiplied_out(turned, name, within, proves)
            found = _From(top, name, Fraction(0), within, strict, proves).rising()
            if found is not None:
                return replace(found, turned=True)
    raise Undecided("no point was found from which slopes show it, which refutes nothing")


def _multiplied_out(g: Expr, name: str, boxes: Boxes, proves: Proves) -> Expr:
    """Something of the sign of g, which has a value throughout. Raises Undecided."""
    inner = {**boxes, name: _open(boxes[name])}
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


@dataclass(frozen=True)
class _From:
    """The question whether g is above 0, or not below it, seen from a point."""

    g: Expr
    name: str
    point: Fraction
    boxes: Boxes
    strict: bool
    proves: Proves

    def rising(self) -> Rising | None:
        """How it is proved; None if it is not."""
        box = self.boxes[self.name]
        own = box.holds(self.point)
        others = {n: b for n, b in self.boxes.items() if n != self.name}
        value = folded(substituted(self.g, {self.name: number(self.point)}))
        if not self.proves(Rel(">" if self.strict and own else ">=", value, ZERO), others):
            return None
        slope = plain(differentiated(self.g, self.name))
        known = []
        for up, side in sides(box, self.point):
            found = self._rises(slope if up else plain(neg(slope)), side, self.strict and not own)
            if found is None:
                return None
            known.append(found)
        relation = Rel(">" if self.strict else ">=", self.g, ZERO)
        return Rising(relation, self.name, self.point, value, tuple(known))

    def _rises(self, slope: Expr, side: Box, strict: bool) -> Rel | None:
        """What is proved of the slope on one side, its far end included if it belongs to the
        domain.
        """
        beside = _open(side)
        boxes = {**self.boxes, self.name: beside}
        if side.lower == self.point:
            side = replace(side, lower_open=False)
        else:
            side = replace(side, upper_open=False)
        closed = {**self.boxes, self.name: side}
        if not is_smooth(self.g, boxes, closed, self.proves):
            return None
        above, not_below = (Rel(operator, slope, ZERO) for operator in (">", ">="))
        if strict and self.proves(above, boxes):
            return above
        # all parts are analytic there: a slope that is not 0 throughout is 0 at single points only
        will_do = not strict or (symbols_of(self.g) == {self.name} and self._is_seen(slope, beside))
        return not_below if will_do and self.proves(not_below, boxes) else None

    def _is_seen(self, slope: Expr, beside: Box) -> bool:
        """Whether the slope is other than 0 at some point."""
        tried = [point for wanted in SEEN if (point := inside(beside, wanted)) is not None]
        vanishes = Statement((Rel("=", slope, ZERO),))
        return any(failure_at(vanishes, {self.name: point}, {}) is not None for point in tried)


def sides(box: Box, point: Fraction) -> Iterator[tuple[bool, Box]]:
    """Whether it lies above the point, and what lies there, the point left out."""
    if box.upper is None or box.upper > point:
        yield True, replace(box, lower=point, lower_open=True)
    if box.lower is None or box.lower < point:
        yield False, replace(box, upper=point, upper_open=True)


def _open(box: Box) -> Box:
    return replace(box, lower_open=True, upper_open=True)
