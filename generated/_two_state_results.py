# Made by: gainproof generate
"""Results of kernels, the same for several modules."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import NamedTuple

    from gainproof.generated._signature import Real
else:
    from gainproof.generated._result import NamedTuple


class Gains(NamedTuple):
    """Result of `gains`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times the sampling interval."""


class GainDerivatives(NamedTuple):
    """Result of `gain_derivatives`."""

    alpha: Real
    """Derivative of the position gain."""
    beta: Real
    """Derivative of the velocity gain times the sampling interval."""


class GainsWithDerivatives(NamedTuple):
    """Result of `gains_with_derivatives`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times the sampling interval."""
    d_alpha: Real
    """Derivative of the position gain."""
    d_beta: Real
    """Derivative of the velocity gain times the sampling interval."""


class PredictorGains(NamedTuple):
    """Result of `predictor_gains`."""

    position: Real
    """Position entry of F K, alpha + beta."""
    velocity: Real
    """Velocity entry of F K times the sampling interval, beta."""


class PredictorGainDerivatives(NamedTuple):
    """Result of `predictor_gain_derivatives`."""

    position: Real
    """Derivative of the position entry of F K, alpha + beta."""
    velocity: Real
    """Derivative of the velocity entry of F K times the sampling interval, beta."""


class PredictedCovariance(NamedTuple):
    """Result of `predicted_covariance`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity times T/sigma_v^2."""
    predicted_22: Real
    """Variance of the predicted velocity times T^2/sigma_v^2."""


class PredictedCovarianceDerivatives(NamedTuple):
    """Result of `predicted_covariance_derivatives`."""

    predicted_11: Real
    """Derivative of the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Derivative of the covariance of predicted position and velocity times T/sigma_v^2."""
    predicted_22: Real
    """Derivative of the variance of the predicted velocity times T^2/sigma_v^2."""


class UpdatedCovariance(NamedTuple):
    """Result of `updated_covariance`."""

    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity times T/sigma_v^2."""
    updated_22: Real
    """Variance of the updated velocity times T^2/sigma_v^2."""


class UpdatedCovarianceDerivatives(NamedTuple):
    """Result of `updated_covariance_derivatives`."""

    updated_11: Real
    """Derivative of the variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Derivative of the covariance of updated position and velocity times T/sigma_v^2."""
    updated_22: Real
    """Derivative of the variance of the updated velocity times T^2/sigma_v^2."""


class GainSecondDerivatives(NamedTuple):
    """Result of `gain_second_derivatives`."""

    alpha: Real
    """Second derivative by Lambda of the position gain."""
    beta: Real
    """Second derivative by Lambda of the velocity gain times the sampling interval."""


class PredictorGainSecondDerivatives(NamedTuple):
    """Result of `predictor_gain_second_derivatives`."""

    position: Real
    """Second derivative by Lambda of the position entry of F K, alpha + beta."""
    velocity: Real
    """Second derivative by Lambda of the velocity entry of F K times the sampling interval,
    beta."""


class PredictedCovarianceSecondDerivatives(NamedTuple):
    """Result of `predicted_covariance_second_derivatives`."""

    predicted_11: Real
    """Second derivative by Lambda of the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Second derivative by Lambda of the covariance of predicted position and velocity times
    T/sigma_v^2."""
    predicted_22: Real
    """Second derivative by Lambda of the variance of the predicted velocity times T^2/sigma_v^2."""


class UpdatedCovarianceSecondDerivatives(NamedTuple):
    """Result of `updated_covariance_second_derivatives`."""

    updated_11: Real
    """Second derivative by Lambda of the variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Second derivative by Lambda of the covariance of updated position and velocity times
    T/sigma_v^2."""
    updated_22: Real
    """Second derivative by Lambda of the variance of the updated velocity times T^2/sigma_v^2."""


class ClosedLoopPoles(NamedTuple):
    """Result of `closed_loop_poles`."""

    first_real: Real
    """Real part of the first pole."""
    first_imaginary: Real
    """Imaginary part of the first pole, not negative."""
    second_real: Real
    """Real part of the second pole."""
    second_imaginary: Real
    """Imaginary part of the second pole, not positive."""


class IndexFromAlpha(NamedTuple):
    """Result of `index_from_alpha`."""

    tracking_index: Real
    """Tracking index Lambda."""


class BetaFromAlpha(NamedTuple):
    """Result of `beta_from_alpha`."""

    beta: Real
    """Velocity gain times the sampling interval."""


class IndexFromBeta(NamedTuple):
    """Result of `index_from_beta`."""

    tracking_index: Real
    """Tracking index Lambda."""


class AlphaFromBeta(NamedTuple):
    """Result of `alpha_from_beta`."""

    alpha: Real
    """Position gain."""
