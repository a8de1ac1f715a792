"""Covariances as they are kept, and the way from and to their entries."""

from __future__ import annotations

from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import recursion_two_states

Real: TypeAlias = float | np.floating[Any] | NDArray[np.floating[Any]]
Reals: TypeAlias = NDArray[np.float64]

# splits a float64 into two halves of 26 digits whose products are exact
SPLITTER = 2.0**27 + 1.0


class Factors(NamedTuple):
    """Covariances P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1] of position and velocity.

    ``diagonal_1``: d1, in m^2, the position's variance where the velocity is known. ``shear``: u,
    in s, covariance over the velocity's variance. ``diagonal_2``: d2, in m^2/s^2, the velocity's
    variance. Numbers, or arrays of tracks.
    """

    diagonal_1: Real
    shear: Real
    diagonal_2: Real


def factors_of(position: ArrayLike, position_velocity: ArrayLike, velocity: ArrayLike) -> Factors:
    """The factors of covariances with the entries 11 (m^2), 12 (m^2/s) and 22 (m^2/s^2).

    Numbers or arrays, broadcast together, float64. The one difference that is needed, that of the
    determinant, is taken of exact products, so that d1 is right to a few 2^-52 of
    itself as long as the products do not leave the range of float64.

    Raises ValueError for a covariance that is not positive definite, with its place, and for a
    negative entry 12: then position and velocity err against each other, which predictions over
    some time turn; the recursion takes it from there on.
    """
    p11, p12, p22 = (np.asarray(x, np.float64) for x in (position, position_velocity, velocity))
    p11, p12, p22 = np.broadcast_arrays(p11, p12, p22)
    with np.errstate(all="ignore"):
        determinant = _difference_of_products(p11, p22, p12)
        _require(p12 >= 0, "entry 12 of the covariance must be 0 or above", p12)
        _require(
            (p22 > 0) & (determinant > 0) & np.isfinite(p11) & np.isfinite(p22),
            "the covariance must be positive definite; its determinant",
            determinant,
        )
        found = determinant / p22, p12 / p22, p22
    return Factors(*(np.array(x)[()] for x in found))


def covariance_of(factors: Factors) -> NDArray[np.floating[Any]]:
    """Covariances as arrays of shape (..., 2, 2), index 0 the position."""
    p11, p12, p22 = (np.asarray(x) for x in recursion_two_states.covariance(*factors))
    return np.stack([np.stack([p11, p12], -1), np.stack([p12, p22], -1)], -2)


def _difference_of_products(a: Reals, b: Reals, c: Reals) -> Reals:
    """a b - c c, from the products with their rounding errors."""
    first, first_rest = _product(a, b)
    second, second_rest = _product(c, c)
    return np.asarray((first - second) + (first_rest - second_rest))


def _product(a: Reals, b: Reals) -> tuple[Reals, Reals]:
    """a b rounded, and what is missing (Dekker)."""
    whole = a * b
    (a_high, a_low), (b_high, b_low) = _halves(a), _halves(b)
    rest = ((a_high * b_high - whole) + a_high * b_low + a_low * b_high) + a_low * b_low
    return whole, rest


def _halves(x: Reals) -> tuple[Reals, Reals]:
    wide = SPLITTER * x
    high = wide - (wide - x)
    return high, x - high


def _require(fine: Any, wanted: str, array: Reals) -> None:
    if np.all(fine):
        return
    first = int(np.argmin(fine))
    place = tuple(int(i) for i in np.unravel_index(first, array.shape))
    where = f" at index {place[0] if len(place) == 1 else place}" if place else ""
    raise ValueError(f"{wanted}, got {array.flat[first]!s}{where}")
