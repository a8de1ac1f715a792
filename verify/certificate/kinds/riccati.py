"""The steady state of the Kalman filter: M = F X F' + q Q0 with X = M - K H M, as polynomials."""

from __future__ import annotations

from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.kinds.combination import (
    Square,
    index_as_written,
    require_combinations,
    require_same,
    square,
    total,
)
from gainproof.verify.certificate.kinds.vector_riccati import vector_riccati
from gainproof.verify.certificate.model import Model, Numbers, numbers, read_model
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import polynomial
from gainproof.verify.certificate.rejection import RejectedError


def riccati(case: Case) -> str:
    """The named predicted and updated covariances and gain are a steady state of the model.

    That is M = F X F' + q Q0, K (H M H' + R) = M H', X = M - K H M, with H M H' + R positive
    definite and q the square of the index.
    Claim: model, predicted, updated (square arrays of names), gain, index (name). The gain is a
    list of names for one measurement in a model of numbers, decided here; rows of names for a
    vector measurement, see `vector_riccati`.
    Evidence here: denominator d, numerators A (M = A/d), cofactors: for each "i,j" with i <= j one
    polynomial per generator, so that the residual times d s D^2, expanded without any reduction,
    is the sum of cofactor times (y^n - radicand); D is the index's denominator as written.
    """
    claim = case.claims("model", "predicted", "updated", "gain", "index")
    model = read_model(case, claim["model"])
    if isinstance(claim["gain"], list) and any(isinstance(row, list) for row in claim["gain"]):
        return vector_riccati(case, model)
    plain = _OneMeasurement(model)
    evidence = case.evidences("denominator", "numerators", "cofactors")
    field = case.tower.field
    size = model.size
    predicted = case.square(claim["predicted"], "predicted")
    updated = case.square(claim["updated"], "updated")
    gain = case.names(claim["gain"], "gain")
    if not len(predicted) == len(updated) == len(gain) == size:
        raise RejectedError(f"{size} states in the model, other sizes in the claim")
    index, index_below = index_as_written(case, claim["index"])
    below = case.polynomial(evidence["denominator"], "denominator")
    above = square(case, evidence["numerators"], size, "numerators")
    if not field.positive(below):
        raise RejectedError("the denominator is not manifestly positive")
    column = [
        total(field, (above[i][k].times(plain.measurement[k]) for k in range(size)))
        for i in range(size)
    ]
    variance = total(field, (column[k].times(plain.measurement[k]) for k in range(size)))
    variance = variance + below.times(plain.measurement_noise)
    if not field.positive(variance):
        raise RejectedError("the innovation variance is not manifestly positive")
    over_below, over_variance = polynomial(field, below), polynomial(field, variance)
    for i in range(size):
        require_same(polynomial(field, column[i]).over(over_variance), gain[i], f"gain {i + 1}")
        for j in range(size):
            entry = polynomial(field, above[i][j]).over(over_below)
            require_same(entry, predicted[i][j], f"predicted {i + 1},{j + 1}")
            change = polynomial(field, column[i] * column[j]).over(over_below).over(over_variance)
            require_same(entry - change, updated[i][j], f"updated {i + 1},{j + 1}")
    scales = index_below * index_below, below * index * index
    residual = _residual(field, plain, above, column, variance, scales)
    residuals = {f"{i + 1},{j + 1}": residual[i][j] for i in range(size) for j in range(i, size)}
    require_combinations(case, evidence["cofactors"], residuals, "cofactors")
    return "proved"


class _OneMeasurement:
    """The numbers of a model with one measurement. Raises RejectedError for another model."""

    def __init__(self, model: Model) -> None:
        transition, noise = numbers(model.transition), numbers(model.process_noise)
        measurement, measured = numbers(model.measurement), numbers(model.measurement_noise)
        if transition is None or noise is None or measurement is None or measured is None:
            raise RejectedError(
                "a model of numbers is wanted for a gain given as a list: "
                "where expressions occur, the gain is given by rows"
            )
        if model.measured != 1:
            raise RejectedError(
                f"a measurement of {model.measured} entries has a gain given by rows, "
                "a list is found"
            )
        self.transition: Numbers = transition
        self.process_noise: Numbers = noise
        self.measurement = measurement[0]
        self.measurement_noise = measured[0][0]


def _residual(
    field: Field,
    model: _OneMeasurement,
    above: Square,
    column: list[Polynomial],
    variance: Polynomial,
    scales: tuple[Polynomial, Polynomial],
) -> Square:
    """``D^2 (s (F A F' - A) - F a a' F') + s d N^2 Q0``, not reduced.

    a = A H', s = H a + R d, the index is N/D; ``scales`` are D^2 and d N^2.
    """
    size = len(above)
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


def _transformed(field: Field, model: _OneMeasurement, rows: Square) -> Square:
    """``F rows F'``."""
    steps, size = model.transition, len(rows)
    half = [
        [total(field, (rows[k][j].times(steps[i][k]) for k in range(size))) for j in range(size)]
        for i in range(size)
    ]
    return [
        [total(field, (half[i][k].times(steps[j][k]) for k in range(size))) for j in range(size)]
        for i in range(size)
    ]
