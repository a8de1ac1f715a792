"""Blocks of the kernels beside this file, from inputs to outputs.

A kernel takes real numbers or arrays of them, float64 or float32 as they are; integers and lists
become float64. Every input is checked before any given output array is touched, and no warning of
NumPy escapes. The arithmetic runs in blocks through a few buffers that are used again and again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.derive.printer.shipped._guards import admit, block_length, parts_of
from gainproof.derive.printer.shipped._outputs import checked, overlap

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.derive.printer.shipped._signature import Array, Real, Signature

LONG = 2
"""Blocks looked at together where all are looked at first: as many more calls cost a tenth."""


def evaluate(
    kernel: Signature, given: Sequence[ArrayLike], out: tuple[Real, ...] | None
) -> tuple[Any, ...]:
    """The outputs of a kernel: numbers for numbers, else arrays of the inputs' common shape.

    TypeError for inputs that are not real numbers of the types above; ValueError for inputs
    outside their domain (NaN included), shapes that do not fit, or arrays in `out` that are not as
    many as the outputs, of another shape or type, read-only, or that share memory.
    """
    with np.errstate(all="ignore"):
        # a signalling NaN warns as soon as it is widened
        inputs = _as_real(kernel, given)
        shape = _common_shape(kernel, inputs)
        length = block_length(kernel)
        flat = [_constant(x, shape, length) if x.size == 1 else _flat(x, shape) for x in inputs]
        kind = inputs[0].dtype
        if out is None:
            results = [np.empty(shape, kind) for _ in kernel.outputs]
        else:
            results = checked(kernel, out, shape, kind)
            size = results[0].size
            for start in range(0, size, LONG * length):
                admit(kernel, flat, start, min(start + LONG * length, size), inputs, shape)
        _run(kernel, flat, results, inputs, out is None)
    if out is None and shape == ():
        return tuple(y[()] for y in results)
    return tuple(results)


def _run(
    kernel: Signature,
    flat: list[Array],
    results: Sequence[Array],
    inputs: Sequence[Array],
    guard: bool,
) -> None:
    size, kind = results[0].size, flat[0].dtype
    single = kind == np.float32
    step = block_length(kernel)
    length = min(size, step)
    # an output that is not contiguous is filled through a buffer
    direct = [y.flags.c_contiguous for y in results]
    targets: list[Array] = [
        np.asarray(y).reshape(-1) if straight else np.empty(length, kind)
        for y, straight in zip(results, direct, strict=True)
    ]
    work: list[Array] = [np.empty(length, kind) for _ in range(kernel.work)]
    # inputs that an output takes the place of: kept block by block, while they are read
    copies: dict[int, Array] = {}
    for place, x in enumerate(() if guard else flat):
        shared = [y for y in results if overlap(y, x)]
        if any(_elsewhere(x, y) for y in shared):
            flat[place] = x.copy()
        elif shared:
            copies[place] = np.empty(length, kind)
    starts = range(0, size, step)
    # what was admitted last is still in the cache: it is computed first
    for start in starts if guard else reversed(starts):
        stop = min(start + step, size)
        if guard:
            admit(kernel, flat, start, stop, inputs, results[0].shape)
        parts = parts_of(flat, start, stop, size)
        filled = [
            y[start:stop] if straight else y[: stop - start]
            for y, straight in zip(targets, direct, strict=True)
        ]
        for place, held in copies.items():
            np.copyto(held[: stop - start], parts[place])
            parts[place] = held[: stop - start]
        kernel.block(parts, filled, [w[: stop - start] for w in work], single)
        for y, straight, result in zip(filled, direct, results, strict=True):
            if not straight:
                np.asarray(result).flat[start:stop] = y


def _as_real(kernel: Signature, given: Sequence[ArrayLike]) -> list[Array]:
    """The inputs as arrays of one type, float64 unless all are float32."""
    arrays = [np.asarray(x) for x in given]
    for domain, x in zip(kernel.inputs, arrays, strict=True):
        if x.dtype.kind not in "iu" and x.dtype.type not in (np.float64, np.float32):
            raise TypeError(
                f"{kernel.name}: {domain.name} must be real numbers of type float64 or float32, "
                f"or integers, got {x.dtype}"
            )
    single = all(x.dtype.type is np.float32 for x in arrays)
    kind: np.dtype[Any] = np.dtype(np.float32 if single else np.float64)
    return [x if x.dtype == kind else x.astype(kind) for x in arrays]


def _common_shape(kernel: Signature, inputs: Sequence[Array]) -> tuple[int, ...]:
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


def _flat(x: Array, shape: tuple[int, ...]) -> Array:
    contiguous: Array = np.ascontiguousarray(x if x.shape == shape else np.broadcast_to(x, shape))
    return contiguous.reshape(-1)


def _constant(x: Array, shape: tuple[int, ...], length: int) -> Array:
    """One number as often as a block takes it."""
    size = 1
    for count in shape:
        size *= count
    return np.full(min(size, length), x.reshape(-1)[0], x.dtype)


def _elsewhere(x: Array, y: Array) -> bool:
    """Whether an output that shares memory with an input is not the same array: then the input is
    not read and written element by element, and the whole of it has to be kept.
    """
    return y.size != x.size or not y.flags.c_contiguous or y.ctypes.data != x.ctypes.data
