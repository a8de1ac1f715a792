# Made by: gainproof generate random-velocity
# From: gainproof derive random-velocity, SymPy 1.14.0
"""Random velocity (velocity random walk): steady state with measured position."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from gainproof.generated._runtime import Domain, Signature, evaluate

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from gainproof.generated._runtime import Array, Real

__all__ = [
    "alpha_from_beta",
    "beta_from_alpha",
    "closed_loop_poles",
    "gain_derivatives",
    "gains",
    "gains_with_derivatives",
    "index_from_alpha",
    "index_from_beta",
    "predicted_covariance",
    "predicted_covariance_derivatives",
    "predictor_gain_derivatives",
    "predictor_gains",
    "updated_covariance",
    "updated_covariance_derivatives",
]


class Gains(NamedTuple):
    """Result of `gains`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times the sampling interval."""


def gains(tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None) -> Gains:
    """Steady-state filter gain.

        alpha = 2 s/m, beta = 2 p/m
        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 3.53 * 2^-52 (float64),
        3.53 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return Gains(*evaluate(_GAINS, (tracking_index,), out))


def _gains_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1 = work
    p = np.sqrt(tracking_index, out=beta)
    half_p = np.multiply(p, 0.5, out=alpha)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=w0)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.multiply(p, 0.25, out=w1)
    t14 = np.add(half_p, h, out=alpha)
    t15 = np.multiply(t13, t14, out=w1)
    s_half = np.sqrt(t15, out=w1)
    s = np.multiply(s_half, 2.0, out=w1)
    m = np.add(t14, s, out=alpha)
    t19 = np.divide(2.0, m, out=w0)
    np.multiply(s, t19, out=alpha)
    np.multiply(p, t19, out=beta)


_GAINS = Signature(
    "gains",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("alpha", "beta"),
    2,
    _gains_block,
)


class GainDerivatives(NamedTuple):
    """Result of `gain_derivatives`."""

    alpha: Real
    """Derivative of the position gain."""
    beta: Real
    """Derivative of the velocity gain times the sampling interval."""


def gain_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None
) -> GainDerivatives:
    """First derivatives of the filter gain with respect to the tracking index.

        d alpha = (1 + 1 p/(2 h))/(p s sigma^2), d beta = (2 + p/s)/(p h sigma^2)
        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 11.89 * 2^-52 (float64), 11.89 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 4.4794894843556084e102 (float64) and
        1e-45 <= tracking_index <= 5.541191e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 12.36
        * 2^-52 (float64), 12.36 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.46054178400843e102 (float64) and 1e-45 <= tracking_index <= 7.9917807e12 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return GainDerivatives(*evaluate(_GAIN_DERIVATIVES, (tracking_index,), out))


def _gain_derivatives_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3 = work
    p = np.sqrt(tracking_index, out=beta)
    half_p = np.multiply(p, 0.5, out=alpha)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=w0)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.multiply(p, 0.25, out=w1)
    t14 = np.add(half_p, h, out=alpha)
    t15 = np.multiply(t13, t14, out=w1)
    s_half = np.sqrt(t15, out=w1)
    s = np.multiply(s_half, 2.0, out=w1)
    m = np.add(t14, s, out=w2)
    t19 = np.divide(2.0, m, out=w2)
    t20 = np.divide(t19, p, out=w2)
    t21 = np.multiply(t20, t20, out=w2)
    t22 = np.multiply(p, s, out=w3)
    t23 = np.multiply(t22, h, out=w3)
    t25 = np.divide(1.0, t23, out=w3)
    t26 = np.multiply(t25, t14, out=alpha)
    np.multiply(t26, t21, out=alpha)
    t28 = np.multiply(s, 2.0, out=w1)
    t29 = np.add(t28, p, out=w1)
    t30 = np.multiply(t25, t29, out=w3)
    np.multiply(t30, t21, out=beta)


_GAIN_DERIVATIVES = Signature(
    "gain_derivatives",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("alpha", "beta"),
    4,
    _gain_derivatives_block,
)


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


def gains_with_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None
) -> GainsWithDerivatives:
    """Filter gain and its first derivatives in one pass.

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 3.53 * 2^-52 (float64),
        3.53 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).
    d_alpha: derivative of the position gain. Relative error at most 11.89 * 2^-52 (float64), 11.89
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 4.4794894843556084e102 (float64)
        and 1e-45 <= tracking_index <= 5.541191e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        12.36 * 2^-52 (float64), 12.36 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.46054178400843e102 (float64) and 1e-45 <= tracking_index <= 7.9917807e12 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return GainsWithDerivatives(*evaluate(_GAINS_WITH_DERIVATIVES, (tracking_index,), out))


def _gains_with_derivatives_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    alpha, beta, d_alpha, d_beta = out
    w0, w1, w2, w3 = work
    p = np.sqrt(tracking_index, out=d_beta)
    half_p = np.multiply(p, 0.5, out=alpha)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=beta)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=d_alpha)
    t8 = np.add(t5, t7, out=beta)
    h_scaled = np.sqrt(t8, out=beta)
    h = np.multiply(h_scaled, 1073741824.0, out=d_alpha)
    t13 = np.multiply(p, 0.25, out=beta)
    t14 = np.add(half_p, h, out=w0)
    t15 = np.multiply(t13, t14, out=beta)
    s_half = np.sqrt(t15, out=beta)
    s = np.multiply(s_half, 2.0, out=w1)
    m = np.add(t14, s, out=alpha)
    t19 = np.divide(2.0, m, out=w2)
    np.multiply(s, t19, out=alpha)
    np.multiply(p, t19, out=beta)
    t22 = np.divide(t19, p, out=w2)
    t23 = np.multiply(t22, t22, out=w2)
    t24 = np.multiply(p, s, out=w3)
    t25 = np.multiply(t24, h, out=w3)
    t27 = np.divide(1.0, t25, out=w3)
    t28 = np.multiply(t27, t14, out=w0)
    np.multiply(t28, t23, out=d_alpha)
    t30 = np.multiply(s, 2.0, out=w1)
    t31 = np.add(t30, p, out=w1)
    t32 = np.multiply(t27, t31, out=w3)
    np.multiply(t32, t23, out=d_beta)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("alpha", "beta", "d_alpha", "d_beta"),
    4,
    _gains_with_derivatives_block,
)


class PredictorGains(NamedTuple):
    """Result of `predictor_gains`."""

    position: Real
    """Position entry of F K, alpha + beta."""
    velocity: Real
    """Velocity entry of F K times the sampling interval, beta."""


def predictor_gains(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None
) -> PredictorGains:
    """Steady-state predictor gain F K.

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta. Relative error at most 3.77 * 2^-52 (float64),
        3.77 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta. Relative error at most 3.53 *
        2^-52 (float64), 3.53 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return PredictorGains(*evaluate(_PREDICTOR_GAINS, (tracking_index,), out))


def _predictor_gains_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1 = work
    p = np.sqrt(tracking_index, out=velocity)
    half_p = np.multiply(p, 0.5, out=position)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=w0)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.multiply(p, 0.25, out=w1)
    t14 = np.add(half_p, h, out=position)
    t15 = np.multiply(t13, t14, out=w1)
    s_half = np.sqrt(t15, out=w1)
    s = np.multiply(s_half, 2.0, out=w1)
    m = np.add(t14, s, out=position)
    t19 = np.add(s, p, out=w1)
    t20 = np.divide(2.0, m, out=w0)
    np.multiply(t19, t20, out=position)
    np.multiply(p, t20, out=velocity)


_PREDICTOR_GAINS = Signature(
    "predictor_gains",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("position", "velocity"),
    2,
    _predictor_gains_block,
)


class PredictorGainDerivatives(NamedTuple):
    """Result of `predictor_gain_derivatives`."""

    position: Real
    """Derivative of the position entry of F K, alpha + beta."""
    velocity: Real
    """Derivative of the velocity entry of F K times the sampling interval, beta."""


def predictor_gain_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None
) -> PredictorGainDerivatives:
    """First derivatives of the predictor gain.

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta. Relative error at most 13.19 *
        2^-52 (float64), 13.19 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        7.11074631974658e102 (float64) and 1e-45 <= tracking_index <= 8.796093e12 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta. Relative
        error at most 12.31 * 2^-52 (float64), 12.31 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 6.46054178400843e102 (float64) and 1e-45 <= tracking_index <= 7.9917807e12
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return PredictorGainDerivatives(*evaluate(_PREDICTOR_GAIN_DERIVATIVES, (tracking_index,), out))


def _predictor_gain_derivatives_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2, w3 = work
    p = np.sqrt(tracking_index, out=position)
    half_p = np.multiply(p, 0.5, out=velocity)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=w0)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.multiply(p, 0.25, out=w1)
    t14 = np.add(half_p, h, out=velocity)
    t15 = np.multiply(t13, t14, out=w1)
    s_half = np.sqrt(t15, out=w1)
    s = np.multiply(s_half, 2.0, out=w1)
    m = np.add(t14, s, out=w2)
    t19 = np.divide(2.0, m, out=w2)
    t20 = np.divide(t19, p, out=w2)
    t21 = np.multiply(t20, t20, out=w2)
    t22 = np.multiply(p, s, out=w3)
    t23 = np.multiply(t22, h, out=w3)
    t25 = np.divide(1.0, t23, out=w3)
    t26 = np.multiply(t25, t14, out=velocity)
    t27 = np.multiply(t26, t21, out=w0)
    t28 = np.multiply(s, 2.0, out=w1)
    t29 = np.add(t28, p, out=w1)
    t30 = np.multiply(t25, t29, out=w3)
    np.multiply(t30, t21, out=velocity)
    np.add(t27, velocity, out=position)


_PREDICTOR_GAIN_DERIVATIVES = Signature(
    "predictor_gain_derivatives",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("position", "velocity"),
    4,
    _predictor_gain_derivatives_block,
)


class PredictedCovariance(NamedTuple):
    """Result of `predicted_covariance`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity times T/sigma_v^2."""
    predicted_22: Real
    """Variance of the predicted velocity times T^2/sigma_v^2."""


def predicted_covariance(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
) -> PredictedCovariance:
    """Predicted covariance in units of sigma_v^2 and T.

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 6.30 *
        2^-52 (float64), 6.30 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.3407807929942502e154 (float64) and 1e-45 <= tracking_index <= 1.8446673e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 3.56 * 2^-52 (float64), 3.56 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.3407807929942502e154 (float64) and 1.1754944e-38 <= tracking_index <=
        1.8446673e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        4.26 * 2^-52 (float64), 3.76 * 2^-23 (float32), proved for 6.278939363646863e-206 <=
        tracking_index <= 9.480751908109109e153 (float64) and 4.1033358e-26 <= tracking_index <=
        1.3043767e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return PredictedCovariance(*evaluate(_PREDICTED_COVARIANCE, (tracking_index,), out))


def _predicted_covariance_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    (w0,) = work
    p = np.sqrt(tracking_index, out=predicted_11)
    half_p = np.multiply(p, 0.5, out=predicted_12)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=predicted_22)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w0)
    t8 = np.add(t5, t7, out=predicted_22)
    h_scaled = np.sqrt(t8, out=predicted_22)
    h = np.multiply(h_scaled, 1073741824.0, out=predicted_22)
    t13 = np.multiply(p, 0.25, out=w0)
    t14 = np.add(half_p, h, out=predicted_22)
    t15 = np.multiply(t13, t14, out=w0)
    s_half = np.sqrt(t15, out=w0)
    s = np.multiply(s_half, 2.0, out=w0)
    m = np.add(t14, s, out=predicted_22)
    t19 = np.multiply(p, s, out=predicted_11)
    t20 = np.multiply(tracking_index, t19, out=w0)
    t21 = np.multiply(half_p, m, out=predicted_12)
    np.multiply(t21, t19, out=predicted_11)
    np.multiply(tracking_index, t21, out=predicted_12)
    t24 = np.multiply(tracking_index, tracking_index, out=predicted_22)
    np.add(t20, t24, out=predicted_22)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("predicted_11", "predicted_12", "predicted_22"),
    1,
    _predicted_covariance_block,
)


class PredictedCovarianceDerivatives(NamedTuple):
    """Result of `predicted_covariance_derivatives`."""

    predicted_11: Real
    """Derivative of the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Derivative of the covariance of predicted position and velocity times T/sigma_v^2."""
    predicted_22: Real
    """Derivative of the variance of the predicted velocity times T^2/sigma_v^2."""


def predicted_covariance_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
) -> PredictedCovarianceDerivatives:
    """First derivatives of the predicted covariance.

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 7.26 * 2^-52 (float64), 7.26 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 8.988465674311453e307 (float64) and 1e-45 <= tracking_index <=
        1.7013988e38 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 4.29 * 2^-52 (float64), 4.29 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 8.988465674311453e307 (float64) and 1e-45 <= tracking_index <=
        1.7013988e38 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 3.76 * 2^-52 (float64), 3.76 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 4.4942328371557264e307 (float64) and 1e-45 <= tracking_index <=
        8.506994e37 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return PredictedCovarianceDerivatives(
        *evaluate(_PREDICTED_COVARIANCE_DERIVATIVES, (tracking_index,), out)
    )


def _predicted_covariance_derivatives_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4 = work
    p = np.sqrt(tracking_index, out=predicted_11)
    half_p = np.multiply(p, 0.5, out=predicted_12)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=predicted_22)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w0)
    t8 = np.add(t5, t7, out=predicted_22)
    h_scaled = np.sqrt(t8, out=predicted_22)
    h = np.multiply(h_scaled, 1073741824.0, out=predicted_22)
    t13 = np.multiply(p, 0.25, out=w0)
    t14 = np.add(half_p, h, out=w1)
    t15 = np.multiply(t13, t14, out=w0)
    s_half = np.sqrt(t15, out=w0)
    s = np.multiply(s_half, 2.0, out=w0)
    m = np.add(t14, s, out=w2)
    t19 = np.divide(s, p, out=w3)
    t20 = np.multiply(tracking_index, t19, out=w3)
    t21 = np.divide(t14, h, out=predicted_22)
    t22 = np.multiply(s, 2.0, out=w4)
    t23 = np.divide(t14, t22, out=w1)
    t24 = np.multiply(tracking_index, t23, out=w1)
    t25 = np.multiply(t21, t24, out=w1)
    t26 = np.add(t20, t25, out=w3)
    t27 = np.multiply(m, 0.5, out=w1)
    t28 = np.multiply(half_p, m, out=predicted_12)
    t29 = np.divide(t28, s, out=w0)
    t30 = np.multiply(t27, t29, out=w1)
    t31 = np.divide(p, t22, out=w4)
    np.multiply(t21, t30, out=predicted_11)
    t34 = np.multiply(t21, t31, out=predicted_22)
    t35 = np.add(1.0, t34, out=predicted_22)
    np.multiply(t28, t35, out=predicted_12)
    t37 = np.multiply(tracking_index, 2.0, out=w0)
    np.add(t26, t37, out=predicted_22)


_PREDICTED_COVARIANCE_DERIVATIVES = Signature(
    "predicted_covariance_derivatives",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("predicted_11", "predicted_12", "predicted_22"),
    5,
    _predicted_covariance_derivatives_block,
)


class UpdatedCovariance(NamedTuple):
    """Result of `updated_covariance`."""

    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity times T/sigma_v^2."""
    updated_22: Real
    """Variance of the updated velocity times T^2/sigma_v^2."""


def updated_covariance(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
) -> UpdatedCovariance:
    """Updated covariance in units of sigma_v^2 and T.

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 3.27 * 2^-52
        (float64), 3.26 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 3.54 * 2^-52 (float64), 3.53 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 3.28 *
        2^-52 (float64), 3.27 * 2^-23 (float32), proved for 6.278939363646863e-206 <= tracking_index
        <= 1.3407807929942502e154 (float64) and 4.1033358e-26 <= tracking_index <= 1.8446673e19
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return UpdatedCovariance(*evaluate(_UPDATED_COVARIANCE, (tracking_index,), out))


def _updated_covariance_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    (w0,) = work
    p = np.sqrt(tracking_index, out=updated_22)
    half_p = np.multiply(p, 0.5, out=updated_11)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=updated_12)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w0)
    t8 = np.add(t5, t7, out=updated_12)
    h_scaled = np.sqrt(t8, out=updated_12)
    h = np.multiply(h_scaled, 1073741824.0, out=updated_12)
    t13 = np.multiply(p, 0.25, out=w0)
    t14 = np.add(half_p, h, out=updated_11)
    t15 = np.multiply(t13, t14, out=w0)
    s_half = np.sqrt(t15, out=w0)
    s = np.multiply(s_half, 2.0, out=w0)
    m = np.add(t14, s, out=updated_11)
    t19 = np.divide(2.0, m, out=updated_12)
    np.multiply(s, t19, out=updated_11)
    np.multiply(p, t19, out=updated_12)
    t22 = np.multiply(p, s, out=updated_22)
    np.multiply(tracking_index, t22, out=updated_22)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("updated_11", "updated_12", "updated_22"),
    1,
    _updated_covariance_block,
)


class UpdatedCovarianceDerivatives(NamedTuple):
    """Result of `updated_covariance_derivatives`."""

    updated_11: Real
    """Derivative of the variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Derivative of the covariance of updated position and velocity times T/sigma_v^2."""
    updated_22: Real
    """Derivative of the variance of the updated velocity times T^2/sigma_v^2."""


def updated_covariance_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
) -> UpdatedCovarianceDerivatives:
    """First derivatives of the updated covariance.

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 11.89 * 2^-52 (float64), 11.89 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 4.4794894843556084e102 (float64) and 1e-45 <= tracking_index <= 5.541191e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 12.36 * 2^-52 (float64), 12.36 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 6.46054178400843e102 (float64) and 1e-45 <= tracking_index <=
        7.9917807e12 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 3.27 * 2^-52 (float64), 3.26 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 8.988465674311453e307 (float64) and 1e-45 <= tracking_index <=
        1.7013988e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return UpdatedCovarianceDerivatives(
        *evaluate(_UPDATED_COVARIANCE_DERIVATIVES, (tracking_index,), out)
    )


def _updated_covariance_derivatives_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5 = work
    p = np.sqrt(tracking_index, out=updated_22)
    half_p = np.multiply(p, 0.5, out=updated_11)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=updated_12)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w0)
    t8 = np.add(t5, t7, out=updated_12)
    h_scaled = np.sqrt(t8, out=updated_12)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.multiply(p, 0.25, out=updated_12)
    t14 = np.add(half_p, h, out=w1)
    t15 = np.multiply(t13, t14, out=updated_12)
    s_half = np.sqrt(t15, out=updated_12)
    s = np.multiply(s_half, 2.0, out=w2)
    m = np.add(t14, s, out=updated_11)
    t19 = np.divide(2.0, m, out=updated_11)
    t20 = np.divide(t19, p, out=updated_11)
    t21 = np.multiply(t20, t20, out=updated_12)
    t22 = np.multiply(p, s, out=updated_11)
    t23 = np.multiply(t22, h, out=updated_11)
    t25 = np.divide(1.0, t23, out=w3)
    t26 = np.multiply(t25, t14, out=updated_11)
    np.multiply(t26, t21, out=updated_11)
    t28 = np.multiply(s, 2.0, out=w4)
    t29 = np.add(t28, p, out=w5)
    t30 = np.multiply(t25, t29, out=w3)
    np.multiply(t30, t21, out=updated_12)
    t32 = np.divide(s, p, out=w2)
    t33 = np.multiply(tracking_index, t32, out=w2)
    t34 = np.divide(t14, h, out=w0)
    t35 = np.divide(t14, t28, out=w1)
    t36 = np.multiply(tracking_index, t35, out=w1)
    t37 = np.multiply(t34, t36, out=w0)
    np.add(t33, t37, out=updated_22)


_UPDATED_COVARIANCE_DERIVATIVES = Signature(
    "updated_covariance_derivatives",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("updated_11", "updated_12", "updated_22"),
    6,
    _updated_covariance_derivatives_block,
)


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


def closed_loop_poles(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None
) -> ClosedLoopPoles:
    """Poles of the filter: a complex pair or two real numbers.

        z^2 - (2 - alpha - beta) z + (1 - alpha) = 0
        all poles lie inside the unit circle; rounded, a real part may come as 1 + 2^-52
        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/4 Lambda), s = sqrt(p (2 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    first_real: real part of the first pole. Error over first_modulus at most 6.57 * 2^-52
        (float64), 6.57 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32).
    first_imaginary: imaginary part of the first pole, not negative. Error over first_modulus at
        most 4.45 * 2^-52 (float64), 4.42 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32).
    second_real: real part of the second pole. Error over second_modulus at most 6.57 * 2^-52
        (float64), 6.57 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32).
    second_imaginary: imaginary part of the second pole, not positive. Error over second_modulus at
        most 4.45 * 2^-52 (float64), 4.42 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return ClosedLoopPoles(*evaluate(_CLOSED_LOOP_POLES, (tracking_index,), out))


def _closed_loop_poles_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    first_real, first_imaginary, second_real, second_imaginary = out
    w0, w1 = work
    p = np.sqrt(tracking_index, out=first_real)
    half_p = np.multiply(p, 0.5, out=first_imaginary)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=second_imaginary)
    t7 = np.multiply(tracking_index, 2.168404344971009e-19, out=w0)
    t8 = np.add(t5, t7, out=second_imaginary)
    h_scaled = np.sqrt(t8, out=second_imaginary)
    h = np.multiply(h_scaled, 1073741824.0, out=second_imaginary)
    t13 = np.multiply(p, 0.25, out=w0)
    t14 = np.add(half_p, h, out=second_imaginary)
    t15 = np.multiply(t13, t14, out=w0)
    s_half = np.sqrt(t15, out=w0)
    s = np.multiply(s_half, 2.0, out=w0)
    m = np.add(t14, s, out=w1)
    t19 = np.divide(2.0, m, out=w1)
    t20 = np.divide(t19, p, out=first_real)
    t21 = np.multiply(half_p, t14, out=first_imaginary)
    np.divide(t20, t21, out=first_real)
    np.divide(t19, s, out=first_imaginary)
    np.negative(first_imaginary, out=second_imaginary)
    np.copyto(second_real, first_real)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (
        Domain(
            "tracking_index",
            "a number above 0 and finite",
            (5e-324, 1.7976931348623157e308),
            (1.401298464324817e-45, 3.4028234663852886e38),
        ),
    ),
    ("first_real", "first_imaginary", "second_real", "second_imaginary"),
    2,
    _closed_loop_poles_block,
)


class IndexFromAlpha(NamedTuple):
    """Result of `index_from_alpha`."""

    tracking_index: Real
    """Tracking index Lambda."""


def index_from_alpha(alpha: ArrayLike, *, out: tuple[Real] | None = None) -> IndexFromAlpha:
    """The tracking index that belongs to a position gain.

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    tracking_index: tracking index Lambda. Relative error at most 3.54 * 2^-52 (float64), 3.54 *
        2^-23 (float32), proved for 2.1095373229726e-154 <= alpha <= 0.9999999999999999 (float64)
        and 1.5332935e-19 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return IndexFromAlpha(*evaluate(_INDEX_FROM_ALPHA, (alpha,), out))


def _index_from_alpha_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (alpha,) = given
    (tracking_index,) = out
    w0, w1, w2 = work
    t2 = np.subtract(1.0, alpha, out=tracking_index)
    t4 = np.multiply(t2, 4.0, out=w0)
    t5 = np.multiply(alpha, alpha, out=w1)
    t6 = np.add(t4, t5, out=w0)
    alpha_radical = np.sqrt(t6, out=w0)
    root_of_rest = np.sqrt(t2, out=tracking_index)
    t10 = np.multiply(t5, 2.0, out=w1)
    t11 = np.subtract(2.0, alpha, out=w2)
    t12 = np.add(t11, alpha_radical, out=w2)
    t13 = np.divide(t10, t12, out=w1)
    np.divide(t13, root_of_rest, out=tracking_index)


_INDEX_FROM_ALPHA = Signature(
    "index_from_alpha",
    (
        Domain(
            "alpha",
            "a number above 0 and below 1",
            (5e-324, 0.9999999999999999),
            (1.401298464324817e-45, 0.9999999403953552),
        ),
    ),
    ("tracking_index",),
    3,
    _index_from_alpha_block,
)


class BetaFromAlpha(NamedTuple):
    """Result of `beta_from_alpha`."""

    beta: Real
    """Velocity gain times the sampling interval."""


def beta_from_alpha(alpha: ArrayLike, *, out: tuple[Real] | None = None) -> BetaFromAlpha:
    """The velocity gain that belongs to a position gain.

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    beta: velocity gain times the sampling interval. Relative error at most 2.27 * 2^-52 (float64),
        2.27 * 2^-23 (float32), proved for 2.1095373229726e-154 <= alpha <= 0.9999999999999999
        (float64) and 1.5332935e-19 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return BetaFromAlpha(*evaluate(_BETA_FROM_ALPHA, (alpha,), out))


def _beta_from_alpha_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (alpha,) = given
    (beta,) = out
    w0, w1 = work
    t2 = np.subtract(1.0, alpha, out=beta)
    t4 = np.multiply(t2, 4.0, out=beta)
    t5 = np.multiply(alpha, alpha, out=w0)
    t6 = np.add(t4, t5, out=beta)
    alpha_radical = np.sqrt(t6, out=beta)
    t9 = np.multiply(t5, 2.0, out=w0)
    t10 = np.subtract(2.0, alpha, out=w1)
    t11 = np.add(t10, alpha_radical, out=w1)
    np.divide(t9, t11, out=beta)


_BETA_FROM_ALPHA = Signature(
    "beta_from_alpha",
    (
        Domain(
            "alpha",
            "a number above 0 and below 1",
            (5e-324, 0.9999999999999999),
            (1.401298464324817e-45, 0.9999999403953552),
        ),
    ),
    ("beta",),
    2,
    _beta_from_alpha_block,
)


class IndexFromBeta(NamedTuple):
    """Result of `index_from_beta`."""

    tracking_index: Real
    """Tracking index Lambda."""


def index_from_beta(beta: ArrayLike, *, out: tuple[Real] | None = None) -> IndexFromBeta:
    """The tracking index that belongs to a velocity gain.

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.

    tracking_index: tracking index Lambda. Relative error at most 2.13 * 2^-52 (float64), 2.13 *
        2^-23 (float32), proved for 2.2250738585072014e-308 <= beta <= 0.9999999999999999 (float64)
        and 1.1754944e-38 <= beta <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return IndexFromBeta(*evaluate(_INDEX_FROM_BETA, (beta,), out))


def _index_from_beta_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (beta,) = given
    (tracking_index,) = out
    w0, w1 = work
    t2 = np.add(8.0, beta, out=tracking_index)
    t3 = np.multiply(beta, t2, out=tracking_index)
    beta_radical = np.sqrt(t3, out=tracking_index)
    t6 = np.subtract(1.0, beta, out=w0)
    t8 = np.multiply(t6, 4.0, out=w0)
    t10 = np.add(2.0, beta, out=w1)
    t11 = np.add(t10, beta_radical, out=w1)
    t12 = np.multiply(t11, 2.0, out=w1)
    t13 = np.divide(t8, t12, out=w0)
    root_of_rest = np.sqrt(t13, out=w0)
    np.divide(beta, root_of_rest, out=tracking_index)


_INDEX_FROM_BETA = Signature(
    "index_from_beta",
    (
        Domain(
            "beta",
            "a number above 0 and below 1",
            (5e-324, 0.9999999999999999),
            (1.401298464324817e-45, 0.9999999403953552),
        ),
    ),
    ("tracking_index",),
    2,
    _index_from_beta_block,
)


class AlphaFromBeta(NamedTuple):
    """Result of `alpha_from_beta`."""

    alpha: Real
    """Position gain."""


def alpha_from_beta(beta: ArrayLike, *, out: tuple[Real] | None = None) -> AlphaFromBeta:
    """The position gain that belongs to a velocity gain.

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.

    alpha: position gain. Relative error at most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32),
        proved for 5e-324 <= beta <= 0.9999999999999999 (float64) and 1e-45 <= beta <= 0.99999994
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-velocity
    """
    return AlphaFromBeta(*evaluate(_ALPHA_FROM_BETA, (beta,), out))


def _alpha_from_beta_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (beta,) = given
    (alpha,) = out
    w0, w1 = work
    t2 = np.multiply(beta, 1.152921504606847e18, out=alpha)
    t4 = np.add(8.0, beta, out=w0)
    t5 = np.multiply(t2, t4, out=w0)
    scaled_beta_radical = np.sqrt(t5, out=w0)
    t7 = np.multiply(t2, 8.0, out=alpha)
    t9 = np.multiply(beta, 1073741824.0, out=w1)
    t10 = np.add(scaled_beta_radical, t9, out=w0)
    t12 = np.multiply(t10, 2147483648.0, out=w0)
    np.divide(t7, t12, out=alpha)


_ALPHA_FROM_BETA = Signature(
    "alpha_from_beta",
    (
        Domain(
            "beta",
            "a number above 0 and below 1",
            (5e-324, 0.9999999999999999),
            (1.401298464324817e-45, 0.9999999403953552),
        ),
    ),
    ("alpha",),
    2,
    _alpha_from_beta_block,
)
