# Made by: gainproof generate position-velocity-random-velocity
# From: gainproof derive position-velocity-random-velocity, SymPy 1.14.0
"""Position and velocity measured, random velocity (velocity random walk)."""

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
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-8 and at most 4e6",
    (1e-12, 1000000000000.0),
    (9.99999993922529e-09, 4000000.0),
)
_VELOCITY_RATIO_DOMAIN = Domain(
    "velocity_ratio",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e8",
    (1e-12, 1000000000000.0),
    (9.999999974752427e-07, 100000000.0),
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
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4",
    (1e-30, 1e30),
    (9.999999747378752e-05, 10000.0),
)
_VELOCITY_RATIO_DOMAIN_3 = Domain(
    "velocity_ratio",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4",
    (1e-30, 1e30),
    (9.999999747378752e-05, 10000.0),
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
_TRACKING_INDEX_DOMAIN_5 = Domain(
    "tracking_index",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-8 and at most 1e8",
    (1e-12, 1000000000000.0),
    (9.99999993922529e-09, 100000000.0),
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
        U12 = h/sigma, U22 = delta h,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 4e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e8.

    gain_11: position's gain on the measured position. Relative error at most 10.11 * 2^-52
        (float64), 10.11 * 2^-23 (float32), proved for every input.
    gain_12: position's gain on the measured velocity over T. Relative error at most 8.00 * 2^-52
        (float64), 8.00 * 2^-23 (float32), proved for every input.
    gain_21: velocity's gain on the measured position times T. Relative error at most 8.40 * 2^-52
        (float64), 8.40 * 2^-23 (float32), proved for every input.
    gain_22: velocity's gain on the measured velocity. Relative error at most 7.57 * 2^-52
        (float64), 7.54 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t10 = form.sqrt(((t2 + 16.0) * t3) + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t24 = tracking_index / (t22 + velocity_ratio)
    t27 = t24 / t19
    t28 = t27 * t3
    t31 = ((t17 * t24) / velocity_ratio) / velocity_ratio
    t34 = ((t24 * (velocity_ratio * t22)) / t19) + (t28 * t27)
    t35 = t34 / t31
    return (t35, t27, t28, t31)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w3)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, gain_12)
    t11 = multiply(tracking_index, velocity_ratio, w2)
    t12 = add(t11, eta_scaled, gain_12)
    t14 = multiply(t12, n2, gain_12)
    t15 = multiply(t11, t14, w2)
    t16 = add(t2, t15, w0)
    delta_scaled = sqrt(t16, gain_22)
    t18 = add(t14, delta_scaled, gain_12)
    sigma_scaled = multiply(t18, n2, w0)
    t20 = multiply(tracking_index, sigma_scaled, w2)
    t21 = divide(t20, velocity_ratio, gain_21)
    coupling_scaled = divide(t21, velocity_ratio, gain_11)
    t23 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t23, w2)
    t25 = multiply(velocity_ratio, coupling_scaled, gain_11)
    rest_scaled = multiply(cross_share, t25, gain_11)
    divide(cross_share, sigma_scaled, gain_12)
    multiply(gain_12, t3, gain_21)
    t29 = multiply(delta_scaled, cross_share, gain_22)
    t30 = divide(t29, velocity_ratio, gain_22)
    divide(t30, velocity_ratio, gain_22)
    t32 = divide(rest_scaled, sigma_scaled, gain_11)
    t33 = multiply(gain_21, gain_12, w0)
    t34 = add(t32, t33, gain_11)
    divide(t34, gain_22, gain_11)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    4,
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
        predicted_22 = delta h + Lambda^2,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = delta h,
        s = 2 U12 + U22,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 4e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e8.

    predicted_11: variance of the predicted position over sigma_o^2. Relative error at most 8.31 *
        2^-52 (float64), 7.47 * 2^-23 (float32), proved for every input.
    predicted_12: covariance of predicted position and velocity times T/sigma_o^2. Relative error at
        most 4.21 * 2^-52 (float64), 4.09 * 2^-23 (float32), proved for every input.
    predicted_22: variance of the predicted velocity times T^2/sigma_o^2. Relative error at most
        7.05 * 2^-52 (float64), 6.99 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t10 = form.sqrt(((t2 + 16.0) * t3) + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t24 = tracking_index / (t22 + velocity_ratio)
    t30 = t17 * t24
    t32 = t19 * ((((t24 / t19) * t3) * 2.0) + t30)
    t34 = ((t24 * (velocity_ratio * t22)) + t32) / t17
    t35 = t24 * t19
    t36 = t30 + t2
    return (t34, t35, t36)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w3)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, predicted_11)
    t11 = multiply(tracking_index, velocity_ratio, w2)
    t12 = add(t11, eta_scaled, predicted_11)
    t14 = multiply(t12, n2, predicted_11)
    t15 = multiply(t11, t14, w2)
    t16 = add(t2, t15, w2)
    delta_scaled = sqrt(t16, predicted_12)
    t18 = add(t14, delta_scaled, predicted_11)
    sigma_scaled = multiply(t18, n2, w2)
    t20 = multiply(tracking_index, sigma_scaled, w3)
    t21 = divide(t20, velocity_ratio, predicted_22)
    coupling_scaled = divide(t21, velocity_ratio, predicted_22)
    t23 = add(coupling_scaled, velocity_ratio, w3)
    cross_share = divide(tracking_index, t23, w3)
    t25 = multiply(velocity_ratio, coupling_scaled, predicted_22)
    rest_scaled = multiply(cross_share, t25, predicted_22)
    t27 = divide(cross_share, sigma_scaled, predicted_11)
    t28 = multiply(t27, t3, predicted_11)
    t29 = multiply(t28, n3, predicted_11)
    t30 = multiply(delta_scaled, cross_share, w1)
    t31 = add(t29, t30, predicted_11)
    t32 = multiply(sigma_scaled, t31, predicted_11)
    t33 = add(rest_scaled, t32, predicted_22)
    divide(t33, delta_scaled, predicted_11)
    multiply(cross_share, sigma_scaled, predicted_12)
    add(t30, t2, predicted_22)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("predicted_11", "predicted_12", "predicted_22"),
    4,
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
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = delta h,
        s = 2 U12 + U22,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 4e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e8.

    updated_11: variance of the updated position over sigma_o^2. Relative error at most 11.76 *
        2^-52 (float64), 11.61 * 2^-23 (float32), proved for every input.
    updated_12: covariance of updated position and velocity times T/sigma_o^2. Relative error at
        most 8.50 * 2^-52 (float64), 8.40 * 2^-23 (float32), proved for every input.
    updated_22: variance of the updated velocity times T^2/sigma_o^2. Relative error at most 6.55 *
        2^-52 (float64), 6.52 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t10 = form.sqrt(((t2 + 16.0) * t3) + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t24 = tracking_index / (t22 + velocity_ratio)
    t28 = (t24 / t19) * t3
    t30 = t17 * t24
    t34 = (t24 * (velocity_ratio * t22)) + (t3 * (((t28 * 2.0) + t30) / t19))
    t35 = t34 / t17
    return (t35, t28, t30)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w3)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, updated_12)
    t11 = multiply(tracking_index, velocity_ratio, w2)
    t12 = add(t11, eta_scaled, updated_12)
    t14 = multiply(t12, n2, updated_12)
    t15 = multiply(t11, t14, w2)
    t16 = add(t2, t15, w0)
    delta_scaled = sqrt(t16, updated_11)
    t18 = add(t14, delta_scaled, updated_12)
    sigma_scaled = multiply(t18, n2, w0)
    t20 = multiply(tracking_index, sigma_scaled, w2)
    t21 = divide(t20, velocity_ratio, updated_22)
    coupling_scaled = divide(t21, velocity_ratio, updated_22)
    t23 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t23, w2)
    t25 = multiply(velocity_ratio, coupling_scaled, updated_22)
    rest_scaled = multiply(cross_share, t25, w3)
    t27 = divide(cross_share, sigma_scaled, updated_12)
    multiply(t27, t3, updated_12)
    t29 = multiply(updated_12, n3, w4)
    multiply(delta_scaled, cross_share, updated_22)
    t31 = add(t29, updated_22, w4)
    t32 = divide(t31, sigma_scaled, w4)
    t33 = multiply(t3, t32, w1)
    t34 = add(rest_scaled, t33, w3)
    divide(t34, delta_scaled, updated_11)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN, _VELOCITY_RATIO_DOMAIN),
    ("updated_11", "updated_12", "updated_22"),
    5,
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
        U12 = h/sigma, U22 = delta h,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    gain_11: derivative by Lambda of the position's gain on the measured position. Relative error at
        most 34.79 * 2^-52 (float64), 27.90 * 2^-23 (float32), proved for every input.
    gain_12: derivative by Lambda of the position's gain on the measured velocity over T. Error over
        the sum of its terms' sizes at most 39.53 * 2^-52 (float64), 33.49 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: what it is the derivative of grows in one
        part of the domain and falls in another, so that it vanishes between. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 1e-6 in float64 and 0.03 in float32 of what its error is relative to.
    gain_21: derivative by Lambda of the velocity's gain on the measured position times T. Error
        over the sum of its terms' sizes at most 38.53 * 2^-52 (float64), 32.49 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: what it is the derivative of grows
        in one part of the domain and falls in another, so that it vanishes between. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 1e-6 in float64 and 0.03 in float32 of what its error is relative to.
    gain_22: derivative by Lambda of the velocity's gain on the measured velocity. Relative error at
        most 43.26 * 2^-52 (float64), 39.81 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t6 = (t2 + 16.0) * (velocity_ratio * velocity_ratio)
    t10 = form.sqrt(t6 + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t23 = t22 + velocity_ratio
    t26 = t19 / velocity_ratio
    t27 = (velocity_ratio / t23) / t26
    t28 = t17 / velocity_ratio
    t30 = (tracking_index / t23) * velocity_ratio
    t32 = (t26 * t28) * (t30 / tracking_index)
    t33 = t32 / t26
    t39 = ((t22 / t23) + 1.0) / t26
    t41 = (t32 + 2.0) / t26
    t43 = t10 / velocity_ratio
    t45 = tracking_index / t28
    t46 = t45 * ((t27 * t33) / tracking_index)
    t47 = t45 * ((t39 * t41) / t43)
    t49 = (t46 / velocity_ratio) / velocity_ratio
    t51 = (t47 / velocity_ratio) / velocity_ratio
    t56 = ((t33 * t33) / tracking_index) + ((t41 * t41) / t43)
    t64 = ((t27 * t27) / tracking_index) + ((t39 * t39) / t43)
    t59 = ((t45 * t56) / velocity_ratio) / velocity_ratio
    t65 = t45 * t64
    t66 = t49 - t51
    t68 = t46 - t47
    return (t65, t66, t68, t59)


def _gains_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 1.0,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4, w5 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w1)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, gain_22)
    t11 = multiply(tracking_index, velocity_ratio, w1)
    t12 = add(t11, eta_scaled, w2)
    t14 = multiply(t12, n2, w2)
    t15 = multiply(t11, t14, w1)
    t16 = add(t2, t15, w0)
    delta_scaled = sqrt(t16, gain_11)
    t18 = add(t14, delta_scaled, w2)
    sigma_scaled = multiply(t18, n2, w2)
    t20 = multiply(tracking_index, sigma_scaled, w0)
    t21 = divide(t20, velocity_ratio, gain_12)
    coupling_scaled = divide(t21, velocity_ratio, gain_21)
    t23 = add(coupling_scaled, velocity_ratio, w0)
    cross_share = divide(tracking_index, t23, w1)
    t25 = divide(velocity_ratio, t23, gain_12)
    t26 = divide(sigma_scaled, velocity_ratio, w2)
    t27 = divide(t25, t26, gain_12)
    t28 = divide(delta_scaled, velocity_ratio, gain_11)
    t29 = multiply(t26, t28, w3)
    t30 = multiply(cross_share, velocity_ratio, w1)
    t31 = divide(t30, tracking_index, w1)
    t32 = multiply(t29, t31, w3)
    t33 = divide(t32, t26, w1)
    t34 = multiply(t27, t33, w4)
    t35 = divide(t34, tracking_index, w4)
    t36 = divide(coupling_scaled, t23, gain_21)
    t38 = add(t36, n3, gain_21)
    t39 = divide(t38, t26, gain_21)
    t40 = add(t32, n4, w3)
    t41 = divide(t40, t26, w3)
    t42 = multiply(t39, t41, w0)
    t43 = divide(eta_scaled, velocity_ratio, gain_22)
    t44 = divide(t42, t43, w0)
    t45 = divide(tracking_index, t28, gain_11)
    t46 = multiply(t45, t35, w4)
    t47 = multiply(t45, t44, w0)
    t48 = divide(t46, velocity_ratio, w2)
    t49 = divide(t48, velocity_ratio, w2)
    t50 = divide(t47, velocity_ratio, w5)
    t51 = divide(t50, velocity_ratio, w5)
    t52 = square(t33, w1)
    t53 = square(t41, w3)
    t54 = divide(t52, tracking_index, w1)
    t55 = divide(t53, t43, w3)
    t56 = add(t54, t55, w1)
    t57 = multiply(t45, t56, w1)
    t58 = divide(t57, velocity_ratio, w1)
    t60 = square(t27, gain_12)
    t61 = square(t39, gain_21)
    t62 = divide(t60, tracking_index, gain_12)
    t63 = divide(t61, t43, gain_21)
    t64 = add(t62, t63, gain_12)
    divide(t58, velocity_ratio, gain_22)
    multiply(t45, t64, gain_11)
    subtract(t49, t51, gain_12)
    subtract(t46, t47, gain_21)


_GAINS_BY_TRACKING_INDEX = Signature(
    "gains_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    6,
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
        U12 = h/sigma, U22 = delta h,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-4 and at most 1e4.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.

    gain_11: derivative by S of the position's gain on the measured position. Relative error at most
        87.54 * 2^-52 (float64), 78.83 * 2^-23 (float32), proved for every input.
    gain_12: derivative by S of the position's gain on the measured velocity over T. Error over the
        sum of its terms' sizes at most 41.03 * 2^-52 (float64), 35.99 * 2^-23 (float32), proved for
        every input. Cancellation, condition number 1: what it is the derivative of grows in one
        part of the domain and falls in another, so that it vanishes between. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 2e-6 in float64 and 0.03 in float32 of what its error is relative to.
    gain_21: derivative by S of the velocity's gain on the measured position times T. Relative error
        at most 39.53 * 2^-52 (float64), 32.02 * 2^-23 (float32), proved for every input.
    gain_22: derivative by S of the velocity's gain on the measured velocity. Relative error at most
        46.48 * 2^-52 (float64), 41.81 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t10 = form.sqrt(((t2 + 16.0) * t3) + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t23 = (t21 / velocity_ratio) + velocity_ratio
    t24 = tracking_index / t23
    t25 = t24 / t19
    t28 = (t25 * t3) / t2
    t29 = (t17 * t24) / t2
    t30 = t28 * t28
    t40 = (((t30 * t30) * 8.0) + 2.0) / (((t30 * 2.0) + (t28 * 2.0)) + 1.0)
    t45 = t40 + (((t28 * 4.0) + (t29 * 2.0)) * t29)
    t46 = tracking_index / velocity_ratio
    t47 = t46 * t46
    t50 = t10 / velocity_ratio
    t53 = (8.0 + (t47 * 2.0)) / ((tracking_index + t50) * 0.5)
    t55 = t29 + 1.0
    t58 = t45 + ((t53 / tracking_index) * (t55 * t55))
    t61 = t19 / velocity_ratio
    t63 = ((t2 / velocity_ratio) / t61) / velocity_ratio
    t65 = t17 / velocity_ratio
    t69 = t65 * t65
    t70 = t65 * t50
    t77 = (t69 + ((t70 * 3.0) * 0.5)) + ((tracking_index * t50) * 0.5)
    t83 = ((t50 * t69) * (t65 + tracking_index)) * 0.5
    t88 = (t47 * 4.0) * ((t46 / velocity_ratio) * t65)
    t90 = (t83 + t2) + (t47 * (t77 + (t2 * 0.5)))
    t92 = t3 + t69
    t96 = ((tracking_index / t61) * 2.0) * (velocity_ratio / t92)
    t100 = t96 * (((t90 + t88) / t92) / (t50 * t65))
    t102 = t24 * velocity_ratio
    t105 = (t61 * t65) * (t102 / tracking_index)
    t106 = t105 / t61
    t108 = (t105 + 2.0) / t61
    t113 = ((t106 * t106) / tracking_index) + ((t108 * t108) / t50)
    t115 = ((tracking_index / t65) * t113) * 0.5
    t120 = ((t102 * 2.0) * (t102 / t70)) + (tracking_index * t115)
    t122 = (2.0 / velocity_ratio) / velocity_ratio
    t127 = (t100 / velocity_ratio) / velocity_ratio
    t68 = ((t63 * t63) * (velocity_ratio / t65)) * (t58 / t50)
    t125 = -(t122 * (t120 / velocity_ratio))
    t130 = t127 - ((t25 / velocity_ratio) * 2.0)
    return (t68, t130, t100, t125)


def _gains_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 8.0,
    n4: float = 2.0,
    n5: float = 1.0,
    n6: float = 3.0,
) -> None:
    tracking_index, velocity_ratio = given
    gain_11, gain_12, gain_21, gain_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w3)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, gain_11)
    t11 = multiply(tracking_index, velocity_ratio, w2)
    t12 = add(t11, eta_scaled, w3)
    t14 = multiply(t12, n2, w3)
    t15 = multiply(t11, t14, w2)
    t16 = add(t2, t15, w2)
    delta_scaled = sqrt(t16, gain_12)
    t18 = add(t14, delta_scaled, w3)
    sigma_scaled = multiply(t18, n2, w3)
    t20 = multiply(tracking_index, sigma_scaled, w2)
    t21 = divide(t20, velocity_ratio, w2)
    coupling_scaled = divide(t21, velocity_ratio, w2)
    t23 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t23, gain_22)
    t25 = divide(cross_share, sigma_scaled, w2)
    t26 = multiply(t25, t3, w4)
    t27 = multiply(delta_scaled, cross_share, w5)
    t28 = divide(t26, t2, gain_21)
    t29 = divide(t27, t2, w5)
    t30 = square(t28, w4)
    t31 = square(t30, w6)
    t33 = multiply(t31, n3, w6)
    t34 = add(t33, n4, w6)
    t35 = multiply(t30, n4, w4)
    t36 = multiply(t28, n4, w7)
    t37 = add(t35, t36, w4)
    t39 = add(t37, n5, w4)
    t40 = divide(t34, t39, w6)
    t41 = multiply(t28, n1, gain_21)
    t42 = multiply(t29, n4, w4)
    t43 = add(t41, t42, gain_21)
    t44 = multiply(t43, t29, gain_21)
    t45 = add(t40, t44, w6)
    t46 = divide(tracking_index, velocity_ratio, gain_21)
    t47 = square(t46, w4)
    t48 = multiply(t47, n4, w7)
    t49 = add(n3, t48, w7)
    t50 = divide(eta_scaled, velocity_ratio, gain_11)
    t51 = add(tracking_index, t50, w8)
    t52 = multiply(t51, n2, w8)
    t53 = divide(t49, t52, w7)
    t54 = divide(t53, tracking_index, w7)
    t55 = add(t29, n5, w5)
    t56 = square(t55, w5)
    t57 = multiply(t54, t56, w7)
    t58 = add(t45, t57, w6)
    t60 = divide(t2, velocity_ratio, w7)
    t61 = divide(sigma_scaled, velocity_ratio, w3)
    t62 = divide(t60, t61, w7)
    t63 = divide(t62, velocity_ratio, w7)
    t64 = square(t63, w7)
    t65 = divide(delta_scaled, velocity_ratio, gain_12)
    t66 = divide(velocity_ratio, t65, w5)
    t67 = multiply(t64, t66, w7)
    t69 = square(t65, w5)
    t70 = multiply(t65, t50, w8)
    t72 = multiply(t70, n6, w9)
    t73 = multiply(t72, n2, w9)
    t74 = add(t69, t73, w9)
    t75 = multiply(tracking_index, t50, w10)
    t76 = multiply(t75, n2, w10)
    t77 = add(t74, t76, w9)
    t78 = multiply(t2, n2, w10)
    t79 = add(t77, t78, w9)
    t80 = multiply(t50, t69, w10)
    t81 = add(t65, tracking_index, w11)
    t82 = multiply(t80, t81, w10)
    t83 = multiply(t82, n2, w10)
    t84 = multiply(t47, t79, w9)
    t85 = multiply(t47, n1, w4)
    t86 = divide(t46, velocity_ratio, gain_21)
    t87 = multiply(t86, t65, gain_21)
    t88 = multiply(t85, t87, w4)
    t89 = add(t83, t2, w10)
    t90 = add(t89, t84, w10)
    t91 = add(t90, t88, w10)
    t92 = add(t3, t69, w1)
    t93 = divide(tracking_index, t61, w5)
    t94 = multiply(t93, n4, w5)
    t95 = divide(velocity_ratio, t92, w4)
    t96 = multiply(t94, t95, w5)
    t97 = divide(t91, t92, w10)
    t98 = multiply(t50, t65, w1)
    t99 = divide(t97, t98, w10)
    multiply(t96, t99, gain_21)
    t101 = divide(tracking_index, t65, w5)
    t102 = multiply(cross_share, velocity_ratio, gain_22)
    t103 = multiply(t61, t65, gain_12)
    t104 = divide(t102, tracking_index, w10)
    t105 = multiply(t103, t104, gain_12)
    t106 = divide(t105, t61, w10)
    t107 = add(t105, n4, gain_12)
    t108 = divide(t107, t61, gain_12)
    t109 = square(t106, w10)
    t110 = square(t108, gain_12)
    t111 = divide(t109, tracking_index, w10)
    t112 = divide(t110, t50, gain_12)
    t113 = add(t111, t112, w10)
    t114 = multiply(t101, t113, w5)
    t115 = multiply(t114, n2, w5)
    t116 = multiply(tracking_index, t115, w5)
    t117 = multiply(t102, n4, w10)
    t118 = divide(t102, t70, gain_22)
    t119 = multiply(t117, t118, w10)
    t120 = add(t119, t116, w10)
    t121 = divide(n4, velocity_ratio, w5)
    t123 = divide(t120, velocity_ratio, w10)
    t126 = divide(gain_21, velocity_ratio, w8)
    t128 = divide(t25, velocity_ratio, w2)
    t129 = multiply(t128, n4, w2)
    t59 = divide(t58, t50, gain_11)
    multiply(t67, t59, gain_11)
    t127 = divide(t126, velocity_ratio, gain_12)
    subtract(t127, t129, gain_12)
    t122 = divide(t121, velocity_ratio, gain_22)
    t124 = multiply(t122, t123, gain_22)
    negative(t124, gain_22)


_GAINS_BY_VELOCITY_RATIO = Signature(
    "gains_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_3, _VELOCITY_RATIO_DOMAIN_3),
    ("gain_11", "gain_12", "gain_21", "gain_22"),
    12,
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
        predicted_22 = delta h + Lambda^2,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = delta h,
        s = 2 U12 + U22,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-4 and at most 1e4.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.

    predicted_11: derivative by Lambda of the variance of the predicted position over sigma_o^2.
        Relative error at most 24.52 * 2^-52 (float64), 18.64 * 2^-23 (float32), proved for every
        input.
    predicted_12: derivative by Lambda of the covariance of predicted position and velocity times
        T/sigma_o^2. Relative error at most 33.83 * 2^-52 (float64), 23.91 * 2^-23 (float32), proved
        for every input.
    predicted_22: derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_o^2. Relative error at most 40.43 * 2^-52 (float64), 16.90 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t10 = form.sqrt(((t2 + 16.0) * t3) + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t23 = t22 + velocity_ratio
    t24 = tracking_index / t23
    t26 = t24 * (velocity_ratio * t22)
    t28 = t19 / velocity_ratio
    t29 = t28 * (velocity_ratio / t23)
    t30 = t29 * t29
    t32 = t10 / velocity_ratio
    t36 = (t24 / t19) * t3
    t38 = t17 / velocity_ratio
    t39 = tracking_index / t38
    t42 = (t36 * 2.0) + (t17 * t24)
    t50 = ((t26 + (t19 * t42)) / t17) + ((t26 + (t3 * (t42 / t19))) / t17)
    t53 = (t24 * velocity_ratio) / tracking_index
    t60 = (t28 * t38) * t53
    t61 = t60 / t28
    t63 = (t60 + 2.0) / t28
    t68 = ((t61 * t61) / tracking_index) + ((t63 * t63) / t32)
    t40 = t39 * ((t30 / tracking_index) + (t30 / t32))
    t58 = (t53 * ((t28 * 2.0) * (t50 + t36))) / (t32 * t38)
    t71 = (t39 * t68) + (tracking_index * 2.0)
    return (t40, t58, t71)


def _predicted_covariance_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w3)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, predicted_11)
    t11 = multiply(tracking_index, velocity_ratio, w2)
    t12 = add(t11, eta_scaled, w3)
    t14 = multiply(t12, n2, w3)
    t15 = multiply(t11, t14, w2)
    t16 = add(t2, t15, w0)
    delta_scaled = sqrt(t16, predicted_12)
    t18 = add(t14, delta_scaled, w3)
    sigma_scaled = multiply(t18, n2, w3)
    t20 = multiply(tracking_index, sigma_scaled, w0)
    t21 = divide(t20, velocity_ratio, predicted_22)
    coupling_scaled = divide(t21, velocity_ratio, predicted_22)
    t23 = add(coupling_scaled, velocity_ratio, w0)
    cross_share = divide(tracking_index, t23, w2)
    t25 = multiply(velocity_ratio, coupling_scaled, predicted_22)
    rest_scaled = multiply(cross_share, t25, predicted_22)
    t27 = divide(velocity_ratio, t23, w0)
    t28 = divide(sigma_scaled, velocity_ratio, w4)
    t29 = multiply(t28, t27, w0)
    t30 = square(t29, w0)
    t31 = divide(t30, tracking_index, w5)
    t32 = divide(eta_scaled, velocity_ratio, predicted_11)
    t33 = divide(t30, t32, w0)
    t34 = add(t31, t33, w5)
    t35 = divide(cross_share, sigma_scaled, w0)
    t36 = multiply(t35, t3, w0)
    t37 = multiply(delta_scaled, cross_share, w6)
    t38 = divide(delta_scaled, velocity_ratio, w7)
    t39 = divide(tracking_index, t38, w8)
    t41 = multiply(t36, n3, w9)
    t42 = add(t41, t37, w9)
    t43 = multiply(sigma_scaled, t42, w6)
    t44 = add(rest_scaled, t43, w6)
    t45 = divide(t44, delta_scaled, w6)
    t46 = divide(t42, sigma_scaled, w9)
    t47 = multiply(t3, t46, w1)
    t48 = add(rest_scaled, t47, predicted_22)
    t49 = divide(t48, delta_scaled, predicted_22)
    t50 = add(t45, t49, w6)
    t51 = add(t50, t36, w6)
    t52 = multiply(cross_share, velocity_ratio, w2)
    t53 = divide(t52, tracking_index, w2)
    t54 = multiply(t28, n3, w0)
    t55 = multiply(t54, t51, w0)
    t56 = multiply(t53, t55, w0)
    t57 = multiply(t32, t38, w1)
    t59 = multiply(t28, t38, w7)
    t60 = multiply(t59, t53, w7)
    t61 = divide(t60, t28, w2)
    t62 = add(t60, n3, w7)
    t63 = divide(t62, t28, w7)
    t64 = square(t61, w2)
    t65 = square(t63, w7)
    t66 = divide(t64, tracking_index, w2)
    t67 = divide(t65, t32, w7)
    t68 = add(t66, t67, w2)
    t69 = multiply(t39, t68, w2)
    t70 = multiply(tracking_index, n3, w3)
    multiply(t39, t34, predicted_11)
    divide(t56, t57, predicted_12)
    add(t69, t70, predicted_22)


_PREDICTED_COVARIANCE_BY_TRACKING_INDEX = Signature(
    "predicted_covariance_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_3, _VELOCITY_RATIO_DOMAIN_3),
    ("predicted_11", "predicted_12", "predicted_22"),
    10,
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
        predicted_22 = delta h + Lambda^2,
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = delta h,
        s = 2 U12 + U22,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    predicted_11: derivative by S of the variance of the predicted position over sigma_o^2. Relative
        error at most 32.32 * 2^-52 (float64), 29.02 * 2^-23 (float32), proved for every input.
    predicted_12: derivative by S of the covariance of predicted position and velocity times
        T/sigma_o^2. Relative error at most 31.22 * 2^-52 (float64), 27.28 * 2^-23 (float32), proved
        for every input.
    predicted_22: derivative by S of the variance of the predicted velocity times T^2/sigma_o^2.
        Relative error at most 32.85 * 2^-52 (float64), 34.27 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t6 = (t2 + 16.0) * (velocity_ratio * velocity_ratio)
    t10 = form.sqrt(t6 + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t24 = tracking_index / (t22 + velocity_ratio)
    t27 = t19 / velocity_ratio
    t28 = t17 * t24
    t30 = (t28 / velocity_ratio) / velocity_ratio
    t31 = t27 * t30
    t33 = (t24 * velocity_ratio) / velocity_ratio
    t36 = ((t33 / velocity_ratio) * 2.0) + t31
    t37 = (t24 * (velocity_ratio * t22)) / velocity_ratio
    t40 = ((t28 + t2) / velocity_ratio) / velocity_ratio
    t43 = t37 + ((t40 / t27) * 2.0)
    t47 = t10 / velocity_ratio
    t49 = ((t31 * t31) / tracking_index) + ((t36 * t36) / t47)
    t51 = velocity_ratio / (t17 / velocity_ratio)
    t57 = ((t31 * t37) / tracking_index) + ((t36 * t43) / t47)
    t63 = ((t37 * t37) / tracking_index) + ((t43 * t43) / t47)
    t52 = t51 * t49
    t58 = t51 * t57
    t64 = t51 * t63
    return (t52, t58, t64)


def _predicted_covariance_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w1)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, predicted_11)
    t11 = multiply(tracking_index, velocity_ratio, w1)
    t12 = add(t11, eta_scaled, w2)
    t14 = multiply(t12, n2, w2)
    t15 = multiply(t11, t14, w1)
    t16 = add(t2, t15, w1)
    delta_scaled = sqrt(t16, predicted_12)
    t18 = add(t14, delta_scaled, w2)
    sigma_scaled = multiply(t18, n2, w2)
    t20 = multiply(tracking_index, sigma_scaled, w1)
    t21 = divide(t20, velocity_ratio, predicted_22)
    coupling_scaled = divide(t21, velocity_ratio, predicted_22)
    t23 = add(coupling_scaled, velocity_ratio, w1)
    cross_share = divide(tracking_index, t23, w1)
    t25 = multiply(velocity_ratio, coupling_scaled, predicted_22)
    rest_scaled = multiply(cross_share, t25, predicted_22)
    t27 = divide(sigma_scaled, velocity_ratio, w2)
    t28 = multiply(delta_scaled, cross_share, w3)
    t29 = divide(t28, velocity_ratio, w4)
    t30 = divide(t29, velocity_ratio, w4)
    t31 = multiply(t27, t30, w4)
    t32 = multiply(cross_share, velocity_ratio, w1)
    t33 = divide(t32, velocity_ratio, w1)
    t34 = divide(t33, velocity_ratio, w1)
    t35 = multiply(t34, n3, w1)
    t36 = add(t35, t31, w1)
    t37 = divide(rest_scaled, velocity_ratio, predicted_22)
    t38 = add(t28, t2, w3)
    t39 = divide(t38, velocity_ratio, w3)
    t40 = divide(t39, velocity_ratio, w3)
    t41 = divide(t40, t27, w3)
    t42 = multiply(t41, n3, w3)
    t43 = add(t37, t42, w3)
    t44 = square(t31, w0)
    t45 = square(t36, w2)
    t46 = divide(t44, tracking_index, w0)
    t47 = divide(eta_scaled, velocity_ratio, predicted_11)
    t48 = divide(t45, t47, w2)
    t49 = add(t46, t48, w0)
    t50 = divide(delta_scaled, velocity_ratio, predicted_12)
    t51 = divide(velocity_ratio, t50, w2)
    t53 = multiply(t31, t37, w4)
    t54 = multiply(t36, t43, w1)
    t55 = divide(t53, tracking_index, w4)
    t56 = divide(t54, t47, w1)
    t57 = add(t55, t56, w4)
    t59 = square(t37, predicted_22)
    t60 = square(t43, w3)
    t61 = divide(t59, tracking_index, predicted_22)
    t62 = divide(t60, t47, w3)
    t63 = add(t61, t62, predicted_22)
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
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = delta h,
        s = 2 U12 + U22,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-5 and at most 1e5.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-5 and at most 1e5.

    updated_11: derivative by Lambda of the variance of the updated position over sigma_o^2.
        Relative error at most 34.79 * 2^-52 (float64), 27.90 * 2^-23 (float32), proved for every
        input.
    updated_12: derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_o^2. Error over the sum of its terms' sizes at most 38.53 * 2^-52 (float64), 32.49 *
        2^-23 (float32), proved for every input. Cancellation, condition number 1: what it is the
        derivative of grows in one part of the domain and falls in another, so that it vanishes
        between. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or
        more only where the value is below 1e-6 in float64 and 0.03 in float32 of what its error is
        relative to.
    updated_22: derivative by Lambda of the variance of the updated velocity times T^2/sigma_o^2.
        Relative error at most 42.26 * 2^-52 (float64), 38.81 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t6 = (t2 + 16.0) * (velocity_ratio * velocity_ratio)
    t10 = form.sqrt(t6 + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t23 = t22 + velocity_ratio
    t26 = t19 / velocity_ratio
    t27 = (velocity_ratio / t23) / t26
    t31 = ((t22 / t23) + 1.0) / t26
    t35 = t10 / velocity_ratio
    t37 = ((t27 * t27) / tracking_index) + ((t31 * t31) / t35)
    t38 = t17 / velocity_ratio
    t39 = tracking_index / t38
    t41 = (tracking_index / t23) * velocity_ratio
    t44 = (t26 * t38) * (t41 / tracking_index)
    t45 = t44 / t26
    t47 = (t44 + 2.0) / t26
    t52 = ((t45 * t45) / tracking_index) + ((t47 * t47) / t35)
    t40 = t39 * t37
    t53 = t39 * t52
    t60 = (t39 * ((t27 * t45) / tracking_index)) - (t39 * ((t31 * t47) / t35))
    return (t40, t60, t53)


def _updated_covariance_by_tracking_index_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 1.0,
    n4: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w1)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, updated_11)
    t11 = multiply(tracking_index, velocity_ratio, w1)
    t12 = add(t11, eta_scaled, w2)
    t14 = multiply(t12, n2, w2)
    t15 = multiply(t11, t14, w1)
    t16 = add(t2, t15, w0)
    delta_scaled = sqrt(t16, updated_22)
    t18 = add(t14, delta_scaled, w2)
    sigma_scaled = multiply(t18, n2, w2)
    t20 = multiply(tracking_index, sigma_scaled, w0)
    t21 = divide(t20, velocity_ratio, updated_12)
    coupling_scaled = divide(t21, velocity_ratio, updated_12)
    t23 = add(coupling_scaled, velocity_ratio, w0)
    cross_share = divide(tracking_index, t23, w1)
    t25 = divide(velocity_ratio, t23, w3)
    t26 = divide(sigma_scaled, velocity_ratio, w2)
    t27 = divide(t25, t26, w3)
    t28 = divide(coupling_scaled, t23, updated_12)
    t30 = add(t28, n3, updated_12)
    t31 = divide(t30, t26, updated_12)
    t32 = square(t27, w0)
    t33 = square(t31, w4)
    t34 = divide(t32, tracking_index, w0)
    t35 = divide(eta_scaled, velocity_ratio, updated_11)
    t36 = divide(t33, t35, w4)
    t37 = add(t34, t36, w0)
    t38 = divide(delta_scaled, velocity_ratio, updated_22)
    t39 = divide(tracking_index, t38, w4)
    t41 = multiply(cross_share, velocity_ratio, w1)
    t42 = multiply(t26, t38, updated_22)
    t43 = divide(t41, tracking_index, w1)
    t44 = multiply(t42, t43, updated_22)
    t45 = divide(t44, t26, w1)
    t46 = add(t44, n4, updated_22)
    t47 = divide(t46, t26, updated_22)
    t48 = square(t45, w2)
    t49 = square(t47, w5)
    t50 = divide(t48, tracking_index, w2)
    t51 = divide(t49, t35, w5)
    t52 = add(t50, t51, w2)
    t54 = multiply(t27, t45, w3)
    t55 = divide(t54, tracking_index, w3)
    t56 = multiply(t31, t47, updated_12)
    t57 = divide(t56, t35, updated_12)
    t58 = multiply(t39, t55, w3)
    t59 = multiply(t39, t57, updated_12)
    multiply(t39, t37, updated_11)
    multiply(t39, t52, updated_22)
    subtract(t58, t59, updated_12)


_UPDATED_COVARIANCE_BY_TRACKING_INDEX = Signature(
    "updated_covariance_by_tracking_index",
    (_TRACKING_INDEX_DOMAIN_2, _VELOCITY_RATIO_DOMAIN_2),
    ("updated_11", "updated_12", "updated_22"),
    6,
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
        U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = delta h,
        s = 2 U12 + U22,
        h = Lambda/(w + kappa), g = Lambda w - h, kappa = t sigma/S, t = Lambda/S,
        sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,
        w = 1, eta^2 = 16 + Lambda^2 + 4 t^2;
        all computed without a subtraction

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-30 and at most 1e30, in
        float32 at least 1e-4 and at most 1e4.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.

    updated_11: derivative by S of the variance of the updated position over sigma_o^2. Relative
        error at most 81.86 * 2^-52 (float64), 60.36 * 2^-23 (float32), proved for every input.
    updated_12: derivative by S of the covariance of updated position and velocity times
        T/sigma_o^2. Relative error at most 36.67 * 2^-52 (float64), 25.60 * 2^-23 (float32), proved
        for every input.
    updated_22: derivative by S of the variance of the updated velocity times T^2/sigma_o^2.
        Relative error at most 33.15 * 2^-52 (float64), 29.45 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t10 = form.sqrt(((t2 + 16.0) * t3) + (t2 * 4.0))
    t11 = tracking_index * velocity_ratio
    t14 = (t11 + t10) * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (tracking_index * t19) / velocity_ratio
    t22 = t21 / velocity_ratio
    t24 = tracking_index / (t22 + velocity_ratio)
    t29 = t17 * t24
    t30 = ((t24 / t19) * t3) / t2
    t31 = t29 / t2
    t32 = t30 * t30
    t42 = (((t32 * t32) * 8.0) + 2.0) / (((t32 * 2.0) + (t30 * 2.0)) + 1.0)
    t47 = t42 + (((t30 * 4.0) + (t31 * 2.0)) * t31)
    t48 = tracking_index / velocity_ratio
    t49 = t48 * t48
    t52 = t10 / velocity_ratio
    t55 = (8.0 + (t49 * 2.0)) / ((tracking_index + t52) * 0.5)
    t57 = t31 + 1.0
    t60 = t47 + ((t55 / tracking_index) * (t57 * t57))
    t63 = t19 / velocity_ratio
    t65 = ((t2 / velocity_ratio) / t63) / velocity_ratio
    t67 = t17 / velocity_ratio
    t68 = velocity_ratio / t67
    t71 = t67 * t67
    t79 = (t71 + (((t67 * t52) * 3.0) * 0.5)) + ((tracking_index * t52) * 0.5)
    t85 = ((t52 * t71) * (t67 + tracking_index)) * 0.5
    t90 = (t49 * 4.0) * ((t48 / velocity_ratio) * t67)
    t92 = (t85 + t2) + (t49 * (t79 + (t2 * 0.5)))
    t94 = t3 + t71
    t98 = ((tracking_index / t63) * 2.0) * (velocity_ratio / t94)
    t103 = (t24 * (velocity_ratio * t22)) / velocity_ratio
    t106 = ((t29 + t2) / velocity_ratio) / velocity_ratio
    t109 = t103 + ((t106 / t63) * 2.0)
    t114 = ((t103 * t103) / tracking_index) + ((t109 * t109) / t52)
    t70 = ((t65 * t65) * t68) * (t60 / t52)
    t102 = t98 * (((t92 + t90) / t94) / (t52 * t67))
    t115 = t68 * t114
    return (t70, t102, t115)


def _updated_covariance_by_velocity_ratio_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 8.0,
    n4: float = 2.0,
    n5: float = 1.0,
    n6: float = 3.0,
) -> None:
    tracking_index, velocity_ratio = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w3)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, updated_11)
    t11 = multiply(tracking_index, velocity_ratio, w2)
    t12 = add(t11, eta_scaled, w3)
    t14 = multiply(t12, n2, w3)
    t15 = multiply(t11, t14, w2)
    t16 = add(t2, t15, w2)
    delta_scaled = sqrt(t16, updated_12)
    t18 = add(t14, delta_scaled, w3)
    sigma_scaled = multiply(t18, n2, w3)
    t20 = multiply(tracking_index, sigma_scaled, w2)
    t21 = divide(t20, velocity_ratio, w2)
    coupling_scaled = divide(t21, velocity_ratio, updated_22)
    t23 = add(coupling_scaled, velocity_ratio, w2)
    cross_share = divide(tracking_index, t23, w2)
    t25 = multiply(velocity_ratio, coupling_scaled, updated_22)
    rest_scaled = multiply(cross_share, t25, updated_22)
    t27 = divide(cross_share, sigma_scaled, w4)
    t28 = multiply(t27, t3, w4)
    t29 = multiply(delta_scaled, cross_share, w2)
    t30 = divide(t28, t2, w4)
    t31 = divide(t29, t2, w5)
    t32 = square(t30, w6)
    t33 = square(t32, w7)
    t35 = multiply(t33, n3, w7)
    t36 = add(t35, n4, w7)
    t37 = multiply(t32, n4, w6)
    t38 = multiply(t30, n4, w8)
    t39 = add(t37, t38, w6)
    t41 = add(t39, n5, w6)
    t42 = divide(t36, t41, w7)
    t43 = multiply(t30, n1, w4)
    t44 = multiply(t31, n4, w6)
    t45 = add(t43, t44, w4)
    t46 = multiply(t45, t31, w4)
    t47 = add(t42, t46, w7)
    t48 = divide(tracking_index, velocity_ratio, w4)
    t49 = square(t48, w6)
    t50 = multiply(t49, n4, w8)
    t51 = add(n3, t50, w8)
    t52 = divide(eta_scaled, velocity_ratio, updated_11)
    t53 = add(tracking_index, t52, w9)
    t54 = multiply(t53, n2, w9)
    t55 = divide(t51, t54, w8)
    t56 = divide(t55, tracking_index, w8)
    t57 = add(t31, n5, w5)
    t58 = square(t57, w5)
    t59 = multiply(t56, t58, w8)
    t60 = add(t47, t59, w7)
    t62 = divide(t2, velocity_ratio, w8)
    t63 = divide(sigma_scaled, velocity_ratio, w3)
    t64 = divide(t62, t63, w8)
    t65 = divide(t64, velocity_ratio, w8)
    t66 = square(t65, w8)
    t67 = divide(delta_scaled, velocity_ratio, updated_12)
    t68 = divide(velocity_ratio, t67, w5)
    t69 = multiply(t66, t68, w8)
    t71 = square(t67, w9)
    t72 = multiply(t67, t52, w10)
    t74 = multiply(t72, n6, w10)
    t75 = multiply(t74, n2, w10)
    t76 = add(t71, t75, w10)
    t77 = multiply(tracking_index, t52, w11)
    t78 = multiply(t77, n2, w11)
    t79 = add(t76, t78, w10)
    t80 = multiply(t2, n2, w11)
    t81 = add(t79, t80, w10)
    t82 = multiply(t52, t71, w11)
    t83 = add(t67, tracking_index, w12)
    t84 = multiply(t82, t83, w11)
    t85 = multiply(t84, n2, w11)
    t86 = multiply(t49, t81, w10)
    t87 = multiply(t49, n1, w6)
    t88 = divide(t48, velocity_ratio, w4)
    t89 = multiply(t88, t67, w4)
    t90 = multiply(t87, t89, w6)
    t91 = add(t85, t2, w11)
    t92 = add(t91, t86, w11)
    t93 = add(t92, t90, w11)
    t94 = add(t3, t71, w1)
    t95 = divide(tracking_index, t63, w9)
    t96 = multiply(t95, n4, w9)
    t97 = divide(velocity_ratio, t94, w6)
    t98 = multiply(t96, t97, w9)
    t99 = divide(t93, t94, w11)
    t100 = multiply(t52, t67, updated_12)
    t103 = divide(rest_scaled, velocity_ratio, updated_22)
    t104 = add(t29, t2, w2)
    t105 = divide(t104, velocity_ratio, w2)
    t106 = divide(t105, velocity_ratio, w2)
    t107 = divide(t106, t63, w2)
    t108 = multiply(t107, n4, w2)
    t109 = add(t103, t108, w2)
    t110 = square(t103, updated_22)
    t111 = square(t109, w2)
    t113 = divide(t111, t52, w2)
    t61 = divide(t60, t52, updated_11)
    multiply(t69, t61, updated_11)
    t101 = divide(t99, t100, updated_12)
    multiply(t98, t101, updated_12)
    t112 = divide(t110, tracking_index, updated_22)
    t114 = add(t112, t113, updated_22)
    multiply(t68, t114, updated_22)


_UPDATED_COVARIANCE_BY_VELOCITY_RATIO = Signature(
    "updated_covariance_by_velocity_ratio",
    (_TRACKING_INDEX_DOMAIN_3, _VELOCITY_RATIO_DOMAIN_3),
    ("updated_11", "updated_12", "updated_22"),
    13,
    _updated_covariance_by_velocity_ratio_block,
    numbers=_updated_covariance_by_velocity_ratio_of_numbers,
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
        half_sum = Lambda^2/(2 m sigma) (4/Lambda^2 + 1/S^2),
        quarter_discriminant = (Lambda^2/(2 delta sigma))^2 (1/S^4 - 4/Lambda^2),
        sigma, m and delta as in gains. Near the curve where the poles meet their difference is
        the square root of a difference: the poles themselves have half the digits there.

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-6 and at most 1e6.
    velocity_ratio: S = sampling_interval velocity_deviation/position_deviation; a number at least
        1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e6.

    half_sum: half the sum of the poles, the real part of each where they are complex. Relative
        error at most 7.09 * 2^-52 (float64), 7.03 * 2^-23 (float32), proved for every input.
    modulus: the geometric mean of their moduli, the modulus of each where they are complex.
        Relative error at most 3.11 * 2^-52 (float64), 3.04 * 2^-23 (float32), proved for every
        input.
    quarter_discriminant: the square of half their difference, negative where they are complex.
        Error over the sum of its terms' sizes at most 14.62 * 2^-52 (float64), 14.56 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: the poles meet on a
        curve. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or
        more only where the value is below 4e-7 in float64 and 0.02 in float32 of what its error is
        relative to.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t6 = (t2 + 16.0) * (velocity_ratio * velocity_ratio)
    t11 = tracking_index * velocity_ratio
    t12 = t11 + form.sqrt(t6 + (t2 * 4.0))
    t14 = t12 * 0.5
    t17 = form.sqrt(t2 + (t11 * t14))
    t19 = (t14 + t17) * 0.5
    t21 = (velocity_ratio / t12) * velocity_ratio
    t26 = (tracking_index / t12) * (tracking_index / t19)
    t31 = tracking_index / ((t17 * t19) * 2.0)
    t32 = tracking_index * t31
    t35 = (velocity_ratio * t31) * (velocity_ratio * 2.0)
    t27 = (t21 * (4.0 / t19)) + t26
    t28 = velocity_ratio / t19
    t38 = (t32 * t32) - (t35 * t35)
    return (t27, t28, t38)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 16.0,
    n1: float = 4.0,
    n2: float = 0.5,
    n3: float = 2.0,
) -> None:
    tracking_index, velocity_ratio = given
    half_sum, modulus, quarter_discriminant = out
    w0, w1, w2 = work
    t2 = square(tracking_index, w0)
    t3 = square(velocity_ratio, w1)
    t5 = add(t2, n0, w2)
    t6 = multiply(t5, t3, w2)
    t8 = multiply(t2, n1, w1)
    t9 = add(t6, t8, w2)
    eta_scaled = sqrt(t9, half_sum)
    t11 = multiply(tracking_index, velocity_ratio, w1)
    t12 = add(t11, eta_scaled, half_sum)
    t14 = multiply(t12, n2, w2)
    t15 = multiply(t11, t14, w1)
    t16 = add(t2, t15, w0)
    delta_scaled = sqrt(t16, modulus)
    t18 = add(t14, delta_scaled, w2)
    sigma_scaled = multiply(t18, n2, w2)
    t20 = divide(velocity_ratio, t12, quarter_discriminant)
    t21 = multiply(t20, velocity_ratio, quarter_discriminant)
    t22 = divide(n1, sigma_scaled, w0)
    t23 = multiply(t21, t22, quarter_discriminant)
    t24 = divide(tracking_index, t12, half_sum)
    t25 = divide(tracking_index, sigma_scaled, w0)
    t26 = multiply(t24, t25, half_sum)
    t29 = multiply(delta_scaled, sigma_scaled, modulus)
    t30 = multiply(t29, n3, modulus)
    t31 = divide(tracking_index, t30, modulus)
    t32 = multiply(tracking_index, t31, w0)
    t33 = multiply(velocity_ratio, t31, modulus)
    t34 = multiply(velocity_ratio, n3, w1)
    t35 = multiply(t33, t34, modulus)
    t36 = square(t32, w0)
    t37 = square(t35, w1)
    add(t23, t26, half_sum)
    divide(velocity_ratio, sigma_scaled, modulus)
    subtract(t36, t37, quarter_discriminant)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN_4, _VELOCITY_RATIO_DOMAIN_4),
    ("half_sum", "modulus", "quarter_discriminant"),
    3,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)


class RealPoles(NamedTuple):
    """Result of `real_poles`."""

    positive_from: Real
    """The 1/S^2 from which on both poles are real and positive."""


def real_poles(
    tracking_index: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> RealPoles:
    """The values of 1/S^2 between which the closed-loop poles are complex.

        positive_from = 2 r/Lambda, r = 1

    tracking_index: Lambda, with Lambda^2 = increment_deviation^2
        sampling_interval^2/position_deviation^2; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-8 and at most 1e8.

    positive_from: the 1/S^2 from which on both poles are real and positive. Relative error at most
        0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for 1e-12 <= tracking_index <=
        1000000000000.0 (float64) and 1e-08 <= tracking_index <= 1e08 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation position-velocity-random-velocity
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
    t2 = 2.0 / tracking_index
    return (t2,)


def _real_poles_block(
    given: Arrays, out: Arrays, _work: Arrays, _single: bool, n0: float = 2.0
) -> None:
    (tracking_index,) = given
    (positive_from,) = out
    divide(n0, tracking_index, positive_from)


_REAL_POLES = Signature(
    "real_poles",
    (_TRACKING_INDEX_DOMAIN_5,),
    ("positive_from",),
    0,
    _real_poles_block,
    numbers=_real_poles_of_numbers,
)
