"""The table of `gainproof bench`."""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from gainproof.bench.compiler import FLAGS, compiler
from gainproof.bench.measure import SIZE, Figures, figures
from gainproof.bench.subjects import measured_kernels
from gainproof.bench.timing import ROUNDS

WIDE = 36
HEADER = (
    "over C",
    "threads/C",
    "passes/C",
    "lambdify over",
    "fresh",
    "SciPy over",
    "worst eps",
    "proved eps",
)


def print_table(options: argparse.Namespace) -> None:
    """Measure and print kernel by kernel, so that a long run shows where it is."""
    command = compiler()
    if command is None:
        print("no C compiler found (cc, gcc, clang): the C column is left out", file=sys.stderr)
    else:
        print(f"C: {command} {' '.join(FLAGS[:-2])}")
    print(
        f"{SIZE} points, outputs preallocated but in `fresh`, guards in the kernel only, "
        f"{options.workers} threads where said, best of {ROUNDS}\n"
    )
    print(_row("kernel", *HEADER))
    with tempfile.TemporaryDirectory() as folder:
        subject = ""
        for item in measured_kernels(options.subject):
            if item.subject != subject:
                subject = item.subject
                print(f"{subject}")
            found = figures(item, Path(folder), options.workers, options.constant)
            print(_row(f"  {item.kernel.name}", *_cells(found)), flush=True)


def _cells(found: Figures) -> tuple[str, ...]:
    return (
        _ratio(found.over_c),
        _ratio(found.shared_over_c),
        _ratio(found.passes_over_c),
        _ratio(found.under_lambdify),
        _ratio(found.fresh_under_lambdify),
        _ratio(found.under_solver),
        f"{found.worst:.2f}",
        f"{found.proved:.2f}",
    )


def _ratio(value: float | None) -> str:
    if value is None:
        return "-"
    return f"{value:,.0f}x" if value >= 100 else f"{value:.2f}x"


def _row(name: str, *cells: str) -> str:
    widths = (len(each) + 2 for each in HEADER)
    return f"{name:<{WIDE}}" + "".join(
        f"{cell:>{width}}" for cell, width in zip(cells, widths, strict=True)
    )
