"""Detections and tracks from above, as a picture."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from gainproof.plots import canvas
from gainproof.tracking.scans import Scans
from gainproof.tracking.tracker import Followed

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SIZE = (6.4, 6.0)
COLOURS = ("#1f4e79", "#b5482a", "#3d7a3d", "#6d4b8d", "#8a6d1f", "#2b7f86")
MOST_NAMED = 60
"""Numbers of more tracks would hide them."""


def _draw(scans: Scans, found: Followed, title: str, sheet: Figure) -> None:
    """x east, y north, in km or m; the radar in the origin."""
    axes = sheet.add_subplot()
    far = float(scans.polar.range.max(initial=0.0))
    scale, unit = (1e3, "km") if far >= 2e3 else (1.0, "m")
    polar = scans.polar
    x = polar.range * np.sin(polar.bearing) / scale
    y = polar.range * np.cos(polar.bearing) / scale
    loose = found.track < 0
    axes.plot(x[~loose], y[~loose], ".", color="0.6", ms=3, label="detections of tracks")
    axes.plot(x[loose], y[loose], "x", color="0.6", ms=4, mew=0.8, label="unassigned")
    axes.plot(0, 0, "^", color="black", ms=7, label="radar")
    for number in found.tracks.tolist():
        own = np.flatnonzero(found.track == number)
        colour = COLOURS[number % len(COLOURS)]
        track = found.state[own] / scale
        axes.plot(track[:, 0], track[:, 2], color=colour, lw=1.3)
        axes.plot(track[-1, 0], track[-1, 2], "o", color=colour, ms=4)
        if len(found.tracks) <= MOST_NAMED:
            axes.annotate(
                str(number + 1),
                (track[-1, 0], track[-1, 2]),
                xytext=(6, 5),
                textcoords="offset points",
                color=colour,
            )
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.08)
    axes.grid(True)
    axes.set_xlabel(f"x, {unit} east")
    axes.set_ylabel(f"y, {unit} north")
    axes.set_title(title)
    sheet.legend(loc="outside lower center", ncols=3)


def plotted(scans: Scans, found: Followed, title: str, path: Path) -> bytes:
    """For a file of that name, which ends in .svg or .png. BadInputError without Matplotlib."""
    drawn = canvas.pictures(lambda sheet: _draw(scans, found, title, sheet), *_SIZE)
    return drawn[path.suffix.lower()[1:]]
