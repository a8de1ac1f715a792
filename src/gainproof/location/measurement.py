"""Ranges and range rates of targets from stations, with their derivatives."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.stations import Stations


class Seen(NamedTuple):
    """Of N targets from n stations: distance and rate (N, n); unit, the derivative of distance by
    position and of rate by velocity, and turn, that of rate by position, (N, n, d); speed (N, n),
    how fast target and station move against each other.
    """

    distance: Reals
    rate: Reals
    unit: Reals
    turn: Reals
    speed: Reals


def seen(given: Stations, position: Reals, velocity: Reals) -> Seen:
    """position and velocity (N, d). Where a target is on a station its numbers are no numbers."""
    apart = position[:, None, :] - given.positions
    moving = velocity[:, None, :] - given.velocities
    with np.errstate(all="ignore"):
        distance = np.sqrt(np.square(apart).sum(axis=2))
        unit = apart / distance[..., None]
        rate = (unit * moving).sum(axis=2)
        turn = (moving - rate[..., None] * unit) / distance[..., None]
        speed = np.sqrt(np.square(moving).sum(axis=2))
    return Seen(distance, rate, unit, turn, speed)
