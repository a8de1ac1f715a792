"""What equations of a book say that no sum of their multiples does: factors cancelled, and why an
N that is wanted is 0. Since N P = 0 with P positive definite; since N = N P W with the inverse W of
P; since equations make N D N' minus a sum of squares, so that it is 0.

Factors at the ends of equations are cancelled: Y G = Z G says Y = Z where G has an inverse.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from heapq import heappop, heappush
from typing import Any

from gainproof.verify.judge.matrices.division import quotient
from gainproof.verify.judge.matrices.equation import Cofactor, Equation, Known
from gainproof.verify.judge.matrices.gram_squares import decomposed
from gainproof.verify.judge.matrices.hypotheses import add_equation
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.inverse_facts import known_inverse
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import (
    Polynomial,
    TooLongError,
    reciprocal,
)
from gainproof.verify.judge.matrices.semidefinite_order import state_order
from gainproof.verify.judge.matrices.squares import units
from gainproof.verify.judge.matrices.zero_matrices import by_definite

FAILURES = (UnprovedError, TooLongError)
MOST_CANCELLED = 24
"""Of one equation."""
LONGER = 2
"""So many times the letters of the equation may be in one that follows from it."""


def draw_consequences(book: Book, residuals: list[Polynomial]) -> bool:
    """Add them to the book, for these matrices that are to be shown zero; whether there are any."""
    before = len(book.equations) + len(book.known)
    for equation in [*book.equations, *_meanings(book)]:
        for one in cancelled(book, equation, common=_of_an_inverse(book, equation)):
            add_equation(book, one)
    _of_sums(book)
    for residual in residuals:
        value = book.alphabet.reduced(book.without_elements(residual)[0])
        for side in (value, book.alphabet.reduced(value.T)):
            _of_multiples(book, side)
            _of_squares(book, side)
    return len(book.equations) + len(book.known) > before


def _of_an_inverse(book: Book, equation: Equation) -> bool:
    """Whether it says what the inverse of an element is, or a letter by that."""
    alphabet = book.alphabet
    held = [
        any(alphabet.base.get(letter // 2) in alphabet.elements for letter in word)
        for word in equation.value.terms
    ]
    return any(held) and not all(held)


def _meanings(book: Book) -> Iterator[Equation]:
    """X = p for the letters X of elements that are supposed to be positive (semi)definite."""
    alphabet = book.alphabet
    for known in book.known:
        for number, meaning in alphabet.elements.items():
            letter = alphabet.letter(number)
            if known.value.key == letter.key:
                rows, columns = (alphabet.unit(size) for size in meaning.shape)
                proof = (Cofactor(("element", number), False, rows, columns),)
                yield book.normal(Equation(letter - meaning, lambda proof=proof: proof))  # type: ignore[misc]


def _of_multiples(book: Book, wanted: Polynomial) -> None:
    """Of equations N P = 0 with N the wanted."""
    alphabet = book.alphabet
    for equation in list(book.equations):
        other = quotient(alphabet, equation.value, wanted)
        if other is None or other.shape[0] != other.shape[1]:
            continue
        for number, meaning in list(alphabet.elements.items()):
            if number in alphabet.inverse and number in book.established:
                for flipped, own in ((False, meaning), (True, alphabet.reduced(meaning.T))):
                    if own.primitive.key == other.primitive.key:
                        add_equation(book, _divided(book, equation, wanted, number, flipped))
        if alphabet.reduced(other.T).key == other.key:
            for one in (other, -other):
                with suppress(*FAILURES):
                    state_order(book, one, strict=True)
                    break


def _divided(
    book: Book, equation: Equation, wanted: Polynomial, number: int, flipped: bool
) -> Equation:
    """N = E W - N (p W - 1) for the equation E = N p and the inverse W of the element p, or with
    the transposes of both.
    """
    alphabet = book.alphabet
    meaning, inverse = alphabet.elements[number], alphabet.letter(alphabet.inverse[number])
    if flipped:
        meaning, inverse = meaning.T, inverse.T
    unit, rows = alphabet.unit(wanted.shape[1]), alphabet.unit(wanted.shape[0])
    whole = alphabet.reduced(wanted @ meaning)
    word = next(iter(whole.terms))
    weight = equation.value.terms[word] * reciprocal(whole.terms[word])
    behind = inverse.times(reciprocal(weight))
    value = equation.value @ behind + wanted - wanted @ meaning @ inverse

    def make() -> tuple[Cofactor, ...]:
        # X W - 1 with the letter X of the element, and X - p; of transposes W' X' is found first
        side = "left" if flipped else "right"
        one = Cofactor(("inverse", number, side), flipped, -wanted, unit)
        element = Cofactor(("element", number), flipped, wanted, inverse)
        return (*(c.inside(rows, behind) for c in equation.proof), one, element)

    return book.normal(Equation(value, make))


def _of_sums(book: Book) -> None:
    """D F = 0 for each square F' D F of a sum that equations make 0, or that is at most 0."""
    facts = [e.value for e in book.equations if not _of_an_inverse(book, e)]
    at_most = [-book.alphabet.reduced(book.without_elements(k.value)[0]) for k in book.known]
    for fact in (*facts, *(-fact for fact in facts), *at_most):
        if fact.shape[0] == fact.shape[1]:
            for factor, one, _ in decomposed(book, fact, [*book.known, *units(book, fact)]) or ():
                with suppress(*FAILURES):
                    _vanishes(book, factor, one)


def _vanishes(book: Book, factor: Polynomial, known: Known) -> None:
    """State that D F is 0, or F if D > 0, since F' D F is. Raises UnprovedError, TooLongError."""
    wanted = factor if known.strict else book.alphabet.reduced(known.value @ factor)
    evidence = by_definite(book, wanted)
    if evidence is None:
        _squeeze(book, book.alphabet.reduced(factor.T @ known.value @ factor))
        evidence = by_definite(book, wanted)
    if evidence is not None:
        _add_zero(book, wanted, evidence)


def _of_squares(book: Book, wanted: Polynomial) -> None:
    """Where equations make a square of the wanted minus a sum of squares, it is 0."""
    rows = wanted.shape[1]
    unit = Known(("unit", rows), book.alphabet.unit(rows), True)
    facts = [equation.value for equation in book.equations]
    facts += [book.alphabet.reduced(book.without_elements(k.value)[0]) for k in book.known]
    words = {word for fact in facts for word in fact.terms}
    for known in (*book.known, unit):
        if not known.strict or known.value.shape[0] != rows:
            continue
        try:
            form = book.alphabet.reduced(wanted @ known.value @ wanted.T)
        except TooLongError:
            continue
        if form.terms and words.issuperset(form.terms):
            with suppress(*FAILURES):
                _squeeze(book, form)


def _squeeze(book: Book, form: Polynomial) -> None:
    """State that it is 0, being neither more nor less. Raises UnprovedError, TooLongError."""
    below = state_order(book, -form, strict=False)
    above = state_order(book, form, strict=False)
    evidence = {
        "above": above.reference,
        "below": below.reference,
        "cofactors": [],
        "opposite": [],
    }
    _add_zero(book, form, evidence)


def _add_zero(book: Book, value: Polynomial, evidence: dict[str, Any]) -> None:
    """State that it is 0."""
    claim = {"left": book.graph(value), "right": book.graph(value - value)}
    name = book.state("matrix_equal", claim, evidence)
    book.differences[name] = value
    add_equation(book, book.equation(("statement", name)))


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
