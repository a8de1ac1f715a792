"""The picture of an estimate as a file."""

from __future__ import annotations

from pathlib import Path

from gainproof import places
from gainproof.figures import canvas
from gainproof.figures.writing import write
from gainproof.location.drawing import SIZE, draw
from gainproof.location.result import Location
from gainproof.location.stations import Stations

ENDINGS = (".svg", ".png")


def write_plot(found: Location, given: Stations, path: Path) -> str:
    """Write it; its name as shown. BadInputError without Matplotlib or a place to write to."""
    drawn = canvas.pictures(lambda sheet: draw(found, given, sheet), *SIZE)
    (written,) = write({path.name: drawn[path.suffix.lower()[1:]]}, path.parent)
    return places.shown(written)
