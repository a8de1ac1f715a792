"""Blocks of a call, and what each input has for one of them.

A block is a piece of the results in their order: a part of one axis, whole beyond it. An input that
is the same along some axes is never written out in full: for a block it is one number, a piece of
its own, or spread into a buffer.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from gainproof.generated._signature import Array, Arrays

Span: TypeAlias = tuple[int, int]
"""Of a block, its first element and the one after its last."""
FEW = 8
"""Of a last axis shorter than this NumPy spreads column by column faster than row by row."""
BLOCK = 24576
"""Elements of a block. With 1 MB of second-level cache, by `gainproof bench --against length` and
all kernels alike, blocks of 32,768 elements take 2 % more time, of 16,384 as much; shorter ones
more, since each call of NumPy costs a microsecond, and two threads wait for each other at each.
"""
LINE = 64
"""Bytes of a line of the cache. Where a buffer begins within one, a sum or product that is written
to it takes twice as long on some processors.
"""


class Blocks(NamedTuple):
    """Results of this `shape` are cut along `axis`; beyond it lie `beyond` elements.

    `inputs`: those that are `plain` have one axis, and on it one number or, in one piece, `each`
    element's own; the others have the axes of the results, of length 1 where they are the same all
    along.
    """

    shape: tuple[int, ...]
    axis: int
    beyond: int
    inputs: list[Array]
    plain: list[bool]
    each: list[bool]
    spans: list[Span]

    @property
    def length(self) -> int:
        """Elements of the longest block."""
        return max((stop - start for start, stop in self.spans), default=0)

    def window(self, x: Array, start: int, stop: int) -> Array:
        """What an array with the axes of the results has for a block, not copied; it is of length 1
        where the array is the same all along.
        """
        *row, first = np.unravel_index(start // self.beyond, self.shape[: self.axis + 1])
        at = [number if many > 1 else 0 for number, many in zip(row, x.shape, strict=False)]
        count = (stop - start) // self.beyond
        along = slice(first, first + count) if x.shape[self.axis] > 1 else slice(None)
        window: Array = x[(*at, along)]
        return window

    def box(self, flat: Array) -> Array:
        """The elements of a block with the axes of its window."""
        return flat.reshape(-1, *self.shape[self.axis + 1 :])


def rows(count: int, length: int, kind: np.dtype[Any]) -> list[Array]:
    """So many buffers of `length` elements, each from the beginning of a line of the cache; in one
    piece, which the allocator keeps for the next call: its pages are mapped but once.
    """
    line = LINE // kind.itemsize
    step = -(-length // line) * line
    piece = np.empty(count * step + line, kind)
    first = lead(piece)
    return [*piece[first : first + count * step].reshape(count, step)[:, :length]]


def lead(x: Array) -> int:
    """How many elements lie before the first one that begins a line of the cache."""
    return int(-x.ctypes.data % LINE // x.itemsize)


def cut(inputs: Arrays, shape: tuple[int, ...], length: int, *, results: Arrays = ()) -> Blocks:
    """Blocks of at most `length` elements. Where all is in one piece, those after the first begin
    at lines of the cache in the first of the results, if `length` is some lines.
    """
    in_one_piece = all(y.flags.c_contiguous for y in results)
    plain = [x.size == 1 or (x.shape == shape and x.flags.c_contiguous) for x in inputs]
    laid = [
        x.reshape(-1) if straight else x.reshape((1,) * (len(shape) - x.ndim) + x.shape)
        for x, straight in zip(inputs, plain, strict=True)
    ]
    each = [straight and x.size > 1 for x, straight in zip(inputs, plain, strict=True)]
    size = math.prod(shape)
    if (all(plain) and in_one_piece) or not size:
        first = length
        line = LINE // inputs[0].itemsize
        if results and size > length > line:
            first -= (length - lead(results[0])) % line
        spans = list(pairwise([0, *range(first, size, length), size])) if size else []
        return Blocks((size,), 0, 1, laid, plain, each, spans)
    axis, beyond = len(shape) - 1, 1
    while axis and shape[axis] * beyond <= length:
        beyond *= shape[axis]
        axis -= 1
    count = shape[axis]
    # as few parts as there must be, all of about one length
    part = math.ceil(count / math.ceil(count / max(1, length // beyond)))
    spans = [
        (row + first * beyond, row + min(first + part, count) * beyond)
        for row in range(0, size, count * beyond)
        for first in range(0, count, part)
    ]
    return Blocks(shape, axis, beyond, laid, plain, each, spans)


class Parts:
    """What inputs have for one block after another, through buffers that are used again."""

    def __init__(self, blocks: Blocks) -> None:
        self.blocks = blocks
        places = range(len(blocks.inputs))
        self._inputs = list(zip(places, blocks.inputs, blocks.each, strict=True))
        others = [place for place, straight in enumerate(blocks.plain) if not straight]
        self._buffers: dict[int, Array] = {}
        if others:
            buffers = rows(len(others), blocks.length, blocks.inputs[0].dtype)
            self._buffers = dict(zip(others, buffers, strict=True))
        self._same: dict[int, Array] = {}

    def all(self, start: int, stop: int) -> list[Array]:
        """Of every input."""
        here = slice(start, stop)
        return [
            x[here] if each else self.one(place, start, stop) for place, x, each in self._inputs
        ]

    def one(self, place: int, start: int, stop: int) -> Array:
        """Of one input: one number, which stands for all, or as many as there are elements."""
        x = self.blocks.inputs[place]
        if self.blocks.plain[place]:
            return x if x.size == 1 else x[start:stop]
        if place in self._same:
            return self._same[place][: stop - start]
        own = self.blocks.window(x, start, stop)
        if own.size == 1 or (own.size == stop - start and own.flags.c_contiguous):
            return own.reshape(-1)
        buffer = self._buffers[place]
        if max(x.shape[: self.blocks.axis + 1]) == 1:
            self._same[place] = buffer
            _spread(own, self.blocks.box(buffer))
        else:
            _spread(own, self.blocks.box(buffer[: stop - start]))
        return buffer[: stop - start]


def _spread(own: Array, box: Array) -> None:
    """Write a window to all that it stands for."""
    many = box.shape[-1]
    if own.shape == box.shape or many >= FEW:
        box[...] = own
        return
    for place in range(many):
        box[..., place] = own[..., place if own.shape[-1] > 1 else 0]
