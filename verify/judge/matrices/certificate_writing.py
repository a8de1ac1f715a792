"""Hypotheses and statements of one proof, written as certificates have them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gainproof.verify.judge.matrices.equation import Cofactor, Equation, Known, Source
from gainproof.verify.judge.matrices.ideal_membership import MOST_PRODUCTS, Budget
from gainproof.verify.judge.matrices.polynomial import Number, Polynomial, Word
from gainproof.verify.judge.matrices.size import ONE as SINGLE
from gainproof.verify.judge.matrices.size import Size
from gainproof.verify.judge.matrices.statement_letters import Alphabet


@dataclass
class Writing:
    """`hypotheses` by number; `statements` in their order; `invertible`: statements by letter;
    `symmetric`: where it is known that a letter is; `differences`: left less right of each
    equation stated; `waiting`: elements that are symmetric by hypothesis; `hints`: polynomials that
    squares may be made of, `said`: those that the claim names; `products`: letters, each with what
    may be its inverse; `goals`: the statements that were asked for, `asked`: as they were.
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
    products: list[tuple[int, Polynomial]] = field(default_factory=list)
    goals: list[str] = field(default_factory=list)
    asked: Mapping[str, Any] | None = None
    most: int = MOST_PRODUCTS
    budget: Budget = field(default_factory=Budget)
    _used: dict[str, set[int]] = field(default_factory=dict)

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
            case ("number", tuple(word)):
                own = Polynomial({word: 1}, (SINGLE, SINGLE))
                return own - own.T
            case ("inverse", int(number), str(side)):
                one, other = alphabet.letter(number), alphabet.letter(alphabet.inverse[number])
                product = one @ other if side == "right" else other @ one
                return product - alphabet.unit(one.shape[0])
            case _:
                return self.differences[source[1]]

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
            case ("number", tuple(word)):
                return ["number", self.data(Polynomial({word: 1}, (SINGLE, SINGLE)))]
            case ("inverse", int(number), side):
                return ["inverse", self.invertible[number], side]
            case _:
                return list(source)

    def _gathered(self, cofactors: Sequence[Cofactor], order: Mapping[int, int]) -> list[Any]:
        """Cofactors of one source between the same words on one side as one; what cancels goes."""
        total: dict[tuple[Any, ...], tuple[Polynomial, Number]] = {}
        for c in cofactors:
            source, flipped, sign = c.source, c.flipped, 1
            if flipped:
                raw = self.raw(source)
                if raw.T.key in (raw.key, (-raw).key):
                    flipped, sign = False, 1 if raw.T.key == raw.key else -1
            for before, factor in c.left.terms.items():
                for after, other in c.right.terms.items():
                    key = (source, flipped, before, after)
                    shape = (c.left.shape[0], c.right.shape[1])
                    value = total.get(key, (Polynomial({}, shape), 0))[1]
                    total[key] = (Polynomial({}, shape), value + sign * factor * other)
        groups: dict[tuple[Any, ...], dict[Word, Number]] = {}
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
                "left": self.data(Polynomial({before: 1}, (shape[0], rows))),
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
