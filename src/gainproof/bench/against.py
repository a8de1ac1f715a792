"""Nanoseconds a point, against the length of a block and against the number of points."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator

import numpy as np

from gainproof.bench.arguments import Arguments, sample, with_constants
from gainproof.bench.measure import SIZE
from gainproof.bench.subjects import Measured, measured_kernels
from gainproof.bench.timing import best_times
from gainproof.generated._blocks import BLOCK, cut
from gainproof.generated._runtime import Call, run

LENGTHS = tuple(sorted({4096, 8192, 16384, 32768, 49152, 65536, 98304, 131072, BLOCK}))
SIZES = (100_000, 300_000, 1_000_000, 3_000_000, 10_000_000)
POINTS = 15 * SIZE
"""How many points a number is measured at, all its rounds together, so that none takes long."""


def print_against(options: argparse.Namespace) -> None:
    """One table, kernel by kernel."""
    by_length = options.against == "length"
    places = LENGTHS if by_length else SIZES
    print("nanoseconds a point, outputs preallocated but in `fresh`; each the best of several\n")
    print(_row("kernel", [f"{place:,}" for place in places]))
    subject = ""
    for item in measured_kernels(options.subject):
        if item.subject != subject:
            subject = item.subject
            print(subject)
        if by_length:
            times = lengths(item, options.constant)
            cells = [f"{'*' if at == BLOCK else ''}{time:.2f}" for at, time in times.items()]
            print(_row(f"  {item.kernel.name}", cells), flush=True)
        else:
            for name, found in sizes(item, options.workers, options.constant):
                print(
                    _row(f"  {item.kernel.name}, {name}", [f"{x:.2f}" for x in found]), flush=True
                )


def lengths(item: Measured, constant: str | None = None) -> dict[int, float]:
    """Of a million points, guards included; by length."""
    given = _given(item, SIZE, constant)
    inputs = [np.asarray(each) for each in given]
    outputs = [np.empty(SIZE) for _ in item.kernel.outputs]

    def filled(length: int) -> Callable[[], object]:
        blocks = cut(inputs, outputs[0].shape, length, results=outputs)
        return lambda: run(Call(item.signature, inputs, blocks, outputs, False), [blocks.spans])

    with np.errstate(all="ignore"):
        best = best_times({str(length): filled(length) for length in LENGTHS}, POINTS // SIZE)
    return {length: best[str(length)] * 1e9 / SIZE for length in LENGTHS}


def sizes(
    item: Measured, workers: int, constant: str | None = None
) -> Iterator[tuple[str, list[float]]]:
    """For given arrays, fresh ones, and threads: times by size."""
    rows: dict[str, list[float]] = {}
    for size in SIZES:
        calls = _calls(item, size, workers, constant)
        threaded = [name for name in calls if name.endswith("threads")]
        best = best_times(calls, max(5, POINTS // size), threaded=threaded)
        for name, seconds in best.items():
            rows.setdefault(name, []).append(seconds * 1e9 / size)
    yield from rows.items()


def _calls(
    item: Measured, size: int, workers: int, constant: str | None
) -> dict[str, Callable[[], object]]:
    given = _given(item, size, constant)
    outputs = tuple(np.empty(size) for _ in item.kernel.outputs)
    return {
        "given": lambda: item.function(*given, out=outputs),
        "fresh": lambda: item.function(*given),
        f"{workers} threads": lambda: item.function(*given, out=outputs, workers=workers),
    }


def _given(item: Measured, size: int, constant: str | None) -> Arguments:
    """Of more than a million the same million again and again."""
    columns = sample(item.signature, min(size, SIZE))
    return with_constants(item.signature, [np.resize(x, size) for x in columns], constant)


def _row(name: str, cells: list[str]) -> str:
    return f"{name:<44}" + "".join(f"{cell:>12}" for cell in cells)
