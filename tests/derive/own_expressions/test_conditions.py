"""Conditions on several inputs: what they make provable, what is refused, what is asked."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from graph_kernels import module_of

from gainproof.derive.own_expressions.dimensions import require_units
from gainproof.derive.own_expressions.expressions import (
    Argument,
    Condition,
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FORMATS, Format
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.known_values import known_values
from gainproof.derive.quantity import METRE, ONE, Quantity
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.rechecking import expected_of, recheck

NAMES = "xyzw"
NUMBERS = {name: Quantity(name, name, "a number", ONE) for name in NAMES}
x, y, z, w = (NUMBERS[name].symbol for name in NAMES)
OUTPUT = Quantity("value", "v", "the value", ONE)
ALL = tuple(Argument(each, "1e-3", "10", signed=True) for each in NUMBERS.values())
NORM = x**2 + y**2 + z**2 + w**2
ACROSS, ALONG = 2 * (x * w + y * z), x**2 + y**2 - z**2 - w**2


def one(
    expression: sp.Expr,
    conditions: Sequence[Condition],
    inputs: Sequence[Argument] = ALL,
    by_terms: bool = True,
) -> ExpressionSet:
    used = set(sp.sympify(expression).free_symbols)
    kept = tuple(each for each in inputs if each.quantity.symbol in used)
    result = Result(OUTPUT, expression, by_terms)
    kernel = ExpressionKernel("kernel", "A title", kept, (result,), conditions=tuple(conditions))
    return ExpressionSet("some-set", "A set", (kernel,))


def made(given: ExpressionSet) -> Kernel:
    (found,) = derive_expressions(given).module.kernels
    return found


def run(kernel: Kernel) -> Callable[..., Any]:
    function: Callable[..., Any] = module_of(kernel)["kernel"]
    return function


APART = Condition(x**2 + y**2 > 0, "square of the distance")
FAR = Condition(sp.sqrt(x**2 + y**2) >= sp.Rational(1, 100), "distance")
TILTED = Condition(ACROSS**2 + ALONG**2 >= 400, "square of the level part")
CASES = [
    pytest.param(y / (x**2 + y**2), APART, (3.0, 4.0), 4 / 25, True, id="slope of a bearing"),
    pytest.param(y / (x**2 + y**2), FAR, (3.0, -4.0), -4 / 25, True, id="beside the distance"),
    pytest.param(
        (x * z + y * w) / sp.sqrt(x**2 + y**2), APART, (3, 4, 5, 0), 3.0, False, id="rate"
    ),
    pytest.param(sp.atan2(x, y), APART, (1.0, 1.0), math.pi / 4, True, id="bearing"),
    pytest.param(
        sp.atan2(z, sp.sqrt(x**2 + y**2)),
        Condition(NORM - w**2 > 0, "square of the range"),
        (0.0, 3.0, -3.0),
        -math.pi / 4,
        True,
        id="elevation off the origin",
    ),
    pytest.param(
        sp.atan2(ACROSS, ALONG),
        TILTED,
        tuple(5 * t for t in (math.cos(0.1), 0.0, 0.0, math.sin(0.1))),
        0.2,
        False,
        id="yaw",
    ),
    pytest.param(
        x / sp.sqrt(y**2 - x**2),
        Condition(x**2 < y**2, "difference of the squares"),
        (3.0, 5.0),
        0.75,
        True,
        id="a difference of squares",
    ),
    pytest.param(
        1 / (x * y - z),
        Condition(x * y > z + 2, "product less a number"),
        (2.0, 3.0, 1.0),
        0.2,
        True,
        id="what is not above 2 is refused",
    ),
]


@pytest.mark.parametrize(("expression", "condition", "at", "value", "tight"), CASES)
def test_what_a_condition_makes_provable(
    expression: sp.Expr,
    condition: Condition,
    at: tuple[float, ...],
    value: float,
    tight: bool,
) -> None:
    """Values by hand; `tight`: the error is relative to the value itself."""
    given = one(expression, [condition])
    kernel = made(given)
    (output,) = kernel.outputs
    assert output.by_terms is not tight
    (found,) = run(kernel)(*at)
    assert math.isclose(found, value, rel_tol=1e-14)
    with pytest.raises(ValueError, match=condition.meaning):
        run(kernel)(*(0.0 for _ in at))
    derived = plain_subject(derive_expressions(given))
    assert recheck(derived.certificate, expected_of(derived))["accepted"]


@pytest.mark.parametrize(("expression", "condition"), [case.values[:2] for case in CASES])
def test_without_it_there_is_no_kernel(expression: sp.Expr, condition: Condition) -> None:
    with pytest.raises(ExpressionError):
        made(one(expression, []))


def test_the_message_of_an_angle_says_which_condition_would_do() -> None:
    with pytest.raises(ExpressionError, match=r"the condition \(x\)\*\*2 \+ \(y\)\*\*2 > 0"):
        made(one(sp.atan2(x, y), []))


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        (Condition(sp.Ne(x, y), "a"), r"a relation with <, <=, >, >= or sp\.Eq is wanted"),
        (Condition(x, "a"), "a relation with"),
        (Condition(sp.Integer(1) > 0, "a"), "this one is always True"),
        (Condition(x**2 + 1 > 0, "a"), "this one is always True"),
        (Condition(x * y >= 0, "a"), r"write > or <"),
        (Condition(x * y >= z, "a"), r"write > or <"),
        (Condition(x * y + 1 <= z + 1, "a"), r"write > or <"),
        (Condition(x * y > sp.pi, "a"), "an exact number"),
        (Condition(x * y > 0.5, "a"), "an exact number"),
        (Condition(0.5 * x * y > z, "a"), "holds a float"),
        (Condition(sp.Eq(x**2 + y**2, 1), "a"), "rounded numbers are not equal"),
        (Condition(sp.Eq(x**2 + y**2, 1), "a", within=("1e-3",)), "within should be two"),  # type: ignore[arg-type]
        (Condition(x * y > 1, "a", single="b"), "a number as text, 'b' came"),
        (Condition(x * sp.Symbol("t") > 1, "a"), "the symbol t is of no input's quantity"),
        (Condition(x * y > 1, "a\nb"), "a line of text"),
        # its error is as large as what is required
        (Condition(x * y > z + sp.Rational(1, 10**12), "a"), "no small part of it; wanted: at"),
    ],
)
def test_what_is_no_condition_is_told(condition: Condition, message: str) -> None:
    with pytest.raises(ExpressionError, match=f"kernel: .*{message}"):
        made(one(x * y + z, [condition]))


def test_sides_have_one_unit() -> None:
    length = Argument(Quantity("q", "q", "a length", METRE), "1", "2")
    (kernel,) = one(x, [Condition(x > length.quantity.symbol, "a")]).kernels
    kernel = replace(kernel, inputs=(ALL[0], length))
    with pytest.raises(ExpressionError, match=r"kernel: condition 1: .* has the unit"):
        require_units(kernel)


def test_an_equality_holds_within_something_from_both_sides() -> None:
    unit = Condition(sp.Eq(NORM, 1), "square of the norm", within=("1e-9", "1e-4"))
    kernel = made(one(x * w + y * z, [unit]))
    assert float(run(kernel)(0.6, 0.0, 0.0, 0.8).value) == pytest.approx(0.48)
    for factor, said in ((1 - 1e-8, "must be at least 0.999999999"), (1 + 1e-8, "minus sign")):
        with pytest.raises(ValueError, match=said):
            run(kernel)(0.6 * factor, 0.0, 0.0, 0.8 * factor)
    single = np.array([0.6, 0.0, 0.0, 0.8 * (1 + 1e-6)], np.float32)
    assert run(kernel)(*single).value.dtype == np.float32
    # points for the tests of a package lie on it
    (points,) = (known_values(kernel, [prove(kernel, form)], "a")["points"] for form in FORMATS[:1])
    assert len(points["float64"]) >= 3
    for point in points["float64"]:
        assert abs(sum(t * t for t in point["at"]) - 1) < 1e-9


def scaled(power: int, least: float, value: Callable[..., float]) -> Callable[..., list[float]]:
    """Points times what brings a homogeneous value of that degree a little above `least`."""
    return lambda *at: [t * (least / value(*at)) ** (1 / power) * (1 + 1e-5) for t in at]


def level(p: float, q: float, r: float, s: float) -> float:
    return (2 * (p * s + q * r)) ** 2 + (p * p + q * q - r * r - s * s) ** 2


def turn(p: float, q: float, r: float, s: float) -> float:
    """Terms of the yaw: its magnitude, and what those of both legs turn it by."""
    over, under = 2 * (p * s + q * r), p * p + q * q - r * r - s * s
    most, norm = 2 * (abs(p * s) + abs(q * r)), p * p + q * q + r * r + s * s
    turned = most * abs(under) + norm * abs(over)
    return abs(math.atan2(over, under)) + turned / (over * over + under * under)


EXACT: Sequence[tuple[Any, ...]] = (
    # expression, condition, points next to the condition's end, terms where they cancel
    (y / (x**2 + y**2), FAR, scaled(1, 0.01, math.hypot), None),
    (sp.atan2(ACROSS, ALONG), TILTED, scaled(4, 400.0, level), turn),
    (
        x / sp.sqrt(y**2 - x**2),
        Condition(x**2 < y**2, "difference of the squares"),
        lambda p, _: [p, float(np.nextafter(np.float32(p), np.float32(9 * p)))],
        None,
    ),
    (
        1 / (x * y - z),
        Condition(x * y > z + 2, "product less a number"),
        lambda p, q, _: [p, q, (p * q - 2) * (1 - 1e-5)],
        None,
    ),
    (
        (x * z + y * w) / sp.sqrt(x**2 + y**2),
        APART,
        lambda p, q, r, _: [p, q, r, -p * r / q],
        lambda p, q, r, s: (abs(p * r) + abs(q * s)) / math.hypot(p, q),
    ),
)


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
@pytest.mark.parametrize(("expression", "condition", "near", "terms"), EXACT, ids=lambda _: "")
def test_no_error_is_above_its_bound(
    expression: sp.Expr,
    condition: Condition,
    near: Callable[..., list[float]],
    terms: Callable[..., float] | None,
    form: Format,
) -> None:
    """Against 60 digits, half of the points next to where the condition ends; the largest error is
    no small part of the bound.
    """
    kernel = made(one(expression, [condition]))
    (stated,), function = prove(kernel, form).outputs, run(kernel)
    draw, kind, worst, count = random.Random(form.name), np.dtype(form.name).type, 0.0, 0
    with mpmath.workdps(60):
        exact = sp.lambdify(
            [sp.Symbol(each.name, real=True) for each in kernel.inputs], expression, "mpmath"
        )
        for turn_of in range(600):
            at = [draw.choice([-1, 1]) * draw.uniform(0.01, 9) for _ in kernel.inputs]
            at = [float(kind(t)) for t in (near(*at) if turn_of % 2 else at)]
            if not all(1e-3 <= abs(t) <= 10 for t in at):
                continue
            try:
                found = function(*map(kind, at)).value
            except ValueError:
                continue
            count += 1
            true = exact(*map(mpmath.mpf, at))
            error = abs(mpmath.mpf(float(found)) - true)
            if expression.has(sp.atan2):
                error = min(error, abs(2 * mpmath.pi - error))
            scale = abs(true) if terms is None else terms(*at)
            allowed = scale * float(stated.bound) * form.epsilon * (1 + 1e-9) + stated.beside
            assert error <= allowed, (at, float(found), str(true))
            worst = max(worst, float(error / allowed))
    assert count > 100
    assert worst > 0.01
