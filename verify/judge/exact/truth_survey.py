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
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.norm_factors import vanishing_factors
from gainproof.verify.judge.exact.places import Place, places
from gainproof.verify.judge.exact.polynomial import Poly
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.truth import Question, truth
from gainproof.verify.judge.exact.work_limits import Limits, Undecided


@dataclass
class Judged:
    """A place, what was found there, the tower there, and the relation that fails."""

    place: Place
    truth: str
    failing: Rel | None
    local: Local


class Work(Question):
    """One tower, its boxes, and the places it is judged on."""

    def __init__(
        self,
        statement: Statement,
        boxes: Mapping[str, Box],
        parameter: str | None,
        labels: Mapping[str, str],
        limits: Limits,
    ) -> None:
        super().__init__(statement, boxes, () if parameter is None else (parameter,), limits)
        self.labels = labels
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

    def equation_fails(self, rel: Rel, local: Local) -> None:
        """Exact only once the cells are cut where the sides are equal; `survey` comes back."""
        if local.place.is_cell and rel not in self.split:
            self.split_if_possible(rel)

    def has_value(self, local: Local, *exprs: Expr) -> None:
        """Divisors that vanish for some values of the free symbols only. Raises Undecided where the
        domain of such a symbol is stated, and in an equivalence, whose other side may hold there.
        """
        below = {node.key for node in walk(*exprs)}
        for check in self.tower.checks:
            if check.node.key not in below:
                continue
            involved = [
                n
                for n, i in zip(self.tower.free, self.tower.free_indices, strict=True)
                if check.poly.degrees()[i] > 0
            ]
            if not involved:
                continue
            try:
                local.sign(check.poly)
            except Undecided:
                index = self.tower.parameter_index
                if index is not None and check.poly.degrees()[index] > 0 and self.box.stated:
                    raise Undecided("a divisor may vanish inside the stated domain") from None
                joined = self.statement.connective != "if"
                if joined or any(self.boxes[name].stated for name in involved):
                    names = ", ".join(self.labels.get(n, n) for n in involved)
                    raise Undecided(f"a divisor may vanish for some values of {names}") from None
                text = f"where the divisor {_readable(self, check.poly)} is not zero"
                if text not in self.exclusions:
                    self.exclusions.append(text)

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
            local = Local(work.tower, place)
            judged.append(Judged(place, *truth(work, local), local))
        if len(work.split) == count:
            return judged


def _readable(work: Work, p: Poly) -> str:
    """A polynomial in the claim's own symbols."""
    shown = str(p)
    for place, name in zip(work.tower.free_indices, work.tower.free, strict=True):
        shown = shown.replace(work.tower.names[place], work.labels.get(name, name))
    return shown
