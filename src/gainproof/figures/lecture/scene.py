"""A target that flies straight, turns, and flies straight on, and a radar that sees it.

The target and the noise are simulated here, no formula under test; what the radar measures goes to
Cartesian coordinates by the kernels of polar coordinates.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from gainproof.generated import polar_coordinates
from gainproof.plots.table import Reals

STANDARD_GRAVITY = 9.80665


@dataclass(frozen=True)
class Scene:
    """The turning target of the lecture, which gives the first four numbers, and what is ours.

    Metres, seconds, radians; bearings clockwise from north; x to the east, y to the north, the
    radar at the origin.
    """

    acceleration: float = 0.1 * STANDARD_GRAVITY
    interval: float = 10.0
    range_deviation: float = 8.0
    bearing_deviation: float = np.deg2rad(0.06)
    speed: float = 200.0
    start: tuple[float, float] = (-80e3, 90e3)
    heading: float = np.deg2rad(90.0)
    turn_begins: float = 400.0
    turned: float = np.deg2rad(90.0)
    last_sample: int = 110

    @property
    def times(self) -> Reals:
        """Of the samples, from zero on."""
        return self.interval * np.arange(self.last_sample + 1.0)

    @property
    def turn_rate(self) -> float:
        """Radians a second, clockwise."""
        return self.acceleration / self.speed

    @property
    def turn_ends(self) -> float:
        """When it flies straight again."""
        return self.turn_begins + self.turned / self.turn_rate

    @property
    def in_turn(self) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """Which samples have the target in its turn."""
        return (self.times > self.turn_begins) & (self.times <= self.turn_ends)

    def positions(self) -> Reals:
        """Where the target is at each sample, (samples, 2)."""
        straight = np.minimum(self.times, self.turn_begins)
        turning = np.clip(self.times - self.turn_begins, 0.0, self.turned / self.turn_rate)
        after = np.maximum(self.times - self.turn_ends, 0.0)
        first, angle = self.heading, self.heading + self.turn_rate * turning
        radius = self.speed / self.turn_rate
        x = self.speed * (straight * np.sin(first) + after * np.sin(first + self.turned))
        y = self.speed * (straight * np.cos(first) + after * np.cos(first + self.turned))
        x += self.start[0] + radius * (np.cos(first) - np.cos(angle))
        y += self.start[1] + radius * (np.sin(angle) - np.sin(first))
        return np.stack([x, y], axis=-1)


@dataclass(frozen=True)
class Seen:
    """What the radar measured in each run, (runs, samples): range in m, bearing in rad."""

    range: Reals
    bearing: Reals

    @property
    def positions(self) -> Reals:
        """The same in coordinates, (runs, samples, 2)."""
        x, y = polar_coordinates.to_cartesian_in_plane(self.range, self.bearing)
        return _together(x, y)

    def covariances(self, scene: Scene) -> Reals:
        """Of the measured positions to first order, at the measurement, (runs, samples, 2, 2)."""
        deviations = scene.range_deviation, scene.bearing_deviation
        xx, xy, yy = polar_coordinates.noise_covariance_in_plane(
            self.range, self.bearing, *deviations
        )
        return _together(_together(xx, xy), _together(xy, yy))


def seen(scene: Scene, runs: int, seed: int) -> Seen:
    """Range and bearing with normal noise, independent from sample to sample and run to run."""
    x, y = scene.positions().T
    noise = np.random.default_rng(seed).standard_normal((2, runs, x.size))
    return Seen(
        np.hypot(x, y) + scene.range_deviation * noise[0],
        np.arctan2(x, y) + scene.bearing_deviation * noise[1],
    )


def _together(first: ArrayLike, second: ArrayLike) -> Reals:
    """Both along a new last axis; rows of a symmetric matrix may be stacked as columns."""
    return np.stack([np.asarray(first, np.float64), np.asarray(second, np.float64)], axis=-1)
