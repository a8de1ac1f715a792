"""The steady state of the Kalman filter: M = F X F' + q Q0 with X = M - K H M, as polynomials."""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.case import Case
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.model import Model, read_model
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio, polynomial
from gainproof.verify.certificate.rejection import RejectedError

_Square = list[list[Polynomial]]


def riccati(case: Case) -> str:
    """The named predicted and updated covariances and gain are a steady state of the model.

    That is M = F X F' + q Q0, K = M H' / (H M H' + R), X = M - K H M, with H M H' + R > 0 and
    q the square of the index.
    Claim: model, predicted, updated (square arrays of names), gain (names), index (name).
    Evidence: denominator d, numerators A (M = A/d), cofactors: for each "i,j" with i <= j one
    polynomial per generator, so that the residual times d s D^2, expanded without any reduction,
    is the sum of cofactor times (y^n - radicand); D is the index's denominator as written.
    """
    claim = case.claims("model", "predicted", "updated", "gain", "index")
    evidence = case.evidences("denominator", "numerators", "cofactors")
    field = case.tower.field
    model = read_model(claim["model"], f"{case.place}.claim.model")
    size = model.size
    predicted = case.square(claim["predicted"], "predicted")
    updated = case.square(claim["updated"], "updated")
    gain = case.names(claim["gain"], "gain")
    if not len(predicted) == len(updated) == len(gain) == size:
        raise RejectedError(f"{size} states in the model, other sizes in the claim")
    index, index_below = _index(case, claim["index"])
    below = case.polynomial(evidence["denominator"], "denominator")
    above = _numerators(case, evidence["numerators"], size)
    if not field.positive(below):
        raise RejectedError("the denominator is not manifestly positive")
    column = [
        _sum(field, (above[i][k].times(model.measurement[k]) for k in range(size)))
        for i in range(size)
    ]
    variance = _sum(field, (column[k].times(model.measurement[k]) for k in range(size)))
    variance = variance + below.times(model.measurement_noise)
    if not field.positive(variance):
        raise RejectedError("the innovation variance is not manifestly positive")
    over_below, over_variance = polynomial(field, below), polynomial(field, variance)
    for i in range(size):
        _same(polynomial(field, column[i]).over(over_variance), gain[i], f"gain {i + 1}")
        for j in range(size):
            entry = polynomial(field, above[i][j]).over(over_below)
            _same(entry, predicted[i][j], f"predicted {i + 1},{j + 1}")
            change = polynomial(field, column[i] * column[j]).over(over_below).over(over_variance)
            _same(entry - change, updated[i][j], f"updated {i + 1},{j + 1}")
    scales = index_below * index_below, below * index * index
    residual = _residual(field, model, above, column, variance, scales)
    _check_cofactors(case, evidence["cofactors"], residual)
    return "proved"


def _residual(
    field: Field,
    model: Model,
    above: _Square,
    column: list[Polynomial],
    variance: Polynomial,
    scales: tuple[Polynomial, Polynomial],
) -> _Square:
    """``D^2 (s (F A F' - A) - F a a' F') + s d N^2 Q0``, not reduced.

    a = A H', s = H a + R d, the index is N/D; ``scales`` are D^2 and d N^2.
    """
    size = model.size
    moved = _transformed(field, model, above)
    outer = [[first * second for second in column] for first in column]
    moved_outer = _transformed(field, model, outer)
    outside, noise = scales[0], variance * scales[1]
    return [
        [
            outside * (variance * (moved[i][j] - above[i][j]) - moved_outer[i][j])
            + noise.times(model.process_noise[i][j])
            for j in range(size)
        ]
        for i in range(size)
    ]


def _transformed(field: Field, model: Model, square: _Square) -> _Square:
    """``F square F'``."""
    steps, size = model.transition, model.size
    half = [
        [_sum(field, (square[k][j].times(steps[i][k]) for k in range(size))) for j in range(size)]
        for i in range(size)
    ]
    return [
        [_sum(field, (half[i][k].times(steps[j][k]) for k in range(size))) for j in range(size)]
        for i in range(size)
    ]


def _check_cofactors(case: Case, value: Plain, residual: _Square) -> None:
    """Each residual must be the stated combination of the relations, term by term."""
    field = case.tower.field
    size = len(residual)
    relations = [field.relation(number) for number in range(len(field.generators))]
    places = [(i, j) for i in range(size) for j in range(i, size)]
    wanted = tuple(f"{i + 1},{j + 1}" for i, j in places)
    entries = schema.record(value, wanted, f"{case.place}.evidence.cofactors")
    for (i, j), key in zip(places, wanted, strict=True):
        listed = schema.items(entries[key], f"{case.place}.evidence.cofactors.{key}")
        if len(listed) != len(relations):
            raise RejectedError(f"cofactors {key}: {len(relations)} polynomials wanted")
        combination = _sum(
            field,
            (
                case.polynomial(cofactor, f"cofactors.{key}") * relation
                for cofactor, relation in zip(listed, relations, strict=True)
            ),
        )
        if combination != residual[i][j]:
            raise RejectedError(
                f"the residual {key} is not the stated combination of the generators' relations"
            )


def _index(case: Case, value: Plain) -> tuple[Polynomial, Polynomial]:
    """The index as it is written: numerator and denominator."""
    name = schema.name(value, f"{case.place}.claim.index")
    index = case.tower.value(name)
    if name in case.tower.written:
        fraction = case.tower.written[name]
        return fraction.numerator, fraction.denominator
    return index.numerator, case.tower.field.ring.constant(1)


def _numerators(case: Case, value: Plain, size: int) -> _Square:
    rows = [
        [
            case.polynomial(entry, "numerators")
            for entry in schema.items(row, f"{case.place}.evidence.numerators")
        ]
        for row in schema.items(value, f"{case.place}.evidence.numerators")
    ]
    if len(rows) != size or any(len(row) != size for row in rows):
        raise RejectedError(f"numerators: {size} rows of {size} wanted")
    if any(rows[i][j] != rows[j][i] for i in range(size) for j in range(i)):
        raise RejectedError("numerators: not symmetric")
    return rows


def _sum(field: Field, terms: Iterable[Polynomial]) -> Polynomial:
    result = field.ring.constant(0)
    for term in terms:
        result = result + term
    return result


def _same(found: Ratio, named: Ratio, what: str) -> None:
    if not found.equals(named):
        raise RejectedError(f"{what}: the named element is another one")
