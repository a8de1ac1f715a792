"""What the printed kernels should return: the oracles' truth about each family, by name.

The models are typed here again; ``test_catalogue_noise`` holds them against the physical
description of the noise and against the catalogue.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from gainproof.verify.oracles.truth import FitTruth, SteadyStateTruth, Truth, steady_state_truth


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
FITS: Mapping[str, int] = {
    "least_squares_mean": 0,
    "least_squares_line": 1,
    "least_squares_parabola": 2,
}


@cache
def truth_of(family: str) -> SteadyStateTruth | FitTruth:
    """The truth about a family; LookupError for one without an oracle."""
    if family in STEADY_STATES:
        return steady_state_truth(STEADY_STATES[family])
    if family in FITS:
        return FitTruth(FITS[family])
    raise LookupError(f"no oracle knows the family {family}: add its model to kernel_truth")


def truth_at(
    family: str, argument: str, value: float, near: float | None = None
) -> Mapping[str, Truth]:
    """Every named quantity of a family where the argument has exactly this value."""
    truth = truth_of(family)
    if isinstance(truth, FitTruth):
        return truth.at(argument, value)
    return truth.at(argument, value, near)
