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
from gainproof.derive.printer.special_values import Behaviour
from gainproof.derive.printer.step_ranges import (
    LEAST_NORMAL,
    Box,
    Grid,
    Mask,
    PrintingError,
    true_size,
)
from gainproof.derive.printer.step_text import formula


def reason(adjoint: Adjoint, failed: Mask) -> tuple[int, str]:
    """The row of the first output that failed, and where and how its error has no bound."""
    row, box = (int(at[0]) for at in np.nonzero(failed))
    forward = adjoint.forward
    place = f"input {boxes.point_text(forward.grid, box)}"
    several = forward.grid.axes > 1
    low, high = (float(end[0][box]) for end in true_size(forward.values[adjoint.ends[row][1]]))
    if several and not (forward.form.least_normal <= low and high <= greatest_normal(forward.form)):
        return row, (
            f"{place}: its true value or its scale, between {low:.3g} and {high:.3g}, may be "
            "no normal number. Several inputs need a domain where all outputs are normal"
        )
    found: dict[int, str] = {}
    for number, step in enumerate(forward.program.steps):
        value, weight = forward.values[number], adjoint.weights.get(number)
        if weight is None or not weight.is_active(row, box):
            continue
        name = formula(forward.program, number)
        name += f" ({step.label})" if step.label in forward.cancellations else ""
        if found.keys() & set(step.operands):
            continue  # only where it begins
        if value.over is not None and value.over[box]:
            found[number] = f"{name} may overflow"
        elif step.operation == "root" and forward.cycles.complaint(box):
            found[number] = forward.cycles.complaint(box)
        elif value.invalid is not None and value.invalid[box]:
            found[number] = f"{name} divides by, or takes the root of, what is not normal"
        elif value.tiny is not None and value.tiny[box] > 0:
            found[number] = f"{name} may be subnormal or 0"
        elif several and value.loose and value.shares is not None:
            found[number] = f"{name} cancels"
    bounded = f"below {adjoint.upper[row, box] / forward.form.epsilon:.3g} epsilon"
    return row, (
        f"{place}: the true value is a normal number, but the error is not "
        f"{bounded if np.isfinite(adjoint.upper[row, box]) else 'bounded'}: "
        f"{'; '.join(found.values()) or 'ranges too wide'}. "
        "Another order of operations may avoid it"
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
