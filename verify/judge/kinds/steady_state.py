"""Steady states of recursions: fixed points, in the domain, that the recursion does not leave."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from gainproof.verify.judge.claim.formulas import formula_of
from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.dimensions.dimension import Mismatch, agreed
from gainproof.verify.judge.dimensions.symbol_dimensions import Names
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Formula, Reading, Relation
from gainproof.verify.judge.kinds.claim_domain import Frame, framed
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import EQUATION, Kind, OwnFields, one_symbol
from gainproof.verify.judge.meaning.evaluation import number_of
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of

BEFORE = "the value before"
ACCENT = re.compile(r"\\(bar|hat|tilde|overline|widehat|widetilde|dot|check|mathrm|mathbf) *\{?")


def _recursion(claim: OwnFields, name: str) -> OwnField:
    formula = formula_of(claim.fields, name, claim.fields.required_text(name), claim.symbols)
    reading = formula.readings[0]
    if len(reading.relations) != 1 or reading.relations[0].operator != "=" or reading.conditions:
        raise claim.fields.fail(name, "one equation is wanted: next value = ...")
    return OwnField(formulas=(formula,), place="the recursion")


def _units(claim: Claim, names: Names) -> Iterator[str]:
    """The value before has the dimension of the next one."""
    (recursion,), previous = claim.own["recursion"].formulas, claim.own["previous"].symbol
    following = _token(recursion.readings[0].relations[0])
    if following is not None:
        try:
            agreed([names.of(following), names.of(previous)], "the next value and the last")
        except Mismatch as fault:
            yield str(fault)


def judge_steady_state(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the formula's value is mapped to itself, lies in its symbol's domain and attracts
    its neighbours: the derivative of the recursion there lies between -1 and 1.
    """
    (recursion,), previous = claim.own["recursion"].formulas, claim.own["previous"].symbol
    if len(reading.relations) != 1:
        raise Undecided("a steady state needs one formula, a recursion and the symbol before it")
    rule = _rule(recursion, reading.relations[0], previous)
    before = symbol(BEFORE)
    following = scope.expression(rule.right, scope.root.having({previous: before}))
    conditions = list(resolved(reading.conditions, scope))
    value = _value(reading.relations[0], conditions, scope)
    within = _domain((_token(reading.relations[0]), _token(rule), previous), value, scope)
    frame = framed(claim, scope, conditions)
    fixed = Rel("=", substituted(following, {BEFORE: value}), value)
    finding = finding_of(frame.decide(Statement((fixed, *within))))
    if finding.verdict not in ("proved", "conditional"):
        return finding
    slope = substituted(differentiated(following, BEFORE), {BEFORE: value})
    attracts = _with_attraction(finding, slope, frame)
    if finding.verdict == "conditional" and attracts.verdict != "refuted":
        raise Undecided(f"a fixed point on a part of the domain only: {finding.reason}")
    return attracts


def _rule(recursion: Formula, relation: Relation, previous: str) -> Relation:
    """The equation of a recursion of the formula's own symbol. Raises Undecided for others."""
    if len(recursion.readings) != 1:
        raise Undecided("a recursion with several readings")
    (reading,) = recursion.readings
    if reading.conditions or len(reading.relations) != 1:
        raise Undecided("a recursion that holds under conditions only")
    (rule,) = reading.relations
    following, own = _token(rule), _token(relation)
    if following is None:
        raise Undecided("the recursion must have the next value, one symbol, on its left")
    if own is not None and _letters(own) not in (_letters(following), _letters(previous)):
        raise Undecided(f"the formula is of {own}, the recursion of {following}")
    return rule


def _letters(token: str) -> str:
    """A symbol without its indices and accents: p of `\\bar{p}`, of `p_{k-1}` and of `p^*`."""
    bare = token.partition("_")[0].partition("^")[0].replace("'", "")
    return ACCENT.sub("", bare).strip("{} ")


def _value(relation: Relation, conditions: list[Rel], scope: Scope) -> Expr:
    """The right side, for a formula `p = ...`; else its left symbol, the formula a hypothesis."""
    left = scope.expression(relation.left)
    right = scope.expression(relation.right)
    token = _token(relation)
    if token is not None and left == symbol(free_name(token)):
        changed = substituted(right, {left.name: number(0)})
        if changed == right:
            return right
        conditions.append(Rel("=", left, right))
        return left
    if token is None:
        raise Undecided("the formula of a steady state must have its symbol on the left")
    conditions.append(Rel("=", left, right))
    return left


def _token(relation: Relation) -> str | None:
    nodes = relation.left["nodes"]
    return str(nodes[0][1]) if len(nodes) == 1 and nodes[0][0] == "symbol" else None


def _domain(tokens: tuple[str | None, ...], value: Expr, scope: Scope) -> list[Rel]:
    """What the domains of the symbol, of the next one and of the one before say of the value."""
    found = []
    for token in dict.fromkeys(tokens):
        if token is None:
            continue
        inner = scope.root.having({token: value})
        for stated in scope.setting.symbols[token].domain:
            sides = [scope.value(side, inner) for side in (stated.left, stated.right)]
            found.append(Rel(stated.operator, number_of(sides[0]), number_of(sides[1])))
    return found


def _with_attraction(finding: Finding, slope: Expr, frame: Frame) -> Finding:
    square = Statement((Rel("<", power(slope, 2), number(1)),))
    try:
        attracts = finding_of(frame.decide(square))
    except Undecided:
        attracts = None
    if attracts is not None and attracts.verdict == "proved":
        certificate = {
            "fixed point": dict(finding.certificate),
            "derivative of the recursion there": dict(attracts.certificate),
        }
        reason = "a fixed point that attracts its neighbours"
        return replace(finding, reason=reason, certificate=certificate)
    fails = attracts is not None and attracts.verdict in ("refuted", "conditional")
    if fails and attracts and not frame.holds(Rel("<=", power(slope, 2), number(1))):
        reason = f"a fixed point that does not attract: its slope squared {attracts.reason}"
        return replace(attracts, reason=reason)
    return replace(finding, reason="a fixed point; whether it attracts is not decided")


STEADY_STATE = Kind(
    "steady_state",
    "the formula is the fixed point of a recursion",
    judge_steady_state,
    own={"recursion": _recursion, "previous": one_symbol},
    own_words="`recursion`: the equation, on its left the next value, one symbol with the "
    "formula's letter; `previous`: the symbol of the value before",
    operators=EQUATION,
    units=_units,
)
