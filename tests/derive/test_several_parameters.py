"""Derivatives and entries of models over towers with several parameters, against numbers."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import pytest
import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.model_entries import matrix_of
from gainproof.derive.algebra.tower import Fraction, Generator, Parameter, Tower
from gainproof.derive.expression import ExpressionError, graph_of, real

P, Q, F, G = (real(name) for name in ("p", "q", "f", "g"))


def _tower() -> Tower:
    return Tower(
        "trial",
        (Parameter("p"), Parameter("q")),
        (Generator("f", 1 + P**2 * Q), Generator("g", Q + P * F, 3)),
        {"square": P**2, "mixed": F / G},
    )


def _number(tower: Tower, value: Fraction, p: Any, q: Any) -> Any:
    f = mp.sqrt(1 + p**2 * q)
    g = mp.cbrt(q + p * f)
    names = dict(zip((P, Q, F, G), (p, q, f, g), strict=True))
    return mp.mpmathify(
        sp.lambdify(list(names), tower.expression(value), "mpmath")(*names.values())
    )


@pytest.mark.parametrize("expression", [F, G, F * G / (P + Q), real("mixed") ** 2, P / G])
def test_partial_derivatives(expression: sp.Expr) -> None:
    tower = _tower()
    value = tower.fraction(expression)
    with mp.workdps(40):
        p, q = mp.mpf("0.7"), mp.mpf("1.3")
        by_p = mp.diff(lambda x: _number(tower, value, x, q), p)
        by_q = mp.diff(lambda x: _number(tower, value, p, x), q)
        for variable, wanted in (("p", by_p), ("q", by_q), ("square", by_p / (2 * p))):
            found = _number(tower, derivative(tower, expression, variable), p, q)
            assert abs(found - wanted) < mp.mpf(10) ** -15 * (1 + abs(wanted))


def test_an_element_of_two_parameters_is_no_variable() -> None:
    with pytest.raises(ValueError, match=r"depends on \['p', 'q'\], not on one"):
        derivative(_tower(), P, "mixed")


def test_entries_of_a_model_come_back() -> None:
    expression = (P**2 - Q / 3) / (1 + Q)
    found = matrix_of([["1/2", graph_of(expression)], [graph_of(-P), "0"]])
    assert found[0, 0] == sp.Rational(1, 2)
    assert sp.simplify(found[0, 1] - expression) == 0
    assert found[1, 0] == -P
    with pytest.raises(ExpressionError, match="made of arithmetic"):
        matrix_of([[graph_of(sp.Derivative(P * Q, P))]])
