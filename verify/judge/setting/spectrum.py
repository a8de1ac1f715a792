"""The innovation spectrum of a model with one scalar measurement, and its stable factor for two
states.

With d(z) = det(zI - F) and the noise of the state seen through H (zI - F)^-1, the spectrum of the
measurement times d(z) d(1/z) is N(z) = n0 + n1 (z + 1/z) + n2 (z^2 + 1/z^2) = S c(z) c(1/z), where
c is the closed-loop polynomial and S the innovation variance. At z = 1 and z = -1 this gives S
c(1)^2 and S c(-1)^2, at the highest power S c(0) = n2.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol, weighted
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.setting.environment import INDEX
from gainproof.verify.judge.setting.matrix import Numbers

Laurent = dict[int, Fraction]


@dataclass(frozen=True)
class Factor:
    """c(z) = z^2 + c1 z + c0 and the innovation variance S, in terms of the tracking index."""

    c1: Expr
    c0: Expr
    innovation: Expr


def characteristic(f: Numbers) -> list[Fraction]:
    """Coefficients of det(zI - F) for two states, from power 0 up."""
    (a, b), (c, d) = f
    return [a * d - b * c, -(a + d), Fraction(1)]


def spectrum(f: Numbers, q: Numbers, h: Numbers, r: Fraction) -> tuple[Laurent, Laurent]:
    """N(z) as the part without noise of the state and the part that is multiplied by the index
    squared.
    """
    d = characteristic(f)
    rest: Laurent = {}
    for i, x in enumerate(d):
        for j, y in enumerate(d):
            rest[i - j] = rest.get(i - j, Fraction(0)) + r * x * y
    (a, b), (c, e) = f
    # H adj(zI - F) = H (z I - adj F) for two states; row of polynomials [constant, slope]
    first, second = h[0]
    row = [[-first * e + second * c, first], [first * b - second * a, second]]
    noise: Laurent = {}
    for i in range(2):
        for j in range(2):
            for m, x in enumerate(row[i]):
                for n, y in enumerate(row[j]):
                    noise[m - n] = noise.get(m - n, Fraction(0)) + q[i][j] * x * y
    return rest, noise


def stable_factor(f: Numbers, q: Numbers, h: Numbers, r: Fraction) -> Factor:
    """c and S with both roots of c inside the unit circle. Raises Undecided where F is singular."""
    rest, noise = spectrum(f, q, h, r)
    index = symbol(INDEX)

    def at(z: int) -> Expr:
        plain = sum((value * z ** abs(k) for k, value in rest.items()), Fraction(0))
        driven = sum((value * z ** abs(k) for k, value in noise.items()), Fraction(0))
        if plain == 0:
            return weighted([1], [index]) if driven == 1 else index * _root(driven)
        if driven == 0:
            return _root(plain)
        return sqrt(weighted([plain, driven], [number(1), power(index, 2)]))

    n2 = rest.get(2, Fraction(0))
    if n2 == 0 or noise.get(2, Fraction(0)) != 0:
        raise Undecided("the transition matrix is singular")
    plus, minus = at(1), at(-1)
    # S c(1) + S c(-1) = 2 S + 2 n2 and S c(+-1) = deviation * root: 2 deviation^2 - (plus + minus)
    # deviation + 2 n2 = 0;
    # the product of its roots is n2, the greater one is the deviation because |c(0)| < 1
    total = plus + minus
    root = sqrt(power(total, 2) - number(16 * n2))
    deviation = number(Fraction(1, 4)) * (total + root)
    other = number(Fraction(1, 4)) * (total - root)
    inverse = weighted([1 / n2], [other])
    return Factor(
        c1=number(Fraction(1, 2)) * (plus - minus) * inverse,
        c0=weighted([1 / n2], [power(other, 2)]),
        innovation=power(deviation, 2),
    )


def _root(value: Fraction) -> Expr:
    """Square root of a number, written without a root where it is rational."""
    top, bottom = isqrt(abs(value.numerator)), isqrt(value.denominator)
    if value == Fraction(top, bottom) ** 2:
        return number(Fraction(top, bottom))
    return sqrt(number(value))
