"""Inputs of a kernel as arrays of one type, and the shape they have in common."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.generated._signature import Array, Signature


CONVERTING = ("__array__", "__array_interface__", "__cuda_array_interface__", "__dlpack__")
"""By what arrays of other libraries become NumPy's: pandas, xarray, torch, dask, JAX, CuPy, ..."""
PLAIN = frozenset({float, int, np.float64, np.float32, np.ndarray})


def as_real(kernel: Signature, given: Sequence[ArrayLike]) -> list[Array]:
    """The inputs as arrays of one type, float64 unless all are float32. TypeError for what is no
    real number of these types, or not of the only type that the kernel has, or an array of another
    library; ValueError for rows of unlike length and for masked elements.
    """
    arrays = [_as_array(kernel, place, x) for place, x in enumerate(given)]
    for domain, x in zip(kernel.inputs, arrays, strict=True):
        if x.dtype.kind not in "iu" and x.dtype.type not in (np.float64, np.float32):
            raise TypeError(
                f"{kernel.name}: {domain.name} must be real numbers of type float64 or float32, "
                f"or integers of at most 64 bits, got {_told(x)}"
            )
    single = all(x.dtype.type is np.float32 for x in arrays)
    kind: np.dtype[Any] = np.dtype(np.float32 if single else np.float64)
    if kernel.only and kind != kernel.only:
        named = ", ".join(
            f"{each.name} {x.dtype}" for each, x in zip(kernel.inputs, arrays, strict=True)
        )
        raise TypeError(
            f"{kernel.name}: only {kernel.only} is here, and inputs must be of it, got {named}"
        )
    return [x if x.dtype == kind else x.astype(kind) for x in arrays]


def common_shape(kernel: Signature, inputs: Sequence[Array]) -> tuple[int, ...]:
    """To which the inputs broadcast; ValueError with the shape of each where they do not."""
    first = inputs[0].shape
    if all(x.shape == first for x in inputs):
        return first
    try:
        return np.broadcast_shapes(*(x.shape for x in inputs))
    except ValueError:
        each = zip(kernel.inputs, inputs, strict=True)
        shapes = ", ".join(f"{domain.name} {x.shape}" for domain, x in each)
        raise ValueError(
            f"{kernel.name}: inputs must have shapes that broadcast, got {shapes}"
        ) from None


def another_library(given: object) -> str:
    """What an array is, and of which library, where that is not NumPy; else nothing. Its type alone
    is asked: nothing is imported, and nothing computed that waits to be.
    """
    kind = type(given)
    if kind in PLAIN:
        return ""
    if isinstance(given, list | tuple):
        if PLAIN.issuperset(map(type, given)):
            return ""
        return next(filter(None, map(another_library, given)), "")
    library = kind.__module__.partition(".")[0]
    if library in ("numpy", "builtins") or not any(hasattr(kind, each) for each in CONVERTING):
        return ""
    return f"{kind.__name__} of {library}"


def _as_array(kernel: Signature, place: int, given: ArrayLike) -> Array:
    name = kernel.inputs[place].name
    if found := another_library(given):
        raise TypeError(
            f"{kernel.name}: {name} must be a number, an array of NumPy or a list, got {found}: "
            "arrays of other libraries are not converted"
        )
    mask = getattr(given, "mask", None)
    # an array would hold what lies under the mask; tables have a method of this name
    if isinstance(mask, np.ndarray | np.bool_) and mask.any():
        first = tuple(int(i) for i in np.argwhere(mask)[0])
        where = f" at index {first[0] if len(first) == 1 else first}" if first else ""
        raise ValueError(
            f"{kernel.name}: {name} must have a number everywhere, got a masked element{where}"
        )
    try:
        return np.asarray(given)
    except ValueError:
        raise ValueError(
            f"{kernel.name}: {name} must be a number or an array of numbers with rows of one "
            f"length, got a {type(given).__name__} that is none"
        ) from None


def _told(x: Array) -> str:
    """What an array of another type holds, in words where the type's name says nothing."""
    if x.dtype.kind in "US":
        return "text"
    if x.dtype.kind != "O":
        return str(x.dtype)
    elements: list[object] = list(x.flat)
    for each in elements:
        if not isinstance(each, int | float | np.integer | np.floating):
            return "None" if each is None else type(each).__name__
    larger = any(isinstance(each, int) and not -(2**63) <= each < 2**64 for each in elements)
    return "a larger one" if larger else "an array of objects"
