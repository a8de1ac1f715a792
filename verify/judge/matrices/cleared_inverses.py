"""Equations with inverses: as they stand, with inverses of block matrices written out, or
multiplied by what is inverted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from gainproof.verify.judge.matrices.block_inverses import (
    Establish,
    Explicit,
    explicit_inverses,
    put_in,
)
from gainproof.verify.judge.matrices.equation import Cofactor, Equation
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError

MOST_MULTIPLIERS = 8
FEW_PRODUCTS = 150
"""Of most proofs; others are sooner found with inverses written out."""
Finish = Callable[[Sequence[Cofactor]], list[Cofactor]]
FAILURES = (UnprovedError, TooLongError)


def cleared(book: Book, residual: Polynomial, establish: Establish) -> list[Cofactor]:
    """Cofactors whose sum the residual is. Raises UnprovedError if none are found."""
    try:
        return book.vanishing(residual, most=FEW_PRODUCTS)
    except FAILURES:
        pass
    written = explicit_inverses(book, establish)
    ways: list[tuple[Polynomial, Finish]] = [(residual, list), *_multiplied(book, residual)]
    if written:
        for goal, finish in ways:
            try:
                return finish(_with_written(book, goal, written))
            except FAILURES:
                continue
    if book.most > FEW_PRODUCTS:
        try:
            return book.vanishing(residual)
        except FAILURES:
            pass
    for goal, finish in ways:
        try:
            return finish(book.vanishing(goal, multiples(book, goal)))
        except FAILURES:
            continue
    raise UnprovedError("no proof was found")


def _with_written(book: Book, residual: Polynomial, written: list[Explicit]) -> list[Cofactor]:
    """The same with inverses of block matrices written out, also in the equations."""
    residual, replaced = book.without_elements(residual)
    value, trace = book.traced(residual)
    put = put_in(book, value, written)[1]
    more = [
        one
        for equation in book.equations
        if (one := _written_out(book, equation, written)) is not None
    ]
    rest = _taken_away(book, value, put)
    return [*replaced, *trace, *put, *book.vanishing(rest, more)]


def _written_out(book: Book, equation: Equation, written: list[Explicit]) -> Equation | None:
    """An equation with inverses of block matrices written out, if there are any in it."""
    cofactors = put_in(book, equation.value, written)[1]
    if not cofactors:
        return None

    def make() -> tuple[Cofactor, ...]:
        return (*equation.proof, *(c.negative() for c in cofactors))

    raw = _taken_away(book, equation.value, cofactors)
    one = book.contracted_equation(book.normal(Equation(raw, make)))
    return one if one.value.terms else None


def _taken_away(book: Book, value: Polynomial, cofactors: Sequence[Cofactor]) -> Polynomial:
    """A polynomial less its cofactors."""
    for c in cofactors:
        raw = book.raw(c.source)
        value = value - c.left @ (raw.T if c.flipped else raw) @ c.right
    return value


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
                ends[piece] = Polynomial({piece: 1}, (rows, columns))
    found: list[Equation] = []
    for equation in book.equations:
        for end in list(ends.values())[:MOST_MULTIPLIERS]:
            if equation.value.shape[1] == end.shape[0]:
                unit = alphabet.unit(equation.value.shape[0])
                one = book.contracted_equation(book.normal(equation.inside(unit, end)))
                if one.value.terms:
                    turned = book.normal(one.transposed())
                    found += [one, book.contracted_equation(turned)]
    return found


def _multiplied(book: Book, residual: Polynomial) -> Iterator[tuple[Polynomial, Finish]]:
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
            try:
                goal = value @ residual if is_left else residual @ value
            except TooLongError:
                continue
            yield goal, _way_back(book, residual, base, is_left)


def _way_back(book: Book, residual: Polynomial, base: int, is_left: bool) -> Finish:
    alphabet = book.alphabet
    inverse = alphabet.letter(alphabet.inverse[base])
    unit = alphabet.unit(inverse.shape[0])

    def finish(cofactors: Sequence[Cofactor]) -> list[Cofactor]:
        ends = (alphabet.unit(residual.shape[0]), alphabet.unit(residual.shape[1]))
        if is_left:
            # Y p r = Y X r - Y (X - p) r with the element X short for p
            back = [c.inside(inverse, ends[1]) for c in cofactors]
            back.append(Cofactor(("inverse", base, "left"), False, -unit, residual))
            element = Cofactor(("element", base), False, inverse, residual)
        else:
            back = [c.inside(ends[0], inverse) for c in cofactors]
            back.append(Cofactor(("inverse", base, "right"), False, -residual, unit))
            element = Cofactor(("element", base), False, residual, inverse)
        return [*back, element] if base in alphabet.elements else back

    return finish
