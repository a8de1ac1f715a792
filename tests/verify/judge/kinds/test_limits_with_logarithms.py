"""Limits in which logarithms and arc tangents grow."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from samples import samples
from small_claims import check, judged

QUARTER = r"\frac{\pi}{2}"


def limit(arrow: str, latex: str, claimed: str, domain: str = "x > 0") -> str:
    return f"latex = '\\lim_{{x \\to {arrow}}} ({latex}) = {claimed}'\ndomain = '{domain}, a > 0'"


TRUE = [
    (r"\infty", r"\arctan x", QUARTER),
    ("0", r"\arctan\frac{\ln x}{x}", "-" + QUARTER),
    (r"\infty", rf"x ({QUARTER} - \arctan x)", "1"),
    ("1", r"\arctan x", r"\frac{\pi}{4}"),
    ("a", r"\arctan x", r"\arctan a"),
    ("0", r"\frac{\arctan(a + x) - \arctan a}{x}", r"\frac{1}{1 + a^2}"),
    ("0", r"\frac{x - \arctan x}{x^3}", r"\frac{1}{3}"),
    ("0", r"\frac{\arctan x - x + x^3/3}{x^5}", r"\frac{1}{5}"),
    ("0", r"x \ln x", "0"),
    ("0", r"\log_{10} x", r"-\infty"),
    (r"\infty", r"\frac{\ln x}{x^{1/10}}", "0"),
    (r"\infty", r"\frac{\ln(a x^2)}{\ln x}", "2"),
    (r"\infty", r"x - \ln x", r"\infty"),
    (r"\infty", r"x (\ln(x + 1) - \ln x)", "1"),
    (r"\infty", r"x^{1/x}", "1"),
    ("0", r"x^x", "1"),
    ("0", r"\frac{e^{x \ln x} - 1}{x \ln x}", "1"),
    ("0", r"e^{-2 \ln x}", r"\infty"),
    ("0", r"\frac{1}{\ln x}", "0"),
    ("0", r"(\ln x)^3 + (\ln x)^2", r"-\infty"),
    ("0", r"\ln(2 x) \ln x - (\ln x)^2", r"-\infty"),
    ("0", r"\sqrt{x^2 (\ln x)^2}", "0"),
    ("0", r"\ln(a x) - \ln x", r"\ln a"),
    ("0", r"(\sin^2 a + \cos^2 a - 1) \ln x + \frac{1}{\ln x} + 3", "3"),
    ("0", r"x \sin(\ln x)", "0"),
    ("0", r"x \ln(-\ln x)", "0"),
]


@pytest.mark.parametrize(("arrow", "latex", "claimed"), TRUE)
def test_what_is_true_is_proved(arrow: str, latex: str, claimed: str) -> None:
    check(judged("limit", limit(arrow, latex, claimed)), "proved")


@pytest.mark.parametrize(("arrow", "latex", "claimed"), TRUE)
def test_another_value_is_refuted(arrow: str, latex: str, claimed: str) -> None:
    other = "5" if "infty" in claimed else f"{claimed} + 1"
    check(judged("limit", limit(arrow, latex, other)), "refuted")


@pytest.mark.parametrize(
    ("arrow", "latex", "claimed"),
    [
        ("0", r"\sin(\ln x)", "0"),
        ("0", r"\sqrt{(\ln x)^2}", r"-\infty"),
        ("0", r"\frac{\sqrt{(\ln x)^2}}{\ln x}", "1"),
        (r"\infty", r"\ln(\ln x)", "0"),
        ("0", r"(a - 1) \ln x", r"-\infty"),
        ("0", r"\ln(-x)", r"-\infty"),
    ],
)
def test_what_is_not_so_is_not_proved(arrow: str, latex: str, claimed: str) -> None:
    assert judged("limit", limit(arrow, latex, claimed)).verdict != "proved"


@pytest.mark.parametrize(
    ("arrow", "latex", "claimed"),
    [
        ("0", r"\sqrt{(\ln x)^2}", r"\infty"),
        ("0", r"\frac{\sqrt{(\ln x)^2}}{\ln x}", "-1"),
        ("0", r"\frac{\ln x}{\ln(2 x)}", "1"),
        ("0", r"\arctan(\ln x)", "-" + QUARTER),
        (r"\infty", r"\ln(\ln x)", r"\infty"),
    ],
)
def test_what_is_true_is_not_refuted(arrow: str, latex: str, claimed: str) -> None:
    assert judged("limit", limit(arrow, latex, claimed, "x > 1/8")).verdict != "refuted"
    assert judged("limit", limit(arrow, latex, claimed)).verdict != "refuted"


@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(samples(10)))
def test_the_largest_of_two_terms_decides(seed: int) -> None:
    """c x^p (ln x)^q + d x^r (ln x)^s as x -> 0: the smaller power of x, then the larger of the
    logarithm is the larger term.
    """
    generator = random.Random(seed)

    def term() -> tuple[Fraction, int, int]:
        power = Fraction(generator.randint(-2, 2), generator.choice([1, 2]))
        return power, generator.randint(-2, 2), generator.choice([-3, -1, 1, 2])

    (p, q, c), (r, s, d) = one, other = term(), term()
    if (p, q) == (r, s):
        c, one, other = c + d, (p, q, c + d), (Fraction(9), 0, 1)
        r, s, d = other
    power, times, factor = min((one, other), key=lambda t: (t[0], -t[1]))
    grows = power < 0 or (power == 0 and times > 0)
    if not factor:
        claimed = "0"
    elif grows:
        claimed = r"\infty" if (factor > 0) == (times % 2 == 0) else r"-\infty"
    else:
        claimed = str(factor) if power == times == 0 else "0"
    latex = rf"{c} \cdot x^{{{p}}} (\ln x)^{{{q}}} + ({d}) x^{{{r}}} (\ln x)^{{{s}}}"
    domain = "0 < x < 1/2"
    check(judged("limit", limit("0", latex, claimed, domain)), "proved")
    wrong = "7" if claimed != "7" else "8"
    check(judged("limit", limit("0", latex, wrong, domain)), "refuted")
