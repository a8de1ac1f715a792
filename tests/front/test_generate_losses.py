"""`generate` says which digits can be lost, and writes nothing where half of them can, unasked."""

from __future__ import annotations

import re
from pathlib import Path

import mpmath
import pytest
from one_of_each import cases

from gainproof import cli

TEXT = """
import sympy as sp
from gainproof.derive.own_expressions.expressions import (
    Argument, ExpressionKernel, ExpressionSet, Result,
)
from gainproof.derive.quantity import ONE, Quantity

X = Quantity("x", "x", "a number", ONE)
Y = Quantity("rest", "y", "the rest", ONE)
x = X.symbol
EXPRESSIONS = ExpressionSet(
    name="rests",
    title="Rests",
    kernels=(
        ExpressionKernel(
            name="rest",
            title="rest of an exponential",
            inputs=(Argument(X, "LOWER", "3"),),
            outputs=(Result(Y, x + sp.exp(-x) - 1),),
        ),
    ),
)
"""
# x + e^-x - 1 is x^2/2 or so, its terms add up to 2 + x or so; half is lost where 5.01 eps of these
# over that is above 10^7.9 u, which is told as 8 digits: x^2 below 4 * 5.01 * 2/10^7.9 * 10^7.9 u
END = (4 * 5.01 * 2 * 10.0**-7.9) ** 0.5


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "rests.py"
    path.write_text(TEXT.replace("LOWER", "1e-6"), encoding="utf-8")
    return path


def true_loss(place: str) -> float:
    """Digits of x + e^-x - 1: the error may be 5.01 * 2 u of the terms."""
    with mpmath.workdps(40):
        x = mpmath.mpf(place)
        terms, value = x + mpmath.exp(-x) + 1, x + mpmath.exp(-x) - 1
        return float(mpmath.log10(5.01 * 2 * terms / value))


def test_nothing_is_written_where_half_is_lost(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "kernels"
    assert cli.main(["generate", str(file), "--out", str(out)]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert not out.exists()
    assert re.search(
        r"rest, rest: Digits .* up to 13\.\d of 16 in float64, half or more only", said
    )
    assert "what cancels: -1 + exp(-x) + x." in said
    assert "for rest, rest where x <= 0.0007" in said
    assert 'docs/stable-forms.md, "What you can do"' in said
    assert "--allow-loss, which writes" in said
    shown = float(said.partition("x <= ")[2].partition(";")[0])
    assert END <= shown <= 1.3 * END
    assert cli.main(["generate", str(file), "--out", str(out), "--allow-loss"]) == 0
    sentence = said[said.index("Digits that") : said.index(" nothing is written")]
    for name in ("rests.py", "rests.md"):
        assert sentence in " ".join((out / name).read_text("utf-8").split())
    assert "Where nothing is lost" not in (out / "rests.md").read_text("utf-8")
    assert cli.main(["generate", str(file), "--out", str(out), "--check"]) == 0
    assert "--allow-loss" in (out / "README.md").read_text("utf-8")


def test_less_than_half_is_said_and_written(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file.write_text(TEXT.replace("LOWER", "1"), encoding="utf-8")
    assert cli.main(["generate", str(file), "--out", str(tmp_path / "kernels")]) == 0
    said = " ".join(capsys.readouterr().out.split())
    numbers = re.findall(r"up to ([\d.]+) of (?:16|7) in float(?:64|32)[;.]", said)
    # x - 1 is exact there: nothing cancels, the error is 4 units of exp and a rounding
    assert all(0.9 <= float(n) < half for n, half in zip(numbers, (8, 3.5), strict=True))
    assert "written to" in said


LOWER = ["0.18", "0.19", "0.2", "0.21", "0.22", "0.24"]


@pytest.mark.parametrize("lower", cases(LOWER, lambda lower: lower == "0.19"))
def test_what_is_shown_decides(
    lower: str, file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Half of float32's digits go near x = 0.2: none of them is allowed, and less is shown else."""
    file.write_text(TEXT.replace("LOWER", lower), encoding="utf-8")
    status = cli.main(["generate", str(file), "--out", str(tmp_path / "kernels")])
    said = " ".join(capsys.readouterr().out.split())
    (shown,) = re.findall(r"up to ([\d.]+) of 7 in float32", said)
    assert status == int(float(shown) >= 3.5)
    assert ("half or more only where" in said) == bool(status)
    assert true_loss(lower) <= float(shown) <= true_loss(lower) + 0.5


def test_by_terms_of_a_result_is_enough_to_write_it(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its author knows; what can be lost is said all the same."""
    text = file.read_text("utf-8").replace("exp(-x) - 1)", "exp(-x) - 1, by_terms=True)")
    file.write_text(text, encoding="utf-8")
    assert cli.main(["generate", str(file), "--out", str(tmp_path / "kernels")]) == 0
    said = capsys.readouterr().out
    assert "Digits that can be lost: up to" in said
    assert "written" in said


@pytest.mark.thorough  # the page itself is run: `test_pages.py`
def test_what_the_page_says_can_be_done_is_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The part that the message names left out, and the page's series, which goes on below it."""
    text = (Path(__file__).parents[2] / "docs" / "stable-forms.md").read_text("utf-8")
    (code,) = re.findall(r"```python\n(# remainder\.py.*?)```", text, re.DOTALL)
    (shown,) = re.findall(r"generate remainder\.py --out kernels\n(.*?)27 of 27", text, re.DOTALL)
    file = tmp_path / "remainder.py"
    file.write_text(code, encoding="utf-8")
    assert cli.main(["generate", str(file), "--out", str(tmp_path / "kernels")]) == 0
    assert capsys.readouterr().out.startswith(shown)
