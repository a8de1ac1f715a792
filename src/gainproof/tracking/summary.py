"""What there is to tell of each track."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gainproof.tracking.arrays import Reals
from gainproof.tracking.scans import Scans
from gainproof.tracking.tracker import Followed


@dataclass(frozen=True)
class Course:
    """One track: its number, from 1; times of the first and the last detection, s; how many
    detections, and scans between them without one; state (x, vx, y, vy) and its deviation after
    the last detection, m and m/s.
    """

    number: int
    first: float
    last: float
    detections: int
    missed: int
    state: Reals
    deviation: Reals

    @property
    def speed(self) -> float:
        """m/s."""
        return float(np.hypot(self.state[1], self.state[3]))

    @property
    def course(self) -> float:
        """Where it goes, degrees from north, clockwise."""
        return float(np.rad2deg(np.arctan2(self.state[1], self.state[3])) % 360)


def courses(scans: Scans, found: Followed) -> list[Course]:
    """All tracks in the order of their numbers."""
    scan = np.repeat(np.arange(len(scans.times)), np.diff(scans.first))
    order = np.argsort(found.track, kind="stable")
    order = order[found.track[order] >= 0]
    starts = np.searchsorted(found.track[order], np.append(found.tracks, len(found.tracks)))
    told = []
    for number in found.tracks.tolist():
        own = order[starts[number] : starts[number + 1]]
        first, last = int(scan[own[0]]), int(scan[own[-1]])
        told.append(
            Course(
                number + 1,
                float(scans.times[first]),
                float(scans.times[last]),
                len(own),
                last - first + 1 - len(own),
                found.state[own[-1]],
                found.deviation[own[-1]],
            )
        )
    return told
