"""Stability of the closed loop: the rows of Schur and Cohn, each manifestly positive."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.matrix import (
    Matrix,
    characteristic_polynomial,
    identity,
    principal_coefficients,
)
from gainproof.verify.certificate.model import Model, read_model
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.ratio import Ratio, number
from gainproof.verify.certificate.rejection import RejectedError


def stable(case: Case) -> str:
    """Every eigenvalue of F (I - K H) lies inside the unit circle.

    Claim: model, gain (a list of names for one measurement, or rows of names). Evidence: values:
    for degree n, n-1, ..., 1 of the characteristic polynomial a_0 + ... + a_n z^n (at first
    a_n = 1) the two manifestly positive fractions a_n - a_0 and a_n + a_0, after which a_k becomes
    a_n a_(k+1) - a_0 a_(n-k-1). With rows of names also coefficients: a_0, ..., a_(n-1) as
    fractions, which keep the values short.
    """
    claim = case.claims("model", "gain")
    model = read_model(case, claim["model"])
    if isinstance(claim["gain"], list) and any(isinstance(row, list) for row in claim["gain"]):
        evidence = case.evidences("coefficients", "values")
        loop = _closed_loop(model, _gain(case, claim["gain"], model))
        row = _stated_coefficients(case, evidence["coefficients"], loop)
    else:
        evidence = case.evidences("values")
        row = characteristic_polynomial(_closed_loop(model, _gain(case, claim["gain"], model)))
    listed = schema.items(evidence["values"], f"{case.place}.evidence.values")
    if len(listed) != 2 * model.size:
        raise RejectedError(f"{2 * model.size} values wanted, {len(listed)} found")
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


def _stated_coefficients(case: Case, value: Plain, loop: Matrix) -> list[Ratio]:
    """a_0, ..., a_n = 1 as the evidence writes them, each equal to what the loop has."""
    listed = schema.items(value, f"{case.place}.evidence.coefficients")
    size = loop.shape[0]
    if len(listed) != size:
        raise RejectedError(f"{size} coefficients wanted, {len(listed)} found")
    field = case.tower.field
    stated = [
        case.fraction(entry, f"coefficients[{k}]").ratio(field) for k, entry in enumerate(listed)
    ]
    for k, found in enumerate(principal_coefficients(loop)[:size]):
        if not found.equals(stated[k]):
            raise RejectedError(f"coefficients[{k}]: the closed loop has another one")
    return [*stated, number(field, 1)]


def _gain(case: Case, value: Plain, model: Model) -> Matrix:
    """The named gain as a matrix of the shape that the model wants."""
    rows: tuple[tuple[Ratio, ...], ...]
    if isinstance(value, list) and any(isinstance(row, list) for row in value):
        rows = case.rows(value, "gain")
    else:
        rows = tuple((entry,) for entry in case.names(value, "gain"))
    wanted = model.size, model.measured
    if (len(rows), len(rows[0])) != wanted:
        raise RejectedError(
            f"{wanted[0]} gains wanted for each of {wanted[1]} measured values, "
            f"{len(rows)} by {len(rows[0])} named"
        )
    return Matrix(rows)


def _closed_loop(model: Model, gain: Matrix) -> Matrix:
    """``F (I - K H)``."""
    field = gain.rows[0][0].field
    taken = gain.times(Matrix(model.measurement)).scaled(number(field, -1))
    return Matrix(model.transition).times(identity(field, model.size).plus(taken))
