"""Arrays of tracks: one entry a track in every array."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from gainproof.tracking.arrays import Bools, Ints, Reals
from gainproof.tracking.gains import Point
from gainproof.tracking.motion import Estimate


@dataclass(frozen=True)
class Tracks:
    """number: of each track, from 0, in the order of the first detections. time: of the last
    update, s. hits: scans with a detection; age: scans since the first, that one included; missed:
    scans without a detection, in a row, until now. state (n, 4) and covariance (n, 4, 4) after the
    last update; index, alpha and beta (n, 2): the point that the recursive update starts from.
    """

    number: Ints
    confirmed: Bools
    time: Reals
    hits: Ints
    age: Ints
    missed: Ints
    state: Reals
    covariance: Reals
    index: Reals
    alpha: Reals
    beta: Reals

    def __len__(self) -> int:
        return len(self.number)

    @property
    def estimate(self) -> Estimate:
        """After the last update."""
        return Estimate(self.state, self.covariance)

    @property
    def point(self) -> Point:
        """That of the last update."""
        return Point(self.index, self.alpha, self.beta)

    def part(self, rows: Any) -> Tracks:
        """Those that an index chooses."""
        return Tracks(**{each.name: getattr(self, each.name)[rows] for each in fields(self)})

    def with_more(self, more: Tracks) -> Tracks:
        """These, then those."""
        return Tracks(
            **{
                each.name: np.concatenate([getattr(self, each.name), getattr(more, each.name)])
                for each in fields(self)
            }
        )


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
        np.zeros((0, 4)),
        np.zeros((0, 4, 4)),
        pair,
        pair,
        pair,
    )
