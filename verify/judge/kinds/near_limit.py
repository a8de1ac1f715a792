"""What is known close to a limit: on which sides conditions hold, which coefficients are zero."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.kinds.approach import SMALL, Approach
from gainproof.verify.judge.kinds.framing import Frame
from gainproof.verify.judge.series.of_expression import expanded
from gainproof.verify.judge.series.series import leading


def refuse_without_value(approach: Approach, around: Frame, *exprs: Expr) -> None:
    """Raises Undecided unless the parts in which the variable does not occur have a value for all
    others: coefficients may cancel what has none.
    """
    waiting = list(exprs)
    while waiting:
        part = waiting.pop()
        if approach.name in symbols_of(part):
            waiting += part.parts
        elif not around.holds(Rel("=", part, part)):
            raise Undecided("a part without value for some values of the other symbols")


def others_frame(frame: Frame, approach: Approach) -> tuple[Frame, bool]:
    """The frame without the variable of the limit; whether a condition on it was left out that does
    not just say from which side it comes.
    """
    on_it = [c for c in frame.conditions if approach.name in symbols_of(c.left, c.right)]
    if any(c.operator == "=" for c in on_it):
        raise Undecided("an equation among the conditions ties the variable of the limit")
    kept = tuple(c for c in frame.conditions if c not in on_it)
    boxes: Mapping[str, Box] = {n: b for n, b in frame.boxes.items() if n != approach.name}
    around = replace(frame, boxes=boxes, conditions=kept)
    return around, any(None in _near(c, approach, around).values() for c in on_it)


def open_sides(approach: Approach, frame: Frame, around: Frame) -> list[int]:
    """The sides on which no condition excludes points close to the limit. Raises Undecided."""
    on_it = [c for c in frame.conditions if approach.name in symbols_of(c.left, c.right)]
    shut = {s for c in on_it for s, holds in _near(c, approach, around).items() if holds is False}
    sides = [side for side in approach.sides() if side not in shut]
    if not sides:
        raise Undecided("the conditions hold nowhere close to the limit")
    return sides


def _near(rel: Rel, approach: Approach, around: Frame) -> dict[int, bool | None]:
    """For each side whether a condition holds close to the limit; None where that is not known."""
    oracle = Coefficients(around)
    found: dict[int, bool | None] = {}
    for side in approach.sides():
        try:
            difference = approach.moved(rel.left - rel.right, side)
            first = leading(expanded(difference, SMALL, oracle, Fraction(4)), oracle)
        except Undecided:
            first = None
        found[side] = None
        for sign, operators in ((1, (">", ">=", "!=")), (-1, ("<", "<=", "!="))):
            if first is not None and oracle.is_positive(first[1] if sign > 0 else -first[1]):
                found[side] = rel.operator in operators
    return found


class Coefficients:
    """What a frame knows of coefficients: the oracle of expansions."""

    def __init__(self, frame: Frame) -> None:
        self._frame = frame
        self._known: dict[tuple[str, Expr], bool] = {}

    def is_zero(self, coefficient: Expr) -> bool:
        """Zero always, or never. Raises Undecided."""
        value = constant_value(coefficient)
        if value is not None:
            return value == 0
        if self._holds("=", coefficient):
            return True
        if self._holds("!=", coefficient):
            return False
        raise Undecided(
            "a coefficient of the expansion may be zero for some values of the other symbols"
        )

    def is_positive(self, coefficient: Expr) -> bool:
        """Positive always; False also where that is not known."""
        value = constant_value(coefficient)
        return self._holds(">", coefficient) if value is None else value > 0

    def _holds(self, operator: str, coefficient: Expr) -> bool:
        key = (operator, coefficient)
        if key not in self._known:
            self._known[key] = self._frame.holds(Rel(operator, coefficient, number(0)))
        return self._known[key]


def equal(left: Expr, right: Expr) -> Statement:
    """That two expressions are equal."""
    return Statement((Rel("=", left, right),))
