"""Example 1 of kosuge-doppler over many draws of noise: errors, and how multipath is found.

Every run is iterated as a single location is, from the true state, which is the example's start;
all runs of one set of biases at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.accuracy import accuracy, all_accuracies
from gainproof.location.example import (
    POSITION,
    VELOCITY,
    deviations,
    example_observations,
    example_stations,
    true_values,
)
from gainproof.location.gauss_newton import CONVERGED, iterate
from gainproof.location.methods import method_of
from gainproof.location.problem import Problem, problem
from gainproof.location.selection import detection, threshold

NAMES = ("x", "y", "vx", "vy")
STATE = np.array([*POSITION, *VELOCITY])


@dataclass(frozen=True, eq=False)
class Errors:
    """Of one way to estimate: RMS errors of x, y, vx, vy in m and m/s, those that its covariance
    promises where it knows all biases (else NaN), and the share of runs that converged.
    """

    name: str
    rms: Reals
    promised: Reals
    converged: float


@dataclass(frozen=True, eq=False)
class Outcome:
    """Of one set of biases: the errors of each way; how often each range was called biased, and how
    often the noncentral chi-square says; the mean number of ranges taken as clean.
    """

    biases: tuple[float, ...]
    runs: int
    errors: tuple[Errors, ...]
    called: Reals
    theory: Reals
    clean: float


@dataclass(frozen=True)
class Compared:
    """Something counted or measured beside what theory says, and the deviation of its sampling."""

    what: str
    found: float
    theory: float
    deviation: float

    @property
    def off(self) -> float:
        """In deviations."""
        return abs(self.found - self.theory) / self.deviation


def simulate(biases: Sequence[float], runs: int, seed: int, false_alarm: float) -> Outcome:
    """0 (bias detection), 2 (B1 and B2) and 4 clean ranges (no bias), and what the test chooses."""
    given = tuple(float(bias) for bias in biases)
    observed = drawn(given, runs, seed)
    every = _asked(range(4))
    states, converged = _iterated(every, observed)
    found = [_errors("0 clean ranges", range(4), given, states, converged)]
    for name, biased in (("2 clean ranges", (2, 3)), ("4 clean ranges", ())):
        found.append(_errors(name, biased, given, *_iterated(_asked(biased), observed)))
    called = _called(every, states, observed, false_alarm)
    estimates, settled = adaptive(observed, called, states)
    nothing = np.full(len(STATE), np.nan)
    found.append(Errors("adaptive", _rms(estimates), nothing, float(settled.mean())))
    theory = [detection(b, s, false_alarm) for b, s in zip(given, bias_deviations(), strict=True)]
    clean = float((~called).sum(axis=1).mean())
    return Outcome(given, runs, tuple(found), called.mean(axis=0), np.array(theory), clean)


def drawn(biases: Sequence[float], runs: int, seed: int) -> Reals:
    """Observations (runs, 8): the true ones with biases of the ranges and noise."""
    draws = np.random.default_rng(seed).standard_normal((runs, 8))
    return np.asarray(true_values() + np.array([*biases, *np.zeros(4)]) + draws * deviations())


def detected(observed: Reals, false_alarm: float) -> tuple[Reals, NDArray[np.bool_]]:
    """Bias detection: the states (N, 4), and which ranges are called biased (N, 4)."""
    every = _asked(range(4))
    states, _ = _iterated(every, observed)
    return states, _called(every, states, observed, false_alarm)


def bias_deviations() -> list[float]:
    """Of the four bias estimates, at the true state."""
    return [each.deviation for each in accuracy(_asked(range(4)), STATE)[1]]


def position_covariance(biased: Sequence[int]) -> Reals:
    """(2, 2), m^2, of position at the true state where the ranges of these stations have biases."""
    return accuracy(_asked(biased), STATE)[0][:2, :2]


def _called(
    every: Problem, states: Reals, observed: Reals, false_alarm: float
) -> NDArray[np.bool_]:
    estimates, spread = all_accuracies(every, states, observed)
    return np.asarray(np.square(estimates / spread) > threshold(false_alarm))


def compared(outcome: Outcome) -> list[Compared]:
    """What theory says something of: RMS errors of unbiased estimates, detection rates."""
    found = []
    for each in outcome.errors:
        for name, rms, promised in zip(NAMES, each.rms, each.promised, strict=True):
            if np.isfinite(promised):
                # of the root mean square of n normal errors
                deviation = promised / np.sqrt(2 * outcome.runs)
                found.append(Compared(f"{each.name}, {name}", rms, promised, deviation))
    for i, (rate, theory) in enumerate(zip(outcome.called, outcome.theory, strict=True), 1):
        deviation = np.sqrt(max(theory * (1 - theory), 1 / outcome.runs) / outcome.runs)
        found.append(Compared(f"B{i} called biased", rate, theory, deviation))
    return found


def _asked(biased: Sequence[int]) -> Problem:
    method = method_of("unknown-reduction")
    return problem(example_stations(), example_observations(), method, biased)


def _iterated(
    asked: Problem, observed: Reals, begin: Reals = STATE
) -> tuple[Reals, NDArray[np.bool_]]:
    done = iterate(asked, np.broadcast_to(begin, (len(observed), len(STATE))), observed)
    return done.unknowns, done.ended == CONVERGED


def _errors(
    name: str,
    biased: Sequence[int],
    biases: Sequence[float],
    estimates: Reals,
    converged: NDArray[np.bool_],
) -> Errors:
    promised = np.full(len(STATE), np.nan)
    if not any(bias for i, bias in enumerate(biases) if i not in biased):
        promised = np.sqrt(np.diag(accuracy(_asked(biased), STATE)[0])[: len(STATE)])
    return Errors(name, _rms(estimates), promised, float(converged.mean()))


def adaptive(
    observed: Reals, called: NDArray[np.bool_], begin: Reals
) -> tuple[Reals, NDArray[np.bool_]]:
    """States (N, 4) with biases of the ranges called so, and which converged; each pattern of
    biases is iterated at once, from where bias detection ended.
    """
    estimates, converged = np.empty_like(begin), np.zeros(len(begin), np.bool_)
    for pattern in np.unique(called, axis=0):
        rows = (called == pattern).all(axis=1)
        asked = _asked(np.flatnonzero(pattern).tolist())
        estimates[rows], converged[rows] = _iterated(asked, observed[rows], begin[rows])
    return estimates, converged


def _rms(estimates: Reals) -> Reals:
    return np.asarray(np.sqrt(np.square(estimates - STATE).mean(axis=0)))
