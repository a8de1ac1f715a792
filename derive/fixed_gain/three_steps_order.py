"""Steps on who is better at equal lag: minimum variance, random jerk, random acceleration."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.three_steps_optimum import P11, lecture_variance
from gainproof.derive.fixed_gain.three_steps_stability import ALPHA, BETA, GAMMA
from gainproof.derive.fixed_gain.three_towers import E, X
from gainproof.derive.relation import equal, monotone, positive

LAG, BOUND = real("lag"), real("bound")
BOUND_LAG, BOUND_VARIANCE = real("bound_lag"), real("bound_variance")
TOWER, RA = "same_lag", "stable_acceleration"


def ordering_steps() -> list[Step]:
    """A filter of random acceleration that lies between, so that no equation need be solved."""
    return [
        Step(
            "random-acceleration-trade",
            "Along random acceleration, from its border on, the lag grows and the variance falls, "
            "each strictly.",
            monotone(P11, "decreasing", variable="e"),
            "The derivatives have one sign each; `x = 2 + e`.",
            tower=RA,
            heading="Orderings at equal lag",
        ),
        joined("random-acceleration-lag", equal(LAG, 1 / GAMMA), tower=RA),
        joined(
            "random-acceleration-lag-grows", monotone(LAG, "increasing", variable="e"), tower=RA
        ),
        Step(
            "jerk-of-lag",
            "Take a filter of random jerk with `x >= 2`, which all with `alpha < 1` have: its "
            "gains, its lag and its variance.",
            equal(
                row(
                    2 * ALPHA * GAMMA - BETA**2,
                    2 * ALPHA**2 + 2 * ALPHA * BETA - 4 * BETA + ALPHA * GAMMA,
                    2 * BETA / GAMMA,
                    LAG,
                    P11,
                ),
                row(GAMMA**2 / 12, GAMMA**2 / 18, X, 1 / GAMMA, lecture_variance()),
            ),
            "As step @random-jerk.",
            tower=TOWER,
        ),
        Step(
            "bound",
            "And the filter of random acceleration whose `x` is `b`:",
            equal(
                row(BOUND, BOUND_LAG, BOUND_VARIANCE),
                row(
                    X + (2 * X**2 + 4 * X - 1) / (3 * X * (3 * X + 2) * (X + 2)),
                    BOUND * (BOUND + 2) ** 2 / 64,
                    (20 * BOUND**2 + 24 * BOUND) / ((BOUND - 2) * (3 * BOUND**2 - 4)),
                ),
            ),
            "Lag and variance are those of step @random-acceleration-trade, over `x`.",
            tower=TOWER,
        ),
        joined(
            "bound-is-of-the-curve",
            equal(
                row(LAG, P11),
                row(
                    (2 + E) * (4 + E) ** 2 / 64,
                    (20 * (2 + E) ** 2 + 24 * (2 + E)) / (E * (3 * (2 + E) ** 2 - 4)),
                ),
            ),
            tower=RA,
        ),
        Step(
            "bound-follows",
            "It lags more than the filter of random jerk, and that more than the border of "
            "random acceleration, `1/2`.",
            positive(BOUND_LAG - LAG),
            "No minus sign is left in `x - 2`.",
            tower=TOWER,
        ),
        joined("bound-starts", positive(LAG - sp.Rational(1, 2)), tower=TOWER),
        Step(
            "order-at-equal-lag",
            "It has more variance all the same. So random acceleration of the very lag, between "
            "the border and `b`, has yet more: at equal lag minimum variance is best, random jerk "
            "second, random acceleration third, strictly.",
            positive(BOUND_VARIANCE - P11),
            "No minus sign is left in `x - 2`; steps @optimum and @random-acceleration-trade.",
            tower=TOWER,
        ),
    ]
