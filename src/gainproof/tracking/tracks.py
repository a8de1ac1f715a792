"""Arrays of tracks: one entry a track in every array."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gainproof.tracking.arrays import Bools, Ints, Reals
from gainproof.tracking.gains import Point
from gainproof.tracking.motion import Estimate
from gainproof.tracking.rows import Rows


@dataclass(frozen=True)
class Tracks(Rows):
    """number: of each track, from 0, in the order of the first detections. time: of the last
    update, s. hits: scans with a detection; age: scans since the first, that one included; missed:
    scans without a detection, in a row, until now. estimate: after the last update. point: that of
    the last update, from which the recursive one starts.
    """

    number: Ints
    confirmed: Bools
    time: Reals
    hits: Ints
    age: Ints
    missed: Ints
    estimate: Estimate
    point: Point

    def __len__(self) -> int:
        return len(self.number)


def no_tracks() -> Tracks:
    """None yet."""
    whole, real = np.zeros(0, np.int64), np.zeros(0)
    pair = np.zeros((0, 2))
    return Tracks(
        whole,
        np.zeros(0, np.bool_),
        real,
        whole,
        whole,
        whole,
        Estimate(np.zeros((0, 4)), np.zeros((0, 4, 4))),
        Point(pair, pair, pair),
    )
