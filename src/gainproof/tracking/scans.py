"""Scans of a radar: detections in the order of time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from gainproof.tracking.arrays import Ints, Reals
from gainproof.tracking.measured import Polar

MOST_TIME = 1e11
"""s, of either sign: Unix time is taken; only differences enter."""
LEAST_INTERVAL = 1e-6
LEAST_LENGTH, MOST_RANGE = 1e-9, 1e12
FULL_TURN = 2 * np.pi
LEAST_BEARING_DEVIATION, MOST_BEARING_DEVIATION = 1e-9, 2.0
"""rad: the conversions' kernels take no more."""


@dataclass(frozen=True)
class Scans:
    """times: (s,), s, rising; an empty scan has one too. first: (s + 1,), the place of each scan's
    first detection. polar: all detections, those of a scan in the order of range and bearing.
    row: (n,), the place that each had when it was handed in.
    """

    times: Reals
    first: Ints
    polar: Polar
    row: Ints

    def __iter__(self) -> Iterator[tuple[float, slice]]:
        """Each scan's time and the places of its detections."""
        ends = self.first.tolist()
        for time, start, end in zip(self.times.tolist(), ends[:-1], ends[1:], strict=True):
            yield time, slice(start, end)

    @property
    def interval(self) -> float:
        """The median of the times between scans, s; 1 where there is one scan only."""
        return float(np.median(np.diff(self.times))) if len(self.times) > 1 else 1.0


class DetectionError(ValueError):
    """A detection that cannot be used: `row` is its place, `field` which of its numbers."""

    def __init__(self, message: str, row: int, field: str) -> None:
        super().__init__(message)
        self.row, self.field = row, field


def scans(
    time: ArrayLike,
    measured_range: ArrayLike,
    bearing: ArrayLike,
    range_deviation: ArrayLike,
    bearing_deviation: ArrayLike,
    empty: ArrayLike = (),
) -> Scans:
    """Detections as a radar gives them: those of one time are a scan.

    time in s, in order; range in m, bearing in rad from north, clockwise; arrays (n,), deviations
    may be single numbers. empty: times of scans without a detection, anywhere in any order.

    Raises DetectionError, which knows row and field: numbers that are not finite, ranges and
    deviations not above 0, a bearing beyond one turn, a bearing's deviation beyond 2 rad, a time
    before the one of the row above, the same detection twice.
    """
    t, r, b = (np.array(x, np.float64, ndmin=1) for x in (time, measured_range, bearing))
    sigmas = (
        np.array(np.broadcast_to(np.asarray(x, np.float64), t.shape))
        for x in (range_deviation, bearing_deviation)
    )
    polar = Polar(r, b, *sigmas)
    if not t.shape == r.shape == b.shape or t.ndim != 1:
        raise ValueError(f"wanted arrays of one length, got {t.shape}, {r.shape} and {b.shape}")
    nothing = np.unique(np.array(empty, np.float64))
    _require(t, polar)
    _require_times(nothing, "empty")
    if back := np.flatnonzero(np.diff(t) < 0).tolist():
        row = back[0] + 1
        message = f"wanted times in order, got {t[row]:.17g} s after {t[row - 1]:.17g} s"
        raise DetectionError(message, row, "time")
    order = np.lexsort((polar.bearing_deviation, polar.range_deviation, b, r, t))
    t, polar = t[order], polar.part(order)
    same = (np.diff(t) == 0) & (np.diff(polar.range) == 0) & (np.diff(polar.bearing) == 0)
    if same.any():
        pair = order[np.flatnonzero(same)[0] : np.flatnonzero(same)[0] + 2]
        row, other = int(pair.max()), int(pair.min())
        raise TwiceError("the same detection twice", row, other)
    times = np.union1d(t, nothing)
    close = np.flatnonzero(np.diff(times) < LEAST_INTERVAL)
    if close.size:
        later = times[close[0] + 1]
        row = int(order[np.searchsorted(t, later)]) if later in t else 0
        message = f"scans are at least {LEAST_INTERVAL:g} s apart, got {np.diff(times)[close[0]]!s}"
        raise DetectionError(message, row, "time")
    first = np.append(np.searchsorted(t, times, "left"), len(t))
    return Scans(times, first, polar, order)


LIMITS = {
    "range": (LEAST_LENGTH, MOST_RANGE, "m"),
    "sigma_range": (LEAST_LENGTH, MOST_RANGE, "m"),
    "sigma_bearing": (LEAST_BEARING_DEVIATION, MOST_BEARING_DEVIATION, "rad"),
}
"""Least, most and unit."""


def wanted(field: str, unit: str, size: float) -> str:
    """The limits of a field in a unit of this size."""
    least, most, _ = LIMITS[field]
    return f"a number from {least / size:.5g} to {most / size:.5g} {unit}"


class OutsideError(DetectionError):
    """A number outside its limits: `value` in m or rad."""

    def __init__(self, value: float, row: int, field: str, unit: str) -> None:
        self.value = value
        super().__init__(self.told(field, unit, 1.0), row, field)

    def told(self, field: str, unit: str, size: float) -> str:
        """What is wrong, in a unit of this size."""
        return f"wanted {wanted(field, unit, size)}, got {self.value / size:.10g}"


class TwiceError(DetectionError):
    """A detection that stands twice: `other` is the row where it came first."""

    def __init__(self, message: str, row: int, other: int) -> None:
        super().__init__(message, row, "range")
        self.other = other


def _require(t: Reals, polar: Polar) -> None:
    _require_times(t, "time")
    checks = (
        ("range", polar.range),
        ("sigma_range", polar.range_deviation),
        ("sigma_bearing", polar.bearing_deviation),
    )
    for name, values in checks:
        least, most, unit = LIMITS[name]
        fine = (values >= least) & (values <= most)
        if not fine.all():
            row = int(np.argmin(fine))
            raise OutsideError(float(values[row]), row, name, unit)
    fine = np.abs(polar.bearing) <= FULL_TURN
    if not fine.all():
        row = int(np.argmin(fine))
        message = f"wanted a bearing within one turn, got {polar.bearing[row]!s} rad"
        raise DetectionError(message, row, "bearing")
    # what the kernels take for no angle at all
    polar.bearing[np.abs(polar.bearing) < 1e-20] = 0.0


def _require_times(times: Reals, field: str) -> None:
    fine = np.abs(times) <= MOST_TIME
    if not fine.all():
        row = int(np.argmin(fine))
        message = f"wanted a time of magnitude up to {MOST_TIME:g} s, got {times[row]!s}"
        raise DetectionError(message, row, field)
