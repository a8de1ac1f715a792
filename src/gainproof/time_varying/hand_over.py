"""From least squares, while a track is young, to steady gains."""

from __future__ import annotations

import operator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gainproof.generated import least_squares_line, recursion_two_states
from gainproof.time_varying.covariance import Reals
from gainproof.time_varying.process_noise import DEFAULT, noise_called


class GainSchedule(NamedTuple):
    """Dimensionless gains for samples 0, 1, ... along the first axis: alpha, and beta (the
    velocity's gain times T).
    """

    alpha: Reals
    beta: Reals


def hand_over_sample(tracking_index: ArrayLike, process_noise: str = DEFAULT) -> np.float64 | Reals:
    """The last sample k, counted from 0, whose least-squares gain is not below the steady one.

    That is the whole part of (4 - 3 alpha + sqrt(16 - 16 alpha + alpha^2))/(2 alpha) with the
    steady alpha of the tracking index Lambda; proved in the derivation recursion-two-states. Where
    that is a whole number but for rounding, the computed gains decide.

    Whole numbers as float64. Raises ValueError for an index so small that the last sample is
    beyond 2^53, and for one outside the domain of the gains.
    """
    alpha = np.asarray(noise_called(process_noise).steady.gains(tracking_index).alpha)
    below_one = np.minimum(alpha, np.nextafter(1.0, 0.0))
    last = np.floor(np.asarray(recursion_two_states.hand_over(below_one).last_sample))
    if np.any(last >= 2.0**53):
        raise ValueError("tracking_index: least squares hands over beyond sample 2^53")
    last = np.maximum(last, 1.0)
    last -= (_gain(last) < alpha) & (last > 1)
    found: np.float64 | Reals = (last + (_gain(last + 1) >= alpha))[()]
    return found


def _gain(sample: Reals) -> Reals:
    return np.asarray(least_squares_line.gains(sample).alpha, np.float64)


def gain_schedule(
    tracking_index: ArrayLike, samples: int, process_noise: str = DEFAULT
) -> GainSchedule:
    """The gains of a fitted line up to `hand_over_sample`, the steady gains from then on.

    At sample 0 the position is taken as measured: alpha = 1, beta = 0. Shape: samples, then that
    of the index. Both kinds of gain stand in the kernels' order of accuracy; alpha never rises.
    """
    index = np.asarray(tracking_index, np.float64)
    last = np.asarray(hand_over_sample(index, process_noise))
    steady = noise_called(process_noise).steady.gains(index)
    if operator.index(samples) < 1:
        raise ValueError(f"samples should be a whole number from 1 on, got {samples}")
    number = np.arange(samples, dtype=np.float64).reshape(-1, *[1] * index.ndim)
    line = least_squares_line.gains(np.maximum(number, 1.0))
    young = number <= last
    alpha, beta = (
        np.where(young, fitted, np.asarray(known))
        for fitted, known in zip(line, steady, strict=True)
    )
    alpha[:1], beta[:1] = 1.0, 0.0
    return GainSchedule(alpha, beta)
