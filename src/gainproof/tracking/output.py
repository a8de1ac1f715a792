"""Every detection with its track, as CSV and as plain data."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from gainproof.tracking.files import FromFile
from gainproof.tracking.settings import Settings
from gainproof.tracking.summary import Course
from gainproof.tracking.time_text import time_text
from gainproof.tracking.tracker import Followed

UNASSIGNED = "unassigned"
STATE = ("x [m]", "vx [m/s]", "y [m]", "vy [m/s]")
HEADING = (
    "line",
    "time [s]",
    "range [m]",
    "bearing [deg]",
    "track",
    *STATE,
    *(f"sigma_{name}" for name in STATE),
)
NAMES = ("x_m", "vx_m_s", "y_m", "vy_m_s")


def csv_text(given: FromFile, found: Followed) -> str:
    """A row for every detection, in the order of the file; the estimate is that after it."""
    lines = [",".join(HEADING)]
    scans = given.scans
    place = np.argsort(scans.row)
    times = np.repeat(scans.times, np.diff(scans.first))
    degrees = np.rad2deg(scans.polar.bearing)
    for row, i in enumerate(place.tolist()):
        cells = [
            str(given.table.lines[int(given.rows[row])]),
            time_text(float(times[i])),
            f"{scans.polar.range[i]:.9g}",
            f"{degrees[i]:.9g}",
            _name(int(found.track[i])),
            *(_number(value) for value in found.state[i].tolist()),
            *(_number(value) for value in found.deviation[i].tolist()),
        ]
        lines.append(",".join(cells))
    return "\n".join(lines) + "\n"


def plain(
    given: FromFile, settings: Settings, found: Followed, told: Sequence[Course]
) -> dict[str, Any]:
    """Metres and seconds; null where nothing is known."""
    scans = given.scans
    place = np.argsort(scans.row).tolist()
    lines = [given.table.lines[int(row)] for row in given.rows]
    numbers = [int(found.track[i]) for i in place]
    return {
        "settings": {**asdict(settings), "confirm": list(settings.confirm)},
        "scans": len(scans.times),
        "interval_s": scans.interval,
        "limited_updates": found.limited,
        "questions": list(given.questions),
        "tracks": [
            {
                "track": each.number,
                "first_s": each.first,
                "last_s": each.last,
                "detections": each.detections,
                "missed": each.missed,
                "state": dict(zip(NAMES, each.state.tolist(), strict=True)),
                "deviation": dict(zip(NAMES, each.deviation.tolist(), strict=True)),
            }
            for each in told
        ],
        "detections": [
            {"line": line, "track": number + 1 if number >= 0 else UNASSIGNED}
            for line, number in zip(lines, numbers, strict=True)
        ],
    }


def _name(number: int) -> str:
    return str(number + 1) if number >= 0 else UNASSIGNED


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.9g}"
