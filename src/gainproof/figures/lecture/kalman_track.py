"""The Kalman filter of constant velocity in the plane, its coordinates coupled by the noise.

The states are x, y and their velocities. At each sample both velocities get an increment of the
given deviation, the lecture's driving noise in m/s, independent of one another; the position goes
on with the velocity before. The measurement's covariance, taken at the measurement, couples x and
y: the gain is a full 4 x 2 matrix, the lecture's interacting filter.
"""

from __future__ import annotations

import numpy as np

from gainproof.plots.table import Reals

PLANE = np.eye(2)


def followed(measured: Reals, noise: Reals, interval: float, increment: float) -> Reals:
    """The smoothed positions (runs, samples, 2).

    ``measured`` (runs, samples, 2) in m, ``noise`` its covariances (runs, samples, 2, 2),
    ``interval`` in s, ``increment`` the deviation of the velocity's step in m/s. The track starts
    with the first two measurements. ValueError for fewer.
    """
    if measured.shape[1] < 2:
        raise ValueError(f"a track starts with two measurements, got {measured.shape[1]}")
    moving = np.kron([[1.0, interval], [0.0, 1.0]], PLANE)
    driven = np.kron([[0.0, 0.0], [0.0, increment**2]], PLANE)
    velocity = (measured[:, 1] - measured[:, 0]) / interval
    state = np.concatenate([measured[:, 1], velocity], axis=-1)
    covariance = _start(noise[:, 0], noise[:, 1], interval) + driven
    smoothed = measured.copy()
    for k in range(2, measured.shape[1]):
        state = state @ moving.T
        covariance = moving @ covariance @ moving.T + driven
        state, covariance = _updated(state, covariance, measured[:, k], noise[:, k])
        smoothed[:, k] = state[:, :2]
    return smoothed


def _start(first: Reals, second: Reals, interval: float) -> Reals:
    """Of the second measurement and of the difference of both over the interval."""
    return np.block(
        [
            [second, second / interval],
            [second / interval, (first + second) / interval**2],
        ]
    )


def _updated(state: Reals, covariance: Reals, measured: Reals, noise: Reals) -> tuple[Reals, Reals]:
    """Both after a measurement; the covariance as I - K H from both sides, which keeps it one."""
    innovation = covariance[:, :2, :2] + noise
    gain = np.swapaxes(np.linalg.solve(innovation, covariance[:, :2, :]), -1, -2)
    ahead = state[:, :2]
    state = state + (gain @ (measured - ahead)[..., None])[..., 0]
    rest = np.broadcast_to(np.eye(4), covariance.shape).copy()
    rest[:, :, :2] -= gain
    turned, back = np.swapaxes(rest, -1, -2), np.swapaxes(gain, -1, -2)
    return state, rest @ covariance @ turned + gain @ noise @ back
