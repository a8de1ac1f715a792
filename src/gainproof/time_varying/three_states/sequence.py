"""Gains and covariances of whole tracks of three states, sample by sample."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from gainproof.time_varying.sequence import Samples, by_samples
from gainproof.time_varying.three_states.covariance import Factors
from gainproof.time_varying.three_states.process_noise import DEFAULT
from gainproof.time_varying.three_states.track import Step, step, update


class GainSequence(NamedTuple):
    """Gains and innovation's variances, and the factors of the covariances after each sample.

    The first axis is the sample, the others those of the tracks.
    """

    position_gain: Samples
    velocity_gain: Samples
    acceleration_gain: Samples
    innovation_variance: Samples
    diagonal_1: Samples
    diagonal_2: Samples
    diagonal_3: Samples
    first_shear: Samples
    second_shear: Samples
    third_shear: Samples

    @property
    def factors(self) -> Factors:
        """The covariances after the samples."""
        return Factors(*self[4:])


def gain_sequence(
    predicted: Factors,
    intervals: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    detected: ArrayLike = True,
    process_noise: str = DEFAULT,
) -> GainSequence:
    """Gains sample by sample from chosen covariances, those predicted for the first sample.

    intervals: one fewer than samples along the first axis, then, if they differ, one for each
    track. strength and measurement_variance: for all samples, numbers or one for each track.
    detected: true or false, for all, or along the first axis for each sample (and each track).

    Raises ValueError for intervals without a first axis and for lists that do not fit; else as
    `step`.
    """
    first = update(predicted, measurement_variance)

    def following(before: Factors, interval: ArrayLike, seen: ArrayLike) -> Step:
        return step(before, interval, strength, measurement_variance, seen, process_noise)

    return GainSequence(*by_samples(first, predicted, following, intervals, detected))
