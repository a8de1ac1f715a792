"""Steps on random acceleration and random jerk among alpha-beta-gamma filters."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.steps_answer import Z
from gainproof.derive.fixed_gain.three_steps_optimum import P11, discriminant, lecture_variance
from gainproof.derive.fixed_gain.three_steps_stability import (
    ALPHA,
    BETA,
    DETERMINANT,
    GAMMA,
    MARGIN,
)
from gainproof.derive.fixed_gain.three_towers import LOOP, X
from gainproof.derive.relation import equal, positive, same_sign

RA, RJ = "random_acceleration", "random_jerk"


def named_steps() -> list[Step]:
    """Random acceleration and random jerk."""
    return [*_acceleration(), *_jerk()]


def _acceleration() -> list[Step]:
    return [
        Step(
            "random-acceleration",
            "The relations of random acceleration, `alpha (alpha + beta + gamma/2) = 2 beta` and "
            "`beta^2 = 2 alpha gamma`, are a curve with `x = 2 beta/gamma` as parameter.",
            equal(
                row(ALPHA * (ALPHA + BETA + GAMMA / 2), BETA**2, X),
                row(2 * BETA, 2 * ALPHA * GAMMA, 2 * BETA / GAMMA),
            ),
            "The second is `y = x^2/2 - 1`; the first then gives `d = x (x^2 - 4)/8`.",
            tower=RA,
            heading="Random acceleration (RA) and random jerk (RJ)",
        ),
        joined(
            "random-acceleration-coordinates",
            equal(
                row((4 * ALPHA - GAMMA) / GAMMA, 2 * MARGIN / GAMMA),
                row(X**2 / 2 - 1, X * (X**2 - 4) / 8),
            ),
            tower=RA,
        ),
        Step(
            "random-acceleration-stable",
            "It is stable exactly where `x > 2`; the last inequality needs `3 x^2 > 4` only.",
            same_sign(MARGIN, X - 2),
            "Insert; the other quantities are positive.",
            tower=RA,
        ),
        joined("random-acceleration-determinant", same_sign(DETERMINANT, 3 * X**2 - 4), tower=RA),
        Step(
            "random-acceleration-range",
            "`alpha` reaches 1 at that border only. Each `alpha` below 1 belongs to `x` and `4/x`, "
            "of which the second is unstable.",
            equal(1 - ALPHA, (X - 2) ** 2 / (X + 2) ** 2),
            "A square.",
            tower=RA,
        ),
        joined("random-acceleration-twice", equal(sp.Subs(ALPHA, X, 4 / X), ALPHA), tower=RA),
        Step(
            "random-acceleration-index",
            "The margin is `4 sqrt(1 - alpha)`. With the tracking index of its Kalman filter, "
            "`gamma/sqrt(1 - alpha)`, therefore, `d` is 8 over the index: next to the border the "
            "index tells what rounded gains do not.",
            equal(
                row(MARGIN**2, (2 * MARGIN / GAMMA) ** 2),
                row(16 * (1 - ALPHA), 64 * (1 - ALPHA) / GAMMA**2),
            ),
            "Insert.",
            tower=RA,
        ),
        Step(
            "random-acceleration-roots",
            "Its poles in closed form: one is `(x - 2)/(x + 2)`, of the stable ones `sqrt(1 - "
            "alpha)`; the others are the zeros of the second factor.",
            equal(
                (Z * (X + 2) - (X - 2))
                * (Z**2 * (X**2 + 2 * X) - 2 * Z * (X**2 - 8) + X**2 - 2 * X),
                X * (X + 2) ** 2 * LOOP.polynomial(Z),
                free=("z",),
            ),
            "`1 + x s + y s^2 + d s^3 = (1 + x s/2) (1 + x s/2 + (x^2 - 4) s^2/4)`.",
            tower=RA,
        ),
        Step(
            "random-acceleration-poles",
            "All poles of a stable one are real up to `x = 4/sqrt(3)`, beyond two are complex.",
            equal(
                discriminant(),
                GAMMA**4 / 64 * (X**2 - 4) ** 2 * (16 - 3 * X**2) / 64,
            ),
            "Step @discriminant.",
            tower=RA,
        ),
        Step(
            "random-acceleration-variance",
            "The variance of the stable ones, `x = 2 + e`.",
            equal(P11, lecture_variance()),
            "Insert.",
            tower="stable_acceleration",
            shown=False,
        ),
        Step(
            "random-acceleration-stable-relations",
            "Their relations.",
            equal(
                row(ALPHA * (ALPHA + BETA + GAMMA / 2), BETA**2),
                row(2 * BETA, 2 * ALPHA * GAMMA),
            ),
            "Insert.",
            tower="stable_acceleration",
            shown=False,
        ),
    ]


def _jerk() -> list[Step]:
    x = real("x")
    return [
        Step(
            "random-jerk",
            "Those of random jerk, `2 alpha gamma - beta^2 = gamma^2/12` and `2 alpha^2 + 2 alpha "
            "beta - 4 beta + alpha gamma = gamma^2/18`, are one too: its gains are rational in "
            "`x = 2 beta/gamma`, here above 1, as for all stable ones.",
            equal(
                row(
                    2 * ALPHA * GAMMA - BETA**2,
                    2 * ALPHA**2 + 2 * ALPHA * BETA - 4 * BETA + ALPHA * GAMMA,
                    x,
                ),
                row(GAMMA**2 / 12, GAMMA**2 / 18, 2 * BETA / GAMMA),
            ),
            "The first is `y = x^2/2 - 5/6`, the second then linear in `d`.",
            tower=RJ,
        ),
        joined(
            "random-jerk-coordinates",
            equal(
                row((4 * ALPHA - GAMMA) / GAMMA, 2 * MARGIN / GAMMA),
                row(x**2 / 2 - sp.Rational(5, 6), (3 * x**4 - 10 * x**2 - 1) / (24 * x)),
            ),
            tower=RJ,
        ),
        joined(
            "random-jerk-gains",
            equal(
                row(ALPHA, BETA, GAMMA),
                row(
                    *(
                        top / (3 * x**4 + 12 * x**3 + 14 * x**2 + 4 * x - 1)
                        for top in (8 * x * (3 * x**2 + 1), 96 * x**2, 192 * x)
                    )
                ),
            ),
            tower=RJ,
        ),
        Step(
            "random-jerk-stable",
            "It is stable exactly where `3 x^4 > 10 x^2 + 1`, `x^2 > (5 + 2 sqrt(7))/3`.",
            same_sign(MARGIN, 3 * x**4 - 10 * x**2 - 1),
            "Insert; the last inequality is `(9 x^2 - 1)(x^2 - 1) > 0`.",
            tower=RJ,
        ),
        joined("random-jerk-determinant", positive(DETERMINANT), tower=RJ),
        Step(
            "random-jerk-range",
            "As a Kalman filter it has `alpha < 1`, which is `3 x^2 > 6 x + 1`, `x > 1 + "
            "2/sqrt(3)`: there it is stable, and two poles are complex.",
            same_sign(1 - ALPHA, 3 * x**2 - 6 * x - 1),
            "`(1 - alpha)` has the factor `(x - 1)^2` besides. With `x >= 2.15` every factor of "
            "the "
            "discriminant but the sign is positive.",
            tower=RJ,
        ),
        joined(
            "random-jerk-poles",
            equal(
                discriminant(),
                -(GAMMA**4)
                / 64
                * (3 * x**2 - 6 * x - 1)
                * (3 * x**2 + 6 * x - 1)
                * ((3 * x**2 - 9) ** 2 - 4 * x**2)
                / (1728 * x**2),
            ),
            tower=RJ,
        ),
    ]
