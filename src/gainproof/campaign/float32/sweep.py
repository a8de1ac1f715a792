"""A block of the sweep: the worst errors of a kernel over a range of float32 numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.bad_input import BadInputError
from gainproof.campaign.float32.kernels import Swept, chosen, swept_kernels
from gainproof.campaign.float32.reference import Reference, reference
from gainproof.campaign.float32.tally import Tally, joined, tally

AT_ONCE = 1 << 14
"""Inputs that are looked at together: of more, each array of doubles takes new pages of memory."""


def block(kernel: str, digest: str, first: int, count: int) -> dict[str, Any]:
    """The numbers with the bits `first` and the `count - 1` next ones: how many of them the kernel
    takes, and the tally of each output.

    Raises BadInputError where the kernel is not the one of the digest, as on a machine that has
    other code, and where there is no C compiler.
    """
    (swept,) = chosen(swept_kernels(), [kernel])
    if swept.digest() != digest:
        raise BadInputError(
            f"{kernel} is another one where it is swept: install the same gainproof"
        )
    found = reference(swept.module, swept.name)
    parts = []
    inputs = 0
    for start in range(first, first + count, AT_ONCE):
        x = np.arange(start, min(start + AT_ONCE, first + count), dtype=np.int32).view(np.float32)
        x = x[x == np.floor(x)] if swept.whole else x
        inputs += x.size
        parts.append(_tallies(swept, found, x))
    outputs = {
        output.name: joined([part[row] for part in parts])
        for row, output in enumerate(found.outputs)
    }
    return {"inputs": inputs, "outputs": outputs}


def _tallies(swept: Swept, found: Reference, x: NDArray[np.float32]) -> list[Tally]:
    rows = [np.empty(x.size) for _ in range(found.rows)]
    found.loop([x.astype(np.float64)], rows)
    with np.errstate(all="ignore"):
        return [
            tally(output, x, y, rows[output.value], rows[output.scale])
            for output, y in zip(found.outputs, swept.function(x), strict=True)
        ]
