"""Tracks as a page for people."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from gainproof.terminal_text import width as columns
from gainproof.tracking.files import FromFile
from gainproof.tracking.settings import Settings
from gainproof.tracking.summary import Course
from gainproof.tracking.time_text import time_text
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
        time_text(each.first),
        time_text(each.last),
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
