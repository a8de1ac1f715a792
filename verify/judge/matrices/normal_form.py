"""Words in normal form, with the cofactors of what that takes away."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

from gainproof.verify.judge.matrices.certificate_writing import Writing
from gainproof.verify.judge.matrices.equation import Cofactor, Equation, Source
from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.polynomial import Number, Polynomial, Word, turned
from gainproof.verify.judge.matrices.scalar_factors import factors, settled, without_transposes


@dataclass
class NormalForm(Writing):
    """What is written in a proof, and its equations in normal form."""

    _exchanged: dict[tuple[Word, Word], Source] = field(default_factory=dict)

    def equation(self, source: Source) -> Equation:
        """The equation of a source in normal form."""
        value = self.raw(source)
        one = Cofactor(
            source, False, self.alphabet.unit(value.shape[0]), self.alphabet.unit(value.shape[1])
        )
        return self.normal(Equation(value, lambda: (one,)))

    def normal(self, equation: Equation) -> Equation:
        """The same equation in normal form."""
        alphabet = self.alphabet
        for word in equation.value.terms:
            for letter in word:
                if letter % 2 and letter // 2 in alphabet.symmetric - self.symmetric.keys():
                    raise UnprovedError(f"{alphabet.names[letter // 2]} is not shown symmetric")

        found = alphabet.reduced(equation.value)

        def make() -> tuple[Cofactor, ...]:
            # a letter may be known to be symmetric since: both have one normal form now
            trace, since = self.traced(equation.value)[1], self.traced(found)[1]
            return (*equation.proof, *(c.negative() for c in trace), *since)

        return Equation(found, make)

    def traced(self, value: Polynomial) -> tuple[Polynomial, list[Cofactor]]:
        """The normal form, and cofactors whose sum is what was taken away."""
        total, trace = Polynomial({}, value.shape), list[Cofactor]()
        for word, factor in value.terms.items():
            short = self._traced(word, factor, value, trace)
            if short is not None:
                total = total + Polynomial({short: factor}, value.shape)
        return total, trace

    def _traced(
        self, word: Word, factor: Number, value: Polynomial, trace: list[Cofactor]
    ) -> Word | None:
        while True:
            word = self._untransposed(word, factor, value, trace)
            while (swapped := self.alphabet.swap(word)) is not None:
                at, other = swapped
                source = self._commuting(word[at - 1 : at + 1], other[at - 1 : at + 1])
                trace.append(self.at(word, at - 1, at + 1, source, False, factor, value))
                word = other
            met = self._met(word, factor, value, trace)
            if met is None:
                return None
            word = self._settled(met, factor, value, trace)
            if word == met and self.alphabet.swap(word) is None:
                return word

    def _commuting(self, word: Word, other: Word) -> Source:
        """That a number times a unit matrix may stand before or behind a letter: a hypothesis, as
        the checker knows no numbers.
        """
        key = (word, other)
        if key not in self._exchanged:
            shapes = self.alphabet.shapes
            shape = (shapes[word[0] >> 1][word[0] & 1], shapes[word[1] >> 1][1 - (word[1] & 1)])
            equation = Polynomial({word: 1, other: -1}, shape)
            self._exchanged[key] = self.suppose({"equation": equation})
        return self._exchanged[key]

    def _untransposed(
        self, word: Word, factor: Number, value: Polynomial, trace: list[Cofactor]
    ) -> Word:
        """Symmetric letters lose their transpose."""
        alphabet = self.alphabet
        for at, letter in enumerate(word):
            if letter % 2 and letter // 2 in alphabet.symmetric:
                if letter // 2 not in self.symmetric:
                    raise UnprovedError(f"{alphabet.names[letter // 2]} is not shown symmetric")
                trace.append(
                    self.at(word, at, at + 1, self.symmetric[letter // 2], False, factor, value)
                )
                word = (*word[:at], letter - 1, *word[at + 1 :])
        return word

    def _met(
        self, word: Word, factor: Number, value: Polynomial, trace: list[Cofactor]
    ) -> Word | None:
        """Neighbours that are unit or zero matrices vanish; None for a word that is zero."""
        at = 0
        while at + 1 < len(word):
            met = self.alphabet.meeting(word[at], word[at + 1])
            if met is None:
                at += 1
                continue
            source, flipped = self._pair(word[at], word[at + 1])
            trace.append(self.at(word, at, at + 2, source, flipped, factor, value))
            if met is False:
                return None
            word = word[:at] + word[at + 2 :]
            at = max(0, at - 1)
        return word

    def _settled(
        self, word: Word, factor: Number, value: Polynomial, trace: list[Cofactor]
    ) -> Word:
        """Factors of one row and column in their order, by transposes alone: f g = g' f'."""
        alphabet = self.alphabet

        def turn(word: Word, start: int, end: int) -> Word:
            piece = word[start:end]
            if turned(piece) != piece:
                source = ("number", piece)
                trace.append(self.at(word, start, end, source, False, factor, value))
            other = (*word[:start], *turned(piece), *word[end:])
            return self._untransposed(other, factor, value, trace)

        cuts = factors(word, alphabet.shapes)
        if len(cuts) < 2:
            return word
        for place, wanted in enumerate(settled(word, cuts, alphabet.symmetric, alphabet.ranks)):
            cuts = factors(word, alphabet.shapes)
            here = list(pairwise(cuts))
            alike = (wanted, without_transposes(turned(wanted), alphabet.symmetric))
            at = next(n for n in range(place, len(here)) if word[slice(*here[n])] in alike)
            start, (middle, end) = here[place][0], here[at]
            if at > place:
                word = turn(word, start, end)  # (f g)' = g' f'
                word = turn(word, start + end - middle, end)
            else:
                middle, end = here[at]
            if word[start : start + end - middle] != wanted:
                word = turn(word, start, start + end - middle)
        return word

    def _pair(self, one: int, other: int) -> tuple[Source, bool]:
        alphabet = self.alphabet
        if one // 2 in alphabet.place:
            (size, i), (_, j) = alphabet.place[one // 2], alphabet.place[other // 2]
            return ("blocks", size, i, j), False
        is_base = one // 2 in alphabet.inverse and alphabet.inverse[one // 2] == other // 2
        base = one // 2 if is_base else other // 2
        if base not in self.invertible:
            raise UnprovedError(f"{alphabet.names[base]} is not shown to have an inverse")
        flipped = bool(one % 2)
        return ("inverse", base, "right" if is_base != flipped else "left"), flipped

    def at(
        self,
        word: Word,
        start: int,
        end: int,
        source: Source,
        flipped: bool,
        factor: Number,
        value: Polynomial,
    ) -> Cofactor:
        """The equation in the place of a part of a word."""
        raw = self.raw(source)
        rows, columns = raw.shape[::-1] if flipped else raw.shape
        left = Polynomial({word[:start]: factor}, (value.shape[0], rows))
        right = Polynomial({word[end:]: 1}, (columns, value.shape[1]))
        return Cofactor(source, flipped, left, right)

    def without_elements(self, value: Polynomial) -> tuple[Polynomial, list[Cofactor]]:
        """With what letters are short for in their place, and the cofactors of that."""
        alphabet, cofactors = self.alphabet, list[Cofactor]()
        while True:
            found = next(
                (
                    (word, at)
                    for word in value.terms
                    for at, letter in enumerate(word)
                    if letter // 2 in alphabet.elements
                ),
                None,
            )
            if found is None:
                return value, cofactors
            word, at = found
            number, flipped = word[at] // 2, bool(word[at] % 2)
            meaning = alphabet.elements[number]
            meaning = meaning.T if flipped else meaning
            one = self.at(word, at, at + 1, ("element", number), flipped, value.terms[word], value)
            gone = Polynomial({word: value.terms[word]}, value.shape)
            value = value - gone + one.left @ meaning @ one.right
            cofactors.append(one)

    def contracted(self, value: Polynomial) -> tuple[Polynomial, list[Cofactor]]:
        """A polynomial in normal form without last blocks that meet their transposes."""
        alphabet, cofactors = self.alphabet, list[Cofactor]()
        done: dict[Word, Number] = {}
        waiting = dict(value.terms)
        while waiting:
            word, factor = waiting.popitem()
            at = alphabet.last_pair(word)
            if at is None:
                total = done.pop(word, 0) + factor
                if total:
                    done[word] = total
                continue
            size = alphabet.place[word[at] // 2][0]
            one = self.at(word, at, at + 2, ("blocks", size), False, factor, value)
            whole = Polynomial({word: factor}, value.shape)
            rest, trace = self.traced(whole - one.left @ self.raw(one.source) @ one.right)
            cofactors += [one, *trace]
            for other, part in rest.terms.items():
                total = waiting.pop(other, 0) + part
                if total:
                    waiting[other] = total
        return Polynomial(done, value.shape), cofactors

    def contracted_equation(self, equation: Equation) -> Equation:
        """The same equation without last blocks that meet their transposes."""

        found = self.short(equation.value)

        def make() -> tuple[Cofactor, ...]:
            return (*equation.proof, *self._gone(equation.value, -1), *self._gone(found, 1))

        return Equation(found, make)

    def _gone(self, value: Polynomial, sign: int) -> list[Cofactor]:
        """What is taken away from a polynomial, that is no longer normal if a letter is known to be
        symmetric since.
        """
        rest, trace = self.traced(value)
        cofactors = [*trace, *self.contracted(rest)[1]]
        return cofactors if sign > 0 else [c.negative() for c in cofactors]

    def short(self, value: Polynomial) -> Polynomial:
        """`contracted` without cofactors."""
        terms: dict[Word, Number] = {}
        for word, factor in value.terms.items():
            for other, times in self.alphabet.contracted(word).items():
                total = terms.pop(other, 0) + factor * times
                if total:
                    terms[other] = total
        self.budget.charge(sum(map(len, value.terms)) + sum(map(len, terms)))
        return Polynomial(terms, value.shape)
