"""The geometry of an estimate: stations, target, other places; and its error ellipse, enlarged."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.result import Location
from gainproof.location.stations import Stations
from gainproof.plots import canvas
from gainproof.tracking.gating import threshold

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SIZE = (7.4, 3.9)
TARGET, BIASED, CLEAN, FIRST = "#b5482a", "#b5482a", "#1f4e79", "0.5"
LEVELS = ((1.0, "39 %"), (threshold(0.95) ** 0.5, "95 %"))
"""Radii of an ellipse in deviations, with the probability inside, of two coordinates."""


def _draw(found: Location, given: Stations, sheet: Figure) -> None:
    """Left where all lies, right the ellipse of x and y; in three dimensions seen from above."""
    left, right = sheet.subplots(1, 2, width_ratios=(1.1, 1.0))
    scale, unit = (1e3, "km") if given.spread >= 2e3 else (1.0, "m")
    _geometry(left, found, given, scale, unit)
    _ellipses(right, found)
    above = ", seen from above" if given.dimension == 3 else ""
    left.set_title(f"{found.method}{above}")
    sheet.legend(loc="outside lower right", ncols=2)


def _geometry(axes: Axes, found: Location, given: Stations, scale: float, unit: str) -> None:
    clean = found.selection.clean if found.selection else given.names
    for i, name in enumerate(given.names):
        x, y = given.positions[i, :2] / scale
        colour = CLEAN if name in clean else BIASED
        axes.plot(
            [x, found.position[0] / scale], [y, found.position[1] / scale], color="0.85", lw=0.8
        )
        axes.plot(x, y, "^", color=colour, markersize=8, zorder=3)
        words = name if name in clean else f"{name}, biased"
        axes.annotate(words, (x, y), xytext=(0, 7), textcoords="offset points", ha="center")
    x, y = found.position[:2] / scale
    axes.plot(x, y, "o", color=TARGET, zorder=4)
    for other in found.others:
        axes.plot(*(other.position[:2] / scale), "o", mfc="none", color=TARGET, zorder=4)
    if found.velocity is not None and np.any(found.velocity[:2]):
        reach = 0.22 * given.spread / scale
        step = found.velocity[:2] / np.linalg.norm(found.velocity[:2]) * reach
        axes.annotate(
            "",
            (x + step[0], y + step[1]),
            xytext=(x, y),
            arrowprops={"arrowstyle": "->", "color": TARGET, "lw": 1.4},
        )
        speed = float(np.linalg.norm(found.velocity[:2]))
        axes.annotate(
            f"{speed:.4g} m/s",
            (x + step[0] / 2, y + step[1] / 2),
            xytext=(0, 6),
            textcoords="offset points",
            color=TARGET,
            ha="center",
        )
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.22)
    axes.grid(True)
    axes.set_xlabel(f"x, {unit}")
    axes.set_ylabel(f"y, {unit}")


def _ellipses(axes: Axes, found: Location) -> None:
    """Of the estimate, and of the bias detection that it began with."""
    if found.first is not None:
        shift = found.first.position[:2] - found.position[:2]
        for radius, _ in LEVELS:
            curve = ellipse(found.first.covariance[:2, :2], radius) + shift
            axes.plot(*curve.T, color=FIRST, lw=1.0, ls=(0, (4, 3)))
        axes.plot(*shift, "x", color=FIRST, label="bias detection")
    for radius, _ in LEVELS:
        curve = ellipse(found.covariance[:2, :2], radius)
        axes.plot(*curve.T, color=TARGET, lw=1.6 if radius == 1 else 1.0)
    axes.plot(0, 0, "o", color=TARGET, label=found.method)
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.12)
    axes.grid(True)
    axes.set_xlabel("x less the estimate, m")
    axes.set_ylabel("y less the estimate, m")
    axes.set_title(f"error ellipses, {LEVELS[0][1]} and {LEVELS[1][1]}")


def ellipse(covariance: Reals, radius: float) -> Reals:
    """Points (n, 2) at which the distance in deviations is `radius`."""
    angle = np.linspace(0, 2 * np.pi, 181)
    values, vectors = np.linalg.eigh(covariance)
    circle = np.stack([np.cos(angle), np.sin(angle)])
    return np.asarray((vectors * np.sqrt(np.maximum(values, 0))) @ circle * radius).T


ENDINGS = (".svg", ".png")


def plotted(found: Location, given: Stations, path: Path) -> bytes:
    """For a file of that name, which ends in .svg or .png. BadInputError without Matplotlib."""
    drawn = canvas.pictures(lambda sheet: _draw(found, given, sheet), *_SIZE)
    return drawn[path.suffix.lower()[1:]]
