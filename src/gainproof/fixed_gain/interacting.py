"""Filters whose coordinates interact: full gain matrices, by numbers.

The state is n positions, then n velocities; the positions are measured. K1 carries the innovations
to the positions (no unit), K2 to the velocities (1/s), T is the interval in s; a non-interacting
filter has K1 = diag(alpha), K2 = diag(beta/T). F (I - K H) carries the error of the prediction on.
Source: the lecture's slide on interacting filters (6 x 6 with n = 3). Stability is decided exactly
(`exact_stability`). No other number here has a proved bound: eigenvalues are NumPy's, the
covariance is a sum of positive terms that is doubled until it stands.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain import exact_stability
from gainproof.fixed_gain.arguments import Reals, real

DOUBLINGS = 60
"""A modulus of 1 - 2^-52 to the power 2^60 is nothing."""
SINGULAR = 2.0**-48
"""Smallest over largest singular value below which a matrix is taken to be singular."""
LOST = 2.0**-20
"""Share of a covariance that rounding the gains' sums may move before none is given."""


class Covariances(NamedTuple):
    """Steady covariances under measurement noise alone, 2n x 2n: positions, then velocities; m^2,
    m^2/s and m^2/s^2 with B in m^2.
    """

    predicted: Reals
    smoothed: Reals


def poles(
    position_gain: ArrayLike, velocity_gain: ArrayLike, interval: float
) -> NDArray[np.complex128]:
    """The 2n eigenvalues of F (I - K H), that of largest modulus first.

    position_gain: K1, n x n. velocity_gain: K2, n x n, 1/s. interval: T, s, above 0. Entries of K1
    and T K2 are at most 1e100.

    ValueError for matrices that are not square or not of one size, for NaN and infinity, for larger
    entries, and for an interval that is not positive; TypeError for what is no real number.
    """
    return _eigenvalues(_loop(position_gain, velocity_gain, interval))


def _eigenvalues(given: _Loop) -> NDArray[np.complex128]:
    found = np.linalg.eigvals(given.closed)
    return np.asarray(found[np.argsort(-np.abs(found), kind="stable")], np.complex128)


def is_stable(position_gain: ArrayLike, velocity_gain: ArrayLike, interval: float) -> bool:
    """Whether all eigenvalues of F (I - K H) have moduli below 1: exactly, for the floats given.

    On the border it is not stable. Errors as `poles`. Long integers: fit for a few coordinates.
    """
    given = _loop(position_gain, velocity_gain, interval)
    return exact_stability.stable(given.position_gain, given.velocity_gain, given.interval)


def covariances(
    position_gain: ArrayLike,
    velocity_gain: ArrayLike,
    interval: float,
    measurement_covariance: ArrayLike,
) -> Covariances:
    """W = F (I - K H) W (F (I - K H))' + F K B (F K)', and what is left of it after the update.

    measurement_covariance: B, n x n, symmetric, no eigenvalue below 0, m^2. Other arguments as
    `poles`.

    ValueError besides for a filter that is not stable (as `is_stable` decides), for one so near the
    border that float64 has no covariance of it, for a covariance beyond float64, and for a B that
    is not of that kind.
    """
    given = _loop(position_gain, velocity_gain, interval)
    noise, exponent = _covariance(measurement_covariance, len(given.position_gain))
    _require_stable(given)
    closed = given.closed
    carried = _doubled(closed, np.eye(len(closed)))
    sizes = float(np.abs(carried).max()) * max(1.0, float(np.abs(given.gain).max())) ** 2
    if not 2.0**-52 * sizes < LOST:
        raise ValueError("too near the border of stability for a covariance in float64")
    column = given.transition @ given.gain
    predicted = _doubled(closed, column @ noise @ column.T)
    smoothed = given.rest @ predicted @ given.rest.T + given.gain @ noise @ given.gain.T
    both = predicted, (smoothed + smoothed.T) / 2
    return Covariances(*(_with_units(matrix, given.interval, exponent) for matrix in both))


def lag(
    velocity_gain: ArrayLike,
    interval: float,
    acceleration: ArrayLike,
    position_gain: ArrayLike | None = None,
) -> Reals:
    """Steady error of the predicted position behind a constant acceleration: T K2^-1 a_c, in m.

    velocity_gain: K2, n x n, 1/s. interval: T, s. acceleration: a_c, n numbers, m/s^2. It is the
    steady error of a stable filter; whether it is one depends on K1 as well: with `position_gain`
    that is decided, without it what is asked of K2 alone, a determinant above 0.

    ValueError for a K2 that is singular to working precision (then there is no such steady error:
    behind some acceleration the error grows), for a K2 or K1 and K2 that are not stable, for a lag
    beyond float64, and for shapes that do not fit.
    """
    gain = _square("velocity_gain", velocity_gain)
    course = real("acceleration", acceleration)
    if course.shape != (len(gain),):
        raise ValueError(
            f"acceleration must have shape ({len(gain)},) for a velocity_gain {gain.shape}, "
            f"got {course.shape}"
        )
    step = _interval_of(interval)
    scaled, exponent = _about_one(gain)
    sizes = np.linalg.svd(scaled, compute_uv=False)
    if not sizes[-1] > SINGULAR * sizes[0]:
        least, most = (float(np.ldexp(sizes[place], exponent)) for place in (-1, 0))
        raise ValueError(
            "velocity_gain is singular: its least singular value is "
            f"{least!s}, its largest {most!s}; the lag T K2^-1 a_c does not exist"
        )
    if position_gain is not None:
        _require_stable(_loop(position_gain, gain, step))
    elif not exact_stability.determinant(gain) > 0:
        raise ValueError(
            "no filter with this velocity_gain is stable: its determinant must be above 0, got "
            f"{float(np.linalg.det(scaled)):.6g} for velocity_gain over 2^{exponent}"
        )
    pull, more = _about_one(course)
    front, most_of = np.frexp(step)
    with np.errstate(over="ignore"):
        found = np.ldexp(front * np.linalg.solve(scaled, pull), int(most_of) + more - exponent)
    if not np.isfinite(found).all():
        raise ValueError("the lag T K2^-1 a_c is beyond float64")
    return np.asarray(found, np.float64)


def _require_stable(given: _Loop) -> None:
    if not exact_stability.stable(given.position_gain, given.velocity_gain, given.interval):
        if exact_stability.determinant(given.velocity_gain) == 0:
            raise ValueError(
                "not a stable filter: velocity_gain is singular, its determinant is exactly 0; "
                "velocities that it does not correct stay as they are, with an eigenvalue 1"
            )
        largest = float(np.abs(_eigenvalues(given)[0]))
        raise ValueError(
            "not a stable filter: the eigenvalues of F (I - K H) must have moduli below 1, which "
            f"is decided exactly; the largest, as rounded, is {largest!s}"
        )


def _with_units(matrix: Reals, interval: float, exponent: int) -> Reals:
    """Velocities over T, and B's power of two."""
    half = len(matrix) // 2
    front, power = np.frexp(interval)
    times = np.repeat([0, 1], half)
    count = times[:, np.newaxis] + times
    with np.errstate(over="ignore"):
        found = np.ldexp(matrix / front**count, exponent - int(power) * count)
    if not np.isfinite(found).all():
        raise ValueError("the covariance is beyond float64 in these units")
    return np.asarray(found)


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


_LARGEST = 1e100
"""Entries of K1 and T K2 that numbers are computed for."""
_SYMMETRIC = 1e-12


@dataclass(frozen=True)
class _Loop:
    """F, K, H of one filter with velocities times T: K is K1 over T K2. Checked."""

    position_gain: Reals
    velocity_gain: Reals
    interval: float
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


def _loop(position_gain: ArrayLike, velocity_gain: ArrayLike, interval: float) -> _Loop:
    """ValueError and TypeError as `poles` names them."""
    first = _square("position_gain", position_gain)
    second = _square("velocity_gain", velocity_gain)
    if first.shape != second.shape:
        raise ValueError(
            "position_gain and velocity_gain must have one shape, got "
            f"{first.shape} and {second.shape}"
        )
    step = _interval_of(interval)
    with np.errstate(over="ignore"):
        scaled = step * second
    for name, matrix in (("position_gain", first), ("interval times velocity_gain", scaled)):
        most = float(np.abs(matrix).max())
        if not most <= _LARGEST:
            raise ValueError(f"{name} must have no entry beyond {_LARGEST:g}, got one of {most!s}")
    one, zero = np.eye(len(first)), np.zeros_like(first)
    transition = np.block([[one, one], [zero, one]])
    gain, seen = np.vstack([first, scaled]), np.hstack([one, zero])
    return _Loop(first, second, step, transition, gain, seen)


def _square(name: str, value: ArrayLike) -> Reals:
    """A square matrix, or an error with that name."""
    matrix = real(name, value)
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not matrix.size:
        raise ValueError(f"{name} must be a square matrix, got shape {matrix.shape}")
    return matrix


def _interval_of(value: float) -> float:
    """T above 0, in s."""
    step = real("interval", value)
    if step.shape or not step > 0:
        raise ValueError(f"interval must be one number above 0, in s, got {value!r}")
    return float(step)


def _covariance(value: ArrayLike, size: int) -> tuple[Reals, int]:
    """B over a power of two, which comes with it, so that its largest entry is about 1."""
    noise = _square("measurement_covariance", value)
    if len(noise) != size:
        raise ValueError(
            f"measurement_covariance must have shape {(size, size)} as the gains have, got "
            f"{noise.shape}"
        )
    noise, exponent = _about_one(noise)
    top = float(np.abs(noise).max())
    if np.abs(noise - noise.T).max() > _SYMMETRIC * top:
        raise ValueError("measurement_covariance must be symmetric, got one that is not")
    least = float(np.linalg.eigvalsh(noise)[0])
    if least < -_SYMMETRIC * top:
        told = float(np.ldexp(least, exponent))
        raise ValueError(f"measurement_covariance must have no eigenvalue below 0, got {told!s}")
    return (noise + noise.T) / 2, exponent


def _about_one(matrix: Reals) -> tuple[Reals, int]:
    """The matrix over a power of two, and its exponent: the largest entry from 1/2 to below 1."""
    exponent = int(np.frexp(np.abs(matrix).max())[1])
    return np.ldexp(matrix, -exponent), exponent
