"""Factors at the ends of equations cancelled: Y G = Z G says Y = Z where G has an inverse."""

from __future__ import annotations

from collections.abc import Iterator
from heapq import heappop, heappush

from gainproof.verify.judge.matrices.book import Book
from gainproof.verify.judge.matrices.equation import Equation
from gainproof.verify.judge.matrices.macaulay import UnprovedError
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError

MOST_CANCELLED = 24
"""Of one equation."""
LONGER = 2
"""So many times the letters of the equation may be in one that follows from it."""


def cancelled(book: Book, equation: Equation) -> list[Equation]:
    """The equation times inverses of letters at the ends of its words, one after the other, short
    ones first: G^-1 = J^-1 times G and J is J = G.
    """
    most = LONGER * _letters(equation.value)
    found, seen = list[Equation](), {equation.value.key}
    waiting = [(0, 0, equation)]
    while waiting and len(found) < MOST_CANCELLED:
        one = heappop(waiting)[-1]
        for before, after in _ends(book, one.value):
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


def _ends(book: Book, value: Polynomial) -> Iterator[tuple[Polynomial, Polynomial]]:
    """What undoes the first or the last letter of a word, and the unit matrix on the other side."""
    rows, columns = (book.alphabet.unit(size) for size in value.shape)
    for letter in sorted({word[0] for word in value.terms if word}):
        inverse = _inverse(book, letter)
        if inverse is not None:
            yield inverse, columns
    for letter in sorted({word[-1] for word in value.terms if word}):
        inverse = _inverse(book, letter)
        if inverse is not None:
            yield rows, inverse


def _inverse(book: Book, letter: int) -> Polynomial | None:
    """The inverse of a letter that is free, or is the inverse of one; None for others."""
    alphabet, number = book.alphabet, letter // 2
    base = alphabet.base.get(number, number)
    if base in alphabet.elements or base not in book.established:
        return None
    other = alphabet.letter(alphabet.inverse_of(number))
    return other.T if letter % 2 else other
