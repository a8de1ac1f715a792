"""Inputs outside their domain, NaN included, are refused with the place of the first."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from gainproof.derive.printer.shipped._signature import Array, Arrays, Domain, Signature

ENOUGH = 1.001
ROW = 1024
"""Numbers of a sum of squares: of more, numbers of the domain would often add up to too much, and
from 8193 on libraries take threads, which may have to wait.
"""


def admit(
    kernel: Signature, parts: Arrays, start: int, inputs: Arrays, shape: tuple[int, ...]
) -> None:
    """ValueError unless a block of every input lies in its domain; numbers are looked at once."""
    for domain, part, whole in zip(kernel.inputs, parts, inputs, strict=True):
        if not start or whole.size > 1:
            _guard(kernel, domain, part, start, whole, shape)
    _require(kernel, parts, start, shape)


def _guard(
    kernel: Signature, domain: Domain, x: Array, start: int, whole: Array, shape: tuple[int, ...]
) -> None:
    """ValueError with the first element outside the domain; comparisons with NaN are false."""
    low, high = domain.single if x.dtype == np.float32 else domain.double
    if domain.signed and not low and _small(x, high):
        return
    came, x = x, np.abs(x) if domain.signed and low else x
    least = -high if domain.signed and not low else low
    inside = not x.size or bool(np.minimum.reduce(x) >= least and np.maximum.reduce(x) <= high)
    if inside and not (domain.whole and np.any(x != np.floor(x))):
        return
    x = np.abs(x) if domain.signed else x
    fine = (x >= low) & (x <= high)
    if domain.zero:
        fine |= x == 0
    if domain.whole:
        fine &= x == np.floor(x)
    if fine.all():
        return
    first = int(np.argmin(fine))
    where = ""
    if whole.shape:
        index = np.unravel_index(start + first, shape)
        own = tuple(int(i) for i in index[len(shape) - whole.ndim :])
        own = tuple(i if n > 1 else 0 for i, n in zip(own, whole.shape, strict=True))
        where = f" at index {own[0] if len(own) == 1 else own}"
    raise ValueError(
        f"{kernel.name}: {domain.name} must be {domain.wanted}, got {came[first]!s}{where}"
    )


def _small(x: Array, high: float) -> bool:
    """Whether sums of squares, one pass that is as fast as memory, show all magnitudes to be at
    most `high`; no says nothing.
    """
    limit = high * high / 2
    whole = x.size - x.size % ROW
    if whole:
        rows = x[:whole].reshape(-1, ROW)
        if not np.maximum.reduce(np.vecdot(rows, rows)) <= limit:
            return False
    rest = x[whole:]
    return not rest.size or bool(np.vecdot(rest, rest) <= limit)


def _require(kernel: Signature, parts: Arrays, start: int, shape: tuple[int, ...]) -> None:
    """ValueError with the first place where inputs together are not what they must be."""
    for required in kernel.required:
        kind = parts[0].dtype
        single = kind == np.float32
        least = required.single if single else required.double
        value: Array = np.empty(parts[0].shape, kind)
        if required.leg is not None and value.size:
            required.leg(parts, [value], (), single)
            # a little more, for the roundings of the root
            if np.minimum.reduce(np.absolute(value, value)) >= ENOUGH * least:
                continue
        work: list[Array] = [np.empty_like(value) for _ in range(required.work)]
        required.block(parts, [value], work, single)
        fine = value >= least
        if not fine.all():
            first = int(np.argmin(fine))
            place = tuple(int(i) for i in np.unravel_index(start + first, shape))
            where = f" at index {place[0] if len(place) == 1 else place}" if shape else ""
            raise ValueError(
                f"{kernel.name}: {required.name} must be {required.wanted}, "
                f"got {value[first]!s}{where}"
            )
