"""Implications and equivalences with functions, and domains in which a side has no value."""

from __future__ import annotations

import random
from fractions import Fraction

import mpmath
import pytest
from one_of_each import further
from samples import samples
from small_claims import check, judged

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.rational_points import without_value
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.replay import replay


def claim(latex: str, domain: str) -> str:
    return f"latex = '{latex}'\ndomain = '{domain}'"


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"y = \ln x \Rightarrow x = e^y", "x > 0"),
        (r"x = e^y \Rightarrow y = \ln x", "x > 0"),
        (r"x = e^y \Leftrightarrow y = \ln x", "x > 0"),
        further(r"x = 10^{y/10} \Leftrightarrow y = 10 \log_{10} x", "x > 0"),
        further(r"z = \sin x, y = \cos x \Rightarrow z^2 + y^2 = 1", "x > 0"),
        (r"e^x > 1 \Rightarrow x > 0", "x > -10"),
        (r"e^x \geq 1 \Leftrightarrow x \geq 0", "x > -10"),
        further(
            r"p = e^{-t^2/(2 s^2)} \Leftrightarrow t = s \sqrt{-2 \ln p}",
            "0 < p < 1, t > 0, s > 0",
        ),
        further(r"e^{-x^2/s^2} = \frac12 \Leftrightarrow x = s\sqrt{\ln 2}", "x > 0, s > 0"),
        further(r"10 \lg q = 10\lg\frac12 \Leftrightarrow q = \frac12", "q > 0"),
        further(r"e^{-q} = \frac12 \Leftrightarrow q = \ln 2", "q > 0"),
        further(r"\ln x < \ln y \Leftrightarrow x < y", "x > 0, y > 0"),
        further(r"e^{-x} < e^{-y} \Leftrightarrow x > y", "x > 0"),
        further(r"s > 10 t \Rightarrow 10 \lg\frac{s}{t} > 10", "s > 0, t > 0"),
        (r"e^x > y \Rightarrow x > \ln y", "y > 0"),
        further(r"(\frac{1}{2})^x < y \Leftrightarrow x > -\log_2 y", "y > 0"),
        further(r"x = e^y \Rightarrow y > 0", "x > 1"),
        (r"-2 y = \ln x \Rightarrow x = e^{-2 y}", "x > 0"),
        (r"\ln x > 0 \Leftrightarrow x > 1", "x > 0"),
        further(r"10 \log_{10} x > 20 \Leftrightarrow x > 100", "x > 0"),
        further(r"\ln x > 1 \Rightarrow x > 2", "x > 0"),
        (r"x > 3 \Rightarrow \ln x > 1", "x > 0"),
        (r"\sin x > 0 \Rightarrow x < 4", "0 < x < 6"),
        (r"1 < x \Rightarrow \ln x > 0", "x > 0"),
        further(r"2 > x \Rightarrow e^x < 8", "x > 0"),
    ],
)
def test_what_is_true_is_proved(latex: str, domain: str) -> None:
    kind = "equivalence" if "Left" in latex else "implication"
    found = judged(kind, claim(latex, domain))
    check(found, "proved")
    ways = [found.certificate] if kind == "implication" else found.certificate.values()
    assert [replay(way, "proved") for way in ways] == [None] * len(ways)


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"y = \ln x \Rightarrow x = e^{2 y}", "x > 0"),
        further(r"x = 10^{y/20} \Leftrightarrow y = 10 \log_{10} x", "x > 0"),
        further(r"e^x > 1 \Leftrightarrow x > 1/10", "x > -10"),
        (r"\ln x > 0 \Leftrightarrow x > 2", "x > 0"),
        further(r"10 \lg q = -3 \Leftrightarrow q = \frac12", "q > 0"),
        further(r"e^{-q} = \frac12 \Leftrightarrow q = \ln 3", "q > 0"),
        (r"x < 1 \Rightarrow -\ln x < 0", "x > 0"),
        further(r"-y = \ln x \Rightarrow y = \ln x", "x > 0"),
        further(r"2 y = \ln x \Rightarrow x = e^y", "x > 0"),
        (r"\ln x \ln x > 1 \Rightarrow x > 2", "x > 0"),
        (r"x > 2 \Rightarrow (\frac{1}{2})^x > \frac{1}{4}", "x > 0"),
        further(
            r"p = e^{-t^2/(2 s^2)} \Leftrightarrow t = s \sqrt{-\ln p}",
            "0 < p < 1, t > 0, s > 0",
        ),
        further(r"\log_{10} x < 0 \Leftrightarrow x < 1", "x > -1"),
        further(r"\ln x > 1 \Rightarrow x > 3", "x > 0"),
        (r"x > 2 \Rightarrow \ln x > 1", "x > 0"),
        (r"\sin x > 0 \Rightarrow x < 3", "0 < x < 6"),
        (r"1 < x \Rightarrow \ln x < 0", "x > 0"),
        further(r"e^x \leq 1 \Rightarrow x < 0", "x > -10"),
        (r"e^x \geq 1 \Rightarrow x > 0", "x > -10"),
        further(r"e^{-x} \leq 1 \Rightarrow x > 0", "x > -10"),
    ],
)
def test_what_is_false_is_refuted(latex: str, domain: str) -> None:
    kind = "equivalence" if "Left" in latex else "implication"
    check(judged(kind, claim(latex, domain)), "refuted")


def test_an_implication_without_a_value_at_a_point() -> None:
    found = judged("implication", claim(r"e^x > y \Rightarrow x > \ln y", "y > -1"))
    check(found, "conditional")
    assert found.domain == "for y > 0, where every part has a value"


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"x = \ln y \Rightarrow \ln(y - 1) < x", "y > 0"),  # no value where the premise holds
        (r"e^x \geq 1 \Leftrightarrow x > 0", "x > -10"),
        (r"e^x > 1 \Rightarrow \frac{1}{x - 2} \leq \frac{1}{x - 2}", "x > -10"),
        (r"e^x > 1 \Rightarrow \frac{1}{(x - 2)^2} > 0", "x > -10"),
        # of what follows from the angle, the angle does not follow: 3 pi/4 has it too
        (r"\cos^2\theta = \frac12 \Leftrightarrow \theta = \frac{\pi}{4}", r"0 < \theta < 3"),
        (r"x > 1 \Rightarrow \ln x + \frac{1}{y} - \frac{1}{y} > 0", "x > 0, y > -1"),
        (r"x > 1 \Rightarrow \frac{y}{y} \ln x > 0", "x > 0, y > -1"),
        (r"-x < 1 \Rightarrow -\ln x > 0", "x > 0"),
        (r"\ln x \leq x", "x > -1"),
        (r"w = 10^{\log_{10} w}", "w >= 0"),
        (r"\frac{\ln x}{\ln x} = 1", "x > 1/2"),
        (r"\sin\frac{x}{x} = \sin 1", "x > -1"),
    ],
)
def test_what_has_no_value_somewhere_is_not_proved(latex: str, domain: str) -> None:
    kinds = {"Left": "equivalence", "Right": "implication", "leq": "inequality"}
    kind = next((k for word, k in kinds.items() if word in latex), "identity")
    assert judged(kind, claim(latex, domain)).verdict != "proved"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"x = e^{-x} \Rightarrow x < \frac{3}{5}", "x > 0"),
        (r"x > 3 \Rightarrow e^x < 0", "x < 2"),  # nothing is greater than 3
        (r"y = \ln x \Rightarrow x > \frac{1}{10}", "x > 0, y > -1"),
        (r"n = e^x \Rightarrow n \geq 2", "x > 0, n >= 1"),  # a whole number
        # what has no value is no premise
        (r"z = \ln(-x^2) \Rightarrow x > 5", "x > -10"),
        (r"x = \frac{e^y}{y - y} \Rightarrow 1 = 2", "x > 0"),
        (r"z = \sqrt{e^x - 1} \Rightarrow x \geq 0", "x > -10"),
        (r"x = 0 \cdot \ln y \Rightarrow \frac{1}{y} > 0", "y > -1"),
        # what agrees to very many digits is not equal
        (r"1 + e^{-x} = 1 \Rightarrow x < 0", "x > 0"),
        (r"1 + e^{-x} = 1 \Rightarrow \ln x < 0", "x > 1"),
        (r"\frac{e^x}{1 + e^x} = 1 \Rightarrow x < 0", "x > 0"),
        (r"e^{-x} + 1 = e^{-2 x} + 1 \Rightarrow x = 0", "x >= 0"),
        (r"y = e^{-x} + 1, y = 1 \Rightarrow x < 0", "x > 0"),
        (r"e^{-x} (1 + e^{-x}) = e^{-x} \Rightarrow \ln(-x) = 0", "x > 0"),
    ],
)
def test_what_is_true_is_not_refuted(latex: str, domain: str) -> None:
    assert judged("implication", claim(latex, domain)).verdict in ("proved", "held", "undecided")


@pytest.mark.parametrize(
    "latex",
    [
        r"z = \ln x \Rightarrow x > 0",
        r"z = \ln x, t = z \Rightarrow x > 0",
        r"z = \log_{10} x \Rightarrow \sqrt{x^2} = x",
    ],
)
def test_what_is_supposed_has_a_value_on_a_part_only(latex: str) -> None:
    found = judged("implication", claim(latex, "x > -10"))
    check(found, "conditional")
    assert found.domain == "for x > 0, where every part has a value"


def test_what_is_not_resolved_is_not_without_value() -> None:
    x = symbol("x")
    sine, cosine = (power(Expr("call", name, (x,)), 2) for name in ("sin", "cos"))
    root = power(sine + cosine - 1, Fraction(1, 2))  # of 0, of which a ball only knows the size
    assert without_value(Statement((Rel("=", root, number(0)),)), {"x": Box()}, {}) is None
    none = power(sine + cosine - 2, Fraction(1, 2))
    assert without_value(Statement((Rel("=", none, number(0)),)), {"x": Box()}, {}) is not None


@pytest.mark.parametrize(
    ("latex", "domain", "verdict"),
    [
        (r"10^{\log_{10} x} = x", "x > 0", "proved"),
        (r"10^{2 \log_{10} x + y} = x^2 \cdot 10^y", "x > 0", "proved"),
        (r"y^{\frac{\ln x}{\ln y}} = x", "x > 0, y > 1", "proved"),
        (r"y^{\frac{\ln x}{\ln y}} = x", "x > 0, y > 0", "conditional"),  # at y = 1
        (r"10^{\ln x} = x", "x > 0", "refuted"),
        (r"10^{\log_2 x} = x", "x > 0", "refuted"),
    ],
)
def test_powers_of_logarithms(latex: str, domain: str, verdict: str) -> None:
    check(judged("identity", claim(latex, domain)), verdict)


@pytest.mark.parametrize("given", [r"x = e^y", r"x = 2 e^y - 1"])
def test_a_domain_is_that_of_what_stands_for_a_symbol_too(given: str) -> None:
    """At x = 1 there is no value, and y may be such that x is 1."""
    latex = claim(r"\frac{\ln x}{\ln x} = 1", "x > 0")
    assert judged("identity", f"{latex}\ngiven = ['{given}']").verdict != "proved"


@pytest.mark.parametrize("latex", [r"\ln x \leq x - 1", r"\ln x^2 = 2 \ln x"])
def test_a_domain_without_values_is_told_with_a_point(latex: str) -> None:
    kind = "inequality" if "leq" in latex else "identity"
    found = judged(kind, claim(latex, "x > -1"))
    check(found, "conditional")
    assert "no value (a logarithm of a number that is not positive)" in found.reason
    # over a domain that nobody stated nothing is said of such places
    check(judged(kind, f"latex = '{latex}'"), "proved")


FUNCTIONS = {
    r"e^{X}": mpmath.exp,
    r"\ln(X)": lambda t: mpmath.log(t) if t > 0 else None,
    r"\arctan(X)": mpmath.atan,
    r"\log_{10}(X)": lambda t: mpmath.log10(t) if t > 0 else None,
    r"\sin(X)": mpmath.sin,
}
ORDERS = {"<": lambda a, b: a < b, r"\leq": lambda a, b: a <= b, ">": lambda a, b: a > b}


@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(samples(10)))
def test_what_is_proved_holds_at_a_thousand_points(seed: int) -> None:
    generator = random.Random(seed)
    name, function = generator.choice(list(FUNCTIONS.items()))
    a, b, c, d = (generator.randint(-3, 3) or 1 for _ in range(4))
    first, then = generator.choice(list(ORDERS)), generator.choice(list(ORDERS))
    inner = f"{a} x {b:+}"
    premise, conclusion = rf"{name.replace('X', inner)} {first} {c}", f"x {then} {d}"
    if generator.random() < 0.4:
        premise, conclusion = conclusion, premise
    swapped = premise.startswith("x")
    found = judged("implication", claim(rf"{premise} \Rightarrow {conclusion}", "-4 < x < 5"))
    if found.verdict not in ("proved", "refuted"):
        return
    failing = []
    for k in range(1, 1000):
        x = mpmath.mpf(-4) + mpmath.mpf(9) * k / 1000
        value = function(a * x + b)
        has = value is not None and ORDERS[first](value, c)
        within = ORDERS[then](x, d)
        if (within and not has) if swapped else (has and not within):
            failing.append(x)
    assert not (found.verdict == "proved" and failing), (premise, conclusion, failing[:3])
    if found.verdict == "refuted" and not failing:
        assert found.witness is not None


@pytest.mark.parametrize(
    "latex",
    [
        r"\ln(x y) > 0 \Rightarrow x > 0",
        r"e^x < e^y \Rightarrow \lvert x \rvert < \lvert y \rvert",
    ],
)
def test_what_fails_where_both_numbers_are_negative_is_refuted(latex: str) -> None:
    check(judged("implication", latex), "refuted")


@pytest.mark.parametrize(
    ("latex", "domain", "true"),
    [
        (r"\frac{e^v \ln w}{\ln w} = e^v", "0 < w < 2", False),
        (r"\frac{e^v \sin w}{\sin w} = e^v", "-1 < w < 1", False),
        (r"e^v > \frac{e^v \arctan w}{2 \arctan w}", "-1 < w < 1", False),
        (r"\frac{\ln w}{\ln w} \ln v = \ln v", "v > 0, 0 < w < 2", False),
        (r"\frac{\ln 1}{\ln 1} e^v = e^v", "w > 0", False),
        (r"\frac{1}{\frac{1}{\ln v}} = \ln v", "v > 0", False),
        (r"\frac{e^v \ln w}{\ln w} = e^v", "w > 1", True),
        (r"\frac{e^v \ln 3}{\ln 3} = e^v", "w > 1", True),
    ],
)
def test_what_cancels_beside_a_function_needs_a_value(latex: str, domain: str, true: bool) -> None:
    stated = {"w": "{ unit = '1', meaning = 'n' }"}
    stated["v"] = "{ unit = '1', domain = '-9 < v < 9', meaning = 'n' }"
    found = judged("identity" if "=" in latex else "inequality", claim(latex, domain), stated)
    assert (found.verdict == "proved") is true
