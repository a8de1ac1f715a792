"""What the printed arithmetic gives everywhere: never NaN, and no normal number where none is due.

IEEE operations are monotone in each operand, rounding, overflow and underflow included. So the
format's own arithmetic on the ends of a range encloses every computed value.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.derive.printer import boxes, interval
from gainproof.derive.printer.affine import affine_sum
from gainproof.derive.printer.fixed_point_enclosure import failed
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.program import Step
from gainproof.derive.printer.step_ranges import Box, Grid, Mask, PrintingError, Value

Floats = NDArray[Any]

ROUNDS = 12
GREATEST_COUNT = 40_000  # of boxes still uncertain after a round
ENOUGH = 64  # boxes of a round: NumPy takes hardly longer for these than for one


class Behaviour:
    """Ranges of the computed magnitudes of every step, and where NaN cannot be excluded.

    The caller holds ``numpy.errstate(all="ignore")``.
    """

    def __init__(self, forward: Forward) -> None:
        self.forward, self.program = forward, forward.program
        self.kind: type[Any] = np.float64 if forward.form is FLOAT64 else np.float32
        self.low: list[Floats] = []
        self.high: list[Floats] = []
        self.lost: list[Mask] = []
        for number, step in enumerate(self.program.steps):
            low, high, lost = self._range(number, step)
            for part in step.operands if step.operation != "select" else ():
                lost = lost | self.lost[part]
            self.low.append(low)
            self.high.append(high)
            self.lost.append(lost)

    def _rounded(self, x: Array, direction: float) -> Floats:
        """The format's numbers just inside or outside an end of a box."""
        value = x.astype(self.kind)
        wrong = value > x if direction < 0 else value < x
        return np.where(wrong, np.nextafter(value, self.kind(direction)), value)

    def _range(self, number: int, step: Step) -> tuple[Floats, Floats, Mask]:
        grid, value = self.forward.grid, self.forward.values[number]
        lows, highs = [self.low[i] for i in step.operands], [self.high[i] for i in step.operands]
        fine = np.zeros(self.forward.count, np.bool_)
        if step.scale is not None:
            return lows[0] * self.kind(step.scale), highs[0] * self.kind(step.scale), fine
        match step.operation:
            case "near_cbrt" | "less" | "start" | "iterate" | "root":
                return self._proved(value)
            case "input":
                axis = self.program.axis(number)
                low, high = grid.low[axis], grid.high[axis]
                return self._rounded(low, -np.inf), self._rounded(high, np.inf), fine
            case "constant":
                assert step.constant is not None
                size = np.full(
                    self.forward.count, abs(step.constant.nearest(self.forward.form)), self.kind
                )
                return size, size, fine
            case "add" | "sub":
                return self._sum(number, lows, highs)
            case "mul":
                lost = (lows[0] == 0) & np.isinf(highs[1]) | (lows[1] == 0) & np.isinf(highs[0])
                return np.fmax(lows[0] * lows[1], 0), np.fmin(highs[0] * highs[1], np.inf), lost
            case "div":
                lost = (lows[0] == 0) & (lows[1] == 0) | np.isinf(highs[0]) & np.isinf(highs[1])
                low, high = lows[0] / highs[1], highs[0] / lows[1]
                return np.fmax(low, 0), np.fmin(high, np.inf), lost
            case "sqrt":
                return np.sqrt(lows[0]), np.sqrt(highs[0]), value.sign < 0
            case "select":
                assert value.chosen is not None
                lost = np.where(
                    value.chosen, self.lost[step.operands[2]], self.lost[step.operands[3]]
                )
                return (
                    np.where(value.chosen, lows[2], lows[3]),
                    np.where(value.chosen, highs[2], highs[3]),
                    lost,
                )
        return lows[0], highs[0], fine

    def _proved(self, value: Value) -> tuple[Floats, Floats, Mask]:
        """What the forward pass proves of a step of a fixed point, where it proves anything."""
        wide = (1.0 + value.drift) * interval.SLACK
        low, high = value.size[0][0] / wide, value.size[1][0] * wide
        return self._rounded(low, -np.inf), self._rounded(high, np.inf), failed(value)

    def _sum(
        self, number: int, lows: list[Floats], highs: list[Floats]
    ) -> tuple[Floats, Floats, Mask]:
        value = self.forward.values[number]
        if value.shares is not None and not value.loose:
            return lows[0] + lows[1], highs[0] + highs[1], np.zeros(len(lows[0]), np.bool_)
        if value.loose:
            return highs[0] * 0, highs[0] + highs[1], np.isinf(highs[0]) & np.isinf(highs[1])
        affine = affine_sum(self.program, number, self.forward.form)
        assert affine is not None
        high_part = self.kind(affine.sign * affine.constant.nearest(self.forward.form))
        rest = self.kind(affine.sign * affine.constant.remainder(self.forward.form))
        source = affine.source
        ends = [
            np.abs((high_part + end * self.kind(affine.factor)) + rest)
            for end in (self.low[source], self.high[source])
        ]
        return np.minimum(*ends), np.maximum(*ends), np.isnan(ends[0]) | np.isnan(ends[1])

    def settle_overflow(self) -> None:
        """Clears the marks of overflow where no computed value is infinite."""
        for number, value in enumerate(self.forward.values):
            if value.over is not None:
                value.over &= np.isinf(self.high[number])


def exclude_nan(
    forward: Forward,
    again: Callable[[Grid], Forward],
    ends: Sequence[tuple[int, int]],
    domains: Sequence[Box],
) -> None:
    """PrintingError unless no output can be NaN, nor normal where the true value is not.

    `ends` pairs outputs with their scales, `domains` are the boxes where these are normal;
    `again` makes the forward pass over finer boxes.
    """
    grid, form = forward.grid, forward.form
    bad = _uncertain(Behaviour(forward), ends, domains)
    for turn in range(ROUNDS):
        if not bad.any():
            return
        grid = boxes.grid(grid.low[:, bad], grid.high[:, bad])
        finer = boxes.halves(boxes.halves(grid, form), form)
        while finer.count < ENOUGH:
            finer = boxes.halves(finer, form)
        # one pass over a point of each box and its parts: few boxes cost as much as many
        points = boxes.grid(grid.low, grid.low)
        forward = again(boxes.joined(points, finer))
        found = _uncertain(Behaviour(forward), ends, domains)
        worse, bad = found[: points.count], found[points.count :]
        if worse.any() or turn == ROUNDS - 1 or grid.count > GREATEST_COUNT:
            box = int(worse.argmax())
            point = boxes.point_text(grid, box)
            if forward.cycles.complaint(box):
                raise PrintingError(f"input {point}: {forward.cycles.complaint(box)}")
            raise PrintingError(
                f"input {point}: NaN, or a normal number where the true value is none, cannot be "
                "excluded; another order of operations may avoid an over- or underflow"
            )
        grid = finer


def _uncertain(
    behaviour: Behaviour,
    ends: Sequence[tuple[int, int]],
    domains: Sequence[Box],
) -> Mask:
    """Boxes where an output may be NaN, or normal outside its domain."""
    grid, form = behaviour.forward.grid, behaviour.forward.form
    bad = np.zeros(grid.count, np.bool_)
    for (output, scale), domain in zip(ends, domains, strict=True):
        bad |= behaviour.lost[output]
        if output == scale:
            outside = boxes.outside(grid, domain)
            vanishing = behaviour.high[output] <= 4.0 * form.least_normal
            vast = behaviour.low[output] >= form.largest / 4.0
            bad |= outside & ~(vanishing | vast)
    return bad
