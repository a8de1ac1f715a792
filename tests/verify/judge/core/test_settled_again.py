"""Questions that were settled before are settled no differently."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.hypotheses import settle

X, Y = symbol("x"), symbol("y")
ABOVE_ONE, POSITIVE = Box(Fraction(1)), Box(Fraction(0))


def grows(x: Expr) -> Statement:
    """x < x^2, which is true above 1 alone."""
    return Statement((Rel("<", x, power(x, 2)),))


def test_the_domain_belongs_to_the_question() -> None:
    assert settle(grows(X), {"x": ABOVE_ONE}, "x", {}).verdict == "proved"
    assert settle(grows(X), {"x": POSITIVE}, "x", {}).verdict != "proved"
    assert settle(grows(X), {"x": ABOVE_ONE}, "x", {}).verdict == "proved"


def test_each_kind_of_domain_is_told_apart() -> None:
    closed = Box(Fraction(1), lower_open=False)
    assert settle(grows(X), {"x": ABOVE_ONE}, "x", {}).verdict == "proved"
    assert settle(grows(X), {"x": closed}, "x", {}).verdict != "proved"
    beyond = Statement((Rel(">=", X, number(2)),))
    assert settle(beyond, {"x": Box(Fraction(1), integer=True)}, "x", {}).verdict == "proved"
    assert settle(beyond, {"x": ABOVE_ONE}, "x", {}).verdict != "proved"


def test_conditions_belong_to_the_question() -> None:
    bare = Statement((Rel(">", X, number(1)),))
    given = Statement(bare.relations, given=(Rel(">", X, number(2)),))
    assert settle(given, {"x": POSITIVE}, "x", {}).verdict == "proved"
    assert settle(bare, {"x": POSITIVE}, "x", {}).verdict != "proved"


def test_names_for_people_are_those_of_the_question() -> None:
    told = [str(settle(grows(X), {"x": POSITIVE}, "x", {"x": name})) for name in ("r", "q")]
    assert told[0] != told[1]


def test_what_is_undecided_stays_so_for_the_same_reason() -> None:
    unknown = Expr("call", "unheard", (X,))
    statement = Statement((Rel("<", unknown, sqrt(Y)),))
    reasons = []
    for _ in range(2):
        with pytest.raises(Undecided) as error:
            settle(statement, {"x": POSITIVE, "y": POSITIVE}, "x", {})
        reasons.append(str(error.value))
    assert reasons[0]
    assert reasons[0] == reasons[1]
