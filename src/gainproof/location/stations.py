"""Stations and what they observed, checked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import Reals, real

MOST = 1e15
"""Largest coordinate, m, and velocity, m/s, that is taken."""


@dataclass(frozen=True, eq=False)
class Stations:
    """names: n of them; positions (n, d) in m from the origin (d,), velocities (n, d) in m/s, d = 2
    or 3.
    """

    names: tuple[str, ...]
    positions: Reals
    velocities: Reals
    origin: Reals

    @property
    def dimension(self) -> int:
        return int(self.positions.shape[1])

    @property
    def centre(self) -> Reals:
        """Of the positions."""
        return np.asarray(self.positions.mean(axis=0))

    @property
    def spread(self) -> float:
        """Distance of the farthest station from their centre, m."""
        return float(np.sqrt(np.square(self.positions - self.centre).sum(axis=1)).max())


@dataclass(frozen=True, eq=False)
class Observations:
    """What was observed: first ranges, then range rates, of the stations with these numbers.

    values (m,) in m and m/s; station (m,) the number of each one's station; is_rate (m,) whether it
    is a range rate; covariance (m, m) of their noise, symmetric and positive definite.
    """

    values: Reals
    station: NDArray[np.intp]
    is_rate: NDArray[np.bool_]
    covariance: Reals

    @property
    def deviations(self) -> Reals:
        return np.sqrt(np.diag(self.covariance))


def stations(
    positions: ArrayLike,
    velocities: ArrayLike | None = None,
    names: Sequence[str] | None = None,
) -> Stations:
    """Stations from arrays (n, d); without velocities they stand still.

    ValueError and TypeError: shapes other than (n, 2) and (n, 3), NaN, names that are not n.
    """
    places = bounded("station positions", positions)
    if places.ndim != 2 or not len(places) or places.shape[1] not in (2, 3):
        raise ValueError(f"station positions must be (n, 2) or (n, 3), got shape {places.shape}")
    moving = np.zeros_like(places)
    if velocities is not None:
        moving = bounded("station velocities", velocities)
    if moving.shape != places.shape:
        raise ValueError(
            f"station velocities must have shape {places.shape} as the positions have, got "
            f"{moving.shape}"
        )
    own = tuple(names) if names is not None else tuple(f"B{i + 1}" for i in range(len(places)))
    if len(own) != len(places) or len(set(own)) != len(own):
        raise ValueError(f"wanted: {len(places)} names, each another, got {own}")
    return Stations(own, places, moving, np.zeros(places.shape[1]))


def from_the_first(given: Stations) -> Stations:
    """The same with the origin at the first station, so that coordinates are no larger than they
    have to be: how far away somebody's zero lies costs no digits.
    """
    first = given.positions[0]
    return replace(given, positions=given.positions - first, origin=given.origin + first)


def observations(
    given: Stations,
    ranges: Sequence[float | None] | Reals | None,
    range_rates: Sequence[float | None] | Reals | None,
    covariance: ArrayLike,
) -> Observations:
    """Ranges (n) in m and range rates (n) in m/s, in the order of the stations; None is none.

    covariance: of all that there is, first the ranges, then the range rates, (m, m). It is checked
    where it is used. ValueError: other lengths, NaN, a range that is not above 0.
    """
    values: list[float] = []
    station: list[int] = []
    is_rate: list[bool] = []
    for name, entries in (("ranges", ranges), ("range_rates", range_rates)):
        if entries is None:
            continue
        if len(entries) != len(given.names):
            raise ValueError(
                f"{name}: wanted {len(given.names)}, one a station, got {len(entries)}"
            )
        for i, entry in enumerate(entries):
            if entry is None:
                continue
            value = float(bounded(f"{name} of {given.names[i]}", entry))
            if name == "ranges" and not value > 0:
                raise ValueError(
                    f"ranges of {given.names[i]} must be above 0, got {value!s}: at 0 the target "
                    "is on the station"
                )
            values.append(value)
            station.append(i)
            is_rate.append(name == "range_rates")
    noise = real("covariance", covariance)
    if noise.shape != (len(values), len(values)):
        raise ValueError(
            f"covariance must be {(len(values), len(values))}, a row and a column for each "
            f"observation, got shape {noise.shape}"
        )
    return Observations(
        np.array(values, np.float64),
        np.array(station, np.intp),
        np.array(is_rate, np.bool_),
        noise,
    )


def bounded(name: str, value: ArrayLike) -> Reals:
    """Finite real numbers up to MOST."""
    array = real(name, value)
    if array.size and not np.abs(array).max() <= MOST:
        raise ValueError(f"{name} must not be beyond {MOST:g}, got {np.abs(array).max()!s}")
    return array
