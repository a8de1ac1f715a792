"""One prediction, one update, one step of many tracks of position, velocity and acceleration."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import recursion_three_states
from gainproof.time_varying.covariance import Real

PROCESS_NOISES = {
    "acceleration-increments": "variance of the acceleration's increment at each sample, m^2/s^4",
    "wiener-acceleration": "variance of an acceleration added over each interval, m^2/s^4",
    "random-jerk": "variance of the jerk of each interval, m^2/s^6",
    "continuous-white-jerk": "two-sided power density of the jerk, m^2/s^5",
}
"""What the strength q is, by the name of the process noise."""
DEFAULT = "continuous-white-jerk"


class Factors(NamedTuple):
    """Covariances P = U diag(d1, d2, d3) U' with U = [1, a + c, a b; 0, 1, b; 0, 0, 1].

    The shears a, b and c are times in s, not negative. Numbers, or arrays of tracks.
    """

    diagonal_1: Real
    diagonal_2: Real
    diagonal_3: Real
    first_shear: Real
    second_shear: Real
    third_shear: Real


class Step(NamedTuple):
    """What a sample brings: covariances after it, the gains used, the innovation's variance.

    A missed detection has the predicted covariance and gains of 0.
    """

    factors: Factors
    position_gain: Real
    velocity_gain: Real
    acceleration_gain: Real
    innovation_variance: Real


def uncorrelated(position: ArrayLike, velocity: ArrayLike, acceleration: ArrayLike) -> Factors:
    """The factors of diagonal covariances, of which tracks start: variances in m^2, m^2/s^2 and
    m^2/s^4, numbers or arrays, broadcast together.
    """
    given = (np.asarray(x, np.float64) for x in (position, velocity, acceleration))
    d1, d2, d3 = (np.array(x)[()] for x in np.broadcast_arrays(*given))
    zero = np.zeros_like(d1)[()]
    return Factors(d1, d2, d3, zero, zero, zero)


def covariance_of(factors: Factors) -> NDArray[np.floating[Any]]:
    """Covariances as arrays of shape (..., 3, 3), index 0 the position."""
    p = [np.asarray(x) for x in recursion_three_states.covariance(*factors)]
    rows = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
    return np.stack([np.stack([p[i] for i in row], -1) for row in rows], -2)


def predict(
    factors: Factors, interval: ArrayLike, strength: ArrayLike, process_noise: str = DEFAULT
) -> Factors:
    """Covariances an interval (above 0) later, each track with its own.

    Only "continuous-white-jerk" is a noise of the time: there two predictions are one over the sum
    of the intervals. Raises ValueError for an unknown process noise; else as the kernels do.
    """
    if process_noise not in PROCESS_NOISES:
        known = ", ".join(sorted(PROCESS_NOISES))
        raise ValueError(f"process_noise must be one of {known}, got {process_noise!r}")
    name = f"predict_{process_noise.replace('-', '_')}"
    return Factors(*getattr(recursion_three_states, name)(*factors, interval, strength))


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
    """An interval, then a position where one is ``detected`` (true or false for each track)."""
    seen = np.asarray(detected)
    if seen.dtype != np.bool_:
        raise TypeError(f"detected must be true or false, got {seen.dtype}")
    before = predict(factors, interval, strength, process_noise)
    found = update(before, measurement_variance)
    if seen.all():
        return found
    pairs = zip(found.factors, before, strict=True)
    chosen = Factors(*(np.where(seen, x, y)[()] for x, y in pairs))
    used = np.where(seen, 1.0, 0.0).astype(np.asarray(found.position_gain).dtype)
    gains = [gain * used for gain in found[1:4]]
    shown = np.broadcast_to(found.innovation_variance, np.shape(chosen.diagonal_1))
    return Step(chosen, gains[0], gains[1], gains[2], shown[()])
