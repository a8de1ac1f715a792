"""What came of checking a certificate."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class StatementResult:
    """One statement: ``status`` is "proved", "cited", "definition", "rejected", or "given up" where
    it is beyond the limits of the checker.

    ``reason`` is empty unless it was rejected or given up; ``seconds`` is the time its check took.
    """

    id: str
    kind: str
    status: str
    reason: str
    seconds: float


@dataclass(frozen=True, slots=True)
class CertificateReport:
    """A whole certificate.

    ``accepted`` holds when the file is well formed, agrees with everything expected of it, has a
    proved statement, and no statement was rejected or given up. Otherwise ``reason`` says what
    failed first, and ``given_up`` whether it is only too long: nothing of it is known to be wrong.
    """

    subject: str
    accepted: bool
    reason: str
    statements: tuple[StatementResult, ...]
    given_up: bool = False

    def count(self, status: str) -> int:
        """How many statements have this status."""
        return sum(result.status == status for result in self.statements)
