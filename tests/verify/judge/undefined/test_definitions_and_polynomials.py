"""Undefined symbols that stand in definitions alone, and solutions that are polynomials."""

from __future__ import annotations

from claim_texts import algebra, judged

NUMBERS = r"""
'a' = { unit = "1", domain = 'a > 0', meaning = "number" }
's' = { unit = "1", domain = 's > 0', meaning = "number" }
'f' = { definition = 'B s^2 + a', meaning = "short for something with B" }
'g' = { definition = '\frac{f}{a}', meaning = "short for something with f" }
'h' = { definition = '\frac{s^6 - a s^2}{a} + 1', meaning = "a number" }
'B' = { undefined = true, unit = "1", meaning = "never said" }
"""


def test_a_symbol_behind_two_definitions_is_solved_for() -> None:
    first, second, third, fourth = judged(
        algebra(NUMBERS),
        ("identity", "g = h"),
        ("identity", "B + a = s^4"),
        ("identity", "B = s^4 + a"),
        ("inequality", "B < s^4"),
    )
    assert first.undefined[0]["solution"] == "B = -a + s^{4}"
    assert {first.verdict, second.verdict} == {"definition", "proved"}
    assert (third.verdict, fourth.verdict) == ("refuted", "proved")
    used_up = first if first.verdict == "definition" else second
    assert "the only solution" in used_up.reason


def test_a_solution_that_is_no_polynomial_stays_as_it_is() -> None:
    first, second = judged(
        algebra(NUMBERS), ("identity", r"f = \sqrt{s}"), ("identity", r"B s^2 = \sqrt{s} - a")
    )
    assert {first.verdict, second.verdict} == {"definition", "proved"}
    assert r"\sqrt" in first.undefined[0]["solution"] or "frac" in first.undefined[0]["solution"]


def test_a_symbol_that_occurs_twice_is_not_taken_for_found() -> None:
    verdicts = judged(algebra(NUMBERS), ("identity", "f B = s"), ("inequality", "B > 0"))
    assert all(v.verdict != "definition" for v in verdicts)
