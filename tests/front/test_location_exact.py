"""Locations against exact least squares, SciPy's, and the paper's own table."""

from __future__ import annotations

import itertools
from fractions import Fraction

import location_cases as cases
import numpy as np
import pytest
from samples import samples

from gainproof.fixed_gain.arguments import Reals
from gainproof.location import locate
from gainproof.location.accuracy import accuracy
from gainproof.location.example import example_observations, example_stations
from gainproof.location.gauss_newton import EPSILON, step
from gainproof.location.methods import METHODS, Method, method_of
from gainproof.location.problem import Problem, linearised, problem
from gainproof.location.result import Bias, Location
from gainproof.location.stations import observations, stations
from gainproof.verify.oracles import location_exact, location_minimum

KINDS = [(method, None) for method in METHODS] + [(method_of("unknown-reduction"), (1, 3))]
NAMES = [f"{method.name}{'' if biased is None else '-two-biases'}" for method, biased in KINDS]
PRINTED = {
    0: ("8.66", "13.23", "0.100", "0.141"),
    2: ("6.05", "6.44", "0.091", "0.115"),
    4: ("4.80", "5.77", "0.088", "0.103"),
}
"""Table 1 by the number of clean ranges: x, y, vx, vy."""


def asked_of(method: Method, biased: tuple[int, ...] | None, dimension: int) -> Problem:
    """The rational geometry in floats; the observations are off by a metre and so on."""
    rows, state = cases.rational(dimension)
    n, d = len(rows), dimension
    table = np.array([[float(part) for part in row] for row in rows])
    given = stations(table[:, :d], table[:, d:])
    values = [
        float(value + off)
        for value, off in zip(
            location_exact.values(rows, state, cases.rows(n)), residuals(n), strict=True
        )
    ]
    noise = [[float(part) for part in row] for row in cases.rational_covariance(n)]
    return problem(given, observations(given, values[:n], values[n:], noise), method, biased)


def residuals(count: int) -> list[Fraction]:
    return [Fraction((-1) ** i * (i + 1), 4) for i in range(2 * count)]


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize(("method", "biased"), KINDS, ids=NAMES)
def test_a_step_and_its_covariance_are_those_of_exact_least_squares(
    method: Method, biased: tuple[int, ...] | None, dimension: int
) -> None:
    """Relative to the deviations: the QR factorisation loses no more than the condition number."""
    asked = asked_of(method, biased, dimension)
    rows, state = cases.rational(dimension)
    n = len(rows)
    kept = [
        (place, (i, rate))
        for place, (i, rate) in enumerate(cases.rows(n))
        if (method.uses_rates if rate else method.uses_ranges)
    ]
    whole, off = cases.rational_covariance(n), residuals(n)
    exact = location_exact.fit(
        rows,
        state,
        [row for _, row in kept],
        asked.unknowns,
        [tuple(Fraction(int(part)) for part in column) for column in asked.columns.T],
        tuple(tuple(whole[i][j] for j, _ in kept) for i, _ in kept),
        tuple(off[i] for i, _ in kept),
    )
    at = np.array([[float(part) for part in state[: asked.unknowns]]])
    linear = linearised(asked, at, asked.used.values[None, :])
    singular = np.linalg.svd(linear.jacobian[0], compute_uv=False)
    allowed = 100 * EPSILON * singular[0] / singular[-1]
    spread, biases = accuracy(asked, at[0])
    deviations = np.sqrt([float(exact.covariance[i][i]) for i in range(len(spread))])
    wanted = np.array([[float(part) for part in row] for row in exact.covariance])
    assert np.abs((spread - wanted) / deviations / deviations[:, None]).max() <= allowed
    taken = step(asked, linear)
    wanted_step = np.array([float(part) for part in exact.step])
    size = np.linalg.norm(asked.white @ asked.used.values) * EPSILON * 100
    found = np.concatenate([taken.change[0], _linear_biases(asked, taken.change[0], biases)])
    assert np.abs((found - wanted_step) / deviations).max() <= allowed * 100 + size
    assert len(biases) == asked.columns.shape[1]


def _linear_biases(asked: Problem, change: Reals, biases: tuple[Bias, ...]) -> Reals:
    """Those of the linear model after its step: what `accuracy` tells is at the old place."""
    if not biases:
        return np.zeros(0)
    before = np.array([each.value for each in biases])
    covariance, _ = accuracy(asked, _state(asked))
    k = asked.unknowns
    slope = covariance[k:, :k] @ np.linalg.inv(covariance[:k, :k])
    return np.asarray(before + slope @ change)


def _state(asked: Problem) -> Reals:
    state = cases.rational(asked.stations.dimension)[1]
    return np.array([float(part) for part in state[: asked.unknowns]])


@pytest.mark.sampled
@pytest.mark.parametrize("dimension", [2, 3])
def test_estimates_are_the_minima_that_scipy_finds(dimension: int) -> None:
    """Within what SciPy can tell of its cost: a change of the unknowns by x deviations changes it
    by x^2, and less than a few epsilons of the cost is lost in rounding.
    """
    for seed in range(samples(1)):
        scene = cases.random_scene(100 * dimension + seed, dimension, 3 * dimension + 3)
        n = len(scene.stations.names)
        noise = np.random.default_rng(seed).standard_normal(2 * n)
        bias = np.where(np.arange(n) == seed % n, 400.0, 0.0)
        for method in METHODS:
            observed, where = scene.observed(noise, bias), scene.state[:dimension]
            found = locate(scene.stations, observed, method.name, near=where)
            wanted, cost = _minimum(scene, observed.values, found, method)
            deviations = np.sqrt(np.diag(found.covariance))
            allowed = 1e-6 + 4 * np.sqrt(EPSILON * cost)
            off = np.abs((_unknowns(found) - wanted) / deviations).max()
            assert off < allowed, (seed, method, cost)
            assert found.convergence.cost == pytest.approx(cost, rel=1e-9, abs=1e-9)


def _unknowns(found: Location) -> Reals:
    velocity = np.zeros(0) if found.velocity is None else found.velocity
    return np.concatenate([found.position, velocity, [each.value for each in found.biases]])


def _minimum(
    scene: cases.Scene, values: Reals, found: Location, method: Method
) -> tuple[Reals, float]:
    n = len(scene.stations.names)
    kept = [i for i in range(2 * n) if (method.uses_rates if i >= n else method.uses_ranges)]
    stations_of = [int(each.station[1:]) - 1 for each in found.biases if each.station != "all"]
    columns = np.zeros((2 * n, len(found.biases)))
    for column, station in enumerate(stations_of):
        columns[station, column] = 1
    if found.biases and not stations_of:
        columns[:n] = 1
    k = len(found.position) + (0 if found.velocity is None else len(found.velocity))
    return location_minimum.minimum(
        scene.stations.positions,
        scene.stations.velocities,
        [cases.rows(n)[i] for i in kept],
        values[kept],
        scene.covariance[np.ix_(kept, kept)],
        columns[kept],
        np.concatenate([scene.state[:k], np.zeros(len(found.biases))]),
        found.velocity is not None,
    )


@pytest.mark.sampled
@pytest.mark.parametrize("dimension", [2, 3])
def test_bias_detection_and_range_rates_alone_are_one_estimate(dimension: int) -> None:
    """The paper's claim of the linear model, through the iterations and with correlated noise."""
    for seed in range(samples(2)):
        scene = cases.random_scene(seed, dimension, 2 * dimension + seed % 4)
        n = len(scene.stations.names)
        random = np.random.default_rng(seed)
        observed = scene.observed(3 * random.standard_normal(2 * n), random.uniform(-300, 900, n))
        where = scene.state[:dimension]
        both = locate(scene.stations, observed, "bias-detection", near=where)
        alone = locate(scene.stations, observed, "doppler-only", near=where)
        k = 2 * dimension
        deviations = np.sqrt(np.diag(alone.covariance))
        apart = (_unknowns(both)[:k] - _unknowns(alone)) / deviations
        assert np.abs(apart).max() < 1e-9
        change = both.covariance[:k, :k] - alone.covariance
        assert np.abs(change / deviations / deviations[:, None]).max() < 1e-9
        assert both.convergence.cost == pytest.approx(alone.convergence.cost, rel=1e-9, abs=1e-9)
        # the iteration did work: the model is not linear
        assert max(both.convergence.iterations, alone.convergence.iterations) > 2


@pytest.mark.parametrize("clean", PRINTED)
def test_table_1(clean: int) -> None:
    """From the truth, as the paper has it. It prints 0.103 where the deviation is 0.10377."""
    method = method_of("unknown-reduction")
    asked = problem(example_stations(), example_observations(), method, range(clean, 4))
    covariance, _ = accuracy(asked, np.array([10e3, 10e3, 200, 0]))
    found = np.sqrt(np.diag(covariance)[:4])
    digits = [len(text.partition(".")[2]) for text in PRINTED[clean]]
    rounded = [f"{value:.{count}f}" for value, count in zip(found, digits, strict=True)]
    wanted = PRINTED[clean] if clean < 4 else (*PRINTED[4][:3], "0.104")
    assert tuple(rounded) == wanted


def test_fewer_biases_and_more_observations_never_make_it_worse() -> None:
    """Property 14, for every set of clean ranges and the next larger one; and ranges alone."""
    scene = cases.random_scene(5, 3, 7)
    observed = scene.observed(np.zeros(14))
    method = method_of("unknown-reduction")
    spreads = []
    for count in range(8):
        asked = problem(scene.stations, observed, method, range(count))
        spreads.append(accuracy(asked, scene.state)[0][:6, :6])
    for less, more in itertools.pairwise(spreads):
        assert np.linalg.eigvalsh(more - less).min() > -1e-9 * np.abs(more).max()
    only = problem(scene.stations, observed, method_of("range-only"))
    ranges = accuracy(only, scene.state[:3])[0]
    assert np.linalg.eigvalsh(ranges - spreads[0][:3, :3]).min() > 0
