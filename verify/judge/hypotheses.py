"""Equations taken as hypotheses: each is solved for a free symbol that occurs linearly, which is
then replaced.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import lru_cache
from operator import itemgetter

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.domain import box_conditions
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, neg, number, symbol, symbols_of
from gainproof.verify.judge.exact.formal_identities import decide_formally
from gainproof.verify.judge.exact.free_names import with_tokens
from gainproof.verify.judge.exact.rational_points import try_points
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Undecided


def candidates(statement: Statement, parameter: str | None) -> list[str | None]:
    """Which symbol may play the one real parameter, the most promising first."""
    names = sorted(statement.symbols())
    if parameter in names:
        return [parameter]
    if len(names) == 1:
        return [names[0]]
    return [None, *names]


def settle(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    *,
    only_proof: bool = False,
) -> Outcome:
    """Decides with the first symbol that can play the one real parameter, then over cells of all
    symbols, then by the relations of roots, then at points. Raises Undecided with the last reason.

    With `only_proof` nothing that is not proved is told in full: where it holds takes long to say.
    """
    labels = with_tokens(labels, statement.symbols())
    known = tuple(sorted(boxes.items(), key=itemgetter(0)))
    found = _settled(statement, known, parameter, tuple(sorted(labels.items())), only_proof)
    if isinstance(found, Undecided):
        raise type(found)(str(found))
    return found


@lru_cache(maxsize=1 << 10)  # two of three questions are asked again: by every convention, say
def _settled(
    statement: Statement,
    boxes: tuple[tuple[str, Box], ...],
    parameter: str | None,
    labels: tuple[tuple[str, str], ...],
    only_proof: bool,
) -> Outcome | Undecided:
    """The outcome, or why there is none; it depends on nothing but what is given."""
    try:
        return _decided(statement, dict(boxes), parameter, dict(labels), only_proof)
    except Undecided as reason:
        return reason.with_traceback(None)


def _decided(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    only_proof: bool,
) -> Outcome:
    last = Undecided("no variable")
    for choice in candidates(statement, parameter):
        try:
            return decide(statement, boxes, choice, labels)
        except Undecided as reason:
            last = reason
    if 1 < len(statement.symbols()) <= DEFAULT_LIMITS.parameters:
        try:
            return decide_in_cells(statement, boxes, labels, only_proof=only_proof)
        except Undecided as reason:
            last = reason
    try:
        return decide_formally(statement, boxes, labels)
    except Undecided:
        points = try_points(statement, boxes, labels)
    if points is None:
        raise last
    return replace(points, reason=f"{points.reason} ({last})")


def without_equations(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Statement:
    """The statement with equations between free symbols, among its conditions, solved and put in.

    Equations of the parameter alone stay, and so do those that cannot be solved: cells decide them.
    """
    while True:
        equation = next(
            (c for c in statement.conditions if c.operator == "=" and _is_free(c, parameter)), None
        )
        if equation is None or len(statement.symbols()) == 1:
            return statement
        try:
            name, value = solved(equation, boxes, parameter, labels)
        except Undecided:
            return statement
        rest = tuple(c for c in statement.conditions if c is not equation)
        moved = replace(statement, conditions=rest).mapped(_put_in(name, tidied(value)))
        # the hypothesis holds nowhere where it has no value: a condition, not part of the claim
        defined = Rel("<=", value, value)
        inside = box_conditions(name, value, boxes.get(name, Box(stated=False)))
        conditions = (*moved.conditions, defined, *inside)
        statement = replace(moved, conditions=conditions)


def _put_in(name: str, value: Expr) -> Callable[[Expr], Expr]:
    return lambda expr: substituted(expr, {name: value})


def _is_free(rel: Rel, parameter: str | None) -> bool:
    return bool(symbols_of(rel.left, rel.right) - {parameter})


def solved(
    equation: Rel, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> tuple[str, Expr]:
    """A free symbol and what it equals: left - right = a + b * symbol identically, b nowhere zero
    on the domain.
    """
    difference = equation.left - equation.right
    names = sorted(symbols_of(difference) - {parameter})
    for name in names:
        if boxes.get(name, Box(stated=False)).integer:
            continue
        at_zero = substituted(difference, {name: number(0)})
        slope = substituted(difference, {name: number(1)}) - at_zero
        line = at_zero + symbol(name) * slope
        rest = {n: b for n, b in boxes.items() if n != name}
        try:
            linear = settle(Statement((Rel("=", difference, line),)), boxes, parameter, labels)
            nowhere = settle(Statement((Rel("!=", slope, number(0)),)), rest, parameter, labels)
        except Undecided:
            continue
        if linear.verdict == nowhere.verdict == "proved":
            return name, neg(at_zero / slope)
    raise Undecided("a hypothesis cannot be solved for a symbol that occurs linearly")
