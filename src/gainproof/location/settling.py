"""From starts to places: iterated, mirrored, iterated again, and the best of them chosen."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.ambiguity import (
    AS_GOOD,
    MOST_OTHERS,
    Candidate,
    candidates,
    chosen,
    mirrored,
)
from gainproof.location.failure import no_estimate
from gainproof.location.gauss_newton import Iterated, iterate
from gainproof.location.levenberg_marquardt import damped
from gainproof.location.newton import newton
from gainproof.location.problem import Problem
from gainproof.location.starts import with_velocity
from gainproof.location.stations import Observations
from gainproof.location.unsettled import Unsettled, unsettled


@dataclass(frozen=True, eq=False)
class Settled:
    """What was asked, all iterations, the place chosen, those that explain the observations as
    well, and the starts that settled nowhere with as good a cost.
    """

    asked: Problem
    iterated: Iterated
    best: Candidate
    others: tuple[Candidate, ...]
    unsettled: Unsettled | None = None

    def all_but(self, place: Candidate) -> tuple[Candidate, ...]:
        """The places other than this one."""
        return tuple(each for each in (self.best, *self.others) if each is not place)


def settle(asked: Problem, observed: Observations, begin: Reals, near: Reals | None) -> Settled:
    """From starts (N, k), and from the mirror images of the best. Raises LocationError."""
    first = _iterated(asked, begin)
    found = candidates(asked, first)
    if not found:
        raise no_estimate(asked, begin, first)
    image = mirrored(asked, chosen(asked, found, near).unknowns)[None, :]
    # the image as it is, and with the velocity that the range rates ask for there
    moved = with_velocity(asked, observed, image[:, : asked.stations.dimension])
    images = np.concatenate([image, moved])
    again = _iterated(asked, images)
    everything = Iterated(
        *(np.concatenate([getattr(first, name), getattr(again, name)]) for name in vars(first))
    )
    found = candidates(asked, everything)
    best = chosen(asked, found, near)
    others = [each for each in found if each is not best and each.cost <= best.cost + AS_GOOD]
    open_ends = unsettled(asked, everything, found, best)
    return Settled(asked, everything, best, tuple(others[:MOST_OTHERS]), open_ends)


def _iterated(asked: Problem, begin: Reals) -> Iterated:
    """By Gauss-Newton; else by damped steps, and near the least cost by Newton's."""
    plain = iterate(asked, begin, asked.used.values)
    return newton(asked, damped(asked, begin, plain))
