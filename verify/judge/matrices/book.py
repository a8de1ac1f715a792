"""Hypotheses and statements of one proof, written as certificates have them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.matrices.alphabet import ONE, Alphabet
from gainproof.verify.judge.matrices.macaulay import (
    MOST_PRODUCTS,
    Budget,
    UnprovedError,
    products_for,
)
from gainproof.verify.judge.matrices.polynomial import Polynomial, Word, turned
from gainproof.verify.judge.matrices.size import Size

Source = tuple[Any, ...]
MOST_PARTED = 60
"""Terms of an equation of which parts between blocks are taken too."""


@dataclass(frozen=True)
class Cofactor:
    """left * (equation of the source, or its transpose) * right."""

    source: Source
    flipped: bool
    left: Polynomial
    right: Polynomial

    def negative(self) -> Cofactor:
        """Minus it."""
        return Cofactor(self.source, self.flipped, -self.left, self.right)

    def transposed(self) -> Cofactor:
        """Its transpose."""
        return Cofactor(self.source, not self.flipped, self.right.T, self.left.T)

    def inside(self, left: Polynomial, right: Polynomial) -> Cofactor:
        """With more factors on both sides."""
        return Cofactor(self.source, self.flipped, left @ self.left, self.right @ right)


@dataclass(frozen=True)
class Equation:
    """A polynomial in normal form that is the sum of cofactors, hence 0."""

    value: Polynomial
    make: Callable[[], tuple[Cofactor, ...]]

    @property
    def proof(self) -> tuple[Cofactor, ...]:
        """The cofactors, which are formed when they are wanted: most equations are never used."""
        return self.make()

    def transposed(self) -> Equation:
        """The transposed equation, not in normal form."""
        return Equation(self.value.T, lambda: tuple(c.transposed() for c in self.proof))

    def inside(self, left: Polynomial, right: Polynomial) -> Equation:
        """Between two factors, not in normal form."""
        value = left @ self.value @ right
        return Equation(value, lambda: tuple(c.inside(left, right) for c in self.proof))


@dataclass(frozen=True)
class Known:
    """What is known to be positive semidefinite, or definite where `strict`."""

    reference: Source
    value: Polynomial
    strict: bool


@dataclass
class Book:
    """`hypotheses` by number; `statements` in their order; `invertible`: statements by letter;
    `symmetric`: where it is known that a letter is; `differences`: left less right of each
    equation stated; `waiting`: elements that are symmetric by hypothesis; `hints`: polynomials that
    squares may be made of, `said`: those that the claim names.
    """

    alphabet: Alphabet
    hypotheses: list[Mapping[str, Any]] = field(default_factory=list)
    statements: list[Mapping[str, Any]] = field(default_factory=list)
    invertible: dict[int, str] = field(default_factory=dict)
    symmetric: dict[int, Source] = field(default_factory=dict)
    known: list[Known] = field(default_factory=list)
    equations: list[Equation] = field(default_factory=list)
    differences: dict[str, Polynomial] = field(default_factory=dict)
    waiting: list[tuple[int, Source]] = field(default_factory=list)
    hints: list[Polynomial] = field(default_factory=list)
    said: list[Polynomial] = field(default_factory=list)
    established: set[int] = field(default_factory=set)
    pending: list[Source] = field(default_factory=list)
    most: int = MOST_PRODUCTS
    budget: Budget = field(default_factory=Budget)
    _used: dict[str, set[int]] = field(default_factory=dict)
    _contracted: list[Equation] = field(default_factory=list)
    _contracted_so_far: int = 0

    def suppose(self, hypothesis: Mapping[str, Any]) -> Source:
        """A hypothesis, as a source."""
        self.hypotheses.append(hypothesis)
        return ("given", len(self.hypotheses) - 1)

    def raw(self, source: Source) -> Polynomial:
        """The equation of a source as the checker forms it."""
        alphabet = self.alphabet
        match source:
            case ("given", int(number)):
                found = self.hypotheses[number]
                if "equation" in found:
                    return found["equation"]  # type: ignore[no-any-return]
                letter = alphabet.letter(found["letter"])
                return letter.T - letter
            case ("element", int(number)):
                return alphabet.letter(number) - alphabet.elements[number]
            case ("blocks", Size() as size):
                total = -alphabet.unit(size)
                for number in alphabet.blocks[size]:
                    total = total + alphabet.letter(number) @ alphabet.letter(number).T
                return total
            case ("blocks", Size() as size, int(i), int(j)):
                pair = [alphabet.letter(alphabet.blocks[size][at]) for at in (i, j)]
                product = pair[0].T @ pair[1]
                return product - alphabet.unit(pair[0].shape[1]) if i == j else product
            case ("inverse", int(number), str(side)):
                one, other = alphabet.letter(number), alphabet.letter(alphabet.inverse[number])
                product = one @ other if side == "right" else other @ one
                return product - alphabet.unit(one.shape[0])
            case _:
                return self.differences[source[1]]

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

        def make() -> tuple[Cofactor, ...]:
            trace = self.traced(equation.value)[1]
            return (*equation.proof, *(c.negative() for c in trace))

        return Equation(alphabet.reduced(equation.value), make)

    def traced(self, value: Polynomial) -> tuple[Polynomial, list[Cofactor]]:
        """The normal form, and cofactors whose sum is what was taken away."""
        total, trace = Polynomial({}, value.shape), list[Cofactor]()
        for word, factor in value.terms.items():
            short = self._traced(word, factor, value, trace)
            if short is not None:
                total = total + Polynomial({short: factor}, value.shape)
        return total, trace

    def _traced(
        self, word: Word, factor: Fraction, value: Polynomial, trace: list[Cofactor]
    ) -> Word | None:
        alphabet = self.alphabet
        at = 0
        while at < len(word):
            letter = word[at]
            if letter % 2 and letter // 2 in alphabet.symmetric:
                if letter // 2 not in self.symmetric:
                    raise UnprovedError(f"{alphabet.names[letter // 2]} is not shown symmetric")
                trace.append(
                    self.at(word, at, at + 1, self.symmetric[letter // 2], False, factor, value)
                )
                word = (*word[:at], letter - 1, *word[at + 1 :])
            at += 1
        at = 0
        while at + 1 < len(word):
            met = alphabet.meeting(word[at], word[at + 1])
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
        factor: Fraction,
        value: Polynomial,
    ) -> Cofactor:
        """The equation in the place of a part of a word."""
        raw = self.raw(source)
        rows, columns = raw.shape[::-1] if flipped else raw.shape
        left = Polynomial({word[:start]: factor}, (value.shape[0], rows))
        right = Polynomial({word[end:]: ONE}, (columns, value.shape[1]))
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
        done: dict[Word, Fraction] = {}
        waiting = dict(value.terms)
        while waiting:
            word, factor = waiting.popitem()
            at = alphabet.last_pair(word)
            if at is None:
                total = done.pop(word, Fraction(0)) + factor
                if total:
                    done[word] = total
                continue
            size = alphabet.place[word[at] // 2][0]
            one = self.at(word, at, at + 2, ("blocks", size), False, factor, value)
            whole = Polynomial({word: factor}, value.shape)
            rest, trace = self.traced(whole - one.left @ self.raw(one.source) @ one.right)
            cofactors += [one, *trace]
            for other, part in rest.terms.items():
                total = waiting.pop(other, Fraction(0)) + part
                if total:
                    waiting[other] = total
        return Polynomial(done, value.shape), cofactors

    def contracted_equation(self, equation: Equation) -> Equation:
        """The same equation without last blocks that meet their transposes."""

        def make() -> tuple[Cofactor, ...]:
            trace = self.contracted(equation.value)[1]
            return (*equation.proof, *(c.negative() for c in trace))

        return Equation(self.short(equation.value), make)

    def short(self, value: Polynomial) -> Polynomial:
        """`contracted` without cofactors."""
        terms: dict[Word, Fraction] = {}
        for word, factor in value.terms.items():
            for other, times in self.alphabet.contracted(word).items():
                total = terms.pop(other, Fraction(0)) + factor * times
                if total:
                    terms[other] = total
        self.budget.charge(sum(map(len, value.terms)) + sum(map(len, terms)))
        return Polynomial(terms, value.shape)

    def vanishing(
        self, residual: Polynomial, more: Sequence[Equation] = (), most: int = MOST_PRODUCTS
    ) -> list[Cofactor]:
        """Cofactors whose sum the residual is, of at most so many products. Raises UnprovedError if
        none are found.
        """
        most = min(most, self.most)
        residual, replaced = self.without_elements(residual)
        value, trace = self.traced(residual)
        short = self.short(value)
        if not short.terms:
            return [*replaced, *trace, *self.contracted(value)[1]]
        if not most:
            raise UnprovedError("no proof was found")
        found = self._found(short, [*self._contracted_equations(), *more], most)
        return [*replaced, *trace, *self.contracted(value)[1], *found]

    def _contracted_equations(self) -> list[Equation]:
        """Every equation, and times the blocks with which its words begin or end."""
        alphabet = self.alphabet
        while self._contracted_so_far < len(self.equations):
            equation = self.equations[self._contracted_so_far]
            self._contracted_so_far += 1
            fresh = [self.contracted_equation(equation), *self._between_blocks(equation)]
            rows, columns = (alphabet.unit(size) for size in equation.value.shape)
            if len(equation.value.terms) > MOST_PARTED:
                fresh = fresh[:1]
            for number in sorted({w[0] // 2 for w in equation.value.terms if w and w[0] % 2}):
                if number in alphabet.place:
                    block = alphabet.letter(number)
                    fresh.append(equation.inside(block, columns))
            for number in sorted({w[-1] // 2 for w in equation.value.terms if w and not w[-1] % 2}):
                if number in alphabet.place:
                    block = alphabet.letter(number).T
                    fresh.append(equation.inside(rows, block))
            known = {e.value.key for e in self._contracted}
            for one in fresh:
                short = self.contracted_equation(self.normal(one))
                if short.value.terms and short.value.key not in known:
                    self._contracted.append(short)
        return self._contracted

    def _between_blocks(self, equation: Equation) -> list[Equation]:
        """The equation between blocks of the sizes with which its words begin or end."""
        alphabet, value = self.alphabet, equation.value
        rows, columns = value.shape
        begins = any(w and not w[0] % 2 and w[0] // 2 in alphabet.place for w in value.terms)
        ends = any(w and w[-1] % 2 and w[-1] // 2 in alphabet.place for w in value.terms)
        left = [alphabet.letter(n).T for n in alphabet.blocks.get(rows, ())] if begins else []
        right = [alphabet.letter(n) for n in alphabet.blocks.get(columns, ())] if ends else []
        one, two = alphabet.unit(rows), alphabet.unit(columns)
        pairs = [(a, two) for a in left] + [(one, b) for b in right]
        pairs += [(a, b) for a in left for b in right]
        return [equation.inside(a, b) for a, b in pairs]

    def _found(self, value: Polynomial, equations: Sequence[Equation], most: int) -> list[Cofactor]:
        self.budget.charge(0)
        values = [e.value for e in equations]
        found = products_for(value, values, self.alphabet, most, self.budget)
        if found is None:
            raise UnprovedError("no proof was found")
        cofactors, rest = list[Cofactor](), value
        for factor, (before, number, after) in found:
            equation = equations[number]
            left = Polynomial({before: factor}, (value.shape[0], equation.value.shape[0]))
            right = Polynomial({after: ONE}, (equation.value.shape[1], value.shape[1]))
            cofactors += [c.inside(left, right) for c in equation.proof]
            rest = rest - left @ equation.value @ right
        left_over, trace = self.traced(rest)
        left_over, more = self.contracted(left_over)
        if left_over.terms:
            raise UnprovedError("the numbers found are not the right ones")
        return [*cofactors, *trace, *more]

    def state(self, kind: str, claim: Mapping[str, Any], evidence: Any, name: str = "") -> str:
        """Write a statement; `evidence` may hold cofactors and sources. Its name."""
        name = name or f"step_{len(self.statements) + 1}"
        used: set[int] = set()
        self._collect(evidence, used)
        order = {number: place for place, number in enumerate(sorted(used))}
        given = [self._plain_hypothesis(number) for number in sorted(used)]
        self._used[name] = used
        self.statements.append(
            {
                "id": name,
                "kind": kind,
                "claim": {**claim, "given": given},
                "evidence": self._plain(evidence, order),
            }
        )
        return name

    def _collect(self, evidence: Any, used: set[int]) -> None:
        if isinstance(evidence, Mapping):
            for value in evidence.values():
                self._collect(value, used)
        elif isinstance(evidence, list):
            for value in evidence:
                self._collect(value, used)
        elif isinstance(evidence, Cofactor):
            self._collect(evidence.source, used)
        elif isinstance(evidence, tuple):
            if evidence[0] == "given":
                used.add(evidence[1])
            elif evidence[0] == "statement":
                used |= self._used[evidence[1]]
            elif evidence[0] == "inverse":
                used |= self._used[self.invertible[evidence[1]]]

    def _plain_hypothesis(self, number: int) -> dict[str, Any]:
        found = self.hypotheses[number]
        if "equation" in found:
            value: Polynomial = found["equation"]
            return {"kind": "equal", "left": self.graph(value), "right": self.graph(value - value)}
        return {"kind": found["kind"], "matrix": self.alphabet.names[found["letter"]]}

    def _plain(self, evidence: Any, order: Mapping[int, int]) -> Any:
        if isinstance(evidence, Mapping):
            return {key: self._plain(value, order) for key, value in evidence.items()}
        if isinstance(evidence, list):
            cofactors = [e for e in evidence if isinstance(e, Cofactor)]
            if cofactors:
                return self._gathered(cofactors, order)
            return [self._plain(value, order) for value in evidence]
        if isinstance(evidence, tuple):
            return self._plain_source(evidence, order)
        if isinstance(evidence, Polynomial):
            return self.data(evidence)
        return evidence

    def _plain_source(self, source: Source, order: Mapping[int, int]) -> list[Any]:
        alphabet = self.alphabet
        match source:
            case ("given", int(number)):
                return ["given", order[number]]
            case ("element", int(number)):
                return ["element", alphabet.names[number]]
            case ("blocks", Size() as size, *more):
                return ["blocks", alphabet.size_name(size), *more]
            case ("unit", Size() as size):
                return ["unit", alphabet.size_name(size)]
            case ("inverse", int(number), side):
                return ["inverse", self.invertible[number], side]
            case _:
                return list(source)

    def _gathered(self, cofactors: Sequence[Cofactor], order: Mapping[int, int]) -> list[Any]:
        """Cofactors of one source between the same words on one side as one; what cancels goes."""
        total: dict[tuple[Any, ...], tuple[Polynomial, Fraction]] = {}
        for c in cofactors:
            source, flipped, sign = c.source, c.flipped, ONE
            if flipped:
                raw = self.raw(source)
                if raw.T.key in (raw.key, (-raw).key):
                    flipped, sign = False, ONE if raw.T.key == raw.key else -ONE
            for before, factor in c.left.terms.items():
                for after, other in c.right.terms.items():
                    key = (source, flipped, before, after)
                    shape = (c.left.shape[0], c.right.shape[1])
                    value = total.get(key, (Polynomial({}, shape), Fraction(0)))[1]
                    total[key] = (Polynomial({}, shape), value + sign * factor * other)
        groups: dict[tuple[Any, ...], dict[Word, Fraction]] = {}
        shapes = {}
        for (source, flipped, before, after), (empty, value) in total.items():
            if value:
                groups.setdefault((source, flipped, before), {})[after] = value
                shapes[(source, flipped, before)] = empty.shape
        listed = []
        for (source, flipped, before), rights in groups.items():
            raw = self.raw(source)
            rows, columns = raw.shape[::-1] if flipped else raw.shape
            shape = shapes[(source, flipped, before)]
            entry = {
                "source": self._plain_source(source, order),
                "left": self.data(Polynomial({before: ONE}, (shape[0], rows))),
                "right": self.data(Polynomial(rights, (columns, shape[1]))),
            }
            listed.append({**entry, "transposed": "yes"} if flipped else entry)
        return listed

    def text(self, word: Word) -> list[str]:
        """A word as certificates write it."""
        return [self.alphabet.names[n // 2] + ("'" if n % 2 else "") for n in word]

    def data(self, value: Polynomial) -> list[Any]:
        """A polynomial as certificates write it."""
        terms = [[str(factor), [], self.text(word)] for word, factor in value.terms.items()]
        return sorted(terms, key=lambda term: term[2])

    def graph(self, value: Polynomial) -> dict[str, Any]:
        """A polynomial as a graph."""
        nodes: list[list[Any]] = []
        known: dict[tuple[Any, ...], int] = {}

        def add(*node: Any) -> int:
            if node not in known:
                nodes.append(list(node))
                known[node] = len(nodes) - 1
            return known[node]

        sums = []
        for word, factor in sorted(value.terms.items()):
            parts = [] if factor == 1 and word else [add("number", str(factor))]
            for letter in word:
                own = add("symbol", self.alphabet.names[letter // 2])
                parts.append(add("transpose", own) if letter % 2 else own)
            if not word:
                parts.append(add("symbol", f"unit_{self.alphabet.size_name(value.shape[0])}"))
            sums.append(parts[0] if len(parts) == 1 else add("mul", *parts))
        if not sums:
            number, flipped = self.alphabet.of_shape(value.shape)
            own = add("symbol", self.alphabet.names[number])
            add("mul", add("number", "0"), add("transpose", own) if flipped else own)
        elif len(sums) > 1:
            add("add", *sums)
        return {"nodes": nodes, "outputs": {"value": len(nodes) - 1}}


def is_self_transposed(value: Polynomial) -> bool:
    """Whether every word occurs with its transpose."""
    return {turned(word): c for word, c in value.terms.items()} == dict(value.terms)
