"""Square matrices: unit, determinant, whole powers; inverse by cofactors, of larger ones of numbers
by elimination.
"""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.exact.balls import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.expression import (
    Expr,
    absolute,
    add,
    div,
    mul,
    neg,
    number,
    power,
    sqrt,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.graph_matrices import Grid
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.value import Value, dot, multiplied, shape_text

MOST_INVERTED = 5
MOST_POWER = 12
PRECISION = 256
MOST_ELIMINATED = 12

Rows = list[list[Expr]]


def identity(size: int) -> Grid:
    """The unit matrix."""
    return tuple(tuple(number(int(r == c)) for c in range(size)) for r in range(size))


def inverse(value: Value) -> Value:
    """The inverse by cofactors; a large one of numbers by elimination."""
    if isinstance(value, Expr):
        return power(value, -1)
    size = _square(value, "the inverse of")
    if size > MOST_INVERTED and is_numeric(value):
        return inverse_of_numbers(value)
    if size > MOST_INVERTED:
        raise Undecided(f"the inverse of a matrix of more than {MOST_INVERTED} rows")
    whole = determinant(value)
    return tuple(
        tuple(div(determinant(_without(value, c, r)) * (-1) ** (r + c), whole) for c in range(size))
        for r in range(size)
    )


def determinant(value: Value) -> Expr:
    """The determinant by the first row; that of no rows, the cofactor of a single entry, is 1."""
    if isinstance(value, Expr):
        return value
    if not value:
        return number(1)
    size = _square(value, "the determinant of")
    if size == 1:
        return value[0][0]
    return dot(
        value[0],
        [determinant(_without(value, 0, c)) * (-1) ** c for c in range(size)],
    )


def trace(value: Value) -> Expr:
    """The sum of the diagonal."""
    if isinstance(value, Expr):
        return value
    return add(*[value[k][k] for k in range(_square(value, "the trace of"))])


def norm(value: Value) -> Expr:
    """The length of a vector; of a number its size."""
    if isinstance(value, Expr):
        return absolute(value)
    if min(len(value), len(value[0])) > 1:
        raise Undecided(f"the norm of {shape_text(value)}: which of its norms is not said")
    return sqrt(add(*[power(x, 2) for row in value for x in row]))


def size_of(value: Value) -> Expr:
    """What stands between single bars: of a square matrix its determinant, else the norm."""
    if isinstance(value, Expr) or len(value) != len(value[0]):
        return norm(value)
    return determinant(value)


def raised(value: Value, exponent: int) -> Value:
    """A whole power of a matrix."""
    if isinstance(value, Expr):
        return power(value, exponent)
    size = _square(value, "a power of")
    base = inverse(value) if exponent < 0 else value
    if abs(exponent) > MOST_POWER:
        raise Undecided(f"a power of a matrix beyond {MOST_POWER}")
    return multiplied([identity(size), *[base] * abs(exponent)]) if exponent else identity(size)


def _square(grid: Grid, what: str) -> int:
    if len(grid) != len(grid[0]):
        raise Undecided(f"{what} {shape_text(grid)}")
    return len(grid)


def _without(grid: Grid, row: int, column: int) -> Grid:
    return tuple(
        tuple(x for c, x in enumerate(line) if c != column)
        for r, line in enumerate(grid)
        if r != row
    )


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
