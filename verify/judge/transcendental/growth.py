"""Expressions that increase away from a point at which they are not negative."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.expression import Expr, neg, number, symbols_of
from gainproof.verify.judge.exact.rational_points import failure_at
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.witness import inside
from gainproof.verify.judge.transcendental.constant_folding import folded, plain
from gainproof.verify.judge.transcendental.smoothness import Proves, is_smooth

SEEN = (Fraction(1), Fraction(1, 3), Fraction(7))
"""Where a slope is looked at whether it is other than 0."""
ZERO = number(0)


@dataclass(frozen=True)
class Rising:
    """How a relation is proved: of what sign g is, its value at the point of a symbol, and what is
    known of slopes beside it, one for each side; `turned` with the reciprocal for the symbol;
    `within`: on a part of the domain only; `ratio`: the symbols of which this one is the quotient.
    """

    relation: Rel
    name: str
    point: Fraction
    value: Expr
    slopes: tuple[Rel, ...]
    turned: bool = False
    within: Box | None = None
    ratio: tuple[str, str] | None = None


@dataclass(frozen=True)
class From:
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
        beside = opened(side)
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


def opened(box: Box) -> Box:
    """Without its ends."""
    return replace(box, lower_open=True, upper_open=True)
