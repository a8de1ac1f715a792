"""Covariances of three states as they are kept, and the way from and to their entries."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import recursion_three_states
from gainproof.time_varying.covariance import Real


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


def factors_of(covariance: ArrayLike) -> Factors:
    """The factors of covariances of shape (..., 3, 3), index 0 the position; float64.

    Taken in fractions, so that each is the factor of exactly these entries, rounded once: some ten
    microseconds a track.

    Raises ValueError, with the place, for a covariance that is not positive definite or not
    symmetric, and for one that has no such factors: entries 13 and 23 and the minor
    P12 P23 - P13 P22 must be 0 or above, and where entry 23 is 0 entry 13 must be 0 and entry 12
    not below. Predictions over some time bring others there; the recursion goes on from there.
    """
    array = np.asarray(covariance, np.float64)
    if array.shape[-2:] != (3, 3):
        raise ValueError(f"covariance must have shape (..., 3, 3), got {array.shape}")
    found = np.empty((6, *array.shape[:-2]))
    for place in np.ndindex(array.shape[:-2]):
        found[(slice(None), *place)] = _factors(array[place], place)
    return Factors(*(np.array(x)[()] for x in found))


def _factors(matrix: NDArray[np.float64], place: tuple[int, ...]) -> list[float]:
    where = f" at index {place[0] if len(place) == 1 else place}" if place else ""
    if not np.isfinite(matrix).all() or (matrix != matrix.T).any():
        raise ValueError(f"the covariance must be finite and symmetric, got {matrix}{where}")
    p11, p12, p13, _, p22, p23, _, _, p33 = (Fraction(float(x)) for x in matrix.flat)
    minor, mixed = p22 * p33 - p23 * p23, p12 * p23 - p13 * p22
    determinant = p11 * minor - p12 * (p12 * p33 - p13 * p23) + p13 * mixed
    if not (p33 > 0 and minor > 0 and determinant > 0):
        raise ValueError(
            "the covariance must be positive definite; entry 33, the last minor and the "
            f"determinant are {float(p33)}, {float(minor)}, {float(determinant)}{where}"
        )
    if p23 == 0 and p13 == 0:
        mixed = p12  # which has the sign of the third shear, then
        shears = Fraction(0), Fraction(0), p12 / p22
    elif p23 > 0:
        shears = p13 / p23, p23 / p33, p33 * mixed / (minor * p23)
    else:
        shears = p13, p23, mixed
    if min(shears) < 0 or (p23 == 0 and p13 != 0):
        raise ValueError(
            "entries 13 and 23 of the covariance and its minor P12 P23 - P13 P22 (entry 12 where "
            f"both are 0) must be 0 or above, got {float(p13)}, {float(p23)}, {float(mixed)}{where}"
        )
    return [float(x) for x in (determinant / minor, minor / p33, p33, *shears)]
