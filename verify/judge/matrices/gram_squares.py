"""Squares read off the words of a polynomial that are their own transposes."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import (
    Number,
    Polynomial,
    TooLongError,
    Word,
    reciprocal,
    turned,
)

Basis = tuple[Known, Word]


def decomposed(
    book: Book, value: Polynomial, known: Sequence[Known]
) -> list[tuple[Polynomial, Known, Number]] | None:
    """The value as a sum of weight F' D F, each D a letter or a unit matrix: the words y' D y
    give the vectors y, all others the rest of a matrix of numbers that must be positive.
    """
    basis = _basis(book, value, known)
    places: dict[Word, tuple[int, int]] = {}
    for i, (one, left) in enumerate(basis):
        for j, (other, right) in enumerate(basis):
            if one is other:
                middle = next(iter(one.value.terms))
                word = book.alphabet.normal((*turned(left), *middle, *right))
                if word is not None:
                    places.setdefault(word, (i, j))
    gram: list[list[Number]] = [[0] * len(basis) for _ in basis]
    for word, factor in value.terms.items():
        if word not in places:
            return None
        i, j = places[word]
        if i != j and book.alphabet.normal(turned(word)) == word:
            # that of y' D z and of its transpose z' D y
            gram[i][j] = gram[j][i] = factor * reciprocal(2)
        else:
            gram[i][j] = factor
    rows = _factored(gram)
    if rows is None:
        return None
    found = []
    for weight, row in rows:
        at = next(i for i, c in enumerate(row) if c)
        one = basis[at][0]
        size = one.value.shape[0]
        terms = {basis[i][1]: c for i, c in enumerate(row) if c}
        found.append((Polynomial(terms, (size, value.shape[1])), one, weight))
    return found


def _basis(book: Book, value: Polynomial, known: Sequence[Known]) -> list[Basis]:
    basis: list[Basis] = []
    for word in value.terms:
        split = _split(book, word, value, known)
        if split is not None and all(split[0] is not k or split[1] != y for k, y in basis):
            basis.append(split)
    return basis


def _split(book: Book, word: Word, value: Polynomial, known: Sequence[Known]) -> Basis | None:
    """D and y of a word y' D y."""
    if book.alphabet.normal(turned(word)) != word:
        return None
    half, odd = divmod(len(word), 2)
    behind = word[half + odd :]
    size = book.alphabet.shapes[behind[0] // 2][behind[0] % 2] if behind else value.shape[1]
    for one in known:
        middle = next(iter(one.value.terms)) if len(one.value.terms) == 1 else None
        if middle == (word[half : half + 1] if odd else ()) and one.value.shape[0] == size:
            return one, behind
    # a word that is an inverse of what is definite: y = y' D y
    for one in known:
        middle = next(iter(one.value.terms)) if len(one.value.terms) == 1 else None
        if middle and book.alphabet.normal((*turned(word), *middle, *word)) == word:
            return one, word
    return None


def _factored(gram: list[list[Number]]) -> list[tuple[Number, list[Number]]] | None:
    """A symmetric matrix of numbers as a sum of weight * row' row with weights > 0, or None."""
    size = len(gram)
    rest = [list(row) for row in gram]
    if any(rest[i][j] != rest[j][i] for i in range(size) for j in range(i)):
        return None
    found = []
    for i in range(size):
        weight = rest[i][i]
        if weight < 0 or (weight == 0 and any(rest[i])):
            return None
        if weight == 0:
            continue
        row = [entry * reciprocal(weight) for entry in rest[i]]
        found.append((weight, row))
        for j in range(size):
            for k in range(size):
                rest[j][k] -= weight * row[j] * row[k]
    return found


def signed_squares(
    book: Book, value: Polynomial, known: Sequence[Known]
) -> list[tuple[Polynomial, Known]]:
    """One square for each D: F is the sum of y over words y' D y, and of C Z y over words y' Z y
    where Z is the inverse of C' D C; with a minus for words with a minus. Schur complements and
    differences of inverses of blocks are such squares.
    """
    letters = [k for k in known if len(k.value.terms) == 1]
    compressed = _compressed(book, letters)
    total: dict[int, tuple[Known, Polynomial]] = {}
    for word, factor in value.terms.items():
        split = _split(book, word, value, letters)
        if split is None or abs(factor) != 1:
            continue
        one, behind = split
        size = one.value.shape[0]
        own = Polynomial({behind: factor}, (size, value.shape[1]))
        middle = next(iter(one.value.terms))
        if middle and middle[0] in compressed:
            one, column = compressed[middle[0]]
            own = column @ Polynomial({middle: 1}, (size, size)) @ own
        elif middle and middle[0] // 2 in book.alphabet.base:
            # Y = Y D Y for the inverse of D
            base = (2 * book.alphabet.base[middle[0] // 2],)
            whole = next((k for k in letters if base in k.value.terms), None)
            if whole is not None:
                one, own = whole, Polynomial({middle: 1}, (size, size)) @ own
        elif not middle and behind and behind[0] % 2 and behind[0] // 2 in book.alphabet.place:
            rows = book.alphabet.shapes[behind[0] // 2][0]
            one = next(k for k in letters if k.reference == ("unit", rows))
            own = book.alphabet.letter(behind[0] // 2) @ own
        before = total.get(id(one), (one, Polynomial({}, (one.value.shape[0], value.shape[1]))))
        total[id(one)] = (one, before[1] + own)
    squares = [(book.alphabet.reduced(f), one) for one, f in total.values()]
    return [(f, one) for f, one in squares if f.terms]


def _compressed(book: Book, known: Sequence[Known]) -> dict[int, tuple[Known, Polynomial]]:
    """For inverse letters Z of an element C' D C: D and C."""
    alphabet = book.alphabet
    found: dict[int, tuple[Known, Polynomial]] = {}
    for base, inverse in alphabet.inverse.items():
        meaning = alphabet.elements.get(base)
        if meaning is None:
            continue
        free = [k for k in known if 2 * inverse not in next(iter(k.value.terms))]
        try:
            squares = decomposed(book, meaning, free)
        except TooLongError:
            continue
        if squares is not None and len(squares) == 1 and squares[0][2] == 1:
            found[2 * inverse] = (squares[0][1], squares[0][0])
    return found
