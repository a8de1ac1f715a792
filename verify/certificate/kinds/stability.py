"""Stability of the closed loop: the rows of Schur and Cohn, each manifestly positive."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.case import Case
from gainproof.verify.certificate.matrix import Matrix, characteristic_polynomial
from gainproof.verify.certificate.model import Model, read_model
from gainproof.verify.certificate.ratio import Ratio, number, total
from gainproof.verify.certificate.rejection import RejectedError


def stable(case: Case) -> str:
    """Every eigenvalue of F (I - K H) lies inside the unit circle.

    Claim: model, gain (names). Evidence: values: for degree n, n-1, ..., 1 of the characteristic
    polynomial a_0 + ... + a_n z^n (at first a_n = 1) the two manifestly positive fractions
    a_n - a_0 and a_n + a_0, after which a_k becomes a_n a_(k+1) - a_0 a_(n-k-1).
    """
    claim = case.claims("model", "gain")
    evidence = case.evidences("values")
    model = read_model(claim["model"], f"{case.place}.claim.model")
    gain = case.names(claim["gain"], "gain")
    if len(gain) != model.size:
        raise RejectedError(f"{model.size} gains wanted, {len(gain)} named")
    listed = schema.items(evidence["values"], f"{case.place}.evidence.values")
    if len(listed) != 2 * model.size:
        raise RejectedError(f"{2 * model.size} values wanted, {len(listed)} found")
    row = characteristic_polynomial(_closed_loop(model, gain))
    for step in range(model.size):
        first, last = row[0], row[-1]
        for offset, quantity in enumerate((last - first, last + first)):
            where = f"values[{2 * step + offset}]"
            stated = case.fraction(listed[2 * step + offset], where)
            if not quantity.equals(stated.positive(case.tower.field)):
                raise RejectedError(f"{where}: the Schur-Cohn quantity is another one")
        degree = len(row) - 1
        row = [last * row[k + 1] - first * row[degree - k - 1] for k in range(degree)]
    return "proved"


def _closed_loop(model: Model, gain: list[Ratio]) -> Matrix:
    """``F (I - K H)``."""
    field = gain[0].field
    size = model.size
    inner = [
        [
            number(field, int(i == j)) - gain[i] * number(field, model.measurement[j])
            for j in range(size)
        ]
        for i in range(size)
    ]
    return Matrix(
        tuple(
            tuple(
                total(
                    field,
                    (inner[k][j] * number(field, model.transition[i][k]) for k in range(size)),
                )
                for j in range(size)
            )
            for i in range(size)
        )
    )
