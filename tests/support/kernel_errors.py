"""Measured errors of the printed kernels, in units of epsilon, against enclosed truth."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from kernel_truth import truth_at
from numpy.typing import NDArray
from printed_kernels import EPSILON, LARGEST, LEAST_NORMAL, PrintedKernel, common_domain

from gainproof.verify.oracles import distance
from gainproof.verify.oracles.true_values import Truth


@dataclass(frozen=True)
class Worst:
    """The largest error met, in epsilon over the output's scale, where, and at how many points."""

    error: float = 0.0
    at: float | tuple[float, ...] = math.nan
    points: int = 0

    def joined(self, other: Worst) -> Worst:
        larger = self if self.error >= other.error else other
        return Worst(larger.error, larger.at, self.points + other.points)


Table = dict[tuple[str, str], Worst]


def broken_promises(kernels: list[PrintedKernel], dtype: str, table: Table) -> list[str]:
    """What was measured above its stated bound, in words."""
    by_name = {kernel.name: kernel for kernel in kernels}
    return [
        f"{by_name[name].id}.{output} ({dtype}) at {worst.at!r}: {worst.error:.2f} epsilon, "
        f"stated {float(by_name[name].promises[dtype][output].bound)}"
        for (name, output), worst in table.items()
        if math.isinf(worst.error)
        or Fraction(worst.error) > by_name[name].promises[dtype][output].bound
    ]


def measure(kernels: list[PrintedKernel], dtype: str, points: Iterable[float]) -> Table:
    """The worst error of every output of kernels of one family and one argument.

    ``points`` are rounded to the format. Outside an output's promised range the value must be
    what is documented there: an AssertionError says where it is not.
    """
    family, argument = kernels[0].family, kernels[0].argument
    places = np.unique(np.array(list(points)).astype(dtype))
    low, high = common_domain(kernels, dtype)
    places = places[(places >= low) & (places <= high)]
    results = [kernel.function(places) for kernel in kernels]
    guess = _guess(kernels, results)
    table: Table = {}
    for row, place in enumerate(places.tolist()):
        near = None if guess is None else float(guess[row])
        truth = truth_at(family, argument, place, near if near and math.isfinite(near) else None)
        for kernel, result in zip(kernels, results, strict=True):
            for output, column in zip(kernel.outputs, result, strict=True):
                key = kernel.name, output
                found = _at(kernel, output, dtype, place, column[row], truth)
                table[key] = table.get(key, Worst()).joined(found)
    return table


def _guess(
    kernels: Sequence[PrintedKernel], results: Sequence[Sequence[NDArray[np.floating]]]
) -> NDArray[np.floating] | None:
    """The index that the kernels themselves name: a guess for the oracle, never trusted."""
    for kernel, result in zip(kernels, results, strict=True):
        if "tracking_index" in kernel.outputs:
            return result[kernel.outputs.index("tracking_index")]
    return None


def _at(
    kernel: PrintedKernel,
    output: str,
    dtype: str,
    place: float,
    computed: np.floating,
    truth: Mapping[str, Truth],
) -> Worst:
    true = truth[kernel.truth_name(output)]
    value = float(computed)
    if kernel.promises[dtype][output].holds_at(place):
        error = distance.relative_error(value, true.value, true.scale) / float(EPSILON[dtype])
        return Worst(error, place, 1)
    # 0, subnormal or infinite, but for what the rounding next to the ends of the normal range
    # makes of a true value there
    size, edge = abs(value), 2.0**-10
    documented = size <= LEAST_NORMAL[dtype] * (1 + edge) or size >= LARGEST[dtype] * (1 - edge)
    where = f"{kernel.id}.{output} at {place!r} ({dtype})"
    assert documented, f"{where}: {value!r} outside the promised range"
    return Worst()


def log_uniform(lowest: float, highest: float, count: int, seed: int) -> list[float]:
    """Random points between two positive numbers, uniform in the logarithm, with both ends."""
    generator = np.random.default_rng(seed)
    exponents = generator.uniform(math.log2(lowest), math.log2(highest), count)
    whole = np.floor(exponents)
    # 2^-1074.. is subnormal: scaled in two steps
    inner = np.ldexp(np.exp2(exponents - whole), whole.astype(int))
    return [lowest, *np.clip(inner, lowest, highest).tolist(), highest]


def near_supremum(highest: float, count: int, seed: int) -> list[float]:
    """Random points whose distance below ``highest`` is uniform in the logarithm."""
    generator = np.random.default_rng(seed)
    gaps: NDArray[np.float64] = np.exp2(generator.uniform(-54, -1, count))
    return [float(x) for x in highest * (1 - gaps)]
