"""Orders of matrices as sums of squares F' D F with D known to be positive (semi)definite."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.matrices.book import Book
from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.explicit import inverses_of
from gainproof.verify.judge.matrices.full_rank import left_inverses
from gainproof.verify.judge.matrices.gram import decomposed, signed_squares
from gainproof.verify.judge.matrices.groups import groups_with_sum
from gainproof.verify.judge.matrices.macaulay import UnprovedError
from gainproof.verify.judge.matrices.polynomial import Number, Polynomial, TooLongError, reciprocal
from gainproof.verify.judge.matrices.size import ZERO, Size

MOST_CANDIDATES = 60
MOST_SEARCHED = 12
MOST_MEANINGS = 5
MOST_PRODUCTS = 500
"""Fewer than for an equation, as there are many attempts."""


@dataclass(frozen=True)
class Square:
    """weight F' D F."""

    factor: Polynomial
    known: Known
    weight: Number = 1


def definite(book: Book, number: int) -> tuple[object, ...]:
    """Prove a letter positive definite. Raises UnprovedError."""
    letter = book.alphabet.letter(number)
    for known in book.known:
        if known.strict and known.value.key == letter.key:
            return known.reference
    if number not in book.alphabet.symmetric:
        raise UnprovedError("it is not known to be symmetric")
    try:
        evidence = prove_order(book, letter, True)
    except UnprovedError:
        if number not in book.invertible:
            raise
        # with an inverse by hypothesis it is enough that it is at least 0
        weak = prove_order(book, letter, False)
        sides = {"larger": book.graph(letter), "smaller": book.graph(letter - letter)}
        name = book.state("matrix_order", {**sides, "relation": ">="}, weak)
        book.known.append(Known(("statement", name), letter, False))
        return ("statement", name)
    claim = {"larger": book.graph(letter), "smaller": book.graph(letter - letter), "relation": ">"}
    reference = ("statement", book.state("matrix_order", claim, evidence))
    book.known.append(Known(reference, letter, True))
    return reference


def prove_order(book: Book, difference: Polynomial, strict: bool) -> dict[str, Any]:
    """Evidence that a matrix is positive (semi)definite. Raises UnprovedError."""
    value = book.alphabet.reduced(book.without_elements(difference)[0])
    for squares in _attempts(book, value):
        rest = difference
        for square in squares:
            middle = square.factor.T @ square.known.value @ square.factor
            rest = rest - middle.times(square.weight)
        try:
            cofactors = book.vanishing(rest, most=MOST_PRODUCTS)
            evidence = {
                "squares": [_plain(book, square) for square in squares],
                "cofactors": cofactors,
            }
            if strict:
                evidence["rank"] = _rank(book, squares, difference.shape[0])
        except (UnprovedError, TooLongError):
            continue
        return evidence
    raise UnprovedError("no sum of squares was found")


def _plain(book: Book, square: Square) -> dict[str, Any]:
    return {
        "weight": [[str(square.weight), [], []]],
        "factor": _positive(book, square.factor),
        "definite": square.known.reference,
    }


def _positive(book: Book, factor: Polynomial) -> Polynomial:
    """With a positive first term, as the checker wants it: the square is the same."""
    return -factor if str(book.data(factor)[0][0]).startswith("-") else factor


def _attempts(book: Book, value: Polynomial) -> Iterator[list[Square]]:
    """Lists of squares whose sum may be the value."""
    known = [*book.known, *_units(book, value)]
    if not value.terms:
        yield []
    for hint in book.said:
        for one in known:
            if hint.shape == (one.value.shape[0], value.shape[0]) and hint.terms:
                yield [Square(hint, one)]
    for hint in book.hints:
        for one in known:
            if hint.shape == (one.value.shape[0], value.shape[0]) and hint.terms:
                square = Square(hint, one)
                own = _expanded(book, square)
                if own is not None and own.key == value.key:
                    yield [square]
    gram = decomposed(book, value, known)
    if gram is not None:
        yield [Square(factor, one, weight) for factor, one, weight in gram]
    signed = signed_squares(book, value, known)
    if signed:
        yield [Square(factor, one) for factor, one in signed]
    candidates = list(_candidates(book, value, known))[:MOST_CANDIDATES]
    by_key = [(s, _expanded(book, s)) for s in candidates]
    found = [(s, v) for s, v in by_key if v is not None and v.terms]
    found += list(_by_equations(book, [s for s, _ in found]))
    for group in groups_with_sum(value, [own for _, own in found]):
        yield [found[at][0] for at in group]
    for square, own in found[:MOST_SEARCHED]:
        if set(own.terms) & set(value.terms):
            yield [square]
    yield from _of_inverses(book, known)
    yield from _of_bases(book, value, known)


def _expanded(book: Book, square: Square) -> Polynomial | None:
    try:
        product = square.factor.T @ square.known.value @ square.factor
        return book.alphabet.reduced(book.without_elements(product)[0])
    except TooLongError:
        return None


def _units(book: Book, value: Polynomial) -> list[Known]:
    """Unit matrices."""
    alphabet = book.alphabet
    sizes = {s for shape in alphabet.shapes for s in shape} | set(value.shape)
    return [Known(("unit", s), alphabet.unit(s), True) for s in sorted(sizes, key=str)]


def _candidates(book: Book, value: Polynomial, known: Sequence[Known]) -> Iterator[Square]:
    size = value.shape[0]
    for one in known:
        for hint in (*book.hints, *(h.T for h in book.hints)):
            if hint.shape == (one.value.shape[0], size) and hint.terms:
                yield Square(hint, one)
    for one in known:
        if one.value.shape[0] == size and one.reference[0] != "unit":
            yield Square(book.alphabet.unit(size), one)
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


def _by_equations(book: Book, squares: Sequence[Square]) -> Iterator[tuple[Square, Polynomial]]:
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
    found = [value]
    for equation in book.equations:
        if equation.value.shape != value.shape:
            continue
        word = next((w for w in equation.value.terms if w in value.terms), None)
        if word is not None:
            factor = value.terms[word] * reciprocal(equation.value.terms[word])
            if abs(factor) == 1:
                found.append(value - equation.value.times(factor))
    return list({p.key: p for p in found}.values())[:MOST_MEANINGS]


def _of_inverses(book: Book, known: Sequence[Known]) -> Iterator[list[Square]]:
    """Y2 - Y1 = Y1 G Y1 + Y1 G Y2 G Y1 for inverses of X1 and X2 with G = X1 - X2 >= 0."""
    alphabet = book.alphabet
    for one in known:
        gap = (
            alphabet.reduced(book.without_elements(one.value)[0])
            if one.reference[0] == "given"
            else one.value
        )
        words = sorted(gap.terms.items(), key=lambda term: -term[1])
        if [c for _, c in words] != [1, -1] or any(len(w) != 1 for w, _ in words):
            continue
        first, second = (_inverse_letter(book, word[0] // 2) for word, _ in words)
        if first is None or second is None:
            continue
        for other in known:
            if other.value.key == second.key:
                yield [
                    Square(first, one),
                    Square(alphabet.reduced(gap @ first), other),
                ]


def _of_bases(book: Book, value: Polynomial, known: Sequence[Known]) -> Iterator[list[Square]]:
    """Y2 - Y1 = Y1 G Y1 + Y1 G Y2 G Y1, from the value: X1 and X2 are what the inverses are of, G
    their difference, which is shown to be at least 0; a unit matrix is its own inverse.
    """
    alphabet = book.alphabet
    signs = {factor: word for word, factor in value.terms.items()}
    if len(value.terms) != 2 or set(signs) != {1, -1}:
        return
    bases: list[Polynomial] = []
    for sign in (-1, 1):
        word = signs[sign]
        if not word:
            bases.append(alphabet.unit(value.shape[0]))
        elif len(word) == 1 and word[0] // 2 in {**alphabet.base, **alphabet.inverse}:
            number = word[0] // 2
            base = alphabet.base.get(number, alphabet.inverse.get(number, number))
            bases.append(alphabet.elements.get(base, alphabet.letter(base)))
        else:
            return
    first, second = (Polynomial({signs[sign]: 1}, value.shape) for sign in (-1, 1))
    same = [k for k in known if k.strict and k.value.shape == second.shape]
    last = next((k for k in same if k.value.key == second.key), None)
    gap = alphabet.reduced(bases[0] - bases[1])
    if last is None or not gap.terms or gap.key == value.key:
        return
    for strict in (True, False):
        try:
            evidence = prove_order(book, gap, strict)
        except (UnprovedError, TooLongError):
            continue
        sides = {"larger": book.graph(gap), "smaller": book.graph(gap - gap)}
        name = book.state("matrix_order", {**sides, "relation": ">" if strict else ">="}, evidence)
        book.known.append(Known(("statement", name), gap, strict))
        break
    else:
        return
    yield [Square(first, book.known[-1]), Square(alphabet.reduced(gap @ first), last)]


def _inverse_letter(book: Book, number: int) -> Polynomial | None:
    alphabet = book.alphabet
    if number in alphabet.inverse:
        return alphabet.letter(alphabet.inverse[number])
    if number in alphabet.base:
        return alphabet.letter(alphabet.base[number])
    return None


def _rank(book: Book, squares: Sequence[Square], size: Size) -> dict[str, Any]:
    """Evidence that the squares vanish at zero only."""
    unit = book.alphabet.unit(size)
    factors = [(n, _positive(book, s.factor)) for n, s in enumerate(squares) if s.known.strict]
    candidates = [(n, left, f) for n, f in factors for left in left_inverses(book, f)]
    # one that needs no equation is sooner found than it is seen that another does not do
    for most in (0, MOST_PRODUCTS):
        for number, left, factor in candidates:
            try:
                cofactors = book.vanishing(unit - left @ factor, most=most)
            except (UnprovedError, TooLongError):
                continue
            return {"left_inverses": [[number, left]], "cofactors": cofactors}
    raise UnprovedError("no left inverse was found")
