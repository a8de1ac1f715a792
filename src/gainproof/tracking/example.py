"""Example detections: four targets, false alarms, missed detections and an empty scan, seeded.

The noise and the interval are the source's; the targets are ours.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from gainproof.files import named_files
from gainproof.tracking.arrays import Reals

FILE = "detections.csv"
SEED = 8
SCANS, INTERVAL = 40, 5.0
RANGE_DEVIATION, BEARING_DEVIATION = 50.0, 1.0
"""m and degrees, the source's."""
DETECTED = 0.95
FALSE_ALARMS = 0.8
"""On average in a scan, within the farthest range."""
FARTHEST = 40e3
EMPTY = 17
"""A scan in which the radar saw nothing."""
RADIUS, RATE = 10e3, 0.01
"""m, rad/s: of the circle that the turning target flies."""


def truth(time: float) -> Reals:
    """(4, 2): where the targets are, m east and north of the radar: one comes straight in, one
    crosses its path, one turns, one appears after 60 s and flies away.
    """
    angle = RATE * time
    turning = (18e3 - RADIUS * np.cos(angle), -14e3 + RADIUS * np.sin(angle))
    away = (-6e3 - 110.0 * (time - 60), -5e3 - 90.0 * (time - 60)) if time >= 60 else (np.nan,) * 2
    return np.array(
        [
            (12e3 - 60.0 * time, 36e3 - 150.0 * time),
            (-14e3 + 120.0 * time, 22e3 - 20.0 * time),
            turning,
            away,
        ]
    )


def lines() -> list[str]:
    """Those of the file."""
    draw = np.random.default_rng(SEED)
    found = ["time [s],range [km],bearing [deg],sigma_range [m],sigma_bearing [deg]"]
    for scan in range(SCANS):
        time = scan * INTERVAL
        east, north = truth(time).T
        far, bearing = np.hypot(east, north), np.rad2deg(np.arctan2(east, north))
        noise = draw.standard_normal((2, len(far)))
        far = far + RANGE_DEVIATION * noise[0]
        bearing = bearing + BEARING_DEVIATION * noise[1]
        seen = (draw.random(len(far)) < DETECTED) & np.isfinite(far)
        alarms = draw.poisson(FALSE_ALARMS)
        far = np.append(far[seen], FARTHEST * np.sqrt(draw.uniform(0.01, 1, alarms)))
        bearing = np.append(bearing[seen], draw.uniform(-180, 180, alarms))
        if scan == EMPTY or not far.size:
            found.append(f"{time:g},,,,")
            continue
        found += [
            f"{time:g},{far[i] / 1e3:.4f},{bearing[i] % 360:.3f},"
            f"{RANGE_DEVIATION:g},{BEARING_DEVIATION:g}"
            for i in np.argsort(far)
        ]
    return found


def write_example(folder: Path) -> Path:
    """detections.csv in the folder, made as needed. Raises BadInputError, also where it exists."""
    path = folder / FILE
    named_files.require_new([path])
    named_files.write({path: ("\n".join(lines()) + "\n").encode()})
    return path
