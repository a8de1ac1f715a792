"""One dimension, and tables of them: those of the entries of a matrix.

A number has no dimension; the number zero has any. A symbol without a declared unit has an unknown
one, which agrees with everything.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.claim.record import Unit
from gainproof.verify.judge.claim.units import unit_text_of

ONE = Unit()


@dataclass(frozen=True)
class _Any:
    """Zero, or a symbol of unknown unit."""


ANY = _Any()
Dimension = Unit | _Any
Table = tuple[tuple[Dimension, ...], ...]
Dimensions = Dimension | Table
"""Of a number or, entry by entry, of a matrix. `ANY` may stand for a matrix too."""


class Mismatch(Exception):
    """Two dimensions that should agree and do not; the text names both."""


def agreed(parts: Sequence[Dimensions], what: str) -> Dimensions:
    """The dimensions that all parts have, entry by entry. Raises Mismatch.

    Matrices of different shapes have no sum: that is said where the formula is judged.
    """
    known = [part for part in parts if part != ANY]
    if not known:
        return ANY
    tables = [part for part in known if isinstance(part, tuple)]
    if not tables:
        return _agreed(known, what)
    first = tables[0]
    if len(tables) < len(known) or any(_shape(t) != _shape(first) for t in tables):
        return ANY
    return tuple(
        tuple(
            _agreed([table[r][c] for table in tables], f"{what}, in row {r + 1}, column {c + 1},")
            for c in range(len(first[0]))
        )
        for r in range(len(first))
    )


def _agreed(parts: Sequence[Dimensions], what: str) -> Dimension:
    known = [part for part in parts if isinstance(part, Unit)]
    for part in known:
        if part != known[0]:
            raise Mismatch(
                f"{what} have dimensions {unit_text_of(known[0])} and {unit_text_of(part)}"
            )
    return known[0] if known else ANY


def without_dimension(part: Dimensions, what: str) -> None:
    """Raises Mismatch where something that must be a number has a dimension."""
    for entry in entries(part):
        if isinstance(entry, Unit) and entry != ONE:
            raise Mismatch(f"{what} has dimension {unit_text_of(entry)}, wanted a number")


def entries(value: Dimensions) -> list[Dimension]:
    """All entries, row by row."""
    return [x for row in value for x in row] if isinstance(value, tuple) else [value]


def mapped(value: Dimensions, change: Callable[[Dimension], Dimension]) -> Dimensions:
    """Every entry changed."""
    if isinstance(value, tuple):
        return tuple(tuple(change(entry) for entry in row) for row in value)
    return change(value)


def times(a: Dimension, b: Dimension, exponent: int | Fraction = 1) -> Dimension:
    """The dimension of a b^exponent."""
    if isinstance(a, _Any) or isinstance(b, _Any):
        return ANY
    return a * b**exponent


def _shape(table: Table) -> tuple[int, int]:
    return len(table), len(table[0])
