"""One prediction, one update, one step of many tracks."""

from __future__ import annotations

from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import recursion_two_states
from gainproof.time_varying.covariance import Factors, Real
from gainproof.time_varying.process_noise import DEFAULT, noise_called


class Step(NamedTuple):
    """What a sample brings: covariances after it, the gains used, the innovation's variance.

    A missed detection has the predicted covariance and gains of 0; its innovation's variance is
    what a detection would have had, for the gate.
    """

    factors: Factors
    position_gain: Real
    velocity_gain: Real
    innovation_variance: Real


def start(
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    process_noise: str = DEFAULT,
) -> Factors:
    """Covariances after the first two positions, an interval apart, nothing known before.

    interval in s, strength as the process noise has it (see `PROCESS_NOISES`), variance of the
    measured position in m^2; numbers or arrays, broadcast together. The state they belong to is
    the second position and the difference of both over the interval.

    Raises ValueError and TypeError as the kernels do, and for an unknown process noise.
    """
    kernel = noise_called(process_noise).kernel("start")
    return Factors(*kernel(interval, strength, measurement_variance))


def predict(
    factors: Factors,
    interval: ArrayLike,
    strength: ArrayLike,
    process_noise: str = DEFAULT,
) -> Factors:
    """Covariances an interval later, each track with its own; for missed detections, too.

    Only "continuous-white-acceleration" is a noise of the time: there two predictions are one over
    the sum of the intervals. The other two belong to the interval, however long.
    """
    kernel = noise_called(process_noise).kernel("predict")
    return Factors(*kernel(*factors, interval, strength))


def update(factors: Factors, measurement_variance: ArrayLike) -> Step:
    """The position measured: gains K = P H'/S and covariances (I - K H) P."""
    gains = recursion_two_states.gains(*factors, measurement_variance)
    return Step(Factors(*recursion_two_states.update(*factors, measurement_variance)), *gains)


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
    kernel = noise_called(process_noise).kernel("step")
    both: Any = kernel(*factors, interval, strength, measurement_variance)
    found = Step(Factors(*both[:3]), *both[3:])
    if detections(detected).all():
        return found
    return where_detected(found, predict(factors, interval, strength, process_noise), detected)


AnyStep = TypeVar("AnyStep", bound=tuple[Any, ...])


def where_detected(found: AnyStep, before: tuple[Real, ...], detected: ArrayLike) -> AnyStep:
    """An update where a position was detected, else the covariances before it and no gains; a
    `Step` of two or of three states.

    Raises TypeError where `detected` is not true or false.
    """
    seen = detections(detected)
    if seen.all():
        return found
    factors, *gains, variance = found
    pairs = zip(factors, before, strict=True)
    chosen = tuple.__new__(type(factors), (np.where(seen, x, y)[()] for x, y in pairs))
    used = np.where(seen, 1.0, 0.0).astype(np.asarray(gains[0]).dtype)
    shown = np.broadcast_to(variance, np.shape(chosen[0]))
    return tuple.__new__(type(found), (chosen, *(gain * used for gain in gains), shown[()]))


def detections(detected: ArrayLike) -> NDArray[np.bool_]:
    """Where a position was detected. Raises TypeError where that is not true or false."""
    seen = np.asarray(detected)
    if seen.dtype != np.bool_:
        raise TypeError(f"detected must be true or false, got {seen.dtype}")
    return seen
