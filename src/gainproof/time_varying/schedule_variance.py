"""What a schedule of gains costs: its variance beside the least possible one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gainproof.time_varying.covariance import Factors, Reals, covariance_of, factors_of
from gainproof.time_varying.hand_over import gain_schedule
from gainproof.time_varying.process_noise import DEFAULT, noise_called
from gainproof.time_varying.track import predict, step


class ScheduleVariance(NamedTuple):
    """Variance of the updated position over that of a measured one, for samples 1, 2, ... along
    the first axis: with the gains of `gain_schedule`, and with the Kalman gains of each sample.
    """

    scheduled: Reals
    least: Reals


def schedule_variance(
    tracking_index: ArrayLike, samples: int, process_noise: str = DEFAULT
) -> ScheduleVariance:
    """The variances at samples 1 to ``samples`` - 1 of a track that starts from two positions.

    The gains of both agree at sample 1, so that both start from the same covariance; from there
    the schedule's is carried on by Joseph's form, which holds for every gain. That it is never
    below the other is a theorem; by how much it is above is computed, not proved.

    Raises ValueError for fewer than two samples, and where the schedule makes position and
    velocity err against each other (an entry 12 below 0), which was never seen.
    """
    if samples < 2:
        raise ValueError(f"samples must be at least 2, got {samples}")
    index = np.asarray(tracking_index, np.float64)
    one, strength = np.ones(index.shape), index * index
    kept = best = Factors(*noise_called(process_noise).kernel("start")(one, strength, one))
    schedule = gain_schedule(index, samples, process_noise)
    pairs = [(_position(kept), _position(best))]
    for alpha, beta in zip(schedule.alpha[2:], schedule.beta[2:], strict=True):
        kept = _joseph(predict(kept, one, strength, process_noise), alpha, beta)
        best = step(best, one, strength, one, process_noise=process_noise).factors
        pairs.append((_position(kept), _position(best)))
    return ScheduleVariance(*(np.stack(each) for each in zip(*pairs, strict=True)))


def _position(factors: Factors) -> Reals:
    return np.asarray(covariance_of(factors)[..., 0, 0], np.float64)


def _joseph(predicted: Factors, alpha: Reals, beta: Reals) -> Factors:
    """(I - K H) M (I - K H)' + K K' for any gain."""
    m = covariance_of(predicted)
    own, cross, velocity = m[..., 0, 0], m[..., 0, 1], m[..., 1, 1]
    left = 1 - alpha
    return factors_of(
        left * left * own + alpha * alpha,
        left * (cross - beta * own) + alpha * beta,
        velocity - 2 * beta * cross + beta * beta * (own + 1),
    )
