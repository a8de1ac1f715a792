# Made by: gainproof generate continuous-white-acceleration
# From: gainproof derive continuous-white-acceleration, SymPy 1.14.0
"""Continuous white acceleration: steady state with measured position."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from gainproof.generated._runtime import Domain, Signature, choose, evaluate, mask_of

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
        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 4.26 * 2^-52 (float64), 4.26 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 3.54 * 2^-52 (float64),
        3.54 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return Gains(*evaluate(_GAINS, (tracking_index,), out))


def _gains_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2 = work
    p = np.sqrt(tracking_index, out=beta)
    half_p = np.multiply(p, 0.5, out=alpha)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=w0)
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.divide(p, 3.0, out=w1)
    t14 = np.multiply(h, 3.0, out=w2)
    t15 = np.add(p, t14, out=w2)
    t16 = np.multiply(t13, t15, out=w1)
    s = np.sqrt(t16, out=w1)
    t18 = np.add(half_p, h, out=alpha)
    m = np.add(t18, s, out=alpha)
    t20 = np.divide(2.0, m, out=w0)
    np.multiply(s, t20, out=alpha)
    np.multiply(p, t20, out=beta)


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
    3,
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

        d alpha = (1 + 1/3 p/(2 h))/(p s sigma^2), d beta = (2 + p/s)/(p h sigma^2)
        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 13.79 * 2^-52 (float64), 13.79 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.247628584236248e102 (float64) and
        1e-45 <= tracking_index <= 6.49139e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 13.04
        * 2^-52 (float64), 13.07 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        9.352083952218625e102 (float64) and 1e-45 <= tracking_index <= 1.1568659e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
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
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.divide(p, 3.0, out=w1)
    t14 = np.multiply(h, 3.0, out=w2)
    t15 = np.add(p, t14, out=w2)
    t16 = np.multiply(t13, t15, out=w1)
    s = np.sqrt(t16, out=w1)
    t18 = np.add(half_p, h, out=alpha)
    m = np.add(t18, s, out=alpha)
    t20 = np.divide(2.0, m, out=alpha)
    t21 = np.divide(t20, p, out=alpha)
    t22 = np.multiply(t21, t21, out=w2)
    t23 = np.multiply(p, s, out=alpha)
    t24 = np.multiply(t23, h, out=alpha)
    t26 = np.divide(1.0, t24, out=w3)
    t28 = np.divide(p, 6.0, out=alpha)
    t29 = np.add(h, t28, out=w0)
    t30 = np.multiply(t26, t29, out=w0)
    np.multiply(t30, t22, out=alpha)
    t32 = np.multiply(s, 2.0, out=w1)
    t33 = np.add(t32, p, out=w1)
    t34 = np.multiply(t26, t33, out=w3)
    np.multiply(t34, t22, out=beta)


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

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 4.26 * 2^-52 (float64), 4.26 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 3.54 * 2^-52 (float64),
        3.54 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).
    d_alpha: derivative of the position gain. Relative error at most 13.77 * 2^-52 (float64), 13.77
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.247628584236248e102 (float64)
        and 1e-45 <= tracking_index <= 6.49139e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        13.04 * 2^-52 (float64), 13.04 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        9.352083952218625e102 (float64) and 1e-45 <= tracking_index <= 1.1568659e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
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
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=d_alpha)
    t8 = np.add(t5, t7, out=beta)
    h_scaled = np.sqrt(t8, out=beta)
    h = np.multiply(h_scaled, 1073741824.0, out=d_alpha)
    t13 = np.divide(p, 3.0, out=beta)
    t14 = np.multiply(h, 3.0, out=w0)
    t15 = np.add(p, t14, out=w0)
    t16 = np.multiply(t13, t15, out=beta)
    s = np.sqrt(t16, out=w0)
    t18 = np.add(half_p, h, out=alpha)
    m = np.add(t18, s, out=alpha)
    t20 = np.divide(2.0, m, out=w1)
    np.multiply(s, t20, out=alpha)
    np.multiply(p, t20, out=beta)
    t23 = np.divide(t20, p, out=w1)
    t24 = np.multiply(t23, t23, out=w1)
    t25 = np.multiply(p, s, out=w2)
    t26 = np.multiply(t25, h, out=w2)
    t28 = np.divide(1.0, t26, out=w2)
    t30 = np.divide(p, 6.0, out=w3)
    t31 = np.add(h, t30, out=d_alpha)
    t32 = np.multiply(t28, t31, out=d_alpha)
    np.multiply(t32, t24, out=d_alpha)
    t34 = np.multiply(s, 2.0, out=w0)
    t35 = np.add(t34, p, out=w0)
    t36 = np.multiply(t28, t35, out=w2)
    np.multiply(t36, t24, out=d_beta)


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

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta. Relative error at most 4.76 * 2^-52 (float64),
        4.76 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta. Relative error at most 3.54 *
        2^-52 (float64), 3.54 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return PredictorGains(*evaluate(_PREDICTOR_GAINS, (tracking_index,), out))


def _predictor_gains_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2 = work
    p = np.sqrt(tracking_index, out=velocity)
    half_p = np.multiply(p, 0.5, out=position)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=w0)
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.divide(p, 3.0, out=w1)
    t14 = np.multiply(h, 3.0, out=w2)
    t15 = np.add(p, t14, out=w2)
    t16 = np.multiply(t13, t15, out=w1)
    s = np.sqrt(t16, out=w1)
    t18 = np.add(half_p, h, out=position)
    m = np.add(t18, s, out=position)
    t20 = np.add(s, p, out=w1)
    t21 = np.divide(2.0, m, out=w0)
    np.multiply(t20, t21, out=position)
    np.multiply(p, t21, out=velocity)


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
    3,
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

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta. Relative error at most 14.56 *
        2^-52 (float64), 14.56 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        9.873247422805948e102 (float64) and 1e-45 <= tracking_index <= 1.2213346e13 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta. Relative
        error at most 12.98 * 2^-52 (float64), 12.98 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 9.352083952218625e102 (float64) and 1e-45 <= tracking_index <=
        1.1568659e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
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
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w1)
    t8 = np.add(t5, t7, out=w0)
    h_scaled = np.sqrt(t8, out=w0)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.divide(p, 3.0, out=w1)
    t14 = np.multiply(h, 3.0, out=w2)
    t15 = np.add(p, t14, out=w2)
    t16 = np.multiply(t13, t15, out=w1)
    s = np.sqrt(t16, out=w1)
    t18 = np.add(half_p, h, out=velocity)
    m = np.add(t18, s, out=velocity)
    t20 = np.divide(2.0, m, out=velocity)
    t21 = np.divide(t20, p, out=velocity)
    t22 = np.multiply(t21, t21, out=velocity)
    t23 = np.multiply(p, s, out=w2)
    t24 = np.multiply(t23, h, out=w2)
    t26 = np.divide(1.0, t24, out=w2)
    t28 = np.divide(p, 6.0, out=w3)
    t29 = np.add(h, t28, out=w0)
    t30 = np.multiply(t26, t29, out=w0)
    t31 = np.multiply(t30, t22, out=w0)
    t32 = np.multiply(s, 2.0, out=w1)
    t33 = np.add(t32, p, out=w1)
    t34 = np.multiply(t26, t33, out=w2)
    np.multiply(t34, t22, out=velocity)
    np.add(t31, velocity, out=position)


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

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 6.93 *
        2^-52 (float64), 6.94 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7000419237042198e154 (float64) and 1e-45 <= tracking_index <= 2.3389442e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 3.72 * 2^-52 (float64), 3.72 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.5097627491058368e154 (float64) and 1.1754944e-38 <= tracking_index <=
        2.0771551e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        7.01 * 2^-52 (float64), 6.52 * 2^-23 (float32), proved for 6.278939363646863e-206 <=
        tracking_index <= 1.181098330382244e154 (float64) and 4.1033358e-26 <= tracking_index <=
        1.6249736e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return PredictedCovariance(*evaluate(_PREDICTED_COVARIANCE, (tracking_index,), out))


def _predicted_covariance_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2 = work
    p = np.sqrt(tracking_index, out=predicted_11)
    half_p = np.multiply(p, 0.5, out=predicted_12)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=predicted_22)
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w0)
    t8 = np.add(t5, t7, out=predicted_22)
    h_scaled = np.sqrt(t8, out=predicted_22)
    h = np.multiply(h_scaled, 1073741824.0, out=predicted_22)
    t13 = np.divide(p, 3.0, out=w0)
    t14 = np.multiply(h, 3.0, out=w1)
    t15 = np.add(p, t14, out=w1)
    t16 = np.multiply(t13, t15, out=w0)
    s = np.sqrt(t16, out=w0)
    t18 = np.add(half_p, h, out=w1)
    m = np.add(t18, s, out=w1)
    t21 = np.divide(p, 6.0, out=w2)
    t22 = np.add(h, t21, out=w2)
    t23 = np.add(t22, h, out=w2)
    t24 = np.multiply(p, t23, out=w2)
    t25 = np.multiply(s, 2.0, out=predicted_22)
    t26 = np.add(t25, p, out=predicted_22)
    t27 = np.divide(p, t26, out=predicted_22)
    t28 = np.multiply(t27, t24, out=predicted_22)
    t29 = np.multiply(tracking_index, t28, out=predicted_22)
    t30 = np.multiply(half_p, m, out=predicted_12)
    t31 = np.multiply(p, s, out=predicted_11)
    np.multiply(t30, t31, out=predicted_11)
    np.multiply(tracking_index, t30, out=predicted_12)
    t34 = np.multiply(tracking_index, tracking_index, out=w0)
    np.add(t29, t34, out=predicted_22)


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
    3,
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

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 8.26 * 2^-52 (float64), 8.26 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.4450712711759723e308 (float64) and 1e-45 <= tracking_index <=
        2.7353304e38 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 4.39 * 2^-52 (float64), 4.39 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.1396917792938073e308 (float64) and 1e-45 <= tracking_index <=
        2.157287e38 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 6.09 * 2^-52 (float64), 6.11 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 6.974966330158624e307 (float64) and 1e-45 <= tracking_index <=
        1.3202697e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return PredictedCovarianceDerivatives(
        *evaluate(_PREDICTED_COVARIANCE_DERIVATIVES, (tracking_index,), out)
    )


def _predicted_covariance_derivatives_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = np.sqrt(tracking_index, out=predicted_11)
    half_p = np.multiply(p, 0.5, out=predicted_12)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=predicted_22)
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w0)
    t8 = np.add(t5, t7, out=predicted_22)
    h_scaled = np.sqrt(t8, out=predicted_22)
    h = np.multiply(h_scaled, 1073741824.0, out=predicted_22)
    t13 = np.divide(p, 3.0, out=w0)
    t14 = np.multiply(h, 3.0, out=w1)
    t15 = np.add(p, t14, out=w1)
    t16 = np.multiply(t13, t15, out=w0)
    s = np.sqrt(t16, out=w0)
    t18 = np.add(half_p, h, out=w1)
    m = np.add(t18, s, out=w1)
    t21 = np.divide(4.0, m, out=w2)
    t22 = np.divide(t21, s, out=w2)
    t24 = np.divide(p, 6.0, out=w3)
    t25 = np.add(h, t24, out=w3)
    t26 = np.divide(t25, h, out=w4)
    t27 = np.multiply(s, 2.0, out=w5)
    t28 = np.divide(t25, t27, out=w3)
    t29 = np.multiply(t26, t28, out=w3)
    t30 = np.divide(p, h, out=predicted_22)
    t31 = np.divide(p, s, out=w6)
    t32 = np.multiply(t30, t31, out=predicted_22)
    t34 = np.divide(t32, 36.0, out=predicted_22)
    t35 = np.add(t29, t34, out=w3)
    t36 = np.multiply(tracking_index, t35, out=w3)
    t37 = np.add(t22, t36, out=w2)
    t38 = np.multiply(m, 0.5, out=w3)
    t39 = np.multiply(half_p, m, out=predicted_12)
    t40 = np.divide(t39, s, out=w0)
    t41 = np.multiply(t38, t40, out=w3)
    t42 = np.divide(p, t27, out=w5)
    np.multiply(t26, t41, out=predicted_11)
    t45 = np.multiply(t26, t42, out=w4)
    t46 = np.add(1.0, t45, out=w4)
    np.multiply(t39, t46, out=predicted_12)
    t48 = np.multiply(tracking_index, 2.0, out=w0)
    np.add(t37, t48, out=predicted_22)


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
    7,
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

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 4.26 * 2^-52
        (float64), 4.26 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 3.54 * 2^-52 (float64), 3.54 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 6.01 *
        2^-52 (float64), 6.04 * 2^-23 (float32), proved for 6.278939363646863e-206 <= tracking_index
        <= 2.4954742419024312e154 (float64) and 4.1033358e-26 <= tracking_index <= 3.4333126e19
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return UpdatedCovariance(*evaluate(_UPDATED_COVARIANCE, (tracking_index,), out))


def _updated_covariance_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2 = work
    p = np.sqrt(tracking_index, out=updated_22)
    half_p = np.multiply(p, 0.5, out=updated_11)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=updated_12)
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w0)
    t8 = np.add(t5, t7, out=updated_12)
    h_scaled = np.sqrt(t8, out=updated_12)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.divide(p, 3.0, out=updated_12)
    t14 = np.multiply(h, 3.0, out=w1)
    t15 = np.add(p, t14, out=w1)
    t16 = np.multiply(t13, t15, out=updated_12)
    s = np.sqrt(t16, out=w1)
    t18 = np.add(half_p, h, out=updated_11)
    m = np.add(t18, s, out=updated_11)
    t20 = np.divide(2.0, m, out=updated_12)
    np.multiply(s, t20, out=updated_11)
    np.multiply(p, t20, out=updated_12)
    t24 = np.divide(p, 6.0, out=w2)
    t25 = np.add(h, t24, out=w2)
    t26 = np.add(t25, h, out=w2)
    t27 = np.multiply(p, t26, out=w2)
    t28 = np.multiply(s, 2.0, out=w1)
    t29 = np.add(t28, p, out=w1)
    t30 = np.divide(p, t29, out=updated_22)
    t31 = np.multiply(t30, t27, out=updated_22)
    np.multiply(tracking_index, t31, out=updated_22)


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
    3,
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

        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 13.79 * 2^-52 (float64), 13.79 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 5.247628584236248e102 (float64) and 1e-45 <= tracking_index <= 6.49139e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 12.98 * 2^-52 (float64), 12.98 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 9.352083952218625e102 (float64) and 1e-45 <= tracking_index <=
        1.1568659e13 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 5.96 * 2^-52 (float64), 5.98 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return UpdatedCovarianceDerivatives(
        *evaluate(_UPDATED_COVARIANCE_DERIVATIVES, (tracking_index,), out)
    )


def _updated_covariance_derivatives_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = np.sqrt(tracking_index, out=updated_22)
    half_p = np.multiply(p, 0.5, out=updated_11)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=updated_12)
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=w0)
    t8 = np.add(t5, t7, out=updated_12)
    h_scaled = np.sqrt(t8, out=updated_12)
    h = np.multiply(h_scaled, 1073741824.0, out=w0)
    t13 = np.divide(p, 3.0, out=updated_12)
    t14 = np.multiply(h, 3.0, out=w1)
    t15 = np.add(p, t14, out=w1)
    t16 = np.multiply(t13, t15, out=updated_12)
    s = np.sqrt(t16, out=w1)
    t18 = np.add(half_p, h, out=updated_11)
    m = np.add(t18, s, out=w2)
    t20 = np.divide(2.0, m, out=updated_11)
    t21 = np.divide(t20, p, out=updated_11)
    t22 = np.multiply(t21, t21, out=updated_12)
    t23 = np.multiply(p, s, out=updated_11)
    t24 = np.multiply(t23, h, out=updated_11)
    t26 = np.divide(1.0, t24, out=w3)
    t28 = np.divide(p, 6.0, out=updated_11)
    t29 = np.add(h, t28, out=w4)
    t30 = np.multiply(t26, t29, out=updated_11)
    np.multiply(t30, t22, out=updated_11)
    t32 = np.multiply(s, 2.0, out=w5)
    t33 = np.add(t32, p, out=w6)
    t34 = np.multiply(t26, t33, out=w3)
    np.multiply(t34, t22, out=updated_12)
    t37 = np.divide(4.0, m, out=w2)
    t38 = np.divide(t37, s, out=w2)
    t39 = np.divide(t29, h, out=w3)
    t40 = np.divide(t29, t32, out=w4)
    t41 = np.multiply(t39, t40, out=w3)
    t42 = np.divide(p, h, out=w0)
    t43 = np.divide(p, s, out=updated_22)
    t44 = np.multiply(t42, t43, out=w0)
    t46 = np.divide(t44, 36.0, out=w0)
    t47 = np.add(t41, t46, out=w3)
    t48 = np.multiply(tracking_index, t47, out=w3)
    np.add(t38, t48, out=updated_22)


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
    7,
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
        p = sqrt(Lambda), h = sqrt(4/Lambda + 1/12 Lambda), s = sqrt(p (4/3 p + 4 h))/2,
        m = p/2 + h + s, sigma = p m/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    first_real: real part of the first pole. Error over first_modulus at most 8.34 * 2^-52
        (float64), 8.33 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    first_imaginary: imaginary part of the first pole, not negative. Error over first_modulus at
        most 8.00 * 2^-52 (float64), 8.00 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    second_real: real part of the second pole. Error over second_modulus at most 10.51 * 2^-52
        (float64), 10.48 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6421143998800672e154 (float64) and 1e-45 <= tracking_index <= 2.2592554e19 (float32).
    second_imaginary: imaginary part of the second pole, not positive. Error over second_modulus at
        most 8.00 * 2^-52 (float64), 8.00 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6421143998800672e154 (float64) and 1e-45 <= tracking_index <= 2.2592554e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return ClosedLoopPoles(*evaluate(_CLOSED_LOOP_POLES, (tracking_index,), out))


def _closed_loop_poles_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], single: bool
) -> None:
    (tracking_index,) = given
    first_real, first_imaginary, second_real, second_imaginary = out
    w0, w1, w2, w3 = work
    p = np.sqrt(tracking_index, out=first_real)
    half_p = np.multiply(p, 0.5, out=first_imaginary)
    t5 = np.divide(3.469446951953614e-18, tracking_index, out=second_real)
    t7 = np.multiply(tracking_index, 7.228014483236696e-20, out=second_imaginary)
    t8 = np.add(t5, t7, out=second_real)
    h_scaled = np.sqrt(t8, out=second_real)
    h = np.multiply(h_scaled, 1073741824.0, out=second_real)
    t13 = np.divide(p, 3.0, out=second_imaginary)
    t14 = np.multiply(h, 3.0, out=w0)
    t15 = np.add(p, t14, out=w0)
    t16 = np.multiply(t13, t15, out=second_imaginary)
    s = np.sqrt(t16, out=second_imaginary)
    t18 = np.add(half_p, h, out=first_imaginary)
    m = np.add(t18, s, out=w0)
    t20 = np.divide(2.0, m, out=second_real)
    t21 = np.divide(t20, p, out=second_real)
    t25 = np.multiply(tracking_index, 0.25, out=first_real)
    t26 = np.subtract(3.0, t25, out=w1)
    distance = np.absolute(t26, out=w1)
    below = np.sqrt(distance, out=w1)
    t29 = np.add(3.0, t25, out=first_real)
    above = np.sqrt(t29, out=first_real)
    t32 = np.multiply(tracking_index, 0.5, out=w2)
    rest = -8.914125970704845e-08 if single else 2.168616518103246e-16
    np.subtract(2.449489742783178, t32, out=w3)
    t33 = np.add(w3, rest, out=w3)
    t34 = np.divide(t33, t18, out=w3)
    t35 = np.add(2.449489742783178, t32, out=w2)
    t36 = np.divide(t35, m, out=w2)
    t37 = np.divide(t36, tracking_index, out=w2)
    t38 = np.multiply(t34, t37, out=w3)
    t39 = np.multiply(t38, 0.6666666666666666, out=w3)
    t40 = np.divide(below, s, out=w1)
    t41 = np.divide(above, m, out=first_real)
    t42 = np.multiply(t40, t41, out=w1)
    t43 = np.multiply(t42, 0.6666666666666666, out=w1)
    middle_size = np.absolute(t39, out=w0)
    t45 = np.add(middle_size, t43, out=w0)
    t46 = np.divide(t21, t45, out=w2)
    t47 = np.multiply(t46, t21, out=w2)
    t49 = np.negative(t45, out=w0)
    mask = mask_of(np.less(tracking_index, 12.0), single)
    choose(mask, t39, t49, out=first_real)
    t51 = np.negative(t47, out=w2)
    choose(mask, t39, t51, out=second_real)
    choose(mask, t43, 0.0, out=first_imaginary)
    t54 = np.negative(t43, out=w1)
    choose(mask, t54, 0.0, out=second_imaginary)


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
    4,
    _closed_loop_poles_block,
)


class IndexFromAlpha(NamedTuple):
    """Result of `index_from_alpha`."""

    tracking_index: Real
    """Tracking index Lambda."""


def index_from_alpha(alpha: ArrayLike, *, out: tuple[Real] | None = None) -> IndexFromAlpha:
    """The tracking index that belongs to a position gain.

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    tracking_index: tracking index Lambda. Relative error at most 3.53 * 2^-52 (float64), 3.53 *
        2^-23 (float32), proved for 2.1095373229726e-154 <= alpha <= 0.9999999999999999 (float64)
        and 1.5332935e-19 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
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
    t7 = np.divide(t5, 3.0, out=w2)
    t8 = np.add(t4, t7, out=w0)
    alpha_radical = np.sqrt(t8, out=w0)
    root_of_rest = np.sqrt(t2, out=tracking_index)
    t12 = np.multiply(t5, 2.0, out=w1)
    t13 = np.subtract(2.0, alpha, out=w2)
    t14 = np.add(t13, alpha_radical, out=w2)
    t15 = np.divide(t12, t14, out=w1)
    np.divide(t15, root_of_rest, out=tracking_index)


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

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    beta: velocity gain times the sampling interval. Relative error at most 2.28 * 2^-52 (float64),
        2.28 * 2^-23 (float32), proved for 2.1095373229726e-154 <= alpha <= 0.9999999999999999
        (float64) and 1.5332935e-19 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
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
    t7 = np.divide(t5, 3.0, out=w1)
    t8 = np.add(t4, t7, out=beta)
    alpha_radical = np.sqrt(t8, out=beta)
    t11 = np.multiply(t5, 2.0, out=w0)
    t12 = np.subtract(2.0, alpha, out=w1)
    t13 = np.add(t12, alpha_radical, out=w1)
    np.divide(t11, t13, out=beta)


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

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.2679491924311228.

    tracking_index: tracking index Lambda. Relative error at most 3.51 * 2^-52 (float64), 3.51 *
        2^-23 (float32), proved for 2.2250738585072014e-308 <= beta <= 1.2679491924311226 (float64)
        and 1.1754944e-38 <= beta <= 1.2679491 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return IndexFromBeta(*evaluate(_INDEX_FROM_BETA, (beta,), out))


def _index_from_beta_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], single: bool
) -> None:
    (beta,) = given
    (tracking_index,) = out
    w0, w1 = work
    t2 = np.divide(beta, 3.0, out=tracking_index)
    t4 = np.add(8.0, t2, out=tracking_index)
    t5 = np.multiply(beta, t4, out=tracking_index)
    beta_radical = np.sqrt(t5, out=tracking_index)
    rest = -3.1087250107475484e-08 if single else -1.0035084221806903e-16
    np.subtract(1.2679491924311228, beta, out=w0)
    t10 = np.add(w0, rest, out=w0)
    rest_ = -8.812204299601945e-08 if single else -3.437383676319936e-16
    np.subtract(4.732050807568878, beta, out=w1)
    t12 = np.add(w1, rest_, out=w1)
    t13 = np.multiply(t10, t12, out=w0)
    t14 = np.multiply(t13, 0.6666666666666666, out=w0)
    t15 = np.add(2.0, beta, out=w1)
    t16 = np.add(t15, beta_radical, out=w1)
    t17 = np.multiply(t16, 2.0, out=w1)
    t18 = np.divide(t14, t17, out=w0)
    root_of_rest = np.sqrt(t18, out=w0)
    np.divide(beta, root_of_rest, out=tracking_index)


_INDEX_FROM_BETA = Signature(
    "index_from_beta",
    (
        Domain(
            "beta",
            "a number above 0 and below 1.2679491924311228",
            (5e-324, 1.2679491924311226),
            (1.401298464324817e-45, 1.267949104309082),
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

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.2679491924311228.

    alpha: position gain. Relative error at most 3.76 * 2^-52 (float64), 3.76 * 2^-23 (float32),
        proved for 5e-324 <= beta <= 1.2679491924311226 (float64) and 1e-45 <= beta <= 1.2679491
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation continuous-white-acceleration
    """
    return AlphaFromBeta(*evaluate(_ALPHA_FROM_BETA, (beta,), out))


def _alpha_from_beta_block(
    given: Sequence[Array], out: Sequence[Array], work: Sequence[Array], _single: bool
) -> None:
    (beta,) = given
    (alpha,) = out
    w0, w1 = work
    t2 = np.multiply(beta, 1.152921504606847e18, out=alpha)
    t4 = np.divide(beta, 3.0, out=w0)
    t6 = np.add(8.0, t4, out=w0)
    t7 = np.multiply(t2, t6, out=w0)
    scaled_beta_radical = np.sqrt(t7, out=w0)
    t10 = np.subtract(12.0, beta, out=w1)
    t12 = np.multiply(t10, 0.6666666666666666, out=w1)
    t13 = np.multiply(t2, t12, out=alpha)
    t15 = np.multiply(beta, 1073741824.0, out=w1)
    t16 = np.add(scaled_beta_radical, t15, out=w0)
    t18 = np.multiply(t16, 2147483648.0, out=w0)
    np.divide(t13, t18, out=alpha)


_ALPHA_FROM_BETA = Signature(
    "alpha_from_beta",
    (
        Domain(
            "beta",
            "a number above 0 and below 1.2679491924311228",
            (5e-324, 1.2679491924311226),
            (1.401298464324817e-45, 1.267949104309082),
        ),
    ),
    ("alpha",),
    2,
    _alpha_from_beta_block,
)
