"""The files of a plot: the picture that was asked for, and its numbers."""

from __future__ import annotations

from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.design.curves import curves
from gainproof.design.drawing import draw
from gainproof.design.sheet import Sheet
from gainproof.figures.writing import write
from gainproof.files import places
from gainproof.plots import canvas

ENDINGS = (".svg", ".png", ".csv")


def write_plot(sheet: Sheet, name: str) -> list[str]:
    """Write FILE (.svg or .png) and its CSV beside it, or the CSV alone; the names written.

    Raises BadInputError for another ending, where there is nothing to draw, where Matplotlib is
    missing, or where a file cannot be written.
    """
    if "\0" in name:
        raise BadInputError(f"--plot takes the name of a file, got {name!r}")
    path = Path(name)
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        raise BadInputError(f"--plot takes a name that ends in .svg, .png or .csv, got {name!r}")
    try:
        table = curves(sheet)
    except ValueError as error:
        raise BadInputError(f"--plot: {error}") from None
    content: dict[str, bytes] = {}
    if ending != ".csv":
        size = canvas.WIDTH, canvas.HEIGHT
        drawn = canvas.pictures(lambda paper: draw(table, paper, sheet.states), *size)
        content[path.name] = drawn[ending[1:]]
    content[path.with_suffix(".csv").name] = table.csv().encode()
    return [places.shown(written) for written in write(content, path.parent)]
