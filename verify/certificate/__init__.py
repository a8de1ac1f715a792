"""Certificates checked."""

from __future__ import annotations

from gainproof.verify.certificate.checker import check, check_statement
from gainproof.verify.certificate.read import read_certificate
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.report import CertificateReport, StatementResult

__all__ = [
    "CertificateReport",
    "RejectedError",
    "StatementResult",
    "check",
    "check_statement",
    "read_certificate",
]
