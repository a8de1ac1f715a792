"""Simulated tracks: what can be said without a filter's theory, and the guards."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from kernel_truth import STEADY_STATES

from gainproof.verify.oracles import position_velocity as oracle
from gainproof.verify.oracles import tracks
from gainproof.verify.oracles.state_space import StateSpace

NOISE = STEADY_STATES["continuous_white_acceleration"]["process_noise"]
MODEL = oracle.model(NOISE, 1, 1)
COUNT = 40_000


def test_a_filter_that_believes_every_measurement_errs_like_one_prediction_from_it() -> None:
    """Gain I: the error is F times the measurement noise, less one process noise."""
    errors = tracks.prediction_errors(MODEL, np.eye(2), 3, COUNT, seed=5)
    f = np.array([[1.0, 1.0], [0.0, 1.0]])
    known = f @ f.T + np.array([[1 / 3, 1 / 2], [1 / 2, 1.0]])
    # a mean of N products of normal numbers is off by less than 6 sqrt(2/N) of their size
    room = 6 * np.sqrt(2 / COUNT) * np.sqrt(np.outer(np.diag(known), np.diag(known)))
    assert np.all(np.abs(errors.T @ errors / COUNT - known) < room)


def test_a_filter_that_believes_nothing_errs_without_end() -> None:
    """Gain 0: the error of the first measurement and all the noise since."""
    errors = tracks.prediction_errors(MODEL, np.zeros((2, 2)), 50, 2000, seed=5)
    assert np.var(errors[:, 1]) > 40
    with pytest.raises(ValueError, match="does not shrink"):
        tracks.samples_to_forget(MODEL, np.zeros((2, 2)), 1e-3)


def test_a_seed_gives_one_set_of_tracks() -> None:
    first, again, other = (
        tracks.prediction_errors(MODEL, np.eye(2) / 2, 5, 10, seed) for seed in (1, 1, 2)
    )
    assert np.array_equal(first, again)
    assert not np.any(first == other)


def test_samples_to_forget_is_the_power_that_has_shrunk() -> None:
    """Gain I/2: the loop is F/2, whose powers are known."""
    samples = tracks.samples_to_forget(MODEL, np.eye(2) / 2, 1e-3)
    sizes = [
        np.linalg.norm(np.array([[1.0, k], [0.0, 1.0]]) / 2.0**k, 2) for k in (samples - 1, samples)
    ]
    assert sizes[1] <= 1e-3 < sizes[0]


def test_every_state_must_be_measured() -> None:
    with pytest.raises(ValueError, match="needs every state measured"):
        tracks.prediction_errors(oracle.position_only(NOISE, 1), np.eye(2), 1, 1, 0)
    with pytest.raises(ValueError, match="2x2 gain"):
        tracks.prediction_errors(MODEL, np.eye(3), 1, 1, 0)


def test_a_singular_noise_moves_the_state_along_its_direction() -> None:
    one, zero = Fraction(1), Fraction(0)
    still = StateSpace(
        ((one, zero), (zero, one)),
        ((one, one), (one, one)),
        ((one, zero), (zero, one)),
        ((zero, zero), (zero, zero)),
    )
    errors = tracks.prediction_errors(still, np.eye(2), 1, 100, seed=3)
    assert np.allclose(errors[:, 0], errors[:, 1], rtol=0, atol=1e-12)
    assert np.std(errors[:, 0]) > 0.5
