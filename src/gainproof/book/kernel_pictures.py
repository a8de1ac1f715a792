"""Pictures of a kernel: its values, and its errors in units in the last place."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup, escape

from gainproof.jobs.workers import Job
from gainproof.subjects.derived import Derived

MOST_LINES = 4
"""Lines or dots of one picture; more could not be told apart."""


@dataclass(frozen=True)
class Picture:
    """A chart and what it shows."""

    svg: Markup
    caption: str


def jobs(derived: Derived) -> list[Job]:
    """One for each kernel of a subject, in their order."""
    return [
        Job(
            f"{kernel['module']}.{kernel['name']}",
            "picture",
            {
                "module": kernel["module"],
                "kernel": {"name": kernel["name"], "outputs": kernel["outputs"]},
                "graph": kernel["graph"],
            },
        )
        for kernel in derived.kernels
    ]


def pictures(sampled: Mapping[str, Any]) -> tuple[Picture, ...]:
    """Of one input the values against it, and the errors; of several the errors alone, since the
    others vary too. `sampled`: what `sampled_kernel` found.
    """
    found = _values(sampled) if sampled["inputs"] == 1 else []
    return (*found, *_errors(sampled))


def _values(sampled: Mapping[str, Any]) -> list[Picture]:
    return [
        Picture(
            _chart(
                sampled["x"],
                lines,
                _axis_of(sampled["x"], _spoken(sampled["input"])),
                _axis_of([value for line in lines.values() for value in line], "value"),
                dots=False,
            ),
            f"{_spoken(', '.join(lines))} against {_spoken(sampled['input'])}",
        )
        for lines in _parts(sampled["values"])
    ]


def _errors(sampled: Mapping[str, Any]) -> list[Picture]:
    found = []
    random = ", the other inputs at random" if sampled["inputs"] > 1 else ""
    for lines in _parts(sampled["errors"]):
        known = [value for line in lines.values() for value in line if value is not None]
        if not known:
            continue
        found.append(
            Picture(
                _chart(
                    sampled["x"],
                    lines,
                    _axis_of(sampled["x"], _spoken(sampled["input"])),
                    _axis_of(known, "error in units in the last place", from_zero=True),
                    dots=True,
                ),
                f"error of {_spoken(', '.join(lines))} in units in the last place (float64) at "
                f"{len(sampled['x'])} values of {_spoken(sampled['input'])}{random}; the greatest "
                f"here {max(known):.2f}. The proved bound is in units of 2^-52 of the value, of "
                "which a unit in the last place is between one half and one",
            )
        )
    return found


def _parts(lines: Mapping[str, Sequence[Any]]) -> list[dict[str, Sequence[Any]]]:
    """A few lines at a time."""
    names = list(lines)
    return [
        {name: lines[name] for name in names[start : start + MOST_LINES]}
        for start in range(0, len(names), MOST_LINES)
    ]


def _spoken(name: str) -> str:
    return name.replace("_", " ")


_WIDTH, _HEIGHT = 640, 300
_LEFT, _RIGHT, _TOP, _BOTTOM = 64, 12, 12, 44
_DASHES = ("", "6 3", "2 3", "8 3 2 3", "12 4", "1 5")
"""Lines differ by their dashes too: not everybody sees colours."""
_MOST_TICKS = 8


@dataclass(frozen=True)
class _Axis:
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
            step = max(1, math.ceil((last - first + 1) / _MOST_TICKS))
            return [10.0**n for n in range(first, last + 1, step)]
        raw = (self.high - self.low) / 5
        unit = 10.0 ** math.floor(math.log10(raw))
        step_size = next(unit * n for n in (1, 2, 5, 10) if unit * n >= raw)
        start = math.ceil(self.low / step_size)
        end = math.floor(self.high / step_size)
        return [n * step_size for n in range(start, end + 1)]


def _axis_of(values: Sequence[float], label: str, *, from_zero: bool = False) -> _Axis:
    """An axis that holds the values: logarithmic if they are positive and far apart."""
    low, high = min(values), max(values)
    if low > 0 and high / low > 50 and not from_zero:
        return _Axis(low, high, True, label)
    low = min(0.0, low) if from_zero else low
    if low == high:
        low, high = low - 1, high + 1
    return _Axis(low, high, False, label)


def _chart(
    x: Sequence[float],
    lines: Mapping[str, Sequence[float | None]],
    across: _Axis,
    up: _Axis,
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
    return picture.format(_WIDTH, _HEIGHT, told, body) + _legend(list(lines), dots)


def _x(axis: _Axis, value: float) -> float:
    return _LEFT + axis.part(value) * (_WIDTH - _LEFT - _RIGHT)


def _y(axis: _Axis, value: float) -> float:
    return _HEIGHT - _BOTTOM - axis.part(value) * (_HEIGHT - _TOP - _BOTTOM)


def _grid(across: _Axis, up: _Axis) -> list[Markup]:
    line = Markup('<line class="grid" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>')
    text = Markup('<text class="tick" x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>')
    found = []
    for value in across.ticks():
        at = _x(across, value)
        found.append(line.format(at, _TOP, at, _HEIGHT - _BOTTOM))
        found.append(text.format(at, _HEIGHT - _BOTTOM + 16, "middle", f"{value:g}"))
    for value in up.ticks():
        at = _y(up, value)
        found.append(line.format(_LEFT, at, _WIDTH - _RIGHT, at))
        found.append(text.format(_LEFT - 6, at + 4, "end", f"{value:g}"))
    middle = (_LEFT + _WIDTH - _RIGHT) / 2
    found.append(text.format(middle, _HEIGHT - 8, "middle", across.label))
    return found


def _line(points: Sequence[tuple[float, float]], number: int) -> Markup:
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    shape = Markup('<polyline class="line c{}" stroke-dasharray="{}" points="{}"/>')
    return shape.format(number % 4, _DASHES[number % len(_DASHES)], path)


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
