"""Steps on the noise of converted measurements: first order, and the mean exactly."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column, real
from gainproof.derive.relation import cited, equal
from gainproof.derive.sensors.polar_names import (
    COS_B,
    COS_E,
    KEPT_B,
    KEPT_E,
    LOSS_B,
    LOSS_E,
    SIGMA_B,
    SIGMA_E,
    SIGMA_R,
    SIN_B,
    SIN_E,
    H,
    R,
    X,
    Y,
    Z,
    by_angles,
    covariance,
)
from gainproof.derive.sensors.polar_steps_jacobian import frame, jacobian
from gainproof.derive.source import ELEMENTARY, PROBABILITY

Matrix = sp.ImmutableDenseMatrix
VARIANCES = (SIGMA_R**2, SIGMA_E**2, SIGMA_B**2)
MEAN = column(real("mean_x"), real("mean_y"), real("mean_z"))
BIAS = column(real("bias_x"), real("bias_y"), real("bias_z"))


def covariance_steps() -> list[Step]:
    """To first order."""
    p, j, u = covariance(), jacobian(), frame()
    lengths = sp.diag(SIGMA_R**2, R**2 * SIGMA_E**2, H**2 * SIGMA_B**2).as_immutable()
    ahead = COS_E**2 * SIGMA_R**2 + SIN_E**2 * R**2 * SIGMA_E**2
    across = H**2 * SIGMA_B**2
    steep = COS_E * SIN_E * (SIGMA_R**2 - R**2 * SIGMA_E**2)
    return [
        Step(
            "covariance",
            "Range, elevation and bearing are measured with independent noises of standard "
            "deviations `sigma_R`, `sigma_E`, `sigma_B`. To first order in these the converted "
            "position has the covariance `P`.",
            equal(
                p,
                sp.MatMul(
                    j, sp.diag(*VARIANCES).as_immutable(), j.T.as_immutable(), evaluate=False
                ),
            ),
            "Linearise the map: the error of the position is `J` times that of the measurement. "
            "With `J` at the true place this is the covariance to first order; what a tracker has "
            "is `J` at the measured place, an estimate of it.",
            heading="Noise to first order",
        ),
        Step(
            "axes",
            "Its axes are those of the sensor, with deviations `sigma_R` along the line of sight, "
            "`R sigma_E` and `h sigma_B` across it.",
            equal(p, sp.MatMul(u, lengths, u.T.as_immutable(), evaluate=False)),
            "Insert step @frame.",
        ),
        Step(
            "covariance-entries",
            "Entry by entry: variances are sums of squares. Covariances are differences of "
            "squares, since they change their sign; the difference in brackets is the only one.",
            equal(
                Matrix([[p[0, 0], p[1, 1], p[2, 2], p[0, 1], p[0, 2], p[1, 2]]]),
                Matrix(
                    [
                        [
                            SIN_B**2 * ahead + COS_B**2 * across,
                            COS_B**2 * ahead + SIN_B**2 * across,
                            SIN_E**2 * SIGMA_R**2 + COS_E**2 * R**2 * SIGMA_E**2,
                            SIN_B * COS_B * (ahead - across),
                            SIN_B * steep,
                            COS_B * steep,
                        ]
                    ]
                ),
            ),
            "Multiply out step @axes; in brackets stand the variances ahead and across as seen "
            "from above.",
        ),
        Step(
            "volume",
            "The squares of these are its eigenvalues, and the directions of step @frame its "
            "eigenvectors: so it is positive definite where all three deviations are above zero.",
            equal(p[0, 0] + p[1, 1] + p[2, 2], sum(lengths.diagonal())),
            "Multiply step @axes by the frame (step @orthonormal). Their sum is the trace.",
        ),
    ]


def mean_steps() -> list[Step]:
    """What the first order misses."""
    named = column(*map(real, ("kept_level", "kept_upwards", "change_level", "change_upwards")))
    return [
        Step(
            "gaussian",
            "Now exactly, for Gaussian noise of the angles.",
            cited(
                "For Gaussian n of mean 0 and standard deviation s the mean of cos n is "
                "exp(-s^2/2) and that of sin n is 0.",
                PROBABILITY.text(),
            ),
            "The characteristic function of the normal distribution at 1. "
            "`lambda_E` and `lambda_B` are these means, numbers above 0 and up to 1.",
            heading="The mean of a converted measurement",
        ),
        Step(
            "kept",
            "Whatever the deviations, these are `1/(1 + l)` with `l` from 0 on.",
            equal(column(KEPT_E, KEPT_B), column(1 / (1 + LOSS_E), 1 / (1 + LOSS_B))),
            "Every number above 0 and up to 1 is of this form, once.",
        ),
        Step(
            "mean",
            "The mean of the converted position: every factor stands for its own mean.",
            equal(
                MEAN,
                column(
                    R * (KEPT_E * COS_E) * (KEPT_B * SIN_B),
                    R * (KEPT_E * COS_E) * (KEPT_B * COS_B),
                    R * (KEPT_E * SIN_E),
                ),
            ),
            "The cosine of a sum is a product of cosines less one of sines, whose mean vanishes: "
            "of the noisy elevation's cosine the mean is `lambda_E c_E`, and so on. The noises are "
            "independent, so that means multiply; the range needs only a noise of mean 0.",
        ),
        Step(
            "bias",
            "So the converted position is biased towards the vertical axis and towards the "
            "horizontal plane: mean less true place, which vanishes with the noise.",
            equal(
                BIAS,
                column((KEPT_E * KEPT_B - 1) * X, (KEPT_E * KEPT_B - 1) * Y, (KEPT_E - 1) * Z),
            ),
            "Subtract step @map.",
        ),
        joined(
            "bias-is", equal(BIAS, column(*(m - t for m, t in zip(MEAN, (X, Y, Z), strict=True))))
        ),
        Step(
            "kept-names",
            "What the kernels take exponentials for.",
            equal(named, column(KEPT_E * KEPT_B, KEPT_E, KEPT_E * KEPT_B - 1, KEPT_E - 1)),
            "`exp(-(s_1^2 + s_2^2)/2)` is a product; `expm1` is `exp` less 1.",
            shown=False,
        ),
        Step(
            "shorter",
            "What the mean lacks of the true squared distance is a sum without a minus sign: it "
            "is never farther away, and as far only without noise.",
            equal(
                R**2 - (MEAN[0] ** 2 + MEAN[1] ** 2 + MEAN[2] ** 2),
                R**2 * ((1 - KEPT_E**2) * SIN_E**2 + (1 - KEPT_E**2 * KEPT_B**2) * COS_E**2),
            ),
            "Neither mean is above 1.",
        ),
        Step(
            "curvature",
            "To second order the bias comes from the second derivatives of the map:",
            equal(
                Matrix([[_second(each, which) for which in (0, 1)] for each in (X, Y, Z)]),
                Matrix([[-X, -X], [-Y, -Y], [-Z, sp.Integer(0)]]),
            ),
            "Half of `sigma_E^2` times the first column plus `sigma_B^2` times the second: "
            "`-(sigma_E^2 + sigma_B^2)/2` of `x` and `y`, `-sigma_E^2/2` of `z`. The range enters "
            "linearly.",
        ),
        joined(
            "range-linear",
            equal(column(*(sp.Derivative(each, (R, 2)) for each in (X, Y, Z))), column(0, 0, 0)),
        ),
        Step(
            "series",
            "It is the first term of the series of the exact bias, and a little too large.",
            cited(
                "For t >= 0: 1 - t <= exp(-t) <= 1 - t + t^2/2.",
                ELEMENTARY.text(),
            ),
            "With `t = (sigma_E^2 + sigma_B^2)/2` the bias of `x` is `-t x`, less by a share of "
            "at most `t/2`.",
        ),
    ]


def _second(expression: sp.Expr, which: int) -> sp.Expr:
    """The second derivative by the elevation or the bearing."""
    return by_angles(by_angles(expression)[which])[which]
