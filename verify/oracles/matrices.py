"""Matrix algebra over any kind of number: float, Fraction, multiprecision float.

A matrix is a tuple of rows. Written out here, rather than taken from a library, so that the
same few lines run exactly (Fraction), in double precision and in multiprecision; nothing is
assumed about the numbers but the four operations, ``abs`` and comparison.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

# Numbers of several libraries pass through (mpmath ships no types): Any is honest here.
Number = Any
Vector = tuple[Number, ...]
Matrix = tuple[Vector, ...]
T = TypeVar("T")


def matrix(rows: Iterable[Iterable[Any]], number: Callable[[Any], Any] = lambda x: x) -> Matrix:
    """Freeze rows into a matrix, each entry passed through ``number``.

    Raises ValueError for an empty or ragged matrix.
    """
    frozen = tuple(tuple(number(entry) for entry in row) for row in rows)
    if not frozen or not frozen[0] or any(len(row) != len(frozen[0]) for row in frozen):
        lengths = [len(row) for row in frozen]
        raise ValueError(f"a matrix needs rows of one positive length, got lengths {lengths}")
    return frozen


def identity(size: int, one: Number = 1) -> Matrix:
    """The identity of the given size, its numbers of the kind of ``one``."""
    zero = one - one
    return tuple(tuple(one if i == j else zero for j in range(size)) for i in range(size))


def transpose(a: Matrix) -> Matrix:
    return tuple(zip(*a, strict=True))


def add(a: Matrix, b: Matrix) -> Matrix:
    _same_shape(a, b)
    return tuple(tuple(x + y for x, y in zip(r, s, strict=True)) for r, s in zip(a, b, strict=True))


def subtract(a: Matrix, b: Matrix) -> Matrix:
    _same_shape(a, b)
    return tuple(tuple(x - y for x, y in zip(r, s, strict=True)) for r, s in zip(a, b, strict=True))


def scale(factor: Number, a: Matrix) -> Matrix:
    return tuple(tuple(factor * x for x in row) for row in a)


def product(*factors: Matrix) -> Matrix:
    """The product of the factors, multiplied from the left."""
    result = factors[0]
    for factor in factors[1:]:
        if len(result[0]) != len(factor):
            raise ValueError(
                f"cannot multiply {len(result)}x{len(result[0])} by {len(factor)}x{len(factor[0])}"
            )
        columns = transpose(factor)
        result = tuple(tuple(_dot(row, column) for column in columns) for row in result)
    return result


def symmetric(a: Matrix) -> Matrix:
    """The mean of a matrix and its transpose."""
    return tuple(tuple((a[i][j] + a[j][i]) / 2 for j in range(len(a))) for i in range(len(a)))


def solve(a: Matrix, b: Matrix) -> Matrix:
    """The X with A X = B, by elimination with the largest pivot of each column.

    Raises ZeroDivisionError when A is singular.
    """
    size = len(a)
    work = [list(left) + list(right) for left, right in zip(a, b, strict=True)]
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(work[i][k]))
        if work[pivot][k] == 0:
            raise ZeroDivisionError(f"singular matrix: no pivot in column {k}")
        work[k], work[pivot] = work[pivot], work[k]
        for i in range(k + 1, size):
            ratio = work[i][k] / work[k][k]
            work[i] = [x - ratio * y for x, y in zip(work[i], work[k], strict=True)]
    columns = len(b[0])
    answer: list[list[Number]] = [[] for _ in range(size)]
    for k in reversed(range(size)):
        answer[k] = [
            (work[k][size + c] - sum(work[k][j] * answer[j][c] for j in range(k + 1, size)))
            / work[k][k]
            for c in range(columns)
        ]
    return matrix(answer)


def solve_lyapunov(a: Matrix, c: Matrix) -> Matrix:
    """The X with X = A X A' + C, as one linear system for the entries of X."""
    size = len(a)
    pairs = [(i, j) for i in range(size) for j in range(size)]
    one = a[0][0] * 0 + 1
    left = tuple(
        tuple((one if (i, j) == (k, m) else one - one) - a[i][k] * a[j][m] for k, m in pairs)
        for i, j in pairs
    )
    flat = solve(left, tuple((c[i][j],) for i, j in pairs))
    return tuple(tuple(flat[i * size + j][0] for j in range(size)) for i in range(size))


def largest_ratio(change: Matrix, reference: Matrix) -> Number:
    """The largest entry of |change| / |reference|; an entry 0 / 0 counts as 0, x / 0 as inf."""
    worst: Number = 0
    for row, against in zip(change, reference, strict=True):
        for x, y in zip(row, against, strict=True):
            if x == 0:
                continue
            ratio = abs(x) / abs(y) if y != 0 else float("inf")
            worst = ratio if not ratio <= worst else worst
    return worst


def _dot(row: Vector, column: Vector) -> Number:
    total = row[0] * column[0]
    for x, y in zip(row[1:], column[1:], strict=True):
        total = total + x * y
    return total


def _same_shape(a: Matrix, b: Matrix) -> None:
    if len(a) != len(b) or len(a[0]) != len(b[0]):
        raise ValueError(f"shapes differ: {len(a)}x{len(a[0])} and {len(b)}x{len(b[0])}")
