"""The proof for a kernel of several inputs: bounds on the whole product of their domains."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import box_search, boxes
from gainproof.derive.printer.domain import product
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.proof import Proof, Settled
from gainproof.derive.printer.special_values import exclude_nan
from gainproof.derive.printer.step_ranges import Grid, PrintingError
from gainproof.derive.printer.structural import Structural

WIDE = 2  # inputs: of more the first box is the whole domain, boxes of each would be too many
MANY = 6  # inputs: of more the bounds are those of the shape, and boxes beyond a few change nothing
FEWER = 8  # times fewer boxes then
WORST = 2.0**7  # epsilons: a larger bound tells of an underflow on the way, and is refused


class SeveralInputs(Proof):
    """Boxes over the product of the domains, bisected where the bounds are largest.

    Nothing is searched: a value that is not normal, or that has no bound, anywhere in the product
    is refused. `enough`: bounds, one an output, below which none is made smaller.
    """

    def __init__(self, kernel: Kernel, form: Format, enough: Array | None = None) -> None:
        super().__init__(kernel, form, product(kernel.inputs, form))
        self.greatest = WORST * form.epsilon
        self.enough = np.zeros(len(self.ends)) if enough is None else enough

    def run(self) -> Settled:
        """The bounds, after NaN has been excluded."""
        try:
            return self._proved()
        except PrintingError:
            adjoint = self.adjoint(self._corners())
            self.refuse(adjoint, adjoint.upper > self.greatest)  # with a clear place, if one is one
            raise

    def _proved(self) -> Settled:
        ratio = boxes.RATIO if len(self.inputs) <= WIDE else np.inf
        grid = boxes.cover(self.inputs, self.near, [() for _ in self.inputs], ratio)
        forward = self.forward(grid)
        exclude_nan(forward, self.forward, self.ends, self.domains)
        return self._refine(forward)

    def ceiling(self, forward: Forward) -> Array:
        """Bounds from the program's shape, which hold in wide boxes too."""
        return Structural(forward, self.kernel.cancellations).bounds(self.ends)

    def _corners(self) -> Grid:
        """The corners of the domain as boxes."""
        places = np.indices([2] * len(self.inputs)).reshape(len(self.inputs), -1)
        ends = np.take_along_axis(np.array(self.inputs), places, axis=1)
        return boxes.grid(ends, ends)

    def _refine(self, forward: Forward) -> Settled:
        count, budget = (
            len(self.ends),
            self.kernel.search * box_search.WORK // len(self.program.steps),
        )
        if len(self.inputs) > MANY:
            budget //= FEWER
        others = count * len(self.kernel.cancellations)
        progress = box_search.Frontier(count, others, self.form, self.greatest, budget)
        progress.least = self.enough
        while True:
            adjoint = self.bounded(forward)
            found = box_search.Waiting(forward.grid, adjoint.upper, self.cancellations(adjoint))
            progress.add(found, adjoint.lower)
            following = progress.finer()
            if following is None:
                break
            forward = self.forward(following)
        if progress.failed is not None:
            adjoint = self.adjoint(progress.failed)
            self.refuse(adjoint, adjoint.upper > self.greatest)
        return self.settled(progress.settled, progress.other, progress.total)
