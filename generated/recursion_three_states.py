# Made by: gainproof generate recursion-three-states
# From: gainproof derive recursion-three-states, SymPy 1.14.0
"""Kalman recursion of position, velocity and acceleration, any intervals."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from gainproof.generated._runtime import Domain, Signature, evaluate

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.generated._runtime import Arrays, Real

__all__ = [
    "Covariance",
    "Gains",
    "PredictAccelerationIncrements",
    "PredictContinuousWhiteJerk",
    "PredictRandomJerk",
    "PredictWienerAcceleration",
    "Update",
    "covariance",
    "gains",
    "predict_acceleration_increments",
    "predict_continuous_white_jerk",
    "predict_random_jerk",
    "predict_wiener_acceleration",
    "update",
]

_DIAGONAL_1_DOMAIN = Domain(
    "diagonal_1",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5",
    (1e-30, 1e30),
    (9.999999747378752e-05, 100000.0),
)
_DIAGONAL_2_DOMAIN = Domain(
    "diagonal_2",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5",
    (1e-30, 1e30),
    (9.999999747378752e-05, 100000.0),
)
_DIAGONAL_3_DOMAIN = Domain(
    "diagonal_3",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5",
    (1e-30, 1e30),
    (9.999999747378752e-05, 100000.0),
)
_FIRST_SHEAR_DOMAIN = Domain(
    "first_shear",
    "0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and at most 1e3",
    (1e-15, 1000000000000000.0),
    (0.0010000000474974513, 1000.0),
    zero=True,
)
_SECOND_SHEAR_DOMAIN = Domain(
    "second_shear",
    "0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and at most 1e3",
    (1e-15, 1000000000000000.0),
    (0.0010000000474974513, 1000.0),
    zero=True,
)
_THIRD_SHEAR_DOMAIN = Domain(
    "third_shear",
    "0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and at most 1e3",
    (1e-15, 1000000000000000.0),
    (0.0010000000474974513, 1000.0),
    zero=True,
)
_MEASUREMENT_VARIANCE_DOMAIN = Domain(
    "measurement_variance",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5",
    (1e-30, 1e30),
    (9.999999747378752e-05, 100000.0),
)
_INTERVAL_DOMAIN = Domain(
    "interval",
    "a number at least 1e-10 and at most 1e10, in float32 at least 1e-2 and at most 1e2",
    (1e-10, 10000000000.0),
    (0.009999999776482582, 100.0),
)
_STRENGTH_DOMAIN = Domain(
    "strength",
    "0 or a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4",
    (1e-30, 1e30),
    (9.999999747378752e-05, 10000.0),
    zero=True,
)


class Covariance(NamedTuple):
    """Result of `covariance`."""

    covariance_11: Real
    """Variance of the position, m^2."""
    covariance_12: Real
    """Covariance of position and velocity, m^2/s."""
    covariance_13: Real
    """Covariance of position and acceleration, m^2/s^2."""
    covariance_22: Real
    """Variance of the velocity, m^2/s^2."""
    covariance_23: Real
    """Covariance of velocity and acceleration, m^2/s^3."""
    covariance_33: Real
    """Variance of the acceleration, m^2/s^4."""


def covariance(
    diagonal_1: ArrayLike,
    diagonal_2: ArrayLike,
    diagonal_3: ArrayLike,
    first_shear: ArrayLike,
    second_shear: ArrayLike,
    third_shear: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
) -> Covariance:
    """Covariance of position, velocity and acceleration from its factors.

        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2; a number at
        least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_3: d3, variance of the acceleration, m^2/s^4; a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e5.
    first_shear: a, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    second_shear: b, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    third_shear: c, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.

    covariance_11: variance of the position, m^2. Relative error at most 3.01 * 2^-52 (float64),
        3.01 * 2^-23 (float32), proved for every input.
    covariance_12: covariance of position and velocity, m^2/s. Relative error at most 2.01 * 2^-52
        (float64), 2.01 * 2^-23 (float32), proved for every input.
    covariance_13: covariance of position and acceleration, m^2/s^2. Relative error at most 1.01 *
        2^-52 (float64), 1.01 * 2^-23 (float32), proved for every input.
    covariance_22: variance of the velocity, m^2/s^2. Relative error at most 1.51 * 2^-52 (float64),
        1.51 * 2^-23 (float32), proved for every input.
    covariance_23: covariance of velocity and acceleration, m^2/s^3. Relative error at most 0.51 *
        2^-52 (float64), 0.51 * 2^-23 (float32), proved for every input.
    covariance_33: variance of the acceleration, m^2/s^4. Relative error at most 0.00 * 2^-52
        (float64), 0.00 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation recursion-three-states
    """
    return Covariance(
        *evaluate(
            _COVARIANCE,
            (diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear),
            out,
        )
    )


def _covariance_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear = given
    covariance_11, covariance_12, covariance_13, covariance_22, covariance_23, covariance_33 = out
    w0, w1, w2, w3, w4 = work
    t6 = np.add(first_shear, third_shear, w0)
    t7 = np.multiply(t6, diagonal_2, w1)
    np.multiply(second_shear, diagonal_3, covariance_23)
    np.multiply(first_shear, covariance_23, covariance_13)
    t10 = np.multiply(second_shear, covariance_23, w2)
    t11 = np.multiply(t6, t7, w0)
    t12 = np.add(diagonal_1, t11, w0)
    t13 = np.multiply(first_shear, second_shear, w3)
    t14 = np.multiply(t13, covariance_13, w3)
    t16 = np.multiply(second_shear, covariance_13, w4)
    np.add(t12, t14, covariance_11)
    np.add(t7, t16, covariance_12)
    np.add(diagonal_2, t10, covariance_22)
    np.copyto(covariance_33, diagonal_3)


_COVARIANCE = Signature(
    "covariance",
    (
        _DIAGONAL_1_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _DIAGONAL_3_DOMAIN,
        _FIRST_SHEAR_DOMAIN,
        _SECOND_SHEAR_DOMAIN,
        _THIRD_SHEAR_DOMAIN,
    ),
    (
        "covariance_11",
        "covariance_12",
        "covariance_13",
        "covariance_22",
        "covariance_23",
        "covariance_33",
    ),
    5,
    _covariance_block,
)


class Gains(NamedTuple):
    """Result of `gains`."""

    position_gain: Real
    """Gain of the position, dimensionless."""
    velocity_gain: Real
    """Gain of the velocity, 1/s."""
    acceleration_gain: Real
    """Gain of the acceleration, 1/s^2."""
    innovation_variance: Real
    """Variance of the innovation, m^2."""


def gains(
    diagonal_1: ArrayLike,
    diagonal_2: ArrayLike,
    diagonal_3: ArrayLike,
    first_shear: ArrayLike,
    second_shear: ArrayLike,
    third_shear: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
) -> Gains:
    """Kalman gain and variance of the innovation, before the position is measured.

        P H'/S, S = innovation_variance = H P H' + r, H = [1, 0, 0],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2; a number at
        least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_3: d3, variance of the acceleration, m^2/s^4; a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e5.
    first_shear: a, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    second_shear: b, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    third_shear: c, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-30 and at
        most 1e30, in float32 at least 1e-4 and at most 1e5.

    position_gain: gain of the position, dimensionless. Relative error at most 6.51 * 2^-52
        (float64), 6.51 * 2^-23 (float32), proved for every input.
    velocity_gain: gain of the velocity, 1/s. Relative error at most 5.51 * 2^-52 (float64), 5.51 *
        2^-23 (float32), proved for every input.
    acceleration_gain: gain of the acceleration, 1/s^2. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input.
    innovation_variance: variance of the innovation, m^2. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation recursion-three-states
    """
    return Gains(
        *evaluate(
            _GAINS,
            (
                diagonal_1,
                diagonal_2,
                diagonal_3,
                first_shear,
                second_shear,
                third_shear,
                measurement_variance,
            ),
            out,
        )
    )


def _gains_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        diagonal_1,
        diagonal_2,
        diagonal_3,
        first_shear,
        second_shear,
        third_shear,
        measurement_variance,
    ) = given
    position_gain, velocity_gain, acceleration_gain, innovation_variance = out
    w0, w1, w2, w3, w4 = work
    t7 = np.add(first_shear, third_shear, w0)
    t8 = np.multiply(t7, diagonal_2, w1)
    t9 = np.add(diagonal_1, measurement_variance, w2)
    t10 = np.multiply(t7, t8, w0)
    t11 = np.add(t9, t10, w2)
    t12 = np.multiply(second_shear, diagonal_3, w3)
    t13 = np.multiply(first_shear, t12, w3)
    t14 = np.multiply(first_shear, second_shear, w4)
    t15 = np.multiply(t14, t13, w4)
    np.add(t11, t15, innovation_variance)
    t17 = np.add(diagonal_1, t10, w0)
    t18 = np.add(t17, t15, w0)
    t20 = np.multiply(second_shear, t13, w2)
    t21 = np.add(t8, t20, w1)
    np.divide(t18, innovation_variance, position_gain)
    np.divide(t21, innovation_variance, velocity_gain)
    np.divide(t13, innovation_variance, acceleration_gain)


_GAINS = Signature(
    "gains",
    (
        _DIAGONAL_1_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _DIAGONAL_3_DOMAIN,
        _FIRST_SHEAR_DOMAIN,
        _SECOND_SHEAR_DOMAIN,
        _THIRD_SHEAR_DOMAIN,
        _MEASUREMENT_VARIANCE_DOMAIN,
    ),
    ("position_gain", "velocity_gain", "acceleration_gain", "innovation_variance"),
    5,
    _gains_block,
)


class Update(NamedTuple):
    """Result of `update`."""

    diagonal_1: Real
    """D1, variance of the position, velocity and acceleration known, m^2."""
    diagonal_2: Real
    """D2, variance of the velocity, acceleration known, m^2/s^2."""
    diagonal_3: Real
    """D3, variance of the acceleration, m^2/s^4."""
    first_shear: Real
    """A, s."""
    second_shear: Real
    """B, s."""
    third_shear: Real
    """C, s."""


def update(
    diagonal_1: ArrayLike,
    diagonal_2: ArrayLike,
    diagonal_3: ArrayLike,
    first_shear: ArrayLike,
    second_shear: ArrayLike,
    third_shear: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
) -> Update:
    """Factors of the covariance after the position is measured.

        P - P H' H P/(H P H' + r) = U D U' with the factors that come, H = [1, 0, 0],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2; a number at
        least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_3: d3, variance of the acceleration, m^2/s^4; a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e5.
    first_shear: a, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    second_shear: b, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    third_shear: c, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-30 and at
        most 1e30, in float32 at least 1e-4 and at most 1e5.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 6.51 * 2^-52
        (float64), 6.51 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved
        for every input.
    second_shear: b, s. Relative error at most 5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved
        for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation recursion-three-states
    """
    return Update(
        *evaluate(
            _UPDATE,
            (
                diagonal_1,
                diagonal_2,
                diagonal_3,
                first_shear,
                second_shear,
                third_shear,
                measurement_variance,
            ),
            out,
        )
    )


def _update_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        diagonal_1,
        diagonal_2,
        diagonal_3,
        first_shear,
        second_shear,
        third_shear,
        measurement_variance,
    ) = given
    diagonal_1_, diagonal_2_, diagonal_3_, first_shear_, second_shear_, third_shear_ = out
    w0, w1, w2, w3, w4 = work
    t7 = np.add(first_shear, third_shear, w0)
    t8 = np.multiply(t7, diagonal_2, w1)
    t9 = np.add(diagonal_1, measurement_variance, w2)
    t10 = np.multiply(t7, t8, w0)
    t11 = np.add(t9, t10, w0)
    t12 = np.multiply(third_shear, t8, w1)
    t13 = np.add(t9, t12, w1)
    t14 = np.multiply(second_shear, diagonal_3, w3)
    t15 = np.multiply(first_shear, t14, w3)
    t16 = np.multiply(first_shear, second_shear, w4)
    t17 = np.multiply(t16, t15, w4)
    t18 = np.add(t11, t17, w4)
    t19 = np.divide(measurement_variance, t9, diagonal_1_)
    t21 = np.divide(t9, t11, diagonal_2_)
    t23 = np.divide(t11, t18, diagonal_3_)
    t25 = np.divide(measurement_variance, t13, first_shear_)
    t27 = np.divide(t13, t11, second_shear_)
    t29 = np.divide(t11, t13, third_shear_)
    t30 = np.multiply(t19, t29, third_shear_)
    np.multiply(diagonal_1, t19, diagonal_1_)
    np.multiply(diagonal_2, t21, diagonal_2_)
    np.multiply(diagonal_3, t23, diagonal_3_)
    np.multiply(first_shear, t25, first_shear_)
    np.multiply(second_shear, t27, second_shear_)
    np.multiply(third_shear, t30, third_shear_)


_UPDATE = Signature(
    "update",
    (
        _DIAGONAL_1_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _DIAGONAL_3_DOMAIN,
        _FIRST_SHEAR_DOMAIN,
        _SECOND_SHEAR_DOMAIN,
        _THIRD_SHEAR_DOMAIN,
        _MEASUREMENT_VARIANCE_DOMAIN,
    ),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    5,
    _update_block,
)


class PredictAccelerationIncrements(NamedTuple):
    """Result of `predict_acceleration_increments`."""

    diagonal_1: Real
    """D1, variance of the position, velocity and acceleration known, m^2."""
    diagonal_2: Real
    """D2, variance of the velocity, acceleration known, m^2/s^2."""
    diagonal_3: Real
    """D3, variance of the acceleration, m^2/s^4."""
    first_shear: Real
    """A, s."""
    second_shear: Real
    """B, s."""
    third_shear: Real
    """C, s."""


def predict_acceleration_increments(
    diagonal_1: ArrayLike,
    diagonal_2: ArrayLike,
    diagonal_3: ArrayLike,
    first_shear: ArrayLike,
    second_shear: ArrayLike,
    third_shear: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
) -> PredictAccelerationIncrements:
    """Factors of the covariance after an interval, acceleration increments.

        F P F' + Q = U D U' with the factors that come, F = [1, t, t^2/2; 0, 1, t; 0, 0, 1],
        Q = [0, 0, 0; 0, 0, 0; 0, 0, q],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2; a number at
        least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_3: d3, variance of the acceleration, m^2/s^4; a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e5.
    first_shear: a, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    second_shear: b, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    third_shear: c, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    interval: t, time since the covariance given, s; a number at least 1e-10 and at most 1e10, in
        float32 at least 1e-2 and at most 1e2.
    strength: q, variance of the acceleration increment, the same for an interval of any length; 0
        or a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 11.51 * 2^-52 (float64), 11.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 0.51 * 2^-52
        (float64), 0.51 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved
        for every input.
    second_shear: b, s. Relative error at most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved
        for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation recursion-three-states
    """
    return PredictAccelerationIncrements(
        *evaluate(
            _PREDICT_ACCELERATION_INCREMENTS,
            (
                diagonal_1,
                diagonal_2,
                diagonal_3,
                first_shear,
                second_shear,
                third_shear,
                interval,
                strength,
            ),
            out,
        )
    )


def _predict_acceleration_increments_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        diagonal_1,
        diagonal_2,
        diagonal_3,
        first_shear,
        second_shear,
        third_shear,
        interval,
        strength,
    ) = given
    diagonal_1_, diagonal_2_, diagonal_3_, first_shear_, second_shear_, third_shear_ = out
    w0, w1, w2, w3, w4 = work
    np.add(diagonal_3, strength, diagonal_3_)
    t9 = np.divide(strength, diagonal_3_, diagonal_2_)
    t10 = np.add(interval, second_shear, w0)
    t11 = np.multiply(diagonal_3, t9, w1)
    t12 = np.add(first_shear, third_shear, diagonal_2_)
    t14 = np.multiply(interval, 0.5, w2)
    t15 = np.add(t14, t12, diagonal_2_)
    t16 = np.multiply(second_shear, third_shear, w3)
    t17 = np.multiply(interval, t15, diagonal_2_)
    t18 = np.add(t17, t16, w3)
    t19 = np.square(t10, diagonal_2_)
    t20 = np.multiply(t11, t19, diagonal_2_)
    np.add(diagonal_2, t20, diagonal_2_)
    t22 = np.multiply(t10, diagonal_3, w0)
    t23 = np.add(t14, second_shear, w2)
    t24 = np.multiply(second_shear, first_shear, w4)
    t25 = np.multiply(interval, t23, w2)
    t26 = np.add(t25, t24, w2)
    t27 = np.multiply(t26, diagonal_3, w2)
    t28 = np.square(t18, w4)
    t29 = np.multiply(t11, t28, w1)
    t30 = np.multiply(diagonal_2, t29, w1)
    t31 = np.divide(t30, diagonal_2_, diagonal_1_)
    t33 = np.multiply(t18, diagonal_3, w3)
    t34 = np.multiply(diagonal_2, t33, w3)
    t37 = np.multiply(diagonal_2_, t22, w1)
    np.add(diagonal_1, t31, diagonal_1_)
    np.divide(t27, t22, first_shear_)
    np.divide(t22, diagonal_3_, second_shear_)
    np.divide(t34, t37, third_shear_)


_PREDICT_ACCELERATION_INCREMENTS = Signature(
    "predict_acceleration_increments",
    (
        _DIAGONAL_1_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _DIAGONAL_3_DOMAIN,
        _FIRST_SHEAR_DOMAIN,
        _SECOND_SHEAR_DOMAIN,
        _THIRD_SHEAR_DOMAIN,
        _INTERVAL_DOMAIN,
        _STRENGTH_DOMAIN,
    ),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    5,
    _predict_acceleration_increments_block,
)


class PredictWienerAcceleration(NamedTuple):
    """Result of `predict_wiener_acceleration`."""

    diagonal_1: Real
    """D1, variance of the position, velocity and acceleration known, m^2."""
    diagonal_2: Real
    """D2, variance of the velocity, acceleration known, m^2/s^2."""
    diagonal_3: Real
    """D3, variance of the acceleration, m^2/s^4."""
    first_shear: Real
    """A, s."""
    second_shear: Real
    """B, s."""
    third_shear: Real
    """C, s."""


def predict_wiener_acceleration(
    diagonal_1: ArrayLike,
    diagonal_2: ArrayLike,
    diagonal_3: ArrayLike,
    first_shear: ArrayLike,
    second_shear: ArrayLike,
    third_shear: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
) -> PredictWienerAcceleration:
    """Factors of the covariance after an interval, wiener acceleration.

        F P F' + Q = U D U' with the factors that come, F = [1, t, t^2/2; 0, 1, t; 0, 0, 1],
        Q = [q t^4/4, q t^3/2, q t^2/2; q t^3/2, q t^2, q t; q t^2/2, q t, q],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2; a number at
        least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_3: d3, variance of the acceleration, m^2/s^4; a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e5.
    first_shear: a, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    second_shear: b, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    third_shear: c, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    interval: t, time since the covariance given, s; a number at least 1e-10 and at most 1e10, in
        float32 at least 1e-2 and at most 1e2.
    strength: q, variance of the acceleration that is added for the interval and stays; 0 or a
        number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 0.51 * 2^-52
        (float64), 0.51 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved
        for every input.
    second_shear: b, s. Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32), proved
        for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation recursion-three-states
    """
    return PredictWienerAcceleration(
        *evaluate(
            _PREDICT_WIENER_ACCELERATION,
            (
                diagonal_1,
                diagonal_2,
                diagonal_3,
                first_shear,
                second_shear,
                third_shear,
                interval,
                strength,
            ),
            out,
        )
    )


def _predict_wiener_acceleration_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        diagonal_1,
        diagonal_2,
        diagonal_3,
        first_shear,
        second_shear,
        third_shear,
        interval,
        strength,
    ) = given
    diagonal_1_, diagonal_2_, diagonal_3_, first_shear_, second_shear_, third_shear_ = out
    w0, w1, w2, w3, w4, w5, w6 = work
    np.add(diagonal_3, strength, diagonal_3_)
    t9 = np.divide(strength, diagonal_3_, diagonal_2_)
    t10 = np.multiply(diagonal_3, t9, w0)
    t11 = np.multiply(second_shear, third_shear, w1)
    t12 = np.square(second_shear, diagonal_2_)
    t13 = np.multiply(t10, t12, diagonal_2_)
    np.add(diagonal_2, t13, diagonal_2_)
    t15 = np.add(interval, second_shear, w2)
    t16 = np.multiply(t15, diagonal_3, w2)
    t17 = np.multiply(strength, interval, w3)
    t18 = np.add(t16, t17, w2)
    t20 = np.multiply(interval, 0.5, w3)
    t21 = np.add(t20, second_shear, w4)
    t22 = np.multiply(second_shear, first_shear, w5)
    t23 = np.multiply(interval, t21, w4)
    t24 = np.add(t23, t22, w4)
    t25 = np.multiply(t24, diagonal_3, w4)
    t26 = np.multiply(interval, t20, w6)
    t27 = np.multiply(strength, t26, w6)
    t28 = np.add(t25, t27, w4)
    t29 = np.square(t11, w6)
    t30 = np.multiply(t10, t29, w0)
    t31 = np.multiply(diagonal_2, t30, w0)
    t32 = np.divide(t31, diagonal_2_, diagonal_1_)
    t34 = np.add(first_shear, third_shear, w0)
    t35 = np.add(t20, t34, w3)
    t36 = np.multiply(interval, t35, w3)
    t37 = np.multiply(second_shear, 0.5, w0)
    t38 = np.multiply(second_shear, t37, w0)
    t39 = np.multiply(second_shear, t22, w5)
    t40 = np.multiply(interval, t38, w0)
    t41 = np.add(t40, t39, w0)
    t42 = np.multiply(interval, t41, w0)
    t43 = np.add(t36, t11, w1)
    t44 = np.multiply(t43, diagonal_3, w1)
    t45 = np.multiply(t36, strength, w3)
    t46 = np.add(t44, t45, w1)
    t47 = np.multiply(diagonal_3, t42, w0)
    t48 = np.multiply(diagonal_2, t46, w1)
    t49 = np.multiply(strength, t47, w0)
    t50 = np.add(t48, t49, w1)
    t53 = np.multiply(diagonal_2_, t18, w0)
    np.add(diagonal_1, t32, diagonal_1_)
    np.divide(t28, t18, first_shear_)
    np.divide(t18, diagonal_3_, second_shear_)
    np.divide(t50, t53, third_shear_)


_PREDICT_WIENER_ACCELERATION = Signature(
    "predict_wiener_acceleration",
    (
        _DIAGONAL_1_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _DIAGONAL_3_DOMAIN,
        _FIRST_SHEAR_DOMAIN,
        _SECOND_SHEAR_DOMAIN,
        _THIRD_SHEAR_DOMAIN,
        _INTERVAL_DOMAIN,
        _STRENGTH_DOMAIN,
    ),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    7,
    _predict_wiener_acceleration_block,
)


class PredictRandomJerk(NamedTuple):
    """Result of `predict_random_jerk`."""

    diagonal_1: Real
    """D1, variance of the position, velocity and acceleration known, m^2."""
    diagonal_2: Real
    """D2, variance of the velocity, acceleration known, m^2/s^2."""
    diagonal_3: Real
    """D3, variance of the acceleration, m^2/s^4."""
    first_shear: Real
    """A, s."""
    second_shear: Real
    """B, s."""
    third_shear: Real
    """C, s."""


def predict_random_jerk(
    diagonal_1: ArrayLike,
    diagonal_2: ArrayLike,
    diagonal_3: ArrayLike,
    first_shear: ArrayLike,
    second_shear: ArrayLike,
    third_shear: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
) -> PredictRandomJerk:
    """Factors of the covariance after an interval, random jerk.

        F P F' + Q = U D U' with the factors that come, F = [1, t, t^2/2; 0, 1, t; 0, 0, 1],
        Q = [q t^6/36, q t^5/12, q t^4/6; q t^5/12, q t^4/4, q t^3/2; q t^4/6, q t^3/2, q t^2],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2; a number at
        least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_3: d3, variance of the acceleration, m^2/s^4; a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e5.
    first_shear: a, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    second_shear: b, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    third_shear: c, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    interval: t, time since the covariance given, s; a number at least 1e-10 and at most 1e10, in
        float32 at least 1e-2 and at most 1e2.
    strength: q, variance of the jerk, which is constant over the interval; 0 or a number at least
        1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 14.51 * 2^-52 (float64), 14.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 1.51 * 2^-52
        (float64), 1.51 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 5.51 * 2^-52 (float64), 5.51 * 2^-23 (float32), proved
        for every input.
    second_shear: b, s. Relative error at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 15.01 * 2^-52 (float64), 15.01 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation recursion-three-states
    """
    return PredictRandomJerk(
        *evaluate(
            _PREDICT_RANDOM_JERK,
            (
                diagonal_1,
                diagonal_2,
                diagonal_3,
                first_shear,
                second_shear,
                third_shear,
                interval,
                strength,
            ),
            out,
        )
    )


def _predict_random_jerk_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        diagonal_1,
        diagonal_2,
        diagonal_3,
        first_shear,
        second_shear,
        third_shear,
        interval,
        strength,
    ) = given
    diagonal_1_, diagonal_2_, diagonal_3_, first_shear_, second_shear_, third_shear_ = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    t8 = np.square(interval, w0)
    t9 = np.multiply(strength, t8, w0)
    np.add(diagonal_3, t9, diagonal_3_)
    t11 = np.divide(t9, diagonal_3_, diagonal_2_)
    t13 = np.multiply(interval, 0.5, w1)
    t14 = np.add(t13, second_shear, w2)
    t15 = np.multiply(diagonal_3, t11, w3)
    t16 = np.multiply(third_shear, 0.5, diagonal_2_)
    t17 = np.multiply(first_shear, 0.5, w4)
    t18 = np.add(t17, t16, w5)
    t20 = np.divide(interval, 6.0, diagonal_1_)
    t21 = np.add(t20, t18, diagonal_2_)
    t22 = np.multiply(second_shear, third_shear, w6)
    t23 = np.multiply(interval, t21, diagonal_2_)
    t24 = np.add(t23, t22, w7)
    t25 = np.square(t14, diagonal_2_)
    t26 = np.multiply(t15, t25, diagonal_2_)
    np.add(diagonal_2, t26, diagonal_2_)
    t28 = np.add(interval, second_shear, w8)
    t29 = np.multiply(t28, diagonal_3, w8)
    t30 = np.multiply(t9, t13, w9)
    t31 = np.add(t29, t30, w8)
    t32 = np.multiply(second_shear, first_shear, w9)
    t33 = np.multiply(interval, t14, w2)
    t34 = np.add(t33, t32, w2)
    t35 = np.multiply(t34, diagonal_3, w2)
    t36 = np.multiply(interval, t20, diagonal_1_)
    t37 = np.multiply(t9, t36, diagonal_1_)
    t38 = np.add(t35, t37, w2)
    t39 = np.square(t24, w7)
    t40 = np.multiply(t15, t39, w3)
    t41 = np.multiply(diagonal_2, t40, w3)
    t42 = np.divide(t41, diagonal_2_, first_shear_)
    t45 = np.divide(interval, 3.0, second_shear_)
    t46 = np.add(t45, t18, second_shear_)
    t47 = np.multiply(interval, t46, second_shear_)
    t49 = np.multiply(second_shear, 0.25, w3)
    t51 = np.divide(interval, 24.0, third_shear_)
    t52 = np.add(t51, t49, third_shear_)
    t53 = np.multiply(first_shear, 0.25, w3)
    t54 = np.divide(second_shear, 3.0, w5)
    t55 = np.add(t54, t53, w5)
    t56 = np.multiply(second_shear, t55, w5)
    t57 = np.multiply(interval, t52, third_shear_)
    t58 = np.add(t57, t56, third_shear_)
    t59 = np.multiply(second_shear, t17, w4)
    t60 = np.multiply(second_shear, t59, w4)
    t61 = np.multiply(interval, t58, third_shear_)
    t62 = np.add(t61, t60, third_shear_)
    t63 = np.multiply(interval, t62, third_shear_)
    t64 = np.add(first_shear, third_shear, w3)
    t65 = np.add(t13, t64, w1)
    t66 = np.multiply(interval, t65, w1)
    t67 = np.add(t66, t22, w1)
    t68 = np.multiply(t67, diagonal_3, w1)
    t69 = np.multiply(t47, t9, second_shear_)
    t70 = np.add(t68, t69, w1)
    t71 = np.multiply(diagonal_3, t63, third_shear_)
    t72 = np.multiply(diagonal_2, t70, w1)
    t73 = np.multiply(t9, t71, w0)
    t74 = np.add(t72, t73, w1)
    t77 = np.multiply(diagonal_2_, t31, w0)
    np.add(diagonal_1, t42, diagonal_1_)
    np.divide(t38, t31, first_shear_)
    np.divide(t31, diagonal_3_, second_shear_)
    np.divide(t74, t77, third_shear_)


_PREDICT_RANDOM_JERK = Signature(
    "predict_random_jerk",
    (
        _DIAGONAL_1_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _DIAGONAL_3_DOMAIN,
        _FIRST_SHEAR_DOMAIN,
        _SECOND_SHEAR_DOMAIN,
        _THIRD_SHEAR_DOMAIN,
        _INTERVAL_DOMAIN,
        _STRENGTH_DOMAIN,
    ),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    10,
    _predict_random_jerk_block,
)


class PredictContinuousWhiteJerk(NamedTuple):
    """Result of `predict_continuous_white_jerk`."""

    diagonal_1: Real
    """D1, variance of the position, velocity and acceleration known, m^2."""
    diagonal_2: Real
    """D2, variance of the velocity, acceleration known, m^2/s^2."""
    diagonal_3: Real
    """D3, variance of the acceleration, m^2/s^4."""
    first_shear: Real
    """A, s."""
    second_shear: Real
    """B, s."""
    third_shear: Real
    """C, s."""


def predict_continuous_white_jerk(
    diagonal_1: ArrayLike,
    diagonal_2: ArrayLike,
    diagonal_3: ArrayLike,
    first_shear: ArrayLike,
    second_shear: ArrayLike,
    third_shear: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
) -> PredictContinuousWhiteJerk:
    """Factors of the covariance after an interval, continuous white jerk.

        F P F' + Q = U D U' with the factors that come, F = [1, t, t^2/2; 0, 1, t; 0, 0, 1],
        Q = [q t^5/20, q t^4/8, q t^3/6; q t^4/8, q t^3/3, q t^2/2; q t^3/6, q t^2/2, q t],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2; a number at
        least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-4 and at most 1e5.
    diagonal_3: d3, variance of the acceleration, m^2/s^4; a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e5.
    first_shear: a, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    second_shear: b, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    third_shear: c, s; 0 or a number at least 1e-15 and at most 1e15, in float32 at least 1e-3 and
        at most 1e3.
    interval: t, time since the covariance given, s; a number at least 1e-10 and at most 1e10, in
        float32 at least 1e-2 and at most 1e2.
    strength: q, two-sided power density of the jerk; 0 or a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e4.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 16.51 * 2^-52 (float64), 16.50 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 1.01 * 2^-52
        (float64), 1.01 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved
        for every input.
    second_shear: b, s. Relative error at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 14.01 * 2^-52 (float64), 14.01 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation recursion-three-states
    """
    return PredictContinuousWhiteJerk(
        *evaluate(
            _PREDICT_CONTINUOUS_WHITE_JERK,
            (
                diagonal_1,
                diagonal_2,
                diagonal_3,
                first_shear,
                second_shear,
                third_shear,
                interval,
                strength,
            ),
            out,
        )
    )


def _predict_continuous_white_jerk_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        diagonal_1,
        diagonal_2,
        diagonal_3,
        first_shear,
        second_shear,
        third_shear,
        interval,
        strength,
    ) = given
    diagonal_1_, diagonal_2_, diagonal_3_, first_shear_, second_shear_, third_shear_ = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    t8 = np.multiply(strength, interval, w0)
    np.add(diagonal_3, t8, diagonal_3_)
    t10 = np.divide(t8, diagonal_3_, diagonal_2_)
    t12 = np.multiply(interval, 0.5, w1)
    t13 = np.add(t12, second_shear, w2)
    t14 = np.multiply(diagonal_3, t10, w3)
    t15 = np.multiply(third_shear, 0.5, diagonal_2_)
    t16 = np.multiply(first_shear, 0.5, w4)
    t17 = np.add(t16, t15, w5)
    t19 = np.divide(interval, 6.0, diagonal_1_)
    t20 = np.add(t19, t17, diagonal_2_)
    t21 = np.multiply(second_shear, third_shear, w6)
    t22 = np.multiply(interval, t20, diagonal_2_)
    t23 = np.add(t22, t21, w7)
    t25 = np.divide(interval, 12.0, first_shear_)
    t26 = np.multiply(interval, t25, diagonal_2_)
    t27 = np.multiply(t8, t26, w8)
    t28 = np.square(t13, diagonal_2_)
    t29 = np.multiply(t14, t28, diagonal_2_)
    t30 = np.add(diagonal_2, t27, w9)
    np.add(t30, t29, diagonal_2_)
    t32 = np.add(interval, second_shear, w9)
    t33 = np.multiply(t32, diagonal_3, w9)
    t34 = np.multiply(t8, t12, w10)
    t35 = np.add(t33, t34, w9)
    t36 = np.multiply(second_shear, first_shear, w10)
    t37 = np.multiply(interval, t13, w2)
    t38 = np.add(t37, t36, w2)
    t39 = np.multiply(t38, diagonal_3, w2)
    t40 = np.multiply(interval, t19, diagonal_1_)
    t41 = np.multiply(t8, t40, diagonal_1_)
    t42 = np.add(t39, t41, w2)
    t43 = np.square(t23, w7)
    t44 = np.multiply(t14, t43, w7)
    t45 = np.multiply(diagonal_2, t44, w7)
    t46 = np.add(first_shear, third_shear, diagonal_1_)
    t47 = np.add(t12, t46, w1)
    t48 = np.multiply(second_shear, 0.5, diagonal_1_)
    t49 = np.add(t25, t48, first_shear_)
    t50 = np.multiply(interval, t49, first_shear_)
    t51 = np.add(t50, t36, first_shear_)
    t52 = np.square(t47, w10)
    t53 = np.multiply(t27, t52, w10)
    t54 = np.multiply(diagonal_2, t53, w10)
    t55 = np.square(t51, first_shear_)
    t56 = np.multiply(t14, t55, w3)
    t57 = np.multiply(t27, t56, w8)
    t59 = np.divide(interval, 720.0, second_shear_)
    t60 = np.multiply(interval, t59, second_shear_)
    t61 = np.multiply(interval, t60, second_shear_)
    t62 = np.multiply(interval, t61, second_shear_)
    t63 = np.multiply(t8, t62, second_shear_)
    t64 = np.add(t45, t54, w7)
    t65 = np.add(t64, t57, w7)
    t66 = np.divide(t65, diagonal_2_, third_shear_)
    t67 = np.add(diagonal_1, t63, second_shear_)
    t70 = np.divide(interval, 3.0, w3)
    t71 = np.add(t70, t17, w3)
    t72 = np.multiply(interval, t71, w3)
    t74 = np.multiply(second_shear, 5.0, w5)
    t76 = np.divide(t74, 24.0, w5)
    t77 = np.divide(interval, 24.0, w7)
    t78 = np.add(t77, t76, w7)
    t79 = np.divide(first_shear, 6.0, w5)
    t80 = np.divide(second_shear, 3.0, w8)
    t81 = np.add(t80, t79, w8)
    t82 = np.multiply(second_shear, t81, w8)
    t83 = np.multiply(interval, t78, w7)
    t84 = np.add(t83, t82, w7)
    t85 = np.multiply(second_shear, t16, w4)
    t86 = np.multiply(second_shear, t85, w4)
    t87 = np.multiply(interval, t84, w7)
    t88 = np.add(t87, t86, w7)
    t89 = np.multiply(interval, t88, w7)
    t91 = np.divide(interval, 144.0, w4)
    t92 = np.multiply(interval, t91, w4)
    t93 = np.multiply(interval, t92, w4)
    t94 = np.multiply(interval, t93, w4)
    t95 = np.multiply(interval, t47, w1)
    t96 = np.add(t95, t21, w1)
    t97 = np.multiply(t96, diagonal_3, w1)
    t98 = np.multiply(t72, t8, w3)
    t99 = np.add(t97, t98, w1)
    t100 = np.multiply(diagonal_3, t89, w7)
    t101 = np.multiply(t8, t94, w4)
    t102 = np.add(t100, t101, w7)
    t103 = np.multiply(diagonal_2, t99, w1)
    t104 = np.multiply(t8, t102, w0)
    t105 = np.add(t103, t104, w1)
    t108 = np.multiply(diagonal_2_, t35, w0)
    np.add(t67, t66, diagonal_1_)
    np.divide(t42, t35, first_shear_)
    np.divide(t35, diagonal_3_, second_shear_)
    np.divide(t105, t108, third_shear_)


_PREDICT_CONTINUOUS_WHITE_JERK = Signature(
    "predict_continuous_white_jerk",
    (
        _DIAGONAL_1_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _DIAGONAL_3_DOMAIN,
        _FIRST_SHEAR_DOMAIN,
        _SECOND_SHEAR_DOMAIN,
        _THIRD_SHEAR_DOMAIN,
        _INTERVAL_DOMAIN,
        _STRENGTH_DOMAIN,
    ),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    11,
    _predict_continuous_white_jerk_block,
)
