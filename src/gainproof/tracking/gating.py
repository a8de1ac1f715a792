"""Block 105: which detections lie so near a prediction that they may be its target's."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gainproof.tracking.arrays import Ints, Reals
from gainproof.tracking.measured import Measured
from gainproof.tracking.motion import POSITION, Estimate, rest
from gainproof.tracking.rows import Rows

MOST_PAIRS = 2_000_000
"""In the bands of x of all gates of a scan: a third of a gigabyte."""


class TooManyPairsError(ValueError):
    """More candidates in a scan than there is memory for."""


@dataclass(frozen=True)
class Pairs(Rows):
    """Tracks and detections that may belong together, by their places, and how far apart they are:
    the squared distance over the innovation's covariance.
    """

    track: Ints
    detection: Ints
    squared: Reals


def threshold(probability: float) -> float:
    """The squared distance within which a track's own detection lies with this probability:
    chi-square of two degrees of freedom.
    """
    return -2 * math.log1p(-probability)


def gated(before: Estimate, seen: Measured, limit: float) -> Pairs:
    """All pairs of predicted tracks and detections within the limit, in the order of the tracks.

    The distance is never below that of x alone over its variance: a band in x finds the candidates.
    Raises TooManyPairsError.
    """
    order = np.argsort(seen.position[:, 0], kind="stable")
    x = seen.position[order, 0]
    widest = seen.covariance[:, 0, 0].max(initial=0.0)
    reach = np.sqrt(limit * (before.covariance[:, 0, 0] + widest)) * (1 + 1e-12)
    first = np.searchsorted(x, before.state[:, 0] - reach, "left")
    count = np.searchsorted(x, before.state[:, 0] + reach, "right") - first
    if count.sum() > MOST_PAIRS:
        raise TooManyPairsError(
            f"{count.sum()} pairs of tracks and detections in one scan, at most {MOST_PAIRS} are "
            "taken; wanted: fewer detections, or a smaller gate or speed"
        )
    track = np.repeat(np.arange(len(first)), count)
    place = np.arange(track.size) - np.repeat(np.cumsum(count) - count - first, count)
    detection = order[place]
    difference = seen.position[detection] - before.state[track][:, POSITION]
    s = before.covariance[:, POSITION, POSITION][track] + seen.covariance[detection]
    a, b, d = s[:, 0, 0], s[:, 0, 1], s[:, 1, 1]
    u, v = difference.T
    # along x, then what is left of y: a sum of squares
    squared = u * u / a + (v - b / a * u) ** 2 / rest(a, b, d)
    near = squared <= limit
    return Pairs(track[near], detection[near], squared[near])
