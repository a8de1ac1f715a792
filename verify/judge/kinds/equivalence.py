"""Equivalences: each side holds exactly where the other does."""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.statement import Statement
from gainproof.verify.judge.exact.witness import truth_of_sides
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import (
    LACKING,
    Frame,
    framed,
    strictly,
    where_hypotheses_have_values,
)
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import Kind
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.transcendental.algebraic_form import has_functions
from gainproof.verify.judge.transcendental.free_values import where_valued
from gainproof.verify.judge.verdict import Finding, finding_of, of_parts
from gainproof.verify.judge.verdict_words import Shown


def judge_equivalence(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether both sides say the same: place by place or cell by cell, else as two
    implications.
    """
    left, right = resolved(reading.relations, scope), resolved(reading.conditions, scope)
    frame = framed(claim, scope)
    return decide_equivalence(Statement(left, right, "iff", tuple(scope.needed)), frame)


def decide_equivalence(statement: Statement, frame: Frame) -> Finding:
    """The finding on A <=> B in a frame. Raises Undecided."""
    try:
        return finding_of(frame.decide_alone(replace(statement, given=frame.conditions)))
    except Undecided:
        one = len(statement.symbols()) == 1 and not frame.conditions
        if one and not has_functions(statement):
            raise
    ways: list[tuple[Finding, str]] = []
    reasons = []
    for supposed, hypothesis, conclusion in (
        ("left", statement.relations, statement.conditions),
        ("right", statement.conditions, statement.relations),
    ):
        one_way = Statement(conclusion, hypothesis, "if", statement.needed)
        try:
            found = finding_of(strictly(frame).decide(one_way))
            ways.append((where_hypotheses_have_values(found, hypothesis, frame), supposed))
        except Undecided as reason:
            reasons.append(reason)
    # of two directions with one domain, that whose witness says what both sides come to
    ways.sort(key=lambda way: way[0].witness is not None and way[0].witness.note == LACKING)
    findings = [_told(found, supposed) for found, supposed in ways]
    refuted = next((f for f in findings if f.verdict == "refuted"), None)
    if reasons and refuted is None:
        raise reasons[0]
    against = refuted or of_parts(findings)
    if against is None:
        certificate = {
            "there": dict(findings[0].certificate),
            "back": dict(findings[1].certificate),
        }
        return replace(
            findings[0], certificate=certificate, method="each side solved and put into the other"
        )
    # where one side has no value, nothing is said of the other
    if against.verdict == "conditional" and has_functions(statement):
        against = replace(against, domain=where_valued(against.domain or ""))
    return replace(against, reason=f"one direction only: {against.reason}")


def _told(finding: Finding, supposed: str) -> Finding:
    """The finding on one direction, its witness with what each side of the equivalence comes to:
    that which is supposed, `left` or `right`, and the other.
    """
    witness = finding.witness
    if witness is None:
        return finding
    if witness.note == LACKING:
        note = f"the {supposed} side of the equivalence has no value"
    else:
        lacks = witness.left.undefined is not None or witness.right.undefined is not None
        said = ("holds", "has no value" if lacks else "does not hold")
        first, second = said if supposed == "left" else said[::-1]
        note = truth_of_sides("equivalence", first, second)
    told = replace(witness, note=note, shows=Shown.TRUTH)
    reason = finding.reason.replace(witness.text(), told.text())
    return replace(finding, reason=reason, witness=told)


EQUIVALENCE = Kind(
    "equivalence",
    "the same in both directions",
    judge_equivalence,
    two_parts=True,
    settings="any",
)
