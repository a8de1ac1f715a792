"""C loops of a kernel's graph, bare and with guards, compiled on this machine."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

FLAGS = (
    "-O3",
    "-march=native",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-ffp-contract=off",
    "-std=c99",
    "-shared",
    "-fPIC",
)

Arrays = Sequence[NDArray[np.float64]]
Loop = Callable[[Arrays, Arrays], None]


def compiler() -> str | None:
    """The C compiler: $CC, cc, gcc or clang; None where there is none."""
    for name in (os.environ.get("CC"), "cc", "gcc", "clang"):
        if name and shutil.which(name):
            return name
    return None


def library(source: str, name: str, folder: Path, flags: Sequence[str] = FLAGS) -> ctypes.CDLL:
    """Compile `source` and load it; `folder` is for both files, which are called `name`.

    Raises FileNotFoundError where there is no compiler, subprocess.CalledProcessError where it
    refuses the source.
    """
    command = compiler()
    if command is None:
        raise FileNotFoundError("no C compiler: cc, gcc or clang is wanted")
    folder.mkdir(parents=True, exist_ok=True)
    text, made = folder / f"{name}.c", folder / f"{name}.so"
    text.write_text(source, encoding="utf-8")
    subprocess.run(
        [command, *flags, str(text), "-o", str(made), "-lm"],
        check=True,
        capture_output=True,
        text=True,
    )
    return ctypes.CDLL(str(made))


def compiled(source: str, function: str, folder: Path, *, guarded: bool = False) -> Loop:
    """Compile `source` and wrap `function`(size_t n, const double *in0, ..., double *out0, ...); a
    `guarded` one takes ``size_t *first`` too, and returns 0 unless it refuses an input.

    Raises what `library` raises; the wrapped function ValueError for what a guarded one refuses.
    """
    loop: Any = getattr(library(source, function, folder), function)
    loop.restype = ctypes.c_int if guarded else None
    first = [None] if guarded else []

    def call(given: Arrays, outputs: Arrays) -> None:
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in (*given, *outputs)]
        if loop(ctypes.c_size_t(given[0].size), *pointers, *first):
            raise ValueError(f"{function} refuses an input that the kernel takes")

    return call
