"""Charts of one horizontal axis as SVG that takes the page's colours and scales with it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup, escape

WIDTH, HEIGHT = 640, 300
LEFT, RIGHT, TOP, BOTTOM = 64, 12, 12, 44
DASHES = ("", "6 3", "2 3", "8 3 2 3", "12 4", "1 5")
"""Lines differ by their dashes too: not everybody sees colours."""
MOST_TICKS = 8


@dataclass(frozen=True)
class Axis:
    """From `low` to `high`, logarithmic or not; `label` is for readers."""

    low: float
    high: float
    logarithmic: bool
    label: str

    def part(self, value: float) -> float:
        """Where a value lies, from 0 to 1."""
        if self.logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)

    def ticks(self) -> list[float]:
        """Round numbers between the ends."""
        if self.logarithmic:
            first, last = math.ceil(math.log10(self.low)), math.floor(math.log10(self.high))
            step = max(1, math.ceil((last - first + 1) / MOST_TICKS))
            return [10.0**n for n in range(first, last + 1, step)]
        raw = (self.high - self.low) / 5
        unit = 10.0 ** math.floor(math.log10(raw))
        step_size = next(unit * n for n in (1, 2, 5, 10) if unit * n >= raw)
        start = math.ceil(self.low / step_size)
        end = math.floor(self.high / step_size)
        return [n * step_size for n in range(start, end + 1)]


def axis_of(values: Sequence[float], label: str, *, from_zero: bool = False) -> Axis:
    """An axis that holds the values: logarithmic if they are positive and far apart."""
    low, high = min(values), max(values)
    if low > 0 and high / low > 50 and not from_zero:
        return Axis(low, high, True, label)
    low = min(0.0, low) if from_zero else low
    if low == high:
        low, high = low - 1, high + 1
    return Axis(low, high, False, label)


def chart(
    x: Sequence[float],
    lines: Mapping[str, Sequence[float | None]],
    across: Axis,
    up: Axis,
    *,
    dots: bool,
) -> Markup:
    """A line, or dots, for each name; None is left out."""
    shapes = [*_grid(across, up)]
    for number, (_, values) in enumerate(lines.items()):
        points = [
            (_x(across, at), _y(up, value))
            for at, value in zip(x, values, strict=True)
            if value is not None
        ]
        shapes.append(_dots(points, number) if dots else _line(points, number))
    told = f"{', '.join(lines)}: {up.label} against {across.label}"
    body = Markup().join(shapes)
    picture = Markup('<svg class="chart" viewBox="0 0 {} {}" role="img" aria-label="{}">{}</svg>')
    return picture.format(WIDTH, HEIGHT, told, body) + _legend(list(lines), dots)


def _x(axis: Axis, value: float) -> float:
    return LEFT + axis.part(value) * (WIDTH - LEFT - RIGHT)


def _y(axis: Axis, value: float) -> float:
    return HEIGHT - BOTTOM - axis.part(value) * (HEIGHT - TOP - BOTTOM)


def _grid(across: Axis, up: Axis) -> list[Markup]:
    line = Markup('<line class="grid" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>')
    text = Markup('<text class="tick" x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>')
    found = []
    for value in across.ticks():
        at = _x(across, value)
        found.append(line.format(at, TOP, at, HEIGHT - BOTTOM))
        found.append(text.format(at, HEIGHT - BOTTOM + 16, "middle", f"{value:g}"))
    for value in up.ticks():
        at = _y(up, value)
        found.append(line.format(LEFT, at, WIDTH - RIGHT, at))
        found.append(text.format(LEFT - 6, at + 4, "end", f"{value:g}"))
    middle = (LEFT + WIDTH - RIGHT) / 2
    found.append(text.format(middle, HEIGHT - 8, "middle", across.label))
    return found


def _line(points: Sequence[tuple[float, float]], number: int) -> Markup:
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    shape = Markup('<polyline class="line c{}" stroke-dasharray="{}" points="{}"/>')
    return shape.format(number % 4, DASHES[number % len(DASHES)], path)


def _dots(points: Sequence[tuple[float, float]], number: int) -> Markup:
    shape = Markup('<path class="dot c{}" d="{}"/>')
    return shape.format(number % 4, " ".join(_mark(x, y, number % 4) for x, y in points))


def _mark(x: float, y: float, form: int) -> str:
    """A plus, a cross, a square or a triangle."""
    forms = (
        "m-3,0h6m-3,-3v6",
        "m-2.5,-2.5l5,5m0,-5l-5,5",
        "m-2,-2h4v4h-4z",
        "m0,-3l3,5h-6z",
    )
    return f"M{x:.1f},{y:.1f}{forms[form]}"


def _legend(names: Sequence[str], dots: bool) -> Markup:
    entry = Markup(
        '<span class="entry"><svg viewBox="0 0 28 10" aria-hidden="true">{}</svg>{}</span>'
    )
    shapes = [
        _dots([(14, 5)], number) if dots else _line([(0, 5), (28, 5)], number)
        for number in range(len(names))
    ]
    entries = [entry.format(s, escape(n)) for s, n in zip(shapes, names, strict=True)]
    return Markup('<p class="legend">{}</p>').format(Markup(" ").join(entries))
