"""An equation as printed, solved for one of its symbols."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.tidy import tidied
from gainproof.verify.judge.hypothesis import settle
from gainproof.verify.judge.repair.construct import (
    Path,
    opposite,
    places,
    product,
    quotient,
    raised,
    total,
    without,
)


@dataclass(frozen=True)
class Solution:
    """What the symbol is; `unique` says that nothing else satisfies the equation where this has a
    value, and `how` on what ground.
    """

    value: Expr
    unique: bool
    how: str


def solutions(left: Expr, right: Expr, name: str, *, positive: bool) -> Iterator[Solution]:
    """Solutions of left = right for a symbol; `positive` says that the symbol is a positive number.
    The equation is undone step by step if the symbol occurs once, or is linear in it.
    """
    occurrences = [
        (side, path)
        for side, expr in enumerate((left, right))
        for path, node in places(expr)
        if node.kind == "symbol" and node.value == name
    ]
    if len(occurrences) == 1:
        side, path = occurrences[0]
        sides = (left, right) if side == 0 else (right, left)
        found = _undone(*sides, path, positive=positive)
        if found is not None:
            yield found
            return
    found = _linear(left, right, name)
    if found is not None:
        yield found


def _undone(expr: Expr, other: Expr, path: Path, *, positive: bool) -> Solution | None:
    """Operations taken off the side that holds the symbol, from outside to inside."""
    unique = True
    for k in path:
        inner = expr.parts[k]
        match expr.kind:
            case "add":
                other = total(other, *[opposite(t) for t in without(expr.parts, k)])
            case "neg":
                other = opposite(other)
            case "mul":
                other = quotient(other, product(*without(expr.parts, k)))
            case "div":
                other = product(other, expr.parts[1]) if k == 0 else quotient(expr.parts[0], other)
            case "pow":
                # of two opposite roots the positive one, if the base is known to be positive
                is_even = expr.fraction.numerator % 2 == 0
                unique = unique and (not is_even or (positive and inner.kind == "symbol"))
                other = raised(other, 1 / expr.fraction)
            case _:
                return None
        expr = inner
    how = "the equation undone step by step" + ("" if unique else "; of two roots one was taken")
    return Solution(other, unique, how)


def _linear(left: Expr, right: Expr, name: str) -> Solution | None:
    difference = left - right
    at_zero = substituted(difference, {name: number(0)})
    slope = substituted(difference, {name: number(1)}) - at_zero
    line = at_zero + symbol(name) * slope
    try:
        outcome = settle(Statement((Rel("=", difference, line),)), {}, None, {})
    except (Undecided, Malformed):
        return None
    if outcome.verdict != "proved" or name in symbols_of(tidied(at_zero / slope)):
        return None
    return Solution(
        opposite(quotient(at_zero, slope)), unique=True, how="the equation is linear in it"
    )


def shortened(expr: Expr) -> Expr:
    """Multiplied out and cancelled, if that is shorter."""
    made = tidied(expr)
    return made if _size(made) < _size(expr) else expr


def _size(expr: Expr) -> int:
    return sum(1 for _ in places(expr))
