"""Ranges of every step over many boxes of the inputs, exactly and under every possible rounding.

For each box: the magnitude's range, the sign, and the ranges of the logarithmic slopes
d log|value| / d log(input): where they have signs the range comes from the box's corners, and so
does that of the ratio of two steps whose slopes differ by signs. `drift` E bounds what rounding
does to a step: computed/exact lies in [1/(1 + E), 1 + E], but for an absolute error of `stray`
where an operand may be subnormal or zero.
"""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.affine import AffineSum, affine_sum
from gainproof.derive.printer.box_operations import product, quotient, root, scaled, with_stray
from gainproof.derive.printer.constant import Constant
from gainproof.derive.printer.corners import rows
from gainproof.derive.printer.cycles import Cycles
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.program import Program, Step
from gainproof.derive.printer.ratio import ratio
from gainproof.derive.printer.select_conditions import threshold
from gainproof.derive.printer.step_ranges import (
    LEAST_NORMAL,
    MARGIN,
    Grid,
    Mask,
    PrintingError,
    Signs,
    Value,
    absolute,
    choose,
    difference,
    like,
    mean_slope,
    monotone,
    none_as_zero,
    sum_of,
    true_size,
)
from gainproof.derive.printer.step_text import formula


def input_value(grid: Grid, axis: int) -> Value:
    """One of the inputs, positive and exact."""
    low, high = grid.low[axis], grid.high[axis]
    size = tuple(rows(end, low, high, axis, grid.axes) for end in (low, high))
    slope = np.zeros(grid.low.shape)
    slope[axis] = 1.0
    return Value((size[0], size[1]), (slope, slope), np.ones(grid.count, np.int8))


def constant_value(constant: Constant, grid: Grid, form: Format) -> Value:
    """A constant, with the rounding that its nearest number costs."""
    count = grid.count
    least, most, sign, error = constant.size(form)
    shape = 1 + 2**grid.axes, count
    size = np.full(shape, least), np.full(shape, most)
    zeros = np.zeros(grid.low.shape)
    value = Value(size, (zeros, zeros), np.full(count, sign, np.int8))
    if not constant.is_exact(form):
        value.rounding = error * MARGIN
        value.drift = value.rounding
    return value


def affine_value(affine: AffineSum, grid: Grid, axis: int, unit: float) -> Value:
    """Constant plus scaled input: monotone, so that the boxes' ends enclose it and its slope."""
    places = grid.low[axis], grid.high[axis]
    ends = [affine.at(x) for x in places]
    low = np.minimum(ends[0][0], ends[1][0])
    high = np.maximum(ends[0][1], ends[1][1])
    sign: Signs = np.where(low >= 0, 1, -1).astype(np.int8)
    sign[(low == 0) & (high == 0)] = 0
    crossing = (low < 0) & (high > 0)
    sizes = [absolute(end) for end in ends]
    nearest = np.where(crossing, 0.0, np.minimum(sizes[0][0], sizes[1][0]))
    farthest = np.maximum(sizes[0][1], sizes[1][1])
    size = (
        rows(nearest, sizes[0][0], sizes[1][0], axis, grid.axes),
        rows(farthest, sizes[0][1], sizes[1][1], axis, grid.axes),
    )
    steep = []
    for x, end in zip(places, sizes, strict=True):
        scaled = x * abs(affine.factor)
        steep.append(interval.divide((scaled, scaled), end))
    least = np.minimum(steep[0][0], steep[1][0])
    most = np.maximum(steep[0][1], steep[1][1])
    falling = sign * affine.factor < 0
    slope = np.zeros(grid.low.shape), np.zeros(grid.low.shape)
    slope[0][axis], slope[1][axis] = (
        np.where(falling, -most, least),
        np.where(falling, -least, most),
    )
    value = Value(size, slope, sign, unit * affine.parts, unit * affine.parts)
    value.invalid = crossing if interval.somewhere(crossing) else None
    return value


GREATEST_DRIFT = 2.0**-8


class Forward:
    """Values of all steps of a program over a grid in one format.

    The caller holds ``numpy.errstate(all="ignore")``. PrintingError for a subtraction of computed
    values that is not named in `cancellations`.
    """

    def __init__(
        self, program: Program, grid: Grid, form: Format, cancellations: Collection[str] = ()
    ) -> None:
        self.program, self.grid, self.form = program, grid, form
        self.cancellations = cancellations
        self.count = grid.count
        self.unit = form.unit_roundoff * MARGIN
        self.least_normal = form.least_normal * LEAST_NORMAL
        self.least, self.largest = form.least, form.largest  # of which every step asks
        self.values: list[Value] = []
        self.cycles = Cycles(program, self)
        for number, step in enumerate(program.steps):
            parts = [self.values[part] for part in step.operands]
            self.values.append(self.evaluated(number, parts))

    def evaluated(self, number: int, parts: list[Value]) -> Value:
        """The value of a step whose operands have these values."""
        value = self.cycles.value(number, parts)
        if value is None:
            value = self._value(number, parts)
        self.cycles.set_drift(number, value, parts)
        return self._finished(number, value)

    def _value(self, number: int, parts: list[Value]) -> Value:
        step = self.program.steps[number]
        if any(part.loose for part in parts[-1:]) and step.operation in ("div", "sqrt"):
            raise PrintingError(f"{self._name(number)}: {step.operation} of a named cancellation")
        if step.scale is not None:
            return scaled(parts[0], step.scale)
        match step.operation:
            case "input":
                return input_value(self.grid, self.program.axis(number))
            case "constant":
                assert step.constant is not None
                return constant_value(step.constant, self.grid, self.form)
            case "add" | "sub":
                affine = affine_sum(self.program, number, self.form)
                if affine is not None:
                    axis = self.program.axis(affine.source)
                    value = affine_value(affine, self.grid, axis, self.unit)
                    return with_stray(value, [part.stray for part in parts], self.unit)
                return self._sum(number, step, parts)
            case "mul":
                return product(parts[0], parts[1], self.unit)
            case "div":
                return quotient(parts[0], parts[1], self.unit)
            case "sqrt":
                return root(parts[0], self.unit)
            case "neg" | "abs":
                sign = -parts[0].sign if step.operation == "neg" else np.abs(parts[0].sign)
                return like(parts[0], sign)
            case "select":
                return self._choice(step, parts)
        raise PrintingError(f"{self._name(number)}: unknown operation {step.operation}")

    def _finished(self, number: int, value: Value) -> Value:
        """Marks boxes where the step may leave the normal range."""
        step = self.program.steps[number]
        if (
            step.scale is None and step.operation != "constant"
        ):  # of these the ends are as they were
            monotone(value)
        high = value.size[1][0] * (1.0 + value.drift)
        if value.stray is not None:
            high = high + value.stray
        within = high <= self.largest
        if not interval.everywhere(within):
            value.over = ~within
        ordered = value.size[0][0] <= value.size[1][0]
        # what is not would be a fault of the ranges themselves: proves nothing
        if not interval.everywhere(ordered):
            empty = ~ordered
            value.invalid = empty if value.invalid is None else empty | value.invalid
        if value.drift > GREATEST_DRIFT and number not in self.cycles.rough:
            raise PrintingError(f"{self._name(number)}: too many roundings to bound")
        if step.operation in ("mul", "div", "sqrt") and (step.scale is None or step.scale < 1):
            low = value.size[0][0] / (1.0 + value.drift) - none_as_zero(value.stray)
            # a scaling has no rounding of its own that could stand for that of a subnormal result
            tiny = low < (self.least_normal if step.scale is None else self.form.least_normal)
            if interval.somewhere(tiny) and interval.somewhere(
                tiny := tiny & (value.size[1][0] > 0)
            ):
                # an error of half the least number, or of the value itself where that is smaller
                value.tiny = np.where(tiny, np.minimum(self.least, 2.0 * value.size[1][0]), 0.0)
                value.stray = value.tiny if value.stray is None else value.stray + value.tiny
        return value

    def _sum(self, number: int, step: Step, parts: list[Value]) -> Value:
        a, b = parts
        turned = -b.sign if step.operation == "sub" else b.sign
        opposite = a.sign * turned < 0
        loose = a.loose or b.loose or interval.somewhere(opposite)
        if loose and step.label not in self.cancellations:
            raise PrintingError(
                f"{self._name(number)}: a subtraction of computed values loses digits. Write it as "
                "sums, products, quotients and roots of positive terms, or name the difference and "
                "give the reason for it in the kernel's cancellations"
            )
        other_over_own = ratio(b, a, self.grid.width)
        own = interval.share(other_over_own)
        other = interval.share(interval.reciprocal(other_over_own))
        sign = np.where(a.sign == 0, turned, a.sign).astype(np.int8)
        value = Value(interval.add(a.size, b.size), mean_slope(own, a.slope, b.slope), sign)
        value.drift = sum_of(max(a.drift, b.drift), self.unit)
        value.rounding, value.shares, value.loose = self.unit, (own, other), loose
        if loose:
            value.true_size = difference(a, b, opposite)
        return with_stray(value, [a.stray, b.stray], self.unit)

    def _choice(self, step: Step, parts: list[Value]) -> Value:
        chosen = self.condition(step)
        x, y = parts[2:]
        value = Value(
            choose(chosen, x.size, y.size),
            choose(chosen, x.slope, y.slope),
            np.where(chosen, x.sign, y.sign),
            max(x.drift, y.drift),
        )
        value.chosen, value.loose = chosen, x.loose or y.loose
        if value.loose:
            value.true_size = choose(chosen, true_size(x), true_size(y))
        if x.stray is not None or y.stray is not None:
            value.stray = np.where(chosen, none_as_zero(x.stray), none_as_zero(y.stray))
        return value

    def condition(self, step: Step) -> Mask:
        """Where the first operand of a select step is less than the second, box by box."""
        limit = threshold(self.program, step, self.form)
        low = self.grid.low[self.program.axis(limit.source)]
        if limit.input_first:
            below: Mask = low < self.form.at_least(limit.place)
        else:
            below = self.form.at_most(limit.place) < low
        return below

    def _name(self, number: int) -> str:
        return formula(self.program, number)
