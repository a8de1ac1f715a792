"""Inputs outside their domain, NaN included, are refused with the place of the first."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from gainproof.derive.printer.shipped._signature import (
        Array,
        Arrays,
        Domain,
        Required,
        Signature,
    )

SIZE = 65536
"""Elements of a block of many arrays: calls cost little beside it, and they stay in the cache."""
MANY = 17
LEG = SIZE // 2
"""Elements of a leg at once: its three passes find it in the second-level cache."""
ROW = 1024
"""Numbers of a sum of squares: of more, numbers of the domain would often add up to too much, and
from 8193 on libraries take threads, which may have to wait.
"""
LARGEST = (1e38, 1e307)
"""Sums of squares that are looked at: in float32 and float64 none of them has overflowed."""
ENOUGH = 1.001


def admit(
    kernel: Signature,
    flat: Arrays,
    start: int,
    stop: int,
    inputs: Arrays,
    shape: tuple[int, ...],
) -> None:
    """ValueError unless the elements from `start` to `stop` of every input lie in its domain.

    What lies in it is found in few calls, the longer the part the fewer; what does not is looked
    for block by block. An input of one number, which `flat` holds as it is, is looked at once.
    """
    size = max(x.size for x in flat)
    long = parts_of(flat, start, stop, size)
    # legs come first: they read two inputs at a time from memory, which is faster
    short = [each for each in kernel.required if not _apart(each, long, stop - start)]
    each = enumerate(zip(kernel.inputs, long, inputs, strict=True))
    doubted = [
        place
        for place, (domain, x, whole) in each
        if (not start or whole.size > 1) and not _within(domain, x)
    ]
    if not doubted and not short:
        return
    step = block_length(kernel)
    for begin in range(start, stop, step):
        parts = parts_of(flat, begin, min(begin + step, stop), size)
        for place in doubted:
            domain, whole = kernel.inputs[place], inputs[place]
            _guard(kernel, domain, parts[place], begin, whole, shape)
        for required in short:
            _require(kernel, required, parts, begin, shape)


def block_length(kernel: Signature) -> int:
    """Elements of a block: a few arrays stay in the cache where it is half as long again.

    By `gainproof bench --against length`, with 1 MB of second-level and 32 MB of last-level cache:
    of 4,096 elements kernels take 60 to 80 % more time, of 16,384 10 to 20 %, of 32,768 4 to 8 %,
    of 65,536 to 131,072 the same within 3 %, of 262,144 3 to 12 % more.
    """
    arrays = len(kernel.inputs) + len(kernel.outputs) + kernel.work
    return SIZE if arrays >= MANY else 3 * SIZE // 2


def parts_of(flat: Arrays, start: int, stop: int, size: int) -> list[Array]:
    """The block of each input; one number is the same in every block."""
    return [x[start:stop] if x.size == size else x for x in flat]


def _within(domain: Domain, x: Array) -> bool:
    """Whether a few passes show all elements to lie in the domain; no says nothing. Comparisons
    with NaN are false.
    """
    low, high = domain.single if x.dtype == np.float32 else domain.double
    if domain.signed and not low and _small(x, high):
        return True
    least = -high if domain.signed and not low else low
    for start in range(0, x.size, 2 * SIZE):  # what is looked at twice is still in the cache
        came = x[start : start + 2 * SIZE]
        if domain.whole and np.any(came != np.floor(came)):
            return False
        y = np.abs(came) if domain.signed and low else came
        if not (np.minimum.reduce(y) >= least and np.maximum.reduce(y) <= high):
            return False
    return True


def _small(x: Array, high: float) -> bool:
    """Whether sums of squares, one pass that is as fast as memory, show all magnitudes to be at
    most `high`; no says nothing.
    """
    # half of a square leaves room for the roundings of the sum; squares below 1 might underflow
    limit = min(high * high / 2, LARGEST[x.dtype == np.float64]) if high >= 1 else -1.0
    whole = x.size - x.size % ROW
    if whole:
        rows = x[:whole].reshape(-1, ROW)
        if not np.maximum.reduce(np.vecdot(rows, rows)) <= limit:
            return False
    rest = x[whole:]
    return not rest.size or bool(np.vecdot(rest, rest) <= limit)


def _apart(required: Required, parts: Arrays, size: int) -> bool:
    """Whether its leg alone shows what is required; no says nothing."""
    if required.leg is None:
        return False
    kind = parts[0].dtype
    single = kind == np.float32
    # a little more, for the roundings of the root
    least = ENOUGH * (required.single if single else required.double)
    value: Array = np.empty(min(size, LEG), kind)
    for start in range(0, size, LEG):
        stop = min(start + LEG, size)
        leg = value[: stop - start]
        required.leg(parts_of(parts, start, stop, size), [leg], (), single)
        if not np.minimum.reduce(np.absolute(leg, leg)) >= least:
            return False
    return True


def _guard(
    kernel: Signature, domain: Domain, x: Array, start: int, whole: Array, shape: tuple[int, ...]
) -> None:
    """ValueError with the first element outside the domain; comparisons with NaN are false."""
    low, high = domain.single if x.dtype == np.float32 else domain.double
    came, x = x, np.abs(x) if domain.signed else x
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


def _require(
    kernel: Signature, required: Required, parts: Arrays, start: int, shape: tuple[int, ...]
) -> None:
    """ValueError with the first place where inputs together are not what they must be."""
    kind = parts[0].dtype
    single = kind == np.float32
    length = max(x.size for x in parts)
    if _apart(required, parts, length):
        return
    value: Array = np.empty(length, kind)
    work: list[Array] = [np.empty_like(value) for _ in range(required.work)]
    required.block(parts, [value], work, single)
    fine = value >= (required.single if single else required.double)
    if not fine.all():
        first = int(np.argmin(fine))
        place = tuple(int(i) for i in np.unravel_index(start + first, shape))
        where = f" at index {place[0] if len(place) == 1 else place}" if shape else ""
        raise ValueError(
            f"{kernel.name}: {required.name} must be {required.wanted}, got {value[first]!s}{where}"
        )
