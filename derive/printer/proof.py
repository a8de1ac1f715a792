"""What proofs over boxes have in common, whatever the number of inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.adjoint import Adjoint
from gainproof.derive.printer.domain import greatest_normal
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.refusal_text import reason
from gainproof.derive.printer.special_values import Behaviour
from gainproof.derive.printer.step_ranges import (
    LEAST_NORMAL,
    Box,
    Grid,
    Mask,
    PrintingError,
    true_size,
)


@dataclass(frozen=True)
class Settled:
    """What a proof found: errors over scales and domains, an entry an output.

    `factors`: of each named cancellation, an entry an output. `beside`: errors of outputs of signed
    inputs that no scale bounds.
    """

    inputs: Box
    domains: Sequence[Box]
    bounds: Array
    factors: Mapping[str, Array]
    boxes: int
    beside: tuple[float, ...] = ()


class Proof:
    """A kernel's program with its outputs and their scales, over the domain `inputs`."""

    def __init__(self, kernel: Kernel, form: Format, inputs: Box) -> None:
        self.kernel, self.form, self.inputs = kernel, form, inputs
        names = tuple(given.name for given in kernel.inputs)
        used = kernel.program
        if not set(used.inputs) <= set(names):
            raise PrintingError(f"the graph has inputs {used.inputs}, the kernel has {names}")
        self.program = replace(used, inputs=names)
        self.near = boxes.special_points(self.program, form)
        self.ends = [self._end(output.name, output.relative_to) for output in kernel.outputs]
        self.domains: list[Box] = [inputs for _ in self.ends]

    def _end(self, name: str, scale: str | None) -> tuple[int, int]:
        for wanted in (name, scale or name):
            if wanted not in self.program.outputs:
                raise PrintingError(f"the graph has no output {wanted!r}")
        return self.program.outputs[name], self.program.outputs[scale or name]

    def forward(self, grid: Grid) -> Forward:
        """Ranges of all steps."""
        return Forward(self.program, grid, self.form, self.kernel.cancellations)

    def adjoint(self, grid: Grid) -> Adjoint:
        """The bounds over boxes."""
        return self.bounded(self.forward(grid))

    def bounded(self, forward: Forward) -> Adjoint:
        """Bounds: infinite where a scale may be no normal number, 0 outside an output's domain."""
        if any(value.over is not None for value in forward.values):
            Behaviour(forward).settle_overflow()
        adjoint = Adjoint(forward, self.ends)
        adjoint.upper = np.minimum(adjoint.upper, self.ceiling(forward))
        for row, ((_, scale), domain) in enumerate(zip(self.ends, self.domains, strict=True)):
            size = true_size(forward.values[scale])
            normal = size[0][0] >= self.form.least_normal * LEAST_NORMAL
            normal &= size[1][0] <= greatest_normal(self.form) * (1.0 + 2.0**-40)
            adjoint.upper[row, ~normal] = np.inf
            without = ~boxes.inside(forward.grid, domain)
            adjoint.upper[row, without] = 0.0
            adjoint.lower[row, without] = 0.0
        return adjoint

    def ceiling(self, forward: Forward) -> Array:
        """What else is known of the errors: nothing, unless a proof says so."""
        return np.full((len(self.ends), forward.count), np.inf)

    def refuse(self, adjoint: Adjoint, failed: Mask) -> None:
        """PrintingError with the reason if any output failed in any box."""
        if failed.any():
            row, text = reason(adjoint, failed)
            raise PrintingError(f"output {self.kernel.outputs[row].name}, {text}")

    def cancellations(self, adjoint: Adjoint) -> Array:
        """The weights of the named cancellations: a row for each name and output, box by box."""
        count = len(self.ends)
        found = np.zeros((count * len(self.kernel.cancellations), adjoint.forward.count))
        for at, name in enumerate(self.kernel.cancellations):
            for number in adjoint.weights:
                if self.program.steps[number].label == name:
                    found[at * count : (at + 1) * count] = adjoint.sizes(number)
        return found

    def settled(self, bounds: Array, factors: Array, total: int) -> Settled:
        """The result, from the largest bounds and weights of cancellations."""
        rows = factors.reshape(len(self.kernel.cancellations), len(self.ends))
        named = dict(zip(self.kernel.cancellations, rows, strict=True))
        return Settled(self.inputs, self.domains, bounds, named, total)
