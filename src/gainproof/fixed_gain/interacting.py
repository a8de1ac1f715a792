"""Filters whose coordinates interact: full gain matrices, by numbers.

The state is n positions, then n velocities; the positions are measured. K1 carries the innovations
to the positions (no unit), K2 to the velocities (1/s), T is the interval in s; a non-interacting
filter has K1 = diag(alpha), K2 = diag(beta/T). F (I - K H) carries the error of the prediction on.
Source: the lecture's slide on interacting filters (6 x 6 with n = 3). Nothing here has a proved
bound: eigenvalues are NumPy's, the covariance is a sum of positive terms that is doubled until it
stands.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import Reals, real

DOUBLINGS = 60
"""A modulus of 1 - 2^-52 to the power 2^60 is nothing."""
SYMMETRIC = 1e-12
SINGULAR = 2.0**-48
"""Smallest over largest singular value below which a matrix is taken to be singular."""


class Covariances(NamedTuple):
    """Steady covariances under measurement noise alone, 2n x 2n: positions, then velocities; m^2,
    m^2/s and m^2/s^2 with B in m^2.
    """

    predicted: Reals
    smoothed: Reals


@dataclass(frozen=True)
class _Loop:
    """F, K, H of one filter, checked."""

    transition: Reals
    gain: Reals
    measurement: Reals

    @property
    def rest(self) -> Reals:
        """I - K H."""
        return np.eye(len(self.transition)) - self.gain @ self.measurement

    @property
    def closed(self) -> Reals:
        """F (I - K H)."""
        return np.asarray(self.transition @ self.rest)


def poles(
    position_gain: ArrayLike, velocity_gain: ArrayLike, interval: float
) -> NDArray[np.complex128]:
    """The 2n eigenvalues of F (I - K H), that of largest modulus first.

    position_gain: K1, n x n. velocity_gain: K2, n x n, 1/s. interval: T, s, above 0.

    ValueError for matrices that are not square or not of one size, for NaN and infinity, and for an
    interval that is not positive; TypeError for what is no real number.
    """
    found = np.linalg.eigvals(_loop(position_gain, velocity_gain, interval).closed)
    return np.asarray(found[np.argsort(-np.abs(found), kind="stable")], np.complex128)


def is_stable(position_gain: ArrayLike, velocity_gain: ArrayLike, interval: float) -> bool:
    """Whether all eigenvalues of F (I - K H), as computed, have moduli below 1."""
    return bool(np.abs(poles(position_gain, velocity_gain, interval)[0]) < 1)


def covariances(
    position_gain: ArrayLike,
    velocity_gain: ArrayLike,
    interval: float,
    measurement_covariance: ArrayLike,
) -> Covariances:
    """W = F (I - K H) W (F (I - K H))' + F K B (F K)', and what is left of it after the update.

    measurement_covariance: B, n x n, symmetric, no eigenvalue below 0, m^2. Other arguments as
    `poles`.

    ValueError besides for a filter that is not stable, with the largest modulus, and for a B that
    is not of that kind.
    """
    loop = _loop(position_gain, velocity_gain, interval)
    noise = _covariance(measurement_covariance, len(loop.gain) // 2)
    largest = float(np.abs(np.linalg.eigvals(loop.closed)).max())
    if not largest < 1:
        raise ValueError(
            "not a stable filter: the eigenvalues of F (I - K H) must have moduli below 1, the "
            f"largest is {largest!s}"
        )
    column = loop.transition @ loop.gain
    predicted = _doubled(loop.closed, column @ noise @ column.T)
    smoothed = loop.rest @ predicted @ loop.rest.T + loop.gain @ noise @ loop.gain.T
    return Covariances(predicted, (smoothed + smoothed.T) / 2)


def lag(velocity_gain: ArrayLike, interval: float, acceleration: ArrayLike) -> Reals:
    """Steady error of the predicted position behind a constant acceleration: T K2^-1 a_c, in m.

    velocity_gain: K2, n x n, 1/s. interval: T, s. acceleration: a_c, n numbers, m/s^2. It is the
    steady error of a stable filter; whether it is one depends on K1 as well (see `is_stable`).

    ValueError for a K2 that is singular to working precision (then there is no such steady error:
    behind some acceleration the error grows), and for shapes that do not fit.
    """
    gain = _square("velocity_gain", velocity_gain)
    course = real("acceleration", acceleration)
    if course.shape != (len(gain),):
        raise ValueError(
            f"acceleration must have shape ({len(gain)},) for a velocity_gain {gain.shape}, "
            f"got {course.shape}"
        )
    step = _interval(interval)
    sizes = np.linalg.svd(gain, compute_uv=False)
    if not sizes[-1] > SINGULAR * sizes[0]:
        raise ValueError(
            "velocity_gain is singular: its least singular value is "
            f"{sizes[-1]!s}, its largest {sizes[0]!s}; the lag T K2^-1 a_c does not exist"
        )
    return np.asarray(step * np.linalg.solve(gain, course), np.float64)


def _loop(position_gain: ArrayLike, velocity_gain: ArrayLike, interval: float) -> _Loop:
    first, second = (
        _square("position_gain", position_gain),
        _square("velocity_gain", velocity_gain),
    )
    if first.shape != second.shape:
        raise ValueError(
            "position_gain and velocity_gain must have one shape, got "
            f"{first.shape} and {second.shape}"
        )
    one, zero = np.eye(len(first)), np.zeros_like(first)
    transition = np.block([[one, _interval(interval) * one], [zero, one]])
    return _Loop(transition, np.vstack([first, second]), np.hstack([one, zero]))


def _square(name: str, value: ArrayLike) -> Reals:
    matrix = real(name, value)
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not matrix.size:
        raise ValueError(f"{name} must be a square matrix, got shape {matrix.shape}")
    return matrix


def _interval(value: float) -> float:
    step = real("interval", value)
    if step.shape or not step > 0:
        raise ValueError(f"interval must be one number above 0, in s, got {value!r}")
    return float(step)


def _covariance(value: ArrayLike, size: int) -> Reals:
    noise = _square("measurement_covariance", value)
    if len(noise) != size:
        raise ValueError(
            f"measurement_covariance must have shape {(size, size)} as the gains have, got "
            f"{noise.shape}"
        )
    top = float(np.abs(noise).max())
    if np.abs(noise - noise.T).max() > SYMMETRIC * top:
        raise ValueError("measurement_covariance must be symmetric, got one that is not")
    least = float(np.linalg.eigvalsh(noise)[0])
    if least < -SYMMETRIC * top:
        raise ValueError(f"measurement_covariance must have no eigenvalue below 0, got {least!s}")
    return (noise + noise.T) / 2


def _doubled(closed: Reals, noise: Reals) -> Reals:
    """The sum of A^k Q A'^k over all k: twice as many terms with each round.

    ValueError where it does not come to rest, so near is the border of stability.
    """
    total, power = (noise + noise.T) / 2, closed
    with np.errstate(over="ignore", invalid="ignore"):
        for _ in range(DOUBLINGS):
            more = power @ total @ power.T
            total = total + (more + more.T) / 2
            power = power @ power
            if not np.isfinite(total).all():
                break
            if np.abs(more).max() <= 2.0**-60 * np.abs(total).max():
                return np.asarray(total)
    raise ValueError("too near the border of stability for a covariance in float64")
