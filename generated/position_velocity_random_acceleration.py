# Made by: gainproof generate position-velocity-random-acceleration
# From: gainproof derive position-velocity-random-acceleration, SymPy 1.14.0
"""Position and velocity measured, random acceleration (constant over each interval)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, multiply, negative, sqrt, square, subtract

from gainproof.generated._numbers import ONE, Double, named
from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Signature

if TYPE_CHECKING:
    from typing import NamedTuple

    from gainproof.generated._numbers import Form
    from gainproof.generated._signature import ArrayLike, Arrays, Real
else:
    from gainproof.generated._result import NamedTuple

__all__ = [
    "ClosedLoopPoles",
    "Gains",
    "GainsByTrackingIndex",
    "GainsByVelocityRatio",
    "KnownVelocity",
    "PredictedCovariance",
    "PredictedCovarianceByTrackingIndex",
    "PredictedCovarianceByVelocityRatio",
    "RealPoles",
    "UpdatedCovariance",
    "UpdatedCovarianceByTrackingIndex",
    "UpdatedCovarianceByVelocityRatio",
    "closed_loop_poles",
    "gains",
    "gains_by_tracking_index",
    "gains_by_velocity_ratio",
    "known_velocity",
    "predicted_covariance",
    "predicted_covariance_by_tracking_index",
    "predicted_covariance_by_velocity_ratio",
    "real_poles",
    "updated_covariance",
    "updated_covariance_by_tracking_index",
    "updated_covariance_by_velocity_ratio",
]

_TRACKING_INDEX_DOMAIN = Domain(
    "tracking_index",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8",
    (1e-12, 1000000000000.0),
    (9.99999993922529e-09, 100000000.0),
)
_VELOCITY_RATIO_DOMAIN = Domain(
    "velocity_ratio",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8",
    (1e-12, 1000000000000.0),
    (9.99999993922529e-09, 100000000.0),
)
_TRACKING_INDEX_DOMAIN_2 = Domain(
    "tracking_index",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5",
    (1e-30, 1e30),
    (9.999999747378752e-06, 100000.0),
)
_VELOCITY_RATIO_DOMAIN_2 = Domain(
    "velocity_ratio",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5",
    (1e-30, 1e30),
    (9.999999747378752e-06, 100000.0),
)
_TRACKING_INDEX_DOMAIN_3 = Domain(
    "tracking_index",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-6 and at most 1e6",
    (1e-30, 1e30),
    (9.999999974752427e-07, 1000000.0),
)
_VELOCITY_RATIO_DOMAIN_3 = Domain(
    "velocity_ratio",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-6 and at most 1e6",
    (1e-30, 1e30),
    (9.999999974752427e-07, 1000000.0),
)
_TRACKING_INDEX_DOMAIN_4 = Domain(
    "tracking_index",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e6",
    (1e-12, 1000000000000.0),
    (9.999999974752427e-07, 1000000.0),
)
_VELOCITY_RATIO_DOMAIN_4 = Domain(
    "velocity_ratio",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e6",
    (1e-12, 1000000000000.0),
    (9.999999974752427e-07, 1000000.0),
)


class Gains(NamedTuple):
    """Result of `gains`."""

    gain_11: Real
    """Position's gain on the measured position."""
    gain_12: Real
    """Position's gain on the measured velocity over T."""
    gain_21: Real
    """Velocity's gain on the measured position times T."""
    gain_22: Real
    """Velocity's gain on the measured velocity."""


def gains(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> Gains:
    """Steady-state filter gain, position and velocity measured.

        gain_11 = U11, gain_12 = U12/S^2, gain_21 = U12, gain_22 = U22/S^2,
        U11 = (g/sigma + U12 U12/S^2)/(U22/S^2),
        U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8.

    gain_11: position's gain on the measured position. Relative error at most 8.03 * 2^-52
        (float64), 7.93 * 2^-23 (float32), proved for every input.
    gain_12: position's gain on the measured velocity over T. Relative error at most 5.89 * 2^-52
        (float64), 5.82 * 2^-23 (float32), proved for every input.
    gain_21: velocity's gain on the measured position times T. Relative error at most 6.89 * 2^-52
        (float64), 6.82 * 2^-23 (float32), proved for every input.
    gain_22: velocity's gain on the measured velocity. Relative error at most 7.54 * 2^-52
        (float64), 7.48 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-12 <= tracking_index <= 1000000000000.0
        and 1e-12 <= velocity_ratio <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(Gains, _gains_of_numbers(tracking_index, velocity_ratio))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Gains(*evaluate(_GAINS, (tracking_index, velocity_ratio), out, workers))


def _gains_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t22 = (((t13 + t8) * 0.5) + t18) * 0.5
    t25 = (tracking_index * t8) / (t2 + t5)
    t27 = tracking_index / (t25 + velocity_ratio)
    t29 = t27 * (velocity_ratio * t25)
    t30 = t27 / t22
    t31 = t30 * t3
    t34 = (t29 + (t2 / t22)) / t18
    t38 = ((t29 / t22) + (t31 * t30)) / t34
    return (t38, t30, t31, t34)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4, w5 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, gain_12)
    t9 = multiply(t3, n1, w3)
    t11 = add(t9, n2, w3)
    t12 = multiply(t2, t11, w3)
    t13 = multiply(tracking_index, velocity_ratio, w4)
    t15 = multiply(eta_scaled, n3, w5)
    t16 = multiply(t13, t15, w5)
    t17 = add(t12, t16, w3)
    delta_scaled = sqrt(t17, gain_22)
    t19 = add(t13, eta_scaled, w4)
    t20 = multiply(t19, n3, w4)
    t21 = add(t20, delta_scaled, w4)
    sigma_scaled = multiply(t21, n3, w4)
    t23 = add(t2, t5, w2)
    t24 = multiply(tracking_index, eta_scaled, gain_12)
    coupling_scaled = divide(t24, t23, gain_21)
    t26 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t26, gain_11)
    t28 = multiply(velocity_ratio, coupling_scaled, gain_21)
    rest_scaled = multiply(cross_share, t28, w2)
    divide(cross_share, sigma_scaled, gain_12)
    multiply(gain_12, t3, gain_21)
    t32 = divide(t2, sigma_scaled, w0)
    t33 = add(rest_scaled, t32, w0)
    divide(t33, delta_scaled, gain_22)
    t35 = divide(rest_scaled, sigma_scaled, w2)
    t36 = multiply(gain_21, gain_12, w0)
    t37 = add(t35, t36, w2)
    divide(t37, gain_22, gain_11)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    6,
    _gains_block,
    numbers=_gains_of_numbers,
)


class PredictedCovariance(NamedTuple):
    """Result of `predicted_covariance`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_o^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity times T/sigma_o^2."""
    predicted_22: Real
    """Variance of the predicted velocity times T^2/sigma_o^2."""


def predicted_covariance(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictedCovariance:
    """Predicted covariance in units of sigma_o^2 and T.

        predicted_11 = (g + sigma s)/delta, predicted_12 = h sigma,
        predicted_22 = delta h + Lambda^2/2,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        s = 2 U12 + U22 + Lambda^2/4,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8.

    predicted_11: variance of the predicted position over sigma_o^2. Relative error at most 11.55 *
        2^-52 (float64), 11.60 * 2^-23 (float32), proved for every input.
    predicted_12: covariance of predicted position and velocity times T/sigma_o^2. Relative error at
        most 5.58 * 2^-52 (float64), 5.58 * 2^-23 (float32), proved for every input.
    predicted_22: variance of the predicted velocity times T^2/sigma_o^2. Relative error at most
        6.07 * 2^-52 (float64), 6.06 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-12 <= tracking_index <= 1000000000000.0
        and 1e-12 <= velocity_ratio <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictedCovariance,
                _predicted_covariance_of_numbers(tracking_index, velocity_ratio),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedCovariance(
        *evaluate(_PREDICTED_COVARIANCE, (tracking_index, velocity_ratio), out, workers)
    )


def _predicted_covariance_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t22 = (((t13 + t8) * 0.5) + t18) * 0.5
    t25 = (tracking_index * t8) / (t2 + t5)
    t27 = tracking_index / (t25 + velocity_ratio)
    t29 = t27 * (velocity_ratio * t25)
    t38 = (((t27 / t22) * t3) * 2.0) + (t3 * ((t29 + (t2 / t22)) / t18))
    t42 = (t29 + (t22 * (t38 + (t2 * 0.25)))) / t18
    t43 = t27 * t22
    t46 = (t18 * t27) + (t2 * 0.5)
    return (t42, t43, t46)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, predicted_11)
    t9 = multiply(t3, n1, w3)
    t11 = add(t9, n2, w3)
    t12 = multiply(t2, t11, w3)
    t13 = multiply(tracking_index, velocity_ratio, w4)
    t15 = multiply(eta_scaled, n3, w5)
    t16 = multiply(t13, t15, w5)
    t17 = add(t12, t16, w3)
    delta_scaled = sqrt(t17, predicted_12)
    t19 = add(t13, eta_scaled, w4)
    t20 = multiply(t19, n3, w4)
    t21 = add(t20, delta_scaled, w4)
    sigma_scaled = multiply(t21, n3, w4)
    t23 = add(t2, t5, w2)
    t24 = multiply(tracking_index, eta_scaled, predicted_11)
    coupling_scaled = divide(t24, t23, predicted_22)
    t26 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t26, w2)
    t28 = multiply(velocity_ratio, coupling_scaled, predicted_22)
    rest_scaled = multiply(cross_share, t28, predicted_22)
    t30 = multiply(t2, n1, w3)
    t31 = divide(cross_share, sigma_scaled, w5)
    t32 = multiply(t31, t3, w5)
    t33 = multiply(t32, n4, w5)
    t34 = divide(t2, sigma_scaled, predicted_11)
    t35 = add(rest_scaled, t34, predicted_11)
    t36 = divide(t35, delta_scaled, predicted_11)
    t37 = multiply(t3, t36, w1)
    t38 = add(t33, t37, w5)
    t39 = add(t38, t30, w5)
    t40 = multiply(sigma_scaled, t39, w5)
    t41 = add(rest_scaled, t40, predicted_22)
    t44 = multiply(delta_scaled, cross_share, w1)
    t45 = multiply(t2, n3, w0)
    divide(t41, delta_scaled, predicted_11)
    multiply(cross_share, sigma_scaled, predicted_12)
    add(t44, t45, predicted_22)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("predicted_11", "predicted_12", "predicted_22"),
    6,
    _predicted_covariance_block,
    numbers=_predicted_covariance_of_numbers,
)


class UpdatedCovariance(NamedTuple):
    """Result of `updated_covariance`."""

    updated_11: Real
    """Variance of the updated position over sigma_o^2."""
    updated_12: Real
    """Covariance of updated position and velocity times T/sigma_o^2."""
    updated_22: Real
    """Variance of the updated velocity times T^2/sigma_o^2."""


def updated_covariance(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdatedCovariance:
    """Updated covariance in units of sigma_o^2 and T.

        updated_11 = U11, updated_12 = U12, updated_22 = U22,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        s = 2 U12 + U22 + Lambda^2/4,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8.

    updated_11: variance of the updated position over sigma_o^2. Relative error at most 12.70 *
        2^-52 (float64), 12.64 * 2^-23 (float32), proved for every input.
    updated_12: covariance of updated position and velocity times T/sigma_o^2. Relative error at
        most 7.28 * 2^-52 (float64), 7.01 * 2^-23 (float32), proved for every input.
    updated_22: variance of the updated velocity times T^2/sigma_o^2. Relative error at most 8.63 *
        2^-52 (float64), 8.14 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-12 <= tracking_index <= 1000000000000.0
        and 1e-12 <= velocity_ratio <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UpdatedCovariance, _updated_covariance_of_numbers(tracking_index, velocity_ratio)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedCovariance(
        *evaluate(_UPDATED_COVARIANCE, (tracking_index, velocity_ratio), out, workers)
    )


def _updated_covariance_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t22 = (((t13 + t8) * 0.5) + t18) * 0.5
    t25 = (tracking_index * t8) / (t2 + t5)
    t27 = tracking_index / (t25 + velocity_ratio)
    t29 = t27 * (velocity_ratio * t25)
    t32 = (t27 / t22) * t3
    t37 = t3 * ((t29 + (t2 / t22)) / t18)
    t40 = (((t32 * 2.0) + t37) + (t2 * 0.25)) / t22
    t43 = (t29 + (t3 * t40)) / t18
    return (t43, t32, t37)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, updated_12)
    t9 = multiply(t3, n1, w3)
    t11 = add(t9, n2, w3)
    t12 = multiply(t2, t11, w3)
    t13 = multiply(tracking_index, velocity_ratio, w4)
    t15 = multiply(eta_scaled, n3, w5)
    t16 = multiply(t13, t15, w5)
    t17 = add(t12, t16, w3)
    delta_scaled = sqrt(t17, updated_11)
    t19 = add(t13, eta_scaled, w4)
    t20 = multiply(t19, n3, w4)
    t21 = add(t20, delta_scaled, w4)
    sigma_scaled = multiply(t21, n3, w4)
    t23 = add(t2, t5, w2)
    t24 = multiply(tracking_index, eta_scaled, updated_12)
    coupling_scaled = divide(t24, t23, updated_22)
    t26 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t26, w2)
    t28 = multiply(velocity_ratio, coupling_scaled, updated_22)
    rest_scaled = multiply(cross_share, t28, w3)
    t30 = multiply(t2, n1, w5)
    t31 = divide(cross_share, sigma_scaled, w2)
    multiply(t31, t3, updated_12)
    t33 = multiply(updated_12, n4, w2)
    t34 = divide(t2, sigma_scaled, w0)
    t35 = add(rest_scaled, t34, w0)
    t36 = divide(t35, delta_scaled, w0)
    multiply(t3, t36, updated_22)
    t38 = add(t33, updated_22, w2)
    t39 = add(t38, t30, w2)
    t40 = divide(t39, sigma_scaled, w2)
    t41 = multiply(t3, t40, w1)
    t42 = add(rest_scaled, t41, w3)
    divide(t42, delta_scaled, updated_11)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("updated_11", "updated_12", "updated_22"),
    6,
    _updated_covariance_block,
    numbers=_updated_covariance_of_numbers,
)


class GainsByTrackingIndex(NamedTuple):
    """Result of `gains_by_tracking_index`."""

    gain_11: Real
    """Derivative by Lambda of the position's gain on the measured position."""
    gain_12: Real
    """Derivative by Lambda of the position's gain on the measured velocity over T."""
    gain_21: Real
    """Derivative by Lambda of the velocity's gain on the measured position times T."""
    gain_22: Real
    """Derivative by Lambda of the velocity's gain on the measured velocity."""


def gains_by_tracking_index(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> GainsByTrackingIndex:
    """First derivatives of the filter gain by tracking_index.

        d/dLambda with S held of what follows. A change of the noise moves the
        covariance by a sum over the closed loop, which is a mean over z = 1 and z = -1: a
        variance's derivative is Lambda/delta times squares over Lambda w and over eta, a
        covariance's has products in place of the squares.
        As K = U R^-1: dK11 = dU11, dK21 = dU12, dK12 = dU12/S^2, dK22 = dU22/S^2.
        The output gain_12 is the difference of two positive terms.
        The output gain_21 is the difference of two positive terms.
        The entries themselves:
        gain_11 = U11, gain_12 = U12/S^2, gain_21 = U12, gain_22 = U22/S^2,
        U11 = (g/sigma + U12 U12/S^2)/(U22/S^2),
        U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    gain_11: derivative by Lambda of the position's gain on the measured position. Relative error at
        most 26.72 * 2^-52 (float64), 26.02 * 2^-23 (float32), proved for every input.
    gain_12: derivative by Lambda of the position's gain on the measured velocity over T. Error over
        the sum of its terms' sizes at most 28.36 * 2^-52 (float64), 26.79 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: what it is the derivative of grows in one
        part of the domain and falls in another, so that it vanishes between. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 8e-7 in float64 and 0.03 in float32 of what its error is relative to.
    gain_21: derivative by Lambda of the velocity's gain on the measured position times T. Error
        over the sum of its terms' sizes at most 27.36 * 2^-52 (float64), 25.79 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: what it is the derivative of grows
        in one part of the domain and falls in another, so that it vanishes between. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 7e-7 in float64 and 0.03 in float32 of what its error is relative to.
    gain_22: derivative by Lambda of the velocity's gain on the measured velocity. Relative error at
        most 29.19 * 2^-52 (float64), 27.62 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-30 <= tracking_index <= 1e30
        and 1e-30 <= velocity_ratio <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                GainsByTrackingIndex,
                _gains_by_tracking_index_of_numbers(tracking_index, velocity_ratio),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainsByTrackingIndex(
        *evaluate(_GAINS_BY_TRACKING_INDEX, (tracking_index, velocity_ratio), out, workers)
    )


def _gains_by_tracking_index_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t20 = (t13 + t8) * 0.5
    t22 = (t20 + t18) * 0.5
    t25 = (tracking_index * t8) / (t2 + t5)
    t26 = t25 + velocity_ratio
    t28 = t22 / velocity_ratio
    t29 = (velocity_ratio / t26) / t28
    t34 = velocity_ratio * ((t8 * 0.25) * (t13 + (t18 * 2.0)))
    t38 = (t3 * (velocity_ratio * 2.0)) + (tracking_index * t20)
    t40 = (t34 / t38) / t28
    t44 = (t25 / t26) / t28
    t46 = (t22 * velocity_ratio) + tracking_index
    t49 = ((t46 * t8) / t38) / t28
    t51 = t8 / velocity_ratio
    t54 = tracking_index / (t18 / velocity_ratio)
    t55 = t54 * ((t29 * t40) / tracking_index)
    t56 = t54 * ((t44 * t49) / t51)
    t58 = (t55 / velocity_ratio) / velocity_ratio
    t60 = (t56 / velocity_ratio) / velocity_ratio
    t65 = ((t40 * t40) / tracking_index) + ((t49 * t49) / t51)
    t73 = ((t29 * t29) / tracking_index) + ((t44 * t44) / t51)
    t68 = ((t54 * t65) / velocity_ratio) / velocity_ratio
    t74 = t54 * t73
    t75 = t58 - t60
    t77 = t55 - t56
    return (t74, t75, t77, t68)


def _gains_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, gain_22)
    t9 = multiply(t3, n1, w3)
    t11 = add(t9, n2, w3)
    t12 = multiply(t2, t11, w3)
    t13 = multiply(tracking_index, velocity_ratio, w4)
    t15 = multiply(eta_scaled, n3, w5)
    t16 = multiply(t13, t15, w5)
    t17 = add(t12, t16, w3)
    delta_scaled = sqrt(t17, gain_11)
    t19 = add(t13, eta_scaled, w3)
    t20 = multiply(t19, n3, w3)
    t21 = add(t20, delta_scaled, w5)
    sigma_scaled = multiply(t21, n3, w5)
    t23 = add(t2, t5, w0)
    t24 = multiply(tracking_index, eta_scaled, w2)
    coupling_scaled = divide(t24, t23, gain_12)
    t26 = add(coupling_scaled, velocity_ratio, w0)
    t27 = divide(velocity_ratio, t26, gain_21)
    t28 = divide(sigma_scaled, velocity_ratio, w2)
    t29 = divide(t27, t28, gain_21)
    t30 = multiply(delta_scaled, n4, w6)
    t31 = add(t13, t30, w4)
    t32 = multiply(eta_scaled, n1, w6)
    t33 = multiply(t32, t31, w6)
    t34 = multiply(velocity_ratio, t33, w6)
    t35 = multiply(velocity_ratio, n4, w4)
    t36 = multiply(t3, t35, w1)
    t37 = multiply(tracking_index, t20, w3)
    t38 = add(t36, t37, w1)
    t39 = divide(t34, t38, w6)
    t40 = divide(t39, t28, w6)
    t41 = multiply(t29, t40, w3)
    t42 = divide(t41, tracking_index, w3)
    t43 = divide(coupling_scaled, t26, gain_12)
    t44 = divide(t43, t28, gain_12)
    t45 = multiply(sigma_scaled, velocity_ratio, w5)
    t46 = add(t45, tracking_index, w5)
    t47 = multiply(t46, eta_scaled, w5)
    t48 = divide(t47, t38, w5)
    t49 = divide(t48, t28, w5)
    t50 = multiply(t44, t49, w0)
    t51 = divide(eta_scaled, velocity_ratio, gain_22)
    t52 = divide(t50, t51, w0)
    t53 = divide(delta_scaled, velocity_ratio, gain_11)
    t54 = divide(tracking_index, t53, gain_11)
    t55 = multiply(t54, t42, w3)
    t56 = multiply(t54, t52, w0)
    t57 = divide(t55, velocity_ratio, w1)
    t58 = divide(t57, velocity_ratio, w1)
    t59 = divide(t56, velocity_ratio, w2)
    t60 = divide(t59, velocity_ratio, w2)
    t61 = square(t40, w6)
    t62 = square(t49, w5)
    t63 = divide(t61, tracking_index, w6)
    t64 = divide(t62, t51, w5)
    t65 = add(t63, t64, w6)
    t66 = multiply(t54, t65, w6)
    t67 = divide(t66, velocity_ratio, w6)
    t69 = square(t29, gain_21)
    t70 = square(t44, gain_12)
    t71 = divide(t69, tracking_index, gain_21)
    t72 = divide(t70, t51, gain_12)
    t73 = add(t71, t72, gain_21)
    divide(t67, velocity_ratio, gain_22)
    multiply(t54, t73, gain_11)
    subtract(t58, t60, gain_12)
    subtract(t55, t56, gain_21)


_GAINS_BY_TRACKING_INDEX = Signature(
    "gains_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    7,
    _gains_by_tracking_index_block,
    numbers=_gains_by_tracking_index_of_numbers,
)


class GainsByVelocityRatio(NamedTuple):
    """Result of `gains_by_velocity_ratio`."""

    gain_11: Real
    """Derivative by S of the position's gain on the measured position."""
    gain_12: Real
    """Derivative by S of the position's gain on the measured velocity over T."""
    gain_21: Real
    """Derivative by S of the velocity's gain on the measured position times T."""
    gain_22: Real
    """Derivative by S of the velocity's gain on the measured velocity."""


def gains_by_velocity_ratio(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> GainsByVelocityRatio:
    """First derivatives of the filter gain by velocity_ratio.

        d/dS with Lambda held of what follows. A change of the noise moves the
        covariance by a sum over the closed loop, which is a mean over z = 1 and z = -1: a
        variance's derivative is S/delta times squares over Lambda w and over eta, a
        covariance's has products in place of the squares.
        As K = U R^-1: dK11 = dU11, dK21 = dU12, dK12 = dU12/S^2 - 2 K12/S, and dK22 =
        dU22/S^2 - 2 K22/S, which is negative and has a form without a subtraction.
        The output gain_12 is the difference of two positive terms.
        The entries themselves:
        gain_11 = U11, gain_12 = U12/S^2, gain_21 = U12, gain_22 = U22/S^2,
        U11 = (g/sigma + U12 U12/S^2)/(U22/S^2),
        U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    gain_11: derivative by S of the position's gain on the measured position. Relative error at most
        26.72 * 2^-52 (float64), 26.01 * 2^-23 (float32), proved for every input.
    gain_12: derivative by S of the position's gain on the measured velocity over T. Error over the
        sum of its terms' sizes at most 29.47 * 2^-52 (float64), 28.14 * 2^-23 (float32), proved for
        every input. Cancellation, condition number 1: what it is the derivative of grows in one
        part of the domain and falls in another, so that it vanishes between. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 8e-7 in float64 and 0.03 in float32 of what its error is relative to.
    gain_21: derivative by S of the velocity's gain on the measured position times T. Relative error
        at most 27.97 * 2^-52 (float64), 26.64 * 2^-23 (float32), proved for every input.
    gain_22: derivative by S of the velocity's gain on the measured velocity. Relative error at most
        31.19 * 2^-52 (float64), 29.61 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-30 <= tracking_index <= 1e30
        and 1e-30 <= velocity_ratio <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                GainsByVelocityRatio,
                _gains_by_velocity_ratio_of_numbers(tracking_index, velocity_ratio),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainsByVelocityRatio(
        *evaluate(_GAINS_BY_VELOCITY_RATIO, (tracking_index, velocity_ratio), out, workers)
    )


def _gains_by_velocity_ratio_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t20 = (t13 + t8) * 0.5
    t22 = (t20 + t18) * 0.5
    t25 = (tracking_index * t8) / (t2 + t5)
    t26 = t25 + velocity_ratio
    t27 = tracking_index / t26
    t34 = ((t18 * t27) + (t2 * 0.5)) / velocity_ratio
    t36 = t22 / velocity_ratio
    t37 = (t34 / velocity_ratio) / t36
    t40 = ((t25 / t26) / t36) * 2.0
    t44 = t8 / velocity_ratio
    t46 = ((t37 * t37) / tracking_index) + ((t40 * t40) / t44)
    t47 = t18 / velocity_ratio
    t48 = velocity_ratio / t47
    t50 = (t27 * (velocity_ratio * t25)) / velocity_ratio
    t57 = ((t37 * t50) / tracking_index) + ((t40 * (t50 + (t37 * 2.0))) / t44)
    t58 = t48 * t57
    t60 = t27 * velocity_ratio
    t65 = velocity_ratio * ((t8 * 0.25) * (t13 + (t18 * 2.0)))
    t69 = (t3 * (velocity_ratio * 2.0)) + (tracking_index * t20)
    t71 = (t65 / t69) / t36
    t73 = (t22 * velocity_ratio) + tracking_index
    t76 = ((t73 * t8) / t69) / t36
    t81 = ((t71 * t71) / tracking_index) + ((t76 * t76) / t44)
    t84 = tracking_index * (((tracking_index / t47) * t81) * 0.5)
    t89 = ((t60 * 2.0) * (t60 / (t47 * t44))) + t84
    t91 = (2.0 / velocity_ratio) / velocity_ratio
    t96 = (t58 / velocity_ratio) / velocity_ratio
    t49 = t48 * t46
    t94 = -(t91 * (t89 / velocity_ratio))
    t99 = t96 - (((t27 / t22) / velocity_ratio) * 2.0)
    return (t49, t99, t58, t94)


def _gains_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, gain_11)
    t9 = multiply(t3, n1, w3)
    t11 = add(t9, n2, w3)
    t12 = multiply(t2, t11, w3)
    t13 = multiply(tracking_index, velocity_ratio, w4)
    t15 = multiply(eta_scaled, n3, w5)
    t16 = multiply(t13, t15, w5)
    t17 = add(t12, t16, w3)
    delta_scaled = sqrt(t17, gain_22)
    t19 = add(t13, eta_scaled, w3)
    t20 = multiply(t19, n3, w3)
    t21 = add(t20, delta_scaled, w5)
    sigma_scaled = multiply(t21, n3, w5)
    t23 = add(t2, t5, w2)
    t24 = multiply(tracking_index, eta_scaled, w6)
    coupling_scaled = divide(t24, t23, gain_21)
    t26 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t26, gain_12)
    t28 = multiply(velocity_ratio, coupling_scaled, w6)
    rest_scaled = multiply(cross_share, t28, w6)
    t30 = divide(cross_share, sigma_scaled, w7)
    t31 = multiply(delta_scaled, cross_share, w8)
    t32 = multiply(t2, n3, w0)
    t33 = add(t31, t32, w8)
    t34 = divide(t33, velocity_ratio, w8)
    t35 = divide(t34, velocity_ratio, w8)
    t36 = divide(sigma_scaled, velocity_ratio, w0)
    t37 = divide(t35, t36, w8)
    t38 = divide(coupling_scaled, t26, gain_21)
    t39 = divide(t38, t36, gain_21)
    t40 = multiply(t39, n4, gain_21)
    t41 = square(t37, w2)
    t42 = square(t40, w9)
    t43 = divide(t41, tracking_index, w2)
    t44 = divide(eta_scaled, velocity_ratio, w10)
    t45 = divide(t42, t44, w9)
    t46 = add(t43, t45, w2)
    t47 = divide(delta_scaled, velocity_ratio, w9)
    t48 = divide(velocity_ratio, t47, w11)
    t50 = divide(rest_scaled, velocity_ratio, w6)
    t51 = multiply(t37, t50, w12)
    t52 = multiply(t37, n4, w8)
    t53 = add(t50, t52, w6)
    t54 = multiply(t40, t53, gain_21)
    t55 = divide(t51, tracking_index, w12)
    t56 = divide(t54, t44, gain_21)
    t57 = add(t55, t56, w12)
    multiply(t48, t57, gain_21)
    t59 = divide(tracking_index, t47, w6)
    t60 = multiply(cross_share, velocity_ratio, gain_12)
    t61 = multiply(delta_scaled, n4, gain_22)
    t62 = add(t13, t61, w4)
    t63 = multiply(eta_scaled, n1, w8)
    t64 = multiply(t63, t62, w8)
    t65 = multiply(velocity_ratio, t64, w8)
    t66 = multiply(velocity_ratio, n4, w4)
    t67 = multiply(t3, t66, w1)
    t68 = multiply(tracking_index, t20, w3)
    t69 = add(t67, t68, w1)
    t70 = divide(t65, t69, w8)
    t71 = divide(t70, t36, w8)
    t72 = multiply(sigma_scaled, velocity_ratio, w5)
    t73 = add(t72, tracking_index, w5)
    t74 = multiply(t73, eta_scaled, w5)
    t75 = divide(t74, t69, w5)
    t76 = divide(t75, t36, w5)
    t77 = square(t71, w8)
    t78 = square(t76, w5)
    t79 = divide(t77, tracking_index, w8)
    t80 = divide(t78, t44, w5)
    t81 = add(t79, t80, w8)
    t82 = multiply(t59, t81, w6)
    t83 = multiply(t82, n3, w6)
    t84 = multiply(tracking_index, t83, w6)
    t85 = multiply(t60, n4, w0)
    t86 = multiply(t47, t44, w9)
    t87 = divide(t60, t86, gain_12)
    t88 = multiply(t85, t87, w0)
    t89 = add(t88, t84, w0)
    t90 = divide(n4, velocity_ratio, w1)
    t91 = divide(t90, velocity_ratio, w1)
    t92 = divide(t89, velocity_ratio, w0)
    t93 = multiply(t91, t92, w1)
    t95 = divide(gain_21, velocity_ratio, w0)
    t96 = divide(t95, velocity_ratio, w0)
    t97 = divide(t30, velocity_ratio, w7)
    t98 = multiply(t97, n4, w7)
    multiply(t48, t46, gain_11)
    negative(t93, gain_22)
    subtract(t96, t98, gain_12)


_GAINS_BY_VELOCITY_RATIO = Signature(
    "gains_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    13,
    _gains_by_velocity_ratio_block,
    numbers=_gains_by_velocity_ratio_of_numbers,
)


class PredictedCovarianceByTrackingIndex(NamedTuple):
    """Result of `predicted_covariance_by_tracking_index`."""

    predicted_11: Real
    """Derivative by Lambda of the variance of the predicted position over sigma_o^2."""
    predicted_12: Real
    """Derivative by Lambda of the covariance of predicted position and velocity times
    T/sigma_o^2."""
    predicted_22: Real
    """Derivative by Lambda of the variance of the predicted velocity times T^2/sigma_o^2."""


def predicted_covariance_by_tracking_index(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictedCovarianceByTrackingIndex:
    """First derivatives of the predicted covariance by tracking_index.

        d/dLambda with S held of what follows. A change of the noise moves the
        covariance by a sum over the closed loop, which is a mean over z = 1 and z = -1: a
        variance's derivative is Lambda/delta times squares over Lambda w and over eta, a
        covariance's has products in place of the squares.
        The entries themselves:
        predicted_11 = (g + sigma s)/delta, predicted_12 = h sigma,
        predicted_22 = delta h + Lambda^2/2,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        s = 2 U12 + U22 + Lambda^2/4,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-6 and at most 1e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-6 and at most 1e6.

    predicted_11: derivative by Lambda of the variance of the predicted position over sigma_o^2.
        Relative error at most 26.03 * 2^-52 (float64), 20.12 * 2^-23 (float32), proved for every
        input.
    predicted_12: derivative by Lambda of the covariance of predicted position and velocity times
        T/sigma_o^2. Relative error at most 24.73 * 2^-52 (float64), 18.76 * 2^-23 (float32), proved
        for every input.
    predicted_22: derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_o^2. Relative error at most 27.61 * 2^-52 (float64), 24.77 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-30 <= tracking_index <= 1e30
        and 1e-30 <= velocity_ratio <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictedCovarianceByTrackingIndex,
                _predicted_covariance_by_tracking_index_of_numbers(tracking_index, velocity_ratio),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedCovarianceByTrackingIndex(
        *evaluate(
            _PREDICTED_COVARIANCE_BY_TRACKING_INDEX,
            (tracking_index, velocity_ratio),
            out,
            workers,
        )
    )


def _predicted_covariance_by_tracking_index_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t20 = (t13 + t8) * 0.5
    t22 = (t20 + t18) * 0.5
    t25 = (tracking_index * t8) / (t2 + t5)
    t26 = t25 + velocity_ratio
    t27 = tracking_index / t26
    t30 = t25 / t26
    t31 = t22 / velocity_ratio
    t33 = t31 * (velocity_ratio / t26)
    t34 = t31 * t30
    t38 = t8 / velocity_ratio
    t40 = ((t33 * t33) / tracking_index) + ((t34 * t34) / t38)
    t42 = (t27 * (velocity_ratio * t25)) + (t2 / t22)
    t46 = tracking_index / (t18 / velocity_ratio)
    t49 = (t27 * velocity_ratio) / tracking_index
    t51 = tracking_index + ((t3 * (t42 / t18)) / tracking_index)
    t56 = (t3 * velocity_ratio) + (tracking_index * t22)
    t60 = (t3 * (velocity_ratio * 2.0)) + (tracking_index * t20)
    t63 = (t49 * (t51 / tracking_index)) + (t30 * (t56 / t60))
    t70 = velocity_ratio * ((t8 * 0.25) * (t13 + (t18 * 2.0)))
    t72 = (t70 / t60) / t31
    t74 = (t22 * velocity_ratio) + tracking_index
    t77 = ((t74 * t8) / t60) / t31
    t82 = ((t72 * t72) / tracking_index) + ((t77 * t77) / t38)
    t47 = t46 * t40
    t65 = t46 * (t31 * t63)
    t85 = (t46 * t82) + (tracking_index * 2.0)
    return (t47, t65, t85)


def _predicted_covariance_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, predicted_11)
    t9 = multiply(t3, n1, w3)
    t11 = add(t9, n2, w3)
    t12 = multiply(t2, t11, w3)
    t13 = multiply(tracking_index, velocity_ratio, w4)
    t15 = multiply(eta_scaled, n3, w5)
    t16 = multiply(t13, t15, w5)
    t17 = add(t12, t16, w3)
    delta_scaled = sqrt(t17, predicted_12)
    t19 = add(t13, eta_scaled, w3)
    t20 = multiply(t19, n3, w3)
    t21 = add(t20, delta_scaled, w5)
    sigma_scaled = multiply(t21, n3, w5)
    t23 = add(t2, t5, w2)
    t24 = multiply(tracking_index, eta_scaled, w6)
    coupling_scaled = divide(t24, t23, predicted_22)
    t26 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t26, w6)
    t28 = multiply(velocity_ratio, coupling_scaled, w7)
    rest_scaled = multiply(cross_share, t28, w7)
    t30 = divide(coupling_scaled, t26, predicted_22)
    t31 = divide(sigma_scaled, velocity_ratio, w8)
    t32 = divide(velocity_ratio, t26, w2)
    t33 = multiply(t31, t32, w2)
    t34 = multiply(t31, t30, w9)
    t35 = square(t33, w2)
    t36 = square(t34, w9)
    t37 = divide(t35, tracking_index, w2)
    t38 = divide(eta_scaled, velocity_ratio, w10)
    t39 = divide(t36, t38, w9)
    t40 = add(t37, t39, w2)
    t41 = divide(t2, sigma_scaled, w0)
    t42 = add(rest_scaled, t41, w7)
    t43 = divide(t42, delta_scaled, w7)
    t44 = multiply(t3, t43, w7)
    t45 = divide(delta_scaled, velocity_ratio, w0)
    t46 = divide(tracking_index, t45, w0)
    t48 = multiply(cross_share, velocity_ratio, w6)
    t49 = divide(t48, tracking_index, w6)
    t50 = divide(t44, tracking_index, w7)
    t51 = add(tracking_index, t50, w7)
    t52 = divide(t51, tracking_index, w7)
    t53 = multiply(t49, t52, w6)
    t54 = multiply(t3, velocity_ratio, w7)
    t55 = multiply(tracking_index, sigma_scaled, w9)
    t56 = add(t54, t55, w7)
    t57 = multiply(velocity_ratio, n4, w9)
    t58 = multiply(t3, t57, w1)
    t59 = multiply(tracking_index, t20, w3)
    t60 = add(t58, t59, w1)
    t61 = divide(t56, t60, w7)
    t62 = multiply(t30, t61, predicted_22)
    t63 = add(t53, t62, w6)
    t64 = multiply(t31, t63, w6)
    t66 = multiply(delta_scaled, n4, predicted_12)
    t67 = add(t13, t66, w4)
    t68 = multiply(eta_scaled, n1, w3)
    t69 = multiply(t68, t67, w3)
    t70 = multiply(velocity_ratio, t69, w3)
    t71 = divide(t70, t60, w3)
    t72 = divide(t71, t31, w3)
    t73 = multiply(sigma_scaled, velocity_ratio, w5)
    t74 = add(t73, tracking_index, w5)
    t75 = multiply(t74, eta_scaled, w5)
    t76 = divide(t75, t60, w5)
    t77 = divide(t76, t31, w5)
    t78 = square(t72, w3)
    t79 = square(t77, w5)
    t80 = divide(t78, tracking_index, w3)
    t81 = divide(t79, t38, w5)
    t82 = add(t80, t81, w3)
    t83 = multiply(t46, t82, w3)
    t84 = multiply(tracking_index, n4, w1)
    multiply(t46, t40, predicted_11)
    multiply(t46, t64, predicted_12)
    add(t83, t84, predicted_22)


_PREDICTED_COVARIANCE_BY_TRACKING_INDEX = Signature(
    "predicted_covariance_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_3, _VELOCITY_RATIO_DOMAIN_3),
    ("predicted_11", "predicted_12", "predicted_22"),
    11,
    _predicted_covariance_by_tracking_index_block,
    numbers=_predicted_covariance_by_tracking_index_of_numbers,
)


class PredictedCovarianceByVelocityRatio(NamedTuple):
    """Result of `predicted_covariance_by_velocity_ratio`."""

    predicted_11: Real
    """Derivative by S of the variance of the predicted position over sigma_o^2."""
    predicted_12: Real
    """Derivative by S of the covariance of predicted position and velocity times T/sigma_o^2."""
    predicted_22: Real
    """Derivative by S of the variance of the predicted velocity times T^2/sigma_o^2."""


def predicted_covariance_by_velocity_ratio(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictedCovarianceByVelocityRatio:
    """First derivatives of the predicted covariance by velocity_ratio.

        d/dS with Lambda held of what follows. A change of the noise moves the
        covariance by a sum over the closed loop, which is a mean over z = 1 and z = -1: a
        variance's derivative is S/delta times squares over Lambda w and over eta, a
        covariance's has products in place of the squares.
        The entries themselves:
        predicted_11 = (g + sigma s)/delta, predicted_12 = h sigma,
        predicted_22 = delta h + Lambda^2/2,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        s = 2 U12 + U22 + Lambda^2/4,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    predicted_11: derivative by S of the variance of the predicted position over sigma_o^2. Relative
        error at most 26.75 * 2^-52 (float64), 24.96 * 2^-23 (float32), proved for every input.
    predicted_12: derivative by S of the covariance of predicted position and velocity times
        T/sigma_o^2. Relative error at most 27.00 * 2^-52 (float64), 22.06 * 2^-23 (float32), proved
        for every input.
    predicted_22: derivative by S of the variance of the predicted velocity times T^2/sigma_o^2.
        Relative error at most 28.24 * 2^-52 (float64), 34.84 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-30 <= tracking_index <= 1e30
        and 1e-30 <= velocity_ratio <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictedCovarianceByVelocityRatio,
                _predicted_covariance_by_velocity_ratio_of_numbers(tracking_index, velocity_ratio),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedCovarianceByVelocityRatio(
        *evaluate(
            _PREDICTED_COVARIANCE_BY_VELOCITY_RATIO,
            (tracking_index, velocity_ratio),
            out,
            workers,
        )
    )


def _predicted_covariance_by_velocity_ratio_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t25 = (tracking_index * t8) / (t2 + t5)
    t26 = t25 + velocity_ratio
    t27 = tracking_index / t26
    t30 = (t27 * (velocity_ratio * t25)) / velocity_ratio
    t34 = ((t18 * t27) + (t2 * 0.5)) / velocity_ratio
    t36 = ((((t13 + t8) * 0.5) + t18) * 0.5) / velocity_ratio
    t37 = (t34 / velocity_ratio) / t36
    t38 = t30 + t37
    t41 = (t36 * (t25 / t26)) * 2.0
    t43 = t30 + (t37 * 2.0)
    t47 = t8 / velocity_ratio
    t49 = ((t38 * t38) / tracking_index) + ((t41 * t41) / t47)
    t51 = velocity_ratio / (t18 / velocity_ratio)
    t57 = ((t38 * t30) / tracking_index) + ((t41 * t43) / t47)
    t63 = ((t30 * t30) / tracking_index) + ((t43 * t43) / t47)
    t52 = t51 * t49
    t58 = t51 * t57
    t64 = t51 * t63
    return (t52, t58, t64)


def _predicted_covariance_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, predicted_11)
    t9 = multiply(t3, n1, w1)
    t11 = add(t9, n2, w1)
    t12 = multiply(t2, t11, w1)
    t13 = multiply(tracking_index, velocity_ratio, w3)
    t15 = multiply(eta_scaled, n3, w4)
    t16 = multiply(t13, t15, w4)
    t17 = add(t12, t16, w1)
    delta_scaled = sqrt(t17, predicted_12)
    t19 = add(t13, eta_scaled, w3)
    t20 = multiply(t19, n3, w3)
    t21 = add(t20, delta_scaled, w3)
    sigma_scaled = multiply(t21, n3, w3)
    t23 = add(t2, t5, w2)
    t24 = multiply(tracking_index, eta_scaled, w1)
    coupling_scaled = divide(t24, t23, predicted_22)
    t26 = add(coupling_scaled, velocity_ratio, w1)
    cross_share = divide(tracking_index, t26, w2)
    t28 = multiply(velocity_ratio, coupling_scaled, w4)
    rest_scaled = multiply(cross_share, t28, w4)
    t30 = divide(rest_scaled, velocity_ratio, w4)
    t31 = multiply(delta_scaled, cross_share, w2)
    t32 = multiply(t2, n3, w0)
    t33 = add(t31, t32, w2)
    t34 = divide(t33, velocity_ratio, w2)
    t35 = divide(t34, velocity_ratio, w2)
    t36 = divide(sigma_scaled, velocity_ratio, w3)
    t37 = divide(t35, t36, w2)
    t38 = add(t30, t37, w0)
    t39 = divide(coupling_scaled, t26, predicted_22)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t40, n4, w3)
    t42 = multiply(t37, n4, w2)
    t43 = add(t30, t42, w2)
    t44 = square(t38, w1)
    t45 = square(t41, predicted_22)
    t46 = divide(t44, tracking_index, w1)
    t47 = divide(eta_scaled, velocity_ratio, predicted_11)
    t48 = divide(t45, t47, predicted_22)
    t49 = add(t46, t48, w1)
    t50 = divide(delta_scaled, velocity_ratio, predicted_12)
    t51 = divide(velocity_ratio, t50, predicted_22)
    t53 = multiply(t38, t30, w0)
    t54 = multiply(t41, t43, w3)
    t55 = divide(t53, tracking_index, w0)
    t56 = divide(t54, t47, w3)
    t57 = add(t55, t56, w0)
    t59 = square(t30, w4)
    t60 = square(t43, w2)
    t61 = divide(t59, tracking_index, w4)
    t62 = divide(t60, t47, w2)
    t63 = add(t61, t62, w4)
    multiply(t51, t49, predicted_11)
    multiply(t51, t57, predicted_12)
    multiply(t51, t63, predicted_22)


_PREDICTED_COVARIANCE_BY_VELOCITY_RATIO = Signature(
    "predicted_covariance_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("predicted_11", "predicted_12", "predicted_22"),
    5,
    _predicted_covariance_by_velocity_ratio_block,
    numbers=_predicted_covariance_by_velocity_ratio_of_numbers,
)


class UpdatedCovarianceByTrackingIndex(NamedTuple):
    """Result of `updated_covariance_by_tracking_index`."""

    updated_11: Real
    """Derivative by Lambda of the variance of the updated position over sigma_o^2."""
    updated_12: Real
    """Derivative by Lambda of the covariance of updated position and velocity times T/sigma_o^2."""
    updated_22: Real
    """Derivative by Lambda of the variance of the updated velocity times T^2/sigma_o^2."""


def updated_covariance_by_tracking_index(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdatedCovarianceByTrackingIndex:
    """First derivatives of the updated covariance by tracking_index.

        d/dLambda with S held of what follows. A change of the noise moves the
        covariance by a sum over the closed loop, which is a mean over z = 1 and z = -1: a
        variance's derivative is Lambda/delta times squares over Lambda w and over eta, a
        covariance's has products in place of the squares.
        The output updated_12 is the difference of two positive terms.
        The entries themselves:
        updated_11 = U11, updated_12 = U12, updated_22 = U22,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        s = 2 U12 + U22 + Lambda^2/4,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    updated_11: derivative by Lambda of the variance of the updated position over sigma_o^2.
        Relative error at most 26.72 * 2^-52 (float64), 26.02 * 2^-23 (float32), proved for every
        input.
    updated_12: derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_o^2. Error over the sum of its terms' sizes at most 27.35 * 2^-52 (float64), 25.79 *
        2^-23 (float32), proved for every input. Cancellation, condition number 1: what it is the
        derivative of grows in one part of the domain and falls in another, so that it vanishes
        between. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or
        more only where the value is below 7e-7 in float64 and 0.03 in float32 of what its error is
        relative to.
    updated_22: derivative by Lambda of the variance of the updated velocity times T^2/sigma_o^2.
        Relative error at most 27.99 * 2^-52 (float64), 26.62 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-30 <= tracking_index <= 1e30
        and 1e-30 <= velocity_ratio <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UpdatedCovarianceByTrackingIndex,
                _updated_covariance_by_tracking_index_of_numbers(tracking_index, velocity_ratio),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedCovarianceByTrackingIndex(
        *evaluate(
            _UPDATED_COVARIANCE_BY_TRACKING_INDEX,
            (tracking_index, velocity_ratio),
            out,
            workers,
        )
    )


def _updated_covariance_by_tracking_index_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t20 = (t13 + t8) * 0.5
    t22 = (t20 + t18) * 0.5
    t25 = (tracking_index * t8) / (t2 + t5)
    t26 = t25 + velocity_ratio
    t28 = t22 / velocity_ratio
    t29 = (velocity_ratio / t26) / t28
    t31 = (t25 / t26) / t28
    t35 = t8 / velocity_ratio
    t37 = ((t29 * t29) / tracking_index) + ((t31 * t31) / t35)
    t39 = tracking_index / (t18 / velocity_ratio)
    t45 = velocity_ratio * ((t8 * 0.25) * (t13 + (t18 * 2.0)))
    t49 = (t3 * (velocity_ratio * 2.0)) + (tracking_index * t20)
    t51 = (t45 / t49) / t28
    t53 = (t22 * velocity_ratio) + tracking_index
    t56 = ((t53 * t8) / t49) / t28
    t61 = ((t51 * t51) / tracking_index) + ((t56 * t56) / t35)
    t40 = t39 * t37
    t62 = t39 * t61
    t69 = (t39 * ((t29 * t51) / tracking_index)) - (t39 * ((t31 * t56) / t35))
    return (t40, t69, t62)


def _updated_covariance_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, updated_11)
    t9 = multiply(t3, n1, w3)
    t11 = add(t9, n2, w3)
    t12 = multiply(t2, t11, w3)
    t13 = multiply(tracking_index, velocity_ratio, w4)
    t15 = multiply(eta_scaled, n3, w5)
    t16 = multiply(t13, t15, w5)
    t17 = add(t12, t16, w3)
    delta_scaled = sqrt(t17, updated_22)
    t19 = add(t13, eta_scaled, w3)
    t20 = multiply(t19, n3, w3)
    t21 = add(t20, delta_scaled, w5)
    sigma_scaled = multiply(t21, n3, w5)
    t23 = add(t2, t5, w0)
    t24 = multiply(tracking_index, eta_scaled, w2)
    coupling_scaled = divide(t24, t23, updated_12)
    t26 = add(coupling_scaled, velocity_ratio, w0)
    t27 = divide(velocity_ratio, t26, w2)
    t28 = divide(sigma_scaled, velocity_ratio, w6)
    t29 = divide(t27, t28, w2)
    t30 = divide(coupling_scaled, t26, updated_12)
    t31 = divide(t30, t28, updated_12)
    t32 = square(t29, w0)
    t33 = square(t31, w7)
    t34 = divide(t32, tracking_index, w0)
    t35 = divide(eta_scaled, velocity_ratio, w8)
    t36 = divide(t33, t35, w7)
    t37 = add(t34, t36, w0)
    t38 = divide(delta_scaled, velocity_ratio, w7)
    t39 = divide(tracking_index, t38, w7)
    t41 = multiply(delta_scaled, n4, updated_22)
    t42 = add(t13, t41, w4)
    t43 = multiply(eta_scaled, n1, updated_22)
    t44 = multiply(t43, t42, updated_22)
    t45 = multiply(velocity_ratio, t44, updated_22)
    t46 = multiply(velocity_ratio, n4, w4)
    t47 = multiply(t3, t46, w1)
    t48 = multiply(tracking_index, t20, w3)
    t49 = add(t47, t48, w1)
    t50 = divide(t45, t49, updated_22)
    t51 = divide(t50, t28, updated_22)
    t52 = multiply(sigma_scaled, velocity_ratio, w5)
    t53 = add(t52, tracking_index, w5)
    t54 = multiply(t53, eta_scaled, w5)
    t55 = divide(t54, t49, w5)
    t56 = divide(t55, t28, w5)
    t57 = square(t51, w1)
    t58 = square(t56, w3)
    t59 = divide(t57, tracking_index, w1)
    t60 = divide(t58, t35, w3)
    t61 = add(t59, t60, w1)
    t63 = multiply(t29, t51, w2)
    t64 = divide(t63, tracking_index, w2)
    t65 = multiply(t31, t56, updated_12)
    t66 = divide(t65, t35, updated_12)
    t67 = multiply(t39, t64, w2)
    t68 = multiply(t39, t66, updated_12)
    multiply(t39, t37, updated_11)
    multiply(t39, t61, updated_22)
    subtract(t67, t68, updated_12)


_UPDATED_COVARIANCE_BY_TRACKING_INDEX = Signature(
    "updated_covariance_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("updated_11", "updated_12", "updated_22"),
    9,
    _updated_covariance_by_tracking_index_block,
    numbers=_updated_covariance_by_tracking_index_of_numbers,
)


class UpdatedCovarianceByVelocityRatio(NamedTuple):
    """Result of `updated_covariance_by_velocity_ratio`."""

    updated_11: Real
    """Derivative by S of the variance of the updated position over sigma_o^2."""
    updated_12: Real
    """Derivative by S of the covariance of updated position and velocity times T/sigma_o^2."""
    updated_22: Real
    """Derivative by S of the variance of the updated velocity times T^2/sigma_o^2."""


def updated_covariance_by_velocity_ratio(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdatedCovarianceByVelocityRatio:
    """First derivatives of the updated covariance by velocity_ratio.

        d/dS with Lambda held of what follows. A change of the noise moves the
        covariance by a sum over the closed loop, which is a mean over z = 1 and z = -1: a
        variance's derivative is S/delta times squares over Lambda w and over eta, a
        covariance's has products in place of the squares.
        The entries themselves:
        updated_11 = U11, updated_12 = U12, updated_22 = U22,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = (S^2 g + Lambda^2/sigma)/delta,
        s = 2 U12 + U22 + Lambda^2/4,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    updated_11: derivative by S of the variance of the updated position over sigma_o^2. Relative
        error at most 26.09 * 2^-52 (float64), 24.44 * 2^-23 (float32), proved for every input.
    updated_12: derivative by S of the covariance of updated position and velocity times
        T/sigma_o^2. Relative error at most 27.00 * 2^-52 (float64), 24.61 * 2^-23 (float32), proved
        for every input.
    updated_22: derivative by S of the variance of the updated velocity times T^2/sigma_o^2.
        Relative error at most 28.24 * 2^-52 (float64), 34.84 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-30 <= tracking_index <= 1e30
        and 1e-30 <= velocity_ratio <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UpdatedCovarianceByVelocityRatio,
                _updated_covariance_by_velocity_ratio_of_numbers(tracking_index, velocity_ratio),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedCovarianceByVelocityRatio(
        *evaluate(
            _UPDATED_COVARIANCE_BY_VELOCITY_RATIO,
            (tracking_index, velocity_ratio),
            out,
            workers,
        )
    )


def _updated_covariance_by_velocity_ratio_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t5 = t3 * 4.0
    t8 = form.sqrt((t5 + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t25 = (tracking_index * t8) / (t2 + t5)
    t26 = t25 + velocity_ratio
    t27 = tracking_index / t26
    t33 = ((t18 * t27) + (t2 * 0.5)) / velocity_ratio
    t35 = ((((t13 + t8) * 0.5) + t18) * 0.5) / velocity_ratio
    t36 = (t33 / velocity_ratio) / t35
    t39 = ((t25 / t26) / t35) * 2.0
    t43 = t8 / velocity_ratio
    t45 = ((t36 * t36) / tracking_index) + ((t39 * t39) / t43)
    t47 = velocity_ratio / (t18 / velocity_ratio)
    t49 = (t27 * (velocity_ratio * t25)) / velocity_ratio
    t52 = t49 + (t36 * 2.0)
    t56 = ((t36 * t49) / tracking_index) + ((t39 * t52) / t43)
    t62 = ((t49 * t49) / tracking_index) + ((t52 * t52) / t43)
    t48 = t47 * t45
    t57 = t47 * t56
    t63 = t47 * t62
    return (t48, t57, t63)


def _updated_covariance_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w3)
    t7 = multiply(t6, n0, w3)
    eta_scaled = sqrt(t7, updated_11)
    t9 = multiply(t3, n1, w1)
    t11 = add(t9, n2, w1)
    t12 = multiply(t2, t11, w1)
    t13 = multiply(tracking_index, velocity_ratio, w3)
    t15 = multiply(eta_scaled, n3, w4)
    t16 = multiply(t13, t15, w4)
    t17 = add(t12, t16, w1)
    delta_scaled = sqrt(t17, updated_12)
    t19 = add(t13, eta_scaled, w3)
    t20 = multiply(t19, n3, w3)
    t21 = add(t20, delta_scaled, w3)
    sigma_scaled = multiply(t21, n3, w3)
    t23 = add(t2, t5, w2)
    t24 = multiply(tracking_index, eta_scaled, w1)
    coupling_scaled = divide(t24, t23, updated_22)
    t26 = add(coupling_scaled, velocity_ratio, w1)
    cross_share = divide(tracking_index, t26, w2)
    t28 = multiply(velocity_ratio, coupling_scaled, w4)
    rest_scaled = multiply(cross_share, t28, w4)
    t30 = multiply(delta_scaled, cross_share, w2)
    t31 = multiply(t2, n3, w0)
    t32 = add(t30, t31, w2)
    t33 = divide(t32, velocity_ratio, w2)
    t34 = divide(t33, velocity_ratio, w2)
    t35 = divide(sigma_scaled, velocity_ratio, w3)
    t36 = divide(t34, t35, w2)
    t37 = divide(coupling_scaled, t26, updated_22)
    t38 = divide(t37, t35, updated_22)
    t39 = multiply(t38, n4, updated_22)
    t40 = square(t36, w0)
    t41 = square(t39, w1)
    t42 = divide(t40, tracking_index, w0)
    t43 = divide(eta_scaled, velocity_ratio, updated_11)
    t44 = divide(t41, t43, w1)
    t45 = add(t42, t44, w0)
    t46 = divide(delta_scaled, velocity_ratio, updated_12)
    t47 = divide(velocity_ratio, t46, w1)
    t49 = divide(rest_scaled, velocity_ratio, w4)
    t50 = multiply(t36, t49, w3)
    t51 = multiply(t36, n4, w2)
    t52 = add(t49, t51, w2)
    t53 = multiply(t39, t52, updated_22)
    t54 = divide(t50, tracking_index, w3)
    t55 = divide(t53, t43, updated_22)
    t56 = add(t54, t55, w3)
    t58 = square(t49, w4)
    t59 = square(t52, w2)
    t60 = divide(t58, tracking_index, w4)
    t61 = divide(t59, t43, w2)
    t62 = add(t60, t61, w4)
    multiply(t47, t45, updated_11)
    multiply(t47, t56, updated_12)
    multiply(t47, t62, updated_22)


_UPDATED_COVARIANCE_BY_VELOCITY_RATIO = Signature(
    "updated_covariance_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("updated_11", "updated_12", "updated_22"),
    5,
    _updated_covariance_by_velocity_ratio_block,
    numbers=_updated_covariance_by_velocity_ratio_of_numbers,
)


class KnownVelocity(NamedTuple):
    """Result of `known_velocity`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_o^2."""


def known_velocity(
    tracking_index: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> KnownVelocity:
    """The position's variances where the velocity is known exactly, S = 0.

        predicted_11 = Lambda^2/4, the limit for S -> 0; that of the updated variance is 0

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.

    predicted_11: variance of the predicted position over sigma_o^2. Relative error at most 0.51 *
        2^-52 (float64), 0.51 * 2^-23 (float32), proved for 1e-12 <= tracking_index <=
        1000000000000.0 (float64) and 1e-08 <= tracking_index <= 1e08 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and 1e-12 <= tracking_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(KnownVelocity, _known_velocity_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return KnownVelocity(*evaluate(_KNOWN_VELOCITY, (tracking_index,), out, workers))


def _known_velocity_of_numbers(tracking_index: float, _form: Form = Double) -> tuple[float, ...]:
    t3 = (tracking_index * tracking_index) * 0.25
    return (t3,)


def _known_velocity_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.25
) -> None:
    (tracking_index,) = given
    (predicted_11,) = out
    (w0,) = work
    t1 = square(tracking_index, w0)
    multiply(t1, n0, predicted_11)


_KNOWN_VELOCITY = Signature(
    "known_velocity",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11",),
    1,
    _known_velocity_block,
    numbers=_known_velocity_of_numbers,
)


class ClosedLoopPoles(NamedTuple):
    """Result of `closed_loop_poles`."""

    half_sum: Real
    """Half the sum of the poles, the real part of each where they are complex."""
    modulus: Real
    """The geometric mean of their moduli, the modulus of each where they are complex."""
    quarter_discriminant: Real
    """The square of half their difference, negative where they are complex."""


def closed_loop_poles(
    tracking_index: ArrayLike,
    velocity_ratio: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> ClosedLoopPoles:
    """Closed-loop poles: half their sum, their modulus, a quarter of the discriminant.

        z = half_sum -+ sqrt(quarter_discriminant), product of both modulus^2 = 1/sigma^2,
        half_sum = Lambda^2/(2 m sigma) (4/Lambda^2 + 1/S^2 - 1/4),
        quarter_discriminant = (Lambda^2/(2 delta sigma))^2 ((1/S^2 - 1/4)^2 - 4/Lambda^2),
        sigma, m and delta as in gains. Near the curve where the poles meet their difference is
        the square root of a difference: the poles themselves have half the digits there.

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-6 and at most 1e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e6.

    half_sum: half the sum of the poles, the real part of each where they are complex. Error over
        the sum of its terms' sizes at most 7.71 * 2^-52 (float64), 7.66 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: the real part of complex poles vanishes
        on a curve. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 2e-7 in float64 and 0.007 in float32 of what its error
        is relative to.
    modulus: the geometric mean of their moduli, the modulus of each where they are complex.
        Relative error at most 2.75 * 2^-52 (float64), 2.75 * 2^-23 (float32), proved for every
        input.
    quarter_discriminant: the square of half their difference, negative where they are complex.
        Error over the sum of its terms' sizes at most 15.99 * 2^-52 (float64), 15.99 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: the poles meet on a
        curve. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or
        more only where the value is below 5e-7 in float64 and 0.02 in float32 of what its error is
        relative to.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and type(velocity_ratio) is float
        and 1e-12 <= tracking_index <= 1000000000000.0
        and 1e-12 <= velocity_ratio <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                ClosedLoopPoles, _closed_loop_poles_of_numbers(tracking_index, velocity_ratio)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ClosedLoopPoles(
        *evaluate(_CLOSED_LOOP_POLES, (tracking_index, velocity_ratio), out, workers)
    )


def _closed_loop_poles_of_numbers(
    tracking_index: float,
    velocity_ratio: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = tracking_index * tracking_index
    t3 = velocity_ratio * velocity_ratio
    t8 = form.sqrt(((t3 * 4.0) + t2) * 4.0)
    t13 = tracking_index * velocity_ratio
    t17 = (t2 * ((t3 * 0.25) + 1.0)) + (t13 * (t8 * 0.5))
    t18 = form.sqrt(t17)
    t19 = t13 + t8
    t22 = ((t19 * 0.5) + t18) * 0.5
    t24 = (velocity_ratio / t19) * velocity_ratio
    t29 = (tracking_index / t19) * (tracking_index / t22)
    t33 = (velocity_ratio + -2.0) * (velocity_ratio + 2.0)
    t34 = t33 * 0.25
    t42 = tracking_index / ((t18 * t22) * 2.0)
    t44 = (tracking_index * t42) * t34
    t47 = (velocity_ratio * t42) * (velocity_ratio * 2.0)
    t36 = (t24 * (4.0 / t22)) - (t29 * t34)
    t39 = velocity_ratio / t22
    t50 = (t44 * t44) - (t47 * t47)
    return (t36, t39, t50)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = 1.0,
    n3: float = 0.5,
    n4: float = -2.0,
    n5: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    half_sum, modulus, quarter_discriminant = out
    w0, w1, w2, w3 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = multiply(t3, n0, w2)
    t6 = add(t5, t2, w2)
    t7 = multiply(t6, n0, w2)
    eta_scaled = sqrt(t7, half_sum)
    t9 = multiply(t3, n1, w1)
    t11 = add(t9, n2, w1)
    t12 = multiply(t2, t11, w0)
    t13 = multiply(tracking_index, velocity_ratio, w1)
    t15 = multiply(eta_scaled, n3, w2)
    t16 = multiply(t13, t15, w2)
    t17 = add(t12, t16, w0)
    delta_scaled = sqrt(t17, modulus)
    t19 = add(t13, eta_scaled, w1)
    t20 = multiply(t19, n3, w0)
    t21 = add(t20, delta_scaled, w0)
    sigma_scaled = multiply(t21, n3, w0)
    t23 = divide(velocity_ratio, t19, quarter_discriminant)
    t24 = multiply(t23, velocity_ratio, quarter_discriminant)
    t25 = divide(n0, sigma_scaled, w2)
    t26 = multiply(t24, t25, quarter_discriminant)
    t27 = divide(tracking_index, t19, w1)
    t28 = divide(tracking_index, sigma_scaled, w2)
    t29 = multiply(t27, t28, w1)
    t31 = add(velocity_ratio, n4, w2)
    t32 = add(velocity_ratio, n5, half_sum)
    t33 = multiply(t31, t32, w2)
    t34 = multiply(t33, n1, w2)
    t35 = multiply(t29, t34, w1)
    t40 = multiply(delta_scaled, sigma_scaled, modulus)
    t41 = multiply(t40, n5, modulus)
    t42 = divide(tracking_index, t41, modulus)
    t43 = multiply(tracking_index, t42, half_sum)
    t44 = multiply(t43, t34, half_sum)
    t45 = multiply(velocity_ratio, t42, modulus)
    t46 = multiply(velocity_ratio, n5, w2)
    t47 = multiply(t45, t46, modulus)
    t48 = square(t44, w2)
    t49 = square(t47, w3)
    subtract(t26, t35, half_sum)
    divide(velocity_ratio, sigma_scaled, modulus)
    subtract(t48, t49, quarter_discriminant)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN_4, _VELOCITY_RATIO_DOMAIN_4),
    ("half_sum", "modulus", "quarter_discriminant"),
    4,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)


class RealPoles(NamedTuple):
    """Result of `real_poles`."""

    positive_from: Real
    """The 1/S^2 from which on both poles are real and positive."""
    negative_up_to: Real
    """The 1/S^2 up to which both poles are real and negative, for no S where it is not positive."""


def real_poles(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> RealPoles:
    """The values of 1/S^2 between which the closed-loop poles are complex.

        positive_from = 1/4 + 2 r/Lambda, r = 1,
        negative_up_to = 1/4 - 2 r/Lambda = product of both/positive_from

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.

    positive_from: the 1/S^2 from which on both poles are real and positive. Relative error at most
        1.01 * 2^-52 (float64), 1.01 * 2^-23 (float32), proved for 1e-12 <= tracking_index <=
        1000000000000.0 (float64) and 1e-08 <= tracking_index <= 1e08 (float32).
    negative_up_to: the 1/S^2 up to which both poles are real and negative, for no S where it is not
        positive. Error over positive_from at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32),
        proved for 1e-12 <= tracking_index <= 1000000000000.0 (float64) and 1e-08 <= tracking_index
        <= 1e08 (float32). Digits that can be lost: up to 2.5 of 16 in float64; up to 3 of 7 in
        float32.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-acceleration
    """
    if (
        type(tracking_index) is float
        and 1e-12 <= tracking_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(RealPoles, _real_poles_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RealPoles(*evaluate(_REAL_POLES, (tracking_index,), out, workers))


def _real_poles_of_numbers(tracking_index: float, _form: Form = Double) -> tuple[float, ...]:
    t4 = 0.25 + (2.0 / tracking_index)
    t7 = (tracking_index + 8.0) / tracking_index
    t10 = (tracking_index + -8.0) / tracking_index
    t14 = ((t7 * t10) * 0.0625) / t4
    return (t4, t14)


def _real_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 0.25,
    n2: float = 8.0,
    n3: float = -8.0,
    n4: float = 0.0625,
) -> None:
    (tracking_index,) = given
    positive_from, negative_up_to = out
    (w0,) = work
    t2 = divide(n0, tracking_index, positive_from)
    add(n1, t2, positive_from)
    t6 = add(tracking_index, n2, w0)
    t7 = divide(t6, tracking_index, negative_up_to)
    t9 = add(tracking_index, n3, w0)
    t10 = divide(t9, tracking_index, w0)
    t11 = multiply(t7, t10, negative_up_to)
    t13 = multiply(t11, n4, negative_up_to)
    divide(t13, positive_from, negative_up_to)


_REAL_POLES = Signature(
    "real_poles",
    (_TRACKING_INDEX_DOMAIN,),
    ("positive_from", "negative_up_to"),
    1,
    _real_poles_block,
    numbers=_real_poles_of_numbers,
)
