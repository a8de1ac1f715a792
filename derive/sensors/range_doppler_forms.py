"""Range, range rate and their derivatives in forms that take anything with + - * /.

SymPy's symbols, where they are proved, and the nodes of graphs, from which kernels are printed.
Everything is a unit vector, a velocity or 1 over the range, to its first or second power: no power
of a length stands anywhere, so that nothing overflows where the result does not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

Vector = Sequence[Any]


@dataclass(frozen=True)
class Sight:
    """A target as seen from a station: range f, unit vector u to it, its velocity w and its
    place r relative to the station.
    """

    range: Any
    unit: Vector
    velocity: Vector
    place: Vector = ()

    @property
    def rate(self) -> Any:
        """u'w."""
        return dot(self.unit, self.velocity)

    @property
    def turning(self) -> list[Any]:
        """h = (w - u u'w)/f, at which u changes; the range rate's derivative by the position."""
        rate = self.rate
        return [(w - rate * u) / self.range for u, w in zip(self.unit, self.velocity, strict=True)]


def dot(one: Vector, other: Vector) -> Any:
    """The inner product, from the first entries on."""
    total, *others = (a * b for a, b in zip(one, other, strict=True))
    for each in others:
        total = total + each
    return total


def differences(one: Vector, other: Vector) -> list[Any]:
    """Entry by entry."""
    return [a - b for a, b in zip(one, other, strict=True)]


def across(unit: Vector) -> dict[tuple[int, int], Any]:
    """P = I - u u' by the places of its entries, upper half; on the diagonal 1 - u_i^2 as the sum
    of the other squares, which does not cancel.
    """
    count = range(len(unit))
    found: dict[tuple[int, int], Any] = {}
    for i in count:
        others = [unit[j] for j in count if j != i]
        for j in count[i:]:
            found[i, j] = dot(others, others) if i == j else -(unit[i] * unit[j])
    return found


def bending(sight: Sight) -> dict[tuple[int, int], Any]:
    """M = -(u h' + h u' + g P/f)/f by the places of its entries, upper half."""
    u, h = sight.unit, sight.turning
    steep, flat = sight.rate / sight.range, across(sight.unit)
    found: dict[tuple[int, int], Any] = {}
    for (i, j), p in flat.items():
        turned = 2 * (u[i] * h[i]) if i == j else u[i] * h[j] + u[j] * h[i]
        found[i, j] = -(turned + steep * p) / sight.range
    return found
