"""The files of a figure."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.figures.entry import Entry
from gainproof.files import atomic_file, places
from gainproof.plots.canvas import pictures
from gainproof.plots.table import Table


def files(entry: Entry, table: Table, drawn: bool = True) -> dict[str, bytes]:
    """The files of a figure by name: CSV, and where ``drawn`` SVG and PNG.

    Raises BadInputError where Matplotlib is wanted and missing.
    """
    found = {f"{entry.file}.csv": table.csv().encode()}
    if drawn:
        drawings = pictures(lambda sheet: entry.draw(table, sheet), *entry.size)
        found |= {f"{entry.file}.{ending}": content for ending, content in drawings.items()}
    return found


def write(content: Mapping[str, bytes], folder: Path) -> list[Path]:
    """Put the files into the folder, made as needed. Raises BadInputError."""
    paths = []
    for name, data in content.items():
        path = folder / name
        try:
            atomic_file.write_bytes(path, data)
        except OSError as error:
            shown = places.shown(path)
            raise BadInputError(f"{shown}: cannot be written: {error.strerror or error}") from None
        paths.append(path)
    return paths
