"""Rewriting of words with a record of what was used: the search that the checker does without.

A rule replaces a word by smaller ones. It comes from an equation l - r = 0 and keeps how it does:

    word - tail = sum of left (l - r) right      (l - r possibly transposed)

so that a polynomial brought to zero is such a sum as well.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.derive.words.polynomial import Key, Letter, Polynomial, Shape, Term, Word
from gainproof.derive.words.setting import Setting

MAXIMUM_STEPS = 20_000
ZERO, ONE = Fraction(0), Fraction(1)

Source = tuple[Any, ...]


class UnprovedError(ValueError):
    """A statement for which the rules at hand give no proof."""


@dataclass(frozen=True)
class Cofactor:
    """left (l - r) right, with l - r of the source, or its transpose."""

    source: Source
    flipped: bool
    left: Polynomial
    right: Polynomial

    def transposed(self) -> Cofactor:
        """The transposed equation between the transposed factors."""
        return Cofactor(self.source, not self.flipped, self.right.T, self.left.T)

    def inside(self, before: Word, after: Word, ends: Shape, by: Term) -> Cofactor:
        """With more letters on both sides, between these sizes, and times a number."""
        assert self.left.shape is not None
        assert self.right.shape is not None
        none = tuple(0 for _ in by[0])
        left = self.left.between(before, (), (ends[0], self.left.shape[1]), by)
        right = self.right.between((), after, (self.right.shape[0], ends[1]), (none, ONE))
        return Cofactor(self.source, self.flipped, left, right)


@dataclass(frozen=True)
class Rule:
    """word -> tail."""

    word: Word
    tail: Polynomial
    proof: tuple[Cofactor, ...]


@dataclass(frozen=True)
class Order:
    """Which of two words is replaced: the one with more of the `heavy` letters, the first before
    the second; else the longer one; else the later one, a transpose being later than its matrix.
    """

    heavy: tuple[str, ...] = ()

    def key(self, word: Word) -> tuple[Any, ...]:
        """Larger for what is to be replaced."""
        names = [name for name, _ in word]
        flags = sum(flag for _, flag in word)
        return (*(names.count(name) for name in self.heavy), len(word), flags, word)


@dataclass(frozen=True)
class Words:
    """Single words of a setting as polynomials."""

    setting: Setting

    def __call__(self, word: Word, shape: Shape) -> Polynomial:
        """The word with coefficient 1."""
        return Polynomial({(word, self.powers): Fraction(1)}, shape)

    @property
    def powers(self) -> tuple[int, ...]:
        """Of no parameter."""
        return (0,) * len(self.setting.variables)

    def rows(self, word: Word, place: int) -> str:
        """The size between a letter and the one before it."""
        name, flag = word[place]
        return self.setting.shape(name)[int(flag)]


def rule_of(value: Polynomial, proof: Sequence[Cofactor], order: Order) -> Rule | None:
    """The rule that value = 0 gives, or None if nothing is left of it."""
    if not value.terms:
        return None
    lead = max((word for word, _ in value.terms), key=order.key)
    leading = {key: c for key, c in value.terms.items() if key[0] == lead}
    if len(leading) > 1 or not lead:
        return None
    (((_, powers), coefficient),) = leading.items()
    scale = Polynomial({((), tuple(-p for p in powers)): 1 / coefficient}, None)
    none = (0,) * len(powers)
    tail = Polynomial({(lead, none): Fraction(1)}, value.shape) - scale @ value
    scaled = tuple(Cofactor(c.source, c.flipped, scale @ c.left, c.right) for c in proof)
    return Rule(lead, tail, scaled)


def reduced(value: Polynomial, rules: Sequence[Rule]) -> tuple[Polynomial, list[Cofactor]]:
    """What is left, and the cofactors of what was taken away: value = left + their sum."""
    cofactors: list[Cofactor] = []
    assert value.shape is not None
    shape = value.shape
    by_letter: dict[Letter, list[int]] = {}
    for number, rule in enumerate(rules):
        by_letter.setdefault(rule.word[0], []).append(number)
    finished: dict[Key, Fraction] = {}
    terms = dict(value.terms)
    for _ in range(MAXIMUM_STEPS):
        if not terms:
            return Polynomial(finished, shape), cofactors
        key, coefficient = next(iter(terms.items()))
        found = _first_match(key[0], by_letter, rules)
        if found is None:
            finished[key] = terms.pop(key)
            continue
        rule, start = found
        before, after = key[0][:start], key[0][start + len(rule.word) :]
        by = (key[1], coefficient)
        del terms[key]
        for other, added in rule.tail.between(before, after, shape, by).terms.items():
            # a word that was finished may come again, with another coefficient
            total = terms.pop(other, ZERO) + finished.pop(other, ZERO) + added
            if total:
                terms[other] = total
        cofactors += [c.inside(before, after, shape, by) for c in rule.proof]
    raise UnprovedError("the rules do not come to an end")


def completed(rules: Sequence[Rule], rounds: int, order: Order, words: Words) -> list[Rule]:
    """With the rules that overlaps of two give: where both apply, what they make is equal."""
    known = list(rules)
    for _ in range(rounds):
        fresh: list[Rule] = []
        for one in known:
            for other in known:
                for value, proof in _overlaps(one, other, words):
                    rest, used = reduced(value, [*known, *fresh])
                    rule = rule_of(rest, [*proof, *_negative(used)], order)
                    if rule is not None:
                        fresh.append(rule)
        if not fresh:
            break
        known += fresh
    return known


def _negative(cofactors: Sequence[Cofactor]) -> list[Cofactor]:
    return [Cofactor(c.source, c.flipped, -c.left, c.right) for c in cofactors]


def _first_match(
    word: Word, by_letter: Mapping[Letter, Sequence[int]], rules: Sequence[Rule]
) -> tuple[Rule, int] | None:
    """The first rule that applies, elements being first, and the first place where it does."""
    for number in sorted(n for letter in set(word) for n in by_letter.get(letter, ())):
        rule = rules[number]
        size = len(rule.word)
        for start in range(len(word) - size + 1):
            if word[start : start + size] == rule.word:
                return rule, start
    return None


def _overlaps(one: Rule, other: Rule, words: Words) -> Iterator[tuple[Polynomial, list[Cofactor]]]:
    """For word a b of the first and b c of the second: tail c - a tail, which is zero."""
    assert one.tail.shape is not None
    assert other.tail.shape is not None
    for size in range(1, min(len(one.word), len(other.word))):
        if one.word[-size:] != other.word[:size]:
            continue
        middle = words.rows(one.word, len(one.word) - size)
        end = words.rows(other.word, size)
        right = words(other.word[size:], (end, other.tail.shape[1]))
        left = words(one.word[:-size], (one.tail.shape[0], middle))
        value = one.tail @ right - left @ other.tail
        ends = (one.tail.shape[0], other.tail.shape[1])
        before, after = one.word[:-size], other.word[size:]
        plus, minus = (words.powers, ONE), (words.powers, -ONE)
        # a b c = tail c + proof c = a tail + a proof
        yield (
            value,
            [
                *(c.inside(before, (), ends, plus) for c in other.proof),
                *(c.inside((), after, ends, minus) for c in one.proof),
            ],
        )
