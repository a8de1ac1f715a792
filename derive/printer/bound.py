"""Proved bounds on the rounding error of a kernel, and the domain on which each output has them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.adjoint import Adjoint
from gainproof.derive.printer.behaviour import Behaviour, exclude_nan
from gainproof.derive.printer.domain import greatest_normal, input_range, normal_interval
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.program import program
from gainproof.derive.printer.refinement import Refinement
from gainproof.derive.printer.refusal import reason
from gainproof.derive.printer.value import LEAST_NORMAL, Grid, Mask, PrintingError, true_size

DIGITS = 100  # printed bounds are rounded up to hundredths of the format's epsilon


@dataclass(frozen=True)
class OutputBound:
    """What is proved of one output in one format.

    `bound`: the error over the scale is at most `bound` * epsilon, epsilon = 2^-52 or 2^-23, for
    every input of the format from `lowest` to `highest`, the largest interval where the true value
    of the scale is a normal number (and 64 epsilon below the largest). `amplification`: for each
    named cancellation the factor by which errors of its operands' sizes may enter this output.
    """

    name: str
    bound: Fraction
    lowest: float
    highest: float
    amplification: Mapping[str, float]


@dataclass(frozen=True)
class KernelBound:
    """The bounds of all outputs in one format.

    `inputs`: least and greatest number of each input's domain; `boxes`: how many prove the bounds.
    """

    format: Format
    inputs: tuple[tuple[float, float], ...]
    outputs: tuple[OutputBound, ...]
    boxes: int

    @property
    def lowest(self) -> float:
        """The least number of the first input's domain."""
        return self.inputs[0][0]

    @property
    def highest(self) -> float:
        """The greatest number of the first input's domain."""
        return self.inputs[0][1]


def prove(kernel: Kernel, form: Format) -> KernelBound:
    """Bounds every output of a kernel in one format.

    PrintingError, naming the node, for a subtraction of computed values that is not named, an
    over- or underflow inside an output's domain, a possible NaN, or a bound that does not settle.
    NotImplementedError for several inputs or negative ones.
    """
    if len(kernel.inputs) != 1:
        raise NotImplementedError(f"{kernel.name}: bounds for several inputs are not built yet")
    try:
        with np.errstate(all="ignore"):
            return _Proof(kernel, form).run()
    except (PrintingError, OverflowError) as error:
        raise PrintingError(f"{kernel.name} ({form.name}): {error}") from error


class _Proof:
    """Boxes over the input's domain, bisected until the bounds of all outputs settle."""

    def __init__(self, kernel: Kernel, form: Format) -> None:
        self.kernel, self.form = kernel, form
        self.program = program(kernel.graph)
        self.lowest, self.highest = input_range(kernel.inputs[0], form)
        if self.lowest < 0:
            raise NotImplementedError(f"{kernel.name}: an input that may be negative")
        self.near = boxes.special_points(self.program, form)
        self.ends = [self._end(output.name, output.relative_to) for output in kernel.outputs]

    def _end(self, name: str, scale: str | None) -> tuple[int, int]:
        for wanted in (name, scale or name):
            if wanted not in self.program.outputs:
                raise PrintingError(f"the graph has no output {wanted!r}")
        return self.program.outputs[name], self.program.outputs[scale or name]

    def _forward(self, grid: Grid) -> Forward:
        return Forward(self.program, grid, self.form, self.kernel.cancellations)

    def run(self) -> KernelBound:
        zero = [(0.0, self.form.least)] if self.lowest == 0 else []
        forward = self._forward(boxes.cover(self.lowest, self.highest, self.near, zero))
        scales = dict.fromkeys(scale for _, scale in self.ends)
        domain = {scale: normal_interval(forward, scale, self._forward) for scale in scales}
        self.domains = [domain[scale] for _, scale in self.ends]
        gaps = [
            gap
            for low, high in domain.values()
            for gap in ((self.form.before(low), low), (high, self.form.after(high)))
            if self.lowest <= gap[0] and gap[1] <= self.highest
        ]
        grid = boxes.cover(self.lowest, self.highest, self.near, zero + gaps)
        exclude_nan(grid, self._forward, self.ends, self.domains)
        return self._refine(grid)

    def _refine(self, grid: Grid) -> KernelBound:
        progress = Refinement(len(self.ends), self.form)
        amplification: list[dict[str, float]] = [{} for _ in self.ends]
        while True:
            forward = self._forward(grid)
            if any(value.over is not None for value in forward.values):
                Behaviour(forward).settle_overflow()
            adjoint = Adjoint(forward, self.ends)
            inside = self._inside(adjoint)
            again = progress.step(grid, adjoint.upper, adjoint.lower, inside)
            failed = np.isinf(adjoint.upper) & ~again
            if failed.any():
                row, text = reason(adjoint, failed)
                raise PrintingError(f"output {self.kernel.outputs[row].name}, {text}")
            self._note_cancellations(adjoint, again, amplification)
            if not again.any():
                break
            grid = progress.finer(grid, again)
        outputs = []
        for row, output in enumerate(self.kernel.outputs):
            exact = Fraction(float(progress.settled[row])) / Fraction(self.form.epsilon)
            bound = Fraction(math.ceil(exact * DIGITS), DIGITS)
            outputs.append(OutputBound(output.name, bound, *self.domains[row], amplification[row]))
        inputs = ((self.lowest, self.highest),)
        return KernelBound(self.form, inputs, tuple(outputs), progress.total)

    def _inside(self, adjoint: Adjoint) -> Mask:
        """Boxes of each output's domain: elsewhere bounds become 0, and infinite if not normal."""
        grid, values = adjoint.forward.grid, adjoint.forward.values
        inside = np.zeros(adjoint.upper.shape, np.bool_)
        for row, ((_, scale), (low, high)) in enumerate(zip(self.ends, self.domains, strict=True)):
            inside[row] = (grid.low >= low) & (grid.high <= high)
            size = true_size(values[scale])
            normal = size[0][0] >= self.form.least_normal * LEAST_NORMAL
            normal &= size[1][0] <= greatest_normal(self.form) * (1.0 + 2.0**-40)
            adjoint.upper[row, ~normal] = np.inf
        adjoint.upper[~inside] = 0.0
        adjoint.lower[~inside] = 0.0
        return inside

    def _note_cancellations(
        self, adjoint: Adjoint, again: Mask, amplification: list[dict[str, float]]
    ) -> None:
        for number, step in enumerate(self.program.steps):
            if step.label in self.kernel.cancellations and number in adjoint.weights:
                most = adjoint.greatest_weight(number, ~again)
                for found, size in zip(amplification, most, strict=True):
                    found[step.label] = max(found.get(step.label, 0.0), size)
