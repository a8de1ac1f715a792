"""The picture of tracks as the bytes of a file."""

from __future__ import annotations

from pathlib import Path

from gainproof.plots import canvas
from gainproof.tracking.drawing import SIZE, draw
from gainproof.tracking.scans import Scans
from gainproof.tracking.tracker import Followed


def plotted(scans: Scans, found: Followed, title: str, path: Path) -> bytes:
    """For a file of that name, which ends in .svg or .png. BadInputError without Matplotlib."""
    drawn = canvas.pictures(lambda sheet: draw(scans, found, title, sheet), *SIZE)
    return drawn[path.suffix.lower()[1:]]
