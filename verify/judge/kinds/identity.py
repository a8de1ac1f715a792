"""Identities, inequalities, chains of them, and recursions: relations that hold on the domain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from math import isclose

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.balls import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.statement import Rel, Statement, Witness
from gainproof.verify.judge.formula import Reading, Relation
from gainproof.verify.judge.kinds.claim_domain import framed, only_plain
from gainproof.verify.judge.kinds.kind import EQUATION, Kind
from gainproof.verify.judge.meaning.value import shape
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of
from gainproof.verify.judge.verdict_words import Shown

BITS = 128
ORDERS = frozenset(("<", "<=", ">", ">=", "!="))


def judge_identity(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether all relations hold wherever the conditions do."""
    relations = resolved(reading.relations, scope)
    printed = resolved(reading.conditions, scope)
    frame = framed(claim, scope, printed, relations if claim.kind == "recursion" else ())
    found = finding_of(frame.decide(Statement(relations, (), "if", tuple(scope.needed))))
    if found.witness is None or len(relations) == len(reading.relations):
        return found
    note = _entry(found.witness, reading.relations, scope, frame.labels)
    if found.witness.note or not note:
        return found
    return replace(found, witness=replace(found.witness, note=note, shows=Shown.ENTRY))


def _entry(
    witness: Witness, printed: tuple[Relation, ...], scope: Scope, labels: Mapping[str, str]
) -> str:
    """In which entry of matrices both sides are what the witness shows; empty if in none."""
    names = {label: name for name, label in labels.items()}
    try:
        at = {names.get(label, label): Fraction(v) for label, v in witness.point.items()}
        shown = [float(side.midpoint) for side in (witness.left, witness.right)]
    except ValueError:
        return ""
    for relation in printed:
        columns = max(shape(scope.value(side))[1] for side in (relation.left, relation.right))
        rels = scope.relations(relation)
        for place, rel in enumerate(rels) if len(rels) > 1 else ():
            try:
                values = [float(enclosed(side, at, BITS).mid()) for side in (rel.left, rel.right)]
            except (NoValue, Unresolved):
                continue
            if all(isclose(a, b, rel_tol=1e-9) for a, b in zip(values, shown, strict=True)):
                return f"entry ({place // columns + 1}, {place % columns + 1})"
    return ""


def resolved(relations: tuple[Relation, ...], scope: Scope) -> tuple[Rel, ...]:
    """Relations in base variables, those between matrices entry by entry. Raises Undecided."""
    found = tuple(rel for relation in relations for rel in scope.relations(relation))
    only_plain(found)
    return found


IDENTITY = Kind(
    "identity",
    "both sides are equal on the domain",
    judge_identity,
    operators=EQUATION,
    settings="any",
    pointwise=True,
)
INEQUALITY = Kind(
    "inequality",
    r"`<`, `\leq`, `>`, `\geq` or `\neq` holds on the domain",
    judge_identity,
    operators=ORDERS,
    settings="any",
    pointwise=True,
    strongest=True,
)
RECURSION = Kind(
    "recursion",
    "the equation holds for every sample of the filter",
    judge_identity,
    operators=EQUATION,
    pointwise=True,
)
