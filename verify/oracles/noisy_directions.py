"""Means of cosines and sines of angles with noise, and of their products, in balls.

Independent as `converted` says, whose parts these are: an angle is a point of the unit circle,
noise turns it, and what is averaged over the nodes is a coordinate of it or a product of two.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import flint

from gainproof.verify.oracles import polar_enclosure

Ball = flint.arb
Number = float | Fraction | Ball
Vector = list[Ball]
Matrix = list[Vector]
Noise = list[tuple[Ball, Ball]]
ZERO = flint.arb(0)


@dataclass(frozen=True)
class Turned:
    """Means of cosine, sine, their squares and their product."""

    cos: Ball
    sin: Ball
    cos2: Ball
    sin2: Ball
    both: Ball


@dataclass(frozen=True)
class Nested:
    """Means, given the measurement, of the true direction (`mean`), of it with noise once more
    (`raw`), and of the means given the truth, their squares and their product (`of_means`).
    """

    mean: Turned
    raw: Turned
    of_means: Turned


def place_of_means(r: Ball, up: Turned, around: Turned) -> Vector:
    """Means of x, y, z."""
    return [r * up.cos * around.cos, r * up.cos * around.sin, r * up.sin]


def products(square: Ball, up: Turned, around: Turned) -> Matrix:
    """Means of products of x, y, z."""
    xy = square * up.cos2 * around.both
    xz, yz = square * up.both * around.cos, square * up.both * around.sin
    return [
        [square * up.cos2 * around.cos2, xy, xz],
        [xy, square * up.cos2 * around.sin2, yz],
        [xz, yz, square * up.sin2],
    ]


def turned(direction: flint.acb, noise: Noise, sign: int) -> Turned:
    """Of a direction to which noise is added (`sign` 1) or off which it is taken (-1)."""
    total = [ZERO] * 5
    for n, w in noise:
        total = [
            t + w * v
            for t, v in zip(total, _values(direction * direction_of(sign * n)), strict=True)
        ]
    return Turned(*total)


def _values(at: flint.acb) -> Vector:
    c, s = at.real, at.imag
    return [c, s, c * c, s * s, c * s]


def nested(direction: flint.acb, noise: Noise) -> Nested:
    """Of a measured direction."""
    turns = [(direction_of(n), w) for n, w in noise]
    raw, squares = [ZERO] * 5, [ZERO] * 5
    for back, v in turns:
        true = direction * back.conjugate()
        inner = [ZERO] * 5
        for turn, w in turns:
            inner = [t + w * x for t, x in zip(inner, _values(true * turn), strict=True)]
        c, s = inner[:2]
        raw = [t + v * x for t, x in zip(raw, inner, strict=True)]
        squares = [t + v * x for t, x in zip(squares, [c, s, c * c, s * s, c * s], strict=True)]
    return Nested(turned(direction, noise, -1), Turned(*raw), Turned(*squares))


def noises_of(deviations: Sequence[Number], count: int) -> list[Noise]:
    """Nodes and weights of the noises of range and angles; for a range 3 are exact."""
    sizes = balls(deviations)
    counts = (3, *(count if size != 0 else 1 for size in sizes[1:]))
    return [
        [(size * n, w) for n, w in polar_enclosure.nodes(each)]
        for size, each in zip(sizes, counts, strict=True)
    ]


def direction_of(angle: Ball) -> flint.acb:
    """The point of the unit circle."""
    return flint.acb(0, angle).exp()


def balls(values: Sequence[Number]) -> Vector:
    """The numbers, exactly."""
    return [
        Ball(flint.fmpq(each.numerator, each.denominator))
        if isinstance(each, Fraction)
        else Ball(each)
        for each in values
    ]
