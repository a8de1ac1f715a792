"""The nominal point of a set of scans: where the fixed gains are exact."""

from __future__ import annotations

import numpy as np

from gainproof.tracking.gains import Point, exact_point, tracking_index
from gainproof.tracking.scans import Scans
from gainproof.tracking.settings import Settings


def nominal_point(scans: Scans, settings: Settings) -> Point:
    """Where the fixed gains are exact: at the nominal range the mean of the variances along and
    across the line of sight, which is that of x and y at a bearing of 45 degrees; the median
    deviations and interval.
    """
    polar = scans.polar
    if not polar.range.size:
        return exact_point(np.ones(2))
    far = settings.nominal_range or float(np.median(polar.range))
    along = float(np.median(polar.range_deviation))
    across = far * float(np.median(polar.bearing_deviation))
    variance = np.full(2, (along**2 + across**2) / 2)
    return exact_point(tracking_index(settings.acceleration, scans.interval, variance))
