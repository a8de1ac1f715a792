"""The steady state with a vector measurement, written in the updated covariance."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.kinds.combination import (
    Square,
    index_as_written,
    product,
    require_combinations,
    require_same,
    square,
    transposed,
)
from gainproof.verify.certificate.kinds.positive_definite import require_leading_minors
from gainproof.verify.certificate.model import Model, Rows
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio, polynomial
from gainproof.verify.certificate.ratio import total as sum_of
from gainproof.verify.certificate.rejection import RejectedError


def vector_riccati(case: Case, model: Model) -> str:
    """The claim of `riccati` with the gain given by rows; F, H and Q0 polynomials of the tower.

    Evidence: denominator d, predicted A and updated B (M = A/d, X = B/d), precision: numerators V
    and denominator w with R V = w I; innovation: the leading minors of H M H' + R, manifestly
    positive; prediction and update: cofactors. It is decided as
    X (I + H' R^-1 H M) = M, K = X H' R^-1 and M = F X F' + q Q0, from which the rest follows:
    K (H M H' + R) = X H' R^-1 H M H' + X H' = (M - X) H' + X H' = M H', and
    K H M = X H' R^-1 H M = M - X.
    """
    claim = case.claims("model", "predicted", "updated", "gain", "index")
    evidence = case.evidences(
        "denominator", "predicted", "updated", "precision", "innovation", "prediction", "update"
    )
    field = case.tower.field
    size, seen = model.size, model.measured
    predicted = case.square(claim["predicted"], "predicted")
    updated = case.square(claim["updated"], "updated")
    gain = case.rows(claim["gain"], "gain")
    if not len(predicted) == len(updated) == len(gain) == size or len(gain[0]) != seen:
        raise RejectedError(f"{size} states and {seen} measurements in the model, other sizes here")
    below = case.polynomial(evidence["denominator"], "denominator")
    if not field.positive(below):
        raise RejectedError("the denominator is not manifestly positive")
    before = square(case, evidence["predicted"], size, "predicted")
    after = square(case, evidence["updated"], size, "updated")
    for i in range(size):
        for j in range(size):
            for above, named, what in (
                (before, predicted, "predicted"),
                (after, updated, "updated"),
            ):
                entry = polynomial(field, above[i][j]).over(polynomial(field, below))
                require_same(entry, named[i][j], f"{what} {i + 1},{j + 1}")
    precision, scale = _precision(case, evidence["precision"], model.measurement_noise)
    measurement = _polynomials(model.measurement, "measurement")
    # H' V, in which the gain and the information of one measurement are w^-1 times polynomials
    weight = product(field, transposed(measurement), precision)
    _require_gain(field, updated, weight, scale, gain)
    _require_innovation(case, evidence["innovation"], model, predicted)
    steps, noise = (
        _polynomials(model.transition, "transition"),
        _polynomials(model.process_noise, "process_noise"),
    )
    index = index_as_written(case, claim["index"])
    prediction = _prediction(field, (steps, noise), below, (before, after), index)
    places = [(i, j) for i in range(size) for j in range(size)]
    require_combinations(
        case,
        evidence["prediction"],
        {f"{i + 1},{j + 1}": prediction[i][j] for i, j in places if i <= j},
        "prediction",
    )
    information = product(field, weight, measurement)
    update = _update(field, information, (below, scale), (before, after))
    require_combinations(
        case, evidence["update"], {f"{i + 1},{j + 1}": update[i][j] for i, j in places}, "update"
    )
    return "proved"


def _precision(case: Case, value: Plain, noise: Rows) -> tuple[Square, Polynomial]:
    """V and w with R V = w I, w manifestly positive."""
    field = case.tower.field
    fields = schema.record(value, ("numerators", "denominator"), f"{case.place}.evidence.precision")
    rows = square(case, fields["numerators"], len(noise), "precision.numerators")
    scale = case.polynomial(fields["denominator"], "precision.denominator")
    if not field.positive(scale):
        raise RejectedError("precision: the denominator is not manifestly positive")
    for i, row in enumerate(noise):
        for j in range(len(noise)):
            found = sum_of(field, (row[k] * polynomial(field, rows[k][j]) for k in range(len(row))))
            wanted = scale if i == j else field.ring.constant(0)
            if not found.equals(polynomial(field, wanted)):
                raise RejectedError("precision: not the inverse of the measurement noise")
    return rows, scale


def _require_gain(
    field: Field, updated: list[list[Ratio]], weight: Square, scale: Polynomial, gain: Rows
) -> None:
    """K = X H' V / w."""
    for i, row in enumerate(updated):
        for j in range(len(gain[0])):
            found = sum_of(
                field, (row[k] * polynomial(field, weight[k][j]) for k in range(len(row)))
            )
            require_same(found.over(polynomial(field, scale)), gain[i][j], f"gain {i + 1},{j + 1}")


def _require_innovation(
    case: Case, value: Plain, model: Model, predicted: list[list[Ratio]]
) -> None:
    """H M H' + R is positive definite, by its leading minors."""
    field, seen = case.tower.field, model.measurement
    states = range(model.size)
    rows = [
        [
            sum_of(
                field,
                (first[k] * predicted[k][m] * second[m] for k in states for m in states),
            )
            + model.measurement_noise[i][j]
            for j, second in enumerate(seen)
        ]
        for i, first in enumerate(seen)
    ]
    require_leading_minors(case, value, rows, "innovation")


def _prediction(
    field: Field,
    matrices: tuple[Square, Square],
    below: Polynomial,
    covariances: tuple[Square, Square],
    index: tuple[Polynomial, Polynomial],
) -> Square:
    """``D^2 (A - F B F') - d N^2 Q0``, not reduced; the index is N/D."""
    (steps, noise), (before, after), (above, under) = matrices, covariances, index
    moved = product(field, product(field, steps, after), transposed(steps))
    outside, strength = under * under, below * above * above
    size = range(len(before))
    return [
        [outside * (before[i][j] - moved[i][j]) - strength * noise[i][j] for j in size]
        for i in size
    ]


def _update(
    field: Field,
    information: Square,
    scales: tuple[Polynomial, Polynomial],
    covariances: tuple[Square, Square],
) -> Square:
    """``B (w d I + H' V H A) - w d A``, not reduced."""
    (below, scale), (before, after) = scales, covariances
    common, size = scale * below, range(len(before))
    zero = field.ring.constant(0)
    inner = product(field, information, before)
    inner = [[inner[i][j] + (common if i == j else zero) for j in size] for i in size]
    left = product(field, after, inner)
    return [[left[i][j] - common * before[i][j] for j in size] for i in size]


def _polynomials(rows: Rows, what: str) -> Square:
    """The entries as polynomials. Raises RejectedError when one is a proper quotient."""
    if any(entry.factors for row in rows for entry in row):
        raise RejectedError(f"model.{what}: an entry is not a polynomial in the tower")
    return [[entry.numerator for entry in row] for row in rows]
