"""Newton's steps: second derivatives against differences, and a curved valley that they go down."""

from __future__ import annotations

import numpy as np
import pytest
from one_of_each import cases

from gainproof.fixed_gain.arguments import Reals
from gainproof.location import locate, observations, stations
from gainproof.location import starts as beginnings
from gainproof.location.example import example_observations, example_stations
from gainproof.location.gauss_newton import CONVERGED, costs, iterate
from gainproof.location.levenberg_marquardt import damped
from gainproof.location.methods import method_of
from gainproof.location.newton import bending, newton
from gainproof.location.problem import Problem, jacobian, predicted, problem, residual
from gainproof.location.starts import starts
from gainproof.location.stations import Observations, Stations

STATE = np.array([9000.0, 10500.0, 180.0, 30.0])


def asked(method: str) -> Problem:
    return problem(example_stations(), example_observations(), method_of(method))


@pytest.mark.parametrize("method", ["range-doppler", "bias-detection", "common-bias", "range-only"])
def test_what_bends_is_the_change_of_the_slope_less_that_of_the_linear_model(method: str) -> None:
    """Half the gradient of the cost is -J' r: its differences are J' J less what bends."""
    one = asked(method)
    x = STATE[: one.unknowns]
    observed = one.used.values[None, :]

    def slope(at: Reals) -> Reals:
        full = jacobian(one, predicted(one, at[None, :])[1])[0]
        return np.asarray(-full.T @ residual(one, at[None, :], observed)[0])

    full = jacobian(one, predicted(one, x[None, :])[1])[0]
    reduced = full - one.base @ (one.base.T @ full)
    found = reduced.T @ reduced - bending(one, x)
    for i, reach in enumerate([0.5, 0.5, 0.01, 0.01][: len(x)]):
        step = reach * np.eye(len(x))[i]
        wanted = (slope(x + step) - slope(x - step)) / (2 * reach)
        size = np.sqrt(np.abs(np.diag(found)) * abs(found[i, i]))
        assert np.allclose(found[i] / size, wanted / size, rtol=0, atol=1e-6)


TARGET, VELOCITY = np.array([15e3, 31e3, -42e3]), np.array([20.0, -30.0, 10.0])


def valley(seed: int) -> tuple[Stations, Observations]:
    """Nine moving stations on a line but for a metre, a target 50 km away, noise of a seed: ranges
    leave a circle round the line, and where on it the target is only the rates tell.
    """
    draw = np.random.default_rng(seed)
    places = np.concatenate([draw.uniform(-6e4, 6e4, (9, 1)), draw.normal(0, 0.3, (9, 2))], axis=1)
    given = stations(places, draw.uniform(-50, 50, (9, 3)))
    away = TARGET - places
    ranges = np.linalg.norm(away, axis=1)
    rates = ((VELOCITY - given.velocities) * away).sum(axis=1) / ranges
    noise = np.concatenate([np.full(9, 0.7), np.full(9, 0.0015)])
    values = np.concatenate([ranges, rates]) + noise * draw.standard_normal(18)
    return given, observations(given, values[:9], values[9:], np.diag(noise**2))


@pytest.mark.parametrize("seed", cases([110, 111], lambda seed: seed == 110))
def test_a_start_in_a_curved_valley_settles_at_its_end(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Begun on two sides of the line alone, from which damped steps do not come to the end."""
    monkeypatch.setattr(beginnings, "TURNS", 0)
    given, seen = valley(seed)
    one = problem(given, seen, method_of("range-doppler"))
    begin = starts(one, seen)
    before = damped(one, begin, iterate(one, begin, one.used.values))
    after = newton(one, before)
    gone_on = (before.ended != CONVERGED) & (after.ended == CONVERGED)
    assert gone_on.any()
    assert np.array_equal(before.unknowns[~gone_on], after.unknowns[~gone_on])
    assert (after.cost[gone_on] <= before.cost[gone_on]).all()
    best = int(np.argmin(after.cost))
    assert gone_on[best]
    assert after.cost[best] < 40  # 12 degrees of freedom
    for reach in (1e-3, 1.0):
        around = after.unknowns[best] + reach * np.concatenate([np.eye(6), -np.eye(6)])
        rows = np.broadcast_to(one.used.values, (12, 18))
        assert (costs(one, around, rows) > after.cost[best] * (1 - 1e-12)).all()


@pytest.mark.parametrize("seed", cases([103, 113, 123], lambda seed: seed == 103))
def test_stations_nearly_on_a_line_are_no_hindrance_where_they_move(seed: int) -> None:
    """Of the circle that their ranges leave the best places are begun from."""
    given, seen = valley(seed)
    found = locate(given, seen, "range-doppler")
    off = found.position - TARGET
    assert found.convergence.cost < 40
    assert off @ np.linalg.solve(found.covariance[:3, :3], off) < 30
