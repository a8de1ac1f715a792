"""Inputs outside their domain, NaN included, are refused with the place of the first."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from gainproof.generated._blocks import BLOCK

if TYPE_CHECKING:
    from gainproof.generated._blocks import Blocks, Parts, Span
    from gainproof.generated._signature import (
        Array,
        Arrays,
        Domain,
        Required,
        Signature,
    )

Refused: TypeAlias = tuple[int, str]
"""The place of an element, and what is said of it."""
ROW = 1024
"""Numbers of a sum of squares: of more, numbers of the domain would often add up to too much, and
from 8193 on libraries take threads, which may have to wait.
"""
LARGEST = (1e38, 1e307)
"""Sums of squares that are looked at: in float32 and float64 none of them has overflowed."""
ENOUGH = 1.001


def doubted(kernel: Signature, blocks: Blocks) -> list[int]:
    """Of the inputs that are looked at once and not block by block, those that a few passes do not
    show to lie in their domain.
    """
    each = enumerate(zip(kernel.inputs, blocks.inputs, blocks.each, strict=True))
    return [place for place, (domain, x, own) in each if not own and not _inside(domain, x)]


def admit(
    kernel: Signature,
    parts: Parts,
    spans: Sequence[Span],
    doubtful: Sequence[int],
    inputs: Arrays,
    shape: tuple[int, ...],
) -> None:
    """ValueError unless the elements of these blocks, which follow each other, lie in the domain of
    every input: with the first that does not, wherever the blocks begin; of several inputs that are
    wrong there, with the first.

    What lies in it is found in few calls, the longer the part the fewer; what does not is looked
    for block by block, as are the inputs that are `doubtful`.
    """
    start, stop = spans[0][0], spans[-1][1]
    # legs come first: they read two inputs at a time from memory, which is faster
    short = [
        required
        for required in kernel.required
        if not _apart(required, [parts.one(x, start, stop) for x in required.leg], stop - start)
    ]
    each = enumerate(zip(kernel.inputs, parts.blocks.inputs, parts.blocks.each, strict=True))
    wrong = [
        place
        for place, (domain, x, own) in each
        if (not _within(domain, x[start:stop]) if own else place in doubtful)
    ]
    if not wrong and not short:
        return
    for begin, end in spans:
        found = [
            _guard(kernel, kernel.inputs[x], parts.one(x, begin, end), begin, inputs[x], shape)
            for x in wrong
        ]
        found += [
            _require(kernel, required, parts.all(begin, end), begin, end, shape)
            for required in short
        ]
        refused = [each for each in found if each is not None]
        if refused:
            raise ValueError(min(refused, key=lambda each: each[0])[1])


def _inside(domain: Domain, x: Array) -> bool:
    """`_within` of an array of any shape, without a copy of the whole."""
    if x.flags.c_contiguous:
        return _within(domain, x.reshape(-1))
    pieces: Any = np.nditer(x, ["external_loop", "buffered"], buffersize=BLOCK)
    return all(_within(domain, piece) for piece in pieces)


def _within(domain: Domain, x: Array) -> bool:
    """Whether a few passes show all elements to lie in the domain; no says nothing. Comparisons
    with NaN are false.
    """
    low, high = domain.single if x.dtype == np.float32 else domain.double
    if domain.signed and not low and _small(x, high):
        return True
    least = -high if domain.signed and not low else low
    for start in range(0, x.size, 2 * BLOCK):  # what is looked at twice is still in the cache
        came = x[start : start + 2 * BLOCK]
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


def _apart(required: Required, leg: Arrays, size: int) -> bool:
    """Whether its leg, the difference of two inputs, shows what is required; no says nothing."""
    if not leg:
        return False
    kind = leg[0].dtype
    # a little more, for the roundings of the root
    least = ENOUGH * (required.single if kind == np.float32 else required.double)
    many, one = sorted(leg, key=np.size, reverse=True)
    if one.size == 1 and abs(one[0]) * np.finfo(kind).epsneg >= least:
        # what is not this number itself is at least so far from it, and comparing is faster
        pieces = (many[start : start + BLOCK] for start in range(0, many.size, BLOCK))
        return not any(np.equal(piece, one).any() for piece in pieces)
    value: Array = np.empty(min(size, BLOCK), kind)
    for start in range(0, size, BLOCK):  # its three passes find it in the cache
        one, other = (x if x.size == 1 else x[start : start + BLOCK] for x in leg)
        apart = np.subtract(one, other, value[: min(BLOCK, size - start)])
        if not np.minimum.reduce(np.absolute(apart, apart)) >= least:
            return False
    return True


def _guard(
    kernel: Signature, domain: Domain, x: Array, start: int, whole: Array, shape: tuple[int, ...]
) -> Refused | None:
    """Of the first element outside the domain; comparisons with NaN are false."""
    low, high = domain.single if x.dtype == np.float32 else domain.double
    came, x = x, np.abs(x) if domain.signed else x
    fine = (x >= low) & (x <= high)
    if domain.zero:
        fine |= x == 0
    if domain.whole:
        fine &= x == np.floor(x)
    if fine.all():
        return None
    first = int(np.argmin(fine))
    where = ""
    if whole.shape:
        index = np.unravel_index(start + first, shape)
        own = tuple(int(i) for i in index[len(shape) - whole.ndim :])
        own = tuple(i if n > 1 else 0 for i, n in zip(own, whole.shape, strict=True))
        where = f" at index {own[0] if len(own) == 1 else own}"
    return start + first, (
        f"{kernel.name}: {domain.name} must be {domain.wanted}, got {came[first]!s}{where}"
    )


def _require(
    kernel: Signature,
    required: Required,
    parts: Arrays,
    start: int,
    stop: int,
    shape: tuple[int, ...],
) -> Refused | None:
    """Of the first place where inputs together are not what they must be."""
    kind = parts[0].dtype
    single = kind == np.float32
    if _apart(required, [parts[place] for place in required.leg], stop - start):
        return None
    value: Array = np.empty(stop - start, kind)
    work: list[Array] = [np.empty_like(value) for _ in range(required.work)]
    required.block(parts, [value], work, single)
    fine = value >= (required.single if single else required.double)
    if fine.all():
        return None
    first = int(np.argmin(fine))
    place = tuple(int(i) for i in np.unravel_index(start + first, shape))
    where = f" at index {place[0] if len(place) == 1 else place}" if shape else ""
    return start + first, (
        f"{kernel.name}: {required.name} must be {required.wanted}, got {value[first]!s}{where}"
    )
