"""The iteration itself: halved steps, many targets at once, what each end is called."""

from __future__ import annotations

import numpy as np

from gainproof.location import diagonal, observations, stations
from gainproof.location.gauss_newton import AWAY, CONVERGED, DEFICIENT, ON_STATION, iterate
from gainproof.location.methods import method_of
from gainproof.location.problem import Problem, problem, residual

TARGET = np.array([5e3, 7e3])


def row(method: str = "range-only") -> Problem:
    """Five stations on a line, a target beside them at rest."""
    given = stations(np.array([[i * 1e4, 0] for i in range(5)]))
    ranges = np.linalg.norm(TARGET - given.positions, axis=1)
    noise = diagonal([10] * 5 + [0.1] * 5)
    return problem(given, observations(given, ranges, np.zeros(5), noise), method_of(method))


def test_a_step_that_overshoots_is_halved() -> None:
    """A metre beside the line the full step goes 24,000 km away: the cost is what stops it."""
    asked = row()
    start = np.array([[5e3, 1.0]])
    before = np.square(residual(asked, start, asked.used.values[None, :])).sum()
    done = iterate(asked, start, asked.used.values)
    assert done.ended.tolist() == [CONVERGED]
    assert done.halvings[0] > 5
    assert done.cost[0] < 1e-9 < before
    assert np.allclose(done.unknowns[0], TARGET)


def test_targets_together_end_as_each_alone() -> None:
    """On the line, on a station, near, and mirrored; each with its own end."""
    asked = row()
    starts = np.array([[5e3, 0.0], [1e4, 0.0], [6e3, 5e3], [6e3, -5e3]])
    done = iterate(asked, starts, asked.used.values)
    assert done.ended.tolist() == [DEFICIENT, ON_STATION, CONVERGED, CONVERGED]
    assert np.allclose(done.unknowns[2:], [TARGET, TARGET * [1, -1]])
    for i, start in enumerate(starts):
        alone = iterate(asked, start[None, :], asked.used.values)
        assert alone.ended[0] == done.ended[i]
        assert alone.iterations[0] == done.iterations[i]
        assert np.allclose(alone.unknowns[0], done.unknowns[i], rtol=1e-12)


def test_observations_that_no_place_explains_run_away() -> None:
    """Ranges that grow towards the stations in the middle."""
    asked = row()
    ranges = np.array([1.0, 1e12, 1e12, 1e12, 1.0])
    done = iterate(asked, np.array([[5e3, 6e3]]), ranges)
    assert done.ended[0] == AWAY
