"""Ranges of every step over many boxes of the input, exactly and under every possible rounding.

For each box: the magnitude's range, the sign, and the range of the logarithmic slope
d log|value| / d log(input): where it has one sign the range comes from the box's ends, and so does
that of the ratio of two steps whose slopes differ by one sign. `drift` E bounds what rounding does
to a step: computed/exact lies in [1/(1 + E), 1 + E], but for an absolute error of `stray` where an
operand may be subnormal or zero.
"""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.affine import AffineSum, affine_sum
from gainproof.derive.printer.constant import Constant
from gainproof.derive.printer.formats import FLOAT64, Format
from gainproof.derive.printer.interval import Array, Interval
from gainproof.derive.printer.program import Program, Step
from gainproof.derive.printer.threshold import threshold
from gainproof.derive.printer.value import (
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

# u is taken larger by this: covers 1/(1 - u), a result just below the least normal number,
# and errors of second order in the comparison of exact and computed values.
MARGIN = 1.0 + 2.0**-13
ABSORBED = 2.0**-60  # an absolute error this far below a sum joins its relative error


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
        self.count = len(grid.low)
        self.unit = form.unit_roundoff * MARGIN
        self.least_normal = form.least_normal * (1.0 - 2.0**-14)
        self.values: list[Value] = []
        for number in range(len(program.steps)):
            self.values.append(self._finished(number, self._value(number)))

    def _value(self, number: int) -> Value:
        step = self.program.steps[number]
        parts = [self.values[part] for part in step.operands]
        if any(part.loose for part in parts[-1:]) and step.operation in ("div", "sqrt"):
            raise PrintingError(f"{self._name(number)}: {step.operation} of a named cancellation")
        if step.scale is not None:
            return self._scaled(parts[0], step.scale)
        match step.operation:
            case "input":
                return self._input()
            case "constant":
                assert step.constant is not None
                return self._constant(step.constant)
            case "add" | "sub":
                affine = affine_sum(self.program, number, self.form)
                if affine is not None:
                    return self._affine(affine, parts)
                return self._sum(number, step, parts)
            case "mul":
                return self._product(*parts)
            case "div":
                return self._quotient(*parts)
            case "sqrt":
                return self._root(parts[0])
            case "neg" | "abs":
                sign = -parts[0].sign if step.operation == "neg" else np.abs(parts[0].sign)
                return like(parts[0], sign)
            case "select":
                return self._choice(step, parts)
        raise PrintingError(f"{self._name(number)}: unknown operation {step.operation}")

    def _finished(self, number: int, value: Value) -> Value:
        """Marks boxes where the step may leave the normal range."""
        monotone(value)
        high = value.size[1][0] * (1.0 + value.drift)
        if value.stray is not None:
            high = high + value.stray
        over = ~((high <= self.form.largest) & (value.size[0][0] <= value.size[1][0]))
        if over.any():
            value.over = over
        step = self.program.steps[number]
        if step.operation in ("mul", "div", "sqrt") and (step.scale is None or step.scale < 1):
            low = value.size[0][0] / (1.0 + value.drift)
            tiny = (low < self.least_normal) & (value.size[1][0] > 0)
            if tiny.any():
                # an error of half the least number, or of the value itself where that is smaller
                value.tiny = np.where(
                    tiny, np.minimum(self.form.least, 2.0 * value.size[1][0]), 0.0
                )
                value.stray = value.tiny if value.stray is None else value.stray + value.tiny
        return value

    def _input(self) -> Value:
        box, ones = self.grid, np.ones(self.count)
        size = np.stack([box.low, box.low, box.high]), np.stack([box.high, box.low, box.high])
        return Value(size, (ones, ones), np.ones(self.count, np.int8))

    def _constant(self, constant: Constant) -> Value:
        low, high = constant.between()
        sign = 0 if high == 0 else 1 if low > 0 else -1
        below, above = sorted((abs(low), abs(high)))
        size = (
            np.full((3, self.count), FLOAT64.at_most(below)),
            np.full((3, self.count), FLOAT64.at_least(above)),
        )
        zeros = np.zeros(self.count)
        value = Value(size, (zeros, zeros), np.full(self.count, sign, np.int8))
        if not constant.is_exact(self.form):
            nearest = Fraction(constant.nearest(self.form))
            error = max(abs(nearest - low), abs(nearest - high)) / below
            value.rounding = float(error) * MARGIN
            value.drift = value.rounding
        return value

    def _scaled(self, part: Value, power: float) -> Value:
        value = like(part, part.sign)
        value.size = interval.scale(part.size, power)
        if part.true_size is not None:
            value.true_size = interval.scale(part.true_size, power)
        if part.stray is not None:
            value.stray = part.stray * power
        return value

    def _affine(self, affine: AffineSum, parts: list[Value]) -> Value:
        ends = [affine.at(x) for x in (self.grid.low, self.grid.high)]
        low = np.minimum(ends[0][0], ends[1][0])
        high = np.maximum(ends[0][1], ends[1][1])
        sign: Signs = np.where(low >= 0, 1, -1).astype(np.int8)
        sign[(low == 0) & (high == 0)] = 0
        crossing = (low < 0) & (high > 0)
        sizes = [absolute(end) for end in ends]
        nearest = np.where(crossing, 0.0, np.minimum(sizes[0][0], sizes[1][0]))
        farthest = np.maximum(sizes[0][1], sizes[1][1])
        size = (
            np.stack([nearest, sizes[0][0], sizes[1][0]]),
            np.stack([farthest, sizes[0][1], sizes[1][1]]),
        )
        steep = []
        for x, end in zip((self.grid.low, self.grid.high), sizes, strict=True):
            scaled = x * abs(affine.factor)
            steep.append(interval.divide((scaled, scaled), end))
        slope_low = np.minimum(steep[0][0], steep[1][0])
        slope_high = np.maximum(steep[0][1], steep[1][1])
        falling = sign * affine.factor < 0
        slope = np.where(falling, -slope_high, slope_low), np.where(falling, -slope_low, slope_high)
        value = Value(size, slope, sign, self.unit * affine.parts, self.unit * affine.parts)
        value.invalid = crossing if crossing.any() else None
        return self._with_stray(value, [part.stray for part in parts])

    def _sum(self, number: int, step: Step, parts: list[Value]) -> Value:
        a, b = parts
        turned = -b.sign if step.operation == "sub" else b.sign
        opposite = a.sign * turned < 0
        loose = a.loose or b.loose or bool(opposite.any())
        if loose and step.label not in self.cancellations:
            raise PrintingError(
                f"{self._name(number)}: a subtraction of computed values loses digits. Write it as "
                "sums, products, quotients and roots of positive terms, or name the difference and "
                "give the reason for it in the kernel's cancellations"
            )
        ratio = self.ratio(b, a)
        own, other = interval.share(ratio), interval.share(interval.reciprocal(ratio))
        sign = np.where(a.sign == 0, turned, a.sign).astype(np.int8)
        value = Value(interval.add(a.size, b.size), mean_slope(own, a.slope, b.slope), sign)
        value.drift = sum_of(max(a.drift, b.drift), self.unit)
        value.rounding, value.shares, value.loose = self.unit, (own, other), loose
        if loose:
            value.true_size = difference(a, b, opposite)
        return self._with_stray(value, [a.stray, b.stray])

    def _with_stray(self, value: Value, strays: list[Array | None]) -> Value:
        """Absolute errors of the operands of a sum: part of its drift where it is much larger."""
        present = [stray for stray in strays if stray is not None]
        if present:
            total = sum(present[1:], present[0])
            absorbed = total <= ABSORBED * value.size[0][0]
            value.drift = sum_of(value.drift, 2.0 * ABSORBED)
            value.stray = None if absorbed.all() else np.where(absorbed, 0.0, total)
        return value

    def _product(self, a: Value, b: Value) -> Value:
        slope = interval.signed_add(a.slope, b.slope)
        value = Value(interval.multiply(a.size, b.size), slope, a.sign * b.sign)
        value.drift, value.rounding = sum_of(a.drift, b.drift, self.unit), self.unit
        value.loose = a.loose or b.loose
        if value.loose:
            value.true_size = interval.multiply(true_size(a), true_size(b))
        if a.stray is not None or b.stray is not None:
            lost_a, lost_b = none_as_zero(a.stray), none_as_zero(b.stray)
            crossed = lost_a * b.size[1][0] + lost_b * a.size[1][0] + lost_a * lost_b
            value.stray = np.fmin(4.0 * crossed, np.inf)
        return value

    def _quotient(self, a: Value, b: Value) -> Value:
        slope = interval.signed_add(a.slope, (-b.slope[1], -b.slope[0]))
        value = Value(interval.divide(a.size, b.size), slope, a.sign * b.sign)
        value.drift, value.rounding = sum_of(a.drift, b.drift, self.unit), self.unit
        value.loose = a.loose
        if value.loose:
            value.true_size = interval.divide(true_size(a), b.size)
        if a.stray is not None:
            value.stray = np.fmin(4.0 * a.stray / b.size[0][0], np.inf)
        if b.stray is not None:
            value.invalid = b.stray > 0
        return value

    def _root(self, part: Value) -> Value:
        value = Value(
            interval.square_root(part.size), (part.slope[0] / 2, part.slope[1] / 2), part.sign
        )
        value.drift, value.rounding = sum_of(part.drift, self.unit), self.unit
        wrong = part.sign < 0
        if part.stray is not None:
            wrong = wrong | (part.stray > 0)
        value.invalid = wrong if wrong.any() else None
        return value

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
        points = self.grid.low * limit.factor
        return points < limit.value if limit.input_first else limit.value < points

    def ratio(self, a: Value, b: Value) -> Interval:
        """a/b over each box, under every possible rounding."""
        wide = (1.0 + sum_of(a.drift, b.drift)) * interval.SLACK
        least = np.nextafter(a.slope[0] - b.slope[1], -np.inf)
        most = np.nextafter(a.slope[1] - b.slope[0], np.inf)
        low, high = interval.divide(a.size, b.size)
        factor = interval.spread(np.maximum(-least, most), self.grid.width)
        rises, falls = least >= 0, most <= 0
        from_ends = np.maximum(low[1], low[2]) / factor, np.minimum(high[1], high[2]) * factor
        low = np.where(rises, low[1], np.where(falls, low[2], np.fmax(low[0], from_ends[0])))
        high = np.where(rises, high[2], np.where(falls, high[1], np.fmin(high[0], from_ends[1])))
        low, high = low / wide, high * wide
        if a.stray is not None or b.stray is not None:
            # (a +- lost)/(b +- lost) from the tight a/b, b at its least
            lost_a, lost_b = none_as_zero(a.stray) * wide, none_as_zero(b.stray) * wide
            least_b = b.size[0][0] / wide
            above, below = least_b + lost_b, np.fmax(least_b - lost_b, 0.0)
            most_b = b.size[1][0] * wide + lost_b
            plain_low = np.fmax(a.size[0][0] / wide - lost_a, 0.0) / most_b / wide
            plain_high = (a.size[1][0] * wide + lost_a) / below * wide
            lost = (lost_a > 0) | (lost_b > 0)
            tight_low = low * (least_b / above) - lost_a / above * wide
            tight_high = high * (least_b / below) + lost_a / below * wide
            low = np.where(lost, np.fmax(tight_low / wide, plain_low), low)
            high = np.where(lost, np.fmin(tight_high * wide, plain_high), high)
        return np.fmax(interval.down(low), 0.0), np.fmin(interval.up(high), np.inf)

    def _name(self, number: int) -> str:
        step = self.program.steps[number]
        return f"node {step.node}" + (f" ({step.label})" if step.label else "")
