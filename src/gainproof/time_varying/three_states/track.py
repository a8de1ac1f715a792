"""One start, one prediction, one update, one step of many tracks of three states."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from gainproof.generated import recursion_three_states
from gainproof.time_varying.covariance import Real
from gainproof.time_varying.three_states.covariance import Factors
from gainproof.time_varying.three_states.process_noise import DEFAULT, noise_called
from gainproof.time_varying.track import where_detected


class Step(NamedTuple):
    """What a sample brings: covariances after it, the gains used, the innovation's variance.

    A missed detection has the predicted covariance and gains of 0; its innovation's variance is
    what a detection would have had, for the gate.
    """

    factors: Factors
    position_gain: Real
    velocity_gain: Real
    acceleration_gain: Real
    innovation_variance: Real


def start(
    first_interval: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    process_noise: str = DEFAULT,
) -> Factors:
    """Covariances after the first three positions, two intervals apart, nothing known before.

    Intervals in s, strength as the process noise has it (see `PROCESS_NOISES`), variance of the
    measured position in m^2; numbers or arrays, broadcast together. The state they belong to is
    that of the parabola through the three positions at the time of the last.

    Raises ValueError and TypeError as the kernels do, and for an unknown process noise.
    """
    kernel = noise_called(process_noise).kernel("start")
    return Factors(*kernel(first_interval, interval, strength, measurement_variance))


def predict(
    factors: Factors, interval: ArrayLike, strength: ArrayLike, process_noise: str = DEFAULT
) -> Factors:
    """Covariances an interval (above 0) later, each track with its own; for missed detections, too.

    Only "continuous-white-jerk" is a noise of the time: there two predictions are one over the sum
    of the intervals. Raises ValueError for an unknown process noise; else as the kernels do.
    """
    kernel = noise_called(process_noise).kernel("predict")
    return Factors(*kernel(*factors, interval, strength))


def update(factors: Factors, measurement_variance: ArrayLike) -> Step:
    """The position measured: gains K = P H'/S and covariances (I - K H) P."""
    gains = recursion_three_states.gains(*factors, measurement_variance)
    after = recursion_three_states.update(*factors, measurement_variance)
    return Step(Factors(*after), *gains)


def step(
    factors: Factors,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    detected: ArrayLike = True,
    process_noise: str = DEFAULT,
) -> Step:
    """An interval, then a position where one is ``detected`` (true or false for each track).

    Arguments as in `predict` and `update`, broadcast together.
    """
    before = predict(factors, interval, strength, process_noise)
    return where_detected(update(before, measurement_variance), before, detected)
