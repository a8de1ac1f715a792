"""Signs and zeros of functions on the triangle 0 < v < w < sqrt(3)."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol
from gainproof.verify.judge.exact.polynomial import Poly, ring
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.chart_decision import Plane
from gainproof.verify.judge.setting.chart_field import HIGH, LOW
from gainproof.verify.judge.setting.triangle_signs import sign_on_triangle

R = ring(("v", "w"))
v, w = R.gen(0), R.gen(1)
V, W, X = symbol(LOW), symbol(HIGH), symbol("x")
PLANE = Plane(("tracking_index", "S"))


def decided(rel: Rel, **positive: bool) -> str:
    boxes = {name: Box(lower=Fraction(0)) for name, known in positive.items() if known}
    return PLANE.decide(Statement((rel,)), boxes, {}).verdict


@pytest.mark.parametrize(
    ("p", "wanted"),
    [
        (w - v, 1),
        (3 - w**2, 1),
        (v * w - 3, -1),
        (3 - v**2, 1),
        (w - 1, None),
        (2 - w**2, None),
        (v - w**2, None),
        # zero at a corner of the triangle, and inside nowhere
        ((v * w - 3) ** 2 + 3 * (w - v) ** 2, 1),
        # the number just below the root of 3, and just above it
        (w - R.constant(1) * 17320508 / 10000000, None),
        (w - R.constant(1) * 17320509 / 10000000, -1),
    ],
)
def test_signs(p: Poly, wanted: int | None) -> None:
    assert sign_on_triangle(p, 0, 1) == wanted


def test_no_sign_is_said_that_a_point_contradicts() -> None:
    source, said = Random(1), 0
    for _ in range(400):
        p = sum(
            (source.randint(-9, 9) * v ** source.randint(0, 3) * w ** source.randint(0, 3))
            for _ in range(4)
        )
        if isinstance(p, int) or p.is_zero():
            continue
        sign = sign_on_triangle(p, 0, 1)
        if sign is None:
            continue
        said += 1
        for _ in range(30):
            high = Fraction(source.randint(1, 1731), 1000)
            low = high * Fraction(source.randint(1, 99), 100)
            value = p(*[_q(x) for x in (low, high)])
            assert (value > 0) == (sign > 0)
    assert said > 40


def _q(x: Fraction) -> object:
    import flint

    return flint.fmpq(x.numerator, x.denominator)


@pytest.mark.parametrize(
    ("left", "right", "wanted"),
    [
        (sqrt(power(W - V, 2)), W - V, "proved"),
        (sqrt(power(W - V, 2)), V - W, "refuted"),
        (sqrt(power(V * W - 3, 2)), 3 - V * W, "proved"),
        (sqrt(V * W) * sqrt(V / W), V, "proved"),
        (sqrt(12 * V) * sqrt(3 * V), 6 * V, "proved"),
        (sqrt(number(2)) * sqrt(number(6)), 2 * sqrt(number(3)), "proved"),
        (sqrt(V) + sqrt(W), sqrt(V + W), "refuted"),
        ((W - V) / (sqrt(W) - sqrt(V)), sqrt(W) + sqrt(V), "proved"),
        ((power(W, 2) - 1) / (W - 1), W + 1, "conditional"),
        (sqrt(power(X, 2) * V), X * sqrt(V), "proved"),
    ],
)
def test_equations(left: Expr, right: Expr, wanted: str) -> None:
    assert decided(Rel("=", left, right), x=True) == wanted


@pytest.mark.parametrize(
    ("left", "operator", "wanted"),
    [
        (sqrt(V) * X, ">", "proved"),
        (sqrt(W) - sqrt(V) * 0, ">", "proved"),
        (V - W, ">", "refuted"),
        (V - W, "<=", "proved"),
    ],
)
def test_orders(left: Expr, operator: str, wanted: str) -> None:
    assert decided(Rel(operator, left, number(0)), x=True) == wanted


@pytest.mark.parametrize(
    "rel",
    [
        Rel(">", W - 1, number(0)),
        Rel("=", sqrt(power(W - 1, 2)), W - 1),
        Rel("=", sqrt(sqrt(V) + 1), number(0)),
        Rel("=", sqrt(power(symbol("y"), 2)), symbol("y")),
        Rel(">", symbol("y"), number(0)),
        Rel("=", 1 / (V - V), number(0)),
    ],
)
def test_what_is_not_covered(rel: Rel) -> None:
    with pytest.raises(Undecided):
        decided(rel)


def test_roots_of_negative_numbers_have_no_value() -> None:
    with pytest.raises(Undecided, match="negative"):
        decided(Rel("=", sqrt(V - W), number(0)))
