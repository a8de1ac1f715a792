"""The table of verdicts: places once, formula and why beside each claim, nothing too wide."""

from __future__ import annotations

from typing import Any

import pytest

from gainproof.claims.source_words import claim_words
from gainproof.terminal_text import filled, width
from gainproof.verdicts import verdict_text

WITNESS = {
    "point": {"r": "1"},
    "left": {"midpoint": "0.500000000", "radius": "0"},
    "operator": "=",
    "right": {"midpoint": "4.383960761730", "radius": "2e-12"},
    "exact": False,
}


def claim(name: str, verdict: str, **fields: Any) -> dict[str, Any]:
    witness = fields.pop("witness", None)
    certificate = fields.pop("certificate", None)
    return {
        "id": name,
        "place": "slide 3",
        "kind": "identity",
        "latex": r"\beta = \alpha",
        "verdict": verdict,
        "domain": None,
        "evidence": {"method": "towers", "certificate": certificate, "witness": witness},
        "repair": None,
        "convention": None,
        "reading": None,
        "undefined": [],
        "reason": "",
        "seconds": 0.01,
    } | fields


def table(*claims: dict[str, Any], columns: int = 92) -> str:
    source = {"key": "lecture", "title": "Tracking"}
    return verdict_text.overview({"source": source, "claims": list(claims)}, columns)


def test_a_proved_claim_needs_one_line() -> None:
    text = table(claim("a", "proved", reason="holds on the whole domain"))
    assert "  slide 3\n    a  proved  \\beta = \\alpha\n\n  1 claim: 1 proved\n" in text


def test_a_place_is_said_once_for_the_claims_that_stand_there() -> None:
    text = table(claim("a", "proved"), claim("b", "proved"), claim("c", "proved", place="slide 4"))
    assert text.count("slide 3") == 1
    assert text.index("slide 3") < text.index(" b ") < text.index("slide 4")


def test_a_refuted_claim_shows_its_witness_and_repair() -> None:
    repair = {"latex": r"\beta = 2", "verdict": "proved"}
    text = table(claim("b", "refuted", witness=WITNESS, repair=repair, reason="not shown"))
    assert "at r = 1 the left side is 0.5, the right 4.38396" in text
    assert r"nearest true formula: \beta = 2 (proved)" in text
    assert "not shown" not in text


def test_of_several_conventions_one_is_named() -> None:
    other = {**WITNESS, "point": {"r": "2"}}
    certificate = {"against other conventions": {"noise A": other, "noise B": WITNESS}}
    text = table(claim("b", "refuted", witness=WITNESS, certificate=certificate))
    assert "fits none of 2 conventions; with noise B, at r = 1 the" in text


def test_a_claim_in_words_shows_them() -> None:
    source = {"key": "lecture", "title": "Tracking"}
    judged = {"source": source, "claims": [claim("a", "proved", latex="")]}
    text = verdict_text.overview(judged, words={"a": "the gain grows with the index"})
    assert "    a  proved  the gain grows with the index\n" in text


def test_words_of_claims_without_a_formula() -> None:
    entries = {
        "1": "kind = 'remark'\ntext = 'one\\ntwo'",
        "2": "kind = 'monotone'\nabout = ['a', 'r']\ntrend = 'increasing'",
        "3": "kind = 'location'\npolynomial = 'z^2 - a'\nvariable = 'z'\nwhere = 'real'",
        "4": "kind = 'identity'\nlatex = 'a = b'\ntext = 'not shown'",
        "5": "kind = 'identity'\nplain = 'a = b'",
    }
    text = "[settings.s]\nkind = 'algebra'\n"
    text += "".join(f"[[claims]]\nid = '{name}'\n{rest}\n" for name, rest in entries.items())
    assert claim_words(text) == {
        "1": "one\\ntwo",
        "2": "a is increasing in r",
        "3": "roots of z^2 - a in z: real",
    }


def test_conventions_filled_in_are_listed_once() -> None:
    text = table(*(claim(name, "proved", convention="filter gain") for name in "abc"))
    assert text.count("filter gain") == 1
    assert "    filter gain: a, b, c\n" in text


@pytest.mark.parametrize("verdict", ["held", "undecided", "refuted", "remark"])
def test_reasons_without_a_witness_are_said(verdict: str) -> None:
    assert "too many roots" in table(claim("a", verdict, reason="too many roots"))


def test_a_condition_and_a_solution_are_said() -> None:
    conditional = claim("a", "conditional", domain="for r > 1", witness=WITNESS)
    solved = claim(
        "b", "undefined", undefined=[{"symbol": "c", "solution": "c = 2", "consumed": ["a"]}]
    )
    text = table(conditional, solved)
    assert "true on a part only (for r > 1)" in text
    assert "c = 2, fixed by a" in text


def test_a_solution_that_nothing_bears_out_is_told_by_the_reason() -> None:
    reason = "c is never defined: solving b gives c = 2, but no other claim uses c"
    open_symbol = [{"symbol": "c", "solution": "c = 2", "consumed": []}]
    text = table(claim("b", "undefined", reason=reason, undefined=open_symbol))
    assert reason in " ".join(text.split())
    assert "fixed by" not in text


@pytest.mark.parametrize("columns", [60, 80, 120])
def test_lines_fit(columns: int) -> None:
    long = " + ".join([r"\alpha \beta"] * 40)
    text = table(claim("a" * 20, "refuted", latex=long, reason="word " * 50), columns=columns)
    assert max(map(len, text.splitlines())) <= columns


def test_files_have_a_fixed_width(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    assert width() == 92
    assert max(map(len, filled("word " * 100))) <= 92
