"""The two systems of coordinates of a radar: an example in both, as lines of a table and a picture.

Of the lecture's pictures the formulas and remarks are left; the example is ours.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.figures.lecture import look
from gainproof.figures.lecture.diagram import Box, arrow, put
from gainproof.generated import polar_coordinates
from gainproof.plots.table import Column, Reals, Table, Words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

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


SIZE = (8.4, 4.2)
VIEW = np.array([[0.72, -0.42], [0.74, 0.3], [0.0, 0.95]])
"""Where a metre to the east, to the north and up goes on the sheet."""
NOISE = r"noise $\approx J\,\mathrm{diag}(\sigma_R^2, \sigma_E^2, \sigma_{By}^2)\,J^T$, coupled"
ROUND = (
    Box(30, 57, 58, 12, "radar measures", "$R,\\ E,\\ B_y$: errors independent of one another"),
    Box(
        30,
        37,
        58,
        18,
        "to Cartesian coordinates",
        "$x = R\\,\\cos E\\,\\sin B_y$,  $y = R\\,\\cos E\\,\\cos B_y$,  $z = R\\,\\sin E$\n"
        + NOISE,
        spacing=1.6,
    ),
    Box(30, 18, 58, 12, "update", "innovation, gain, smoothed position and velocity"),
    Box(30, 2, 58, 12, "predict", "a straight course is linear here (not in polar coordinates)"),
)


def draw_coordinates(table: Table, sheet: Figure) -> None:
    """Left the radar's geometry, right a sample's way through both systems."""
    space, flow = sheet.subplots(1, 2, width_ratios=(1, 1.15))
    _draw_space(space, table)
    _draw_round(flow)


def _draw_space(axes: Axes, table: Table) -> None:
    names = table.words("point")
    points = np.stack([table["x_m"], table["y_m"], table["z_m"]], axis=-1) / table["x_m"].max()
    place = dict(zip(names, points @ VIEW, strict=True))
    space = dict(zip(names, points, strict=True))
    axes.set_axis_off()
    axes.set_aspect("equal")
    radar = place["radar"]
    ends = {"east": "$x$, east", "north": "$y$, north", "up": "$z$, up"}
    for name, words in ends.items():
        arrow(axes, tuple(radar), tuple(place[name]))
        axes.annotate(words, place[name], xytext=(4, 2), textcoords="offset points", bbox=look.BOX)
    target, foot = place["target"], place["foot"]
    _line(axes, radar, target, color=look.DARK, linewidth=1.8)
    _line(axes, radar, foot, color="0.4", linewidth=0.9, linestyle=look.DASHED)
    _line(axes, foot, target, color="0.4", linewidth=0.9, linestyle=look.DASHED)
    for corner in ((space["foot"][0], 0, 0), (0, space["foot"][1], 0)):
        _line(axes, foot, np.array(corner) @ VIEW, color="0.4", linewidth=0.7, linestyle=":")
    axes.plot(*target, marker="o", color=look.DARK, markersize=6)
    axes.plot(*radar, marker="^", color="black", markersize=7)
    axes.annotate("target", target, xytext=(6, 3), textcoords="offset points")
    axes.annotate("radar", radar, xytext=(-6, -10), textcoords="offset points", ha="right")
    axes.annotate("$R$", 0.55 * target, xytext=(-4, 4), textcoords="offset points", ha="right")
    _angles(axes)
    axes.set_xlim(-0.2, 1.15)
    axes.set_ylim(-0.5, 1.02)


def _angles(axes: Axes) -> None:
    """Bearing from north on the ground, elevation above the ground."""
    way = np.linspace(0, 1, 40)
    turn, rise = way * BEARING, way * ELEVATION
    flat = np.stack([np.sin(turn), np.cos(turn), 0 * way], axis=-1)
    steep = np.stack(
        [np.cos(rise) * np.sin(BEARING), np.cos(rise) * np.cos(BEARING), np.sin(rise)], axis=-1
    )
    for arc, words, how in ((0.36 * flat, "$B_y$", (5, -3)), (0.68 * steep, "$E$", (5, -2))):
        drawn = arc @ VIEW
        axes.plot(*drawn.T, color=look.MIDDLE, linewidth=1.4)
        axes.annotate(words, drawn[20], xytext=how, textcoords="offset points", color=look.MIDDLE)


def _line(axes: Axes, start: Reals, end: Reals, **how: Any) -> None:
    axes.plot(*np.stack([start, end]).T, **how)


def _draw_round(axes: Axes) -> None:
    axes.set_axis_off()
    axes.set_xlim(0, 76)
    axes.set_ylim(-5, 64)
    for box in ROUND:
        put(axes, box)
    for above, below in pairwise(ROUND):
        arrow(axes, above.bottom, below.top)
    update, predict = ROUND[2:]
    right = predict.x + predict.width / 2
    arrow(axes, (right, predict.y), (right, update.y), curve=0.9)
    axes.text(right + 8.5, (predict.y + update.y) / 2, "next\nsample", va="center", fontsize=7.5)
