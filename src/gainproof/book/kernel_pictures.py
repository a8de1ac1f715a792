"""Pictures of a kernel: its values, and its errors in units in the last place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from gainproof.book.chart import axis_of, chart
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
            chart(
                sampled["x"],
                lines,
                axis_of(sampled["x"], _spoken(sampled["input"])),
                axis_of([value for line in lines.values() for value in line], "value"),
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
                chart(
                    sampled["x"],
                    lines,
                    axis_of(sampled["x"], _spoken(sampled["input"])),
                    axis_of(known, "error in units in the last place", from_zero=True),
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
