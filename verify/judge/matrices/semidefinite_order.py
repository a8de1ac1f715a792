"""Orders of matrices as sums of squares F' D F with D known to be positive (semi)definite."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.matrices.completed_squares import FEW_HINTS, of_completed, of_subtracted
from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.full_rank import full_rank
from gainproof.verify.judge.matrices.gram_squares import decomposed, signed_squares
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import (
    PRIME,
    Polynomial,
    TooLongError,
    modulo,
    reciprocal,
)
from gainproof.verify.judge.matrices.size import Shape
from gainproof.verify.judge.matrices.squares import (
    Square,
    by_equations,
    by_words,
    candidates,
    expanded,
    of_inverses,
    units,
)

MOST_CANDIDATES = 60
MOST_SEARCHED = 12
MOST_PRODUCTS = 500
"""Fewer than for an equation, as there are many attempts."""
Asked = tuple[Shape, object]
"""A matrix: its shape and the key of its polynomial."""
SALT = 7919


def state_order(
    book: Book, value: Polynomial, *, strict: bool, asked: frozenset[Asked] = frozenset()
) -> Known:
    """State that a matrix is positive (semi)definite, and remember it. Raises UnprovedError."""
    return state_shown(book, value, strict, prove_order(book, value, strict, asked))


def state_shown(book: Book, value: Polynomial, strict: bool, evidence: dict[str, Any]) -> Known:
    """State it by this evidence."""
    sides = {"larger": book.graph(value), "smaller": book.graph(value - value)}
    name = book.state("matrix_order", {**sides, "relation": ">" if strict else ">="}, evidence)
    known = Known(("statement", name), value, strict)
    book.known.append(known)
    return known


def prove_order(
    book: Book, difference: Polynomial, strict: bool, asked: frozenset[Asked] = frozenset()
) -> dict[str, Any]:
    """Evidence that a matrix is positive (semi)definite; `asked` are matrices of which that is
    being looked for already, which helps with none of them. Raises UnprovedError.
    """
    value = book.alphabet.reduced(book.without_elements(difference)[0])
    size, value = value.content, value.primitive
    for found in _attempts(book, value, asked | {(value.shape, value.key)}):
        squares = [replace(square, weight=square.weight * size) for square in found]
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
                factors = [
                    (n, _positive(book, s.factor)) for n, s in enumerate(squares) if s.known.strict
                ]
                evidence["rank"] = full_rank(book, factors, difference.shape[0], MOST_PRODUCTS)
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


def _attempts(book: Book, value: Polynomial, asked: frozenset[Asked]) -> Iterator[list[Square]]:
    """Lists of squares whose sum may be the value."""
    known = [*book.known, *units(book, value)]
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
                own = expanded(book, square)
                if own is not None and own.key == value.key:
                    yield [square]
    for some in (known, *([one] for one in known)):
        yield from _of_gram(book, value, some)
    signed = signed_squares(book, value, known)
    if signed:
        yield [Square(factor, one) for factor, one in signed]
    likely = list(candidates(book, value, known))[:MOST_CANDIDATES]
    by_key = [(s, expanded(book, s)) for s in likely]
    found = [(s, v) for s, v in by_key if v is not None and v.terms]
    found += list(by_equations(book, [s for s, _ in found]))
    found = [_primitive(square, own) for square, own in found]
    for group in groups_with_sum(value, [own for _, own in found]):
        yield [found[at][0] for at in group]
    for square, own in found[:MOST_SEARCHED]:
        if set(own.terms) & set(value.terms):
            yield [square]
    yield from of_inverses(book, known)
    yield from of_subtracted(book, value, known)
    yield from of_completed(book, value, known)
    yield from _of_hints(book, known)
    yield from _of_bases(book, value, known, asked)
    for other in by_words(book, value):
        yield from _of_gram(book, other, known)


def _of_hints(book: Book, known: Sequence[Known]) -> Iterator[list[Square]]:
    """H' W H with W the inverse of an element and H a letter: they share no word with the value."""
    alphabet = book.alphabet
    for one in known:
        words = list(one.value.terms)
        if len(words) == 1 and len(words[0]) == 1:
            base = alphabet.base.get(words[0][0] // 2)
            if base in alphabet.elements:
                hints = [h for h in (*book.hints, *(h.T for h in book.hints)) if h.terms]
                fitting = [h for h in hints if h.shape[0] == one.value.shape[0]]
                yield from ([Square(hint, one)] for hint in fitting[:FEW_HINTS])


def _of_gram(book: Book, value: Polynomial, known: Sequence[Known]) -> Iterator[list[Square]]:
    gram = decomposed(book, value, known)
    if gram is not None:
        yield [Square(factor, one, weight) for factor, one, weight in gram]


def _primitive(square: Square, value: Polynomial) -> tuple[Square, Polynomial]:
    """The square with a weight that makes its coefficients whole and without a common divisor, as
    those of what is looked for.
    """
    weight = square.weight * reciprocal(value.content)
    return replace(square, weight=weight), value.primitive


def _of_bases(
    book: Book, value: Polynomial, known: Sequence[Known], asked: frozenset[Asked]
) -> Iterator[list[Square]]:
    """Y2 - Y1 = Y1 G Y1 + Y1 G Y2 G Y1, from the value: Y1 and Y2 are multiples of letters or of
    a unit matrix, X1 and X2 their inverses, G = X1 - X2, which is shown to be at least 0. Of G the
    same may be asked, whose answer often is the value: it ends as there are finitely many pairs of
    letters, none of which is asked about on the way to itself.
    """
    alphabet = book.alphabet
    terms = sorted(value.terms.items(), key=lambda term: term[1])
    if len(terms) != 2 or not terms[0][1] < 0 < terms[1][1]:
        return
    bases: list[Polynomial] = []
    for word, factor in terms:
        if not word:
            own = alphabet.unit(value.shape[0])
        elif len(word) == 1 and word[0] // 2 in {**alphabet.base, **alphabet.inverse}:
            number = word[0] // 2
            base = alphabet.base.get(number, alphabet.inverse.get(number, number))
            own = alphabet.elements.get(base, alphabet.letter(base))
        else:
            return
        bases.append(own.times(reciprocal(factor if factor > 0 else -factor)))
    first = Polynomial({terms[0][0]: -terms[0][1]}, value.shape)
    second = Polynomial({terms[1][0]: 1}, value.shape)
    same = [k for k in known if k.strict and k.value.shape == second.shape]
    last = next((k for k in same if k.value.key == second.key), None)
    whole = alphabet.reduced(bases[0] - bases[1])
    gap = whole.primitive
    if last is None or not gap.terms or (gap.shape, gap.key) in asked:
        return
    for strict in (True, False):
        try:
            shown = state_order(book, gap, strict=strict, asked=asked)
        except (UnprovedError, TooLongError):
            continue
        again = Square(alphabet.reduced(whole @ first), last, terms[1][1])
        yield [Square(first, shown, whole.content), again]
        return


def groups_with_sum(value: Polynomial, parts: Sequence[Polynomial]) -> Iterator[tuple[int, ...]]:
    """Places of one, of two and of three of the parts whose sum is the value.

    A fingerprint is the same sum with numbers in the place of words, so that only groups with that
    of the value, and by chance very few others, are added up.
    """
    prints = [fingerprint(part) for part in parts]
    places: dict[int, list[int]] = {}
    for at, own in enumerate(prints):
        places.setdefault(own, []).append(at)
    goal = fingerprint(value)
    for group in _groups(goal, prints, places):
        total = value
        for at in group:
            total = total - parts[at]
        if not total.terms:
            yield group


def _groups(
    goal: int, prints: Sequence[int], places: dict[int, list[int]]
) -> Iterator[tuple[int, ...]]:
    yield from ((at,) for at in places.get(goal, ()))
    for one, own in enumerate(prints):
        rest = (goal - own) % PRIME
        yield from ((one, at) for at in places.get(rest, ()) if at > one)
    for one, own in enumerate(prints):
        for two in range(one + 1, len(prints)):
            rest = (goal - own - prints[two]) % PRIME
            yield from ((one, two, at) for at in places.get(rest, ()) if at > two)


def fingerprint(value: Polynomial) -> int:
    """The polynomial with a number for each word, modulo a prime; additive."""
    return sum(modulo(c) * hash((SALT, *word)) for word, c in value.terms.items()) % PRIME
