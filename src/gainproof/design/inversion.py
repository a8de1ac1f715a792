"""The parameter at which a kernel has a wanted value, by bisection down to neighbouring floats."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
HALVINGS = 64
"""Bisections of an interval that no more than 2^1100 or so separate in floats: the exponent
first, then 52 bits."""


def solved(
    value: Callable[[Reals], Any], wanted: Reals, low: float, high: float
) -> tuple[Reals, NDArray[np.bool_]]:
    """Parameters between `low` and `high`, both positive, where a monotone function of arrays has
    the wanted values; and whether it takes them on the interval at all.

    The parameter is within a few numbers of the true one; where it is not taken it is an end.
    """
    wanted = np.asarray(wanted, np.float64)
    below, above = np.full(wanted.shape, low), np.full(wanted.shape, high)
    first, last = (np.asarray(value(end)) for end in (below, above))
    rising = last > first
    found = (wanted >= np.minimum(first, last)) & (wanted <= np.maximum(first, last))
    for step in range(2 * HALVINGS):
        # the geometric mean halves exponents, the arithmetic mean bits
        middle = np.sqrt(below) * np.sqrt(above) if step < HALVINGS // 4 else (below + above) / 2
        middle = np.clip(middle, below, above)
        up = (np.asarray(value(middle)) < wanted) == rising
        below, above = np.where(up, middle, below), np.where(up, above, middle)
        if np.all(np.nextafter(below, above) >= above):
            break
    return above, found
