"""Example 1 of kosuge-doppler, (139)-(141), as numbers and as files.

The source has no observations. Those of the files are the true ones with noise that is written down
here in deviations, and multipath on the ranges of B3 and B4.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from gainproof.files import named_files
from gainproof.fixed_gain.arguments import Reals
from gainproof.location.measurement import seen
from gainproof.location.noise import diagonal
from gainproof.location.stations import Observations, Stations, observations, stations

POSITION = (10e3, 10e3)
VELOCITY = (200.0, 0.0)
STATIONS = ((0.0, 0.0), (10e3, 0.0), (0.0, 10e3), (20e3, 20e3))
RANGE_DEVIATION, RATE_DEVIATION = 10.0, 0.1
BIASES = (0.0, 0.0, 120.0, 90.0)
RANGE_NOISE = (0.42, -1.10, 0.35, 0.87)
RATE_NOISE = (-0.63, 0.18, 1.21, -0.37)
FILES = ("observations.csv", "stations.csv")


def example_stations() -> Stations:
    """(140)."""
    return stations(STATIONS)


def example_observations(
    biases: Sequence[float] = BIASES,
    range_noise: Sequence[float] = RANGE_NOISE,
    rate_noise: Sequence[float] = RATE_NOISE,
) -> Observations:
    """Of the target (139): biases in m, noise in deviations."""
    values = true_values() + np.array([*biases, *np.zeros(4)])
    values += deviations() * np.array([*range_noise, *rate_noise])
    return observations(example_stations(), values[:4], values[4:], diagonal(deviations()))


def true_values() -> Reals:
    """Four ranges and four range rates without noise, m and m/s."""
    found = seen(example_stations(), np.array([POSITION]), np.array([VELOCITY]))
    return np.concatenate([found.distance[0], found.rate[0]])


def deviations() -> Reals:
    """Of the eight observations."""
    return np.array([RANGE_DEVIATION] * 4 + [RATE_DEVIATION] * 4)


def write_example(folder: Path) -> list[Path]:
    """observations.csv and stations.csv in the folder, made as needed.

    Raises BadInputError, also where one of them exists.
    """
    observed = example_observations()
    rows = ["station,range [km],range_rate [m/s],sigma_range [m],sigma_range_rate [m/s]"]
    standing = ["station,x [km],y [km]"]
    given = example_stations()
    for i, name in enumerate(given.names):
        distance, rate = observed.values[i] / 1e3, observed.values[4 + i]
        rows.append(f"{name},{distance:.6f},{rate:.4f},{RANGE_DEVIATION:g},{RATE_DEVIATION:g}")
        x, y = given.positions[i] / 1e3
        standing.append(f"{name},{x:g},{y:g}")
    paths = [folder / name for name in FILES]
    named_files.require_new(paths)
    texts = [("\n".join(lines) + "\n").encode() for lines in (rows, standing)]
    named_files.write(dict(zip(paths, texts, strict=True)))
    return paths
