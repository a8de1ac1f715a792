"""The stable factor of the spectrum for three states that are a Taylor expansion of a motion.

With v = 2 - z - 1/z the spectrum is r (v^3 + index^2 (n0 + n1 v + n2 v^2)). Put z = (1 + s)/(1 - s)
and u = -s^2: then v = 4 u/(1 + u), and times (1 + u)^3 the spectrum is d(s) d(-s) with a Hurwitz
polynomial d = d3 s^3 + d2 s^2 + d1 s + d0. With X = d1/d0, Y = d2/d0, D = d3/d0 its coefficients
say X^2 = a1 + 2 Y, Y^2 = a2 + 2 D X, D^2 = 64/(n0 index^2) + e, so that all but the index is
rational in X. The noise holds the factor 1 + u; hence d holds 1 + s where the index is infinite,
which gives the least X. None of this is trusted: `steady_state` establishes what follows from it.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, sqrt, symbol
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.spectral_factor import Factor, number_root
from gainproof.verify.judge.setting.spectrum import Laurent

SHARE = "measurement noise over innovation deviation"
"""w = sqrt(1 - filter_gain.1), the parameter where the noise is in proportion to 1 - v/4."""
RATIO = "twice the second over the third filter gain"
"""X, for all other noises; it is an excess over its least value that is their parameter."""
EXCESS = f"{RATIO}, above its least value"


def three_states(rest: Laurent, noise: Laurent) -> Factor:
    """Raises Undecided for other transitions, and for an acceleration that is not driven."""
    if rest.get(3) is None or {k: v / rest[3] for k, v in rest.items()} != _cube():
        raise Undecided("a steady state with three states that are no Taylor expansion of a motion")
    r = -rest[3]
    n0, n1, n2 = (n / r for n in _in_v(noise))
    if n0 <= 0:
        raise Undecided("a steady state with three states and an acceleration that is not driven")
    if n1 == -n0 / 4 and n2 == 0:
        return _increments(r, n0)
    return _by_ratio(r, n0, n1 / n0, n2 / n0)


def _in_v(noise: Laurent) -> tuple[Fraction, Fraction, Fraction]:
    """The coefficients of 1, v and v^2."""
    c0, c1, c2 = (noise.get(k, Fraction(0)) for k in range(3))
    n2 = c2
    n1 = -(c1 + 4 * n2)
    return c0 - 2 * n1 - 6 * n2, n1, n2


def _cube() -> Laurent:
    """(z - 1)^3 (1/z - 1)^3 over its highest coefficient."""
    values = (1, -6, 15, -20, 15, -6, 1)
    return {k: Fraction(value) for k, value in zip(range(-3, 4), values, strict=True)}


def _increments(r: Fraction, n0: Fraction) -> Factor:
    """With filter gains 1 - w^2, 2 (1 - w)^2, 2 (1 - w)^3 / (1 + w) of the kinematic model the
    index is 2 (1 - w)^3 / (w (1 + w)) where the noise is 1 - v/4.
    """
    w = symbol(SHARE)
    left = 1 - w
    gains = (1 - power(w, 2), 2 * power(left, 2), 2 * power(left, 3) / (1 + w))
    a, b, c = gains
    # predictor gains of the kinematic model, then det(zI - F + L H)
    first, second, third = a + b + c / 2, b + c, c
    coefficients = (
        -1 + first - second + third / 2,
        3 - 2 * first + second + third / 2,
        first - 3,
    )
    index = 2 * power(left, 3) / mul(number_root(n0), w, 1 + w)
    box = Box(lower=Fraction(0), upper=Fraction(1))
    innovation = number(r) / power(w, 2)
    return Factor(coefficients, innovation, SHARE, box, index, power(index, 2))


def _by_ratio(r: Fraction, n0: Fraction, n1: Fraction, n2: Fraction) -> Factor:
    """For the noise n0 (1 + n1 v + n2 v^2)."""
    a1, a2 = 3 + 4 * n1, 3 + 8 * n1 + 16 * n2
    e = 1 + 4 * n1 + 16 * n2
    x = symbol(RATIO)
    y = (power(x, 2) - number(a1)) / 2
    d = (power(y, 2) - number(a2)) / (2 * x)
    total = 1 + x + y + d
    # d(s) (z + 1)^3 / (8 d(1)) at s = (z - 1)/(z + 1)
    coefficients = (
        (1 - x + y - d) / total,
        (3 - x - y + 3 * d) / total,
        (3 + x - y - 3 * d) / total,
    )
    gap = power(d, 2) - number(e)
    squared = number(64 / n0) / gap
    if e == 0:
        index: Expr = number(8) / mul(number_root(n0), d)
    else:
        index = 16 * x / mul(number_root(n0), sqrt(tidied(4 * power(x, 2) * gap)))
    return Factor(
        coefficients,
        number(r) * power(total, 2) / gap,
        EXCESS,
        Box(lower=Fraction(0)),
        index,
        squared,
        {RATIO: symbol(EXCESS) + _least(a1, e)},
    )


def _least(a1: Fraction, e: Fraction) -> Expr:
    """X where D^2 = e and Y = X - 1 + D."""
    inside = number_root(e)
    if inside.kind != "number":
        return 1 + sqrt(number(a1 - 1) + 2 * inside)
    return 1 + number_root(a1 - 1 + 2 * inside.fraction)
