"""That a letter is positive definite, which gives it an inverse."""

from __future__ import annotations

from gainproof.verify.judge.matrices.book import Book
from gainproof.verify.judge.matrices.macaulay import UnprovedError
from gainproof.verify.judge.matrices.order import prove_order, state_order, state_shown


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
        return state_order(book, letter, strict=False).reference
    return state_shown(book, letter, True, evidence).reference
