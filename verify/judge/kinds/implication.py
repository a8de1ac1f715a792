"""Implications: where the first relations hold, so do the others."""

from __future__ import annotations

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.statement import Statement
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import framed, strictly, where_hypotheses_have_values
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import Kind
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of


def judge_implication(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the relations imply those of the trailing parenthesis, or right of the arrow."""
    first, then = resolved(reading.relations, scope), resolved(reading.conditions, scope)
    frame = framed(claim, scope)
    needed = tuple(scope.needed)
    found = finding_of(strictly(frame).decide(Statement(then, first, "if", needed)))
    return where_hypotheses_have_values(found, first, frame)


IMPLICATION = Kind(
    "implication",
    "what stands first implies the condition, or what stands left of the arrow what stands right; "
    "both need a value on a stated domain",
    judge_implication,
    two_parts=True,
    settings="any",
    strongest=True,
)
