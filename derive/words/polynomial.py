"""Sums of words in noncommuting letters, with rational coefficients and powers of parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from operator import add

Letter = tuple[str, bool]
"""A matrix by its name, and whether it is transposed."""
Word = tuple[Letter, ...]
Powers = tuple[int, ...]
Key = tuple[Word, Powers]
Term = tuple[Powers, Fraction]
Shape = tuple[str, str]


class ShapeError(ValueError):
    """Matrices whose shapes do not fit are added or multiplied."""


@dataclass(frozen=True)
class Polynomial:
    """Coefficients by word and powers; `shape`: rows and columns, None for a number."""

    terms: Mapping[Key, Fraction]
    shape: Shape | None

    def __add__(self, other: Polynomial) -> Polynomial:
        if self.shape != other.shape:
            raise ShapeError(f"{self.shape} and {other.shape} are added")
        terms = dict(self.terms)
        for key, value in other.terms.items():
            terms[key] = terms.get(key, Fraction(0)) + value
        return Polynomial({key: value for key, value in terms.items() if value}, self.shape)

    def __neg__(self) -> Polynomial:
        return Polynomial({key: -value for key, value in self.terms.items()}, self.shape)

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def __matmul__(self, other: Polynomial) -> Polynomial:
        shape = self.shape or other.shape
        if self.shape and other.shape:
            if self.shape[1] != other.shape[0]:
                raise ShapeError(f"{self.shape} is multiplied by {other.shape}")
            shape = (self.shape[0], other.shape[1])
        terms: dict[Key, Fraction] = {}
        for (word, powers), value in self.terms.items():
            for (after, more), factor in other.terms.items():
                key = (word + after, tuple(map(add, powers, more)))
                terms[key] = terms.get(key, Fraction(0)) + value * factor
        return Polynomial({key: value for key, value in terms.items() if value}, shape)

    def between(self, before: Word, after: Word, shape: Shape, by: Term) -> Polynomial:
        """before * self * after, times a number and powers of parameters; it has this shape."""
        powers, coefficient = by
        terms = {
            (before + word + after, tuple(map(add, powers, more))): value * coefficient
            for (word, more), value in self.terms.items()
        }
        return Polynomial(terms, shape)

    @property
    def T(self) -> Polynomial:
        """The transpose."""
        terms = {(transposed(word), powers): value for (word, powers), value in self.terms.items()}
        return Polynomial(terms, self.shape and (self.shape[1], self.shape[0]))

    def data(self) -> list[list[object]]:
        """As certificates have it: ascending by letters, then powers."""
        listed = sorted(
            ([letter_text(letter) for letter in word], list(powers), str(value))
            for (word, powers), value in self.terms.items()
        )
        return [[value, powers, word] for word, powers, value in listed]

    def split(self) -> Iterator[tuple[Key, Fraction]]:
        """The terms one by one."""
        return iter(self.terms.items())


def transposed(word: Word) -> Word:
    """The word backwards, each letter transposed."""
    return tuple((name, not flag) for name, flag in reversed(word))


def letter_text(letter: Letter) -> str:
    """A name, with ' behind it for the transpose."""
    return letter[0] + "'" * letter[1]
