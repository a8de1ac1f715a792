"""Steps on filters without process noise whose velocity gain is held: NP-S and NP-P."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA, MARGIN
from gainproof.derive.fixed_gain.two_towers import E, X, Y
from gainproof.derive.relation import equal, limit, positive, same_sign

N, P11, X11 = real("n"), real("predicted_11"), real("updated_11")
ANY, SLOW, FAST, BORDER = "smoothed_any", "smoothed_slow", "smoothed_fast", "smoothed_border"
LEAST = (2 * N + 3) / (N + 1) ** 2
FAST_LEAST = (3 - 2 * N) / (N - 1) ** 2
RELATION = 4 * BETA * (1 - ALPHA) ** 2


def held_gain_steps() -> list[Step]:
    """The best stationary filters at a held velocity gain: predicted, then smoothed."""
    return [*_bounds(), *_slow(), *_fast()]


def smoothed_variance(alpha: sp.Expr, beta: sp.Expr) -> sp.Expr:
    """That of the position, in the gains."""
    return (2 * alpha**2 + 2 * beta - 3 * alpha * beta) / (alpha * (4 - 2 * alpha - beta))


def _bounds() -> list[Step]:
    return [
        Step(
            "held-bound",
            "The lecture's last filters know no process noise. They hold the gain of the velocity, "
            "here `beta`, and minimise the covariance of the prediction (NP-P) or of the smoothed "
            "state (NP-S). To hold `beta` is to hold the lag: of one position, NP-P in its steady "
            "state is the minimum variance filter of step @optimum. For NP-S, with `n` as there, "
            "the smoothed variance is a bound and a square more.",
            equal(X11 - LEAST, ((N + 2) * X - N * (N + 1)) ** 2 / ((N + 1) ** 2 * X * Y)),
            "Bring to one denominator; `n^2 = 1 + x + y`.",
            tower="optimum",
            heading="Velocity gain held, no process noise (NP-P, NP-S)",
        ),
        joined("held-variance", equal(X11, smoothed_variance(ALPHA, BETA)), tower="optimum"),
        Step(
            "held-bound-fast",
            "And another bound and a square more: the same with `-n` for `n`.",
            equal(X11 - FAST_LEAST, ((2 - N) * X - N * (N - 1)) ** 2 / ((N - 1) ** 2 * X * Y)),
            "As before.",
            tower="optimum",
        ),
    ]


def _slow() -> list[Step]:
    ends = {"0": End(), "infinity": End()}
    return [
        Step(
            "smoothed-place",
            "The first square is 0 at one `x` of each `n`, `x = n (n + 1)/(n + 2)`. That filter is "
            "stable exactly if `beta < 2`.",
            same_sign(MARGIN, 2 - BETA),
            "`y = n^2 - 1 - x = (n + 1) (n^2 - 2)/(n + 2)`.",
            tower=ANY,
        ),
        joined(
            "smoothed-coordinates",
            equal(
                row(2 * ALPHA / BETA, MARGIN / BETA),
                row(N * (N + 1) / (N + 2), (N + 1) * (N**2 - 2) / (N + 2)),
            ),
            tower=ANY,
        ),
        Step(
            "smoothed-gains",
            "So for each `beta` below 2 there is just one filter of least smoothed variance, NP-S:",
            equal(row(ALPHA, BETA), row(2 * (N + 1) / (N * (N + 2)), 4 / N**2)),
            "Step @coordinates. With `b = sqrt(beta) = 2/n` it is `alpha = b (2 + b)/(2 (1 + b))`.",
            tower=SLOW,
        ),
        joined("smoothed-stable", positive(MARGIN), tower=SLOW),
        joined("smoothed-alpha", positive(1 - ALPHA), tower=SLOW),
        Step(
            "smoothed-relation",
            "It has a relation of its own: `2 sqrt(beta) (1 - alpha) = 2 alpha - beta`.",
            equal(RELATION, (2 * ALPHA - BETA) ** 2),
            "Insert; `2 alpha - beta` and `1 - alpha` are positive.",
            tower=SLOW,
        ),
        joined("smoothed-relation-sign", positive(2 * ALPHA - BETA), tower=SLOW),
        Step(
            "smoothed-value",
            "The least smoothed variance, `(1 + 1/(n + 1))^2 - 1`; the least predicted one is "
            "`(1 + 1/(n - 1))^2 - 1`, so that both are one function two steps of `n` apart.",
            equal(row(X11, X11), row((1 + 1 / (N + 1)) ** 2 - 1, smoothed_variance(ALPHA, BETA))),
            "Step @held-bound.",
            tower=SLOW,
        ),
        Step(
            "smoothed-predicted",
            "It pays in prediction:",
            equal(
                row(P11, P11),
                row(
                    (2 * N**3 + 7 * N**2 + 8 * N + 2) / ((N + 1) ** 2 * (N**2 - 2)),
                    (2 * ALPHA**2 + 2 * BETA + ALPHA * BETA) / (ALPHA * MARGIN),
                ),
            ),
            "Step @lecture-variance.",
            tower=SLOW,
        ),
        Step(
            "smoothed-above",
            "At equal `beta` its `alpha` is above that of minimum variance, `2 (n - 1)/n^2`.",
            equal(ALPHA - 2 * (N - 1) / N**2, 4 / (N**2 * (N + 2))),
            "Step @minimum-variance-gains with `x = n - 1`.",
            tower=SLOW,
        ),
        Step(
            "smoothed-border",
            "With `beta = 2` no filter is best: all smooth worse than a single measurement, whose "
            "variance is 1, and come as near to it as one likes towards `alpha = 1`, which is not "
            "stable.",
            positive(X11 - 1),
            "`x + y = 1` there.",
            tower=BORDER,
        ),
        joined(
            "smoothed-border-limit",
            limit(X11, "0", sp.Integer(1), variable="e"),
            tower=BORDER,
            hint={"ends": ends},
        ),
        joined(
            "smoothed-border-gains",
            equal(row(ALPHA, BETA, X11), row(1 / (1 + E), 2, smoothed_variance(ALPHA, BETA))),
            tower=BORDER,
        ),
    ]


def _fast() -> list[Step]:
    return [
        Step(
            "smoothed-fast-place",
            "The second square is 0 at `x = n (n - 1)/(2 - n)`, for `n` below 2. That filter is "
            "stable exactly if `beta > 2`.",
            same_sign(MARGIN, BETA - 2),
            "`y = (n - 1) (2 - n^2)/(2 - n)`.",
            tower=FAST,
        ),
        joined(
            "smoothed-fast-coordinates",
            equal(
                row(2 * ALPHA / BETA, MARGIN / BETA),
                row(N * (N - 1) / (2 - N), (N - 1) * (2 - N**2) / (2 - N)),
            ),
            tower=FAST,
        ),
        Step(
            "smoothed-fast-value",
            "So for each `beta` between 2 and 4 too there is just one best filter, with `2 "
            "sqrt(beta) (1 - alpha) = beta - 2 alpha`.",
            equal(
                row(X11 * ALPHA * MARGIN, RELATION),
                row(2 * ALPHA**2 + 2 * BETA - 3 * ALPHA * BETA, (2 * ALPHA - BETA) ** 2),
            ),
            "Insert.",
            tower=FAST,
        ),
        Step(
            "smoothed-fast-worse",
            "It smooths worse than a single measurement: only below 2 is there something to gain.",
            same_sign(X11 - 1, BETA - 2),
            "`3 - 2 n - (n - 1)^2 = 2 - n^2`.",
            tower=FAST,
        ),
    ]
