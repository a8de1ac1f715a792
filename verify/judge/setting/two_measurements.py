"""Closed form of the steady state with position and velocity measured, for all two-state noises.

In units T = 1 and measured position deviation 1, with F = [[1, 1], [0, 1]], H = I, R = diag(1, y)
and Q = index^2 [[q11, n], [n, 1]]. The determinant of the innovation spectrum is v^2 + B v + C with
v = 2 - z - 1/z; its stable factor has the values c and E at z = 1 and -1, and sigma^2 is the ratio
of the determinants of the innovation and the measurement noise. Nothing here is trusted: what
makes it the steady state is shown where it is used.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    mul,
    number,
    power,
    sqrt,
    weighted,
)

HALF = number(Fraction(1, 2))


@dataclass(frozen=True)
class Noise:
    """Q / index^2 = [[position, mixed], [mixed, 1]]."""

    position: Fraction
    mixed: Fraction

    @property
    def at_minus_one(self) -> Fraction:
        """The share of the noise spectrum at z = -1 in that at z = 1."""
        return 1 - 4 * (self.mixed - self.position)

    @property
    def determinant(self) -> Fraction:
        """Of Q / index^2."""
        return self.position - self.mixed**2


@dataclass(frozen=True)
class Entries:
    """Upper entries of the predicted and the updated covariance: 11, 12, 22."""

    predicted: tuple[Expr, Expr, Expr]
    updated: tuple[Expr, Expr, Expr]


def entries(index: Expr, top: Expr, bottom: Expr, noise: Noise) -> Entries:
    """The covariances for the ratio S = top / bottom of the deviations of measured velocity and
    position; each term is positive, and has a value for top = 0 and for bottom = 0 as well.
    """
    e, d, n = noise.at_minus_one, noise.determinant, noise.mixed
    a, a2, b2, index2 = top, power(top, 2), power(bottom, 2), power(index, 2)
    # c = index hat_c / top, E = hat_e / top, sigma - 1/sigma = hat_d / top, sigma = hat_s / top
    hat_c = sqrt(weighted([1, d], [a2, mul(index2, b2)])) if d else a
    inner = weighted([4, d], [index2, power(index, 4)])
    hat_e = sqrt(add(mul(a2, weighted([16, e], [number(1), index2])), mul(inner, b2)))
    driven = weighted([Fraction(1 + e, 2), 2, d], [a2, b2, mul(index2, b2)])
    hat_d = sqrt(mul(HALF, index, add(mul(index, driven), mul(hat_c, hat_e))))
    hat_m = mul(HALF, add(mul(index, hat_c), hat_e))
    hat_s = mul(HALF, add(hat_m, hat_d))
    below = add(mul(power(hat_d, 2), b2), power(a, 4))
    rising = weighted([1, 2 * n - 1], [hat_m, hat_d])
    cross = add(mul(HALF, index2, b2, rising), mul(a2, index, hat_c)) / below
    first = weighted([e / 4, 1, d / 2], [a2, b2, mul(index2, b2)])
    second = weighted([Fraction(1, 4), d / 2], [a2, mul(index2, b2)])
    third = weighted([(1 - 2 * n) / 2], [mul(a2, hat_d)])
    inside = add(mul(index, hat_c, first), mul(hat_e, second), third)
    whole = mul(index2, inside) / below
    updated_12 = mul(a2, cross) / hat_s
    predicted_12 = mul(cross, hat_s)
    updated_22 = mul(a2, add(index2 / hat_s, whole)) / hat_d
    step = weighted([2, 1, noise.position], [updated_12, updated_22, index2])
    updated_11 = add(mul(b2, whole), mul(a2, step) / hat_s) / hat_d
    return Entries(
        (add(updated_11, step), predicted_12, add(updated_22, index2)),
        (updated_11, updated_12, updated_22),
    )


def exact_velocity(index: Expr, noise: Noise) -> Expr:
    """The predicted variance of the position where velocities are measured exactly.

    What is left to be filtered is the position, whose noise given that of the velocity has the
    variance d = index^2 determinant: of the variance m before the update, m / (m + 1) is left, so
    that m^2 = d (m + 1).
    """
    index2 = power(index, 2)
    d = mul(number(noise.determinant), index2)
    before = mul(HALF, add(d, sqrt(add(power(d, 2), mul(number(4), d)))))
    return add(before, mul(number(noise.mixed**2), index2))
