"""The inverse of a matrix of numbers by elimination; cofactors of larger ones are too many."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.exact.enclose import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    mul,
    neg,
    number,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.grid import Grid
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.tidy import tidied

PRECISION = 256
MOST_ELIMINATED = 12

Rows = list[list[Expr]]


def is_numeric(grid: Grid) -> bool:
    """Whether every entry is made of numbers and roots alone."""
    every = [entry for row in grid for entry in row]
    return not symbols_of(*every) and all(node.kind != "call" for node in walk(*every))


def inverse_of_numbers(grid: Grid) -> Grid:
    """The inverse of a square matrix of numbers; each pivot is seen not to be zero. Raises
    Undecided where in some column none is.
    """
    size = len(grid)
    if size > MOST_ELIMINATED:
        raise Undecided(f"the inverse of a matrix of more than {MOST_ELIMINATED} rows")
    unit = [[number(int(r == c)) for c in range(size)] for r in range(size)]
    rows: Rows = [[*map(tidied, line), *ones] for line, ones in zip(grid, unit, strict=True)]
    for column in range(size):
        place = _pivot(rows, column)
        rows[column], rows[place] = rows[place], rows[column]
        pivot = rows[column][column]
        rows[column] = [tidied(div(entry, pivot)) for entry in rows[column]]
        for other, row in enumerate(rows):
            if other != column and not _is_zero(row[column]):
                rows[other] = _reduced(row, rows[column], row[column])
    return tuple(tuple(row[size:]) for row in rows)


def _reduced(row: Sequence[Expr], pivot_row: Sequence[Expr], factor: Expr) -> list[Expr]:
    return [
        entry if _is_zero(above) else tidied(add(entry, neg(mul(factor, above))))
        for entry, above in zip(row, pivot_row, strict=True)
    ]


def _pivot(rows: Rows, column: int) -> int:
    """The first row from the diagonal down with an entry that is not zero."""
    for place in range(column, len(rows)):
        if _is_nonzero(rows[place][column]):
            return place
    raise Undecided("the inverse of a matrix in which no pivot is seen not to be zero")


def _is_zero(entry: Expr) -> bool:
    return entry.kind == "number" and entry.value == 0


def _is_nonzero(entry: Expr) -> bool:
    try:
        return not enclosed(entry, {}, PRECISION).contains(0)
    except (NoValue, Unresolved):
        return False
