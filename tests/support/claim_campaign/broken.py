"""Broken claims: a relation, the polynomial, or a condition of the domain mutated, a fifth of them
near misses.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import permutations
from random import Random
from typing import Any

from mutation.mutants import misprints, near_misses, sample
from mutation.tree import Tree, number, symbols, to_graph, to_tree

from claim_campaign.subject import Subject, calls, rel
from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.formula import Relation as Printed
from gainproof.verify.judge.kinds.location import LOCATIONS
from gainproof.verify.judge.kinds.stability import SENSES

SPARE = 2
"""So many times more mutants are made than wanted: some are true, or have no value to compare."""
BOUNDED = ("inequality", "location", "monotone", "stability")
"""Kinds of claims that mostly hold on their domain only."""

Made = tuple[str, bool, Claim]
"""What was done, whether it is a near miss, the claim."""


@dataclass(frozen=True)
class Mutant:
    """A subject whose claim was changed; `words` say how."""

    subject: Subject
    words: str
    near: bool

    @property
    def claim(self) -> Claim:
        """The changed claim."""
        return self.subject.claim


def mutants(subject: Subject, count: int, random: Random) -> Iterator[Mutant]:
    """More than `count` mutants where there are so many, near misses and others as one to four."""
    close: list[Mutant] = []
    plain: list[Mutant] = []
    made = [*_relations(subject, count * SPARE, random), *_polynomials(subject), *_domains(subject)]
    made += [*_senses(subject), *_orders(subject)]
    for words, near, claim in made:
        one = Mutant(replace(subject, claim=claim), words, near)
        (close if near else plain).append(one)
    random.shuffle(close)
    random.shuffle(plain)
    while close or plain:
        yield from [group.pop() for group in (close, plain, plain, plain, plain) if group]


def _relations(subject: Subject, count: int, random: Random) -> Iterator[Made]:
    if subject.claim.formula is None:
        return
    (reading,) = subject.claim.formula.readings
    for place, relation in enumerate(reading.relations):
        if "infinity" in symbols(to_tree(relation.right)):
            continue  # what tends to infinity still does when it is changed a little
        left, right = to_tree(relation.left), to_tree(relation.right)
        if subject.claim.kind == "value":
            made = _values(relation)
        else:
            scalars = sorted(t for t in symbols(left) | symbols(right) if _is_scalar(subject, t))
            variable = random.choice(scalars) if scalars else ""
            tried = sample(left, right, variable, count, random)
            made = iter([(words, near, _sides(relation, a, b)) for words, near, a, b in tried])
        for words, near, changed in made:
            yield words, near, _with(subject.claim, reading, place, changed)


def _values(relation: Printed) -> Iterator[tuple[str, bool, Printed]]:
    """The exact side mutated; one more or less in the last digit that is printed."""
    left, right = to_tree(relation.left), to_tree(relation.right)
    decimals = relation.left_decimals if right[0] != "number" else relation.right_decimals
    if not isinstance(decimals, int):
        return
    exact, shown = (left, right) if right[0] == "number" else (right, left)

    def turned(a: Tree, b: Tree) -> Printed:
        return _sides(relation, a, b) if exact is left else _sides(relation, b, a)

    for words, new in misprints(exact):
        yield words, False, turned(new, shown)
    if shown[0] == "number":
        for step in (1, -1, 2, -2, 3, -3, 5, -5, 10, -10):
            other = number(shown[1] + step * Fraction(10) ** -decimals)
            yield f"last digit {step:+d}", True, turned(exact, other)


def _sides(relation: Printed, left: Tree, right: Tree) -> Printed:
    return replace(relation, left=to_graph(left), right=to_graph(right))


def having(claim: Claim, name: str, **what: Any) -> Claim:
    """The claim with something else in a field of its kind."""
    changed = replace(claim.own.get(name, OwnField()), **what)
    return replace(claim, own={**claim.own, name: changed})


def _polynomials(subject: Subject) -> Iterator[Made]:
    claim = subject.claim
    if "polynomial" not in claim.own:
        return
    tree = to_tree(claim.own["polynomial"].expression)
    variable = claim.own["variable"].symbol
    for words, new in misprints(tree):
        changed = having(claim, "polynomial", expressions=(to_graph(new),))
        yield f"polynomial: {words}", False, changed
    for words, new in near_misses(tree, variable):
        if "abs" in calls(new):
            continue  # no polynomial any more
        changed = having(claim, "polynomial", expressions=(to_graph(new),))
        yield f"polynomial: {words}", True, changed
    for where in LOCATIONS:
        if "where" not in claim.own or where != claim.own["where"].word:
            yield f"roots {where}", False, having(claim, "where", word=where)


def _senses(subject: Subject) -> Iterator[Made]:
    claim = subject.claim
    if claim.kind == "stability":
        for sense in SENSES:
            if sense != claim.own["sense"].word:
                yield f"sense {sense}", False, having(claim, "sense", word=sense)


def _orders(subject: Subject) -> Iterator[Made]:
    claim = subject.claim
    ascending = claim.own["ascending"].filters if "ascending" in claim.own else ()
    for order in permutations(ascending):
        if order != ascending:
            changed = having(claim, "ascending", filters=order)
            yield f"order {', '.join(order)}", False, changed


def _domains(subject: Subject) -> Iterator[Made]:
    claim = subject.claim
    if claim.kind not in BOUNDED:
        return
    for place, printed in enumerate(claim.domain):
        rest = (*claim.domain[:place], *claim.domain[place + 1 :])
        yield "condition dropped", False, replace(claim, domain=rest)
        relation = rel(printed)
        changed = [(w, new, relation.right) for w, new in misprints(relation.left)]
        changed += [(w, relation.left, new) for w, new in misprints(relation.right)]
        for words, left, right in changed:
            other = _sides(printed, left, right)
            domain = (*claim.domain[:place], other, *claim.domain[place + 1 :])
            yield f"domain: {words}", False, replace(claim, domain=domain)


def _is_scalar(subject: Subject, token: str) -> bool:
    entry = subject.setting.symbols.get(token)
    return entry is not None and entry.shape is None


def _with(claim: Claim, reading: Reading, place: int, changed: Printed) -> Claim:
    relations = (*reading.relations[:place], changed, *reading.relations[place + 1 :])
    assert claim.formula is not None
    formula = replace(claim.formula, readings=(replace(reading, relations=relations),))
    return replace(claim, formula=formula)
