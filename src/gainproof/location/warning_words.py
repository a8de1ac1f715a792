"""What an estimate has to be taken with, as sentences."""

from __future__ import annotations

import sys
from collections.abc import Sequence

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.ambiguity import Candidate, mirror_words
from gainproof.location.gauss_newton import rounding
from gainproof.location.geometry_words import listed
from gainproof.location.methods import CHOSEN, EACH, Method
from gainproof.location.observability import bending
from gainproof.location.problem import Problem
from gainproof.location.result import Bias, Location
from gainproof.location.selection import exceeded

AMBIGUOUS = "ambiguous"
UNLIKELY = 1e-3
"""How rarely noise alone may give such a cost before it is told."""
REFUTED = 1e-6
"""How rarely noise alone may give the cost with biases left out before their choice is refuted."""
NO_COST = 1e-12
DILUTED = 100.0
"""Deviation of a velocity over the largest of a range rate: beyond it the geometry is told."""
SHORT = 5.0
"""Deviations of a bias below 0 that are told: noise gives one in three million ranges."""
BENT = 0.5
"""Deviations that residuals may bend within one deviation of the estimate, untold."""


def warnings(
    asked: Problem, best: Candidate, others: Sequence[Candidate], covariance: Reals
) -> tuple[str, ...]:
    """Other places; a model that bends within its deviations; residuals too large or none."""
    found = [_other(asked, best, each) for each in others]
    d = asked.stations.dimension
    bent = bending(asked, best.unknowns)
    if bent > BENT + 4 * float(rounding(asked, asked.used.values[None, :])[0]):
        found.append(
            f"one deviation beside the estimate the residuals are {bent:.2g} deviations from where "
            "a linear model has them: the covariance says little there"
        )
    if asked.velocity:
        speed = float(np.sqrt(np.linalg.eigvalsh(covariance[d : 2 * d, d : 2 * d])[-1]))
        if speed > DILUTED * float(asked.used.deviations[asked.used.is_rate].max()):
            found.append(
                f"the 1-sigma of the velocity reaches {speed:.3g} m/s, far beyond that of a range "
                "rate: one direction of it is hardly observed"
            )
    freedom = len(asked.used.values) - asked.unknowns - asked.columns.shape[1]
    if freedom == 0:
        found.append("there are as many unknowns as observations: no residual is left to check by")
    elif exceeded(best.cost, freedom) < UNLIKELY:
        found.append(
            f"the residuals are larger than their noise: noise alone gives a cost beyond "
            f"{best.cost:.4g} in {_share(exceeded(best.cost, freedom))} of all cases; a bias that "
            f"is not in the model, or deviations that are too small. {_next(asked.method)}"
        )
    return tuple(found)


def _next(method: Method) -> str:
    """What may tell more where residuals are too large."""
    if method.bias == CHOSEN:
        return "The method bias-detection gives every range a bias of its own"
    if method.uses_ranges and method.bias != EACH:
        rates = "" if method.uses_rates else ", with range rates,"
        return f"The method unknown-reduction{rates} looks for such biases"
    return "No bias of a range explains it here: the range rates do not fit each other"


def too_short(method: Method, biases: Sequence[Bias]) -> tuple[str, ...]:
    """Where a range is shorter than multipath can make it."""
    if method.bias not in (EACH, CHOSEN):
        return ()
    found = [each for each in biases if each.value < -SHORT * each.deviation]
    if not found:
        return ()
    named = ", ".join(f"{each.station} by {_metres(-each.value)} m" for each in found)
    return (
        (
            f"ranges come out too short: {named}. Multipath makes ranges longer: a unit in the "
            "first line of a file, a clock or a station's place may be wrong"
        ),
    )


def refuted(found: Location, first: Location) -> tuple[str, ...]:
    """Where biases that a test left out are missed: noise alone hardly ever gives the cost without
    them, but well that of bias detection (first).
    """
    if not _beyond_noise(found) or _beyond_noise(first):
        return ()
    place = f"({_numbers(first.position, 1)}) m"
    if first.velocity is not None:
        place += f" with velocity ({_numbers(first.velocity, 3)}) m/s"
    return (
        (
            "refuted: the selection of clean ranges cannot be right, as noise gives a cost beyond "
            f"{found.convergence.cost:.4g} in less than one of a million cases. Take bias "
            f"detection instead, whose cost {_cost(first.convergence.cost)} noise explains: {place}"
        ),
    )


def _beyond_noise(found: Location) -> bool:
    freedom = found.convergence.degrees_of_freedom
    return freedom > 0 and exceeded(found.convergence.cost, freedom) < REFUTED


def few_clean(clean: int, ranges: int) -> tuple[str, ...]:
    """Where the test leaves less than half of the ranges clean."""
    if 2 * clean >= ranges:
        return ()
    told = f"only {clean} of {ranges} ranges are taken as clean: either multipath is everywhere, or"
    return (f"{told} the range rates led to a wrong place",)


def _other(asked: Problem, best: Candidate, other: Candidate) -> str:
    place, velocity = asked.split(other.unknowns[None, :])
    where = f"({_numbers(place[0] + asked.stations.origin, 1)}) m"
    if asked.velocity:
        where += f" with velocity ({_numbers(velocity[0], 3)}) m/s"
    mirror = mirror_words(asked, best.unknowns, other.unknowns)
    if other.clean:
        where += f", with {listed(other.clean)} taken as clean,"
    costs = f"cost {_cost(other.cost)} against {_cost(best.cost)}"
    if mirror:
        return f"{AMBIGUOUS}: {where}, {mirror}, explains the observations as well ({costs})"
    return f"{AMBIGUOUS}: {where} explains the observations as well ({costs})"


def _share(probability: float) -> str:
    """To one digit; one that is no normal number is below the least there is."""
    least = sys.float_info.min
    return f"{probability:.1g}" if probability >= least else f"less than {least:.1g}"


def _metres(value: float) -> str:
    return f"{value:.4g}" if value < 1e4 else f"{value:.0f}"


def _cost(cost: float) -> str:
    return "0" if cost < NO_COST else f"{cost:.3g}"


def _numbers(values: Reals, places: int) -> str:
    return ", ".join(f"{value + 0.0:.{places}f}" for value in np.round(values, places).tolist())
