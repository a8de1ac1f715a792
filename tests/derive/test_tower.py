"""Towers of radicals against numerical evaluation, and the forms that show signs."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from gainproof.derive.algebra.cofactors import NotInIdeal, cofactors
from gainproof.derive.algebra.positive_forms import NoPlainSign, is_positive_fraction, positive_form
from gainproof.derive.algebra.tower import Generator, Parameter, Tower, is_manifestly_positive
from gainproof.derive.expression import real

P, S, U = real("p"), real("s"), real("u")


def _tower() -> Tower:
    return Tower(
        "main",
        (Parameter("p"),),
        (Generator("s", P**2 + 2), Generator("u", S + P)),
        {"sum": P + S},
    )


def _value(expression: sp.Expr, p: float) -> float:
    s = math.sqrt(p * p + 2)
    point = {P: p, S: s, U: math.sqrt(s + p), real("sum"): p + s}
    return float(expression.subs(point))


@st.composite
def _expressions(draw: st.DrawFn) -> sp.Expr:
    value: sp.Expr = draw(st.sampled_from([P, S, U, real("sum"), sp.Integer(3), sp.Rational(1, 2)]))
    for _ in range(draw(st.integers(1, 5))):
        other = draw(st.sampled_from([P, S, U, sp.Integer(2), real("sum")]))
        value = draw(st.sampled_from([value + other, value * other, value - other, value / other]))
    return value


@given(_expressions(), st.fractions(Fraction(1, 10), 10))
def test_reduction_keeps_the_value(expression: sp.Expr, p: Fraction) -> None:
    tower = _tower()
    reduced = tower.expression(tower.fraction(expression))
    expected = _value(expression, float(p))
    # 1e-9: at most six operations on values of moderate size, some of them cancelling
    assert _value(reduced, float(p)) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_conjugates_show_a_sign() -> None:
    tower = _tower()
    form = positive_form(tower, S - P)
    assert is_positive_fraction(tower, form)
    assert tower.is_zero(tower.expression(form) - (S - P))
    with pytest.raises(NoPlainSign, match="negative"):
        positive_form(tower, P - S)
    with pytest.raises(NoPlainSign):
        positive_form(tower, S - 2)  # changes sign at p = sqrt(2)


def test_cofactors_recombine() -> None:
    tower = _tower()
    p, s, u = tower.ring.gens
    poly = (u**2 - s - p) * (p + 3) + (s**2 - p**2 - 2) * u
    parts = cofactors(tower, poly)
    relations = (s**2 - p**2 - 2, u**2 - s - p)
    assert sum((c * r for c, r in zip(parts, relations, strict=True)), tower.ring.zero) == poly
    with pytest.raises(NotInIdeal):
        cofactors(tower, poly + 1)


def test_a_closed_parameter_needs_a_term_without_it() -> None:
    tower = Tower("main", (Parameter("k", None, "2"),), (), {})
    (k,) = tower.ring.gens
    assert is_manifestly_positive(k - 1, tower.parameters)
    assert not is_manifestly_positive(k - 2, tower.parameters)  # zero at k = 2
    assert is_manifestly_positive(k**2 - 4 * k + 5, tower.parameters)
