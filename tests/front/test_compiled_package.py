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
from samples import samples

import gainproof.generated.filter_step as plain
from gainproof import cli
from gainproof.standalone.in_c import _compiled
from gainproof.standalone.in_c._compiled import FILL, INSTRUCTIONS, LOOK, _found
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
    count = len(signature.inputs) + len(signature.outputs)
    return compiled._found(signature.block, signature.name, count) is not None


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
@pytest.mark.parametrize(("read", "filled"), [(0, 0), (0, 5), (5, 0)])
def test_outputs_may_take_the_place_of_inputs(
    in_c: ModuleType, kernel: str, read: int, filled: int
) -> None:
    given = arguments(kernel, np.float64, [(70_000,)])
    want = getattr(plain, kernel)(*given)
    memory = np.empty(70_005)
    x, y = memory[read:][:70_000], memory[filled:][:70_000]
    x[...] = given[0]
    out = (y, *(np.empty_like(y) for y in want[1:]))
    assert same(getattr(in_c, kernel)(x, *given[1:], out=out), want)


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


def recorded(refused_from: int = 10**9) -> tuple[list[tuple[Any, ...]], Any]:
    """The calls of a function in C, and the function: it refuses what begins at an element or
    beyond, of an array of numbers that count its elements.
    """
    seen: list[tuple[Any, ...]] = []

    def function(size: int, how: int, own: int, *places: int) -> int:
        first = ctypes.c_double.from_address(places[1]).value
        seen.append((size, how, own, first))
        return how & LOOK and first + size > refused_from

    return seen, function


def no_block(*_: Any) -> None:
    raise AssertionError("NumPy computes")


def test_numbers_are_handed_to_c_as_numbers() -> None:
    seen, function = recorded()
    whole = in_c_block(no_block, function, function).whole
    inputs, outputs = [np.array(2.0), np.arange(4.0), np.array([5.0])], [np.empty(4)]
    assert whole(inputs, outputs, True, 1)
    assert seen == [(4, LOOK | FILL, 0b010, 0.0)]


@pytest.mark.parametrize("workers", [1, 3])
@pytest.mark.parametrize("fresh", [False, True])
def test_all_is_looked_at_before_what_was_given_is_touched(
    fresh: bool, workers: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_compiled, "PIECE", 100)
    monkeypatch.setattr(_compiled, "BLOCK", 50)
    inputs, outputs = [np.array(2.0), np.arange(450.0)], [np.empty(450)]
    starts = [0.0, 100.0, 200.0, 300.0, 400.0]
    seen, function = recorded()
    assert in_c_block(no_block, function, function).whole(inputs, outputs, fresh, workers)
    sizes = [100, 100, 100, 100, 50]
    passes = [LOOK | FILL] if fresh else [LOOK, FILL]
    found = [sorted(seen[i : i + 5], key=lambda call: call[3]) for i in range(0, len(seen), 5)]
    assert found == [
        [(size, how, 0b10, start) for size, start in zip(sizes, starts, strict=True)]
        for how in passes
    ]
    seen, function = recorded(refused_from=449)
    assert not in_c_block(no_block, function, function).whole(inputs, outputs, fresh, workers)
    assert not any(how == FILL for _, how, _, _ in seen)


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_guards_in_c_are_the_only_ones(
    in_c: ModuleType, kernel: str, kind: type[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of arrays in one piece and numbers beside them."""
    given = arguments(kernel, kind, [(3000,), ()])
    want = getattr(plain, kernel)(*given)
    monkeypatch.setattr(importlib.import_module(f"{PACKAGE}._runtime"), "admit", no_block)
    assert same(getattr(in_c, kernel)(*given), want)
    out = tuple(np.empty_like(y) for y in want)
    assert same(getattr(in_c, kernel)(*given, out=out), want)


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("version", INSTRUCTIONS)
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_every_set_of_instructions_gives_the_same_bits(
    in_c: ModuleType,
    kernel: str,
    version: str,
    kind: type[Any],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    there = importlib.import_module(f"{PACKAGE}._compiled")
    monkeypatch.setenv(there.AT_MOST, version)
    loaded = there.load(MODULE)
    best = there.best_instructions(loaded)
    assert best == version or version not in ("none", *there.instructions(loaded))
    loops = [f"{best}_{there.same_bits(MODULE)[kernel]}{ending}" for ending in ("", "_float")]
    seen: list[str] = []
    taken = there.functions

    def watched(*given: Any) -> Any:
        seen.extend(each.__name__ for each in taken(*given) if each is not None)
        return taken(*given)

    monkeypatch.setattr(there, "functions", watched)
    there._found.cache_clear()
    for length in (1, 7, 255, 256, 257, 1000):
        for shapes in ([(length,)], [(length,), ()], [(), (length,)]):
            given = arguments(kernel, kind, shapes)
            assert same(getattr(in_c, kernel)(*given), getattr(plain, kernel)(*given))
    assert seen == ([] if best == "none" else loops)
    there._found.cache_clear()


def test_a_set_of_instructions_that_is_none_is_refused(compiled: Path) -> None:
    kernel = KERNELS[0]
    given = ", ".join(["[0.5]"] * len(getattr(plain, f"_{kernel.upper()}").inputs))
    code = f"from {PACKAGE}.{MODULE} import {kernel}; {kernel}({given})"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "GAINPROOF_INSTRUCTIONS": "avx3"},
        cwd=compiled.parent,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (
        "GAINPROOF_INSTRUCTIONS must be one of none, plain, avx2, avx512, got 'avx3'" in done.stderr
    )


def outcome(function: Any, given: Sequence[Any], out: Any, workers: Any) -> Any:
    """What a call returns or says, and what it leaves in the arrays that it was given."""
    try:
        found = [np.asarray(y) for y in function(*given, out=out, workers=workers)]
        said: Any = [(y.dtype.str, y.shape, y.tobytes()) for y in found]
    except (TypeError, ValueError) as error:
        said = type(error), str(error)
    return said, [x.tobytes() for x in (*given, *(out or ())) if isinstance(x, np.ndarray)]


def one_call(kernel: str, generator: np.random.Generator) -> tuple[list[Any], Any, int]:
    """Arguments of many kinds: shapes, types, places in memory, outputs that overlap, and numbers
    outside of their domains.
    """
    signature = getattr(plain, f"_{kernel.upper()}")
    kind = (np.float64, np.float32)[generator.integers(2)]
    size = int(generator.choice([1, 3, 300, 2000]))
    given: list[Any] = []
    for _ in signature.inputs:
        x = generator.uniform(0.1, 0.9, size).astype(kind)
        match generator.integers(30):
            case 0:
                x = x[:1]
            case 1:
                x = np.asarray(x[0])
            case 2:
                given.append(float(x[0]))
                continue
            case 3:
                x = np.repeat(x, 2)[::2]
            case 4:
                x = x[::-1]
            case 5:
                x = np.frombuffer(b"?" + x.tobytes(), np.uint8)[1:].view(kind)
            case 6:
                x = x.astype(x.dtype.newbyteorder())
            case 7:
                x[generator.integers(x.size)] = generator.choice([np.nan, -1.0, 3e38, np.inf, 0])
        given.append(x)
    arrays = [x for x in given if isinstance(x, np.ndarray)]
    out = None
    if generator.integers(2):
        whole = np.full((len(signature.outputs), size + 3), 7.0, kind)
        out = tuple(row[:size] for row in whole)
        own = [x for x in arrays if x.shape == (size,) and x.dtype == kind and x.flags.writeable]
        if own and generator.integers(2):
            out = (own[generator.integers(len(own))], *out[1:])
        elif generator.integers(2):
            whole[0] = generator.uniform(0.1, 0.9, size + 3)
            ends = (slice(3, None), slice(size))
            turned = generator.integers(2)
            given[0], first = whole[0][ends[turned]], whole[0][ends[1 - turned]]
            out = (first, *out[1:])
    return given, out, int(generator.integers(1, 4))


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.sampled
def test_any_call_ends_as_it_does_in_numpy(
    in_c: ModuleType, kernel: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = importlib.import_module(f"{PACKAGE}._compiled")
    monkeypatch.setattr(there, "PIECE", 700)
    monkeypatch.setattr(there, "BLOCK", 500)
    for seed in range(samples(100)):
        said = [
            outcome(getattr(module, kernel), *one_call(kernel, np.random.default_rng(seed)))
            for module in (plain, in_c)
        ]
        assert said[0] == said[1], seed


def test_double_words_are_never_computed_by_the_plain_function() -> None:
    module = importlib.import_module("gainproof.generated.random_acceleration")
    accurate = module._ACCURATE_GAINS
    assert accurate.name == module._GAINS.name
    assert _found(accurate.block, accurate.name, 3) is None


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
