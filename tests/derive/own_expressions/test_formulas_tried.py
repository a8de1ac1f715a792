"""Formulas that have no value at any point are refused: a test against them compares nothing."""

from __future__ import annotations

import pytest
import sympy as sp

from gainproof.derive.formulas import _Intervals
from gainproof.derive.formulas_tried import require_values

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
