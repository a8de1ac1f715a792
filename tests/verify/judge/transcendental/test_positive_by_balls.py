"""Balls over pieces of an interval, and intervals in parts: what they show, and what they may not.

What is asked for here is known by calculus: the least values stand beside the cases.
"""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from one_of_each import further

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental import decision, inequalities
from gainproof.verify.judge.transcendental.constant_folding import plain
from gainproof.verify.judge.transcendental.failing_points import equal_somewhere
from gainproof.verify.judge.transcendental.lowest_points import lowest
from gainproof.verify.judge.transcendental.positive_by_balls import Pieces, by_pieces, seen_above

X, ZERO = symbol("x"), number(0)


def call(name: str, x: Expr) -> Expr:
    return Expr("call", name, (x,))


EXP, LOG, SIN, COS = (call(name, X) for name in ("exp", "log", "sin", "cos"))
LEAST = X * X - LOG
"""Least at 1/sqrt(2): 1/2 + ln(2)/2 = 0.846573590..."""


@pytest.mark.parametrize(
    ("g", "lower", "upper", "wanted"),
    [
        (LEAST - number(Fraction("0.8465")), Fraction(1, 10), Fraction(3), True),
        (LEAST - number(Fraction("0.846573")), Fraction(1, 10), Fraction(3), True),
        (LEAST - number(Fraction("0.846574")), Fraction(1, 10), Fraction(3), False),
        # 0 at an end, and beyond it below 0
        (SIN, Fraction(0), Fraction(3), False),
        (SIN, Fraction(1, 100), Fraction(3), True),
        (SIN, Fraction(1, 100), Fraction(22, 7), False),
        # no value somewhere, though above 0 everywhere else
        (1 / (X * X), Fraction(-1), Fraction(1), False),
        (1 / power(X - number(Fraction(1, 3)), 2), Fraction(0), Fraction(1), False),
        (EXP + LOG - LOG, Fraction(-1), Fraction(1), False),
        (2 + call("tan", X) * call("tan", X), Fraction(0), Fraction(3), False),
        (1 + power(X, Fraction(1, 2)), Fraction(-2), Fraction(-1), False),
        (1 + power(X, Fraction(1, 2)), Fraction(1, 9), Fraction(2), True),
        # one point
        (COS, Fraction(1), Fraction(1), True),
        (COS, Fraction(2), Fraction(2), False),
    ],
)
def test_above_0_on_pieces(g: Expr, lower: Fraction, upper: Fraction, wanted: bool) -> None:
    assert (seen_above(g, "x", lower, upper) is not None) is wanted


@pytest.mark.parametrize(
    ("operator", "box", "wanted"),
    [
        (">", Box(Fraction(1, 100), Fraction(3)), True),
        (">=", Box(Fraction(1, 100), Fraction(3)), True),
        ("<", Box(Fraction(1, 100), Fraction(3)), False),
        ("<", Box(Fraction(-3), Fraction(-1, 100)), True),
        (">", Box(Fraction(1, 100)), False),
        (">", Box(upper=Fraction(3)), False),
        ("!=", Box(Fraction(1, 100), Fraction(3)), False),
    ],
)
def test_an_inequality_on_a_bounded_interval(operator: str, box: Box, wanted: bool) -> None:
    found = by_pieces(Rel(operator, SIN, ZERO), box)
    assert (found is not None) is wanted
    if isinstance(found, Pieces):
        assert (found.lower, found.upper) == (box.lower, box.upper)


def test_two_symbols_are_not_looked_at() -> None:
    assert by_pieces(Rel(">", EXP + symbol("y"), ZERO), Box(Fraction(0), Fraction(1))) is None


HALF = number(Fraction(1, 2))


@pytest.mark.alike
@pytest.mark.parametrize(
    ("rel", "box", "conditions", "wanted"),
    [
        # 0.846573...: above 0 far out, at both ends and at every simple point
        (Rel(">", LEAST, number(Fraction("0.84657"))), Box(Fraction(0)), (), True),
        (Rel(">", LEAST, number(Fraction("0.84658"))), Box(Fraction(0)), (), False),
        further(Rel("<", -LEAST, number(Fraction("-0.84657"))), Box(Fraction(0)), (), True),
        # falls below 0 beyond 64
        (Rel(">", number(100) - LOG * 20, ZERO), Box(Fraction(1)), (), False),
        (Rel(">", COS + number(Fraction(999, 1000)), ZERO), Box(), (), False),
        # 0 at 0 and above 0 beside it
        (Rel(">=", EXP - 1 - SIN, ZERO), Box(Fraction(0), lower_open=False), (), True),
        (Rel(">", EXP - 1 - SIN, ZERO), Box(Fraction(0), lower_open=False), (), False),
        # below 0 between the simple points 0 and 1, where it is 0
        (Rel(">=", X * (X - 1) * EXP, ZERO), Box(Fraction(0), lower_open=False), (), False),
        # below 0 on the one side of a simple point where it is 0
        (Rel(">=", (X - 1) * EXP, ZERO), Box(Fraction(0)), (), False),
        (Rel(">=", (1 - X) * EXP, ZERO), Box(Fraction(0)), (), False),
        (Rel(">=", power(X - 1, 2) * EXP, ZERO), Box(Fraction(0)), (), True),
        # another symbol
        (Rel(">", LEAST + symbol("y") * EXP, ZERO), Box(Fraction(0)), (), False),
        # without a number: both sides are asked
        (Rel(">", X * X * EXP, ZERO), Box(), (Rel("!=", X, ZERO),), True),
        (Rel(">", X * EXP, ZERO), Box(), (Rel("!=", X, ZERO),), False),
        (Rel(">", -X * EXP, ZERO), Box(), (Rel("!=", X, ZERO),), False),
        further(Rel(">", X * X * EXP, ZERO), Box(), (Rel("!=", X, HALF),), False),
        (Rel(">", COS - 1 + X * X * HALF, ZERO), Box(), (Rel("!=", X, ZERO),), True),
        further(Rel(">", COS - 1 + X * X * HALF, ZERO), Box(), (Rel("!=", X, number(1)),), False),
        # a condition of another kind is not read as this one
        (Rel(">", LEAST, HALF), Box(Fraction(0)), (Rel("!=", X * X, number(1)),), False),
    ],
)
def test_an_interval_in_parts(
    rel: Rel,
    box: Box,
    conditions: tuple[Rel, ...],
    wanted: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What is false is not proved even where no point is tried before."""
    statement = Statement((rel,), conditions)
    assert (_verdict(statement, box) == "proved") is wanted
    monkeypatch.setattr(decision, "try_points", lambda *_, **__: None)
    monkeypatch.setattr(inequalities, "try_points", lambda *_, **__: None)
    assert wanted or _verdict(statement, box) != "proved"


def _verdict(statement: Statement, box: Box) -> str:
    try:
        return decision.decided(statement, {"x": box, "y": Box()}, None, {}).verdict
    except Undecided:
        return "undecided"


def test_an_equality_at_a_number_that_is_taken_out_refutes_nothing() -> None:
    below = Rel("<", LOG, X - 1)
    boxes = {"x": Box(Fraction(0))}
    found = equal_somewhere(Statement((below,), (Rel("!=", X, number(2)),)), boxes, {}, _no_proof)
    assert found is not None
    assert (found.verdict, dict(found.witness.point if found.witness else {})) == (
        "refuted",
        {"x": "1"},
    )
    taken_out = Statement((below,), (Rel("!=", X, number(1)),))
    assert equal_somewhere(taken_out, boxes, {}, _no_proof) is None
    other = Statement((below,), (Rel("!=", X * X, number(1)),))
    assert equal_somewhere(other, boxes, {}, _no_proof) is None


def _no_proof(rel: Rel, _boxes: Boxes) -> bool:
    """Of equalities between the same numbers alone."""
    return rel.operator == "=" and plain(rel.left).key == plain(rel.right).key


@pytest.mark.parametrize(
    ("g", "box", "wanted"),
    [
        (LEAST, Box(Fraction(0)), 0.5**0.5),
        (X * LOG, Box(Fraction(0), Fraction(1)), math.exp(-1)),
        (COS + X * X * number(Fraction(1, 10)), Box(Fraction(1)), 2.59574),
        (EXP - 2 * X, Box(), math.log(2)),
        (call("exp", -X) + 2 * X, Box(upper=Fraction(0)), -math.log(2)),
        # no inner point is lowest, or there is no value, or one too large for a float
        (EXP, Box(Fraction(0)), None),
        (call("log", X), Box(upper=Fraction(-1)), None),
        (call("exp", EXP), Box(), None),
        (-call("exp", call("exp", X * X)), Box(), None),
    ],
)
def test_points_where_a_formula_is_lowest(g: Expr, box: Box, wanted: float | None) -> None:
    found = list(lowest(g, "x", box))
    assert all(box.holds(point) for point in found)
    if wanted is not None:
        assert abs(float(found[-1]) - wanted) < 1e-5
        assert [point.denominator for point in found] == sorted(p.denominator for p in found)
