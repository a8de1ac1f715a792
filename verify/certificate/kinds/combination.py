"""Residuals as combinations of a tower's relations, expanded and never reduced."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TypeAlias

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import RejectedError

Square: TypeAlias = list[list[Polynomial]]


def require_combinations(
    case: Case, value: Plain, residuals: Mapping[str, Polynomial], field: str
) -> None:
    """Each residual must be the stated combination of the relations, term by term.

    ``value`` holds, for the key of each residual, one cofactor for each relation of the tower.
    """
    tower = case.tower.field
    relations = [tower.relation(number) for number in range(len(tower.generators))]
    place = f"{case.place}.evidence.{field}"
    entries = schema.record(value, tuple(residuals), place)
    for key, residual in residuals.items():
        listed = schema.items(entries[key], f"{place}.{key}")
        if len(listed) != len(relations):
            raise RejectedError(f"{field} {key}: {len(relations)} polynomials wanted")
        combination = total(
            tower,
            (
                case.polynomial(cofactor, f"{field}.{key}") * relation
                for cofactor, relation in zip(listed, relations, strict=True)
            ),
        )
        if combination != residual:
            raise RejectedError(
                f"the residual {key} is not the stated combination of the generators' relations"
            )


def square(case: Case, value: Plain, size: int, field: str) -> Square:
    """A symmetric square of polynomials of the evidence."""
    place = f"{case.place}.evidence.{field}"
    rows = [
        [case.polynomial(entry, field) for entry in schema.items(row, place)]
        for row in schema.items(value, place)
    ]
    if len(rows) != size or any(len(row) != size for row in rows):
        raise RejectedError(f"{field}: {size} rows of {size} wanted")
    if any(rows[i][j] != rows[j][i] for i in range(size) for j in range(i)):
        raise RejectedError(f"{field}: not symmetric")
    return rows


def index_as_written(case: Case, value: Plain) -> tuple[Polynomial, Polynomial]:
    """The index of the noise as the tower writes it: numerator and denominator."""
    name = schema.name(value, f"{case.place}.claim.index")
    index = case.tower.value(name)
    if name in case.tower.written:
        fraction = case.tower.written[name]
        return fraction.numerator, fraction.denominator
    return index.numerator, case.tower.field.ring.constant(1)


def total(field: Field, terms: Iterable[Polynomial]) -> Polynomial:
    """The sum of any number of polynomials."""
    result = field.ring.constant(0)
    for term in terms:
        result = result + term
    return result


def product(field: Field, left: Square, right: Square) -> Square:
    """The matrix product, not reduced."""
    columns = list(zip(*right, strict=True))
    return [
        [total(field, (a * b for a, b in zip(row, column, strict=True))) for column in columns]
        for row in left
    ]


def transposed(rows: Square) -> Square:
    """Rows as columns."""
    return [list(column) for column in zip(*rows, strict=True)]


def require_same(found: Ratio, named: Ratio, what: str) -> None:
    """Reject unless the named element is what was found."""
    if not found.equals(named):
        raise RejectedError(f"{what}: the named element is another one")
