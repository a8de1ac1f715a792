"""Which kernels are printed as JavaScript: those that the play on the book's pages moves."""

from __future__ import annotations

from collections.abc import Mapping

_STEADY = ("gains", "predictor_gains", "closed_loop_poles")
_COVARIANCES = ("predicted_covariance", "updated_covariance")
_FIXED = ("closed_loop_poles", "lags", "variances", "variances_of_coordinates")

PLAYED: Mapping[str, tuple[str, ...]] = {
    "random_velocity": (*_STEADY, *_COVARIANCES),
    "random_acceleration": (*_STEADY, *_COVARIANCES),
    "continuous_white_acceleration": (*_STEADY, *_COVARIANCES),
    "acceleration_increments": (*_STEADY, *_COVARIANCES),
    "wiener_acceleration": (*_STEADY, *_COVARIANCES),
    "random_jerk": (*_STEADY, *_COVARIANCES),
    "continuous_white_jerk": (*_STEADY, *_COVARIANCES),
    "position_velocity": ("gains", "closed_loop_poles", *_COVARIANCES),
    "position_velocity_random_acceleration": ("gains", "closed_loop_poles", *_COVARIANCES),
    "position_velocity_random_velocity": ("gains", "closed_loop_poles", *_COVARIANCES),
    "alpha_beta": (*_FIXED, "minimum_variance_by_lag"),
    "alpha_beta_gamma": (*_FIXED, "minimum_variance_by_lag"),
}
"""Names of kernels by module."""
