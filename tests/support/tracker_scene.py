"""Many targets on circles, missed detections and false alarms; what a tracker made of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gainproof.tracking import Followed, Scans, scans

Reals = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True)
class Scene:
    """Targets between ``inner`` and ``outer`` (m) at 80 to 250 m/s, turning with 0.2 to 0.8 m/s^2;
    false_alarms: on average in a scan.
    """

    targets: int = 300
    scans: int = 200
    interval: float = 5.0
    detected: float = 0.95
    false_alarms: float = 30.0
    range_deviation: float = 50.0
    bearing_deviation: float = float(np.deg2rad(1.0))
    inner: float = 20e3
    outer: float = 110e3
    seed: int = 1


@dataclass(frozen=True)
class Drawn:
    """The detections, and of each, in the order of the scans, its target or -1."""

    scans: Scans
    target: Ints


def drawn(scene: Scene) -> Drawn:
    draw = np.random.default_rng(scene.seed)
    n = scene.targets
    far = np.sqrt(draw.uniform(scene.inner**2, scene.outer**2, n))
    bearing = draw.uniform(0, 2 * np.pi, n)
    speed, pull = draw.uniform(80, 250, n), draw.uniform(0.2, 0.8, n)
    radius = np.maximum(speed**2 / pull, 5e3)
    phase, rate = draw.uniform(0, 2 * np.pi, n), speed / radius * draw.choice([-1, 1], n)
    first = np.stack([far * np.sin(bearing), far * np.cos(bearing)], -1)
    centre = first - radius[:, None] * np.stack([np.cos(phase), np.sin(phase)], -1)
    rows = []
    for k in range(scene.scans):
        time = k * scene.interval
        angle = phase + rate * time
        place = centre + radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], -1)
        seen = np.flatnonzero(draw.random(n) < scene.detected)
        x, y = place[seen].T
        noise = draw.standard_normal((2, seen.size))
        alarms = draw.poisson(scene.false_alarms)
        rows.append(
            np.stack(
                [
                    np.full(seen.size + alarms, time),
                    np.append(
                        np.hypot(x, y) + scene.range_deviation * noise[0],
                        scene.outer * np.sqrt(draw.uniform(0.01, 1, alarms)),
                    ),
                    np.append(
                        np.arctan2(x, y) + scene.bearing_deviation * noise[1],
                        draw.uniform(-np.pi, np.pi, alarms),
                    ),
                    np.append(seen, np.full(alarms, -1)),
                ],
                -1,
            )
        )
    table = np.concatenate(rows)
    time_of, far_of, bearing_of, _ = table.T
    deviations = scene.range_deviation, scene.bearing_deviation
    given = scans(time_of, far_of, bearing_of, *deviations)
    return Drawn(given, table[given.row, 3].astype(np.int64))


@dataclass(frozen=True)
class Judged:
    """tracks: how many; kept: targets whose detections lie in one track alone; swaps: how often a
    track goes from one target to another; false_alarms: false alarms in tracks; lost: the share of
    the targets' detections that no track took.
    """

    tracks: int
    kept: int
    swaps: int
    false_alarms: int
    lost: float


def judged(given: Drawn, found: Followed, targets: int) -> Judged:
    real = given.target >= 0
    in_track = found.track >= 0
    swaps = 0
    for track in found.tracks.tolist():
        own = given.target[real & (found.track == track)]
        swaps += int(np.count_nonzero(np.diff(own)))
    kept = 0
    for target in range(targets):
        own = found.track[(given.target == target) & in_track]
        kept += np.unique(own).size == 1
    return Judged(
        len(found.tracks),
        int(kept),
        swaps,
        int(np.count_nonzero(in_track & ~real)),
        float(np.mean(~in_track[real])),
    )
