"""Integers among several parameters: real numbers first, integers only where these fail."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement

k, n, y = symbol("k"), symbol("n"), symbol("y")
zero = number(0)
POSITIVE = Box(lower=Fraction(0))
WHOLE = Box(lower=Fraction(1), lower_open=False, integer=True)


def judged(operator: str, left: Expr, right: Expr, box: Box = WHOLE) -> Outcome:
    statement = Statement((Rel(operator, left, right),))
    names = statement.symbols()
    return decide_in_cells(statement, {m: POSITIVE if m == "y" else box for m in names})


def test_real_numbers_are_enough() -> None:
    assert judged("<=", k + n, 2 * k * n).reason == "holds on the whole domain"


@pytest.mark.parametrize(
    ("left", "box"),
    [
        ((k - 1) * (k - 2) * y, WHOLE),
        ((k - 1) * (k - 2) * (k - 2) * (k - 3) * y, WHOLE),
        ((2 * k - 3) * (3 * k - 4) * (y + k), WHOLE),
        ((k * k - 2) * (2 * k * k - 3) * y, WHOLE),
        ((k - 2) * (k - 3) * y, Box(lower=Fraction(1), integer=True)),
        ((k - 1) * (k - 2) * y, Box(lower=Fraction(-5), upper=Fraction(7), integer=True)),
        ((k - 1) * (k - 2) * y, Box(integer=True)),
    ],
)
def test_failures_between_integers_do_not_count(left: Expr, box: Box) -> None:
    outcome = judged(">=", left, zero, box)
    assert outcome.verdict == "proved"
    assert "not for all real numbers" in outcome.reason


@pytest.mark.parametrize(
    ("operator", "left", "box"),
    [
        (">", (k - 1) * (k - 2) * y, WHOLE),
        (">=", (k - 1) * (k - 3) * y, WHOLE),
        (">=", (k - 99) * (k - 101) * y, WHOLE),
        (">=", (k - y) * (k - 2 - y), WHOLE),
        (">=", (k - 1) * (k - 2) * (100 - k) * y, WHOLE),
        (">", (k - 4) * (k - 5) * y, Box(lower=Fraction(5), lower_open=False, integer=True)),
    ],
)
def test_a_failing_integer_is_found(operator: str, left: Expr, box: Box) -> None:
    outcome = judged(operator, left, zero, box)
    assert outcome.verdict != "proved"
    assert outcome.witness is not None
    at = Fraction(outcome.witness.point["k"])
    assert at.denominator == 1
    assert box.holds(at)
