"""Points that are no rational numbers at which claims with functions fail: where functions have
exact values, and where a difference changes its sign.
"""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

import mpmath
import pytest
from one_of_each import further
from samples import samples
from small_claims import check, judged
from thin_sets_functions import TERMS, claims

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, sqrt, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.replay import replay
from gainproof.verify.judge.transcendental.pi import PI
from gainproof.verify.judge.transcendental.special_points import equal_sides, is_zero

with mpmath.workdps(90):
    LONG_E = mpmath.nstr(+mpmath.e, 80)


def claim(latex: str, domain: str) -> str:
    return f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else "")


FAILING = [
    # no value: one symbol, two, three and four; angles of which the half has no tangent
    ("identity", r"\frac{e^p - 3}{e^p - 3} = 1", "p > 0", {"p": "log(3)"}),
    ("identity", r"\frac{1 - \ln v}{1 - \ln v} = 1", "v > 0", {"v": "exp(1)"}),
    ("inequality", r"\frac{1}{u^2 + (\ln v)^2} > 0", "-1 < u < 1, v > 0", {"u": "0", "v": "1"}),
    ("inequality", r"\frac{1}{2 + \cos p + \cos q} > 0", "3 < p < 4, 3 < q < 4",
     {"p/pi": "1", "q/pi": "1"}),
    ("identity", r"\frac{x^2 + 1 + \cos a}{x^2 + 1 + \cos a} = 1", "-1 < x < 1, -4 < a < 4",
     {"a/pi": "1", "x": "0"}),
    further("inequality", r"\frac{1}{\left| e^p - 2 \right| + \sin^2 q} > 0", "p > 0, 3 < q < 4",
     {"p": "log(2)", "q/pi": "1"}),
    ("identity", r"\frac{x^2 + y^2 + (e^p - 3)^2}{x^2 + y^2 + (e^p - 3)^2} = 1",
     "-1 < x < 1, -1 < y < 1, p > 0", {"p": "log(3)", "x": "0", "y": "0"}),
    ("identity", r"\frac{3 - \sin a - \sin b - \sin c}{3 - \sin a - \sin b - \sin c} = 1",
     "1 < a < 2, 1 < b < 2, 1 < c < 2", {"a/pi": "1/2", "b/pi": "1/2", "c/pi": "1/2"}),
    ("implication", r"u \geq 0 \Rightarrow \frac{u^2 + 1 - \sin a}{u^2 + 1 - \sin a} = 1",
     "-1 < u < 1, 1 < a < 2", {"a/pi": "1/2", "u": "0"}),
    ("monotone", "about = ['\\frac{x (1 + \\cos a)}{1 + \\cos a}', 'x']\ntrend = 'increasing'",
     "-1 < x < 1, 3 < a < 4", {"a/pi": "1", "x": "0"}),
    ("implication", r"v > w \Rightarrow v > w + \frac{0}{e^x - 3}", "x > 0",
     {"v": "5", "w": "1", "x": "log(3)"}),
    # both sides of a strict relation are one number
    ("inequality", r"1 + \cos a > 0", "-4 < a < 4", {"a/pi": "1"}),
    ("inequality", r"\cos 2 t > -1", "0 < t < 3", {"t/pi": "1/2"}),
    ("inequality", "b^c < 1", r"0 < b < 1, c \geq 0", {"b": "1/2", "c": "0"}),
    ("inequality", r"\left| \sin x \cos x \right| < \frac{1}{2}", "", {"x/pi": "1/4"}),
    ("inequality", r"\sin x + \sin y < 2", "0 < x < 3, 0 < y < 3", {"x/pi": "1/2", "y/pi": "1/2"}),
    ("implication", r"\cos u < 0 \Rightarrow \cos u > -1", "", {"u/pi": "1"}),
    # parts on both sides of the point, or within the ends
    ("inequality", r"\frac{\left| \sin x \right|}{\left| x \right|} \leq 1", "-1 < x < 1",
     {"x": "0"}),
    further("inequality", r"\left| \tan t \right| \geq \left| t \right|",
     r"-\frac{\pi}{2} \leq t \leq \frac{\pi}{2}", {"t/pi": "-1/2"}),
]  # fmt: skip


@pytest.mark.alike
@pytest.mark.parametrize(("kind", "latex", "domain", "point"), FAILING)
def test_a_special_point_is_found(
    kind: str, latex: str, domain: str, point: dict[str, str]
) -> None:
    fields = f"{latex}\ndomain = '{domain}'" if kind == "monotone" else claim(latex, domain)
    found = judged(kind, fields)
    check(found, "conditional")
    assert found.witness is not None
    assert found.witness["point"] == point
    assert found.certificate
    assert replay(found.certificate, "conditional") is None


@pytest.mark.parametrize(
    ("kind", "latex", "domain", "name", "place"),
    [
        ("inequality", r"x \neq \cos x", "", "x", lambda x: x - mpmath.cos(x)),
        ("inequality", r"(x - e^{-x})^2 > 0", "", "x", lambda x: x - mpmath.exp(-x)),
        ("identity", r"\frac{x - \cos x}{x - \cos x} = 1", "0 < x < 2", "x",
         lambda x: x - mpmath.cos(x)),
        ("inequality", r"\frac{1}{(x + \ln x)^2} > 0", "x > 0", "x", lambda x: x + mpmath.log(x)),
    ],
)  # fmt: skip
def test_a_change_of_sign_is_found(
    kind: str, latex: str, domain: str, name: str, place: mpmath.mpf
) -> None:
    found = judged(kind, claim(latex, domain))
    assert found.verdict in ("refuted", "conditional"), found.reason
    assert found.witness is not None
    near = float(found.witness["point"][name].rpartition(" near ")[2])
    assert near == pytest.approx(float(mpmath.findroot(place, 0.6)), rel=1e-5)


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\cos 2 t > -1", r"0 < t < \frac{3}{2}"),
        (r"\frac{e^p}{e^p - 3} < 0", "p < 1"),
        ("b^c < 1", "0 < b < 1, c > 0"),
        (r"\frac{1}{1 - \ln x} \neq 0", ""),  # a change of sign, where it has no value
        (r"\frac{1}{2 + \cos p + \cos q} > 0", "3 < p < 4, 2 < q < 3"),
        (r"\ln(1 + e^u) > 0", ""),
        (r"\ln(2 + \cos u) \geq 0", ""),
    ],
)
def test_what_never_fails_is_proved(latex: str, domain: str) -> None:
    check(judged("inequality", claim(latex, domain)), "proved")


def call(name: str, *parts: Expr) -> Expr:
    return Expr("call", name, parts)


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"x \neq \cos x", "x > 1"),  # the root is outside
        # a change of sign at x = 1/3, where it has no value: e^x (x - 1/3) is nowhere below
        # -e^{-2/3}, so never -1
        (r"e^x + \frac{3}{3 x - 1} \neq 0", ""),
    ],
)
def test_what_is_no_root_is_no_counterexample(latex: str, domain: str) -> None:
    found = judged("inequality", claim(latex, domain))
    assert found.verdict in ("proved", "held", "undecided"), found.reason


def test_a_point_where_a_condition_fails_is_none_of_the_domain() -> None:
    a = symbol("a")
    above = (Rel(">", 1 + call("cos", a), number(0)),)
    boxes = {"a": Box(lower=Fraction(0), upper=Fraction(4))}
    assert equal_sides(Statement(above), boxes, {}) is not None
    for operator in (">", ">=", "="):
        condition = Rel(operator, call("sin", a), number(Fraction(1, 2)))
        assert equal_sides(Statement(above, (condition,)), boxes, {}) is None
    at_least = Rel(">=", call("sin", a), number(0))
    assert equal_sides(Statement(above, (at_least,)), boxes, {}) is not None


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [(r"\cos u > 0 \Rightarrow \cos u > -1", "proved"),
     (r"\sin^2 u < 1 \Rightarrow \cos^2 u > 0", "proved"),
     (r"\log_2(x + 1) > \log_2(y + 1) \Rightarrow x y > -1", "refuted")],
)  # fmt: skip
def test_conditions_on_functions(latex: str, wanted: str) -> None:
    check(judged("implication", latex), wanted)


@pytest.mark.parametrize(
    ("expr", "wanted"),
    [
        (call("exp", call("log", number(3))) - 3, True),
        (call("exp", call("log", number(3))) - 2, False),
        (call("sin", PI / 3) - sqrt(number(3)) / 2, True),
        (1 + call("cos", PI), True),
        (call("log", call("exp", number(2))) - 2, True),
        (call("exp", number(1)) - number(LONG_E), False),
    ],
)
def test_zeros_are_exact(expr: Expr, wanted: bool) -> None:
    assert is_zero(expr) is wanted


def test_the_terms_vanish_where_it_is_said() -> None:
    for term in TERMS:
        assert abs(term.value(term.zero)) < 1e-15, term.latex
        assert all(term.value(mpmath.mpf(k) / 7) > -1e-12 for k in range(1, 40)), term.latex


@pytest.mark.sampled
def test_none_without_a_value_somewhere_is_proved() -> None:
    for each in claims(3, samples(6), has_value=False, most=3):
        found = each.judged()
        assert found.verdict != "proved", (each.fields, each.symbols)


@pytest.mark.sampled
def test_most_with_a_value_everywhere_are_proved() -> None:
    verdicts = Counter(
        each.judged().verdict for each in claims(4, samples(5), has_value=True, most=3)
    )
    assert set(verdicts) <= {"proved", "held", "undecided"}
    assert verdicts["proved"] >= 0.9 * verdicts.total()
