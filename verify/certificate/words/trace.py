"""Traces: words up to rotation and transposition, since tr(A B) = tr(B A) and tr(A') = tr(A)."""

from __future__ import annotations

from fractions import Fraction
from typing import TypeAlias

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.words.combination import combination
from gainproof.verify.certificate.words.polynomial import Polynomial, Powers, Word
from gainproof.verify.certificate.words.relations import Ground

Traces: TypeAlias = dict[tuple[Powers, Word, str], Fraction]


def add_trace(total: Traces, value: Polynomial, sign: int, ground: Ground, place: str) -> None:
    """Add the trace of a square matrix, or subtract it. That of a unit matrix is its size."""
    if value.shape is None or value.shape[0] != value.shape[1]:
        raise RejectedError(f"{place}: a square matrix is wanted")
    for (powers, word), coefficient in value.terms.items():
        ground.setting.meter.spend(2 * len(word) ** 2 + 1)
        key = (powers, _representative(word), "" if word else value.shape[0])
        rest = total.pop(key, Fraction(0)) + sign * coefficient
        if rest:
            total[key] = rest


def require_traces(
    left: Polynomial, right: Polynomial, value: Plain, ground: Ground, place: str
) -> None:
    """Reject unless the traces agree after equations are used, each in a square matrix:
    [{"size", "cofactors"}, ...].
    """
    total: Traces = {}
    add_trace(total, left, 1, ground, place)
    add_trace(total, right, -1, ground, place)
    for number, entry in enumerate(schema.items(value, place)):
        here = f"{place}[{number}]"
        fields = schema.record(entry, ("size", "cofactors"), here)
        size = schema.text(fields["size"], here)
        used = combination(fields["cofactors"], (size, size), ground, here)
        add_trace(total, used, -1, ground, here)
    if total:
        raise RejectedError(f"{place}: {len(total)} terms are left over")


def _representative(word: Word) -> Word:
    """The first of all rotations of the word and of its transpose."""
    if not word:
        return word
    other = tuple(letter ^ 1 for letter in reversed(word))
    return min(w[i:] + w[:i] for w in (word, other) for i in range(len(word)))
