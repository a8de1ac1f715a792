"""Claims with pi: exact angles, domains that end at multiples of it, arc tangents; false ones."""

from __future__ import annotations

from fractions import Fraction
from functools import partial

import mpmath
import pytest
from one_of_each import cases, further
from small_claims import check, judged

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.exact.balls import Balls
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, add, mul, number, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.replay import replay
from gainproof.verify.judge.transcendental import inequalities
from gainproof.verify.judge.transcendental.free_values import freely
from gainproof.verify.judge.transcendental.half_tangent import half_tangent_of_turns
from gainproof.verify.judge.transcendental.mean_value_theorem import by_slopes
from gainproof.verify.judge.transcendental.pi import PI, cosine_of, exact_angles, pi_box
from gainproof.verify.judge.transcendental.symbols_over_pi import scaled

TRUE = [
    ("identity", r"\cos(2\pi x) = 1 - 2\sin^2(\pi x)", None),
    ("identity", r"\sin\frac{\pi}{12} = \frac{\sqrt{6} - \sqrt{2}}{4}", None),
    ("identity", r"\sin(\frac\pi2 - x) = \cos x", None),
    ("identity", r"\tan(x + \frac{\pi}{2}) = -\frac{1}{\tan x}", None),
    ("identity", r"\ln(2\pi x) = \ln 2 + \ln\pi + \ln x", "x > 0"),
    ("identity", r"x^\pi x = x^{\pi + 1}", "x > 0"),
    ("identity", r"\int_0^x 2\pi t \, dt = \pi x^2", None),
    ("identity", r"\cos x = -1", r"x = \pi"),
    ("identity", r"\cos\frac{x}{2} = \sqrt{\frac{1 + \cos x}{2}}", r"-\pi \leq x \leq \pi"),
    ("value", r"\frac{\pi}{180} = 0.01745", None),
    ("limit", r"\lim_{x\to\infty} \frac{2\pi x}{x + 1} = 2\pi", None),
    # between numbers, closer than the variable's ends
    ("inequality", r"3.14159265358979323846264338327950288419 < \pi", None),
    ("inequality", r"\pi < 3.14159265358979323846264338327950288420", None),
    ("inequality", r"x < \pi", "0 < x < 3.1415"),
    # up to multiples of pi
    ("inequality", r"\sin x > 0", r"0 < x < \pi"),
    ("inequality", r"\sin x \geq 0", r"0 \leq x \leq \pi"),
    ("inequality", r"\cos x > 0", r"-\frac{\pi}{2} < x < \frac{\pi}{2}"),
    ("inequality", r"\sin\frac{x}{2} > 0", r"0 < x < 2\pi"),
    ("inequality", r"\sin 3 x > 0", r"0 < x < \frac{\pi}{3}"),
    ("inequality", r"\sin x \geq \frac{2 x}{\pi}", r"0 \leq x \leq \frac{\pi}{2}"),
    ("inequality", r"\tan x > x", r"0 < x < \frac{\pi}{2}"),
    ("inequality", r"\sin x + \sin y > 0", r"0 < x < \pi, 0 < y < \pi"),
    ("implication", r"0 < x < \pi \Rightarrow \sin x > 0", None),
    # arc tangents
    ("inequality", r"\left| \arctan x \right| < \frac{\pi}{2}", None),
    ("inequality", r"\arctan x \leq \frac{\pi}{4}", r"x \leq 1"),
    # of one slope and equal at a point
    ("identity", r"\arctan x + \arctan\frac{1}{x} = \frac{\pi}{2}", "x > 0"),
    ("identity", r"\arctan(a x) + \arctan\frac{1}{a x} = \frac{\pi}{2}", "x > 0, a > 0"),
    ("identity", r"\arctan\frac{1 + x}{1 - x} = \frac{\pi}{4} + \arctan x", "x < 1"),
    ("identity", r"2\arctan x = \arctan\frac{2 x}{1 - x^2}", "-1 < x < 1"),
]
FALSE = [
    ("identity", r"\pi = \frac{22}{7}", None, "refuted"),
    ("identity", r"\pi = \pi + 10^{-40}", None, "refuted"),
    ("identity", r"2\pi x = 6.2832 x", None, "refuted"),
    ("identity", r"\cos x = 1", r"x = \pi", "refuted"),
    ("identity", r"\sin x = \sqrt{1 - \cos^2 x}", r"0 \leq x \leq 2\pi", "refuted"),
    ("identity", r"\arctan x + \arctan\frac{1}{x} = \frac{\pi}{2}", None, "refuted"),
    ("identity", r"2\arctan x = \arctan\frac{2 x}{1 - x^2}", "x > 1", "refuted"),
    ("value", r"\frac{\pi}{180} = 0.01746", None, "refuted"),
    ("inequality", r"3.14159265358979323846264338327950288420 < \pi", None, "refuted"),
    ("inequality", r"\sin x \geq 0", r"0 \leq x \leq \frac{11\pi}{10}", "refuted"),
    ("inequality", r"\sin x > 0", r"0 < x \leq \pi", "refuted"),
    ("inequality", r"\cos x > -1", r"0 < x < 2\pi", "conditional"),
    ("inequality", r"\frac{\sin x}{x} > \frac{2}{\pi}", r"0 < x \leq \frac{\pi}{2}", "conditional"),
    ("inequality", r"\sin x \cos x > 0", r"0 < x < \frac{51\pi}{100}", "refuted"),
    # far out alone
    ("inequality", r"\arctan x < \frac{\pi}{2.0001}", None, "refuted"),
]
ARCS = r"\arctan x + \arctan\frac{1}{x}"
OPEN = [
    # without a value at an end, or anywhere
    ("inequality", r"\tan\frac{x}{2} \geq 0", r"0 \leq x \leq \pi"),
    ("inequality", r"\frac{1}{1 + \cos x} \geq 0", r"x = \pi"),
    ("inequality", r"\frac{1}{1 + \cos x} \geq 0", r"x \geq \pi, x \leq \pi"),
    ("identity", r"\sin(\frac{\pi}{6} + \frac{1}{x} - \frac{1}{x}) = \frac{1}{2}", "-1 < x < 1"),
    ("identity", r"\tan\frac{\pi}{2} = \tan\frac{\pi}{2}", None),
    (
        "identity",
        rf"{ARCS} + \frac{{1}}{{x - 7}} - \frac{{1}}{{x - 7}} = \frac{{\pi}}{{2}}",
        "x > 0",
    ),
    ("identity", rf"{ARCS} + 0\cdot\ln(x - 7) = \frac{{\pi}}{{2}}", "x > 0"),
    ("identity", r"\frac{x}{\sin\pi} = \frac{x}{\cos\frac{\pi}{2}}", None),
]
KINDS = (1, 6, 8, 11, 15, 19, 23, 26)


def claim(latex: str, domain: str | None) -> str:
    return f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else "")


@pytest.mark.parametrize(
    ("kind", "latex", "domain"), cases(TRUE, lambda case: TRUE.index(case) in KINDS)
)
def test_true(kind: str, latex: str, domain: str | None) -> None:
    found = judged(kind, claim(latex, domain))
    check(found, "proved")
    if found.certificate is not None and "statement" in found.certificate:
        assert replay(found.certificate, "proved") is None


@pytest.mark.parametrize(
    ("kind", "latex", "domain", "wanted"),
    cases(FALSE, lambda case: FALSE.index(case) in (0, 1, 6, 10, 11, 14)),
)
def test_false(kind: str, latex: str, domain: str | None, wanted: str) -> None:
    check(judged(kind, claim(latex, domain)), wanted)


@pytest.mark.parametrize(("kind", "latex", "domain"), OPEN)
def test_what_has_no_value_is_not_proved(kind: str, latex: str, domain: str | None) -> None:
    found = judged(kind, claim(latex, domain))
    if found.verdict in ("refuted", "conditional"):
        assert "no value" in found.reason
    else:
        assert found.verdict in ("held", "undecided"), found.reason


def test_a_domain_is_told_over_pi() -> None:
    found = judged("inequality", claim(r"\sin x > 0", r"0 < x < \pi"))
    assert found.domain == "0 < x/pi < 1"


def test_a_declared_letter_is_no_number() -> None:
    letter = {r"\pi": "{ unit = '1', domain = '\\pi > 4', meaning = 'a share' }"}
    check(judged("inequality", r"\pi > 4", letter), "proved")
    # one with a mark is another letter: whether the bare one is the number is not known then
    letter = {r"\pi_k": "{ unit = '1', meaning = 'a share' }"}
    for latex in (r"\pi > 3", r"\pi_j > 3"):
        with pytest.raises(ClaimFileError, match="not declared"):
            judged("inequality", latex, letter)


def test_a_mark_makes_another_letter_of_it() -> None:
    for latex in (r"\pi_j > 3", r"\pi_{0} > 3"):
        with pytest.raises(ClaimFileError, match="not declared"):
            judged("inequality", latex)


X = symbol("x")


def arc(x: Expr) -> Expr:
    return Expr("call", "atan", (x,))


@pytest.mark.parametrize(
    ("g", "box"),
    [
        # the slope is 0 where there is one, and the value jumps at 0
        (arc(X) + arc(1 / X) - PI / 2, Box()),
        (arc(X) + arc(1 / X) - PI / 2, Box(lower=Fraction(-1))),
        # one slope, another value
        (arc(X) + arc(1 / X) - PI / 3, Box(lower=Fraction(0))),
        # equal at a point, other slopes
        (arc(X) - X, Box()),
        (Expr("call", "sin", (PI * X,)), Box()),
    ],
)
def test_what_is_not_0_throughout_is_not_proved(g: Expr, box: Box) -> None:
    """Without a look at points, which would refute it."""
    decides = partial(freely, parameter=None, labels={})
    proves = inequalities._prover(
        None, lambda part, boxes, *_: decides(part, boxes), 3, {}, iter(range(20))
    )
    with pytest.raises(Undecided):
        by_slopes(Statement((Rel("=", g, number(0)),)), {"x": box}, proves)


ALL = Box()


def scaled_box(*conditions: Rel, box: Box = ALL) -> Box | None:
    statement = Statement((Rel(">", X, number(0)),), conditions)
    return scaled(statement, {"x": box}, {}).boxes.get("x/pi")


def test_bounds_are_put_together() -> None:
    below, up_to = Rel("<", X, PI), Rel(">=", PI, X)
    for conditions in ((below, up_to), (up_to, below)):
        box = scaled_box(*conditions)
        assert box is not None
        assert (box.upper, box.upper_open) == (Fraction(1), True)
    half = Rel("<=", X, PI / 2)
    for pair in ((half, below), (below, half), (half, half)):
        box = scaled_box(*pair)
        assert box is not None
        assert (box.upper, box.upper_open) == (Fraction(1, 2), False)
    above, from_there = Rel(">", X, -PI), Rel("<=", -PI, X)
    for conditions in ((above, from_there), (from_there, above)):
        box = scaled_box(*conditions, box=Box(upper=Fraction(0)))
        assert box is not None
        assert (box.lower, box.lower_open) == (Fraction(-1), True)
        assert box.upper == 0


@pytest.mark.parametrize(
    ("condition", "box"),
    [
        (Rel("<", X, PI), Box(integer=True)),
        (Rel("<", X, PI), Box(lower=Fraction(1))),
        (Rel("<", X, PI + 1), Box()),
        (Rel("<", X, PI * PI), Box()),
        (Rel("<", X, PI * symbol("y")), Box()),
        (Rel("<", 2 * X, PI), Box()),
        (Rel("!=", X, PI), Box()),
    ],
)
def test_other_domains_stay(condition: Rel, box: Box) -> None:
    assert scaled_box(condition, box=box) is None


@pytest.mark.parametrize("twelfths", cases(range(-25, 50), lambda twelfths: -2 < twelfths < 26))
def test_cosines_of_twelfths(twelfths: int) -> None:
    with mpmath.workdps(40):
        ball = Balls({}, 160).round(cosine_of(twelfths))
        assert (
            abs(
                mpmath.mpf(ball.mid().str(40, radius=False))
                - mpmath.cospi(mpmath.mpf(twelfths) / 12)
            )
            < mpmath.mpf(10) ** -36
        )


@pytest.mark.parametrize("name", ["sin", "cos", "tan"])
@pytest.mark.parametrize("twelfths", [-7, further(1), 3, 6, further(8), 12, further(29)])
def test_angles_with_twelfths_in_them(name: str, twelfths: int) -> None:
    angle = add(mul(number(Fraction(twelfths, 12)), PI), mul(number(3), symbol("x")))
    plain = Expr("call", name, (angle,))
    exact = exact_angles(plain)
    assert exact != plain
    balls = Balls({"x": Fraction(2, 7)}, 128)
    assert (balls.round(plain) - balls.round(exact)).abs_upper() < 2**-100


@pytest.mark.parametrize("angle", [mul(number(Fraction(1, 7)), PI), symbol("x")])
def test_other_angles_stay(angle: Expr) -> None:
    assert exact_angles(Expr("call", "sin", (angle,))) == Expr("call", "sin", (angle,))


def test_pi_lies_between_its_bounds() -> None:
    box = pi_box()
    assert box.lower is not None
    assert box.upper is not None
    with mpmath.workdps(60):
        low, high = (mpmath.mpf(x.numerator) / x.denominator for x in (box.lower, box.upper))
        assert low < mpmath.pi < high
        assert high - low < mpmath.mpf(10) ** -29


ENDS = [Fraction(n, 12) for n in range(-12, 13)]


@pytest.mark.parametrize("low", ENDS[::3])
@pytest.mark.parametrize("high", ENDS[::4])
def test_tangents_of_half_a_range_lie_in_it(low: Fraction, high: Fraction) -> None:
    turns = Box(lower=low, upper=high, lower_open=abs(low) == 1, upper_open=abs(high) == 1)
    if turns.is_empty or low >= high:
        return
    found = half_tangent_of_turns(turns)
    assert found is not None
    for k in range(1, 20):
        u = low + (high - low) * Fraction(k, 20)
        assert found.holds(Fraction(float(mpmath.tan(mpmath.pi * u.numerator / u.denominator / 2))))
    for end, bound, below in ((low, found.lower, True), (high, found.upper, False)):
        if bound is not None:
            with mpmath.workdps(50):
                there = mpmath.tan(mpmath.pi * end.numerator / end.denominator / 2)
                gap = (there - mpmath.mpf(bound.numerator) / bound.denominator) * (
                    1 if below else -1
                )
                assert -(mpmath.mpf(10) ** -45) < gap < mpmath.mpf(10) ** -11
    # as narrow as it can be told
    assert (found.lower is None) == (low == -1)
    assert (found.upper is None) == (high == 1)


def test_ranges_beyond_half_a_turn_have_none() -> None:
    assert half_tangent_of_turns(Box(lower=Fraction(0), upper=Fraction(3, 2))) is None
    assert half_tangent_of_turns(Box(lower=Fraction(0))) is None
