"""Steps on position gains that fit the covariance in hand, the velocity gain being held."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.steps_filter import EQUATIONS
from gainproof.derive.fixed_gain.two_steps_held_gain import LEAST, P11, X11, N, smoothed_variance
from gainproof.derive.fixed_gain.two_steps_order import lecture_variance
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA, MARGIN
from gainproof.derive.fixed_gain.two_towers import X, Y
from gainproof.derive.relation import equal, positive

GAIN, P, B = real("g"), real("p"), real("b")
ENTRIES = tuple(real(f"q_{ij}") for ij in ("11", "12", "22"))
SMOOTHED, PREDICTED = "fitting_smoothed", "fitting_predicted"
CURVE = 4 * ALPHA**2 - BETA * (4 - 2 * ALPHA)


def fitting_gain_steps() -> list[Step]:
    """The best gain for one step, and the filters that stay with theirs."""
    return [*_one_step(), *_smoothed(), *_predicted()]


def _one_step() -> list[Step]:
    first, cross, last = ENTRIES
    share = (first + cross) / (first + 1)
    return [
        Step(
            "fitting-smoothed",
            "The other reading: in each sample the position gain `g` that is best for the "
            "covariance in hand. With the variance `p` of the predicted position and `b` of the "
            "measurement, the smoothed variance is least at `g = p/(p + b)`, whatever the gain of "
            "the velocity: the scalar Kalman gain.",
            equal(
                (1 - GAIN) ** 2 * P + GAIN**2 * B - P * B / (P + B),
                (P + B) * (GAIN - P / (P + B)) ** 2,
                free=("g", "p", "b"),
            ),
            "Complete the square.",
            tower=EQUATIONS,
            heading="Position gain that fits the covariance in hand",
        ),
        Step(
            "fitting-predicted",
            "The variance of the next prediction is least where `g`, now `alpha + beta`, is `(q11 "
            "+ q12)/(q11 + 1)`, with `q` the covariance in hand and `b = 1`.",
            equal(
                (1 - GAIN) ** 2 * first + 2 * (1 - GAIN) * cross + last + GAIN**2,
                (first + 1) * (GAIN - share) ** 2
                + (first + 2 * cross + last)
                - (first + cross) ** 2 / (first + 1),
                free=("g", *(entry.name for entry in ENTRIES)),
            ),
            "The same.",
            tower=EQUATIONS,
        ),
    ]


def _smoothed() -> list[Step]:
    return [
        Step(
            "fitting-smoothed-curve",
            "A stable filter stays with its gain if that fits its own steady covariance: `alpha "
            "(P11 + 1) = P11` is `y = x^2 - 1`.",
            equal(ALPHA * (P11 + 1) - P11, (X**2 - 1 - Y) / (X * Y)),
            "Insert steps @gains-of-coordinates and @entries.",
        ),
        Step(
            "fitting-smoothed-filter",
            "So there is just one for each `beta` below 2, with `beta = 2 alpha^2/(2 - alpha)`, "
            "and none from 2 on: `x (x + 1) = n^2` and `x > 1`. Its smoothed variance is `alpha`.",
            equal(row(CURVE, X11, P11), row(0, ALPHA, ALPHA / (1 - ALPHA))),
            "`y = x^2 - 1` inserted.",
            tower=SMOOTHED,
        ),
        joined("fitting-smoothed-stable", positive(MARGIN), tower=SMOOTHED),
        joined("fitting-smoothed-beta", positive(2 - BETA), tower=SMOOTHED),
        joined("fitting-smoothed-n", equal(N**2, 4 / BETA), tower=SMOOTHED),
        joined(
            "fitting-smoothed-variances",
            equal(
                row(P11, X11), row(lecture_variance(ALPHA, BETA), smoothed_variance(ALPHA, BETA))
            ),
            tower=SMOOTHED,
        ),
        Step(
            "fitting-smoothed-worse",
            "It is never NP-S of step @smoothed-gains: what is best for each step, the velocity's "
            "gain held, is not best in the steady state. At equal `beta` its smoothed variance is "
            "larger, strictly.",
            positive(X11 - LEAST),
            "Step @held-bound: `(n + 2) x - n (n + 1) = (n - x) (x - 1)`, and `n > x > 1`.",
            tower=SMOOTHED,
            hint={"form": _smoothed_form()},
        ),
    ]


def _smoothed_form() -> sp.Expr:
    """((n - x) (x - 1))^2/((n + 1)^2 x y) with n - x = x/(n + x), x = 1 + e."""
    e = real("e")
    x = 1 + e
    return x * e / ((N + x) ** 2 * (N + 1) ** 2 * (x + 1))


def _predicted() -> list[Step]:
    return [
        Step(
            "fitting-predicted-curve",
            "Likewise the gain that fits the next prediction: `y = (x + 1)^2`.",
            equal(
                (ALPHA + BETA) * (P11 + 1) - P11 - real("predicted_12"),
                ((X + 1) ** 2 - Y) / (X * Y),
            ),
            "As step @fitting-smoothed-curve.",
        ),
        Step(
            "fitting-predicted-filter",
            "Again one for each `beta` below 2 and none from 2 on: `(x + 1) (x + 2) = n^2`.",
            equal(row(N**2, P11), row(4 / BETA, lecture_variance(ALPHA, BETA))),
            "`y = (x + 1)^2` inserted.",
            tower=PREDICTED,
        ),
        joined("fitting-predicted-stable", positive(MARGIN), tower=PREDICTED),
        joined("fitting-predicted-beta", positive(2 - BETA), tower=PREDICTED),
        Step(
            "fitting-predicted-worse",
            "It is never the minimum variance filter: at equal `beta` it predicts worse, strictly.",
            positive(P11 - N**2 / (N - 1) ** 2 + 1),
            "Step @optimum: `x + 1` is below `n`.",
            tower=PREDICTED,
            hint={"form": N**2 / ((N + X + 1) ** 2 * _less_one() ** 2 * X)},
        ),
    ]


def _less_one() -> sp.Expr:
    """n - 1 without a minus sign: n^2 - 1 = x^2 + 3 x + 1."""
    return (X**2 + 3 * X + 1) / (N + 1)
