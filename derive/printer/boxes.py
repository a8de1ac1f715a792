"""Boxes that cover a domain of the inputs, to its very ends, and their bisection."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from gainproof.derive.printer.affine import affine_sum
from gainproof.derive.printer.formats import FLOAT64, Format
from gainproof.derive.printer.interval import Array, up
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.select_conditions import threshold
from gainproof.derive.printer.step_ranges import Box, Grid, Mask

RATIO = 2.0**8  # of the first boxes' ends

Gap = tuple[float, float]
"""Neighbouring numbers of the format between which no box reaches."""

Gaps = Sequence[Sequence[Gap]]
"""The gaps along each input."""


def special_points(program: Program, form: Format) -> list[list[Gap]]:
    """Gaps at the zeros of exact differences and at the thresholds of select steps."""
    found: list[set[Gap]] = [set() for _ in program.inputs]
    for number, step in enumerate(program.steps):
        affine = affine_sum(program, number, form)
        if affine is not None and affine.crosses_zero():
            below, above = affine.zero(form)
            gaps = found[program.axis(affine.source)]
            if below == above:
                gaps |= {(form.before(below), below), (below, form.after(below))}
            else:
                gaps.add((below, above))
        if step.operation == "select":
            limit = threshold(program, step, form)
            gaps = found[program.axis(limit.source)]
            if limit.input_first:
                at = form.at_least(limit.place)
                gaps.add((form.before(at), at))
            else:
                at = form.at_most(limit.place)
                gaps.add((at, form.after(at)))
    return [sorted(gaps) for gaps in found]


def cover(domain: Box, near: Gaps, plain: Gaps, ratio: float = RATIO) -> Grid:
    """Boxes over the domain without the gaps; their ends crowd at the gaps in `near`."""
    axes = [
        _axis(*ends, crowded, bare, ratio)
        for ends, crowded, bare in zip(domain, near, plain, strict=True)
    ]
    places = np.indices([len(low) for low, _ in axes]).reshape(len(axes), -1)
    low, high = (
        np.stack([ends[side][place] for ends, place in zip(axes, places, strict=True)])
        for side in (0, 1)
    )
    return grid(low, high)


def _axis(
    lowest: float, highest: float, near: Iterable[Gap], plain: Iterable[Gap], ratio: float
) -> tuple[Array, Array]:
    cuts = dict.fromkeys(near, True)
    cuts |= {gap: False for gap in plain if gap not in cuts}
    inner = sorted(gap for gap in cuts if lowest <= gap[0] and gap[1] <= highest)
    starts = [(lowest, False)] + [(gap[1], cuts[gap]) for gap in inner]
    ends = [(gap[0], cuts[gap]) for gap in inner] + [(highest, False)]
    low: list[float] = []
    high: list[float] = []
    for (start, crowd_start), (end, crowd_end) in zip(starts, ends, strict=True):
        if start > end:
            continue
        points = _points(start, end, crowd_start, crowd_end, ratio)
        low += points[:-1] or points
        high += points[1:] or points
    return np.array(low), np.array(high)


def _points(
    start: float, end: float, crowd_start: bool, crowd_end: bool, ratio: float
) -> list[float]:
    points = {start, end}
    x = start
    while 0 < x < end / ratio:
        x *= ratio
        points.add(x)
    for k in range(1, 53):
        if crowd_start:
            points.add(start * (1.0 + 2.0**-k))
        if crowd_end:
            points.add(end * (1.0 - 2.0**-k))
    return sorted(point for point in points if start <= point <= end)


def grid(low: Array, high: Array) -> Grid:
    """The boxes with their widths."""
    ratio = np.where(low == high, 1.0, up(high / np.maximum(low, 5e-324)))
    return Grid(low, high, np.where(low == high, 0.0, up(ratio - 1.0)))


def joined(first: Grid, second: Grid) -> Grid:
    """The boxes of both, one after another."""
    pairs = zip(vars(first).values(), vars(second).values(), strict=True)
    return Grid(*(np.concatenate(pair, axis=1) for pair in pairs))


def halves(boxes: Grid, form: Format, axis: NDArray[np.intp] | None = None) -> Grid:
    """Each box bisected along one input (if none is said its widest), geometrically if it is wide;
    the two ends where nothing lies between.
    """
    chosen = np.argmax(boxes.width, axis=0) if axis is None else axis
    place = chosen, np.arange(boxes.count)
    low, high = boxes.low[place], boxes.high[place]
    middle = np.where(high > 2.0 * low, np.sqrt(low) * np.sqrt(high), low + (high - low) / 2)
    only_ends = (_after(low, form) >= high) | (middle <= low) | (middle >= high)
    left_high, right_low = boxes.high.copy(), boxes.low.copy()
    left_high[place] = np.where(only_ends, low, middle)
    right_low[place] = np.where(only_ends, high, middle)
    return grid(
        np.concatenate([boxes.low, right_low], axis=1),
        np.concatenate([left_high, boxes.high], axis=1),
    )


def _after(x: Array, form: Format) -> Array:
    """The next numbers of the format."""
    if form is FLOAT64:
        return np.nextafter(x, np.inf)
    near = x.astype(np.float32)
    return np.where(near <= x, np.nextafter(near, np.float32(np.inf)), near).astype(np.float64)


def outside(boxes: Grid, domain: Box) -> Mask:
    """Which boxes lie wholly outside a domain."""
    low, high = np.array(domain).T[:, :, None]
    found: Mask = ((boxes.low > high) | (boxes.high < low)).any(axis=0)
    return found


def inside(boxes: Grid, domain: Box) -> Mask:
    """Which boxes lie wholly inside a domain."""
    low, high = np.array(domain).T[:, :, None]
    found: Mask = ((boxes.low >= low) & (boxes.high <= high)).all(axis=0)
    return found


def point_text(boxes: Grid, box: int) -> str:
    """The first point of a box in words."""
    numbers = boxes.low[:, box].tolist()
    return repr(numbers[0]) if len(numbers) == 1 else repr(tuple(numbers))
