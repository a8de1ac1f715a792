"""Range rates that come as Doppler shifts of a carrier: read as rates, with the printed kernel.

The shift is that of one way, received less sent frequency, below 0 where the target goes away. An
echo has twice the shift, as if its carrier were twice as high.
"""

from __future__ import annotations

import re
from dataclasses import replace

from gainproof.bad_input import BadInputError
from gainproof.generated.range_doppler import doppler_shift_in_plane
from gainproof.tables.cell_text import decimal
from gainproof.tables.csv_table import CsvTable
from gainproof.tables.kind import FREQUENCIES, LEAST_DEVIATION, MOST_DEVIATION

LEAST_CARRIER, MOST_CARRIER = 1.0, 1e18
"""Hz."""
COLUMNS = ("doppler", "sigma_doppler", "carrier")
QUANTITY = re.compile(r"\s*(\S+?)\s*([A-Za-z]+)\s*")


def shift_of_rate(carrier: float) -> float:
    """The Doppler shift in Hz of a range rate of 1 m/s, by the printed kernel; below 0."""
    at_rest, away = (0.0, 0.0), (1.0, 0.0)
    found = doppler_shift_in_plane(*away, *away, *at_rest, *at_rest, carrier)
    return float(found.doppler_shift)


def carrier_of(text: str) -> float:
    """Hz from "9.4 GHz". Raises BadInputError."""
    match = QUANTITY.fullmatch(text)
    known = ", ".join(FREQUENCIES)
    if match is None or match[2] not in FREQUENCIES:
        raise BadInputError(f"--carrier takes a number and one of {known}, got {text!r}")
    try:
        value = decimal(match[1]) * FREQUENCIES[match[2]]
    except ValueError:
        raise BadInputError(f"--carrier takes a number and one of {known}, got {text!r}") from None
    if not LEAST_CARRIER <= value <= MOST_CARRIER:
        raise BadInputError(f"--carrier is between 1 Hz and {MOST_CARRIER:g} Hz, got {text!r}")
    return value


def with_rates(seen: CsvTable, carrier: float | None, *, own_covariance: bool) -> CsvTable:
    """The observations with a range rate for every Doppler shift.

    carrier: Hz, of every row, where there is no such column; own_covariance: whether that of the
    noise comes from a file, which is in m and m/s. Raises BadInputError.
    """
    if "doppler" not in seen.at:
        _require_no_other(seen, carrier)
        return seen
    if carrier is None and "carrier" not in seen.at:
        raise BadInputError(
            f"{seen.file}: there is a column doppler and no column carrier; wanted it, or --carrier"
        )
    if carrier is not None and "carrier" in seen.at:
        raise BadInputError(f"{seen.file}: a column carrier beside --carrier: which holds?")
    if own_covariance:
        raise BadInputError(
            f"{seen.file}: a column doppler beside --covariance, which is in m and m/s: wanted "
            "range_rate, or sigma_doppler without --covariance"
        )
    if "sigma_doppler" not in seen.at:
        raise BadInputError(f"{seen.file}: there is a column doppler and no column sigma_doppler")
    rates, deviations = [*seen.numbers("range_rate")], [*seen.numbers("sigma_range_rate")]
    shares = [*seen.numbers("correlation")]
    for row, shift in enumerate(seen.numbers("doppler")):
        if shift is None:
            continue
        if rates[row] is not None:
            raise seen.error(row, "doppler", "there is a range_rate too: one of them")
        own = _carrier(seen, row, carrier)
        if abs(shift) >= own:
            # then the range rate is that of light or more
            raise seen.error(
                row,
                "doppler",
                f"wanted a shift below the carrier, got {shift:g} Hz at a carrier of {own:g} Hz; "
                "are the units of both right?",
            )
        per_rate = shift_of_rate(own)
        deviation = seen.numbers("sigma_doppler")[row]
        if deviation is None:
            raise seen.error(row, "sigma_doppler", "the cell is empty, doppler has a number")
        rates[row], deviations[row] = shift / per_rate, deviation / abs(per_rate)
        if not LEAST_DEVIATION <= deviation / abs(per_rate) <= MOST_DEVIATION:
            raise seen.error(
                row,
                "sigma_doppler",
                f"a deviation is between {LEAST_DEVIATION:g} and {MOST_DEVIATION:g} in m/s, got "
                f"{deviation / abs(per_rate):.3g} m/s at this carrier",
            )
        share = shares[row]
        if share is not None:
            # a noise that raises the shift lowers the rate
            shares[row] = -share
    columns = dict(seen.columns) | {
        "range_rate": tuple(rates),
        "sigma_range_rate": tuple(deviations),
        "correlation": tuple(shares),
    }
    at = dict(seen.at)
    at.setdefault("range_rate", at["doppler"])
    at.setdefault("sigma_range_rate", at["sigma_doppler"])
    return replace(seen, columns=columns, at=at)


def _carrier(seen: CsvTable, row: int, carrier: float | None) -> float:
    if carrier is not None:
        return carrier
    own = seen.numbers("carrier")[row]
    if own is None:
        raise seen.error(row, "carrier", "the cell is empty, doppler has a number")
    if not LEAST_CARRIER <= own <= MOST_CARRIER:
        raise seen.error(
            row, "carrier", f"a carrier is between 1 Hz and {MOST_CARRIER:g} Hz, got {own:g} Hz"
        )
    return own


def _require_no_other(seen: CsvTable, carrier: float | None) -> None:
    for name in COLUMNS[1:]:
        if name in seen.at:
            raise BadInputError(f"{seen.file}: there is a column {name} and no column doppler")
    if carrier is not None:
        raise BadInputError(f"{seen.file}: --carrier and no column doppler")
