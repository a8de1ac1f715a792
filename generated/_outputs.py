"""Arrays that are given for the outputs: whether they fit, and what they share memory with."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.generated._inputs import another_library

if TYPE_CHECKING:
    from gainproof.generated._signature import Array, Signature


def checked(
    kernel: Signature, out: Any, shape: tuple[int, ...], kind: np.dtype[Any]
) -> list[Array]:
    """The given output arrays. TypeError for what is no array of this type, ValueError for arrays
    that do not fit otherwise; each says which of them.
    """
    if not isinstance(out, tuple) or len(out) != len(kernel.outputs):
        raise ValueError(
            f"{kernel.name}: out must be a tuple of {len(kernel.outputs)} arrays "
            f"({', '.join(kernel.outputs)}), got {type(out).__name__}"
            + (f" of {len(out)}" if isinstance(out, tuple) else "")
        )
    results: list[Any] = list(out)
    for name, y in zip(kernel.outputs, results, strict=True):
        found = another_library(y)
        if found or not isinstance(y, np.ndarray):
            raise TypeError(
                f"{kernel.name}: out {name} must be an array of NumPy, "
                f"got {found or type(y).__name__}"
            )
        if y.dtype != kind:
            raise TypeError(f"{kernel.name}: out {name} must be of type {kind}, got {y.dtype}")
        if y.shape != shape:
            raise ValueError(f"{kernel.name}: out {name} must have shape {shape}, got {y.shape}")
        if not y.flags.writeable:
            raise ValueError(f"{kernel.name}: out {name} must be writable, got a read-only array")
        if not (y.flags.c_contiguous or _apart(y)):
            raise ValueError(f"{kernel.name}: out {name} must not hold its elements at one place")
    for i, y in enumerate(results):
        for j in range(i):
            if overlap(y, results[j]):
                raise ValueError(
                    f"{kernel.name}: out {kernel.outputs[j]} and {kernel.outputs[i]} share memory"
                )
    return results


def _apart(y: Array) -> bool:
    """Whether each step along an axis leads beyond all that the smaller steps reach: then no two
    elements share memory, as they do in a writable `broadcast_to`.
    """
    reach = y.itemsize
    for step, count in sorted(zip(map(abs, y.strides), y.shape, strict=True)):
        if count > 1 and step < reach:
            return False
        reach += step * (count - 1)
    return True


def overlap(x: Array, y: Array) -> bool:
    """Whether two arrays share an element."""
    return np.may_share_memory(x, y) and np.shares_memory(x, y)
