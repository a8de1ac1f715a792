"""Steps on random velocity and random acceleration in the region of stability."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA, MARGIN
from gainproof.derive.fixed_gain.two_towers import X
from gainproof.derive.relation import equal, same_sign

ROOT = real("root_two")
RA, RV = "random_acceleration", "random_velocity"


def named_steps() -> list[Step]:
    """Where the two curves run."""
    return [*_velocity(), *_acceleration()]


def _velocity() -> list[Step]:
    return [
        Step(
            "random-velocity",
            "The relation of random velocity, `alpha (alpha + beta) = 2 beta`, is `y = (x^2 - "
            "2)/2`: a curve with `x` as parameter, one filter for each `alpha` below 2.",
            equal(row(ALPHA * (ALPHA + BETA), BETA), row(2 * BETA, ALPHA**2 / (2 - ALPHA))),
            "`alpha = 4/(x + 2)`, `beta = 8/(x (x + 2))`.",
            tower=RV,
            heading="Random velocity (RV) and random acceleration (RA)",
        ),
        joined("random-velocity-curve", equal(MARGIN / BETA, (X**2 - 2) / 2), tower=RV),
        joined("random-velocity-parameter", equal(X, 2 * ALPHA / BETA), tower=RV),
        Step(
            "random-velocity-stable",
            "It is stable exactly where `x > sqrt(2)`, which is `alpha < 4 - 2 sqrt(2)`, about "
            "1.17; at the border a root is -1.",
            same_sign(MARGIN, X - ROOT),
            "Insert; the coefficients `alpha` and `beta` are positive.",
            tower=RV,
            hint={"form": 4 * (X + ROOT) / (X * (X + 2))},
        ),
        joined(
            "random-velocity-stable-alpha",
            same_sign(4 - 2 * ROOT - ALPHA, X - ROOT),
            tower=RV,
            hint={"form": 2 * ROOT * (ROOT - 1) / (X + 2)},
        ),
        Step(
            "random-velocity-range",
            "As a Kalman filter it has `alpha < 1`, `x > 2`: there it is stable, and its poles are "
            "complex.",
            same_sign(1 - ALPHA, X - 2),
            "Step @discriminant: the discriminant has the sign of `2 - x`.",
            tower=RV,
        ),
        joined("random-velocity-poles", same_sign((ALPHA + BETA) ** 2 - 4 * BETA, 2 - X), tower=RV),
    ]


def _acceleration() -> list[Step]:
    return [
        Step(
            "random-acceleration",
            "That of random acceleration, `(alpha + beta/2)^2 = 2 beta`, is `y = (x^2 - 1)/2`.",
            equal((ALPHA + BETA / 2) ** 2, 2 * BETA),
            "`alpha = 4 x/(1 + x)^2`, `beta = 8/(1 + x)^2`.",
            tower=RA,
        ),
        joined("random-acceleration-curve", equal(MARGIN / BETA, (X**2 - 1) / 2), tower=RA),
        joined("random-acceleration-parameter", equal(X, 2 * ALPHA / BETA), tower=RA),
        Step(
            "random-acceleration-stable",
            "It is stable exactly where `x > 1`, which is `beta < 2`.",
            same_sign(MARGIN, X - 1),
            "Insert.",
            tower=RA,
        ),
        joined("random-acceleration-beta", same_sign(2 - BETA, X - 1), tower=RA),
        Step(
            "random-acceleration-range",
            "`alpha` reaches 1 there and only there: at `alpha = 1`, `beta = 2` a root is -1 and "
            "the filter is not stable.",
            equal(1 - ALPHA, (X - 1) ** 2 / (X + 1) ** 2),
            "A square.",
            tower=RA,
        ),
        joined("random-acceleration-border", equal(sp.Subs(MARGIN, X, 1), sp.Integer(0)), tower=RA),
        Step(
            "random-acceleration-index",
            "The margin is `4 sqrt(1 - alpha)`. With the tracking index of its Kalman filter, "
            "`beta/sqrt(1 - alpha)`, therefore, `y` is 4 over the index: next to the border the "
            "index tells what rounded gains do not.",
            equal(
                row(MARGIN**2, (MARGIN / BETA) ** 2),
                row(16 * (1 - ALPHA), 16 * (1 - ALPHA) / BETA**2),
            ),
            "Insert.",
            tower=RA,
        ),
        Step(
            "random-acceleration-twice",
            "Each `alpha` below 1 belongs to two solutions of the relation, `x` and `1/x`: the one "
            "with the larger `beta` is unstable. So the relation and `0 < alpha < 1` alone do not "
            "make a filter stable; `beta < 2` does.",
            equal(sp.Subs(ALPHA, X, 1 / X), ALPHA),
            "Insert.",
            tower=RA,
        ),
        Step(
            "random-acceleration-poles",
            "Its poles are real for `x` up to `sqrt(2)`, which is `alpha >= 12 sqrt(2) - 16`, "
            "about 0.97, and complex beyond.",
            same_sign((ALPHA + BETA) ** 2 - 4 * BETA, 2 - X**2),
            "Step @discriminant.",
            tower=RA,
        ),
    ]
