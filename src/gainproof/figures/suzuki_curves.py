"""The numbers of the source's figures 1 to 3, from the kernels (Suzuki, section 4).

The quantities are those of the captions; the ranges are ours, since the pictures themselves are
not among what we have. r = 4/Lambda is the normalised deviation of the measured position, S that
of the measured velocity, G1 the variance of the predicted position over sigma_o^2.
"""

from __future__ import annotations

import numpy as np

from gainproof.plots.table import Column, Table, decades, grid
from gainproof.position_velocity import velocity_ratio_for
from gainproof.position_velocity.variance import position_variance

POSITION = "4 sigma_o/(sigma_a T^2), normalised deviation of the measured position"
VELOCITY = "sigma_d T/sigma_o, normalised deviation of the measured velocity"
STEP = 1.1
"""The source's factor that says where the step of G1 begins."""
PER_DECADE = 16


def figure_1() -> Table:
    """G1 against S, r as parameter: one curve for each decade of r."""
    r, s = grid(decades(-2, 4, 1), decades(-5, 5, PER_DECADE))
    variance = position_variance().at(4 / r, s)
    return Table(
        "Velocity measurement error S and predicted position error G1",
        (
            Column("r", POSITION, r),
            Column("S", VELOCITY, s),
            Column("G1", "variance of the predicted position over sigma_o^2", variance),
        ),
    )


def figure_2() -> Table:
    """S against r where G1 = 1.1 G1(S=0), and where G1 = G1(S=infinity)/1.1: the step's ends."""
    r = decades(-3, 6, PER_DECADE)
    index = 4 / r
    variance = position_variance()
    begin, end = (
        np.asarray(velocity_ratio_for(index, wanted))
        for wanted in (variance.known_exactly(index) * STEP, variance.not_measured(index) / STEP)
    )
    return Table(
        "Where G1 = 1.1 G1(S=0): r and S",
        (
            Column("r", POSITION, r),
            Column("S", "S at which G1 = 1.1 G1(S=0)", begin),
            Column("S_end", "S at which G1 = G1(S=infinity)/1.1", end),
            Column("width", "S_end/S, the width of the step of G1", end / begin),
        ),
    )


def figure_3() -> Table:
    """G1(S=0)/G1(S=infinity) against r."""
    r = decades(-3, 6, PER_DECADE)
    index = 4 / r
    variance = position_variance()
    known, missing = variance.known_exactly(index), variance.not_measured(index)
    ratio = known / missing
    return Table(
        "Improvement of the predicted position error",
        (
            Column("r", POSITION, r),
            Column("ratio", "G1(S=0)/G1(S=infinity)", ratio),
            Column("G1_zero", "G1 in the limit S to 0", known),
            Column("G1_infinity", "G1 in the limit S to infinity", missing),
        ),
        {"ratio at the least r": float(ratio[0])},
    )
