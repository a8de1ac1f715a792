"""Why a sum of squares vanishes at zero only: multiples of its factors add up to the unit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from gainproof.verify.judge.matrices.book import Book
from gainproof.verify.judge.matrices.full_rank import left_inverses
from gainproof.verify.judge.matrices.macaulay import UnprovedError
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError, reciprocal
from gainproof.verify.judge.matrices.size import Size

Left = tuple[int, Polynomial]
"""Number of a square and what its factor is multiplied by."""


def full_rank(
    book: Book, factors: Sequence[tuple[int, Polynomial]], size: Size, most: int
) -> dict[str, Any]:
    """Evidence from the factors of squares of what is definite, by their numbers, each equation of
    at most so many products. Raises UnprovedError.
    """
    unit = book.alphabet.unit(size)
    tried = [([(n, left)], left @ f) for n, f in factors for left in left_inverses(book, f)]
    tried += _pairs(book, factors, unit)
    # one that needs no equation is sooner found than it is seen that another does not do
    for limit in (0, most):
        for lefts, total in tried:
            try:
                cofactors = book.vanishing(unit - total, most=limit)
            except (UnprovedError, TooLongError):
                continue
            return {"left_inverses": [list(left) for left in lefts], "cofactors": cofactors}
    raise UnprovedError("no left inverse was found")


def _pairs(
    book: Book, factors: Sequence[tuple[int, Polynomial]], unit: Polynomial
) -> Iterator[tuple[list[Left], Polynomial]]:
    """F, and what is left of the unit matrix as a multiple of another: 1 = (1 - L G) + L G."""
    for number, factor in factors:
        if factor.shape != unit.shape:
            continue
        for one in (unit, -unit):
            first = one @ factor
            rest = book.alphabet.reduced(unit - first)
            for other, behind in factors:
                left = _quotient(rest, behind)
                if other != number and left is not None:
                    yield [(number, one), (other, left)], first + left @ behind


def _quotient(value: Polynomial, factor: Polynomial) -> Polynomial | None:
    """L with value = L factor, for a factor of one word."""
    if len(factor.terms) != 1 or not value.terms:
        return None
    ((word, number),) = factor.terms.items()
    start = {w: w[: len(w) - len(word)] for w in value.terms}
    if any(start[w] + word != w for w in value.terms):
        return None
    terms = {start[w]: count * reciprocal(number) for w, count in value.terms.items()}
    return Polynomial(terms, (value.shape[0], factor.shape[0]))
