"""Starts that did not settle and came to a cost as good as that of the place chosen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gainproof.location.ambiguity import AS_GOOD, Candidate, apart
from gainproof.location.errors import DivergedError
from gainproof.location.failure import place_words
from gainproof.location.gauss_newton import ON_STATION, Iterated
from gainproof.location.observability import observability
from gainproof.location.problem import Problem
from gainproof.location.report import report

UNSETTLED = "unsettled"
CLOSE_BY = 0.1
"""In deviations at a settled place, from which nothing is another place."""


@dataclass(frozen=True)
class Unsettled:
    """How many starts of how many; of the one with the least cost the number and the cost."""

    count: int
    of: int
    number: int
    cost: float


def unsettled(
    asked: Problem, iterated: Iterated, found: Sequence[Candidate], best: Candidate
) -> Unsettled | None:
    """The starts with a cost within 9 of the best or below it that came to none of the places
    found. DivergedError where one is cheaper than the best by more than 9: there is a place that
    explains the observations far better, and it was not found.
    """
    near = (iterated.cost < best.cost + AS_GOOD) & (iterated.ended != ON_STATION)
    left = [
        i
        for i in np.flatnonzero(near).tolist()
        if not any(
            iterated.cost[i] >= each.cost - CLOSE_BY
            and apart(asked, each.unknowns, iterated.unknowns[i]) <= CLOSE_BY
            for each in found
        )
    ]
    if not left:
        return None
    least = min(left, key=lambda i: float(iterated.cost[i]))
    told = Unsettled(len(left), len(iterated.cost), least, float(iterated.cost[least]))
    if told.cost < best.cost - AS_GOOD:
        x = iterated.unknowns[least]
        how = report(asked, iterated, least, observability(asked, x).ratio)
        raise DivergedError(
            f"{asked.method.name} did not converge: "
            f"{unsettled_words(asked, iterated, told)}; the best place that it settled at, "
            f"{place_words(asked, best.unknowns)}, has cost {best.cost:.4g}",
            how,
        )
    return told


def unsettled_words(asked: Problem, iterated: Iterated, told: Unsettled) -> str:
    """How many starts, how the cheapest ended, where and with which cost."""
    how = report(asked, iterated, told.number, 0.0)
    came = place_words(asked, iterated.unknowns[told.number])
    ended = how.ended.replace("converged", "converged where the rank is deficient")
    return (
        f"{told.count} of {told.of} starts did not settle; the best of them came to {came} with "
        f"cost {told.cost:.3g}: {ended}"
    )
