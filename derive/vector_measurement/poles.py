"""Closed-loop poles: half their sum, their product, and the square of half their difference.

The poles are the roots of z^2 - 2 a z + 1/sigma^2 with a = (eta - Lambda w)/(4 sigma). As eta^2 is
(Lambda w)^2 + 16 + 4 b, b being the linear coefficient of the spectrum in v,

    a = (4 + b)/(2 m sigma),  a^2 - 1/sigma^2 = (b^2 - 4 (Lambda w)^2)/(2 delta sigma)^2,

b = Lambda^2 (1/S^2 - f) with f = (1 - e)/4, and b^2 - 4 (Lambda w)^2 is
Lambda^2 ((Lambda (1/S^2 - g))^2 - 4 r^2) with g = f + 2 d and r^2 = 1 + d (d + f) Lambda^2. So the
poles turn real where 1/S^2 = g -+ 2 r/Lambda. Both differences in S are written as products of a
sum with a difference between S and a constant, which is one rounding.

Every function works on SymPy symbols and on graph nodes; differences are left to the caller.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gainproof.derive.vector_measurement.forms import Basis
from gainproof.derive.vector_measurement.process_noise import Noise, times, total

Parts = tuple[Any, Any]
"""Two terms: the quantity is the first less the second, or their sum where it is said."""


def slope(noise: Noise) -> Fraction:
    """f = (1 - e)/4, what b/Lambda^2 falls by with the process noise."""
    return (1 - noise.e) / 4


def centre(noise: Noise) -> Fraction:
    """g = f + 2 d, the middle of the values of 1/S^2 between which the poles are complex."""
    return slope(noise) + 2 * noise.determinant


def spread(noise: Noise) -> Fraction:
    """d (d + f) in r^2 = 1 + d (d + f) Lambda^2."""
    return noise.determinant * (noise.determinant + slope(noise))


def spread_squared(noise: Noise, index: Any) -> Any:
    """r^2; None where r is 1."""
    found = spread(noise)
    return times(found, index * index) + 1 if found else None


def half_sum_parts(x: Basis, place: Any) -> Parts:
    """a in two terms, the second positive for S beyond `place`, 1/sqrt(f).

    For e = 1 `place` is not used, both terms are positive and a is their sum.
    """
    both = x.index * x.width + x.eta_scaled
    first = ((x.ratio / both) * x.ratio) * (4 / x.sigma_scaled)
    own = (x.index / both) * (x.index / x.sigma_scaled)
    if x.noise.e == 1:
        return first, own
    return first, own * times(slope(x.noise), (x.ratio - place) * (x.ratio + place))


def discriminant_parts(x: Basis, place: Any) -> Parts:
    """a^2 - 1/sigma^2 in two squares; `place` is 1/sqrt(g), unused where g is 0."""
    rate = x.index / (x.delta_scaled * x.sigma_scaled * 2)
    near = x.index * rate
    if centre(x.noise):
        near = near * times(centre(x.noise), (x.ratio - place) * (x.ratio + place))
    far = (x.ratio * rate) * (x.ratio * 2)
    squared = spread_squared(x.noise, x.index)
    return near * near, far * far if squared is None else (far * squared) * far


def modulus(x: Basis) -> Any:
    """1/sigma, the geometric mean of both moduli."""
    return x.ratio / x.sigma_scaled


def positive_from(noise: Noise, index: Any, spread_root: Any) -> Any:
    """g + 2 r/Lambda, the 1/S^2 from which on both poles are real and positive."""
    return total(centre(noise) or None, spread_root * 2 / index)


def negative_up_to(noise: Noise, index: Any, limit: Any, positive: Any) -> Any:
    """g - 2 r/Lambda, the 1/S^2 up to which both poles are real and negative.

    (g Lambda)^2 - 4 r^2 is (f Lambda)^2 - 4, and `limit` 2/f; `positive` is g + 2 r/Lambda.
    """
    more = ((index + limit) / index) * ((index - limit) / index)
    return times(slope(noise) * slope(noise), more) / positive
