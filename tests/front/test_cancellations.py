"""`list --cancellations`: what docstrings say of subtractions, all of it and nothing else."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gainproof.generated
from gainproof import cancellations, cli

GENERATED = Path(gainproof.generated.__file__).parent


def test_every_cancellation_of_the_printed_files_is_listed() -> None:
    """Counted in the text of the files, without importing any."""
    for path in sorted(GENERATED.glob("[a-z]*.py")):
        text = " ".join(path.read_text("utf-8").split())
        named = [each for each in cancellations.left() if each.name.startswith(f"{path.stem}.")]
        assert text.count("Cancellation in ") == sum(len(each.differences) for each in named)
        assert text.count("over the sum of its terms taken positive") == sum(
            each.by_terms for each in named
        )


def test_every_output_over_something_larger_says_what_it_loses() -> None:
    """With the words of the docstrings; as many as there are such outputs in the files."""
    pattern = re.compile(r"Error over [\w ]+ at most")
    for path in sorted(GENERATED.glob("[a-z]*.py")):
        text = " ".join(path.read_text("utf-8").split())
        listed = [each for each in cancellations.left() if each.name.startswith(f"{path.stem}.")]
        losses = [loss for each in listed for loss in each.losses]
        assert len(losses) == len(pattern.findall(text)), path.stem
        assert all(f"Digits that can be lost: {said}." in text for _, said in losses)


def test_the_page(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["list", "--cancellations"]) == 0
    text = capsys.readouterr().out
    assert max(map(len, text.splitlines())) <= 92
    assert re.match(r"\d+ kernels\. \d+ subtract no computed values\.", text)
    assert "alpha_beta.lags\n  updated_velocity_lag_difference, condition number 1: " in text
    assert "random_acceleration.gains\n" not in text
    _, _, lost = text.partition("Digits that can be lost, proved for every input")
    assert "\nalpha_beta.lags\n  updated_velocity_lag: up to 16 of 16 in float64" in lost
