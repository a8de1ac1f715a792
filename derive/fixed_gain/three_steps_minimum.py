"""Steps on alpha-beta-gamma filters of minimum variance: the lecture's equations, their curve."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.three_steps_optimum import MV, P11, discriminant
from gainproof.derive.fixed_gain.three_steps_stability import ALPHA, BETA, GAMMA, MARGIN, Y
from gainproof.derive.fixed_gain.three_towers import D, M, X
from gainproof.derive.relation import equal, limit, monotone, positive, same_sign

FIRST = 4 * ALPHA * BETA - GAMMA * (8 - 4 * ALPHA - BETA)
SECOND = (
    BETA**3
    + 2 * (3 * ALPHA - 8) * BETA**2
    + 4 * (3 * ALPHA**2 - 12 * ALPHA + 16) * BETA
    - 8 * ALPHA**2 * (2 - ALPHA)
)


def minimum_steps() -> list[Step]:
    """What the lecture says of them, and how they run with the lag."""
    return [*_implicit(), *_curve()]


def _implicit() -> list[Step]:
    return [
        Step(
            "implicit",
            "The lecture gives two implicit equations. These gains satisfy both.",
            equal(row(FIRST, SECOND), row(0, 0)),
            "Insert.",
            tower=MV,
        ),
        Step(
            "implicit-first",
            "And among stable filters only they do: the first equation is `m = d`,",
            same_sign(FIRST, M - D),
            "Insert step @gains-of-coordinates.",
        ),
        Step(
            "implicit-second",
            "and where it holds, which is `x y = 2 d`, the second is `y = 2 x (1 + x)`.",
            same_sign(SECOND, 2 * X * (1 + X) - Y),
            "The quotient of both sides has no minus sign.",
            tower="equal_minors",
        ),
        joined(
            "equal-minors",
            equal(
                row(2 * BETA / GAMMA, (4 * ALPHA - GAMMA) / GAMMA, 2 * MARGIN / GAMMA),
                row(X, Y, X * Y / 2),
            ),
            tower="equal_minors",
        ),
    ]


def _curve() -> list[Step]:
    ends, lag = {"0": End(), "infinity": End()}, real("lag")
    return [
        Step(
            "minimum-variance-range",
            "`alpha` falls from 2 to 0 as the lag grows: there is one filter for each `alpha` "
            "between, all stable. It is below 1 where `x^3 > x^2 + x + 1`, `x` above 1.84.",
            monotone(ALPHA, "decreasing", variable="x"),
            "The derivatives have one sign each.",
            tower=MV,
        ),
        joined(
            "minimum-variance-alpha-start",
            limit(ALPHA, "0", sp.Integer(2), variable="x"),
            tower=MV,
            hint={"ends": ends},
        ),
        joined(
            "minimum-variance-alpha-end",
            limit(ALPHA, "infinity", sp.Integer(0), variable="x"),
            tower=MV,
            hint={"ends": ends},
        ),
        joined("minimum-variance-alpha-one", same_sign(1 - ALPHA, X**3 - X**2 - X - 1), tower=MV),
        Step(
            "minimum-variance-trade",
            "Lag and least variance are one against the other.",
            monotone(P11, "decreasing", variable="x"),
            "As step @minimum-variance-range.",
            tower=MV,
        ),
        joined("minimum-variance-lag", equal(lag, 1 / GAMMA), tower=MV),
        joined("minimum-variance-lag-grows", monotone(lag, "increasing", variable="x"), tower=MV),
        Step(
            "minimum-variance-poles",
            "One pole is real, two are complex, always.",
            positive(-discriminant()),
            "Step @discriminant.",
            tower=MV,
        ),
    ]
