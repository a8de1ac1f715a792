"""The proof for a kernel of one input: it finds each output's domain itself."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.domain import input_range, normal_interval
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.proof import Proof, Settled
from gainproof.derive.printer.special_values import exclude_nan
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


class OneInput(Proof):
    """Boxes over the input's domain, bisected until the bounds of all outputs settle."""

    def __init__(self, kernel: Kernel, form: Format) -> None:
        super().__init__(kernel, form, (input_range(kernel.inputs[0], form),))
        ((self.lowest, self.highest),) = self.inputs
        if self.lowest < 0:
            raise NotImplementedError(f"{kernel.name}: an input that may be negative")

    def run(self) -> Settled:
        """Domains first, then their bounds."""
        zero = [(0.0, self.form.least)] if self.lowest == 0 else []
        forward = self.forward(boxes.cover(self.inputs, self.near, [zero]))
        scales = dict.fromkeys(scale for _, scale in self.ends)
        domain = {scale: normal_interval(forward, scale, self.forward) for scale in scales}
        self.domains = [(domain[scale],) for _, scale in self.ends]
        gaps = [
            gap
            for low, high in domain.values()
            for gap in ((self.form.before(low), low), (high, self.form.after(high)))
            if self.lowest <= gap[0] and gap[1] <= self.highest
        ]
        if gaps:
            forward = self.forward(boxes.cover(self.inputs, self.near, [zero + gaps]))
        exclude_nan(forward, self.forward, self.ends, self.domains)
        return self._refine(forward)

    def _refine(self, forward: Forward) -> Settled:
        progress = Refinement(len(self.ends), self.form)
        factors = np.zeros(len(self.ends) * len(self.kernel.cancellations))
        while True:
            grid, adjoint = forward.grid, self.bounded(forward)
            again = progress.step(grid, adjoint.upper, self._least(grid, adjoint.lower))
            self.refuse(adjoint, np.isinf(adjoint.upper) & ~again)
            settled = self.cancellations(adjoint)[:, ~again]
            factors = np.maximum(factors, settled.max(axis=1, initial=0.0))
            if not again.any():
                return self.settled(progress.settled, factors, progress.total)
            forward = self.forward(progress.finer(grid, again))

    def _least(self, grid: Grid, least: Array) -> Array:
        """What no finer box gets below; of a named cancellation, that at one end of the box.

        Errors that enter a difference are not set off against each other, so that the reverse pass
        knows no least size of theirs.
        """
        if not self.kernel.cancellations:
            return least
        at_one_end = self.adjoint(boxes.grid(grid.low, grid.low)).upper
        return np.maximum(least, np.where(np.isfinite(at_one_end), at_one_end, 0.0))
