"""Tracks as a page for people, as CSV, and as plain data for JSON."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from gainproof.terminal_text import width as columns
from gainproof.tracking.files import FromFile
from gainproof.tracking.settings import Settings
from gainproof.tracking.summary import Course
from gainproof.tracking.tracker import Followed

MOST_SHOWN = 40
HEADS = ("track", "from, s", "to, s", "detections", "missed", "x, m", "y, m", "1-sigma, m")
MORE = ("speed, m/s", "course, deg")


def page(given: FromFile, settings: Settings, found: Followed, told: Sequence[Course]) -> str:
    """The whole page."""
    scans = given.scans
    taken = int((found.track >= 0).sum())
    total = len(found.track)
    empty = int((scans.first[1:] == scans.first[:-1]).sum())
    words = (
        f"{_counted(len(scans.times), 'scan')}, {scans.interval:g} s apart"
        f"{f' ({empty} empty)' if empty else ''}; {_counted(total, 'detection')}: {taken} in "
        f"{_counted(len(told), 'track')}, {total - taken} unassigned."
    )
    gate = f"gate of {100 * settings.gate:.6g} %"
    lines = [f"{settings.filter} filter, {settings.conversion} conversion, {gate}"]
    lines += textwrap.wrap(words, columns())
    if told:
        rows = [_row(each) for each in told[:MOST_SHOWN]]
        lines += ["", *_aligned([(*HEADS, *MORE), *rows])]
        if len(told) > MOST_SHOWN:
            lines.append(f"and {len(told) - MOST_SHOWN} more: --json or --out has them all")
    else:
        needed, of = settings.confirm
        lines += ["", f"no track: nothing was detected {needed} times in {of} scans"]
    warnings = list(given.questions)
    if found.limited:
        warnings.append(
            f"{_counted(found.limited, 'update')} with exact gains: those of first order were not "
            "stable with alpha at most 1 there, so far from the nominal point"
        )
    for warning in warnings:
        lines += textwrap.wrap(f"warning: {warning}", columns(), subsequent_indent="  ")
    return "\n".join(lines)


def _row(each: Course) -> tuple[str, ...]:
    deviation = max(float(each.deviation[0]), float(each.deviation[2]))
    return (
        str(each.number),
        _time_text(each.first),
        _time_text(each.last),
        str(each.detections),
        str(each.missed),
        f"{each.state[0]:.0f}",
        f"{each.state[2]:.0f}",
        f"{deviation:.0f}" if deviation >= 10 else f"{deviation:.2g}",
        f"{each.speed:.0f}" if each.speed >= 100 else f"{each.speed:.1f}",
        f"{round(each.course) % 360}",
    )


def _counted(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _aligned(cells: Sequence[tuple[str, ...]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return [
        "  ".join(f"{cell:>{width}}" for cell, width in zip(row, widths, strict=True))
        for row in cells
    ]


_UNASSIGNED = "unassigned"
_STATE = ("x [m]", "vx [m/s]", "y [m]", "vy [m/s]")
_HEADING = (
    "line",
    "time [s]",
    "range [m]",
    "bearing [deg]",
    "track",
    *_STATE,
    *(f"sigma_{name}" for name in _STATE),
)
_NAMES = ("x_m", "vx_m_s", "y_m", "vy_m_s")


def csv_text(given: FromFile, found: Followed) -> str:
    """A row for every detection, in the order of the file; the estimate is that after it."""
    lines = [",".join(_HEADING)]
    scans = given.scans
    place = np.argsort(scans.row)
    times = np.repeat(scans.times, np.diff(scans.first))
    degrees = np.rad2deg(scans.polar.bearing)
    for row, i in enumerate(place.tolist()):
        cells = [
            str(given.table.lines[int(given.rows[row])]),
            _time_text(float(times[i])),
            f"{scans.polar.range[i]:.9g}",
            f"{degrees[i]:.9g}",
            _name(int(found.track[i])),
            *(_number(value) for value in found.state[i].tolist()),
            *(_number(value) for value in found.deviation[i].tolist()),
        ]
        lines.append(",".join(cells))
    return "\n".join(lines) + "\n"


def plain(
    given: FromFile, settings: Settings, found: Followed, told: Sequence[Course]
) -> dict[str, Any]:
    """Metres and seconds; null where nothing is known."""
    scans = given.scans
    place = np.argsort(scans.row).tolist()
    lines = [given.table.lines[int(row)] for row in given.rows]
    numbers = [int(found.track[i]) for i in place]
    return {
        "settings": {**asdict(settings), "confirm": list(settings.confirm)},
        "scans": len(scans.times),
        "interval_s": scans.interval,
        "limited_updates": found.limited,
        "questions": list(given.questions),
        "tracks": [
            {
                "track": each.number,
                "first_s": each.first,
                "last_s": each.last,
                "detections": each.detections,
                "missed": each.missed,
                "state": dict(zip(_NAMES, each.state.tolist(), strict=True)),
                "deviation": dict(zip(_NAMES, each.deviation.tolist(), strict=True)),
            }
            for each in told
        ],
        "detections": [
            {"line": line, "track": number + 1 if number >= 0 else _UNASSIGNED}
            for line, number in zip(lines, numbers, strict=True)
        ],
    }


def _name(number: int) -> str:
    return str(number + 1) if number >= 0 else _UNASSIGNED


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.9g}"


def _time_text(time: float) -> str:
    """The fewest digits that come back as the same number, in s: those of a file in s, mostly."""
    return repr(time).removesuffix(".0")
