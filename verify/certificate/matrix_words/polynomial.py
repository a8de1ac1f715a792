"""Noncommutative polynomials: words in matrices and their transposes, of one shape.

A word is a tuple of letters, 2 n for the matrix of number n and 2 n + 1 for its transpose; the
empty word is the unit matrix. A term is a coefficient times powers of the parameters, which are
numbers and commute with everything, times a word. Matrices are real, of every size that the names
of their shapes may stand for: two polynomials with the same terms are equal for all of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from operator import add
from typing import TypeAlias

from gainproof.verify.certificate.rejection import (
    MAXIMUM_COEFFICIENT_BITS,
    MAXIMUM_POWER,
    Meter,
    RejectedError,
)

MAXIMUM_WORD = 48
MAXIMUM_WORD_TERMS = 4_000

# What a term costs, in letters, before its word is looked at, and how many bits cost one letter.
_TERM = 4
_BITS = 64

Word: TypeAlias = tuple[int, ...]
Powers: TypeAlias = tuple[int, ...]
Terms: TypeAlias = Mapping[tuple[Powers, Word], Fraction]
Shape: TypeAlias = tuple[str, str]


@dataclass(frozen=True, slots=True)
class Polynomial:
    """Terms without zero coefficients. `shape`: the names of rows and columns, None for a number
    that stands before matrices.
    """

    terms: Terms
    shape: Shape | None

    def effort(self) -> int:
        """What it costs to write every term once, in the units of the meter."""
        return sum(
            _TERM + len(powers) + len(word) + _bits(coefficient) // _BITS
            for (powers, word), coefficient in self.terms.items()
        )

    def plus(self, other: Polynomial, meter: Meter, place: str) -> Polynomial:
        """The sum. Raises RejectedError unless both have one shape."""
        if self.shape != other.shape:
            raise RejectedError(f"{place}: {_said(self)} and {_said(other)} are added")
        meter.spend(len(self.terms) + other.effort())
        terms = dict(self.terms)
        for key, coefficient in other.terms.items():
            _add(terms, key, coefficient, meter, place)
        return Polynomial(_few(terms, place), self.shape)

    def minus(self, other: Polynomial, meter: Meter, place: str) -> Polynomial:
        """The difference. Raises RejectedError unless both have one shape."""
        return self.plus(other.negative(meter), meter, place)

    def times(self, other: Polynomial, meter: Meter, place: str) -> Polynomial:
        """The product. Raises RejectedError unless the shapes fit, or if it grows too long: before
        any term is formed if words do or the effort is too much, row by row if terms do.
        """
        shape = self.shape or other.shape
        if self.shape is not None and other.shape is not None:
            if self.shape[1] != other.shape[0]:
                raise RejectedError(f"{place}: {_said(self)} is multiplied by {_said(other)}")
            shape = (self.shape[0], other.shape[1])
        if _longest(self) + _longest(other) > MAXIMUM_WORD:
            raise RejectedError(f"{place}: a word of more than {MAXIMUM_WORD} letters")
        rows, columns = len(self.terms), len(other.terms)
        meter.spend(rows + columns + columns * self.effort() + rows * other.effort())
        terms: dict[tuple[Powers, Word], Fraction] = {}
        for (powers, word), coefficient in self.terms.items():
            for (more, after), factor in other.terms.items():
                key = (_sum(powers, more, place), word + after)
                _add(terms, key, coefficient * factor, meter, place)
            _few(terms, place)
        return Polynomial(terms, shape)

    def negative(self, meter: Meter) -> Polynomial:
        """Minus the polynomial."""
        meter.spend(self.effort())
        return Polynomial({key: -value for key, value in self.terms.items()}, self.shape)

    def transposed(self, meter: Meter) -> Polynomial:
        """The transpose: words backwards, each letter transposed. (A B)' = B' A'."""
        meter.spend(self.effort())
        terms = {
            (powers, tuple(letter ^ 1 for letter in reversed(word))): value
            for (powers, word), value in self.terms.items()
        }
        return Polynomial(terms, None if self.shape is None else (self.shape[1], self.shape[0]))

    def letters(self) -> set[int]:
        """The numbers of the matrices that occur."""
        return {letter // 2 for _, word in self.terms for letter in word}


def _sum(powers: Powers, more: Powers, place: str) -> Powers:
    total = tuple(map(add, powers, more))
    if total and max(map(abs, total)) > MAXIMUM_POWER:
        raise RejectedError(f"{place}: a power beyond {MAXIMUM_POWER}")
    return total


def _add(
    terms: dict[tuple[Powers, Word], Fraction],
    key: tuple[Powers, Word],
    value: Fraction,
    meter: Meter,
    place: str,
) -> None:
    before = terms.pop(key, None)
    if before is not None:
        # what has gathered may have far more digits than what is added
        meter.spend(_bits(before) // _BITS)
        value += before
    if value:
        terms[key] = _short(value, place)


def _bits(value: Fraction) -> int:
    return value.numerator.bit_length() + value.denominator.bit_length()


def _longest(value: Polynomial) -> int:
    return max((len(word) for _, word in value.terms), default=0)


def _short(value: Fraction, place: str) -> Fraction:
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > MAXIMUM_COEFFICIENT_BITS:
        raise RejectedError(f"{place}: a coefficient of too many digits")
    return value


def _few(
    terms: dict[tuple[Powers, Word], Fraction], place: str
) -> dict[tuple[Powers, Word], Fraction]:
    if len(terms) > MAXIMUM_WORD_TERMS:
        raise RejectedError(f"{place}: more than {MAXIMUM_WORD_TERMS} terms")
    return terms


def _said(value: Polynomial) -> str:
    return "a number" if value.shape is None else "a matrix {} by {}".format(*value.shape)
