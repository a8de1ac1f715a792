"""Division of a polynomial by another: P with E = N P."""

from __future__ import annotations

from gainproof.verify.judge.matrices.polynomial import (
    Polynomial,
    TooLongError,
    Word,
    reciprocal,
)
from gainproof.verify.judge.matrices.statement_letters import Alphabet

MOST_TERMS = 20
"""Of a quotient."""


def quotient(alphabet: Alphabet, value: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """P with value = divisor P, all in normal form; None where none is found, or it is a number."""
    if value.shape[0] != divisor.shape[0] or not value.terms or not divisor.terms:
        return None
    first = max(divisor.terms, key=_order)
    found = Polynomial({}, (divisor.shape[1], value.shape[1]))
    rest = value
    for _ in range(MOST_TERMS):
        if not rest.terms:
            return found if any(found.terms) else None
        word = max(rest.terms, key=_order)
        if word[: len(first)] != first:
            return None
        factor = rest.terms[word] * reciprocal(divisor.terms[first])
        term = Polynomial({word[len(first) :]: factor}, found.shape)
        try:
            less = alphabet.reduced(rest - divisor @ term)
        except TooLongError:
            return None
        if word in less.terms:
            return None
        found, rest = found + term, less
    return None


def _order(word: Word) -> tuple[int, Word]:
    return len(word), word
