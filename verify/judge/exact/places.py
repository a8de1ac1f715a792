"""Places: the open intervals of the parameter between candidate points, and those points
themselves.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import ceil, floor
from typing import Any

from gainproof.verify.judge.exact.algebraic_numbers import (
    Algebraic,
    apart,
    compare,
    rational_point,
    rationals_between,
    real_roots,
)
from gainproof.verify.judge.exact.box import Box, interval_text

SAMPLES = 7


@dataclass(frozen=True)
class Place:
    """An open interval (`at` None) between two candidate points, or one point. Without parameter:
    one point, `at` None.
    """

    left: Algebraic | None = None
    right: Algebraic | None = None
    at: Algebraic | None = None
    is_cell: bool = False

    moved = ()

    @property
    def samples(self) -> tuple[Fraction, ...]:
        """Rational points of a cell, the simplest first."""
        return self._spread

    @cached_property
    def _spread(self) -> tuple[Fraction, ...]:
        if not self.is_cell:
            return ()
        low = None if self.left is None else self.left.high
        high = None if self.right is None else self.right.low
        return tuple(rationals_between(low, high, SAMPLES))

    def integers(self, count: int) -> list[int]:
        """Up to `count` integers of a cell, those nearest to zero first."""
        low = None if self.left is None else self.left
        high = None if self.right is None else self.right
        if low is not None and compare(low, Fraction(0)) >= 0:
            start = floor(low.refined(Fraction(1, 4)).low)
            run: Iterable[int] = range(start, start + count + 3)
        elif high is not None and compare(high, Fraction(0)) <= 0:
            start = ceil(high.refined(Fraction(1, 4)).high)
            run = range(start, start - count - 3, -1)
        else:
            run = sorted(range(-count, count + 1), key=abs)
        inside = [
            n
            for n in run
            if (low is None or compare(low, Fraction(n)) < 0)
            and (high is None or compare(high, Fraction(n)) > 0)
        ]
        return inside[:count]

    @property
    def holds_integer(self) -> bool:
        """Whether an integer lies in it."""
        if self.at is not None:
            return self.at.is_rational and self.at.low.denominator == 1
        return bool(self.integers(1))

    def text(self, name: str) -> str:
        """Readable."""
        if self.at is not None:
            return f"{name} = {self.at.text()}"
        if not self.is_cell:
            return "everywhere"
        ends = ("" if end is None else end.text() for end in (self.left, self.right))
        return interval_text(name, ends)


def places(factors: Iterable[Any], box: Box) -> list[Place]:
    """All places of the box, from left to right; the faces of the box are candidate points too."""
    # distinct irreducible polynomials have distinct roots
    distinct = {_sign_free(factor): factor for factor in factors}
    points = [
        r for factor in distinct.values() for r in real_roots(factor) if _strictly_inside(r, box)
    ]
    lower = None if box.lower is None else rational_point(box.lower)
    upper = None if box.upper is None else rational_point(box.upper)
    if lower is not None and upper is not None and box.lower == box.upper:
        return [Place(at=lower)]
    # the inner points must not touch the faces either, so that samples lie inside
    points = [
        p
        for p in apart([*points, *[f for f in (lower, upper) if f is not None]])
        if _strictly_inside(p, box)
    ]
    found: list[Place] = []
    if lower is not None and not box.lower_open:
        found.append(Place(at=lower))
    edges = [lower, *points, upper]
    for k, (left, right) in enumerate(pairwise(edges)):
        found.append(Place(left=left, right=right, is_cell=True))
        if k < len(points):
            found.append(Place(at=points[k]))
    if upper is not None and not box.upper_open:
        found.append(Place(at=upper))
    return found


def _sign_free(factor: Any) -> tuple[int, ...]:
    coefficients = tuple(int(c) for c in factor.coeffs())
    return coefficients if coefficients[-1] > 0 else tuple(-c for c in coefficients)


def _strictly_inside(number: Algebraic, box: Box) -> bool:
    return (box.lower is None or compare(number, box.lower) > 0) and (
        box.upper is None or compare(number, box.upper) < 0
    )
