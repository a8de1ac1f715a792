"""How much each rounding weighs in each output: the reverse pass over all boxes.

With every operation written value (1 + delta), the mean value theorem gives
computed - exact = sum of delta_i * d output/d delta_i at a point between, where the terms are
A_i = node_i * d output/d node_i. These weights, over the scale of the output's error, are enclosed
for every possible rounding, so that nothing of second order is neglected. For a node used in
several places the contributions are added with their signs before the magnitude is taken.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.interval import Array, Interval
from gainproof.derive.printer.program import Step
from gainproof.derive.printer.ratio import ratio
from gainproof.derive.printer.rounding_weights import Weight
from gainproof.derive.printer.step_ranges import MARGIN, Value, none_as_zero, true_size
from gainproof.derive.printer.structural import measured_by_parts


class Adjoint:
    """Error bounds of all outputs over a forward pass.

    `ends` pairs each output's step with the step of its scale (the same step: relative error).
    `upper` bounds the error over the scale on the box, infinite where the box proves nothing;
    `lower` is what no refinement of the box can get below, to first order.
    """

    def __init__(self, forward: Forward, ends: Sequence[tuple[int, int]]) -> None:
        self.forward, self.values, self.ends = forward, forward.values, ends
        self.program = forward.program
        self.shape = (len(ends), forward.count)
        self.weights: dict[int, Weight] = {}
        self.upper, self.lower = np.zeros(self.shape), np.zeros(self.shape)
        self.any_tiny = any(value.tiny is not None for value in forward.values)
        for row, (output, scale) in enumerate(ends):
            self._start(row, output, scale)
        for number in range(len(self.program.steps) - 1, -1, -1):
            if number in self.weights:
                self._account(number)
                self._pass_on(number)
        self.upper *= interval.SLACK
        if any(value.loose for value in self.values):
            # weights of cancelled values are over exact sizes, rounded ones differ by the drift;
            # starts of fixed points, far from what they stand for, have no weight
            drift = max(self.values[number].drift for number in self.weights)
            self.upper *= 1.0 + 4.0 * len(self.values) * drift
        self.upper[~(self.upper >= self.lower)] = np.inf

    def sizes(self, number: int) -> Array:
        """The largest |share| of a step in each output, box by box."""
        return self.weights[number].magnitude(len(self.ends))

    def _start(self, row: int, output: int, scale: int) -> None:
        value, reference = self.values[output], self.values[scale]
        if output == scale and not value.loose:
            one: Interval = np.full(self.shape[1], 0.0), np.full(self.shape[1], 1.0)
            one[0][:] = 1.0 / (1.0 + value.drift)
        elif measured_by_parts(self.program, output, scale) and not reference.loose:
            # sizes of a named difference are those of the sum, which is the scale
            one = np.zeros(self.shape[1]), np.ones(self.shape[1])
        elif value.loose or reference.loose:
            (_, high), (low, _) = value.size, true_size(reference)
            one = np.zeros(self.shape[1]), np.fmin(interval.up(high[0] / low[0]), np.inf)
        else:
            one = ratio(value, reference, self.forward.grid.width)
        wide = (1.0 + value.drift) * interval.SLACK
        low, high = one[0] / interval.SLACK, one[1] * wide
        if value.loose:
            low = -high
        absolute = None
        if self.any_tiny:
            absolute = interval.up(1.0 / true_size(reference)[0][0])
            if value.stray is not None:
                # an absolute error of the output itself moves the ratio output/scale
                moved = interval.up(absolute * value.stray)
                low, high = low - moved, high + moved
            absolute = absolute[None]
        self._give(output, Weight((row,), (low[None], high[None]), None, absolute))

    def _give(self, number: int, new: Weight) -> None:
        if self.program.steps[number].operation in ("input", "start", "iterate"):
            return  # of an iterate only its distance counts, which its successor's rounding holds
        old = self.weights.get(number)
        self.weights[number] = new if old is None else old + new

    def _account(self, number: int) -> None:
        """Adds the step's own rounding to the bounds."""
        value, weight = self.values[number], self.weights[number]
        place = weight.place
        if value.rounding:
            most = interval.magnitude(weight.share) * value.rounding
            # an empty interval would be a fault of the bounds themselves: proves nothing
            ordered = weight.share[0] <= weight.share[1]
            if not interval.everywhere(ordered):
                most = np.where(ordered, most, np.inf)
            least = interval.mignitude(weight.share) * value.rounding
            self.upper[place] += weight.used(most)
            self.lower[place] += weight.used(least)
        if value.tiny is not None:
            assert weight.absolute is not None
            lost = interval.up(weight.absolute * value.tiny) / 2 * MARGIN
            self.upper[place] += np.where(weight.exposed(value.tiny > 0), lost, 0.0)
        for failed in (value.invalid, value.over):
            if failed is not None:
                self.upper[place] = np.where(weight.exposed(failed), np.inf, self.upper[place])

    def _pass_on(self, number: int) -> None:
        step, value, weight = self.program.steps[number], self.values[number], self.weights[number]
        share, absolute = weight.share, self._absolute(number)
        if value.tiny is not None and absolute is not None:
            lost = np.where(value.tiny > 0, interval.up(absolute * value.tiny), 0.0)
            share = interval.signed_add(share, (-lost, lost))
        for part, its_share, rate in self._parts(step, value, share):
            if self.values[part].loose or value.loose:
                bound = interval.magnitude(its_share)
                its_share = -bound, bound
            its = None
            if absolute is not None:
                its = weight.used(np.fmin(interval.up(absolute * rate), np.inf))
            self._give(part, Weight(weight.rows, its_share, weight.active, its))
        if step.operation == "select":
            assert value.chosen is not None
            for part, mask in ((step.operands[2], value.chosen), (step.operands[3], ~value.chosen)):
                kept = np.where(mask, share[0], 0.0), np.where(mask, share[1], 0.0)
                its = None if absolute is None else np.where(mask, absolute, 0.0)
                self._give(part, Weight(weight.rows, kept, weight.exposed(mask), its))

    def _parts(self, step: Step, value: Value, share: Interval) -> list[tuple[int, Interval, Any]]:
        """For each operand its step, its share, and a bound of |d step/d operand|."""
        parts = step.operands
        if step.scale is not None:
            return [(parts[0], share, step.scale)]
        match step.operation:
            case "add" | "sub" if value.shares is not None:
                weighed = (interval.signed_multiply(share, own) for own in value.shares)
                return [(part, own, 1.0) for part, own in zip(parts, weighed, strict=True)]
            case "add" | "sub":
                # operands are exact; only a scaled input that underflows has an error to pass
                lost = [part for part in parts if self.values[part].tiny is not None]
                whole = np.full_like(share[0], np.inf)
                return [(part, (-whole, whole), 1.0) for part in lost]
            case "less":
                assert value.shares is not None
                (own, other), (over, under) = value.shares, parts
                less = interval.signed_multiply((-share[1], -share[0]), other)
                return [(over, interval.signed_multiply(share, own), 1.0), (under, less, 1.0)]
            case "mul":
                (a, b), (size_a, size_b) = parts, (self._most(part) for part in parts)
                return [(a, share, size_b), (b, share, size_a)]
            case "div":
                over, under = parts
                low = self._least(under)
                turned = -share[1], -share[0]
                most = np.fmin(self._most_of(value) / low, np.inf)
                return [(over, share, interval.up(1.0 / low)), (under, turned, most)]
            case "sqrt":
                half = share[0] / 2, share[1] / 2
                return [(parts[0], half, interval.up(0.5 / self._least_of(value)))]
            case "neg" | "abs" | "root":
                return [(parts[0], share, 1.0)]
        return []

    def _absolute(self, number: int) -> Array | None:
        """The better of two bounds of |d output/d node|: handed down, or from the share."""
        weight = self.weights[number]
        if weight.absolute is None:
            return None
        by_share = interval.up(interval.magnitude(weight.share) / self._least(number))
        return np.fmin(weight.absolute, by_share * interval.SLACK)

    def _most(self, number: int) -> Array:
        return self._most_of(self.values[number])

    def _most_of(self, value: Value) -> Array:
        high = value.size[1][0] * ((1.0 + value.drift) * interval.SLACK)
        return interval.up(high + none_as_zero(value.stray))

    def _least(self, number: int) -> Array:
        return self._least_of(self.values[number])

    def _least_of(self, value: Value) -> Array:
        low = value.size[0][0] / ((1.0 + value.drift) * interval.SLACK)
        return interval.down(np.fmax(low - none_as_zero(value.stray), 0.0) + 0.0)
