"""Broken claims: one relation of a claim mutated, a fifth of them near misses."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from random import Random

from mutation.mutants import sample
from mutation.tree import symbols, to_graph, to_tree

from claim_campaign.subject import Subject
from gainproof.verify.judge.claim_record import Claim
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.formula import Relation as Printed

SPARE = 2
"""So many times more mutants are made than wanted: some are true, or have no value to compare."""


@dataclass(frozen=True)
class Mutant:
    """A claim with one relation changed; `words` say how."""

    subject: Subject
    words: str
    near: bool

    @property
    def claim(self) -> Claim:
        """The changed claim."""
        return self.subject.claim


def mutants(subject: Subject, count: int, random: Random) -> Iterator[Mutant]:
    """More than `count` mutants, near misses and others in turn as one to four."""
    close: list[Mutant] = []
    plain: list[Mutant] = []
    for name, near, claim in _all(subject, count * SPARE, random):
        made = Mutant(replace(subject, claim=claim), name, near)
        (close if near else plain).append(made)
    random.shuffle(close)
    random.shuffle(plain)
    while close or plain:
        yield from (group.pop() for group in (close, plain, plain, plain, plain) if group)


def _all(subject: Subject, count: int, random: Random) -> Iterator[tuple[str, bool, Claim]]:
    assert subject.claim.formula is not None
    (reading,) = subject.claim.formula.readings
    for place, relation in enumerate(reading.relations):
        if relation.operator == "->" and ["symbol", "infinity"] in map(
            list, relation.right["nodes"]
        ):
            continue  # what tends to infinity still does when it is changed a little
        left, right = to_tree(relation.left), to_tree(relation.right)
        scalars = sorted(t for t in symbols(left) | symbols(right) if _is_scalar(subject, t))
        if not scalars:
            continue
        for name, near, a, b in sample(left, right, random.choice(scalars), count, random):
            changed = Printed(relation.operator, to_graph(a), to_graph(b))
            yield name, near, _with(subject.claim, reading, place, changed)


def _is_scalar(subject: Subject, token: str) -> bool:
    entry = subject.setting.symbols.get(token)
    return entry is not None and entry.shape is None


def _with(claim: Claim, reading: Reading, place: int, changed: Printed) -> Claim:
    relations = (*reading.relations[:place], changed, *reading.relations[place + 1 :])
    assert claim.formula is not None
    formula = replace(claim.formula, readings=(replace(reading, relations=relations),))
    return replace(claim, formula=formula)
