"""Geometries for tests of locations: rational ones, and random ones with correlated noise."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from gainproof.location.stations import Observations, Stations, observations, stations

Reals = NDArray[np.float64]
PYTHAGOREAN = {
    2: ((3, 4), (-5, 12), (8, -15), (-20, -21), (24, 7), (-12, 35)),
    3: (
        *((1, 2, 2), (-2, 3, 6), (4, -4, 7), (2, 6, -9)),
        *((-6, -6, 7), (3, -4, -12), (-8, 1, 4), (9, 8, -12)),
    ),
}
"""Differences whose length is an integer."""


@dataclass(frozen=True, eq=False)
class Scene:
    """Stations, the true state (position, velocity), and the noise's covariance."""

    stations: Stations
    state: Reals
    covariance: Reals

    @property
    def true(self) -> Reals:
        """Ranges, then range rates, of the plain formulas."""
        d = self.stations.dimension
        apart = self.state[:d] - self.stations.positions
        motion = self.state[d:] - self.stations.velocities
        length = np.sqrt((apart**2).sum(axis=1))
        return np.concatenate([length, (apart * motion).sum(axis=1) / length])

    def observed(self, noise: Reals, biases: Reals | float = 0.0) -> Observations:
        """noise (2n,) in white deviations; biases (n,) on the ranges."""
        n = len(self.stations.names)
        values = self.true + np.linalg.cholesky(self.covariance) @ noise
        values[:n] += biases
        return observations(self.stations, values[:n], values[n:], self.covariance)


def rows(count: int) -> list[tuple[int, bool]]:
    """Every station's range, then every station's range rate."""
    return [(i, is_rate) for is_rate in (False, True) for i in range(count)]


def rational(dimension: int) -> tuple[list[tuple[Fraction, ...]], tuple[Fraction, ...]]:
    """Moving stations around a target, all distances rational; metres and seconds."""
    state = (100, -200, 50)[:dimension] + (7, -3, 2)[:dimension]
    target = tuple(Fraction(part) for part in state)
    found = []
    for i, apart in enumerate(PYTHAGOREAN[dimension]):
        place = [target[j] - 10 * part for j, part in enumerate(apart)]
        motion = [Fraction((-1) ** (i + j) * (i + 2 * j), 3) for j in range(dimension)]
        found.append(tuple(Fraction(part) for part in (*place, *motion)))
    return found, target


def rational_covariance(count: int) -> list[list[Fraction]]:
    """Ranges 5 m, rates 1/5 m/s, with correlations within and between."""
    size = 2 * count
    scale = [Fraction(5)] * count + [Fraction(1, 5)] * count
    return [
        [
            scale[i] * scale[j] * (1 if i == j else Fraction((-1) ** (i + j), 3 + abs(i - j) ** 2))
            for j in range(size)
        ]
        for i in range(size)
    ]


def random_scene(seed: int, dimension: int, count: int, correlated: bool = True) -> Scene:
    """Kilometres between stations, tens of metres and decimetres a second of noise."""
    random = np.random.default_rng(seed)
    places = random.uniform(-1e4, 1e4, (count, dimension))
    motion = random.uniform(-30, 30, (count, dimension))
    place, velocity = random.uniform(-6e3, 6e3, dimension), random.uniform(-200, 200, dimension)
    state = np.concatenate([place, velocity])
    deviations = np.concatenate([random.uniform(3, 15, count), random.uniform(0.03, 0.2, count)])
    mixed = random.standard_normal((2 * count, 2 * count)) * (0.35 if correlated else 0.0)
    correlation = mixed @ mixed.T + np.eye(2 * count)
    size = np.sqrt(np.diag(correlation))
    covariance = correlation / size[:, None] / size * deviations[:, None] * deviations
    return Scene(stations(places, motion), state, (covariance + covariance.T) / 2)
