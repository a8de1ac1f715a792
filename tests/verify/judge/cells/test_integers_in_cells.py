"""Integers among several parameters: real numbers first, integers only where these fail."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Nowhere, Undecided

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


T = Box(Fraction(0), Fraction(1))
"""What may be above a whole part."""


def _with_parts(left: Expr, right: Expr, conditions: tuple[Rel, ...], sides: str) -> Outcome:
    boxes = {**{m: Box(integer=True) for m in "kn"}, **dict.fromkeys(sides, T)}
    return decide_in_cells(Statement((Rel(">", left, right),), conditions), boxes)


def test_an_integer_for_which_the_conditions_never_hold_says_nothing_of_others() -> None:
    """n = k where t > s, for all integers; the conditions may leave no k beside one n."""
    t, s = symbol("t"), symbol("s")
    found = _with_parts(n, k, (Rel(">", n + t, k + s),), "st")
    assert found.verdict == "conditional"
    assert found.witness is not None
    point = found.witness.point
    assert point["n"] == point.get("k", "0")


def test_conditions_that_hold_for_no_integer_hold_nowhere() -> None:
    t = symbol("t")
    with pytest.raises(Nowhere):
        _with_parts(n, k, (Rel("<", k, n + t), Rel("<", n + t + 3, k)), "t")


EIGHT = Box(Fraction(1), Fraction(8), lower_open=False, upper_open=False, integer=True)
SHOWN = (Rel("!=", k * n, number(35)), Rel("<=", k * n, number(62)), Rel("!=", k * k * n, k + 69))


@pytest.mark.parametrize("rel", [*SHOWN, Rel("!=", k * n * n, number(63))])
def test_few_pairs_of_integers_are_tried_one_by_one(rel: Rel) -> None:
    found = judged(rel.operator, rel.left, rel.right, EIGHT)
    holds = {"!=": int.__ne__, "<=": int.__le__}[rel.operator]

    def value(side: Expr, at: dict[str, int]) -> int:
        filled = constant_value(substituted(side, {m: number(v) for m, v in at.items()}))
        assert filled is not None
        return int(filled)

    def is_true(a: int, b: int) -> bool:
        at = {"k": a, "n": b}
        return holds(value(rel.left, at), value(rel.right, at))

    true = all(is_true(a, b) for a in range(1, 9) for b in range(1, 9))
    assert (found.verdict == "proved") == true
    if not true:
        assert found.witness is not None
        assert not is_true(*(int(found.witness.point[m]) for m in "kn"))


@pytest.mark.parametrize("value", [37, 59])
def test_more_pairs_are_not_tried(value: int) -> None:
    """Both are primes beyond 9, which no such pair has as its product."""
    nine = replace(EIGHT, upper=Fraction(9))
    assert judged("!=", k * n, number(value), EIGHT).verdict == "proved"
    with pytest.raises(Undecided, match="whether for integers"):
        judged("!=", k * n, number(value), nine)


def test_a_real_number_beside_pairs_of_integers() -> None:
    assert judged(">", (k * n - 37) * (k * n - 37) * y, zero, EIGHT).verdict == "proved"
    found = judged(">", (k * n - 35) * (k * n - 35) * y, zero, EIGHT)
    assert found.witness is not None
    assert sorted(found.witness.point[m] for m in "kn") == ["5", "7"]
    assert "y" in found.witness.point
