"""Steps on the four conversions in space: covariances, what they are exact for."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import column
from gainproof.derive.relation import equal
from gainproof.derive.sensors.converted_names import COS2, KEPT, SIGMA_A, SIGMA_R, SIN2, R
from gainproof.derive.sensors.converted_space_names import (
    BOTH,
    COS_E,
    ENTRY,
    KEPT_E,
    LA,
    LE,
    LEVEL,
    ONCE,
    SIGMA_E,
    SIN_E,
    TWICE,
    UPWARDS,
    WHOLE,
    WIDER,
)
from gainproof.derive.sensors.converted_space_steps import mean_square_error

CLASSICAL, DEBIASED, UNBIASED, MODIFIED = ENTRY.values()
MEANS = BOTH, KEPT_E
"""What noise keeps of the place ahead and of the height."""


def space_conversion_steps() -> list[Step]:
    """The four conversions, and their biases."""
    return [*_conversions(), *_biases()]


def _conversions() -> list[Step]:
    c1, s1, m1 = ONCE
    level, height = R * COS_E, R * SIN_E
    wide, high = 1 / BOTH, 1 / KEPT_E
    return [
        Step(
            "space-classical",
            "The classical covariance, to first order:",
            equal(
                column(*CLASSICAL),
                column(
                    COS_E**2 * SIGMA_R**2 + height**2 * SIGMA_E**2,
                    level**2 * SIGMA_A**2,
                    SIN_E**2 * SIGMA_R**2 + level**2 * SIGMA_E**2,
                    COS_E * SIN_E * (SIGMA_R**2 - R**2 * SIGMA_E**2),
                ),
            ),
            "As in the derivation polar-coordinates.",
            tower="space",
        ),
        Step(
            "space-debiased",
            "The debiased conversion's: the mean of `V`, given the measurement.",
            equal(column(*DEBIASED), column(*_average(sp.Integer(1), sp.Integer(1)))),
            "The true squared range has the mean `r_m^2 + sigma_r^2`, the elevation has its noise "
            "twice, and the azimuth's noise turns what is ahead and across.",
            tower="space",
        ),
        Step(
            "space-unbiased",
            "The unbiased conversion's mean square error given the measurement; `V` with the "
            "squares and the product of its biases.",
            equal(
                column(*UNBIASED),
                column(*mean_square_error()),
            ),
            "Of the converted less the true place.",
            tower="space",
        ),
        Step(
            "space-average",
            "What the Tracker Component Library states for the unbiased conversion in space, "
            "equations (11) of the paper, is the other matrix: the mean given the measurement of "
            "the covariance given the truth. Ahead, across, up, and of ahead and up:",
            equal(
                column(*_average(wide, high)),
                column(
                    (WIDER * (1 + LA**4) * TWICE[0] / BOTH**2) / 2 - WHOLE * (1 + LA**2) * c1 / 2,
                    (WIDER * (1 - LA**4) * TWICE[0] / BOTH**2) / 2 - WHOLE * (1 - LA**2) * c1 / 2,
                    WIDER * TWICE[1] / LE - WHOLE * s1,
                    KEPT * (WIDER * TWICE[2] / LE - WHOLE * m1),
                ),
            ),
            "The debiased conversion's entries times the factors of ahead and up: (11a) to (11f) "
            "at azimuth 0.",
            tower="space",
        ),
    ]


def _average(wide: sp.Expr, high: sp.Expr) -> tuple[sp.Expr, ...]:
    """The mean given the measurement of the covariance given the truth of places that are
    multiplied by `wide` ahead and across and by `high` up.
    """
    (c2, s2, m2), (c1, s1, m1) = TWICE, ONCE
    ahead = WIDER * c2 * COS2 - LA * LE * WHOLE * c1
    across = WIDER * c2 * SIN2
    return (
        wide**2 * (COS2 * ahead + SIN2 * across),
        wide**2 * (SIN2 * ahead + COS2 * across),
        high**2 * (WIDER * s2 - LE * WHOLE * s1),
        wide * high * LA * (WIDER * m2 - LE * WHOLE * m1),
    )


def _biases() -> list[Step]:
    less = 1 - BOTH, 1 - KEPT_E
    more = 1 + BOTH, 1 + KEPT_E
    rows = list(zip(LEVEL.values(), UPWARDS.values(), strict=True))
    return [
        Step(
            "space-factors",
            "All four multiply the measured place ahead by `f` and the height by `g`: classical, "
            "debiased, unbiased, modified.",
            equal(
                column(*LEVEL.values(), *UPWARDS.values()),
                column(
                    1, 1 + BOTH - BOTH**2, 1 / BOTH, BOTH, 1, 1 + KEPT_E - LE, 1 / KEPT_E, KEPT_E
                ),
            ),
            "As in the plane, with `lambda lambda_eta` ahead and `lambda_eta` up.",
            tower="space",
        ),
        Step(
            "space-bias-truth",
            "Mean errors given the truth, in parts of the true place ahead and of the height:",
            equal(
                sp.ImmutableDenseMatrix(
                    [[f * m - 1 for f, m in zip(each, MEANS, strict=True)] for each in rows]
                ),
                sp.ImmutableDenseMatrix(
                    [
                        [-less[0], -less[1]],
                        [-(less[0] ** 2) * more[0], -(less[1] ** 2) * more[1]],
                        [0, 0],
                        [-less[0] * more[0], -less[1] * more[1]],
                    ]
                ),
            ),
            "Only the unbiased conversion has none.",
            tower="space",
        ),
        Step(
            "space-bias-measured",
            "And given the measurement, in parts of the measured ones:",
            equal(
                sp.ImmutableDenseMatrix(
                    [[f - m for f, m in zip(each, MEANS, strict=True)] for each in rows]
                ),
                sp.ImmutableDenseMatrix(
                    [
                        [less[0], less[1]],
                        [less[0] * more[0], less[1] * more[1]],
                        [less[0] * more[0] / BOTH, less[1] * more[1] / KEPT_E],
                        [0, 0],
                    ]
                ),
            ),
            "Only the modified conversion has none, and only its covariance is that of its error.",
            tower="space",
        ),
    ]
