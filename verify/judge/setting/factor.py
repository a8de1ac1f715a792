"""The stable factor of an innovation spectrum, in closed form for one, two and some three states.

None of this is trusted: `steady_state` establishes what follows from it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, sqrt, symbol, weighted
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.setting.environment import INDEX, POSITIVE
from gainproof.verify.judge.setting.matrix import Numbers
from gainproof.verify.judge.setting.spectrum import Laurent, at_point, spectrum

SHARE = "measurement noise over innovation deviation"
"""w = sqrt(1 - filter_gain.1), the parameter of three-state models."""


@dataclass(frozen=True)
class Factor:
    """c(z) as its coefficients from power 0 up, without the leading 1, and the innovation variance.

    Both in terms of `parameter`, which lives in `box`, and so is the tracking index.
    """

    coefficients: tuple[Expr, ...]
    innovation: Expr
    parameter: str = INDEX
    box: Box = POSITIVE
    index: Expr = field(default_factory=lambda: symbol(INDEX))


def stable_factor(f: Numbers, q: Numbers, h: Numbers, r: Fraction) -> Factor:
    """c and S with all roots of c inside the unit circle. Raises Undecided."""
    rest, noise = spectrum(f, q, h, r)
    if len(f) == 1:
        return _one_state(rest, noise)
    if len(f) == 2:
        return _two_states(rest, noise)
    if len(f) == 3:
        return _three_states(rest, noise)
    raise Undecided(f"a steady state with {len(f)} states is not covered")


def _one_state(rest: Laurent, noise: Laurent) -> Factor:
    """S (1 - p)^2 and S (1 + p)^2 are the values at 1 and -1."""
    plus, minus = _root_at(rest, noise, 1), _root_at(rest, noise, -1)
    total = plus + minus
    return Factor(((plus - minus) / total,), number(Fraction(1, 4)) * power(total, 2))


def _two_states(rest: Laurent, noise: Laurent) -> Factor:
    """S c(1)^2 and S c(-1)^2 are the values at 1 and -1, S c(0) the highest coefficient."""
    n2 = rest.get(2, Fraction(0))
    if n2 == 0 or noise.get(2, Fraction(0)) != 0:
        raise Undecided("the transition matrix is singular")
    plus, minus = _root_at(rest, noise, 1), _root_at(rest, noise, -1)
    # S c(1) + S c(-1) = 2 S + 2 n2 and S c(+-1) = deviation * root: 2 deviation^2 - (plus + minus)
    # deviation + 2 n2 = 0;
    # the product of its roots is n2, the greater one is the deviation because |c(0)| < 1
    total = plus + minus
    root = sqrt(power(total, 2) - number(16 * n2))
    deviation = number(Fraction(1, 4)) * (total + root)
    other = number(Fraction(1, 4)) * (total - root)
    inverse = weighted([1 / n2], [other])
    return Factor(
        (
            weighted([1 / n2], [power(other, 2)]),
            number(Fraction(1, 2)) * (plus - minus) * inverse,
        ),
        power(deviation, 2),
    )


def _three_states(rest: Laurent, noise: Laurent) -> Factor:
    """For d = (z - 1)^3 and noise in proportion to (z + 1)(1/z + 1): acceleration increments.

    With filter gains 1 - w^2, 2 (1 - w)^2, 2 (1 - w)^3 / (1 + w) of the kinematic model the index
    is 2 (1 - w)^3 / (w (1 + w)) where the noise is (z + 1)(1/z + 1) / 4.
    """
    quarter = noise.get(1, Fraction(0))
    scale = {k: v for k, v in noise.items() if v}
    if rest.get(3) is None or {k: v / rest[3] for k, v in rest.items()} != _cube():
        raise Undecided("a steady state with three states that are no Taylor expansion of a motion")
    if quarter <= 0 or scale != {-1: quarter, 0: 2 * quarter, 1: quarter}:
        raise Undecided("a steady state with three states and this process noise is not covered")
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
    r = -rest[3]
    driven = _root(4 * quarter / r)
    index = 2 * power(left, 3) / mul(driven, w, 1 + w)
    box = Box(lower=Fraction(0), upper=Fraction(1))
    return Factor(coefficients, number(r) / power(w, 2), SHARE, box, index)


def _cube() -> Laurent:
    """(z - 1)^3 (1/z - 1)^3 over its highest coefficient."""
    values = (1, -6, 15, -20, 15, -6, 1)
    return {k: Fraction(value) for k, value in zip(range(-3, 4), values, strict=True)}


def _root_at(rest: Laurent, noise: Laurent, z: int) -> Expr:
    """The square root of the spectrum at 1 or -1."""
    index = symbol(INDEX)
    plain, driven = at_point(rest, z), at_point(noise, z)
    if plain == 0:
        return weighted([1], [index]) if driven == 1 else index * _root(driven)
    if driven == 0:
        return _root(plain)
    return sqrt(weighted([plain, driven], [number(1), power(index, 2)]))


def _root(value: Fraction) -> Expr:
    """Square root of a number, written without a root where it is rational."""
    top, bottom = isqrt(abs(value.numerator)), isqrt(value.denominator)
    if value == Fraction(top, bottom) ** 2:
        return number(Fraction(top, bottom))
    return sqrt(number(value))
