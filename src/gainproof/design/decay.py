"""How far the largest closed-loop pole is from the unit circle, where floats round it away.

Rounded poles say nothing of 1 - |z| below 2^-52 or, next to multiple poles, far above it. Here it
is enclosed by the exact test of Schur and Cohn of the gains' polynomial on smaller circles.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from fractions import Fraction

from gainproof.fixed_gain.exact_stability import schur

CLEAR = 0.99
"""Up to this modulus the poles as rounded tell it."""
ROUNDED = Fraction(1, 2**51)
"""What gains of the kernels may be off by, of themselves."""
SHARE = 0.01
"""How much of 1 - |z| that may move before it is not told."""
HALVINGS = 1100


def distance(gains: Sequence[float]) -> float | None:
    """1 - |z| of the largest closed-loop pole of stable gains (two or three).

    None where it cannot be told: rounding the gains moves it by more than 1 % or makes them not
    stable.
    """
    exact = [Fraction(gain) for gain in gains]
    here = _polynomial(exact)
    least = Fraction(1, 2)
    for _ in range(HALVINGS):
        if _within(here, least):
            break
        least /= 2
    else:
        return None
    step = least
    for _ in range(46):
        step /= 2
        least += step if _within(here, least + step) else 0
    found = float(least)
    low, high = (Fraction(found * share) for share in (1 - SHARE, 1 + SHARE))
    for signs in itertools.product((-1, 1), repeat=len(exact)):
        moved = [gain * (1 + sign * ROUNDED) for gain, sign in zip(exact, signs, strict=True)]
        there = _polynomial(moved)
        if not _within(there, low) or _within(there, high):
            return None
    return found


def samples(distance: float, share: float = 0.01) -> float:
    """Samples until (1 - distance)^n is at most `share`."""
    return max(1.0, math.ceil(math.log(share) / math.log1p(-distance)))


def _polynomial(gains: Sequence[Fraction]) -> list[Fraction]:
    """det(z I - F (I - K H)), the leading coefficient first."""
    if len(gains) == 2:
        alpha, beta = gains
        return [Fraction(1), alpha + beta - 2, 1 - alpha]
    alpha, beta, gamma = gains
    return [
        Fraction(1),
        alpha + beta + gamma / 2 - 3,
        3 - 2 * alpha - beta + gamma / 2,
        alpha - 1,
    ]


def _within(polynomial: Sequence[Fraction], less: Fraction) -> bool:
    """Whether all roots have moduli below 1 - less."""
    radius = 1 - less
    order = len(polynomial) - 1
    if radius <= 0:
        return False
    scaled = [c * radius ** (order - k) for k, c in enumerate(polynomial)]
    common = math.lcm(*(c.denominator for c in scaled))
    return schur([int(c * common) for c in scaled])
