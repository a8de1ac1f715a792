"""How long a start is remembered."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import finite

PER_CENT = 0.01


def samples_to_settle(poles: ArrayLike, share: float = PER_CENT) -> NDArray[np.float64]:
    """Samples until the largest closed-loop pole's modulus, to that power, is at most `share`.

    poles: complex, the last axis holds those of one filter, as `poles` of two and three states
    give them. Whole numbers as floats, at least 1; infinity where a pole is not inside the unit
    circle. It says how fast a start decays in the end; a filter with a double pole takes longer.
    Where all n poles are 0 it is n: then the start is gone, and not before.

    ValueError where `share` is not between 0 and 1, for NaN and for no pole; TypeError for what is
    no number.
    """
    (wanted,) = finite({"share": share})
    if not ((wanted > 0) & (wanted < 1)).all():
        raise ValueError(f"share must be between 0 and 1, got {share!r}")
    array: NDArray[Any] = np.asarray(poles)
    if array.dtype.kind not in "iufc":
        raise TypeError(f"poles must be numbers, got {array.dtype}")
    if not array.ndim or not array.shape[-1]:
        raise ValueError(f"the last axis must hold the poles of one filter, got {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError("poles must be finite")
    with np.errstate(over="ignore"):
        largest = np.abs(array).max(axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        count = np.ceil(np.log(wanted) / np.log(largest))
    # of one measured position the loop is a single block: n poles at 0 take n samples
    count = np.where(largest == 0, float(array.shape[-1]), np.maximum(count, 1.0))
    return np.asarray(np.where(largest < 1, count, np.inf))[()]
