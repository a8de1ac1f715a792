"""The truth of a statement at every place of its one parameter.

The candidate points are the roots of the norms of every radicand, every denominator and, where a
comparison needs it, of the difference of its sides; the faces of the box are candidates too.
Between neighbouring candidates every relation is true everywhere or false everywhere, and at each
candidate it is decided exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import walk
from gainproof.verify.judge.exact.limits import Limits, Undecided
from gainproof.verify.judge.exact.local import Local
from gainproof.verify.judge.exact.norm import vanishing_factors
from gainproof.verify.judge.exact.place import Place, places
from gainproof.verify.judge.exact.poly import Poly
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.tower import Tower, build_tower

TRUE, FALSE, NO_VALUE, SKIPPED = "true", "false", "no value", "outside"


@dataclass
class Judged:
    """A place, what was found there, the tower there, and the relation that fails."""

    place: Place
    truth: str
    local: Local
    failing: Rel | None = None


class Work:
    """One tower, its boxes, and the places it is judged on."""

    def __init__(
        self,
        statement: Statement,
        boxes: Mapping[str, Box],
        parameter: str | None,
        labels: Mapping[str, str],
        limits: Limits,
    ) -> None:
        self.statement, self.boxes, self.labels = statement, boxes, labels
        free = tuple(sorted(name for name in boxes if name != parameter))
        positive = frozenset(name for name, box in boxes.items() if box.is_positive)
        self.differences = {
            rel: rel.left - rel.right for rel in (*statement.relations, *statement.conditions)
        }
        exprs = (*statement.exprs(), *self.differences.values())
        self.tower: Tower = build_tower(exprs, parameter, free, positive, limits)
        self.box = boxes[parameter] if parameter is not None else Box()
        self.factors: list[Any] = []
        self.split: set[Rel] = set()
        self.exclusions: list[str] = []
        self.inexact = False
        for check in self.tower.checks:
            self.add_factors(check.poly)
        # an equation that should hold is compared first, and splits only where it fails
        lazy = statement.relations if statement.connective == "if" else ()
        for rel in self.differences:
            if rel.operator != "=" or rel not in lazy:
                self.split_by(rel)

    def add_factors(self, p: Poly) -> None:
        """The places are cut where p may vanish."""
        known = {tuple(int(c) for c in f.coeffs()) for f in self.factors}
        self.factors += [
            f
            for f in vanishing_factors(self.tower, p)
            if tuple(int(c) for c in f.coeffs()) not in known
        ]

    def split_by(self, rel: Rel) -> None:
        """The places are cut where the sides of this relation may be equal."""
        if rel not in self.split:
            self.split.add(rel)
            self.add_factors(self.tower.element(self.differences[rel]).num)

    def split_if_possible(self, rel: Rel) -> None:
        """The same for an equation known to fail: without the cuts its points of truth stay
        unknown.
        """
        try:
            self.split_by(rel)
        except Undecided:
            self.inexact = True

    def places(self) -> list[Place]:
        """All places of the parameter's box; one place if there is no parameter."""
        return [Place()] if self.tower.parameter is None else places(self.factors, self.box)


def survey(work: Work) -> list[Judged]:
    """Every place with its truth. Raises Undecided."""
    while True:
        count = len(work.split)
        judged = []
        for place in work.places():
            if work.box.integer and work.tower.parameter is not None and not place.holds_integer:
                continue
            judged.append(_judge_place(work, place))
        if len(work.split) == count:
            return judged


def _judge_place(work: Work, place: Place) -> Judged:
    local = Local(work.tower, place)
    statement = work.statement
    if statement.connective == "if":
        for condition in statement.conditions:
            if local.undefined(condition.left, condition.right) is not None:
                return Judged(place, SKIPPED, local)
            if not _holds(work, local, condition, everywhere=False):
                return Judged(place, SKIPPED, local)
        for rel in statement.relations:
            if local.undefined(rel.left, rel.right, *statement.needed) is not None:
                return Judged(place, NO_VALUE, local, rel)
            _note_exclusions(work, local, rel)
        for rel in statement.relations:
            if not _holds(work, local, rel, everywhere=True):
                return Judged(place, FALSE, local, rel)
        return Judged(place, TRUE, local)
    if local.undefined(*statement.exprs()) is not None:
        return Judged(place, NO_VALUE, local, statement.relations[0])
    first = all(_holds(work, local, rel, everywhere=False) for rel in statement.relations)
    second = all(_holds(work, local, rel, everywhere=False) for rel in statement.conditions)
    good = first == second if statement.connective == "iff" else (second or not first)
    return Judged(place, TRUE if good else FALSE, local, None if good else statement.relations[0])


def _note_exclusions(work: Work, local: Local, rel: Rel) -> None:
    """Divisors that vanish for some values of the free symbols only."""
    below = {node.key for node in walk(rel.left, rel.right)}
    for check in work.tower.checks:
        if check.node.key not in below:
            continue
        involved = [
            n
            for n, i in zip(work.tower.free, work.tower.free_indices, strict=True)
            if check.poly.degrees()[i] > 0
        ]
        if not involved:
            continue
        try:
            local.sign(check.poly)
        except Undecided:
            index = work.tower.parameter_index
            if index is not None and check.poly.degrees()[index] > 0 and work.box.stated:
                raise Undecided("a divisor may vanish inside the stated domain") from None
            if any(work.boxes[name].stated for name in involved):
                names = ", ".join(work.labels.get(n, n) for n in involved)
                raise Undecided(f"a divisor may vanish for some values of {names}") from None
            text = f"where the divisor {_readable(work, check.poly)} is not zero"
            if text not in work.exclusions:
                work.exclusions.append(text)


def _readable(work: Work, p: Poly) -> str:
    """A polynomial in the claim's own symbols."""
    shown = str(p)
    for place, name in zip(work.tower.free_indices, work.tower.free, strict=True):
        shown = shown.replace(work.tower.names[place], work.labels.get(name, name))
    return shown


def _holds(work: Work, local: Local, rel: Rel, *, everywhere: bool) -> bool:
    """The truth of a relation at a place; `everywhere`: for all values of the free symbols.

    Otherwise (conditions) a relation that depends on the values of free symbols raises Undecided.
    """
    element = work.tower.element(work.differences[rel])
    equal = local.vanishes(element.num)
    if rel.operator == "=":
        if equal:
            return True
        if local.place.is_cell and rel not in work.split:
            # exact only once the cells are cut where the sides are equal; `survey` comes back
            work.split_if_possible(rel)
        if not everywhere and work.tower.free:
            local.sign(element.num)
        return False
    if equal:
        return rel.operator in ("<=", ">=")
    above = local.sign(element.num, strict=rel.operator not in ("<=", ">="))
    sign = above * local.sign(element.den)
    match rel.operator:
        case "<" | "<=":
            return sign < 0
        case ">" | ">=":
            return sign > 0
        case "!=":
            return True
        case _:
            raise Undecided(f"the relation {rel.operator} is not covered here")
