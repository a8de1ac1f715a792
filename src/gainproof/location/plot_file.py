"""The picture of an estimate as the bytes of a file."""

from __future__ import annotations

from pathlib import Path

from gainproof.location.drawing import SIZE, draw
from gainproof.location.result import Location
from gainproof.location.stations import Stations
from gainproof.plots import canvas

ENDINGS = (".svg", ".png")


def plotted(found: Location, given: Stations, path: Path) -> bytes:
    """For a file of that name, which ends in .svg or .png. BadInputError without Matplotlib."""
    drawn = canvas.pictures(lambda sheet: draw(found, given, sheet), *SIZE)
    return drawn[path.suffix.lower()[1:]]
