"""Moments of independent normal noises with mean zero, with sines and cosines of them.

For one noise v of variance s, E[v^j e^(i k v)] = i^j R_j e^(-k^2 s/2) with R_0 = 1, R_1 = k s and
R_(j+1) = k s R_j - j s R_(j-1), since E[v f(v)] = s E[f'(v)] (integration by parts of the normal
density). Independent noises multiply, and sines and cosines are parts of e^(i x).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number, power, symbols_of
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.expansion import coefficients
from gainproof.verify.judge.transcendental.monomials import UNIT, monomials

MOST_TURNS = 8
MOST_POWER = 16

Turn = tuple[str, Expr]
"""`cos` or `sin`, and of what."""

_PARTS = {
    "cos": ((1, "cos"), (-1, "sin"), (-1, "cos"), (1, "sin")),
    "sin": ((1, "sin"), (1, "cos"), (-1, "sin"), (-1, "cos")),
}
"""Of i^n e^(i a), n = 0 to 3: the real part by cos, the imaginary part by sin."""


def moments(
    powers: Mapping[str, int], turns: Sequence[Turn], variances: Mapping[str, Expr]
) -> list[Expr]:
    """E of the product of powers of noises with sines and cosines, as terms. Raises Undecided."""
    if any(n > MOST_POWER for n in powers.values()):
        raise Undecided(f"a moment of a noise beyond power {MOST_POWER}")
    if not turns:
        return _one(Fraction(1), "cos", number(0), powers, variances)
    sums = sums_of_turns(turns)
    return [term for c, name, angle in sums for term in _one(c, name, angle, powers, variances)]


def sums_of_turns(turns: Sequence[Turn]) -> list[tuple[Fraction, str, Expr]]:
    """A product of one or more sines and cosines as a sum: coefficient, function, angle. Raises
    Undecided.
    """
    if len(turns) > MOST_TURNS:
        raise Undecided(f"a product of more than {MOST_TURNS} sines and cosines")
    sums = [(Fraction(1), *turns[0])]
    for turn in turns[1:]:
        sums = [term for c, name, angle in sums for term in _sum_of(c, (name, angle), turn)]
    return sums


def _sum_of(c: Fraction, a: Turn, b: Turn) -> list[tuple[Fraction, str, Expr]]:
    """c times the product of two, as the sum of two; a sine stands first."""
    if a[0] == "cos" and b[0] == "sin":
        a, b = b, a
    plus, minus = a[1] + b[1], a[1] - b[1]
    half = c / 2
    if a[0] == "cos":
        return [(half, "cos", minus), (half, "cos", plus)]
    if b[0] == "cos":
        return [(half, "sin", plus), (half, "sin", minus)]
    return [(half, "cos", minus), (-half, "cos", plus)]


def _one(
    c: Fraction, name: str, angle: Expr, powers: Mapping[str, int], variances: Mapping[str, Expr]
) -> list[Expr]:
    """c E[powers times cos or sin of the angle]."""
    factors: list[Expr] = []
    for noise in sorted({*powers, *(symbols_of(angle) & set(variances))}):
        angle, slope = _linear(angle, noise, variances)
        s = variances[noise]
        polynomial = _polynomial(powers.get(noise, 0), slope, s)
        if polynomial is None:
            return []
        factors.append(polynomial)
        if slope != number(0):
            factors.append(Expr("call", "exp", (neg(power(slope, 2) * s / number(2)),)))
    sign, part = _PARTS[name][sum(powers.values()) % 4]
    turned = Expr("call", part, (angle,))
    if angle == number(0):
        if part == "sin":
            return []
        return [mul(number(sign * c), *factors)]
    return [mul(number(sign * c), *factors, turned)]


def linear_parts(angle: Expr, variances: Mapping[str, Expr]) -> list[Expr]:
    """What an angle is made of beside noises. Raises Undecided if it is not linear in them."""
    slopes = []
    for noise in sorted(symbols_of(angle) & set(variances)):
        angle, slope = _linear(angle, noise, variances)
        slopes.append(slope)
    return [angle, *slopes]


def _linear(angle: Expr, noise: str, variances: Mapping[str, Expr]) -> tuple[Expr, Expr]:
    """The angle without the noise, and the coefficient of the noise."""
    found = coefficients(angle, noise)
    if found is None or any(n > 1 for n in found):
        raise Undecided("an expectation of a sine or cosine of something not linear in the noises")
    slope = found.get(1, number(0))
    if symbols_of(slope) & set(variances):
        raise Undecided("an expectation of a sine or cosine of a product of noises")
    return found.get(0, number(0)), _plain(slope)


def _plain(slope: Expr) -> Expr:
    """A number as a number: a difference of two equal ones is 0."""
    if symbols_of(slope):
        return slope
    terms = monomials(slope)
    return number(terms.get(UNIT, Fraction(0))) if set(terms) <= {UNIT} else slope


def _polynomial(j: int, slope: Expr, s: Expr) -> Expr | None:
    """R_j as polynomial of slope k and variance s; None if it is zero.

    A term k^m has s to the power (j + m)/2.
    """
    before: dict[int, int] = {}
    now = {0: 1}
    for i in range(j):
        following = {m + 1: c for m, c in now.items()}
        for m, c in before.items():
            following[m] = following.get(m, 0) - i * c
        before, now = now, following
    if slope == number(0):
        now = {m: c for m, c in now.items() if m == 0}
    terms = [
        mul(number(c), *(power(x, n) for x, n in ((slope, m), (s, (j + m) // 2)) if n))
        for m, c in now.items()
        if c
    ]
    return add(*terms) if terms else None
