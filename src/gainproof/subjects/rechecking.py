"""Certificates checked against what the derivation is expected to prove, as plain data."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from gainproof.subjects.choice_sides import missing_sides
from gainproof.verify.certificate import check

if TYPE_CHECKING:
    from gainproof.subjects.derived import Derived


def expected_of(derived: Derived) -> dict[str, Any]:
    """What a certificate of this subject has to prove, taken from a derivation made afresh."""
    return {
        "subject": derived.name,
        "claims": list(derived.claims),
        "model": derived.model,
        "domain": dict(derived.domains),
        "programs": dict(derived.programs),
        "towers": dict(derived.certificate["towers"]),
        "kernels": {kernel["name"]: kernel["programs"] for kernel in derived.kernels},
    }


def recheck(certificate: Any, expected: Mapping[str, Any]) -> dict[str, Any]:
    """{"subject", "accepted", "reason", "given_up", "statements"}: the checker's report as plain
    data.

    A statement is {"id", "kind", "status", "reason", "seconds"}. Rejected too: a certificate that
    says nothing of one of the kernels' outputs, or speaks of one side of a choice only.
    """
    report = check(
        certificate,
        claims=expected["claims"],
        model=expected["model"],
        domain=expected["domain"],
        programs=expected["programs"],
        towers=expected["towers"],
    )
    statements = [
        {
            "id": result.id,
            "kind": result.kind,
            "status": result.status,
            "reason": result.reason,
            "seconds": result.seconds,
        }
        for result in report.statements
    ]
    reason = report.reason
    if report.accepted:
        reason = (
            _unproved_outputs(expected)
            or missing_sides(certificate)
            or _other_subject(report.subject, expected)
        )
    return {
        "subject": expected["subject"],
        "accepted": report.accepted and not reason,
        "reason": reason,
        "given_up": report.given_up,
        "statements": statements,
    }


def _unproved_outputs(expected: Mapping[str, Any]) -> str:
    claimed = {
        (entry["claim"]["program"], output)
        for entry in expected["claims"]
        if entry["kind"] == "program"
        for output in entry["claim"]["outputs"]
    }
    missing = [
        f"{program}.{output}"
        for programs in expected["kernels"].values()
        for program in programs
        for output in expected["programs"][program]["graph"]["outputs"]
        if (program, output) not in claimed
    ]
    return f"no statement says what these outputs are: {', '.join(missing)}" if missing else ""


def _other_subject(subject: str, expected: Mapping[str, Any]) -> str:
    wanted = expected["subject"]
    return "" if subject == wanted else f"the subject {wanted!r} is expected, {subject!r} found"
