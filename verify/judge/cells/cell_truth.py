"""Connected sets, each with the truth of the statement on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gainproof.verify.judge.cells.cell_statement import Task
from gainproof.verify.judge.cells.critical_polynomials import CellQuestion
from gainproof.verify.judge.cells.projection import Projection
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.connected_sets import Connected
from gainproof.verify.judge.exact.expression import symbols_of, walk
from gainproof.verify.judge.exact.polynomial import Poly
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.tower_at_place import Local


@dataclass(frozen=True)
class Piece:
    """A connected set and the truth on it; `dimension` counts its parameters.

    `counted` is whether it matters: a formula without value counts against it only where the domain
    was stated.
    """

    task: Task
    place: Connected
    dimension: int
    truth: str
    failing: Rel | None
    local: Local
    counted: bool = True


@dataclass(frozen=True)
class Part:
    """The pieces of one task: cells, and the projection they come from; or, in one parameter, all
    places; or the arcs of a curve, each by a point, and the points between them (`sampled`).
    """

    task: Task
    pieces: tuple[Piece, ...]
    question: CellQuestion | None = None
    cuts: tuple[Poly, ...] = ()
    projection: Projection | None = None
    sampled: bool = False


def is_stated(task: Task, local: Local, stated: frozenset[str]) -> bool:
    """Whether a part that has no value holds a symbol with a stated domain.

    Its symbols are those of the part before anything was put in: on a border they may be gone.
    """
    if not stated:
        return False
    for node in walk(*task.parts):
        if symbols_of(node) & stated:
            moved = node
            for name, value in task.solved:
                moved = substituted(moved, {name: value})
            if local.is_cause(moved):
                return True
    return False


def all_pieces(found: Sequence[Part]) -> list[Piece]:
    """The pieces of all parts."""
    return [piece for part in found for piece in part.pieces]
