"""A printed C module as a shared library, its array entries called with NumPy arrays."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.c_language.module import c_files
from gainproof.derive.printer.c_language.names import names_of
from gainproof.derive.printer.kernel import Kernel, Module

Columns = Sequence[NDArray[Any]]
WARNINGS = ("-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-pedantic", "-Werror")
FLAGS = ("-std=c99", *WARNINGS, "-O2", "-march=native", "-ffp-contract=off", "-shared", "-fPIC")


def compiler() -> str:
    """The C compiler; the test is skipped where there is none."""
    found = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if found is None:
        pytest.skip("needs a C compiler")
    return found


def library(module: Module, bounds: Sequence[Sequence[KernelBound]], folder: Path) -> ctypes.CDLL:
    """Print and compile a module; a warning of the compiler fails."""
    command = compiler()
    for name, text in c_files(module, bounds).items():
        (folder / name).write_text(text, encoding="utf-8")
    built = folder / f"{module.name}.so"
    source = folder / f"{module.name}.c"
    subprocess.run([command, *FLAGS, "-o", built, source, "-lm"], check=True)
    return ctypes.CDLL(str(built))


def call_arrays(
    loaded: ctypes.CDLL, module: Module, kernel: Kernel, given: Columns
) -> tuple[int, int, list[NDArray[Any]]]:
    """The code, the place of what was refused (-1: none), and the outputs (-7 where not filled)."""
    names = names_of(module.name, kernel)
    ending = "" if given[0].dtype == np.float64 else "_float"
    outputs = [np.full_like(given[0], -7.0) for _ in kernel.outputs]
    first = ctypes.c_size_t(2**64 - 1)
    pointers = [ctypes.c_void_p(column.ctypes.data) for column in (*given, *outputs)]
    function = getattr(loaded, f"{names.stem}_array{ending}")
    code = function(ctypes.c_size_t(given[0].size), *pointers, ctypes.byref(first))
    return int(code), ctypes.c_ssize_t(first.value).value, outputs
