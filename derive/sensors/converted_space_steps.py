"""Steps on converted measurements in space: moments of range, elevation, azimuth."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column
from gainproof.derive.relation import Relation, described, equal
from gainproof.derive.sensors.converted_names import COS2, KEPT, SIGMA_R, SIN2, R
from gainproof.derive.sensors.converted_space_names import (
    BOTH,
    COS_E,
    ENTRY,
    KEPT_E,
    LA,
    LE,
    ONCE,
    SIN_E,
    TWICE,
    UPRIGHT,
    WHOLE,
    A,
    squares,
)

UNBIASED, MODIFIED = ENTRY["space_unbiased"], ENTRY["space_modified"]


def space_steps() -> list[Step]:
    """Means, mean squares, covariances, and forms without cancellation."""
    c1, _, _ = ONCE
    ahead, up, tilt = UPRIGHT
    return [
        Step(
            "space",
            "In space the elevation `eta` above the plane of x and y is measured too, with a noise "
            "of its own, independent of the others. Places are counted horizontally ahead, across "
            "and up, as seen in the azimuth's direction.",
            described("`-pi/2 < eta < pi/2`; `lambda_eta` is to `eta` what `lambda` is to `theta`"),
            "First the noise of the elevation turns the line of sight in the vertical plane, then "
            "that of the azimuth turns what is ahead.",
            tower="space",
            heading="In space",
        ),
        Step(
            "space-elevation",
            "Cosine `c_eta` and sine `s_eta` of the elevation are rational in `a = tan(pi/4 + "
            "eta/2)`, which is any number above zero.",
            equal(column(COS_E, SIN_E), column(2 * A / (1 + A**2), (A**2 - 1) / (1 + A**2))),
            "They are sine and, but for the sign, cosine of twice the angle `pi/4 + eta/2`.",
            tower="space",
        ),
        Step(
            "space-squares",
            "Cosine and sine of the elevation with noise have the mean squares `C_1`, `S_1` and "
            "the mean product `B_1`; with noise twice `C_2`, `S_2`, `B_2`.",
            equal(column(*ONCE, *TWICE), column(*_turned(LE**2), *_turned(LE**4))),
            "Cosine and sine of a sum; the product of the noise's cosine and sine has the mean 0.",
            tower="space",
        ),
        _in_space(
            "space-doubled",
            equal(column(*ONCE[:2], *TWICE[:2]), column(*squares(LE**2)[:2], *squares(LE**4)[:2])),
        ),
        Step(
            "space-azimuth",
            "Of the azimuth's noise, as in step @squares.",
            equal(column(COS2, SIN2), column(*azimuth_squares())),
            "What the names mean.",
            tower="space",
            shown=False,
        ),
        Step(
            "space-covariance",
            "Given the truth, or given the measurement with the flat prior of step @prior, the "
            "means are `lambda lambda_eta` times the place ahead and `lambda_eta` times the "
            "height. The covariance `V` in space is, ahead, across, up, and of ahead and up, with "
            "`C` and `S` of step @squares:",
            equal(
                column(*MODIFIED),
                column(*modified()),
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
                column(*upright()),
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


def _turned(kept: sp.Expr) -> tuple[sp.Expr, ...]:
    """Mean squares of cosine and sine, and the mean product, of the elevation with a noise."""
    c2, s2 = (1 + kept) / 2, (1 - kept) / 2
    return (
        COS_E**2 * c2 + SIN_E**2 * s2,
        SIN_E**2 * c2 + COS_E**2 * s2,
        COS_E * SIN_E * (c2 - s2),
    )


def azimuth_squares() -> tuple[sp.Expr, sp.Expr]:
    """Mean squares of cosine and sine of the azimuth's noise."""
    return (1 + LA**2) / 2, (1 - LA**2) / 2


def flat() -> tuple[sp.Expr, sp.Expr]:
    """The covariance in the plane, with the elevation's noise."""
    return (
        (R**2 * (1 - LE) ** 2 + SIGMA_R**2 * (1 + LE**2)) / 2,
        WHOLE * (1 - LE) * (1 + LE) / 2,
    )


def modified() -> tuple[sp.Expr, ...]:
    """Mean squares less squares of means."""
    c1, s1, m1 = ONCE
    level, height = BOTH * R * COS_E, KEPT_E * R * SIN_E
    return (
        WHOLE * c1 * COS2 - level**2,
        WHOLE * c1 * SIN2,
        WHOLE * s1 - height**2,
        KEPT * WHOLE * m1 - level * height,
    )


def mean_square_error() -> tuple[sp.Expr, ...]:
    """Mean squares of the converted less the true place, given the measurement."""
    c1, s1, m1 = ONCE
    level, height = R * COS_E, R * SIN_E
    wide, high = 1 / BOTH, 1 / KEPT_E
    return (
        (wide**2 - 2) * level**2 + WHOLE * c1 * COS2,
        WHOLE * c1 * SIN2,
        (high**2 - 2) * height**2 + WHOLE * s1,
        (wide * high - 1 / KEPT - KEPT) * level * height + KEPT * WHOLE * m1,
    )


def upright() -> tuple[sp.Expr, ...]:
    """The same covariance turned by the elevation: ahead, up, and of both."""
    along, over = flat()
    return (
        COS_E**2 * along + SIN_E**2 * over,
        SIN_E**2 * along + COS_E**2 * over,
        COS_E * SIN_E * (along - over),
    )


def _in_space(name: str, relation: Relation) -> Step:
    return joined(name, relation, "space")
