"""The two systems of coordinates of a radar: an example in both, as lines of a table.

Of the lecture's pictures the formulas and remarks are left; the example is ours.
"""

from __future__ import annotations

import numpy as np

from gainproof.generated import polar_coordinates
from gainproof.plots.table import Column, Table, Words

ELEVATION_DEGREES, BEARING_DEGREES = 36.0, 50.0
RANGE, ELEVATION, BEARING = 10e3, np.deg2rad(ELEVATION_DEGREES), np.deg2rad(BEARING_DEGREES)
"""Of the example: metres, radians, radians from north over east."""


def coordinates() -> Table:
    """Radar, target, the target's foot on the ground, and the ends of the axes."""
    place = polar_coordinates.to_cartesian(RANGE, ELEVATION, BEARING)
    x, y, z = (float(value) for value in place)
    points = {
        "radar": (0.0, 0.0, 0.0),
        "target": (x, y, z),
        "foot": (x, y, 0.0),
        "east": (RANGE, 0.0, 0.0),
        "north": (0.0, RANGE, 0.0),
        "up": (0.0, 0.0, RANGE),
    }
    return Table(
        "Polar and north-referenced Cartesian coordinates",
        (
            Words("point", "its name on the figure", tuple(points)),
            *(
                Column(f"{axis}_m", f"metres {words}", np.array([p[k] for p in points.values()]))
                for k, (axis, words) in enumerate(
                    (("x", "to the east"), ("y", "to the north"), ("z", "up"))
                )
            ),
        ),
        {
            "range of the example (m)": RANGE,
            "elevation of the example (degrees)": ELEVATION_DEGREES,
            "bearing from north of the example (degrees)": BEARING_DEGREES,
        },
        (
            "The lecture gives x = R cos E sin By, y = R cos E cos By, z = R sin E.",
            "Ours: the example, and the round of a filter's sample beside it.",
        ),
    )
