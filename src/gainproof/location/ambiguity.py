"""Other places that explain the same observations: found by iterating from elsewhere, and named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.accuracy import cost_without_bias
from gainproof.location.gauss_newton import CONVERGED, Iterated, rounding
from gainproof.location.observability import observability
from gainproof.location.problem import Problem, linearised
from gainproof.location.stations import Stations

AS_GOOD = 9.0
"""A cost this much larger is three deviations of one number: the place is still told."""
SAME = 1e-3
"""Places closer than this, in deviations, are one."""
TIE = 1e-6
"""Costs closer than this are equal: what sets the places apart has to come from elsewhere."""
MOST_OTHERS = 3
LEVEL = 1e-6


@dataclass(frozen=True, eq=False)
class Candidate:
    """A place where the iteration settled: its number among the starts, unknowns (k,), cost; the
    stations whose ranges are clean there, if others than at the place chosen.
    """

    number: int
    unknowns: Reals
    cost: float
    clean: tuple[str, ...] = ()


def candidates(asked: Problem, iterated: Iterated) -> list[Candidate]:
    """The places where it settled and the rank is full, each once and by the first start that comes
    to it, least cost first.
    """
    kept: list[Candidate] = []
    same = max(SAME, 100 * float(rounding(asked, asked.used.values[None, :])[0]))
    for number in np.flatnonzero(iterated.ended == CONVERGED).tolist():
        x = iterated.unknowns[number]
        if any(apart(asked, each.unknowns, x) <= same for each in kept):
            continue
        if observability(asked, x).rank == asked.unknowns:
            kept.append(Candidate(number, x, float(iterated.cost[number])))
    return sorted(kept, key=lambda each: each.cost)


def chosen(asked: Problem, found: Sequence[Candidate], near: Reals | None) -> Candidate:
    """Of the places whose cost is least: the closest to `near`, else the one whose ranges need the
    least bias, else the first, but of mirror images that on the side of larger z (y, in a plane).
    """
    tied = _tied(found, [each.cost for each in found])
    d = asked.stations.dimension
    if near is not None:
        return min(tied, key=lambda each: float(np.linalg.norm(each.unknowns[:d] - near)))
    if asked.columns.shape[1]:
        tied = _tied(tied, [cost_without_bias(asked, each.unknowns) for each in tied])
    first = min(tied, key=lambda each: each.number)
    images = [each for each in tied if mirror_words(asked, first.unknowns, each.unknowns)]
    normal = _normal(asked.stations)
    return max([first, *images], key=lambda each: float(normal @ each.unknowns[:d]))


def _tied(found: Sequence[Candidate], costs: Sequence[float]) -> list[Candidate]:
    least = min(costs)
    return [
        each for each, cost in zip(found, costs, strict=True) if cost <= least + TIE * (1 + least)
    ]


def apart(asked: Problem, first: Reals, second: Reals) -> float:
    """How far two places are apart, in deviations at the first; 0 within rounding."""
    linear = linearised(asked, first[None, :], asked.used.values[None, :])
    change = second - first
    d = asked.stations.dimension
    size = np.abs(first - np.concatenate([asked.stations.centre, np.zeros(len(first) - d)])).max()
    if np.abs(change).max() <= 1e-12 * (size + asked.stations.spread):
        return 0.0
    return float(np.linalg.norm(linear.jacobian[0] @ (linear.scale[0] * change)))


def mirrored(asked: Problem, unknowns: Reals) -> Reals:
    """The target (k,) in the line (of the plane, d = 2) or plane (d = 3) that fits the stations
    best, its velocity against their mean velocity too.
    """
    given = asked.stations
    normal = _normal(given)
    d = given.dimension
    place = unknowns[:d] - 2 * normal * (normal @ (unknowns[:d] - given.centre))
    if not asked.velocity:
        return np.asarray(place)
    mean = given.velocities.mean(axis=0)
    motion = unknowns[d:] - 2 * normal * (normal @ (unknowns[d:] - mean))
    return np.concatenate([place, motion])


def mirror_words(asked: Problem, unknowns: Reals, other: Reals) -> str:
    """ "mirror image in the line of the stations" and so on, where `other` is it; else ""."""
    given = asked.stations
    image = mirrored(asked, unknowns)
    d = given.dimension
    off = float(np.linalg.norm(image[:d] - other[:d]))
    across = 2 * abs(float(_normal(given) @ (unknowns[:d] - given.centre)))
    if across == 0 or off > 0.05 * across:
        return ""
    exact = off <= 1e-6 * across
    what = "line" if d == 2 else "plane"
    return (
        f"the mirror image in the {what} of the stations"
        if exact
        else (f"close to the mirror image in the {what} that fits the stations best")
    )


def _normal(given: Stations) -> Reals:
    axes = np.linalg.svd(given.positions - given.centre, full_matrices=True)[2]
    # larger z first; where it runs level, larger y, then larger x
    first = int(np.flatnonzero(np.abs(axes[-1]) > LEVEL)[-1])
    return np.asarray(axes[-1] * np.sign(axes[-1][first]))
