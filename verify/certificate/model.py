"""The model a statement speaks about: F, Q0, H, R, numbers or expressions over the tower."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.matrix import determinant
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.ratio import Ratio, number
from gainproof.verify.certificate.rejection import MAXIMUM_ORDER, RejectedError

Rows = tuple[tuple[Ratio, ...], ...]
Numbers = tuple[tuple[Fraction, ...], ...]

_FIELDS = ("name", "title", "transition", "process_noise", "measurement", "measurement_noise")


@dataclass(frozen=True, slots=True)
class Model:
    """A state model in units that make T = 1 and the first measurement's deviation 1.

    ``transition`` F and ``process_noise`` Q0 are n by n, ``measurement`` H is m by n,
    ``measurement_noise`` R is m by m. The process noise is ``q Q0``. Everywhere in the tower Q0 is
    positive semidefinite and R positive definite.
    """

    transition: Rows
    process_noise: Rows
    measurement: Rows
    measurement_noise: Rows

    @property
    def size(self) -> int:
        """The number of states."""
        return len(self.transition)

    @property
    def measured(self) -> int:
        """The number of entries of a measurement."""
        return len(self.measurement)


def read_model(case: Case, value: Plain) -> Model:
    """Read model data; shapes must fit, Q0 be a covariance, R a positive definite one."""
    place = f"{case.place}.claim.model"
    fields = schema.record(value, _FIELDS, place)
    schema.name(str(fields["name"]).replace("-", "_"), f"{place}.name")
    schema.text(fields["title"], f"{place}.title")
    transition, noise, measurement, measured = (
        _rows(case, fields[field], field) for field in _FIELDS[2:]
    )
    size, seen = len(transition), len(measurement)
    for rows, shape, what in (
        (transition, (size, size), "transition"),
        (noise, (size, size), "process_noise"),
        (measurement, (seen, size), "measurement"),
        (measured, (seen, seen), "measurement_noise"),
    ):
        if (len(rows), len(rows[0])) != shape:
            raise RejectedError(f"{place}.{what}: the shape {shape} is wanted")
    for rows, what in ((noise, "process_noise"), (measured, "measurement_noise")):
        if any(not rows[i][j].equals(rows[j][i]) for i in range(len(rows)) for j in range(i)):
            raise RejectedError(f"{place}.{what}: not symmetric")
    field = case.tower.field
    if not _is_positive_semidefinite(field, noise):
        raise RejectedError(
            f"{place}.process_noise: not a covariance, it has a negative minor "
            "or one that is not manifestly nonnegative"
        )
    if not _is_positive_definite(field, measured):
        raise RejectedError(
            f"{place}.measurement_noise: not positive, a leading minor is not manifestly so"
        )
    return Model(transition, noise, measurement, measured)


def numbers(rows: Rows) -> Numbers | None:
    """The entries as numbers; None unless every one visibly is a number."""
    found = [[entry.constant_value() for entry in row] for row in rows]
    if any(value is None for row in found for value in row):
        return None
    return tuple(tuple(value for value in row if value is not None) for row in found)


def _is_positive_definite(field: Field, rows: Rows) -> bool:
    """Whether every leading minor of a symmetric matrix is manifestly positive."""
    plain = numbers(rows)
    if plain is not None:
        return all(
            _determinant([list(row[:order]) for row in plain[:order]]) > 0
            for order in range(1, len(plain) + 1)
        )
    return all(
        field.positive(determinant(tuple(row[:order] for row in rows[:order])).numerator)
        for order in range(1, len(rows) + 1)
    )


def _is_positive_semidefinite(field: Field, rows: Rows) -> bool:
    """Whether every principal minor of a symmetric matrix is manifestly nonnegative."""
    chosen = [
        [i for i in range(len(rows)) if subset >> i & 1] for subset in range(1, 1 << len(rows))
    ]
    plain = numbers(rows)
    if plain is not None:
        return all(
            _determinant([[plain[i][j] for j in places] for i in places]) >= 0 for places in chosen
        )
    return all(
        field.nonnegative(
            determinant(tuple(tuple(rows[i][j] for j in places) for i in places)).numerator
        )
        for places in chosen
    )


def _determinant(rows: list[list[Fraction]]) -> Fraction:
    """By elimination."""
    result = Fraction(1)
    while rows:
        pivot = next((row for row in rows if row[0]), None)
        if pivot is None:
            return Fraction(0)
        position = rows.index(pivot)
        result *= pivot[0] * (-1) ** position
        rest = rows[:position] + rows[position + 1 :]
        rows = [
            [
                entry - row[0] * above / pivot[0]
                for entry, above in zip(row[1:], pivot[1:], strict=True)
            ]
            for row in rest
        ]
    return result


def _rows(case: Case, value: Plain, field: str) -> Rows:
    place = f"{case.place}.claim.model.{field}"
    rows = tuple(
        tuple(_entry(case, entry, f"model.{field}") for entry in schema.items(row, place))
        for row in schema.items(value, place)
    )
    if not 1 <= len(rows) <= MAXIMUM_ORDER or not 1 <= len(rows[0]) <= MAXIMUM_ORDER:
        raise RejectedError(f"{place}: between 1 and {MAXIMUM_ORDER} rows and columns are wanted")
    if any(len(row) != len(rows[0]) for row in rows):
        raise RejectedError(f"{place}: rows of different lengths")
    return rows


def _entry(case: Case, value: Plain, field: str) -> Ratio:
    """A number as text, or a graph over the names of the tower."""
    if isinstance(value, dict):
        return case.evaluation(case.no_fractions()).scalar(case.expression(value, field))
    return number(case.tower.field, schema.number(value, f"{case.place}.claim.{field}"))
