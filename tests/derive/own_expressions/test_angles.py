"""Angles of a user's kernel where an argument of atan2 is 0: refused, or said."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from graph_kernels import module_of

from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.quantity import ONE, Quantity

Y, X = (Quantity(name, name, "a number", ONE) for name in "yx")
y, x = Y.symbol, X.symbol


def made(expression: sp.Expr, *inputs: Argument) -> Kernel:
    angle = Result(Quantity("angle", "a", "an angle", ONE), expression)
    kernel = ExpressionKernel("angle_of", "An angle", inputs, (angle,))
    (found,) = derive_expressions(ExpressionSet("some-set", "A set", (kernel,))).module.kernels
    return found


def signed(quantity: Quantity) -> Argument:
    return Argument(quantity, "1/1000", "10", signed=True)


def positive(quantity: Quantity, zero: bool = False) -> Argument:
    return Argument(quantity, "1/1000", "10", zero=zero)


@pytest.mark.parametrize(
    ("expression", "inputs"),
    [
        (sp.atan2(y, x), (signed(Y), signed(X))),
        (sp.atan2(y, -x), (positive(Y, True), positive(X, True))),
        (sp.atan2(y * x, y), (signed(Y), positive(X))),
        (sp.atan2(y - x, sp.Abs(y - x)), (positive(Y), positive(X))),
    ],
)
def test_of_two_zeros_there_is_none(expression: sp.Expr, inputs: tuple[Argument, ...]) -> None:
    """(-0.0, -0.0) gave -pi under a bound of 4.01 for the value 0."""
    with pytest.raises(ExpressionError, match="atan2 has no value where both"):
        made(expression, *inputs)


@pytest.mark.parametrize(
    ("expression", "inputs", "angle"),
    [
        (sp.atan2(y, -x), (signed(Y), positive(X)), -math.pi),
        (sp.atan2(sp.sqrt(y), -x), (positive(Y, True), positive(X)), -math.pi),
    ],
)
def test_where_the_sign_of_a_zero_decides_it_is_said(
    expression: sp.Expr, inputs: tuple[Argument, ...], angle: float
) -> None:
    kernel = made(expression, *inputs)
    assert any("the sign of the zero decides" in line for line in kernel.equations)
    assert module_of(kernel)["angle_of"](-0.0, 2.0).angle == angle
    assert module_of(kernel)["angle_of"](0.0, 2.0).angle == -angle


@pytest.mark.parametrize(
    ("expression", "inputs"),
    [
        (sp.atan2(y, x), (signed(Y), positive(X))),
        (sp.atan2(x, y), (signed(Y), positive(X))),
        (sp.atan2(x - y, x + y), (positive(Y), positive(X))),
    ],
)
def test_elsewhere_nothing_is_said(expression: sp.Expr, inputs: tuple[Argument, ...]) -> None:
    assert not any("zero" in line for line in made(expression, *inputs).equations)
