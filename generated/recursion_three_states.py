# Made by: gainproof generate recursion-three-states
# From: gainproof derive recursion-three-states, SymPy 1.14.0
"""Kalman recursion of position, velocity and acceleration, any intervals."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, copyto, divide, multiply, square

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
    "Covariance",
    "Gains",
    "PredictAccelerationIncrements",
    "PredictContinuousWhiteJerk",
    "PredictRandomJerk",
    "PredictWienerAcceleration",
    "StartAccelerationIncrements",
    "StartContinuousWhiteJerk",
    "StartRandomJerk",
    "StartWienerAcceleration",
    "Update",
    "covariance",
    "gains",
    "predict_acceleration_increments",
    "predict_continuous_white_jerk",
    "predict_random_jerk",
    "predict_wiener_acceleration",
    "start_acceleration_increments",
    "start_continuous_white_jerk",
    "start_random_jerk",
    "start_wiener_acceleration",
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
_FIRST_INTERVAL_DOMAIN = Domain(
    "first_interval",
    "a number at least 1e-10 and at most 1e10, in float32 at least 1e-2 and at most 1e2",
    (1e-10, 10000000000.0),
    (0.009999999776482582, 100.0),
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
    workers: int = 1,
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(diagonal_1) is float
        and type(diagonal_2) is float
        and type(diagonal_3) is float
        and type(first_shear) is float
        and type(second_shear) is float
        and type(third_shear) is float
        and 1e-30 <= diagonal_1 <= 1e30
        and 1e-30 <= diagonal_2 <= 1e30
        and 1e-30 <= diagonal_3 <= 1e30
        and (1e-15 <= first_shear <= 1000000000000000.0 or first_shear == 0)
        and (1e-15 <= second_shear <= 1000000000000000.0 or second_shear == 0)
        and (1e-15 <= third_shear <= 1000000000000000.0 or third_shear == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                Covariance,
                _covariance_of_numbers(
                    diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Covariance(
        *evaluate(
            _COVARIANCE,
            (diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear),
            out,
            workers,
        )
    )


def _covariance_of_numbers(
    diagonal_1: float,
    diagonal_2: float,
    diagonal_3: float,
    first_shear: float,
    second_shear: float,
    third_shear: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t6 = first_shear + third_shear
    t7 = t6 * diagonal_2
    t8 = second_shear * diagonal_3
    t9 = first_shear * t8
    t15 = (diagonal_1 + (t6 * t7)) + ((first_shear * second_shear) * t9)
    t17 = t7 + (second_shear * t9)
    t18 = diagonal_2 + (second_shear * t8)
    return (t15, t17, t9, t18, t8, diagonal_3)


def _covariance_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear = given
    covariance_11, covariance_12, covariance_13, covariance_22, covariance_23, covariance_33 = out
    w0, w1, w2, w3, w4 = work
    t6 = add(first_shear, third_shear, w0)
    t7 = multiply(t6, diagonal_2, w1)
    multiply(second_shear, diagonal_3, covariance_23)
    multiply(first_shear, covariance_23, covariance_13)
    t10 = multiply(second_shear, covariance_23, w2)
    t11 = multiply(t6, t7, w0)
    t12 = add(diagonal_1, t11, w0)
    t13 = multiply(first_shear, second_shear, w3)
    t14 = multiply(t13, covariance_13, w3)
    t16 = multiply(second_shear, covariance_13, w4)
    add(t12, t14, covariance_11)
    add(t7, t16, covariance_12)
    add(diagonal_2, t10, covariance_22)
    copyto(covariance_33, diagonal_3)


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
    numbers=_covariance_of_numbers,
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
    workers: int = 1,
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(diagonal_1) is float
        and type(diagonal_2) is float
        and type(diagonal_3) is float
        and type(first_shear) is float
        and type(second_shear) is float
        and type(third_shear) is float
        and type(measurement_variance) is float
        and 1e-30 <= diagonal_1 <= 1e30
        and 1e-30 <= diagonal_2 <= 1e30
        and 1e-30 <= diagonal_3 <= 1e30
        and (1e-15 <= first_shear <= 1000000000000000.0 or first_shear == 0)
        and (1e-15 <= second_shear <= 1000000000000000.0 or second_shear == 0)
        and (1e-15 <= third_shear <= 1000000000000000.0 or third_shear == 0)
        and 1e-30 <= measurement_variance <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                Gains,
                _gains_of_numbers(
                    diagonal_1,
                    diagonal_2,
                    diagonal_3,
                    first_shear,
                    second_shear,
                    third_shear,
                    measurement_variance,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
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
            workers,
        )
    )


def _gains_of_numbers(
    diagonal_1: float,
    diagonal_2: float,
    diagonal_3: float,
    first_shear: float,
    second_shear: float,
    third_shear: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t7 = first_shear + third_shear
    t8 = t7 * diagonal_2
    t10 = t7 * t8
    t11 = (diagonal_1 + measurement_variance) + t10
    t13 = first_shear * (second_shear * diagonal_3)
    t15 = (first_shear * second_shear) * t13
    t16 = t11 + t15
    t19 = ((diagonal_1 + t10) + t15) / t16
    t22 = (t8 + (second_shear * t13)) / t16
    t23 = t13 / t16
    return (t19, t22, t23, t16)


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
    t7 = add(first_shear, third_shear, w0)
    t8 = multiply(t7, diagonal_2, w1)
    t9 = add(diagonal_1, measurement_variance, w2)
    t10 = multiply(t7, t8, w0)
    t11 = add(t9, t10, w2)
    t12 = multiply(second_shear, diagonal_3, w3)
    t13 = multiply(first_shear, t12, w3)
    t14 = multiply(first_shear, second_shear, w4)
    t15 = multiply(t14, t13, w4)
    add(t11, t15, innovation_variance)
    t17 = add(diagonal_1, t10, w0)
    t18 = add(t17, t15, w0)
    t20 = multiply(second_shear, t13, w2)
    t21 = add(t8, t20, w1)
    divide(t18, innovation_variance, position_gain)
    divide(t21, innovation_variance, velocity_gain)
    divide(t13, innovation_variance, acceleration_gain)


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
    numbers=_gains_of_numbers,
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
    workers: int = 1,
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(diagonal_1) is float
        and type(diagonal_2) is float
        and type(diagonal_3) is float
        and type(first_shear) is float
        and type(second_shear) is float
        and type(third_shear) is float
        and type(measurement_variance) is float
        and 1e-30 <= diagonal_1 <= 1e30
        and 1e-30 <= diagonal_2 <= 1e30
        and 1e-30 <= diagonal_3 <= 1e30
        and (1e-15 <= first_shear <= 1000000000000000.0 or first_shear == 0)
        and (1e-15 <= second_shear <= 1000000000000000.0 or second_shear == 0)
        and (1e-15 <= third_shear <= 1000000000000000.0 or third_shear == 0)
        and 1e-30 <= measurement_variance <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                Update,
                _update_of_numbers(
                    diagonal_1,
                    diagonal_2,
                    diagonal_3,
                    first_shear,
                    second_shear,
                    third_shear,
                    measurement_variance,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
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
            workers,
        )
    )


def _update_of_numbers(
    diagonal_1: float,
    diagonal_2: float,
    diagonal_3: float,
    first_shear: float,
    second_shear: float,
    third_shear: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t7 = first_shear + third_shear
    t8 = t7 * diagonal_2
    t9 = diagonal_1 + measurement_variance
    t11 = t9 + (t7 * t8)
    t13 = t9 + (third_shear * t8)
    t15 = first_shear * (second_shear * diagonal_3)
    t18 = t11 + ((first_shear * second_shear) * t15)
    t19 = measurement_variance / t9
    t20 = diagonal_1 * t19
    t22 = diagonal_2 * (t9 / t11)
    t24 = diagonal_3 * (t11 / t18)
    t26 = first_shear * (measurement_variance / t13)
    t28 = second_shear * (t13 / t11)
    t31 = third_shear * (t19 * (t11 / t13))
    return (t20, t22, t24, t26, t28, t31)


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
    t7 = add(first_shear, third_shear, w0)
    t8 = multiply(t7, diagonal_2, w1)
    t9 = add(diagonal_1, measurement_variance, w2)
    t10 = multiply(t7, t8, w0)
    t11 = add(t9, t10, w0)
    t12 = multiply(third_shear, t8, w1)
    t13 = add(t9, t12, w1)
    t14 = multiply(second_shear, diagonal_3, w3)
    t15 = multiply(first_shear, t14, w3)
    t16 = multiply(first_shear, second_shear, w4)
    t17 = multiply(t16, t15, w4)
    t18 = add(t11, t17, w4)
    t19 = divide(measurement_variance, t9, diagonal_1_)
    t21 = divide(t9, t11, diagonal_2_)
    t23 = divide(t11, t18, diagonal_3_)
    t25 = divide(measurement_variance, t13, first_shear_)
    t27 = divide(t13, t11, second_shear_)
    t29 = divide(t11, t13, third_shear_)
    t30 = multiply(t19, t29, third_shear_)
    multiply(diagonal_1, t19, diagonal_1_)
    multiply(diagonal_2, t21, diagonal_2_)
    multiply(diagonal_3, t23, diagonal_3_)
    multiply(first_shear, t25, first_shear_)
    multiply(second_shear, t27, second_shear_)
    multiply(third_shear, t30, third_shear_)


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
    numbers=_update_of_numbers,
)


class StartAccelerationIncrements(NamedTuple):
    """Result of `start_acceleration_increments`."""

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


def start_acceleration_increments(
    first_interval: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StartAccelerationIncrements:
    """Factors of the covariance after the first three positions, acceleration increments.

        r W W' + A Q(t) A' + B Q(s) B' = U D U' with the factors that come; the state is
        W (z2, z1, z0)', the parabola through three positions, the newest first,
        W = [1, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2]^-1,
        A = W [0, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2],
        B = W [0, 0, 0; 0, 0, 0; 1, -s, s^2/2],
        Q(t) = [0, 0, 0; 0, 0, 0; 0, 0, q],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    first_interval: s, time between the first two positions, s; a number at least 1e-10 and at most
        1e10, in float32 at least 1e-2 and at most 1e2.
    interval: t, time between the last two positions, s; a number at least 1e-10 and at most 1e10,
        in float32 at least 1e-2 and at most 1e2.
    strength: q, variance of the acceleration increment, the same for an interval of any length; 0
        or a number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-30 and at
        most 1e30, in float32 at least 1e-4 and at most 1e5.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 12.01 * 2^-52 (float64), 12.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        10.51 * 2^-52 (float64), 10.51 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 8.51 * 2^-52
        (float64), 8.51 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 7.01 * 2^-52 (float64), 7.01 * 2^-23 (float32), proved
        for every input.
    second_shear: b, s. Relative error at most 9.01 * 2^-52 (float64), 9.00 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 19.51 * 2^-52 (float64), 19.50 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(first_interval) is float
        and type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-10 <= first_interval <= 10000000000.0
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and 1e-30 <= measurement_variance <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StartAccelerationIncrements,
                _start_acceleration_increments_of_numbers(
                    first_interval, interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StartAccelerationIncrements(
        *evaluate(
            _START_ACCELERATION_INCREMENTS,
            (first_interval, interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _start_acceleration_increments_of_numbers(
    first_interval: float,
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = first_interval * first_interval
    t7 = first_interval * (first_interval * 2.0)
    t8 = first_interval * t7
    t9 = interval * t4
    t13 = (interval * (t9 + t8)) + (first_interval * t8)
    t17 = first_interval * 8.0
    t18 = interval * 8.0
    t20 = first_interval * t17
    t21 = interval * (t18 + t17)
    t24 = strength * (interval * (interval * t13))
    t25 = t24 + (measurement_variance * (t21 + t20))
    t26 = first_interval * t4
    t29 = interval * (interval * (first_interval * t26))
    t30 = interval * t29
    t36 = first_interval * (first_interval * 20.0)
    t37 = interval * (t18 + (first_interval * 12.0))
    t39 = first_interval * t20
    t42 = measurement_variance * ((interval * (t37 + t36)) + t39)
    t44 = (strength * t30) + t42
    t47 = measurement_variance * (interval * (t9 + t26))
    t48 = interval * t30
    t50 = first_interval * 16.0
    t54 = first_interval * (first_interval * 40.0)
    t55 = interval * (t18 + t50)
    t59 = first_interval * (first_interval * 32.0)
    t62 = (interval * (t55 + t54)) + (first_interval * t59)
    t64 = first_interval * (first_interval * t50)
    t67 = (interval * t62) + (first_interval * t64)
    t70 = (strength * t48) + (measurement_variance * t67)
    t73 = measurement_variance * (measurement_variance * 48.0)
    t75 = (strength * t70) + t73
    t79 = first_interval * (first_interval * 4.0)
    t82 = measurement_variance * (measurement_variance * (t21 + t79))
    t83 = strength * (measurement_variance * t29)
    t88 = first_interval * (first_interval * 24.0)
    t93 = interval * ((interval * (t55 + t88)) + t64)
    t95 = measurement_variance * (t93 + (first_interval * t39))
    t97 = strength * (measurement_variance * t48)
    t100 = measurement_variance * (measurement_variance * 16.0)
    t102 = strength * (t97 + (measurement_variance * t95))
    t106 = (first_interval * interval) * (first_interval + interval)
    t107 = (t102 + (measurement_variance * t100)) / t75
    t109 = (t75 / t25) * 0.25
    t111 = t25 / (t106 * t106)
    t113 = (t47 / t44) * 4.0
    t115 = (t44 / t25) * 0.5
    t119 = ((t25 / t75) * ((t83 + t82) / t44)) * 4.0
    return (t107, t109, t111, t113, t115, t119)


def _start_acceleration_increments_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 8.0,
    n2: float = 12.0,
    n3: float = 20.0,
    n4: float = 16.0,
    n5: float = 40.0,
    n6: float = 32.0,
    n7: float = 48.0,
    n8: float = 4.0,
    n9: float = 24.0,
    n10: float = 0.25,
    n11: float = 0.5,
) -> None:
    first_interval, interval, strength, measurement_variance = given
    diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    t4 = square(first_interval, w0)
    t6 = multiply(first_interval, n0, w1)
    t7 = multiply(first_interval, t6, w1)
    t8 = multiply(first_interval, t7, w1)
    t9 = multiply(interval, t4, w2)
    t10 = add(t9, t8, w3)
    t11 = multiply(first_interval, t8, w1)
    t12 = multiply(interval, t10, w3)
    t13 = add(t12, t11, w3)
    t14 = multiply(interval, t13, w3)
    t15 = multiply(interval, t14, w3)
    t17 = multiply(first_interval, n1, w1)
    t18 = multiply(interval, n1, w4)
    t19 = add(t18, t17, w5)
    t20 = multiply(first_interval, t17, w1)
    t21 = multiply(interval, t19, w5)
    t22 = add(t21, t20, w6)
    t23 = multiply(measurement_variance, t22, w6)
    t24 = multiply(strength, t15, w3)
    t25 = add(t24, t23, w3)
    t26 = multiply(first_interval, t4, w0)
    t27 = multiply(first_interval, t26, w6)
    t28 = multiply(interval, t27, w6)
    t29 = multiply(interval, t28, w6)
    t30 = multiply(interval, t29, w7)
    t32 = multiply(first_interval, n2, w8)
    t33 = add(t18, t32, w8)
    t35 = multiply(first_interval, n3, w9)
    t36 = multiply(first_interval, t35, w9)
    t37 = multiply(interval, t33, w8)
    t38 = add(t37, t36, w8)
    t39 = multiply(first_interval, t20, w1)
    t40 = multiply(interval, t38, w8)
    t41 = add(t40, t39, w8)
    t42 = multiply(measurement_variance, t41, w8)
    t43 = multiply(strength, t30, w9)
    t44 = add(t43, t42, w9)
    t45 = add(t9, t26, w2)
    t46 = multiply(interval, t45, w2)
    t47 = multiply(measurement_variance, t46, w2)
    t48 = multiply(interval, t30, w7)
    t50 = multiply(first_interval, n4, w0)
    t51 = add(t18, t50, w4)
    t53 = multiply(first_interval, n5, w8)
    t54 = multiply(first_interval, t53, w8)
    t55 = multiply(interval, t51, w4)
    t56 = add(t55, t54, w8)
    t58 = multiply(first_interval, n6, w10)
    t59 = multiply(first_interval, t58, w10)
    t60 = multiply(first_interval, t59, w10)
    t61 = multiply(interval, t56, w8)
    t62 = add(t61, t60, w8)
    t63 = multiply(first_interval, t50, w0)
    t64 = multiply(first_interval, t63, w0)
    t65 = multiply(first_interval, t64, w10)
    t66 = multiply(interval, t62, w8)
    t67 = add(t66, t65, w8)
    t68 = multiply(measurement_variance, t67, w8)
    t69 = multiply(strength, t48, w10)
    t70 = add(t69, t68, w10)
    t72 = multiply(measurement_variance, n7, w8)
    t73 = multiply(measurement_variance, t72, w8)
    t74 = multiply(strength, t70, w10)
    t75 = add(t74, t73, w10)
    t76 = multiply(measurement_variance, t29, w6)
    t78 = multiply(first_interval, n8, w8)
    t79 = multiply(first_interval, t78, w8)
    t80 = add(t21, t79, w5)
    t81 = multiply(measurement_variance, t80, w5)
    t82 = multiply(measurement_variance, t81, w5)
    t83 = multiply(strength, t76, w6)
    t84 = add(t83, t82, w6)
    t85 = multiply(measurement_variance, t48, w7)
    t87 = multiply(first_interval, n9, w5)
    t88 = multiply(first_interval, t87, w5)
    t89 = add(t55, t88, w4)
    t90 = multiply(interval, t89, w4)
    t91 = add(t90, t64, w4)
    t92 = multiply(first_interval, t39, w1)
    t93 = multiply(interval, t91, w4)
    t94 = add(t93, t92, w4)
    t95 = multiply(measurement_variance, t94, w4)
    t96 = multiply(measurement_variance, t95, w4)
    t97 = multiply(strength, t85, w7)
    t98 = add(t97, t96, w7)
    t99 = multiply(measurement_variance, n4, w4)
    t100 = multiply(measurement_variance, t99, w4)
    t101 = multiply(measurement_variance, t100, w4)
    t102 = multiply(strength, t98, w7)
    t103 = add(t102, t101, w7)
    t104 = multiply(first_interval, interval, w4)
    t105 = add(first_interval, interval, w1)
    t106 = multiply(t104, t105, w4)
    t110 = square(t106, w4)
    t117 = divide(t84, t44, w6)
    divide(t103, t75, diagonal_1)
    divide(t25, t110, diagonal_3)
    t108 = divide(t75, t25, diagonal_2)
    multiply(t108, n10, diagonal_2)
    t112 = divide(t47, t44, first_shear)
    multiply(t112, n8, first_shear)
    t114 = divide(t44, t25, second_shear)
    multiply(t114, n11, second_shear)
    t116 = divide(t25, t75, third_shear)
    t118 = multiply(t116, t117, third_shear)
    multiply(t118, n8, third_shear)


_START_ACCELERATION_INCREMENTS = Signature(
    "start_acceleration_increments",
    (_FIRST_INTERVAL_DOMAIN, _INTERVAL_DOMAIN, _STRENGTH_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    11,
    _start_acceleration_increments_block,
    numbers=_start_acceleration_increments_of_numbers,
)


class StartWienerAcceleration(NamedTuple):
    """Result of `start_wiener_acceleration`."""

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


def start_wiener_acceleration(
    first_interval: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StartWienerAcceleration:
    """Factors of the covariance after the first three positions, wiener acceleration.

        r W W' + A Q(t) A' + B Q(s) B' = U D U' with the factors that come; the state is
        W (z2, z1, z0)', the parabola through three positions, the newest first,
        W = [1, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2]^-1,
        A = W [0, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2],
        B = W [0, 0, 0; 0, 0, 0; 1, -s, s^2/2],
        Q(t) = [q t^4/4, q t^3/2, q t^2/2; q t^3/2, q t^2, q t; q t^2/2, q t, q],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    first_interval: s, time between the first two positions, s; a number at least 1e-10 and at most
        1e10, in float32 at least 1e-2 and at most 1e2.
    interval: t, time between the last two positions, s; a number at least 1e-10 and at most 1e10,
        in float32 at least 1e-2 and at most 1e2.
    strength: q, variance of the acceleration that is added for the interval and stays; 0 or a
        number at least 1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-30 and at
        most 1e30, in float32 at least 1e-4 and at most 1e5.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 7.01 * 2^-52 (float64), 6.99 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        7.01 * 2^-52 (float64), 7.00 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 7.51 * 2^-52
        (float64), 7.51 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 7.01 * 2^-52 (float64), 7.01 * 2^-23 (float32), proved
        for every input.
    second_shear: b, s. Relative error at most 8.01 * 2^-52 (float64), 8.01 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 16.01 * 2^-52 (float64), 16.01 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(first_interval) is float
        and type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-10 <= first_interval <= 10000000000.0
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and 1e-30 <= measurement_variance <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StartWienerAcceleration,
                _start_wiener_acceleration_of_numbers(
                    first_interval, interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StartWienerAcceleration(
        *evaluate(
            _START_WIENER_ACCELERATION,
            (first_interval, interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _start_wiener_acceleration_of_numbers(
    first_interval: float,
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = first_interval * first_interval
    t5 = first_interval * t4
    t6 = first_interval * t5
    t8 = interval * (interval * t6)
    t10 = first_interval * 8.0
    t11 = interval * 8.0
    t13 = first_interval * t10
    t14 = interval * (t11 + t10)
    t18 = (strength * t8) + (measurement_variance * (t14 + t13))
    t25 = first_interval * (first_interval * 20.0)
    t26 = interval * (t11 + (first_interval * 12.0))
    t30 = (interval * (t26 + t25)) + (first_interval * t13)
    t33 = (strength * (interval * t8)) + (measurement_variance * t30)
    t37 = measurement_variance * (interval * ((interval * t4) + t5))
    t38 = measurement_variance * t6
    t41 = measurement_variance * (measurement_variance * 6.0)
    t43 = (strength * t38) + t41
    t47 = first_interval * (first_interval * 4.0)
    t50 = measurement_variance * (measurement_variance * (t14 + t47))
    t51 = strength * (measurement_variance * t8)
    t55 = measurement_variance * (measurement_variance * 4.0)
    t57 = strength * (measurement_variance * t38)
    t61 = (first_interval * interval) * (first_interval + interval)
    t62 = (t57 + (measurement_variance * t55)) / t43
    t64 = t62 * 0.5
    t66 = (t43 / t18) * 2.0
    t68 = t18 / (t61 * t61)
    t70 = (t37 / t33) * 4.0
    t72 = (t33 / t18) * 0.5
    t76 = ((t18 / t43) * ((t51 + t50) / t33)) * 0.5
    return (t64, t66, t68, t70, t72, t76)


def _start_wiener_acceleration_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 12.0,
    n2: float = 20.0,
    n3: float = 6.0,
    n4: float = 4.0,
    n5: float = 0.5,
    n6: float = 2.0,
) -> None:
    first_interval, interval, strength, measurement_variance = given
    diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    t4 = square(first_interval, w0)
    t5 = multiply(first_interval, t4, w1)
    t6 = multiply(first_interval, t5, w2)
    t7 = multiply(interval, t6, w3)
    t8 = multiply(interval, t7, w3)
    t10 = multiply(first_interval, n0, w4)
    t11 = multiply(interval, n0, w5)
    t12 = add(t11, t10, w6)
    t13 = multiply(first_interval, t10, w4)
    t14 = multiply(interval, t12, w6)
    t15 = add(t14, t13, w7)
    t16 = multiply(measurement_variance, t15, w7)
    t17 = multiply(strength, t8, w8)
    t18 = add(t17, t16, w8)
    t19 = multiply(interval, t8, w7)
    t21 = multiply(first_interval, n1, w9)
    t22 = add(t11, t21, w5)
    t24 = multiply(first_interval, n2, w9)
    t25 = multiply(first_interval, t24, w9)
    t26 = multiply(interval, t22, w5)
    t27 = add(t26, t25, w5)
    t28 = multiply(first_interval, t13, w4)
    t29 = multiply(interval, t27, w5)
    t30 = add(t29, t28, w5)
    t31 = multiply(measurement_variance, t30, w5)
    t32 = multiply(strength, t19, w7)
    t33 = add(t32, t31, w7)
    t34 = multiply(interval, t4, w0)
    t35 = add(t34, t5, w0)
    t36 = multiply(interval, t35, w0)
    t37 = multiply(measurement_variance, t36, w0)
    t38 = multiply(measurement_variance, t6, w2)
    t40 = multiply(measurement_variance, n3, w1)
    t41 = multiply(measurement_variance, t40, w1)
    t42 = multiply(strength, t38, w4)
    t43 = add(t42, t41, w4)
    t44 = multiply(measurement_variance, t8, w3)
    t46 = multiply(first_interval, n4, w1)
    t47 = multiply(first_interval, t46, w1)
    t48 = add(t14, t47, w6)
    t49 = multiply(measurement_variance, t48, w6)
    t50 = multiply(measurement_variance, t49, w6)
    t51 = multiply(strength, t44, w3)
    t52 = add(t51, t50, w3)
    t53 = multiply(measurement_variance, t38, w2)
    t54 = multiply(measurement_variance, n4, w1)
    t55 = multiply(measurement_variance, t54, w1)
    t56 = multiply(measurement_variance, t55, w1)
    t57 = multiply(strength, t53, w2)
    t58 = add(t57, t56, w2)
    t59 = multiply(first_interval, interval, w1)
    t60 = add(first_interval, interval, w5)
    t61 = multiply(t59, t60, w1)
    t62 = divide(t58, t43, diagonal_1)
    t65 = divide(t43, t18, diagonal_2)
    t67 = square(t61, w1)
    t69 = divide(t37, t33, first_shear)
    t71 = divide(t33, t18, second_shear)
    t73 = divide(t18, t43, diagonal_3)
    t74 = divide(t52, t33, third_shear)
    t75 = multiply(t73, t74, third_shear)
    multiply(t62, n5, diagonal_1)
    multiply(t65, n6, diagonal_2)
    divide(t18, t67, diagonal_3)
    multiply(t69, n4, first_shear)
    multiply(t71, n5, second_shear)
    multiply(t75, n5, third_shear)


_START_WIENER_ACCELERATION = Signature(
    "start_wiener_acceleration",
    (_FIRST_INTERVAL_DOMAIN, _INTERVAL_DOMAIN, _STRENGTH_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    10,
    _start_wiener_acceleration_block,
    numbers=_start_wiener_acceleration_of_numbers,
)


class StartRandomJerk(NamedTuple):
    """Result of `start_random_jerk`."""

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


def start_random_jerk(
    first_interval: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StartRandomJerk:
    """Factors of the covariance after the first three positions, random jerk.

        r W W' + A Q(t) A' + B Q(s) B' = U D U' with the factors that come; the state is
        W (z2, z1, z0)', the parabola through three positions, the newest first,
        W = [1, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2]^-1,
        A = W [0, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2],
        B = W [0, 0, 0; 0, 0, 0; 1, -s, s^2/2],
        Q(t) = [q t^6/36, q t^5/12, q t^4/6; q t^5/12, q t^4/4, q t^3/2; q t^4/6, q t^3/2, q t^2],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    first_interval: s, time between the first two positions, s; a number at least 1e-10 and at most
        1e10, in float32 at least 1e-2 and at most 1e2.
    interval: t, time between the last two positions, s; a number at least 1e-10 and at most 1e10,
        in float32 at least 1e-2 and at most 1e2.
    strength: q, variance of the jerk, which is constant over the interval; 0 or a number at least
        1e-30 and at most 1e30, in float32 at least 1e-4 and at most 1e4.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-30 and at
        most 1e30, in float32 at least 1e-4 and at most 1e5.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 16.01 * 2^-52 (float64), 16.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        15.00 * 2^-52 (float64), 14.98 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 11.00 * 2^-52
        (float64), 10.98 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 10.50 * 2^-52 (float64), 10.48 * 2^-23 (float32),
        proved for every input.
    second_shear: b, s. Relative error at most 14.00 * 2^-52 (float64), 13.96 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 30.00 * 2^-52 (float64), 29.95 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(first_interval) is float
        and type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-10 <= first_interval <= 10000000000.0
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and 1e-30 <= measurement_variance <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StartRandomJerk,
                _start_random_jerk_of_numbers(
                    first_interval, interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StartRandomJerk(
        *evaluate(
            _START_RANDOM_JERK,
            (first_interval, interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _start_random_jerk_of_numbers(
    first_interval: float,
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t6 = first_interval * (first_interval * 4.0)
    t9 = first_interval * (first_interval * 12.0)
    t12 = (interval * t6) + (first_interval * t9)
    t15 = first_interval * (first_interval * 9.0)
    t16 = first_interval * t15
    t19 = (interval * t12) + (first_interval * t16)
    t21 = first_interval * first_interval
    t22 = first_interval * t21
    t24 = first_interval * (first_interval * t22)
    t25 = first_interval * t24
    t28 = interval * ((interval * (interval * t19)) + t25)
    t31 = first_interval * 72.0
    t32 = interval * 72.0
    t34 = first_interval * t31
    t35 = interval * (t32 + t31)
    t39 = (strength * (interval * t28)) + (measurement_variance * (t35 + t34))
    t42 = first_interval * (first_interval * 2.0)
    t45 = first_interval * (first_interval * 7.0)
    t48 = (interval * t42) + (first_interval * t45)
    t51 = first_interval * (first_interval * 6.0)
    t53 = first_interval * (first_interval * t51)
    t57 = interval * (interval * ((interval * t48) + t53))
    t61 = interval * (interval * (interval * (t57 + t25)))
    t67 = first_interval * (first_interval * 180.0)
    t68 = interval * (t32 + (first_interval * 108.0))
    t70 = first_interval * t34
    t73 = measurement_variance * ((interval * (t68 + t67)) + t70)
    t75 = (strength * t61) + t73
    t79 = measurement_variance * (interval * ((interval * t21) + t22))
    t82 = interval * (interval * (interval * t25))
    t85 = interval * (interval * (interval * t82))
    t91 = first_interval * (first_interval * 864.0)
    t92 = interval * (t32 + (first_interval * 216.0))
    t96 = first_interval * (first_interval * 1296.0)
    t99 = (interval * (t92 + t91)) + (first_interval * t96)
    t102 = first_interval * (first_interval * 648.0)
    t103 = first_interval * t102
    t106 = (interval * t99) + (first_interval * t103)
    t109 = first_interval * (first_interval * t70)
    t112 = (interval * (interval * t106)) + (first_interval * t109)
    t115 = (strength * t85) + (measurement_variance * t112)
    t118 = measurement_variance * (measurement_variance * 3888.0)
    t120 = (strength * t115) + t118
    t123 = first_interval * (first_interval * 3.0)
    t127 = (interval * ((interval * t123) + t16)) + t53
    t131 = interval * ((interval * (interval * t127)) + t25)
    t133 = measurement_variance * (interval * t131)
    t136 = first_interval * (first_interval * 36.0)
    t139 = measurement_variance * (measurement_variance * (t35 + t136))
    t145 = first_interval * (first_interval * 540.0)
    t151 = first_interval * (first_interval * 324.0)
    t153 = first_interval * (first_interval * t151)
    t154 = interval * ((interval * (t92 + t145)) + t103)
    t158 = first_interval * (first_interval * t136)
    t160 = first_interval * (first_interval * t158)
    t161 = interval * (interval * (t154 + t153))
    t164 = measurement_variance * (measurement_variance * (t161 + t160))
    t165 = strength * (measurement_variance * t85)
    t168 = measurement_variance * (measurement_variance * 1296.0)
    t171 = (strength * (t165 + t164)) + (measurement_variance * t168)
    t174 = (first_interval * interval) * (first_interval + interval)
    t187 = (t39 / t120) * (((strength * t133) + t139) / t75)
    t175 = t171 / t120
    t177 = (t120 / t39) / 36.0
    t180 = (t39 / 9.0) / (t174 * t174)
    t182 = (t79 / t75) * 36.0
    t184 = (t75 / t39) * 0.5
    t188 = t187 * 36.0
    return (t175, t177, t180, t182, t184, t188)


def _start_random_jerk_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 4.0,
    n1: float = 12.0,
    n2: float = 9.0,
    n3: float = 72.0,
    n4: float = 2.0,
    n5: float = 7.0,
    n6: float = 6.0,
    n7: float = 108.0,
    n8: float = 180.0,
    n9: float = 216.0,
    n10: float = 864.0,
    n11: float = 1296.0,
    n12: float = 648.0,
    n13: float = 3888.0,
    n14: float = 3.0,
    n15: float = 36.0,
    n16: float = 540.0,
    n17: float = 324.0,
    n18: float = 0.5,
) -> None:
    first_interval, interval, strength, measurement_variance = given
    diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12 = work
    t5 = multiply(first_interval, n0, w0)
    t6 = multiply(first_interval, t5, w0)
    t8 = multiply(first_interval, n1, w1)
    t9 = multiply(first_interval, t8, w1)
    t10 = multiply(first_interval, t9, w1)
    t11 = multiply(interval, t6, w0)
    t12 = add(t11, t10, w0)
    t14 = multiply(first_interval, n2, w1)
    t15 = multiply(first_interval, t14, w1)
    t16 = multiply(first_interval, t15, w1)
    t17 = multiply(first_interval, t16, w2)
    t18 = multiply(interval, t12, w0)
    t19 = add(t18, t17, w0)
    t20 = multiply(interval, t19, w0)
    t21 = square(first_interval, w2)
    t22 = multiply(first_interval, t21, w3)
    t23 = multiply(first_interval, t22, w4)
    t24 = multiply(first_interval, t23, w4)
    t25 = multiply(first_interval, t24, w4)
    t26 = multiply(interval, t20, w0)
    t27 = add(t26, t25, w0)
    t28 = multiply(interval, t27, w0)
    t29 = multiply(interval, t28, w0)
    t31 = multiply(first_interval, n3, w5)
    t32 = multiply(interval, n3, w6)
    t33 = add(t32, t31, w7)
    t34 = multiply(first_interval, t31, w5)
    t35 = multiply(interval, t33, w7)
    t36 = add(t35, t34, w8)
    t37 = multiply(measurement_variance, t36, w8)
    t38 = multiply(strength, t29, w0)
    t39 = add(t38, t37, w0)
    t41 = multiply(first_interval, n4, w8)
    t42 = multiply(first_interval, t41, w8)
    t44 = multiply(first_interval, n5, w9)
    t45 = multiply(first_interval, t44, w9)
    t46 = multiply(first_interval, t45, w9)
    t47 = multiply(interval, t42, w8)
    t48 = add(t47, t46, w8)
    t50 = multiply(first_interval, n6, w9)
    t51 = multiply(first_interval, t50, w9)
    t52 = multiply(first_interval, t51, w9)
    t53 = multiply(first_interval, t52, w9)
    t54 = multiply(interval, t48, w8)
    t55 = add(t54, t53, w8)
    t56 = multiply(interval, t55, w8)
    t57 = multiply(interval, t56, w8)
    t58 = add(t57, t25, w8)
    t59 = multiply(interval, t58, w8)
    t60 = multiply(interval, t59, w8)
    t61 = multiply(interval, t60, w8)
    t63 = multiply(first_interval, n7, w10)
    t64 = add(t32, t63, w10)
    t66 = multiply(first_interval, n8, w11)
    t67 = multiply(first_interval, t66, w11)
    t68 = multiply(interval, t64, w10)
    t69 = add(t68, t67, w10)
    t70 = multiply(first_interval, t34, w5)
    t71 = multiply(interval, t69, w10)
    t72 = add(t71, t70, w10)
    t73 = multiply(measurement_variance, t72, w10)
    t74 = multiply(strength, t61, w8)
    t75 = add(t74, t73, w8)
    t76 = multiply(interval, t21, w2)
    t77 = add(t76, t22, w2)
    t78 = multiply(interval, t77, w2)
    t79 = multiply(measurement_variance, t78, w2)
    t80 = multiply(interval, t25, w3)
    t81 = multiply(interval, t80, w3)
    t82 = multiply(interval, t81, w3)
    t83 = multiply(interval, t82, w3)
    t84 = multiply(interval, t83, w3)
    t85 = multiply(interval, t84, w3)
    t87 = multiply(first_interval, n9, w10)
    t88 = add(t32, t87, w6)
    t90 = multiply(first_interval, n10, w10)
    t91 = multiply(first_interval, t90, w10)
    t92 = multiply(interval, t88, w6)
    t93 = add(t92, t91, w10)
    t95 = multiply(first_interval, n11, w11)
    t96 = multiply(first_interval, t95, w11)
    t97 = multiply(first_interval, t96, w11)
    t98 = multiply(interval, t93, w10)
    t99 = add(t98, t97, w10)
    t101 = multiply(first_interval, n12, w11)
    t102 = multiply(first_interval, t101, w11)
    t103 = multiply(first_interval, t102, w11)
    t104 = multiply(first_interval, t103, w12)
    t105 = multiply(interval, t99, w10)
    t106 = add(t105, t104, w10)
    t107 = multiply(interval, t106, w10)
    t108 = multiply(first_interval, t70, w5)
    t109 = multiply(first_interval, t108, w5)
    t110 = multiply(first_interval, t109, w5)
    t111 = multiply(interval, t107, w10)
    t112 = add(t111, t110, w10)
    t113 = multiply(measurement_variance, t112, w10)
    t114 = multiply(strength, t85, w5)
    t115 = add(t114, t113, w5)
    t117 = multiply(measurement_variance, n13, w10)
    t118 = multiply(measurement_variance, t117, w10)
    t119 = multiply(strength, t115, w5)
    t120 = add(t119, t118, w5)
    t122 = multiply(first_interval, n14, w10)
    t123 = multiply(first_interval, t122, w10)
    t124 = multiply(interval, t123, w10)
    t125 = add(t124, t16, w10)
    t126 = multiply(interval, t125, w10)
    t127 = add(t126, t53, w10)
    t128 = multiply(interval, t127, w10)
    t129 = multiply(interval, t128, w10)
    t130 = add(t129, t25, w10)
    t131 = multiply(interval, t130, w10)
    t132 = multiply(interval, t131, w10)
    t133 = multiply(measurement_variance, t132, w10)
    t135 = multiply(first_interval, n15, w1)
    t136 = multiply(first_interval, t135, w1)
    t137 = add(t35, t136, w7)
    t138 = multiply(measurement_variance, t137, w7)
    t139 = multiply(measurement_variance, t138, w7)
    t140 = multiply(strength, t133, w10)
    t141 = add(t140, t139, w10)
    t142 = multiply(measurement_variance, t85, w3)
    t144 = multiply(first_interval, n16, w4)
    t145 = multiply(first_interval, t144, w4)
    t146 = add(t92, t145, w6)
    t147 = multiply(interval, t146, w6)
    t148 = add(t147, t103, w6)
    t150 = multiply(first_interval, n17, w4)
    t151 = multiply(first_interval, t150, w4)
    t152 = multiply(first_interval, t151, w4)
    t153 = multiply(first_interval, t152, w4)
    t154 = multiply(interval, t148, w6)
    t155 = add(t154, t153, w6)
    t156 = multiply(interval, t155, w6)
    t157 = multiply(first_interval, t136, w1)
    t158 = multiply(first_interval, t157, w1)
    t159 = multiply(first_interval, t158, w1)
    t160 = multiply(first_interval, t159, w1)
    t161 = multiply(interval, t156, w6)
    t162 = add(t161, t160, w6)
    t163 = multiply(measurement_variance, t162, w6)
    t164 = multiply(measurement_variance, t163, w6)
    t165 = multiply(strength, t142, w3)
    t166 = add(t165, t164, w3)
    t167 = multiply(measurement_variance, n11, w1)
    t168 = multiply(measurement_variance, t167, w1)
    t169 = multiply(measurement_variance, t168, w1)
    t170 = multiply(strength, t166, w3)
    t171 = add(t170, t169, w3)
    t172 = multiply(first_interval, interval, w1)
    t173 = add(first_interval, interval, w4)
    t174 = multiply(t172, t173, w1)
    t176 = divide(t120, t39, diagonal_2)
    t178 = divide(t39, n2, diagonal_3)
    t179 = square(t174, w1)
    t181 = divide(t79, t75, first_shear)
    t183 = divide(t75, t39, second_shear)
    t185 = divide(t39, t120, diagonal_1)
    t186 = divide(t141, t75, third_shear)
    t187 = multiply(t185, t186, third_shear)
    divide(t171, t120, diagonal_1)
    divide(t176, n15, diagonal_2)
    divide(t178, t179, diagonal_3)
    multiply(t181, n15, first_shear)
    multiply(t183, n18, second_shear)
    multiply(t187, n15, third_shear)


_START_RANDOM_JERK = Signature(
    "start_random_jerk",
    (_FIRST_INTERVAL_DOMAIN, _INTERVAL_DOMAIN, _STRENGTH_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    13,
    _start_random_jerk_block,
    numbers=_start_random_jerk_of_numbers,
)


class StartContinuousWhiteJerk(NamedTuple):
    """Result of `start_continuous_white_jerk`."""

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


def start_continuous_white_jerk(
    first_interval: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StartContinuousWhiteJerk:
    """Factors of the covariance after the first three positions, continuous white jerk.

        r W W' + A Q(t) A' + B Q(s) B' = U D U' with the factors that come; the state is
        W (z2, z1, z0)', the parabola through three positions, the newest first,
        W = [1, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2]^-1,
        A = W [0, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2],
        B = W [0, 0, 0; 0, 0, 0; 1, -s, s^2/2],
        Q(t) = [q t^5/20, q t^4/8, q t^3/6; q t^4/8, q t^3/3, q t^2/2; q t^3/6, q t^2/2, q t],
        P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]
          = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]

    first_interval: s, time between the first two positions, s; a number at least 1e-10 and at most
        1e10, in float32 at least 1e-2 and at most 1e2.
    interval: t, time between the last two positions, s; a number at least 1e-10 and at most 1e10,
        in float32 at least 1e-2 and at most 1e2.
    strength: q, two-sided power density of the jerk; 0 or a number at least 1e-30 and at most 1e30,
        in float32 at least 1e-4 and at most 1e4.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-30 and at
        most 1e30, in float32 at least 1e-4 and at most 1e5.

    diagonal_1: d1, variance of the position, velocity and acceleration known, m^2. Relative error
        at most 18.01 * 2^-52 (float64), 18.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, acceleration known, m^2/s^2. Relative error at most
        15.50 * 2^-52 (float64), 15.46 * 2^-23 (float32), proved for every input.
    diagonal_3: d3, variance of the acceleration, m^2/s^4. Relative error at most 10.50 * 2^-52
        (float64), 10.48 * 2^-23 (float32), proved for every input.
    first_shear: a, s. Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32),
        proved for every input.
    second_shear: b, s. Relative error at most 13.00 * 2^-52 (float64), 12.97 * 2^-23 (float32),
        proved for every input.
    third_shear: c, s. Relative error at most 29.50 * 2^-52 (float64), 31.43 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(first_interval) is float
        and type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-10 <= first_interval <= 10000000000.0
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and 1e-30 <= measurement_variance <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StartContinuousWhiteJerk,
                _start_continuous_white_jerk_of_numbers(
                    first_interval, interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StartContinuousWhiteJerk(
        *evaluate(
            _START_CONTINUOUS_WHITE_JERK,
            (first_interval, interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _start_continuous_white_jerk_of_numbers(
    first_interval: float,
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t6 = first_interval * (first_interval * 8.0)
    t9 = first_interval * (first_interval * 20.0)
    t10 = first_interval * t9
    t15 = first_interval * (first_interval * 15.0)
    t17 = first_interval * (first_interval * t15)
    t19 = (interval * ((interval * t6) + t10)) + t17
    t22 = first_interval * (first_interval * 3.0)
    t24 = first_interval * (first_interval * t22)
    t27 = (interval * t19) + (first_interval * t24)
    t31 = first_interval * 120.0
    t34 = first_interval * t31
    t35 = interval * ((interval * 120.0) + t31)
    t38 = strength * (interval * (interval * t27))
    t39 = t38 + (measurement_variance * (t35 + t34))
    t42 = first_interval * (first_interval * 7.0)
    t45 = first_interval * (first_interval * 21.0)
    t48 = (interval * t42) + (first_interval * t45)
    t49 = first_interval * t10
    t54 = first_interval * (first_interval * 6.0)
    t56 = first_interval * (first_interval * t54)
    t57 = first_interval * t56
    t59 = (interval * ((interval * t48) + t49)) + t57
    t62 = interval * (interval * (interval * t59))
    t66 = interval * 240.0
    t70 = first_interval * (first_interval * 600.0)
    t71 = interval * (t66 + (first_interval * 360.0))
    t73 = first_interval * 240.0
    t75 = first_interval * (first_interval * t73)
    t78 = measurement_variance * ((interval * (t71 + t70)) + t75)
    t80 = (strength * t62) + t78
    t81 = first_interval * first_interval
    t84 = (interval * t81) + (first_interval * t81)
    t86 = measurement_variance * (interval * t84)
    t89 = first_interval * (first_interval * 60.0)
    t92 = (interval * t15) + (first_interval * t89)
    t95 = first_interval * (first_interval * 80.0)
    t97 = first_interval * (first_interval * t95)
    t102 = first_interval * (first_interval * 36.0)
    t104 = first_interval * (first_interval * t102)
    t107 = (interval * ((interval * t92) + t97)) + (first_interval * t104)
    t110 = interval * (interval * (interval * t107))
    t112 = interval * (interval * t110)
    t114 = first_interval * 3600.0
    t120 = first_interval * (first_interval * 12000.0)
    t121 = interval * ((interval * 1440.0) + t114)
    t125 = first_interval * (first_interval * 14400.0)
    t128 = (interval * (t121 + t120)) + (first_interval * t125)
    t131 = first_interval * (first_interval * 7200.0)
    t132 = first_interval * t131
    t135 = (interval * t128) + (first_interval * t132)
    t137 = first_interval * (first_interval * 1440.0)
    t139 = first_interval * (first_interval * t137)
    t142 = (interval * t135) + (first_interval * t139)
    t145 = (strength * t112) + (measurement_variance * t142)
    t148 = measurement_variance * (measurement_variance * 43200.0)
    t150 = (strength * t145) + t148
    t153 = first_interval * (first_interval * 10.0)
    t156 = first_interval * (first_interval * 25.0)
    t159 = (interval * t153) + (first_interval * t156)
    t163 = (interval * ((interval * t159) + t49)) + t57
    t166 = measurement_variance * (interval * (interval * t163))
    t170 = measurement_variance * ((interval * (t66 + t73)) + t34)
    t173 = (strength * t166) + (measurement_variance * t170)
    t179 = first_interval * (first_interval * t114)
    t181 = interval * ((interval * (t121 + t131)) + t132)
    t185 = first_interval * (first_interval * 720.0)
    t187 = first_interval * (first_interval * t185)
    t189 = interval * (t181 + (first_interval * t179))
    t191 = measurement_variance * (t189 + (first_interval * t187))
    t193 = strength * (measurement_variance * t112)
    t196 = measurement_variance * (measurement_variance * 14400.0)
    t198 = strength * (t193 + (measurement_variance * t191))
    t202 = (first_interval * interval) * (first_interval + interval)
    t203 = (t198 + (measurement_variance * t196)) / t150
    t205 = (t150 / t39) / 240.0
    t208 = (t39 / 15.0) / (t202 * t202)
    t210 = (t86 / t80) * 120.0
    t213 = (t80 / t39) * 0.25
    t217 = ((t39 / t150) * (t173 / t80)) * 240.0
    return (t203, t205, t208, t210, t213, t217)


def _start_continuous_white_jerk_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 20.0,
    n2: float = 15.0,
    n3: float = 3.0,
    n4: float = 120.0,
    n5: float = 7.0,
    n6: float = 21.0,
    n7: float = 6.0,
    n8: float = 360.0,
    n9: float = 240.0,
    n10: float = 600.0,
    n11: float = 60.0,
    n12: float = 80.0,
    n13: float = 36.0,
    n14: float = 3600.0,
    n15: float = 1440.0,
    n16: float = 12000.0,
    n17: float = 14400.0,
    n18: float = 7200.0,
    n19: float = 43200.0,
    n20: float = 10.0,
    n21: float = 25.0,
    n22: float = 720.0,
    n23: float = 0.25,
) -> None:
    first_interval, interval, strength, measurement_variance = given
    diagonal_1, diagonal_2, diagonal_3, first_shear, second_shear, third_shear = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15 = work
    t5 = multiply(first_interval, n0, w0)
    t6 = multiply(first_interval, t5, w0)
    t8 = multiply(first_interval, n1, w1)
    t9 = multiply(first_interval, t8, w1)
    t10 = multiply(first_interval, t9, w1)
    t11 = multiply(interval, t6, w0)
    t12 = add(t11, t10, w0)
    t14 = multiply(first_interval, n2, w2)
    t15 = multiply(first_interval, t14, w2)
    t16 = multiply(first_interval, t15, w3)
    t17 = multiply(first_interval, t16, w3)
    t18 = multiply(interval, t12, w0)
    t19 = add(t18, t17, w0)
    t21 = multiply(first_interval, n3, w3)
    t22 = multiply(first_interval, t21, w3)
    t23 = multiply(first_interval, t22, w3)
    t24 = multiply(first_interval, t23, w3)
    t25 = multiply(first_interval, t24, w3)
    t26 = multiply(interval, t19, w0)
    t27 = add(t26, t25, w0)
    t28 = multiply(interval, t27, w0)
    t29 = multiply(interval, t28, w0)
    t31 = multiply(first_interval, n4, w3)
    t32 = multiply(interval, n4, w4)
    t33 = add(t32, t31, w4)
    t34 = multiply(first_interval, t31, w3)
    t35 = multiply(interval, t33, w4)
    t36 = add(t35, t34, w4)
    t37 = multiply(measurement_variance, t36, w4)
    t38 = multiply(strength, t29, w0)
    t39 = add(t38, t37, w0)
    t41 = multiply(first_interval, n5, w4)
    t42 = multiply(first_interval, t41, w4)
    t44 = multiply(first_interval, n6, w5)
    t45 = multiply(first_interval, t44, w5)
    t46 = multiply(first_interval, t45, w5)
    t47 = multiply(interval, t42, w4)
    t48 = add(t47, t46, w4)
    t49 = multiply(first_interval, t10, w1)
    t50 = multiply(interval, t48, w4)
    t51 = add(t50, t49, w4)
    t53 = multiply(first_interval, n7, w5)
    t54 = multiply(first_interval, t53, w5)
    t55 = multiply(first_interval, t54, w5)
    t56 = multiply(first_interval, t55, w5)
    t57 = multiply(first_interval, t56, w5)
    t58 = multiply(interval, t51, w4)
    t59 = add(t58, t57, w4)
    t60 = multiply(interval, t59, w4)
    t61 = multiply(interval, t60, w4)
    t62 = multiply(interval, t61, w4)
    t64 = multiply(first_interval, n8, w6)
    t66 = multiply(interval, n9, w7)
    t67 = add(t66, t64, w6)
    t69 = multiply(first_interval, n10, w8)
    t70 = multiply(first_interval, t69, w8)
    t71 = multiply(interval, t67, w6)
    t72 = add(t71, t70, w6)
    t73 = multiply(first_interval, n9, w8)
    t74 = multiply(first_interval, t73, w9)
    t75 = multiply(first_interval, t74, w9)
    t76 = multiply(interval, t72, w6)
    t77 = add(t76, t75, w6)
    t78 = multiply(measurement_variance, t77, w6)
    t79 = multiply(strength, t62, w4)
    t80 = add(t79, t78, w4)
    t81 = square(first_interval, w6)
    t82 = multiply(first_interval, t81, w9)
    t83 = multiply(interval, t81, w6)
    t84 = add(t83, t82, w6)
    t85 = multiply(interval, t84, w6)
    t86 = multiply(measurement_variance, t85, w6)
    t88 = multiply(first_interval, n11, w9)
    t89 = multiply(first_interval, t88, w9)
    t90 = multiply(first_interval, t89, w9)
    t91 = multiply(interval, t15, w2)
    t92 = add(t91, t90, w2)
    t94 = multiply(first_interval, n12, w9)
    t95 = multiply(first_interval, t94, w9)
    t96 = multiply(first_interval, t95, w9)
    t97 = multiply(first_interval, t96, w9)
    t98 = multiply(interval, t92, w2)
    t99 = add(t98, t97, w2)
    t101 = multiply(first_interval, n13, w9)
    t102 = multiply(first_interval, t101, w9)
    t103 = multiply(first_interval, t102, w9)
    t104 = multiply(first_interval, t103, w9)
    t105 = multiply(first_interval, t104, w9)
    t106 = multiply(interval, t99, w2)
    t107 = add(t106, t105, w2)
    t108 = multiply(interval, t107, w2)
    t109 = multiply(interval, t108, w2)
    t110 = multiply(interval, t109, w2)
    t111 = multiply(interval, t110, w2)
    t112 = multiply(interval, t111, w2)
    t114 = multiply(first_interval, n14, w9)
    t116 = multiply(interval, n15, w10)
    t117 = add(t116, t114, w10)
    t119 = multiply(first_interval, n16, w11)
    t120 = multiply(first_interval, t119, w11)
    t121 = multiply(interval, t117, w10)
    t122 = add(t121, t120, w11)
    t124 = multiply(first_interval, n17, w12)
    t125 = multiply(first_interval, t124, w12)
    t126 = multiply(first_interval, t125, w12)
    t127 = multiply(interval, t122, w11)
    t128 = add(t127, t126, w11)
    t130 = multiply(first_interval, n18, w12)
    t131 = multiply(first_interval, t130, w12)
    t132 = multiply(first_interval, t131, w13)
    t133 = multiply(first_interval, t132, w14)
    t134 = multiply(interval, t128, w11)
    t135 = add(t134, t133, w11)
    t136 = multiply(first_interval, n15, w14)
    t137 = multiply(first_interval, t136, w14)
    t138 = multiply(first_interval, t137, w14)
    t139 = multiply(first_interval, t138, w14)
    t140 = multiply(first_interval, t139, w14)
    t141 = multiply(interval, t135, w11)
    t142 = add(t141, t140, w11)
    t143 = multiply(measurement_variance, t142, w11)
    t144 = multiply(strength, t112, w14)
    t145 = add(t144, t143, w14)
    t147 = multiply(measurement_variance, n19, w11)
    t148 = multiply(measurement_variance, t147, w11)
    t149 = multiply(strength, t145, w14)
    t150 = add(t149, t148, w14)
    t152 = multiply(first_interval, n20, w11)
    t153 = multiply(first_interval, t152, w11)
    t155 = multiply(first_interval, n21, w15)
    t156 = multiply(first_interval, t155, w15)
    t157 = multiply(first_interval, t156, w15)
    t158 = multiply(interval, t153, w11)
    t159 = add(t158, t157, w11)
    t160 = multiply(interval, t159, w11)
    t161 = add(t160, t49, w11)
    t162 = multiply(interval, t161, w11)
    t163 = add(t162, t57, w11)
    t164 = multiply(interval, t163, w11)
    t165 = multiply(interval, t164, w11)
    t166 = multiply(measurement_variance, t165, w11)
    t167 = add(t66, t73, w7)
    t168 = multiply(interval, t167, w7)
    t169 = add(t168, t34, w7)
    t170 = multiply(measurement_variance, t169, w7)
    t171 = multiply(measurement_variance, t170, w7)
    t172 = multiply(strength, t166, w11)
    t173 = add(t172, t171, w11)
    t174 = multiply(measurement_variance, t112, w2)
    t175 = add(t121, t131, w10)
    t176 = multiply(interval, t175, w10)
    t177 = add(t176, t132, w10)
    t178 = multiply(first_interval, t114, w9)
    t179 = multiply(first_interval, t178, w9)
    t180 = multiply(first_interval, t179, w9)
    t181 = multiply(interval, t177, w10)
    t182 = add(t181, t180, w10)
    t184 = multiply(first_interval, n22, w1)
    t185 = multiply(first_interval, t184, w1)
    t186 = multiply(first_interval, t185, w1)
    t187 = multiply(first_interval, t186, w1)
    t188 = multiply(first_interval, t187, w1)
    t189 = multiply(interval, t182, w10)
    t190 = add(t189, t188, w10)
    t191 = multiply(measurement_variance, t190, w10)
    t192 = multiply(measurement_variance, t191, w10)
    t193 = multiply(strength, t174, w2)
    t194 = add(t193, t192, w2)
    t195 = multiply(measurement_variance, n17, w1)
    t196 = multiply(measurement_variance, t195, w1)
    t197 = multiply(measurement_variance, t196, w1)
    t198 = multiply(strength, t194, w2)
    t199 = add(t198, t197, w2)
    t200 = multiply(first_interval, interval, w1)
    t201 = add(first_interval, interval, w3)
    t202 = multiply(t200, t201, w1)
    t204 = divide(t150, t39, diagonal_2)
    t206 = divide(t39, n2, diagonal_3)
    t207 = square(t202, w1)
    t209 = divide(t86, t80, first_shear)
    t211 = divide(t80, t39, second_shear)
    t214 = divide(t39, t150, diagonal_1)
    t215 = divide(t173, t80, third_shear)
    t216 = multiply(t214, t215, third_shear)
    divide(t199, t150, diagonal_1)
    divide(t204, n9, diagonal_2)
    divide(t206, t207, diagonal_3)
    multiply(t209, n4, first_shear)
    multiply(t211, n23, second_shear)
    multiply(t216, n9, third_shear)


_START_CONTINUOUS_WHITE_JERK = Signature(
    "start_continuous_white_jerk",
    (_FIRST_INTERVAL_DOMAIN, _INTERVAL_DOMAIN, _STRENGTH_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "diagonal_2", "diagonal_3", "first_shear", "second_shear", "third_shear"),
    16,
    _start_continuous_white_jerk_block,
    numbers=_start_continuous_white_jerk_of_numbers,
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
    workers: int = 1,
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(diagonal_1) is float
        and type(diagonal_2) is float
        and type(diagonal_3) is float
        and type(first_shear) is float
        and type(second_shear) is float
        and type(third_shear) is float
        and type(interval) is float
        and type(strength) is float
        and 1e-30 <= diagonal_1 <= 1e30
        and 1e-30 <= diagonal_2 <= 1e30
        and 1e-30 <= diagonal_3 <= 1e30
        and (1e-15 <= first_shear <= 1000000000000000.0 or first_shear == 0)
        and (1e-15 <= second_shear <= 1000000000000000.0 or second_shear == 0)
        and (1e-15 <= third_shear <= 1000000000000000.0 or third_shear == 0)
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictAccelerationIncrements,
                _predict_acceleration_increments_of_numbers(
                    diagonal_1,
                    diagonal_2,
                    diagonal_3,
                    first_shear,
                    second_shear,
                    third_shear,
                    interval,
                    strength,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
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
            workers,
        )
    )


def _predict_acceleration_increments_of_numbers(
    diagonal_1: float,
    diagonal_2: float,
    diagonal_3: float,
    first_shear: float,
    second_shear: float,
    third_shear: float,
    interval: float,
    strength: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t8 = diagonal_3 + strength
    t10 = interval + second_shear
    t11 = diagonal_3 * (strength / t8)
    t14 = interval * 0.5
    t17 = interval * (t14 + (first_shear + third_shear))
    t18 = t17 + (second_shear * third_shear)
    t21 = diagonal_2 + (t11 * (t10 * t10))
    t22 = t10 * diagonal_3
    t26 = (interval * (t14 + second_shear)) + (second_shear * first_shear)
    t31 = (diagonal_2 * (t11 * (t18 * t18))) / t21
    t32 = diagonal_1 + t31
    t35 = (t26 * diagonal_3) / t22
    t36 = t22 / t8
    t38 = (diagonal_2 * (t18 * diagonal_3)) / (t21 * t22)
    return (t32, t21, t8, t35, t36, t38)


def _predict_acceleration_increments_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5
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
    add(diagonal_3, strength, diagonal_3_)
    t9 = divide(strength, diagonal_3_, diagonal_2_)
    t10 = add(interval, second_shear, w0)
    t11 = multiply(diagonal_3, t9, w1)
    t12 = add(first_shear, third_shear, diagonal_2_)
    t14 = multiply(interval, n0, w2)
    t15 = add(t14, t12, diagonal_2_)
    t16 = multiply(second_shear, third_shear, w3)
    t17 = multiply(interval, t15, diagonal_2_)
    t18 = add(t17, t16, w3)
    t19 = square(t10, diagonal_2_)
    t20 = multiply(t11, t19, diagonal_2_)
    add(diagonal_2, t20, diagonal_2_)
    t22 = multiply(t10, diagonal_3, w0)
    t23 = add(t14, second_shear, w2)
    t24 = multiply(second_shear, first_shear, w4)
    t25 = multiply(interval, t23, w2)
    t26 = add(t25, t24, w2)
    t27 = multiply(t26, diagonal_3, w2)
    t28 = square(t18, w4)
    t29 = multiply(t11, t28, w1)
    t30 = multiply(diagonal_2, t29, w1)
    t31 = divide(t30, diagonal_2_, diagonal_1_)
    t33 = multiply(t18, diagonal_3, w3)
    t34 = multiply(diagonal_2, t33, w3)
    t37 = multiply(diagonal_2_, t22, w1)
    add(diagonal_1, t31, diagonal_1_)
    divide(t27, t22, first_shear_)
    divide(t22, diagonal_3_, second_shear_)
    divide(t34, t37, third_shear_)


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
    numbers=_predict_acceleration_increments_of_numbers,
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
    workers: int = 1,
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(diagonal_1) is float
        and type(diagonal_2) is float
        and type(diagonal_3) is float
        and type(first_shear) is float
        and type(second_shear) is float
        and type(third_shear) is float
        and type(interval) is float
        and type(strength) is float
        and 1e-30 <= diagonal_1 <= 1e30
        and 1e-30 <= diagonal_2 <= 1e30
        and 1e-30 <= diagonal_3 <= 1e30
        and (1e-15 <= first_shear <= 1000000000000000.0 or first_shear == 0)
        and (1e-15 <= second_shear <= 1000000000000000.0 or second_shear == 0)
        and (1e-15 <= third_shear <= 1000000000000000.0 or third_shear == 0)
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictWienerAcceleration,
                _predict_wiener_acceleration_of_numbers(
                    diagonal_1,
                    diagonal_2,
                    diagonal_3,
                    first_shear,
                    second_shear,
                    third_shear,
                    interval,
                    strength,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
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
            workers,
        )
    )


def _predict_wiener_acceleration_of_numbers(
    diagonal_1: float,
    diagonal_2: float,
    diagonal_3: float,
    first_shear: float,
    second_shear: float,
    third_shear: float,
    interval: float,
    strength: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t8 = diagonal_3 + strength
    t10 = diagonal_3 * (strength / t8)
    t11 = second_shear * third_shear
    t14 = diagonal_2 + (t10 * (second_shear * second_shear))
    t16 = (interval + second_shear) * diagonal_3
    t18 = t16 + (strength * interval)
    t20 = interval * 0.5
    t22 = second_shear * first_shear
    t24 = (interval * (t20 + second_shear)) + t22
    t28 = (t24 * diagonal_3) + (strength * (interval * t20))
    t32 = (diagonal_2 * (t10 * (t11 * t11))) / t14
    t36 = interval * (t20 + (first_shear + third_shear))
    t40 = interval * (second_shear * (second_shear * 0.5))
    t42 = interval * (t40 + (second_shear * t22))
    t46 = ((t36 + t11) * diagonal_3) + (t36 * strength)
    t50 = (diagonal_2 * t46) + (strength * (diagonal_3 * t42))
    t33 = diagonal_1 + t32
    t51 = t28 / t18
    t52 = t18 / t8
    t54 = t50 / (t14 * t18)
    return (t33, t14, t8, t51, t52, t54)


def _predict_wiener_acceleration_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5
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
    add(diagonal_3, strength, diagonal_3_)
    t9 = divide(strength, diagonal_3_, diagonal_2_)
    t10 = multiply(diagonal_3, t9, w0)
    t11 = multiply(second_shear, third_shear, w1)
    t12 = square(second_shear, diagonal_2_)
    t13 = multiply(t10, t12, diagonal_2_)
    add(diagonal_2, t13, diagonal_2_)
    t15 = add(interval, second_shear, w2)
    t16 = multiply(t15, diagonal_3, w2)
    t17 = multiply(strength, interval, w3)
    t18 = add(t16, t17, w2)
    t20 = multiply(interval, n0, w3)
    t21 = add(t20, second_shear, w4)
    t22 = multiply(second_shear, first_shear, w5)
    t23 = multiply(interval, t21, w4)
    t24 = add(t23, t22, w4)
    t25 = multiply(t24, diagonal_3, w4)
    t26 = multiply(interval, t20, w6)
    t27 = multiply(strength, t26, w6)
    t28 = add(t25, t27, w4)
    t29 = square(t11, w6)
    t30 = multiply(t10, t29, w0)
    t31 = multiply(diagonal_2, t30, w0)
    t32 = divide(t31, diagonal_2_, diagonal_1_)
    t34 = add(first_shear, third_shear, w0)
    t35 = add(t20, t34, w3)
    t36 = multiply(interval, t35, w3)
    t37 = multiply(second_shear, n0, w0)
    t38 = multiply(second_shear, t37, w0)
    t39 = multiply(second_shear, t22, w5)
    t40 = multiply(interval, t38, w0)
    t41 = add(t40, t39, w0)
    t42 = multiply(interval, t41, w0)
    t43 = add(t36, t11, w1)
    t44 = multiply(t43, diagonal_3, w1)
    t45 = multiply(t36, strength, w3)
    t46 = add(t44, t45, w1)
    t47 = multiply(diagonal_3, t42, w0)
    t48 = multiply(diagonal_2, t46, w1)
    t49 = multiply(strength, t47, w0)
    t50 = add(t48, t49, w1)
    t53 = multiply(diagonal_2_, t18, w0)
    add(diagonal_1, t32, diagonal_1_)
    divide(t28, t18, first_shear_)
    divide(t18, diagonal_3_, second_shear_)
    divide(t50, t53, third_shear_)


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
    numbers=_predict_wiener_acceleration_of_numbers,
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
    workers: int = 1,
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(diagonal_1) is float
        and type(diagonal_2) is float
        and type(diagonal_3) is float
        and type(first_shear) is float
        and type(second_shear) is float
        and type(third_shear) is float
        and type(interval) is float
        and type(strength) is float
        and 1e-30 <= diagonal_1 <= 1e30
        and 1e-30 <= diagonal_2 <= 1e30
        and 1e-30 <= diagonal_3 <= 1e30
        and (1e-15 <= first_shear <= 1000000000000000.0 or first_shear == 0)
        and (1e-15 <= second_shear <= 1000000000000000.0 or second_shear == 0)
        and (1e-15 <= third_shear <= 1000000000000000.0 or third_shear == 0)
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictRandomJerk,
                _predict_random_jerk_of_numbers(
                    diagonal_1,
                    diagonal_2,
                    diagonal_3,
                    first_shear,
                    second_shear,
                    third_shear,
                    interval,
                    strength,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
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
            workers,
        )
    )


def _predict_random_jerk_of_numbers(
    diagonal_1: float,
    diagonal_2: float,
    diagonal_3: float,
    first_shear: float,
    second_shear: float,
    third_shear: float,
    interval: float,
    strength: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t9 = strength * (interval * interval)
    t10 = diagonal_3 + t9
    t13 = interval * 0.5
    t14 = t13 + second_shear
    t15 = diagonal_3 * (t9 / t10)
    t17 = first_shear * 0.5
    t18 = t17 + (third_shear * 0.5)
    t20 = interval / 6.0
    t22 = second_shear * third_shear
    t24 = (interval * (t20 + t18)) + t22
    t27 = diagonal_2 + (t15 * (t14 * t14))
    t29 = (interval + second_shear) * diagonal_3
    t31 = t29 + (t9 * t13)
    t34 = (interval * t14) + (second_shear * first_shear)
    t38 = (t34 * diagonal_3) + (t9 * (interval * t20))
    t42 = (diagonal_2 * (t15 * (t24 * t24))) / t27
    t52 = (interval / 24.0) + (second_shear * 0.25)
    t55 = (second_shear / 3.0) + (first_shear * 0.25)
    t58 = (interval * t52) + (second_shear * t55)
    t62 = (interval * t58) + (second_shear * (second_shear * t17))
    t66 = interval * (t13 + (first_shear + third_shear))
    t69 = (interval * ((interval / 3.0) + t18)) * t9
    t72 = diagonal_2 * (((t66 + t22) * diagonal_3) + t69)
    t74 = t72 + (t9 * (diagonal_3 * (interval * t62)))
    t43 = diagonal_1 + t42
    t75 = t38 / t31
    t76 = t31 / t10
    t78 = t74 / (t27 * t31)
    return (t43, t27, t10, t75, t76, t78)


def _predict_random_jerk_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 6.0,
    n2: float = 3.0,
    n3: float = 0.25,
    n4: float = 24.0,
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
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    t8 = square(interval, w0)
    t9 = multiply(strength, t8, w0)
    add(diagonal_3, t9, diagonal_3_)
    t11 = divide(t9, diagonal_3_, diagonal_2_)
    t13 = multiply(interval, n0, w1)
    t14 = add(t13, second_shear, w2)
    t15 = multiply(diagonal_3, t11, w3)
    t16 = multiply(third_shear, n0, diagonal_2_)
    t17 = multiply(first_shear, n0, w4)
    t18 = add(t17, t16, w5)
    t20 = divide(interval, n1, diagonal_1_)
    t21 = add(t20, t18, diagonal_2_)
    t22 = multiply(second_shear, third_shear, w6)
    t23 = multiply(interval, t21, diagonal_2_)
    t24 = add(t23, t22, w7)
    t25 = square(t14, diagonal_2_)
    t26 = multiply(t15, t25, diagonal_2_)
    add(diagonal_2, t26, diagonal_2_)
    t28 = add(interval, second_shear, w8)
    t29 = multiply(t28, diagonal_3, w8)
    t30 = multiply(t9, t13, w9)
    t31 = add(t29, t30, w8)
    t32 = multiply(second_shear, first_shear, w9)
    t33 = multiply(interval, t14, w2)
    t34 = add(t33, t32, w2)
    t35 = multiply(t34, diagonal_3, w2)
    t36 = multiply(interval, t20, diagonal_1_)
    t37 = multiply(t9, t36, diagonal_1_)
    t38 = add(t35, t37, w2)
    t39 = square(t24, w7)
    t40 = multiply(t15, t39, w3)
    t41 = multiply(diagonal_2, t40, w3)
    t42 = divide(t41, diagonal_2_, first_shear_)
    t45 = divide(interval, n2, second_shear_)
    t46 = add(t45, t18, second_shear_)
    t47 = multiply(interval, t46, second_shear_)
    t49 = multiply(second_shear, n3, w3)
    t51 = divide(interval, n4, third_shear_)
    t52 = add(t51, t49, third_shear_)
    t53 = multiply(first_shear, n3, w3)
    t54 = divide(second_shear, n2, w5)
    t55 = add(t54, t53, w5)
    t56 = multiply(second_shear, t55, w5)
    t57 = multiply(interval, t52, third_shear_)
    t58 = add(t57, t56, third_shear_)
    t59 = multiply(second_shear, t17, w4)
    t60 = multiply(second_shear, t59, w4)
    t61 = multiply(interval, t58, third_shear_)
    t62 = add(t61, t60, third_shear_)
    t63 = multiply(interval, t62, third_shear_)
    t64 = add(first_shear, third_shear, w3)
    t65 = add(t13, t64, w1)
    t66 = multiply(interval, t65, w1)
    t67 = add(t66, t22, w1)
    t68 = multiply(t67, diagonal_3, w1)
    t69 = multiply(t47, t9, second_shear_)
    t70 = add(t68, t69, w1)
    t71 = multiply(diagonal_3, t63, third_shear_)
    t72 = multiply(diagonal_2, t70, w1)
    t73 = multiply(t9, t71, w0)
    t74 = add(t72, t73, w1)
    t77 = multiply(diagonal_2_, t31, w0)
    add(diagonal_1, t42, diagonal_1_)
    divide(t38, t31, first_shear_)
    divide(t31, diagonal_3_, second_shear_)
    divide(t74, t77, third_shear_)


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
    numbers=_predict_random_jerk_of_numbers,
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
    workers: int = 1,
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
    third_shear: c, s. Relative error at most 14.01 * 2^-52 (float64), 14.00 * 2^-23 (float32),
        proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-three-states
    """
    if (
        type(diagonal_1) is float
        and type(diagonal_2) is float
        and type(diagonal_3) is float
        and type(first_shear) is float
        and type(second_shear) is float
        and type(third_shear) is float
        and type(interval) is float
        and type(strength) is float
        and 1e-30 <= diagonal_1 <= 1e30
        and 1e-30 <= diagonal_2 <= 1e30
        and 1e-30 <= diagonal_3 <= 1e30
        and (1e-15 <= first_shear <= 1000000000000000.0 or first_shear == 0)
        and (1e-15 <= second_shear <= 1000000000000000.0 or second_shear == 0)
        and (1e-15 <= third_shear <= 1000000000000000.0 or third_shear == 0)
        and 1e-10 <= interval <= 10000000000.0
        and (1e-30 <= strength <= 1e30 or strength == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictContinuousWhiteJerk,
                _predict_continuous_white_jerk_of_numbers(
                    diagonal_1,
                    diagonal_2,
                    diagonal_3,
                    first_shear,
                    second_shear,
                    third_shear,
                    interval,
                    strength,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
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
            workers,
        )
    )


def _predict_continuous_white_jerk_of_numbers(
    diagonal_1: float,
    diagonal_2: float,
    diagonal_3: float,
    first_shear: float,
    second_shear: float,
    third_shear: float,
    interval: float,
    strength: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t8 = strength * interval
    t9 = diagonal_3 + t8
    t12 = interval * 0.5
    t13 = t12 + second_shear
    t14 = diagonal_3 * (t8 / t9)
    t16 = first_shear * 0.5
    t17 = t16 + (third_shear * 0.5)
    t19 = interval / 6.0
    t21 = second_shear * third_shear
    t23 = (interval * (t19 + t17)) + t21
    t25 = interval / 12.0
    t27 = t8 * (interval * t25)
    t31 = (diagonal_2 + t27) + (t14 * (t13 * t13))
    t33 = (interval + second_shear) * diagonal_3
    t35 = t33 + (t8 * t12)
    t36 = second_shear * first_shear
    t39 = ((interval * t13) + t36) * diagonal_3
    t47 = t12 + (first_shear + third_shear)
    t50 = interval * (t25 + (second_shear * 0.5))
    t51 = t50 + t36
    t61 = interval * (interval * (interval / 720.0))
    t64 = (diagonal_2 * (t14 * (t23 * t23))) + (diagonal_2 * (t27 * (t47 * t47)))
    t66 = (t64 + (t27 * (t14 * (t51 * t51)))) / t31
    t78 = (interval / 24.0) + ((second_shear * 5.0) / 24.0)
    t81 = (second_shear / 3.0) + (first_shear / 6.0)
    t84 = (interval * t78) + (second_shear * t81)
    t88 = (interval * t84) + (second_shear * (second_shear * t16))
    t93 = interval * (interval * (interval / 144.0))
    t97 = ((interval * t47) + t21) * diagonal_3
    t98 = (interval * ((interval / 3.0) + t17)) * t8
    t102 = (diagonal_3 * (interval * t88)) + (t8 * (interval * t93))
    t105 = (diagonal_2 * (t97 + t98)) + (t8 * t102)
    t68 = (diagonal_1 + (t8 * (interval * t61))) + t66
    t106 = (t39 + (t8 * (interval * t19))) / t35
    t107 = t35 / t9
    t109 = t105 / (t31 * t35)
    return (t68, t31, t9, t106, t107, t109)


def _predict_continuous_white_jerk_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 6.0,
    n2: float = 12.0,
    n3: float = 720.0,
    n4: float = 3.0,
    n5: float = 5.0,
    n6: float = 24.0,
    n7: float = 144.0,
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
    t8 = multiply(strength, interval, w0)
    add(diagonal_3, t8, diagonal_3_)
    t10 = divide(t8, diagonal_3_, diagonal_2_)
    t12 = multiply(interval, n0, w1)
    t13 = add(t12, second_shear, w2)
    t14 = multiply(diagonal_3, t10, w3)
    t15 = multiply(third_shear, n0, diagonal_2_)
    t16 = multiply(first_shear, n0, w4)
    t17 = add(t16, t15, w5)
    t19 = divide(interval, n1, diagonal_1_)
    t20 = add(t19, t17, diagonal_2_)
    t21 = multiply(second_shear, third_shear, w6)
    t22 = multiply(interval, t20, diagonal_2_)
    t23 = add(t22, t21, w7)
    t25 = divide(interval, n2, first_shear_)
    t26 = multiply(interval, t25, diagonal_2_)
    t27 = multiply(t8, t26, w8)
    t28 = square(t13, diagonal_2_)
    t29 = multiply(t14, t28, diagonal_2_)
    t30 = add(diagonal_2, t27, w9)
    add(t30, t29, diagonal_2_)
    t32 = add(interval, second_shear, w9)
    t33 = multiply(t32, diagonal_3, w9)
    t34 = multiply(t8, t12, w10)
    t35 = add(t33, t34, w9)
    t36 = multiply(second_shear, first_shear, w10)
    t37 = multiply(interval, t13, w2)
    t38 = add(t37, t36, w2)
    t39 = multiply(t38, diagonal_3, w2)
    t40 = multiply(interval, t19, diagonal_1_)
    t41 = multiply(t8, t40, diagonal_1_)
    t42 = add(t39, t41, w2)
    t43 = square(t23, w7)
    t44 = multiply(t14, t43, w7)
    t45 = multiply(diagonal_2, t44, w7)
    t46 = add(first_shear, third_shear, diagonal_1_)
    t47 = add(t12, t46, w1)
    t48 = multiply(second_shear, n0, diagonal_1_)
    t49 = add(t25, t48, first_shear_)
    t50 = multiply(interval, t49, first_shear_)
    t51 = add(t50, t36, first_shear_)
    t52 = square(t47, w10)
    t53 = multiply(t27, t52, w10)
    t54 = multiply(diagonal_2, t53, w10)
    t55 = square(t51, first_shear_)
    t56 = multiply(t14, t55, w3)
    t57 = multiply(t27, t56, w8)
    t59 = divide(interval, n3, second_shear_)
    t60 = multiply(interval, t59, second_shear_)
    t61 = multiply(interval, t60, second_shear_)
    t62 = multiply(interval, t61, second_shear_)
    t63 = multiply(t8, t62, second_shear_)
    t64 = add(t45, t54, w7)
    t65 = add(t64, t57, w7)
    t66 = divide(t65, diagonal_2_, third_shear_)
    t67 = add(diagonal_1, t63, second_shear_)
    t70 = divide(interval, n4, w3)
    t71 = add(t70, t17, w3)
    t72 = multiply(interval, t71, w3)
    t74 = multiply(second_shear, n5, w5)
    t76 = divide(t74, n6, w5)
    t77 = divide(interval, n6, w7)
    t78 = add(t77, t76, w7)
    t79 = divide(first_shear, n1, w5)
    t80 = divide(second_shear, n4, w8)
    t81 = add(t80, t79, w8)
    t82 = multiply(second_shear, t81, w8)
    t83 = multiply(interval, t78, w7)
    t84 = add(t83, t82, w7)
    t85 = multiply(second_shear, t16, w4)
    t86 = multiply(second_shear, t85, w4)
    t87 = multiply(interval, t84, w7)
    t88 = add(t87, t86, w7)
    t89 = multiply(interval, t88, w7)
    t91 = divide(interval, n7, w4)
    t92 = multiply(interval, t91, w4)
    t93 = multiply(interval, t92, w4)
    t94 = multiply(interval, t93, w4)
    t95 = multiply(interval, t47, w1)
    t96 = add(t95, t21, w1)
    t97 = multiply(t96, diagonal_3, w1)
    t98 = multiply(t72, t8, w3)
    t99 = add(t97, t98, w1)
    t100 = multiply(diagonal_3, t89, w7)
    t101 = multiply(t8, t94, w4)
    t102 = add(t100, t101, w7)
    t103 = multiply(diagonal_2, t99, w1)
    t104 = multiply(t8, t102, w0)
    t105 = add(t103, t104, w1)
    t108 = multiply(diagonal_2_, t35, w0)
    add(t67, t66, diagonal_1_)
    divide(t42, t35, first_shear_)
    divide(t35, diagonal_3_, second_shear_)
    divide(t105, t108, third_shear_)


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
    numbers=_predict_continuous_white_jerk_of_numbers,
)
