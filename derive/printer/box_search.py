"""Boxes over several inputs, bisected best first: where the bound is largest, within a budget."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gainproof.derive.printer import boxes
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.step_ranges import Grid, Mask

TOLERANCE = 0.01  # a box is done when its bounds are this close to their least possible maximum
WORK = 240_000  # boxes of one kernel in one format, times the steps of its program
BATCH = 1_024  # boxes bisected at a time
ENOUGH = (
    256  # boxes made at a time, if there is room: NumPy takes hardly longer for these than for one
)


@dataclass(frozen=True)
class Waiting:
    """Boxes with their bounds (a row an output), and other quantities whose maximum is wanted."""

    grid: Grid
    upper: Array
    other: Array

    def part(self, chosen: Mask | NDArray[np.intp]) -> Waiting:
        """Some of the boxes, by mask or by number."""
        grid = Grid(*(each[:, chosen] for each in (self.grid.low, self.grid.high, self.grid.width)))
        return Waiting(grid, self.upper[:, chosen], self.other[:, chosen])


class Frontier:
    """The bounds settled so far: `settled` and `other`, the largest of boxes no longer bisected.

    Every box that is not bisected counts with its own bound, so that the result is a bound at any
    time; bisection only brings it down.
    """

    def __init__(
        self, outputs: int, others: int, form: Format, greatest: float, budget: int
    ) -> None:
        self.form, self.greatest, self.budget = form, greatest, budget
        self.settled, self.least, self.other = (
            np.zeros(outputs),
            np.zeros(outputs),
            np.zeros(others),
        )
        self.total = 0
        self.waiting: Waiting | None = None
        self.failed: Grid | None = None  # the first settled box with a bound above `greatest`

    def add(self, found: Waiting, lower: Array) -> None:
        """Takes boxes with their bounds; `lower` is what no bisection can get below."""
        self.total += found.grid.count
        self.least = np.maximum(self.least, lower.max(axis=1, initial=0.0))
        self.waiting = found if self.waiting is None else _joined(self.waiting, found)

    def finer(self) -> Grid | None:
        """The next boxes to be bounded, quarters of some or less; None when all are settled."""
        waiting = self.waiting
        assert waiting is not None
        with_room = (waiting.grid.low < waiting.grid.high).any(axis=0)
        # 0/0 of an exact output is NaN, which fmax leaves out
        excess = np.fmax.reduce(waiting.upper / (self.least[:, None] * (1.0 + TOLERANCE)))
        promising = (excess > 1.0) & with_room
        self._settle(waiting.part(~promising))
        waiting, excess = waiting.part(promising), excess[promising]
        count = min(BATCH, (self.budget - self.total) // 4, waiting.grid.count)
        if count <= 0:
            self._settle(waiting)
            return None
        order = np.argsort(-excess, kind="stable")
        self.waiting = waiting.part(order[count:])
        grid = waiting.part(order[:count]).grid
        finer = boxes.halves(boxes.halves(grid, self.form), self.form)
        while finer.count < ENOUGH and self.total + 2 * finer.count <= self.budget:
            finer = boxes.halves(finer, self.form)
        return finer

    def _settle(self, done: Waiting) -> None:
        beyond = np.flatnonzero((done.upper > self.greatest).any(axis=0))
        if len(beyond) and self.failed is None:
            self.failed = done.part(beyond[:1]).grid
        self.settled = np.maximum(self.settled, done.upper.max(axis=1, initial=0.0))
        self.other = np.maximum(self.other, done.other.max(axis=1, initial=0.0))


def _joined(first: Waiting, second: Waiting) -> Waiting:
    return Waiting(
        boxes.joined(first.grid, second.grid),
        np.concatenate([first.upper, second.upper], axis=1),
        np.concatenate([first.other, second.other], axis=1),
    )
