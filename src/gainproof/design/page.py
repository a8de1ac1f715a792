"""A design as a table for people, and as plain data for JSON."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Sequence
from typing import Any

from gainproof.design.belonging import Belonging
from gainproof.design.sheet import NOT_TOLD, Absent, Row, Sheet
from gainproof.design.units import Units, in_units
from gainproof.terminal_text import width as columns

GAINS = ("alpha", "beta", "gamma")
TITLES = {2: "alpha-beta filters", 3: "alpha-beta-gamma filters"}
MOTIONS = {2: ("acceleration", "a_c T^2", "m/s^2"), 3: ("jerk", "j T^3", "m/s^3")}
HEADINGS = {
    "lag_m": "lag, m",
    "predicted_deviation_m": "predicted, m",
    "smoothed_deviation_m": "smoothed, m",
    "settling_s": "settles, s",
}


def page(sheet: Sheet, units: Units, belongs: Sequence[Belonging] = ()) -> str:
    """The whole page."""
    lines = [_title(sheet)]
    if sheet.found:
        lines += ["", *table(_head(sheet), [_cells(row) for row in sheet.found])]
        lines += ["", *_meaning(sheet)]
        if units.stated:
            lines += ["", *_unit_table(sheet, units)]
    told = [*_notes(sheet), *_absent(sheet)]
    lines += ["", *told] if told else []
    if belongs:
        lines += ["", *_belonging(belongs)]
    return "\n".join(lines)


def _title(sheet: Sheet) -> str:
    if isinstance(sheet.value, tuple):
        value = ", ".join(
            f"{name} = {gain!r}" for name, gain in zip(GAINS, sheet.value, strict=False)
        )
        return f"{TITLES[sheet.states]}: {value}, and the named ones of the same lag"
    return f"{TITLES[sheet.states]} at {sheet.kind} {sheet.value!r}".removesuffix(".0")


def _meaning(sheet: Sheet) -> list[str]:
    motion, scale, _ = MOTIONS[sheet.states]
    return wrapped(
        "variance/B: of the predicted and the smoothed position under measurement noise alone, "
        f"over that of the measurement; lag: e_fin behind a constant {motion}, over {scale}; "
        "settles: samples until the largest pole's modulus, to that power, is at most 1 %. All "
        "are stable."
    )


def _head(sheet: Sheet) -> tuple[list[str], list[str]]:
    gains = list(GAINS[: sheet.states])
    above = ["", *("" for _ in gains), "variance/B", "", "", "closed-loop poles", "largest", ""]
    below = ["filter", *gains, "predicted", "smoothed", "lag", "", "modulus", "settles"]
    return above, below


def _cells(row: Row) -> list[str]:
    return [
        row.name,
        *(number(gain) for gain in row.gains),
        number(row.predicted),
        number(row.smoothed),
        number(row.lag),
        poles(row.poles),
        "not told" if row.distance is None else modulus(row.distance),
        "not told" if row.samples is None else settles(row.samples),
    ]


def settles(samples: float) -> str:
    """Whole samples; three digits of very many."""
    return f"{samples:.0f}" if samples < 1e6 else f"{samples:.3g}"


def table(head: Sequence[list[str]], rows: list[list[str]]) -> Iterator[str]:
    """Columns as wide as their longest cell: names to the left, numbers to the right."""
    everything = [*head, *rows]
    spans = [max(map(len, column)) for column in zip(*everything, strict=True)]
    for cells in everything:
        text = "  ".join(
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(cells, spans, strict=True))
        )
        yield text.rstrip()


def _unit_table(sheet: Sheet, units: Units) -> Iterator[str]:
    motion, _, unit = MOTIONS[sheet.states]
    stated = (
        ("interval", units.interval, "s"),
        (motion, units.motion, unit),
        ("deviation of the measurement", units.deviation, "m"),
    )
    told = ", ".join(f"{name} {number(x)} {of}" for name, x, of in stated if x is not None)
    yield f"with {told}:"
    yield ""
    rows = [(row.name, in_units(sheet, row, units)) for row in sheet.found]
    kinds = max((list(found) for _, found in rows), key=len, default=[])
    if not kinds:
        yield f"a lag in metres takes both an interval and the {motion}"
        return
    head = ["filter", *(HEADINGS[kind] for kind in kinds)]
    cells = [[name, *(_told(found.get(kind)) for kind in kinds)] for name, found in rows]
    yield from table([head], cells)


def _told(value: float | None) -> str:
    return "not told" if value is None else number(value)


def _notes(sheet: Sheet) -> Iterator[str]:
    for row in sheet.found:
        if row.note:
            yield from wrapped(f"{row.name} of lag {number(row.lag)}: {row.note}")
        if row.distance is None:
            yield from wrapped(f"{row.name} of lag {number(row.lag)}: {NOT_TOLD}")


def _absent(sheet: Sheet) -> Iterator[str]:
    for row in sheet.rows:
        if isinstance(row, Absent):
            yield from wrapped(f"{row.name}, {row.title}, {row.reason}")


def _belonging(belongs: Sequence[Belonging]) -> Iterator[str]:
    fitting = [f"{each.name} ({each.title})" for each in belongs if each.fits]
    if fitting:
        yield from wrapped(f"Within the digits given these are the gains of: {', '.join(fitting)}.")
    else:
        compared = " compared" if any(each.not_compared for each in belongs) else ""
        yield f"Within the digits given these are the gains of none of the named filters{compared}."
    for each in belongs:
        if each.not_compared:
            yield from wrapped(f"  {each.name}: not compared: {each.not_compared}")
            continue
        *others, last = each.gains
        parts = zip(GAINS, others, each.off, strict=False)
        shown = ", ".join(f"{n} = {g:.10g} (off by {d:.2g})" for n, g, d in parts)
        word = "fits" if each.fits else "does not fit"
        told = f"  {each.name}: with {GAINS[len(others)]} = {number(last)} has {shown}: {word}"
        yield from textwrap.wrap(told, columns(), subsequent_indent="    ", break_on_hyphens=False)


def number(value: float) -> str:
    """Six significant digits; 0.01 as it is."""
    if not math.isfinite(value):
        return str(value)
    return f"{value:.6g}"


def modulus(distance: float) -> str:
    """Four digits; next to 1 of the distance to it."""
    return f"{1 - distance:.4g}" if distance > 1e-4 else f"1 - {distance:.2g}"


def poles(values: Sequence[complex]) -> str:
    """Poles with four digits, a complex pair as one."""
    parts, left = [], list(values)
    while left:
        pole = left.pop(0)
        if pole.imag:
            left.remove(pole.conjugate()) if pole.conjugate() in left else left.pop(0)
            parts.append(f"{pole.real:.4g} +- {abs(pole.imag):.4g}i")
        else:
            parts.append(f"{pole.real:.4g}")
    return ", ".join(parts)


def wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, columns(), subsequent_indent="  ", break_on_hyphens=False)


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
