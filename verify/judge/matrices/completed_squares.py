"""Squares of sums from which an inverse is taken away, or to which it is added: with N the sum of
w g' D g and W = N^-1,

    sum w (c - g W v)' D (c - g W v) = sum w c' D c - v' W v    where sum w g' D c = v,
    sum w (g h - g W v)' D (g h - g W v) = h' N h - h' v - v' h + v' W v.

The first is what a measurement leaves of a covariance, as Joseph wrote it, and the convexity of the
inverse; the second, a square completed, what a gain other than Kalman's adds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from math import isqrt

from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.gram_squares import decomposed
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import (
    Number,
    Polynomial,
    TooLongError,
    reciprocal,
    turned,
)
from gainproof.verify.judge.matrices.squares import Square

Part = tuple[Polynomial, Known, Number]
"""Of a sum: F, D and the weight of F' D F."""
FEW_HINTS = 8


def of_subtracted(book: Book, value: Polynomial, known: Sequence[Known]) -> Iterator[list[Square]]:
    """Lists of squares that may be the value, which holds -v' W v."""
    for word, factor, parts, behind in _inverses(book, value, known):
        if factor > 0:
            continue
        rest = Polynomial({w: c for w, c in value.terms.items() if w != word}, value.shape)
        others = decomposed(book, rest.times(reciprocal(-factor)), known)
        if others is None:
            continue
        for sign in (1, -1):
            left = list(others)
            squares = list[Square]()
            for g, one, weight in parts:
                start = _taken(book, left, one, weight)
                solved = (g @ behind).times(sign)
                squares.append(Square(_less(start, solved), one, weight * -factor))
            squares += [Square(f, one, weight * -factor) for f, one, weight in left]
            yield _reduced(book, squares)


def of_completed(book: Book, value: Polynomial, known: Sequence[Known]) -> Iterator[list[Square]]:
    """Lists of squares that may be the value, which holds v' W v."""
    for _, factor, parts, behind in _inverses(book, value, known):
        if factor < 0:
            continue
        letters = [hint for hint in (*book.hints, *(h.T for h in book.hints)) if hint.terms]
        for hint in [h for h in letters if h.shape == behind.shape][:FEW_HINTS]:
            for sign in (1, -1):
                gap = hint - behind.times(sign)
                squares = [Square(g @ gap, one, weight * factor) for g, one, weight in parts]
                yield _reduced(book, squares)


def _inverses(
    book: Book, value: Polynomial, known: Sequence[Known]
) -> Iterator[tuple[tuple[int, ...], Number, list[Part], Polynomial]]:
    """Words v' W v, their factors, the parts of N, and W v."""
    alphabet = book.alphabet
    for word, factor in value.terms.items():
        half, odd = divmod(len(word), 2)
        if not odd or alphabet.normal(turned(word)) != word:
            continue
        number = alphabet.base.get(word[half] // 2, alphabet.inverse.get(word[half] // 2))
        if number is None:
            continue
        meaning = alphabet.elements.get(number, alphabet.letter(number))
        try:
            parts = decomposed(book, meaning, known)
        except TooLongError:
            continue
        if parts:
            end = word[half:]
            columns = alphabet.shapes[end[-1] // 2][1 - end[-1] % 2]
            yield word, factor, parts, Polynomial({end: 1}, (meaning.shape[0], columns))


def _taken(book: Book, parts: list[Part], one: Known, weight: Number) -> Polynomial | None:
    """c with c' D c one of the parts, of D or of its inverse, over a weight; it is taken away."""
    alphabet = book.alphabet
    for at, (factor, other, size) in enumerate(parts):
        root = _root(size * reciprocal(weight))
        if root is None or other.value.shape != one.value.shape:
            continue
        if other.value.key == one.value.key:
            del parts[at]
            return factor.times(root)
        product = alphabet.reduced(one.value @ other.value)
        if product.key == alphabet.unit(product.shape[0]).key:
            del parts[at]
            return alphabet.reduced(other.value @ factor).times(root)
    return None


def _reduced(book: Book, squares: list[Square]) -> list[Square]:
    """In normal form, without those of 0."""
    found = [replace(s, factor=book.alphabet.reduced(s.factor)) for s in squares]
    return [square for square in found if square.factor.terms]


def _less(start: Polynomial | None, solved: Polynomial) -> Polynomial:
    return -solved if start is None else start - solved


def _root(value: Number) -> Number | None:
    """The root of a number that is a square."""
    whole = Fraction(value)
    found = Fraction(isqrt(whole.numerator), isqrt(whole.denominator))
    if found * found != whole:
        return None
    return found.numerator if found.denominator == 1 else found
