"""Squares F' D F that an order may be a sum of, D known to be positive (semi)definite."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gainproof.verify.judge.matrices.block_inverses import inverses_of
from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import (
    Number,
    Polynomial,
    TooLongError,
    reciprocal,
)
from gainproof.verify.judge.matrices.size import ZERO, Size

MOST_MEANINGS = 5
FEW_TERMS = 4


@dataclass(frozen=True)
class Square:
    """weight F' D F."""

    factor: Polynomial
    known: Known
    weight: Number = 1


def expanded(book: Book, square: Square) -> Polynomial | None:
    try:
        product = square.factor.T @ square.known.value @ square.factor
        return book.alphabet.reduced(book.without_elements(product)[0])
    except TooLongError:
        return None


def units(book: Book, value: Polynomial) -> list[Known]:
    """Unit matrices."""
    alphabet = book.alphabet
    sizes = {s for shape in alphabet.shapes for s in shape} | set(value.shape)
    return [Known(("unit", s), alphabet.unit(s), True) for s in sorted(sizes, key=str)]


def candidates(book: Book, value: Polynomial, known: Sequence[Known]) -> Iterator[Square]:
    size = value.shape[0]
    for one in known:
        for hint in (*book.hints, *(h.T for h in book.hints)):
            if hint.shape == (one.value.shape[0], size) and hint.terms:
                yield Square(hint, one)
    for one in known:
        if one.value.shape[0] == size and one.reference[0] != "unit":
            yield Square(book.alphabet.unit(size), one)
    for one in known:
        # 1 - X' X = (1 - X' X)^2 + X' (1 - X X') X
        if one.strict and one.value.shape == value.shape and len(value.terms) <= FEW_TERMS:
            yield Square(value, one)
    for one in known:
        if one.reference[0] != "unit":
            yield from _schur(book, one, size)


def _schur(book: Book, one: Known, size: Size) -> Iterator[Square]:
    """F = E - C Z C' D E for blocks E of this size and the rest C of the size of D, Z being the
    inverse of C' D C: then F' D F is the Schur complement.
    """
    alphabet = book.alphabet
    whole = one.value.shape[0]
    if whole not in alphabet.blocks:
        return
    rest = whole - size
    if not rest.is_never_negative or rest == ZERO:
        return
    for start, rest_start in ((ZERO, size), (whole - size, ZERO)):
        try:
            picked = alphabet.embedded(whole, start, size)
            other = alphabet.embedded(whole, rest_start, rest)
        except (ValueError, KeyError):
            continue
        yield Square(picked, one)
        for value in _meant(book, one):
            corner = alphabet.reduced(other.T @ value @ other)
            beside = alphabet.reduced(other.T @ value @ picked)
            for inverse in inverses_of(book, corner):
                yield Square(picked - alphabet.reduced(other @ inverse @ beside), one)


def by_equations(book: Book, squares: Sequence[Square]) -> Iterator[tuple[Square, Polynomial]]:
    """Squares, what is definite put as equations have it."""
    for square in squares:
        for meaning in _meant(book, square.known)[1:]:
            try:
                value = book.alphabet.reduced(square.factor.T @ meaning @ square.factor)
            except TooLongError:
                continue
            if value.terms:
                yield square, value


def _meant(book: Book, one: Known) -> list[Polynomial]:
    """What is known to be definite, with what letters in it are short for, also by equations."""
    value = book.alphabet.reduced(book.without_elements(one.value)[0])
    found = [value, *by_words(book, value)]
    return list({p.key: p for p in found}.values())[:MOST_MEANINGS]


def by_words(book: Book, value: Polynomial) -> Iterator[Polynomial]:
    """The value as each equation has it that says what one of its words is."""
    for equation in book.equations:
        if equation.value.shape != value.shape:
            continue
        word = next((w for w in equation.value.terms if w in value.terms), None)
        if word is not None:
            factor = value.terms[word] * reciprocal(equation.value.terms[word])
            if abs(factor) == 1:
                yield value - equation.value.times(factor)


def of_inverses(book: Book, known: Sequence[Known]) -> Iterator[list[Square]]:
    """Y2 - Y1 = Y1 G Y1 + Y1 G Y2 G Y1 for inverses of multiples X1 and X2 of letters, of which
    G = X1 - X2 >= 0 is known.
    """
    alphabet = book.alphabet
    for one in known:
        gap = (
            alphabet.reduced(book.without_elements(one.value)[0])
            if one.reference[0] == "given"
            else one.value
        )
        words = sorted(gap.terms.items(), key=lambda term: -term[1])
        if (
            len(words) != 2
            or not words[1][1] < 0 < words[0][1]
            or any(len(w) != 1 for w, _ in words)
        ):
            continue
        first, second = (_inverse_letter(book, word[0] // 2) for word, _ in words)
        if first is None or second is None:
            continue
        first = first.times(reciprocal(words[0][1]))
        for other in known:
            if other.value.key == second.key:
                yield [
                    Square(first, one),
                    Square(alphabet.reduced(gap @ first), other, reciprocal(-words[1][1])),
                ]


def _inverse_letter(book: Book, number: int) -> Polynomial | None:
    alphabet = book.alphabet
    if number in alphabet.inverse:
        return alphabet.letter(alphabet.inverse[number])
    if number in alphabet.base:
        return alphabet.letter(alphabet.base[number])
    return None
