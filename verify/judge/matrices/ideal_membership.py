"""Whether a polynomial is a sum of products with equations: linear algebra over words.

Starting from its words, every equation that has one of them inside a product gives such a product,
whose words are looked at in their turn; a few rounds of this, then one linear system. Nothing is
oriented, so nothing has to be completed, and nothing that is found is believed: the cofactors are
checked elsewhere. Numbers are taken modulo a prime and read back as fractions at the end.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeVar

from gainproof.verify.judge.matrices.polynomial import (
    MOST_LETTERS,
    PRIME,
    Number,
    Polynomial,
    Word,
    modulo,
)
from gainproof.verify.judge.matrices.statement_letters import Alphabet

MOST_PRODUCTS = 1200
MOST_ROUNDS = 7
EFFORT = 500
"""Steps for each product, on an average."""
CHARGE = 5
"""Steps for each letter that is written outside of searches."""
LARGEST = 10_000
"""Numerator and denominator of a coefficient that is read back."""

Product = tuple[Word, int, Word]
"""Left word, number of the equation, right word."""
Row = dict[Word, int]
_Key = TypeVar("_Key")


class UnprovedError(ValueError):
    """What the search does not prove."""


@dataclass
class Budget:
    """Steps of arithmetic that all searches for one claim may still take, those under conditions
    that it lacks and those for each premise counted apart; `limit` is that of each search. A
    million take about a second.
    """

    remaining: int = 5_000_000
    limit: int = 0

    def charge(self, work: int) -> None:
        """Count work outside of searches. Raises UnprovedError when nothing remains."""
        self.remaining -= CHARGE * work
        if self.remaining <= 0:
            raise UnprovedError("the search was given up")

    def begin(self, most: int) -> None:
        """Begin a search."""
        self.limit = max(0, self.remaining - most * EFFORT)

    def spend(self, work: int) -> bool:
        """Whether it may go on."""
        self.remaining -= work
        return self.remaining > self.limit


@dataclass
class _System:
    """Products in echelon form, each with how it is made of those that were put in."""

    rows: dict[Word, tuple[Row, dict[Product, int]]]
    budget: Budget

    def reduced(self, row: Row, made: dict[Product, int]) -> tuple[Row, dict[Product, int]]:
        """What is left of a row."""
        left: Row = {}
        row = dict(row)
        while row:
            word = max(row)
            value = row.pop(word)
            if word not in self.rows:
                left[word] = value
                continue
            other, how = self.rows[word]
            if not self.budget.spend(len(row) + len(other) + len(how)):
                return row, made
            for key, factor in other.items():
                if key != word:
                    _add(row, key, -value * factor)
            for product, factor in how.items():
                _add(made, product, -value * factor)
        return left, made

    def insert(self, row: Row, product: Product) -> None:
        """Put in a product."""
        left, made = self.reduced(row, {product: 1})
        if not left:
            return
        lead = max(left)
        scale = pow(left[lead], -1, PRIME)
        self.rows[lead] = (
            {word: value * scale % PRIME for word, value in left.items()},
            {key: value * scale % PRIME for key, value in made.items()},
        )


def products_for(
    residual: Polynomial,
    equations: Sequence[Polynomial],
    alphabet: Alphabet,
    most: int,
    budget: Budget,
) -> list[tuple[Number, Product]] | None:
    """Products of equations whose sum is the residual, in the normal form in which no last block
    meets its transpose. None if none are found among `most` products.
    """
    if not residual.terms:
        return []
    goal = {word: modulo(value) for word, value in residual.terms.items()}
    by_first: dict[int, list[tuple[Word, int]]] = {}
    for number, equation in enumerate(equations):
        for word in equation.terms:
            if word:
                by_first.setdefault(word[0], []).append((word, number))
    budget.begin(most)
    system = _System({}, budget)
    seen: set[Product] = set()
    known, frontier = set(goal), set(goal)
    for _ in range(MOST_ROUNDS):
        fresh: set[Word] = set()
        for word in sorted(frontier, key=_order):
            for product in _matches(word, by_first):
                if product in seen:
                    continue
                seen.add(product)
                row = _row(product, equations[product[1]], alphabet)
                if len(seen) > most or not budget.spend(1 + sum(map(len, row))):
                    return None
                fresh.update(row)
                system.insert(row, product)
        left, made = system.reduced(goal, {})
        if not left:
            return [(_fraction(-value), product) for product, value in made.items()]
        frontier = {word for word in fresh - known if len(word) <= MOST_LETTERS}
        known |= fresh
        if not frontier:
            return None
    return None


def _matches(word: Word, by_first: dict[int, list[tuple[Word, int]]]) -> Iterator[Product]:
    for start, letter in enumerate(word):
        for inner, number in by_first.get(letter, ()):
            if word[start : start + len(inner)] == inner:
                yield word[:start], number, word[start + len(inner) :]


def _row(product: Product, equation: Polynomial, alphabet: Alphabet) -> Row:
    row: Row = {}
    before, _, after = product
    for word, value in equation.terms.items():
        short = alphabet.normal(before + word + after)
        if short is None:
            continue
        if alphabet.last_pair(short) is None:
            _add(row, short, modulo(value))
            continue
        for other, times in alphabet.contracted(short).items():
            _add(row, other, times * modulo(value))
    return row


def _add(row: dict[_Key, int], key: _Key, value: int) -> None:
    total = (row.pop(key, 0) + value) % PRIME
    if total:
        row[key] = total


def _order(word: Word) -> tuple[int, Word]:
    return len(word), word


def _fraction(value: int) -> Number:
    """The small fraction that this is modulo the prime; a wrong one is seen by the checker."""
    low, high, p, q = PRIME, value % PRIME, 0, 1
    while high > LARGEST:
        factor = low // high
        low, high, p, q = high, low - factor * high, q, p - factor * q
    found = Fraction(high, q) if q else Fraction(0)
    return found.numerator if found.denominator == 1 else found
