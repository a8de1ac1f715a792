"""The page of one claim: everything once, nothing too wide."""

from __future__ import annotations

from typing import Any

import pytest

from gainproof.verdicts.explanation import explanation
from gainproof.verify.judge.verdict_words import Shown

WITNESS = {
    "point": {"r": "1"},
    "left": {"midpoint": "0.5", "radius": "0"},
    "operator": "=",
    "right": {"midpoint": "4.383960761730", "radius": "2e-12"},
    "exact": False,
    "values": {r"\beta": {"midpoint": "0.5", "radius": "0"}},
}


def claim(**fields: Any) -> dict[str, Any]:
    evidence = {
        "method": "towers",
        "certificate": fields.pop("certificate", None),
        "witness": fields.pop("witness", None),
    }
    return {
        "id": "7",
        "place": "slide 3",
        "kind": "identity",
        "latex": r"\beta = \alpha",
        "verdict": "refuted",
        "domain": "nowhere",
        "evidence": evidence,
        "repair": None,
        "convention": None,
        "reading": None,
        "undefined": [],
        "reason": "fails at r = 1",
        "seconds": 0.01,
    } | fields


def test_a_counterexample_is_shown_in_full_and_once() -> None:
    text = explanation(claim(witness=WITNESS))
    assert "  right side: 4.383960761730 +/- 2e-12\n" in text
    assert "  with \\beta = 0.5\n" in text
    assert "result:" not in text
    assert "nowhere" not in text


def test_against_a_trend_stand_the_derivative_and_what_is_asked_of_it() -> None:
    witness = {**WITNESS, "operator": "<=", "right": {"midpoint": "0", "radius": "0"}}
    witness["shows"] = Shown.SLOPE
    trend = claim(witness=witness, kind="monotone", latex="")
    text = explanation(trend)
    assert "  derivative: 0.5\n  claimed: at most 0\n" in text
    assert "side" not in text


def test_other_conventions_have_a_line_each_and_the_one_shown_none() -> None:
    others = {"noise A": WITNESS, "noise B": {**WITNESS, "point": {"r": "2"}}, "noise C": "why"}
    text = explanation(claim(witness=WITNESS, certificate={"against other conventions": others}))
    assert "noise A" not in text
    assert "  noise B: at r = 2 the left side is 0.5, the right 4.38396\n" in text
    assert "  noise C: why\n" in text


def test_repairs_with_their_changes() -> None:
    first = {"latex": "a = b", "verdict": "proved", "changes": ["sign of a term"], "under": "A"}
    other = {"latex": "c = d", "verdict": "proved", "changes": ["a symbol"], "under": ""}
    text = explanation(claim(repair=first, repairs=[first, other]))
    assert (
        "  a = b\n    sign of a term\n    proved under A\n  c = d\n    a symbol\n    proved\n"
        in text
    )


def test_a_reason_without_a_witness_is_the_result() -> None:
    assert "result:     too many roots\n" in explanation(
        claim(verdict="undecided", reason="too many roots")
    )


@pytest.mark.parametrize("columns", [60, 92, 120])
def test_lines_fit(columns: int) -> None:
    certificate = {"established": ["fact " * 40]}
    text = explanation(
        claim(latex="a + " * 60, reason="word " * 60, certificate=certificate), columns
    )
    assert max(map(len, text.splitlines())) <= columns
