"""Formulas that have no value at any point are refused: a test against them compares nothing."""

from __future__ import annotations

import pytest
import sympy as sp
from mpmath import iv

from gainproof.derive.formula_values import require_values
from gainproof.derive.textbook_formulas import _Intervals

ATAN = _Intervals().doprint(sp.atan(sp.Symbol("x")))  # intervals have atan2 only
VALUES = {"k": {"points": {"float64": [{"at": [0.75]}, {"at": [3.5]}]}}}


def source(formula: str) -> str:
    return f"from mpmath import iv\n\ndef k(x):\n    return {{'y': iv.convert({formula})}}\n"


@pytest.mark.parametrize("formula", ["iv.log(x)", ATAN, "iv.sqrt(x - 2)", "x", "1/(x - 3.5)"])
def test_one_point_with_a_value_is_enough(formula: str) -> None:
    require_values(source(formula), VALUES)


@pytest.mark.parametrize(
    "formula", ["iv.log(x - 4) + iv.log(x - 5)", "iv.sqrt(-x)", "1/(x - x)", "1/iv.mpf(0)"]
)
def test_no_point_with_a_value_is_refused(formula: str) -> None:
    with pytest.raises(ValueError, match="k: its formulas have no real value"):
        require_values(source(formula), VALUES)


@pytest.mark.parametrize(
    ("power", "at", "value"),
    [("1/3", 27, 3), ("2/3", 27, 9), ("-1/3", 8, 0.5), ("5/6", 64, 32), ("3/4", 16, 8)],
)
def test_roots_are_of_their_own_order(power: str, at: int, value: float) -> None:
    text = _Intervals().doprint(sp.Symbol("x") ** sp.Rational(power))
    found = eval(text, {"iv": iv, "x": iv.mpf(at)})  # noqa: S307 (text that was just printed)
    assert value in found
    assert found.delta < 1e-12
