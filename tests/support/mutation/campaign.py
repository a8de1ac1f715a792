"""Mutants of relations, judged; every mutant that the evaluator finds false must be refuted."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from gainproof.verify.judge.verdict import Finding
from mutation.arithmetic import Misshapen, NoValue, differ
from mutation.evaluator import Subject
from mutation.mutants import sample
from mutation.tree import Tree

INDEX_POINTS = tuple(Fraction(t) for t in ("1/1000", "1/7", "1", "5/2", "17/3", "50", "3000"))
SAMPLE_POINTS = tuple(Fraction(k) for k in (3, 4, 5, 7, 12, 50, 1001))
REFUSED = ("refuted", "conditional")


@dataclass(frozen=True)
class Relation:
    """A true relation, the subjects in all of which a mutant must be false, and its judge."""

    name: str
    left: Tree
    right: Tree
    variable: str
    subjects: tuple[Subject, ...]
    points: Sequence[Fraction]
    judge: Callable[[Tree, Tree], Finding]


@dataclass(frozen=True)
class Result:
    """One mutant that the evaluator found false."""

    relation: str
    name: str
    near: bool
    verdict: str
    reason: str
    first_point: bool


def is_false(relation: Relation, left: Tree, right: Tree) -> bool:
    """Whether under every subject the sides differ at some point, or one of them alone has a value
    there.
    """
    try:
        return all(
            _false_for(subject, relation.points, left, right) for subject in relation.subjects
        )
    except Misshapen:
        return False


def _false_for(subject: Subject, points: Iterable[Fraction], left: Tree, right: Tree) -> bool:
    for point in points:
        values = []
        for side in (left, right):
            try:
                values.append(subject.value(side, point))
            except NoValue:
                values.append(None)
        if values[0] is None or values[1] is None or differ(values[0], values[1]):
            return True
    return False


def run(relations: Iterable[Relation], count: int, seed: int) -> list[Result]:
    """Judges `count` mutants of each relation; those that the evaluator cannot tell from true ones
    are left out.
    """
    return [result for relation in relations for result in mutants_of(relation, count, seed)]


def mutants_of(relation: Relation, count: int, seed: int) -> list[Result]:
    """The same of one relation; its mutants do not depend on the others."""
    random = Random(f"{seed} {relation.name}")
    tried = sample(relation.left, relation.right, relation.variable, count, random)
    found = []
    for name, near, left, right in tried:
        if is_false(relation, left, right):
            finding = relation.judge(left, right)
            first = finding.reach == 1
            found.append(Result(relation.name, name, near, finding.verdict, finding.reason, first))
    return found


def report(results: Sequence[Result]) -> str:
    """The score, and every survivor by name."""
    refused = [r for r in results if r.verdict in REFUSED]
    accepted = [r for r in results if r.verdict == "proved"]
    others = [r for r in results if r.verdict not in (*REFUSED, "proved")]
    near = [r for r in results if r.near]
    first = sum(r.first_point for r in refused)
    lines = [
        f"false mutants: {len(results)}, of them near misses {len(near)}",
        f"refused with a counterexample: {len(refused)}, {first} of them at the first point",
        f"false accepts: {len(accepted)}",
        f"undecided: {len(others)}",
    ]
    lines += [f"  ACCEPTED {r.relation}: {r.name}" for r in accepted]
    lines += [f"  undecided {r.relation}: {r.name}: {r.reason}" for r in others]
    return "\n".join(lines)
