"""The record of the float32 sweep, `tests/campaigns/float32.md`: its rows, read and written."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path

from gainproof.campaign.float32.kernels import Swept, swept_kernels
from gainproof.campaign.float32.report import HEAD
from gainproof.campaign.float32.stated import Stated

RECORD = Path(__file__).resolve().parents[1] / "campaigns" / "float32.md"
KERNELS: Mapping[str, Swept] = {kernel.id: kernel for kernel in swept_kernels()}
BOUND = HEAD.index("bound")
HALF_OF_THE_LAST_DIGIT = 0.5e-4


@dataclass(frozen=True)
class Recorded:
    """A kernel's lines of the table as texts of cells, one line an output; `whole`: not a part."""

    digest: str
    whole: bool
    inputs: int
    hours: float
    lines: tuple[tuple[str, ...], ...]


@cache
def same_digest() -> Mapping[str, Sequence[str]]:
    """The names of the kernels of each digest, gains first as they are swept."""
    found: dict[str, list[str]] = {}
    for kernel in sorted(KERNELS.values(), key=lambda each: each.name != "gains"):
        found.setdefault(kernel.digest(), []).append(kernel.id)
    return found


def rows_of(text: str) -> Iterator[Recorded]:
    """The kernels of a table."""
    lines = [
        tuple(cell.strip() for cell in line.strip("|\n").split("|"))
        for line in text.splitlines()
        if line.startswith("|") and line.count("|") == len(HEAD) + 1
    ]
    starts = [i for i, cells in enumerate(lines) if "`" in cells[0]]
    for start, stop in pairwise([*starts, len(lines)]):
        first = lines[start]
        match = re.fullmatch(r"[\w., ]+ `([0-9a-f]+)`(.*)", first[0])
        if match is None:
            raise ValueError(f"no row of a kernel: {first}")
        rest = [line for line in lines[start:stop] if line[0] != HEAD[0] and set(line[0]) != {"-"}]
        yield Recorded(match[1], not match[2], int(first[1]), float(first[2]), (*rest,))


def document(rows: Sequence[Recorded]) -> str:
    """The whole record, with the names and bounds that kernels have now."""
    named = [names for row in rows for names in same_digest()[row.digest]]
    inputs = sum(row.inputs * len(same_digest()[row.digest]) for row in rows)
    hours = sum(row.hours for row in rows)
    lines = [line for row in rows for line in _current(row)]
    missing = sorted(KERNELS.keys() - set(named))
    return HEADING.format(
        kernels=len(named),
        all=len(KERNELS),
        inputs=inputs,
        hours=hours,
        table="\n".join(map(_line, [HEAD, ["---"] * len(HEAD), *lines])),
        # five in a hundred more than is lost by writing two digits
        doubt=f"{1.05 * max(e.doubt for k in KERNELS.values() for e in k.stated):.1e}",
        failures=sum(
            fails(line, promise)
            for row in rows
            for line, promise in zip(row.lines, _promises(row), strict=True)
        ),
        missing="\n".join(_by_module(missing)) or "None.",
    )


def fails(line: Sequence[str], promise: Stated) -> bool:
    """Whether an output is not as it is stated now; of its worst error a rounded text is known."""
    cells = dict(zip(HEAD, line, strict=True))
    worst = float(cells["worst"]) + HALF_OF_THE_LAST_DIGIT + promise.doubt
    return not worst <= promise.bound or cells["undocumented"] != "0"


def _promises(row: Recorded) -> Sequence[Stated]:
    return KERNELS[same_digest()[row.digest][0]].stated


def _current(row: Recorded) -> Iterator[Sequence[str]]:
    names = same_digest()[row.digest]
    for number, (line, promise) in enumerate(zip(row.lines, KERNELS[names[0]].stated, strict=True)):
        first = f"{', '.join(names)} `{row.digest}`" if number == 0 else ""
        yield (first, *line[1:BOUND], f"{promise.bound:.2f}", *line[BOUND + 1 :])


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _by_module(names: Iterable[str]) -> Iterator[str]:
    modules: dict[str, list[str]] = {}
    for name in names:
        module, _, kernel = name.partition(".")
        modules.setdefault(module, []).append(kernel)
    for module, kernels in modules.items():
        yield f"- {module}: {', '.join(kernels)}"


HEADING = """\
# Every float32 input

What `gainproof campaign float32` has completed: {kernels} of {all} kernels of one input,
{inputs} inputs, {hours:.2f} hours of one processor. Outputs above their proved bound, NaN, or
outside the documented values where no bound is stated: {failures}.

Judged are the float32 results of the shipped NumPy kernel. `worst` is the largest error in units of
2^-23 of the true value (or of the scale that the docstring names), as the proved bounds; `worst at`
the first input where it is; `ulp` the worst in units in the last place of the same. Truth is the
same graph in double precision: by the bounds proved of float64 the errors are off by at most
{doubt} of these units, which is added before they are compared with their bounds. `outside`
counts the inputs for which no bound is stated, the true value being no normal number;
`undocumented` those of them for which the result is not 0, subnormal or infinite. Kernels named
together are the same arithmetic on the same inputs, and were swept once; inputs count for each.

The digest beside a kernel says what was swept: what it computes, domain and ranges, and what is
measured; where values are kept on the way does not count. It is found by running the block on
names. A row says nothing of a kernel that has another digest by now:
`python tests/campaigns/float32_record.py` drops such rows, and brings in those of a finished
sweep. It wrote this file.

{table}

## Not recorded

{missing}
"""
