"""The table of measured errors of kernels, beside what their docstrings state."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby
from typing import NamedTuple

from kernel_errors import Worst
from printed_kernels import DTYPES, printed_kernels
from printed_pairs import printed_pairs

SPANS = ("domain", "near", "grid")


class Said(NamedTuple):
    """What a docstring says of one output in one format; `argument` as in the key of a task."""

    kernel: str
    argument: str
    output: str
    dtype: str
    where: str
    bound: Fraction

    def chosen(self, only: str) -> bool:
        """Whether any chunk of this output has the text in its key, as `tasks` chooses them."""
        family = self.kernel.split(".")[0]
        return any(only in f"{family}/{self.argument}/{self.dtype}/{span}" for span in SPANS)


def statements() -> Iterator[Said]:
    """The bounds of all outputs in both formats."""
    for kernel in printed_kernels():
        for dtype in DTYPES:
            for output in kernel.outputs:
                promise = kernel.promises[dtype][output]
                where = f"{promise.lowest:.3g}..{promise.highest:.3g}"
                yield Said(kernel.id, kernel.argument, output, dtype, where, promise.bound)
    for pair in printed_pairs():
        for dtype in DTYPES:
            where = ranges(pair.domain[dtype])
            for output, stated in pair.outputs.items():
                arguments = ",".join(pair.arguments)
                yield Said(pair.id, arguments, output, dtype, where, stated.bound[dtype])


def ranges(domain: Sequence[tuple[float, float]]) -> str:
    """The ranges of the arguments, neighbours of one range together."""
    same = [
        (text, len(list(each))) for text, each in groupby(f"{a:.3g}..{b:.3g}" for a, b in domain)
    ]
    return " x ".join(text if count == 1 else f"({text})^{count}" for text, count in same)


def table(worst: Mapping[str, Worst], only: str) -> tuple[list[str], bool]:
    """Lines of the table, and whether every measured error keeps its bound. `worst` is by family,
    kernel and output, format and span.
    """
    head = ("output", "format", "range of the bound", "bound", "domain", "1e-6..1e6", "grid")
    rows, kept = [], True
    for said in statements():
        start = f"{said.kernel.replace('.', '/', 1)}.{said.output}/{said.dtype}"
        measured = [worst.get(f"{start}/{span}", Worst()) for span in SPANS]
        count = sum(each.points for each in measured)
        if not count or not said.chosen(only):
            continue
        kept &= all(each.error <= said.bound for each in measured)
        name = f"{said.kernel}.{said.output}"
        errors = (f"{w.error:.2f}" if w.points else "" for w in measured)
        rows.append((name, said.dtype, said.where, f"{float(said.bound):.2f}", *errors, str(count)))
    widths = [max(map(len, column)) for column in zip((*head, "points"), *rows, strict=True)]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in ((*head, "points"), *rows)
    ]
    return ["errors in units of 2^-52 (float64) and 2^-23 (float32)", *lines], kept
