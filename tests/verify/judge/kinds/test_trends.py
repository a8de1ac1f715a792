"""Monotone claims: on intervals, with corners, from sample to sample."""

from __future__ import annotations

import pytest
from small_claims import check, judged


@pytest.mark.parametrize(
    ("subject", "variable", "trend", "domain", "wanted"),
    [
        (r"\frac{a}{2-a}", "a", "increasing", "0 < a < 1", "proved"),
        (r"\frac{a}{2-a}", "a", "decreasing", "0 < a < 1", "refuted"),
        ("x^3", "x", "increasing", "", "proved"),
        (r"\left|x - 1\right| + x", "x", "nondecreasing", "", "proved"),
        (r"\left|x - 1\right| + x", "x", "increasing", "", "conditional"),
        (r"\sqrt{x}", "x", "increasing", r"x \geq 0", "proved"),
        # it falls on both sides of zero and is greater on the right
        (r"\frac{1}{x}", "x", "decreasing", "", "conditional"),
        (r"\frac{1}{x}", "x", "decreasing", "x > 0", "proved"),
        ("x^2", "x", "increasing", "", "conditional"),
        (r"\frac{q}{q+r}", "q", "increasing", "q > 0, r > 0", "proved"),
        (r"\frac{q}{q+r}", "r", "increasing", "q > 0, r > 0", "refuted"),
        (r"\frac{n}{n+1}", "n", "increasing", r"n \geq 0", "proved"),
        (r"\frac{2n+1}{(n+1)(n+2)}", "n", "decreasing", r"n \geq 1", "proved"),
        (r"\frac{2n+1}{(n+1)(n+2)}", "n", "decreasing", r"n \geq 0", "conditional"),
        ("2", "x", "increasing", "", "refuted"),
        # flat where the other symbol is zero
        ("a x", "x", "increasing", r"a \geq 0", "conditional"),
        ("a x^3", "x", "increasing", "a > 0", "proved"),
        ("a x^3", "x", "increasing", r"a \geq 0", "undecided"),
        ("a x", "x", "nondecreasing", r"a \geq 0", "proved"),
        # it falls back at each of its poles, and rises between them
        (r"\tan\theta", r"\theta", "increasing", "", "conditional"),
        (r"\tan\theta", r"\theta", "decreasing", "", "refuted"),
        (r"\frac{1}{x}", "x", "decreasing", r"x \geq 0", "conditional"),
        (r"\frac{1}{x}", "x", "increasing", r"x \geq 0", "refuted"),
        (r"\frac{1}{x^2}", "x", "increasing", "", "undecided"),
        (r"\sqrt{x}", "x", "decreasing", "x > -1", "refuted"),
        (r"\ln x", "x", "increasing", "x > -1", "conditional"),
        (r"\ln x", "x", "decreasing", "x > -1", "refuted"),
        (r"\frac{1}{n - 3}", "n", "decreasing", r"n \geq 0", "undecided"),
        # constant where its derivative, as a formula, has no value
        (r"-\sqrt{(x - \left|x\right|)^2}", "x", "increasing", "", "undecided"),
        (r"\sqrt[3]{x}", "x", "increasing", "", "proved"),
        ("2", "x", "nondecreasing", "", "proved"),
        ("e^{-a x}", "x", "decreasing", "a > 0", "proved"),
    ],
)
def test_trend(subject: str, variable: str, trend: str, domain: str, wanted: str) -> None:
    fields = f"about = ['{subject}', '{variable}']\ntrend = '{trend}'\ntext = 'in words'"
    check(judged("monotone", fields + (f"\ndomain = '{domain}'" if domain else "")), wanted)


def test_a_domain_in_two_pieces_is_no_interval() -> None:
    fields = "about = ['\\frac{1}{x}', 'x']\ntrend = 'decreasing'\ntext = 't'\ndomain = 'x^2 > 1'"
    assert judged("monotone", fields).verdict == "undecided"


def test_a_formula_of_the_claim_is_claimed_and_not_supposed() -> None:
    fields = "about = ['x', 'y']\ntrend = 'increasing'\nlatex = 'x = y'"
    assert judged("monotone", fields).verdict == "refuted"
