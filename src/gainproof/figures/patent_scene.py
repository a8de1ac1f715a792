"""The experiment of JP4869403B2: its parameters, and four paths, which are ours.

The source gives noise, interval and process noise, no path, no nominal point and no number of runs.
Every path has its own stream of random numbers, so that one alone comes out as all do.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from gainproof.plots.table import Reals
from gainproof.tracking.conversion import DEFAULT, converted
from gainproof.tracking.gains import Point, exact_point
from gainproof.tracking.measured import Measured, Polar
from gainproof.tracking.nominal import diagonal, index_of

ACCELERATION = 0.98
"""sigma_w, m/s^2."""
RANGE_DEVIATION, BEARING_DEVIATION = 50.0, float(np.deg2rad(1.0))
INTERVAL = 5.0
CONVERSION = DEFAULT
RUNS, SAMPLES, SEED = 500, 61, 4869403
SETTLED = 10
"""Samples that the figures told in words leave out."""
SPEED = 250.0
NOMINAL: Mapping[str, float] = {"far": 80e3, "middle": 40e3, "near": 10e3}
"""Ranges of the nominal points, m, at a bearing of 45 degrees: x and y have the same index there"""


@dataclass(frozen=True)
class Truth:
    """position and velocity, (samples, runs or 1, 2), m and m/s."""

    position: Reals
    velocity: Reals


def _radial(_draw: np.random.Generator) -> Truth:
    """Straight at the radar from 80 km at a bearing of 30 degrees, to 5 km."""
    way = np.array([np.sin(np.pi / 6), np.cos(np.pi / 6)])
    far = 80e3 - SPEED * _times()
    return Truth((far[:, None] * way)[:, None], np.broadcast_to(-SPEED * way, (SAMPLES, 1, 2)))


def _crossing(_draw: np.random.Generator) -> Truth:
    """Straight past the radar, 10 km north of it."""
    east = -37.5e3 + SPEED * _times()
    position = np.stack([east, np.full(SAMPLES, 10e3)], -1)[:, None]
    return Truth(position, np.broadcast_to((SPEED, 0.0), (SAMPLES, 1, 2)))


def _turning(_draw: np.random.Generator) -> Truth:
    """A turn of 0.3 g (2.94 m/s^2) all the time, round a place 35 km away."""
    acceleration = 3 * ACCELERATION
    radius, rate = SPEED**2 / acceleration, acceleration / SPEED
    angle = rate * _times()
    place = np.stack([10e3 + radius * np.cos(angle), 33e3 + radius * np.sin(angle)], -1)
    motion = SPEED * np.stack([-np.sin(angle), np.cos(angle)], -1)
    return Truth(place[:, None], motion[:, None])


def _manoeuvring(draw: np.random.Generator) -> Truth:
    """As the radial one at first, then with the accelerations that the filters are made for: white,
    constant over each interval, of deviation sigma_w in x and in y, another path in each run.
    """
    start = _radial(draw)
    shakes = ACCELERATION * draw.standard_normal((SAMPLES - 1, RUNS, 2))
    gained = np.concatenate([np.zeros((1, RUNS, 2)), np.cumsum(shakes * INTERVAL, 0)])
    moved = gained[:-1] * INTERVAL + shakes * INTERVAL**2 / 2
    walked = np.concatenate([np.zeros((1, RUNS, 2)), np.cumsum(moved, 0)])
    return Truth(start.position + walked, start.velocity + gained)


PATHS: Mapping[str, Callable[[np.random.Generator], Truth]] = {
    "radial": _radial,
    "crossing": _crossing,
    "turning": _turning,
    "manoeuvring": _manoeuvring,
}


@dataclass(frozen=True)
class Seen:
    """A path and what the radar measured of it in each run, (samples, runs)."""

    truth: Truth
    measured: Measured

    @property
    def range(self) -> Reals:
        """m, of each sample: its root mean square over the runs."""
        found: Reals = np.sqrt(np.mean(np.sum(self.truth.position**2, -1), 1))
        return found


def seen(path: str) -> Seen:
    """Range and bearing with normal noise, independent from sample to sample and run to run."""
    draw = np.random.default_rng([SEED, list(PATHS).index(path)])
    truth = PATHS[path](draw)
    noise = draw.standard_normal((2, SAMPLES, RUNS))
    x, y = truth.position[..., 0], truth.position[..., 1]
    far = np.hypot(x, y) + RANGE_DEVIATION * noise[0]
    bearing = np.arctan2(x, y) + BEARING_DEVIATION * noise[1]
    return Seen(truth, converted(polar(far, bearing), CONVERSION))


def polar(far: Reals, bearing: Reals) -> Polar:
    """With the source's deviations."""
    deviations = (np.full_like(far, x) for x in (RANGE_DEVIATION, BEARING_DEVIATION))
    return Polar(far, bearing, *deviations)


def nominal_points() -> dict[str, Point]:
    """The gains of each nominal point, arrays (1, 2)."""
    point = exact_point(diagonal_index(np.array([*NOMINAL.values()])))
    return {name: point.part([i]) for i, name in enumerate(NOMINAL)}


def diagonal_index(far: Reals) -> Reals:
    """(n, 2): of x and y at these ranges and a bearing of 45 degrees."""
    given = diagonal(far, RANGE_DEVIATION, BEARING_DEVIATION)
    return index_of(given, ACCELERATION, INTERVAL, CONVERSION)


def _times() -> Reals:
    return INTERVAL * np.arange(float(SAMPLES))
