"""The picture of tracks as a file."""

from __future__ import annotations

from pathlib import Path

from gainproof import places
from gainproof.figures import canvas
from gainproof.figures.writing import write
from gainproof.tracking.drawing import SIZE, draw
from gainproof.tracking.scans import Scans
from gainproof.tracking.tracker import Followed


def write_plot(scans: Scans, found: Followed, title: str, path: Path) -> str:
    """Write it; its name as shown. BadInputError without Matplotlib or a place to write to."""
    drawn = canvas.pictures(lambda sheet: draw(scans, found, title, sheet), *SIZE)
    (written,) = write({path.name: drawn[path.suffix.lower()[1:]]}, path.parent)
    return places.shown(written)
