"""Inverses that follow from products of square matrices.

From L V = 1 follows that V has an inverse W, and L = L V W = W, so that V L = 1 too. If a product
of square matrices has an inverse Y, all its factors have: from Y U V = 1 the last one, and with
W = Y U then V Y U = V W = 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gainproof.verify.judge.matrices.equation import Cofactor, Equation
from gainproof.verify.judge.matrices.hypotheses import add_equation
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Polynomial


def suppose_product(book: Book, first: Polynomial, last: Polynomial) -> None:
    """A hypothesis: first last = 1, both square. What is one letter may have the other for its
    inverse.
    """
    for own, other in ((last, first), (first, last)):
        number = _one_letter(book, own)
        if number is not None and other.shape == own.shape and other.terms:
            book.alphabet.inverse_of(number)
            book.products.append((number, other))


def _one_letter(book: Book, value: Polynomial) -> int | None:
    """The free letter that a polynomial is."""
    alphabet = book.alphabet
    if len(value.terms) != 1 or value.shape[0] != value.shape[1]:
        return None
    ((word, factor),) = value.terms.items()
    if len(word) != 1 or factor != 1 or word[0] % 2 or word[0] // 2 in alphabet.base:
        return None
    return word[0] // 2


def inverses_by_products(book: Book, number: int) -> Iterator[Polynomial]:
    """Candidates for the inverse of a letter: what stands beside it in a product that is 1, or
    v Y u where Y is the inverse of u V v, transposed where V is.
    """
    alphabet = book.alphabet
    yield from (other for own, other in book.products if own == number)
    shape = alphabet.shapes[number]
    for base, inverse in list(alphabet.inverse.items()):
        meaning = alphabet.elements.get(base)
        if base not in book.invertible or meaning is None or len(meaning.terms) != 1:
            continue
        ((word, factor),) = meaning.terms.items()
        for at, letter in enumerate(word):
            if letter // 2 == number and meaning.shape == shape and abs(factor) == 1:
                total = (*word[at + 1 :], 2 * inverse, *word[:at])
                found = Polynomial({total: factor}, shape)
                yield alphabet.reduced(found.T if letter % 2 else found)


def speak_of_factors(book: Book, number: int) -> None:
    """Ask for the inverses of the letters of a product of square matrices, and of those beside a
    letter in one that has an inverse.
    """
    alphabet = book.alphabet
    for base, meaning in list(alphabet.elements.items()):
        if len(meaning.terms) != 1 or (base != number and base not in book.invertible):
            continue
        ((word, _),) = meaning.terms.items()
        letters = {letter // 2 for letter in word}
        if (base == number or number in letters) and all(
            alphabet.shapes[letter] == meaning.shape for letter in letters
        ):
            for letter in sorted(letters):
                alphabet.inverse_of(letter)


def add_inverse(book: Book, number: int, left: Polynomial, cofactors: Sequence[Cofactor]) -> None:
    """L = W for the inverse W of a letter V, by cofactors of 1 - L V."""
    alphabet = book.alphabet
    inverse = alphabet.letter(alphabet.inverse[number])
    unit = alphabet.unit(inverse.shape[0])
    # L - W = -L (V W - 1) - (1 - L V) W
    proof = (
        Cofactor(("inverse", number, "right"), False, -left, unit),
        *(c.inside(unit, inverse).negative() for c in cofactors),
    )
    add_equation(book, book.normal(Equation(left - inverse, lambda: proof)))
