"""False claims that once came out as proved because of points without a value, or where a trend is
flat; beside them the true ones that must stay proved.
"""

from __future__ import annotations

import pytest
from small_claims import judged

TRENDS = [
    # poles between which it rises
    (r"\tan x", "x", "increasing", ""),
    (r"\frac{\sin x}{\cos x}", "x", "increasing", ""),
    (r"-\frac{1}{\log x}", "x", "increasing", "x > 0"),
    (r"-\frac{1}{\arctan x}", "x", "increasing", "-1 < x < 1"),
    (r"-\frac{1}{n}", "n", "increasing", ""),
    # flat where another symbol is zero
    ("x y^2", "x", "increasing", ""),
    ("x (y - 1)^2", "x", "increasing", ""),
    ("x^2 y", "x", "increasing", r"x \geq 0, y \geq 0"),
    # zero for negative x
    (r"e^x (x + \left|x\right|)", "x", "increasing", ""),
    (r"e^x (x^3 + (x^2)^{3/2})", "x", "increasing", ""),
    # another term of the sequence with each sample
    ("x_k + k", "k", "increasing", ""),
]
TRUE_TRENDS = [
    (r"\tan x", "x", "increasing", "-1 < x < 1"),
    (r"-\frac{1}{\log x}", "x", "increasing", "x > 1"),
    (r"-\frac{1}{n}", "n", "increasing", r"n \geq 1"),
    ("x (y^2 + 1)", "x", "increasing", ""),
    ("x + e^x", "x", "increasing", ""),
    (r"\sin x", "x", "increasing", "-1 < x < 1"),
    (r"x + \sin x", "x", "increasing", ""),
    # the following number has to be in the domain too
    (r"-\left|n - j\right|", "n", "increasing", r"n \leq j"),
]
IDENTITIES = [
    (r"\frac{\cos x}{\cos x} = 1", "-2 < x < 2"),
    # the angle that the tangent of its half does not reach
    (r"\frac{1 + \cos x}{1 + \cos x} = 1", "-4 < x < 4"),
    (r"\tan\frac{x}{2} - \tan\frac{x}{2} = 0", "-4 < x < 4"),
    (r"\tan x \cos x = \sin x", r"0 \leq x \leq 3"),
    (r"\frac{x^n}{x^n} = 1", r"-1 < x < 1, n \geq 1"),
    (r"\frac{x^n - 1}{x^n - 1} = 1", r"n \geq 0"),
    (r"\frac{\log x}{\log x} = 1", "x > 0"),
    (r"(\frac{x}{x})^n = 1", "-1 < x < 1"),
    (r"e^{x/x - 1} = 1", "-1 < x < 1"),
    # a sum without terms
    (r"\frac{\sum_{i=1}^k x_i}{\sum_{i=1}^k x_i} = 1", r"k \geq 0"),
    # no value anywhere
    (r"\frac{\log 1}{\log 1} = 1", ""),
    (r"\frac{\arctan x + \arctan(-x)}{\arctan x + \arctan(-x)} = 1", ""),
    (r"\frac{\sum_{i=0}^k (x_i - x_i)}{\sum_{i=0}^k (x_i - x_i)} = 1", r"k \geq 0"),
]
TRUE_IDENTITIES = [
    (r"\frac{\cos x}{\cos x} = 1", "-1 < x < 1", ""),
    (r"\frac{1 + \cos x}{1 + \cos x} = 1", "-3 < x < 3", ""),
    (r"\tan\frac{x}{2} = \frac{1 - \cos x}{\sin x}", "0 < x < 3", ""),
    (r"\cos(x + y) = \cos x \cos y - \sin x \sin y", "x > 0, y > 0", ""),
    (r"\frac{\log x}{\log x} = 1", "x > 1", ""),
    (r"\frac{\arctan x}{\arctan x} = 1", "x > 0", ""),
    (r"\frac{x^n}{x^n} = 1", r"0 < x < 1, n \geq 1", ""),
    (r"\frac{x \arctan 1}{\arctan 1} = x", "", ""),
    (r"\frac{\sum_{i=0}^k x_i}{2 \sum_{i=0}^k x_i} = \frac{1}{2}", r"k \geq 0", "every part"),
    (r"\tan x = \frac{\sin x}{\cos x}", "", "where every part has a value"),
]
SYMBOLS: dict[str, str] = dict.fromkeys(("x_i", "x_k"), "{ unit = '1', meaning = 'a term' }")


def _trend(subject: str, variable: str, trend: str, domain: str) -> str:
    where = f"domain = '{domain}'" if domain else ""
    about = f"about = ['{subject}', '{variable}']\ntrend = '{trend}'\ntext = 'in words'\n{where}"
    return judged("monotone", about, SYMBOLS).verdict


@pytest.mark.parametrize(("subject", "variable", "trend", "domain"), TRENDS)
def test_trend_is_not_proved(subject: str, variable: str, trend: str, domain: str) -> None:
    assert _trend(subject, variable, trend, domain) != "proved"


def test_what_rests_on_measurements_has_no_trend() -> None:
    symbols = {
        "k": "{ quantity = 'sample_number', meaning = 'number of the sample' }",
        "s": "{ quantity = 'previous_state.1', meaning = 'position before' }",
    }
    about = "about = ['k + s', 'k']\ntrend = 'increasing'\ntext = 'in words'"
    setting = "kind = 'growing_memory'\ndegree = 1\ngain = 'filter'"
    assert judged("monotone", about, symbols, setting).verdict != "proved"


@pytest.mark.parametrize(("subject", "variable", "trend", "domain"), TRUE_TRENDS)
def test_true_trend_is_proved(subject: str, variable: str, trend: str, domain: str) -> None:
    assert _trend(subject, variable, trend, domain) == "proved"


@pytest.mark.parametrize(("latex", "domain"), IDENTITIES)
def test_identity_is_not_proved(latex: str, domain: str) -> None:
    where = f"\ndomain = '{domain}'" if domain else ""
    assert judged("identity", f"latex = '{latex}'{where}", SYMBOLS).verdict != "proved"


@pytest.mark.parametrize(("latex", "domain", "left_out"), TRUE_IDENTITIES)
def test_true_identity_is_proved(latex: str, domain: str, left_out: str) -> None:
    where = f"\ndomain = '{domain}'" if domain else ""
    found = judged("identity", f"latex = '{latex}'{where}", SYMBOLS)
    assert found.verdict == "proved", found.reason
    assert found.domain is not None
    assert left_out in found.domain
    assert ("every part" in found.domain) == bool(left_out)
