"""The numbers behind a figure: named columns, as CSV and as plain data."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Column:
    """A column: its name in the CSV, what it is, and its numbers. NaN stands for no number."""

    name: str
    meaning: str
    values: Reals

    def cells(self) -> list[str]:
        """17 digits, so that floats come back as they were; an empty cell is no number."""
        return [_cell(value) for value in self.values.tolist()]

    def plain(self) -> list[Any]:
        """For JSON; null stands for no number."""
        return [_finite(value) for value in self.values.tolist()]


@dataclass(frozen=True)
class Words:
    """A column of words: of a diagram's lines and of named points."""

    name: str
    meaning: str
    values: tuple[str, ...]

    def cells(self) -> list[str]:
        """In quotation marks where a comma or a mark asks for them."""
        return [_quoted(value) for value in self.values]

    def plain(self) -> list[Any]:
        """The words as they are."""
        return list(self.values)


@dataclass(frozen=True)
class Table:
    """The columns of a figure, of one length, and the few numbers that are told beside it.

    ``notes`` say what the source leaves open and what is ours; they are sentences.
    """

    title: str
    columns: tuple[Column | Words, ...]
    numbers: Mapping[str, Any] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def __getitem__(self, name: str) -> Reals:
        for column in self.columns:
            if column.name == name and isinstance(column, Column):
                return column.values
        raise KeyError(name)

    def words(self, name: str) -> tuple[str, ...]:
        """A column of words."""
        for column in self.columns:
            if column.name == name and isinstance(column, Words):
                return column.values
        raise KeyError(name)

    def csv(self) -> str:
        """The notes as lines that begin with #, a line of names, then one line a row."""
        lines = [f"# {note}" for note in self.notes]
        lines.append(",".join(column.name for column in self.columns))
        cells = [column.cells() for column in self.columns]
        lines += [",".join(row) for row in zip(*cells, strict=True)]
        return "\n".join(lines) + "\n"

    def plain(self) -> dict[str, Any]:
        """Data for JSON; null stands for no number."""
        return {
            "title": self.title,
            **({"notes": list(self.notes)} if self.notes else {}),
            "columns": {
                column.name: {"meaning": column.meaning, "values": column.plain()}
                for column in self.columns
            },
            "numbers": dict(self.numbers),
        }


def grid(*axes: Sequence[float] | Reals) -> tuple[Reals, ...]:
    """Every combination of the axes' values, flat, the last axis running fastest."""
    return tuple(mesh.ravel() for mesh in np.meshgrid(*axes, indexing="ij"))


def decades(first: int, last: int, per_decade: int) -> Reals:
    """Powers of ten from 10^first to 10^last, so many to a decade; whole powers exactly."""
    steps = np.arange(first * per_decade, last * per_decade + 1)
    values = [
        float(f"1e{step // per_decade}") * 10.0 ** (step % per_decade / per_decade)
        for step in steps.tolist()
    ]
    return np.array(values)


def _cell(value: float) -> str:
    return "" if math.isnan(value) else repr(value)


def _quoted(value: str) -> str:
    if not set(value) & {",", '"', "\n"}:
        return value
    return '"' + value.replace('"', '""') + '"'


def _finite(value: float) -> float | str | None:
    if math.isnan(value):
        return None
    return value if math.isfinite(value) else repr(value)
