"""Packages whose kernels compute in C: the functions, refusals and bits of the NumPy modules."""

from __future__ import annotations

import ctypes
import importlib
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from c_library import compiler

import gainproof.generated.filter_step as plain
from gainproof import cli
from gainproof.standalone.in_c._compiled import _found
from gainproof.standalone.in_c._compiled import in_c as in_c_block

SUBJECT, MODULE, PACKAGE = "filter-step", "filter_step", "steps_in_c"


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    compiler()
    folder = tmp_path_factory.mktemp("made") / PACKAGE
    assert cli.main(["generate", SUBJECT, "--out", str(folder), "--target", "c"]) == 0
    return folder


@pytest.fixture
def package(written: Path, tmp_path: Path) -> Path:
    """A copy to do harm to."""
    return Path(shutil.copytree(written, tmp_path / PACKAGE))


def run(package: Path, *arguments: str, **others: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", *arguments],
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **others},
        cwd=package.parent,
        capture_output=True,
        text=True,
        check=False,
    )


def libraries(package: Path) -> list[Path]:
    return sorted((package / "c").glob("*.so"))


@pytest.fixture(scope="module")
def once_compiled(written: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    package = Path(shutil.copytree(written, tmp_path_factory.mktemp("compiled") / PACKAGE))
    done = run(package, f"{PACKAGE}.compile")
    assert done.returncode == 0, done.stderr
    assert "the same bits" in done.stdout
    assert len(libraries(package)) == 1
    return package


@pytest.fixture
def compiled(once_compiled: Path, tmp_path: Path) -> Path:
    """A copy to do harm to."""
    return Path(shutil.copytree(once_compiled, tmp_path / PACKAGE))


@pytest.fixture(scope="module")
def in_c(once_compiled: Path) -> Iterator[ModuleType]:
    """The module of a package that is compiled."""
    package = once_compiled
    sys.path.insert(0, str(package.parent))
    yield importlib.import_module(f"{PACKAGE}.{MODULE}")
    sys.path.remove(str(package.parent))
    for name in [each for each in sys.modules if each.partition(".")[0] == PACKAGE]:
        del sys.modules[name]


KERNELS = [name for name in plain.__all__ if name.islower()]


def arguments(kernel: str, kind: type[Any], shapes: Sequence[tuple[int, ...]]) -> list[Any]:
    """Of these shapes in turn, within 0.1 to 0.9."""
    generator = np.random.default_rng(5)
    signature = getattr(plain, f"_{kernel.upper()}")
    return [
        generator.uniform(0.1, 0.9, shapes[place % len(shapes)]).astype(kind)
        for place in range(len(signature.inputs))
    ]


def same(mine: Sequence[Any], theirs: Sequence[Any]) -> bool:
    return all(
        np.shape(x) == np.shape(y)
        and np.asarray(x).dtype == np.asarray(y).dtype
        and np.asarray(x).tobytes() == np.asarray(y).tobytes()
        for x, y in zip(mine, theirs, strict=True)
    )


def computes_in_c(module: ModuleType, kernel: str) -> bool:
    signature = getattr(module, f"_{kernel.upper()}")
    compiled = importlib.import_module(f"{PACKAGE}._compiled")
    return compiled._found(signature.block, signature.name, signature.work) is not None


SHAPES: list[Sequence[tuple[int, ...]]] = [
    [()],
    [(70_000,)],
    [(0,)],
    [(300, 1), (400,), ()],
    [(7, 5), (), (5,), (7, 1)],
]


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_results_are_the_same_bit_for_bit(in_c: ModuleType, kernel: str, kind: type[Any]) -> None:
    assert computes_in_c(in_c, kernel)
    for shapes in SHAPES:
        given = arguments(kernel, kind, shapes)
        want = getattr(plain, kernel)(*given)
        assert same(getattr(in_c, kernel)(*given), want)
        assert same(getattr(in_c, kernel)(*given, workers=2), want)
        out = tuple(np.full_like(y, 7.0) for y in want if np.shape(y)) or None
        if out is not None:
            assert same(getattr(in_c, kernel)(*given, out=out), want)
            assert same(out, want)


@pytest.mark.parametrize("kernel", KERNELS)
def test_outputs_may_take_the_place_of_inputs(in_c: ModuleType, kernel: str) -> None:
    given = arguments(kernel, np.float64, [(70_000,)])
    want = getattr(plain, kernel)(*given)
    out = (given[0], *(np.empty_like(y) for y in want[1:]))
    assert same(getattr(in_c, kernel)(*given, out=out), want)


@pytest.mark.parametrize("kernel", KERNELS)
def test_numbers_across_their_places_in_memory_are_taken(in_c: ModuleType, kernel: str) -> None:
    given = arguments(kernel, np.float64, [(1000,)])
    want = getattr(plain, kernel)(*given)
    across = np.frombuffer(b"\0" + given[0].tobytes(), np.uint8)[1:].view(np.float64)
    assert not across.flags.aligned
    assert same(getattr(in_c, kernel)(across, *given[1:]), want)


@pytest.mark.parametrize("kernel", KERNELS)
def test_what_is_refused_is_told_alike_and_nothing_is_written(
    in_c: ModuleType, kernel: str
) -> None:
    given = arguments(kernel, np.float64, [(70_000,)])
    given[-1][69_999] = np.nan
    said = []
    for module in (plain, in_c):
        out = tuple(np.full(70_000, 7.0) for _ in getattr(plain, f"_{kernel.upper()}").outputs)
        with pytest.raises(ValueError, match="at index 69999") as caught:
            getattr(module, kernel)(*given, out=out)
        said.append(str(caught.value))
        assert all((y == 7.0).all() for y in out)
    assert said[0] == said[1]


def test_c_sees_one_number_as_often_as_there_are_results() -> None:
    seen: list[list[float]] = []

    def function(size: ctypes.c_size_t, *places: Any) -> int:
        row = ctypes.c_double * size.value
        seen.extend(list(row.from_address(place.value)) for place in places[:-1])
        return 0

    block = in_c_block(lambda *_: None, 0, function, function)
    inputs, outputs = [np.array([2.0]), np.array([3.0, 4.0])], [np.array([5.0, 6.0])]
    block(inputs, outputs, [np.empty(2), np.empty(2)], False)
    assert seen == [[2.0, 2.0], [3.0, 4.0], [5.0, 6.0]]


def test_double_words_are_never_computed_by_the_plain_function() -> None:
    module = importlib.import_module("gainproof.generated.random_acceleration")
    accurate = module._ACCURATE_GAINS
    assert accurate.name == module._GAINS.name
    assert _found(accurate.block, accurate.name, accurate.work) is None


def test_a_library_that_is_not_as_numpy_is_not_used(compiled: Path) -> None:
    package = compiled
    before = libraries(package)
    source = package / "c" / f"{MODULE}.c"
    text = source.read_text(encoding="utf-8")
    changed = text.replace(" + 1.0;", " + 1.0000000000000002;").replace(" - ", " + ")
    assert changed != text
    source.write_text(changed, encoding="utf-8")
    done = run(package, f"{PACKAGE}.compile")
    assert done.returncode == 1
    assert "in C" in done.stderr
    assert "no library is put in place" in done.stderr
    assert libraries(package) == before  # that of the former source, which is not looked at
    assert run(package, f"{PACKAGE}.compile", "--remove").returncode == 0
    assert libraries(package) == []


def test_what_computes_in_c_now_can_be_asked_for(package: Path) -> None:
    def shown() -> str:
        done = run(package, f"{PACKAGE}.compile", "--show")
        assert done.returncode == 0, done.stderr
        return done.stdout

    assert shown() == f"{MODULE}: all NumPy's\n"
    compiled = run(package, f"{PACKAGE}.compile").stdout
    count = compiled.split(" in C")[0]
    assert shown().startswith(f"{count} in C")
    assert ("NumPy's stay" in shown()) == ("NumPy's stay" in compiled)
    assert run(package, f"{PACKAGE}.compile", "--remove").returncode == 0
    assert shown() == f"{MODULE}: all NumPy's\n"
    assert run(package, f"{PACKAGE}.compile", "--show", "--remove").returncode == 2


def test_without_a_compiler_nothing_is_changed(package: Path) -> None:
    done = run(package, f"{PACKAGE}.compile", PATH="", CC="")
    assert done.returncode == 2
    assert "needs a C compiler" in done.stderr
    assert libraries(package) == []


def test_a_compiler_of_ones_own_is_taken_with_its_options(package: Path) -> None:
    done = run(package, f"{PACKAGE}.compile", CC="no_such_compiler -m64")
    assert done.returncode == 2
    assert "$CC is no_such_compiler -m64" in done.stderr
    assert run(package, f"{PACKAGE}.compile", CC=f"{compiler()} -DNOTHING").returncode == 0


def test_without_the_sources_numpy_computes(package: Path) -> None:
    shutil.rmtree(package / "c")
    kernel = KERNELS[0]
    given = ", ".join(["0.5"] * len(getattr(plain, f"_{kernel.upper()}").inputs))
    code = f"from {PACKAGE}.{MODULE} import {kernel}; print({kernel}({given}))"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=package.parent, capture_output=True, text=True, check=True
    )
    assert done.stdout
    assert done.stderr == ""
    done = run(package, f"{PACKAGE}.compile")
    assert done.returncode == 2
    assert "no sources in" in done.stderr


def test_what_the_compiler_says_is_told(package: Path) -> None:
    (package / "c" / f"{MODULE}.c").write_text("int wrong(", encoding="utf-8")
    done = run(package, f"{PACKAGE}.compile")
    assert done.returncode == 2
    assert "error:" in done.stderr
    assert libraries(package) == []


def test_a_library_that_cannot_be_loaded_is_told_and_numpy_computes(compiled: Path) -> None:
    package = compiled
    (library,) = libraries(package)
    library.write_bytes(b"no library")
    kernel = KERNELS[0]
    given = ", ".join(["[0.5]"] * len(getattr(plain, f"_{kernel.upper()}").inputs))
    code = f"from {PACKAGE}.{MODULE} import {kernel}; print([*map(list, {kernel}({given}))])"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=package.parent, capture_output=True, text=True, check=True
    )
    assert "cannot be loaded, NumPy computes" in done.stderr
    want = getattr(plain, kernel)(*[[0.5]] * given.count("0.5"))
    assert done.stdout.strip() == str([*map(list, want)])


def test_a_run_of_generate_leaves_libraries_alone(compiled: Path) -> None:
    package = compiled
    before = libraries(package)
    options = ["generate", SUBJECT, "--out", str(package), "--target", "c"]
    assert cli.main([*options, "--check"]) == 0
    assert cli.main(options) == 0
    assert libraries(package) == before
