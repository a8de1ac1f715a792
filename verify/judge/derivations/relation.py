"""Relations written by a derivation, judged like any claim."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.derivations.program import judge_program
from gainproof.verify.judge.derivations.steady_statements import (
    definite_statement,
    riccati_statement,
    stable_statement,
)
from gainproof.verify.judge.derivations.surroundings import Surroundings, surroundings
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.graph import read_graph, read_values
from gainproof.verify.judge.exact.grid import Grid
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.hypothesis import settle
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.verdict import Finding, finding_of

Graph = Mapping[str, Any]


def judge_relation(
    left: Graph,
    right: Graph,
    model: Mapping[str, Any] | None = None,
    *,
    operator: str = "=",
    degree: int | None = None,
    tower: Mapping[str, Any] | None = None,
    free: Sequence[str] = (),
    around: Surroundings | None = None,
) -> Finding:
    """Whether `left operator right` holds for every index (or sample number) and all free symbols.

    The symbols are those of `surroundings`: alpha, beta, predicted_11, tracking_index, ..., the
    tower's parameter and roots, and `free`. Matrices are compared entry by entry. Never raises:
    what cannot be decided is `undecided`.
    """
    try:
        where = around or surroundings(model, degree, tower)
        return _related(where, left, right, operator, free)
    except (Undecided, Malformed, NotEstablished) as reason:
        return Finding("undecided", str(reason))


def judge_statement(
    kind: str,
    claim: Mapping[str, Any],
    model: Mapping[str, Any] | None = None,
    *,
    degree: int | None = None,
    tower: Mapping[str, Any] | None = None,
    programs: Mapping[str, Any] | None = None,
    around: Surroundings | None = None,
) -> Finding:
    """One statement of a derivation, of any kind that certificates know.

    `programs` are the certificate's, for statements about kernels. Never raises: what cannot be
    decided is `undecided`.
    """
    try:
        where = around or surroundings(model, degree, tower)
        return _judged(kind, claim, where, programs or {})
    except (Undecided, Malformed, NotEstablished) as reason:
        return Finding("undecided", str(reason))


def _judged(
    kind: str, claim: Mapping[str, Any], where: Surroundings, programs: Mapping[str, Any]
) -> Finding:
    zero = {"nodes": [["number", "0"]], "outputs": {"value": 0}}
    match kind:
        case "equal":
            return _related(where, claim["left"], claim["right"], "=", claim.get("free", ()))
        case "positive":
            return _related(where, claim["expression"], zero, ">", ())
        case "same_sign":
            return _same_sign(where, claim["left"], claim["right"])
        case "limit":
            return _limit(where, claim)
        case "increasing_onto":
            return _increasing(where, claim)
        case "sum":
            return _sum(claim)
        case "riccati":
            return _settled(where, riccati_statement(where, claim), ())
        case "stable":
            return _settled(where, stable_statement(where, claim), ())
        case "positive_definite":
            return _settled(where, definite_statement(where, claim), ())
        case "program":
            return judge_program(where, claim, programs)
        case "definition":
            return Finding("definition", "nothing to decide")
        case "cited":
            return Finding("remark", "a theorem of the literature, cited")
        case _:
            raise Undecided(f"statements of kind {kind} are not covered")


def _entries(graph: Graph) -> list[Expr]:
    value: Expr | Grid = read_values(graph)["value"]
    return [value] if isinstance(value, Expr) else [entry for row in value for entry in row]


def _settled(where: Surroundings, statement: Statement, free: Sequence[str]) -> Finding:
    boxes = {**where.boxes, **{free_name(name): Box(stated=False) for name in free}}
    return finding_of(settle(statement, boxes, where.parameter, {}))


def _related(
    where: Surroundings, left: Graph, right: Graph, operator: str, free: Sequence[str]
) -> Finding:
    sides = _entries(left), _entries(right)
    if len(sides[0]) != len(sides[1]):
        raise Malformed(
            f"wanted matrices of one size, got {len(sides[0])} and {len(sides[1])} entries"
        )
    finding: Finding | None = None
    for a, b in zip(*sides, strict=True):
        (a, more), (b, others) = where.resolved(a, free), where.resolved(b, free)
        statement = Statement((Rel(operator, a, b),), needed=(*more, *others))
        finding = _settled(where, statement, free)
        if finding.verdict != "proved":
            return finding
    if finding is None:
        raise Malformed("an empty matrix")
    return finding


def _same_sign(where: Surroundings, left: Graph, right: Graph) -> Finding:
    """Positive together and zero together, hence negative together."""
    (a, more), (b, others) = where.resolved(read_graph(left)), where.resolved(read_graph(right))
    finding: Finding | None = None
    for operator in (">", "="):
        first, second = (Rel(operator, side, number(0)) for side in (a, b))
        finding = _settled(where, Statement((first,), (second,), "iff", (*more, *others)), ())
        if finding.verdict != "proved":
            return finding
    assert finding is not None
    return finding


def _target(value: Any) -> Expr | str:
    return value if isinstance(value, str) else read_graph(value)


def _limit(where: Surroundings, claim: Mapping[str, Any]) -> Finding:
    expr, _ = where.resolved(read_graph(claim["expression"]))
    point = "infinity" if claim["point"] == "infinity" else Fraction(0)
    return _tends(where, expr, claim["variable"], point, _target(claim["value"]))


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


def _increasing(where: Surroundings, claim: Mapping[str, Any]) -> Finding:
    expr, _ = where.resolved(read_graph(claim["expression"]))
    name, variable = where.parameter, claim["variable"]
    if name is None:
        raise Undecided("monotone in no parameter")
    slope = differentiated(expr, name)
    along = where.value(variable)
    if along != symbol(name):
        slope = slope / differentiated(along, name)
    # where the domain begins the slope may vanish: rising inside and continuous is enough
    inside = {key: replace(box, lower_open=True) for key, box in where.boxes.items()}
    rising = _settled(
        replace(where, boxes=inside), Statement((Rel(">", slope, number(0)),), needed=(expr,)), ()
    )
    if rising.verdict != "proved":
        return rising
    for point, value in ((Fraction(0), claim["from"]), ("infinity", claim["to"])):
        finding = _tends(where, expr, variable, point, _target(value))
        if finding.verdict != "proved":
            return finding
    return rising


def _sum(claim: Mapping[str, Any]) -> Finding:
    """closed(upper) - closed(upper - 1) = summand(upper) and closed(start) = summand(start)."""
    summand, closed = read_graph(claim["summand"]), read_graph(claim["closed"])
    index, upper = claim["index"], claim["upper"]
    start = constant_value(
        read_graph(claim["start"])
        if isinstance(claim["start"], Mapping)
        else number(claim["start"])
    )
    if start is None or not symbols_of(summand) <= {index} or not symbols_of(closed) <= {upper}:
        raise Undecided("a sum with further symbols")
    step = closed - substituted(closed, {upper: symbol(upper) - 1})
    first = substituted(closed, {upper: number(start)})
    relations = (
        Rel("=", step, substituted(summand, {index: symbol(upper)})),
        Rel("=", first, substituted(summand, {index: number(start)})),
    )
    boxes = {upper: Box(lower=start, lower_open=False, integer=True)}
    return finding_of(decide(Statement(relations), boxes, upper))
