"""Checking whole certificates; nothing a certificate holds makes these functions raise."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from time import perf_counter
from typing import Any

from gainproof.verify.certificate.document import Document, Statement, read_document
from gainproof.verify.certificate.expected_claims import Expectation, read_expectation
from gainproof.verify.certificate.plain_data import plain
from gainproof.verify.certificate.rejection import GivenUpError, Meter, RejectedError
from gainproof.verify.certificate.report import CertificateReport, StatementResult


def check(
    certificate: Mapping[str, Any],
    claims: Sequence[Mapping[str, Any]] | None = None,
    model: Mapping[str, Any] | None = None,
    domain: Mapping[str, Any] | None = None,
    programs: Mapping[str, Any] | None = None,
    towers: Mapping[str, Any] | None = None,
) -> CertificateReport:
    """Decide every statement of a certificate, exactly.

    ``claims`` (records of id, kind, claim, and tower unless it is "main", in order), ``model``
    (the model of every statement about one), ``domain`` (the parameters of every tower by its
    name), ``programs`` and ``towers`` (by name, whole: what every name in a claim stands for) are
    what the caller expects; any difference is a rejection. What is not given is not compared.
    """
    try:
        expectation = read_expectation(claims, model, domain, programs, towers)
        value = plain(certificate)
        document = read_document(value, Meter())
        disagreement = expectation.of_document(value)
    except RejectedError as rejection:
        too_long = isinstance(rejection, GivenUpError)
        return CertificateReport("", False, str(rejection), (), too_long)
    except Exception as error:  # noqa: BLE001 - a hostile file is rejected, it never crashes us
        return CertificateReport("", False, f"malformed: {type(error).__name__}", ())
    if disagreement is not None:
        return CertificateReport(document.subject, False, f"not as expected: {disagreement}", ())
    results = tuple(
        decide(document, number, statement, expectation)
        for number, statement in enumerate(document.statements)
    )
    reason = _reason(document, results)
    statuses = {result.status for result in results}
    too_long = "given up" in statuses and "rejected" not in statuses
    return CertificateReport(document.subject, not reason, reason, results, too_long)


def check_statement(certificate: Mapping[str, Any], statement_id: str) -> StatementResult:
    """Decide one statement of a certificate, without the others."""
    try:
        document = read_document(plain(certificate), Meter())
    except RejectedError as rejection:
        return StatementResult(statement_id, "", "rejected", str(rejection), 0.0)
    except Exception as error:  # noqa: BLE001 - as above
        return StatementResult(
            statement_id, "", "rejected", f"malformed: {type(error).__name__}", 0.0
        )
    for number, statement in enumerate(document.statements):
        if statement.id == statement_id:
            return decide(document, number, statement, Expectation(None, None, None, None))
    return StatementResult(statement_id, "", "rejected", "there is no statement of that id", 0.0)


def decide(
    document: Document,
    number: int,
    statement: Statement,
    expectation: Expectation,
) -> StatementResult:
    """Compare one statement with what is expected, then decide it."""
    start = perf_counter()
    status, reason = "rejected", ""
    try:
        disagreement = expectation.of_statement(number, statement)
        if disagreement is not None:
            reason = f"not as expected: {disagreement}"
        else:
            status = document.decide(statement)
    except RejectedError as rejection:
        reason = str(rejection)
        if isinstance(rejection, GivenUpError):
            status = "given up"
    except Exception as error:  # noqa: BLE001 - as above
        reason = f"malformed: {type(error).__name__}: {error}"
    return StatementResult(statement.id, statement.kind, status, reason, perf_counter() - start)


def _reason(document: Document, results: tuple[StatementResult, ...]) -> str:
    for result in results:
        if result.status in ("rejected", "given up"):
            return f"{result.id}: {result.reason}"
    if not any(result.status == "proved" for result in results):
        return "nothing is proved"
    try:
        document.require_coherent()
    except RejectedError as rejection:
        return str(rejection)
    return ""
