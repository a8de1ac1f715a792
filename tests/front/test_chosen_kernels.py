"""One kernel, one format: a package has nothing else, and its numbers are those of the whole."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from c_library import compiler

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.standalone import testing
from gainproof.standalone.files import ARRAYS, TARGETS, _needed
from gainproof.subjects.chosen_kernels import require_found

Capture = pytest.CaptureFixture[str]
SUBJECT, MODULE = "least-squares-line", "least_squares_line"
EVERY = tuple(word for target in TARGETS for word in ("--target", target))
OTHER = {"float32": "float64", "float64": "float32"}
FOREIGN = {"float32": r"double|f64|binary64|float64", "float64": r"float|single|f32|binary32"}
"""Words of the other format in what other languages compute."""


def generate(folder: Path, *options: str, subject: str = SUBJECT) -> int:
    return cli.main(["generate", subject, "--out", str(folder), *options])


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("whole") / "line_whole"
    assert generate(folder, *EVERY) == 0
    return folder


def sources(folder: Path) -> dict[str, list[str]]:
    """Lines of what the other languages compute, without comments, by file."""
    found = {}
    for path in sorted(folder.rglob("*")):
        is_test = "test" in path.relative_to(folder).as_posix()
        if path.suffix in (".c", ".m", ".rs", ".fpcore") and not is_test:
            text = re.sub(r"/\*.*?\*/", "", path.read_text("utf-8"), flags=re.DOTALL)
            lines = [line for line in text.splitlines() if not re.match(r"\s*(//|%|;)", line)]
            found[path.relative_to(folder).as_posix()] = lines
    return found


def results(folder: Path, form: str) -> bytes:
    """Bits of the gains at numbers of a format, in a process of its own."""
    code = (
        f"import numpy as np; from {folder.name}.{MODULE} import gains\n"
        f"at = np.arange(1, 3000, dtype='{form}')\n"
        "print([y.tobytes().hex() for y in gains(at)])"
    )
    run = [sys.executable, "-c", code]
    done = subprocess.run(run, cwd=folder.parent, capture_output=True, check=True)
    return done.stdout


@pytest.mark.parametrize("form", ["float32", "float64"])
def test_a_package_of_one_kernel_in_one_format(
    form: str, whole: Path, tmp_path: Path, capsys: Capture
) -> None:
    folder = tmp_path / "line_gains"
    options = ("--kernel", "gains", "--format", form, *EVERY)
    assert generate(folder, *options, "--test") == 0, capsys.readouterr().out
    every, found = sources(whole), sources(folder)
    assert {name.partition("/")[0] for name in found} == set(TARGETS) - set(ARRAYS)
    assert set(found) == {name for name in every if "covariance" not in name}
    for name, lines in found.items():
        # nothing but what the whole has, but for Octave's choice between two types
        ours = set(lines) - set(every[name])
        assert not any("covariance" in line for line in lines)
        assert not ours or name.endswith(".m"), ours
        assert all("isa(" in line or "all inputs must be" in line for line in ours)
        code = "\n".join(line for line in lines if "#" not in line)
        code = code.replace("double(value(", "")  # a message of Octave's
        assert not re.search(rf"\b\w*({FOREIGN[form]})\b", code), name
    assert results(folder, form) == results(whole, form)
    for name in (f"tests/values_{MODULE}.json", f"{MODULE}.py", f"{MODULE}.md"):
        text = (folder / name).read_text("utf-8")
        assert "updated_covariance" not in text
        told = "inputs that are all float32 are refused"
        assert OTHER[form] not in " ".join(text.split()).replace(told, "")
    assert not (folder / "_double_word.py").exists()
    assert generate(folder, *options, "--check") == 0
    assert generate(folder, *options[:2], *EVERY, "--check") == 1


def test_a_format_that_is_not_here_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "line_single"
    assert generate(folder, "--format", "float32") == 0
    code = (
        f"import numpy as np; from line_single.{MODULE} import gains\n"
        "for x in (5.0, 5, np.array([5.0])):\n"
        "    try: gains(x)\n"
        "    except TypeError as error: print(error)\n"
        "assert gains(np.float32(5)).alpha.dtype == 'float32'"
    )
    run = [sys.executable, "-c", code]
    done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=True)
    said = "gains: only float32 is here, and inputs must be of it, got sample_number"
    assert done.stdout.splitlines() == [
        f"{said} {kind}" for kind in ("float64", "int64", "float64")
    ]


@pytest.mark.parametrize("form", ["float32", "float64"])
def test_one_format_computes_in_c_too(form: str, tmp_path: Path) -> None:
    compiler()
    folder = tmp_path / "line_in_c"
    assert generate(folder, "--kernel", "gains", "--format", form, "--target", "c") == 0
    run = [sys.executable, "-m", "line_in_c.compile"]
    done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=False)
    # of two outputs 20,000 in one format
    assert "1 kernel in C, 40,000 results compared" in done.stdout, done.stderr
    assert testing.passes(folder)


def test_each_subject_has_its_own_of_the_kernels(tmp_path: Path) -> None:
    folder = tmp_path / "both"
    run = ["generate", SUBJECT, "filter-step", "--out", str(folder)]
    assert cli.main([*run, "--kernel", "gains", "--kernel", "step_two_states"]) == 0
    for module, wanted in ((MODULE, "gains"), ("filter_step", "step_two_states")):
        text = (folder / f"{module}.py").read_text("utf-8")
        assert re.findall(r"^def ([a-z]\w*)\(", text, re.MULTILINE) == [wanted]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--kernel", "gain"), "no kernel is called 'gain'; nearest: gains"),
        (("--kernel", "gains", "--kernel", "zzz"), "no kernel is called 'zzz'; known: gains, "),
    ],
)
def test_kernels_that_are_not_there(
    options: tuple[str, ...], said: str, tmp_path: Path, capsys: Capture
) -> None:
    assert generate(tmp_path / "none", *options) == 2
    assert said in capsys.readouterr().err
    assert not (tmp_path / "none").exists()


def test_why_a_kernel_is_not_there_and_subjects_without_any() -> None:
    parts = [
        {"kernels": ["gains"], "left_out": "There are no kernels of poles: the number is 2."},
        {"kernels": ["sight"], "left_out": ""},
    ]
    require_found(["a", "b"], parts, [])
    require_found(["a", "b"], parts, ["sight", "gains"])
    with pytest.raises(BadInputError, match=r"'poles'.* There are no kernels of poles: the number"):
        require_found(["a", "b"], parts, ["poles"])
    with pytest.raises(
        BadInputError, match=r"^b: has none of the kernels asked for; it has sight$"
    ):
        require_found(["a", "b"], parts, ["gains"])


@pytest.mark.parametrize("option", [("--kernel", "gains"), ("--format", "float32")])
def test_the_folder_of_the_project_has_all(option: tuple[str, str], capsys: Capture) -> None:
    assert cli.main(["generate", SUBJECT, *option]) == 2
    assert "give --out DIR" in capsys.readouterr().err


def test_shared_code_that_nothing_imports_is_left_out() -> None:
    ours = "from gainproof.generated."
    texts = {
        "gains.py": f"{ours}_bits import choose\nimport numpy",
        "_bits.py": f"if x:\n    {ours}_blocks import cut",
        "_blocks.py": "",
        "_double_word.py": f"{ours}_threads import x",
        "_threads.py": "",
        "gains.md": "",
    }
    assert set(_needed(texts)) == {"gains.py", "_bits.py", "_blocks.py", "gains.md"}


TEXT = """
import sympy as sp
from gainproof.derive.own_expressions.expressions import (
    Argument, ExpressionKernel, ExpressionSet, Result,
)
from gainproof.derive.quantity import ONE, Quantity

X = Quantity("x", "x", "a number", ONE)
Y = Quantity("y", "y", "a value", ONE)
x = X.symbol

def kernel(name, value):
    return ExpressionKernel(
        name=name, title=name, inputs=(Argument(X, "0.1", "3"),), outputs=(Result(Y, value),)
    )

EXPRESSIONS = ExpressionSet(
    name="rests", title="Rests",
    kernels=(kernel("rest", x + sp.exp(-x) - 1), kernel("root", sp.sqrt(x) + 1)),
)
"""


def test_only_what_wanted_kernels_lose_is_said(tmp_path: Path, capsys: Capture) -> None:
    """Near 0.1 half of float32's digits are lost, and less than half of float64's."""
    file, out = tmp_path / "rests.py", tmp_path / "kernels"
    file.write_text(TEXT, encoding="utf-8")
    assert generate(out, subject=str(file)) == 1
    assert "float32" in capsys.readouterr().out
    assert not out.exists()
    assert generate(out, "--kernel", "root", subject=str(file)) == 0
    assert "igits" not in capsys.readouterr().out
    assert generate(out, "--kernel", "rest", subject=str(file)) == 1
    assert generate(out, "--kernel", "rest", "--format", "float32", subject=str(file)) == 1
    said = capsys.readouterr().out
    assert "nothing is written" in said
    assert generate(out, "--format", "float64", subject=str(file)) == 0
    said = capsys.readouterr().out
    assert "up to" in said
    assert "float32" not in said


@pytest.mark.thorough  # two states, whose formulas in double-words need both formats
@pytest.mark.parametrize("form", ["float32", "float64"])
def test_what_needs_both_formats_is_named(form: str, tmp_path: Path, capsys: Capture) -> None:
    options = ("--kernel", "gains", "--format", form, "--test")
    assert generate(tmp_path / "gains_only", *options, subject="random-velocity") == 0
    assert "gains: without accurate=True, which needs both formats" in capsys.readouterr().out
    assert "accurate" not in (tmp_path / "gains_only/random_velocity.py").read_text("utf-8")
