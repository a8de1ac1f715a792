"""A user's own model: derived like any other, and every mistake answered with its place."""

from __future__ import annotations

import importlib
import re
from pathlib import Path

import pytest

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.subjects import derivations
from gainproof.subjects.own_file import built, defined

Capture = pytest.CaptureFixture[str]

MODEL = """
from fractions import Fraction

import sympy as sp

from gainproof.derive.model import Model
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION, METRE, SAMPLING_INTERVAL, SECOND, Quantity,
)

T, deviation = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
SHAKE = Quantity("shake", "w", "strength of the noise", METRE / SECOND**2)
w = SHAKE.symbol
MODEL = Model(
    name="half-and-half",
    title="Noise of its own",
    transition=sp.ImmutableDenseMatrix([[1, T], [0, 1]]),
    process_noise=w**2 * sp.ImmutableDenseMatrix([[T**4 / 3, T**3 / 2], [T**3 / 2, T**2]]),
    measurement=sp.ImmutableDenseMatrix([[1, 0]]),
    measurement_noise=sp.ImmutableDenseMatrix([[deviation**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE),
    state_units=(METRE, METRE / SECOND),
)
"""

EXPRESSIONS = """
from gainproof.derive.own_expressions.expressions import (
    Argument, ExpressionKernel, ExpressionSet, Result
)
from gainproof.derive.quantity import ONE, Quantity

NUMBER = Quantity("x", "x", "a number", ONE)
SQUARE = Quantity("square", "s", "its square", ONE)
KERNEL = ExpressionKernel(
    name="square",
    title="A square",
    inputs=(Argument(NUMBER, "1", "10"),),
    outputs=(Result(SQUARE, NUMBER.symbol**2),),
)
EXPRESSIONS = ExpressionSet(name="squares", title="A square", kernels=(KERNEL,))
"""
"""What is sooner derived than a model."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("models")


@pytest.fixture
def file(folder: Path) -> Path:
    # its path is the same in every test, so that the model is derived once for all
    path = folder / "own_model.py"
    path.write_text(MODEL)
    return path


@pytest.mark.thorough  # by default that of the README is: `test_readme.py`
def test_own_model_is_derived_and_proved(file: Path, capsys: Capture) -> None:
    assert cli.main(["derive", str(file), "--steps"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("Noise of its own\n")
    assert "rejected" not in text
    assert len(re.findall(r"\[proved\]$", text, flags=re.MULTILINE)) > 30
    assert int(re.findall(r"(\d+) proved,", text)[0]) > 80


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x = 1\n", "wanted a variable MODEL"),
        ("MODEL = 3\n", "it is int"),
        ("x = 1\ny = 1 / 0\n", "line 2: ZeroDivisionError"),
        ("x = = 1\n", "line 1: SyntaxError"),
        ("raise SystemExit(0)\n", "SystemExit"),
        (MODEL.replace("T**4 / 3", "T**4 / 5"), "process_noise should be positive semidefinite"),
        (MODEL.replace("[[1, T], [0, 1]]", "[[1, 2 * T, 0], [0, 1, 0]]"), "should have the shape"),
        (MODEL.replace("[[1, 0]]", "[[2, 0]]"), "the first state is to be measured"),
        (MODEL.replace("[[1, 0]]", "[[0, 1]]"), "should hold numbers"),
        (
            MODEL.replace("T**4 / 3", "T**3 / 3"),
            "entry 1,1 of process_noise should have the unit m",
        ),
    ],
)
def test_each_mistake_is_bad_input_and_names_the_file(text: str, message: str, file: Path) -> None:
    file.write_text(text)
    with pytest.raises(BadInputError) as caught:
        built(str(file), *defined(str(file)))
    assert message in str(caught.value)
    assert "own_model.py" in str(caught.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("raise SystemExit(0)\n", "SystemExit"),
        pytest.param(
            *(MODEL.replace("[[1, 0]]", "[[2, 0]]"), "the first state is to be measured"),
            marks=pytest.mark.thorough,
        ),
    ],
)
def test_a_mistake_has_status_2_and_one_line(
    text: str, message: str, file: Path, capsys: Capture
) -> None:
    file.write_text(text)
    assert cli.main(["derive", str(file)]) == 2
    captured = capsys.readouterr()
    assert message in captured.err
    assert "own_model.py" in captured.err
    assert "Traceback" not in captured.err


def test_what_the_file_prints_does_not_spoil_the_answer(file: Path, capsys: Capture) -> None:
    file.write_text(MODEL + "\nprint('{\"result\": 1}')\n")
    assert cli.main(["derive", str(file)]) == 0
    assert capsys.readouterr().out.startswith("Noise of its own\n")


def test_a_changed_file_is_derived_again(file: Path, capsys: Capture) -> None:
    file.write_text(EXPRESSIONS)
    cli.main(["derive", str(file)])
    file.write_text(EXPRESSIONS.replace("A square", "Another title"))
    capsys.readouterr()
    assert cli.main(["derive", str(file)]) == 0
    assert capsys.readouterr().out.startswith("Another title\n")


@pytest.mark.thorough
def test_kernels_of_an_own_model_are_written_tested_and_run(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    out = tmp_path / "own_kernels"
    assert cli.main(["generate", str(file), "--out", str(out), "--test"]) == 0
    assert re.search(r"\d{3} passed", capsys.readouterr().out)
    text = (out / "half_and_half.py").read_text(encoding="utf-8")
    assert text.startswith("# Made by: gainproof generate own_model.py --out DIR\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    kernels = importlib.import_module("own_kernels.half_and_half")
    alpha, beta = kernels.gains(1.0)
    assert 0 < alpha < 1
    assert 0 < beta < 2
    assert cli.main(["generate", str(file), "--out", str(out), "--check"]) == 0


def test_no_kernel_is_written_of_what_the_checker_rejects(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    rejected = {
        "accepted": False,
        "given_up": False,
        "reason": "form: not the stated combination",
    }
    file.write_text(EXPRESSIONS)
    monkeypatch.setattr(derivations, "recheck", lambda *_: [rejected])
    assert cli.main(["generate", str(file), "--out", str(tmp_path / "kernels")]) == 2
    assert "the checker rejects the derivation" in capsys.readouterr().err
    assert not (tmp_path / "kernels").exists()
