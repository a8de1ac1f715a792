"""Steps on the alpha-beta-gamma filter of least variance at a given lag."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.steps_answer import Z
from gainproof.derive.fixed_gain.three_steps_stability import (
    ALPHA,
    BETA,
    GAMMA,
    INEQUALITIES,
    MARGIN,
    Y,
)
from gainproof.derive.fixed_gain.three_towers import LOOP, D, M, P, T, X
from gainproof.derive.relation import equal, limit, monotone, positive, same_sign

P11, SIZE = real("predicted_11"), real("m")
MV = "minimum_variance"
FIRST = 4 * ALPHA * BETA - GAMMA * (8 - 4 * ALPHA - BETA)
SECOND = (
    BETA**3
    + 2 * (3 * ALPHA - 8) * BETA**2
    + 4 * (3 * ALPHA**2 - 12 * ALPHA + 16) * BETA
    - 8 * ALPHA**2 * (2 - ALPHA)
)


def lecture_variance() -> sp.Expr:
    """The lecture's smoothing index."""
    g = (2 * ALPHA * BETA - GAMMA * (2 - ALPHA)) * MARGIN
    return 8 * BETA**2 / ((2 - ALPHA) * g) + ALPHA / (2 - ALPHA)


def discriminant() -> sp.Expr:
    """Of c(z)."""
    return sp.Poly(LOOP.polynomial(Z), Z).discriminant()


def optimum_steps() -> list[Step]:
    """Minimum variance."""
    return [*_optimum(), *_implicit(), *_curve()]


def _optimum() -> list[Step]:
    x, size = P * T**2, (1 + P) ** 3
    d = (x * (size - 1 - x) - SIZE) / (1 + x)
    y = (d + SIZE) / x
    innovation = size * (x * (1 + x) + SIZE) / (d * SIZE)
    square = (SIZE - P**2 * T * (1 + P * T**2)) ** 2
    rest = SIZE * P**2 * (T - 1) ** 2 * (T * (T + 2) + P * (2 * T + 1))
    return [
        Step(
            "innovation",
            "In the coordinates the variance of the innovation, `P11 + 1`, is short.",
            equal(
                real("innovation_variance"),
                (1 + X + Y + D) * (X * (1 + X) + M) / (D * M),
            ),
            "Insert step @gains-of-coordinates in step @entries.",
            heading="Minimum variance at a given lag (MV)",
        ),
        Step(
            "same-lag",
            "The lag behind a jerk is `1/gamma` whatever the other gains are. Take all stable "
            "filters of one lag `(1 + p)^3/8`, `p > 0`; each has `x = p t^2` with a `t > 0`, "
            "and `m` "
            "then fixes `d` and `y`.",
            equal(row(1 + x + y + d, x * y - d), row(size, SIZE), free=("m",)),
            "`d = (x ((1 + p)^3 - 1 - x) - m)/(1 + x)`, `y = (d + m)/x`.",
            tower="optimum",
        ),
        Step(
            "optimum",
            "Its variance is `(1 + 1/p)^3 - 1` and two terms more, neither of which is negative:",
            equal(
                innovation - (1 + 1 / P) ** 3,
                size * (square + rest) / (P**3 * d * SIZE * (1 + x)),
                free=("m",),
            ),
            "Bring to one denominator; `d`, `m` and the last bracket are positive.",
            tower="optimum",
        ),
        joined("optimum-bracket", positive(T * (T + 2) + P * (2 * T + 1)), tower="optimum"),
        Step(
            "optimum-unique",
            "Both vanish only for `t = 1`, `m = p^2 (1 + p)`. So there is just one best filter for "
            "each lag above `1/8`: `x = p`, `d = m = x^2 (1 + x)`, `y = 2 x (1 + x)`.",
            equal(
                row(*(sp.Subs(v.subs(SIZE, P**2 * (1 + P)), T, sp.Integer(1)) for v in (d, y))),
                row(P**2 * (1 + P), 2 * P * (1 + P)),
            ),
            "Insert in step @same-lag.",
            tower="optimum",
        ),
        Step(
            "minimum-variance-gains",
            "Its gains, explicit and rational in `x`, with `1 + x = 2 gamma^(-1/3)`:",
            equal(
                row(ALPHA, BETA, GAMMA),
                row(
                    2 * (2 * X**2 + 2 * X + 1) / (1 + X) ** 3,
                    4 * X / (1 + X) ** 3,
                    8 / (1 + X) ** 3,
                ),
            ),
            "Insert in step @gains-of-coordinates.",
            tower=MV,
        ),
        joined(
            "minimum-variance-coordinates",
            equal(
                row(2 * BETA / GAMMA, (4 * ALPHA - GAMMA) / GAMMA, 2 * MARGIN / GAMMA),
                row(X, 2 * X * (1 + X), X**2 * (1 + X)),
            ),
            tower=MV,
        ),
        Step(
            "minimum-variance-value",
            "The least variance at that lag:",
            equal(P11, (1 + 1 / X) ** 3 - 1),
            "Step @optimum.",
            tower=MV,
        ),
        joined("minimum-variance-lecture", equal(P11, lecture_variance()), tower=MV),
        *(
            joined(f"minimum-variance-{name}", positive(value), tower=MV)
            for name, value in INEQUALITIES.items()
        ),
    ]


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
