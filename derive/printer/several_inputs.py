"""The proof for a kernel of several inputs: bounds on the whole product of their domains."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.behaviour import exclude_nan
from gainproof.derive.printer.domain import product
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.frontier import Frontier, Waiting
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.proof import Proof, Settled
from gainproof.derive.printer.value import Grid

WORST = 2.0**7  # epsilons: a larger bound tells of an underflow on the way, and is refused


class SeveralInputs(Proof):
    """Boxes over the product of the domains, bisected where the bounds are largest.

    Nothing is searched: a value that is not normal, or that has no bound, anywhere in the product
    is refused.
    """

    def __init__(self, kernel: Kernel, form: Format) -> None:
        super().__init__(kernel, form, product(kernel.inputs, form))
        self.greatest = WORST * form.epsilon

    def run(self) -> Settled:
        """The bounds, after NaN has been excluded."""
        corners = self._corners()
        adjoint = self.adjoint(corners)
        self.refuse(adjoint, adjoint.upper > self.greatest)  # at once, and with a clear place
        grid = boxes.cover(self.inputs, self.near, [() for _ in self.inputs])
        exclude_nan(grid, self.forward, self.ends, self.domains)
        return self._refine(grid)

    def _corners(self) -> Grid:
        """The corners of the domain as boxes."""
        places = np.indices([2] * len(self.inputs)).reshape(len(self.inputs), -1)
        ends = np.take_along_axis(np.array(self.inputs), places, axis=1)
        return boxes.grid(ends, ends)

    def _refine(self, grid: Grid) -> Settled:
        count = len(self.ends)
        frontier = Frontier(count, count * len(self.kernel.cancellations), self.form, self.greatest)
        following: Grid | None = grid
        while following is not None:
            adjoint = self.adjoint(following)
            found = Waiting(following, adjoint.upper, self.cancellations(adjoint))
            frontier.add(found, adjoint.lower)
            following = frontier.finer()
        if frontier.failed is not None:
            adjoint = self.adjoint(frontier.failed)
            self.refuse(adjoint, adjoint.upper > self.greatest)
        return self.settled(frontier.settled, frontier.other, frontier.total)
