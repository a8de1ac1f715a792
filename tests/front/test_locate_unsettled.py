"""Starts that do not settle by Gauss-Newton: damped steps settle them, and what is left is told."""

from __future__ import annotations

import numpy as np
import pytest

from gainproof.location import DivergedError, diagonal, locate, newton, observations, stations
from gainproof.location import levenberg_marquardt as damping
from gainproof.location import unsettled as ends
from gainproof.location.methods import method_of
from gainproof.location.problem import linearised, problem
from gainproof.location.stations import Observations, Stations

PLACES = [
    *([5940.5662, 7546.4398], [-8979.2820, -6982.9615], [6607.0288, 2935.2299]),
    *([6547.4428, 2134.4652], [1786.2616, 702.4724], [-1327.0427, 2736.6416]),
    *([4852.7790, -2464.8435], [4679.2485, -5063.2940]),
]
RANGES = [
    *(21419.9828, 20653.3706, 23564.2484, 23988.8317),
    *(20488.1738, 16772.2006, 24840.8184, 26628.0024),
]
RATES = [14.3549, 13.6559, 15.2164, 15.4149, 16.2350, 16.2935, 16.2046, 16.3521]
METHODS = ("bias-detection", "doppler-only")
AT_ONCE = [12949.0, -10627.0]
"""Where Gauss-Newton settles."""
IN_THE_VALLEY = [-8219.0, 15879.5]
"""Where its steps zigzag."""


def far_and_slow() -> tuple[Stations, Observations]:
    """A target twice as far away as the stations are wide: two places have nearly its rates."""
    given = stations(PLACES)
    noise = diagonal([3.1367] * 8 + [0.1566] * 8)
    return given, observations(given, RANGES, RATES, noise)


def cost_of_rates(place: list[float]) -> float:
    """By the plain formula, with the velocity that fits best there."""
    apart = np.array(place) - PLACES
    unit = apart / np.linalg.norm(apart, axis=1)[:, None]
    rest = np.linalg.lstsq(unit, np.array(RATES), rcond=None)[1]
    return float(rest[0]) / 0.1566**2


@pytest.mark.parametrize("method", METHODS)
def test_a_place_in_a_bent_valley_is_found(method: str) -> None:
    """Biases that are free leave the range rates alone to decide."""
    assert cost_of_rates(IN_THE_VALLEY) < cost_of_rates(AT_ONCE)
    found = locate(*far_and_slow(), method)
    assert np.abs(found.position - IN_THE_VALLEY).max() < 1
    assert found.convergence.ended == "converged"
    assert found.convergence.cost <= cost_of_rates(IN_THE_VALLEY) + 1e-9
    (other,) = (each for each in found.warnings if each.startswith("ambiguous"))
    assert "(12949.3, -10627.4) m" in other
    assert np.abs(found.others[0].position - AT_ONCE).max() < 1


def test_a_place_that_was_not_reached_is_a_warning(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(damping, "MOST_DAMPED", 0)
    monkeypatch.setattr(newton, "MOST_STARTS", 0)
    # reduction begins at the places of bias detection, and says what it came to from there
    for method, starts in (("bias-detection", 30), ("unknown-reduction", 4)):
        found = locate(*far_and_slow(), method)
        told, *_ = (each for each in found.warnings if each.startswith("unsettled"))
        assert f"{method}: " in told
        assert f"of {starts} starts did not settle" in told
        assert "a place there may explain the observations as well" in told


def test_a_place_that_is_far_better_and_was_not_reached_is_no_answer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(damping, "MOST_DAMPED", 0)
    monkeypatch.setattr(newton, "MOST_STARTS", 0)
    monkeypatch.setattr(ends, "AS_GOOD", 0.5)
    with pytest.raises(
        DivergedError, match=r"the best place that it settled at, \(12949"
    ) as caught:
        locate(*far_and_slow(), "doppler-only")
    assert caught.value.report.cost < cost_of_rates(AT_ONCE) - 0.5
    assert caught.value.report.ended != "converged"


def test_a_selection_that_the_cost_refutes_is_told() -> None:
    """Biases of kilometres within the deviations of their estimates: the test misses them."""
    found = locate(*far_and_slow())
    assert found.first is not None
    assert found.convergence.cost > 100 * found.convergence.degrees_of_freedom
    told = found.warnings[0]
    assert told.startswith("refuted: the selection of clean ranges cannot be right")
    place = ", ".join(f"{value:.1f}" for value in found.first.position.tolist())
    assert f"Take bias detection instead, whose cost 4.39 noise explains: ({place}) m" in told


def test_deviations_whose_costs_are_no_numbers_are_refused() -> None:
    """They were told as a target on a station."""
    given, observed = far_and_slow()
    tiny = observations(given, RANGES, RATES, observed.covariance * 1e-300)
    with pytest.raises(ValueError, match="deviations are between 1e-50 and 1e") as caught:
        locate(given, tiny)
    assert type(caught.value) is ValueError


def test_a_damped_step_is_that_of_damped_normal_equations() -> None:
    """(J'J + damping I) s = J'r, in columns that are well conditioned."""
    given, observed = far_and_slow()
    asked = problem(given, observed, method_of("range-doppler"))
    at = np.array([[1e4, 9e3, 5.0, -3.0]])
    linear = linearised(asked, at, observed.values[None, :])
    jacobian, residual = linear.jacobian[0], linear.residual[0]
    for size in (1e-3, 1.0, 30.0):
        change, expected = damping._step(linear, np.array([size]))
        normal = jacobian.T @ jacobian + size * np.eye(4)
        scaled = np.linalg.solve(normal, jacobian.T @ residual)
        assert np.allclose(change[0] * linear.scale[0], scaled, rtol=1e-8)
        left = residual - jacobian @ scaled
        assert expected[0] == pytest.approx(residual @ residual - left @ left, rel=1e-8)
