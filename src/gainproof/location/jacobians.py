"""Ranges and range rates of many targets from many stations, with their derivatives, as arrays.

A state is position and velocity side by side, 6 numbers in space and 4 in the plane. The numbers
come from the printed kernels `range_doppler` and `range_doppler_in_plane`, whose bounds they keep:
derivatives stand in the order of the states, so that a row of `rate_D_target` is that of a design
matrix.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import range_doppler
from gainproof.location.errors import OnStationError

Floats = NDArray[np.floating[Any]]
Reals = NDArray[np.float64] | NDArray[np.float32]
LEAST = {"float64": 1e-20, "float32": 1e-6}
"""The least distance of the kernels."""


class Jacobians(NamedTuple):
    """Of N targets from m stations, each with s = 6 or 4 numbers a state."""

    slant_range: Reals
    """Ranges, (N, m), m."""
    range_rate: Reals
    """Range rates, (N, m), m/s, above 0 where the two part."""
    range_D_target: Reals
    """Derivatives of the ranges by the targets' states, (N, m, s): unit vectors, then zeros."""
    rate_D_target: Reals
    """Derivatives of the range rates by the targets' states, (N, m, s): 1/s, then unit vectors."""

    @property
    def range_D_station(self) -> Reals:
        """By the stations' states: the negatives."""
        return -self.range_D_target

    @property
    def rate_D_station(self) -> Reals:
        """By the stations' states: the negatives."""
        return -self.rate_D_target


def range_doppler_jacobians(targets: ArrayLike, stations: ArrayLike) -> Jacobians:
    """Every target from every station.

    targets: states (N, 6) or (N, 4), x, y, z and their rates, m and m/s. stations: states (m, 6) or
    (m, 4); or (N, m, 6) and (N, m, 4) where they are others for each target, as stations that move
    between observations. float32 where both are float32, else float64. Errors are those that
    `range_doppler` states for its outputs, relative to its terms where they cancel.

    Raises ValueError for shapes that do not fit, and for what is no number or beyond the domain of
    the kernels, with its place; OnStationError, which names target and station by their numbers
    from 0, where the two are less than 1e-20 m (float32: 1e-6 m) apart. TypeError for what is not
    real.
    """
    seen, sites = _states("targets", targets), _states("stations", stations)
    size = _checked(seen, sites)
    single = seen.dtype == np.float32 and sites.dtype == np.float32
    target, station = (
        np.moveaxis(each if single else each.astype(np.float64, copy=False), -1, 0)
        for each in (seen[:, None, :], sites if sites.ndim == 3 else sites[None])
    )
    half = size // 2
    kernel = range_doppler.range_doppler if half == 3 else range_doppler.range_doppler_in_plane
    shape = (len(seen), sites.shape[-2])
    kind: np.dtype[Any] = np.dtype(np.float32 if single else np.float64)
    found = Jacobians(
        np.empty(shape, kind),
        np.empty(shape, kind),
        np.zeros((*shape, size), kind),
        np.empty((*shape, size), kind),
    )
    unit, turning = found.range_D_target[..., :half], found.rate_D_target[..., :half]
    slopes = [*np.moveaxis(unit, -1, 0), *np.moveaxis(turning, -1, 0)]
    try:
        kernel(*target, *station, out=(found.slant_range, found.range_rate, *slopes))
    except ValueError:
        with np.errstate(over="ignore"):
            _apart(target[:half] - station[:half])
        raise
    found.rate_D_target[..., half:] = unit
    return found


def _states(name: str, given: ArrayLike) -> Floats:
    """As an array of real, finite numbers."""
    try:
        found = np.asarray(given)
    except ValueError:
        raise ValueError(f"{name} must be an array, got rows of unlike lengths") from None
    if found.dtype.kind not in "iuf" or found.dtype.type in (np.float16, np.longdouble):
        raise TypeError(f"{name} must be real numbers of float64 or float32, got {found.dtype}")
    wide: Floats = found if found.dtype.kind == "f" else found.astype(np.float64)
    wrong = np.argwhere(~np.isfinite(wide))
    if wrong.size:
        place = tuple(int(number) for number in wrong[0])
        raise ValueError(f"{name} must be finite numbers, got {wide[place]} at index {place}")
    return wide


def _checked(targets: Floats, stations: Floats) -> int:
    """How many numbers a state has; ValueError where shapes do not fit."""
    came = f"got targets {targets.shape} and stations {stations.shape}"
    if targets.ndim != 2 or stations.ndim not in (2, 3):
        raise ValueError(
            f"wanted targets (N, 6) or (N, 4) and stations (m, 6) or (N, m, 6), (m, 4) or "
            f"(N, m, 4); {came}"
        )
    size = int(targets.shape[1])
    if size not in (4, 6) or stations.shape[-1] != size:
        raise ValueError(f"states of targets and stations must have 6 numbers, or both 4; {came}")
    if stations.ndim == 3 and stations.shape[0] != targets.shape[0]:
        raise ValueError(f"stations (N, m, {size}) are wanted for as many targets; {came}")
    return size


def _apart(between: Floats) -> None:
    """OnStationError for a target on a station: the first, by number."""
    near = np.sqrt(np.square(between).sum(axis=0)) < LEAST[between.dtype.name]
    if near.any():
        target, station = (int(number) for number in np.argwhere(near)[0])
        raise OnStationError(
            f"target {target} is on station {station}: where a range is 0 it has no derivative",
            str(station),
        ) from None
