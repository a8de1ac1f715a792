"""Logarithms of products of positive factors, and angles that are an arc tangent."""

from __future__ import annotations

import pytest
from small_claims import check, judged


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\log(a b) = \log a + \log b", "proved"),
        (r"\log\frac{a^x}{\sqrt{b}} = x \log a - \frac{1}{2} \log b", "proved"),
        (r"\log(a e^x) = x + \log a", "proved"),
        (r"\log\frac{1 + a}{1 + b} = \log(1 + a) - \log(1 + b)", "proved"),
        (r"\log 72 = 3 \log 2 + 2 \log 3", "proved"),
        (r"\log 1 = 0", "proved"),
        (r"\sin(\arctan x) = \frac{x}{\sqrt{1 + x^2}}", "proved"),
        (r"\cos(\arctan x) = \frac{1}{\sqrt{1 + x^2}}", "proved"),
        (r"\tan(\arctan x) = x", "proved"),
        (r"\log(a + b) = \log a + \log b", "refuted"),
        (r"\log(a^x) = x \log b", "refuted"),
        (r"\log\sqrt{a} = 2 \log a", "refuted"),
        (r"\log 9 = 3 \log 2", "refuted"),
        (r"\cos(\arctan x) = \frac{x}{\sqrt{1 + x^2}}", "refuted"),
        (r"\sin(\arctan x) = -\frac{x}{\sqrt{1 + x^2}}", "refuted"),
        (r"\arctan(\tan x) = x", "refuted"),
    ],
)
def test_of_positive_numbers(latex: str, verdict: str) -> None:
    found = judged("identity", f"latex = '{latex}'\ndomain = 'a > 0, b > 0'")
    assert found.verdict == verdict, found.reason


@pytest.mark.parametrize(
    ("latex", "where"),
    [
        (r"\log(x y) = \log x + \log y", "x > 0, y > 0, where every part has a value"),
        (r"\log(x^2) = 2 \log x", "x > 0, where every part has a value"),
        (r"\log\frac{x}{y} = \log x - \log y", "x > 0, y > 0, where every part has a value"),
    ],
)
def test_what_may_have_no_value_is_split_where_it_has(latex: str, where: str) -> None:
    """Of factors that may be negative or 0: one side has a value where the other has none. Nothing
    was stated of x and y.
    """
    found = judged("identity", f"latex = '{latex}'\ndomain = 'a > 0'")
    check(found, "proved")
    assert found.domain == where


@pytest.mark.parametrize("latex", [r"\log(x - x) = 0", r"\log(x y) = \log(-x) + \log(-y) + 1"])
def test_what_has_no_value_or_another_is_not_split(latex: str) -> None:
    assert judged("identity", f"latex = '{latex}'\ndomain = 'a > 0'").verdict != "proved"


@pytest.mark.parametrize(
    "latex",
    [r"\log 0 = 0", r"\log(0 a) = \log a", r"\log(-1) + \log(-1) = 0", r"\log(-a) = \log a"],
)
def test_what_has_no_value_on_a_stated_domain_is_refuted(latex: str) -> None:
    found = judged("identity", f"latex = '{latex}'\ndomain = 'a > 0'")
    check(found, "refuted")
    assert "no value" in found.reason


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\ln(x y) \leq \ln(x (y + 1))", "x > 0, y > 0"),
        (r"10 \lg(1 + x y) \leq 10 \lg(1 + x y^2)", "x > 0, y > 1"),
        (r"-\ln x > -\ln(x + y^2)", "x > 0, y > 0"),
        (r"\frac{\ln(x + y)}{2} \geq \frac12 \ln\sqrt{x y}", "x > 1, y > 1"),
    ],
)
def test_of_two_logarithms_that_of_the_larger_is_larger(latex: str, domain: str) -> None:
    check(judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'"), "proved")


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        # x and y may both be negative, where both sides have a value
        (r"\ln((y + 3) x) \leq \ln(x (4 + y))", None),
        (r"\ln(x y) \leq \ln(x (y + 1))", None),
        (r"-\ln x > -\ln(x - y^2)", "x > 2, -1 < y < 1"),
        (r"2 \ln(x + y) \leq \ln(x + y + 1)", "x > 0, y > 0"),
        (r"\ln(x - y) \leq \ln(x + y)", "x > 0, -1 < y < 1"),
    ],
)
def test_what_is_false_of_two_logarithms(latex: str, domain: str | None) -> None:
    stated = f"\ndomain = '{domain}'" if domain else ""
    check(judged("inequality", f"latex = '{latex}'{stated}"), "refuted")


@pytest.mark.parametrize(
    "latex",
    [
        r"\ln((7 x - 5)^2) < \ln(1 + (7 x - 5)^2)",
        r"\ln(1 + (7 x - 5)^2) > \ln((7 x - 5)^2)",
        r"\ln(1 + (7 x - 5)^2) > \ln(-(7 x - 5)^2 + 1/1000000)",
    ],
)
def test_a_logarithm_without_a_value_at_a_point_that_is_not_tried_is_not_larger(latex: str) -> None:
    assert judged("inequality", f"latex = '{latex}'\ndomain = '0 < x < 1'").verdict != "proved"
