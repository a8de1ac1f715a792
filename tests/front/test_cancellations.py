"""`list --cancellations`: what docstrings say of subtractions, all of it and nothing else."""

from __future__ import annotations

import importlib
import pkgutil
import re
from pathlib import Path

import pytest

import gainproof.generated
from gainproof import cli
from gainproof.pages import cancellations

KNOWN = {"the", "sum", "of", "its", "terms", "sizes", "taken", "positive", "s"}
KNOWN |= {"sqrt", "exp", "expm1", "sin", "cos"}
GENERATED = Path(gainproof.generated.__file__).parent


def test_every_cancellation_of_the_printed_files_is_listed() -> None:
    """Counted in the text of the files, without importing any."""
    for path in sorted(GENERATED.glob("[a-z]*.py")):
        text = " ".join(path.read_text("utf-8").split())
        named = [each for each in cancellations.left() if each.name.startswith(f"{path.stem}.")]
        assert text.count("Cancellation, condition number ") == sum(
            len(each.differences) for each in named
        )
        assert text.count("over the sum of its terms taken positive") == sum(
            each.by_terms for each in named
        )


def test_every_output_over_something_larger_says_what_it_loses() -> None:
    """With the words of the docstrings; as many as there are such outputs in the files."""
    pattern = re.compile(r"Error over [\w' ]+ at most")
    for path in sorted(GENERATED.glob("[a-z]*.py")):
        text = " ".join(path.read_text("utf-8").split())
        listed = [each for each in cancellations.left() if each.name.startswith(f"{path.stem}.")]
        losses = [loss for each in listed for loss in each.losses]
        assert len(losses) == len(pattern.findall(text)), path.stem
        assert all(f"Digits that can be lost: {said}." in text for _, said in losses)


def test_the_page(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["list", "--cancellations"]) == 0
    text = capsys.readouterr().out
    # a product of long names is one word, and is not broken
    assert all(len(line) <= 92 or " " not in line.strip() for line in text.splitlines())
    assert re.match(r"\d+ kernels\. \d+ subtract no computed values\.", text)
    assert "alpha_beta.lags\n  updated_velocity_lag, condition number 1: " in text
    assert "random_acceleration.gains\n" not in text
    _, _, lost = text.partition("Digits that can be lost, proved for every input")
    assert "\nalpha_beta.lags\n  updated_velocity_lag: up to 16 of 16 in float64" in lost


def test_every_name_is_explained() -> None:
    """What is measured and what cancels is told in names that the docstring has besides."""
    told = re.compile(r"Error over (.*?) at most|what cancels: (.*?)\.(?= [a-z]\w*:|$)", re.DOTALL)
    count = 0
    for module in pkgutil.iter_modules(gainproof.generated.__path__):
        loaded = importlib.import_module(f"gainproof.generated.{module.name}")
        for name in getattr(loaded, "__all__", ()):
            text = " ".join((getattr(loaded, name).__doc__ or "").split())
            found = " ".join(a or b for a, b in told.findall(text))
            words = set(re.findall(r"[a-z]\w*", found))
            rest = set(re.findall(r"\w+", told.sub("", text)))
            assert words - rest - KNOWN == set(), f"{module.name}.{name}"
            count += bool(words)
    assert count > 50
