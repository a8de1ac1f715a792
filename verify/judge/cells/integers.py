"""Statements for integers that fail for real numbers: between integers, or at one of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import groupby, product
from math import ceil, floor, prod

from gainproof.verify.judge.cells.cell_statement import Task
from gainproof.verify.judge.cells.cells_and_borders import piece_of_cell
from gainproof.verify.judge.cells.critical_polynomials import CellQuestion
from gainproof.verify.judge.cells.lifting import Between, cells
from gainproof.verify.judge.cells.projection import projected
from gainproof.verify.judge.exact.algebraic_numbers import Algebraic, compare
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.truth import TRUE
from gainproof.verify.judge.exact.work_limits import Limits

MOST_NUMBERS = 64
"""Up to so many, or so many together of several symbols, are decided one by one."""


@dataclass(frozen=True)
class Runs:
    """Real intervals that hold all integers of a box but leave out where the statement fails
    between integers; or an integer for which it fails.
    """

    intervals: tuple[Box, ...] = ()
    failing: int | None = None


def runs_of(task: Task, name: str, boxes: Mapping[str, Box], limits: Limits) -> Runs:
    """Looks at all open cells over intervals of one variable. Raises Undecided."""
    question = CellQuestion(task, limits)
    sides = [task.boxes[n] for n in task.names]
    stated = frozenset(n for n, box in boxes.items() if box.stated)
    levels = projected(question.cuts(), sides, limits, task.names.index(name)).levels
    found = cells(levels, sides, limits)
    # from the left end to the first failing interval, between two, from the last to the right end
    edges: list[tuple[Algebraic | None, Algebraic | None]] = []
    start = found[0].sides[0].left
    for base, group in groupby(found, key=lambda cell: cell.sides[0]):
        pieces = [piece_of_cell(question, task, cell, stated) for cell in group]
        if any(p.counted and p.truth != TRUE for p in pieces):
            inside = _integers(base)
            if inside:
                return Runs(failing=inside[0])
            edges.append((start, base.left))
            start = base.right
    edges.append((start, found[-1].sides[0].right))
    made = (_closed(left, right, boxes[name]) for left, right in edges)
    return Runs(tuple(box for box in made if box is not None))


def whole_points(names: Sequence[str], boxes: Mapping[str, Box]) -> Iterator[dict[str, Box]]:
    """All whole numbers that several symbols may be together, as boxes of one point; none where
    there are more than MOST_NUMBERS.
    """
    extents = []
    for box in map(boxes.__getitem__, names):
        if box.lower is None or box.upper is None or box.upper - box.lower > MOST_NUMBERS:
            return
        inside = range(ceil(box.lower), floor(box.upper) + 1)
        extents.append([Fraction(n) for n in inside if box.holds(Fraction(n))])
    if prod(map(len, extents)) <= MOST_NUMBERS:
        for values in product(*extents):
            points = (Box(v, v, lower_open=False, upper_open=False) for v in values)
            yield dict(zip(names, points, strict=True))


def _integers(base: Between) -> list[int]:
    return Place(left=base.left, right=base.right, is_cell=True).integers(1)


def _closed(left: Algebraic | None, right: Algebraic | None, box: Box) -> Box | None:
    """The integers between two numbers, these included as far as the box holds them, as a closed
    real interval; None if there are none.
    """
    low = None if left is None else ceil(left.low)
    high = None if right is None else floor(right.high)
    while low is not None and (_compared(left, low) > 0 or _is_open_end(box.lower, low, box)):
        low += 1
    while high is not None and (_compared(right, high) < 0 or _is_open_end(box.upper, high, box)):
        high -= 1
    if low is not None and high is not None and low > high:
        return None
    return replace(
        box,
        lower=None if low is None else Fraction(low),
        upper=None if high is None else Fraction(high),
        lower_open=low is None,
        upper_open=high is None,
        integer=False,
    )


def _compared(number: Algebraic | None, value: int) -> int:
    """Sign of number - value; a missing number does not restrict."""
    return 0 if number is None else compare(number, Fraction(value))


def _is_open_end(face: Fraction | None, value: int, box: Box) -> bool:
    return face == value and not box.holds(Fraction(value))
