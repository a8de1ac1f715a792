"""Relations written by a derivation, judged like any claim."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.expression_graph import read_graph, read_values
from gainproof.verify.judge.exact.graph_matrices import Grid
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.verdict import Finding, finding_of
from judged_derivations.along import (
    judge_increasing,
    judge_limit,
    judge_monotone,
    settled,
)
from judged_derivations.program import judge_program
from judged_derivations.steady_statements import (
    definite_statement,
    riccati_statement,
    stable_statement,
)
from judged_derivations.surroundings import Surroundings, surroundings

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
            return judge_limit(where, claim)
        case "increasing_onto":
            return judge_increasing(where, claim)
        case "monotone":
            return judge_monotone(where, claim)
        case "sum":
            return _sum(claim)
        case "riccati":
            return settled(where, riccati_statement(where, claim))
        case "stable":
            return settled(where, stable_statement(where, claim))
        case "positive_definite":
            return settled(where, definite_statement(where, claim))
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
        finding = settled(where, statement, free)
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
        finding = settled(where, Statement((first,), (second,), "iff", (*more, *others)))
        if finding.verdict != "proved":
            return finding
    assert finding is not None
    return finding


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
