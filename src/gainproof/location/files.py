"""Stations, observations and their covariance from files."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from gainproof.bad_input import BadInputError, nearest
from gainproof.files import places
from gainproof.fixed_gain.arguments import Reals
from gainproof.location.doppler import with_rates
from gainproof.location.noise import whitening
from gainproof.location.stations import Observations, Stations, observations, stations
from gainproof.tables.cell_text import decimal
from gainproof.tables.csv_table import CsvTable, read, text_of
from gainproof.tables.kind import (
    FREQUENCIES,
    LEAST_DEVIATION,
    LENGTHS,
    MOST_DEVIATION,
    PURE,
    SPEEDS,
    Kind,
)

_STATION_COLUMNS = {
    "station": Kind(None, needed=True),
    "x": Kind(LENGTHS, needed=True),
    "y": Kind(LENGTHS, needed=True),
    "z": Kind(LENGTHS),
    "vx": Kind(SPEEDS),
    "vy": Kind(SPEEDS),
    "vz": Kind(SPEEDS),
}
_OBSERVATION_COLUMNS = {
    "station": Kind(None, needed=True),
    "range": Kind(LENGTHS, above_zero=True, blank=True),
    "sigma_range": Kind(LENGTHS, above_zero=True, deviation=True, blank=True),
    "range_rate": Kind(SPEEDS, blank=True),
    "sigma_range_rate": Kind(SPEEDS, above_zero=True, deviation=True, blank=True),
    "doppler": Kind(FREQUENCIES, blank=True),
    "sigma_doppler": Kind(FREQUENCIES, above_zero=True, blank=True),
    "carrier": Kind(FREQUENCIES, above_zero=True, blank=True),
    "correlation": Kind(PURE, blank=True),
}


MOST_OBSERVATIONS = 2000
PAIRS = (("range", "sigma_range"), ("range_rate", "sigma_range_rate"))


def read_files(
    observed: Path,
    standing: Path,
    covariance: Path | None = None,
    carrier: float | None = None,
) -> tuple[Stations, Observations]:
    """The stations that observed anything, in the order of the observations, and these; Doppler
    shifts as range rates, of this carrier in Hz where the observations have none.

    Raises BadInputError with file, line and column.
    """
    seen, places_of = read(observed, _OBSERVATION_COLUMNS), read(standing, _STATION_COLUMNS)
    seen = with_rates(seen, carrier, own_covariance=covariance is not None)
    rows = _station_rows(seen, places_of)
    given = _stations(places_of, rows)
    if len(_told(seen)) > MOST_OBSERVATIONS:
        raise BadInputError(
            f"{seen.file}: at most {MOST_OBSERVATIONS} ranges and range rates are taken, got "
            f"{len(_told(seen))}: their covariance is a full matrix"
        )
    values = {name: seen.numbers(name) for name, _ in PAIRS}
    noise = _diagonal(seen) if covariance is None else _matrix(seen, covariance)
    try:
        found = observations(given, values["range"], values["range_rate"], noise)
        whitening(found.covariance, _told(seen))
    except ValueError as error:
        file = seen.file if covariance is None else places.shown(covariance)
        raise BadInputError(f"{file}: {error}") from None
    return given, found


def _station_rows(seen: CsvTable, standing: CsvTable) -> list[int]:
    known: dict[str, int] = {}
    for row, name in enumerate(standing.columns["station"]):
        if str(name) in known:
            first = standing.lines[known[str(name)]]
            raise standing.error(row, "station", f"{name} stands already in line {first}")
        known[str(name)] = row
    taken: dict[str, int] = {}
    for row, name in enumerate(seen.columns["station"]):
        if str(name) not in known:
            close = nearest(str(name), known)
            hint = f"; nearest: {', '.join(close)}" if close else ""
            message = f"{standing.file} has no station {name}{hint}"
            raise seen.error(row, "station", message)
        if str(name) in taken:
            first = seen.lines[taken[str(name)]]
            raise seen.error(row, "station", f"{name} observes already in line {first}")
        taken[str(name)] = row
    return [known[name] for name in taken]


def _stations(table: CsvTable, rows: list[int]) -> Stations:
    axes = ("x", "y", "z") if "z" in table.at else ("x", "y")
    if "vz" in table.at and "z" not in table.at:
        raise BadInputError(f"{table.file}: there is a column vz and no column z")
    speeds = [f"v{axis}" for axis in axes]
    missing = [name for name in speeds if name not in table.at]
    if missing and len(missing) < len(speeds):
        has = " and ".join(name for name in speeds if name in table.at)
        raise BadInputError(
            f"{table.file}: there is a column {has} and no column {' and no '.join(missing)}"
        )
    chosen = {
        name: [float(table.numbers(name)[row] or 0.0) for row in rows]
        for axis in axes
        for name in (axis, f"v{axis}")
    }
    names = [str(table.columns["station"][row]) for row in rows]
    try:
        return stations(
            np.array([chosen[axis] for axis in axes]).T,
            np.array([chosen[f"v{axis}"] for axis in axes]).T,
            names,
        )
    except ValueError as error:
        raise BadInputError(f"{table.file}: {error}") from None


def _diagonal(seen: CsvTable) -> Reals:
    """From the columns of deviations and of the correlation of both noises of a station."""
    variances: list[float] = []
    of: dict[tuple[int, str], int] = {}
    for name, sigma in PAIRS:
        for row, (value, deviation) in enumerate(
            zip(seen.numbers(name), seen.numbers(sigma), strict=True)
        ):
            if value is None:
                continue
            if sigma not in seen.at:
                raise BadInputError(
                    f"{seen.file}: there is a column {name} and no column {sigma}; wanted it, or "
                    "--covariance"
                )
            if deviation is None:
                raise seen.error(row, sigma, f"the cell is empty, {name} has a number")
            of[row, name] = len(variances)
            variances.append(deviation**2)
    noise = np.diag(np.array(variances, np.float64))
    for row, share in enumerate(seen.numbers("correlation")):
        if share is None:
            continue
        if not -1 < share < 1:
            raise seen.error(row, "correlation", f"wanted a number between -1 and 1, got {share}")
        if (row, "range") not in of or (row, "range_rate") not in of:
            raise seen.error(row, "correlation", "wanted a range and a range rate with it")
        i, j = of[row, "range"], of[row, "range_rate"]
        noise[i, j] = noise[j, i] = share * np.sqrt(noise[i, i] * noise[j, j])
    return noise


def _matrix(seen: CsvTable, path: Path) -> Reals:
    """A square of numbers without a header, in metres and seconds."""
    for name in ("sigma_range", "sigma_range_rate", "correlation"):
        if name in seen.at:
            raise BadInputError(f"{seen.file}: a column {name} beside --covariance: which holds?")
    file = places.shown(path)
    rows: list[list[float]] = []
    for line, text in enumerate(text_of(path, file).splitlines(), 1):
        if not text.strip() or text.lstrip().startswith("#"):
            continue
        row = []
        for place, cell in enumerate(text.split(","), 1):
            try:
                row.append(decimal(cell))
            except ValueError:
                raise BadInputError(
                    f"{file}, line {line}, column {place}: wanted a number, got {cell.strip()!r}"
                ) from None
            if not np.isfinite(row[-1]):
                where = f"{file}, line {line}, column {place}"
                raise BadInputError(f"{where}: wanted a finite number, got {cell.strip()}")
        wanted = len(_told(seen))
        if len(row) != wanted:
            raise BadInputError(
                f"{file}, line {line}: wanted {wanted} numbers, one for each range and then each "
                f"range rate, got {len(row)}"
            )
        rows.append(row)
    if len(rows) != len(_told(seen)):
        raise BadInputError(f"{file}: wanted {len(_told(seen))} rows, got {len(rows)}")
    _require_deviations(file, seen, rows)
    return np.array(rows)


def _require_deviations(file: str, seen: CsvTable, rows: list[list[float]]) -> None:
    """That variances of a file are those of deviations that columns may have; those not above 0
    are named elsewhere.
    """
    largest = max((abs(value) for row in rows for value in row), default=0.0)
    if largest > MOST_DEVIATION**2:
        raise BadInputError(
            f"{file}: a covariance is at most {MOST_DEVIATION**2:g}, got {largest!s}: the "
            f"deviation of an observation is at most {MOST_DEVIATION:g} in m and m/s"
        )
    for i, name in enumerate(_told(seen)):
        variance = rows[i][i]
        if variance > 0 and not LEAST_DEVIATION <= variance**0.5 <= MOST_DEVIATION:
            raise BadInputError(
                f"{file}: the deviation of {name} is between {LEAST_DEVIATION:g} and "
                f"{MOST_DEVIATION:g} in m and m/s, got the variance {variance!s}"
            )


def _told(seen: CsvTable) -> list[str]:
    """The names of all observations, in the order of the covariance."""
    return [
        f"the {name.replace('_', ' ')} of {station}"
        for name, _ in PAIRS
        for station, value in zip(seen.columns["station"], seen.numbers(name), strict=True)
        if value is not None
    ]
