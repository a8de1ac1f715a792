"""What the paper's own numbers pin: verdicts that a reader would look up first."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

import gainproof.verify

CLAIMS = Path(gainproof.verify.__file__).parent / "claims"


@pytest.fixture(scope="module")
def verdicts() -> Mapping[str, Any]:
    text = (CLAIMS / "suzuki.verdicts.json").read_text(encoding="utf-8")
    return {claim["id"]: claim for claim in json.loads(text)["claims"]}


def test_every_number_of_the_paper_has_a_claim(verdicts: Mapping[str, Any]) -> None:
    letters = {"16": "abc", "17": "abcdefgh", "18": "abcd", "19": "abc"}
    numbers = [str(n) for n in range(1, 22) if str(n) not in letters or n == 18]
    numbers += [n + letter for n, found in letters.items() for letter in found]
    numbers += ["14a", "A1", "A2", "A3", "A3-P", "A4a", "A4b", "A5", "A6a", "A6b"]
    numbers += ["fig1-S", "fig1-r", "fig2-S", "fig2-r", "fig2", "fig3"]
    assert set(numbers) <= set(verdicts)


def test_nothing_is_left_open(verdicts: Mapping[str, Any]) -> None:
    assert not [
        n for n, c in verdicts.items() if c["verdict"] in ("held", "undecided", "undefined")
    ]


@pytest.mark.parametrize(
    ("name", "part"),
    [("15", r"\sigma_d T"), ("fig2-S", r"\sigma_d T"), ("fig1-r", r"\sigma_a T"), ("21", "- ")],
)
def test_slips_of_print_are_repaired(name: str, part: str, verdicts: Mapping[str, Any]) -> None:
    assert verdicts[name]["verdict"] == "refuted"
    assert part in verdicts[name]["repair"]["latex"]


def test_the_symbol_that_is_never_defined(verdicts: Mapping[str, Any]) -> None:
    found = {entry["symbol"]: entry for entry in verdicts["16a"]["undefined"]}
    assert found["B"]["solution"] == r"B = \frac{1}{3} A S^{2} - A + S^{4}"
    assert found["B"]["consumed"] == ["16b"]
    assert found["X"]["consumed"] == ["18d"]
