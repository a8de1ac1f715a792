"""Blocks of the kernels beside this file, from inputs to outputs.

A kernel takes real numbers or arrays of them, float64 or float32 as they are; integers and lists
become float64. Every input is checked before any given output array is touched, and no warning of
NumPy escapes. The arithmetic runs in blocks through a few buffers that are used again and again.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial
from itertools import pairwise
from types import FunctionType
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

from gainproof.derive.printer.shipped._blocks import BLOCK, Blocks, Parts, cut, rows
from gainproof.derive.printer.shipped._guards import admit, doubted
from gainproof.derive.printer.shipped._inputs import as_real, common_shape
from gainproof.derive.printer.shipped._numbers import ONE, PYTHONS, of_numbers
from gainproof.derive.printer.shipped._outputs import checked, overlap

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.derive.printer.shipped._blocks import Span
    from gainproof.derive.printer.shipped._signature import Array, Arrays, Block, Real, Signature

    Spans: TypeAlias = Sequence[Span]

LONG = 16
"""Blocks looked at together where all are looked at first: two at a time, looking at many inputs
takes a twentieth more time.
"""


class Call(NamedTuple):
    """One call of a kernel: its inputs as they came and cut into `blocks`, and the results, which
    are `fresh` where none were given.
    """

    kernel: Signature
    inputs: Sequence[Array]
    blocks: Blocks
    results: Sequence[Array]
    fresh: bool


class Compiled(NamedTuple):
    """A kernel by functions of a library: `whole` fills the results of a call, or says that it has
    not, and `block` those of a block.
    """

    whole: Callable[[Arrays, Arrays, bool, int], bool]
    block: Block


def evaluate(
    kernel: Signature,
    given: Sequence[ArrayLike],
    out: tuple[Real, ...] | None,
    workers: int,
    compiled: Compiled | None = None,
) -> tuple[Any, ...]:
    """The outputs of a kernel: numbers for numbers, else arrays of the inputs' common shape.

    Beside inputs and outputs it takes a few buffers of a block for each thread, and a copy of an
    input that shares memory with an output otherwise than element by element.

    `workers`: threads that share the blocks, started for this call alone; 1 starts none. However
    many there are, results are the same bit for bit and the same input is refused.

    TypeError for inputs that are not real numbers of the types above, and for what in `out` is no
    array of the type of the results; ValueError for inputs outside their domain (NaN included),
    shapes that do not fit, an `out` that is no tuple of as many arrays as there are outputs,
    arrays in it of another shape, read-only, or that share memory, and for `workers` that is no
    whole number from 1.
    """
    if out is None and workers is ONE and (found := of_numbers(kernel, given)) is not None:
        return found
    if not isinstance(workers, int | np.integer) or workers < 1:
        raise ValueError(
            f"{kernel.name}: workers must be a whole number of threads, 1 or more, got {workers!r}"
        )
    with np.errstate(all="ignore"):
        # a signalling NaN warns as soon as it is widened
        inputs = as_real(kernel, given)
        shape = common_shape(kernel, inputs)
        kind = inputs[0].dtype
        if out is None:
            results = [np.empty(shape, kind) for _ in kernel.outputs]
        else:
            results = checked(kernel, out, shape, kind)
        if compiled is None:
            _in_blocks(kernel, inputs, results, out is None, int(workers))
        elif not compiled.whole(inputs, results, out is None, int(workers)):
            kernel = kernel._replace(block=compiled.block)
            _in_blocks(kernel, inputs, results, out is None, int(workers))
    if out is None and shape == ():
        kinds = set(map(type, given))
        return tuple(float(y[()]) if kinds <= PYTHONS else y[()] for y in results)
    return tuple(results)


def _in_blocks(
    kernel: Signature, inputs: Arrays, results: Arrays, fresh: bool, workers: int
) -> None:
    """Fill the results block by block, in as many threads."""
    blocks = cut(inputs, results[0].shape, BLOCK, results=results)
    spans = blocks.spans
    count = max(1, min(workers, len(spans)))
    ends = [len(spans) * part // count for part in range(count + 1)]
    shares = [spans[first:last] for first, last in pairwise(ends)]
    run(Call(kernel, inputs, blocks, results, fresh), shares)


def run(call: Call, shares: Sequence[Spans]) -> None:
    """Fill the results; every share of the blocks has a thread, the first has this."""
    kept: list[int] = []
    doubtful = doubted(call.kernel, call.blocks)
    if not call.fresh:
        in_shares(partial(_look, call, doubtful), shares)
        # where an output takes the place of an input
        for place, x in enumerate(call.blocks.inputs):
            shared = [y for y in call.results if overlap(y, x)]
            if any(not call.blocks.plain[place] or _elsewhere(x, y) for y in shared):
                call.blocks.inputs[place] = x.copy()
            elif shared:
                kept.append(place)
    in_shares(partial(_fill, call, doubtful, kept), shares)


def in_shares(job: Callable[[Spans], None], shares: Sequence[Spans]) -> None:
    """Do a job for every share, and raise what the first of them raised."""
    if len(shares) == 1:
        job(shares[0])
    else:
        # kernels are imported more often than threads are asked for
        from gainproof.derive.printer.shipped._threads import in_threads

        in_threads(job, shares)


def _look(call: Call, doubtful: Sequence[int], spans: Spans) -> None:
    """Refuse what a share holds outside the domain."""
    parts = Parts(call.blocks)
    # what is spread has room for one block
    together = LONG if all(call.blocks.plain) else 1
    for first in range(0, len(spans), together):
        several = spans[first : first + together]
        admit(call.kernel, parts, several, doubtful, call.inputs, call.results[0].shape)


def _fill(call: Call, doubtful: Sequence[int], kept: Sequence[int], spans: Spans) -> None:
    """Compute a share; inputs that are `kept` are copied block by block before they are read."""
    kernel, results, shape = call.kernel, call.results, call.results[0].shape
    kind, length = results[0].dtype, call.blocks.length
    single = kind == np.float32
    # an output that is not contiguous is filled through a buffer
    through = [place for place, y in enumerate(results) if not y.flags.c_contiguous]
    work = rows(kernel.work + len(kept) + len(through), length, kind)
    copies = [(place, work.pop()) for place in kept]
    buffers = {place: work.pop() for place in through}
    flat = [np.asarray(y).reshape(-1) for y in results if y.flags.c_contiguous]
    each = Parts(call.blocks)
    block = with_arrays(kernel.block, kind)
    # what was looked at last is still in the cache: it is computed first
    for start, stop in spans if call.fresh else reversed(spans):
        if call.fresh:
            admit(kernel, each, [(start, stop)], doubtful, call.inputs, shape)
        size = stop - start
        here = slice(start, stop)
        parts, filled = each.all(start, stop), [y[here] for y in flat]
        for place, buffer in buffers.items():
            filled.insert(place, buffer[:size])
        for place, copy in copies:
            np.copyto(copy[:size], parts[place])
            parts[place] = copy[:size]
        block(parts, filled, work if size == length else [w[:size] for w in work], single)
        for place in buffers:
            window = call.blocks.window(np.asarray(results[place]), start, stop)
            window[...] = call.blocks.box(filled[place])


@cache
def with_arrays(block: Block, kind: np.dtype[Any]) -> Block:
    """A block function with arrays without axes for its numbers, which are its defaults: NumPy
    makes one of a number at every call, which takes half as long as the call.
    """
    if not block.__defaults__:
        return block
    numbers = tuple(np.array(x, kind) for x in block.__defaults__)
    return FunctionType(block.__code__, block.__globals__, None, numbers, block.__closure__)


def _elsewhere(x: Array, y: Array) -> bool:
    """Whether an output that shares memory with an input is not the same array: then the input is
    not read and written element by element, and the whole of it has to be kept.
    """
    return y.size != x.size or not y.flags.c_contiguous or y.ctypes.data != x.ctypes.data
