"""Steps on how the covariance of every conversion changes with range."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import equal, limit, monotone, same_sign
from gainproof.derive.sensors.converted_names import SIGMA_A, SIGMA_R, STATED, L, R

NAMES = ("classical", "debiased", "unbiased", "modified")
ENDS = {"0": End(), "infinity": End()}
GROWTH = {
    "classical": (sp.Integer(0), SIGMA_A**2),
    "debiased": (
        (1 - L) ** 2 * (1 + L + L**2) / 2,
        (1 - L) * (1 + L**3) / 2,
    ),
    "unbiased": ((1 - L) ** 2 * (2 + L) / (2 * L), (1 - L) * (1 + L) / 2),
    "modified": ((1 - L) ** 2 / 2, (1 - L) * (1 + L) / 2),
}
"""What r_m^2 is times in each covariance, along and across the line of sight."""
START = {
    "classical": (SIGMA_R**2, sp.Integer(0)),
    "debiased": (
        SIGMA_R**2 * ((1 - L) ** 2 * (1 + L + L**2) + 1 + L**4) / 2,
        SIGMA_R**2 * (1 - L**2) * (2 - L + 2 * L**2) / 2,
    ),
    "unbiased": (SIGMA_R**2 * (1 + L**2) / 2, SIGMA_R**2 * (1 - L**2) / 2),
    "modified": (SIGMA_R**2 * (1 + L**2) / 2, SIGMA_R**2 * (1 - L**2) / 2),
}
"""What is left at range 0."""


def range_steps() -> list[Step]:
    """Growth, limits, and where the two deviations are equal."""
    return [
        Step(
            "growth",
            "Each variance is a number plus a multiple of the squared range; along and across the "
            "line of sight, in the order classical, debiased, unbiased, modified, they grow with "
            "the range at the rates",
            equal(
                _rows(lambda name, axis: sp.Derivative(STATED[name][axis], R)),
                _rows(lambda name, axis: 2 * R * GROWTH[name][axis]),
            ),
            "Differentiate the forms without cancellation.",
            heading="How covariances change with range",
        ),
        Step(
            "start",
            "At range 0 they are",
            equal(
                _rows(lambda name, axis: STATED[name][axis] - R**2 * GROWTH[name][axis]),
                _rows(lambda name, axis: START[name][axis]),
            ),
            "Subtract what grows. So the covariance of every conversion changes with the range, as "
            "patent JP 4869403 says; only the classical variance along the line of sight does not.",
        ),
        Step(
            "increasing",
            "Every variance but that one increases strictly with the range, and so do the "
            "variances of x and y, sums of these with the squares of cosine and sine.",
            monotone(STATED["classical"][1], "increasing", "slant_range"),
            "Step @growth: the rates are positive.",
        ),
        *(
            joined(
                f"increasing-{name}-{axis}",
                monotone(STATED[name][number], "increasing", "slant_range"),
            )
            for name in NAMES[1:]
            for number, axis in enumerate(("radial", "cross"))
        ),
        Step(
            "far",
            "Far away the ratio of variances across and along the line of sight tends to a number "
            "that is the noise's alone; of the modified conversion to "
            "`(1 + lambda^2)/(1 - lambda^2)`, the cotangent hyperbolic of `sigma_theta^2/2`.",
            limit(
                STATED["modified"][1] / STATED["modified"][0],
                "infinity",
                (1 + L) / (1 - L),
                "slant_range",
            ),
            "The quotient of the factors of `r_m^2`. Of the classical one it grows without bound.",
            hint={"ends": ENDS},
        ),
        joined(
            "far-unbiased",
            limit(
                STATED["unbiased"][1] / STATED["unbiased"][0],
                "infinity",
                L * (1 + L) / ((1 - L) * (2 + L)),
                "slant_range",
            ),
            hint={"ends": ENDS},
        ),
        joined(
            "far-debiased",
            limit(
                STATED["debiased"][1] / STATED["debiased"][0],
                "infinity",
                (1 + L**3) / ((1 - L) * (1 + L + L**2)),
                "slant_range",
            ),
            hint={"ends": ENDS},
        ),
        *_crossing(),
    ]


def _rows(entry: Callable[[str, int], sp.Expr]) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([[entry(name, axis) for axis in (0, 1)] for name in NAMES])


def _crossing() -> list[Step]:
    def more(name: str) -> sp.Expr:
        return STATED[name][1] - STATED[name][0]

    return [
        Step(
            "crossing",
            "Where is the error across the line of sight the larger one? With the modified "
            "conversion beyond the range `sigma_r lambda/sqrt(1 - lambda^2)`, that is "
            "`sigma_r/sqrt(exp(sigma_theta^2) - 1)`, a little before the classical conversion's "
            "`sigma_r/sigma_theta`.",
            same_sign(more("modified"), R**2 * (1 - L) - SIGMA_R**2 * L),
            "The difference is `lambda^2` times this. There the covariance of x and y changes its "
            "sign, and the variances of x and y do not depend on the azimuth.",
            hint={"form": L},
        ),
        joined(
            "crossing-classical",
            same_sign(more("classical"), R * SIGMA_A - SIGMA_R),
            hint={"form": R * SIGMA_A + SIGMA_R},
        ),
        Step(
            "crossing-debiased",
            "With the debiased conversion beyond the range "
            "`sigma_r sqrt((2 lambda^2 - 1)/(1 - lambda^2))`; at every range if "
            "`lambda^2 <= 1/2`, which is noise of `sqrt(ln 2) = 0.833` or more.",
            same_sign(more("debiased"), R**2 * (1 - L) - SIGMA_R**2 * (2 * L - 1)),
            "The factor between them is `lambda^6`.",
            hint={"form": L**3},
        ),
        Step(
            "crossing-unbiased",
            "With the unbiased conversion's mean square error beyond the range "
            "`sigma_r sqrt(lambda^6/((1 - lambda^2)(lambda^4 + lambda^2 - 1)))`; at no range if "
            "`lambda^4 + lambda^2 <= 1`, which is noise of "
            "`sqrt(ln((1 + sqrt 5)/2)) = 0.694` or more.",
            same_sign(
                more("unbiased"),
                R**2 * (1 - L) * (L**2 + L - 1) - SIGMA_R**2 * L**3,
            ),
            "The factor between them is `1/lambda^2`: then the squared bias along the line of "
            "sight is the larger part everywhere.",
            hint={"form": 1 / L},
        ),
    ]
