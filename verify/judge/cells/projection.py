"""Projection of polynomials, one variable at a time, so far as open cells need it.

Where no leading coefficient, discriminant, pairwise resultant or value at a face of the box is
zero, the real roots in the last variable are simple, distinct, inside or outside the box for good,
and never run off to infinity: over a connected open set they are graphs of continuous functions in
a fixed order. Nothing more is needed for open cells (McCallum 1993, Strzebonski 2000).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from gainproof.verify.judge.cells.coefficient_signs import keeps_sign
from gainproof.verify.judge.cells.parameter_polynomials import irreducible, leading, put_in
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.polynomial import Poly, degree
from gainproof.verify.judge.exact.work_limits import Limits, Undecided


@dataclass(frozen=True)
class Level:
    """A variable (its position) and the polynomials in it and in the variables of levels before."""

    index: int
    polys: tuple[Poly, ...]


@dataclass(frozen=True)
class Projection:
    """Levels from the first variable that gets a value to the last; `dropped` keep one sign."""

    levels: tuple[Level, ...]
    dropped: tuple[Poly, ...]


def projected(
    factors: Sequence[Poly], boxes: Sequence[Box], limits: Limits, base: int | None = None
) -> Projection:
    """All levels for irreducible factors; `base` is the variable that gets its value first, if that
    matters. Raises Undecided where polynomials grow too large.
    """
    left = set(range(len(boxes)))
    dropped: dict[str, Poly] = {}
    kept = _without_constant_sign(factors, boxes, dropped)
    levels: list[Level] = []
    while left:
        index = _next_variable(kept, left - {base} or left)
        left.discard(index)
        here = [p for p in kept if degree(p, index) > 0]
        levels.append(Level(index, tuple(here)))
        below = [p for p in kept if degree(p, index) <= 0]
        made = irreducible([*below, *_projections(here, index, boxes[index], limits)])
        if len(made) > limits.projection_factors:
            raise Undecided(f"a projection of more than {limits.projection_factors} polynomials")
        kept = _without_constant_sign(made, boxes, dropped)
    return Projection(tuple(reversed(levels)), tuple(dropped.values()))


def _without_constant_sign(
    polys: Sequence[Poly], boxes: Sequence[Box], dropped: dict[str, Poly]
) -> list[Poly]:
    kept = []
    for p in polys:
        if keeps_sign(p, boxes, closed=False):
            dropped[str(p)] = p
        else:
            kept.append(p)
    return kept


def _next_variable(polys: Sequence[Poly], left: set[int]) -> int:
    """The variable that is eliminated first: of lowest degree, in the fewest terms."""

    def cost(index: int) -> tuple[int, int, int]:
        degrees = [degree(p, index) for p in polys]
        return max(degrees, default=0), sum(1 for d in degrees if d > 0), index

    return min(left, key=cost)


def _projections(polys: Sequence[Poly], index: int, box: Box, limits: Limits) -> list[Poly]:
    return [
        *[leading(p, index) for p in polys],
        *[value for p in polys for value in face_values(p, index, box)],
        *discriminants(polys, index, limits),
        *resultants(polys, index, limits),
    ]


def discriminants(polys: Sequence[Poly], index: int, limits: Limits) -> list[Poly]:
    """Where none is zero no roots of one polynomial meet. Raises Undecided."""
    bent = [p for p in polys if degree(p, index) > 1]
    for p in bent:
        _bounded(p, p, limits)
    return [p.discriminant(index) for p in bent]


def resultants(polys: Sequence[Poly], index: int, limits: Limits) -> list[Poly]:
    """Where none is zero no roots of two polynomials meet. Raises Undecided."""
    for p, q in combinations(polys, 2):
        _bounded(p, q, limits)
    return [p.resultant(q, index) for p, q in combinations(polys, 2)]


def face_values(p: Poly, index: int, box: Box) -> list[Poly]:
    """The polynomial on the faces of the box: where it is not zero no root crosses a face."""
    name = p.context().names()[index]
    faces = [face for face in (box.lower, box.upper) if face is not None]
    return [put_in(p, name, face) for face in faces]


def _bounded(p: Poly, q: Poly, limits: Limits) -> None:
    """Resultants have up to this total degree, by Bezout."""
    if int(p.total_degree()) * int(q.total_degree()) > limits.projection_degree:
        raise Undecided(f"a projection of degree more than {limits.projection_degree}")
