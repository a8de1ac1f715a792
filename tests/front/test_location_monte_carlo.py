"""Example 1 over draws of noise: a small version of tests/campaigns/location.py."""

from __future__ import annotations

from statistics import NormalDist

import numpy as np
import pytest
from samples import samples

from gainproof.location import monte_carlo
from gainproof.location.example import deviations
from gainproof.location.monte_carlo import Compared, compared, simulate

FALSE_ALARM = 1e-6
"""How often the comparisons of one simulation, taken together, fail though all is as theory says
(for other seeds than the one that is written here).
"""


def allowed(everything: list[Compared]) -> float:
    return -NormalDist().inv_cdf(FALSE_ALARM / 2 / len(everything))


@pytest.mark.sampled
@pytest.mark.parametrize("biases", [(0, 0, 0, 0), (0, 0, 60, 40)])
def test_errors_and_detection_rates_are_those_of_theory(biases: tuple[float, ...]) -> None:
    outcome = simulate(biases, samples(1000), 3, 0.05)
    everything = compared(outcome)
    assert len(everything) == 4 * (2 + (not any(biases))) + 4
    worst = max(everything, key=lambda each: each.off)
    assert worst.off < allowed(everything), worst
    assert all(each.converged == 1 for each in outcome.errors)
    rms = {each.name: each.rms for each in outcome.errors}
    assert (rms["2 clean ranges"][:2] < rms["0 clean ranges"][:2]).all()


def test_another_noise_than_the_covariance_says_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """A tenth more noise than V has."""
    monkeypatch.setattr(monte_carlo, "deviations", lambda: 1.1 * deviations())
    everything = compared(simulate((0, 0, 0, 0), 2000, 3, 0.05))
    assert max(each.off for each in everything) > allowed(everything)


def test_a_wrong_threshold_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """That of the chi-square of two degrees of freedom."""
    monkeypatch.setattr(monte_carlo, "threshold", lambda p: -2 * np.log(p))
    everything = compared(simulate((0, 0, 60, 40), 1000, 3, 0.05))
    assert max(each.off for each in everything) > allowed(everything)
