"""Derivatives of formulas: one place takes them, and own results have them as results."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
import sympy as sp

import gainproof.derive
from gainproof.derive.algebra.derivative import along, by
from gainproof.derive.expression import real
from gainproof.derive.own_expressions.expressions import Result, derivatives
from gainproof.derive.quantity import METRE, ONE, SECOND, Quantity

HOME = Path(gainproof.derive.__file__).parent
TOWERS = "algebra/tower.py"
"""Takes a coefficient, with the derivative of what is linear."""
x, y = real("x"), real("y")


def test_nothing_else_differentiates() -> None:
    found = {
        path.relative_to(HOME).as_posix()
        for path in HOME.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Attribute) and node.attr == "diff"
    }
    assert found == {"algebra/derivative.py", TOWERS}


@pytest.mark.parametrize(
    ("value", "wanted"),
    [
        (sp.Abs(x - y), lambda a, b: 1 if a > b else -1),
        (x * sp.Abs(x), lambda a, _: 2 * abs(a)),
        (sp.sqrt(x**2 + y**2), lambda a, b: a / (a * a + b * b) ** 0.5),
        (sp.atan2(y, x), lambda a, b: -b / (a * a + b * b)),
        (sp.Abs(x * y) ** 3, lambda a, b: 3 * a * a * abs(b) ** 3 * (1 if a > 0 else -1)),
    ],
)
def test_derivatives_that_a_kernel_can_compute(value: sp.Expr, wanted: object) -> None:
    found = by(value, x)
    assert not found.has(sp.sign, sp.Derivative)
    for a, b in ((2.0, 3.0), (-0.5, 4.0), (7.0, -1.5), (-3.0, -2.0)):
        assert callable(wanted)
        assert float(found.subs({x: a, y: b})) == pytest.approx(wanted(a, b))


def test_rates_of_several_are_the_chain_rule() -> None:
    """x^2 y at (3, 5) with rates 7 and 11: 2 * 3 * 5 * 7 + 9 * 11."""
    rates = {x: sp.Integer(7), y: sp.Integer(11)}
    assert along(x**2 * y, rates).subs({x: 3, y: 5}) == 309


def test_a_jacobian_has_names_units_and_no_zeros() -> None:
    place = Quantity("x", "x", "a place", METRE)
    speed = Quantity("y", "y", "a velocity", METRE / SECOND)
    length = Result(Quantity("length", "l", "a length", METRE), sp.Abs(x))
    ratio = Result(Quantity("ratio", "q", "a time", SECOND), x / y, by_terms=True)
    found = derivatives((length, ratio), (place, speed))
    assert [each.quantity.name for each in found] == ["length_D_x", "ratio_D_x", "ratio_D_y"]
    assert [each.quantity.unit for each in found] == [ONE, SECOND / METRE, SECOND**2 / METRE]
    assert [each.by_terms for each in found] == [False, True, True]
    assert found[2].expression == -x / y**2
