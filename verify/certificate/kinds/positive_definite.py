"""Positive definite matrices, by their leading minors."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.matrix import determinant
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import RejectedError


def positive_definite(case: Case) -> str:
    """The symmetric matrix of named elements is positive definite at every point of the tower.

    Claim: matrix (square array of names). Evidence: minors (manifestly positive fractions equal to
    the leading minors, the smallest first).
    """
    claim = case.claims("matrix")
    evidence = case.evidences("minors")
    matrix = case.square(claim["matrix"], "matrix")
    require_leading_minors(case, evidence["minors"], matrix, "minors")
    return "proved"


def require_leading_minors(case: Case, value: Plain, matrix: list[list[Ratio]], field: str) -> None:
    """Reject unless the fractions listed in the evidence are the leading minors, and positive."""
    listed = schema.items(value, f"{case.place}.evidence.{field}")
    if len(listed) != len(matrix):
        raise RejectedError(f"{len(matrix)} minors wanted, {len(listed)} found")
    for number, entry in enumerate(listed):
        stated = case.fraction(entry, f"{field}[{number}]").positive(case.tower.field)
        corner = tuple(tuple(row[: number + 1]) for row in matrix[: number + 1])
        if not determinant(corner).equals(stated):
            raise RejectedError(f"{field}[{number}]: the leading minor is another one")
