"""The runs of the experiment: every filter on the same noise, all runs at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from gainproof.figures.patent_scene import (
    ACCELERATION,
    INTERVAL,
    PATHS,
    SETTLED,
    Seen,
    nominal_points,
    seen,
)
from gainproof.plots.table import Reals
from gainproof.tracking.arrays import Ints
from gainproof.tracking.gains import (
    Point,
    constant_point,
    decoupled,
    exact_point,
    kalman,
    line_of_sight,
    recursive_point,
    tracking_index,
    young,
)
from gainproof.tracking.measured import Measured
from gainproof.tracking.motion import POSITION, VELOCITY, Estimate, predicted, started, updated

NORMAL = NormalDist().inv_cdf(0.975)
"""Of the two-sided interval of 95 %."""
NOMINAL_FILTERS = ("fixed", "first-order-recursive", "first-order-constant")
OTHERS = ("exact", "line-of-sight", "kalman")


@dataclass(frozen=True)
class Errors:
    """Squared errors of one filter after each sample, (samples, runs): m^2 and m^2/s^2."""

    position: Reals
    velocity: Reals


@dataclass(frozen=True)
class Interval:
    """A root of a mean square with its interval of 95 %: numbers or arrays."""

    middle: Reals
    lower: Reals
    upper: Reals


def rms(squared: Reals) -> Interval:
    """Over the last axis, independent runs: the mean of squares is normal to good approximation,
    its deviation that of the sample.
    """
    n = squared.shape[-1]
    mean = squared.mean(-1)
    reach = NORMAL * squared.std(-1, ddof=1) / np.sqrt(n)
    return Interval(np.sqrt(mean), np.sqrt(np.maximum(mean - reach, 0)), np.sqrt(mean + reach))


def ratio(squared: Reals, other: Reals) -> Interval:
    """The RMS of one filter over that of another on the same noise, one square for each run: the
    deviation of a quotient of means, to first order.
    """
    n = squared.shape[-1]
    found = squared.mean(-1) / other.mean(-1)
    rest = squared - found[..., None] * other
    reach = NORMAL * rest.std(-1, ddof=1) / np.sqrt(n) / other.mean(-1)
    return Interval(np.sqrt(found), np.sqrt(np.maximum(found - reach, 0)), np.sqrt(found + reach))


def settled(squared: Reals) -> Reals:
    """The mean over the samples after the first ones, one number for each run."""
    return np.asarray(squared[SETTLED:].mean(0))


def outcomes(path: str) -> dict[str, Errors]:
    """Errors by filter; those with a nominal point are called "fixed, far" and so on."""
    given = seen(path)
    measured = given.measured
    index = tracking_index(ACCELERATION, INTERVAL, measured.variances)
    found: dict[str, Errors] = {}
    for name, nominal in nominal_points().items():
        steps: Mapping[str, Point] = {
            "fixed": _everywhere(nominal, index),
            "first-order-recursive": _recursive(nominal, index),
            "first-order-constant": constant_point(nominal, index),
        }
        for filter_name, point in steps.items():
            found[f"{filter_name}, {name}"] = _of_axes(given, point)
    found["exact"] = _of_axes(given, exact_point(index))
    interval = np.full(measured.position.shape[:-1], INTERVAL)
    turned = line_of_sight(measured, interval, ACCELERATION, _samples(index))
    found["line-of-sight"] = _followed(given, turned)
    found["kalman"] = _kalman(given)
    return found


def all_outcomes() -> dict[str, dict[str, Errors]]:
    """Those of all paths."""
    return {path: outcomes(path) for path in PATHS}


def _of_axes(given: Seen, point: Point) -> Errors:
    """Gains of their own for x and y, after those of least squares while these are larger."""
    number = _samples(point.index)
    return _followed(given, decoupled(young(point, number), np.full(number.shape, INTERVAL)))


def _samples(index: Reals) -> Ints:
    """(samples, 1): 1, 1, 2, 3, ...; the first two have no gains of their own."""
    return np.maximum(np.arange(len(index)), 1)[:, None]


def _everywhere(nominal: Point, index: Reals) -> Point:
    alpha, beta = (np.broadcast_to(x, index.shape) for x in (nominal.alpha, nominal.beta))
    return Point(index, alpha, beta)


def _recursive(nominal: Point, index: Reals) -> Point:
    """From the nominal point to the first sample that is filtered, then from sample to sample."""
    last = _everywhere(nominal, nominal.index)
    alpha, beta = np.zeros_like(index), np.zeros_like(index)
    for k in range(2, len(index)):
        last = recursive_point(last, index[k])
        alpha[k], beta[k] = last.alpha, last.beta
    return Point(index, alpha, beta)


def _start(measured: Measured) -> Estimate:
    return started(
        measured.position[0],
        measured.covariance[0],
        measured.part(1),
        np.full(measured.position.shape[1], INTERVAL),
        ACCELERATION,
    )


def _followed(given: Seen, gain: Reals) -> Errors:
    """With gains (samples, runs, 4, 2)."""
    measured = given.measured.position
    state = _start(given.measured).state
    states = np.full((*measured.shape[:2], 4), np.nan)
    states[1] = state
    for k in range(2, len(measured)):
        state = state.copy()
        state[:, POSITION] += INTERVAL * state[:, VELOCITY]
        innovation = measured[k] - state[:, POSITION]
        state += gain[k, :, :, 0] * innovation[:, :1] + gain[k, :, :, 1] * innovation[:, 1:]
        states[k] = state
    return _errors(given, states)


def _kalman(given: Seen) -> Errors:
    measured = given.measured
    kept = _start(measured)
    states = np.full((*measured.position.shape[:2], 4), np.nan)
    states[1] = kept.state
    interval = np.full(len(kept.state), INTERVAL)
    for k in range(2, len(states)):
        before = predicted(kept, interval, ACCELERATION)
        now = measured.part(k)
        kept = updated(before, kalman(now, before.covariance), now)
        states[k] = kept.state
    return _errors(given, states)


def _errors(given: Seen, states: Reals) -> Errors:
    position = states[..., POSITION] - given.truth.position
    velocity = states[..., VELOCITY] - given.truth.velocity
    return Errors(np.sum(position**2, -1), np.sum(velocity**2, -1))
