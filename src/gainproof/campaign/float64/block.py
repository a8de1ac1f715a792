"""A block of the campaign: seeded points of a range of float64, one in each of equal parts."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.bad_input import BadInputError
from gainproof.campaign.float64.compiled import Compared, Measure, measure_of
from gainproof.campaign.float64.kernels import sampled
from gainproof.derive.printer.kernel import Kernel
from gainproof.subjects.deriving import build

AT_ONCE = 1 << 16
"""Points that are given to the kernel together."""


def block(
    kernel: str, digest: str, low: int, high: int, points: int, first: int, count: int
) -> dict[str, Any]:
    """`count` of the `points` of the numbers with bits from `low` to `high`, from number `first`.

    Raises BadInputError where the kernel is not the one of the digest, as on a machine that has
    other code, where it cannot be compared, and where there are fewer numbers than points.
    """
    (found,) = sampled([kernel])
    if found.digest() != digest:
        raise BadInputError(
            f"{kernel} is another one where it is sampled: install the same gainproof"
        )
    compared = Compared(_measure(kernel), found.swept.signature.outputs, found.ends)
    inputs = 0
    for x in drawn(low, high, points, first, count):
        inputs += x.size
        compared.add(x, found.swept.function(x))
    return {"inputs": inputs, "outputs": compared.tallies()}


def drawn(
    low: int, high: int, points: int, first: int, count: int
) -> Iterator[NDArray[np.float64]]:
    """One number at random in each of `points` parts of equally many; the first part has the least
    of them at its place, the last the greatest.
    """
    width = (high - low + 1) // points
    if width < 1:
        raise BadInputError(f"{points} points are wanted of {high - low + 1} numbers")
    generator = np.random.default_rng([20, first])
    for start in range(first, first + count, AT_ONCE):
        stop = min(start + AT_ONCE, first + count)
        bits = low + width * np.arange(start, stop) + generator.integers(0, width, stop - start)
        if start == 0:
            bits[0] = low
        if stop == points:
            bits[-1] = high
        yield bits.view(np.float64)


@cache
def _measure(kernel: str) -> Measure:
    return measure_of(graph(kernel))


@cache
def graph(kernel: str) -> Kernel:
    """As derived anew; a subject is called as its module, with hyphens."""
    module, _, name = kernel.partition(".")
    (found,) = (k for k in build(module.replace("_", "-")).module.kernels if k.name == name)
    return found
