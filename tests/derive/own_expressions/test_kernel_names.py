"""Kernels of a user whose names would clash in Python or C, and exponents without end."""

from __future__ import annotations

import pytest
import sympy as sp

from gainproof.derive.own_expressions.checks import require_written_well
from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.kernel_names import ENTRIES, TYPES, require_side_by_side
from gainproof.derive.printer.c_language.names import Names
from gainproof.derive.printer.c_language.real_types import FLAVOURS
from gainproof.derive.quantity import ONE, Quantity

X = Quantity("x", "x", "a number", ONE)


def given(expression: sp.Expr, *names: str) -> ExpressionSet:
    output = Result(Quantity("y", "y", "the value", ONE), expression)
    inputs = (Argument(X, "1/1000", "10"),)
    kernels = tuple(ExpressionKernel(name, "A title", inputs, (output,)) for name in names)
    return ExpressionSet("some-set", "A set", kernels)


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (("k", "k_array"), "both have the C function k_array"),
        (("k_float", "k"), "both have the C function k_float"),
        (("k", "k_values_float"), "both have the C function k_values_float"),
        (("x1_2", "x12"), "kernels x1_2 and x12 both have the class X12"),
        (("signature",), "cannot be called signature: Signature"),
        (("named_tuple",), "NamedTuple"),
        (("true",), "True"),
    ],
)
def test_names_that_clash(names: tuple[str, ...], message: str) -> None:
    with pytest.raises(ExpressionError, match=message):
        require_written_well(given(X.symbol + 1, *names))


def test_names_that_do_not() -> None:
    require_side_by_side(["k", "k_arrays", "kernel", "signatures", "x1_2"])


def test_the_endings_are_those_of_the_functions_in_c() -> None:
    names = Names("k", (), ())
    printed = {names.function(flavour, entry) for flavour in FLAVOURS for entry in ENTRIES}
    assert printed == {f"k{entry}{kind}" for entry in ENTRIES for kind in TYPES}


@pytest.mark.parametrize("exponent", [65, 100_000, -100_000, sp.Rational(100_001, 2)])
def test_exponents_have_an_end(exponent: sp.Expr) -> None:
    with pytest.raises(ExpressionError, match="exponents of at most 64 are wanted"):
        require_written_well(given(X.symbol**exponent, "k"))
    require_written_well(given(X.symbol**64, "k"))
