"""Proofs that leave definitions closed: what is true of any matrix A needs no word of what A is.

A letter whose definition stays closed is a free letter of the same shape, without facts, so that
what is proved then is more than was asked. Premises and what is shown of closed letters (that a
block of a definite matrix is definite, that an inverse exists) are proved on their own and come in
as hypotheses; the certificate holds both.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Any

from gainproof.verify.judge.matrices.certificate import rejected, written
from gainproof.verify.judge.matrices.instance import NoValueError, Unsupported
from gainproof.verify.judge.matrices.letter import MatrixSetting
from gainproof.verify.judge.matrices.macaulay import MOST_PRODUCTS, Budget, UnprovedError
from gainproof.verify.judge.matrices.polynomial import TooLongError
from gainproof.verify.judge.matrices.prove import Question, proof_of
from gainproof.verify.judge.matrices.sample import holds, instances, is_block, is_random
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.tree import Chain, Node

MOST_DEEP = 3
"""Lemmas for lemmas."""
FEW_PRODUCTS = 300
"""Where premises did not suffice, all definitions opened are no likelier to."""
FEW_TRIES, FEW_INSTANCES = 9, 2
"""To see that what is left of a claim, definitions closed, is false."""
FAILURES = (UnprovedError, TooLongError, Unsupported, NoValueError)


@dataclass
class Layers:
    """Proofs in one setting; what was proved once, or was not, is kept."""

    setting: MatrixSetting
    _known: dict[Question, list[dict[str, Any]] | str] = field(default_factory=dict)
    _budget: Budget = field(default_factory=Budget)

    def prove(self, question: Question, deep: int = 0) -> list[dict[str, Any]]:
        """Certificates, lemmas first. Raises UnprovedError."""
        if deep == 0:
            self._budget = Budget()
        bare = replace(question, hints=())
        if bare not in self._known or question.hints:
            try:
                self._known[bare] = self._proved(question, deep)
            except UnprovedError as reason:
                if deep == 0:
                    raise
                self._known[bare] = str(reason)
        found = self._known[bare]
        if isinstance(found, str):
            raise UnprovedError(found)
        return found

    def _proved(self, question: Question, deep: int) -> list[dict[str, Any]]:
        reasons: list[str] = []
        try:
            certificate = written(proof_of(replace(question, premises=()), self.setting, 0))
            if rejected(certificate) is None:
                return [certificate]
        except FAILURES:
            pass  # multiplied out it is not the same on both sides
        lemmas, given, invertible = self._of_premises(question, deep)
        for closed in self._closings(question):
            setting = _with_closed(self.setting, closed)
            try:
                more, facts, inverses = self._of_letters(question, closed, deep, given)
                asked = replace(
                    question,
                    given=(*question.given, *given, *facts),
                    invertible=(*question.invertible, *invertible, *inverses),
                    premises=(),
                )
                if closed and _fails(asked, setting):
                    reasons.append("what is left of it is not true")
                    continue
                most = MOST_PRODUCTS if closed or not question.premises else FEW_PRODUCTS
                certificate = written(proof_of(asked, setting, most, self._budget))
                fault = rejected(certificate)
                if fault is None:
                    hidden = self._of_hidden(question, setting, deep, given, invertible)
                    return [*lemmas, *more, *hidden, certificate]
                reasons.append(f"the proof that was found is not accepted: {fault}")
            except FAILURES as reason:
                reasons.append(str(reason))
        raise UnprovedError(reasons[-1])

    def _of_premises(
        self, question: Question, deep: int
    ) -> tuple[list[dict[str, Any]], list[Chain], list[Node]]:
        """Earlier claims, proved under the hypotheses of this one."""
        lemmas: list[dict[str, Any]] = []
        given: list[Chain] = []
        inverses: list[Node] = []
        for premise in question.premises:
            asked = replace(premise, given=question.given, invertible=question.invertible)
            supposed = replace(
                asked, chains=premise.given, existing=premise.invertible, premises=(), hints=()
            )
            if not (set(premise.given) <= set(question.given)) or not (
                set(premise.invertible) <= set(question.invertible)
            ):
                lemmas += self.prove(supposed, deep + 1)
                asked = premise  # what it supposes is true here
            lemmas += self.prove(asked, deep + 1)
            given += premise.chains
            inverses += premise.existing
        return lemmas, given, inverses

    def _closings(self, question: Question) -> Iterator[frozenset[str]]:
        """Which definitions stay closed: all; all of blocks but such as only pick rows; none."""
        letters = self.setting.letters
        # what depends on a random vector is not any matrix to a mean
        defined = {
            name
            for name, letter in letters.items()
            if letter.definition is not None and not is_random(name, self.setting)
        }
        picks = {name for name in defined if is_block(letters[name].definition)}  # type: ignore[arg-type]
        blocks = {
            name
            for name in defined
            if letters[name].definition.kind == "matrix"  # type: ignore[union-attr]
            and not _selects(letters[name].definition)  # type: ignore[arg-type]
        }
        seen: set[frozenset[str]] = set()
        for closed in (blocks | picks, defined if question.premises else set(), set()):
            used = frozenset(closed & _reached(question, self.setting, closed))
            if used not in seen:
                seen.add(used)
                yield used

    def _of_letters(
        self, question: Question, closed: frozenset[str], deep: int, known: list[Chain]
    ) -> tuple[list[dict[str, Any]], list[Chain], list[Node]]:
        """What is shown of closed letters and of inverses, as far as it is true and found."""
        lemmas: list[dict[str, Any]] = []
        facts: list[Chain] = []
        inverses: list[Node] = []
        if not closed or deep >= MOST_DEEP:
            return lemmas, facts, inverses
        setting = _with_closed(self.setting, closed)
        inverted = _inverted(question, setting)
        waiting = [
            node
            for node in self._wanted(question, closed)
            if node not in question.invertible and node not in question.existing
            if not (node.kind == "name" and setting.letters[node.name].facts)
        ]
        while waiting:
            left: list[Node] = []
            for node in waiting:
                given = (*question.given, *known, *facts)
                definite = _positive(node, setting)
                asked = Question((definite,), given, question.invertible)
                if definite in given or question.chains == (definite,):
                    continue
                try:
                    lemmas += self.prove(asked, deep + 1)
                    facts.append(definite)
                except UnprovedError:
                    left.append(node)
            if len(left) == len(waiting):
                break
            waiting = left
        for node in waiting:
            if node in inverted:
                given = (*question.given, *known, *facts)
                asked = Question((), given, question.invertible, (), (node,))
                lemmas += self.prove(asked, deep + 1)
                inverses.append(node)
        return lemmas, facts, inverses

    def _of_hidden(
        self,
        question: Question,
        setting: MatrixSetting,
        deep: int,
        known: list[Chain],
        invertible: list[Node],
    ) -> list[dict[str, Any]]:
        """Every inverse in a closed definition exists: a letter that is none has no truth. Raises
        UnprovedError.
        """
        given = (*question.given, *known)
        existing = (*question.invertible, *invertible)
        met = {*_inverted(question, setting), *existing}
        lemmas: list[dict[str, Any]] = []
        for node in _inverted(question, self.setting):
            if node not in met:
                asked = Question((), given, existing, (), (node,))
                lemmas += self.prove(asked, deep + 1)
        return lemmas

    def _wanted(self, question: Question, closed: frozenset[str]) -> list[Node]:
        """Blocks on a diagonal that are closed, and what is inverted."""
        letters = self.setting.letters
        setting = _with_closed(self.setting, closed)
        names = sorted(_reached(question, self.setting, closed) & closed)
        diagonal = [
            Node("name", name=name)
            for name in names
            if is_block(letters[name].definition)  # type: ignore[arg-type]
            and letters[name].shape[0] == letters[name].shape[1]
            and letters[name].definition.parts[0].parts[0] == letters[name].definition.parts[2]  # type: ignore[union-attr]
        ]
        return list(dict.fromkeys([*diagonal, *_inverted(question, setting)]))


def _fails(question: Question, setting: MatrixSetting) -> bool:
    """Whether a closed question is false at one of few instances: no proof is looked for then."""
    tried = instances(setting, question.given, question.invertible, tries=FEW_TRIES)
    try:
        for instance in islice(tried, FEW_INSTANCES):
            if not all(holds(chain, instance) for chain in question.chains):
                return True
            if not all(instance.of(node).det() != 0 for node in question.existing):
                return True
    except (Unsupported, NoValueError):
        return False
    return False


def _selects(node: Node) -> bool:
    """Whether a matrix has no blocks but units and zeros."""
    return all(part.kind in ("unit", "zero") for part in node.parts)


def _with_closed(setting: MatrixSetting, closed: frozenset[str]) -> MatrixSetting:
    letters = {
        name: replace(letter, definition=None) if name in closed else letter
        for name, letter in setting.letters.items()
    }
    return MatrixSetting(setting.sizes, letters)


def _reached(
    question: Question, setting: MatrixSetting, closed: set[str] | frozenset[str]
) -> set[str]:
    """The letters of a question and of the definitions in it that are not closed."""
    waiting, found = [*question.nodes()], set[str]()
    while waiting:
        for part in waiting.pop().walk():
            if part.kind == "name" and part.name not in found:
                found.add(part.name)
                letter = setting.letters[part.name]
                if part.name not in closed and letter.definition is not None:
                    waiting.append(letter.definition)
                if letter.variance is not None:
                    waiting.append(letter.variance)
    return found


def _inverted(question: Question, setting: MatrixSetting) -> list[Node]:
    """What stands under an inverse in a question, with the definitions that are open."""
    waiting, seen, found = [*question.nodes()], set[str](), list[Node]()
    while waiting:
        for part in waiting.pop(0).walk():
            if part.kind == "name" and part.name not in seen:
                seen.add(part.name)
                definition = setting.letters[part.name].definition
                waiting += [] if definition is None else [definition]
            if part.kind == "inverse" and part.parts[0] not in found:
                found.insert(0, part.parts[0])
    return found


def _positive(node: Node, setting: MatrixSetting) -> Chain:
    """The matrix is positive definite."""
    shape = Shapes(setting.letters, setting.sizes).of(node)
    return Chain((node, Node("zero", shape=shape)), (">",))
