"""Cofactors found by rewriting with the equations that a statement may use."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from gainproof.derive.words.expression import Expression, symbol
from gainproof.derive.words.hypotheses import Hypothesis
from gainproof.derive.words.polynomial import Polynomial, Word
from gainproof.derive.words.rewriting import (
    Cofactor,
    Order,
    Rule,
    Source,
    UnprovedError,
    Words,
    completed,
    reduced,
    rule_of,
)
from gainproof.derive.words.setting import Setting

if TYPE_CHECKING:
    from gainproof.derive.words.statement import Statement

SHOWN_TERMS = 6
SYMMETRIC = ("symmetric", "definite", "semidefinite")
Equations = list[tuple[Polynomial, Source]]


@dataclass
class Search:
    """The equations at hand for one statement, and which hypotheses were needed.

    `given`: hypotheses that may be used. `using`: earlier statements. `heavy`: letters to be
    replaced first. `rounds`: of completing the rules by their overlaps. `multiples`: equations
    (hypotheses or statements) between two factors, which make rules of their own; `taken`: such
    products that are taken away at once. `numbers`: matrices of one row and column, which are their
    own transposes. `aside`: earlier statements that make no rules and are only taken or multiplied.
    """

    setting: Setting
    given: Sequence[Hypothesis] = ()
    using: Sequence[Statement] = ()
    heavy: tuple[str, ...] = ()
    rounds: int = 0
    multiples: Sequence[tuple[Expression, Any, Expression]] = ()
    taken: Sequence[tuple[Expression, Any, Expression]] = ()
    numbers: Sequence[Expression] = ()
    aside: Sequence[Statement] = ()
    used: set[int] = field(default_factory=set)

    @cached_property
    def pool(self) -> list[Hypothesis]:
        """Every hypothesis at hand, those of earlier statements included."""
        found: list[Hypothesis] = []
        for hypothesis in (*self.given, *(h for s in (*self.using, *self.aside) for h in s.given)):
            if hypothesis not in found:
                found.append(hypothesis)
        return found

    @property
    def one(self) -> Polynomial:
        """The number 1."""
        return self.setting.number(Fraction(1))

    @property
    def needed(self) -> tuple[Hypothesis, ...]:
        """The hypotheses that were used, in the order in which they were given."""
        return tuple(self.pool[number] for number in sorted(self.used))

    def reference(self, known: Any) -> list[Any]:
        """How evidence names a hypothesis, an earlier statement or a size."""
        if isinstance(known, tuple):
            return list(known)
        if isinstance(known, Mapping):
            return ["given", self.pool.index(dict(known))]
        return ["statement", known.id]

    def definite(self, known: Any) -> tuple[list[Any], Polynomial]:
        """The reference and the matrix of what is known to be positive (semi)definite: a
        hypothesis, a `Statement`, or ("unit", size).
        """
        if isinstance(known, tuple):
            return list(known), self.setting.unit(known[1])
        if isinstance(known, Mapping):
            return self.marked(known), self.setting.letter(known["matrix"])
        return self.marked(known), known.difference

    def marked(self, known: Any) -> list[Any]:
        """The reference, its hypotheses being remembered as needed."""
        return self._marked(tuple(self.reference(known)))

    def vanishing(self, residual: Polynomial, name: str) -> list[dict[str, Any]]:
        """Cofactors whose sum the residual is. Raises UnprovedError where none are found."""
        first = [self._product(*entry) for entry in self.taken]
        for value, _ in first:
            residual = residual - value
        rest, cofactors = reduced(residual, self.rules)
        if rest.terms:
            left = [self._shown(*term) for term in rest.data()]
            more = f" and {len(left) - SHOWN_TERMS} more" if len(left) > SHOWN_TERMS else ""
            raise UnprovedError(f"{name}: left over {', '.join(left[:SHOWN_TERMS])}{more}")
        return [
            self._data(cofactor)
            for cofactor in gathered([*(c for _, c in first), *cofactors], self.words)
        ]

    def _shown(self, coefficient: Any, powers: Any, word: Any) -> str:
        """A term as text, its number in front."""
        named = zip(self.setting.variables, powers, strict=True)
        numbers = (f"{name}^{power}" if power != 1 else name for name, power in named if power)
        return " ".join([coefficient, *numbers, *word])

    def numbered(self, evidence: Any) -> Any:
        """With the hypotheses numbered as in `needed`."""
        order = {number: place for place, number in enumerate(sorted(self.used))}
        if isinstance(evidence, Mapping):
            return {key: self.numbered(value) for key, value in evidence.items()}
        if isinstance(evidence, list):
            if len(evidence) == 2 and evidence[0] == "given":
                return ["given", order[evidence[1]]]
            return [self.numbered(entry) for entry in evidence]
        return evidence

    @property
    def words(self) -> Words:
        """Words of the setting."""
        return Words(self.setting)

    @cached_property
    def rules(self) -> list[Rule]:
        """Rules of all equations, elements first, then completed."""
        order = Order(self.heavy)
        found = [
            rule for name in self.setting.elements for rule in element_rules(self.setting, name)
        ]
        for value, whole in self._equations():
            for flag in (False, True):
                turned = value.T if flag else value
                proof = [whole.transposed() if flag else whole]
                rest, used = reduced(turned, found)
                negative = [Cofactor(c.source, c.flipped, -c.left, c.right) for c in used]
                rule = rule_of(rest, [*proof, *negative], order)
                if rule is not None:
                    found.append(rule)
        return completed(found, self.rounds, order, self.words)

    def _equations(self) -> list[tuple[Polynomial, Cofactor]]:
        """Every equation at hand, as it is found in its source."""
        whole = [
            (value, Cofactor(source, False, *units(self.setting, value)))
            for value, source in self._sources()
        ]
        return [*whole, *(self._product(*entry) for entry in self.multiples)]

    def _product(
        self, before: Expression, known: Any, after: Expression
    ) -> tuple[Polynomial, Cofactor]:
        """An equation between two factors."""
        source = tuple(self.reference(known))
        apart = [entry for statement in self.aside for entry in statement.equations]
        (value,) = (value for value, other in [*self._sources(), *apart] if other == source)
        cofactor = Cofactor(source, False, self.setting.expand(before), self.setting.expand(after))
        return cofactor.left @ value @ cofactor.right, cofactor

    def _sources(self) -> list[tuple[Polynomial, Source]]:
        """What the rules are made of, each equation with where it comes from."""
        plain, last = equations(self.setting, self.pool, self.numbers)
        # the last ones come reduced by all others, so that the rules they make are the shortest
        return [*plain, *(e for statement in self.using for e in statement.equations), *last]

    def _data(self, cofactor: Cofactor) -> dict[str, Any]:
        flipped_too = {"transposed": "yes"} if cofactor.flipped else {}
        return {
            "source": self._marked(cofactor.source),
            **flipped_too,
            "left": cofactor.left.data(),
            "right": cofactor.right.data(),
        }

    def _marked(self, source: Source) -> list[Any]:
        """The source, its hypotheses being remembered as needed."""
        if source[0] == "given":
            self.used.add(source[1])
        if source[0] in ("statement", "inverse"):
            (statement,) = (s for s in (*self.using, *self.aside) if s.id == source[1])
            self.used |= {self.pool.index(hypothesis) for hypothesis in statement.given}
        if source[0] == "number":
            return ["number", source[1].value.data()]
        return list(source)


def gathered(cofactors: Sequence[Cofactor], words: Words) -> list[Cofactor]:
    """Cofactors of one source with one right factor are one."""
    by_right: dict[tuple[Any, ...], Cofactor] = {}
    for cofactor in cofactors:
        for (word, powers), coefficient in cofactor.right.terms.items():
            key = (cofactor.source, cofactor.flipped, word)
            scale = Polynomial({((), powers): coefficient}, None)
            single = words(word, cofactor.right.shape or ("", ""))
            left = scale @ cofactor.left
            if key in by_right:
                left = left + by_right[key].left
            by_right[key] = Cofactor(cofactor.source, cofactor.flipped, left, single)
    return _by_left(list(by_right.values()))


def _by_left(cofactors: Sequence[Cofactor]) -> list[Cofactor]:
    """Cofactors of one source with one left factor are one."""
    by_left: dict[tuple[Any, ...], Cofactor] = {}
    for cofactor in cofactors:
        if cofactor.left.terms:
            key = (cofactor.source, cofactor.flipped, str(cofactor.left.data()))
            right = cofactor.right
            if key in by_left:
                right = right + by_left[key].right
            by_left[key] = Cofactor(cofactor.source, cofactor.flipped, cofactor.left, right)
    return list(by_left.values())


def element_rules(setting: Setting, name: str) -> list[Rule]:
    """A letter and its transpose are replaced by what they stand for."""
    meaning = setting.meanings[name]
    made = []
    for flag in (False, True):
        tail = meaning.T if flag else meaning
        word: Word = ((name, flag),)
        proof = Cofactor(("element", name), flag, *units(setting, tail))
        made.append(Rule(word, tail, (proof,)))
    return made


def equations(
    setting: Setting, pool: Sequence[Hypothesis], numbers: Sequence[Expression]
) -> tuple[Equations, Equations]:
    """Left less right of blocks and symmetric letters, and of single numbers and hypotheses."""
    plain, last = _blocks(setting), Equations()
    for entry in numbers:
        value = setting.expand(entry)
        last.append((value - value.T, ("number", Exact(value))))
    for number, hypothesis in enumerate(pool):
        if hypothesis["kind"] in SYMMETRIC:
            letter = setting.letter(hypothesis["matrix"])
            plain.append((letter.T - letter, ("given", number)))
        elif hypothesis["kind"] == "equal":
            left, right = setting.pair(_read(hypothesis["left"]), _read(hypothesis["right"]))
            last.append((left - right, ("given", number)))
    return plain, last


def units(setting: Setting, value: Polynomial) -> tuple[Polynomial, Polynomial]:
    """The unit matrices on both sides of a matrix."""
    assert value.shape is not None
    return setting.unit(value.shape[0]), setting.unit(value.shape[1])


def _blocks(setting: Setting) -> Equations:
    found = Equations()
    for size, columns in setting.blocks.items():
        letters = [setting.letter(name) for name in columns]
        for i, one in enumerate(letters):
            for j, other in enumerate(letters):
                value = one.T @ other
                if i == j:
                    value = value - setting.unit(setting.shape(columns[i])[1])
                found.append((value, ("blocks", size, i, j)))
        total = -setting.unit(size)
        for letter in letters:
            total = total + letter @ letter.T
        found.append((total, ("blocks", size)))
    return found


@dataclass(frozen=True, eq=False)
class Exact:
    """A polynomial as part of a source, told from others by which object it is."""

    value: Polynomial


def _read(graph: Mapping[str, Any]) -> Expression:
    """The formula of a graph."""
    made: list[Expression] = []
    for kind, *rest in graph["nodes"]:
        if kind == "pow":
            made.append(made[rest[0]] ** int(rest[1]))
        elif kind in ("number", "symbol"):
            made.append(Expression(kind, rest[0]) if kind == "number" else symbol(rest[0]))
        else:
            made.append(Expression(kind, "", tuple(made[number] for number in rest)))
    return made[-1]
