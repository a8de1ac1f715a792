"""`generate` says which digits can be lost, and writes nothing where half of them can, unasked."""

from __future__ import annotations

from pathlib import Path

import pytest

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
# over that is above 2^-26.5: x^2 below 4 * 5.01 * 2^-25.5
END = (4 * 5.01 * 2.0**-25.5) ** 0.5


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "rests.py"
    path.write_text(TEXT.replace("LOWER", "1e-6"), encoding="utf-8")
    return path


def test_nothing_is_written_where_half_is_lost(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "kernels"
    assert cli.main(["generate", str(file), "--out", str(out)]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert not out.exists()
    assert "rest, rest: Digits that can be lost: up to 14 of 16 in float64, half or more" in said
    assert "what cancels: -1 + exp(-x) + x." in said
    assert "--allow-loss writes" in said
    shown = float(said.partition("x <= ")[2].partition(";")[0])
    assert END <= shown <= 1.3 * END
    assert cli.main(["generate", str(file), "--out", str(out), "--allow-loss"]) == 0
    sentence = said[said.index("Digits that") : said.index(" nothing is written")]
    for name in ("rests.py", "rests.md"):
        assert sentence in " ".join((out / name).read_text("utf-8").split())
    assert cli.main(["generate", str(file), "--out", str(out), "--check"]) == 0
    assert "--allow-loss" in (out / "README.md").read_text("utf-8")


def test_less_than_half_is_said_and_written(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file.write_text(TEXT.replace("LOWER", "1"), encoding="utf-8")
    assert cli.main(["generate", str(file), "--out", str(tmp_path / "kernels")]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "Digits that can be lost: up to 3 of 16 in float64; up to 2 of 7 in float32" in said
    assert "written to" in said
