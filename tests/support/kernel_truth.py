"""What the printed kernels should return: the oracles' truth about each family, by name.

The models are typed here again; ``test_catalogue_noise`` holds them against the physical
description of the noise and against the catalogue.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import flint
from both_measured import BothMeasuredTruth, both_measured
from estimated_bias import BiasDeviationTruth
from fixed_gain_triples import AlphaBetaGammaTruth
from fixed_gain_truth import AlphaBetaTruth
from shared_variances import PositionGainTruth
from updated_gains_truth import UpdateLimitsTruth

from gainproof.verify.oracles.true_values import (
    FitTruth,
    SteadyStateTruth,
    Truth,
    steady_state_truth,
)


def position_velocity(noise: list[list[str]]) -> dict[str, Any]:
    """Position and velocity with measured position, in units T = R = 1."""
    return {
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": noise,
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }


STEADY_STATES: Mapping[str, dict[str, Any]] = {
    "random_velocity": position_velocity([["0", "0"], ["0", "1"]]),
    "random_acceleration": position_velocity([["1/4", "1/2"], ["1/2", "1"]]),
    "continuous_white_acceleration": position_velocity([["1/3", "1/2"], ["1/2", "1"]]),
}


def acceleration_too(noise: list[list[str]]) -> dict[str, Any]:
    """Position, velocity and acceleration with measured position, in units T = R = 1."""
    return {
        "transition": [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
        "process_noise": noise,
        "measurement": [["1", "0", "0"]],
        "measurement_noise": [["1"]],
    }


THREE_STATES: Mapping[str, dict[str, Any]] = {
    "acceleration_increments": acceleration_too(
        [["0", "0", "0"], ["0", "0", "0"], ["0", "0", "1"]]
    ),
    "wiener_acceleration": acceleration_too(
        [["1/4", "1/2", "1/2"], ["1/2", "1", "1"], ["1/2", "1", "1"]]
    ),
    "random_jerk": acceleration_too(
        [["1/36", "1/12", "1/6"], ["1/12", "1/4", "1/2"], ["1/6", "1/2", "1"]]
    ),
    "continuous_white_jerk": acceleration_too(
        [["1/20", "1/8", "1/6"], ["1/8", "1/3", "1/2"], ["1/6", "1/2", "1"]]
    ),
}
FITS: Mapping[str, int] = {
    "least_squares_mean": 0,
    "least_squares_line": 1,
    "least_squares_parabola": 2,
}


BOTH_MEASURED: Mapping[str, str] = {
    "position_velocity": "continuous_white_acceleration",
    "position_velocity_random_acceleration": "random_acceleration",
    "position_velocity_random_velocity": "random_velocity",
}
"""Modules with position and velocity measured, and their process noise."""


@dataclass(frozen=True)
class HandOverTruth:
    """The sample, as a real number, at which the gain of a fitted line is alpha: between two whole
    numbers whose gains, sums over the samples, lie on both sides, then by halving. The gain
    between samples is that fraction of polynomials that the sums are at three of them.
    """

    def at(self, argument: str, value: float) -> Mapping[str, Truth]:
        """`last_sample` where alpha has exactly this value."""
        assert argument == "alpha"
        alpha = Fraction(value)
        low, high = Fraction(1), Fraction(2)
        while self.gain(high) > alpha:
            low, high = high, 2 * high
        for _ in range(150):
            middle = (low + high) / 2
            low, high = (middle, high) if self.gain(middle) > alpha else (low, middle)
        with flint.ctx.workprec(400):
            ends = [flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in (low, high)]
            found = ends[0].union(ends[1])
            return {"last_sample": Truth(found, found)}

    def gain(self, k: Fraction) -> Fraction:
        """Newest weight of the fit: 1/n + (last deviation)^2/(sum of squared deviations)."""
        n = k + 1
        return 1 / n + (k / 2) ** 2 / (n * (n * n - 1) / 12)


FixedGainTruth = (
    AlphaBetaTruth
    | AlphaBetaGammaTruth
    | PositionGainTruth
    | BiasDeviationTruth
    | UpdateLimitsTruth
)


@cache
def truth_of(
    family: str,
) -> SteadyStateTruth | FitTruth | BothMeasuredTruth | HandOverTruth | FixedGainTruth:
    """The truth about a family; LookupError for one without an oracle."""
    if family in STEADY_STATES:
        return steady_state_truth(STEADY_STATES[family])
    if family in THREE_STATES:
        return steady_state_truth(THREE_STATES[family])
    if family in BOTH_MEASURED:
        return both_measured(STEADY_STATES[BOTH_MEASURED[family]]["process_noise"])
    if family in FITS:
        return FitTruth(FITS[family])
    if family == "recursion_two_states":
        return HandOverTruth()
    if family == "alpha_beta":
        return AlphaBetaTruth()
    if family == "alpha_beta_gamma":
        return AlphaBetaGammaTruth()
    if family == "interacting_gains":
        return PositionGainTruth()
    if family == "multipath_location":
        return BiasDeviationTruth()
    if family == "updated_gains":
        return UpdateLimitsTruth()
    raise LookupError(f"no oracle knows the family {family}: add its model to kernel_truth")


def truth_at(
    family: str, argument: str, value: float, near: float | None = None
) -> Mapping[str, Truth]:
    """Every named quantity of a family where the argument has exactly this value."""
    truth = truth_of(family)
    if isinstance(truth, SteadyStateTruth):
        return truth.at(argument, value, near)
    return truth.at(argument, value)
