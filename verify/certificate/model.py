"""The model a statement speaks about: F, Q0, H, R with rational entries."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.rejection import MAXIMUM_ORDER, RejectedError

Rows = tuple[tuple[Fraction, ...], ...]

_FIELDS = ("name", "title", "transition", "process_noise", "measurement", "measurement_noise")


@dataclass(frozen=True, slots=True)
class Model:
    """A state model in units T = R = 1, one scalar measurement.

    ``transition`` F and ``process_noise`` Q0 are n by n, ``measurement`` H has n entries,
    ``measurement_noise`` R is a positive number. The process noise is ``q Q0``.
    """

    transition: Rows
    process_noise: Rows
    measurement: tuple[Fraction, ...]
    measurement_noise: Fraction

    @property
    def size(self) -> int:
        """The number of states."""
        return len(self.transition)


def read_model(value: Plain, place: str) -> Model:
    """Read model data; shapes must fit, Q0 be a covariance, R positive."""
    fields = schema.record(value, _FIELDS, place)
    schema.name(str(fields["name"]).replace("-", "_"), f"{place}.name")
    schema.text(fields["title"], f"{place}.title")
    transition, noise, measurement, measured = (
        _rows(fields[field], f"{place}.{field}") for field in _FIELDS[2:]
    )
    size = len(transition)
    for rows, shape, what in (
        (transition, (size, size), "transition"),
        (noise, (size, size), "process_noise"),
        (measurement, (1, size), "measurement"),
        (measured, (1, 1), "measurement_noise"),
    ):
        if (len(rows), len(rows[0])) != shape:
            raise RejectedError(f"{place}.{what}: the shape {shape} is wanted")
    if any(noise[i][j] != noise[j][i] for i in range(size) for j in range(i)):
        raise RejectedError(f"{place}.process_noise: not symmetric")
    if not _is_positive_semidefinite(noise):
        raise RejectedError(f"{place}.process_noise: not a covariance, it has a negative minor")
    if not measured[0][0] > 0:
        raise RejectedError(f"{place}.measurement_noise: not positive")
    return Model(transition, noise, measurement[0], measured[0][0])


def _is_positive_semidefinite(rows: Rows) -> bool:
    """Whether no principal minor of a symmetric matrix is negative."""
    chosen = [
        [i for i in range(len(rows)) if subset >> i & 1] for subset in range(1, 1 << len(rows))
    ]
    return all(
        _determinant([[rows[i][j] for j in places] for i in places]) >= 0 for places in chosen
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


def _rows(value: Plain, place: str) -> Rows:
    rows = tuple(
        tuple(schema.number(entry, place) for entry in schema.items(row, place))
        for row in schema.items(value, place)
    )
    if not 1 <= len(rows) <= MAXIMUM_ORDER or not 1 <= len(rows[0]) <= MAXIMUM_ORDER:
        raise RejectedError(f"{place}: between 1 and {MAXIMUM_ORDER} rows and columns are wanted")
    if any(len(row) != len(rows[0]) for row in rows):
        raise RejectedError(f"{place}: rows of different lengths")
    return rows
