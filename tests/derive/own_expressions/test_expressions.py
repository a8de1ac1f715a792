"""A user's expressions: what is wrong is told with its place, what is right is proved."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

from gainproof.derive.own_expressions.certificate_programs import held
from gainproof.derive.own_expressions.dimensions import unit_of
from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.graphs import graph_of_outputs
from gainproof.derive.own_expressions.parts import NotReadError, Parts
from gainproof.derive.own_expressions.program_match import require_instance
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.quantity import KILOGRAM, METRE, ONE, SECOND, Quantity, Unit
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.own_file import built, defined
from gainproof.subjects.rechecking import expected_of, recheck

GALLERY = Path(__file__).resolve().parents[3] / "docs" / "expressions"
LENGTH = Quantity("x", "x", "a length", METRE)
TIME = Quantity("t", "t", "a time", SECOND)
NUMBER = Quantity("n", "n", "a number", ONE)
x, t, n = LENGTH.symbol, TIME.symbol, NUMBER.symbol
PLACE = Argument(LENGTH, "1/1000", "1000")
MOMENT = Argument(TIME, "1/1000", "1000")
PURE = Argument(NUMBER, "1/1000", "10")
SPEED = METRE / SECOND
SIGNED = replace(PURE, signed=True)
OTHER = Argument(Quantity("m", "m", "another number", ONE), "1/1000", "10", signed=True)
ANOTHER = Argument(Quantity("x0", "x0", "another length", METRE), "1/1000", "1000")
m, x0 = OTHER.quantity.symbol, ANOTHER.quantity.symbol
LIGHT = Argument(Quantity("c", "c", "a speed", SPEED), "1", "1000")
SPEED_OF_LIGHT = LIGHT.quantity.symbol


def one(
    expression: Any, *inputs: Argument, unit: Unit = ONE, name: str = "kernel_1"
) -> ExpressionSet:
    """A set of one kernel with one output."""
    output = Result(Quantity("y", "y", "the value", unit), expression)
    kernel = ExpressionKernel(name, "A title", inputs, (output,))
    return ExpressionSet("some-set", "A set", (kernel,))


def accepted(given: ExpressionSet) -> bool:
    derived = plain_subject(derive_expressions(given))
    return bool(recheck(derived.certificate, expected_of(derived))["accepted"])


@pytest.mark.parametrize(
    "given",
    [
        one(x / t, PLACE, MOMENT, unit=SPEED),
        one(sp.sqrt(n + 1) - sp.sqrt(n), PURE),
        # what is left of it is a difference
        pytest.param(one(n**3 - 3 * n + 1, PURE), marks=pytest.mark.thorough),
        one(n**4 / (n + 1) ** 2 + sp.Rational(2, 7) / sp.sqrt(n), PURE),
        one(sp.exp(n) - 1, PURE),
        one(sp.log(1 + n), PURE),
        one(n * sp.sin(n) + sp.pi, Argument(NUMBER, "1/1000", "1", signed=True)),
        one(x - t * SPEED_OF_LIGHT, replace(PLACE, signed=True), MOMENT, LIGHT, unit=METRE),
    ],
    ids=lambda given: str(given.kernels[0].outputs[0].expression),
)
def test_expressions_are_proved(given: ExpressionSet) -> None:
    assert accepted(given)


@pytest.mark.parametrize("path", sorted(GALLERY.glob("*.py")), ids=lambda path: path.stem)
def test_the_gallery_is_proved(path: Path) -> None:
    derived = plain_subject(built(str(path), *defined(str(path))))
    assert recheck(derived.certificate, expected_of(derived))["accepted"]


def replaced(given: ExpressionSet, **changes: Any) -> ExpressionSet:
    """The set with its kernel changed."""
    return replace(given, kernels=(replace(given.kernels[0], **changes),))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (one(x + t, PLACE, MOMENT), "kernel_1: y: t has the unit s and x has m, in t + x"),
        (one(x / t, PLACE, MOMENT), "y should have the unit 1, its expression has m s^-1"),
        (one(sp.sin(x), PLACE), "x should have the unit 1, it has m, in sin(x)"),
        (one(n**x, PURE, PLACE), "a rational exponent is wanted"),
        (one(n + x / x, PURE, PLACE), "the input x occurs in no output"),
        (one(sp.Symbol("n") + 1, PURE), "the symbol n is of no input's quantity"),
        (one(0.5 * n, PURE), "holds a float"),
        (one("n", PURE), "an expression is wanted, 'n' came"),
        (one(sp.Eq(n, 1), PURE), "an expression is wanted"),
        (one(n, PURE, name="out"), "a name in small letters"),
        (one(n, PURE, name="lambda"), "a name in small letters"),
        (one(n, PURE, name="part_1"), "a name in small letters"),
        (one(n, Argument(NUMBER, "2", "1")), "its greatest above its least, it is 2 to 1"),
        (one(n, Argument(NUMBER, "-1", "1")), "signed=True makes it one of magnitudes"),
        (one(n, Argument(NUMBER, "a", "1")), "an end of a domain is a number as text"),
        (one(n, Argument(NUMBER, 1, "2")), "as text, 1 came"),  # type: ignore[arg-type]
        (one(n * x, PURE, Argument(LENGTH), unit=METRE), "needs a greatest number"),
        (one(n ** sp.Rational(1, 3), PURE), "a root of order 2, 4, 8, ... is wanted"),
        (one(sp.gamma(n), PURE), "are what a kernel computes, gamma(n) came"),
        (one(sp.sqrt(n - 20), PURE), "No other form helps"),
        (one(1 / n, Argument(NUMBER, "1/10", "1", signed=True)), "a division by what may be 0"),
        (
            one(n / (n**2 + x**2 / x0**2), SIGNED, replace(PLACE, signed=True), ANOTHER),
            (
                "kernel_1: n/(n**2 + x**2/x0**2): a division by what may be 0: n**2 + "
                "x**2/x0**2 is 0 "
                "where n = 0 and x = 0, and the domain admits that"
            ),
        ),
        (
            one(x / sp.sqrt(x**2 * n**2), SIGNED, replace(PLACE, signed=True)),
            "0 where n = 0 or x = 0",
        ),
        (
            one(1 / (n - 1), SIGNED),
            "1/(-1 + n): a division by what may be 0: -1 + n is 0 where -1 + n = 0",
        ),
        (
            one(sp.atan2(2 * n * m + 1, n**2 - m**2), SIGNED, OTHER),
            (
                "atan2 of an uncertain value: the terms of 1 + 2*m*n may cancel and the terms of "
                "n**2 - m**2 may cancel"
            ),
        ),
        (
            one(sp.sin(x / x0) / n, PLACE, ANOTHER, PURE),
            (
                "sin(x/x0): sin of a computed number: next to its zeros an error that "
                "x/x0 already has "
                "is no small part of it; wanted: x/x0 as an input of its own"
            ),
        ),
        (one(n + sp.Integral(m, (m, 0, n)), PURE), "the symbol m is of no input's quantity"),
        (one(sp.Matrix([n]), PURE), "an expression is wanted"),
        (replaced(one(n, PURE), title=7), "some-set: kernel 1, title should be of the type str, 7"),
        (replaced(one(n, PURE), inputs=(n,)), "inputs, number 1 should be of the type Argument, n"),
        (one(n, replace(PURE, single=("1",))), "single should be two ends of a domain"),  # type: ignore[arg-type]
        (one(sp.I * n, PURE), "are what a kernel computes, I came"),
        (one(n / (n - n + 1), PURE, PLACE), "the input x occurs in no output"),
        (one(n, PURE).__class__("s", "A set", ()), "a kernel at least is wanted"),
        (
            one(n, PURE).__class__("s", "A set", one(n, PURE).kernels[0]),  # type: ignore[arg-type]
            "s: kernels should be a tuple, it is of type ExpressionKernel",
        ),
        (
            replaced(one(n, PURE), inputs=PURE),
            "inputs should be a tuple, it is of type Argument; a tuple of one element is",
        ),
    ],
)
def test_each_mistake_is_told(given: ExpressionSet, message: str) -> None:
    with pytest.raises(ExpressionError) as caught:
        derive_expressions(given)
    assert message in str(caught.value)


def test_another_expression_is_not_what_is_printed() -> None:
    """The certificate of one kernel is refused for another, and so is one that is altered."""
    for first, second in (
        (sp.sqrt(n + 1) - sp.sqrt(n), sp.sqrt(n + 2) - sp.sqrt(n)),
        (n * sp.sqrt(n + 1), n * sp.sqrt(n + 2)),
        (sp.exp(3 * n) - 1, sp.exp(2 * n) - 1),
    ):
        own, other = (
            plain_subject(derive_expressions(one(each, PURE))) for each in (first, second)
        )
        assert recheck(own.certificate, expected_of(own))["accepted"]
        assert not recheck(own.certificate, expected_of(other))["accepted"]
        altered = deepcopy(own.certificate)
        nodes = [node for each in altered["programs"].values() for node in each["graph"]["nodes"]]
        number = next(node for node in nodes if node[0] == "number")
        number[1] = "17/3"
        assert not recheck(altered, expected_of(own))["accepted"]


def graph(name: str, value: Callable[[GraphBuilder], Node]) -> Graph:
    builder = GraphBuilder()
    return builder.graph({name: value(builder)})


def test_what_is_printed_is_what_was_proved() -> None:
    kinds = {"e": "growth", "f": "decay"}
    proved = {
        "y": graph("y", lambda b: (1 + 1 * b.symbol("e")) * (1 + -1 * b.symbol("f"))),
        "e": graph("e", lambda b: b.symbol("a")),
        "f": graph("f", lambda b: b.symbol("a") + 1),
    }

    def require(value: Callable[[GraphBuilder, Node], Node]) -> None:
        require_instance(graph("y", lambda b: value(b, b.symbol("a"))), "y", proved, kinds)

    require(lambda b, a: b.call("exp", a) * b.call("exp", -(a + 1)))
    for wrong in (
        lambda b, a: b.call("exp", a) + b.call("exp", -(a + 1)),
        lambda b, a: b.call("exp", a) * b.call("exp", a + 1),
        lambda b, a: b.call("exp", a) * b.call("exp", -(a + 2)),
        lambda b, a: b.call("exp", a) * b.call("exp", -a),
        lambda b, a: b.call("expm1", a) * b.call("exp", -(a + 1)),
    ):
        with pytest.raises(ValueError, match="is printed, the certificate has"):
            require(wrong)
    proved["y"] = graph("y", lambda b: b.symbol("e") + (1 + 1 * b.symbol("e")))
    with pytest.raises(ValueError, match="is printed, the certificate has"):
        require(lambda b, a: b.call("expm1", a) + b.call("exp", a + 1))


@pytest.mark.parametrize(
    "expression",
    [
        1 - sp.cos(n),
        (1 - sp.cos(n)) / sp.sin(n),
        (1 - sp.exp(-n)) * sp.sqrt(n),
        # 1 + 7/5 expm1(n) is no exp(n)
        (n - 2) * (n - 3) * sp.exp(n) - 1,
        sp.log(1 + sp.exp(-n)),
    ],
    ids=str,
)
def test_functions_stand_for_what_was_proved_of_them(expression: sp.Expr) -> None:
    upper = "1" if expression.has(n - 3) else "3"
    assert accepted(one(expression, Argument(NUMBER, "1/2", upper)))


@pytest.mark.parametrize("name", ["root_1", "x_above", "y_growth_1", "y_required_1", "out_1"])
def test_names_of_inputs_are_none_of_a_certificate(name: str) -> None:
    other = Quantity(name, name, "a number", ONE)
    assert accepted(
        one(
            (sp.exp(n) - 1) * (sp.sqrt(other.symbol + n + 1) - sp.sqrt(n)),
            PURE,
            Argument(other, "1/2", "2"),
        )
    )


@pytest.mark.parametrize(
    "name", ["workers", "accurate", "out", "value", "np", "lambda", "iv", "abs"]
)
def test_names_that_are_taken_are_refused(name: str) -> None:
    other = Quantity(name, name, "a number", ONE)
    with pytest.raises(ExpressionError, match=name):
        derive_expressions(one(other.symbol + 1, Argument(other, "1/2", "2")))


@pytest.mark.parametrize("end", ["1e999999999", "1E-999999999", "ten", "1/0"])
def test_ends_of_domains_that_are_no_numbers_are_refused(end: str) -> None:
    with pytest.raises(ExpressionError, match="an end of a domain is a number as text"):
        derive_expressions(one(n + 1, Argument(NUMBER, "1/2", end)))


@pytest.mark.parametrize("lower", ["1e-6", "0"])
def test_a_domain_with_one_end_of_the_only_input(lower: str) -> None:
    with pytest.raises(ExpressionError, match="with both ends is wanted") as caught:
        derive_expressions(one(sp.exp(-n), Argument(NUMBER, lower)))
    assert str(caught.value).count("ends") == 1
    assert "several" not in str(caught.value)


def test_parts_are_symbols_in_a_certificate() -> None:
    parts = Parts()
    read = parts.read(n / sp.sqrt(n + 1) ** 3 + 1 / (n * (n + 2)))
    kept = held(graph_of_outputs({"y": read}, parts))
    assert all(node[0] in ("symbol", "number", "add", "mul") for node in kept["nodes"])
    assert set(kept["outputs"]) > {"y"}
    with pytest.raises(NotReadError, match="gamma"):
        parts.read(sp.gamma(n))


@pytest.mark.parametrize(
    ("expression", "unit"),
    [
        (x**2 / t, Unit(Fraction(2), Fraction(-1))),
        (sp.sqrt(x / t**2), Unit(Fraction(1, 2), Fraction(-1))),
        (sp.atan2(x, 2 * x), ONE),
        (sp.Abs(x) + x, METRE),
        (sp.pi * 3, ONE),
    ],
)
def test_units(expression: sp.Expr, unit: Unit) -> None:
    assert unit_of(expression, {x: METRE, t: SECOND}) == unit


def test_units_are_written_in_the_usual_order() -> None:
    assert str(KILOGRAM * METRE**2 / SECOND**3) == "m^2 s^-3 kg"
