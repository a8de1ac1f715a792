"""Open cells with a simple rational point in each, and the intervals that isolate it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any

from gainproof.verify.judge.cells.parameter_polynomials import put_in
from gainproof.verify.judge.cells.projection import Level
from gainproof.verify.judge.exact.algebraic_numbers import (
    Algebraic,
    apart,
    compare,
    rational_point,
    rationals_between,
    real_roots,
)
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.polynomial import Poly, univariate
from gainproof.verify.judge.exact.work_limits import Limits, Undecided

SAMPLES = 3
MOVED = 4
"""Further points of a cell, apart from its samples in every coordinate."""


@dataclass(frozen=True)
class Between:
    """One coordinate of a cell above the point chosen before: the numbers beside it, its value.

    It is the interval number `rank` of so many `walls`.
    """

    index: int
    left: Algebraic | None
    right: Algebraic | None
    values: tuple[Fraction, ...]
    rank: int
    walls: int


@dataclass(frozen=True)
class Cell:
    """An open cell: one interval for each variable, in the order of the `levels`."""

    sides: tuple[Between, ...]
    levels: Sequence[Level] = field(default=(), compare=False, repr=False)
    boxes: Sequence[Box] = field(default=(), compare=False, repr=False)

    at = None
    is_cell = True

    @property
    def samples(self) -> tuple[tuple[Fraction, ...], ...]:
        """Points of the cell in the order of the variables; they differ in the last coordinate."""
        chosen = {side.index: side.values[0] for side in self.sides}
        last = self.sides[-1]
        points = ({**chosen, last.index: value} for value in last.values)
        return tuple(tuple(point[i] for i in range(len(chosen))) for point in points)

    @property
    def moved(self) -> tuple[tuple[Fraction, ...], ...]:
        """Points of the cell that differ from its samples in every coordinate: what vanishes where
        one of the first coordinates is 0, say, may vanish at all samples.
        """
        return self._apart

    @cached_property
    def _apart(self) -> tuple[tuple[Fraction, ...], ...]:
        found = (_moved(self, step) for step in range(1, MOVED + 1))
        return tuple(point for point in found if point is not None)


def _moved(cell: Cell, step: int) -> tuple[Fraction, ...] | None:
    """The point above other values: of the walls above these the same two are taken, since above
    one interval their number does not change; None if it does.
    """
    polys = [list(level.polys) for level in cell.levels]
    point: dict[int, Fraction] = {}
    for k, side in enumerate(cell.sides):
        walls = _walls(polys[k], side.index, cell.boxes[side.index])
        if len(walls) != side.walls:
            return None
        left, right = walls[side.rank], walls[side.rank + 1]
        value = _between(left, right, SAMPLES + step)[SAMPLES + step - 1]
        point[side.index] = value
        polys[k + 1 :] = [[_with(p, side.index, value) for p in level] for level in polys[k + 1 :]]
    return tuple(point[i] for i in range(len(point)))


def _between(left: Algebraic | None, right: Algebraic | None, count: int) -> tuple[Fraction, ...]:
    low = None if left is None else left.high
    high = None if right is None else right.low
    return tuple(rationals_between(low, high, count))


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
        yield Cell(sides, levels, boxes)
        return
    index = levels[k].index
    last = k + 1 == len(levels)
    walls = _walls(polys[k], index, boxes[index])
    for rank, (left, right) in enumerate(pairwise(walls)):
        values = _between(left, right, SAMPLES if last else 1)
        side = Between(index, left, right, values, rank, len(walls))
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
