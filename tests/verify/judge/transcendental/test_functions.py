"""Exponentials, angles and symbolic powers: freed to prove, never to refute."""

from __future__ import annotations

import pytest
from small_claims import check, judged

TRUE = [
    r"\sin^2 \theta + \cos^2 \theta = 1",
    r"\sin(2\theta) = 2 \sin\theta \cos\theta",
    r"\cos(\theta + \phi) = \cos\theta \cos\phi - \sin\theta \sin\phi",
    r"\cos\frac{\theta}{2} \sin\frac{\theta}{2} = \frac{\sin\theta}{2}",
    r"\tan\theta = \frac{\sin\theta}{\cos\theta}",
    r"\cosh^2 x - \sinh^2 x = 1",
    r"e^{x+y} = e^x e^y",
    r"e^{-\frac{x^2}{2}} e^{-\frac{x^2}{2}} = e^{-x^2}",
    r"c^{n+1} c^{n-1} = c^{2n}",
    r"4^n = 2^n \cdot 2^n",
    r"(-1)^{2n} = 1",
    r"e^{n \log 2} = 2^n",
    r"(e^{-x})^2 = e^{-2 x}",
    r"(2^x)^y = 2^{x y}",
    r"(2^{\frac{1}{x}})^x = 2",
    r"(a b)^n = a^n b^n",
    r"\frac{\partial}{\partial x} e^{-a x} = -a e^{-a x}",
    r"\frac{\partial}{\partial \theta} (x \cos\theta) = -x \sin\theta",
]
FALSE = [
    r"\sin(2\theta) = \sin\theta \cos\theta",
    r"\sin^2 \theta - \cos^2 \theta = 1",
    r"e^{x y} = e^x e^y",
    r"c^{n+1} = c^{n-1}",
    r"(-1)^n = 1",
    r"e^{n \log 2} = 2 n",
    r"(2^x)^y = 2^{x + y}",
    r"(a + b)^n = a^n + b^n",
    r"\cosh^2 x + \sinh^2 x = 1",
    r"\frac{\partial}{\partial x} e^{-a x} = e^{-a x}",
    # the common part of the exponents is x/50000000000
    r"e^{2.00000000002 x} = (e^x)^2",
    # false for y > 400 only
    r"x \cos y + \left|y - 400\right| + y - 400 = x \cos y",
]


@pytest.mark.parametrize("latex", TRUE)
def test_true(latex: str) -> None:
    check(judged("identity", latex), "proved")


@pytest.mark.parametrize("latex", FALSE)
def test_false(latex: str) -> None:
    check(judged("identity", latex), "refuted")


@pytest.mark.parametrize(
    ("fields", "wanted"),
    [
        ("e^x > 0", "proved"),
        ("latex = 'e^{-x} < 1'\ndomain = 'x > 0'", "proved"),
        ("latex = '1 - e^{-x} > 0'\ndomain = 'x > 0'", "proved"),
        ("latex = 'c^n < 1'\ndomain = '0 < c < 1, n \\geq 1'", "proved"),
        (r"\cos\theta \leq 1", "proved"),
        ("latex = '\\cos\\theta \\geq \\frac{1}{2}'\ndomain = '-1 < \\theta < 1'", "proved"),
        ("latex = '\\cos\\theta \\geq \\frac{3}{5}'\ndomain = '-1 < \\theta < 1'", "refuted"),
        ("latex = '\\cos\\theta > \\frac{1}{2}'\ndomain = '-1 < \\theta < 1'", "proved"),
        (r"\cos\theta + \sin\phi < 3", "proved"),
        (r"(\cos\theta + 2)^2 \neq 0", "proved"),
        # the one angle that the half tangent misses: equality holds only there
        (r"\cos\theta > -1", "conditional"),
        ("e^x > 1", "refuted"),
        (r"\cos\theta \leq \frac{1}{2}", "refuted"),
        # by the arguments of both exponentials
        ("latex = 'x^x \\geq e^{x-1}'\ndomain = 'x > 0'", "proved"),
    ],
)
def test_orders(fields: str, wanted: str) -> None:
    check(judged("inequality", fields), wanted)


@pytest.mark.parametrize(
    "fields",
    [
        "latex = 'c^{-n} c^{n} = 1'\ndomain = '-1 < c < 1'",
        r"\log x = \log x \quad (x > -1)",
        "O(x) - O(x) = 0",
        "latex = '\\tan\\theta \\cos\\theta = \\sin\\theta'\ndomain = '0 < \\theta < 3'",
        "latex = 'e^{\\frac{1}{x}} = e^{\\frac{1}{x}}'\ndomain = '-1 < x < 1'",
        "latex = '(2^{\\frac{1}{x}})^x = 2'\ndomain = '-1 < x < 1'",
        "latex = '\\sin\\frac{1}{x} = \\sin\\frac{1}{x}'\ndomain = '-1 < x < 1'",
    ],
)
def test_what_may_have_no_value_is_not_proved(fields: str) -> None:
    assert judged("identity", fields).verdict != "proved"
