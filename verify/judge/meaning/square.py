"""Square matrices: unit, determinant, inverse by cofactors, whole powers."""

from __future__ import annotations

from gainproof.verify.judge.exact.expression import Expr, absolute, add, div, number, power, sqrt
from gainproof.verify.judge.exact.grid import Grid
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.meaning.elimination import inverse_of_numbers, is_numeric
from gainproof.verify.judge.meaning.value import Value, dot, multiplied, shape_text

MOST_INVERTED = 5
MOST_POWER = 12


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
