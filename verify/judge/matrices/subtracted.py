"""Squares whose sum is what a measurement leaves of a covariance: c' D c - v' N^-1 v for an N of
which g' D g is a part and v = g' D c. With F = N^-1 v it is (c - g F)' D (c - g F) and the other
parts of F' N F, as Joseph wrote it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gainproof.verify.judge.matrices.book import Book
from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.gram import decomposed
from gainproof.verify.judge.matrices.polynomial import (
    Number,
    Polynomial,
    TooLongError,
    Word,
    reciprocal,
    turned,
)
from gainproof.verify.judge.matrices.squares import Square

Part = tuple[Polynomial, Known, Number]
"""Of N: g, D and its weight."""


def of_subtracted(book: Book, value: Polynomial, known: Sequence[Known]) -> Iterator[list[Square]]:
    """Lists of squares that may be the value, which holds -f v' N^-1 v."""
    alphabet = book.alphabet
    for word, factor in value.terms.items():
        half, odd = divmod(len(word), 2)
        if factor > 0 or not odd or alphabet.normal(turned(word)) != word:
            continue
        base = alphabet.base.get(word[half] // 2)
        if base not in alphabet.elements:
            continue
        try:
            parts = decomposed(book, alphabet.elements[base], known) or []
        except TooLongError:
            continue
        for at in range(len(parts)):
            found = _squares(book, word[half:], parts, at, -factor)
            if found is None:
                continue
            whole, squares = found
            rest = alphabet.reduced(value - whole)
            more = decomposed(book, rest, known)
            if more is not None:
                yield [*squares, *(Square(f, one, weight) for f, one, weight in more)]


def _squares(
    book: Book, end: Word, parts: Sequence[Part], at: int, size: Number
) -> tuple[Polynomial, list[Square]] | None:
    """size (c' D c / w - v' N^-1 v) and its squares, for the part at this place, whose weight is w;
    None where v, what stands in `end` behind N^-1, is no g' D c.
    """
    alphabet, (factor, one, weight) = book.alphabet, parts[at]
    if len(factor.terms) != 1 or len(one.value.terms) != 1:
        return None
    ((word, number),) = factor.terms.items()
    (middle,) = one.value.terms
    begin = alphabet.normal((*turned(word), *middle))
    behind = end[1:]
    if not behind or number != 1 or begin is None or behind[: len(begin)] != begin:
        return None
    columns = alphabet.shapes[behind[-1] // 2][1 - behind[-1] % 2]
    rest = Polynomial({behind[len(begin) :]: reciprocal(weight)}, (one.value.shape[0], columns))
    solved = Polynomial({end: 1}, (factor.shape[1], columns))
    squares = [Square(g @ solved, d, size * w) for n, (g, d, w) in enumerate(parts) if n != at]
    squares.append(Square(rest - factor @ solved, one, size * weight))
    less = Polynomial({alphabet.normal((*turned(behind), *end)) or (): size}, (columns, columns))
    whole = (rest.T @ one.value @ rest).times(size * weight)
    return alphabet.reduced(whole - less), squares
