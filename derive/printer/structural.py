"""Error bounds from the shape of a program alone, weighed by shares: good over wide boxes.

Errors are logarithms: with e bounding |log(computed/exact)| in units of -log(1 - u), a rounding
is 1, e(a b) = e(a) + e(b) + 1, e(sqrt a) = e(a)/2 + 1, and of terms of one sign
e(a + b) = s e(a) + (1 - s) e(b) + 1 with the share s = a/(a + b) of an intermediate point (mean
value theorem), which the forward pass encloses for every rounding. Nothing of second order is
neglected. Errors that a node sends along several ways are added, never set off: x/x costs
1 + 2 e(x). All this holds in boxes where no step under- or overflows; in others nothing is proved.

The adjoint pass is better in narrow boxes, where errors that a node sends along several ways are
set off. In wide ones its ranges of quotients are too wide for that.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.affine import affine_sum
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.interval import Array, Interval
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.step_ranges import Mask, Value


def measured_by_parts(program: Program, output: int, scale: int) -> bool:
    """Whether an output is a difference and its scale the sum of the same two steps' magnitudes.

    Both may be multiplied by the same power of two, which is exact.
    """
    difference, both = program.steps[output], program.steps[scale]
    if difference.scale is not None and difference.scale == both.scale:
        ((inside,), (within,)) = difference.operands, both.operands
        difference, both = program.steps[inside], program.steps[within]
    same = sorted(difference.operands) == sorted(_signed(program, part) for part in both.operands)
    return difference.operation == "sub" and both.operation == "add" and same


def _signed(program: Program, number: int) -> int:
    """The step itself, or the one whose absolute value it is."""
    step = program.steps[number]
    return step.operands[0] if step.operation == "abs" else number


class Structural:
    """Errors of all steps over the boxes of a forward pass, infinite where nothing is proved."""

    def __init__(self, forward: Forward, cancellations: Collection[str]) -> None:
        self.forward, self.cancellations = forward, cancellations
        self.errors: list[Array] = []
        for number in range(len(forward.values)):
            self.errors.append(self._error(number))

    def bounds(self, ends: Sequence[tuple[int, int]]) -> Array:
        """Errors over the scales: a row for each output with its scale, a column a box."""
        return np.stack([self._bound(output, scale) for output, scale in ends])

    def _bound(self, output: int, scale: int) -> Array:
        error = np.full(self.forward.count, np.inf)
        most = self.errors[output]
        if output == scale:
            error = self.errors[output]
        elif self._named(output) and measured_by_parts(self.forward.program, output, scale):
            # |a' - a| <= a ((1 - u)^-e - 1) and the same of b, over the exact a + b
            parts = [self.errors[part] for part in self.forward.program.steps[output].operands]
            error, most = self._weighed(self.forward.values[output], *parts), np.maximum(*parts)
        unit = self.forward.form.unit_roundoff
        # (1 - u)^-e - 1 <= e u/(1 - max(e, 1) u) (Bernoulli); a difference has a factor 1 + u more
        room = 1.0 - (most + 2.0) * unit
        bound = np.where(room > 0.5, error * unit / room, np.inf)
        # rounding: far fewer than 2^16 operations of positive numbers lead here
        return np.where(np.isfinite(bound), bound * interval.SLACK, np.inf)

    def _named(self, number: int) -> bool:
        return self.forward.program.steps[number].label in self.cancellations

    def _error(self, number: int) -> Array:
        step, value = self.forward.program.steps[number], self.forward.values[number]
        parts = [self.errors[part] for part in step.operands]
        zero = np.zeros(self.forward.count)
        if step.scale is not None:
            error = parts[0]
        else:
            match step.operation:
                case "input" | "start" | "iterate":
                    error = zero  # of an iterate only its distance counts: its successor's rounding
                case "root":
                    error = parts[0] + value.rounding / self.forward.form.unit_roundoff
                case "less":
                    assert value.shares is not None
                    weights = (end[1] for end in value.shares)
                    error = sum((w * e for w, e in zip(weights, parts, strict=True)), zero) + 1.0
                case "constant":
                    error = zero + value.rounding / self.forward.form.unit_roundoff
                case "add" | "sub":
                    error = self._sum(number, value, parts)
                case "mul" | "div":
                    error = parts[0] + parts[1] + 1.0
                case "sqrt":
                    error = parts[0] / 2 + 1.0
                case "neg" | "abs":
                    error = parts[0]
                case "select":
                    assert value.chosen is not None
                    error = np.where(value.chosen, parts[2], parts[3])
                case _:
                    error = zero + np.inf
        return np.where(self._fine(number, value), error, np.inf)

    def _sum(self, number: int, value: Value, parts: list[Array]) -> Array:
        affine = affine_sum(self.forward.program, number, self.forward.form)
        if affine is not None:
            # exact operands: their rounding is all; in two parts it is one more, a little apart
            # from exact where the first sum is much larger than the rest of the constant
            return np.full(self.forward.count, 1.0 if affine.parts == 1 else 2.0 + 2.0**-10)
        if value.loose:
            return np.full(self.forward.count, np.inf)
        return self._weighed(value, *parts)

    def _weighed(self, value: Value, first: Array, second: Array) -> Array:
        """s e(a) + (1 - s) e(b) + 1 at the worst share; it is linear in s."""
        assert value.shares is not None
        own: Interval = value.shares[0]
        low, high = np.clip(own[0], 0.0, 1.0), np.clip(own[1], 0.0, 1.0)
        fine = np.isfinite(first) & np.isfinite(second)
        a, b = np.where(fine, first, 0.0), np.where(fine, second, 0.0)
        worst = np.maximum(low * a + (1.0 - low) * b, high * a + (1.0 - high) * b)
        return np.where(fine, worst + 1.0, np.inf)

    def _fine(self, number: int, value: Value) -> Mask:
        """Where the step's result is rounded as a normal number, for every rounding before it."""
        step, form = self.forward.program.steps[number], self.forward.form
        fine = np.ones(self.forward.count, np.bool_)
        for failed in (value.over, value.invalid):
            if failed is not None:
                fine &= ~failed
        for lost in (value.stray, value.tiny):
            if lost is not None:
                fine &= lost == 0
        if step.operation in ("mul", "div", "sqrt", "constant"):
            least = value.size[0][0] / ((1.0 + value.drift) * interval.SLACK)
            fine &= least >= form.least_normal
        return fine
