"""Gains to try a filter with, and the errors of kernels against the oracle at them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import flint
from printed_kernels import DTYPES, EPSILON
from printed_pairs import PrintedPair, pairs_of

import gainproof.generated

WORKING = 1200


def kernels_of(family: str) -> dict[str, PrintedPair]:
    """The kernels of several inputs of one module, by name."""
    return {
        kernel.name: kernel
        for folder in gainproof.generated.__path__
        for kernel in pairs_of(family, Path(folder))
    }


def worst_excess(
    kernel: PrintedPair, dtype: str, given: Sequence[Any], truth: Mapping[str, flint.arb]
) -> float:
    """The largest error over what the docstring allows; at most 1 where the kernel keeps it."""
    assert dtype in DTYPES
    values = kernel.function(*given)
    worst = 0.0
    for (output, said), value in zip(kernel.outputs.items(), values, strict=True):
        allowed = said.bound[dtype] * EPSILON[dtype]
        exact = Fraction(float(value))
        error = abs(flint.arb(flint.fmpq(exact.numerator, exact.denominator)) - truth[output])
        limit = abs(truth[said.scale]) * flint.arb(
            flint.fmpq(allowed.numerator, allowed.denominator)
        )
        worst = max(worst, float((error / limit).upper()) if error != 0 else 0.0)
    return worst
