"""Relations of derivations that run along a variable: limits, trends, maps onto an interval."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.verdict import Finding, finding_of
from judged_derivations.surroundings import Surroundings

TRENDS = {"increasing": ">", "decreasing": "<"}


def settled(where: Surroundings, statement: Statement, free: Sequence[str] = ()) -> Finding:
    """A statement in base variables decided. Raises Undecided."""
    boxes = {**where.boxes, **{free_name(name): Box(stated=False) for name in free}}
    return finding_of(settle(statement, boxes, where.parameter, {}))


def _target(where: Surroundings, value: Any) -> Expr | str:
    return value if isinstance(value, str) else where.resolved(read_graph(value))[0]


def judge_limit(where: Surroundings, claim: Mapping[str, Any]) -> Finding:
    """Whether the expression tends to the value as the variable tends to its point."""
    expr, _ = where.resolved(read_graph(claim["expression"]))
    point = "infinity" if claim["point"] == "infinity" else Fraction(0)
    return _tends(where, expr, claim["variable"], point, _target(where, claim["value"]))


def _tends(
    where: Surroundings, expr: Expr, variable: str, point: Fraction | str, value: Expr | str
) -> Finding:
    name = where.parameter
    if name is None:
        raise Undecided("a limit without a parameter")
    along = where.value(variable)
    if along != symbol(name):
        # the variable tends to the point together with the parameter
        both = decide_limit(
            along,
            name,
            where.boxes[name],
            point,
            point if isinstance(point, str) else number(point),
            name,
        )
        if both.verdict != "proved":
            raise Undecided(f"{variable} does not tend to {point} with {name}")
    if symbols_of(expr) - {name}:
        raise Undecided("a limit of an expression with several variables")
    return finding_of(decide_limit(expr, name, where.boxes[name], point, value, variable))


def judge_increasing(where: Surroundings, claim: Mapping[str, Any]) -> Finding:
    """Whether the expression rises with the variable, from one value to the other."""
    rising = judge_monotone(where, {**claim, "trend": "increasing"})
    if rising.verdict != "proved":
        return rising
    expr, _ = where.resolved(read_graph(claim["expression"]))
    variable = claim["variable"]
    for point, value in ((Fraction(0), claim["from"]), ("infinity", claim["to"])):
        finding = _tends(where, expr, variable, point, _target(where, value))
        if finding.verdict != "proved":
            return finding
    return rising


def judge_monotone(where: Surroundings, claim: Mapping[str, Any]) -> Finding:
    """Whether the expression rises or falls strictly with the variable."""
    expr, _ = where.resolved(read_graph(claim["expression"]))
    name, variable = where.parameter, claim["variable"]
    if name is None:
        raise Undecided("monotone in no parameter")
    if claim["trend"] not in TRENDS:
        raise Malformed(f"wanted increasing or decreasing, got {claim['trend']}")
    slope = differentiated(expr, name)
    along = where.value(variable)
    if along != symbol(name):
        slope = slope / differentiated(along, name)
    # where the domain begins the slope may vanish: rising inside and continuous is enough
    inside = {key: replace(box, lower_open=True) for key, box in where.boxes.items()}
    rel = Rel(TRENDS[claim["trend"]], slope, number(0))
    return settled(replace(where, boxes=inside), Statement((rel,), needed=(expr,)))
