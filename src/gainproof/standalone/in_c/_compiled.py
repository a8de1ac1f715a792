"""The kernels in C, bit for bit NumPy's, where `compile` beside this file was run.

Arrays in one piece, and numbers beside them, are looked at and computed by functions of a library;
what lies otherwise too, of a copy, where it is no more than a block. What these refuse and all else
is for NumPy's guards and blocks, which have the messages; there only what is computed for a block
is computed in C. Without a library nothing changes.
"""

from __future__ import annotations

import ctypes
import hashlib
import json
import os
import sysconfig
import warnings
from collections.abc import Callable, Sequence
from functools import cache, partial
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

from gainproof.generated._blocks import BLOCK
from gainproof.generated._runtime import Compiled, in_shares
from gainproof.generated._runtime import evaluate as evaluate_blocks

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.generated._blocks import Span
    from gainproof.generated._signature import Array, Arrays, Block, Real, Signature

Function: TypeAlias = Callable[..., int]

SOURCES = Path(__file__).with_name("c")
FLAGS = (
    *("-O3", "-std=c99", "-ffp-contract=off"),
    # a root is one instruction, and loops may compute what is not chosen: no bit changes
    *("-fno-math-errno", "-fno-trapping-math"),
    *("-shared", "-fPIC"),
)
"""Nothing of the processor's own: a library goes wherever its platform is."""
INSTRUCTIONS = ("none", "plain", "avx2", "avx512")
"""Sets of instructions, each better than those before it. A library has its loops for one or two of
them. The best that the processor has is taken, at most the one that this variable of the
environment names; with none NumPy computes.
"""
AT_MOST = "GAINPROOF_INSTRUCTIONS"
LOOK, FILL = 1, 2
PIECE = 1_048_576
"""Elements that one call of C looks at or fills at most: so long an interrupt waits."""
IN_ONE_PIECE = 0x101
"""Flags of NumPy's: C-contiguous, and each number at its natural place."""


def evaluate(
    kernel: Signature, given: Sequence[ArrayLike], out: tuple[Real, ...] | None, workers: int
) -> tuple[Any, ...]:
    """What `_runtime.evaluate` returns and raises, the same bit for bit."""
    count = len(kernel.inputs) + len(kernel.outputs)
    return evaluate_blocks(kernel, given, out, workers, _found(kernel.block, kernel.name, count))


def library(module: str, folder: Path = SOURCES) -> Path:
    """Where the library of a module lies: its name tells the source, the flags and the platform."""
    names = (f"{module}.h", f"{module}.c", f"{module}_numpy.c")
    source = b"".join((folder / name).read_bytes() for name in names)
    digest = hashlib.sha256(source + " ".join(FLAGS).encode()).hexdigest()[:16]
    return folder / f"{module}.{digest}.{sysconfig.get_platform()}.so"


def same_bits(module: str, folder: Path = SOURCES) -> dict[str, str]:
    """C functions by kernel, of those that call nothing that may round otherwise than NumPy's."""
    try:
        described = json.loads((folder / f"{module}.json").read_text(encoding="utf-8"))
    except OSError:  # shipped without them
        return {}
    found: dict[str, str] = described["same_bits"]
    return found


def instructions(loaded: ctypes.CDLL) -> list[str]:
    """The sets of instructions for which a library has loops that this processor can run, the best
    last.
    """
    loaded.instructions.restype = ctypes.c_char_p
    found: bytes = loaded.instructions()
    return found.decode().split()


def best_instructions(loaded: ctypes.CDLL) -> str:
    """Those that are taken here. ValueError where the variable of the environment names none."""
    wanted = os.environ.get(AT_MOST, INSTRUCTIONS[-1])
    if wanted not in INSTRUCTIONS:
        raise ValueError(f"{AT_MOST} must be one of {', '.join(INSTRUCTIONS)}, got {wanted!r}")
    admitted = INSTRUCTIONS[: INSTRUCTIONS.index(wanted) + 1]
    return ["none", *(each for each in instructions(loaded) if each in admitted)][-1]


def functions(
    loaded: ctypes.CDLL, name: str, count: int, version: str
) -> tuple[Function | None, Function | None]:
    """A version of a kernel's loops, which take so many arrays: for float64 and for float32, of
    which one may not be there, and with `none` neither is.
    """
    double, single = (getattr(loaded, f"{version}_{name}{kind}", None) for kind in ("", "_float"))
    for each in (double, single):
        if each is not None:
            each.argtypes = (ctypes.c_size_t,) * 3 + (ctypes.c_void_p,) * count
    return double, single


def in_c(block: Block, double: Function | None, single: Function | None) -> Compiled:
    """A kernel by functions of C; `block` computes what they do not take."""

    def whole(inputs: Arrays, results: Arrays, fresh: bool, workers: int) -> bool:
        size, kind = results[0].size, results[0].dtype
        function = single if kind == np.float32 else double
        if function is None or not size:
            return False
        laid = _laid(inputs, results, fresh)
        if laid is None and size <= BLOCK:
            inputs = [_copied(x, results[0]) for x in inputs]
            laid = _laid(inputs, results, fresh)
        if laid is None:
            return False
        length = max(BLOCK, min(PIECE, -(-size // workers)))
        if size <= length:
            return not function(size, LOOK | FILL, laid.own, *laid.places)
        steps = [kind.itemsize if many > kind.itemsize else 0 for many in laid.lengths]
        spans = list(pairwise([*range(0, size, length), size]))
        count = min(workers, len(spans))
        ends = [len(spans) * part // count for part in range(count + 1)]
        shares = [spans[first:last] for first, last in pairwise(ends)]
        refused: list[int] = []

        def do(how: int, share: Sequence[Span]) -> None:
            for start, stop in share:
                at = [x + start * step for x, step in zip(laid.places, steps, strict=True)]
                if function(stop - start, how, laid.own, *at):
                    refused.append(start)
                    return

        # no array that was given is touched before all is looked at
        for how in (LOOK | FILL,) if fresh else (LOOK, FILL):
            in_shares(partial(do, how), shares)
            if refused:
                return False
        return True

    def block_in_c(given: Arrays, out: Arrays, work: Arrays, is_single: bool) -> None:
        function = single if is_single else double
        laid = _laid(given, out, True) if function else None
        # C knows no numbers across their natural places
        if function is None or laid is None:
            block(given, out, work, is_single)
        else:
            function(out[0].size, FILL, laid.own, *laid.places)

    return Compiled(whole, block_in_c)


class Laid(NamedTuple):
    """Which inputs have as many elements as the outputs, the first the lowest bit; addresses and
    bytes of inputs and outputs.
    """

    own: int
    places: list[int]
    lengths: list[int]


def _laid(inputs: Arrays, outputs: Arrays, apart: bool) -> Laid | None:
    """None where an array is not in one piece, or is neither one number nor as long as outputs, or
    where an input shares memory with an output; `apart`: none does.
    """
    size, own = outputs[0].size, 0
    arrays = (*inputs, *outputs)
    for place, x in enumerate(inputs):
        if x.size == size:
            own |= 1 << place
        elif x.size != 1:
            return None
    if any(x.flags.num & IN_ONE_PIECE != IN_ONE_PIECE for x in arrays):
        return None
    laid = Laid(own, [x.ctypes.data for x in arrays], [x.nbytes for x in arrays])
    if apart:
        return laid
    ranges = list(zip(laid.places, laid.lengths, strict=True))
    read, filled = ranges[: len(inputs)], ranges[len(inputs) :]
    shared = any(x < y + m and y < x + n for x, n in read for y, m in filled)
    return None if shared else laid


def _copied(x: Array, output: Array) -> Array:
    """An input with an element for each of the output's."""
    own: Array = np.empty(output.shape, x.dtype)
    own[...] = x
    return own


@cache
def _found(block: Block, name: str, count: int) -> Compiled | None:
    """A kernel in C; None where NumPy computes, as in double-words."""
    module = block.__module__.rpartition(".")[2]
    if block.__name__ != f"_{name}_block":
        return None
    function = same_bits(module).get(name)
    loaded = load(module) if function else None
    if not function or not loaded:
        return None
    return in_c(block, *functions(loaded, function, count, best_instructions(loaded)))


@cache
def load(module: str) -> ctypes.CDLL | None:
    """The library of a module; None where there is none, and with a warning where it is none."""
    try:
        path = library(module)
    except OSError:
        return None
    if not path.is_file():
        return None
    try:
        return ctypes.CDLL(str(path))
    except OSError as error:
        warnings.warn(f"{path.name} cannot be loaded, NumPy computes: {error}", stacklevel=5)
        return None
