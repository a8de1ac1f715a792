"""Equations with inverses: as they stand, or multiplied by what is inverted."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from gainproof.verify.judge.matrices.alphabet import ONE
from gainproof.verify.judge.matrices.book import Book, Cofactor, Equation, UnprovedError
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError

MOST_MULTIPLIERS = 8
Multiplied = tuple[Polynomial, Callable[[Sequence[Cofactor]], list[Cofactor]]]


def cleared(book: Book, residual: Polynomial) -> list[Cofactor]:
    """Cofactors whose sum is the residual. Raises UnprovedError if none are found."""
    for more in ((), multiples(book, residual)):
        try:
            return book.vanishing(residual, more)
        except (UnprovedError, TooLongError):
            continue
    for multiplied, finish in _multiplied(book, residual):
        try:
            return finish(book.vanishing(multiplied, multiples(book, multiplied)))
        except (UnprovedError, TooLongError):
            continue
    return book.vanishing(residual, thorough=True)


def multiples(book: Book, residual: Polynomial) -> list[Equation]:
    """Equations times the inverses that occur, with the blocks of sizes in front of these."""
    alphabet = book.alphabet
    ends: dict[tuple[int, ...], Polynomial] = {}
    for word in residual.terms:
        for at, letter in enumerate(word):
            if letter // 2 in alphabet.base:
                start = at
                while start and word[start - 1] // 2 in alphabet.place:
                    start -= 1
                piece = word[start : at + 1]
                rows = alphabet.shapes[piece[0] // 2][piece[0] % 2]
                columns = alphabet.shapes[letter // 2][1]
                ends[piece] = Polynomial({piece: ONE}, (rows, columns))
    found: list[Equation] = []
    for equation in book.equations:
        for end in list(ends.values())[:MOST_MULTIPLIERS]:
            if equation.value.shape[1] == end.shape[0]:
                unit = alphabet.unit(equation.value.shape[0])
                parts = tuple(c.inside(unit, end) for c in equation.proof)
                one = book.contracted_equation(book.normal(Equation(equation.value @ end, parts)))
                if one.value.terms:
                    turned = book.normal(one.transposed())
                    found += [one, book.contracted_equation(turned)]
    return found


def _multiplied(book: Book, residual: Polynomial) -> Iterator[Multiplied]:
    """The residual times the base of an inverse at one of its ends, with the way back:
    r = Y (X r) - (Y X - 1) r.
    """
    alphabet = book.alphabet
    firsts = {word[0] // 2 for word in residual.terms if word and word[0] // 2 in alphabet.base}
    lasts = {word[-1] // 2 for word in residual.terms if word and word[-1] // 2 in alphabet.base}
    for numbers, is_left in ((firsts, True), (lasts, False)):
        for number in sorted(numbers):
            base = alphabet.base[number]
            value = alphabet.elements.get(base, alphabet.letter(base))
            yield _one_side(book, residual, base, value, is_left)


def _one_side(
    book: Book, residual: Polynomial, base: int, value: Polynomial, is_left: bool
) -> Multiplied:
    alphabet = book.alphabet
    inverse = alphabet.letter(alphabet.inverse[base])
    unit = alphabet.unit(value.shape[0])
    multiplied = value @ residual if is_left else residual @ value

    def finish(cofactors: Sequence[Cofactor]) -> list[Cofactor]:
        # checked with the element still in place of its letter
        side = "left" if is_left else "right"
        ends = (alphabet.unit(residual.shape[0]), alphabet.unit(residual.shape[1]))
        if is_left:
            back = [c.inside(inverse, ends[1]) for c in cofactors]
            rest = [Cofactor(("inverse", base, side), False, -unit, residual)]
            if base in alphabet.elements:
                # Y p r = Y X r - Y (X - p) r
                rest.append(Cofactor(("element", base), False, inverse, residual))
        else:
            back = [c.inside(ends[0], inverse) for c in cofactors]
            rest = [Cofactor(("inverse", base, side), False, -residual, unit)]
            if base in alphabet.elements:
                rest.append(Cofactor(("element", base), False, residual, inverse))
        return [*back, *rest]

    return multiplied, finish
