"""Matrices of expressions inside graphs: sums, products, opposites. Nothing is left out of a
product with zero.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from gainproof.verify.judge.exact.expression import Expr, add, mul, neg
from gainproof.verify.judge.exact.work_limits import Malformed

Grid = tuple[tuple[Expr, ...], ...]


def combined(kind: str, values: Sequence[Expr | Grid]) -> Expr | Grid:
    """The node `add`, `mul` or `neg` of scalars and matrices, left to right. Raises Malformed."""
    plain = [value for value in values if isinstance(value, Expr)]
    if len(plain) == len(values):
        return Expr(kind, None, tuple(plain))
    if kind == "neg":
        return _mapped(values[0], neg)
    total = values[0]
    for value in values[1:]:
        total = _sum(total, value) if kind == "add" else _product(total, value)
    return total


def _mapped(grid: Expr | Grid, change: Callable[[Expr], Expr]) -> Grid:
    assert not isinstance(grid, Expr)
    return tuple(tuple(change(entry) for entry in row) for row in grid)


def _sum(a: Expr | Grid, b: Expr | Grid) -> Grid:
    if isinstance(a, Expr) or isinstance(b, Expr) or len(a) != len(b) or len(a[0]) != len(b[0]):
        raise Malformed("a sum of matrices of different sizes")
    return tuple(
        tuple(add(x, y) for x, y in zip(p, q, strict=True)) for p, q in zip(a, b, strict=True)
    )


def _product(a: Expr | Grid, b: Expr | Grid) -> Expr | Grid:
    if isinstance(a, Expr):
        return mul(a, b) if isinstance(b, Expr) else _mapped(b, lambda entry: mul(a, entry))
    if isinstance(b, Expr):
        return _mapped(a, lambda entry: mul(entry, b))
    if len(a[0]) != len(b):
        raise Malformed("a product of matrices whose sizes do not fit")
    return tuple(
        tuple(
            add(*[mul(x, y) for x, y in zip(row, column, strict=True)])
            for column in zip(*b, strict=True)
        )
        for row in a
    )
