"""Packages with C and FPCore besides: in folders of their own, tested, gone when not wanted."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from gainproof import cli
from gainproof.derive.printer.program import FUNCTIONS
from gainproof.standalone.shipped import test_c, test_octave

SUBJECT, MODULE = "least-squares-mean", "least_squares_mean"
BOTH = ("--target", "fpcore", "--target", "c", "--target", "numpy")
NONE_COLLECTED = 5
"""Of pytest's: all tests of a file are skipped before there are any, as without JAX."""
QUIET = ("-q", "-o", "addopts=", "-p", "no:cacheprovider")


def generate(folder: Path, *options: str) -> int:
    return cli.main(["generate", SUBJECT, "--out", str(folder), *options])


def names(folder: Path) -> set[str]:
    return {p.relative_to(folder).as_posix() for p in folder.rglob("*.*")}


def run_tests(folder: Path, name: str = "c") -> subprocess.CompletedProcess[str]:
    run = [sys.executable, "-m", "pytest", *QUIET, str(folder / f"tests/test_{name}.py")]
    plain = {"PYTHONDONTWRITEBYTECODE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    own = {**os.environ, **plain}
    return subprocess.run(run, env=own, capture_output=True, text=True, check=False)


def test_other_targets_lie_in_folders_of_their_own(tmp_path: Path) -> None:
    package = tmp_path / "mean_kernels"
    assert generate(package) == 0
    before = names(package)
    assert generate(package, *BOTH) == 0
    c_files = {f"c/{MODULE}.h", f"c/{MODULE}.c", f"c/{MODULE}.json", f"c/test_{MODULE}.c"}
    c_files |= {f"c/{MODULE}_numpy.c", "tests/test_c.py", "_compiled.py", "compile.py"}
    assert names(package) - before == {*c_files, f"fpcore/{MODULE}.fpcore"}
    assert generate(package, *BOTH, "--check") == 0
    assert run_tests(package).returncode == 0
    source = package / "c" / f"{MODULE}.c"
    text = source.read_text(encoding="utf-8")
    source.write_text(text.replace(" + 1.0;", " + 1.0000000000001;"), encoding="utf-8")
    assert source.read_text(encoding="utf-8") != text
    said = run_tests(package).stdout
    assert "skipped" in said or "3 failed" in said, said
    assert generate(package) == 0  # what is no longer wanted goes
    assert names(package) == before


@pytest.mark.parametrize(
    ("name", "files"),
    [
        ("octave", {f"+{MODULE}/gains.m", f"+{MODULE}/predicted_covariance.m",
                    f"+{MODULE}/updated_covariance.m", f"test_{MODULE}.m"}),
        ("array-api", {"__init__.py", "_arrays.py", f"{MODULE}.py"}),
        ("jax", {"__init__.py", "_arrays.py", "_jax.py", f"{MODULE}.py"}),
        ("rust", {f"{MODULE}/Cargo.toml", f"{MODULE}/src/lib.rs", f"{MODULE}/tests/values.rs"}),
    ],
)  # fmt: skip
def test_a_language_has_its_files_and_their_test(
    tmp_path: Path, name: str, files: set[str]
) -> None:
    package = tmp_path / "mean_kernels"
    assert generate(package, "--target", name) == 0
    name = name.replace("-", "_")
    found = {each for each in names(package) if each.startswith(f"{name}/")}
    assert found == {f"{name}/{each}" for each in files}
    assert run_tests(package, name).returncode in (0, NONE_COLLECTED)
    kernels = ("gains.m", "lib.rs", f"{MODULE}.py")
    (source,) = (package / name / each for each in files if each.endswith(kernels))
    text = source.read_text(encoding="utf-8")
    source.write_text(text.replace(" + 1.0", " + 1.0000000000001"), encoding="utf-8")
    assert source.read_text(encoding="utf-8") != text
    said = run_tests(package, name).stdout
    assert "skipped" in said or "failed" in said, said


def test_the_functions_that_round_otherwise_are_those_that_kernels_call() -> None:
    assert set(test_c.LIBRARY) == set(test_octave.LIBRARY) == set(FUNCTIONS)


def test_other_targets_need_a_package(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["generate", SUBJECT, "--target", "c"]) == 2
    assert "give --out DIR" in capsys.readouterr().err
