"""Words of matrices as the search has them: letters are numbers, odd ones transposes.

The search proposes; what it finds is checked by `gainproof.verify.certificate.matrix_words`, which
has polynomials of its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm
from typing import TypeAlias

from gainproof.verify.judge.matrices.size import Shape

Word = tuple[int, ...]
Number: TypeAlias = int | Fraction
"""Whole numbers stay such: with fractions the search takes three times as long."""
MOST_TERMS = 1500
MOST_LETTERS = 44
PRIME = 2**61 - 1


class TooLongError(ValueError):
    """More terms or longer words than are looked at."""


@dataclass(frozen=True)
class Polynomial:
    """Words with coefficients that are not 0, all of one shape."""

    terms: Mapping[Word, Number]
    shape: Shape

    def __add__(self, other: Polynomial) -> Polynomial:
        terms = dict(self.terms)
        for word, value in other.terms.items():
            total = terms.pop(word, 0) + value
            if total:
                terms[word] = total
        return Polynomial(terms, self.shape)

    def __neg__(self) -> Polynomial:
        return self.times(-1)

    def __sub__(self, other: Polynomial) -> Polynomial:
        terms = dict(self.terms)
        for word, value in other.terms.items():
            total = terms.pop(word, 0) - value
            if total:
                terms[word] = total
        return Polynomial(terms, self.shape)

    def times(self, factor: Number) -> Polynomial:
        """A number times the polynomial."""
        terms = {word: factor * value for word, value in self.terms.items() if factor}
        return Polynomial(terms, self.shape)

    def __matmul__(self, other: Polynomial) -> Polynomial:
        terms: dict[Word, Number] = {}
        for word, value in self.terms.items():
            for after, factor in other.terms.items():
                key = word + after
                total = terms.pop(key, 0) + value * factor
                if total:
                    terms[key] = total
                if len(terms) > MOST_TERMS or len(key) > MOST_LETTERS:
                    raise TooLongError("the formula multiplied out is too long")
        return Polynomial(terms, (self.shape[0], other.shape[1]))

    @property
    def T(self) -> Polynomial:
        """The transpose."""
        return Polynomial(
            {turned(word): value for word, value in self.terms.items()},
            (self.shape[1], self.shape[0]),
        )

    @property
    def content(self) -> Number:
        """The largest number > 0 of which all coefficients are whole multiples; 1 if all are 0."""
        values = [Fraction(value) for value in self.terms.values()] or [Fraction(1)]
        top = gcd(*(value.numerator for value in values))
        return reciprocal(Fraction(lcm(*(value.denominator for value in values)), top))

    @property
    def primitive(self) -> Polynomial:
        """The polynomial over its content."""
        return self.times(reciprocal(self.content))

    @property
    def key(self) -> frozenset[tuple[Word, Number]]:
        """Equal for equal terms."""
        return frozenset(self.terms.items())


def turned(word: Word) -> Word:
    """The transpose of a word."""
    return tuple(letter ^ 1 for letter in reversed(word))


def reciprocal(value: Number) -> Number:
    """One over a number that is not 0."""
    found = 1 / Fraction(value)
    return found.numerator if found.denominator == 1 else found


def modulo(value: Number) -> int:
    """The number modulo the prime."""
    if value.denominator == 1:
        return value.numerator % PRIME
    return value.numerator * pow(value.denominator, -1, PRIME) % PRIME
