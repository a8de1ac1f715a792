"""Where the iteration begins, without iteration.

With ranges: differences of squared ranges are linear in the position within the stations' line or
plane; what is left of the squared ranges is its square distance from there, on both sides. With
range rates alone: directions times distances around the stations. The velocity of a start is the
least-squares solution of its range rates, which are linear in it.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.measurement import seen
from gainproof.location.problem import Problem, residual
from gainproof.location.stations import Observations, Stations

FLAT = (1e-6, 0.2)
"""A direction in which the stations reach less than this share of the farthest is left to a root;
both are tried, as heights of stations that are nearly level lose the digits of a linear solution.
"""
NO_LENGTH = 1e-6
MOST_SUBSETS = 16
TURNS = 720
"""Places on the circle that stations nearly on a line leave open in space: where they move, or are
not quite on it, the rest of the observations tells them apart; the best are begun from.
"""
DISTANCES = np.geomspace(0.05, 30.0, 14)
"""Over the stations' spread."""
KEPT = 8
"""Places of the grid from which it is iterated."""


def direct(
    given: Stations,
    ranges: Reals,
    where: NDArray[np.intp],
    flat: float = FLAT[0],
    turns: int = 0,
) -> Reals:
    """Positions (1 or 2, d) from ranges of the stations with these numbers, on each side if two;
    in space, where stations on a line leave a circle, on so many places of it.
    """
    places = given.positions[where]
    d = given.dimension
    centre = places.mean(axis=0)
    apart = places - centre
    axes = np.linalg.svd(apart, full_matrices=True)[2]
    along = apart @ axes.T
    sizes = np.sqrt(np.square(along).sum(axis=0))
    inside = sizes > flat * max(float(sizes.max()), 1e-300)
    squares = np.square(ranges)
    offset = np.zeros(d)
    if inside.any():
        # r_i^2 = |s_i|^2 - 2 s_i.p + |p|^2, less the mean over the stations
        right = np.square(apart).sum(axis=1) - squares
        right -= right.mean()
        offset[inside] = np.linalg.lstsq(2 * along[:, inside], right, rcond=None)[0]
    if inside.all():
        return np.asarray((centre + offset @ axes)[None, :])
    height = np.sqrt(max(float((squares - np.square(along - offset).sum(axis=1)).mean()), 0.0))
    normal = np.zeros(d)
    normal[int(np.flatnonzero(~inside)[0])] = 1.0
    if (normal @ axes)[np.flatnonzero(np.abs(normal @ axes) > NO_LENGTH)[-1]] < 0:
        normal = -normal  # the side of larger z, in a plane of larger y, comes first
    if turns and height > 0 and d == 3 and inside.sum() == 1:
        first, second = (
            normal @ axes,
            np.cross(axes[int(np.flatnonzero(inside)[0])], normal @ axes),
        )
        angle = 2 * np.pi * np.arange(turns) / turns
        circle = np.outer(np.cos(angle), first) + np.outer(np.sin(angle), second)
        return np.asarray(centre + offset @ axes + height * circle)
    sides = (1.0, -1.0) if height > 0 else (0.0,)
    return np.stack([centre + (offset + side * height * normal) @ axes for side in sides])


def around(given: Stations) -> Reals:
    """Positions on circles or spheres around the stations' centre."""
    if given.dimension == 2:
        angle = 2 * np.pi * (np.arange(48) + 0.25) / 48
        directions = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    else:
        i = np.arange(150) + 0.5
        height, turn = 1 - 2 * i / 150, np.pi * (1 + 5**0.5) * i
        ring = np.sqrt(1 - height**2)
        directions = np.stack([ring * np.cos(turn), ring * np.sin(turn), height], axis=1)
    reach = DISTANCES * (given.spread or 1.0)
    shells = directions[None] * reach[:, None, None]
    return np.asarray(given.centre + shells.reshape(-1, given.dimension))


def starts(asked: Problem, observed: Observations, near: Reals | None = None) -> Reals:
    """Starts (N, k) of position and velocity, the most likely first.

    observed: all observations, as ranges may say where to begin even where the method leaves them
    out. near (d,): a place to begin from besides.
    """
    given = asked.stations
    rows = ~observed.is_rate
    places = [] if near is None else [near[None, :]]
    ranges, where = observed.values[rows], observed.station[rows]
    if len(ranges):
        first = direct(given, ranges, where)
        circle = direct(given, ranges, where, FLAT[1], TURNS)
        if len(circle) > 2:
            circle = circle[_best(asked, with_velocity(asked, observed, circle))]
        places += [first, circle]
        if len(first) == 1:
            places += [_beside(given, first[0])]
        size = given.dimension + 1
        if len(ranges) > size:
            subsets = itertools.combinations(range(len(ranges)), size)
            places += [
                direct(given, ranges[list(s)], where[list(s)])
                for s in itertools.islice(subsets, MOST_SUBSETS)
            ]
    if asked.velocity and (asked.biases or not asked.method.uses_ranges):
        grid = with_velocity(asked, observed, around(given))
        places += [grid[_best(asked, grid), : given.dimension]]
    if not places:
        places = [around(given)]
    return with_velocity(asked, observed, np.concatenate(places))


def with_velocity(asked: Problem, observed: Observations, position: Reals) -> Reals:
    """Each position with the velocity that its range rates ask for, by least squares."""
    if not asked.velocity:
        return position
    given = asked.stations
    rate = observed.is_rate
    where = observed.station[rate]
    found = seen(given, position, np.zeros_like(position))
    unit = found.unit[:, where]
    # u.(v - station velocity) = observed
    right = observed.values[rate] - found.rate[:, where]
    fine = np.isfinite(unit).all(axis=(1, 2))
    velocity = np.zeros_like(position)
    inverse = np.linalg.pinv(unit[fine], rcond=1e-9)
    velocity[fine] = np.einsum("ndm,nm->nd", inverse, right[fine])
    return np.concatenate([position, velocity], axis=1)


def _beside(given: Stations, position: Reals) -> Reals:
    """A little off a start on the stations' line or plane, where derivatives across it vanish."""
    axes = np.linalg.svd(given.positions - given.centre, full_matrices=True)[2]
    reach = 0.03 * max(given.spread, float(np.linalg.norm(position - given.centre)), 1e-300)
    return np.stack([position + side * reach * axes[-1] for side in (1.0, -1.0)])


def _best(asked: Problem, grid: Reals) -> list[int]:
    """Places of least cost, no two of them close together."""
    observed = np.broadcast_to(asked.used.values, (len(grid), len(asked.used.values)))
    with np.errstate(all="ignore"):
        cost = np.square(residual(asked, grid, observed)).sum(axis=1)
    order = np.argsort(np.where(np.isfinite(cost), cost, np.inf), kind="stable")
    d = asked.stations.dimension
    kept: list[int] = []
    for i in order.tolist():
        apart = [np.linalg.norm(grid[i, :d] - grid[j, :d]) for j in kept]
        reach = 0.3 * np.linalg.norm(grid[i, :d] - asked.stations.centre)
        if all(distance > reach for distance in apart):
            kept.append(i)
        if len(kept) == KEPT:
            break
    return kept
