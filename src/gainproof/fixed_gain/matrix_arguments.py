"""Matrix gains, intervals and covariances checked and brought to numbers without units."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from gainproof.fixed_gain.arguments import Reals, real

LARGEST = 1e100
"""Entries of K1 and T K2 that numbers are computed for."""
SYMMETRIC = 1e-12


@dataclass(frozen=True)
class Loop:
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


def loop(position_gain: ArrayLike, velocity_gain: ArrayLike, interval: float) -> Loop:
    """ValueError and TypeError as `interacting.poles` names them."""
    first = square("position_gain", position_gain)
    second = square("velocity_gain", velocity_gain)
    if first.shape != second.shape:
        raise ValueError(
            "position_gain and velocity_gain must have one shape, got "
            f"{first.shape} and {second.shape}"
        )
    step = interval_of(interval)
    with np.errstate(over="ignore"):
        scaled = step * second
    for name, matrix in (("position_gain", first), ("interval times velocity_gain", scaled)):
        most = float(np.abs(matrix).max())
        if not most <= LARGEST:
            raise ValueError(f"{name} must have no entry beyond {LARGEST:g}, got one of {most!s}")
    one, zero = np.eye(len(first)), np.zeros_like(first)
    transition = np.block([[one, one], [zero, one]])
    gain, seen = np.vstack([first, scaled]), np.hstack([one, zero])
    return Loop(first, second, step, transition, gain, seen)


def square(name: str, value: ArrayLike) -> Reals:
    """A square matrix, or an error with that name."""
    matrix = real(name, value)
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not matrix.size:
        raise ValueError(f"{name} must be a square matrix, got shape {matrix.shape}")
    return matrix


def interval_of(value: float) -> float:
    """T above 0, in s."""
    step = real("interval", value)
    if step.shape or not step > 0:
        raise ValueError(f"interval must be one number above 0, in s, got {value!r}")
    return float(step)


def covariance(value: ArrayLike, size: int) -> tuple[Reals, int]:
    """B over a power of two, which comes with it, so that its largest entry is about 1."""
    noise = square("measurement_covariance", value)
    if len(noise) != size:
        raise ValueError(
            f"measurement_covariance must have shape {(size, size)} as the gains have, got "
            f"{noise.shape}"
        )
    noise, exponent = about_one(noise)
    top = float(np.abs(noise).max())
    if np.abs(noise - noise.T).max() > SYMMETRIC * top:
        raise ValueError("measurement_covariance must be symmetric, got one that is not")
    least = float(np.linalg.eigvalsh(noise)[0])
    if least < -SYMMETRIC * top:
        told = float(np.ldexp(least, exponent))
        raise ValueError(f"measurement_covariance must have no eigenvalue below 0, got {told!s}")
    return (noise + noise.T) / 2, exponent


def about_one(matrix: Reals) -> tuple[Reals, int]:
    """The matrix over a power of two, and its exponent: the largest entry from 1/2 to below 1."""
    exponent = int(np.frexp(np.abs(matrix).max())[1])
    return np.ldexp(matrix, -exponent), exponent
