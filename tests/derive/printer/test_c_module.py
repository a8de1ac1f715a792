"""C99 headers and sources: what compiles, what is refused, and that bits are those of NumPy."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c_library import call_arrays, compiler, library
from graph_kernels import function_of, kernel_of, several_of

from gainproof.derive.printer.c_language.module import c_files
from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import (
    Input,
    Kernel,
    Module,
    Output,
    Requirement,
    closed,
    signed,
)
from gainproof.derive.printer.module_bounds import prove_all

KINDS = pytest.mark.parametrize("kind", [np.float64, np.float32])


def module_of(*kernels: Kernel) -> Module:
    return Module("trial", "A trial", "gainproof generate trial", "by hand", kernels)


def trial() -> Kernel:
    """A difference with a constant in two parts, a choice, a root, names that C keeps."""
    b = GraphBuilder()
    x = b.symbol("double")
    gap = b.absolute(x / 2 - b.sqrt("2/3"))
    chosen = b.select(2, x, gap * 3, -b.sqrt(x)) * "1/3"
    made = kernel_of(b.graph({"n": chosen, "t3": gap / 3 + 1, "double": x}), upper=10**9)
    return replace(made, inputs=(Input("double", "the argument", "0", 10**9),))


def two_inputs() -> Kernel:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    return several_of(b.graph({"y": x / (x + z)}), "1e-6", "1e6")


def cube_root() -> Kernel:
    b = GraphBuilder()
    x = b.symbol("x")
    first = fixed_point(near_cbrt(x), lambda y: b.sqrt(b.sqrt(x * y)), within="1/25")
    return kernel_of(b.graph({"y": first}), lower="1e-20", upper="1e20")


def apart() -> Kernel:
    """Inputs of either sign, a requirement on both."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    size = b.sqrt(x * x + z * z)
    return replace(
        kernel_of(b.graph({"y": x / size, "root": size})),
        inputs=(signed("x", "an argument", 0, 10**6), signed("z", "an argument", 0, 10**6)),
        outputs=(Output("y", "a value"),),
        requirements=(Requirement("root", "the root", "1e-6", "1e-3"),),
    )


@KINDS
@pytest.mark.parametrize("made", [trial, cube_root])
def test_the_bits_are_those_of_numpy(
    made: Callable[[], Kernel], kind: type[Any], tmp_path: Path
) -> None:
    module = module_of(made())
    loaded = library(module, prove_all(module.kernels), tmp_path)
    given = np.geomspace(1e-19, 9e8, 20_000).astype(kind)
    code, first, found = call_arrays(loaded, module, module.kernels[0], [given])
    assert (code, first) == (0, -1)
    for mine, theirs in zip(function_of(module.kernels[0])(given), found, strict=True):
        assert mine.dtype == theirs.dtype == kind
        assert np.array_equal(mine.view(np.uint8), theirs.view(np.uint8))


@KINDS
@pytest.mark.parametrize("made", [trial, cube_root])
def test_loops_have_these_bits_with_every_set_of_instructions(
    made: Callable[[], Kernel], kind: type[Any], tmp_path: Path
) -> None:
    """Cube roots in float32 are computed with the widest vectors alone, or in NumPy."""
    module = module_of(made())
    library(module, prove_all(module.kernels), tmp_path)
    built = tmp_path / "loops.so"
    flags = (
        "-O3",
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-ffp-contract=off",
        "-shared",
        "-fPIC",
    )
    source = tmp_path / f"{module.name}_numpy.c"
    subprocess.run([compiler(), *flags, "-o", built, source, "-lm"], check=True)
    loaded = ctypes.CDLL(str(built))
    loaded.instructions.restype = ctypes.c_char_p
    ending = "" if kind is np.float64 else "_float"
    given = np.geomspace(1e-19, 9e8, 20_000).astype(kind)
    wanted = function_of(module.kernels[0])(given)
    for version in loaded.instructions().decode().split():
        loop = getattr(loaded, f"{version}_trial_{module.kernels[0].name}{ending}", None)
        wide_only = made is cube_root and kind is np.float32
        assert (loop is None) == (wide_only and version != "avx512")
        if loop is None:
            continue
        found = [np.full_like(given, -7.0) for _ in wanted]
        pointers = [ctypes.c_void_p(x.ctypes.data) for x in (given, *found)]
        sizes = [ctypes.c_size_t(x) for x in (given.size, 3, 1)]
        assert loop(*sizes, *pointers) == 0
        for mine, theirs in zip(wanted, found, strict=True):
            assert np.array_equal(mine.view(np.uint8), theirs.view(np.uint8))
        bad = np.append(given[:-1], kind(np.nan))
        assert loop(*sizes, ctypes.c_void_p(bad.ctypes.data), *pointers[1:]) == 1


@pytest.mark.alike
@KINDS
@pytest.mark.parametrize("bad", [np.nan, np.inf, -1.0, 0.0, 2e6])
def test_the_first_that_is_refused_is_told_and_nothing_is_written(
    kind: type[Any], bad: float, tmp_path: Path
) -> None:
    module = module_of(two_inputs())
    loaded = library(module, prove_all(module.kernels), tmp_path)
    given = [np.full(1000, 2.0, kind), np.full(1000, 3.0, kind)]
    given[1][[700, 800]] = bad
    code, first, found = call_arrays(loaded, module, module.kernels[0], given)
    assert (code, first) == (2, 700)
    assert all(np.all(column == -7.0) for column in found)
    given[0][650] = bad
    assert call_arrays(loaded, module, module.kernels[0], given)[:2] == (1, 650)


@KINDS
def test_what_inputs_must_be_together_is_refused_with_its_own_code(
    kind: type[Any], tmp_path: Path
) -> None:
    module = module_of(apart())
    loaded = library(module, prove_all(module.kernels), tmp_path)
    given = [np.linspace(-3, 4, 1001).astype(kind), np.zeros(1001, kind)]
    given[1][:] = 5e-4
    given[0][600] = 0.0
    code, first, found = call_arrays(loaded, module, module.kernels[0], given)
    if kind == np.float32:
        assert (code, first) == (3, 600)
        given[1][:] = 2e-3
        code, first, found = call_arrays(loaded, module, module.kernels[0], given)
    assert (code, first) == (0, -1)
    assert np.array_equal(found[0], function_of(module.kernels[0])(*given)[0])


def test_numbers_are_taken_one_by_one(tmp_path: Path) -> None:
    module = module_of(two_inputs())
    loaded = library(module, prove_all(module.kernels), tmp_path)
    value = ctypes.c_double(-7.0)
    scalar = loaded.trial_kernel
    scalar.argtypes = [ctypes.c_double, ctypes.c_double, ctypes.c_void_p]
    assert scalar(1.0, 0.0, ctypes.byref(value)) == 2
    assert value.value == -7.0
    assert scalar(1.0, 3.0, ctypes.byref(value)) == 0
    assert value.value == 0.25


def test_what_would_round_otherwise_does_not_compile(tmp_path: Path) -> None:
    module, command = module_of(trial()), compiler()
    for name, text in c_files(module, prove_all(module.kernels)).items():
        (tmp_path / name).write_text(text, encoding="utf-8")

    def compiled(*flags: str) -> subprocess.CompletedProcess[str]:
        line = [command, *flags, "-c", "trial.c", "-o", "trial.o"]
        return subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, check=False)

    assert compiled("-std=c99").returncode == 0
    for option in ("-ffast-math", "-ffinite-math-only"):
        refused = compiled("-std=c99", option)
        assert refused.returncode
        assert "without -ffast-math" in refused.stderr


def test_cpp_reads_the_header(tmp_path: Path) -> None:
    module, command = module_of(trial()), compiler()
    header = c_files(module, prove_all(module.kernels))["trial.h"]
    (tmp_path / "trial.h").write_text(header, encoding="utf-8")
    text = '#include "trial.h"\n#include "trial.h"\nint main() { return 0; }\n'
    (tmp_path / "main.cc").write_text(text, encoding="utf-8")
    line = [command, "-x", "c++", "-Wall", "-Werror", "-c", "main.cc", "-o", "main.o"]
    done = subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, check=False)
    if "cc1plus" in done.stderr:
        pytest.skip("the compiler has no C++")
    assert done.returncode == 0, done.stderr


def test_no_two_names_are_alike_and_none_hides_what_is_called(tmp_path: Path) -> None:
    b = GraphBuilder()
    root, namespace = b.symbol("sqrt"), b.symbol("namespace")
    graph = b.graph({"sqrt_": b.sqrt(root + namespace), "sqrt": root, "fabs": namespace + 1})
    names = ("sqrt", "namespace")
    kernel = replace(
        several_of(graph, "1e-6", "1e6"),
        inputs=tuple(closed(name, "an argument", "1e-6", "1e6") for name in names),
    )
    loaded = library(module_of(kernel), prove_all([kernel]), tmp_path)
    given = [np.array([4.0, 9.0]), np.array([5.0, 7.0])]
    code, _, found = call_arrays(loaded, module_of(kernel), kernel, given)
    assert code == 0
    assert [column.tolist() for column in found] == [[3.0, 4.0], [4.0, 9.0], [6.0, 8.0]]
    assert "namespace," not in (tmp_path / "trial.h").read_text(encoding="utf-8")


def test_the_comment_cannot_be_left() -> None:
    kernel = replace(trial(), source="a */ b /* c", equations=("y = x*/2",))
    header = c_files(module_of(kernel), prove_all([kernel]))["trial.h"]
    assert "a * / b / * c" in header
    assert header.count("/*") == header.count("*/")
