"""Inequalities that are decided in another variable: by x = e^u, and by degrees in two symbols."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from one_of_each import cases
from small_claims import check, judged

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, div, mul, number, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.replay import replay
from gainproof.verify.judge.transcendental.changes_of_variable import in_other_variables

TRUE = [
    (r"x \ln x \geq -e^{-1}", "x > 0"),
    (r"\frac{\ln x}{x} \leq e^{-1}", "x > 0"),
    (r"\ln x \leq e^{-1} x", "x > 1"),
    (r"\frac{x}{s^2} e^{-x^2/(2s^2)} \leq \frac{1}{s} e^{-1/2}", "x > 0, s > 0"),
    (r"\frac{1}{s} e^{-x/s} \leq \frac{1}{e^1 x}", "x > 0, s > 0"),
]
LIKE_ANOTHER = (TRUE[2], TRUE[4])
FALSE = [
    (r"x \ln x \geq -0.3678", "x > 0"),
    (r"\frac{\ln x}{x} \leq 0.3678", "x > 0"),
    (r"\frac{x}{s^2} e^{-x^2/(2s^2)} \leq \frac{0.6065}{s}", "x > 0, s > 0"),
    (r"\frac{x}{s^2} e^{-x^2/(2s^2)} \leq \frac{0.61}{s^2}", "x > 0, s > 0"),
    (r"\frac{1}{s} e^{-x/s} \leq \frac{1}{e^1 x^2}", "x > 0, s > 0"),
]


@pytest.mark.parametrize(("latex", "domain"), cases(TRUE, lambda case: case not in LIKE_ANOTHER))
def test_true(latex: str, domain: str) -> None:
    found = judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'")
    check(found, "proved")
    assert found.method is not None
    assert found.method.startswith("in another variable")
    # of the statement itself, not of that in the other variable
    assert "free x" in found.certificate["statement"]["domain"]
    assert replay(found.certificate, "proved") is None


@pytest.mark.parametrize(("latex", "domain"), FALSE)
def test_false(latex: str, domain: str) -> None:
    assert judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'").verdict != "proved"


@pytest.mark.parametrize(
    ("latex", "domain"), cases(TRUE[:3], lambda case: case not in LIKE_ANOTHER)
)
def test_strict_ones_are_not_proved_where_both_sides_meet(latex: str, domain: str) -> None:
    strict = latex.replace(r"\geq", ">").replace(r"\leq", "<")
    found = judged("inequality", f"latex = '{strict}'\ndomain = '{domain}'")
    assert found.verdict != "proved"


def test_the_new_domain_is_that_of_the_logarithm() -> None:
    x = symbol("x")
    rel = Rel("<", Expr("call", "log", (x,)), x)
    over = {
        Box(Fraction(0)): Box(),
        Box(Fraction(1), None, lower_open=False): Box(Fraction(0), None, lower_open=False),
        Box(Fraction(0), Fraction(1)): Box(None, Fraction(0)),
        Box(Fraction(2)): None,
        Box(Fraction(0), None, lower_open=False): None,
        Box(): None,
    }
    for box, wanted in over.items():
        made = list(in_other_variables(Statement((rel,)), {"x": box}, lambda *_: False))
        assert [where for _, where in made] == ([{"ln x": wanted}] if wanted else [])


def test_sides_of_different_degrees_are_left_alone() -> None:
    x, y = symbol("x"), symbol("y")
    boxes = {"x": Box(Fraction(0)), "y": Box(Fraction(0))}
    ratio = div(x, y)
    growth = Expr("call", "exp", (ratio,))
    alike = Rel("<=", mul(x, growth), mul(number(3), y, growth, ratio))
    asked: list[Statement] = []

    def proves(statement: Statement, _: object) -> bool:
        asked.append(statement)
        return True

    assert list(in_other_variables(Statement((alike,)), boxes, proves)) != []
    assert len(asked) == 4  # each side, each of both symbols
    other = Rel("<=", alike.left, mul(alike.right, x))
    assert list(in_other_variables(Statement((other,)), boxes, proves)) == []
    refused = list(in_other_variables(Statement((alike,)), boxes, lambda *_: False))
    assert refused == []


def test_the_bounds_are_right() -> None:
    with mpmath.workdps(30):
        assert abs(mpmath.mpf("0.3679") - mpmath.exp(-1)) < 1e-4
        assert 0.6065 < mpmath.exp(mpmath.mpf(-1) / 2) < 0.6066
        assert 0.3678 < mpmath.exp(-1) < 0.3679
