"""The existence of every inverse that a proof speaks of."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any

from gainproof.verify.judge.matrices.definite_inverses import speak_of_definite, turned_inverses
from gainproof.verify.judge.matrices.equation import Cofactor, Equation
from gainproof.verify.judge.matrices.hypotheses import add_equation
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.inverse_facts import (
    inverse_equations,
    make_symmetric,
    state_definite_inverse,
    state_symmetric_inverse,
)
from gainproof.verify.judge.matrices.inverses_from_products import (
    add_inverse,
    inverses_by_products,
    speak_of_factors,
)
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Number, Polynomial, reciprocal

Definite = Callable[[Book, int], tuple[object, ...]]
"""Proves a letter positive definite; where that is known from. Raises UnprovedError."""


def establish(
    book: Book,
    definite: Definite,
    candidates: Sequence[Polynomial] = (),
    *,
    eager: bool = False,
) -> None:
    """For every inverse that is spoken of: it exists, is symmetric if its base is, and its
    equations. `candidates` may be left inverses, likely ones where `eager`. Raises UnprovedError,
    saying what has no inverse.
    """
    alphabet = book.alphabet
    done = book.established
    while waiting := [n for n in alphabet.inverse if n not in done]:
        before, reason = len(done), UnprovedError("an inverse")
        # what has an inverse by hypothesis helps to show that others have one
        for number in sorted(
            waiting, key=lambda n: (n in alphabet.elements, n not in book.invertible)
        ):
            _add_pending(book)
            try:
                _establish_one(book, number, definite, candidates, eager)
            except UnprovedError as error:
                reason = error  # perhaps later, when others are established
                speak_of_factors(book, number)
                speak_of_definite(book, number, definite)
            else:
                done.add(number)
        if len(done) == before and len(waiting) == len(alphabet.inverse) - len(done):
            raise reason
    _add_pending(book)
    while book.waiting:
        _gap_of_transposes(book, *book.waiting.pop())


def _establish_one(
    book: Book, number: int, definite: Definite, candidates: Sequence[Polynomial], eager: bool
) -> None:
    alphabet = book.alphabet
    was_given = number in book.invertible
    if not was_given:
        evidence = _why_invertible(book, number, definite, candidates, eager)
        name = alphabet.names[number]
        book.invertible[number] = f"{name}_is_invertible"
        book.state("matrix_invertible", {"matrix": name}, evidence, book.invertible[number])
        if "left_inverse" in evidence and number not in alphabet.elements:
            add_inverse(book, number, evidence["left_inverse"], evidence["cofactors"])
    make_symmetric(book, number)
    if was_given and number in alphabet.elements:
        with suppress(UnprovedError):
            definite(book, number)
    state_symmetric_inverse(book, number)
    inverse_equations(book, number)
    state_definite_inverse(book, number)


def _add_pending(book: Book) -> None:
    """Equations supposed, as soon as the inverses in them are known to be symmetric."""
    for source in list(book.pending):
        try:
            add_equation(book, book.equation(source))
        except UnprovedError:
            continue
        book.pending.remove(source)


def _why_invertible(
    book: Book, number: int, definite: Definite, candidates: Sequence[Polynomial], eager: bool
) -> dict[str, Any]:
    if eager:
        try:
            return _left_inverse(book, number, candidates)
        except UnprovedError:
            pass
    try:
        return {"because": definite(book, number)}
    except UnprovedError:
        return _left_inverse(book, number, candidates)


def _left_inverse(book: Book, number: int, candidates: Sequence[Polynomial]) -> dict[str, Any]:
    alphabet = book.alphabet
    value = alphabet.elements.get(number)
    if value is not None and len(value.terms) == 1:
        ((word, factor),) = value.terms.items()
        if all(each // 2 in book.invertible or each // 2 in alphabet.base for each in word):
            total = alphabet.unit(value.shape[0]).times(reciprocal(factor))
            for each in reversed(word):
                other = alphabet.letter(alphabet.inverse_of(each // 2))
                total = total @ (other.T if each % 2 else other)
            candidates = [total, *candidates]
    made = (*inverses_by_products(book, number), *turned_inverses(book, number))
    for left in (*candidates, *made):
        if left.shape != alphabet.shapes[number] or number in _bases(book, left):
            continue
        rest = alphabet.unit(left.shape[0]) - left @ alphabet.letter(number)
        try:
            return {"left_inverse": left, "cofactors": book.vanishing(rest)}
        except UnprovedError:
            continue
    raise UnprovedError(f"that {shown(book, number)} has an inverse")


def _bases(book: Book, value: Polynomial) -> set[int]:
    return {book.alphabet.base.get(each // 2, -1) for word in value.terms for each in word}


def shown(book: Book, number: int) -> str:
    """A letter in words, or what it is short for."""
    value = book.alphabet.elements.get(number)
    if value is None:
        return book.alphabet.names[number]
    terms = list(value.terms.items())
    words = "".join(_term(" ".join(book.text(word)), factor) for word, factor in terms[:3])
    more = f" + {len(terms) - 3} more terms" if len(terms) > 3 else ""
    return words.removeprefix(" + ").removeprefix(" ") + more


def _term(word: str, factor: Number) -> str:
    """With its sign before it."""
    size = abs(factor)
    number = "" if size == 1 and word else f"{size} " if word else str(size)
    return f" {'-' if factor < 0 else '+'} {number}{word}"


def _gap_of_transposes(book: Book, number: int, source: tuple[object, ...]) -> None:
    """The letter is symmetric by hypothesis: so is what it is short for."""
    alphabet = book.alphabet
    value = alphabet.elements[number]
    shape = value.shape
    one, two = alphabet.unit(shape[0]), alphabet.unit(shape[1])
    given = Cofactor(source, False, one, two)  # letter' - letter
    element = Cofactor(("element", number), False, one, two)  # letter - value
    proof = (given, element, element.transposed().negative())
    equation = Equation(value.T - value, lambda: proof)
    add_equation(book, book.normal(equation))
