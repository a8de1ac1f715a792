"""Polynomials without zero on a domain, shown by cells or by cutting the box into smaller boxes.

Where a polynomial is not zero on a closed bounded box, small enough boxes show it: this ends, but
for zeros on the faces of an open box, which only exhaust the number of boxes. In unbounded boxes
it need not end; there the polynomial may have no root over any point of a single cell.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.cells.coefficient_signs import keeps_sign
from gainproof.verify.judge.cells.lifting import cells
from gainproof.verify.judge.cells.parameter_polynomials import value_at
from gainproof.verify.judge.cells.projection import projected
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.polynomial import Poly
from gainproof.verify.judge.exact.work_limits import Limits, Undecided

MOST_BOXES = 300
ONE_CELL = Limits(cells=1, projection_factors=60)


def nowhere_zero(p: Poly, outside: Sequence[tuple[Poly, int]], boxes: Sequence[Box]) -> bool:
    """Whether p is shown to have no zero in the box; parts of it in which a polynomial of `outside`
    has its sign throughout do not count.
    """
    if _without_root(p, boxes):
        return True
    waiting = [tuple(boxes)]
    for _ in range(MOST_BOXES):
        if not waiting:
            return True
        box = waiting.pop()
        if keeps_sign(p, box, closed=True):
            continue
        if any(keeps_sign(q, box, closed=True) and _sign(q, box) == s for q, s in outside):
            continue
        waiting += _halves(box)
    return not waiting


def _without_root(p: Poly, boxes: Sequence[Box]) -> bool:
    """Whether projection leaves the open box in one cell: then no root lies over any of its points.

    Only for open boxes: nothing is said about closed faces.
    """
    closed = [
        b
        for b in boxes
        if (b.lower is not None and not b.lower_open) or (b.upper is not None and not b.upper_open)
    ]
    if closed:
        return False
    try:
        levels = projected([p], boxes, ONE_CELL).levels
        return len(cells(levels, boxes, ONE_CELL)) == 1
    except Undecided:
        return False


def _sign(p: Poly, boxes: Sequence[Box]) -> int:
    value = value_at(p, [_middle(box) for box in boxes])
    return (value > 0) - (value < 0)


def _middle(box: Box) -> Fraction:
    if box.lower is None and box.upper is None:
        return Fraction(0)
    if box.lower is None:
        return (box.upper or Fraction(0)) - 1
    return box.lower + 1 if box.upper is None else (box.lower + box.upper) / 2


def _halves(boxes: tuple[Box, ...]) -> list[tuple[Box, ...]]:
    """Two boxes, cut across the widest side; both hold the cut."""
    index = max(range(len(boxes)), key=lambda i: _width(boxes[i]))
    box, cut = boxes[index], _middle(boxes[index])
    low = replace(box, upper=cut, upper_open=False)
    high = replace(box, lower=cut, lower_open=False)
    return [(*boxes[:index], half, *boxes[index + 1 :]) for half in (low, high)]


def _width(box: Box) -> Fraction:
    if box.lower is not None and box.upper is not None:
        return box.upper - box.lower
    if box.lower is None and box.upper is None:
        return Fraction(10**9)
    # the farther out the half-line begins the less it needs a cut
    return 2 / (1 + abs(box.lower if box.lower is not None else box.upper or Fraction(0)))
