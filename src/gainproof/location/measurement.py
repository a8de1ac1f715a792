"""Ranges and range rates of targets from stations, with derivatives, by the printed kernels."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.generated import range_doppler
from gainproof.location.stations import Stations

LEAST, MOST = 1e-19, 1e59
"""Within the domain of the kernels, with something to spare: distances and coordinates."""


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
    """position and velocity (N, d). Where a target is on a station, or beyond all numbers, what the
    two have between them is NaN.
    """
    with np.errstate(all="ignore"):
        near = np.abs(position[:, None, :] - given.positions).max(axis=2)
        far = np.maximum(np.abs(position).max(axis=1), np.abs(velocity).max(axis=1))
    lost = ~((near >= LEAST) & (far <= MOST)[:, None])
    hit = bool(lost.any())
    place, motion = position[:, None, :], velocity[:, None, :]
    if hit:
        # one away along every axis: a stand-in, whose numbers are taken out again
        place = np.where(lost[..., None], given.positions + 1.0, place)
        motion = np.where(lost[..., None], given.velocities, motion)
    target, moving = np.moveaxis(place, 2, 0), np.moveaxis(motion, 2, 0)
    kernel = (
        range_doppler.range_doppler
        if given.dimension == 3
        else range_doppler.range_doppler_in_plane
    )
    distance, rate, *slopes = kernel(*target, *moving, *given.positions.T, *given.velocities.T)
    d = given.dimension
    found = [
        np.asarray(distance),
        np.asarray(rate),
        np.stack(slopes[:d], axis=2),
        np.stack(slopes[d:], axis=2),
        np.asarray(np.sqrt(np.square(motion - given.velocities).sum(axis=2))),
    ]
    if hit:
        for each in found:
            each[lost] = np.nan
    return Seen(*found)
