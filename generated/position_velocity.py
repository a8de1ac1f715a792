# Made by: gainproof generate position-velocity
# From: gainproof derive position-velocity, SymPy 1.14.0
"""Position and velocity measured, continuous white acceleration."""

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
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8.

    gain_11: position's gain on the measured position. Relative error at most 9.32 * 2^-52
        (float64), 9.10 * 2^-23 (float32), proved for every input.
    gain_12: position's gain on the measured velocity over T. Relative error at most 7.04 * 2^-52
        (float64), 6.96 * 2^-23 (float32), proved for every input.
    gain_21: velocity's gain on the measured position times T. Relative error at most 8.04 * 2^-52
        (float64), 7.95 * 2^-23 (float32), proved for every input.
    gain_22: velocity's gain on the measured velocity. Relative error at most 8.04 * 2^-52
        (float64), 7.86 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t5 = t3 / 12.0
    t7 = form.sqrt(t2 + t5)
    t13 = t2 * 4.0
    t16 = ((t3 / 3.0) + 16.0) * ((t13 + t3) * 0.25)
    t17 = form.sqrt(t16)
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t34 = (((t25 + t17) * 0.5) + t30) * 0.5
    t37 = (tracking_index * t17) / (t3 + t13)
    t39 = tracking_index / (t37 + t7)
    t42 = t39 * (t5 + (t7 * t37))
    t43 = t39 / t34
    t44 = t43 * t2
    t47 = (t42 + (t3 / t34)) / t30
    t51 = ((t42 / t34) + (t44 * t43)) / t47
    return (t51, t43, t44, t47)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, gain_12)
    t6 = add(t2, t5, w2)
    level_scaled = sqrt(t6, gain_21)
    t9 = divide(t3, n1, gain_22)
    t11 = add(t9, n2, gain_22)
    t13 = multiply(t2, n3, w2)
    t14 = add(t13, t3, w3)
    t15 = multiply(t14, n4, w3)
    t16 = multiply(t11, t15, gain_22)
    eta_scaled = sqrt(t16, gain_11)
    t19 = multiply(t3, n5, w3)
    t21 = add(t19, n6, w3)
    t22 = divide(t2, n1, gain_22)
    t23 = add(t22, t21, gain_22)
    t24 = multiply(t3, t23, gain_22)
    t25 = multiply(tracking_index, level_scaled, w3)
    t27 = multiply(eta_scaled, n7, w4)
    t28 = multiply(t25, t27, w4)
    t29 = add(t24, t28, gain_22)
    delta_scaled = sqrt(t29, gain_22)
    t31 = add(t25, eta_scaled, w3)
    t32 = multiply(t31, n7, w3)
    t33 = add(t32, delta_scaled, w3)
    sigma_scaled = multiply(t33, n7, w3)
    t35 = add(t3, t13, w2)
    t36 = multiply(tracking_index, eta_scaled, gain_11)
    coupling_scaled = divide(t36, t35, gain_11)
    t38 = add(coupling_scaled, level_scaled, w2)
    cross_share = divide(tracking_index, t38, w2)
    t40 = multiply(level_scaled, coupling_scaled, gain_21)
    t41 = add(t5, t40, gain_12)
    rest_scaled = multiply(cross_share, t41, w4)
    divide(cross_share, sigma_scaled, gain_12)
    multiply(gain_12, t2, gain_21)
    t45 = divide(t3, sigma_scaled, w1)
    t46 = add(rest_scaled, t45, w1)
    divide(t46, delta_scaled, gain_22)
    t48 = divide(rest_scaled, sigma_scaled, w4)
    t49 = multiply(gain_21, gain_12, w0)
    t50 = add(t48, t49, w4)
    divide(t50, gain_22, gain_11)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    5,
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
        s = 2 U12 + U22 + Lambda^2/3,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8.

    predicted_11: variance of the predicted position over sigma_o^2. Relative error at most 21.17 *
        2^-52 (float64), 14.40 * 2^-23 (float32), proved for every input.
    predicted_12: covariance of predicted position and velocity times T/sigma_o^2. Relative error at
        most 7.63 * 2^-52 (float64), 7.63 * 2^-23 (float32), proved for every input.
    predicted_22: variance of the predicted velocity times T^2/sigma_o^2. Relative error at most
        6.92 * 2^-52 (float64), 6.92 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t5 = t3 / 12.0
    t7 = form.sqrt(t2 + t5)
    t9 = t3 / 3.0
    t13 = t2 * 4.0
    t17 = form.sqrt((t9 + 16.0) * ((t13 + t3) * 0.25))
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t34 = (((t25 + t17) * 0.5) + t30) * 0.5
    t37 = (tracking_index * t17) / (t3 + t13)
    t39 = tracking_index / (t37 + t7)
    t42 = t39 * (t5 + (t7 * t37))
    t50 = (((t39 / t34) * t2) * 2.0) + (t2 * ((t42 + (t3 / t34)) / t30))
    t54 = (t42 + (t34 * (t50 + t9))) / t30
    t55 = t39 * t34
    t58 = (t30 * t39) + (t3 * 0.5)
    return (t54, t55, t58)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, predicted_11)
    t6 = add(t2, t5, w2)
    level_scaled = sqrt(t6, predicted_12)
    t9 = divide(t3, n1, predicted_22)
    t11 = add(t9, n2, w2)
    t13 = multiply(t2, n3, w3)
    t14 = add(t13, t3, w4)
    t15 = multiply(t14, n4, w4)
    t16 = multiply(t11, t15, w2)
    eta_scaled = sqrt(t16, w2)
    t19 = multiply(t3, n5, w4)
    t21 = add(t19, n6, w4)
    t22 = divide(t2, n1, w5)
    t23 = add(t22, t21, w5)
    t24 = multiply(t3, t23, w5)
    t25 = multiply(tracking_index, level_scaled, w4)
    t27 = multiply(eta_scaled, n7, w6)
    t28 = multiply(t25, t27, w6)
    t29 = add(t24, t28, w5)
    delta_scaled = sqrt(t29, w5)
    t31 = add(t25, eta_scaled, w4)
    t32 = multiply(t31, n7, w4)
    t33 = add(t32, delta_scaled, w4)
    sigma_scaled = multiply(t33, n7, w4)
    t35 = add(t3, t13, w3)
    t36 = multiply(tracking_index, eta_scaled, w2)
    coupling_scaled = divide(t36, t35, w2)
    t38 = add(coupling_scaled, level_scaled, w3)
    cross_share = divide(tracking_index, t38, w3)
    t40 = multiply(level_scaled, coupling_scaled, predicted_12)
    t41 = add(t5, t40, predicted_11)
    rest_scaled = multiply(cross_share, t41, predicted_11)
    t43 = divide(cross_share, sigma_scaled, w2)
    t44 = multiply(t43, t2, w2)
    t45 = multiply(t44, n8, w2)
    t46 = divide(t3, sigma_scaled, w6)
    t47 = add(rest_scaled, t46, w6)
    t48 = divide(t47, delta_scaled, w6)
    t49 = multiply(t2, t48, w0)
    t50 = add(t45, t49, w2)
    t51 = add(t50, t9, w2)
    t52 = multiply(sigma_scaled, t51, w2)
    t53 = add(rest_scaled, t52, predicted_11)
    t56 = multiply(delta_scaled, cross_share, w0)
    t57 = multiply(t3, n7, w1)
    divide(t53, delta_scaled, predicted_11)
    multiply(cross_share, sigma_scaled, predicted_12)
    add(t56, t57, predicted_22)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("predicted_11", "predicted_12", "predicted_22"),
    7,
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
        s = 2 U12 + U22 + Lambda^2/3,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8.

    updated_11: variance of the updated position over sigma_o^2. Relative error at most 22.10 *
        2^-52 (float64), 15.78 * 2^-23 (float32), proved for every input.
    updated_12: covariance of updated position and velocity times T/sigma_o^2. Relative error at
        most 8.75 * 2^-52 (float64), 8.55 * 2^-23 (float32), proved for every input.
    updated_22: variance of the updated velocity times T^2/sigma_o^2. Relative error at most 14.45 *
        2^-52 (float64), 9.75 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t5 = t3 / 12.0
    t7 = form.sqrt(t2 + t5)
    t9 = t3 / 3.0
    t13 = t2 * 4.0
    t17 = form.sqrt((t9 + 16.0) * ((t13 + t3) * 0.25))
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t34 = (((t25 + t17) * 0.5) + t30) * 0.5
    t37 = (tracking_index * t17) / (t3 + t13)
    t39 = tracking_index / (t37 + t7)
    t42 = t39 * (t5 + (t7 * t37))
    t44 = (t39 / t34) * t2
    t49 = t2 * ((t42 + (t3 / t34)) / t30)
    t53 = t2 * ((((t44 * 2.0) + t49) + t9) / t34)
    t55 = (t42 + t53) / t30
    return (t55, t44, t49)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, updated_12)
    t6 = add(t2, t5, w2)
    level_scaled = sqrt(t6, updated_22)
    t9 = divide(t3, n1, updated_11)
    t11 = add(t9, n2, w2)
    t13 = multiply(t2, n3, w3)
    t14 = add(t13, t3, w4)
    t15 = multiply(t14, n4, w4)
    t16 = multiply(t11, t15, w2)
    eta_scaled = sqrt(t16, w2)
    t19 = multiply(t3, n5, w4)
    t21 = add(t19, n6, w4)
    t22 = divide(t2, n1, w5)
    t23 = add(t22, t21, w5)
    t24 = multiply(t3, t23, w5)
    t25 = multiply(tracking_index, level_scaled, w4)
    t27 = multiply(eta_scaled, n7, w6)
    t28 = multiply(t25, t27, w6)
    t29 = add(t24, t28, w5)
    delta_scaled = sqrt(t29, w5)
    t31 = add(t25, eta_scaled, w4)
    t32 = multiply(t31, n7, w4)
    t33 = add(t32, delta_scaled, w4)
    sigma_scaled = multiply(t33, n7, w4)
    t35 = add(t3, t13, w3)
    t36 = multiply(tracking_index, eta_scaled, w2)
    coupling_scaled = divide(t36, t35, w2)
    t38 = add(coupling_scaled, level_scaled, w3)
    cross_share = divide(tracking_index, t38, w3)
    t40 = multiply(level_scaled, coupling_scaled, updated_22)
    t41 = add(t5, t40, updated_12)
    rest_scaled = multiply(cross_share, t41, w2)
    t43 = divide(cross_share, sigma_scaled, w3)
    multiply(t43, t2, updated_12)
    t45 = multiply(updated_12, n8, w3)
    t46 = divide(t3, sigma_scaled, w1)
    t47 = add(rest_scaled, t46, w1)
    t48 = divide(t47, delta_scaled, w1)
    multiply(t2, t48, updated_22)
    t50 = add(t45, updated_22, w3)
    t51 = add(t50, t9, w3)
    t52 = divide(t51, sigma_scaled, w3)
    t53 = multiply(t2, t52, w0)
    t54 = add(rest_scaled, t53, w2)
    divide(t54, delta_scaled, updated_11)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("updated_11", "updated_12", "updated_22"),
    7,
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
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    gain_11: derivative by Lambda of the position's gain on the measured position. Relative error at
        most 38.88 * 2^-52 (float64), 37.11 * 2^-23 (float32), proved for every input.
    gain_12: derivative by Lambda of the position's gain on the measured velocity over T. Error over
        the sum of its terms' sizes at most 39.75 * 2^-52 (float64), 38.84 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: what it is the derivative of grows in one
        part of the domain and falls in another, so that it vanishes between. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 2e-6 in float64 and 0.04 in float32 of what its error is relative to.
    gain_21: derivative by Lambda of the velocity's gain on the measured position times T. Error
        over the sum of its terms' sizes at most 38.75 * 2^-52 (float64), 37.84 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: what it is the derivative of grows
        in one part of the domain and falls in another, so that it vanishes between. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 1e-6 in float64 and 0.04 in float32 of what its error is relative to.
    gain_22: derivative by Lambda of the velocity's gain on the measured velocity. Relative error at
        most 46.88 * 2^-52 (float64), 44.78 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t7 = form.sqrt(t2 + (t3 / 12.0))
    t9 = t3 / 3.0
    t11 = t9 + 16.0
    t13 = t2 * 4.0
    t17 = form.sqrt(t11 * ((t13 + t3) * 0.25))
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t32 = (t25 + t17) * 0.5
    t34 = (t32 + t30) * 0.5
    t37 = (tracking_index * t17) / (t3 + t13)
    t38 = t37 + t7
    t39 = tracking_index / t38
    t41 = t34 / velocity_ratio
    t42 = (t7 / t38) / t41
    t47 = (t25 + (t30 * 2.0)) + (t17 * (t9 / t11))
    t54 = (t2 * (t7 * 2.0)) + (tracking_index * t32)
    t56 = ((t7 * ((t17 * 0.25) * t47)) / t54) / t41
    t59 = tracking_index * (t7 / velocity_ratio)
    t62 = (t37 / t38) / t41
    t66 = (((t34 * t7) + tracking_index) * t17) / t54
    t67 = t66 / t41
    t69 = t17 / velocity_ratio
    t71 = t39 * velocity_ratio
    t75 = ((t30 * t39) + (t3 * 0.5)) / velocity_ratio
    t76 = t75 / velocity_ratio
    t77 = t76 / t41
    t80 = (t76 + 2.0) / t41
    t83 = tracking_index / (t30 / velocity_ratio)
    t84 = t83 * ((t42 * t56) / t59)
    t87 = ((t71 * t77) / t59) + ((t71 * t80) / t69)
    t90 = t83 * (((t62 * t67) / t69) + (t87 / 12.0))
    t92 = (t84 / velocity_ratio) / velocity_ratio
    t94 = (t90 / velocity_ratio) / velocity_ratio
    t95 = t71 * t71
    t100 = ((t56 * t56) / t59) + ((t67 * t67) / t69)
    t105 = t100 + (((t95 / t59) + (t95 / t69)) / 12.0)
    t113 = ((t42 * t42) / t59) + ((t62 * t62) / t69)
    t118 = ((t77 * t77) / t59) + ((t80 * t80) / t69)
    t108 = ((t83 * t105) / velocity_ratio) / velocity_ratio
    t121 = t83 * (t113 + (t118 / 12.0))
    t122 = t92 - t94
    t124 = t84 - t90
    return (t121, t122, t124, t108)


def _gains_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, gain_22)
    t6 = add(t2, t5, gain_22)
    level_scaled = sqrt(t6, gain_11)
    t9 = divide(t3, n1, gain_12)
    t11 = add(t9, n2, gain_22)
    t13 = multiply(t2, n3, w2)
    t14 = add(t13, t3, w3)
    t15 = multiply(t14, n4, w3)
    t16 = multiply(t11, t15, w3)
    eta_scaled = sqrt(t16, gain_21)
    t19 = multiply(t3, n5, w3)
    t21 = add(t19, n6, w3)
    t22 = divide(t2, n1, w4)
    t23 = add(t22, t21, w4)
    t24 = multiply(t3, t23, w4)
    t25 = multiply(tracking_index, level_scaled, w3)
    t27 = multiply(eta_scaled, n7, w5)
    t28 = multiply(t25, t27, w5)
    t29 = add(t24, t28, w4)
    delta_scaled = sqrt(t29, w4)
    t31 = add(t25, eta_scaled, w5)
    t32 = multiply(t31, n7, w5)
    t33 = add(t32, delta_scaled, w6)
    sigma_scaled = multiply(t33, n7, w6)
    t35 = add(t3, t13, w2)
    t36 = multiply(tracking_index, eta_scaled, w7)
    coupling_scaled = divide(t36, t35, w7)
    t38 = add(coupling_scaled, level_scaled, w2)
    cross_share = divide(tracking_index, t38, w8)
    t40 = divide(level_scaled, t38, w9)
    t41 = divide(sigma_scaled, velocity_ratio, w10)
    t42 = divide(t40, t41, w9)
    t43 = divide(t9, t11, gain_12)
    t44 = multiply(eta_scaled, t43, gain_12)
    t45 = multiply(delta_scaled, n8, gain_22)
    t46 = add(t25, t45, w3)
    t47 = add(t46, t44, w3)
    t48 = multiply(eta_scaled, n4, gain_12)
    t49 = multiply(t48, t47, gain_12)
    t50 = multiply(level_scaled, t49, gain_12)
    t51 = multiply(level_scaled, n8, w3)
    t52 = multiply(t2, t51, w0)
    t53 = multiply(tracking_index, t32, w5)
    t54 = add(t52, t53, w0)
    t55 = divide(t50, t54, gain_12)
    t56 = divide(t55, t41, gain_12)
    t57 = multiply(t42, t56, w3)
    t58 = divide(level_scaled, velocity_ratio, w5)
    t59 = multiply(tracking_index, t58, w5)
    t60 = divide(t57, t59, w3)
    t61 = divide(coupling_scaled, t38, w7)
    t62 = divide(t61, t41, w7)
    t63 = multiply(sigma_scaled, level_scaled, w6)
    t64 = add(t63, tracking_index, w6)
    t65 = multiply(t64, eta_scaled, w6)
    t66 = divide(t65, t54, w6)
    t67 = divide(t66, t41, w6)
    t68 = multiply(t62, t67, w0)
    t69 = divide(eta_scaled, velocity_ratio, gain_21)
    t70 = divide(t68, t69, w0)
    t71 = multiply(cross_share, velocity_ratio, w2)
    t72 = multiply(delta_scaled, cross_share, w8)
    t73 = multiply(t3, n7, w1)
    t74 = add(t72, t73, w8)
    t75 = divide(t74, velocity_ratio, w8)
    t76 = divide(t75, velocity_ratio, w8)
    t77 = divide(t76, t41, w1)
    t78 = multiply(t71, t77, gain_11)
    t79 = add(t76, n8, w8)
    t80 = divide(t79, t41, w8)
    t81 = multiply(t71, t80, w10)
    t82 = divide(delta_scaled, velocity_ratio, w4)
    t83 = divide(tracking_index, t82, w4)
    t84 = multiply(t83, t60, w3)
    t85 = divide(t78, t59, gain_11)
    t86 = divide(t81, t69, w10)
    t87 = add(t85, t86, gain_11)
    t88 = divide(t87, n0, gain_11)
    t89 = add(t70, t88, w0)
    t90 = multiply(t83, t89, w0)
    t91 = divide(t84, velocity_ratio, w10)
    t92 = divide(t91, velocity_ratio, w10)
    t93 = divide(t90, velocity_ratio, gain_11)
    t94 = divide(t93, velocity_ratio, w11)
    t95 = square(t71, w2)
    t96 = square(t56, gain_12)
    t97 = square(t67, w6)
    t98 = divide(t96, t59, gain_12)
    t99 = divide(t97, t69, w6)
    t100 = add(t98, t99, gain_12)
    t101 = divide(t95, t59, w6)
    t102 = divide(t95, t69, w2)
    t103 = add(t101, t102, w6)
    t104 = divide(t103, n0, w6)
    t105 = add(t100, t104, gain_12)
    t106 = multiply(t83, t105, gain_12)
    t107 = divide(t106, velocity_ratio, gain_12)
    t109 = square(t42, w9)
    t110 = square(t62, w7)
    t111 = divide(t109, t59, w9)
    t112 = divide(t110, t69, w7)
    t113 = add(t111, t112, w9)
    t114 = square(t77, w1)
    t115 = square(t80, w8)
    t116 = divide(t114, t59, w1)
    t117 = divide(t115, t69, w8)
    t118 = add(t116, t117, w1)
    t119 = divide(t118, n0, w1)
    t120 = add(t113, t119, w9)
    divide(t107, velocity_ratio, gain_22)
    multiply(t83, t120, gain_11)
    subtract(t92, t94, gain_12)
    subtract(t84, t90, gain_21)


_GAINS_BY_TRACKING_INDEX = Signature(
    "gains_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    12,
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
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    gain_11: derivative by S of the position's gain on the measured position. Relative error at most
        36.63 * 2^-52 (float64), 35.36 * 2^-23 (float32), proved for every input.
    gain_12: derivative by S of the position's gain on the measured velocity over T. Error over the
        sum of its terms' sizes at most 38.00 * 2^-52 (float64), 36.94 * 2^-23 (float32), proved for
        every input. Cancellation, condition number 1: what it is the derivative of grows in one
        part of the domain and falls in another, so that it vanishes between. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 1e-6 in float64 and 0.03 in float32 of what its error is relative to.
    gain_21: derivative by S of the velocity's gain on the measured position times T. Relative error
        at most 36.50 * 2^-52 (float64), 35.44 * 2^-23 (float32), proved for every input.
    gain_22: derivative by S of the velocity's gain on the measured velocity. Relative error at most
        48.88 * 2^-52 (float64), 46.78 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t5 = t3 / 12.0
    t7 = form.sqrt(t2 + t5)
    t9 = t3 / 3.0
    t11 = t9 + 16.0
    t13 = t2 * 4.0
    t17 = form.sqrt(t11 * ((t13 + t3) * 0.25))
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t32 = (t25 + t17) * 0.5
    t34 = (t32 + t30) * 0.5
    t37 = (tracking_index * t17) / (t3 + t13)
    t38 = t37 + t7
    t39 = tracking_index / t38
    t47 = ((t30 * t39) + (t3 * 0.5)) / velocity_ratio
    t49 = t34 / velocity_ratio
    t50 = (t47 / velocity_ratio) / t49
    t53 = ((t37 / t38) / t49) * 2.0
    t57 = tracking_index * (t7 / velocity_ratio)
    t59 = t17 / velocity_ratio
    t61 = ((t50 * t50) / t57) + ((t53 * t53) / t59)
    t62 = t30 / velocity_ratio
    t63 = velocity_ratio / t62
    t65 = (t39 * (t5 + (t7 * t37))) / velocity_ratio
    t72 = ((t50 * t65) / t57) + ((t53 * (t65 + (t50 * 2.0))) / t59)
    t73 = t63 * t72
    t75 = t39 * velocity_ratio
    t76 = t75 * t75
    t81 = (t25 + (t30 * 2.0)) + (t17 * (t9 / t11))
    t88 = (t2 * (t7 * 2.0)) + (tracking_index * t32)
    t90 = ((t7 * ((t17 * 0.25) * t81)) / t88) / t49
    t94 = (((t34 * t7) + tracking_index) * t17) / t88
    t95 = t94 / t49
    t100 = ((t90 * t90) / t57) + ((t95 * t95) / t59)
    t105 = t100 + (((t76 / t57) + (t76 / t59)) / 12.0)
    t107 = ((tracking_index / t62) * t105) * 0.5
    t113 = ((t75 * 2.0) * (t75 / (t62 * t59))) + (tracking_index * t107)
    t115 = (2.0 / velocity_ratio) / velocity_ratio
    t120 = (t73 / velocity_ratio) / velocity_ratio
    t64 = t63 * t61
    t118 = -(t115 * (t113 / velocity_ratio))
    t123 = t120 - (((t39 / t34) / velocity_ratio) * 2.0)
    return (t64, t123, t73, t118)


def _gains_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, gain_21)
    t6 = add(t2, t5, w2)
    level_scaled = sqrt(t6, gain_11)
    t9 = divide(t3, n1, gain_22)
    t11 = add(t9, n2, w2)
    t13 = multiply(t2, n3, w3)
    t14 = add(t13, t3, w4)
    t15 = multiply(t14, n4, w4)
    t16 = multiply(t11, t15, w4)
    eta_scaled = sqrt(t16, gain_12)
    t19 = multiply(t3, n5, w4)
    t21 = add(t19, n6, w4)
    t22 = divide(t2, n1, w5)
    t23 = add(t22, t21, w5)
    t24 = multiply(t3, t23, w5)
    t25 = multiply(tracking_index, level_scaled, w4)
    t27 = multiply(eta_scaled, n7, w6)
    t28 = multiply(t25, t27, w6)
    t29 = add(t24, t28, w5)
    delta_scaled = sqrt(t29, w5)
    t31 = add(t25, eta_scaled, w6)
    t32 = multiply(t31, n7, w6)
    t33 = add(t32, delta_scaled, w7)
    sigma_scaled = multiply(t33, n7, w7)
    t35 = add(t3, t13, w3)
    t36 = multiply(tracking_index, eta_scaled, w8)
    coupling_scaled = divide(t36, t35, w8)
    t38 = add(coupling_scaled, level_scaled, w3)
    cross_share = divide(tracking_index, t38, w9)
    t40 = multiply(level_scaled, coupling_scaled, w10)
    t41 = add(t5, t40, gain_21)
    rest_scaled = multiply(cross_share, t41, gain_21)
    t43 = divide(cross_share, sigma_scaled, w10)
    t44 = multiply(delta_scaled, cross_share, w11)
    t45 = multiply(t3, n7, w1)
    t46 = add(t44, t45, w11)
    t47 = divide(t46, velocity_ratio, w11)
    t48 = divide(t47, velocity_ratio, w11)
    t49 = divide(sigma_scaled, velocity_ratio, w1)
    t50 = divide(t48, t49, w11)
    t51 = divide(coupling_scaled, t38, w8)
    t52 = divide(t51, t49, w8)
    t53 = multiply(t52, n8, w8)
    t54 = square(t50, w3)
    t55 = square(t53, w12)
    t56 = divide(level_scaled, velocity_ratio, w13)
    t57 = multiply(tracking_index, t56, w13)
    t58 = divide(t54, t57, w3)
    t59 = divide(eta_scaled, velocity_ratio, w14)
    t60 = divide(t55, t59, w12)
    t61 = add(t58, t60, w3)
    t62 = divide(delta_scaled, velocity_ratio, w12)
    t63 = divide(velocity_ratio, t62, w15)
    t65 = divide(rest_scaled, velocity_ratio, gain_21)
    t66 = multiply(t50, t65, w16)
    t67 = multiply(t50, n8, w11)
    t68 = add(t65, t67, gain_21)
    t69 = multiply(t53, t68, w8)
    t70 = divide(t66, t57, w16)
    t71 = divide(t69, t59, w8)
    t72 = add(t70, t71, w16)
    multiply(t63, t72, gain_21)
    t74 = divide(tracking_index, t62, w8)
    t75 = multiply(cross_share, velocity_ratio, w9)
    t76 = square(t75, w11)
    t77 = divide(t9, t11, gain_22)
    t78 = multiply(eta_scaled, t77, gain_22)
    t79 = multiply(delta_scaled, n8, w5)
    t80 = add(t25, t79, w4)
    t81 = add(t80, t78, w4)
    t82 = multiply(eta_scaled, n4, w2)
    t83 = multiply(t82, t81, w2)
    t84 = multiply(level_scaled, t83, w2)
    t85 = multiply(level_scaled, n8, w4)
    t86 = multiply(t2, t85, w0)
    t87 = multiply(tracking_index, t32, w6)
    t88 = add(t86, t87, w0)
    t89 = divide(t84, t88, w2)
    t90 = divide(t89, t49, w2)
    t91 = multiply(sigma_scaled, level_scaled, w7)
    t92 = add(t91, tracking_index, w7)
    t93 = multiply(t92, eta_scaled, w7)
    t94 = divide(t93, t88, w7)
    t95 = divide(t94, t49, w7)
    t96 = square(t90, w2)
    t97 = square(t95, w7)
    t98 = divide(t96, t57, w2)
    t99 = divide(t97, t59, w7)
    t100 = add(t98, t99, w2)
    t101 = divide(t76, t57, w13)
    t102 = divide(t76, t59, w11)
    t103 = add(t101, t102, w13)
    t104 = divide(t103, n0, w13)
    t105 = add(t100, t104, w2)
    t106 = multiply(t74, t105, w8)
    t107 = multiply(t106, n7, w8)
    t108 = multiply(tracking_index, t107, w8)
    t109 = multiply(t75, n8, w0)
    t110 = multiply(t62, t59, w12)
    t111 = divide(t75, t110, w9)
    t112 = multiply(t109, t111, w0)
    t113 = add(t112, t108, w0)
    t114 = divide(n8, velocity_ratio, w1)
    t115 = divide(t114, velocity_ratio, w1)
    t116 = divide(t113, velocity_ratio, w0)
    t117 = multiply(t115, t116, w1)
    t119 = divide(gain_21, velocity_ratio, w0)
    t120 = divide(t119, velocity_ratio, w0)
    t121 = divide(t43, velocity_ratio, w10)
    t122 = multiply(t121, n8, w10)
    multiply(t63, t61, gain_11)
    negative(t117, gain_22)
    subtract(t120, t122, gain_12)


_GAINS_BY_VELOCITY_RATIO = Signature(
    "gains_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    17,
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
        s = 2 U12 + U22 + Lambda^2/3,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-6 and at most 1e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-6 and at most 1e6.

    predicted_11: derivative by Lambda of the variance of the predicted position over sigma_o^2.
        Relative error at most 38.24 * 2^-52 (float64), 34.56 * 2^-23 (float32), proved for every
        input.
    predicted_12: derivative by Lambda of the covariance of predicted position and velocity times
        T/sigma_o^2. Relative error at most 36.37 * 2^-52 (float64), 31.33 * 2^-23 (float32), proved
        for every input.
    predicted_22: derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_o^2. Relative error at most 45.35 * 2^-52 (float64), 35.81 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t5 = t3 / 12.0
    t7 = form.sqrt(t2 + t5)
    t9 = t3 / 3.0
    t11 = t9 + 16.0
    t13 = t2 * 4.0
    t17 = form.sqrt(t11 * ((t13 + t3) * 0.25))
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t32 = (t25 + t17) * 0.5
    t34 = (t32 + t30) * 0.5
    t37 = (tracking_index * t17) / (t3 + t13)
    t38 = t37 + t7
    t39 = tracking_index / t38
    t42 = t39 * (t5 + (t7 * t37))
    t43 = t37 / t38
    t44 = t34 / velocity_ratio
    t45 = t7 / t38
    t46 = t44 * t45
    t47 = t44 * t43
    t51 = tracking_index * (t7 / velocity_ratio)
    t53 = t17 / velocity_ratio
    t55 = ((t46 * t46) / t51) + ((t47 * t47) / t53)
    t65 = ((t30 * t39) + (t3 * 0.5)) / velocity_ratio
    t68 = (t42 / velocity_ratio) + ((t65 / velocity_ratio) / t44)
    t70 = ((t39 / t34) + t45) * 2.0
    t71 = t44 * t70
    t76 = ((t68 * t68) / t51) + ((t71 * t71) / t53)
    t80 = tracking_index / (t30 / velocity_ratio)
    t82 = t39 * velocity_ratio
    t84 = (t2 * ((t42 + (t3 / t34)) / t30)) / t51
    t87 = (t82 / tracking_index) * ((t51 + t84) / tracking_index)
    t94 = (t2 * (t7 * 2.0)) + (tracking_index * t32)
    t95 = ((t2 * t7) + (tracking_index * t34)) / t94
    t101 = (t87 + (t43 * t95)) + (((t82 * t70) / t53) / 12.0)
    t104 = t82 * t82
    t109 = (t25 + (t30 * 2.0)) + (t17 * (t9 / t11))
    t114 = ((t7 * ((t17 * 0.25) * t109)) / t94) / t44
    t118 = (((t34 * t7) + tracking_index) * t17) / t94
    t119 = t118 / t44
    t124 = ((t114 * t114) / t51) + ((t119 * t119) / t53)
    t129 = t124 + (((t104 / t51) + (t104 / t53)) / 12.0)
    t81 = t80 * (t55 + (t76 / 12.0))
    t103 = t80 * (t44 * t101)
    t132 = (t80 * t129) + (tracking_index * 2.0)
    return (t81, t103, t132)


def _predicted_covariance_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16, w17 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, predicted_11)
    t6 = add(t2, t5, w2)
    level_scaled = sqrt(t6, predicted_12)
    t9 = divide(t3, n1, predicted_22)
    t11 = add(t9, n2, w2)
    t13 = multiply(t2, n3, w3)
    t14 = add(t13, t3, w4)
    t15 = multiply(t14, n4, w4)
    t16 = multiply(t11, t15, w4)
    eta_scaled = sqrt(t16, w4)
    t19 = multiply(t3, n5, w5)
    t21 = add(t19, n6, w5)
    t22 = divide(t2, n1, w6)
    t23 = add(t22, t21, w6)
    t24 = multiply(t3, t23, w6)
    t25 = multiply(tracking_index, level_scaled, w5)
    t27 = multiply(eta_scaled, n7, w7)
    t28 = multiply(t25, t27, w7)
    t29 = add(t24, t28, w6)
    delta_scaled = sqrt(t29, w6)
    t31 = add(t25, eta_scaled, w7)
    t32 = multiply(t31, n7, w7)
    t33 = add(t32, delta_scaled, w8)
    sigma_scaled = multiply(t33, n7, w8)
    t35 = add(t3, t13, w3)
    t36 = multiply(tracking_index, eta_scaled, w9)
    coupling_scaled = divide(t36, t35, w9)
    t38 = add(coupling_scaled, level_scaled, w3)
    cross_share = divide(tracking_index, t38, w10)
    t40 = multiply(level_scaled, coupling_scaled, w11)
    t41 = add(t5, t40, predicted_11)
    rest_scaled = multiply(cross_share, t41, predicted_11)
    t43 = divide(coupling_scaled, t38, w9)
    t44 = divide(sigma_scaled, velocity_ratio, w11)
    t45 = divide(level_scaled, t38, w3)
    t46 = multiply(t44, t45, w12)
    t47 = multiply(t44, t43, w13)
    t48 = square(t46, w12)
    t49 = square(t47, w13)
    t50 = divide(level_scaled, velocity_ratio, w14)
    t51 = multiply(tracking_index, t50, w14)
    t52 = divide(t48, t51, w12)
    t53 = divide(eta_scaled, velocity_ratio, w15)
    t54 = divide(t49, t53, w13)
    t55 = add(t52, t54, w12)
    t56 = divide(rest_scaled, velocity_ratio, w13)
    t57 = divide(cross_share, sigma_scaled, w16)
    t58 = divide(t3, sigma_scaled, w17)
    t59 = add(rest_scaled, t58, predicted_11)
    t60 = divide(t59, delta_scaled, predicted_11)
    t61 = multiply(t2, t60, predicted_11)
    t62 = multiply(delta_scaled, cross_share, w17)
    t63 = multiply(t3, n7, w1)
    t64 = add(t62, t63, w17)
    t65 = divide(t64, velocity_ratio, w17)
    t66 = divide(t65, velocity_ratio, w17)
    t67 = divide(t66, t44, w17)
    t68 = add(t56, t67, w13)
    t69 = add(t57, t45, w16)
    t70 = multiply(t69, n8, w16)
    t71 = multiply(t44, t70, w1)
    t72 = square(t68, w13)
    t73 = square(t71, w1)
    t74 = divide(t72, t51, w13)
    t75 = divide(t73, t53, w1)
    t76 = add(t74, t75, w13)
    t77 = divide(t76, n0, w13)
    t78 = add(t55, t77, w12)
    t79 = divide(delta_scaled, velocity_ratio, w1)
    t80 = divide(tracking_index, t79, w1)
    t82 = multiply(cross_share, velocity_ratio, w10)
    t83 = divide(t82, tracking_index, w3)
    t84 = divide(t61, t51, predicted_11)
    t85 = add(t51, t84, predicted_11)
    t86 = divide(t85, tracking_index, predicted_11)
    t87 = multiply(t83, t86, w3)
    t88 = multiply(t2, level_scaled, w13)
    t89 = multiply(tracking_index, sigma_scaled, w17)
    t90 = add(t88, t89, w13)
    t91 = multiply(level_scaled, n8, w17)
    t92 = multiply(t2, t91, w0)
    t93 = multiply(tracking_index, t32, w7)
    t94 = add(t92, t93, w0)
    t95 = divide(t90, t94, w13)
    t96 = multiply(t43, t95, w9)
    t97 = add(t87, t96, w3)
    t98 = multiply(t82, t70, w16)
    t99 = divide(t98, t53, w16)
    t100 = divide(t99, n0, w16)
    t101 = add(t97, t100, w3)
    t102 = multiply(t44, t101, w3)
    t104 = square(t82, w10)
    t105 = divide(t9, t11, predicted_22)
    t106 = multiply(eta_scaled, t105, predicted_22)
    t107 = multiply(delta_scaled, n8, w6)
    t108 = add(t25, t107, w5)
    t109 = add(t108, t106, w5)
    t110 = multiply(eta_scaled, n4, w2)
    t111 = multiply(t110, t109, w2)
    t112 = multiply(level_scaled, t111, w2)
    t113 = divide(t112, t94, w2)
    t114 = divide(t113, t44, w2)
    t115 = multiply(sigma_scaled, level_scaled, w8)
    t116 = add(t115, tracking_index, w8)
    t117 = multiply(t116, eta_scaled, w8)
    t118 = divide(t117, t94, w8)
    t119 = divide(t118, t44, w8)
    t120 = square(t114, w2)
    t121 = square(t119, w8)
    t122 = divide(t120, t51, w2)
    t123 = divide(t121, t53, w8)
    t124 = add(t122, t123, w2)
    t125 = divide(t104, t51, w14)
    t126 = divide(t104, t53, w10)
    t127 = add(t125, t126, w14)
    t128 = divide(t127, n0, w14)
    t129 = add(t124, t128, w2)
    t130 = multiply(t80, t129, w2)
    t131 = multiply(tracking_index, n8, w0)
    multiply(t80, t78, predicted_11)
    multiply(t80, t102, predicted_12)
    add(t130, t131, predicted_22)


_PREDICTED_COVARIANCE_BY_TRACKING_INDEX = Signature(
    "predicted_covariance_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_3, _VELOCITY_RATIO_DOMAIN_3),
    ("predicted_11", "predicted_12", "predicted_22"),
    18,
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
        s = 2 U12 + U22 + Lambda^2/3,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    predicted_11: derivative by S of the variance of the predicted position over sigma_o^2. Relative
        error at most 37.24 * 2^-52 (float64), 31.40 * 2^-23 (float32), proved for every input.
    predicted_12: derivative by S of the covariance of predicted position and velocity times
        T/sigma_o^2. Relative error at most 36.20 * 2^-52 (float64), 29.79 * 2^-23 (float32), proved
        for every input.
    predicted_22: derivative by S of the variance of the predicted velocity times T^2/sigma_o^2.
        Relative error at most 37.50 * 2^-52 (float64), 41.67 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t5 = t3 / 12.0
    t7 = form.sqrt(t2 + t5)
    t13 = t2 * 4.0
    t16 = ((t3 / 3.0) + 16.0) * ((t13 + t3) * 0.25)
    t17 = form.sqrt(t16)
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t37 = (tracking_index * t17) / (t3 + t13)
    t38 = t37 + t7
    t39 = tracking_index / t38
    t43 = (t39 * (t5 + (t7 * t37))) / velocity_ratio
    t47 = ((t30 * t39) + (t3 * 0.5)) / velocity_ratio
    t49 = ((((t25 + t17) * 0.5) + t30) * 0.5) / velocity_ratio
    t50 = (t47 / velocity_ratio) / t49
    t51 = t43 + t50
    t54 = (t49 * (t37 / t38)) * 2.0
    t56 = t43 + (t50 * 2.0)
    t60 = tracking_index * (t7 / velocity_ratio)
    t62 = t17 / velocity_ratio
    t64 = ((t51 * t51) / t60) + ((t54 * t54) / t62)
    t66 = velocity_ratio / (t30 / velocity_ratio)
    t72 = ((t51 * t43) / t60) + ((t54 * t56) / t62)
    t78 = ((t43 * t43) / t60) + ((t56 * t56) / t62)
    t67 = t66 * t64
    t73 = t66 * t72
    t79 = t66 * t78
    return (t67, t73, t79)


def _predicted_covariance_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, predicted_11)
    t6 = add(t2, t5, w2)
    level_scaled = sqrt(t6, predicted_12)
    t9 = divide(t3, n1, predicted_22)
    t11 = add(t9, n2, predicted_22)
    t13 = multiply(t2, n3, w2)
    t14 = add(t13, t3, w3)
    t15 = multiply(t14, n4, w3)
    t16 = multiply(t11, t15, predicted_22)
    eta_scaled = sqrt(t16, predicted_22)
    t19 = multiply(t3, n5, w3)
    t21 = add(t19, n6, w3)
    t22 = divide(t2, n1, w0)
    t23 = add(t22, t21, w0)
    t24 = multiply(t3, t23, w0)
    t25 = multiply(tracking_index, level_scaled, w3)
    t27 = multiply(eta_scaled, n7, w4)
    t28 = multiply(t25, t27, w4)
    t29 = add(t24, t28, w0)
    delta_scaled = sqrt(t29, w0)
    t31 = add(t25, eta_scaled, w3)
    t32 = multiply(t31, n7, w3)
    t33 = add(t32, delta_scaled, w3)
    sigma_scaled = multiply(t33, n7, w3)
    t35 = add(t3, t13, w2)
    t36 = multiply(tracking_index, eta_scaled, w4)
    coupling_scaled = divide(t36, t35, w4)
    t38 = add(coupling_scaled, level_scaled, w2)
    cross_share = divide(tracking_index, t38, w5)
    t40 = multiply(level_scaled, coupling_scaled, w6)
    t41 = add(t5, t40, predicted_11)
    rest_scaled = multiply(cross_share, t41, predicted_11)
    t43 = divide(rest_scaled, velocity_ratio, predicted_11)
    t44 = multiply(delta_scaled, cross_share, w5)
    t45 = multiply(t3, n7, w1)
    t46 = add(t44, t45, w5)
    t47 = divide(t46, velocity_ratio, w5)
    t48 = divide(t47, velocity_ratio, w5)
    t49 = divide(sigma_scaled, velocity_ratio, w3)
    t50 = divide(t48, t49, w5)
    t51 = add(t43, t50, w1)
    t52 = divide(coupling_scaled, t38, w4)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t53, n8, w3)
    t55 = multiply(t50, n8, w5)
    t56 = add(t43, t55, w5)
    t57 = square(t51, w2)
    t58 = square(t54, w4)
    t59 = divide(level_scaled, velocity_ratio, predicted_12)
    t60 = multiply(tracking_index, t59, predicted_12)
    t61 = divide(t57, t60, w2)
    t62 = divide(eta_scaled, velocity_ratio, predicted_22)
    t63 = divide(t58, t62, w4)
    t64 = add(t61, t63, w2)
    t65 = divide(delta_scaled, velocity_ratio, w0)
    t66 = divide(velocity_ratio, t65, w0)
    t68 = multiply(t51, t43, w1)
    t69 = multiply(t54, t56, w3)
    t70 = divide(t68, t60, w1)
    t71 = divide(t69, t62, w3)
    t72 = add(t70, t71, w1)
    t74 = square(t43, predicted_11)
    t75 = square(t56, w5)
    t76 = divide(t74, t60, predicted_11)
    t77 = divide(t75, t62, w5)
    t78 = add(t76, t77, w5)
    multiply(t66, t64, predicted_11)
    multiply(t66, t72, predicted_12)
    multiply(t66, t78, predicted_22)


_PREDICTED_COVARIANCE_BY_VELOCITY_RATIO = Signature(
    "predicted_covariance_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("predicted_11", "predicted_12", "predicted_22"),
    7,
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
        s = 2 U12 + U22 + Lambda^2/3,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    updated_11: derivative by Lambda of the variance of the updated position over sigma_o^2.
        Relative error at most 38.88 * 2^-52 (float64), 34.89 * 2^-23 (float32), proved for every
        input.
    updated_12: derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_o^2. Error over the sum of its terms' sizes at most 38.75 * 2^-52 (float64), 37.29 *
        2^-23 (float32), proved for every input. Cancellation, condition number 1: what it is the
        derivative of grows in one part of the domain and falls in another, so that it vanishes
        between. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or
        more only where the value is below 1e-6 in float64 and 0.03 in float32 of what its error is
        relative to.
    updated_22: derivative by Lambda of the variance of the updated velocity times T^2/sigma_o^2.
        Relative error at most 45.88 * 2^-52 (float64), 42.16 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t7 = form.sqrt(t2 + (t3 / 12.0))
    t9 = t3 / 3.0
    t11 = t9 + 16.0
    t13 = t2 * 4.0
    t17 = form.sqrt(t11 * ((t13 + t3) * 0.25))
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t32 = (t25 + t17) * 0.5
    t34 = (t32 + t30) * 0.5
    t37 = (tracking_index * t17) / (t3 + t13)
    t38 = t37 + t7
    t39 = tracking_index / t38
    t41 = t34 / velocity_ratio
    t42 = (t7 / t38) / t41
    t44 = (t37 / t38) / t41
    t48 = tracking_index * (t7 / velocity_ratio)
    t50 = t17 / velocity_ratio
    t52 = ((t42 * t42) / t48) + ((t44 * t44) / t50)
    t56 = ((t30 * t39) + (t3 * 0.5)) / velocity_ratio
    t57 = t56 / velocity_ratio
    t58 = t57 / t41
    t60 = (t57 + 2.0) / t41
    t65 = ((t58 * t58) / t48) + ((t60 * t60) / t50)
    t69 = tracking_index / (t30 / velocity_ratio)
    t71 = t39 * velocity_ratio
    t72 = t71 * t71
    t77 = (t25 + (t30 * 2.0)) + (t17 * (t9 / t11))
    t84 = (t2 * (t7 * 2.0)) + (tracking_index * t32)
    t86 = ((t7 * ((t17 * 0.25) * t77)) / t84) / t41
    t90 = (((t34 * t7) + tracking_index) * t17) / t84
    t91 = t90 / t41
    t96 = ((t86 * t86) / t48) + ((t91 * t91) / t50)
    t101 = t96 + (((t72 / t48) + (t72 / t50)) / 12.0)
    t112 = ((t71 * t58) / t48) + ((t71 * t60) / t50)
    t115 = t69 * (((t44 * t91) / t50) + (t112 / 12.0))
    t70 = t69 * (t52 + (t65 / 12.0))
    t102 = t69 * t101
    t116 = (t69 * ((t42 * t86) / t48)) - t115
    return (t70, t116, t102)


def _updated_covariance_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, updated_11)
    t6 = add(t2, t5, updated_11)
    level_scaled = sqrt(t6, updated_22)
    t9 = divide(t3, n1, updated_12)
    t11 = add(t9, n2, updated_11)
    t13 = multiply(t2, n3, w2)
    t14 = add(t13, t3, w3)
    t15 = multiply(t14, n4, w3)
    t16 = multiply(t11, t15, w3)
    eta_scaled = sqrt(t16, w3)
    t19 = multiply(t3, n5, w4)
    t21 = add(t19, n6, w4)
    t22 = divide(t2, n1, w5)
    t23 = add(t22, t21, w5)
    t24 = multiply(t3, t23, w5)
    t25 = multiply(tracking_index, level_scaled, w4)
    t27 = multiply(eta_scaled, n7, w6)
    t28 = multiply(t25, t27, w6)
    t29 = add(t24, t28, w5)
    delta_scaled = sqrt(t29, w5)
    t31 = add(t25, eta_scaled, w6)
    t32 = multiply(t31, n7, w6)
    t33 = add(t32, delta_scaled, w7)
    sigma_scaled = multiply(t33, n7, w7)
    t35 = add(t3, t13, w2)
    t36 = multiply(tracking_index, eta_scaled, w8)
    coupling_scaled = divide(t36, t35, w8)
    t38 = add(coupling_scaled, level_scaled, w2)
    cross_share = divide(tracking_index, t38, w9)
    t40 = divide(level_scaled, t38, w10)
    t41 = divide(sigma_scaled, velocity_ratio, w11)
    t42 = divide(t40, t41, w10)
    t43 = divide(coupling_scaled, t38, w8)
    t44 = divide(t43, t41, w8)
    t45 = square(t42, w2)
    t46 = square(t44, w12)
    t47 = divide(level_scaled, velocity_ratio, w13)
    t48 = multiply(tracking_index, t47, w13)
    t49 = divide(t45, t48, w2)
    t50 = divide(eta_scaled, velocity_ratio, w14)
    t51 = divide(t46, t50, w12)
    t52 = add(t49, t51, w2)
    t53 = multiply(delta_scaled, cross_share, w12)
    t54 = multiply(t3, n7, w1)
    t55 = add(t53, t54, w12)
    t56 = divide(t55, velocity_ratio, w12)
    t57 = divide(t56, velocity_ratio, w12)
    t58 = divide(t57, t41, w1)
    t59 = add(t57, n8, w12)
    t60 = divide(t59, t41, w12)
    t61 = square(t58, w15)
    t62 = square(t60, w16)
    t63 = divide(t61, t48, w15)
    t64 = divide(t62, t50, w16)
    t65 = add(t63, t64, w15)
    t66 = divide(t65, n0, w15)
    t67 = add(t52, t66, w2)
    t68 = divide(delta_scaled, velocity_ratio, w15)
    t69 = divide(tracking_index, t68, w15)
    t71 = multiply(cross_share, velocity_ratio, w9)
    t72 = square(t71, w16)
    t73 = divide(t9, t11, updated_12)
    t74 = multiply(eta_scaled, t73, updated_12)
    t75 = multiply(delta_scaled, n8, w5)
    t76 = add(t25, t75, w4)
    t77 = add(t76, t74, w4)
    t78 = multiply(eta_scaled, n4, w5)
    t79 = multiply(t78, t77, w5)
    t80 = multiply(level_scaled, t79, w5)
    t81 = multiply(level_scaled, n8, w4)
    t82 = multiply(t2, t81, w0)
    t83 = multiply(tracking_index, t32, w6)
    t84 = add(t82, t83, w0)
    t85 = divide(t80, t84, w5)
    t86 = divide(t85, t41, w5)
    t87 = multiply(sigma_scaled, level_scaled, w7)
    t88 = add(t87, tracking_index, w7)
    t89 = multiply(t88, eta_scaled, w7)
    t90 = divide(t89, t84, w7)
    t91 = divide(t90, t41, w7)
    t92 = square(t86, w0)
    t93 = square(t91, w3)
    t94 = divide(t92, t48, w0)
    t95 = divide(t93, t50, w3)
    t96 = add(t94, t95, w0)
    t97 = divide(t72, t48, w3)
    t98 = divide(t72, t50, w16)
    t99 = add(t97, t98, w3)
    t100 = divide(t99, n0, w3)
    t101 = add(t96, t100, w0)
    t103 = multiply(t42, t86, w10)
    t104 = divide(t103, t48, w10)
    t105 = multiply(t44, t91, w8)
    t106 = divide(t105, t50, w8)
    t107 = multiply(t71, t58, w1)
    t108 = multiply(t71, t60, w9)
    t109 = multiply(t69, t104, w10)
    t110 = divide(t107, t48, w1)
    t111 = divide(t108, t50, w9)
    t112 = add(t110, t111, w1)
    t113 = divide(t112, n0, w1)
    t114 = add(t106, t113, w8)
    t115 = multiply(t69, t114, w8)
    multiply(t69, t67, updated_11)
    multiply(t69, t101, updated_22)
    subtract(t109, t115, updated_12)


_UPDATED_COVARIANCE_BY_TRACKING_INDEX = Signature(
    "updated_covariance_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("updated_11", "updated_12", "updated_22"),
    17,
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
        s = 2 U12 + U22 + Lambda^2/3,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t eta/(4 + t^2)/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w^2 = 1 + 1/12 t^2, eta^2 = (16 + Lambda^2/3) (1 + t^2/4);
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    updated_11: derivative by S of the variance of the updated position over sigma_o^2. Relative
        error at most 36.26 * 2^-52 (float64), 30.86 * 2^-23 (float32), proved for every input.
    updated_12: derivative by S of the covariance of updated position and velocity times
        T/sigma_o^2. Relative error at most 36.20 * 2^-52 (float64), 29.75 * 2^-23 (float32), proved
        for every input.
    updated_22: derivative by S of the variance of the updated velocity times T^2/sigma_o^2.
        Relative error at most 37.50 * 2^-52 (float64), 41.67 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t5 = t3 / 12.0
    t7 = form.sqrt(t2 + t5)
    t13 = t2 * 4.0
    t16 = ((t3 / 3.0) + 16.0) * ((t13 + t3) * 0.25)
    t17 = form.sqrt(t16)
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * t7
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t37 = (tracking_index * t17) / (t3 + t13)
    t38 = t37 + t7
    t39 = tracking_index / t38
    t46 = ((t30 * t39) + (t3 * 0.5)) / velocity_ratio
    t48 = ((((t25 + t17) * 0.5) + t30) * 0.5) / velocity_ratio
    t49 = (t46 / velocity_ratio) / t48
    t52 = ((t37 / t38) / t48) * 2.0
    t56 = tracking_index * (t7 / velocity_ratio)
    t58 = t17 / velocity_ratio
    t60 = ((t49 * t49) / t56) + ((t52 * t52) / t58)
    t62 = velocity_ratio / (t30 / velocity_ratio)
    t64 = (t39 * (t5 + (t7 * t37))) / velocity_ratio
    t67 = t64 + (t49 * 2.0)
    t71 = ((t49 * t64) / t56) + ((t52 * t67) / t58)
    t77 = ((t64 * t64) / t56) + ((t67 * t67) / t58)
    t63 = t62 * t60
    t72 = t62 * t71
    t78 = t62 * t77
    return (t63, t72, t78)


def _updated_covariance_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, updated_11)
    t6 = add(t2, t5, w2)
    level_scaled = sqrt(t6, updated_12)
    t9 = divide(t3, n1, updated_22)
    t11 = add(t9, n2, updated_22)
    t13 = multiply(t2, n3, w2)
    t14 = add(t13, t3, w3)
    t15 = multiply(t14, n4, w3)
    t16 = multiply(t11, t15, updated_22)
    eta_scaled = sqrt(t16, updated_22)
    t19 = multiply(t3, n5, w3)
    t21 = add(t19, n6, w3)
    t22 = divide(t2, n1, w0)
    t23 = add(t22, t21, w0)
    t24 = multiply(t3, t23, w0)
    t25 = multiply(tracking_index, level_scaled, w3)
    t27 = multiply(eta_scaled, n7, w4)
    t28 = multiply(t25, t27, w4)
    t29 = add(t24, t28, w0)
    delta_scaled = sqrt(t29, w0)
    t31 = add(t25, eta_scaled, w3)
    t32 = multiply(t31, n7, w3)
    t33 = add(t32, delta_scaled, w3)
    sigma_scaled = multiply(t33, n7, w3)
    t35 = add(t3, t13, w2)
    t36 = multiply(tracking_index, eta_scaled, w4)
    coupling_scaled = divide(t36, t35, w4)
    t38 = add(coupling_scaled, level_scaled, w2)
    cross_share = divide(tracking_index, t38, w5)
    t40 = multiply(level_scaled, coupling_scaled, w6)
    t41 = add(t5, t40, updated_11)
    rest_scaled = multiply(cross_share, t41, updated_11)
    t43 = multiply(delta_scaled, cross_share, w5)
    t44 = multiply(t3, n7, w1)
    t45 = add(t43, t44, w5)
    t46 = divide(t45, velocity_ratio, w5)
    t47 = divide(t46, velocity_ratio, w5)
    t48 = divide(sigma_scaled, velocity_ratio, w3)
    t49 = divide(t47, t48, w5)
    t50 = divide(coupling_scaled, t38, w4)
    t51 = divide(t50, t48, w4)
    t52 = multiply(t51, n8, w4)
    t53 = square(t49, w1)
    t54 = square(t52, w2)
    t55 = divide(level_scaled, velocity_ratio, updated_12)
    t56 = multiply(tracking_index, t55, updated_12)
    t57 = divide(t53, t56, w1)
    t58 = divide(eta_scaled, velocity_ratio, updated_22)
    t59 = divide(t54, t58, w2)
    t60 = add(t57, t59, w1)
    t61 = divide(delta_scaled, velocity_ratio, w0)
    t62 = divide(velocity_ratio, t61, w0)
    t64 = divide(rest_scaled, velocity_ratio, updated_11)
    t65 = multiply(t49, t64, w2)
    t66 = multiply(t49, n8, w5)
    t67 = add(t64, t66, w5)
    t68 = multiply(t52, t67, w4)
    t69 = divide(t65, t56, w2)
    t70 = divide(t68, t58, w4)
    t71 = add(t69, t70, w2)
    t73 = square(t64, updated_11)
    t74 = square(t67, w5)
    t75 = divide(t73, t56, updated_11)
    t76 = divide(t74, t58, w5)
    t77 = add(t75, t76, w5)
    multiply(t62, t60, updated_11)
    multiply(t62, t71, updated_12)
    multiply(t62, t77, updated_22)


_UPDATED_COVARIANCE_BY_VELOCITY_RATIO = Signature(
    "updated_covariance_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("updated_11", "updated_12", "updated_22"),
    7,
    _updated_covariance_by_velocity_ratio_block,
    numbers=_updated_covariance_by_velocity_ratio_of_numbers,
)


class KnownVelocity(NamedTuple):
    """Result of `known_velocity`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_o^2."""
    updated_11: Real
    """Variance of the updated position over sigma_o^2."""


def known_velocity(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> KnownVelocity:
    """The position's variances where the velocity is known exactly, S = 0.

        updated_11 = 2 Lambda/(Lambda + sqrt(Lambda^2 + 48)),
        predicted_11 = updated_11 + Lambda^2/3: the limits for S -> 0

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.

    predicted_11: variance of the predicted position over sigma_o^2. Relative error at most 2.26 *
        2^-52 (float64), 2.26 * 2^-23 (float32), proved for 1e-12 <= tracking_index <=
        1000000000000.0 (float64) and 1e-08 <= tracking_index <= 1e08 (float32).
    updated_11: variance of the updated position over sigma_o^2. Relative error at most 1.76 * 2^-52
        (float64), 1.76 * 2^-23 (float32), proved for 1e-12 <= tracking_index <= 1000000000000.0
        (float64) and 1e-08 <= tracking_index <= 1e08 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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


def _known_velocity_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t1 = tracking_index * tracking_index
    t7 = tracking_index + form.sqrt(t1 + 48.0)
    t8 = (tracking_index * 2.0) / t7
    t11 = t8 + (t1 / 3.0)
    return (t11, t8)


def _known_velocity_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 48.0,
    n1: float = 2.0,
    n2: float = 3.0,
) -> None:
    (tracking_index,) = given
    predicted_11, updated_11 = out
    w0, w1 = work
    t1 = square(tracking_index, w0)
    t3 = add(t1, n0, w1)
    far = sqrt(t3, updated_11)
    t6 = multiply(tracking_index, n1, w1)
    t7 = add(tracking_index, far, updated_11)
    divide(t6, t7, updated_11)
    t10 = divide(t1, n2, predicted_11)
    add(updated_11, t10, predicted_11)


_KNOWN_VELOCITY = Signature(
    "known_velocity",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11", "updated_11"),
    2,
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
        half_sum = Lambda^2/(2 m sigma) (4/Lambda^2 + 1/S^2 - 1/6),
        quarter_discriminant = (Lambda^2/(2 delta sigma))^2 ((1/S^2 - 1/3)^2 - 1/12 - 4/Lambda^2),
        sigma, m and delta as in gains. Near the curve where the poles meet their difference is
        the square root of a difference: the poles themselves have half the digits there.

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-6 and at most 1e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e6.

    half_sum: half the sum of the poles, the real part of each where they are complex. Error over
        the sum of its terms' sizes at most 11.28 * 2^-52 (float64), 11.16 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: the real part of complex poles vanishes
        on a curve. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 3e-7 in float64 and 0.009 in float32 of what its error
        is relative to.
    modulus: the geometric mean of their moduli, the modulus of each where they are complex.
        Relative error at most 3.88 * 2^-52 (float64), 3.88 * 2^-23 (float32), proved for every
        input.
    quarter_discriminant: the square of half their difference, negative where they are complex.
        Error over the sum of its terms' sizes at most 23.03 * 2^-52 (float64), 33.21 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: the poles meet on a
        curve. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or
        more only where the value is below 6e-7 in float64 and 0.03 in float32 of what its error is
        relative to.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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
    t2 = velocity_ratio * velocity_ratio
    t3 = tracking_index * tracking_index
    t16 = ((t3 / 3.0) + 16.0) * (((t2 * 4.0) + t3) * 0.25)
    t17 = form.sqrt(t16)
    t23 = (t2 / 3.0) + ((t3 * 0.041666666666666664) + 1.0)
    t25 = tracking_index * form.sqrt(t2 + (t3 / 12.0))
    t30 = form.sqrt((t3 * t23) + (t25 * (t17 * 0.5)))
    t31 = t25 + t17
    t34 = ((t31 * 0.5) + t30) * 0.5
    t38 = (velocity_ratio / t31) * velocity_ratio
    t43 = (tracking_index / t31) * (tracking_index / t34)
    t45 = (velocity_ratio + -2.449489742783178) + (
        8.914125970704845e-08 if form.single else -2.168616518103246e-16
    )
    t47 = t45 * (velocity_ratio + 2.449489742783178)
    t57 = tracking_index / ((t30 * t34) * 2.0)
    t60 = (velocity_ratio + -1.7320508075688772) + (
        -3.1087250107475484e-08 if form.single else -1.0035084221806903e-16
    )
    t62 = t60 * (velocity_ratio + 1.7320508075688772)
    t64 = (tracking_index * t57) * (t62 / 3.0)
    t67 = (velocity_ratio * t57) * (velocity_ratio * 2.0)
    t50 = (t38 * (4.0 / t34)) - (t43 * (t47 / 6.0))
    t53 = velocity_ratio / t34
    t74 = (t64 * t64) - ((t67 * ((t3 / 48.0) + 1.0)) * t67)
    return (t50, t53, t74)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 12.0,
    n1: float = 3.0,
    n2: float = 16.0,
    n3: float = 4.0,
    n4: float = 0.25,
    n5: float = 0.041666666666666664,
    n6: float = 1.0,
    n7: float = 0.5,
    n8: float = -2.449489742783178,
    n9: float = 8.914125970704845e-08,
    n10: float = -2.168616518103246e-16,
    n11: float = 2.449489742783178,
    n12: float = 6.0,
    n13: float = 2.0,
    n14: float = -1.7320508075688772,
    n15: float = -3.1087250107475484e-08,
    n16: float = -1.0035084221806903e-16,
    n17: float = 1.7320508075688772,
    n18: float = 48.0,
) -> None:
    tracking_index, velocity_ratio = given
    half_sum, modulus, quarter_discriminant = out
    w0, w1, w2, w3, w4 = work
    t2 = square(velocity_ratio, w0)
    t3 = square(tracking_index, w1)
    t5 = divide(t3, n0, half_sum)
    t6 = add(t2, t5, half_sum)
    level_scaled = sqrt(t6, modulus)
    t9 = divide(t3, n1, quarter_discriminant)
    t11 = add(t9, n2, quarter_discriminant)
    t13 = multiply(t2, n3, half_sum)
    t14 = add(t13, t3, half_sum)
    t15 = multiply(t14, n4, half_sum)
    t16 = multiply(t11, t15, quarter_discriminant)
    eta_scaled = sqrt(t16, quarter_discriminant)
    t19 = multiply(t3, n5, half_sum)
    t21 = add(t19, n6, half_sum)
    t22 = divide(t2, n1, w0)
    t23 = add(t22, t21, w0)
    t24 = multiply(t3, t23, w0)
    t25 = multiply(tracking_index, level_scaled, modulus)
    t27 = multiply(eta_scaled, n7, half_sum)
    t28 = multiply(t25, t27, half_sum)
    t29 = add(t24, t28, w0)
    delta_scaled = sqrt(t29, w0)
    t31 = add(t25, eta_scaled, modulus)
    t32 = multiply(t31, n7, half_sum)
    t33 = add(t32, delta_scaled, half_sum)
    sigma_scaled = multiply(t33, n7, quarter_discriminant)
    t37 = divide(velocity_ratio, t31, half_sum)
    t38 = multiply(t37, velocity_ratio, half_sum)
    t39 = divide(n3, sigma_scaled, w2)
    t40 = multiply(t38, t39, half_sum)
    t41 = divide(tracking_index, t31, modulus)
    t42 = divide(tracking_index, sigma_scaled, w2)
    t43 = multiply(t41, t42, modulus)
    rest = n9 if single else n10
    add(velocity_ratio, n8, w2)
    t45 = add(w2, rest, w2)
    t46 = add(velocity_ratio, n11, w3)
    t47 = multiply(t45, t46, w2)
    t48 = divide(t47, n12, w2)
    t49 = multiply(t43, t48, modulus)
    t55 = multiply(delta_scaled, sigma_scaled, w0)
    t56 = multiply(t55, n13, w0)
    t57 = divide(tracking_index, t56, w0)
    t58 = multiply(tracking_index, t57, w2)
    rest_ = n15 if single else n16
    add(velocity_ratio, n14, w3)
    t60 = add(w3, rest_, w3)
    t61 = add(velocity_ratio, n17, w4)
    t62 = multiply(t60, t61, w3)
    t63 = divide(t62, n1, w3)
    t64 = multiply(t58, t63, w2)
    t65 = multiply(velocity_ratio, t57, w0)
    t66 = multiply(velocity_ratio, n13, w3)
    t67 = multiply(t65, t66, w0)
    t69 = divide(t3, n18, w1)
    t70 = add(t69, n6, w1)
    t71 = square(t64, w2)
    t72 = multiply(t67, t70, w1)
    t73 = multiply(t72, t67, w1)
    subtract(t40, t49, half_sum)
    divide(velocity_ratio, sigma_scaled, modulus)
    subtract(t71, t73, quarter_discriminant)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN_4, _VELOCITY_RATIO_DOMAIN_4),
    ("half_sum", "modulus", "quarter_discriminant"),
    5,
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

        positive_from = 1/3 + 2 r/Lambda, r = sqrt(1 + Lambda^2/48),
        negative_up_to = 1/3 - 2 r/Lambda = product of both/positive_from

    tracking_index: Lambda, with Lambda^2 = acceleration_deviation^2
        sampling_interval^4/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.

    positive_from: the 1/S^2 from which on both poles are real and positive. Relative error at most
        1.76 * 2^-52 (float64), 1.76 * 2^-23 (float32), proved for 1e-12 <= tracking_index <=
        1000000000000.0 (float64) and 1e-08 <= tracking_index <= 1e08 (float32).
    negative_up_to: the 1/S^2 up to which both poles are real and negative, for no S where it is not
        positive. Error over positive_from at most 5.26 * 2^-52 (float64), 5.26 * 2^-23 (float32),
        proved for 1e-12 <= tracking_index <= 1000000000000.0 (float64) and 1e-08 <= tracking_index
        <= 1e08 (float32). Digits that can be lost: up to 3.2 of 16 in float64; up to 2.7 of 7 in
        float32, a quarter or more only where tracking_index >= 4.2.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity
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


def _real_poles_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t3 = (tracking_index * tracking_index) / 48.0
    t9 = (form.sqrt(t3 + 1.0) * 2.0) / tracking_index
    t11 = 0.3333333333333333 + t9
    t14 = (tracking_index + 12.0) / tracking_index
    t17 = (tracking_index + -12.0) / tracking_index
    t21 = ((t14 * t17) / 36.0) / t11
    return (t11, t21)


def _real_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 48.0,
    n1: float = 1.0,
    n2: float = 2.0,
    n3: float = 0.3333333333333333,
    n4: float = 12.0,
    n5: float = -12.0,
    n6: float = 36.0,
) -> None:
    (tracking_index,) = given
    positive_from, negative_up_to = out
    (w0,) = work
    t1 = square(tracking_index, w0)
    t3 = divide(t1, n0, positive_from)
    t5 = add(t3, n1, positive_from)
    spread_root = sqrt(t5, negative_up_to)
    t8 = multiply(spread_root, n2, negative_up_to)
    t9 = divide(t8, tracking_index, negative_up_to)
    add(n3, t9, positive_from)
    t13 = add(tracking_index, n4, w0)
    t14 = divide(t13, tracking_index, w0)
    t16 = add(tracking_index, n5, negative_up_to)
    t17 = divide(t16, tracking_index, negative_up_to)
    t18 = multiply(t14, t17, w0)
    t20 = divide(t18, n6, w0)
    divide(t20, positive_from, negative_up_to)


_REAL_POLES = Signature(
    "real_poles",
    (_TRACKING_INDEX_DOMAIN,),
    ("positive_from", "negative_up_to"),
    1,
    _real_poles_block,
    numbers=_real_poles_of_numbers,
)
