"""How targets move between measurements, and how tracks start and are corrected.

A state is (x, vx, y, vy) in m and m/s; the acceleration of each coordinate is white, constant from
one measurement to the next and of deviation sigma_w: equations (1) to (4) of the source. Arrays of
tracks: states (..., 4), covariances (..., 4, 4), gains (..., 4, 2).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gainproof.tracking.arrays import Reals
from gainproof.tracking.measured import Measured
from gainproof.tracking.rows import Rows

POSITION, VELOCITY = slice(0, 4, 2), slice(1, 4, 2)


@dataclass(frozen=True)
class Estimate(Rows):
    """States and their covariances."""

    state: Reals
    covariance: Reals


def predicted(before: Estimate, interval: Reals, acceleration: float) -> Estimate:
    """An interval (s, one a track) later; acceleration: sigma_w, m/s^2."""
    one = np.zeros((*interval.shape, 4, 4))
    one[..., range(4), range(4)] = 1.0
    one[..., 0, 1] = one[..., 2, 3] = interval
    state = before.state.copy()
    state[..., POSITION] += interval[..., None] * before.state[..., VELOCITY]
    covariance = one @ before.covariance @ np.swapaxes(one, -1, -2)
    half = interval * interval / 2
    strength = acceleration * acceleration
    for axis in (0, 2):
        covariance[..., axis, axis] += strength * half * half
        covariance[..., axis, axis + 1] += strength * half * interval
        covariance[..., axis + 1, axis] += strength * half * interval
        covariance[..., axis + 1, axis + 1] += strength * interval * interval
    return Estimate(state, covariance)


def started(
    first: Reals, noise: Reals, seen: Measured, interval: Reals, acceleration: float
) -> Estimate:
    """From two measured positions, an interval apart, nothing known before; ``first`` (..., 2) and
    its ``noise`` (..., 2, 2) are those of the earlier one.

    The covariance is exact for independent noise: the position errs by the second noise, the
    velocity by the difference of both over the interval less half an interval's acceleration.
    """
    t = interval[..., None]
    state = np.zeros((*interval.shape, 4))
    state[..., POSITION] = seen.position
    state[..., VELOCITY] = (seen.position - first) / t
    covariance = np.zeros((*interval.shape, 4, 4))
    t = t[..., None]
    covariance[..., POSITION, POSITION] = seen.covariance
    covariance[..., POSITION, VELOCITY] = covariance[..., VELOCITY, POSITION] = seen.covariance / t
    of_velocity = (seen.covariance + noise) / t**2
    covariance[..., VELOCITY, VELOCITY] = of_velocity
    for axis in (1, 3):
        covariance[..., axis, axis] += (acceleration * interval / 2) ** 2
    return Estimate(state, covariance)


def updated(before: Estimate, gain: Reals, seen: Measured) -> Estimate:
    """With any gain: the covariance is Joseph's, which holds for every one."""
    innovation = seen.position - before.state[..., POSITION]
    state = before.state + (gain @ innovation[..., None])[..., 0]
    rest = np.zeros_like(before.covariance)
    rest[..., range(4), range(4)] = 1.0
    rest[..., :, POSITION] -= gain
    covariance = rest @ before.covariance @ np.swapaxes(rest, -1, -2)
    covariance += gain @ seen.covariance @ np.swapaxes(gain, -1, -2)
    return Estimate(state, (covariance + np.swapaxes(covariance, -1, -2)) / 2)


def inverse(matrix: Reals) -> Reals:
    """Of positive definite matrices (..., 2, 2); where rounding left one singular, of one beside
    it.
    """
    a, b, d = matrix[..., 0, 0], matrix[..., 0, 1], matrix[..., 1, 1]
    left = rest(a, b, d)
    adjugate = np.stack([np.stack([d, -b], -1), np.stack([-b, a], -1)], -2)
    found: Reals = adjugate / (a * left)[..., None, None]
    return found


def rest(a: Reals, b: Reals, d: Reals) -> Reals:
    """d - b^2/a, the variance that is left of the second where the first is known; above 0."""
    return np.maximum(d - b / a * b, 2.0**-52 * d)
