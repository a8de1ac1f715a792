"""What a schedule of three gains costs: its variance beside the least possible one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gainproof.time_varying.covariance import Reals
from gainproof.time_varying.three_states.covariance import covariance_of
from gainproof.time_varying.three_states.hand_over import gain_schedule
from gainproof.time_varying.three_states.process_noise import DEFAULT, noise_called
from gainproof.time_varying.three_states.track import start, step

MOTION = np.array([[1.0, 1.0, 0.5], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]])


class ScheduleVariance(NamedTuple):
    """Variance of the updated position over that of a measured one, for samples 2, 3, ... along
    the first axis: with the gains of `gain_schedule`, and with the Kalman gains of each sample.
    """

    scheduled: Reals
    least: Reals


def schedule_variance(
    tracking_index: ArrayLike, samples: int, process_noise: str = DEFAULT
) -> ScheduleVariance:
    """The variances at samples 2 to ``samples`` - 1 of a track that starts from three positions.

    The gains of both agree at sample 2, so that both start from the same covariance; from there
    the schedule's is carried on by Joseph's form, which holds for every gain, in plain entries.
    That it is never below the other is a theorem; by how much it is above is computed, not proved.

    Raises ValueError for fewer than three samples.
    """
    if samples < 3:
        raise ValueError(f"samples must be at least 3, got {samples}")
    index = np.asarray(tracking_index, np.float64)
    one, strength = np.ones(index.shape), index * index
    best = start(one, one, strength, one, process_noise)
    kept = covariance_of(best)
    noise = noise_called(process_noise).unit_covariance * strength[..., None, None]
    schedule = gain_schedule(index, samples, process_noise)
    pairs = [(kept[..., 0, 0], kept[..., 0, 0])]
    for number in range(3, samples):
        gain = np.stack([each[number] for each in schedule], -1)
        kept = _joseph(MOTION @ kept @ MOTION.T + noise, gain)
        best = step(best, one, strength, one, process_noise=process_noise).factors
        pairs.append((kept[..., 0, 0], covariance_of(best)[..., 0, 0]))
    return ScheduleVariance(*(np.stack(each) for each in zip(*pairs, strict=True)))


def _joseph(predicted: Reals, gain: Reals) -> Reals:
    """(I - K H) M (I - K H)' + K K' for any gain."""
    left = np.broadcast_to(np.eye(3), predicted.shape).copy()
    left[..., :, 0] -= gain
    kept: Reals = left @ predicted @ np.swapaxes(left, -1, -2)
    return kept + gain[..., :, None] * gain[..., None, :]
