"""Discs that hold the roots of real cubics, each with as many as it should: proved point by point.

p(t) = t^3 + a t^2 + b t + c, z_1, z_2, z_3 any numbers near its roots, q(t) the cubic with these
roots, and e(|t|) = e2 |t|^2 + e1 |t| + e0 at least |p(t) - q(t)|. Let r_i > 0 and U be the union of
the discs |t - z_i| <= r_i. If for each i, j and k being the others,

    r_i max(r_j, |z_i - z_j| - r_i) max(r_k, |z_i - z_k| - r_i) > e(|z_i| + r_i),

each connected piece of U holds as many roots of p as it has discs. For a point t of the border of U
lies on a circle i and inside no other: |t - z_j| is at least r_j and at least |z_i - z_j| - r_i. So
|q(t)| is at least the left side and |p(t) - q(t)| at most the right one, and by Rouche's theorem p
and q have equally many roots in each piece. Roots are numbered so that those of a piece have the
numbers of its discs; the disc about z_i that holds the piece then holds the i-th.

Radii are guessed, and the inequality is what proves them: about |p|/(|z_i - z_j| |z_i - z_k|) where
roots are apart, as by Smith (1970), about a square root of it at a double and a cube root at a
threefold one, as by Ostrowski. Where no guess stands, the disc of all roots (Knuth: none exceeds
twice the largest of |a|, |b|^(1/2), |c|^(1/3)) is taken.

The coefficients of q come from the z_i in numbers of twice the precision, at most 20 2^-106 of the
magnitudes of their terms off: sums err by 3, products by 7 2^-106 of themselves (Joldes, Muller and
Popescu 2017, algorithms 6 and 10), and a, b, c are taken to be known to 8 2^-106. `NOISE` is 32.
Where products underflow, they err by less than 2^-1060. Other sums, products and roots of
non-negative numbers are rounded by less than `MORE`, `np.hypot` too (libraries keep an ulp).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.fixed_gain.cubic_roots import Cubic, Roots
from gainproof.fixed_gain.twofold import Twofold

NOISE = 2.0**-101
LEAST = 2.0**-1000
MORE = 1 + 2.0**-40
LESS = 1 - 2.0**-40
ALL = 2.0
"""No root of a cubic with |a|, |b|^(1/2) and |c|^(1/3) up to 1 is larger."""

Triple = tuple[Reals, Reals, Reals]
OTHERS = ((1, 2), (2, 0), (0, 1))


def centres(found: Roots) -> tuple[tuple[Twofold, Twofold], ...]:
    """Real and imaginary parts of the three."""
    nothing = found.single * 0.0
    second = Twofold.where(found.real, found.second, found.first)
    aside = Twofold.where(found.real, nothing, found.second)
    return (found.single, nothing), (found.first, aside), (second, -aside)


def radii(cubic: Cubic, found: Roots) -> Triple:
    """Of the discs about `centres`, coefficients up to 1 in magnitude: one numbering of the roots
    puts each into its disc.
    """
    errors = _errors(cubic, found)
    places = centres(found)
    sizes = [np.hypot(x.high, y.high) * MORE for x, y in places]
    gaps = {(i, j): _distance(places[i], places[j]) for i in range(3) for j in OTHERS[i]}
    allowed = [4 * _at(errors, size) for size in sizes]
    guess = [_apart(allowed[i], *(gaps[i, j] for j in OTHERS[i])) for i in range(3)]
    together = np.cbrt(np.maximum.reduce(allowed))
    kept = [size + ALL * MORE for size in sizes]
    for tried in ([together] * 3, guess):
        stands = np.logical_and.reduce([_stands(i, tried, sizes, gaps, errors) for i in range(3)])
        kept = [np.where(stands, new, old) for new, old in zip(tried, kept, strict=True)]
    first, second, third = _merged(kept, gaps)
    return first, second, third


def _errors(cubic: Cubic, found: Roots) -> Triple:
    """e2, e1, e0: bounds of |p - q|, coefficient by coefficient."""
    x, first, second, real = found.single, found.first, found.second, found.real
    total = Twofold.where(real, first + second, first * 2)
    squares = first * first + second * second
    product = Twofold.where(real, first * second, squares)
    a, b, c = cubic.square, cubic.linear, cubic.constant
    both, whole = x * total, x * product
    return (
        _bound(a + (x + total), a, x, total),
        _bound(b - (both + product), b, both, product),
        _bound(c + whole, c, whole),
    )


def _bound(difference: Twofold, *terms: Twofold) -> Reals:
    magnitude = sum((np.abs(term.high) for term in terms), np.abs(difference.high) * 0.0)
    return (np.abs(difference.high) + NOISE * magnitude + LEAST) * MORE


def _at(errors: Triple, size: Reals) -> Reals:
    return ((errors[0] * size + errors[1]) * size + errors[2]) * MORE


def _apart(allowed: Reals, one: Reals, other: Reals) -> Reals:
    """The largest r with r max(r, one) max(r, other) up to what is allowed, or not much more."""
    far = np.maximum(one, other)
    single, double = allowed / one / other, np.sqrt(allowed / far)
    return np.fmin(np.fmin(single, double), np.cbrt(allowed))


def _stands(
    i: int,
    tried: list[Reals],
    sizes: list[Reals],
    gaps: dict[tuple[int, int], Reals],
    errors: Triple,
) -> NDArray[np.bool_]:
    """The inequality of one disc; false for NaN."""
    left = tried[i] * LESS
    for j in OTHERS[i]:
        left = left * np.maximum(tried[j], gaps[i, j] * LESS - tried[i]) * LESS
    return np.asarray(left > _at(errors, (sizes[i] + tried[i]) * MORE), np.bool_)


def _merged(kept: list[Reals], gaps: dict[tuple[int, int], Reals]) -> list[Reals]:
    """Radii about each centre that hold the piece of its disc."""
    touch = {
        pair: gap * LESS <= (kept[pair[0]] + kept[pair[1]]) * MORE for pair, gap in gaps.items()
    }
    found = []
    for i, (j, k) in enumerate(OTHERS):
        radius = kept[i]
        for one, other in ((j, k), (k, j)):
            joined = touch[i, one] | (touch[i, other] & touch[other, one])
            radius = np.maximum(radius, np.where(joined, gaps[i, one] + kept[one], 0.0) * MORE)
        found.append(radius)
    return found


def _distance(one: tuple[Twofold, Twofold], other: tuple[Twofold, Twofold]) -> Reals:
    return np.asarray(np.hypot(*((a - b).high for a, b in zip(one, other, strict=True))))
