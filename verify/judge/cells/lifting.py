"""Open cells with a simple rational point in each, and the intervals that isolate it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from gainproof.verify.judge.cells.ground import put_in
from gainproof.verify.judge.cells.projection import Level
from gainproof.verify.judge.exact.algebraic import (
    Algebraic,
    apart,
    compare,
    rational_point,
    rationals_between,
    real_roots,
)
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.limits import Limits, Undecided
from gainproof.verify.judge.exact.poly import Poly, univariate

SAMPLES = 3


@dataclass(frozen=True)
class Between:
    """One coordinate of a cell above the point chosen before: the numbers beside it, its value."""

    index: int
    left: Algebraic | None
    right: Algebraic | None
    values: tuple[Fraction, ...]


@dataclass(frozen=True)
class Cell:
    """An open cell: one interval for each variable, in the order of the levels."""

    sides: tuple[Between, ...]

    at = None
    is_cell = True

    @property
    def samples(self) -> tuple[tuple[Fraction, ...], ...]:
        """Points of the cell in the order of the variables; they differ in the last coordinate."""
        chosen = {side.index: side.values[0] for side in self.sides}
        last = self.sides[-1]
        points = ({**chosen, last.index: value} for value in last.values)
        return tuple(tuple(point[i] for i in range(len(chosen))) for point in points)


def cells(levels: Sequence[Level], boxes: Sequence[Box], limits: Limits) -> list[Cell]:
    """All open cells of the box. Raises Undecided if there are too many."""
    found: list[Cell] = []
    for cell in _above((), [list(level.polys) for level in levels], levels, boxes):
        found.append(cell)
        if len(found) > limits.cells:
            raise Undecided(f"more than {limits.cells} cells")
    return found


def _above(
    sides: tuple[Between, ...],
    polys: list[list[Poly]],
    levels: Sequence[Level],
    boxes: Sequence[Box],
) -> Iterator[Cell]:
    """The cells above a point; `polys` are those of all levels with the point put in."""
    k = len(sides)
    if k == len(levels):
        yield Cell(sides)
        return
    index = levels[k].index
    last = k + 1 == len(levels)
    for left, right in pairwise(_walls(polys[k], index, boxes[index])):
        values = rationals_between(
            None if left is None else left.high,
            None if right is None else right.low,
            SAMPLES if last else 1,
        )
        side = Between(index, left, right, tuple(values))
        higher = polys
        if not last:
            higher = [
                *polys[: k + 1],
                *[[_with(p, index, values[0]) for p in level] for level in polys[k + 1 :]],
            ]
        yield from _above((*sides, side), higher, levels, boxes)


def _with(p: Poly, index: int, value: Fraction) -> Poly:
    return put_in(p, p.context().names()[index], value)


def _walls(polys: Sequence[Poly], index: int, box: Box) -> list[Algebraic | None]:
    """The faces of the box and the roots between them, in order, in intervals that do not touch."""
    lower = None if box.lower is None else rational_point(box.lower)
    upper = None if box.upper is None else rational_point(box.upper)
    roots: dict[tuple[int, ...], Any] = {}
    for p in polys:
        for factor, _ in univariate(p, index).factor()[1]:
            roots.setdefault(tuple(int(c) for c in factor.coeffs()), factor)
    inside = [
        root
        for factor in roots.values()
        if _may_have_roots(factor)
        for root in real_roots(factor)
        if (box.lower is None or compare(root, box.lower) > 0)
        and (box.upper is None or compare(root, box.upper) < 0)
    ]
    faces = [face for face in (lower, upper) if face is not None]
    ordered = [n for n in apart([*inside, *faces]) if n not in faces]
    return [lower, *ordered, upper]


def _may_have_roots(factor: Any) -> bool:
    if factor.degree() != 2:
        return True
    c, b, a = (int(n) for n in factor.coeffs())
    return b * b >= 4 * a * c
