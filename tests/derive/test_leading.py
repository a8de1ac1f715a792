"""Leading terms of towers at both ends of a parameter, against numbers far out."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp

from gainproof.derive.algebra.leading_elements import NoLeadingTerm, edge, square_root
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real

X, R, F, G = (real(name) for name in ("x", "r", "f", "g"))


def _tower() -> Tower:
    return Tower(
        "trial",
        (Parameter("x"), Parameter("r")),
        (Generator("f", 8 * X**2 + (1 + R) ** 2), Generator("g", X**2 * R + X**2 + 2 * X * F)),
        {"ratio": F / G, "apart": F - X},
    )


@pytest.mark.parametrize("expression", [F, F * F / (X + R), (X + F) / (1 + X * F)])
@pytest.mark.parametrize("at_infinity", [False, True])
def test_the_leading_term_is_what_is_left_far_out(expression: sp.Expr, at_infinity: bool) -> None:
    tower = Tower("first", (Parameter("x"), Parameter("r")), _tower().generators[:1], {})
    found = edge(tower, at_infinity=at_infinity).of(tower.fraction(expression))
    with mp.workdps(60):
        x, r = mp.mpf(10) ** (30 if at_infinity else -30), mp.mpf("0.7")
        f = mp.sqrt(8 * x**2 + (1 + r) ** 2)
        value = sp.lambdify([X, R, F], expression, "mpmath")(x, r, f)
        coefficient = sp.lambdify([R], found.coefficient, "mpmath")(r)
        assert abs(value / (coefficient * x**found.order) - 1) < mp.mpf(10) ** -25


def test_a_half_power_has_no_whole_order() -> None:
    with pytest.raises(NoLeadingTerm, match="g has no integer order"):
        edge(_tower(), at_infinity=False)


def test_terms_that_may_cancel_have_no_leading_term() -> None:
    tower = Tower("first", (Parameter("x"), Parameter("r")), _tower().generators[:1], {})
    end = edge(tower, at_infinity=True)
    with pytest.raises(NoLeadingTerm, match="no plain sign"):
        end.of(tower.fraction(F - 3 * X))


def test_a_likely_root_saves_a_root_of_a_root() -> None:
    generators = (
        Generator("f", 1 + (1 + R) * X**2),
        Generator("g", (2 + R) * X**2 + 2 * X * F + 1),
    )
    tower = Tower("trial", (Parameter("x"), Parameter("r")), generators, {})
    plain, helped = (
        edge(tower, at_infinity=True, likely=likely) for likely in (None, {"g": X + F})
    )
    assert list(plain.end.constants) == ["root_of_f", "root_of_g"]
    assert list(helped.end.constants) == ["root_of_f"]
    wrong = edge(tower, at_infinity=True, likely={"g": 2 * X + F})
    assert wrong.end == plain.end


@pytest.mark.parametrize(
    "value", [sp.Integer(72), sp.Rational(8, 27), 18 * R**3 + 36 * R**2 + 18 * R]
)
def test_square_roots_are_taken_out(value: sp.Expr) -> None:
    outside, inside = square_root(value)
    assert sp.expand(outside**2 * inside - value) == 0
    assert all(power == 1 for _, power in sp.factor_list(inside)[1])
