"""The two systems of coordinates as a picture, and what a tracking filter does in each."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.figures.lecture import look
from gainproof.figures.lecture.coordinates import BEARING, ELEVATION
from gainproof.figures.lecture.diagram import Box, arrow, put
from gainproof.plots.table import Reals, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

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
