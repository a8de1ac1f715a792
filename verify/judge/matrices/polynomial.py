"""Words of matrices as the search has them: letters are numbers, odd ones transposes.

The search proposes; what it finds is checked by `gainproof.verify.certificate.words`, which has
polynomials of its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.matrices.size import Shape

Word = tuple[int, ...]
MOST_TERMS = 1500
MOST_LETTERS = 44


class TooLongError(ValueError):
    """More terms or longer words than are looked at."""


@dataclass(frozen=True)
class Polynomial:
    """Words with coefficients that are not 0, all of one shape."""

    terms: Mapping[Word, Fraction]
    shape: Shape

    def __add__(self, other: Polynomial) -> Polynomial:
        terms = dict(self.terms)
        for word, value in other.terms.items():
            total = terms.pop(word, Fraction(0)) + value
            if total:
                terms[word] = total
        return Polynomial(terms, self.shape)

    def __neg__(self) -> Polynomial:
        return self.times(Fraction(-1))

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def times(self, factor: Fraction) -> Polynomial:
        """A number times the polynomial."""
        terms = {word: factor * value for word, value in self.terms.items() if factor}
        return Polynomial(terms, self.shape)

    def __matmul__(self, other: Polynomial) -> Polynomial:
        terms: dict[Word, Fraction] = {}
        for word, value in self.terms.items():
            for after, factor in other.terms.items():
                key = word + after
                total = terms.pop(key, Fraction(0)) + value * factor
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
    def key(self) -> frozenset[tuple[Word, Fraction]]:
        """Equal for equal terms."""
        return frozenset(self.terms.items())


def turned(word: Word) -> Word:
    """The transpose of a word."""
    return tuple(letter ^ 1 for letter in reversed(word))
