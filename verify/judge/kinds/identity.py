"""Identities, inequalities, chains of them, and recursions: relations that hold on the domain."""

from __future__ import annotations

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.formula import Reading, Relation
from gainproof.verify.judge.kinds.framing import framed, only_plain
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of


def judge_identity(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether all relations hold wherever the conditions do."""
    relations = resolved(reading.relations, scope)
    printed = resolved(reading.conditions, scope)
    frame = framed(claim, scope, printed, relations if claim.kind == "recursion" else ())
    return finding_of(frame.decide(Statement(relations, (), "if", tuple(scope.needed))))


def resolved(relations: tuple[Relation, ...], scope: Scope) -> tuple[Rel, ...]:
    """Relations in base variables, those between matrices entry by entry. Raises Undecided."""
    found = tuple(rel for relation in relations for rel in scope.relations(relation))
    only_plain(found)
    return found
