"""Values of formulas: numbers and matrices of numbers, each an expression, and what is done with
them.

A matrix of one row and one column is the number in it, as in print: x' P x is a number.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, add, div, mul, neg, number
from gainproof.verify.judge.exact.graph_matrices import Grid
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided

Value = Expr | Grid

MOST_ENTRIES = 144


def shape_text(value: Value) -> str:
    """`a number` or `a 2 x 3 matrix`."""
    return "a number" if isinstance(value, Expr) else f"a {len(value)} x {len(value[0])} matrix"


def shape(value: Value) -> tuple[int, int]:
    """Rows and columns; a number has one of each."""
    return (1, 1) if isinstance(value, Expr) else (len(value), len(value[0]))


def entries(value: Value) -> list[Expr]:
    """All entries, row by row."""
    return [value] if isinstance(value, Expr) else [x for row in value for x in row]


def zeros_like(value: Value, other: Value) -> Value:
    """A matrix of zeros if the value is the number 0 and the other a matrix; else the value."""
    if isinstance(value, Expr) and not isinstance(other, Expr) and _is(value, 0):
        return mapped(other, lambda _: number(0))
    return value


def matrix(rows: Sequence[Sequence[Expr]]) -> Value:
    """A matrix, or the number in it if it holds one only."""
    if len(rows) * len(rows[0]) > MOST_ENTRIES:
        raise Undecided(f"a matrix of more than {MOST_ENTRIES} entries")
    if len(rows) == 1 and len(rows[0]) == 1:
        return rows[0][0]
    return tuple(tuple(row) for row in rows)


def mapped(value: Value, change: Callable[[Expr], Expr]) -> Value:
    """Every entry changed."""
    if isinstance(value, Expr):
        return change(value)
    return tuple(tuple(change(entry) for entry in row) for row in value)


def put_in(value: Value, values: Mapping[str, Expr]) -> Value:
    """Symbols replaced by expressions in every entry."""
    return mapped(value, lambda entry: substituted(entry, values))


def added(values: Sequence[Value]) -> Value:
    """The sum. Raises Undecided for different shapes."""
    plain = [v for v in values if isinstance(v, Expr)]
    if len(plain) == len(values):
        return add(*plain)
    grids = [v for v in values if not isinstance(v, Expr)]
    first = grids[0]
    for other in values:
        if shape(other) != shape(first):
            raise Undecided(f"a sum of {shape_text(first)} and {shape_text(other)}")
    return tuple(
        tuple(add(*[g[r][c] for g in grids]) for c in range(len(first[0])))
        for r in range(len(first))
    )


def multiplied(values: Sequence[Value]) -> Value:
    """The product in the order printed. Raises Undecided for shapes that do not fit."""
    plain = [v for v in values if isinstance(v, Expr)]
    if len(plain) == len(values):
        return mul(*plain)
    total = values[0]
    for value in values[1:]:
        total = _product(total, value)
    return total


def _product(a: Value, b: Value) -> Value:
    if isinstance(a, Expr):
        return mapped(b, lambda entry: mul(a, entry))
    if isinstance(b, Expr):
        return mapped(a, lambda entry: mul(entry, b))
    if len(a[0]) != len(b):
        raise Undecided(f"a product of {shape_text(a)} and {shape_text(b)}")
    columns = list(zip(*b, strict=True))
    return matrix([[dot(row, column) for column in columns] for row in a])


def dot(row: Sequence[Expr], column: Sequence[Expr]) -> Expr:
    """Sum of products; zeros and ones printed in a matrix are left out.

    Nothing is left out that may lack a value.
    """
    terms = [_times(x, y) for x, y in zip(row, column, strict=True)]
    kept = [t for t in terms if t is not None]
    return add(*kept) if kept else number(0)


def _times(x: Expr, y: Expr) -> Expr | None:
    if _is(x, 1):
        return None if _is(y, 0) else y
    if _is(y, 1):
        return None if _is(x, 0) else x
    if (_is(x, 0) and is_total(y)) or (_is(y, 0) and is_total(x)):
        return None
    return mul(x, y)


def _is(x: Expr, value: int) -> bool:
    return x.kind == "number" and x.value == value


def divided(a: Value, b: Value) -> Value:
    """A value over a number; over a matrix it has no one meaning."""
    if not isinstance(b, Expr):
        raise Undecided(f"a division by {shape_text(b)}: write its inverse")
    return mapped(a, lambda entry: div(entry, b))


def negated(value: Value) -> Value:
    """The opposite."""
    return mapped(value, neg)


def transposed(value: Value) -> Value:
    """The transpose; a number is its own."""
    return value if isinstance(value, Expr) else tuple(zip(*value, strict=True))


def kronecker(a: Value, b: Value) -> Value:
    """The Kronecker product: every entry of the first times the second."""
    first = ((a,),) if isinstance(a, Expr) else a
    second = ((b,),) if isinstance(b, Expr) else b
    return stacked(
        [[mapped(second, lambda entry, x=x: mul(x, entry)) for x in row] for row in first]  # type: ignore[misc]
    )


def stacked(blocks: Sequence[Sequence[Value]]) -> Value:
    """A matrix from blocks; numbers are blocks of one entry. Raises Undecided at uneven edges."""
    rows: list[list[Expr]] = []
    for line in blocks:
        grids = [((b,),) if isinstance(b, Expr) else b for b in line]
        if len({len(g) for g in grids}) != 1:
            shapes = " beside ".join(shape_text(b) for b in line)
            raise Undecided(f"blocks of different heights: {shapes}")
        rows += [[x for g in grids for x in g[r]] for r in range(len(grids[0]))]
    if len({len(row) for row in rows}) != 1:
        raise Undecided("rows of blocks of different widths")
    return matrix(rows)
