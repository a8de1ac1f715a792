"""The quantities of a model at a point, from oracles alone: the doubled Riccati equation, and exact
least squares over all samples.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import mpmath
from mutation.arithmetic import product, real

from claim_campaign.point import DIGITS
from gainproof.verify.judge.convention_effect import Chosen
from gainproof.verify.oracles import doubling, least_squares
from gainproof.verify.oracles.state_space import state_space

MOST_SAMPLES = 60
"""More are not simulated; gains and covariances are known for any number."""


@dataclass(frozen=True)
class Place:
    """Where a model is looked at: tracking index or sample number, in units of `interval` and
    `deviation`; `seed` draws states and samples.
    """

    parameter: Any
    interval: Fraction
    deviation: Fraction
    seed: int


def steady(model: Mapping[str, Any], place: Place, chosen: Chosen) -> dict[str, Any]:
    """By name of the quantity; a name that has no value is not there."""
    names = ("transition", "process_noise", "measurement", "measurement_noise")
    frozen = tuple((name, tuple(tuple(row) for row in model[name])) for name in names)
    gain, predicted, updated, innovation = _solved(frozen, place.parameter)
    found = {"tracking_index": real(place.parameter)}
    found["innovation_variance"] = innovation * real(place.deviation) ** 2
    random = Random(place.seed)
    size = len(gain)
    before = [_drawn(random) for _ in range(size)]
    moved = _ahead(before, place.interval)
    measured = _drawn(random)
    residual = measured - moved[0]
    updated_state = [
        m + g * residual / real(place.interval) ** i
        for i, (m, g) in enumerate(zip(moved, gain, strict=True))
    ]
    states = {"previous": before, "predicted": moved, "updated": updated_state}
    if _numbers(model["transition"]) != _numbers(least_squares.taylor(size - 1)):
        states = {}  # they move otherwise
    forward = product(_numbers(model["transition"]), [[g] for g in gain])
    found["measurement"] = measured
    return _finished(
        found, gain, [row[0] for row in forward], predicted, updated, states, place, chosen
    )


def memory(degree: int, place: Place, chosen: Chosen) -> dict[str, Any]:
    """As `steady`; states are those of the batch over samples drawn at random."""
    k = int(place.parameter)
    if k < degree:
        return {}
    gain = [real(g) for g in least_squares.gains(degree, k)]
    updated = _numbers(least_squares.covariance(degree, k))
    move = _numbers(least_squares.taylor(degree))
    predicted: Any = None
    found: dict[str, Any] = {"sample_number": real(k + int(chosen.index_origin))}
    if k > degree:
        before = _numbers(least_squares.covariance(degree, k - 1))
        back = [list(row) for row in zip(*move, strict=True)]
        predicted = product(product(move, before), back)
        found["innovation_variance"] = (predicted[0][0] + 1) * real(place.deviation) ** 2
    states: dict[str, list[Any]] = {}
    if k <= MOST_SAMPLES:
        states = _batch(degree, k, place, found)
    forward = product(move, [[g] for g in gain])
    return _finished(
        found, gain, [row[0] for row in forward], predicted, updated, states, place, chosen
    )


def _batch(degree: int, k: int, place: Place, found: dict[str, Any]) -> dict[str, list[Any]]:
    random = Random(place.seed)
    samples = [Fraction(random.randrange(-30, 30), random.randrange(1, 6)) for _ in range(k + 1)]
    found["measurement"], found["first_measurement"] = real(samples[-1]), real(samples[0])
    if degree == 0:
        found["first_updated_state.1"] = real(samples[0])
    # per unit interval there, per second here
    states = {"updated": _scaled(least_squares.fit(degree, samples), place)}
    if k > degree:
        states["previous"] = _scaled(least_squares.fit(degree, samples[:-1]), place)
        states["predicted"] = _ahead(states["previous"], place.interval)
    return states


def _finished(
    found: dict[str, Any],
    gain: Sequence[Any],
    forward: Sequence[Any],
    predicted: Any,
    updated: Any,
    states: Mapping[str, Sequence[Any]],
    place: Place,
    chosen: Chosen,
) -> dict[str, Any]:
    interval, deviation = real(place.interval), real(place.deviation)
    if chosen.noise == "ratio":
        deviation = real(1)
    found |= {"sampling_interval": interval, "measurement_noise_deviation": deviation}
    found["measurement_noise_variance"] = deviation**2
    if chosen.noise != "deviation":
        for name in ("tracking_index", "measurement_noise_deviation"):
            if name in found:
                found[name] = found[name] ** 2
    meant = gain if chosen.gain == "filter" else forward
    factors = {2: interval ** (int(chosen.power_of_T) - 1), 3: real(Fraction(chosen.third_gain))}
    for i in range(1, len(gain) + 1):
        found[f"filter_gain.{i}"], found[f"predictor_gain.{i}"] = gain[i - 1], forward[i - 1]
        found[f"gain.{i}"] = meant[i - 1] * factors.get(i, 1)
    for which, matrix in (("predicted", predicted), ("updated", updated)):
        for i, row in enumerate(matrix or (), start=1):
            for j, entry in enumerate(row, start=1):
                value = entry * deviation**2 / interval ** (i + j - 2)
                found[f"{which}_covariance.{i}.{j}"] = value
                if which == chosen.covariance:
                    found[f"covariance.{i}.{j}"] = value
    for which, state in states.items():
        found |= {f"{which}_state.{i}": value for i, value in enumerate(state, start=1)}
    return found


@cache
def _solved(
    model: tuple[tuple[str, Any], ...], index: Any
) -> tuple[list[Any], list[list[Any]], list[list[Any]], Any]:
    data = {name: [list(row) for row in rows] for name, rows in model}
    state = doubling.steady_state(state_space(data, index), DIGITS).state

    def rows(matrix: Any) -> list[list[Any]]:
        return [[mpmath.mpf(entry) for entry in row] for row in matrix]

    gain = [row[0] for row in rows(state.gain)]
    return gain, rows(state.predicted), rows(state.updated), rows(state.innovation)[0][0]


def _numbers(matrix: Sequence[Sequence[Any]]) -> list[list[Any]]:
    return [[real(Fraction(entry)) for entry in row] for row in matrix]


def _drawn(random: Random) -> Any:
    return real(Fraction(random.randrange(-50, 50), random.randrange(1, 7)))


def _ahead(state: Sequence[Any], interval: Fraction) -> list[Any]:
    size = len(state)
    move = least_squares.taylor(size - 1)
    rows = [
        [real(move[i][j]) * real(interval) ** (j - i) if j >= i else real(0) for j in range(size)]
        for i in range(size)
    ]
    return [row[0] for row in product(rows, [[s] for s in state])]


def _scaled(state: Sequence[Any], place: Place) -> list[Any]:
    return [real(s) / real(place.interval) ** i for i, s in enumerate(state)]
