"""From least squares with a parabola, while a track is young, to steady gains."""

from __future__ import annotations

import operator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gainproof.generated import least_squares_line, least_squares_parabola
from gainproof.time_varying.covariance import Reals
from gainproof.time_varying.three_states.process_noise import DEFAULT, noise_called


class GainSchedule(NamedTuple):
    """Dimensionless gains for samples 0, 1, ... along the first axis: alpha, beta (the velocity's
    gain times T) and gamma (the acceleration's gain times T^2).
    """

    alpha: Reals
    beta: Reals
    gamma: Reals


def hand_over_sample(tracking_index: ArrayLike, process_noise: str = DEFAULT) -> np.float64 | Reals:
    """The last sample k, counted from 0, whose least-squares gain is not below the steady one.

    It lies between 9/alpha - 5 - 8/3 and 9/alpha - 5 with the steady alpha of the tracking index
    Lambda, which the derivation recursion-three-states proves; the computed gains of the whole
    numbers between decide.

    Whole numbers as float64, at least 2. Raises ValueError for an index so small that the last
    sample is beyond 2^53, and for one outside the domain of the gains.
    """
    alpha = np.asarray(noise_called(process_noise).steady.gains(tracking_index).alpha)
    last = np.floor(9 / alpha - 5)
    if np.any(last >= 2.0**53):
        raise ValueError("tracking_index: least squares hands over beyond sample 2^53")
    last = np.maximum(last, 2.0)
    for _ in range(3):
        last -= (_gain(last) < alpha) & (last > 2)
    # beside a whole number 9/alpha - 5 may be rounded to the one below
    found: np.float64 | Reals = (last + (_gain(last + 1) >= alpha))[()]
    return found


def _gain(sample: Reals) -> Reals:
    return np.asarray(least_squares_parabola.gains(sample).alpha, np.float64)


def gain_schedule(
    tracking_index: ArrayLike, samples: int, process_noise: str = DEFAULT
) -> GainSchedule:
    """The gains of a fitted parabola up to `hand_over_sample`, the steady gains from then on.

    At sample 0 the position is taken as measured (alpha = 1, beta = gamma = 0), at sample 1 a line
    through both; from sample 2 on the parabola is that of all samples. Shape: samples, then that
    of the index. All gains stand in the kernels' order of accuracy; alpha never rises.
    """
    index = np.asarray(tracking_index, np.float64)
    last = np.asarray(hand_over_sample(index, process_noise))
    steady = noise_called(process_noise).steady.gains(index)
    if operator.index(samples) < 1:
        raise ValueError(f"samples should be a whole number from 1 on, got {samples}")
    number = np.arange(samples, dtype=np.float64).reshape(-1, *[1] * index.ndim)
    fit = least_squares_parabola.gains(np.maximum(number, 2.0))
    young = number <= last
    schedule = GainSchedule(
        *(
            np.where(young, fitted, np.asarray(known))
            for fitted, known in zip(fit, steady, strict=True)
        )
    )
    line = least_squares_line.gains(1.0)
    for column, first, second in zip(schedule, (1.0, 0.0, 0.0), (*line, 0.0), strict=True):
        column[:1], column[1:2] = first, second
    return schedule
