"""When boxes over one input are bisected and when their bounds are good enough."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.step_ranges import Grid, Mask

TOLERANCE = 0.01  # boxes are bisected until the bound is this close to its least possible value
GREATEST_COUNT = 40_000  # of boxes of one kernel in one format
ROUNDS = 40
ENOUGH = 256  # boxes of a round: NumPy takes hardly longer for these than for one


class Refinement:
    """The bounds settled so far: `settled`, one an output, from `total` boxes."""

    def __init__(self, count: int, form: Format) -> None:
        self.form = form
        self.settled, self.least = np.zeros(count), np.zeros(count)
        self.before = np.full(count, np.inf)
        self.total, self.rounds = 0, 0

    def step(self, grid: Grid, upper: Array, lower: Array) -> Mask:
        """Settles the bounds of some boxes, and says which others are to be bisected.

        A box is bisected while its bound may still come down: above the least possible maximum by
        more than the tolerance, and not when the last bisection of all such boxes changed nothing.
        """
        self.total += grid.count
        self.rounds += 1
        self.least = np.maximum(self.least, lower.max(axis=1, initial=0.0))
        largest = upper.max(axis=1, initial=0.0)
        stuck = (largest > self.before * (1.0 - TOLERANCE / 4))[:, None] & np.isfinite(upper)
        self.before = largest
        # outside an output's domain its bound is 0: nothing promising
        promising = (upper > self.least[:, None] * (1.0 + TOLERANCE)) & ~stuck
        again: Mask = promising.any(axis=0) & (grid.low < grid.high).any(axis=0)
        if self.total > GREATEST_COUNT or self.rounds > ROUNDS:
            again[:] = False
        kept = np.where(again, 0.0, upper)
        self.settled = np.maximum(self.settled, kept.max(axis=1, initial=0.0))
        return again

    def finer(self, grid: Grid, again: Mask) -> Grid:
        """Those boxes, each in four, or in more where they are few."""
        finer = boxes.grid(grid.low[:, again], grid.high[:, again])
        finer = boxes.halves(boxes.halves(finer, self.form), self.form)
        while finer.count < ENOUGH:
            finer = boxes.halves(finer, self.form)
        return finer
