"""Interacting filters against a Kronecker product, long runs and filters of one coordinate."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gainproof.fixed_gain import interacting, two_states

GENERATOR = np.random.default_rng(5)
K1 = np.diag([0.4, 0.5, 0.6]) + GENERATOR.uniform(-0.05, 0.05, (3, 3))
K2 = (np.diag([0.1, 0.2, 0.3]) + GENERATOR.uniform(-0.03, 0.03, (3, 3))) / 10
B = np.array([[4.0, 1.0, 0.5], [1.0, 9.0, -1.0], [0.5, -1.0, 2.0]])
T = 10.0


def test_the_covariance_solves_the_lectures_equation_as_a_kronecker_product() -> None:
    """Written out with F, K, H by blocks; the front doubles a sum instead."""
    zero, one = np.zeros((3, 3)), np.eye(3)
    moving = np.block([[one, T * one], [zero, one]])
    gain, seen = np.vstack([K1, K2]), np.hstack([one, zero])
    rest = np.eye(6) - gain @ seen
    closed = moving @ rest
    driven = moving @ gain @ B @ (moving @ gain).T
    wanted = np.linalg.solve(np.eye(36) - np.kron(closed, closed), driven.reshape(-1)).reshape(6, 6)
    found = interacting.covariances(K1, K2, T, B)
    scale = np.sqrt(np.outer(np.diag(wanted), np.diag(wanted)))
    assert np.abs((found.predicted - wanted) / scale).max() < 1e-12
    smoothed = rest @ wanted @ rest.T + gain @ B @ gain.T
    assert np.abs((found.smoothed - smoothed) / scale).max() < 1e-12
    assert (found.predicted == found.predicted.T).all()
    assert np.linalg.eigvalsh(found.smoothed)[0] > 0


def test_without_interaction_each_coordinate_is_a_filter_of_its_own() -> None:
    alpha, beta = np.array([0.4, 0.5, 0.6]), np.array([0.1, 0.2, 0.3])
    sizes = np.array([1.0, 4.0, 9.0])
    found = interacting.covariances(np.diag(alpha), np.diag(beta / T), T, np.diag(sizes))
    own = two_states.variances(alpha, beta)
    assert np.diag(found.predicted)[:3] == pytest.approx(own.predicted_11 * sizes, rel=1e-12)
    assert np.diag(found.smoothed)[3:] == pytest.approx(own.updated_22 * sizes / T**2, rel=1e-12)
    assert interacting.lag(np.diag(beta / T), T, [1, 1, 2]) == pytest.approx(
        T**2 / beta * [1, 1, 2], rel=1e-12
    )
    moduli = np.abs(interacting.poles(np.diag(alpha), np.diag(beta / T), T))
    each = np.abs(two_states.poles(alpha, beta)).reshape(-1)
    assert moduli == pytest.approx(np.sort(each)[::-1], rel=1e-12)


def test_the_lag_is_what_a_noise_free_run_leaves() -> None:
    course = np.array([1.0, -2.0, 0.5])
    position, velocity = np.zeros(3), np.zeros(3)
    error = np.zeros(3)
    for k in range(1, 2000):
        ahead = position + T * velocity
        truth = course * (k * T) ** 2 / 2
        error = truth - ahead
        position, velocity = ahead + K1 @ error, velocity + K2 @ error
    assert interacting.lag(K2, T, course) == pytest.approx(error, rel=1e-6)
    assert interacting.is_stable(K1, K2, T)
    assert not interacting.is_stable(K1, 100 * K2, T)


NAN = float("nan")
ERRORS: list[tuple[Any, tuple[Any, ...], str]] = [
    (interacting.lag, (np.ones((3, 3)), T, [1, 1, 1]), "velocity_gain is singular: its least"),
    (interacting.lag, (np.zeros((2, 2)), T, [1, 1]), "velocity_gain is singular"),
    (interacting.lag, (np.eye(3), T, [1, 1]), r"acceleration must have shape \(3,\)"),
    (interacting.lag, (np.eye(3), 0, [1, 1, 1]), "interval must be one number above 0"),
    (interacting.lag, (np.eye(3), [1, 2], [1, 1, 1]), "interval must be one number above 0"),
    (interacting.poles, (K1, K2[:2, :2], T), r"one shape, got \(3, 3\) and \(2, 2\)"),
    (interacting.poles, (K1[:2], K2, T), r"position_gain must be a square matrix, got shape \(2"),
    (interacting.poles, (K1 * NAN, K2, T), r"position_gain must be finite, got nan at index \(0"),
    (interacting.poles, (np.empty((0, 0)), K2, T), "must be a square matrix"),
    (interacting.covariances, (K1, 100 * K2, T, B), "not a stable filter: the eigenvalues of F"),
    (interacting.covariances, (np.zeros((3, 3)), K2, T, B), "not a stable filter"),
    (interacting.covariances, (K1, np.ones((3, 3)), T, B), "velocity_gain is singular, its det"),
    (interacting.lag, (K2, T, [1, 1, 1], np.zeros((3, 3))), "the eigenvalues of F"),
    (interacting.covariances, (K1, K2, T, -B), "no eigenvalue below 0, got -"),
    (interacting.covariances, (K1, K2, T, np.triu(B)), "must be symmetric"),
    (interacting.covariances, (K1, K2, T, np.eye(2)), r"must have shape \(3, 3\) as the gains"),
]


@pytest.mark.parametrize(("function", "given", "told"), ERRORS)
def test_what_cannot_be_computed_is_named(function: Any, given: tuple[Any, ...], told: str) -> None:
    with pytest.raises(ValueError, match=told):
        function(*given)


def test_a_matrix_of_something_else_is_a_type_error() -> None:
    with pytest.raises(TypeError, match="position_gain must be real numbers, got"):
        interacting.poles([["a"]], [[1.0]], T)
