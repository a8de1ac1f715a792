"""Limits: exact, from the right side, never by numbers that look close."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, sqrt, symbol
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.work_limits import Undecided

x = symbol("x")
POSITIVE = Box(lower=Fraction(0))
REAL = Box()


@pytest.mark.parametrize(
    ("expr", "point", "value"),
    [
        (sqrt(x * x + x) - x, "infinity", number(Fraction(1, 2))),
        ((2 * x + 1) / (x + 1), "infinity", number(2)),
        (sqrt(2 * x * x + 1) / x, "infinity", sqrt(number(2))),
        (sqrt(2 * x * x + 1) / x, "-infinity", -sqrt(number(2))),
        (x * x, "infinity", "infinity"),
        (-x, "infinity", "-infinity"),
        ((sqrt(1 + x) - 1) / x, Fraction(0), number(Fraction(1, 2))),
        (1 / x, Fraction(0), "infinity"),
        (sqrt(x + sqrt(x)) - sqrt(x), "infinity", number(Fraction(1, 2))),
    ],
)
def test_true_limits(expr: Expr, point: Fraction | str, value: Expr | str) -> None:
    box = REAL if point == "-infinity" else POSITIVE
    assert decide_limit(expr, "x", box, point, value, "x").verdict == "proved"


@pytest.mark.parametrize(
    ("expr", "point", "value"),
    [
        (sqrt(x * x + x) - x, "infinity", number(Fraction(1, 2) + Fraction(1, 10**30))),
        (sqrt(2 * x * x + 1) / x, "infinity", number(Fraction(141421356237309505, 10**17))),
        (sqrt(2 * x * x + 1) / x, "infinity", -sqrt(number(2))),
        (x * number(Fraction(1, 10**40)), "infinity", number(0)),
        (x * x, "infinity", "-infinity"),
        (1 / x, "infinity", "infinity"),
    ],
)
def test_false_limits_are_refuted(expr: Expr, point: Fraction | str, value: Expr | str) -> None:
    outcome = decide_limit(expr, "x", POSITIVE, point, value, "x")
    assert outcome.verdict == "refuted"
    assert outcome.witness is not None


def test_both_sides_of_a_point_count() -> None:
    one_sided = sqrt(x * x) / x
    assert decide_limit(one_sided, "x", POSITIVE, Fraction(0), number(1), "x").verdict == "proved"
    assert decide_limit(one_sided, "x", REAL, Fraction(0), number(1), "x").verdict == "refuted"


def test_limit_near_a_rational_that_is_not_a_binary_fraction() -> None:
    close = Fraction(1, 3) + Fraction(1, 10**25)
    expr = number(close) + 1 / x
    assert decide_limit(expr, "x", POSITIVE, "infinity", number(close), "x").verdict == "proved"
    third = number(Fraction(1, 3))
    assert decide_limit(expr, "x", POSITIVE, "infinity", third, "x").verdict == "refuted"


def test_no_limit_where_there_is_no_value() -> None:
    with pytest.raises(Undecided, match="no value"):
        decide_limit(sqrt(1 - x), "x", POSITIVE, "infinity", number(0), "x")
    with pytest.raises(Undecided):
        decide_limit(x, "x", Box(lower=Fraction(0), upper=Fraction(1)), Fraction(5), number(5), "x")
