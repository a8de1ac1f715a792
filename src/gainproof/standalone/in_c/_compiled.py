"""The arithmetic of kernels in C, bit for bit NumPy's, where `compile` beside this file was run.

Guards, shapes, blocks, threads and messages stay those of `_runtime`; only what is computed for a
block is computed by a function of a library. Without a library nothing changes.
"""

from __future__ import annotations

import ctypes
import hashlib
import json
import sysconfig
import warnings
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from gainproof.generated._runtime import evaluate as evaluate_blocks

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

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


def evaluate(
    kernel: Signature, given: Sequence[ArrayLike], out: tuple[Real, ...] | None, workers: int
) -> tuple[Any, ...]:
    """What `_runtime.evaluate` returns and raises, the same bit for bit."""
    block = _found(kernel.block, kernel.name, kernel.work)
    if block is not None:
        # a buffer for each input that is one number for all elements
        kernel = kernel._replace(block=block, work=len(kernel.inputs))
    return evaluate_blocks(kernel, given, out, workers)


def library(module: str, folder: Path = SOURCES) -> Path:
    """Where the library of a module lies: its name tells the source, the flags and the platform."""
    source = (folder / f"{module}.h").read_bytes() + (folder / f"{module}.c").read_bytes()
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


def functions(loaded: ctypes.CDLL, name: str) -> tuple[Function | None, Function | None]:
    """Those of a kernel for arrays of float64 and of float32, of which one may not be there."""
    double, single = (getattr(loaded, f"{name}_array{ending}", None) for ending in ("", "_float"))
    return double, single


def in_c(block: Block, work: int, double: Function | None, single: Function | None) -> Block:
    """What `block` does, which takes so many buffers, by functions of C."""

    def block_in_c(given: Arrays, out: Arrays, buffers: Arrays, is_single: bool) -> None:
        size = out[0].size
        arrays = [_whole(x, size, buffer) for x, buffer in zip(given, buffers, strict=True)]
        arrays += out
        if all(x.flags.aligned for x in arrays):
            places = [ctypes.c_void_p(x.ctypes.data) for x in arrays]
            function = single if is_single else double
            if function and not function(ctypes.c_size_t(size), *places, None):
                return
        # C knows no numbers across their natural places; what it refuses is NumPy's to decide
        block(given, out, [np.empty_like(out[0]) for _ in range(work)], is_single)

    return block_in_c


def _whole(x: Array, size: int, buffer: Array) -> Array:
    """An input with as many elements as there are results."""
    if x.size == size:
        return x
    np.copyto(buffer, x)
    return buffer


@cache
def _found(block: Block, name: str, work: int) -> Block | None:
    """A kernel's block in C; None where NumPy computes, as in double-words."""
    module = block.__module__.rpartition(".")[2]
    if block.__name__ != f"_{name}_block":
        return None
    function = same_bits(module).get(name)
    loaded = _loaded(module) if function else None
    return in_c(block, work, *functions(loaded, function)) if function and loaded else None


@cache
def _loaded(module: str) -> ctypes.CDLL | None:
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
