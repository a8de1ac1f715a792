"""A certificate as goals: equalities and signs over a tower, each a statement of algebra.

Nothing is decided here, and nothing of the checker is used: what a goal says is read off the claim,
what helps to prove it off the evidence.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gainproof.certify.expression import Tree


@dataclass(frozen=True)
class Relation:
    """The positive number `symbol` with symbol^power = radicand."""

    symbol: str
    power: int
    radicand: Tree


@dataclass(frozen=True)
class Tower:
    """Positive parameters; those `shifted` are at least the number given. Elements by name."""

    parameters: tuple[str, ...]
    shifted: Mapping[str, str]
    relations: tuple[Relation, ...]
    elements: Mapping[str, Tree]

    @property
    def names(self) -> tuple[str, ...]:
        """All variables in order: parameters, then generators."""
        return (*self.parameters, *(relation.symbol for relation in self.relations))


@dataclass(frozen=True)
class Goal:
    """`left` = `right` at every point; `positive`: left > 0, since right is manifestly positive.

    `free` are names that stand for any real numbers; `nonzero` are positive numbers to which, or
    to whose negative, a divisor is equal.
    """

    left: Tree
    right: Tree
    positive: bool = False
    free: tuple[str, ...] = ()
    nonzero: tuple[Tree, ...] = ()


@dataclass(frozen=True)
class Statement:
    """One statement and its goals, in the order in which they may be used; or why it has none."""

    id: str
    kind: str
    tower: str
    goals: tuple[Goal, ...] = ()
    left_out: str = ""
