"""What memory alone would take: arrays read once, arrays written once."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from gainproof.bench.arguments import Arguments
from gainproof.bench.timing import best_times

LARGE = 16_000_000
"""Numbers of an array that no cache holds: 128 MB."""


def touched(given: Arguments, outputs: Sequence[NDArray[np.float64]]) -> Callable[[], object]:
    """A call that reads each input array once, as their maxima, and fills each output once.

    These are the arrays of the kernel, so that what a cache holds of them it holds for both.
    """
    arrays = [each for each in given if isinstance(each, np.ndarray)]

    def call() -> None:
        for array in arrays:
            array.max()
        for output in outputs:
            output.fill(1.0)

    return call


def bandwidth(size: int = LARGE) -> dict[str, float]:
    """Gigabytes a second of one thread, by reading (maximum), writing (fill) and copying.

    Copying counts what is read and what is written. What the processor reads of a line before it
    writes to it is not counted.
    """
    source, target = np.ones(size), np.empty(size)
    calls: dict[str, Callable[[], object]] = {
        "reading": source.max,
        "writing": lambda: target.fill(2.0),
        "copying": lambda: np.copyto(target, source),
    }
    moved = {"reading": 8.0, "writing": 8.0, "copying": 16.0}
    best = best_times(calls, rounds=7)
    return {name: moved[name] * size / seconds / 1e9 for name, seconds in best.items()}
