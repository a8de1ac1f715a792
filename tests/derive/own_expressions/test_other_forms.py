"""Other forms over inputs of either sign: found, proved equal, with no value where none was."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from graph_kernels import module_of

from gainproof.derive.expression import real
from gainproof.derive.own_expressions.expressions import (
    Argument,
    Condition,
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.other_forms import conjugated
from gainproof.derive.own_expressions.parts import NotReadError, Parts
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.own_expressions.written_form import difference
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.quantity import ONE, Quantity
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.rechecking import expected_of, recheck

NAMES = "abxyzw"
NUMBERS = {name: Quantity(name, name, "a number", ONE) for name in NAMES}
a, b, x, y, z, w = (NUMBERS[name].symbol for name in NAMES)
FAR = Condition(sp.sqrt(x**2 + y**2) > sp.Rational(1, 10**6), "distance", single="1e-3")
R = sp.sqrt(x**2 + y**2)
APART = sp.sqrt((x - a) ** 2 + (y - b) ** 2)


def one(expression: sp.Expr, *conditions: Condition, low: str = "1e-3") -> ExpressionSet:
    used = expression.free_symbols
    inputs = tuple(
        Argument(each, low, "1e5", signed=True) for each in NUMBERS.values() if each.symbol in used
    )
    result = Result(Quantity("value", "v", "the value", ONE), expression)
    kernel = ExpressionKernel("kernel", "A title", inputs, (result,), conditions=conditions)
    return ExpressionSet("some-set", "A set", (kernel,))


def made(given: ExpressionSet) -> Kernel:
    (found,) = derive_expressions(given).module.kernels
    return found


def at(kernel: Kernel, *numbers: float) -> float:
    function: Callable[..., Any] = module_of(kernel)["kernel"]
    return float(function(*numbers).value)


@pytest.mark.parametrize(
    ("expression", "point"),
    [
        # stations at -a and a, at 0 and a, and five times one range against another
        (sp.sqrt((x - a) ** 2 + y**2 + 1) - sp.sqrt((x + a) ** 2 + y**2 + 1), (1.0, 0.1, 1e5)),
        (sp.sqrt(x**2 + 1) - sp.sqrt((x - a) ** 2 + 1) - a, None),
        (sp.sqrt(x**2 + 1) - sp.sqrt((x - a) ** 2 + 1), (1e-3, 1e5)),
        (5 * sp.sqrt(x**2 + 1) - sp.sqrt(25 * x**2 + 26), (1e4,)),
        (z * (sp.sqrt(x**2 + 2) - sp.sqrt(x**2 + 1)) / (a**2 + 1), (1.0, 1e5, 2.0)),
    ],
)
def test_differences_of_roots_lose_nothing(
    expression: sp.Expr, point: tuple[float, ...] | None
) -> None:
    """Against 50 digits where the formula as it is written keeps less than half of 16."""
    kernel = made(one(expression))
    assert kernel.outputs[0].by_terms is (point is None)
    if point is None:
        return
    names = [real(each.name) for each in kernel.inputs]
    with mpmath.workdps(50):
        exact = sp.lambdify(names, expression, "mpmath")(*map(mpmath.mpf, point))
        assert abs(at(kernel, *point) / exact - 1) < 1e-15
    assert abs(sp.lambdify(names, expression, "math")(*point) / exact - 1) > 1e-9
    derived = plain_subject(derive_expressions(one(expression)))
    assert recheck(derived.certificate, expected_of(derived))["accepted"]


def test_positive_inputs_have_the_forms_of_signed_ones() -> None:
    """x - a of two positive numbers is exact but for one rounding, which boxes do not see."""
    (kernel,) = one(sp.sqrt((x - a) ** 2 + y**2) - sp.sqrt((x + a) ** 2 + y**2)).kernels
    inputs = tuple(replace(each, signed=False) for each in kernel.inputs)
    found = made(replace(one(x), kernels=(replace(kernel, inputs=inputs),)))
    assert not found.outputs[0].by_terms
    with mpmath.workdps(50):
        roots = [mpmath.hypot(mpmath.mpf("0.1") + t, 1e5) for t in (-1, 1)]
        assert abs(at(found, 1.0, 0.1, 1e5) / (roots[0] - roots[1]) - 1) < 1e-14


def test_two_differences_in_one_sum() -> None:
    """Roots are paired so that what is left is short."""
    value = conjugated(sp.sqrt(x**2 + a) - sp.sqrt(y**2 + b) - sp.sqrt(x**2) + sp.sqrt(y**2))
    assert conjugated(value) == value
    found = conjugated(
        sp.sqrt(x**2 + 2) - sp.sqrt(y**2 + 3) - sp.sqrt(x**2 + 1) + sp.sqrt(y**2 + 5)
    )
    wanted = 1 / (sp.sqrt(x**2 + 2) + sp.sqrt(x**2 + 1)) + 2 / (
        sp.sqrt(y**2 + 5) + sp.sqrt(y**2 + 3)
    )
    assert sp.expand(found - wanted) == 0


@pytest.mark.parametrize("by", [x, y, a, b])
def test_a_derivative_is_one_fraction(by: sp.Symbol) -> None:
    """Of the range rate by a coordinate y (y a - x b)/r^3: by hand 3 (3 * 2 - 4 * 5)/125 at
    x = 4, y = 3, whose terms are smaller than those of a/r - x (x a + y b)/r^3.
    """
    kernel = made(one(sp.diff((x * a + y * b) / R, by), FAR))
    numbers = {"a": 2.0, "b": 5.0, "x": 4.0, "y": 3.0}
    wanted = {x: 3 * (3 * 2 - 4 * 5) / 125, y: 4 * (4 * 5 - 3 * 2) / 125, a: 4 / 5, b: 3 / 5}[by]
    found = at(kernel, *(numbers[each.name] for each in kernel.inputs))
    assert math.isclose(found, wanted, rel_tol=1e-15)
    assert kernel.outputs[0].by_terms is (by in (x, y))


def test_where_products_overflow_factors_are_divided_one_by_one() -> None:
    """-x z/(h r^2) is (x/h)(z/r)/r: in float32 h r^2 overflows at 1e15, and the value is 1e-15."""
    given = one(sp.diff(sp.atan2(z, R), x), FAR)
    (kernel,) = given.kernels
    inputs = tuple(replace(each, upper="1e15") for each in kernel.inputs)
    found = made(replace(given, kernels=(replace(kernel, inputs=inputs),)))
    single = (np.float32(t) for t in (3e14, 4e14, 1.2e15 / 5))
    value = float(module_of(found)["kernel"](*single).value)
    x_, y_, z_ = (float(np.float32(t)) for t in (3e14, 4e14, 1.2e15 / 5))
    wanted = -x_ * z_ / math.hypot(x_, y_) / (x_ * x_ + y_ * y_ + z_ * z_)
    assert math.isclose(value, wanted, rel_tol=1e-6)


@pytest.mark.parametrize(
    ("value", "most"),
    [
        # a component of the velocity across, twice over the range; its square over the range
        (sp.diff(((x - a) * z + (y - b) * w) / APART, x), 9.1),
        (sp.diff(sp.diff(APART, x), x), 7.6),
        (sp.diff(sp.diff(APART, x), y), 7.6),
        ((z**2 + w**2) / R - (x * z + y * w) ** 2 / R**3, 7.1),
    ],
)
def test_nothing_overflows_on_the_way(value: sp.Expr, most: float) -> None:
    """Of coordinates up to 1e60 (1e12 in float32) the squares of squares are no numbers of the
    format; the bounds are those of forms that were ordered by hand.
    """
    far = Condition(
        (APART if value.has(b) else R) >= sp.Rational(1, 10**20), "range", single="1e-6"
    )
    given = one(value, far)
    (kernel,) = given.kernels
    inputs = tuple(
        replace(each, lower="0", upper="1e60", single=("0", "1e9" if name in "zw" else "1e12"))
        for each in kernel.inputs
        for name in [each.quantity.name]
    )
    found = made(replace(given, kernels=(replace(kernel, inputs=inputs),)))
    for form in FORMATS:
        assert prove(found, form).outputs[0].bound <= most


@pytest.mark.parametrize(
    "expression",
    [(x**2 - y**2) / (x - y), 1 / (1 / x + 1 / y), (x - y) ** 2 / (x - y) ** 3 * (x - y)],
)
def test_no_value_is_printed_where_there_was_none(expression: sp.Expr) -> None:
    """x + y has one at x = y, where (x^2 - y^2)/(x - y) has none."""
    if expression.is_number:
        return
    with pytest.raises(ExpressionError, match="a division by what may be 0"):
        made(one(expression))


def test_no_value_is_printed_where_a_root_had_none() -> None:
    """(r + y)^2 - 2 y r with r = sqrt(x) is x + y^2, also where x < 0 and there is no r."""
    root = sp.sqrt(x)
    with pytest.raises(ExpressionError, match="the root of what may be negative"):
        made(one((root + y) ** 2 - 2 * y * root))
    angle = sp.atan2(x, y)
    with pytest.raises(ExpressionError, match="atan2 has no value"):
        made(one((angle + a) ** 2 - angle**2 - 2 * a * angle))
    # of a sum of squares there is one everywhere
    kernel = made(one((R + a) ** 2 - 2 * a * R))
    assert at(kernel, 3.0, 5.0, 12.0) == 9 + 25 + 144


def test_what_is_not_below_a_negative_number_may_be_zero() -> None:
    """x - y above -3 may be 0; above 0 it is not."""
    value = (x**2 - y**2) / (x - y)
    with pytest.raises(ExpressionError, match="a division by what may be 0"):
        made(one(value, Condition(x - y > -3, "difference")))
    kernel = made(one(value, Condition(x - y > 0, "difference")))
    assert at(kernel, 5.0, 3.0) == 8.0


def test_what_is_not_equal_is_not_shown() -> None:
    parts = Parts()
    same = parts.read(sp.sqrt(x**2 + 1) - sp.sqrt(y**2 + 1))
    other = parts.read((x**2 - y**2) / (sp.sqrt(x**2 + 1) + sp.sqrt(y**2 + 1)))
    known = list(parts.known.values())
    shown = difference(same - other, known)
    assert sp.expand(shown - (same - other)) == 0
    for wrong in (same - 2 * other, same + other, same * other, other):
        with pytest.raises(NotReadError, match="not shown to be equal"):
            difference(wrong, known)


def test_an_altered_form_is_rejected() -> None:
    given = one(sp.sqrt((x - a) ** 2 + 1) - sp.sqrt((x + a) ** 2 + 1))
    derived = plain_subject(derive_expressions(given))
    (step,) = (
        each for each in derived.certificate["statements"] if each["id"] == "form-kernel-value"
    )
    for node in step["claim"]["left"]["nodes"]:
        if node == ["number", "4"]:
            node[1] = "3"
    report = recheck(derived.certificate, expected_of(derived))
    assert not report["accepted"]
