"""Products, inverses and blocks of tables of dimensions.

Where shapes do not fit the dimension is not known: that is said where the formula is judged.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations

from gainproof.verify.judge.dimensions.dimension import (
    ANY,
    ONE,
    Dimension,
    Dimensions,
    Table,
    agreed,
    mapped,
    times,
)

MOST_ROWS = 5
"""Determinants of larger matrices have an unknown dimension: a product for each order of rows."""
PRODUCTS = "the products of a determinant"


def multiplied(a: Dimensions, b: Dimensions, what: str = "the terms of a product") -> Dimensions:
    """The product. Raises Mismatch where terms of an entry do not agree."""
    if not isinstance(a, tuple):
        return ANY if a == ANY else mapped(b, lambda entry: times(entry, a))
    if not isinstance(b, tuple):
        return ANY if b == ANY else mapped(a, lambda entry: times(entry, b))
    if len(a[0]) != len(b):
        return ANY
    columns = list(zip(*b, strict=True))
    return _plain([[_dot(row, column, what) for column in columns] for row in a])


def _dot(row: Sequence[Dimension], column: Sequence[Dimension], what: str) -> Dimension:
    found = agreed([times(x, y) for x, y in zip(row, column, strict=True)], what)
    assert not isinstance(found, tuple)
    return found


def _plain(rows: Sequence[Sequence[Dimension]]) -> Dimensions:
    """The table; of one entry, the entry."""
    if len(rows) == len(rows[0]) == 1:
        return rows[0][0]
    return tuple(tuple(row) for row in rows)


def transposed(a: Dimensions) -> Dimensions:
    """The transpose; a number is its own."""
    return tuple(zip(*a, strict=True)) if isinstance(a, tuple) else a


def stacked(blocks: Sequence[Sequence[Dimensions]]) -> Dimensions:
    """A matrix from blocks."""
    rows: list[list[Dimension]] = []
    for line in blocks:
        tables = [block if isinstance(block, tuple) else ((block,),) for block in line]
        if len({len(table) for table in tables}) != 1:
            return ANY
        rows += [[x for table in tables for x in table[r]] for r in range(len(tables[0]))]
    return _plain(rows) if len({len(row) for row in rows}) == 1 else ANY


def kronecker(a: Dimensions, b: Dimensions) -> Dimensions:
    """Every entry of the first times the second."""
    first = a if isinstance(a, tuple) else ((a,),)
    return stacked([[multiplied(entry, b) for entry in row] for row in first])


def raised(a: Table, exponent: int) -> Dimensions:
    """A whole power of a matrix."""
    if exponent < 0:
        a_inverse = inverse(a)
        return raised(a_inverse, -exponent) if isinstance(a_inverse, tuple) else ANY
    found: Dimensions = unit_matrix(a)
    for _ in range(min(exponent, MOST_ROWS)):
        found = multiplied(found, a)
    # what higher powers mix, the first ones mix
    return found if exponent <= MOST_ROWS else ANY


def unit_matrix(a: Table) -> Dimensions:
    """Of the numbers one and zero."""
    size = range(len(a))
    return tuple(tuple(ONE if i == j else ANY for j in size) for i in size)


def determinant(a: Dimensions) -> Dimension:
    """The dimension of a determinant. Raises Mismatch where its products do not agree."""
    if not isinstance(a, tuple):
        return a
    size = len(a)
    if size != len(a[0]) or size > MOST_ROWS:
        return ANY
    products: list[Dimensions] = []
    for order in permutations(range(size)):
        product: Dimension = ONE
        for row, column in enumerate(order):
            product = times(product, a[row][column])
        products.append(product)
    found = agreed(products, PRODUCTS)
    assert not isinstance(found, tuple)
    return found


def inverse(a: Dimensions) -> Dimensions:
    """The inverse: entry i, j has the dimension of the determinant without row j and column i over
    the determinant. Raises Mismatch.
    """
    if not isinstance(a, tuple):
        return times(ONE, a, -1)
    whole = determinant(a)
    if whole == ANY or len(a) != len(a[0]):
        return ANY
    size = range(len(a))
    return tuple(tuple(times(_minor(a, j, i), whole, -1) for j in size) for i in size)


def _minor(a: Table, row: int, column: int) -> Dimension:
    rest = tuple(
        tuple(x for j, x in enumerate(line) if j != column) for i, line in enumerate(a) if i != row
    )
    return determinant(rest) if rest else ONE
