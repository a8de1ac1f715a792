"""Why there is no estimate: the error that says it."""

from __future__ import annotations

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.errors import (
    Direction,
    DivergedError,
    LocationError,
    OnStationError,
    UnobservableError,
)
from gainproof.location.gauss_newton import DEFICIENT, ON_STATION, Iterated
from gainproof.location.geometry_words import listed, motion_words, shape_words
from gainproof.location.measurement import seen
from gainproof.location.observability import (
    Observability,
    observability,
    weakest,
)
from gainproof.location.problem import Problem
from gainproof.location.report import report

ON_IT = 1e-3
"""Share of the position's 1-sigma: a target this close to a station is on it."""
CLOSE = 3.0
"""Deviations of a range within which an iteration that fails next to a station is told so."""


def no_estimate(asked: Problem, begin: Reals, iterated: Iterated) -> LocationError:
    """The error for an iteration that settled from none of its starts."""
    lost = np.flatnonzero(iterated.ended == DEFICIENT)
    if lost.size:
        # the first start is the most likely one
        x = iterated.unknowns[lost[0]]
        return UnobservableError(*_unobservable(asked, x, observability(asked, x)))
    best = int(np.argmin(iterated.cost))
    x = iterated.unknowns[best]
    found = seen(asked.stations, *asked.split(x[None, :]))
    nearest = int(np.argmin(found.distance[0]))
    distance = float(found.distance[0, nearest])
    name = asked.stations.names[nearest]
    reach = CLOSE * float(asked.used.deviations[~asked.used.is_rate].max(initial=0.0))
    if iterated.ended[best] == ON_STATION or distance <= reach:
        return _on_station(asked, name, distance)
    settled = observability(asked, x)
    if settled.rank < asked.unknowns:
        return UnobservableError(*_unobservable(asked, x, settled))
    told = report(asked, iterated, best, settled.ratio)
    (direction,), deviation = weakest(asked, x)
    return DivergedError(
        f"{asked.method.name} did not converge from any of {len(begin)} starts: {told.ended}; "
        f"the best came to {place_words(asked, x)} after {told.iterations} iterations with cost "
        f"{told.cost:.4g}, last step {told.step:.2g} deviations; known worst there is "
        f"{direction.words} (1-sigma {deviation:.3g} m){_why(asked, x)}",
        told,
    )


def not_observed(asked: Problem, unknowns: Reals) -> None:
    """UnobservableError where the accuracy found is worse than the distance to every station: the
    linear model that says so holds no more, and the rank is full by its noise alone. OnStationError
    where the target is as good as on one.
    """
    place, velocity = asked.split(unknowns[None, :])
    distance = seen(asked.stations, place, velocity).distance[0]
    nearest = int(np.argmin(distance))
    farthest = float(distance.max())
    directions, deviation = weakest(asked, unknowns, farthest)
    if deviation < farthest:
        if distance[nearest] <= ON_IT * deviation:
            raise _on_station(asked, asked.stations.names[nearest], float(distance[nearest]))
        return
    raise UnobservableError(
        f"{asked.method.name} cannot observe {listed([each.words for each in directions])} within "
        f"the noise: the 1-sigma would be {deviation:.3g} m, all stations are within "
        f"{farthest:.3g} m of {place_words(asked, unknowns)}{_why(asked, unknowns)}",
        directions,
    )


def _on_station(asked: Problem, name: str, distance: float) -> OnStationError:
    return OnStationError(
        f"{asked.method.name}: the target comes to lie on station {name} (distance "
        f"{distance:.3g} m), where its range has no derivative",
        name,
    )


def _unobservable(
    asked: Problem, x: Reals, found: Observability
) -> tuple[str, tuple[Direction, ...]]:
    words = listed([each.words for each in found.directions])
    message = (
        f"{asked.method.name} cannot observe {words}: the scaled rank is {found.rank} of "
        f"{found.unknowns} at {place_words(asked, x)}{_why(asked, x)}"
    )
    return message, found.directions


def _why(asked: Problem, x: Reals) -> str:
    place = asked.split(x[None, :])[0][0]
    reasons = [shape_words(asked.stations, place), motion_words(asked, x)]
    return "".join(f"; {reason}" for reason in reasons if reason)


def place_words(asked: Problem, unknowns: Reals) -> str:
    """(x, y) m, to a millimetre."""
    place = asked.split(unknowns[None, :])[0][0] + asked.stations.origin
    return f"({', '.join(f'{value:.10g}' for value in (np.round(place, 3) + 0.0).tolist())}) m"
