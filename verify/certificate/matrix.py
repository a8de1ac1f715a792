"""Matrices of quotients: entrywise sums, products, determinants."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.ratio import Ratio, number, total
from gainproof.verify.certificate.rejection import RejectedError


@dataclass(frozen=True, slots=True)
class Matrix:
    """A nonempty rectangle of quotients, row by row."""

    rows: tuple[tuple[Ratio, ...], ...]

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of rows and columns."""
        return len(self.rows), len(self.rows[0])

    def entries(self) -> list[Ratio]:
        """All entries, row by row."""
        return [entry for row in self.rows for entry in row]

    def rebuilt(self, entries: list[Ratio]) -> Matrix:
        """A matrix of the same shape with these entries."""
        width = self.shape[1]
        return Matrix(
            tuple(tuple(entries[start : start + width]) for start in range(0, len(entries), width))
        )

    def plus(self, other: Matrix) -> Matrix:
        """The sum. Raises RejectedError if the shapes differ."""
        if self.shape != other.shape:
            raise RejectedError(f"matrices of shapes {self.shape} and {other.shape} added")
        return self.rebuilt([a + b for a, b in zip(self.entries(), other.entries(), strict=True)])

    def times(self, other: Matrix) -> Matrix:
        """The matrix product. Raises RejectedError if the shapes do not fit."""
        if self.shape[1] != other.shape[0]:
            raise RejectedError(f"matrices of shapes {self.shape} and {other.shape} multiplied")
        field = self.rows[0][0].field
        columns = list(zip(*other.rows, strict=True))
        return Matrix(
            tuple(
                tuple(
                    total(field, (a * b for a, b in zip(row, column, strict=True)))
                    for column in columns
                )
                for row in self.rows
            )
        )

    def scaled(self, factor: Ratio) -> Matrix:
        """Every entry times a factor."""
        return self.rebuilt([entry * factor for entry in self.entries()])

    def trace(self) -> Ratio:
        """The sum of the diagonal of a square matrix."""
        field = self.rows[0][0].field
        return total(field, (row[i] for i, row in enumerate(self.rows)))


def identity(field: Field, size: int) -> Matrix:
    """The identity matrix."""
    return Matrix(
        tuple(tuple(number(field, int(i == j)) for j in range(size)) for i in range(size))
    )


def determinant(rows: tuple[tuple[Ratio, ...], ...]) -> Ratio:
    """The determinant of a square array, by expansion along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    result = number(rows[0][0].field, 0)
    for column, entry in enumerate(rows[0]):
        if entry.is_zero():
            continue
        minor = tuple(row[:column] + row[column + 1 :] for row in rows[1:])
        term = entry * determinant(minor)
        result = result - term if column % 2 else result + term
    return result


def characteristic_polynomial(matrix: Matrix) -> list[Ratio]:
    """The coefficients a_0, ..., a_n = 1 of det(z I - matrix) (Faddeev and LeVerrier)."""
    size = matrix.shape[0]
    field = matrix.rows[0][0].field
    coefficients = [number(field, 1)]
    auxiliary = identity(field, size)
    for step in range(1, size + 1):
        product = matrix.times(auxiliary)
        coefficient = -product.trace().over(number(field, step))
        coefficients.append(coefficient)
        auxiliary = product.plus(identity(field, size).scaled(coefficient))
    return coefficients[::-1]


def principal_coefficients(matrix: Matrix) -> list[Ratio]:
    """The same as sums of principal minors: fewer products of large entries, more of many."""
    size = matrix.shape[0]
    field = matrix.rows[0][0].field
    coefficients = [number(field, 1)]
    for order in range(1, size + 1):
        minors = total(
            field,
            (
                determinant(tuple(tuple(matrix.rows[i][j] for j in places) for i in places))
                for places in combinations(range(size), order)
            ),
        )
        coefficients.append(-minors if order % 2 else minors)
    return coefficients[::-1]
