"""Worst error of every kernel output over very many points, beside its stated bound.

    python tests/campaigns/kernel_ulp.py [--points N] [--only TEXT] [--executor WHERE]
                                         [--state FILE]

For every family, argument and format the points are log-uniform over the domain of the bounds
(for a gain half of them, the others in their distance from its upper end), and log-uniform over
1e-6..1e6 for the tracking index. Truth is a ball round the Riccati solution. Kernels of several
arguments have their points over the whole domain, over 1e-6..1e6 and on a grid of half decades;
their truth is their own graph, evaluated in balls. Kernels with signed inputs (filter_step,
polar_coordinates) are left out: they have tests of their own. A campaign that was interrupted goes
on as long as the kernels are the same. Status 1 when a measured error exceeds its bound.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from files_digest import files_digest
from kernel_errors import Worst, log_uniform, measure, near_supremum
from kernel_table import table
from printed_kernels import DTYPES, common_domain, groups, printed_kernels
from printed_pairs import measure_pairs, pair_groups, points_in, printed_pairs

import gainproof.generated
from gainproof.campaign.campaign import Campaign, Done, Report
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options

CHUNK = 500
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


def run(
    family: str, argument: str, dtype: str, span: str, seed: int, _code: str
) -> dict[str, list[Any]]:
    """The worst error of each output over one chunk, where it is, and the number of points."""
    pairs = pair_groups(printed_pairs()).get((family, argument))
    if pairs is not None:
        table = measure_pairs(
            pairs, dtype, lambda pair: points_in(pair, dtype, span, CHUNK, 1000 * seed)
        )
    else:
        kernels = groups(printed_kernels())[family, argument]
        table = measure(kernels, dtype, points_of(Task(family, argument, dtype, span, seed)))
    return {f"{name}.{output}": [w.error, w.at, w.points] for (name, output), w in table.items()}


def report(only: str, done: Sequence[Done]) -> Report:
    """The table of all outputs; a measured error above its bound is wrong."""
    worst: dict[str, Worst] = {}
    for each in done:
        family, _, dtype, span, *_ = each.arguments
        for output, measured in each.result.items():
            key = f"{family}/{output}/{dtype}/{span}"
            worst[key] = worst.get(key, Worst()).joined(Worst(*measured))
    lines, kept = table(worst, only)
    return Report("\n".join(lines), kept)


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--points", type=int, default=100_000, help="of each kind")
    parser.add_argument("--only", default="", help="a part of family/argument/format/span")
    add_options(parser)
    options = parser.parse_args()
    folders = map(Path, gainproof.generated.__path__)
    code = files_digest(file for folder in folders for file in sorted(folder.glob("*.py")))
    blocks = [(*task, code) for task in tasks(options.points, options.only)]
    return carry_out(Campaign("kernel_ulp", run, blocks, partial(report, options.only)), options)


if __name__ == "__main__":
    sys.exit(main())
