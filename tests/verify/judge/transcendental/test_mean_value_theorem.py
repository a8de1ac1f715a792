"""Inequalities with functions, proved by the slope away from a point; false ones beside them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction

import pytest
from one_of_each import cases
from small_claims import check, judged

from gainproof.verify.judge.exact.balls import Balls
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.replay import replay
from gainproof.verify.judge.transcendental.constant_folding import plain, without_common
from gainproof.verify.judge.transcendental.decision import decided
from gainproof.verify.judge.transcendental.mean_value_theorem import by_slopes
from gainproof.verify.judge.transcendental.smoothness import is_smooth

R, UNIT, WHOLE, TWO = "x > 0", "0 < x < 1", None, "x > 0, y > 0"
TRUE = [
    (r"e^x > 1 + x + \frac{x^2}{2} + \frac{x^3}{6}", R),
    (r"\ln x \leq x - 1", R),
    (r"x \ln x \geq x - 1", R),
    (r"\frac{\ln x}{x} \leq 1", R),
    (r"e^x \geq 1 + x", WHOLE),
    (r"\sin x \geq x - \frac{x^3}{6}", R),
    # the slope 1 - cos x is 0 again and again
    (r"\sin x < x", R),
    (r"\cos x \geq 1 - \frac{x^2}{2}", WHOLE),
    (r"\tanh x < x", R),
    (r"\tan x > x", UNIT),
    (r"\arctan x > \frac{x}{1 + x^2}", R),
    (r"\ln(1 + x) > \frac{2 x}{2 + x}", R),
    (r"\ln(1 - x) < -x", UNIT),
    (r"\frac{1 - e^{-x}}{x} < 1", R),
    # a root has a value but no slope at 0
    (r"e^{\sqrt{x}} \geq 1 + \sqrt{x}", r"x \geq 0"),
    # other symbols stay what they are
    (r"e^{a x} \geq 1 + a x", "x > 0, a > 0"),
    (r"1 < e^x < e^{2 x}", R),
    # numbers in which logarithms stand are compared by balls
    (r"2^x \geq x + 1", r"x \geq 1"),
    # what vanishes far out
    (r"\ln(1 + \frac{1}{x}) < \frac{1}{x}", R),
    # least between simple points: balls over pieces there, slopes farther out
    (r"e^x > x^2", R),
    (r"e^x > 2.71828 x", R),
    (r"x^2 - \ln x > 0.84656", R),
    (r"\sin x > \frac{2 x}{5}", "0 < x < 2"),
    # a number is taken out
    (r"\ln x^2 \leq x^2 - 1", r"x \neq 0"),
    (r"\frac{\sin x}{x} \leq 1", r"x \neq 0"),
    (r"\cos x > 1 - \frac{x^2}{2}", r"x \neq 0"),
    # from where two symbols are equal
    (r"x \ln\frac{x}{y} \geq x - y", TWO),
    (r"\ln\frac{x + y}{2} \geq \frac{\ln x + \ln y}{2}", TWO),
    (r"x \ln\frac{x}{y} + z \geq x - y", TWO + ", z > 0"),
    # unlike throughout
    (r"e^x \neq x", WHOLE),
    (r"e^x \neq 1 + x", r"x \neq 0"),
]
FALSE = [
    (r"e^x > 1 + x + \frac{x^2}{2} + \frac{x^3}{5}", R, "refuted"),
    (r"\sin x \geq x - \frac{x^3}{7}", R, "refuted"),
    (r"\sin x < x - \frac{x^3}{7}", R, "refuted"),
    (r"\tan x > x", "0 < x < 3", "refuted"),
    (r"\frac{1 - e^{-x}}{x} < 1 - \frac{x}{2}", R, "refuted"),
    (r"\ln(1 + x) < x - \frac{x^2}{1000}", R, "refuted"),
    # close to 0 alone
    (r"e^x > 1 + x + \frac{x^2}{1.9999999}", R, "refuted"),
    (r"e^x \geq 1.000000001 + x", WHOLE, "refuted"),
    (r"e^x > 2.71829 x", R, "refuted"),
    # where it is lowest, between simple points
    (r"x^2 - \ln x > 0.84658", R, "refuted"),
    (r"x \ln x > -0.3678", UNIT, "refuted"),
    (r"e^{-1000000 (x - 0.3333)^2} < 0.99", UNIT, "refuted"),
    (r"\frac{\ln x}{x} < 0.36787", R, "refuted"),
    (r"\ln x^2 < x^2 - 1", r"x \neq 0", "refuted"),
    # equal at one point only
    (r"\ln x < x - 1", R, "conditional"),
    (r"e^x > 1 + x", WHOLE, "conditional"),
    (r"\cos x > 1 - \frac{x^2}{2}", r"x \geq 0", "conditional"),
    (r"e^x \neq 1 + x", WHOLE, "conditional"),
    # equal where several symbols are simple numbers
    (r"x \ln\frac{x}{y} > x - y", TWO, "refuted"),
    (r"e^x + e^y > 2 e^{(x + y)/2}", WHOLE, "refuted"),
    (r"x + y > \ln(1 + x) + \ln(1 + y)", r"x \geq 0, y \geq 0", "refuted"),
    (r"x \ln\frac{x}{y} \geq x - y + 0.001", TWO, "refuted"),
]
KINDS = (0, 1, 6, 9, 12, 14, 15, 17, 18, 19, 21, 23, 26, 29)


def claim(latex: str, domain: str | None) -> str:
    return f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else "")


@pytest.mark.alike
@pytest.mark.parametrize(("latex", "domain"), cases(TRUE, lambda case: TRUE.index(case) in KINDS))
def test_true(latex: str, domain: str | None) -> None:
    check(judged("inequality", claim(latex, domain)), "proved")


@pytest.mark.parametrize(
    ("latex", "domain", "wanted"), cases(FALSE, lambda case: FALSE.index(case) in (0, 3, 6, 8, 9))
)
def test_false(latex: str, domain: str | None, wanted: str) -> None:
    found = judged("inequality", claim(latex, domain))
    check(found, wanted)
    if wanted == "conditional":
        assert found.witness is not None
        assert found.witness["exact"] is True


def test_where_a_strict_one_holds_is_told() -> None:
    assert judged("inequality", claim(r"\ln x < x - 1", R)).domain == "for 0 < x < 1 or x > 1"


def test_a_ratio_is_told_by_its_symbols() -> None:
    found = judged("inequality", claim(r"x \ln\frac{x}{y} \geq x - y", TWO))
    assert found.certificate is not None
    assert found.certificate["slopes"][0].startswith(
        "1 + (x/y) log((x/y)) - (x/y) >= 0: it is 0 at"
    )
    assert replay(found.certificate, "proved") is None


def test_the_parts_of_a_proof_are_told() -> None:
    found = judged("inequality", claim(r"\ln x < x - 1", R + r", x \neq 1"))
    assert found.domain == "x > 0, x != 1"
    assert found.certificate is not None
    above, below = found.certificate["slopes"]
    assert above.startswith("x > 1: -1 - log(x) + x > 0: it is 0 at x = 1;")
    assert below.startswith("0 < x < 1: -1 - log(x) + x > 0: it is 0 at x = 1;")
    found = judged("inequality", claim(r"x^2 - \ln x > 0.84", R))
    assert found.certificate is not None
    lines = [line.split(": ")[0] for line in found.certificate["slopes"]]
    assert lines[:2] == ["0 < x <= 1/2", "1/2 <= x <= 3"]
    assert "x >= 3" in lines
    assert replay(found.certificate, "proved") is None


def test_the_proof_is_told_and_gone_through_again() -> None:
    found = judged("inequality", claim(r"e^x > 1 + x + \frac{x^2}{2}", R))
    assert found.certificate is not None
    first, second = found.certificate["slopes"]
    assert first.endswith(" > 0: it is 0 at x = 0; slope away from there: -1 - x + exp(x) > 0")
    assert second == "-1 - x + exp(x) > 0: it is 0 at x = 0; slope away from there: -1 + exp(x) > 0"
    assert replay(found.certificate, "proved") is None
    assert replay({**found.certificate, "slopes": []}, "proved") == "slopes differ"
    changed = json.loads(json.dumps(found.certificate).replace('"2"', '"1"'))
    assert replay(changed, "proved") == "wanted proved, got refuted"


X, ZERO = symbol("x"), number(0)


def call(name: str, x: Expr) -> Expr:
    return Expr("call", name, (x,))


SIZE = power(power(X, 2), Fraction(1, 2))
EXP = call("exp", X)


def proves(rel: Rel, boxes: Mapping[str, Box]) -> bool:
    try:
        return decided(Statement((rel,)), boxes, None, {}).verdict == "proved"
    except Undecided:
        return False


@pytest.mark.parametrize(
    ("g", "wanted"),
    [
        (EXP * X + call("cos", X) - call("atan", X) * call("erf", X), True),
        (1 / X, False),
        (power(X, -1), False),
        (power(X, Fraction(1, 2)), True),
        (power(X, Fraction(1, 3)), True),
        (power(X, Fraction(-1, 2)), False),
        (power(X - 1, Fraction(1, 2)), False),
        (power(X - 1, 2), True),
        (call("log", X), False),
        (call("log", X + 1), True),
        (call("tan", X), False),
        (call("tan", X / 2), True),
        (Expr("call", "power", (X, EXP)), False),
        (Expr("call", "power", (X + 1, X)), True),
        (call("erfinv", X / 3), False),
        (Expr("call", "sum", (X, symbol("k"), ZERO, X)), False),
    ],
)
def test_where_every_part_has_a_slope(g: Expr, wanted: bool) -> None:
    """Between 0 and 2, with a value and no jump at both ends."""
    between = {"x": Box(Fraction(0), Fraction(2))}
    closed = {"x": Box(Fraction(0), Fraction(2), lower_open=False, upper_open=False)}
    assert is_smooth(g, between, closed, proves) is wanted


@pytest.mark.parametrize(
    ("expr", "wanted"),
    [
        (X * EXP + power(X, 2), "exp(x) + x"),
        (EXP / X + 1, "exp(x) + x"),
        (EXP / X + X / EXP, "exp(x)^2 + x^2"),
        (EXP + 1, "1 + exp(x)"),
        (X * EXP + 2 * X, "2 + exp(x)"),
        (EXP - EXP, "0"),
    ],
)
def test_common_positive_factors_go(expr: Expr, wanted: str) -> None:
    left = without_common(expr, lambda _: True)
    assert sorted(written(left)[1][0].split(" + ")) == sorted(wanted.split(" + "))
    for value in (Fraction(1, 3), Fraction(5)):
        balls = Balls({"x": value}, 128)
        assert (balls.round(left) > 0) is bool(balls.round(expr) > 0)
    assert without_common(X * EXP + X, lambda factor: factor == EXP).key == plain(X * EXP + X).key


@pytest.mark.parametrize(
    ("g", "box"),
    [
        # the slope is nowhere below 0, but nothing rises
        (EXP * call("exp", -X) - 1, Box(Fraction(0))),
        # 0 for all x < 0; the slope is not below 0 wherever it exists, and above 0 at 1
        (call("atan", SIZE + X), Box(Fraction(-1), Fraction(2))),
        # falls at 1 by a jump
        (call("atan", 1 / (1 - X)), Box(Fraction(0), Fraction(2))),
        (call("tan", X), Box(Fraction(0), Fraction(3))),
        (call("log", X), Box(Fraction(0), Fraction(2))),
        # no value below 0
        (call("log", X) - call("log", X) + EXP, Box(Fraction(-1), Fraction(1))),
        # the slope of the wrong sign on one side of the point
        (EXP - 1, Box(Fraction(-1), Fraction(1))),
    ],
)
def test_what_is_not_above_0_is_not_proved(g: Expr, box: Box) -> None:
    with pytest.raises(Undecided):
        by_slopes(Statement((Rel(">", g, ZERO),)), {"x": box}, proves)


@pytest.mark.parametrize(
    "statement",
    [
        Statement((Rel(">", EXP, X),), (Rel(">", X, ZERO),)),
        Statement((Rel(">", EXP, X),), (Rel(">", X, ZERO),), "iff"),
        Statement((Rel(">", EXP, X),), needed=(call("log", X),)),
        Statement((Rel("!=", EXP, 2 * X + 1),)),
    ],
)
def test_what_slopes_do_not_cover(statement: Statement) -> None:
    with pytest.raises(Undecided):
        by_slopes(statement, {"x": Box(Fraction(-1))}, proves)


@pytest.mark.parametrize("factor", ["e^y", r"e^{y + 1}", r"\sinh(y)", r"(e^y + 1)", r"e^{-y}"])
def test_a_slope_that_is_the_relation_itself_is_told_once(factor: str) -> None:
    # the slope by y of e^y g is e^y g again; that by x is 0 throughout
    stated = {n: f"{{ unit = '1', domain = '-2 < {n} < 2', meaning = 'n' }}" for n in "xy"}
    found = judged("identity", rf"\ln(x^2) {factor} = 2 {factor} \ln\left|x\right|", stated)
    check(found, "conditional")
    assert "x != 0" in (found.domain or ""), found.domain
