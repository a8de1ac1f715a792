"""A table from a CSV file whose header names columns and units; errors say file, line, column."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from gainproof.bad_input import BadInputError, nearest
from gainproof.files import input_file, places
from gainproof.tables import cell_text
from gainproof.tables.kind import LEAST_DEVIATION, MOST_DEVIATION, Kind

LARGEST_FILE = 10_000_000
"""Bytes."""
HEADING = re.compile(r"\s*([A-Za-z_][A-Za-z0-9_]*)\s*(?:\[\s*([^\]]*?)\s*\])?\s*")


@dataclass(frozen=True)
class CsvTable:
    """columns: by name, one entry a row: a word, a number in metres and seconds, or None where the
    cell is empty. lines: the line of each row; at: the place of each column, from 1; units: of each
    column of numbers its unit, and the size of that in metres and seconds.
    """

    file: str
    columns: Mapping[str, tuple[str | float | None, ...]]
    lines: tuple[int, ...]
    at: Mapping[str, int]
    units: Mapping[str, tuple[str, float]]

    def numbers(self, name: str) -> tuple[float | None, ...]:
        """A column of numbers; all None where there is no such column."""
        column = self.columns.get(name, (None,) * len(self.lines))
        return tuple(None if isinstance(cell, str) else cell for cell in column)

    def error(self, row: int, name: str, message: str) -> BadInputError:
        """At a cell."""
        where = f", column {self.at[name]} ({name})" if name in self.at else ""
        return BadInputError(f"{self.file}, line {self.lines[row]}{where}: {message}")


def read(path: Path, kinds: Mapping[str, Kind]) -> CsvTable:
    """Lines that begin with # and empty ones are passed over. Raises BadInputError."""
    file = places.shown(path)
    rows = _rows(path, file)
    if not rows:
        raise BadInputError(f"{file}: there is no line of column names")
    first, heading = rows[0]
    names, sizes = _heading(file, first, heading, kinds)
    cells: dict[str, list[str | float | None]] = {name: [] for name in names}
    for line, row in rows[1:]:
        if len(row) != len(names):
            raise BadInputError(f"{file}, line {line}: wanted {len(names)} cells, got {len(row)}")
        for place, (name, size, text) in enumerate(zip(names, sizes, row, strict=True), 1):
            where = f"{file}, line {line}, column {place} ({name})"
            cells[name].append(_cell(where, text.strip(), kinds[name], size))
    if len(rows) == 1:
        raise BadInputError(f"{file}: there is no line below the column names")
    return CsvTable(
        file,
        {name: tuple(column) for name, column in cells.items()},
        tuple(line for line, _ in rows[1:]),
        {name: place for place, name in enumerate(names, 1)},
        {
            name: (unit, size)
            for name, size in zip(names, sizes, strict=True)
            for unit, known in (kinds[name].units or {}).items()
            if known == size
        },
    )


def text_of(path: Path, file: str) -> str:
    """The file's text. Raises BadInputError where it cannot be read."""
    text = input_file.text(path, LARGEST_FILE).removeprefix("\ufeff")
    if "\0" in text:
        raise BadInputError(f"{file}: cannot be read: is no text")
    return text


def _rows(path: Path, file: str) -> list[tuple[int, list[str]]]:
    lines = re.split(r"\r\n|\r|\n", text_of(path, file))
    # what is quoted is no comment
    reader = csv.reader("" if line.lstrip().startswith("#") else line for line in lines)
    rows: list[tuple[int, list[str]]] = []
    last = 0
    try:
        for row in reader:
            if reader.line_num > last + 1:
                raise BadInputError(f"{file}, line {last + 1}: a quoted cell does not end there")
            last = reader.line_num
            if any(cell.strip() for cell in row):
                rows.append((last, row))
        return rows
    except csv.Error as error:
        raise BadInputError(f"{file}, line {reader.line_num}: {error}") from None


def _heading(
    file: str, line: int, heading: list[str], kinds: Mapping[str, Kind]
) -> tuple[list[str], list[float]]:
    names: list[str] = []
    sizes: list[float] = []
    for place, text in enumerate(heading, 1):
        where = f"{file}, line {line}, column {place}"
        match = HEADING.fullmatch(text)
        if match is None:
            raise BadInputError(
                f"{where}: wanted a name and a unit, as x [m], got {text.strip()!r}"
            )
        name, unit = match[1], match[2]
        if name not in kinds:
            close = nearest(name, kinds) or list(kinds)
            raise BadInputError(f"{where}: no column is called {name!r}; known: {', '.join(close)}")
        if name in names:
            raise BadInputError(f"{where}: a second column {name}")
        names.append(name)
        sizes.append(_size(where, name, unit, kinds[name]))
    missing = [name for name, kind in kinds.items() if kind.needed and name not in names]
    if missing:
        raise BadInputError(f"{file}, line {line}: there is no column {' and no '.join(missing)}")
    return names, sizes


def _size(where: str, name: str, unit: str | None, kind: Kind) -> float:
    if kind.units is None:
        if unit is not None:
            raise BadInputError(f"{where}: {name} holds words, it has no unit, got [{unit}]")
        return 1.0
    if unit is None and "1" in kind.units:
        return 1.0
    known = ", ".join(f"[{each}]" for each in kind.units)
    if unit is None:
        raise BadInputError(f"{where}: {name} has no unit; wanted {name} and one of {known}")
    if unit not in kind.units:
        raise BadInputError(f"{where}: the unit of {name} is one of {known}, got [{unit}]")
    return kind.units[unit]


def _cell(where: str, text: str, kind: Kind, size: float) -> str | float | None:
    if kind.units is None:
        if not text:
            raise BadInputError(f"{where}: the cell is empty")
        try:
            return cell_text.name(text)
        except ValueError as error:
            raise BadInputError(f"{where}: {error}") from None
    if not text:
        if kind.blank:
            return None
        raise BadInputError(f"{where}: the cell is empty, wanted a number")
    try:
        value = cell_text.decimal(text)
    except ValueError:
        raise BadInputError(f"{where}: wanted a number, got {text!r}") from None
    if not math.isfinite(value * size):
        raise BadInputError(f"{where}: wanted a finite number, got {text}")
    if kind.above_zero and not value * size > 0:
        raise BadInputError(f"{where}: wanted a number above 0, got {text}")
    if kind.deviation and not LEAST_DEVIATION <= value * size <= MOST_DEVIATION:
        raise BadInputError(
            f"{where}: a deviation is between {LEAST_DEVIATION:g} and {MOST_DEVIATION:g} in m and "
            f"m/s, got {text}"
        )
    return value * size
