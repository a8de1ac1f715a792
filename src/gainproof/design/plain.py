"""A design as plain data for JSON."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from gainproof.design.belonging import Belonging
from gainproof.design.sheet import NOT_TOLD, Absent, Row, Sheet
from gainproof.design.units import Units, in_units

GAINS = ("alpha", "beta", "gamma")


def plain(sheet: Sheet, units: Units, belongs: Sequence[Belonging] = ()) -> dict[str, Any]:
    """The sheet: "filters" in order, each with its numbers, or with "absent", the reason.

    Infinity comes as text. What gains as rounded do not tell is None, and "not_told" says so.
    Units that were stated are under "units", what they make of a filter
    under its "in_units".
    """
    value = list(sheet.value) if isinstance(sheet.value, tuple) else sheet.value
    found: dict[str, Any] = {
        "states": sheet.states,
        "choice": {"kind": sheet.kind, "value": value},
        "filters": [_filter(sheet, row, units) for row in sheet.rows],
    }
    if units.stated:
        motion = "acceleration_m_s2" if sheet.states == 2 else "jerk_m_s3"
        found["units"] = {
            "interval_s": units.interval,
            motion: units.motion,
            "deviation_m": units.deviation,
        }
    if belongs:
        found["belongs"] = [
            {
                "name": each.name,
                "title": each.title,
                "within_the_digits": None if each.not_compared else each.fits,
                **({"not_compared": each.not_compared} if each.not_compared else {}),
                "gains_at_this_lag": dict(zip(GAINS, each.gains, strict=False)),
                "off": dict(zip(GAINS, each.off, strict=False)),
            }
            for each in belongs
        ]
    return found


def _filter(sheet: Sheet, row: Row | Absent, units: Units) -> dict[str, Any]:
    named = {"name": row.name, "title": row.title}
    if isinstance(row, Absent):
        return {**named, "absent": row.reason}
    found: dict[str, Any] = {
        **named,
        "gains": dict(zip(GAINS, row.gains, strict=False)),
        "predicted_variance": _number(row.predicted),
        "smoothed_variance": _number(row.smoothed),
        "lag": _number(row.lag),
        "poles": [[pole.real, pole.imag] for pole in row.poles],
        "largest_modulus": None if row.distance is None else 1 - row.distance,
        "distance_to_1": row.distance,
        "stable": row.stable,
        "samples_to_one_per_cent": None if row.samples is None else _number(row.samples),
    }
    if row.distance is None:
        found["not_told"] = NOT_TOLD
    if row.note:
        found["note"] = row.note
    if units.stated:
        found["in_units"] = {name: _number(x) for name, x in in_units(sheet, row, units).items()}
    return found


def _number(value: float) -> float | str:
    return value if math.isfinite(value) else str(value)
