"""Prediction and update of three states in factors, without a subtraction of computed numbers.

The covariance of position, velocity and acceleration is P = U diag(d1, d2, d3) U', and U, unit
upper, is a product of three shears that are not negative:

    U = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1].

Its entries alone would not do: an update subtracts from entry 23, and what is subtracted is the
minor u12 u23 - u13 of U. The shears carry that minor, b c, as a product. Motion is such a product
itself, F = shears t/2, t, t/2, and so is every sum of what it makes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.recursion.noise import T
from gainproof.derive.recursion.polynomial import nested, times
from gainproof.derive.recursion.three_state_noise import TripleNoise

A, B, C = (sp.Symbol(name, real=True) for name in "abc")
ORDER = (T, B, A, C)


@dataclass(frozen=True)
class Triple:
    """d1, d2, d3 and the shears a, b, c."""

    first: Any
    second: Any
    third: Any
    a: Any
    b: Any
    c: Any


@dataclass(frozen=True)
class TripleUpdate:
    """What a measurement does: the new factors, the gains, the innovation's variance."""

    factors: Triple
    position_gain: Any
    velocity_gain: Any
    acceleration_gain: Any
    innovation: Any


def covariance(f: Triple) -> tuple[Any, ...]:
    """Entries 11, 12, 13, 22, 23 and 33."""
    both = f.a + f.c
    cross = both * f.second
    last = f.b * f.third
    far = f.a * last
    near = f.b * last
    return (
        f.first + both * cross + (f.a * f.b) * far,
        cross + f.b * far,
        far,
        f.second + near,
        last,
        f.third,
    )


def updated(f: Triple, measurement: Any) -> TripleUpdate:
    """The factors after a position measured with a variance."""
    both = f.a + f.c
    cross = both * f.second
    known = f.first + measurement
    more = known + both * cross
    mixed = known + f.c * cross
    far = f.a * (f.b * f.third)
    own = (f.a * f.b) * far
    innovation = more + own
    left = measurement / known
    factors = Triple(
        f.first * left,
        f.second * (known / more),
        f.third * (more / innovation),
        f.a * (measurement / mixed),
        f.b * (mixed / more),
        f.c * (left * (more / mixed)),
    )
    return TripleUpdate(
        factors,
        (f.first + both * cross + own) / innovation,
        (cross + f.b * far) / innovation,
        far / innovation,
        innovation,
    )


def strength_of(noise: TripleNoise, strength: Any, interval: Any) -> Any:
    """g3, the variance that the acceleration gains."""
    if noise.power == 0:
        return strength
    return strength * (interval if noise.power == 1 else interval * interval)


def predicted(noise: TripleNoise, f: Triple, interval: Any, strength: Any) -> Triple:
    """F P F' + Q over an interval above zero.

    Both are products of shears; of their sum d3 and row 3 are means, d2 and d1 grow by the spread
    of what is averaged, and the minor for c is a sum of products of both.
    """
    n12, n23, n13 = noise.shears
    at = {T: interval, A: f.a, B: f.b, C: f.c}

    def value(expression: Any) -> Any:
        return nested(expression, ORDER, at)

    # entries of F U, and its minor u12 u23 - u13
    u12, u23, u13, minor = (
        A + C + T,
        B + T,
        A * B + T * B + T**2 / 2,
        B * C + (A + C) * T + T**2 / 2,
    )
    v12, v23, v13 = n12 * T, n23 * T, n13 * T**2
    gained = strength_of(noise, strength, interval)
    total = f.third + gained
    share = gained / total
    gap2, gap1 = u23 - v23, u13 - v13
    far2 = value(gap2)
    spread = f.third * share
    middle = value(u12 * gap2 - gap1)
    second = _sum(f.second, _scaled(gained, noise.second * T**2, value), spread * (far2 * far2))
    row23 = _sum(value(u23) * f.third, _scaled(gained, v23, value))
    row13 = _sum(value(u13) * f.third, _scaled(gained, v13, value))
    parts = [f.second * (spread * (middle * middle))]
    if noise.second:
        own = _scaled(gained, noise.second * T**2, value)
        apart, mixed = value(u12 - v12), value(gap1 - v12 * gap2)
        parts += [f.second * (own * (apart * apart)), own * (spread * (mixed * mixed))]
    first = _sum(f.first, _scaled(gained, noise.first * T**4, value), _sum(*parts) / second)
    c2 = value(u12 * v23 - v13)
    c3 = value((u13 * v23 - u23 * v13) * gap2 + noise.second * T**2 * (u23 * v12 - u13))
    last = value(noise.second * T**2 * (n12 * n23 - n13) * T**2)
    inner = _sum(value(minor) * f.third, None if c2 is None else c2 * gained)
    outer = _sum(None if c3 is None else f.third * c3, None if last is None else gained * last)
    whole = _sum(f.second * inner, None if outer is None else gained * outer)
    return Triple(first, second, total, row13 / row23, row23 / total, whole / (second * row23))


def _scaled(gained: Any, expression: Any, value: Any) -> Any:
    """gained times a polynomial of the interval; None for zero."""
    found = value(expression)
    return None if found is None else times(gained, found)


def _sum(*terms: Any) -> Any:
    """The sum of what there is; None for nothing."""
    result = None
    for term in terms:
        if term is not None:
            result = term if result is None else result + term
    return result
