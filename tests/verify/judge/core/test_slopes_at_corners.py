"""Derivatives where a factor has a corner and the product has none: x |x| rises with 2 |x|."""

from __future__ import annotations

from fractions import Fraction

import pytest
from small_claims import check, judged

from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, absolute, mul, number, power, symbol

X = symbol("x")
SIZE = absolute(X)


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        (r"x \left|x\right|) = 2 \left|x\right|", "proved"),
        (r"x \left|x\right|) = 2 x", "conditional"),
        (r"-x \left|x\right|) = -2 \left|x\right|", "proved"),
        (r"x^2 \left|x\right|) = 3 x \left|x\right|", "proved"),
        (r"x^2 \left|x\right|) = 2 x \left|x\right|", "refuted"),
        (r"x \left|x\right| y) = 2 \left|x\right| y", "proved"),
        (r"x \left|x\right| \sin x) = 2 \left|x\right| \sin x + x \left|x\right| \cos x", "proved"),
        (r"\left|x\right|^3) = 3 x \left|x\right|", "proved"),
        (r"\left|x\right|^2) = 2 x", "proved"),
        # no slope at 0
        (r"\left|x\right|) = \frac{x}{\left|x\right|}", "conditional"),
        (r"\left|x\right|) = 1", "conditional"),
        (r"y \left|x\right|) = \frac{x y}{\left|x\right|}", "conditional"),
        (r"x^{-1} \left|x\right|) = 0", "conditional"),
    ],
)
def test_around_the_corner(latex: str, wanted: str) -> None:
    claim = r"\frac{\partial}{\partial x} (" + latex
    check(judged("identity", f"latex = '{claim}'\ndomain = '-1 < x < 1'"), wanted)


def test_a_second_derivative_has_the_corner_back() -> None:
    claim = r"\frac{\partial^2}{\partial x^2} (x \left|x\right|) = 2 \frac{\left|x\right|}{x}"
    check(judged("identity", f"latex = '{claim}'\ndomain = '-1 < x < 1'"), "conditional")


@pytest.mark.parametrize(
    ("expr", "power_of_x"),
    [
        (mul(X, SIZE), 2),
        (mul(SIZE, X), 2),
        (mul(number(3), power(X, 4), SIZE), 5),
        (power(SIZE, 3), 3),
        (mul(power(SIZE, 5), X), 6),
    ],
)
def test_against_difference_quotients(expr: Expr, power_of_x: int) -> None:
    """Next to 0 these go with |x|^n, so that the quotient is exact there to order n - 1."""
    slope = differentiated(expr, "x")

    def at(value: Fraction, of: Expr = expr) -> Fraction:
        found = constant_value(substituted(of, {"x": number(value)}))
        assert found is not None
        return found

    step = Fraction(1, 10**9)
    for place in (Fraction(-3, 2), Fraction(1, 3), Fraction(2)):
        quotient = (at(place + step) - at(place - step)) / (2 * step)
        assert abs(quotient - at(place, slope)) < Fraction(1, 10**6)
    assert at(Fraction(0), slope) == 0
    assert abs(at(step) / step) <= 3 * step ** (power_of_x - 1)
