"""Gains and covariances of whole tracks, sample by sample."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.time_varying.covariance import Factors, Real
from gainproof.time_varying.process_noise import DEFAULT
from gainproof.time_varying.track import Step, step, update, where_detected

Samples = NDArray[np.floating[Any]]


class GainSequence(NamedTuple):
    """Gains and innovation's variances, and the factors of the covariances after each sample.

    The first axis is the sample, the others those of the tracks.
    """

    position_gain: Samples
    velocity_gain: Samples
    innovation_variance: Samples
    diagonal_1: Samples
    shear: Samples
    diagonal_2: Samples

    @property
    def factors(self) -> Factors:
        """The covariances after the samples."""
        return Factors(self.diagonal_1, self.shear, self.diagonal_2)


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


def by_samples(
    first: Any,
    predicted: tuple[Real, ...],
    following: Callable[[Any, Any, Any], Any],
    intervals: ArrayLike,
    detected: ArrayLike,
) -> Iterator[Samples]:
    """Gains and factors of steps of two or three states, each over the samples: from the `first`
    update of what was predicted, and what follows from factors, an interval and what was detected.

    Raises ValueError for intervals without a first axis and for lists that do not fit.
    """
    lengths, seen = samples_of(intervals, detected)
    steps = [where_detected(first, predicted, seen[0])]
    for interval, now in zip(lengths, seen[1:], strict=True):
        steps.append(following(steps[-1].factors, interval, now))
    columns = zip(*([*found[1:], *found.factors] for found in steps), strict=True)
    return (np.stack(np.broadcast_arrays(*each)) for each in columns)


def samples_of(intervals: ArrayLike, detected: ArrayLike) -> tuple[Samples, NDArray[Any]]:
    """Intervals, and for each sample what was detected; ValueError for lists that do not fit."""
    lengths = np.asarray(intervals)
    if lengths.ndim == 0:
        raise ValueError("intervals need a first axis, one entry fewer than samples; got a number")
    count = len(lengths) + 1
    seen = np.asarray(detected)
    if seen.ndim == 0:
        seen = np.broadcast_to(seen, (count,))
    if len(seen) != count:
        raise ValueError(f"{count - 1} intervals need {count} samples, detected has {len(seen)}")
    return lengths, seen
