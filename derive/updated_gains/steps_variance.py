"""Steps on gains over the variance of the measurement, and on an axis between both variances."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.relation import equal, same_sign
from gainproof.derive.updated_gains.forms import gains_of, index_of
from gainproof.derive.updated_gains.names import (
    ALPHA,
    BETA,
    FOLLOWING,
    FOLLOWING_ALPHA,
    FOLLOWING_BETA,
    INDEX,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    E,
    G,
    N,
)
from gainproof.derive.updated_gains.steps_sight import COSINE, SINE
from gainproof.derive.updated_gains.towers import CIRCLE


def variance_steps() -> list[Step]:
    """Tangents, chords, and the gain of an axis against the mixture."""
    here, there = real("position_variance"), real("nominal_variance")
    gap = there - here

    def above(gain: sp.Expr, other: sp.Expr) -> sp.Expr:
        slope = sp.Derivative(gain, here)
        return other - (gain + slope * gap)

    def form(number: int) -> dict[str, sp.Expr]:
        """The factor that is positive."""
        gain, variance = gains_of(E)[number], 1 / index_of(E) ** 2
        slope = by(gain, E) / by(variance, E)
        tangent = gain + slope * (1 / index_of(N) ** 2 - variance)
        return {"form": sp.factor((gains_of(N)[number] - tangent) / (E - N) ** 2)}

    return [
        Step(
            "variance",
            "Against variances: in units of `(sigma_w T^2)^2` the variance of an axis is",
            equal(
                row(here, there),
                row((1 + E) ** 2 / (4 * E**4), (1 + N) ** 2 / (4 * N**4)),
            ),
            "`R = 1/Lambda^2`.",
            heading="An axis between both",
        ),
        Step(
            "convex",
            "Over the variance the gains bend up: each is above its tangents.",
            same_sign(above(ALPHA, NOMINAL_ALPHA), (E - N) ** 2),
            "But for the square there is no minus sign.",
            hint=form(0),
        ),
        joined("convex-beta", same_sign(above(BETA, NOMINAL_BETA), (E - N) ** 2), hint=form(1)),
        *_between(),
    ]


def _between() -> list[Step]:
    here, first, second = (
        real(f"{name}_variance") for name in ("position", "nominal", "following")
    )

    def above(gain: sp.Expr, one: sp.Expr, other: sp.Expr) -> sp.Expr:
        return one * (here - second) + other * (first - here) - gain * (first - second)

    def form(number: int) -> dict[str, sp.Expr]:
        """The factor that is positive."""
        gains = [gains_of(x)[number] for x in (E, N, G)]
        own, one, other = (1 / index_of(x) ** 2 for x in (E, N, G))
        left = gains[1] * (own - other) + gains[2] * (one - own) - gains[0] * (one - other)
        return {"form": sp.factor(left / ((own - other) * (one - own) * (one - other)))}

    order = (here - second) * (first - here) * (first - second)
    along, across = real("variance_along"), real("variance_across")
    mixed = COSINE**2 * along + SINE**2 * across
    return [
        Step(
            "between",
            "With a third variance, `R_2`, where `R` is between `R_0` and `R_2`: the gain is below "
            "the chord.",
            same_sign(above(ALPHA, NOMINAL_ALPHA, FOLLOWING_ALPHA), order),
            "But for the differences of variances there is no minus sign.",
            hint=form(0),
        ),
        joined(
            "between-beta",
            same_sign(above(BETA, NOMINAL_BETA, FOLLOWING_BETA), order),
            hint=form(1),
        ),
        joined(
            "between-variances",
            equal(
                row(here, first, second),
                row(1 / INDEX**2, 1 / NOMINAL**2, 1 / FOLLOWING**2),
            ),
        ),
        Step(
            "mixture",
            "The variance of axis `x` is `R_r c_theta^2 + R_theta s_theta^2`. It divides the "
            "interval between `R_r` and `R_theta`:",
            equal(
                row(mixed - across, along - mixed),
                row(COSINE**2 * (along - across), SINE**2 * (along - across)),
                free=("variance_along", "variance_across"),
            ),
            "`c_theta^2 + s_theta^2 = 1`. From this follows, by step @between divided by "
            "`R_r - R_theta`: where these differ and the angle is no multiple of a right angle, "
            "the gain for the variance of an axis is below the same mixture of the gains along and "
            "across. The filters of the axes are slower than the filter of the line of sight in "
            "both diagonal entries; otherwise it has the form of theirs.",
            tower=CIRCLE,
        ),
    ]
