"""Guards, blocks and output arrays of the kernels beside this file.

A kernel takes real numbers or arrays of them, float64 or float32 as they are; integers and lists
become float64. Every input is checked before any given output array is touched, and no warning of
NumPy escapes. The arithmetic runs in blocks through a few buffers that are used again and again.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Array: TypeAlias = NDArray[np.floating[Any]]
    Arrays: TypeAlias = Sequence[Array]
    Real: TypeAlias = np.floating[Any] | NDArray[np.floating[Any]]
    Block: TypeAlias = Callable[[Arrays, Arrays, Arrays, bool], None]

ROW = 8192  # numbers of a sum of squares: libraries take threads for more, which may have to wait
SIZE = 65536  # elements of a block: calls cost little beside it, a few buffers stay in the cache


class Domain(NamedTuple):
    """One input: its name, the numbers wanted in words, least and greatest of each type.

    `whole`: whole numbers only; `zero`: 0 besides; `signed`: of their magnitude.
    """

    name: str
    wanted: str
    double: tuple[float, float]
    single: tuple[float, float]
    whole: bool = False
    zero: bool = False
    signed: bool = False


class Required(NamedTuple):
    """What inputs must fulfil together: what `block` computes of them is at least `double`, in
    float32 at least `single`.
    """

    name: str
    wanted: str
    double: float
    single: float
    work: int
    block: Block


class Signature(NamedTuple):
    """A kernel: its name, inputs, names of outputs, number of work buffers, and arithmetic.

    `block(inputs, outputs, work, single)` fills arrays of one shape and type; it may use the
    outputs as buffers before it fills them.
    """

    name: str
    inputs: tuple[Domain, ...]
    outputs: tuple[str, ...]
    work: int
    block: Block
    required: tuple[Required, ...] = ()


def evaluate(
    kernel: Signature, given: Sequence[ArrayLike], out: tuple[Real, ...] | None
) -> tuple[Any, ...]:
    """The outputs of a kernel: numbers for numbers, else arrays of the inputs' common shape.

    TypeError for inputs that are not real numbers of the types above; ValueError for inputs
    outside their domain (NaN included), shapes that do not fit, or arrays in `out` that are not as
    many as the outputs, of another shape or type, read-only, or that share memory.
    """
    inputs = _as_real(kernel, given)
    shape = _common_shape(kernel, inputs)
    flat = [_constant(x, shape) if x.size == 1 else _flat(x, shape) for x in inputs]
    kind = inputs[0].dtype
    with np.errstate(all="ignore"):
        if out is None:
            results = [np.empty(shape, kind) for _ in kernel.outputs]
        else:
            results = _checked(kernel, out, shape, kind)
            size = results[0].size
            for start in range(0, size, SIZE):
                parts = _parts(flat, start, min(start + SIZE, size), size)
                _admit(kernel, parts, start, inputs, shape)
            flat = [x.copy() if _elsewhere(x, results) else x for x in flat]
        _run(kernel, flat, results, inputs, out is None)
    if out is None and shape == ():
        return tuple(y[()] for y in results)
    return tuple(results)


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


def _run(
    kernel: Signature,
    flat: Sequence[Array],
    results: Sequence[Array],
    inputs: Sequence[Array],
    guard: bool,
) -> None:
    size, kind = results[0].size, flat[0].dtype
    single = kind == np.float32
    length = min(size, SIZE)
    # an output that is not contiguous is filled through a buffer
    direct = [y.flags.c_contiguous for y in results]
    targets: list[Array] = [
        np.asarray(y).reshape(-1) if straight else np.empty(length, kind)
        for y, straight in zip(results, direct, strict=True)
    ]
    work: list[Array] = [np.empty(length, kind) for _ in range(kernel.work)]
    # inputs that an output takes the place of: kept block by block, while they are read
    copies = {
        place: np.empty(length, kind)
        for place, x in enumerate(flat)
        if any(_overlap(y, x) for y in results)
    }
    starts = range(0, size, SIZE)
    # what was admitted last is still in the cache: it is computed first
    for start in starts if guard else reversed(starts):
        stop = min(start + SIZE, size)
        parts = _parts(flat, start, stop, size)
        if guard:
            _admit(kernel, parts, start, inputs, results[0].shape)
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


def _parts(flat: Sequence[Array], start: int, stop: int, size: int) -> list[Array]:
    """The block of each input; of a constant as much as the block is long."""
    return [x[start:stop] if x.size == size else x[: stop - start] for x in flat]


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
    return [x.astype(kind, copy=False) for x in arrays]


def _common_shape(kernel: Signature, inputs: Sequence[Array]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*(x.shape for x in inputs))
    except ValueError:
        each = zip(kernel.inputs, inputs, strict=True)
        shapes = ", ".join(f"{domain.name} {x.shape}" for domain, x in each)
        raise ValueError(
            f"{kernel.name}: inputs must have shapes that broadcast, got {shapes}"
        ) from None


def _flat(x: Array, shape: tuple[int, ...]) -> Array:
    contiguous: Array = np.ascontiguousarray(np.broadcast_to(x, shape))
    return contiguous.reshape(-1)


def _constant(x: Array, shape: tuple[int, ...]) -> Array:
    """One number as often as a block takes it."""
    size = 1
    for count in shape:
        size *= count
    return np.full(min(size, SIZE), x.reshape(-1)[0], x.dtype)


def _elsewhere(x: Array, results: Sequence[Array]) -> bool:
    """Whether an input shares memory with an output other than by being the same array: then it is
    not read and written element by element, and the whole of it has to be kept.
    """
    shared = [y for y in results if _overlap(y, x)]
    return any(
        y.size != x.size or not y.flags.c_contiguous or y.ctypes.data != x.ctypes.data
        for y in shared
    )


def _admit(
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
    came, x = x, np.abs(x) if domain.signed else x
    inside = not x.size or bool(np.minimum.reduce(x) >= low and np.maximum.reduce(x) <= high)
    if inside and not (domain.whole and np.any(x != np.floor(x))):
        return
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
    whole = x.size - x.size % ROW
    rows, rest = x[:whole].reshape(-1, ROW), x[whole:]
    most = np.maximum.reduce(np.vecdot(rows, rows), initial=np.vecdot(rest, rest))
    return bool(most <= high * high / 2)


def _require(kernel: Signature, parts: Arrays, start: int, shape: tuple[int, ...]) -> None:
    """ValueError with the first place where inputs together are not what they must be."""
    for required in kernel.required:
        kind = parts[0].dtype
        single = kind == np.float32
        value: Array = np.empty(parts[0].shape, kind)
        work: list[Array] = [np.empty_like(value) for _ in range(required.work)]
        required.block(parts, [value], work, single)
        fine = value >= (required.single if single else required.double)
        if not fine.all():
            first = int(np.argmin(fine))
            place = tuple(int(i) for i in np.unravel_index(start + first, shape))
            where = f" at index {place[0] if len(place) == 1 else place}" if shape else ""
            raise ValueError(
                f"{kernel.name}: {required.name} must be {required.wanted}, "
                f"got {value[first]!s}{where}"
            )


def _checked(
    kernel: Signature, out: Any, shape: tuple[int, ...], kind: np.dtype[Any]
) -> list[Array]:
    """The given output arrays, or an error that says which of them does not fit."""
    if not isinstance(out, tuple) or len(out) != len(kernel.outputs):
        raise ValueError(
            f"{kernel.name}: out must be a tuple of {len(kernel.outputs)} arrays "
            f"({', '.join(kernel.outputs)}), got {type(out).__name__}"
            + (f" of {len(out)}" if isinstance(out, tuple) else "")
        )
    results: list[Any] = list(out)
    for name, y in zip(kernel.outputs, results, strict=True):
        if not isinstance(y, np.ndarray):
            raise TypeError(f"{kernel.name}: out {name} must be an array, got {type(y).__name__}")
        if y.dtype != kind:
            raise TypeError(f"{kernel.name}: out {name} must be of type {kind}, got {y.dtype}")
        if y.shape != shape:
            raise ValueError(f"{kernel.name}: out {name} must have shape {shape}, got {y.shape}")
        if not y.flags.writeable:
            raise ValueError(f"{kernel.name}: out {name} must be writable, got a read-only array")
        if not _apart(y):
            raise ValueError(f"{kernel.name}: out {name} must not hold its elements at one place")
    for i, y in enumerate(results):
        for j in range(i):
            if _overlap(y, results[j]):
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


def _overlap(x: Array, y: Array) -> bool:
    """Whether two arrays share an element."""
    return np.may_share_memory(x, y) and np.shares_memory(x, y)
