"""Detections from a file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.tables.csv_table import CsvTable, read
from gainproof.tables.kind import ANGLES, LENGTHS, TIMES, Kind
from gainproof.tracking.arrays import Ints, Reals
from gainproof.tracking.conversion import NoCovarianceError
from gainproof.tracking.scans import (
    LEAST_INTERVAL,
    MOST_TIME,
    DetectionError,
    OutsideError,
    Scans,
    TwiceError,
    scans,
)

COLUMNS = {
    "time": Kind(TIMES, needed=True),
    "range": Kind(LENGTHS, needed=True, above_zero=True, blank=True),
    "bearing": Kind(ANGLES, needed=True, blank=True),
    "sigma_range": Kind(LENGTHS, above_zero=True, blank=True),
    "sigma_bearing": Kind(ANGLES, above_zero=True, blank=True),
}
LEAST_ASKED = 3
"""Detections from which their bearings are looked at as a whole."""
SIGMAS = ("sigma_range", "sigma_bearing")


@dataclass(frozen=True)
class FromFile:
    """The scans, and of each detection, in the order of the file, the row of the table."""

    scans: Scans
    table: CsvTable
    rows: Ints

    def error(self, problem: NoCovarianceError) -> BadInputError:
        """What is said of a detection, with file, line and column."""
        row = int(self.rows[self.scans.row[problem.place]])
        return self.table.error(row, problem.field, str(problem))

    @property
    def questions(self) -> tuple[str, ...]:
        """What the file may mean otherwise than it says: numbers within one turn of radians are
        hardly those of degrees around a radar.
        """
        unit, size = self.table.units["bearing"]
        bearings = self.scans.polar.bearing
        if (
            unit != "deg"
            or len(bearings) < LEAST_ASKED
            or np.abs(bearings / size).max() > 2 * np.pi
        ):
            return ()
        least, most = (f"{value / size:.3g}" for value in (bearings.min(), bearings.max()))
        return (
            (
                f"all bearings lie between {least} and {most} deg: are these radians? Then the "
                "column is bearing [rad], and sigma_bearing has a unit of its own"
            ),
        )


def read_file(path: Path, given: tuple[float | None, float | None] = (None, None)) -> FromFile:
    """``given``: deviations of range (m) and bearing (rad), for files without such columns.

    A row without range and bearing is a scan without a detection. Raises BadInputError with file,
    line and column.
    """
    table = read(path, COLUMNS)
    time = np.array(table.numbers("time"), np.float64)
    seen = [_is_detection(table, row) for row in range(len(time))]
    rows = np.flatnonzero(seen)
    empty = np.flatnonzero(~np.array(seen, np.bool_))
    _require_order(table, time, empty)
    far, bearing = (_column(table, rows, name) for name in ("range", "bearing"))
    noise = [_deviations(table, rows, *each) for each in zip(SIGMAS, given, strict=True)]
    try:
        found = scans(time[rows], far, bearing, noise[0], noise[1], time[empty])
    except TwiceError as error:
        first = table.lines[int(rows[error.other])]
        message = f"the same detection stands already in line {first}"
        raise table.error(int(rows[error.row]), "range", message) from None
    except OutsideError as error:
        message = error.told(error.field, *table.units[error.field])
        raise table.error(int(rows[error.row]), error.field, message) from None
    except DetectionError as error:
        if error.field == "empty":
            row = int(empty[np.argmin(np.abs(time[empty]) <= MOST_TIME)])
            raise table.error(row, "time", str(error)) from None
        raise table.error(int(rows[error.row]), error.field, str(error)) from None
    return FromFile(found, table, rows)


def _is_detection(table: CsvTable, row: int) -> bool:
    """Whether a row has a detection; not where range and bearing are empty."""
    blank = [name for name in ("range", "bearing") if table.columns[name][row] is None]
    if len(blank) == 1:
        other = "bearing" if blank == ["range"] else "range"
        raise table.error(
            row, blank[0], f"the cell is empty, {other} has a number (both empty: an empty scan)"
        )
    return not blank


def _require_order(table: CsvTable, time: Reals, empty: Ints) -> None:
    """That times do not fall from row to row, and that an empty scan has a time of its own."""
    if back := np.flatnonzero(np.diff(time) < 0).tolist():
        row = back[0] + 1
        raise table.error(
            row,
            "time",
            f"wanted rows in the order of time, got {time[row]:.17g} s after "
            f"{time[row - 1]:.17g} s in line {table.lines[row - 1]}",
        )
    step = np.diff(time)
    if close := np.flatnonzero((step > 0) & (step < LEAST_INTERVAL)).tolist():
        message = f"scans are at least {LEAST_INTERVAL:g} s apart, got {step[close[0]]:.3g} s"
        raise table.error(close[0] + 1, "time", message)
    for row in empty.tolist():
        same = np.flatnonzero(time == time[row])
        if same.size > 1:
            other = table.lines[int(same[0] if same[0] != row else same[1])]
            message = f"a scan without a detection, and line {other} has the same time"
            raise table.error(row, "time", message)


def _column(table: CsvTable, rows: Ints, name: str) -> Reals:
    return np.array(table.numbers(name), np.float64)[rows]


def _deviations(table: CsvTable, rows: Ints, name: str, given: float | None) -> Reals:
    option = f"--{name.replace('_', '-')}"
    if name not in table.at:
        if given is None:
            raise BadInputError(f"{table.file}: there is no column {name}; wanted it, or {option}")
        return np.full(len(rows), given)
    if given is not None:
        raise BadInputError(f"{table.file}: a column {name} beside {option}: which holds?")
    found = _column(table, rows, name)
    if (missing := np.isnan(found)).any():
        row = int(rows[np.argmax(missing)])
        raise table.error(row, name, "the cell is empty, range and bearing have numbers")
    return found
