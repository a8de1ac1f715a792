"""Factors at the ends of equations cancelled: Y G = Z G says Y = Z where G has an inverse."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from heapq import heappop, heappush

from gainproof.verify.judge.matrices.book import Book
from gainproof.verify.judge.matrices.equation import Equation
from gainproof.verify.judge.matrices.inverse_facts import known_inverse
from gainproof.verify.judge.matrices.macaulay import UnprovedError
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError

MOST_CANCELLED = 24
"""Of one equation."""
LONGER = 2
"""So many times the letters of the equation may be in one that follows from it."""


def cancelled(book: Book, equation: Equation, *, common: bool = False) -> list[Equation]:
    """The equation times inverses of letters at the ends of its words, one after the other, short
    ones first: G^-1 = J^-1 times G and J is J = G. Where `common`, only of letters with which
    several words begin or end.
    """
    most = LONGER * _letters(equation.value)
    found, seen = list[Equation](), {equation.value.key}
    waiting = [(0, 0, equation)]
    while waiting and len(found) < MOST_CANCELLED:
        one = heappop(waiting)[-1]
        for before, after in _ends(book, one.value, 2 if common else 1):
            try:
                other = book.contracted_equation(book.normal(one.inside(before, after)))
            except (UnprovedError, TooLongError):
                continue
            size = _letters(other.value)
            if 0 < size <= most and other.value.key not in seen:
                seen.add(other.value.key)
                found.append(other)
                heappush(waiting, (size, len(found), other))
    return found


def _letters(value: Polynomial) -> int:
    return sum(map(len, value.terms))


def _ends(book: Book, value: Polynomial, least: int) -> Iterator[tuple[Polynomial, Polynomial]]:
    """What undoes the first or the last letter of so many words, and the unit on the other side."""
    rows, columns = (book.alphabet.unit(size) for size in value.shape)
    words = [word for word in value.terms if word]
    for at in (0, -1):
        for letter, times in sorted(Counter(word[at] for word in words).items()):
            inverse = known_inverse(book, letter)
            base = book.alphabet.base.get(letter // 2, letter // 2)
            if inverse is not None and times >= least and base not in book.alphabet.elements:
                yield (rows, inverse) if at else (inverse, columns)
