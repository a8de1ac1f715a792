"""The C loop computes exactly what the printed module does."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from graph_kernels import function_of, kernel_of

from gainproof.derive.printer.c_language.loop import c_loop
from gainproof.derive.printer.graph import GraphBuilder


def test_same_bits(tmp_path: Path) -> None:
    compiler = shutil.which("cc") or shutil.which("gcc")
    if compiler is None:
        pytest.skip("needs a C compiler")
    b = GraphBuilder()
    x = b.symbol("x")
    gap = b.absolute(x / 2 - b.sqrt("2/3"))
    kernel = kernel_of(
        b.graph({"y": b.select(2, x, gap * 3, -b.sqrt(x)) * "1/3", "z": gap / 3 + 1, "x_": x}),
        upper=10**9,
    )
    source, library = tmp_path / "kernel.c", tmp_path / "kernel.so"
    source.write_text(c_loop(kernel), encoding="utf-8")
    flags = ["-O3", "-std=c99", "-Wall", "-Werror", "-ffp-contract=off", "-shared", "-fPIC"]
    subprocess.run([compiler, *flags, "-o", library, source, "-lm"], check=True)
    given = np.geomspace(1e-300, 9e8, 30_000)
    found = [np.empty_like(given) for _ in kernel.outputs]
    pointer = np.ctypeslib.ndpointer(np.float64, flags="C_CONTIGUOUS")
    function = ctypes.CDLL(str(library)).kernel
    function.argtypes = [ctypes.c_size_t, pointer, *[pointer] * len(found)]
    function.restype = None
    function(given.size, given, *found)
    for mine, theirs in zip(function_of(kernel)(given), found, strict=True):
        assert np.array_equal(mine, theirs)
