"""Position and velocity from ranges and range rates: the front door of the estimators."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.accuracy import accuracy
from gainproof.location.ambiguity import (
    AS_GOOD,
    MOST_OTHERS,
    SAME,
    Candidate,
    apart,
    candidates,
    chosen,
    mirrored,
)
from gainproof.location.errors import LocationError
from gainproof.location.failure import no_estimate, not_observed
from gainproof.location.gauss_newton import Iterated, iterate
from gainproof.location.levenberg_marquardt import damped
from gainproof.location.methods import CHOSEN, Method, method_of, require_counts
from gainproof.location.newton import newton
from gainproof.location.observability import observability
from gainproof.location.problem import Problem, problem
from gainproof.location.report import report
from gainproof.location.result import Bias, Location, Place
from gainproof.location.selection import Selection, select, threshold
from gainproof.location.starts import starts, with_velocity
from gainproof.location.stations import Observations, Stations, bounded, from_the_first
from gainproof.location.unsettled import UNSETTLED, Unsettled, unsettled, unsettled_words
from gainproof.location.warning_words import few_clean, refuted, too_short, warnings

DEFAULT = "unknown-reduction"
FALSE_ALARM = 0.05
LEAST_DEVIATION, MOST_DEVIATION = 1e-50, 1e50
"""In any unit of length and time: with distances of the kernels' domain, costs stay finite."""


def locate(
    given: Stations,
    observed: Observations,
    method: str = DEFAULT,
    *,
    false_alarm: float = FALSE_ALARM,
    near: ArrayLike | None = None,
) -> Location:
    """The target by one of the methods of `methods.METHODS`.

    false_alarm: how often the test of unknown reduction may call a clean range biased. near (d,),
    m: a place to begin from besides the starts of `starts`; of places that explain the observations
    equally well the one closest to it is returned.

    LocationError: too few observations, directions that are not observed, a target on a station, an
    iteration that does not settle; each a class of its own in `errors`. ValueError: a covariance
    that is none, arguments out of range. BadInputError: a method there is not.
    """
    chosen = method_of(method)
    threshold(false_alarm)
    _require_deviations(observed)
    ranges = int((~observed.is_rate).sum())
    require_counts(chosen, given.dimension, ranges, int(observed.is_rate.sum()))
    here = from_the_first(given)
    close = None if near is None else _place(here, near)
    if chosen.bias == CHOSEN:
        return _reduced(here, observed, chosen, false_alarm, close)
    asked = problem(here, observed, chosen)
    return _told(_settle(asked, observed, starts(asked, observed, close), close))


def _require_deviations(observed: Observations) -> None:
    """ValueError where squares of white residuals would run out of numbers; what is not above 0 is
    named with the covariance.
    """
    variances = np.diag(observed.covariance)
    least, most = LEAST_DEVIATION**2, MOST_DEVIATION**2
    wrong = variances[(variances > 0) & ~((variances >= least) & (variances <= most))]
    if wrong.size:
        raise ValueError(
            f"deviations are between {LEAST_DEVIATION:g} and {MOST_DEVIATION:g}, got "
            f"the variance {float(wrong[0])!s}"
        )


def _reduced(
    given: Stations,
    observed: Observations,
    method: Method,
    false_alarm: float,
    near: Reals | None,
) -> Location:
    """Bias detection, the test (55), and the iteration again from there with fewer unknowns.

    Where bias detection leaves several places open, the test is made at each, and the one with the
    most clean ranges is followed; of equals the first. What is told besides explains the
    observations with as many clean ranges, not only with a free bias for each.
    """
    free = problem(given, observed, method_of("bias-detection"))
    first = _settle(free, observed, starts(free, observed, near), near)
    places = [first.best, *(first.others if near is None else ())]
    tests = [_selection(accuracy(free, each.unknowns)[1], false_alarm) for each in places]
    most = max(range(len(tests)), key=lambda i: (len(tests[i].clean), -i))
    biased = [given.names.index(each.station) for each in tests[most].decisions if not each.clean]
    asked = problem(given, observed, method, biased)
    begin = [places[most].unknowns]
    if first.unsettled is not None:
        # where bias detection came to no end, these biases alone may
        begin.append(first.iterated.unknowns[first.unsettled.number])
    reported = _settle(asked, observed, np.array(begin), near)
    if not reported.others:
        # where as many ranges are clean elsewhere, the choice among the places was none
        count = len(tests[most].clean)
        rivals = [
            _as_good(given, observed, method, reported, place, test)
            for i, (place, test) in enumerate(zip(places, tests, strict=True))
            if i != most and len(test.clean) == count
        ]
        reported = replace(reported, others=tuple(each for each in rivals if each is not None))
    found = _told(reported)
    begun = _told(replace(first, best=places[most], others=first.all_but(places[most])))
    if missed := refuted(found, begun):
        found = replace(found, warnings=(*missed, *_open(first), *found.warnings))
    few = few_clean(len(tests[most].clean), len(tests[most].decisions))
    return replace(found, selection=tests[most], first=begun, warnings=(*found.warnings, *few))


def _as_good(
    given: Stations,
    observed: Observations,
    method: Method,
    reported: _Settled,
    place: Candidate,
    test: Selection,
) -> Candidate | None:
    """Where the iteration from another place comes to with the ranges that are clean there, if that
    is another place and explains the observations as well: free biases explain what noise does not.
    """
    biased = [given.names.index(each.station) for each in test.decisions if not each.clean]
    asked = problem(given, observed, method, biased)
    try:
        best = _settle(asked, observed, place.unknowns[None, :], None).best
    except LocationError:
        return None
    near = apart(reported.asked, reported.best.unknowns, best.unknowns) <= SAME
    if near or best.cost > reported.best.cost + AS_GOOD:
        return None
    return replace(best, clean=() if biased == list(reported.asked.biases) else test.clean)


def _selection(biases: tuple[Bias, ...], false_alarm: float) -> Selection:
    return select(
        tuple(each.station for each in biases),
        tuple(each.value for each in biases),
        tuple(each.deviation for each in biases),
        false_alarm,
    )


def _told(settled: _Settled) -> Location:
    asked, best, others = settled.asked, settled.best, settled.others
    not_observed(asked, best.unknowns)
    covariance, biases = accuracy(asked, best.unknowns)
    rank = observability(asked, best.unknowns)
    return Location(
        asked.method.name,
        *_split(asked, best.unknowns),
        covariance,
        biases,
        None,
        report(asked, settled.iterated, best.number, rank.ratio),
        rank.rank,
        tuple(Place(*_split(asked, each.unknowns), each.cost) for each in others),
        (
            *_open(settled),
            *warnings(asked, best, others, covariance),
            *too_short(asked.method, biases),
        ),
    )


def _open(settled: _Settled) -> tuple[str, ...]:
    """The warning of starts that settled nowhere."""
    told = settled.unsettled
    if told is None:
        return ()
    words = unsettled_words(settled.asked, settled.iterated, told)
    return (
        (
            f"{UNSETTLED}: {settled.asked.method.name}: {words}; a place there may explain the "
            "observations as well"
        ),
    )


def _split(asked: Problem, unknowns: Reals) -> tuple[Reals, Reals | None]:
    place, velocity = asked.split(unknowns[None, :])
    return place[0] + asked.stations.origin, velocity[0] if asked.velocity else None


def _place(given: Stations, near: ArrayLike) -> Reals:
    place = bounded("near", near)
    if place.shape != (given.dimension,):
        raise ValueError(f"near must have shape {(given.dimension,)}, got {place.shape}")
    return place - given.origin


@dataclass(frozen=True, eq=False)
class _Settled:
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


def _settle(asked: Problem, observed: Observations, begin: Reals, near: Reals | None) -> _Settled:
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
    return _Settled(asked, everything, best, tuple(others[:MOST_OTHERS]), open_ends)


def _iterated(asked: Problem, begin: Reals) -> Iterated:
    """By Gauss-Newton; else by damped steps, and near the least cost by Newton's."""
    plain = iterate(asked, begin, asked.used.values)
    return newton(asked, damped(asked, begin, plain))
