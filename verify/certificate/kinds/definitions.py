"""Statements that prove nothing: definitions and cited theorems."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.graph import Symbol
from gainproof.verify.certificate.rejection import RejectedError


def definition(case: Case) -> str:
    """What a symbol means: in words ("text"), or as an expression ("left", "right").

    When the left side is one symbol of the tower, the tower must agree with the right side (a
    generator, for instance, with the root it is). Otherwise there is nothing to decide.
    Evidence: none, an empty record.
    """
    case.evidences()
    place = f"{case.place}.claim"
    if "text" in schema.table(case.claim, place):
        schema.text(case.claims("text")["text"], f"{place}.text")
        return "definition"
    claim = case.claims("left", "right")
    left = case.expression(claim["left"], "left")
    right = case.expression(claim["right"], "right")
    node = left.nodes[left.outputs["value"]]
    if isinstance(node, Symbol) and case.tower.knows(node.name):
        evaluation = case.evaluation(case.no_fractions())
        if not evaluation.scalar(left).equals(evaluation.scalar(right)):
            raise RejectedError(f"the tower defines {node.name!r} otherwise")
    return "definition"


def cited(case: Case) -> str:
    """A theorem taken from the literature: reported as cited, never as proved.

    Claim: theorem, reference (text). Evidence: none, an empty record.
    """
    case.evidences()
    claim = case.claims("theorem", "reference")
    for field in ("theorem", "reference"):
        schema.text(claim[field], f"{case.place}.claim.{field}")
    return "cited"
