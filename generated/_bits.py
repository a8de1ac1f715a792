"""Choices and starts of roots by the bits of numbers, many at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from gainproof.generated._signature import Array


def mask_of(condition: NDArray[np.bool_], single: bool) -> NDArray[Any]:
    """All bits set where the condition holds, as integers as wide as the numbers."""
    kind = np.int32 if single else np.int64
    mask: NDArray[Any] = np.negative(condition.view(np.int8), dtype=kind)
    return mask


def choose(mask: NDArray[Any], x: Array | float, y: Array | float, out: Array) -> Array:
    """x where the mask is set, else y: bit by bit, since a masked copy waits for every branch.

    `out` may be x or y, or both may be numbers.
    """
    if x is y:
        np.copyto(out, x)
        return out
    kind = mask.dtype
    bits = out.view(kind)
    first, second = (np.asarray(each, out.dtype).view(kind) for each in (x, y))
    if out is y:
        mask, first, second = ~mask, second, first
    np.bitwise_xor(first, second, out=bits)
    np.bitwise_and(bits, mask, out=bits)
    np.bitwise_xor(bits, second, out=bits)
    return out


def near_cbrt(x: Array, out: Array, single: bool) -> Array:
    """Numbers within 3.3 % of the cube roots of positive normal numbers: a third of their bits."""
    kind = np.int32 if single else np.int64
    bits = out.view(kind)
    np.floor_divide(x.view(kind), 3, bits)
    np.add(bits, 709958653 if single else 3071306327078975046, bits)
    return out
