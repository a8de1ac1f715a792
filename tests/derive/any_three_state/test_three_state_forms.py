"""Forms of three states: what the search gives has one sign, and the roots are the spectrum's."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp
from own_models import own_model

from gainproof.derive.algebra.tower import Parameter, Tower, coupled
from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.model_numbers import shape_of
from gainproof.derive.any_three_state.names import ROOTS
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.own_model.choice import derive_own_model

Q = sp.Rational
FADING = [[1, 1, Q(9, 20)], [0, 1, Q(9, 10)], [0, 0, Q(3, 4)]]
LAST = sp.diag(0, 0, 1).tolist()


def context() -> Context:
    model = own_model(FADING, LAST)
    return Context(model, shape_of(model, scale_free(model)))


def roots_at(c: Context, index: float) -> dict[sp.Symbol, float]:
    """d0, ..., d3 from the zeros of g(s) g(-s) + q n(s), half of them, by mpmath."""
    with mp.workdps(40):
        sums = [
            mp.mpf(f.p) / f.q + mp.mpf(index) ** 2 * mp.mpf(n.p) / n.q
            for f, n in zip(c.shape.still, c.shape.shaken, strict=True)
        ]
        zeros = mp.polyroots(
            [-sums[3], 0, sums[2], 0, -sums[1], 0, sums[0]], maxsteps=500, extraprec=400
        )
        left = [zero for zero in zeros if mp.re(zero) < 0]
        assert len(left) == 3
        first, second, third = left
        scale = mp.sqrt(sums[3])
        found = (
            -first * second * third,
            first * second + first * third + second * third,
            -(first + second + third),
            mp.mpf(1),
        )
        return {d: float(mp.re(scale * value)) for d, value in zip(ROOTS, found, strict=True)}


def test_the_roots_solve_their_equations() -> None:
    c = context()
    for index in (0.01, 1.0, 300.0):
        d0, d1, d2, d3 = roots_at(c, index).values()
        sums = [float(f + index**2 * n) for f, n in zip(c.shape.still, c.shape.shaken, strict=True)]
        assert d0**2 == pytest.approx(sums[0], rel=1e-12)
        assert d1**2 == pytest.approx(sums[1] + 2 * d0 * d2, rel=1e-12)
        assert d2**2 == pytest.approx(sums[2] + 2 * d3 * d1, rel=1e-12)
        assert d1 * d2 >= 4 * d0 * d3


def test_no_form_of_correlated_acceleration_cancels() -> None:
    """Nor does one of a derivative; and each has the value of what it stands for."""
    c = context()
    values = {
        **c.quantities.gains(c.basis),
        **c.quantities.predicted_covariance(c.basis),
        **c.quantities.updated_covariance(c.basis),
    }
    assert [name for name, value in values.items() if not value.is_positive] == []
    assert [v for v in c.quantities.gain_derivatives(c.basis).values() if v.cancels] == []
    for name, value in values.items():
        assert c.tower.is_zero(value.value - real(name)), name


def test_a_tower_reduces_products_of_coupled_roots() -> None:
    """x^2 = 3 + 2 y, y^2 = 5 + 4 x: powers of both come down to 1, x, y and x y."""
    pair = coupled(("x", sp.Integer(3), sp.Integer(2)), ("y", sp.Integer(5), sp.Integer(4)))
    tower = Tower("pair", (Parameter("p"),), pair, {})
    x, y = mp.findroot(lambda x, y: (x**2 - 3 - 2 * y, y**2 - 5 - 4 * x), (3, 4))
    for expression in (real("x") ** 5, real("y") ** 4 * real("x") ** 3, real("x") ** 2):
        value = tower.fraction(expression).num
        assert max(value.degree(1), value.degree(2)) <= 1
        found = sum(
            float(c) * float(x) ** powers[1] * float(y) ** powers[2] for powers, c in value.terms()
        )
        wanted = expression.subs({real("x"): float(x), real("y"): float(y)})
        assert found == pytest.approx(float(wanted), rel=1e-9)


@pytest.mark.parametrize(
    ("transition", "message"),
    [
        (
            [[Q(24, 25), Q(7, 25), 0], [-Q(7, 25), Q(24, 25), 1], [0, 0, 1]],
            "coefficients of the spectrum that are not negative are in reach, f2 = ",
        ),
        ([[1, 1, 0], [0, 1, 1], [0, 0, 0]], "of three states a transition with an inverse"),
    ],
)
def test_out_of_reach(transition: list[list[sp.Expr]], message: str) -> None:
    with pytest.raises(ModelError, match=message):
        derive_own_model(own_model(transition, LAST))
