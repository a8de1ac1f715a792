"""Steps on converted measurements in space: moments of range, elevation and azimuth, and signs."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import Relation, described, equal, positive
from gainproof.derive.sensors.converted_names import KEPT, LOSS, SIGMA_R, R, column
from gainproof.derive.sensors.converted_space_names import (
    BOTH,
    COS_E,
    COSINES,
    ENTRY,
    KEPT_E,
    LA,
    LE,
    LOSS_E,
    SIN_E,
    UPRIGHT,
    WHOLE,
    A,
    squares,
)

UNBIASED, MODIFIED = ENTRY["space_unbiased"], ENTRY["space_modified"]


def space_steps() -> list[Step]:
    """Moments and definiteness."""
    return [*_moments(), *_definite()]


def _moments() -> list[Step]:
    turned = (1 + LE**2) / 2, (1 - LE**2) / 2
    c1, s1, m1 = squares(LE**2)
    ahead, up, tilt = UPRIGHT
    return [
        Step(
            "space",
            "In space the elevation `eta` above the plane of x and y is measured too, with a noise "
            "of its own, independent of the others. Places are counted horizontally ahead, across "
            "and up, as seen in the azimuth's direction.",
            described("-pi/2 < eta < pi/2; lambda_eta is to eta what lambda is to theta"),
            "First the noise of the elevation turns the line of sight in the vertical plane, then "
            "that of the azimuth turns what is ahead.",
            tower="space",
            heading="In space",
        ),
        _in_space(
            "space-elevation",
            equal(column(COS_E, SIN_E), column(2 * A / (1 + A**2), (A**2 - 1) / (1 + A**2))),
        ),
        Step(
            "space-squares",
            "The noisy elevation's cosine and sine have mean squares and a mean product, which the "
            "true ones and the noise determine.",
            equal(
                column(
                    COS_E**2 * turned[0] + SIN_E**2 * turned[1],
                    SIN_E**2 * turned[0] + COS_E**2 * turned[1],
                    COS_E * SIN_E * (turned[0] - turned[1]),
                ),
                column(c1, s1, m1),
            ),
            "Cosine and sine of a sum; the product of the noise's cosine and sine has the mean 0.",
            tower="space",
        ),
        Step(
            "space-covariance",
            "Given the truth, or given the measurement with the flat prior of step @prior, the "
            "means are `lambda lambda_eta` times the place ahead and `lambda_eta` times the "
            "height. The covariance `V` in space is, ahead, across, up, and of ahead and up:",
            equal(
                column(*MODIFIED),
                column(*_modified()),
            ),
            "Mean squares less squares of means. What is across is an odd function of the "
            "azimuth's noise, so that it is not correlated with the rest.",
            tower="space",
        ),
        Step(
            "space-upright",
            "Without noise of the azimuth this is the covariance of the plane, stood upright:",
            equal(
                column(*UPRIGHT),
                column(*_upright()),
            ),
            "Step @truth-spread with the noise of the elevation, turned by the elevation.",
            tower="space",
        ),
        Step(
            "space-form",
            "With it nothing cancels but what changes its sign:",
            equal(
                column(*MODIFIED),
                column(
                    LA * ahead + (1 - LA) ** 2 * WHOLE * c1 / 2,
                    WHOLE * c1 * (1 - LA) * (1 + LA) / 2,
                    up,
                    KEPT * tilt,
                ),
            ),
            "`(1 + lambda^4)/2` is `lambda^2` and half the square of `1 - lambda^2`.",
            tower="space",
        ),
    ]


def _flat() -> tuple[sp.Expr, sp.Expr]:
    """The covariance in the plane, with the elevation's noise."""
    return (
        (R**2 * (1 - LE) ** 2 + SIGMA_R**2 * (1 + LE**2)) / 2,
        WHOLE * (1 - LE) * (1 + LE) / 2,
    )


def _definite() -> list[Step]:
    ahead, across, up, tilt = MODIFIED
    level = WHOLE * squares(LE**2)[0]
    form = LA * _flat()[0] * _flat()[1] + (1 - LA) ** 2 * level / 2 * UPRIGHT[1]
    return [
        *_tied(),
        Step(
            "space-definite",
            "It is positive definite whatever the noise.",
            positive(ahead),
            "Leading minors; below the plane of x and y everything is the mirror image. The "
            "determinant of ahead and up is the sum of `lambda^2` times that of the plane and of "
            "what the azimuth adds ahead, times the variance up.",
            tower="signs",
        ),
        _of_signs("space-definite-across", positive(across)),
        _of_signs("space-definite-up", positive(up)),
        joined("space-definite-minor", positive(ahead * up - tilt**2), "signs", {"form": form}),
    ]


def _tied() -> list[Step]:
    """The same quantities in the tower in which signs are shown."""
    circle = 2 * A / (1 + A**2), (A**2 - 1) / (1 + A**2)
    kept = 1 / (1 + LOSS_E), 1 / (1 + LOSS)
    return [
        _quiet("signs-circle", equal(column(COS_E, SIN_E, KEPT_E, KEPT), column(*circle, *kept))),
        _quiet("signs-upright", equal(column(*UPRIGHT), column(*_upright()))),
        _quiet("signs-modified", equal(column(*MODIFIED), column(*_modified()))),
        _quiet("signs-unbiased", equal(column(*UNBIASED), column(*mean_square_error()))),
    ]


def _quiet(name: str, relation: Relation) -> Step:
    return Step(name, "What the names mean.", relation, "As before.", tower="signs", shown=False)


def _of_signs(name: str, relation: Relation) -> Step:
    return joined(name, relation, "signs")


def _modified() -> tuple[sp.Expr, ...]:
    """Mean squares less squares of means."""
    c1, s1, m1 = squares(LE**2)
    level, height = BOTH * R * COS_E, KEPT_E * R * SIN_E
    return (
        WHOLE * c1 * COSINES[0] - level**2,
        WHOLE * c1 * COSINES[1],
        WHOLE * s1 - height**2,
        KEPT * WHOLE * m1 - level * height,
    )


def mean_square_error() -> tuple[sp.Expr, ...]:
    """Mean squares of the converted less the true place, given the measurement."""
    c1, s1, m1 = squares(LE**2)
    level, height = R * COS_E, R * SIN_E
    wide, high = 1 / BOTH, 1 / KEPT_E
    return (
        (wide**2 - 2) * level**2 + WHOLE * c1 * COSINES[0],
        WHOLE * c1 * COSINES[1],
        (high**2 - 2) * height**2 + WHOLE * s1,
        (wide * high - 1 / KEPT - KEPT) * level * height + KEPT * WHOLE * m1,
    )


def _upright() -> tuple[sp.Expr, ...]:
    along, over = _flat()
    return (
        COS_E**2 * along + SIN_E**2 * over,
        SIN_E**2 * along + COS_E**2 * over,
        COS_E * SIN_E * (along - over),
    )


def _in_space(name: str, relation: Relation) -> Step:
    return joined(name, relation, "space")
