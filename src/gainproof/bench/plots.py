"""The plots of the page of `gainproof bench`, drawn as SVG by hand: colours come from the page.

A drawing needs no library, no network and no script, and follows light and dark.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from html import escape
from statistics import median

from gainproof.bench.columns import RATIOS, Row, ratio_text, worst_output

WIDTH, LEFT, RIGHT = 640, 150, 20
STEP, TOP, FOOT = 30, 16, 44


def ratios(rows: Sequence[Row]) -> str:
    """Each ratio of the table as a line of dots, one a kernel, the median as a bar."""
    lines = [
        (column.title, [(row, value) for row in rows if (value := column.value(row)) is not None])
        for column in RATIOS
    ]
    lines = [(title, found) for title, found in lines if found]
    values = [value for _, found in lines for _, value in found if 0 < value < math.inf]
    if not values:
        return ""
    across, ticks = _axis(min(*values, 0.5), max(*values, 2.0), LEFT, WIDTH - RIGHT)
    height = TOP + STEP * len(lines) + FOOT
    bottom = height - FOOT
    parts = [
        *_grid(ticks, across, TOP, bottom),
        _line(across(1.0), TOP, across(1.0), bottom, "one"),
    ]
    for number, (title, found) in enumerate(lines):
        y = TOP + STEP * (number + 0.5)
        parts.append(_text(LEFT - 10, y + 5, title, "end"))
        parts += [
            _dot(across(value), y, f"{_name(row)}: {ratio_text(value)}") for row, value in found
        ]
        middle = across(median(value for _, value in found))
        parts.append(_line(middle, y - 11, middle, y + 11, "median"))
    parts.append(_text((LEFT + WIDTH - RIGHT) / 2, height - 6, "ratio of times", "middle"))
    about = "Ratios of times, a dot a kernel, on a logarithmic axis; bars are medians"
    return _drawing(about, height, parts)


def errors(rows: Sequence[Row]) -> str:
    """The greatest error met of each kernel against its proved bound."""
    points = [
        (row, float(worst["proved"]), float(worst["worst"]), bool(worst["outside"]))
        for row in rows
        for worst in [worst_output(row)]
    ]
    sizes = [size for _, proved, met, _ in points for size in (proved, met) if 0 < size < math.inf]
    if not sizes:
        return ""
    low, high = min(*sizes, 0.5), max(*sizes, 2.0)
    height, left = 430, 70
    bottom = height - FOOT
    across, ticks = _axis(low, high, left, WIDTH - RIGHT)
    upward, _ = _axis(low, high, bottom, TOP)
    parts = [*_grid(ticks, across, TOP, bottom)]
    for tick in ticks:
        parts.append(_line(left, upward(tick), WIDTH - RIGHT, upward(tick), "grid"))
        parts.append(_text(left - 8, upward(tick) + 5, _tick(tick), "end"))
    parts.append(_line(across(low), upward(low), across(high), upward(high), "one"))
    for row, proved, met, outside in points:
        told = f"{_name(row)}: met {met:.2f}, proved {proved:.2f}"
        # an error of 0, or one without end, is drawn at the edge
        y = upward(min(max(met, low), high))
        parts.append(_dot(across(proved), y, told, "outside" if outside else "dot"))
    parts.append(_text((left + WIDTH - RIGHT) / 2, height - 6, "proved bound, 2^-52", "middle"))
    parts.append(
        f'<text transform="translate(16 {(TOP + bottom) / 2:.0f}) rotate(-90)" '
        'text-anchor="middle">greatest error met, 2^-52</text>'
    )
    about = "Greatest error met against the proved bound, a dot a kernel; all belong below the line"
    return _drawing(about, height, parts)


def _axis(
    low: float, high: float, start: float, end: float
) -> tuple[Callable[[float], float], list[float]]:
    """A logarithmic axis: places of values, and the values at which lines stand."""
    least, most = math.log10(low), math.log10(high)
    room = 0.03 * (most - least)
    least, most = least - room, most + room

    def place(value: float) -> float:
        return start + (math.log10(value) - least) / (most - least) * (end - start)

    decades = range(math.floor(least), math.ceil(most) + 1)
    factors = (1, 2, 5) if most - least < 2.5 else (1,)
    values = [factor * 10.0**decade for decade in decades for factor in factors]
    return place, [value for value in values if least <= math.log10(value) <= most]


def _grid(
    ticks: Sequence[float], across: Callable[[float], float], top: float, bottom: float
) -> Iterator[str]:
    for tick in ticks:
        yield _line(across(tick), top, across(tick), bottom, "grid")
        yield _text(across(tick), bottom + 17, _tick(tick), "middle")


def _drawing(about: str, height: float, parts: Sequence[str]) -> str:
    return (
        f'<svg viewBox="0 0 {WIDTH} {height:.0f}" role="img" aria-label="{escape(about)}">'
        f"{''.join(parts)}</svg>"
    )


def _line(x1: float, y1: float, x2: float, y2: float, kind: str) -> str:
    return f'<line class="{kind}" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>'


def _dot(x: float, y: float, told: str, kind: str = "dot") -> str:
    return (
        f'<circle class="{kind}" cx="{x:.1f}" cy="{y:.1f}" r="3.5">'
        f"<title>{escape(told)}</title></circle>"
    )


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(text)}</text>'


def _tick(value: float) -> str:
    """Thousands as k, millions as M: long numbers would run into each other."""
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:g}{letter}"
    return f"{value:g}"


def _name(row: Row) -> str:
    return f"{row['subject']} {row['kernel']}"
