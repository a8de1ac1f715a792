"""An interval in parts: slopes where it has no end and beside points where a formula is 0 or has
no value, balls over pieces between.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.witness import inside
from gainproof.verify.judge.transcendental.constant_folding import folded
from gainproof.verify.judge.transcendental.growth import ZERO, From, Rising, opened
from gainproof.verify.judge.transcendental.positive_by_balls import Pieces, seen_above
from gainproof.verify.judge.transcendental.smoothness import Proves

SHARES = (Fraction(1, 2), Fraction(1, 16), Fraction(1, 256))
"""Of the way from an end to the middle, on which slopes are asked for."""
FAR = (Fraction(2), Fraction(8), Fraction(64))
INNER = (Fraction(0), Fraction(1), Fraction(-1))
"""Simple points, which may part an interval; slopes begin there too."""

Part = Rising | Pieces
Edge = tuple[Fraction, Part | None]
"""Up to where a part reaches from an end, and how it is proved; None: it is the end itself."""


def in_parts(
    g: Expr, name: str, boxes: Boxes, strict: bool, proves: Proves
) -> tuple[Part, ...] | None:
    """How g > 0, or not below it, is proved part by part; None if it is not."""
    if symbols_of(g) != {name}:
        return None
    found: list[Part] = []
    for box in _between_zeros(g, name, boxes[name], strict, proves):
        part = _Whole(g, name, box, strict, proves).parts()
        if part is None:
            return None
        found += part
    return tuple(found)


def _between_zeros(g: Expr, name: str, box: Box, strict: bool, proves: Proves) -> Iterator[Box]:
    rest = box
    for point in sorted(INNER):
        if strict or not _is_within(rest, point):
            continue
        if proves(Rel("=", folded(substituted(g, {name: number(point)})), ZERO), {}):
            yield replace(rest, upper=point, upper_open=False)
            rest = replace(rest, lower=point, lower_open=False)
    yield rest


def _is_within(box: Box, point: Fraction) -> bool:
    return box.holds(point) and point not in (box.lower, box.upper)


class _Whole:
    """One interval from end to end."""

    def __init__(self, g: Expr, name: str, box: Box, strict: bool, proves: Proves) -> None:
        self.g, self.name, self.box, self.strict, self.proves = g, name, box, strict, proves

    def parts(self) -> list[Part] | None:
        """Two ends and what lies between; None if one of these is not shown."""
        middle = inside(opened(self.box), Fraction(1))
        if middle is None:
            return None
        below = self._up_to(middle, up=False)
        above = self._up_to(middle, up=True) if below else None
        if below is None or above is None:
            return None
        relation = Rel(">" if self.strict else ">=", self.g, ZERO)
        count = below[1] + above[1]
        between = Pieces(relation, self.name, below[0][0], above[0][0], count)
        ends = [end for end in (below[0][1], above[0][1]) if end is not None]
        return [*ends[:1], between, *ends[1:]] if below[0][1] else [between, *ends]

    def _up_to(self, middle: Fraction, *, up: bool) -> tuple[Edge, int] | None:
        """The first edge from which pieces reach to the middle, and how many."""
        for edge in self._edges(middle, up):
            ends = (middle, edge[0]) if up else (edge[0], middle)
            count = seen_above(self.g, self.name, *ends)
            if count is not None:
                return edge, count
        return None

    def _edges(self, middle: Fraction, up: bool) -> Iterator[Edge]:
        end = self.box.upper if up else self.box.lower
        if end is not None:
            yield end, None
        cuts = (
            [middle + (far if up else -far) for far in FAR]
            if end is None
            else [end + (middle - end) * share for share in SHARES]
        )
        for cut in cuts:
            side = (
                replace(self.box, lower=cut, lower_open=False)
                if up
                else replace(self.box, upper=cut, upper_open=False)
            )
            for point in [cut] if end is None else [end, cut]:
                boxes = {self.name: side}
                found = From(self.g, self.name, point, boxes, self.strict, self.proves).rising()
                if found is not None:
                    yield cut, replace(found, within=side)
                    break
