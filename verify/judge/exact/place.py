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

from gainproof.verify.judge.exact.algebraic import (
    Algebraic,
    apart,
    compare,
    rational_point,
    rationals_between,
    real_roots,
)

SAMPLES = 7


@dataclass(frozen=True)
class Box:
    """Where a variable lives. A missing bound is infinite; `stated` says that the domain was given,
    not guessed.
    """

    lower: Fraction | None = None
    upper: Fraction | None = None
    lower_open: bool = True
    upper_open: bool = True
    integer: bool = False
    stated: bool = True

    @property
    def is_empty(self) -> bool:
        """Whether no real number (or integer, for integers) lies in it."""
        if self.lower is None or self.upper is None:
            return False
        if self.lower > self.upper or (
            self.lower == self.upper and (self.lower_open or self.upper_open)
        ):
            return True
        if not self.integer:
            return False
        return not any(self.holds(Fraction(n)) for n in (ceil(self.lower), floor(self.lower) + 1))

    @property
    def is_positive(self) -> bool:
        """Whether every number in it is greater than zero."""
        return self.lower is not None and (self.lower > 0 or (self.lower == 0 and self.lower_open))

    def holds(self, value: Fraction) -> bool:
        """Whether the number lies in it."""
        if self.lower is not None and (
            value < self.lower or (value == self.lower and self.lower_open)
        ):
            return False
        return self.upper is None or not (
            value > self.upper or (value == self.upper and self.upper_open)
        )

    def text(self, name: str) -> str:
        """Readable."""
        kind = f", {name} an integer" if self.integer else ""
        left = "" if self.lower is None else f"{self.lower} {'<' if self.lower_open else '<='} "
        right = "" if self.upper is None else f" {'<' if self.upper_open else '<='} {self.upper}"
        if not left and not right:
            return f"all real {name}" if not kind else f"all integers {name}"
        if left and not right:
            return f"{name} {'>' if self.lower_open else '>='} {self.lower}{kind}"
        return f"{left}{name}{right}{kind}"


@dataclass(frozen=True)
class Place:
    """An open interval (`at` None) between two candidate points, or one point. Without parameter:
    one point, `at` None.
    """

    left: Algebraic | None = None
    right: Algebraic | None = None
    at: Algebraic | None = None
    is_cell: bool = False

    @cached_property
    def samples(self) -> tuple[Fraction, ...]:
        """Rational points of a cell, the simplest first."""
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
        if self.left is None and self.right is None:
            return f"all real {name}"
        left = "" if self.left is None else f"{self.left.text()} < "
        right = "" if self.right is None else f" < {self.right.text()}"
        return (
            f"{name} > {self.left.text()}"
            if self.left and not self.right
            else f"{left}{name}{right}"
        )


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


def region_text(kept: list[Place], name: str, *, integer: bool = False) -> str:
    """The union of places as text: neighbouring places are joined."""
    pieces: list[list[Place]] = []
    for place in kept:
        if pieces and _adjacent(pieces[-1][-1], place, integer):
            pieces[-1].append(place)
        else:
            pieces.append([place])
    shown = _integer_text if integer else _piece_text
    return " or ".join(shown(piece, name) for piece in pieces) or "nowhere"


def _adjacent(a: Place, b: Place, integer: bool) -> bool:
    if integer:
        last, first = _ends(a)[1], _ends(b)[0]
        return last is not None and first == last + 1
    if a.is_cell:
        return b.at is not None and a.right == b.at
    return b.is_cell and a.at is not None and b.left == a.at


def _piece_text(piece: list[Place], name: str) -> str:
    if len(piece) == 1:
        return piece[0].text(name)
    first, last = piece[0], piece[-1]
    left = first.at if first.at is not None else first.left
    right = last.at if last.at is not None else last.right
    low = "<=" if first.at is not None else "<"
    high = "<=" if last.at is not None else "<"
    if left is None and right is None:
        return f"all real {name}"
    if right is None and left is not None:
        return f"{name} {'>=' if low == '<=' else '>'} {left.text()}"
    if left is None and right is not None:
        return f"{name} {high} {right.text()}"
    assert left is not None
    assert right is not None
    return f"{left.text()} {low} {name} {high} {right.text()}"


def _ends(place: Place) -> tuple[int | None, int | None]:
    """The first and the last integer of a place that holds one; None without bound."""
    if place.at is not None:
        return int(place.at.low), int(place.at.low)
    first = last = None
    if place.left is not None:
        first = floor(place.left.low)
        while compare(place.left, Fraction(first)) >= 0:
            first += 1
    if place.right is not None:
        last = ceil(place.right.high)
        while compare(place.right, Fraction(last)) <= 0:
            last -= 1
    return first, last


def _integer_text(piece: list[Place], name: str) -> str:
    first, last = _ends(piece[0])[0], _ends(piece[-1])[1]
    if first is None and last is None:
        return f"all {name}"
    if first == last:
        return f"{name} = {first}"
    if last is None:
        return f"{name} >= {first}"
    return f"{name} <= {last}" if first is None else f"{first} <= {name} <= {last}"
