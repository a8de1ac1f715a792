"""Steps on the four conversions: where they put the place, and what covariance they state."""

from __future__ import annotations

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column
from gainproof.derive.relation import Relation, equal
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
    L,
    R,
)

WHOLE, WIDER = R**2 + SIGMA_R**2, R**2 + 2 * SIGMA_R**2
"""Means, given the measurement, of r^2 and of r^2 + sigma_r^2."""
MEAN_RADIAL = (WHOLE * (1 - L) ** 2 + SIGMA_R**2 * (1 + L**2)) / 2
MEAN_CROSS = WIDER * (1 - L**2) / 2


def conversion_steps() -> list[Step]:
    """All four put the place on the measured line of sight, at a multiple of the measured range."""
    return [*_classical(), *_debiased(), *_unbiased(), *_modified()]


def _classical() -> list[Step]:
    return [
        Step(
            "classical",
            "The classical conversion takes the measured place as it is; its covariance is that to "
            "first order in the noise.",
            equal(column(FACTOR["classical"], *STATED["classical"]), _linear()),
            "The map's derivatives along and across the line of sight are 1 and `r_m` (see "
            "polar-coordinates, step axes).",
            heading="The four conversions",
        )
    ]


def _linear() -> object:
    return column(1, SIGMA_R**2, R**2 * SIGMA_A**2)


def _debiased() -> list[Step]:
    return [
        Step(
            "debiased",
            "Lerro and Bar-Shalom (1993) take off the mean, given the measurement, of the bias "
            "that the raw conversion has given the truth.",
            equal(FACTOR["debiased"] * R, R - (KEPT - 1) * (KEPT * R)),
            "The bias is `lambda - 1` times the true place, of which the mean is `lambda` times "
            "the measured one.",
        ),
        Step(
            "debiased-mean",
            "Their covariance is the mean, given the measurement, of `V(r)`, turned as in step "
            "@average.",
            equal(
                column(*STATED["debiased"]),
                column(
                    COS2 * MEAN_RADIAL + SIN2 * MEAN_CROSS,
                    SIN2 * MEAN_RADIAL + COS2 * MEAN_CROSS,
                ),
            ),
            "In step @truth-spread `r^2` has the mean `r_m^2 + sigma_r^2`.",
        ),
        Step(
            "debiased-printed",
            "Printed it is with hyperbolic functions of `sigma_theta^2`, along and across: the "
            "same.",
            _hyperbolic(),
            "`cosh(k sigma_theta^2) = (lambda^(2k) + lambda^(-2k))/2`, sinh likewise; equations "
            "(13a) and (13b) at azimuth 0, as the Tracker Component Library transcribes them.",
        ),
        Step(
            "debiased-form",
            "Without cancellation:",
            equal(
                column(*STATED["debiased"]),
                column(
                    (WHOLE * (1 - L) ** 2 * (1 + L + L**2) + SIGMA_R**2 * (1 + L**4)) / 2,
                    (1 - L)
                    * (R**2 * (1 + L**3) + SIGMA_R**2 * (1 + L) * (1 + (1 - L) + 2 * L**2))
                    / 2,
                ),
            ),
            "Multiply out; `1 - lambda^2` is the only difference.",
        ),
    ]


def _hyperbolic() -> Relation:
    cosh = {k: (L**k + L**-k) / 2 for k in (1, 2)}
    sinh = {k: (L**-k - L**k) / 2 for k in (1, 2)}
    return equal(
        column(*STATED["debiased"]),
        column(
            L**2 * (R**2 * (cosh[2] - cosh[1]) + SIGMA_R**2 * (2 * cosh[2] - cosh[1])),
            L**2 * (R**2 * (sinh[2] - sinh[1]) + SIGMA_R**2 * (2 * sinh[2] - sinh[1])),
        ),
    )


def _unbiased() -> list[Step]:
    square = FACTOR["unbiased"] * R
    return [
        Step(
            "unbiased",
            "The unbiased conversion (Longbin et al. 1998) divides by `lambda`, which takes the "
            "whole bias away, given the truth.",
            equal(FACTOR["unbiased"] * (KEPT * TRUE), TRUE),
            "By step @truth-mean the mean was `lambda r`.",
        ),
        Step(
            "unbiased-mean-square",
            "The covariance (7) that goes with it is the mean square error given the measurement, "
            "with the square of the bias that there is then.",
            equal(
                column(*STATED["unbiased"]),
                column(
                    square**2 - 2 * square * (KEPT * R) + WHOLE * COS2,
                    WHOLE * SIN2,
                ),
            ),
            "Of the square of (converted less true place) along the line of sight: the mean of the "
            "true place is `lambda r_m`, that of its square `(r_m^2 + sigma_r^2) C`.",
        ),
        joined(
            "unbiased-bias",
            equal(
                column(*STATED["unbiased"]),
                column(SPREAD[0] + (square - KEPT * R) ** 2, SPREAD[1]),
            ),
        ),
        Step(
            "unbiased-form",
            "Without cancellation:",
            equal(
                column(*STATED["unbiased"]),
                column(
                    (R**2 * (1 - L) ** 2 * (2 + L) / L + SIGMA_R**2 * (1 + L**2)) / 2,
                    WHOLE * (1 - L) * (1 + L) / 2,
                ),
            ),
            "`1/lambda^2 - 2 + (1 + lambda^4)/2` has the double root `lambda^2 = 1`.",
        ),
        Step(
            "average-covariance",
            "Transcriptions of the same paper differ: some state, as that paper's other "
            "covariance (11), the mean given the measurement of the covariance given the truth, "
            "`V(r)/lambda^2`. It is another matrix `A`, and it is right about what it is.",
            equal(
                column(*STATED["average"]),
                column(
                    (COS2 * MEAN_RADIAL + SIN2 * MEAN_CROSS) / L,
                    (SIN2 * MEAN_RADIAL + COS2 * MEAN_CROSS) / L,
                ),
            ),
            "So `A` is the debiased conversion's covariance divided by `lambda^2`.",
        ),
        joined(
            "average-printed",
            equal(
                column(*STATED["average"]),
                column(
                    WIDER * (1 + L**4) / (2 * L) - WHOLE * COS2,
                    WIDER * (1 - L**4) / (2 * L) - WHOLE * SIN2,
                ),
            ),
        ),
        joined(
            "average-larger",
            equal(
                column(*STATED["average"]),
                column(STATED["debiased"][0] / L, STATED["debiased"][1] / L),
            ),
        ),
    ]


def _modified() -> list[Step]:
    return [
        Step(
            "modified",
            "The modified unbiased conversion (Duan, Han, Li 2004), that of (12) to (17) in patent "
            "JP 4869403, takes mean and covariance of the truth given the measurement.",
            equal(column(FACTOR["modified"] * R, *STATED["modified"]), column(KEPT * R, *SPREAD)),
            "Step @measured-mean. Both multiply the measured place, one by `lambda`, one by "
            "`1/lambda`: which one is unbiased depends on what is given.",
        ),
    ]
