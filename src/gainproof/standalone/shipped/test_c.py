"""The C files: they compile without a warning, keep their bounds, and have the bits of NumPy."""

from __future__ import annotations

import ctypes
import math
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gainproof.standalone.shipped._package import FORMATS, PACKAGE, VALUES, function, imported

SOURCES = PACKAGE / "c"
FLAGS = ("-O2", "-std=c99", "-ffp-contract=off", "-Wall", "-Wextra", "-pedantic", "-Werror")
LIBRARY = ("sin", "cos", "atan2", "hypot", "exp", "expm1", "log1p")
"""Calls of `math.h` that may round otherwise than NumPy's own functions."""


def compiled(*arguments: str | Path) -> None:
    """Run the C compiler; the test is skipped where there is none."""
    command = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if command is None:
        pytest.skip("needs a C compiler")
    subprocess.run([command, *FLAGS, *arguments, "-lm"], check=True)


@pytest.mark.parametrize("module", VALUES)
def test_the_program_in_c_finds_every_value_as_proved(module: str, tmp_path: Path) -> None:
    program = tmp_path / "trial"
    compiled("-o", program, SOURCES / f"{module}.c", SOURCES / f"test_{module}.c")
    done = subprocess.run([program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("module", VALUES)
def test_the_bits_are_those_of_numpy(module: str, tmp_path: Path) -> None:
    source = SOURCES / f"{module}.c"
    compiled("-shared", "-fPIC", "-o", tmp_path / "kernels.so", source)
    loaded = ctypes.CDLL(str(tmp_path / "kernels.so"))
    calls = any(f"{name}(" in source.read_text(encoding="utf-8") for name in LIBRARY)
    for kernel, described in VALUES[module].items():
        for form in FORMATS:
            points = [point["at"] for point in described["points"][form]]
            given: list[Any] = [np.array(x, form) for x in zip(*points, strict=True)]
            want = function(module, kernel)(*given)
            found = [np.full(len(points), math.nan, form) for _ in want]
            ending = "_array" if form == "float64" else "_array_float"
            pointers = [ctypes.c_void_p(x.ctypes.data) for x in (*given, *found)]
            entry = getattr(loaded, f"{module}_{kernel}{ending}")
            assert entry(ctypes.c_size_t(len(points)), *pointers, None) == 0
            for ours, theirs in zip(want, found, strict=True):
                same = ours.view(np.uint8) == theirs.view(np.uint8)
                assert calls or np.all(same), (kernel, form)


@pytest.mark.parametrize("module", VALUES)
def test_loops_in_c_have_the_bits_of_numpy(module: str, tmp_path: Path) -> None:
    functions = imported(".._compiled").same_bits(module)
    if not functions:
        pytest.skip("calls functions of math.h")
    flags = imported(".._compiled").FLAGS
    compiled(*flags, "-o", tmp_path / "kernels.so", SOURCES / f"{module}_numpy.c")
    loaded = ctypes.CDLL(str(tmp_path / "kernels.so"))
    assert imported("..compile").differences(module, loaded)
