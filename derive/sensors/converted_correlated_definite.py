"""Steps on noises that are correlated: that the covariances are positive definite."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import column
from gainproof.derive.relation import cited, equal
from gainproof.derive.sensors.converted_correlated_tower import SPREAD
from gainproof.derive.sensors.converted_names import KEPT, SIGMA_R, L
from gainproof.derive.sensors.converted_space_correlated import PRODUCT
from gainproof.derive.sensors.converted_space_names import LA, LE, squares
from gainproof.derive.source import PROBABILITY


def correlated_definite_steps() -> list[Step]:
    """What the range's own noise adds to covariances, in the plane and in space."""
    level, height, slope = squares(LE**2)
    across = (1 - LA**2) / 2
    plane = (1 + L**2) / 2, (1 - L**2) / 2, 0
    space = level * (1 - across), 0, level * across, KEPT * slope, 0, height
    return [
        Step(
            "correlated-own",
            "With `sigma_r^2`, where `c` stays, the covariance in the plane grows by the mean "
            "squares of the measured direction, along and across.",
            equal(
                column(*(sp.Derivative(each, SIGMA_R) for each in SPREAD)),
                column(*(2 * SIGMA_R * each for each in plane)),
            ),
            "Differentiate step @correlated-covariance.",
            tower="correlated",
        ),
        Step(
            "space-correlated-own",
            "And in space, where `c` and `e` stay, by its mean products: `sigma_r` is not in "
            "the means `m`.",
            equal(
                column(*(sp.Derivative(each, SIGMA_R) for each in PRODUCT)),
                column(*(2 * SIGMA_R * each for each in space)),
            ),
            "Differentiate step @space-correlated-products.",
            tower="space_correlated",
        ),
        Step(
            "correlated-definite",
            "So all these covariances are positive definite as long as that of the noises is: "
            "`sigma_r^2` is then above the least one that goes with `c` and `e`, `c^2/sigma_theta^2"
            " + e^2/sigma_eta^2`. There is a covariance there, and what is added from there on is "
            "positive definite.",
            cited(
                "A covariance matrix is positive semidefinite; mean products of a vector that lies "
                "in no fixed plane are positive definite, and so is the sum of both.",
                PROBABILITY.text(),
            ),
            "Measured directions lie in no line of the plane and in no plane of space. What the "
            "unbiased conversion adds is the square of its bias.",
            tower="space_correlated",
        ),
    ]
