"""Steps that solve for the entries of both covariances and for the gains."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    COUPLING,
    CROSS,
    DELTA,
    ETA,
    INDEX,
    MEAN,
    PREDICTED,
    RATIO,
    REST,
    SIGMA,
    SPEED,
    UPDATED,
    gain_matrix,
    symmetric,
)
from gainproof.derive.vector_measurement.towers import rational

P11, P12, P22 = map(real, PREDICTED)
U11, U12, U22 = map(real, UPDATED)
DETERMINANT = U11 * U22 - U12**2


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([list(entries)])


def cross_steps(c: Context) -> list[Step]:
    """The cross covariances: one linear equation for their geometric mean h."""
    n, area = rational(c.noise.n), INDEX**2
    noise = c.noise
    return [
        Step(
            "inverse",
            "Written for the inverses, the update P^-1 = U^-1 - R^-1 is linear; the adjugates give "
            "each predicted entry from the updated ones.",
            equal(
                _row(P11, P12, P22),
                _row(
                    SIGMA**2 * (U11 - DETERMINANT / RATIO**2),
                    SIGMA**2 * U12,
                    SIGMA**2 * (U22 - DETERMINANT),
                ),
            ),
            "det P = sigma^2 det U, and R = diag(1, S^2).",
        ),
        Step(
            "cross",
            "So both cross covariances have one geometric mean h; sigma divides them.",
            equal(_row(P12, U12), _row(CROSS * SIGMA, CROSS / SIGMA)),
            "P12 = sigma^2 U12; put h = sigma U12.",
        ),
        Step(
            "prediction",
            "The prediction P = F U F' + Lambda^2 Q0, entry by entry.",
            equal(
                _row(P11, P12, P22),
                _row(
                    U11 + 2 * U12 + U22 + rational(noise.first) * area,
                    U12 + U22 + n * area,
                    U22 + area,
                ),
            ),
            "Multiply out.",
        ),
        Step(
            "velocity-from-cross",
            "Its cross entry ties the velocity's variance to h.",
            equal(_row(DELTA * CROSS, DELTA * CROSS), _row(U22 + n * area, P22 - (1 - n) * area)),
            "P12 - U12 = h (sigma - 1/sigma) = delta h.",
        ),
        Step(
            "rest",
            "c(1) is det U/S^2 + U12. Times sigma: what h leaves of Lambda w is g.",
            equal(
                _row(REST, REST),
                _row(SIGMA * DETERMINANT / RATIO**2, INDEX * c.level - CROSS),
            ),
            "c(1) = det(I - F + F K), written with K = U R^-1.",
        ),
        Step(
            "velocity-from-rest",
            "The velocity entries of the update and of the prediction say the same with sigma and "
            "1/sigma exchanged.",
            equal(
                _row(DELTA * U22, DELTA * P22),
                _row(RATIO**2 * REST + area / SIGMA, RATIO**2 * REST + area * SIGMA),
            ),
            "P22 = sigma^2 (U22 - det U) and P22 = U22 + Lambda^2: solve for each.",
        ),
        Step(
            "cross-equation",
            "Both expressions for U22 together: a linear equation for h.",
            equal(
                CROSS * (DELTA**2 + RATIO**2),
                area * (1 / SIGMA + n * DELTA) + RATIO**2 * INDEX * c.level,
            ),
            "Insert g = Lambda w - h.",
        ),
        *_solved(c),
    ]


def _solved(c: Context) -> list[Step]:
    d = rational(c.noise.determinant)
    share = ETA / (4 + SPEED**2) if c.noise.interval else SIGMA
    why = (
        "The factors of eta^2 let the quotient be cancelled: kappa S^2/Lambda is eta/(4 + t^2)."
        if c.noise.interval
        else "delta^2 = t^2 + Lambda m, so the right side is a part of the left."
    )
    return [
        Step(
            "coupling",
            "kappa says how strongly the measured velocity holds the cross covariance down; it is "
            "small when S is large.",
            equal(COUPLING, SPEED * share / RATIO),
            "The name of this quantity.",
        ),
        Step(
            "cross-solved",
            "Solved, h is a single quotient of positive terms.",
            equal(CROSS, INDEX / (c.level + COUPLING)),
            why,
        ),
        Step(
            "rest-solved",
            "And so is g.",
            equal(REST, CROSS * (d * SPEED**2 + c.level * COUPLING)),
            "Lambda w - h = h (w^2 - 1 + w kappa).",
        ),
    ]


def position_steps(c: Context) -> list[Step]:
    """The position's variances and the gains."""
    step = 2 * U12 + U22 + rational(c.noise.first) * INDEX**2
    return [
        Step(
            "position",
            "The position entries are found like those of the velocity, and again differ by sigma "
            "and 1/sigma only.",
            equal(
                _row(DELTA * U11, DELTA * P11),
                _row(REST + step / SIGMA, REST + step * SIGMA),
            ),
            "P11 = sigma^2 (U11 - det U/S^2), and P11 - U11 = 2 U12 + U22 + Q11.",
        ),
        Step(
            "gain",
            "The gain is U over the variances of the measurements.",
            equal(
                sp.MatMul(gain_matrix(), c.model.measurement_noise, evaluate=False),
                symmetric(UPDATED),
            ),
            "K = U R^-1. In units K12 is multiplied by T, K21 divided by T.",
        ),
        Step(
            "gain-remainders",
            "What the gains on the diagonal leave to 1.",
            equal(
                _row(1 - U11, 1 - U22 / RATIO**2),
                _row(
                    (P22 + RATIO**2) / (RATIO**2 * SIGMA**2),
                    (P11 + 1) / SIGMA**2,
                ),
            ),
            "I - K = R (P + R)^-1, and det(P + R) = sigma^2 S^2.",
        ),
        Step(
            "sum-of-cross",
            "Sum, difference and product of the cross covariances.",
            equal(
                _row(P12 + U12, P12 - U12, P12 * U12),
                _row(MEAN * CROSS, DELTA * CROSS, CROSS**2),
            ),
            "m = sigma + 1/sigma and delta = sigma - 1/sigma.",
        ),
    ]
