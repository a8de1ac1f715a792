"""Whatever a file of expressions holds, it is derived or refused in words."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp
from random_expressions import QUANTITIES, VALUE, X, broken, odd
from samples import samples

from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.printer.lost_digits import with_losses
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.quantity import ONE, Quantity


def answered(given: ExpressionSet) -> bool:
    """Whether it is derived; any error but a refusal is a failure."""
    try:
        kernels = derive_expressions(given).module.kernels
    except ExpressionError:
        return False
    for kernel, bounds in zip(kernels, prove_all(kernels), strict=True):
        with_losses(kernel, bounds)
    return True


@pytest.mark.sampled
@pytest.mark.parametrize(("draw", "least"), [(odd, 8), (broken, 2)])
def test_all_is_derived_or_refused(draw: Callable[[int], ExpressionSet], least: int) -> None:
    derived = 0
    for seed in range(samples(80)):
        try:
            given = draw(seed)
        except ValueError:  # SymPy cannot compare what was drawn
            continue
        derived += answered(given)
    assert derived >= least


@pytest.mark.parametrize("argument", ["x", "-x", "2*x"])
def test_an_angle_against_a_constant_is_a_right_one(argument: str) -> None:
    """atan2(a, 0) is pi/2 for positive a and -pi/2 for negative, by definition."""
    over = sp.sympify(argument, {"x": X})
    kernel = ExpressionKernel(
        "made",
        "An angle",
        (Argument(QUANTITIES["x"], "1", "2"),),
        (Result(VALUE, sp.atan2(over, 0)),),
    )
    assert answered(ExpressionSet("drawn", "A title", (kernel,)))


def test_a_number_of_python_is_an_expression() -> None:
    second = Quantity("one", "1", "a constant", ONE)
    kernel = ExpressionKernel(
        "made",
        "A title",
        (Argument(QUANTITIES["x"], "1", "2"),),
        (Result(VALUE, X + 1), Result(second, 1)),
    )
    assert answered(ExpressionSet("drawn", "A title", (kernel,)))
