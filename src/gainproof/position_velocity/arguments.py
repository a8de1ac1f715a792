"""Arguments checked: positive finite real numbers, or an error with name, value and place."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import place_of

Reals = NDArray[np.float64]


def positive(given: Mapping[str, ArrayLike]) -> tuple[Reals, ...]:
    """The arguments as float64 arrays of their common shape.

    TypeError for what is no real number, ValueError for a number that is not positive and finite
    (NaN included) and for shapes that do not fit.
    """
    arrays = {name: _real(name, value) for name, value in given.items()}
    for name, array in arrays.items():
        require(np.isfinite(array) & (array > 0), array, name, "a number above 0 and finite")
    try:
        return tuple(np.broadcast_arrays(*arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"shapes do not fit together: {shapes}") from None


def require(fine: Any, array: Reals, name: str, wanted: str) -> None:
    """ValueError with the first element of `array` that is not `fine`, and its place."""
    if np.all(fine):
        return
    first = int(np.argmin(fine))
    came = array.flat[first]
    raise ValueError(f"{name} must be {wanted}, got {came!s}{place_of(first, array.shape)}")


def _real(name: str, value: ArrayLike) -> Reals:
    array = np.asarray(value)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, got {array.dtype}")
    return array.astype(np.float64)
