"""Symbols that a source never defines are solved for from its own claims."""

from __future__ import annotations

import pytest
from claim_texts import algebra, judged, memory, steady

LAMBDA = "[settings.s.symbols]\n'\\lambda' = { undefined = true, meaning = 'never said' }\n"
RV = steady("random-velocity", more=LAMBDA)


def test_one_claim_is_used_up_and_the_rest_are_judged() -> None:
    first, second, third = judged(
        RV,
        ("identity", r"\lambda \alpha = \beta"),
        ("identity", r"\lambda (2 - \alpha) = \alpha"),
        ("inequality", r"\lambda < 1"),
    )
    assert first.verdict == "definition"
    assert first.undefined[0]["solution"] == r"\lambda = \frac{\beta}{\alpha}"
    for verdict in (second, third):
        assert verdict.verdict == "proved", verdict.reason
        assert verdict.undefined == (
            {
                "symbol": r"\lambda",
                "solution": r"\lambda = \frac{\beta}{\alpha}",
                "consumed": ["c0"],
            },
        )


def test_a_claim_that_no_other_bears_out_is_no_definition() -> None:
    (only,) = judged(RV, ("identity", r"\lambda \alpha = \beta"))
    assert only.verdict == "undefined"
    assert only.undefined[0]["solution"] == r"\lambda = \frac{\beta}{\alpha}"
    assert only.undefined[0]["consumed"] == []
    assert "no other claim uses" in only.reason


def test_claims_that_contradict_one_another_fix_nothing() -> None:
    verdicts = judged(
        RV, ("identity", r"\lambda = \frac{\beta}{\alpha}"), ("identity", r"\lambda = 3 \alpha")
    )
    assert [v.verdict for v in verdicts] == ["undefined", "undefined"]
    assert all(v.undefined[0]["consumed"] == [] for v in verdicts)


def test_the_claim_that_most_others_bear_out_is_taken() -> None:
    # the first claim is wrong for every value that suits the others
    wrong, *rest = judged(
        RV,
        ("identity", r"\lambda = 3 \alpha"),
        ("identity", r"\lambda \alpha = \beta"),
        ("identity", r"\lambda (2 - \alpha) = \alpha"),
        ("identity", r"\lambda \alpha (2 - \alpha) = \alpha^2"),
    )
    assert wrong.verdict == "refuted"
    assert sorted(v.verdict for v in rest) == ["definition", "proved", "proved"]


@pytest.mark.parametrize(
    ("first", "second", "solution"),
    [
        (r"\frac{6}{\lambda} = \beta", r"\lambda = (k+1)(k+2)", r"\lambda = \frac{6}{\beta}"),
        (r"\sqrt{\lambda} = k + 1", r"\lambda = k^2 + 2k + 1", None),
        (r"\lambda + k \lambda = 6", r"\lambda = \frac{6}{k+1}", None),
        (r"\lambda^3 = (k+1)^3", r"\lambda - k = 1", None),
    ],
)
def test_many_ways_to_solve(first: str, second: str, solution: str | None) -> None:
    verdicts = judged(memory(1, more=LAMBDA), ("identity", first), ("identity", second))
    assert sorted(v.verdict for v in verdicts) == ["definition", "proved"], verdicts[0].reason
    if solution is not None:
        assert verdicts[1].undefined[0]["solution"] in (solution, second.replace("(k+1)(k+2)", ""))


def test_two_roots_do_not_fix_a_symbol() -> None:
    symbols = algebra(
        "'x' = { unit = '1', domain = 'x > 0', meaning = 'a number' }\n"
        "'u' = { undefined = true, meaning = 'never said' }\n"
    )
    verdicts = judged(symbols, ("identity", "u^2 = x^2"), ("identity", "u^4 = x^4"))
    assert [v.verdict for v in verdicts] == ["undefined", "undefined"]
    assert "not shown to be the only solution" in verdicts[0].reason


def test_settings_without_such_symbols_are_left_alone() -> None:
    (verdict,) = judged(RV, ("identity", r"\alpha(\alpha + \beta) = 2\beta"))
    assert verdict.verdict == "proved"
    assert verdict.undefined == ()


def test_where_the_coefficient_vanishes_a_symbol_is_not_fixed() -> None:
    symbols = algebra(
        "'x' = { unit = '1', domain = 'x > 0', meaning = 'a number' }\n"
        "'u' = { undefined = true, meaning = 'never said' }\n"
    )
    # at x = 1 the first claim holds for every u
    verdicts = judged(symbols, ("identity", "u (x - 1) = x^2 - 1"), ("identity", "u (x-1)^2 = x"))
    assert [v.verdict for v in verdicts] == ["undefined", "undefined"]


def test_a_symbol_is_fixed_only_where_the_claim_is_made() -> None:
    narrow, wide = (
        ("identity", r"\lambda = k + 1 \quad (3 \le k)"),
        ("identity", r"\lambda^2 = k \lambda + \lambda"),
    )
    later = ("identity", r"\lambda - 1 = k \quad (3 \le k)")
    verdicts = judged(memory(1, more=LAMBDA), narrow, wide)
    assert [v.verdict for v in verdicts] == ["undefined", "undefined"]
    verdicts = judged(memory(1, more=LAMBDA), narrow, later)
    assert sorted(v.verdict for v in verdicts) == ["definition", "proved"]
