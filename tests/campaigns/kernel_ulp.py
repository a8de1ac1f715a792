"""Worst error of every kernel output over very many points, beside its stated bound.

    python tests/campaigns/kernel_ulp.py [--points N] [--jobs N] [--state FILE] [--only TEXT]

For every family, argument and format the points are log-uniform over the domain of the bounds
(for a gain half of them, the others in their distance from its upper end), and log-uniform over
1e-6..1e6 for the tracking index. Truth is a ball round the Riccati solution. Kernels of several
arguments have their points over the whole domain, over 1e-6..1e6 and on a grid of half decades;
their truth is their own graph, evaluated in balls. Kernels with signed inputs (filter_step,
polar_coordinates) are left out: they have tests of their own. The state file is
written every few chunks; a campaign that was interrupted goes on from it as long as the kernels
are the same, and one that is complete prints its table at once. Status 1 when a measured error
exceeds its bound.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any, NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from kernel_errors import Worst, log_uniform, measure, near_supremum
from kernel_table import table
from printed_kernels import DTYPES, common_domain, groups, printed_kernels
from printed_pairs import measure_pairs, pair_groups, points_in, printed_pairs
from saved_state import save
from spoken_lines import say, tell

import gainproof.generated

CHUNK = 500
Found = dict[str, tuple[float, Any, int]]
HELP = "worst error of every kernel output over very many points, beside its stated bound; "
HELP += "none of the kernels with signed inputs, which have tests of their own"


class Task(NamedTuple):
    """A chunk of random points of one family, argument, format and span."""

    family: str
    argument: str
    dtype: str
    span: str
    seed: int

    @property
    def key(self) -> str:
        return "/".join(map(str, self))


def tasks(points: int, only: str) -> Iterator[Task]:
    """All chunks, one of each kind before the second of any."""
    for seed in range(-(-points // CHUNK)):
        for family, argument in groups(printed_kernels()):
            spans = ["domain", "near"] if argument == "tracking_index" else ["domain"]
            for span in spans:
                for dtype in DTYPES:
                    task = Task(family, argument, dtype, span, seed)
                    if only in task.key:
                        yield task
        for family, arguments in pair_groups(printed_pairs()):
            for span in ("grid", "domain", "near") if seed == 0 else ("domain", "near"):
                for dtype in DTYPES:
                    task = Task(family, arguments, dtype, span, seed)
                    if only in task.key:
                        yield task


def points_of(task: Task) -> list[float]:
    """The points of a chunk, the same for the same task."""
    kernels = groups(printed_kernels())[task.family, task.argument]
    # where at least one output has its bound: beyond, there is nothing to measure
    promises = [promise for kernel in kernels for promise in kernel.promises[task.dtype].values()]
    low, high = common_domain(kernels, task.dtype)
    low = max(low, min(promise.lowest for promise in promises))
    high = min(high, max(promise.highest for promise in promises))
    seed = 1000 * task.seed + DTYPES.index(task.dtype)
    if task.span == "near":
        return log_uniform(1e-6, 1e6, CHUNK, seed)
    if task.argument == "sample_number":
        return [float(round(x)) for x in log_uniform(max(low, 1), high, CHUNK, seed)]
    if task.argument == "tracking_index":
        return log_uniform(low, high, CHUNK, seed)
    return log_uniform(low, high, CHUNK // 2, seed) + near_supremum(high, CHUNK // 2, seed)


def run(task: Task) -> Found:
    """The worst error of each output over one chunk."""
    pairs = pair_groups(printed_pairs()).get((task.family, task.argument))
    if pairs is not None:
        table = measure_pairs(
            pairs,
            task.dtype,
            lambda pair: points_in(pair, task.dtype, task.span, CHUNK, 1000 * task.seed),
        )
    else:
        kernels = groups(printed_kernels())[task.family, task.argument]
        table = measure(kernels, task.dtype, points_of(task))
    return {f"{name}.{output}": (w.error, w.at, w.points) for (name, output), w in table.items()}


def load(path: Path) -> dict[str, Any]:
    """What was measured of these very kernels; nothing when they have changed since."""
    kernels = digest()
    if path.exists():
        state: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if state["kernels"] == kernels:
            return state
        sys.stderr.write(f"{path} is about other kernels: starting anew\n")
    return {"kernels": kernels, "done": [], "worst": {}}


def digest() -> str:
    """A digest of the text of all generated modules."""
    found = hashlib.sha256()
    for folder in gainproof.generated.__path__:
        for file in sorted(Path(folder).glob("*.py")):
            found.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return found.hexdigest()


def note(state: dict[str, Any], task: Task, found: Found) -> None:
    for output, measured in found.items():
        key = f"{task.family}/{output}/{task.dtype}/{task.span}"
        before = Worst(*state["worst"].get(key, (0.0, 0.0, 0)))
        state["worst"][key] = list(vars(before.joined(Worst(*measured))).values())
    state["done"].append(task.key)


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--points", type=int, default=100_000, help="of each kind")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--state", type=Path, default=Path("kernel_ulp.state.json"))
    parser.add_argument("--only", default="", help="a part of family/argument/format/span")
    options = parser.parse_args()
    state = load(options.state)
    done = set(state["done"])
    todo = [task for task in tasks(options.points, options.only) if task.key not in done]
    start = time.monotonic()
    with ProcessPoolExecutor(options.jobs) as pool:
        for count, (task, found) in enumerate(finished(pool, todo, options.jobs), 1):
            note(state, task, found)
            if count % 20 and count < len(todo):
                continue
            save(options.state, state)
            left = (time.monotonic() - start) / count * (len(todo) - count)
            tell(f"{count}/{len(todo)} chunks, about {left / 60:.1f} min left", count == len(todo))
    lines, kept = table(state, options.only)
    for line in lines:
        say(line)
    return 0 if kept else 1


def finished(
    pool: ProcessPoolExecutor, todo: list[Task], jobs: int
) -> Iterator[tuple[Task, Found]]:
    """Results as they come, with few chunks in hand so that an interrupt is quick."""
    for start in range(0, len(todo), 8 * jobs):
        pending = {pool.submit(run, task): task for task in todo[start : start + 8 * jobs]}
        for future in as_completed(pending):
            yield pending[future], future.result()


if __name__ == "__main__":
    sys.exit(main())
