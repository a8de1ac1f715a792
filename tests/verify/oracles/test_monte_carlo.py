"""Simulated filters and their judgement: what can be known without a filter's theory."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from gainproof.verify.oracles import monte_carlo

FALSE_ALARM = 1e-6
COUNT = 20_000


def test_a_filter_that_believes_every_measurement() -> None:
    """Gains 1 and 1: position z_k, velocity z_k less z_(k-1), so the covariance is plain."""
    errors = monte_carlo.run((1.0, 1.0), 5, COUNT, 1)
    updated = np.array([[1.0, 1.0], [1.0, 2.0]])
    predicted = np.array([[5.0, 3.0], [3.0, 2.0]])
    for found, known in ((errors.updated, updated), (errors.predicted, predicted)):
        assert monte_carlo.contradictions(found, np.zeros(2), known, FALSE_ALARM) == ()


def test_process_noise_shakes_the_state_by_its_covariance() -> None:
    """Gain 0: one sample's error is one draw of the noise, singular ones included."""
    for noise in ([[0.25, 0.5], [0.5, 1.0]], [[0.0, 0.0], [0.0, 4.0]], [[2.0, -1.0], [-1.0, 3.0]]):
        known = np.array(noise)
        found = monte_carlo.run((0.0, 0.0), 1, COUNT, 2, process_noise=known).predicted
        room = 6 * np.sqrt(2 / COUNT) * np.sqrt(np.outer(known.diagonal(), known.diagonal()))
        assert np.all(np.abs(found.T @ found / COUNT - known) <= room)


def test_a_push_moves_the_target_by_its_powers_of_time() -> None:
    """Gain 0: the errors are the truth, a k^n/n! and its derivatives."""
    for size in (2, 3):
        true = np.array([5.0**k / mpmath.factorial(k) for k in range(size, 0, -1)], dtype=float)
        predicted, updated = monte_carlo.standing_errors((0.0,) * size, 5)
        assert np.allclose(predicted, true)
        assert np.allclose(updated, true)
        noisy = monte_carlo.run((0.0,) * size, 5, 3, 1, push=2.0)
        assert np.allclose(noisy.predicted, 2 * true)


@pytest.mark.parametrize("degrees", [5, 400, 20_000])
@pytest.mark.parametrize("rate", [0.3, 1e-3, 1e-8])
def test_the_interval_leaves_out_the_stated_probability(degrees: int, rate: float) -> None:
    """By mpmath's incomplete gamma function."""
    low, high = monte_carlo.spread_interval(degrees, rate)
    below = mpmath.gammainc(degrees / 2, 0, low * degrees / 2, regularized=True)
    above = mpmath.gammainc(degrees / 2, high * degrees / 2, regularized=True)
    assert float(below) == pytest.approx(rate / 2, rel=1e-6)
    assert float(above) == pytest.approx(rate / 2, rel=1e-6)


def test_false_alarms_come_at_most_as_often_as_stated() -> None:
    """1000 sets of a true covariance at the rate 0.1: at most 10 %, and not far below."""
    generator = np.random.default_rng(3)
    root = np.array([[1.0, 0.0], [0.7, 0.5]])
    draws = generator.standard_normal((1000, 50, 2)) @ root.T
    covariance, mean = root @ root.T, np.zeros(2)
    alarms = sum(bool(monte_carlo.contradictions(d, mean, covariance, 0.1)) for d in draws)
    # 6 deviations of a count of 1000 at a tenth
    assert 20 < alarms < 100 + 6 * np.sqrt(90)


def wrong_entries() -> list[tuple[str, np.ndarray[tuple[int, ...], np.dtype[np.float64]]]]:
    """The covariance of gains 1 and 1 with one entry off by a tenth or of the other sign."""
    return [
        ("state 1", np.array([[5.5, 3.0], [3.0, 2.0]])),
        ("state 2", np.array([[5.0, 3.0], [3.0, 2.2]])),
        ("states 1", np.array([[5.0, 2.7], [2.7, 2.0]])),
        ("states 1", np.array([[5.0, -3.0], [-3.0, 2.0]])),
    ]


@pytest.mark.parametrize(("which", "wrong"), wrong_entries())
def test_a_wrong_covariance_is_contradicted(
    which: str, wrong: np.ndarray[tuple[int, ...], np.dtype[np.float64]]
) -> None:
    errors = monte_carlo.run((1.0, 1.0), 5, COUNT, 1).predicted
    found = monte_carlo.contradictions(errors, np.zeros(2), wrong, FALSE_ALARM)
    assert any(text.startswith(f"variance of {which}") for text in found)


def test_a_wrong_lag_is_contradicted() -> None:
    """Gains 1 and 1 are exactly a/2 T^2 ahead with the position 0 late, velocity a T/2 late."""
    errors = monte_carlo.run((1.0, 1.0), 8, COUNT, 4, push=3.0).updated
    covariance = np.array([[1.0, 1.0], [1.0, 2.0]])
    assert monte_carlo.contradictions(errors, np.array([0, 1.5]), covariance, FALSE_ALARM) == ()
    found = monte_carlo.contradictions(errors, np.array([0, 1.4]), covariance, FALSE_ALARM)
    assert any(text.startswith("mean of state 2") for text in found)


def test_a_loop_that_does_not_shrink_and_bad_input_are_refused() -> None:
    assert monte_carlo.samples_to_forget((1.0, 1.0), 1e-6) == 2
    with pytest.raises(ValueError, match="does not shrink"):
        monte_carlo.samples_to_forget((1.0, 2.1), 1e-6)
    with pytest.raises(ValueError, match="between 0 and 1, got 0"):
        monte_carlo.contradictions(np.ones((3, 1)), np.zeros(1), np.eye(1), 0)
    # singular; by the machine's order of operations the last two leave a little more or less than 0
    for first, both, second in ((1, 1, 1), (5, 15, 45), (6, 18, 54)):
        singular = np.array([[first, both], [both, second]])
        with pytest.raises(ValueError, match="stated variance of states 1 less 2 is "):
            monte_carlo.contradictions(np.ones((3, 2)), np.zeros(2), singular, 0.1)
