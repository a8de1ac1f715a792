"""Steps that find the variances of the position, and the gains."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.relation import equal
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    CROSS,
    DELTA,
    INDEX,
    MEAN,
    RATIO,
    REST,
    SIGMA,
    UPDATED,
    gain_matrix,
    row,
    symmetric,
)
from gainproof.derive.vector_measurement.steps_entries import P11, P12, P22, U11, U12, U22
from gainproof.derive.vector_measurement.towers import rational


def position_steps(c: Context) -> list[Step]:
    """The position's variances and the gains."""
    step = 2 * U12 + U22 + rational(c.noise.first) * INDEX**2
    return [
        Step(
            "position",
            "The position's variances are found like those of the velocity, and again differ by "
            "`sigma` in the place of `1/sigma`.",
            equal(
                row(DELTA * U11, DELTA * P11),
                row(REST + step / SIGMA, REST + step * SIGMA),
            ),
            "`P11 = sigma^2 (U11 - det U/S^2)` by step @inverse, `P11 - U11` from step "
            "@prediction, and `det U = S^2 g/sigma`.",
        ),
        Step(
            "gain",
            "The gain is `U` over the variances of the measurements. In the model's own units "
            "`K12` is multiplied by `T` and `K21` divided by it.",
            equal(
                sp.MatMul(gain_matrix(), c.model.measurement_noise, evaluate=False),
                symmetric(UPDATED),
            ),
            "`K = U R^-1` (step @filter), times `R`.",
        ),
        Step(
            "gain-remainders",
            "What the gains on the diagonal leave to 1 needs no subtraction either.",
            equal(
                row(1 - U11, 1 - U22 / RATIO**2),
                row(
                    (P22 + RATIO**2) / (RATIO**2 * SIGMA**2),
                    (P11 + 1) / SIGMA**2,
                ),
            ),
            "`I - K = R (P + R)^-1`, and `det(P + R) = sigma^2 S^2` by step @at-zero; "
            "`K11 = U11` and `K22 = U22/S^2`.",
        ),
        Step(
            "sum-of-cross",
            "Sum, difference and product of the cross covariances.",
            equal(
                row(P12 + U12, P12 - U12, P12 * U12),
                row(MEAN * CROSS, DELTA * CROSS, CROSS**2),
            ),
            "Step @cross with `m = sigma + 1/sigma` and `delta = sigma - 1/sigma`.",
        ),
    ]
