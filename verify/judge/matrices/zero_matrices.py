"""Matrices that are zero since a square of them is, where equations alone do not show it."""

from __future__ import annotations

from typing import Any

from gainproof.verify.judge.matrices.division import quotient
from gainproof.verify.judge.matrices.equation import Cofactor, Known
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError

FEW_PRODUCTS = 300


def by_definite(book: Book, residual: Polynomial) -> dict[str, Any] | None:
    """N = 0 since N' D N = 0 or N D N' = 0 for a D that is positive definite; or since N or N' is
    D K with K' D K = 0 for a D that is positive semidefinite.
    """
    for side, factor in (("left", residual), ("right", residual.T)):
        rows = factor.shape[0]
        for known in (*book.known, Known(("unit", rows), book.alphabet.unit(rows), True)):
            if known.value.shape[0] != rows:
                continue
            try:
                evidence = _by_one(book, factor, known)
            except (UnprovedError, TooLongError):
                continue
            if evidence is not None:
                return {**evidence, "definite": known.reference, "side": side}
    return None


def _by_one(book: Book, factor: Polynomial, known: Known) -> dict[str, Any] | None:
    """Raises UnprovedError, TooLongError."""
    if known.strict:
        return {"cofactors": _square(book, known.value, factor)}
    inner = quotient(book.alphabet, book.alphabet.reduced(factor), known.value)
    if inner is None:
        return None
    rest = book.vanishing(factor - known.value @ inner, most=0)
    return {"factor": inner, "rest": rest, "cofactors": _square(book, known.value, inner)}


def _square(book: Book, middle: Polynomial, factor: Polynomial) -> list[Cofactor]:
    return book.vanishing(factor.T @ middle @ factor, most=FEW_PRODUCTS)
