"""A claim about stability that lacks a bound of another gain gets it, if the bound is exact."""

from __future__ import annotations

import pytest
from claim_texts import HEAD

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.verdict import ClaimVerdict

SETTING = r"""
[settings.s]
title = "s"
kind = "fixed_gain"
states = 2
[settings.s.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain" }
'\beta' = { quantity = "filter_gain.2", meaning = "gain" }
"""
RA = r"\left( \alpha + \frac{\beta}{2} \right)^2 = 2\beta"


def stability(latex: str, given: str, sense: str) -> ClaimVerdict:
    claim = f"""
[[claims]]
id = "1"
place = "here"
kind = "stability"
setting = "s"
latex = '{latex}'
given = ['{given}']
sense = "{sense}"
"""
    (found,) = judge_file(read_claim_text(HEAD + SETTING + claim), ())
    return found


@pytest.mark.parametrize("latex", [r"0 < \alpha < 1", r"\alpha > 0"])
def test_the_bound_that_makes_it_exact(latex: str) -> None:
    found = stability(latex, RA, "sufficient")
    assert found.verdict == "conditional"
    assert found.repair is not None
    wanted = rf"{latex} \quad \left( \beta < 2 \right)"
    assert found.repair == {"latex": wanted, "verdict": "proved"}
    assert found.repairs[0]["changes"] == ["a condition is missing"]


def test_a_bound_that_was_not_tried_is_not_offered() -> None:
    found = stability(r"\alpha > 0", RA.replace(r"= 2\beta", r"= 3\beta"), "sufficient")
    assert found.verdict == "conditional"
    assert found.repair is None
    assert "< 4/3" in (found.domain or "")


def test_what_is_proved_needs_none() -> None:
    found = stability(r"0 < \alpha < 1", RA.replace(r"= 2\beta", r"= \beta"), "sufficient")
    assert found.verdict == "proved"
    assert found.repair is None
