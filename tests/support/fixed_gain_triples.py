"""The named filters of three gains of one lag or one position gain: their relations, solved.

Minimum variance is taken from the lecture's two implicit equations; that they are the optimum is
held against the oracle's slopes in `test_fixed_gain_alpha_beta_gamma`, and the relations of the
others against the Riccati solutions of their models. Variances are those of the oracle that knows
F, H and K only.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import flint
from fixed_gain_truth import BITS, WORKING, acceleration

from gainproof.verify.oracles.fixed_gain import ball, predicted
from gainproof.verify.oracles.true_values import Truth
from gainproof.verify.oracles.zero_crossing import between

Gains = tuple[Fraction, ...]
Ends = tuple[Gains, Gains]
Law = Callable[[flint.arb, flint.arb, flint.arb], flint.arb]


@dataclass(frozen=True)
class AlphaBetaGammaTruth:
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
        for name, ends in found.items():
            for place, gain in enumerate(("alpha", "beta", "gamma")):
                low, high = (ball(end[place]) for end in ends)
                named[f"{name}_{gain}"] = low.union(high)
            low, high = (predicted([ball(gain) for gain in end])[0, 0] for end in ends)
            named[f"{name}_predicted_11"] = low.union(high)
        return {output: Truth(x, x) for output, x in named.items()}


def random_acceleration(alpha: flint.arb, beta: flint.arb, gamma: flint.arb) -> flint.arb:
    """The lecture's first relation."""
    return alpha * (alpha + beta + gamma / 2) - 2 * beta


def random_jerk(alpha: flint.arb, beta: flint.arb, gamma: flint.arb) -> flint.arb:
    """The lecture's first relation."""
    return 2 * alpha**2 + 2 * alpha * beta - 4 * beta + alpha * gamma - gamma**2 / 18


def _by_lag(lag: Fraction) -> dict[str, Ends]:
    gamma = 1 / lag
    found: dict[str, Ends] = {"minimum_variance": _minimum(gamma)}
    # alpha by the second relations: beta^2 = 2 alpha gamma, 2 alpha gamma - beta^2 = gamma^2/12
    for name, law, part, least in (
        ("random_acceleration", random_acceleration, Fraction(0), Fraction(1, 2)),
        ("random_jerk", random_jerk, Fraction(1, 12), Fraction(69, 128)),
    ):
        if lag > least:
            found[name] = _of_gamma(gamma, law, part)
    return found


def _of_gamma(gamma: Fraction, law: Law, part: Fraction) -> Ends:
    def alpha_of(beta: Fraction) -> Fraction:
        return (beta**2 + part * gamma**2) / (2 * gamma)

    def rising(beta: flint.arb) -> flint.arb:
        given = ball(gamma)
        return law((beta**2 + ball(part) * given**2) / (2 * given), beta, given)

    # 2 beta/gamma is 2 at least, and grows as the cube root of the lag
    highest = 4 * gamma * max(Fraction(1), Fraction(float(1 / gamma) ** (1 / 3)))
    low, high = between(gamma, highest, rising, 2 * BITS)
    return (alpha_of(low), low, gamma), (alpha_of(high), high, gamma)


def _by_gain(alpha: Fraction) -> dict[str, Ends]:
    """beta^2 = 2 alpha gamma makes the other relation that of the two gains."""
    given = ball(alpha)
    low, high = between(alpha**2 / 8, 4 - 2 * alpha, lambda b: -acceleration(given, b), 2 * BITS)
    second = (alpha, low, low**2 / (2 * alpha)), (alpha, high, high**2 / (2 * alpha))
    return {"random_acceleration": second, "random_jerk": _jerk_of_alpha(alpha)}


def _jerk_of_alpha(alpha: Fraction) -> Ends:
    given = ball(alpha)

    def beta_of(gamma: flint.arb) -> flint.arb:
        return (2 * given * gamma - gamma**2 / 12).sqrt()

    def rising(gamma: flint.arb) -> flint.arb:
        return -random_jerk(given, beta_of(gamma), gamma)

    ends = between(alpha**3 / 64, 2 * alpha**2, rising, 2 * BITS)
    low, high = ((alpha, _fraction(beta_of(ball(gamma))), gamma) for gamma in ends)
    return low, high


def _fraction(value: flint.arb) -> Fraction:
    """A number of the ball, which is far narrower than what is asked for."""
    middle = value.mid().fmpq()
    return Fraction(int(middle.p), int(middle.q))


def _minimum(gamma: Fraction) -> Ends:
    """4 alpha beta = gamma (8 - 4 alpha - beta) gives beta, the cubic equation alpha."""

    def beta_of(alpha: Fraction) -> Fraction:
        return gamma * (8 - 4 * alpha) / (4 * alpha + gamma)

    def cubic(alpha: flint.arb) -> flint.arb:
        c = ball(gamma)
        beta = c * (8 - 4 * alpha) / (4 * alpha + c)
        return (
            8 * alpha**2 * (2 - alpha)
            - beta**3
            - 2 * (3 * alpha - 8) * beta**2
            - 4 * (3 * alpha**2 - 12 * alpha + 16) * beta
        )

    # beta < 4 - 2 alpha is alpha > gamma/4
    inside = 1 - Fraction(1, 2**120)
    low, high = between(gamma / 4 / inside, 2 * inside, cubic, 2 * BITS)
    return (low, beta_of(low), gamma), (high, beta_of(high), gamma)
