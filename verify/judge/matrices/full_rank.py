"""Why a sum of squares vanishes at zero only: multiples of its factors add up to the unit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.gram_squares import decomposed
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError, reciprocal
from gainproof.verify.judge.matrices.size import ZERO, Size

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


def left_inverses(book: Book, factor: Polynomial) -> Iterator[Polynomial]:
    """Candidates L for L F = 1, the likely ones first."""
    alphabet = book.alphabet
    rows, columns = factor.shape
    if rows == columns:
        yield alphabet.unit(rows)
        yield -alphabet.unit(rows)
    for hint in (*book.hints, *(h.T for h in book.hints)):
        if hint.shape == (columns, rows):
            yield hint
            yield -hint
    if alphabet.reduced(factor.T @ factor).key == alphabet.unit(columns).key:
        yield factor.T
    yield from _of_letters(book, factor)
    yield from _of_blocks(book, factor)
    yield from _of_grams(book, factor)
    yield factor.T


def _of_letters(book: Book, factor: Polynomial) -> Iterator[Polynomial]:
    """The inverses of the letters of one word, backwards; what a letter is short for counts too."""
    alphabet = book.alphabet
    if len(factor.terms) == 1:
        ((word, value),) = factor.terms.items()
        total = alphabet.unit(factor.shape[1]).times(reciprocal(value))
        for letter in reversed(word):
            number = letter // 2
            if number in alphabet.base:
                other = alphabet.letter(alphabet.base[number])
            elif number in alphabet.inverse:
                other = alphabet.letter(alphabet.inverse[number])
            elif number in alphabet.place:
                other = alphabet.letter(number).T
            else:
                return
            total = total @ (other.T if letter % 2 else other)
        yield total
    for base, inverse in alphabet.inverse.items():
        meaning = alphabet.elements.get(base)
        if meaning is not None and meaning.key == factor.key:
            yield alphabet.letter(inverse)


def _of_blocks(book: Book, factor: Polynomial) -> Iterator[Polynomial]:
    """Rows of the factor that are the unit matrix."""
    alphabet = book.alphabet
    rows, columns = factor.shape
    if rows not in alphabet.blocks:
        return
    start = ZERO
    for size in alphabet.cuts[rows]:
        end = start + columns
        if (rows - end).is_never_negative:
            try:
                picked = alphabet.embedded(rows, start, columns).T
            except ValueError:
                start = start + size
                continue
            for one in (picked, -picked):
                gap = alphabet.reduced(one @ factor) - alphabet.unit(columns)
                if not gap.terms or _only_blocks(book, gap):
                    yield one
        start = start + size


def _only_blocks(book: Book, gap: Polynomial) -> bool:
    return all(letter // 2 in book.alphabet.place for word in gap.terms for letter in word)


def _of_grams(book: Book, factor: Polynomial) -> Iterator[Polynomial]:
    """With N = G' X G invertible and F = G T, T picking columns: T' N^-1 G' X."""
    alphabet = book.alphabet
    for base in sorted(book.invertible):
        meaning = alphabet.elements.get(base)
        if meaning is None or base not in alphabet.inverse:
            continue
        for gram, middle in _grams(book, meaning, factor):
            picked = _picking(book, gram, factor)
            if picked is not None:
                inverse = alphabet.letter(alphabet.inverse[base])
                yield picked.T @ inverse @ gram.T @ middle


def _grams(
    book: Book, meaning: Polynomial, factor: Polynomial
) -> Iterator[tuple[Polynomial, Polynomial]]:
    """G and X with G' X G the polynomial and G as many rows as the factor has."""
    known = [*book.known, *_unit_knowns(book)]
    for gram in book.hints:
        if gram.shape != (factor.shape[0], meaning.shape[0]):
            continue
        for middle in known:
            if middle.value.shape[0] == gram.shape[0]:
                product = book.alphabet.reduced(gram.T @ middle.value @ gram)
                if product.key == meaning.key:
                    yield gram, middle.value
    try:
        squares = decomposed(book, meaning, known)
    except TooLongError:
        return
    if squares is not None and len(squares) == 1 and squares[0][2] == 1:
        gram, middle, _ = squares[0]
        if gram.shape[0] == factor.shape[0]:
            yield gram, middle.value


def _unit_knowns(book: Book) -> list[Known]:
    alphabet = book.alphabet
    sizes = {s for shape in alphabet.shapes for s in shape}
    return [Known(("unit", s), alphabet.unit(s), True) for s in sorted(sizes, key=str)]


def _picking(book: Book, gram: Polynomial, factor: Polynomial) -> Polynomial | None:
    """T with F = G T that picks columns of G, or multiplies them by blocks."""
    alphabet = book.alphabet
    if gram.key == factor.key and gram.shape == factor.shape:
        return alphabet.unit(gram.shape[1])
    own = [alphabet.letter(n) for n in alphabet.blocks.get(factor.shape[1], ())]
    there = [alphabet.letter(n) for n in alphabet.blocks.get(gram.shape[1], ())]
    own = own or [alphabet.unit(factor.shape[1])]
    there = there or [alphabet.unit(gram.shape[1])]
    total = Polynomial({}, (gram.shape[1], factor.shape[1]))
    for column in own:
        wanted = alphabet.reduced(factor @ column)
        for other in there:
            found = alphabet.reduced(gram @ other)
            turns = [alphabet.unit(other.shape[1])] if other.shape[1] == column.shape[1] else []
            turns += [
                alphabet.letter(n)
                for n in alphabet.blocks.get(other.shape[1], ())
                if alphabet.shapes[n][1] == column.shape[1]
            ]
            turn = next((t for t in turns if alphabet.reduced(found @ t).key == wanted.key), None)
            if turn is not None:
                total = total + other @ turn @ column.T
                break
        else:
            return None
    return total
