"""Small matrices: of fractions (models) and of expressions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number
from gainproof.verify.judge.exact.expression_graph import rational
from gainproof.verify.judge.exact.work_limits import Malformed

Numbers = tuple[tuple[Fraction, ...], ...]
Exprs = tuple[tuple[Expr, ...], ...]


def numbers(rows: Any, what: str) -> Numbers:
    """Rows of number texts as fractions. Raises Malformed."""
    if not isinstance(rows, Sequence) or isinstance(rows, str) or not rows:
        raise Malformed(f"{what}: wanted rows of number texts, got {str(rows)[:60]}")
    made = tuple(tuple(rational(entry) for entry in row) for row in rows)
    if len({len(row) for row in made}) != 1:
        raise Malformed(f"{what}: the rows differ in length")
    return made


def model_matrices(model: Mapping[str, Any]) -> tuple[Numbers, Numbers, Numbers, Numbers]:
    """Transition, process noise (for index 1), measurement, its noise. Raises Malformed."""
    names = ("transition", "process_noise", "measurement", "measurement_noise")
    f, q, h, r = (numbers(model.get(name), name) for name in names)
    n, m = len(f), len(h)
    shapes = {
        "transition": (f, n, n),
        "process_noise": (q, n, n),
        "measurement": (h, m, n),
        "measurement_noise": (r, m, m),
    }
    for name, (matrix, rows, columns) in shapes.items():
        if (len(matrix), len(matrix[0])) != (rows, columns):
            raise Malformed(
                f"{name}: wanted {rows} x {columns}, got {len(matrix)} x {len(matrix[0])}"
            )
    return f, q, h, r


def exprs(matrix: Numbers) -> Exprs:
    """The same matrix as expressions."""
    return tuple(tuple(number(x) for x in row) for row in matrix)


def transposed(a: Exprs) -> Exprs:
    """Transpose."""
    return tuple(zip(*a, strict=True))


def times(a: Exprs, b: Exprs) -> Exprs:
    """Product; terms with a zero factor are left out."""
    return tuple(tuple(_dot(row, column) for column in zip(*b, strict=True)) for row in a)


def plus(a: Exprs, b: Exprs) -> Exprs:
    """Sum."""
    return tuple(tuple(x + y for x, y in zip(p, q, strict=True)) for p, q in zip(a, b, strict=True))


def minus(a: Exprs, b: Exprs) -> Exprs:
    """Difference."""
    return tuple(
        tuple(add(x, neg(y)) for x, y in zip(p, q, strict=True)) for p, q in zip(a, b, strict=True)
    )


def scaled(a: Exprs, factor: Expr) -> Exprs:
    """Matrix times a scalar."""
    return tuple(tuple(_times(x, factor) for x in row) for row in a)


def _dot(row: Sequence[Expr], column: Sequence[Expr]) -> Expr:
    kept = [_times(x, y) for x, y in zip(row, column, strict=True) if not (_is(x, 0) or _is(y, 0))]
    return add(*kept) if kept else number(0)


def _times(x: Expr, y: Expr) -> Expr:
    if _is(x, 1):
        return y
    if _is(y, 1):
        return x
    return number(0) if _is(x, 0) or _is(y, 0) else mul(x, y)


def _is(x: Expr, value: int) -> bool:
    return x.kind == "number" and x.value == value


def solve_rows(matrix: Sequence[Sequence[Fraction]], right: Sequence[Expr]) -> list[Expr] | None:
    """Unknowns of a linear system with numbers on the left and expressions on the right, by
    elimination.

    Rows that depend on others are dropped unread: the caller must check all equations. None if rank
    is short.
    """
    width = len(matrix[0])
    rows = [(list(row), {k: Fraction(1)}) for k, row in enumerate(matrix)]
    chosen: list[tuple[list[Fraction], dict[int, Fraction]]] = []
    for column in range(width):
        pivot = next((r for r in rows if r[0][column] != 0), None)
        if pivot is None:
            return None
        rows.remove(pivot)
        lead = pivot[0][column]
        unit = ([x / lead for x in pivot[0]], {k: c / lead for k, c in pivot[1].items()})
        rows = [_cleared(r, unit, column) for r in rows]
        chosen = [*[_cleared(r, unit, column) for r in chosen], unit]
    return [_combined(weights, right) for _, weights in chosen]


def _cleared(
    row: tuple[list[Fraction], dict[int, Fraction]],
    unit: tuple[list[Fraction], dict[int, Fraction]],
    column: int,
) -> tuple[list[Fraction], dict[int, Fraction]]:
    factor = row[0][column]
    if factor == 0:
        return row
    weights = dict(row[1])
    for k, c in unit[1].items():
        weights[k] = weights.get(k, Fraction(0)) - factor * c
    return [x - factor * y for x, y in zip(row[0], unit[0], strict=True)], weights


def _combined(weights: Mapping[int, Fraction], right: Sequence[Expr]) -> Expr:
    kept = [
        _times(number(c), right[k])
        for k, c in sorted(weights.items())
        if c != 0 and not _is(right[k], 0)
    ]
    return add(*kept) if kept else number(0)
