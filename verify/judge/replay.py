"""Proofs and refutations of the judge, gone through again from their certificates alone.

A certificate names the statement as plain data. Replaying builds the tower anew, forms norms and
candidates anew, and must come to the same verdict on the same places. It shares the judge's code,
which is why these proofs are marked `replayed`; of many `check_answer` decides the statement apart.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.certificate import statement_from
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.formal_identities import decide_formally
from gainproof.verify.judge.exact.rational_points import is_seen
from gainproof.verify.judge.exact.statement import NEGATED, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.setting.chart_decision import INSIDE, Plane
from gainproof.verify.judge.transcendental.decision import decided
from gainproof.verify.judge.verdict_words import DECIDES

FIELDS = (
    "tower",
    "candidates",
    "places",
    "projection",
    "of one sign",
    "count",
    "borders",
    "slopes",
)
"""Of a certificate what has to come out again."""


def replay(certificate: Mapping[str, Any], verdict: str) -> str | None:
    """None if the certificate leads to the verdict again, else what differs. Never raises.

    What is refuted or conditional may rest on a part of the claim, or on one convention: then the
    certificate says what that part comes to. A proof rests on its own statement alone, or on
    several that it names, each of which has to be proved unless it says what it comes to: the
    worst of them is what they come to together.
    """
    wanted = verdict if verdict == "proved" else certificate.get(DECIDES, verdict)
    if "statement" not in certificate:
        parts = statements_of(certificate)
        if not parts:
            return "cannot be replayed: no statement"
        each = {name: p.get(DECIDES, "proved") for name, p in parts.items()}
        together = next((v for v in ("refuted", "conditional") if v in each.values()), "proved")
        if together != wanted:
            return f"wanted {wanted}, but its parts come to {together}"
        found = {name: replay(p, each[name]) for name, p in parts.items()}
        return next((f"{name}: {why}" for name, why in found.items() if why is not None), None)
    try:
        statement, boxes, parameter, labels = statement_from(certificate["statement"])
        if certificate.get("engine") == "balls":
            came = _by_balls(statement)
            return None if came == wanted else f"wanted {wanted}, got {came}"
        if certificate.get("engine") == "cells":
            outcome = decide_in_cells(statement, boxes, labels)
        elif certificate.get("engine") == "formal":
            outcome = decide_formally(statement, boxes, labels)
        elif certificate.get("engine") == "chart":
            plane = Plane(tuple(certificate["names"]), INSIDE[certificate["signs"]])
            outcome = plane.decide(statement, boxes, labels)
        elif certificate.get("engine") == "functions":
            outcome = decided(statement, boxes, parameter, labels)
        else:
            outcome = decide(statement, boxes, parameter, labels)
    except (KeyError, TypeError, ValueError, Malformed, Undecided) as reason:
        return f"cannot be replayed: {reason}"
    if outcome.verdict != wanted:
        return f"wanted {wanted}, got {outcome.verdict}"
    for field in FIELDS:
        if outcome.certificate.get(field) != certificate.get(field):
            return f"{field} differ"
    return None


def _by_balls(statement: Statement) -> str:
    """What balls show of inequalities between numbers."""
    if all(is_seen(rel) for rel in statement.relations):
        return "proved"
    opposite = (Rel(NEGATED[r.operator], r.left, r.right) for r in statement.relations)
    return "refuted" if any(map(is_seen, opposite)) else "undecided"


def statements_of(certificate: Mapping[str, Any]) -> dict[str, Mapping[str, Any]]:
    """The parts of a certificate that hold a statement, by name; "" for the whole."""
    if "statement" in certificate:
        return {"": certificate}
    return {
        name: part
        for name, part in certificate.items()
        if isinstance(part, Mapping) and "statement" in part
    }


def replay_json(claim: Mapping[str, Any]) -> str | None:
    """The same for a claim of `check --json`; None also where there is nothing to replay."""
    certificate = claim["evidence"]["certificate"]
    if not certificate or not statements_of(certificate):
        return None
    return replay(certificate, claim["verdict"])
