"""Proved bounds on the rounding error of a kernel, and the domain on which each output has them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.adjoint import Adjoint
from gainproof.derive.printer.behaviour import Behaviour
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.exact import is_normal, last_that_holds
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.kernel import Input, Kernel
from gainproof.derive.printer.program import Program, program
from gainproof.derive.printer.value import Grid, Mask, PrintingError, true_size

TOLERANCE = 0.01  # boxes are bisected until the bound is this close to its least possible value
GREATEST_COUNT = 40_000  # of boxes of one kernel in one format
ROUNDS = 40
DIGITS = 100  # printed bounds are rounded up to hundredths of the format's epsilon


@dataclass(frozen=True)
class OutputBound:
    """What is proved of one output in one format.

    `bound`: the error over the scale is at most `bound` * epsilon, epsilon = 2^-52 or 2^-23, for
    every input of the format from `lowest` to `highest`, the largest interval where the true value
    of the scale is a normal number. `amplification`: for each named cancellation the factor by
    which errors of its operands' sizes may enter this output.
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


def input_range(given: Input, form: Format) -> tuple[float, float]:
    """The least and the greatest number of the format in an input's domain."""
    lower = constant(given.lower)
    lowest = lower.at_least(form)
    if given.lower_open and lower.is_exact(form):
        lowest = form.after(lowest)
    if given.upper is None:
        return lowest, form.largest
    upper = constant(given.upper)
    if upper.rational is not None and upper.rational > Fraction(form.largest):
        return lowest, form.largest
    highest = upper.at_most(form)
    if given.upper_open and upper.is_exact(form):
        highest = form.before(highest)
    return lowest, highest


def prove(kernel: Kernel, form: Format) -> KernelBound:
    """Bounds every output of a kernel in one format.

    PrintingError, naming the node, for a subtraction of computed values that is not named, an
    over- or underflow inside an output's domain, a possible NaN, or a bound that does not settle.
    NotImplementedError for several inputs or negative ones.
    """
    if len(kernel.inputs) != 1:
        raise NotImplementedError(f"{kernel.name}: bounds for several inputs are not built yet")
    with np.errstate(all="ignore"):
        return _Proof(kernel, form).run()


class _Proof:
    def __init__(self, kernel: Kernel, form: Format) -> None:
        self.kernel, self.form = kernel, form
        self.program: Program = program(kernel.graph)
        self.lowest, self.highest = input_range(kernel.inputs[0], form)
        if self.lowest < 0:
            raise NotImplementedError(f"{kernel.name}: an input that may be negative")
        self.near = boxes.special_points(self.program, form)
        self.ends = [self._end(output.name, output.relative_to) for output in kernel.outputs]
        # room for the rounding error of a value next to the largest number
        self.top = form.largest * (1.0 - 64.0 * form.epsilon)

    def _end(self, name: str, scale: str | None) -> tuple[int, int]:
        for wanted in (name, scale or name):
            if wanted not in self.program.outputs:
                raise PrintingError(f"{self.kernel.name}: the graph has no output {wanted!r}")
        return self.program.outputs[name], self.program.outputs[scale or name]

    def _forward(self, grid: Grid) -> Forward:
        return Forward(self.program, grid, self.form, self.kernel.cancellations)

    def run(self) -> KernelBound:
        forward = self._forward(boxes.cover(self.lowest, self.highest, self.near, []))
        domains: dict[int, tuple[float, float]] = {}
        for _, scale in self.ends:
            if scale not in domains:
                domains[scale] = self._domain(forward, scale)
        self.domains = [domains[scale] for _, scale in self.ends]
        plain = [
            gap
            for low, high in domains.values()
            for gap in ((self.form.before(low), low), (high, self.form.after(high)))
            if self.lowest <= gap[0] and gap[1] <= self.highest
        ]
        grid = boxes.cover(self.lowest, self.highest, self.near, plain)
        self._exclude_nan(grid)
        return self._refine(grid)

    def _domain(self, forward: Forward, number: int) -> tuple[float, float]:
        """The largest interval of inputs where a step's true value is a normal number."""
        for _ in range(6):
            low, high = (end[0] for end in true_size(forward.values[number]))
            sure = np.flatnonzero((low >= self.form.least_normal) & (high <= self.top))
            if len(sure):
                break
            finer = boxes.halves(forward.grid, self.form)
            order = np.argsort(finer.low, kind="stable")
            forward = self._forward(boxes.grid(finer.low[order], finer.high[order]))
        else:
            raise PrintingError(f"{self.kernel.name}: an output is nowhere surely a normal number")

        def normal(x: float) -> bool:
            return is_normal(self.program, number, x, self.form, self.top)

        def end(inside: float, places: list[float]) -> float:
            for place in places:
                if not normal(place):
                    return last_that_holds(normal, inside, place, self.form)
                inside = place
            return inside

        grid = forward.grid
        # ends of boxes may lie between numbers of a narrower format
        lows = [self.form.at_least(Fraction(x)) for x in grid.low[: sure[0]][::-1].tolist()]
        highs = [self.form.at_most(Fraction(x)) for x in grid.high[sure[-1] + 1 :].tolist()]
        first = self.form.at_least(Fraction(float(grid.low[sure[0]])))
        last = self.form.at_most(Fraction(float(grid.high[sure[-1]])))
        return end(first, lows), end(last, highs)

    def _exclude_nan(self, grid: Grid) -> None:
        """PrintingError unless no output can be NaN, or normal where the true value is not."""
        for turn in range(12):
            forward = self._forward(grid)
            bad = self._uncertain(forward, Behaviour(forward))
            if not bad.any():
                return
            grid = boxes.grid(grid.low[bad], grid.high[bad])
            points = self._forward(boxes.grid(grid.low, grid.low))
            worse = self._uncertain(points, Behaviour(points))
            if worse.any() or turn == 11 or len(grid.low) > GREATEST_COUNT:
                raise PrintingError(
                    f"{self.kernel.name} ({self.form.name}), input "
                    f"{float(grid.low[worse.argmax()])!r}: NaN, or a normal number where the true "
                    "value is none, cannot be excluded; another order of operations may avoid an "
                    "over- or underflow"
                )
            grid = boxes.halves(boxes.halves(grid, self.form), self.form)

    def _uncertain(self, forward: Forward, behaviour: Behaviour) -> Mask:
        """Boxes where an output may be NaN, or normal outside its domain."""
        grid = forward.grid
        bad = np.zeros(len(grid.low), np.bool_)
        for (output, scale), (low, high) in zip(self.ends, self.domains, strict=True):
            bad |= behaviour.lost[output]
            if output == scale:
                outside = (grid.high < low) | (grid.low > high)
                vanishing = behaviour.high[output] <= 4.0 * self.form.least_normal
                vast = behaviour.low[output] >= self.form.largest / 4.0
                bad |= outside & ~(vanishing | vast)
        return bad

    def _refine(self, grid: Grid) -> KernelBound:
        count = len(self.ends)
        settled, least, total = np.zeros(count), np.zeros(count), 0
        before = np.full(count, np.inf)
        amplification: list[dict[str, float]] = [{} for _ in range(count)]
        for _ in range(ROUNDS):
            forward = self._forward(grid)
            if any(value.over is not None for value in forward.values):
                Behaviour(forward).settle_overflow()
            adjoint = Adjoint(forward, self.ends)
            upper, lower, inside = self._inside(adjoint)
            total += len(grid.low)
            least = np.maximum(least, lower.max(axis=1, initial=0.0))
            wide = grid.low < grid.high
            open_ = (upper > least[:, None] * (1.0 + TOLERANCE)) & inside
            largest = upper.max(axis=1, initial=0.0)
            # what two bisections do not improve is as good as settled
            open_ &= ~(largest > before * (1.0 - TOLERANCE / 4))[:, None] | np.isinf(upper)
            before = largest
            again = open_.any(axis=0) & wide
            if total > GREATEST_COUNT:
                again[:] = False
            kept = np.where(again, 0.0, upper)
            settled = np.maximum(settled, kept.max(axis=1, initial=0.0))
            self._note_cancellations(adjoint, ~again, amplification)
            if not np.isfinite(settled).all():
                self._explain(adjoint, np.isinf(kept))
            if not again.any():
                return self._result(settled, total, amplification)
            part = boxes.grid(grid.low[again], grid.high[again])
            grid = boxes.halves(boxes.halves(part, self.form), self.form)
        raise PrintingError(f"{self.kernel.name} ({self.form.name}): the bound does not settle")

    def _inside(self, adjoint: Adjoint) -> tuple[Array, Array, Mask]:
        grid, values = adjoint.forward.grid, adjoint.forward.values
        upper, lower = adjoint.upper, adjoint.lower
        inside = np.zeros(upper.shape, np.bool_)
        for row, ((_, scale), (low, high)) in enumerate(zip(self.ends, self.domains, strict=True)):
            inside[row] = (grid.low >= low) & (grid.high <= high)
            size = true_size(values[scale])
            normal = size[0][0] >= self.form.least_normal * (1.0 - 2.0**-14)
            normal &= size[1][0] <= self.top * (1.0 + 2.0**-40)
            upper[row, ~normal] = np.inf
        upper[~inside] = 0.0
        lower[~inside] = 0.0
        return upper, lower, inside

    def _note_cancellations(
        self, adjoint: Adjoint, kept: Mask, amplification: list[dict[str, float]]
    ) -> None:
        for number, step in enumerate(self.program.steps):
            if step.label in self.kernel.cancellations and number in adjoint.weights:
                weight = adjoint.weights[number]
                for row, found in enumerate(amplification):
                    size = np.maximum(-weight.share[0][row], weight.share[1][row])
                    most = float(np.where(weight.active[row] & kept, size, 0.0).max(initial=0.0))
                    found[step.label] = max(found.get(step.label, 0.0), most)

    def _explain(self, adjoint: Adjoint, failed: Mask) -> None:
        row, box = (int(at[0]) for at in np.nonzero(failed))
        forward = adjoint.forward
        place = f"input {float(forward.grid.low[box])!r}"
        reasons: dict[int, str] = {}
        for number, step in enumerate(self.program.steps):
            value, weight = forward.values[number], adjoint.weights.get(number)
            if weight is None or not weight.active[row, box]:
                continue
            name = f"node {step.node} ({step.label or step.operation})"
            if reasons.keys() & set(step.operands):
                continue  # only where it begins
            if value.over is not None and value.over[box]:
                reasons[number] = f"{name} may overflow"
            elif value.invalid is not None and value.invalid[box]:
                reasons[number] = f"{name} divides by, or takes the root of, what is not normal"
            elif value.tiny is not None and value.tiny[box] > 0:
                reasons[number] = f"{name} may be subnormal or 0"
        raise PrintingError(
            f"{self.kernel.name} ({self.form.name}), output {self.kernel.outputs[row].name}, "
            f"{place}: the true value is a normal number, but the error is not bounded: "
            f"{'; '.join(reasons.values()) or 'ranges too wide'}. "
            "Another order of operations may avoid it"
        )

    def _result(
        self, settled: Array, total: int, amplification: list[dict[str, float]]
    ) -> KernelBound:
        outputs = []
        for row, output in enumerate(self.kernel.outputs):
            exact = Fraction(float(settled[row])) / Fraction(self.form.epsilon)
            bound = Fraction(math.ceil(exact * DIGITS), DIGITS)
            low, high = self.domains[row]
            outputs.append(OutputBound(output.name, bound, low, high, amplification[row]))
        inputs = ((self.lowest, self.highest),)
        return KernelBound(self.form, inputs, tuple(outputs), total)
