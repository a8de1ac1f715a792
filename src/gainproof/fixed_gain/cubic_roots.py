"""Roots of real cubics over arrays, in numbers of twice the precision.

t^3 + a t^2 + b t + c, none of |a|, |b|^(1/2) and |c|^(1/3) above 1. With W = 3 t + a it is
W^3 = 3 P W + 2 Q, P = a^2 - 3 b and 2 Q = 9 a b - 2 a^3 - 27 c; the root farthest from the mean of
all, on the side of Q, is real and apart from the others, so that two steps by Newton settle it. The
others are those of the quadratic that is left, whose coefficients come from the side that loses
less (Peters and Wilkinson 1971). No error is bounded here: what roots found in any way are worth is
the business of `cubic_discs`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.fixed_gain.twofold import Twofold

THIRD = Twofold(np.array(1 / 3), np.array(2.0**-54 / 3))
NEWTON = 2
"""Steps, each of which finds 50 digits of two more."""
SMALL = 2.0**-30
"""Share up to which a root moves the quotient that it is of the constant and the other two."""
LARGEST = 4.0
"""No root of a cubic of that size is larger."""


@dataclass(frozen=True, eq=False)
class Cubic:
    """t^3 + square t^2 + linear t + constant."""

    square: Twofold
    linear: Twofold
    constant: Twofold


@dataclass(frozen=True, eq=False)
class Roots:
    """One real root and two others: real, or first + i second and its conjugate."""

    single: Twofold
    real: NDArray[np.bool_]
    first: Twofold
    second: Twofold


def roots(cubic: Cubic) -> Roots:
    """All three, close to the last of twice 53 digits where they are apart."""
    single = _single(cubic)
    half, product = _quadratic(cubic, single)
    square = half * half - product
    real = square.high >= 0
    root = _root(square)
    large = -(half + Twofold.where(half.high >= 0, root, -root))
    first = Twofold.where(real, large, -half)
    second = Twofold.where(real, _quotient(product, large), root)
    return Roots(_finite(single), real, _finite(first), _finite(second))


def _single(cubic: Cubic) -> Twofold:
    """The root farthest from the mean of all."""
    a, b, c = cubic.square, cubic.linear, cubic.constant
    away = _away(cubic)
    t = (Twofold.of(away) - a) * THIRD
    for _ in range(NEWTON):
        first = t + a
        second = first * t + b
        slope = ((t + first) * t + second).high
        step = (second * t + c).high / slope
        # a longer one is noise: the roots agree to a cube root of the last digit
        t = t - Twofold.of(np.where(np.abs(step) < np.abs(away), step, 0.0))
    first = t + a
    second = first * t + b
    small = np.abs((t + first).high * t.high) < SMALL * np.abs(second.high)
    return Twofold.where(small, _quotient(-c, second), t)


def _away(cubic: Cubic) -> Reals:
    """W of that root, by Cardano or the cosine: sums without cancellation, but for P and Q."""
    a, b, c = cubic.square, cubic.linear, cubic.constant
    square = a * a
    p = (square - b * 3).high
    q = ((b * 9 - square * 2) * a - c * 27).high / 2
    size, whole = np.abs(q), q * q - p * p * p
    r = np.cbrt(size + np.sqrt(np.maximum(whole, 0.0)))
    part = p / r
    alone = np.where(p > 0, r + part, 2 * size / (r * r - p + part * part))
    width = np.sqrt(np.maximum(p, 0.0))
    turned = 2 * width * np.cos(np.arccos(np.fmin(size / (p * width), 1.0)) / 3)
    return np.asarray(np.copysign(np.where(whole > 0, alone, turned), q))


def _quadratic(cubic: Cubic, single: Twofold) -> tuple[Twofold, Twofold]:
    """Half of the linear coefficient and the constant of what is left of the cubic."""
    a, b, c = cubic.square, cubic.linear, cubic.constant
    linear = a + single
    constant = single * linear + b
    x, least = (np.abs(each.high) for each in (single, c))
    wide = np.abs(a.high) + x
    backward = _quotient(-c, single)
    constant = Twofold.where(2 * least < x * (np.abs(b.high) + x * wide), backward, constant)
    known = np.abs(b.high) + np.abs(constant.high)
    linear = Twofold.where(known < x * wide, _quotient(constant - b, single), linear)
    return linear / 2, constant


def _quotient(a: Twofold, b: Twofold) -> Twofold:
    """a/b; 0 where b is 0."""
    first = np.where(b.high == 0, 0.0, a.high / b.high)
    rest = (a - b * Twofold.of(first)).high / b.high
    return Twofold.of(first) + Twofold.of(np.where(b.high == 0, 0.0, rest))


def _root(a: Twofold) -> Twofold:
    """The root of the magnitude."""
    size = Twofold.where(a.high >= 0, a, -a)
    first = np.sqrt(size.high)
    rest = (size - Twofold.of(first) * Twofold.of(first)).high / (2 * first)
    return Twofold.of(first) + Twofold.of(np.where(first > 0, rest, 0.0))


def _finite(a: Twofold) -> Twofold:
    """0 in place of what can be no root."""
    fine = np.abs(a.high) <= LARGEST
    return Twofold(np.where(fine, a.high, 0.0), np.where(fine, a.low, 0.0))
