"""The nominal point of a set of scans: where the fixed gains are exact."""

from __future__ import annotations

import numpy as np

from gainproof.tracking.arrays import Reals
from gainproof.tracking.conversion import CONVERSIONS
from gainproof.tracking.gains import Point, exact_point, tracking_index
from gainproof.tracking.measured import Polar
from gainproof.tracking.scans import Scans
from gainproof.tracking.settings import Settings

BEARING = np.pi / 4
"""Of nominal points, rad: x and y have the same variance there, the mean of those along and across
the line of sight.
"""


def nominal_point(scans: Scans, settings: Settings) -> Point:
    """Where the fixed gains are exact: at the nominal range and a bearing of 45 degrees, by the
    chosen conversion; the median deviations and interval.
    """
    polar = scans.polar
    if not polar.range.size:
        return exact_point(np.ones(2))
    far = settings.nominal_range or float(np.median(polar.range))
    deviations = (float(np.median(x)) for x in (polar.range_deviation, polar.bearing_deviation))
    given = diagonal(np.array([far]), *deviations)
    found = index_of(given, settings.acceleration, scans.interval, settings.conversion)
    return exact_point(found[0])


def diagonal(far: Reals, range_deviation: float, bearing_deviation: float) -> Polar:
    """Measurements at these ranges (m) and the nominal bearing."""
    wholes = (np.full_like(far, x) for x in (BEARING, range_deviation, bearing_deviation))
    return Polar(far, *wholes)


def index_of(polar: Polar, acceleration: float, interval: float, conversion: str) -> Reals:
    """(..., 2): the tracking index (18) of x and of y under a conversion's covariance.

    Of its variances alone: a nominal point, at a range that may be far from every detection, need
    have no covariance with digits enough to be inverted.
    """
    kernel = CONVERSIONS[conversion]
    north, east = kernel(
        polar.range, polar.bearing, polar.range_deviation, polar.bearing_deviation
    )[2:5:2]
    return tracking_index(acceleration, interval, np.stack([east, north], -1))
