"""Steps that solve for the entries of both covariances and for the gains."""

from __future__ import annotations

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    COUPLING,
    CROSS,
    DELTA,
    ETA,
    INDEX,
    PREDICTED,
    RATIO,
    REST,
    SIGMA,
    SPEED,
    UPDATED,
    row,
)
from gainproof.derive.vector_measurement.steps_spectrum import one_end_text
from gainproof.derive.vector_measurement.towers import rational

P11, P12, P22 = map(real, PREDICTED)
U11, U12, U22 = map(real, UPDATED)
DETERMINANT = U11 * U22 - U12**2


def cross_steps(c: Context) -> list[Step]:
    """The cross covariances: one linear equation for their geometric mean h."""
    return [*_both_ways(c), *_cross_equation(c), *_solved(c)]


def _both_ways(c: Context) -> list[Step]:
    """The update and the prediction, entry by entry."""
    n, area = rational(c.noise.n), INDEX**2
    return [
        Step(
            "inverse",
            "Written for the inverses the update is linear, `P^-1 = U^-1 - R^-1`. So each entry of "
            "`P` follows from those of `U`.",
            equal(
                row(P11, P12, P22),
                row(
                    SIGMA**2 * (U11 - DETERMINANT / RATIO**2),
                    SIGMA**2 * U12,
                    SIGMA**2 * (U22 - DETERMINANT),
                ),
            ),
            "The inverse of a matrix is its adjugate over its determinant; `det P = sigma^2 det U` "
            "(step @at-zero), `det U = U11 U22 - U12^2`, and `R` holds 1 and `S^2`.",
            heading="The entries of the covariances",
        ),
        Step(
            "prediction",
            "And the prediction, `P = F U F' + Lambda^2 Q0`, entry by entry.",
            equal(
                row(P11, P12, P22),
                row(
                    U11 + 2 * U12 + U22 + rational(c.noise.first) * area,
                    U12 + U22 + n * area,
                    U22 + area,
                ),
            ),
            "Multiply out. From here on it is algebra: six equations for six entries.",
        ),
        Step(
            "cross",
            "Between the two cross covariances stands `h`, their geometric mean; they differ by "
            "`sigma` alone.",
            equal(row(P12, U12), row(CROSS * SIGMA, CROSS / SIGMA)),
            "`P12 = sigma^2 U12` by step @inverse; put `h = sigma U12`.",
        ),
    ]


def _cross_equation(c: Context) -> list[Step]:
    """Two expressions for the velocity's variance, and what they say of h together."""
    n, area, one_end = rational(c.noise.n), INDEX**2, one_end_text(c)
    return [
        Step(
            "velocity-from-cross",
            "The cross entry of the prediction ties both variances of the velocity to `h`.",
            equal(row(DELTA * CROSS, DELTA * CROSS), row(U22 + n * area, P22 - (1 - n) * area)),
            "`P12 - U12 = h (sigma - 1/sigma) = delta h` by steps @cross and @delta; insert step "
            "@prediction.",
        ),
        Step(
            "rest",
            f"Let `g` be what `h` leaves of `{one_end}`. It is the determinant of `U`, scaled.",
            equal(
                row(REST, REST),
                row(INDEX * c.level - CROSS, SIGMA * DETERMINANT / RATIO**2),
            ),
            "Written with `K = U R^-1`, `c(1) = K21 + det K` is `U12 + det U/S^2`. Multiply by "
            f"`sigma`: on the left stands `{one_end}` (step @at-one), on the right "
            "`h + sigma det U/S^2`.",
        ),
        Step(
            "velocity-from-rest",
            "The velocity entries of the update and of the prediction give a second expression. "
            "`P22` and `U22` differ by `sigma` in the place of `1/sigma`.",
            equal(
                row(DELTA * U22, DELTA * P22),
                row(RATIO**2 * REST + area / SIGMA, RATIO**2 * REST + area * SIGMA),
            ),
            "`P22 = sigma^2 (U22 - det U)` (step @inverse), `P22 = U22 + Lambda^2` (step "
            "@prediction) and `det U = S^2 g/sigma` (step @rest): solve for each.",
        ),
        Step(
            "cross-equation",
            "Both expressions for `U22` together are a linear equation for `h`.",
            equal(
                CROSS * (DELTA**2 + RATIO**2),
                area * (1 / SIGMA + n * DELTA) + RATIO**2 * INDEX * c.level,
            ),
            f"Multiply step @velocity-from-cross by `delta`, insert step @velocity-from-rest and "
            f"`g = {one_end} - h`.",
        ),
    ]


def _solved(c: Context) -> list[Step]:
    d = rational(c.noise.determinant)
    rest = (
        "Then `g = h (w (w + kappa) - 1)`, with `w^2` from step @level."
        if c.noise.determinant
        else "Then `g = Lambda - h = h (1 + kappa) - h`."
    )
    share = ETA / (4 + SPEED**2) if c.noise.interval else SIGMA
    why = (
        "In step @cross-equation divide by the factor of `h`. The quotient can be cancelled, for "
        "`eta^2` is a product (step @at-minus-one)."
        if c.noise.interval
        else "In step @cross-equation divide by the factor of `h`. The quotient can be cancelled, "
        "for `delta^2 = t^2 + Lambda m`."
    )
    return [
        Step(
            "coupling",
            "For short let `kappa` be this quantity. It says how strongly the measured velocity "
            "holds the cross covariances down, and is small where `S` is large.",
            equal(COUPLING, SPEED * share / RATIO),
            "Its name; the next step shows what it is good for.",
        ),
        Step(
            "cross-solved",
            "Solved, `h` is a single quotient of positive terms, and so is `g`.",
            equal(CROSS, INDEX / (c.level + COUPLING)),
            f"{why} {rest}",
        ),
        joined("rest-solved", equal(REST, CROSS * (d * SPEED**2 + c.level * COUPLING))),
    ]
