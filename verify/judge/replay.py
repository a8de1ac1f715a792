"""Proofs and refutations of the judge, gone through again from their certificates alone.

A certificate names the statement as plain data. Replaying builds the tower anew, forms norms and
candidates anew, and must come to the same verdict on the same places. It shares the judge's code:
an independent checker does not exist for these proofs yet, which is why they are marked `replayed`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.certificate import statement_from
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.formal import decide_formally
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.freed.deciding import decided

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
    certificate says what that part comes to. A proof rests on its own statement alone.
    """
    wanted = verdict if verdict == "proved" else certificate.get("decides", verdict)
    try:
        statement, boxes, parameter, labels = statement_from(certificate["statement"])
        if certificate.get("engine") == "cells":
            outcome = decide_in_cells(statement, boxes, labels)
        elif certificate.get("engine") == "formal":
            outcome = decide_formally(statement, boxes, labels)
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


def replay_json(claim: Mapping[str, Any]) -> str | None:
    """The same for a claim of `check --json`; None also where there is nothing to replay."""
    certificate = claim["evidence"]["certificate"]
    if not certificate or "statement" not in certificate:
        return None
    return replay(certificate, claim["verdict"])
