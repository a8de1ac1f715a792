"""The named filters of one lag or one position gain: their relations or their optimum, solved.

Relations are those of the lecture; random velocity and random acceleration are also held against
the Riccati solutions of their models in `test_fixed_gain_alpha_beta`. Variances are those of the
oracle that knows F, H and K only, and so is the optimum of minimum variance.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import flint

from gainproof.verify.oracles.fixed_gain import (
    ball,
    predicted,
    updated,
    variance_slope,
)
from gainproof.verify.oracles.true_values import Truth
from gainproof.verify.oracles.zero_crossing import between

BITS = 75  # of a place: far beyond a double
WORKING = 700  # 1/(alpha beta) is up to 1e45, the slope near its place 2^-150 of its terms
Ends = tuple[Fraction, Fraction]
Pair = tuple[Ends, Ends]


def velocity(alpha: flint.arb, beta: flint.arb) -> flint.arb:
    """The relation of random velocity."""
    return alpha * (alpha + beta) - 2 * beta


def acceleration(alpha: flint.arb, beta: flint.arb) -> flint.arb:
    """That of random acceleration."""
    return (alpha + beta / 2) ** 2 - 2 * beta


def optimum(alpha: flint.arb, beta: flint.arb) -> flint.arb:
    """The slope of the variance along alpha: 0 where it is least at this lag."""
    return variance_slope((alpha, beta), 0)


def smoothed_optimum(alpha: flint.arb, beta: flint.arb) -> flint.arb:
    """The slope of the smoothed variance (1 - alpha)^2 P + alpha^2 along alpha."""
    p = predicted((alpha, beta))[0, 0]
    slope = variance_slope((alpha, beta), 0)
    return (1 - alpha) ** 2 * slope - 2 * (1 - alpha) * p + 2 * alpha


@dataclass(frozen=True)
class AlphaBetaTruth:
    """What the kernels by lag and by gain should return, under their outputs' names."""

    def at(self, argument: str, value: float) -> Mapping[str, Truth]:
        """Every output whose filter exists where the argument has exactly this value."""
        return _at(argument, value)


@cache
def _at(argument: str, value: float) -> Mapping[str, Truth]:
    with flint.ctx.workprec(WORKING):
        exact = Fraction(value)
        found = _by_lag(exact) if argument == "lag" else _by_gain(exact)
        named: dict[str, flint.arb] = {}
        for name, (alpha, beta) in found.items():
            named[f"{name}_alpha"] = _hull(*map(ball, alpha))
            named[f"{name}_beta"] = _hull(*map(ball, beta))
            named[f"{name}_predicted_11"] = _hull(*map(_variance, alpha, beta))
            named[f"{name}_updated_11"] = _hull(*map(_smoothed, alpha, beta))
        return {name: Truth(x, x) for name, x in named.items()}


def _hull(low: flint.arb, high: flint.arb) -> flint.arb:
    return low.union(high)


def _variance(alpha: Fraction, beta: Fraction) -> flint.arb:
    """At exact gains: a ball of gains would be blown up where the filter is slow."""
    return predicted((ball(alpha), ball(beta)))[0, 0]


def _smoothed(alpha: Fraction, beta: Fraction) -> flint.arb:
    return updated((ball(alpha), ball(beta)))[0, 0]


def _by_lag(lag: Fraction) -> dict[str, Pair]:
    beta = 1 / lag
    border = 2 - beta / 2
    least = border * min(beta, Fraction(1)) / 64

    def alpha_of(
        rising: Callable[[flint.arb, flint.arb], flint.arb], top: Fraction, bits: int
    ) -> Pair:
        given = ball(beta)
        return between(least, top, lambda alpha: rising(alpha, given), bits), (beta, beta)

    inside = least + (border - least) * (1 - Fraction(1, 2**60))
    found: dict[str, Pair] = {}
    if lag > Fraction(1, 4):
        found["minimum_variance"] = alpha_of(optimum, inside, BITS)
    if lag > Fraction(1, 2):
        found["random_acceleration"] = alpha_of(acceleration, border, 2 * BITS)
        found["minimum_smoothed_variance"] = alpha_of(smoothed_optimum, inside, 2 * BITS)
    if border > 0 and velocity(ball(border), ball(beta)) > 0:
        found["random_velocity"] = alpha_of(velocity, border, 2 * BITS)
    return found


def _by_gain(alpha: Fraction) -> dict[str, Pair]:
    given = ball(alpha)

    def beta_of(rising: Callable[[flint.arb], flint.arb], low: Fraction, high: Fraction) -> Pair:
        # near the border of stability the variance tells much of beta's digits
        return (alpha, alpha), between(low, high, rising, 2 * BITS)

    least, middle = alpha**2 / 8, 2 - 2 * alpha
    # at the larger beta of the relation, beyond 2, random acceleration is unstable
    found = {
        "random_velocity": beta_of(lambda b: -velocity(given, b), least, Fraction(4)),
        "random_acceleration": beta_of(lambda b: -acceleration(given, b), least, 4 - 2 * alpha),
        # of least smoothed variance are the slow ones, below 2
        "minimum_smoothed_variance": beta_of(
            lambda b: -smoothed_optimum(given, b), least, Fraction(2)
        ),
    }
    if alpha < Fraction(1, 2):
        border = (4 - 2 * alpha) * (1 - Fraction(1, 2**120))
        found["slow_minimum_variance"] = beta_of(lambda b: -optimum(given, b), least, middle)
        found["fast_minimum_variance"] = beta_of(lambda b: optimum(given, b), middle, border)
    return found
