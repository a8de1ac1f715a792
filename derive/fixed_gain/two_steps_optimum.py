"""Steps on the filter of least variance at a given lag."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA, MARGIN
from gainproof.derive.fixed_gain.two_towers import X, Y
from gainproof.derive.relation import equal, limit, monotone, positive

N, P11 = real("n"), real("predicted_11")
TOWER = "minimum_variance"
LAG = real("lag")


def optimum_steps() -> list[Step]:
    """Minimum variance: the optimum, its gains, its place in the region."""
    return [*_optimum(), *_gains(), *_trend()]


def _optimum() -> list[Step]:
    least = N**2 / (N - 1) ** 2 - 1
    return [
        Step(
            "optimum",
            "The lag behind an acceleration is `1/beta` whatever `alpha` is. Of all stable filters "
            "of one lag, that is of one `n = 2/sqrt(beta) = sqrt(1 + x + y)`, the variance of the "
            "predicted position is that of `x = n - 1` and a square more.",
            equal(P11 - least, N**2 * (X - N + 1) ** 2 / ((N - 1) ** 2 * X * Y)),
            "Bring to one denominator.",
            tower="optimum",
            heading="Minimum variance at a given lag (MV)",
        ),
        joined("optimum-lag", equal(N**2, 4 / BETA), tower="optimum"),
        joined("optimum-variance", equal(P11, _lecture()), tower="optimum"),
        Step(
            "optimum-exists",
            "So there is just one best filter for each lag above `1/4`, with `x = n - 1`, and "
            "it is stable: `n > 1`, and `y = n^2 - 1 - x = n (n - 1)`.",
            positive(N - 1),
            "`n^2 - 1 = x + y`.",
            tower="optimum",
        ),
    ]


def _lecture() -> sp.Expr:
    return (2 * ALPHA**2 + 2 * BETA + ALPHA * BETA) / (ALPHA * MARGIN)


def _gains() -> list[Step]:
    return [
        Step(
            "minimum-variance-gains",
            "Its gains, with `x` as parameter:",
            equal(row(ALPHA, BETA), row(2 * X / (1 + X) ** 2, 4 / (1 + X) ** 2)),
            "Insert `y = x (1 + x)` in step @coordinates.",
            tower=TOWER,
        ),
        joined("minimum-variance-stable", positive(MARGIN), tower=TOWER),
        Step(
            "minimum-variance-relation",
            "They satisfy the lecture's relation `alpha = -beta/2 + sqrt(beta)`, and every `beta` "
            "between 0 and 4 occurs.",
            equal((ALPHA + BETA / 2) ** 2, BETA),
            "Insert; `alpha + beta/2` is positive, so it is the positive root.",
            tower=TOWER,
        ),
        Step(
            "minimum-variance-value",
            "The least variance at that lag, `(1 + 1/x)^2 - 1`:",
            equal(P11, (1 + 1 / X) ** 2 - 1),
            "Step @optimum.",
            tower=TOWER,
        ),
        joined("minimum-variance-lecture", equal(P11, _lecture()), tower=TOWER),
        Step(
            "minimum-variance-alpha",
            "Its `alpha` is never above `1/2`, which belongs to `x = 1`, `beta = 1`.",
            equal(sp.Rational(1, 2) - ALPHA, (X - 1) ** 2 / (2 * (1 + X) ** 2)),
            "A square.",
            tower=TOWER,
        ),
        Step(
            "minimum-variance-twice",
            "Each `alpha` below that belongs to two of them, `x` and `1/x`: both stable.",
            equal(sp.Subs(ALPHA, X, 1 / X), ALPHA),
            "Insert.",
            tower=TOWER,
        ),
        Step(
            "minimum-variance-complex",
            "Its poles are always complex.",
            positive(4 * BETA - (ALPHA + BETA) ** 2),
            "Step @discriminant: `4 y - x^2 = 3 x^2 + 4 x`.",
            tower=TOWER,
        ),
    ]


def _trend() -> list[Step]:
    ends = {"0": End(), "infinity": End()}
    return [
        Step(
            "minimum-variance-trade",
            "Lag and least variance are one against the other: as `x` grows the lag `1/beta` grows "
            "and the variance falls, from infinity at the lag `1/4` to 0.",
            monotone(P11, "decreasing", variable="x"),
            "The derivatives have one sign each.",
            tower=TOWER,
        ),
        joined("minimum-variance-lag", equal(LAG, 1 / BETA), tower=TOWER),
        joined(
            "minimum-variance-lag-grows", monotone(LAG, "increasing", variable="x"), tower=TOWER
        ),
        joined(
            "minimum-variance-lag-start",
            limit(LAG, "0", sp.Rational(1, 4), variable="x"),
            tower=TOWER,
            hint={"ends": ends},
        ),
        joined(
            "minimum-variance-start",
            limit(P11, "0", "infinity", variable="x"),
            tower=TOWER,
            hint={"ends": ends},
        ),
        joined(
            "minimum-variance-end",
            limit(P11, "infinity", sp.Integer(0), variable="x"),
            tower=TOWER,
            hint={"ends": ends},
        ),
    ]
