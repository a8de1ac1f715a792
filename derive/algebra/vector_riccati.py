"""Evidence for a steady state with a vector measurement, written in the updated covariance."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from gainproof.derive.algebra.cofactors import cofactors
from gainproof.derive.algebra.model_entries import matrix_of
from gainproof.derive.algebra.plain import poly_data
from gainproof.derive.algebra.signs import shown
from gainproof.derive.algebra.tower import Poly, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real


def vector_riccati_evidence(step: Step, tower: Tower) -> dict[str, Any]:
    """Common denominator d of M = A/d and X = B/d, the inverse V/w of R, minors, cofactors.

    Residuals: prediction A - F B F' - d q Q0, update B (w d I + H' V H A) - w d A. They are short
    when the tower writes all entries over one denominator. The hint may hold "innovation": forms
    that show the signs of the leading minors of H M H' + R.
    """
    parts = step.relation.parts
    model = parts["model"]
    below, (before, after) = _common(tower, parts["predicted"], parts["updated"])
    size = len(before)
    transition, noise, measurement = (
        _matrix(tower, model[key]) for key in ("transition", "process_noise", "measurement")
    )
    precision, scale = _precision(tower, model["measurement_noise"])
    first, second = _wrapped(tower, before), _wrapped(tower, after)
    index = tower.fraction(real(parts["index"]))
    one = _scalar(tower, tower.ring.one, size)
    strength = _scalar(tower, below * index.num**2, size)
    moved = first - transition * second * transition.transpose()
    prediction = _scalar(tower, index.den**2, size) * moved - strength * noise
    common = _scalar(tower, scale * below, size)
    information = measurement.transpose() * precision * measurement
    update = second * (common * one + information * first) - common * first
    places = [(i, j) for i in range(size) for j in range(size)]
    return {
        "denominator": poly_data(below),
        "predicted": [[poly_data(entry) for entry in row] for row in before],
        "updated": [[poly_data(entry) for entry in row] for row in after],
        "precision": {
            "numerators": [
                [poly_data(_element(precision, i, j)) for j in range(len(row))]
                for i, row in enumerate(model["measurement_noise"])
            ],
            "denominator": poly_data(scale),
        },
        "innovation": _innovation(step, tower),
        "prediction": {
            f"{i + 1},{j + 1}": _written(tower, _element(prediction, i, j))
            for i, j in places
            if i <= j
        },
        "update": {f"{i + 1},{j + 1}": _written(tower, _element(update, i, j)) for i, j in places},
    }


def _common(tower: Tower, *names: Any) -> tuple[Poly, list[list[list[Poly]]]]:
    """The least common denominator of all named entries, and their numerators over it."""
    squares = [[[tower.elements[name] for name in row] for row in rows] for rows in names]
    below: Poly = tower.ring.one
    for entry in (entry for rows in squares for row in rows for entry in row):
        below = below.lcm(entry.den)
    return below, [
        [[entry.num * below.quo(entry.den) for entry in row] for row in rows] for rows in squares
    ]


def _precision(tower: Tower, rows: list[list[Any]]) -> tuple[DomainMatrix, Poly]:
    """V and w with R V = w I: the adjugate and the determinant, over one denominator."""
    noise = matrix_of(rows)
    inverse = noise.adjugate() / noise.det()
    entries = [[tower.fraction(entry) for entry in row] for row in inverse.tolist()]
    scale: Poly = tower.ring.one
    for entry in (entry for row in entries for entry in row):
        scale = scale.lcm(entry.den)
    return (
        _wrapped(tower, [[entry.num * scale.quo(entry.den) for entry in row] for row in entries]),
        scale,
    )


def _innovation(step: Step, tower: Tower) -> list[dict[str, Any]]:
    """Positive forms of the leading minors of H M H' + R."""
    parts = step.relation.parts
    model = parts["model"]
    predicted = sp.ImmutableDenseMatrix(
        [[real(name) for name in row] for row in parts["predicted"]]
    )
    measurement = matrix_of(model["measurement"])
    rows = measurement * predicted * measurement.T + matrix_of(model["measurement_noise"])
    forms = step.hint.get("innovation") or [
        sp.expand(rows[:n, :n].det()) for n in range(1, rows.rows + 1)
    ]
    return [shown(tower, form) for form in forms]


def _matrix(tower: Tower, rows: list[list[Any]]) -> DomainMatrix:
    """Entries of the model as polynomials of the tower."""
    entries = [[tower.fraction(entry) for entry in row] for row in matrix_of(rows).tolist()]
    if any(entry.den != tower.ring.one for row in entries for entry in row):
        raise ValueError(f"entries that are polynomials in tower {tower.name} are wanted: {rows}")
    return _wrapped(tower, [[entry.num for entry in row] for row in entries])


def _wrapped(tower: Tower, rows: list[list[Poly]]) -> DomainMatrix:
    domain = tower.ring.to_domain()
    converted = [[domain.convert(entry) for entry in row] for row in rows]
    return DomainMatrix(converted, (len(rows), len(rows[0])), domain)


def _scalar(tower: Tower, value: Poly, size: int) -> DomainMatrix:
    zero = tower.ring.zero
    return _wrapped(tower, [[value if i == j else zero for j in range(size)] for i in range(size)])


def _element(matrix: DomainMatrix, row: int, column: int) -> Poly:
    return matrix[row, column].element


def _written(tower: Tower, residual: Poly) -> list[Any]:
    return [poly_data(part) for part in cofactors(tower, residual)]
