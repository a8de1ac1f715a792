"""Steps on the alpha-beta-gamma filter of least variance at a given lag."""

from __future__ import annotations

import sympy as sp

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
from gainproof.derive.relation import equal, positive

P11, SIZE = real("predicted_11"), real("m")
MV = "minimum_variance"


def lecture_variance() -> sp.Expr:
    """The lecture's smoothing index."""
    g = (2 * ALPHA * BETA - GAMMA * (2 - ALPHA)) * MARGIN
    return 8 * BETA**2 / ((2 - ALPHA) * g) + ALPHA / (2 - ALPHA)


def discriminant() -> sp.Expr:
    """Of c(z)."""
    return sp.Poly(LOOP.polynomial(Z), Z).discriminant()


def optimum_steps() -> list[Step]:
    """Minimum variance."""
    return _optimum()


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
