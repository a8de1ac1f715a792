"""Boxes that cover a domain of the input, to its very ends, and their bisection."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from gainproof.derive.printer.affine import affine_sum
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.interval import Array, up
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.threshold import threshold
from gainproof.derive.printer.value import Grid

RATIO = 2.0**8  # of the first boxes' ends

Gap = tuple[float, float]
"""Neighbouring numbers of the format between which no box reaches."""


def special_points(program: Program, form: Format) -> list[Gap]:
    """Gaps at the zeros of exact differences and at the thresholds of select steps."""
    gaps: set[Gap] = set()
    for number, step in enumerate(program.steps):
        affine = affine_sum(program, number, form)
        if affine is not None and affine.crosses_zero():
            below, above = affine.zero(form)
            if below == above:
                gaps |= {(form.before(below), below), (below, form.after(below))}
            else:
                gaps.add((below, above))
        if step.operation == "select":
            limit = threshold(program, step, form)
            if limit.input_first:
                at = form.at_least(limit.place)
                gaps.add((form.before(at), at))
            else:
                at = form.at_most(limit.place)
                gaps.add((at, form.after(at)))
    return sorted(gaps)


def cover(lowest: float, highest: float, near: Iterable[Gap], plain: Iterable[Gap]) -> Grid:
    """Boxes over [lowest, highest] without the gaps; their ends crowd at the gaps in `near`."""
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
        points = _points(start, end, crowd_start, crowd_end)
        low += points[:-1] or points
        high += points[1:] or points
    return grid(np.array(low), np.array(high))


def _points(start: float, end: float, crowd_start: bool, crowd_end: bool) -> list[float]:
    points = {start, end}
    x = start
    while 0 < x < end / RATIO:
        x *= RATIO
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


def halves(boxes: Grid, form: Format) -> Grid:
    """Each box bisected, geometrically if it is wide; the two ends where nothing lies between."""
    low, high = boxes.low, boxes.high
    middle = np.where(high > 2.0 * low, np.sqrt(low) * np.sqrt(high), low + (high - low) / 2)
    after = np.array([form.after(x) for x in low.tolist()])
    only_ends = (after >= high) | (middle <= low) | (middle >= high)
    left_high = np.where(only_ends, low, middle)
    right_low = np.where(only_ends, high, middle)
    return grid(np.concatenate([low, right_low]), np.concatenate([left_high, high]))
