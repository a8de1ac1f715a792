"""A block of the sweep: the worst errors of a kernel over a range of float32 numbers."""

from __future__ import annotations

from typing import Any

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.bench.compiler import compiler
from gainproof.campaign.float32.compiled import Compiled, measure
from gainproof.campaign.float32.kernels import Swept, chosen, swept_kernels
from gainproof.campaign.float32.reference import reference
from gainproof.campaign.float32.tally import Tallied

AT_ONCE = 1 << 16
"""Inputs that are given to the kernel together: of fewer, calls take a good part of the time."""


def block(kernel: str, digest: str, first: int, count: int) -> dict[str, Any]:
    """The numbers with the bits `first` and the `count - 1` next ones: how many of them the kernel
    takes, and the tally of each output.

    Raises BadInputError where the kernel is not the one of the digest, as on a machine that has
    other code.
    """
    (swept,) = chosen(swept_kernels(), [kernel])
    if swept.digest() != digest:
        raise BadInputError(
            f"{kernel} is another one where it is swept: install the same gainproof"
        )
    measured = measured_by(swept)
    inputs = 0
    for start in range(first, first + count, AT_ONCE):
        x = np.arange(start, min(start + AT_ONCE, first + count), dtype=np.int32).view(np.float32)
        x = x[x == np.floor(x)] if swept.whole else x
        if x.size:
            inputs += x.size
            measured.add(x, swept.function(x))
    return {"inputs": inputs, "outputs": measured.tallies()}


def measured_by(swept: Swept) -> Compiled | Tallied:
    """In C where there is a compiler, else in NumPy, which takes longer and finds the same."""
    if compiler() is None:
        return Tallied(reference(swept))
    return Compiled(measure(swept), reference(swept).outputs)
