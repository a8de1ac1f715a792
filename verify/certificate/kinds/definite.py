"""Positive definite matrices, by their leading minors."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.case import Case
from gainproof.verify.certificate.matrix import determinant
from gainproof.verify.certificate.rejection import RejectedError


def positive_definite(case: Case) -> str:
    """The symmetric matrix of named elements is positive definite at every point of the tower.

    Claim: matrix (square array of names). Evidence: minors (manifestly positive fractions equal to
    the leading minors, the smallest first).
    """
    claim = case.claims("matrix")
    evidence = case.evidences("minors")
    matrix = case.square(claim["matrix"], "matrix")
    listed = schema.items(evidence["minors"], f"{case.place}.evidence.minors")
    if len(listed) != len(matrix):
        raise RejectedError(f"{len(matrix)} minors wanted, {len(listed)} found")
    for number, entry in enumerate(listed):
        stated = case.fraction(entry, f"minors[{number}]").positive(case.tower.field)
        corner = tuple(tuple(row[: number + 1]) for row in matrix[: number + 1])
        if not determinant(corner).equals(stated):
            raise RejectedError(f"minors[{number}]: the leading minor is another one")
    return "proved"
