"""One claim under one convention and one reading: the kind of claim says what has to be decided."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim_record import Claim
from gainproof.verify.judge.domain import bounded
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.graph import graph_of
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.points import with_values
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.hypothesis import settle, without_equations
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import SAMPLE
from gainproof.verify.judge.verdict import Finding, finding_of

PLAIN = ("=", "!=", "<", "<=", ">", ">=")
NOT_COVERED = ("asymptotics", "value", "monotone", "location", "steady_state")
"""Kinds whose formula must not be taken for an identity."""


def judge_reading(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """The finding on a claim with a formula. Raises Undecided, UndefinedSymbol, Malformed."""
    finding = _judged(claim, reading, scope)
    meanings = {
        token: expr
        for token, expr in scope.used.items()
        if expr.kind != "symbol" and scope.setting.symbols[token].role == "quantity"
    }
    if meanings and finding.certificate:
        graphs = {token: graph_of(expr) for token, expr in meanings.items()}
        finding = replace(finding, certificate={**finding.certificate, "quantities": graphs})
    if meanings and finding.witness is not None:
        finding = replace(finding, witness=with_values(finding.witness, meanings, scope.labels()))
    return finding


def _judged(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    if claim.kind in NOT_COVERED:
        raise Undecided(f"claims of kind {claim.kind} are not covered")
    if any(r.operator == "->" for r in (*reading.relations, *reading.conditions)):
        return _limit(claim, reading, scope)
    relations = tuple(scope.relation(r) for r in reading.relations)
    printed = tuple(scope.relation(r) for r in reading.conditions)
    _only_plain((*relations, *printed))
    both = claim.kind == "equivalence" or reading.connective == "iff"
    implied = claim.kind == "implication" or reading.connective == "implies"
    stated = () if both or implied else printed
    boxes, rest = _domain(claim, scope, stated, relations if claim.kind == "recursion" else ())
    labels = scope.labels()
    parameter = scope.environment.parameter
    needed = tuple(scope.needed)
    if both:
        return _equivalence(
            Statement(relations, printed, "iff", needed), rest, boxes, parameter, labels
        )
    if implied:
        statement = Statement(printed, (*relations, *rest), "if", needed)
    else:
        statement = Statement(relations, rest, "if", needed)
    statement = without_equations(statement, boxes, parameter, labels)
    return finding_of(settle(statement, boxes, parameter, labels))


def _only_plain(relations: Iterable[Rel]) -> None:
    for rel in relations:
        if rel.operator not in PLAIN:
            raise Undecided(f"the relation {rel.operator} is not covered")


def _domain(
    claim: Claim, scope: Scope, printed: tuple[Rel, ...], used: tuple[Rel, ...] = ()
) -> tuple[dict[str, Box], tuple[Rel, ...]]:
    """Boxes and further conditions: `printed` ones, fields `domain`, `given`."""
    stated = [*printed, *[scope.relation(r) for r in claim.domain]]
    for formula in claim.given:
        if len(formula.readings) != 1:
            raise Undecided("a hypothesis with several readings")
        stated += [scope.relation(r) for r in formula.readings[0].relations]
    done: set[str] = set()
    while pending := [token for token in scope.used if token not in done]:
        for token in pending:
            done.add(token)
            stated += [scope.relation(r) for r in scope.setting.symbols[token].domain]
    _only_plain(stated)
    boxes = scope.boxes()
    before = {s for rel in used for s in symbols_of(rel.left, rel.right)}
    if SAMPLE in boxes and any(name.startswith("previous_state") for name in before):
        # there is no sample before the first one
        lower = boxes[SAMPLE].lower
        boxes[SAMPLE] = replace(boxes[SAMPLE], lower=max(lower or Fraction(0), Fraction(1)))
    return bounded(boxes, stated)


def _equivalence(
    statement: Statement,
    rest: tuple[Rel, ...],
    boxes: dict[str, Box],
    parameter: str | None,
    labels: dict[str, str],
) -> Finding:
    """A <=> B: place by place or cell by cell, else as two implications."""
    try:
        return finding_of(settle(replace(statement, given=rest), boxes, parameter, labels))
    except Undecided:
        if len(statement.symbols()) == 1 and not rest:
            raise
    findings = []
    for hypothesis, conclusion in (
        (statement.relations, statement.conditions),
        (statement.conditions, statement.relations),
    ):
        one = Statement(conclusion, (*hypothesis, *rest), "if", statement.needed)
        one = without_equations(one, boxes, parameter, labels)
        findings.append(finding_of(settle(one, boxes, parameter, labels)))
    wrong = [f for f in findings if f.verdict != "proved"]
    if not wrong:
        certificate = {
            "there": dict(findings[0].certificate),
            "back": dict(findings[1].certificate),
        }
        return replace(
            findings[0], certificate=certificate, method="each side solved and put into the other"
        )
    worst = next((f for f in wrong if f.verdict != "held"), wrong[0])
    return replace(worst, reason=f"one direction only: {worst.reason}")


def _limit(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    arrows = [r for r in reading.conditions if r.operator == "->"]
    if len(arrows) != 1 or len(reading.relations) != 1:
        raise Undecided("a limit needs one relation and one condition with an arrow")
    variable = scope.expression(arrows[0].left)
    point = _end(arrows[0].right, scope)
    relation = reading.relations[0]
    if relation.operator not in ("->", "="):
        raise Undecided(f"the relation {relation.operator} in a limit is not covered")
    expr = scope.expression(relation.left)
    target = _end(relation.right, scope)
    claimed = target if isinstance(target, str) else scope.expression(relation.right)
    others = tuple(scope.relation(r) for r in reading.conditions if r is not arrows[0])
    boxes, rest = _domain(claim, scope, others)
    if rest or variable.kind != "symbol":
        raise Undecided("a limit under conditions, or in a quantity that is no variable")
    if not isinstance(claimed, str) and symbols_of(claimed):
        raise Undecided("a limit that depends on symbols is not covered")
    if symbols_of(expr) - {variable.name}:
        raise Undecided("a limit of an expression with several variables is not covered")
    box = boxes[variable.name]
    label = scope.labels().get(variable.name, variable.name)
    if isinstance(point, Fraction | str):
        return finding_of(decide_limit(expr, variable.name, box, point, claimed, label))
    raise Undecided("the point of a limit must be a number or infinity")


def _end(graph: object, scope: Scope) -> Fraction | str | Expr:
    """A number, "infinity" or "-infinity", or another expression."""
    nodes = graph["nodes"] if isinstance(graph, dict) else []
    if ["symbol", "infinity"] in [list(n) for n in nodes]:
        if len(nodes) == 1:
            return "infinity"
        if len(nodes) == 2 and nodes[1][0] == "neg":
            return "-infinity"
        raise Undecided("infinity inside an expression")
    expr = scope.expression(graph)  # type: ignore[arg-type]
    value = constant_value(expr)
    return expr if value is None else value


def judge_determines(claim: Claim, scope: Scope) -> Finding:
    """Each of the quantities fixes the others: each is strictly monotone in the one parameter of
    the setting.
    """
    parameter = scope.environment.parameter
    if parameter is None:
        raise Undecided("no model with one parameter")
    found: list[Finding] = []
    for token in claim.about:
        slope = differentiated(scope.symbol(token), parameter)
        boxes, rest = _domain(claim, scope, ())
        if rest:
            raise Undecided("a domain that is no interval of the parameter")
        for operator in (">", "<"):
            outcome = settle(
                Statement((Rel(operator, slope, number(0)),)), boxes, parameter, scope.labels()
            )
            if outcome.verdict == "proved":
                found.append(finding_of(outcome))
                break
        else:
            raise Undecided(f"{token} is not strictly monotone in the parameter of the setting")
    certificate = {token: dict(f.certificate) for token, f in zip(claim.about, found, strict=True)}
    method = "each quantity is strictly monotone in the one parameter, so each fixes all others"
    return replace(found[0], method=method, certificate=certificate)
