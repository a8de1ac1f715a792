"""Arguments checked: finite real numbers of shapes that fit, or an error with name and place."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

Reals = NDArray[np.float64]
Real = np.float64 | Reals


def finite(given: Mapping[str, ArrayLike]) -> tuple[Reals, ...]:
    """The arguments as float64 arrays of their common shape.

    TypeError for what is no real number; ValueError for NaN and infinity, with the first place, and
    for shapes that do not broadcast.
    """
    arrays = {name: real(name, value) for name, value in given.items()}
    try:
        np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"shapes do not fit together: {shapes}") from None
    return tuple(np.broadcast_arrays(*arrays.values()))


def real(name: str, value: ArrayLike) -> Reals:
    """A float64 array without NaN and infinity."""
    try:
        array = np.asarray(value)
    except ValueError:
        raise ValueError(
            f"{name} must be a number or an array, got rows of unlike lengths"
        ) from None
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, got {array.dtype}")
    wide = array
    with np.errstate(over="ignore"):
        array = array.astype(np.float64)
    fine = np.isfinite(array)
    if not fine.all():
        first = int(np.argmin(fine))
        came = wide.flat[first]
        if np.isfinite(came):
            place = place_of(first, array.shape)
            raise ValueError(f"{name} must be a number that float64 holds, got {came!s}{place}")
        raise ValueError(f"{name} must be finite, got {came!s}{place_of(first, array.shape)}")
    return array


def place_of(first: int, shape: tuple[int, ...]) -> str:
    """Where the element of this number stands, in words; nothing to say of a single number."""
    place = tuple(int(i) for i in np.unravel_index(first, shape))
    return "" if not place else f" at index {place[0] if len(place) == 1 else place}"
