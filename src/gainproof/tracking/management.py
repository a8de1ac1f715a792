"""Block 103: tracks begin with a detection that no track took, are confirmed, and end."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gainproof.tracking.arrays import Bools, Ints
from gainproof.tracking.gains import Point
from gainproof.tracking.measured import Measured
from gainproof.tracking.motion import POSITION, Estimate
from gainproof.tracking.settings import Settings
from gainproof.tracking.tracks import Tracks


def rank(tracks: Tracks) -> Ints:
    """Who chooses a detection first: 0 confirmed tracks, 1 those with a velocity, 2 beginnings."""
    return np.where(tracks.confirmed, 0, np.where(tracks.hits > 1, 1, 2))


def counted(tracks: Tracks, detected: Bools) -> Tracks:
    """A scan later, with or without a detection."""
    return replace(
        tracks,
        hits=tracks.hits + detected,
        age=tracks.age + 1,
        missed=np.where(detected, 0, tracks.missed + 1),
    )


def judged(tracks: Tracks, settings: Settings) -> tuple[Tracks, Bools]:
    """Confirmed where the detections suffice, with which are kept: a confirmed track until it was
    missed too often in a row, another one as long as it can still be confirmed.
    """
    needed, scans = settings.confirm
    confirmed = tracks.confirmed | (tracks.hits >= needed)
    hopeful = scans - tracks.age + tracks.hits >= needed
    kept = np.where(confirmed, tracks.missed < settings.drop, hopeful)
    return replace(tracks, confirmed=confirmed), kept


def begun(seen: Measured, time: float, first: int, settings: Settings, limit: float) -> Tracks:
    """A beginning for each detection, numbered from ``first``.

    Its velocity is unknown: taken as 0 with a deviation that puts the fastest target at the border
    of the gate.
    """
    n = len(seen.position)
    state = np.zeros((n, 4))
    state[:, POSITION] = seen.position
    covariance = np.zeros((n, 4, 4))
    covariance[:, POSITION, POSITION] = seen.covariance
    covariance[:, (1, 3), (1, 3)] = settings.most_speed**2 / limit
    whole = np.ones(n, np.int64)
    unknown = np.full((n, 2), np.nan)
    return Tracks(
        first + np.arange(n),
        np.zeros(n, np.bool_),
        np.full(n, time),
        whole,
        whole,
        0 * whole,
        Estimate(state, covariance),
        Point(unknown, unknown, unknown),
    )
