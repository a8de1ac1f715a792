"""Inverses of block matrices written out: with p and q the two halves of a size and M symmetric,

    M^-1 = T R T' + Q Z Q',   Z = M_qq^-1,   R = (M_pp - M_pq Z M_qp)^-1,   T = P - Q Z M_qp,

where P and Q pick the halves. It is stated as an equation, proved by M F = 1, and put in for the
letter of the inverse.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from gainproof.verify.judge.matrices.equation import Cofactor
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError
from gainproof.verify.judge.matrices.size import ZERO

Establish = Callable[[Book, Polynomial], None]
"""Makes a book know the inverses that are not established yet; a polynomial may be a left one."""


@dataclass(frozen=True)
class Explicit:
    """An inverse letter, what it is, and where it is stated that letter - what = 0."""

    letter: int
    value: Polynomial
    source: tuple[object, ...]


def explicit_inverses(book: Book, establish: Establish) -> list[Explicit]:
    """All that are found, each inverse once."""
    found: list[Explicit] = []
    for base, inverse in list(book.alphabet.inverse.items()):
        if base in book.alphabet.elements and base in book.invertible:
            one = _explicit(book, base, inverse, establish)
            if one is not None:
                found.append(one)
    return found


def _explicit(book: Book, base: int, inverse: int, establish: Establish) -> Explicit | None:
    alphabet = book.alphabet
    for meaning, why in meanings(book, base):
        for first, second in _halves(book, meaning):
            corner = alphabet.reduced(second.T @ meaning @ second)
            beside = alphabet.reduced(second.T @ meaning @ first)
            for z in inverses_of(book, corner):
                try:
                    return _written(
                        book, base, inverse, (meaning, why), (first, second), z, beside, establish
                    )
                except (UnprovedError, TooLongError):
                    continue
    return None


def meanings(book: Book, base: int) -> Iterator[tuple[Polynomial, list[Cofactor]]]:
    """What is inverted, as it stands or as an equation has it, with cofactors of the difference:
    element = meaning + their sum; every word between two blocks.
    """
    value = book.alphabet.elements[base]
    options = [(value, list[Cofactor]())]
    for equation in book.equations:
        options.append((value - equation.value, list(equation.proof)))
        options.append((value + equation.value, [c.negative() for c in equation.proof]))
    places = book.alphabet.place
    for meaning, why in options:
        if all(len(w) > 1 and w[0] // 2 in places and w[-1] // 2 in places for w in meaning.terms):
            yield meaning, why


def _halves(book: Book, value: Polynomial) -> Iterator[tuple[Polynomial, Polynomial]]:
    """The two ways of naming the halves of a size at each of its cuts."""
    alphabet = book.alphabet
    size = value.shape[0]
    place = ZERO
    for width in alphabet.cuts.get(size, [])[:-1]:
        place = place + width
        try:
            one = alphabet.embedded(size, ZERO, place)
            other = alphabet.embedded(size, place, size - place)
        except (ValueError, KeyError):
            continue
        yield one, other
        yield other, one


def inverses_of(book: Book, value: Polynomial) -> Iterator[Polynomial]:
    """Letters, or the unit matrix, that are the inverse of a polynomial."""
    alphabet = book.alphabet
    gap = value - alphabet.unit(value.shape[0])
    if not book.short(gap).terms:
        yield alphabet.unit(value.shape[0])
        return
    short = book.short(value).key
    for base, inverse in list(alphabet.inverse.items()):
        meaning = alphabet.elements.get(base, alphabet.letter(base))
        if meaning.shape == value.shape and book.short(meaning).key == short:
            yield alphabet.letter(inverse)


def _written(
    book: Book,
    base: int,
    inverse: int,
    meant: tuple[Polynomial, list[Cofactor]],
    halves: tuple[Polynomial, Polynomial],
    z: Polynomial,
    beside: Polynomial,
    establish: Establish,
) -> Explicit:
    alphabet = book.alphabet
    meaning, why = meant
    first, second = halves
    corner = first.T @ meaning @ first - beside.T @ z @ beside
    schur = alphabet.reduced(corner)
    known = next(inverses_of(book, schur), None)
    if known is None:
        number = alphabet.short_for(book.short(schur))
        known = alphabet.letter(alphabet.inverse_of(number))
        establish(book, alphabet.reduced(first.T @ alphabet.letter(inverse) @ first))
    turned = first - second @ z @ beside
    value = alphabet.reduced(turned @ known @ turned.T + second @ z @ second.T)
    unit = alphabet.unit(value.shape[0])
    letter = alphabet.letter(inverse)
    # Y - F = Y (1 - M F) + (Y M - 1) F, and M = p + its cofactors
    product = book.vanishing(meaning @ value - unit)
    cofactors = [c.inside(-letter, unit) for c in product]
    cofactors.append(Cofactor(("inverse", base, "left"), False, unit, value))
    cofactors.append(Cofactor(("element", base), False, -letter, value))
    cofactors += [c.inside(-letter, value) for c in why]
    name = book.state(
        "matrix_equal",
        {"left": book.graph(letter), "right": book.graph(value)},
        {"cofactors": cofactors},
    )
    book.differences[name] = letter - value
    return Explicit(inverse, value, ("statement", name))


def put_in(
    book: Book, value: Polynomial, known: list[Explicit]
) -> tuple[Polynomial, list[Cofactor]]:
    """A polynomial with inverses written out: value = result + cofactors."""
    alphabet, cofactors = book.alphabet, list[Cofactor]()
    by_letter = {one.letter: one for one in known}
    while True:
        place = next(
            ((w, at) for w in value.terms for at, n in enumerate(w) if n // 2 in by_letter), None
        )
        if place is None:
            return book.short(alphabet.reduced(value)), cofactors
        word, at = place
        one = by_letter[word[at] // 2]
        flipped = bool(word[at] % 2)
        source = one.source
        cofactor = book.at(word, at, at + 1, source, flipped, value.terms[word], value)
        meaning = one.value.T if flipped else one.value
        gone = Polynomial({word: value.terms[word]}, value.shape)
        value = alphabet.reduced(value - gone + cofactor.left @ meaning @ cofactor.right)
        cofactors.append(cofactor)
