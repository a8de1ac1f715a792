"""The rows of a run in a file of JSON, whole at any moment, from which a run is continued."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.bench import machine
from gainproof.bench.measure import SECONDS, SIZE, Options
from gainproof.bench.memory import bandwidth
from gainproof.bench.timing import ROUNDS
from gainproof.files import input_file, places
from gainproof.jobs import code_digest

FORMAT = "gainproof bench 1"
MOST_BYTES = 10**8
KEYS = frozenset(
    (
        *("subject", "kernel", "domain", "inputs", "outputs"),
        *("cancellations", "seconds", "missing", "errors"),
    )
)
"""What a row holds."""


@dataclass(frozen=True)
class Results:
    """How was measured, and the rows; `rows` and `finished` grow as kernels are measured.

    `conditions`: what rows must have in common to stand in one table; `bandwidth`: gigabytes a
    second; `load`: processes that wanted to run at the beginning; `finished`: the subjects of which
    all kernels are there; `chosen`: those that are wanted.
    """

    conditions: Mapping[str, Any]
    bandwidth: Mapping[str, float]
    load: float | None
    chosen: tuple[str, ...]
    rows: list[dict[str, Any]] = field(default_factory=list)
    finished: list[str] = field(default_factory=list)

    @property
    def complete(self) -> bool:
        """Whether all is measured that is wanted."""
        return set(self.chosen) <= set(self.finished)

    @property
    def outside(self) -> list[tuple[str, str]]:
        """Kernels and outputs of which an error was greater than is proved."""
        return [
            (f"{row['subject']} {row['kernel']}", error["name"])
            for row in self.rows
            for error in row["errors"]
            if error["outside"]
        ]


def conditions(options: Options) -> dict[str, Any]:
    """Machine, versions, settings and code: all that a row depends on but the kernel."""
    front = Path(__file__).resolve().parent
    return {
        "machine": machine.facts(),
        "points": SIZE,
        "rounds": ROUNDS,
        "seconds a call": SECONDS,
        "settings": asdict(options),
        "code": [
            code_digest.of_modules(
                *code_digest.modules_in("derive"), *code_digest.modules_in("generated")
            ),
            code_digest.of_files(front, front.rglob("*.py")),
            code_digest.of_files(
                places.package_folder("generated"), places.package_folder("generated").glob("*.py")
            ),
        ],
    }


def begun(options: Options, chosen: Sequence[str], kept_from: Path | None = None) -> Results:
    """A run at its beginning; with what a file holds of these subjects, if one is given.

    Raises BadInputError for a file from which it cannot be continued.
    """
    now = conditions(options)
    rows, finished = ([], []) if kept_from is None else _kept(kept_from, now)
    rows = [row for row in rows if row["subject"] in chosen]
    finished = [name for name in finished if name in chosen]
    speeds = {name: round(value, 2) for name, value in bandwidth().items()}
    return Results(now, speeds, machine.load(), tuple(chosen), rows, finished)


def as_json(results: Results) -> str:
    """The file; it names its format."""
    return json.dumps({"format": FORMAT, **asdict(results)}, indent=1, allow_nan=False) + "\n"


def _kept(path: Path, now: Mapping[str, Any]) -> tuple[list[dict[str, Any]], list[str]]:
    """Rows and finished subjects of a file that was written under the conditions of now; nothing
    without a file. Other conditions are refused, since ratios of two machines or of two versions do
    not belong in one table.
    """
    shown = places.shown(path)
    if not os.path.lexists(path):
        return [], []
    content = input_file.content(path, MOST_BYTES)
    try:
        data = json.loads(content)
    except (ValueError, RecursionError):
        data = None
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise BadInputError(f"{shown}: a file of `gainproof bench --json` is wanted ({FORMAT!r})")
    then = data.get("conditions")
    if then != json.loads(json.dumps(now)):
        other = [name for name in now if not isinstance(then, dict) or then.get(name) != now[name]]
        raise BadInputError(
            f"{shown}: measured with another {', '.join(other)}; without --resume it is begun anew"
        )
    rows: Any = data.get("rows")
    finished: Any = data.get("finished")
    lists = isinstance(rows, list) and isinstance(finished, list)
    if not lists or not all(isinstance(row, dict) and row.keys() >= KEYS for row in rows):
        raise BadInputError(f"{shown}: its rows are not as `gainproof bench --json` writes them")
    return rows, finished
