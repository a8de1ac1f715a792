"""Proofs that leave definitions closed: what is true of any matrix A needs no word of what A is.

A letter whose definition stays closed is a free letter of the same shape, without facts, so that
what is proved then is more than was asked. Premises and what is shown of closed letters (that a
block of a definite matrix is definite, that an inverse exists) are proved on their own and come in
as hypotheses; the certificate holds both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Any

from gainproof.verify.judge.matrices.certificate import rejected, written
from gainproof.verify.judge.matrices.instance import NoValueError, Unsupported
from gainproof.verify.judge.matrices.letter import MatrixSetting
from gainproof.verify.judge.matrices.macaulay import MOST_PRODUCTS, Budget, UnprovedError
from gainproof.verify.judge.matrices.polynomial import TooLongError
from gainproof.verify.judge.matrices.prove import Question, links, proof_of
from gainproof.verify.judge.matrices.sample import holds, instances, is_block, is_random
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.tree import Chain, Node

MOST_DEEP = 3
"""Lemmas for lemmas."""
FEW_PRODUCTS = 300
"""Where premises did not suffice, all definitions opened are no likelier to."""
Closing = dict[str, Node | None]
"""What takes the place of definitions; nothing where a letter is closed."""
FEW_TRIES, FEW_INSTANCES = 9, 2
"""To see that what is left of a claim, definitions closed, is false."""
FAILURES = (UnprovedError, TooLongError, Unsupported, NoValueError)


@dataclass
class Layers:
    """Proofs in one setting; what was proved once, or was not, is kept."""

    setting: MatrixSetting
    _known: dict[Question, list[dict[str, Any]] | str] = field(default_factory=dict)
    _facts: dict[Question, list[Chain]] = field(default_factory=dict)
    _budget: Budget = field(default_factory=Budget)

    def prove(self, question: Question, deep: int = 0) -> list[dict[str, Any]]:
        """Certificates, lemmas first. Raises UnprovedError."""
        if deep == 0:
            self._budget = Budget()
        bare = replace(question, hints=())
        before = self._under_less(bare)
        if before is not None:
            return before
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

    def _under_less(self, question: Question) -> list[dict[str, Any]] | None:
        """The proof of the same under some of the hypotheses, if there was one."""
        for other, found in self._known.items():
            if (
                not isinstance(found, str)
                and (other.chains, other.existing) == (question.chains, question.existing)
                and _supposes_no_more(other, question)
            ):
                return found
        return None

    def _proved(self, question: Question, deep: int) -> list[dict[str, Any]]:
        """Multiplied out, if it is the same on both sides; where premises are said to be needed,
        that is tried last.
        """
        if not question.premises:
            return self._multiplied_out(question) or self._by_layers(question, deep)
        try:
            return self._by_layers(question, deep)
        except UnprovedError:
            found = self._multiplied_out(question)
            if found is None:
                raise
            return found

    def _multiplied_out(self, question: Question) -> list[dict[str, Any]] | None:
        try:
            certificate = written(proof_of(replace(question, premises=()), self.setting, 0))
        except FAILURES:
            return None
        return [certificate] if rejected(certificate) is None else None

    def _by_layers(self, question: Question, deep: int) -> list[dict[str, Any]]:
        reasons: list[str] = []
        lemmas, given, invertible, known = self._of_premises(question, deep)
        for closed in self._closings(question):
            setting = _with_closed(self.setting, closed)
            try:
                more, facts, inverses = self._of_letters(question, closed, deep, given, known)
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
                    self._facts[replace(question, hints=())] = facts
                    return [*lemmas, *more, *hidden, certificate]
                reasons.append(f"the proof that was found is not accepted: {fault}")
            except FAILURES as reason:
                reasons.append(str(reason))
        raise UnprovedError(reasons[-1])

    def _of_premises(
        self, question: Question, deep: int
    ) -> tuple[list[dict[str, Any]], list[Chain], list[Node], list[Chain]]:
        """Earlier claims, and what was shown on the way; what they suppose beyond the hypotheses of
        this one is proved first, with those before them.
        """
        lemmas: list[dict[str, Any]] = []
        facts: list[Chain] = []
        given: list[Chain] = []
        inverses: list[Node] = []
        for premise in question.premises:
            now = Question((), (*question.given, *given), (*question.invertible, *inverses))
            if not _supposes_no_more(premise, now):
                supposed = replace(now, chains=premise.given, existing=premise.invertible)
                lemmas += self.prove(supposed, deep + 1)
            try:
                lemmas += self.prove(premise, deep + 1)
            except UnprovedError:
                here = replace(premise, given=question.given, invertible=question.invertible)
                if here == premise or not _supposes_no_more(premise, question):
                    raise
                lemmas += self.prove(here, deep + 1)
            facts += self._facts.get(replace(premise, hints=()), [])
            given += premise.chains
            inverses += premise.existing
        return lemmas, given, inverses, facts

    def _closings(self, question: Question) -> Iterator[Closing]:
        """What definitions become: with premises a letter what one of them says it is, and all others
        closed, or all but such as only pick rows; then those of blocks closed; then none.
        """
        letters = self.setting.letters
        # what depends on a random vector is not any matrix to a mean
        defined = {
            name: letter.definition
            for name, letter in letters.items()
            if letter.definition is not None and not is_random(name, self.setting)
        }
        picks = {name for name, node in defined.items() if is_block(node)}
        blocks = {n for n, node in defined.items() if node.kind == "matrix" and not _selects(node)}
        ways: list[Closing] = [dict.fromkeys(blocks | picks), {}]
        if question.premises:
            small = {n for n, node in defined.items() if node.kind == "matrix" and _selects(node)}
            said = _said(question, self.setting)
            every = {**dict.fromkeys(defined), **said}
            ways[:0] = [every, {n: node for n, node in every.items() if n not in small}]
        seen: list[Closing] = []
        for way in ways:
            reached = _reached(question, _with_closed(self.setting, way))
            used = {name: node for name, node in way.items() if name in reached}
            if used not in seen:
                seen.append(used)
                yield used

    def _of_letters(
        self,
        question: Question,
        closed: Closing,
        deep: int,
        known: list[Chain],
        shown: list[Chain],
    ) -> tuple[list[dict[str, Any]], list[Chain], list[Node]]:
        """What is shown of closed letters and of inverses, as far as it is true and found."""
        lemmas: list[dict[str, Any]] = []
        inverses: list[Node] = []
        wanted = self._wanted(question, closed)
        facts = [c for c in dict.fromkeys(shown) if closed and c.sides[0] in wanted]
        if not closed or deep >= MOST_DEEP:
            return lemmas, facts, inverses
        setting = _with_closed(self.setting, closed)
        inverted = _inverted(question, setting)
        waiting = [
            node
            for node in wanted
            if node not in question.invertible and node not in question.existing
            if not (node.kind == "name" and setting.letters[node.name].facts)
        ]
        while waiting:
            left: list[Node] = []
            for node in waiting:
                given = tuple(dict.fromkeys((*question.given, *known, *shown, *facts)))
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
                given = tuple(dict.fromkeys((*question.given, *known, *shown, *facts)))
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
        met = {*_inverted(question, setting), *question.invertible, *invertible}
        lemmas: list[dict[str, Any]] = []
        for node in _inverted(question, self.setting):
            if node not in met:
                lemmas += self._exists(node, question, known, invertible, deep)
        return lemmas

    def _exists(
        self,
        node: Node,
        question: Question,
        known: list[Chain],
        invertible: list[Node],
        deep: int,
    ) -> list[dict[str, Any]]:
        """An inverse exists, with what was shown only where it has to be: that may have inverses of
        its own.
        """
        alone = Question((), question.given, question.invertible, (), (node,))
        if not known and not invertible:
            return self.prove(alone, deep + 1)
        try:
            return self.prove(alone, deep + 1)
        except UnprovedError:
            given, existing = (*question.given, *known), (*question.invertible, *invertible)
            return self.prove(replace(alone, given=given, invertible=existing), deep + 1)

    def _wanted(self, question: Question, closed: Closing) -> list[Node]:
        """Blocks on a diagonal that are closed, and what is inverted."""
        letters = self.setting.letters
        setting = _with_closed(self.setting, closed)
        names = sorted(name for name in _reached(question, setting) if name in closed)
        diagonal = [
            Node("name", name=name)
            for name in names
            if is_block(letters[name].definition)  # type: ignore[arg-type]
            and letters[name].shape[0] == letters[name].shape[1]
            and letters[name].definition.parts[0].parts[0] == letters[name].definition.parts[2]  # type: ignore[union-attr]
        ]
        return list(dict.fromkeys([*diagonal, *_inverted(question, setting)]))


def _supposes_no_more(premise: Question, question: Question) -> bool:
    return set(premise.given) <= set(question.given) and (
        set(premise.invertible) <= set(question.invertible)
    )


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


def _said(question: Question, setting: MatrixSetting) -> Closing:
    """Letters with a definition that a premise says to be something made of other letters."""
    found: Closing = {}
    for premise in question.premises:
        for left, operator, right in links(premise.chains):
            for own, other in ((left, right), (right, left)):
                if (
                    operator == "="
                    and own.kind == "name"
                    and setting.letters[own.name].definition is not None
                    and not is_block(setting.letters[own.name].definition)  # type: ignore[arg-type]
                    and other.kind != "name"
                    and own.name not in found
                    and own.name not in _spoken((other,), _with_closed(setting, found))
                ):
                    found[own.name] = other
                    break
    return found


def _with_closed(setting: MatrixSetting, closed: Closing) -> MatrixSetting:
    letters = {
        name: replace(letter, definition=closed[name]) if name in closed else letter
        for name, letter in setting.letters.items()
    }
    return MatrixSetting(setting.sizes, letters)


def _reached(question: Question, setting: MatrixSetting) -> set[str]:
    """The letters of a question and of the definitions in it."""
    return _spoken(question.nodes(), setting)


def _spoken(nodes: Sequence[Node], setting: MatrixSetting) -> set[str]:
    waiting, found = [*nodes], set[str]()
    while waiting:
        for part in waiting.pop().walk():
            if part.kind == "name" and part.name not in found:
                found.add(part.name)
                letter = setting.letters[part.name]
                waiting += [n for n in (letter.definition, letter.variance) if n is not None]
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
