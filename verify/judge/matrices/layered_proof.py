"""Proofs with few definitions put in: what is true of any matrix A needs no word of what A is.

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

from gainproof.verify.judge.matrices.certificate import accepted
from gainproof.verify.judge.matrices.exact_instance import NoValueError, Unsupported
from gainproof.verify.judge.matrices.ideal_membership import MOST_PRODUCTS, Budget, UnprovedError
from gainproof.verify.judge.matrices.letters import MatrixSetting
from gainproof.verify.judge.matrices.polynomial import TooLongError
from gainproof.verify.judge.matrices.proof import Question, links, proof_of
from gainproof.verify.judge.matrices.random_instances import holds, instances
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.tree import Chain, Node
from gainproof.verify.judge.matrices.used_definitions import (
    inverted,
    is_block,
    is_random,
    names_in,
    within,
)

MOST_DEEP = 3
"""Lemmas for lemmas."""
FEW_PRODUCTS = 300
"""Where premises did not suffice, all definitions opened are no likelier to."""
FAILURES = (UnprovedError, TooLongError, Unsupported, NoValueError)
FEW_TRIES, FEW_INSTANCES = 9, 2
"""To see that what is left of a claim, definitions closed, is false."""
Closing = dict[str, Node | None]
"""What takes the place of definitions; nothing where a letter is closed."""


@dataclass(frozen=True)
class Proof:
    """Certificates, lemmas first, and what was shown of closed letters on the way; `claim`: the id
    of the claim that is proved, none where it is proved under hypotheses of another.
    """

    certificates: list[dict[str, Any]]
    facts: tuple[Chain, ...]
    claim: str


Proofs = dict[Any, Proof | str]
"""Of claims by their whole content, or why there is none: premises are proved once."""


def proof_in(
    setting: MatrixSetting, question: Question, proofs: Proofs, budget: Budget | None = None
) -> Proof:
    """The proof of a question on its own, whatever was proved before; premises have budgets of
    their own. Raises UnprovedError.
    """
    own = within(question.nodes(), setting)
    key = (tuple(own.sizes.names.items()), tuple(own.letters.items()), question)
    if key not in proofs:
        layers = Layers(own, proofs, budget or Budget())
        try:
            certificates = layers.prove(question)
            proofs[key] = Proof(certificates, layers.facts_of(question), question.claim)
        except UnprovedError as reason:
            if budget is not None:
                raise  # perhaps for want of what others have spent
            proofs[key] = str(reason)
    found = proofs[key]
    if isinstance(found, str):
        raise UnprovedError(found)
    return found


@dataclass
class Layers:
    """Proofs in one setting; what was proved once, or was not, is kept."""

    setting: MatrixSetting
    proofs: Proofs
    budget: Budget
    _known: dict[Question, list[dict[str, Any]] | str] = field(default_factory=dict)
    _facts: dict[Question, list[Chain]] = field(default_factory=dict)
    _asked: set[Question] = field(default_factory=set)

    def facts_of(self, question: Question) -> tuple[Chain, ...]:
        """What was shown of closed letters for a question that was proved."""
        return tuple(self._facts.get(replace(question, hints=()), ()))

    def prove(self, question: Question, deep: int = 0) -> list[dict[str, Any]]:
        """Certificates, lemmas first. Raises UnprovedError, also where a question comes up again on
        the way to its own proof: that is none then, and as a claim has finitely many it ends.
        """
        bare = replace(question, hints=())
        if bare in self._asked:
            raise UnprovedError("the proof would rest on itself")
        before = self._under_less(bare)
        if before is not None:
            return before
        if bare not in self._known or question.hints:
            self._asked.add(bare)
            try:
                self._known[bare] = self._proved(question, deep)
            except UnprovedError as reason:
                if deep == 0:
                    raise
                self._known[bare] = str(reason)
            finally:
                self._asked.remove(bare)
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
                and supposes_no_more(other, question)
            ):
                return found
        return None

    def _proved(self, question: Question, deep: int) -> list[dict[str, Any]]:
        """Multiplied out, if it is the same on both sides; where premises or equations are said to
        be needed, that is tried last.
        """
        if not question.premises and not any("=" in c.operators for c in question.given):
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
            bare = replace(question, premises=())
            certificate, fault = accepted(proof_of(bare, self.setting, 0, self.budget))
        except FAILURES:
            return None
        return [certificate] if fault is None else None

    def _by_layers(self, question: Question, deep: int) -> list[dict[str, Any]]:
        reasons: list[str] = []
        lemmas, given, invertible, known = self._of_premises(question, deep)
        for closed in closings(question, self.setting):
            setting = with_closed(self.setting, closed)
            try:
                more, facts, inverses = self._of_letters(question, closed, deep, given, known)
                asked = replace(
                    question,
                    given=(*question.given, *given, *facts),
                    invertible=(*question.invertible, *invertible, *inverses),
                    premises=(),
                )
                if closed and fails(asked, setting):
                    reasons.append("what is left of it is not true")
                    continue
                most = MOST_PRODUCTS if closed or not question.premises else FEW_PRODUCTS
                # of a letter without its definition the statement is another
                rests = bool(closed or given or facts or invertible or inverses)
                proof = proof_of(asked, setting, most, self.budget)
                certificate, fault = accepted(proof, rests)
                if fault is None:
                    hidden = self._of_hidden(question, setting, deep, given, invertible)
                    definite = [c for c in given if c.operators in ((">",), ("<",))]
                    self._facts[replace(question, hints=())] = [*facts, *definite]
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
            if not supposes_no_more(premise, now):
                supposed = replace(now, chains=premise.given, existing=premise.invertible)
                lemmas += self.prove(supposed, deep + 1)
            try:
                found = proof_in(self.setting, premise, self.proofs)
            except UnprovedError:
                here = replace(
                    premise, given=question.given, invertible=question.invertible, claim=""
                )
                if here == premise or not supposes_no_more(premise, question):
                    raise
                found = proof_in(self.setting, here, self.proofs)
            lemmas += found.certificates
            facts += found.facts
            given += premise.chains
            inverses += premise.existing
        return lemmas, given, inverses, facts

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
        facts = [c for c in dict.fromkeys(shown) if closed and set(c.sides) & set(wanted)]
        if not closed or deep >= MOST_DEEP:
            return lemmas, facts, inverses
        setting = with_closed(self.setting, closed)
        under = inverted(question.nodes(), setting)
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
                definite = positive(node, setting)
                asked = Question((definite,), given, question.invertible)
                if is_given(definite, given) or question.chains == (definite,):
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
            if node in under:
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
        met = {*inverted(question.nodes(), setting), *question.invertible, *invertible}
        lemmas: list[dict[str, Any]] = []
        for node in inverted(question.nodes(), self.setting):
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
        setting = with_closed(self.setting, closed)
        names = sorted(name for name in names_in(question.nodes(), setting) if name in closed)
        diagonal = [
            Node("name", name=name)
            for name in names
            if is_block(letters[name].definition)  # type: ignore[arg-type]
            and letters[name].shape[0] == letters[name].shape[1]
            and letters[name].definition.parts[0].parts[0] == letters[name].definition.parts[2]  # type: ignore[union-attr]
        ]
        return list(dict.fromkeys([*diagonal, *inverted(question.nodes(), setting)]))


def supposes_no_more(premise: Question, question: Question) -> bool:
    """Whether all that one question supposes is supposed by the other."""
    return set(premise.given) <= set(question.given) and (
        set(premise.invertible) <= set(question.invertible)
    )


def fails(question: Question, setting: MatrixSetting) -> bool:
    """Whether a closed question is false at one of few instances: no proof is looked for then."""
    if any(part.kind == "expectation" for node in question.nodes() for part in node.walk()):
        return False  # means take longer than the proof
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


def is_given(definite: Chain, given: Sequence[Chain]) -> bool:
    """Whether X > 0 is among the hypotheses, also as 0 < X."""
    return definite in given or Chain(definite.sides[::-1], ("<",)) in given


def positive(node: Node, setting: MatrixSetting) -> Chain:
    """The matrix is positive definite."""
    shape = Shapes(setting.letters, setting.sizes).of(node)
    return Chain((node, Node("zero", shape=shape)), (">",))


def closings(question: Question, setting: MatrixSetting) -> Iterator[Closing]:
    """What definitions become: with premises a letter what one of them says it is, and all others
    closed, or all but such as only pick rows; then those of blocks closed; then none.
    """
    letters = setting.letters
    # what depends on a random vector is not any matrix to a mean
    defined = {
        name: letter.definition
        for name, letter in letters.items()
        if letter.definition is not None and not is_random(name, setting)
    }
    picks = {name for name, node in defined.items() if is_block(node)}
    blocks = {n for n, node in defined.items() if node.kind == "matrix" and not _selects(node)}
    ways: list[Closing] = [dict.fromkeys(blocks | picks), {}]
    if question.premises:
        small = {n for n, node in defined.items() if node.kind == "matrix" and _selects(node)}
        said = _said(question, setting)
        every = {**dict.fromkeys(defined), **said}
        # an equation may follow from others word by word, an order rests on what is picked
        equations = all(chain.operators == ("=",) for chain in question.chains)
        ways.insert(0, {name: node for name, node in every.items() if name not in small})
        if said and equations:
            ways.insert(0, every)
    seen: list[Closing] = []
    for way in ways:
        reached = set(names_in(question.nodes(), with_closed(setting, way)))
        used = {name: node for name, node in way.items() if name in reached}
        if used not in seen:
            seen.append(used)
            yield used


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
                    and own.name not in names_in((other,), with_closed(setting, found))
                ):
                    found[own.name] = other
                    break
    return found


def with_closed(setting: MatrixSetting, closed: Closing) -> MatrixSetting:
    """The setting with definitions replaced."""
    letters = {
        name: replace(letter, definition=closed[name]) if name in closed else letter
        for name, letter in setting.letters.items()
    }
    return MatrixSetting(setting.sizes, letters)
