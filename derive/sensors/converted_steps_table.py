"""Steps on bias and covariance of every conversion, given the truth and given the measurement."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column
from gainproof.derive.relation import equal, positive, same_sign
from gainproof.derive.sensors.converted_names import (
    COS2,
    FACTOR,
    KEPT,
    SIGMA_A,
    SIGMA_R,
    SIN2,
    SPREAD,
    STATED,
    TRUE,
    TRUE_SPREAD,
    L,
    R,
)

ORDER = ("classical", "debiased", "unbiased", "modified")
SECOND = TRUE**2 + SIGMA_R**2
ESTIMATE = (
    R**2 / L - (R**2 - SIGMA_R**2) * (1 + L**2) / (2 * L**2),
    (R**2 - SIGMA_R**2) * (1 - L**2) / (2 * L**2),
)
"""Whose mean given the truth is the unbiased conversion's covariance."""


def table_steps() -> list[Step]:
    """Mean errors and covariances."""
    turned = R**2 * L * (1 - L)
    return [
        Step(
            "bias-truth",
            "Mean errors given the truth, in the order classical, debiased, unbiased, modified: "
            "along the line of sight, in true ranges.",
            equal(
                column(*(FACTOR[name] * (KEPT * TRUE) - TRUE for name in ORDER)),
                column(
                    -(1 - KEPT) * TRUE,
                    -((1 - KEPT) ** 2) * (1 + KEPT) * TRUE,
                    0,
                    -(1 - KEPT) * (1 + KEPT) * TRUE,
                ),
            ),
            "Only the unbiased conversion has none. The debiased one leaves the share "
            "`1 - lambda^2` of the classical bias, to first order `sigma_theta^2`; the modified "
            "one has about twice that of the classical.",
            heading="What each is exact for",
        ),
        Step(
            "bias-measured",
            "Mean errors given the measurement, in measured ranges, in the same order.",
            equal(
                column(*(FACTOR[name] * R - KEPT * R for name in ORDER)),
                column(
                    (1 - KEPT) * R,
                    (1 - KEPT) * (1 + KEPT) * R,
                    (1 - KEPT) * (1 + KEPT) * R / KEPT,
                    0,
                ),
            ),
            "Only the modified conversion has none. Debiasing doubles what the classical one has.",
        ),
        Step(
            "covariance-truth",
            "Covariances of the error given the truth: those of the raw conversion, times the "
            "square of the factor.",
            equal(
                sp.ImmutableDenseMatrix(
                    [
                        [
                            FACTOR[name] ** 2 * SECOND * COS2 - (FACTOR[name] * KEPT * TRUE) ** 2,
                            FACTOR[name] ** 2 * SECOND * SIN2,
                        ]
                        for name in ORDER
                    ]
                ),
                sp.ImmutableDenseMatrix(
                    [[f * f * each for each in TRUE_SPREAD] for f in _factors()]
                ),
            ),
            "The truth is a number then. None of the stated covariances is this one: they are "
            "functions of the measurement.",
        ),
        Step(
            "covariance-measured",
            "Given the measurement the converted place is a number, and the covariance of the "
            "error is `V`, whatever the conversion. Of the stated ones these parts are missing, "
            "along and across, in the same order:",
            equal(
                sp.ImmutableDenseMatrix(
                    [[SPREAD[axis] - STATED[name][axis] for axis in (0, 1)] for name in ORDER]
                ),
                sp.ImmutableDenseMatrix(
                    [
                        [
                            (1 - L) * (R**2 * (1 - L) - SIGMA_R**2 * (1 + L)) / 2,
                            (R**2 + SIGMA_R**2) * (1 - L**2) / 2 - R**2 * SIGMA_A**2,
                        ],
                        [
                            (1 - L) * (SIGMA_R**2 * (2 * L**3 + L**2 - 1) - turned * (1 + L)) / 2,
                            (1 - L**2) * (turned - SIGMA_R**2 * (2 * L**2 - L + 1)) / 2,
                        ],
                        [-(R**2) * (1 - L) ** 2 / L, sp.Integer(0)],
                        [sp.Integer(0), sp.Integer(0)],
                    ]
                ),
            ),
            "Only the modified conversion states its covariance. The unbiased one adds the square "
            "of its bias, so that what it states is right as a mean square error.",
        ),
        Step(
            "classical-radial",
            "The classical covariance is too small along the line of sight just where the range "
            "is long: beyond `sigma_r sqrt((1 + lambda^2)/(1 - lambda^2))`, that is where "
            "`r^2 tanh(sigma_theta^2/2) > sigma_r^2`.",
            same_sign(SPREAD[0] - STATED["classical"][0], R**2 * (1 - L) - SIGMA_R**2 * (1 + L)),
            "The factor between them is `(1 - lambda^2)/2`. Across the line of sight "
            "`sigma_theta^2` exceeds `(1 - lambda^4)/2` by step @expm1: far away the classical "
            "covariance is too large there.",
            hint={"form": (1 - L) / 2},
        ),
        *_definite(),
        *_estimate(),
    ]


def _factors() -> list[sp.Expr]:
    return [sp.Integer(1), 1 + KEPT - KEPT**2, 1 / KEPT, KEPT]


def _definite() -> list[Step]:
    """Where the stated covariances are covariances."""
    return [
        Step(
            "definite",
            "All of these are positive definite whatever the noise: variances along and across the "
            "line of sight are above zero.",
            positive(STATED["classical"][0]),
            "Sums of positive terms: steps @debiased-form, @unbiased-form and @measured-spread. "
            "Without noise of the azimuth nothing is left across the line of sight.",
        ),
        *(
            joined(f"definite-{name}-{axis}", positive(STATED[name][number]))
            for name in (*ORDER, "average")
            for number, axis in enumerate(("radial", "cross"))
            if (name, axis) != ("classical", "radial")
        ),
    ]


def _estimate() -> list[Step]:
    mean = (SECOND / L, SECOND)
    trace, off = mean[0] - TRUE**2, mean[0] - TRUE**2 / L**2
    return [
        Step(
            "estimate",
            "Is there a function of the measurement whose mean given the truth is the unbiased "
            "conversion's covariance `V(r)/lambda^2`? There is, diagonal in the measured frame, "
            "its entries added and subtracted being",
            equal(
                column(ESTIMATE[0] + ESTIMATE[1], ESTIMATE[0] - ESTIMATE[1]),
                column(R**2 / L - (R**2 - SIGMA_R**2), R**2 / L - (R**2 - SIGMA_R**2) / L**2),
            ),
            "Given the truth `r_m^2 - sigma_r^2` has the mean `r^2`, and of entries subtracted and "
            "turned by the noise `lambda^4` is left (step @average): so their means are twice "
            "`V(r)/lambda^2`, along and across.",
        ),
        joined(
            "estimate-mean",
            equal(
                column(trace + KEPT**4 * off, trace - KEPT**4 * off),
                column(2 * TRUE_SPREAD[0] / L, 2 * TRUE_SPREAD[1] / L),
            ),
        ),
        Step(
            "estimate-limit",
            "But it is a covariance only between two ranges. Along the line of sight it is "
            "negative where `(1 - lambda^2)^2 r_m^2 > (1 + lambda^4) sigma_r^2`, that is where "
            "`cosh(sigma_theta^2) (1 - sigma_r^2/r_m^2) > 1`; across it, where `r_m < sigma_r`.",
            same_sign(ESTIMATE[0], SIGMA_R**2 * (1 + L**2) - R**2 * (1 - L) ** 2),
            "The factors between them are `1/(2 lambda^4)` and, as `lambda < 1`, "
            "`(1 - lambda^4) (r_m + sigma_r)/(2 lambda^4)`. For small noise the first is "
            "`r_m sigma_theta^2 > sqrt(2) sigma_r`: at 50 m and 1 degree beyond 232 km.",
            hint={"form": 1 / (2 * L**2)},
        ),
        joined(
            "estimate-limit-across",
            same_sign(ESTIMATE[1], R - SIGMA_R),
            hint={"form": (1 - L) * (1 + L) * (R + SIGMA_R) / (2 * L**2)},
        ),
    ]
