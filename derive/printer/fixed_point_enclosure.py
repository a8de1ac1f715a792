"""A fixed point over boxes, enclosed from its start and by the map itself."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.interval import Interval
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.ratio import ratio
from gainproof.derive.printer.step_ranges import Mask, Value

if TYPE_CHECKING:
    from gainproof.derive.printer.forward import Forward

NARROWINGS = 12  # of an enclosure by the map, each to a quarter where the slope is 1/4
NO_GAIN = 2.0**-16  # of the ends of an enclosure: a narrowing that brings less is the last
UP = 1.0 + 2.0**-40  # more than a few roundings


@dataclass(frozen=True)
class Chain:
    """The steps that lead from an iterate to a step that holds it; what else they need is older."""

    source: int
    numbers: tuple[int, ...]

    def followed(self, forward: Forward, at: Value) -> tuple[Value, Mask]:
        """The last step's value, were the iterate `at`; and where it proves nothing."""
        local: dict[int, Value] = {self.source: at}
        bad = np.zeros(forward.grid.count, np.bool_)
        for number in self.numbers:
            operands = forward.program.steps[number].operands
            parts = [local[part] if part in local else forward.values[part] for part in operands]
            local[number] = forward.evaluated(number, parts)
            bad |= failed(local[number])
        value = local[self.numbers[-1]]
        return value, bad | (value.sign <= 0)


def chain(program: Program, source: int, end: int) -> Chain:
    """The steps from one to another."""
    needed = {end}
    for number in range(end, source, -1):
        if number in needed:
            needed.update(program.steps[number].operands)
    found = [source]
    for number in range(source + 1, end + 1):
        if number in needed and any(part in found for part in program.steps[number].operands):
            found.append(number)
    return Chain(source, tuple(found[1:]))


def failed(value: Value) -> Mask:
    """Where a step proves nothing or may overflow."""
    found = np.zeros(len(value.sign), np.bool_)
    for mask in (value.invalid, value.over):
        if mask is not None:
            found |= mask
    return found


def astray(value: Value) -> Mask:
    """Where a step has an absolute error beside its relative one."""
    if value.stray is None:
        return np.zeros(len(value.sign), np.bool_)
    mask: Mask = value.stray > 0
    return mask


def enclosed(
    forward: Forward, image: Chain, slope: float, start: Value, known: Fraction | None = None
) -> tuple[Value, Interval]:
    """The fixed point with its slopes, and an enclosure of its ratio to the start's exact value.

    `known` is a factor within which the start is known to lie, whatever the inputs.

    The start x encloses the fixed point X by (2) of `newton`: log(X/x) lies between log(g(x)/x) and
    that over 1 - K. Its slope by an input is that of the map with x held, over 1 - k. The map of an
    enclosure, of the slope too, is another.
    """
    start = Value(start.size, start.slope, start.sign)
    value, bad = image.followed(forward, start)
    power = np.full(forward.grid.count, 1.0 / (1.0 - slope) * UP)
    factor = _powers(ratio(value, start, forward.grid.width), power)
    if known is not None:
        most = np.full(forward.grid.count, float(known) * UP)
        factor = _both(factor, (1.0 / most / UP, most))
    size = interval.multiply(start.size, factor)
    # held: the same range at every corner, or slopes would be read from a number that moves
    held = np.broadcast_to(size[0][0], size[0].shape), np.broadcast_to(size[1][0], size[1].shape)
    still = start.slope[0] * 0.0, start.slope[1] * 0.0
    low, high = image.followed(forward, Value(held, still, start.sign))[0].slope
    root = Value(size, (np.fmin(low, low * power[0]), np.fmax(high, high * power[0])), start.sign)
    for _ in range(NARROWINGS):
        value, again = image.followed(forward, root)
        bad |= again
        before = root
        root = replace(root, size=_both(root.size, value.size))
        root.slope = _both(root.slope, value.slope)
        if _same(before, root):
            break
    root.invalid = bad
    found = ratio(root, start, forward.grid.width)
    return root, found if known is None else _both(found, factor)


def _powers(t: Interval, power: interval.Array) -> Interval:
    """Between t and t^power, for a power of at least 1."""
    low, high = t[0] / UP, t[1] * UP
    below = interval.spread(power, np.maximum(1.0 / low - 1.0, 0.0) * UP)
    above = interval.spread(power, np.maximum(high - 1.0, 0.0) * UP)
    least = np.where(low < 1.0, 1.0 / below, low) / UP
    most = np.where(high > 1.0, above, high) * UP
    return np.fmax(least, 0.0), np.fmin(most, np.inf)


def _both(a: Interval, b: Interval) -> Interval:
    """What lies in both."""
    return np.fmax(a[0], b[0]), np.fmin(a[1], b[1])


def _same(before: Value, after: Value) -> bool:
    """Whether a narrowing brought nothing to speak of, neither to the sizes nor to the slopes."""
    (low, high), (lower, higher) = before.size, after.size
    near = (lower <= low * (1.0 + NO_GAIN)) & (high <= higher * (1.0 + NO_GAIN))
    near |= (low == lower) & (high == higher)
    moved = (np.abs(x - y) for x, y in zip(before.slope, after.slope, strict=True))
    return interval.everywhere(near) and all(interval.everywhere(each <= NO_GAIN) for each in moved)
