"""A statement over some real parameters, and what has been put in for others."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.statement import ALLOWED, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Limits, Undecided


@dataclass(frozen=True)
class Task:
    """A statement on a box of real parameters, or on a border of one: then `solved` says what was
    put in for which symbols, first to last, and `border` which polynomials are zero there. `parts`
    are the sides of the statement before anything was put in.
    """

    statement: Statement
    boxes: Mapping[str, Box]
    solved: tuple[tuple[str, Expr], ...] = ()
    border: tuple[Expr, ...] = ()
    parts: tuple[Expr, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters, in the order of the variables."""
        return tuple(sorted(self.boxes))

    @property
    def key(self) -> frozenset[object]:
        """Equal only for tasks that are the same question."""
        kinds = (self.statement.relations, self.statement.conditions, self.statement.given)
        entries = {
            (kind, r.operator, r.left.key, r.right.key)
            for kind, rels in enumerate(kinds)
            for r in rels
        }
        needed = {expr.key for expr in self.statement.needed}
        return frozenset((*entries, *needed, *self.boxes))


class OutOfTime(Undecided):
    """The time is over: nothing else is tried."""


@dataclass
class Budget:
    """How much of the work is done, and the borders that could not be decided.

    `thorough` looks also for thin sets of truth beside cells where the statement is false.
    """

    limits: Limits
    thorough: bool = False
    cells: int = 0
    seen: set[frozenset[object]] = field(default_factory=set)
    gaps: list[tuple[Expr, str]] = field(default_factory=list)
    # processor time: a loaded machine must not change a verdict
    start: float = field(default_factory=time.process_time)

    def is_new(self, task: Task) -> bool:
        """Whether this question was not asked before. Raises Undecided if there are too many."""
        if task.key in self.seen:
            return False
        if len(self.seen) >= self.limits.borders:
            raise Undecided(f"more than {self.limits.borders} borders between cells")
        self.seen.add(task.key)
        return True

    def check_time(self) -> None:
        """Raises OutOfTime."""
        if time.process_time() - self.start > self.limits.seconds:
            raise OutOfTime(f"more than {self.limits.seconds:g} seconds over cells")

    def spend(self, count: int) -> None:
        """Counts cells. Raises Undecided if there are too many."""
        self.cells += count
        if self.cells > self.limits.cells:
            raise Undecided(f"more than {self.limits.cells} cells")


def plainly_false(rel: Rel) -> bool:
    """Whether a relation between two numbers is false."""
    left, right = constant_value(rel.left), constant_value(rel.right)
    if left is None or right is None:
        return False
    return (left > right) - (left < right) not in ALLOWED[rel.operator]
