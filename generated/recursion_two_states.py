# Made by: gainproof generate recursion-two-states
# From: gainproof derive recursion-two-states, SymPy 1.14.0
"""Kalman recursion of position and velocity, any intervals."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, copyto, divide, multiply, sqrt, square, subtract

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
    "Factors",
    "Gains",
    "HandOver",
    "PredictContinuousWhiteAcceleration",
    "PredictRandomAcceleration",
    "PredictRandomVelocity",
    "StartContinuousWhiteAcceleration",
    "StartRandomAcceleration",
    "StartRandomVelocity",
    "StepContinuousWhiteAcceleration",
    "StepRandomAcceleration",
    "StepRandomVelocity",
    "covariance",
    "gains",
    "hand_over",
    "predict_continuous_white_acceleration",
    "predict_random_acceleration",
    "predict_random_velocity",
    "start_continuous_white_acceleration",
    "start_random_acceleration",
    "start_random_velocity",
    "step_continuous_white_acceleration",
    "step_random_acceleration",
    "step_random_velocity",
    "update",
]

_DIAGONAL_1_DOMAIN = Domain(
    "diagonal_1",
    "a number at least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9",
    (1e-40, 1e40),
    (1.0000000116860974e-07, 1000000000.0),
)
_SHEAR_DOMAIN = Domain(
    "shear",
    "0 or a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4",
    (1e-20, 1e20),
    (9.999999747378752e-05, 10000.0),
    zero=True,
)
_DIAGONAL_2_DOMAIN = Domain(
    "diagonal_2",
    "a number at least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9",
    (1e-40, 1e40),
    (1.0000000116860974e-07, 1000000000.0),
)
_MEASUREMENT_VARIANCE_DOMAIN = Domain(
    "measurement_variance",
    "a number at least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9",
    (1e-40, 1e40),
    (1.0000000116860974e-07, 1000000000.0),
)
_INTERVAL_DOMAIN = Domain(
    "interval",
    "a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4",
    (1e-20, 1e20),
    (9.999999747378752e-05, 10000.0),
)
_STRENGTH_DOMAIN = Domain(
    "strength",
    "0 or a number at least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e6",
    (1e-40, 1e40),
    (1.0000000116860974e-07, 1000000.0),
    zero=True,
)
_INTERVAL_DOMAIN_2 = Domain(
    "interval",
    "0 or a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4",
    (1e-20, 1e20),
    (9.999999747378752e-05, 10000.0),
    zero=True,
)
_ALPHA_DOMAIN = Domain(
    "alpha",
    "a number above 0 and below 1",
    (5e-324, 0.9999999999999999),
    (1.401298464324817e-45, 0.9999999403953552),
)


class Covariance(NamedTuple):
    """Result of `covariance`."""

    covariance_11: Real
    """Variance of the position, m^2."""
    covariance_12: Real
    """Covariance of position and velocity, m^2/s."""
    covariance_22: Real
    """Variance of the velocity, m^2/s^2."""


def covariance(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> Covariance:
    """Covariance of position and velocity from its factors d1, u, d2.

        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.

    covariance_11: variance of the position, m^2. Relative error at most 1.51 * 2^-52 (float64),
        1.51 * 2^-23 (float32), proved for every input.
    covariance_12: covariance of position and velocity, m^2/s. Relative error at most 0.51 * 2^-52
        (float64), 0.51 * 2^-23 (float32), proved for every input.
    covariance_22: variance of the velocity, m^2/s^2. Relative error at most 0.00 * 2^-52 (float64),
        0.00 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(Covariance, _covariance_of_numbers(diagonal_1, shear, diagonal_2))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Covariance(*evaluate(_COVARIANCE, (diagonal_1, shear, diagonal_2), out, workers))


def _covariance_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = shear * diagonal_2
    t5 = diagonal_1 + (shear * t3)
    return (t5, t3, diagonal_2)


def _covariance_block(given: Arrays, out: Arrays, _work: Arrays, _single: bool) -> None:
    diagonal_1, shear, diagonal_2 = given
    covariance_11, covariance_12, covariance_22 = out
    multiply(shear, diagonal_2, covariance_12)
    t4 = multiply(shear, covariance_12, covariance_11)
    add(diagonal_1, t4, covariance_11)
    copyto(covariance_22, diagonal_2)


_COVARIANCE = Signature(
    "covariance",
    (_DIAGONAL_1_DOMAIN, _SHEAR_DOMAIN, _DIAGONAL_2_DOMAIN),
    ("covariance_11", "covariance_12", "covariance_22"),
    0,
    _covariance_block,
    numbers=_covariance_of_numbers,
)


class Gains(NamedTuple):
    """Result of `gains`."""

    position_gain: Real
    """Gain of the position, dimensionless."""
    velocity_gain: Real
    """Gain of the velocity, 1/s."""
    innovation_variance: Real
    """Variance of the innovation, m^2."""


def gains(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> Gains:
    """Kalman gain and variance of the innovation, before the position is measured.

        position_gain = (d1 + u^2 d2)/S, velocity_gain = u d2/S,
        S = innovation_variance = d1 + u^2 d2 + r,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    position_gain: gain of the position, dimensionless. Relative error at most 2.51 * 2^-52
        (float64), 2.51 * 2^-23 (float32), proved for every input.
    velocity_gain: gain of the velocity, 1/s. Relative error at most 2.51 * 2^-52 (float64), 2.45 *
        2^-23 (float32), proved for every input.
    innovation_variance: variance of the innovation, m^2. Relative error at most 2.01 * 2^-52
        (float64), 2.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(measurement_variance) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                Gains, _gains_of_numbers(diagonal_1, shear, diagonal_2, measurement_variance)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Gains(
        *evaluate(_GAINS, (diagonal_1, shear, diagonal_2, measurement_variance), out, workers)
    )


def _gains_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = shear * diagonal_2
    t6 = diagonal_1 + (shear * t3)
    t7 = t6 + measurement_variance
    t8 = t6 / t7
    t9 = t3 / t7
    return (t8, t9, t7)


def _gains_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    diagonal_1, shear, diagonal_2, measurement_variance = given
    position_gain, velocity_gain, innovation_variance = out
    w0, w1 = work
    t3 = multiply(shear, diagonal_2, w0)
    t5 = multiply(shear, t3, w1)
    t6 = add(diagonal_1, t5, w1)
    add(t6, measurement_variance, innovation_variance)
    divide(t6, innovation_variance, position_gain)
    divide(t3, innovation_variance, velocity_gain)


_GAINS = Signature(
    "gains",
    (_DIAGONAL_1_DOMAIN, _SHEAR_DOMAIN, _DIAGONAL_2_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("position_gain", "velocity_gain", "innovation_variance"),
    2,
    _gains_block,
    numbers=_gains_of_numbers,
)


class Factors(NamedTuple):
    """Result of `update`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""


def update(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> Factors:
    """Factors of the covariance after the position is measured.

        diagonal_1 = d1 r/(d1 + r), shear = u r/(d1 + r), diagonal_2 = d2 (d1 + r)/S,
        S = d1 + u^2 d2 + r,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 3.51 * 2^-52
        (float64), 3.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(measurement_variance) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                Factors, _update_of_numbers(diagonal_1, shear, diagonal_2, measurement_variance)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Factors(
        *evaluate(_UPDATE, (diagonal_1, shear, diagonal_2, measurement_variance), out, workers)
    )


def _update_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t5 = diagonal_1 + measurement_variance
    t7 = diagonal_1 + (shear * (shear * diagonal_2))
    t9 = measurement_variance / t5
    t10 = diagonal_1 * t9
    t11 = shear * t9
    t13 = diagonal_2 * (t5 / (t7 + measurement_variance))
    return (t10, t11, t13)


def _update_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    diagonal_1, shear, diagonal_2, measurement_variance = given
    diagonal_1_, shear_, diagonal_2_ = out
    w0, w1 = work
    t3 = multiply(shear, diagonal_2, w0)
    t5 = add(diagonal_1, measurement_variance, w1)
    t6 = multiply(shear, t3, w0)
    t7 = add(diagonal_1, t6, w0)
    t8 = add(t7, measurement_variance, w0)
    t9 = divide(measurement_variance, t5, shear_)
    t12 = divide(t5, t8, diagonal_2_)
    multiply(diagonal_1, t9, diagonal_1_)
    multiply(shear, t9, shear_)
    multiply(diagonal_2, t12, diagonal_2_)


_UPDATE = Signature(
    "update",
    (_DIAGONAL_1_DOMAIN, _SHEAR_DOMAIN, _DIAGONAL_2_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "shear", "diagonal_2"),
    2,
    _update_block,
    numbers=_update_of_numbers,
)


class StartRandomVelocity(NamedTuple):
    """Result of `start_random_velocity`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""


def start_random_velocity(
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> StartRandomVelocity:
    """Factors of the covariance after the first two positions, random velocity.

        diagonal_1 = r (r/t^2 + c)/diagonal_2, shear = r/(t diagonal_2),
        diagonal_2 = 2 r/t^2 + c, c = q,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    interval: t, time between the two positions, s; a number at least 1e-20 and at most 1e20, in
        float32 at least 1e-4 and at most 1e4.
    strength: q, variance of the velocity increment, the same for an interval of any length; 0 or a
        number at least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e6.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 2.99 * 2^-52 (float64), 2.66 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 1.51 * 2^-52
        (float64), 1.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-20 <= interval <= 1e20
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StartRandomVelocity,
                _start_random_velocity_of_numbers(interval, strength, measurement_variance),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StartRandomVelocity(
        *evaluate(_START_RANDOM_VELOCITY, (interval, strength, measurement_variance), out, workers)
    )


def _start_random_velocity_of_numbers(
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = measurement_variance / (interval * interval)
    t7 = (t4 * 2.0) + strength
    t11 = measurement_variance * ((t4 + strength) / t7)
    t12 = (measurement_variance / interval) / t7
    return (t11, t12, t7)


def _start_random_velocity_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 2.0
) -> None:
    interval, strength, measurement_variance = given
    diagonal_1, shear, diagonal_2 = out
    (w0,) = work
    t3 = square(interval, w0)
    t4 = divide(measurement_variance, t3, diagonal_1)
    t6 = multiply(t4, n0, w0)
    add(t6, strength, diagonal_2)
    t8 = divide(measurement_variance, interval, shear)
    t9 = add(t4, strength, diagonal_1)
    t10 = divide(t9, diagonal_2, diagonal_1)
    multiply(measurement_variance, t10, diagonal_1)
    divide(t8, diagonal_2, shear)


_START_RANDOM_VELOCITY = Signature(
    "start_random_velocity",
    (_INTERVAL_DOMAIN, _STRENGTH_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "shear", "diagonal_2"),
    1,
    _start_random_velocity_block,
    numbers=_start_random_velocity_of_numbers,
)


class StartRandomAcceleration(NamedTuple):
    """Result of `start_random_acceleration`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""


def start_random_acceleration(
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> StartRandomAcceleration:
    """Factors of the covariance after the first two positions, random acceleration.

        diagonal_1 = r (r/t^2 + c)/diagonal_2, shear = r/(t diagonal_2),
        diagonal_2 = 2 r/t^2 + c, c = q t^2/4,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    interval: t, time between the two positions, s; a number at least 1e-20 and at most 1e20, in
        float32 at least 1e-4 and at most 1e4.
    strength: q, variance of the acceleration, which is constant over the interval; 0 or a number at
        least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e6.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 4.00 * 2^-52 (float64), 3.60 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 1.51 * 2^-52
        (float64), 1.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-20 <= interval <= 1e20
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StartRandomAcceleration,
                _start_random_acceleration_of_numbers(interval, strength, measurement_variance),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StartRandomAcceleration(
        *evaluate(
            _START_RANDOM_ACCELERATION,
            (interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _start_random_acceleration_of_numbers(
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = interval * interval
    t4 = measurement_variance / t3
    t9 = ((strength * t3) * 1.0) * 0.25
    t12 = (t4 * 2.0) + t9
    t16 = measurement_variance * ((t4 + t9) / t12)
    t17 = (measurement_variance / interval) / t12
    return (t16, t17, t12)


def _start_random_acceleration_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 0.25,
    n2: float = 2.0,
) -> None:
    interval, strength, measurement_variance = given
    diagonal_1, shear, diagonal_2 = out
    w0, w1 = work
    t3 = square(interval, w0)
    t4 = divide(measurement_variance, t3, diagonal_1)
    t5 = multiply(strength, t3, w0)
    t7 = multiply(t5, n0, w0)
    t9 = multiply(t7, n1, w0)
    t11 = multiply(t4, n2, w1)
    add(t11, t9, diagonal_2)
    t13 = divide(measurement_variance, interval, shear)
    t14 = add(t4, t9, diagonal_1)
    t15 = divide(t14, diagonal_2, diagonal_1)
    multiply(measurement_variance, t15, diagonal_1)
    divide(t13, diagonal_2, shear)


_START_RANDOM_ACCELERATION = Signature(
    "start_random_acceleration",
    (_INTERVAL_DOMAIN, _STRENGTH_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "shear", "diagonal_2"),
    2,
    _start_random_acceleration_block,
    numbers=_start_random_acceleration_of_numbers,
)


class StartContinuousWhiteAcceleration(NamedTuple):
    """Result of `start_continuous_white_acceleration`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""


def start_continuous_white_acceleration(
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> StartContinuousWhiteAcceleration:
    """Factors of the covariance after the first two positions, continuous white acceleration.

        diagonal_1 = r (r/t^2 + c)/diagonal_2, shear = r/(t diagonal_2),
        diagonal_2 = 2 r/t^2 + c, c = q t/3,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    interval: t, time between the two positions, s; a number at least 1e-20 and at most 1e20, in
        float32 at least 1e-4 and at most 1e4.
    strength: q, two-sided power density of the acceleration; 0 or a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e6.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 4.00 * 2^-52 (float64), 3.50 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 1.51 * 2^-52
        (float64), 1.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-20 <= interval <= 1e20
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StartContinuousWhiteAcceleration,
                _start_continuous_white_acceleration_of_numbers(
                    interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StartContinuousWhiteAcceleration(
        *evaluate(
            _START_CONTINUOUS_WHITE_ACCELERATION,
            (interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _start_continuous_white_acceleration_of_numbers(
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = measurement_variance / (interval * interval)
    t9 = ((strength * interval) * 1.0) / 3.0
    t12 = (t4 * 2.0) + t9
    t16 = measurement_variance * ((t4 + t9) / t12)
    t17 = (measurement_variance / interval) / t12
    return (t16, t17, t12)


def _start_continuous_white_acceleration_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 3.0,
    n2: float = 2.0,
) -> None:
    interval, strength, measurement_variance = given
    diagonal_1, shear, diagonal_2 = out
    (w0,) = work
    t3 = square(interval, w0)
    t4 = divide(measurement_variance, t3, diagonal_1)
    t5 = multiply(strength, interval, w0)
    t7 = multiply(t5, n0, w0)
    t9 = divide(t7, n1, shear)
    t11 = multiply(t4, n2, w0)
    add(t11, t9, diagonal_2)
    t13 = divide(measurement_variance, interval, w0)
    t14 = add(t4, t9, diagonal_1)
    t15 = divide(t14, diagonal_2, diagonal_1)
    multiply(measurement_variance, t15, diagonal_1)
    divide(t13, diagonal_2, shear)


_START_CONTINUOUS_WHITE_ACCELERATION = Signature(
    "start_continuous_white_acceleration",
    (_INTERVAL_DOMAIN, _STRENGTH_DOMAIN, _MEASUREMENT_VARIANCE_DOMAIN),
    ("diagonal_1", "shear", "diagonal_2"),
    1,
    _start_continuous_white_acceleration_block,
    numbers=_start_continuous_white_acceleration_of_numbers,
)


class PredictRandomVelocity(NamedTuple):
    """Result of `predict_random_velocity`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""


def predict_random_velocity(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictRandomVelocity:
    """Factors of the covariance after an interval, random velocity.

        diagonal_1 = d1 + (u + t)^2 d2 g/(d2 + g),
        shear = ((u + t) d2)/(d2 + g), diagonal_2 = d2 + g,
        g = q,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    interval: t, time since the covariance given, s; 0 or a number at least 1e-20 and at most 1e20,
        in float32 at least 1e-4 and at most 1e4.
    strength: q, variance of the velocity increment, the same for an interval of any length; 0 or a
        number at least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e6.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 0.51 * 2^-52
        (float64), 0.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(interval) is float
        and type(strength) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and (1e-20 <= interval <= 1e20 or interval == 0)
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictRandomVelocity,
                _predict_random_velocity_of_numbers(
                    diagonal_1, shear, diagonal_2, interval, strength
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictRandomVelocity(
        *evaluate(
            _PREDICT_RANDOM_VELOCITY,
            (diagonal_1, shear, diagonal_2, interval, strength),
            out,
            workers,
        )
    )


def _predict_random_velocity_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    interval: float,
    strength: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t5 = diagonal_2 + strength
    t6 = shear + interval
    t11 = (t6 * t6) * (diagonal_2 * (strength / t5))
    t12 = diagonal_1 + t11
    t13 = (t6 * diagonal_2) / t5
    return (t12, t13, t5)


def _predict_random_velocity_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    diagonal_1, shear, diagonal_2, interval, strength = given
    diagonal_1_, shear_, diagonal_2_ = out
    w0, w1 = work
    add(diagonal_2, strength, diagonal_2_)
    t6 = add(shear, interval, w0)
    t7 = multiply(t6, diagonal_2, w1)
    t8 = square(t6, w0)
    divide(t7, diagonal_2_, shear_)
    t9 = divide(strength, diagonal_2_, diagonal_1_)
    t10 = multiply(diagonal_2, t9, diagonal_1_)
    t11 = multiply(t8, t10, diagonal_1_)
    add(diagonal_1, t11, diagonal_1_)


_PREDICT_RANDOM_VELOCITY = Signature(
    "predict_random_velocity",
    (_DIAGONAL_1_DOMAIN, _SHEAR_DOMAIN, _DIAGONAL_2_DOMAIN, _INTERVAL_DOMAIN_2, _STRENGTH_DOMAIN),
    ("diagonal_1", "shear", "diagonal_2"),
    2,
    _predict_random_velocity_block,
    numbers=_predict_random_velocity_of_numbers,
)


class PredictRandomAcceleration(NamedTuple):
    """Result of `predict_random_acceleration`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""


def predict_random_acceleration(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictRandomAcceleration:
    """Factors of the covariance after an interval, random acceleration.

        diagonal_1 = d1 + (u + t/2)^2 d2 g/(d2 + g),
        shear = ((u + t) d2 + g t/2)/(d2 + g), diagonal_2 = d2 + g,
        g = q t^2,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    interval: t, time since the covariance given, s; 0 or a number at least 1e-20 and at most 1e20,
        in float32 at least 1e-4 and at most 1e4.
    strength: q, variance of the acceleration, which is constant over the interval; 0 or a number at
        least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e6.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 4.01 * 2^-52 (float64), 4.00 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 1.51 * 2^-52
        (float64), 1.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(interval) is float
        and type(strength) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and (1e-20 <= interval <= 1e20 or interval == 0)
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictRandomAcceleration,
                _predict_random_acceleration_of_numbers(
                    diagonal_1, shear, diagonal_2, interval, strength
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictRandomAcceleration(
        *evaluate(
            _PREDICT_RANDOM_ACCELERATION,
            (diagonal_1, shear, diagonal_2, interval, strength),
            out,
            workers,
        )
    )


def _predict_random_acceleration_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    interval: float,
    strength: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t6 = strength * (interval * interval)
    t7 = diagonal_2 + t6
    t11 = interval * 0.5
    t12 = shear + t11
    t14 = ((shear + interval) * diagonal_2) + (t11 * t6)
    t18 = (t12 * t12) * (diagonal_2 * (t6 / t7))
    t19 = diagonal_1 + t18
    t20 = t14 / t7
    return (t19, t20, t7)


def _predict_random_acceleration_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5
) -> None:
    diagonal_1, shear, diagonal_2, interval, strength = given
    diagonal_1_, shear_, diagonal_2_ = out
    w0, w1, w2, w3 = work
    t5 = square(interval, w0)
    t6 = multiply(strength, t5, w0)
    add(diagonal_2, t6, diagonal_2_)
    t8 = add(shear, interval, w1)
    t9 = multiply(t8, diagonal_2, w1)
    t11 = multiply(interval, n0, w2)
    t12 = add(shear, t11, w3)
    t13 = multiply(t11, t6, w2)
    t14 = add(t9, t13, w1)
    t15 = square(t12, w3)
    divide(t14, diagonal_2_, shear_)
    t16 = divide(t6, diagonal_2_, diagonal_1_)
    t17 = multiply(diagonal_2, t16, diagonal_1_)
    t18 = multiply(t15, t17, diagonal_1_)
    add(diagonal_1, t18, diagonal_1_)


_PREDICT_RANDOM_ACCELERATION = Signature(
    "predict_random_acceleration",
    (_DIAGONAL_1_DOMAIN, _SHEAR_DOMAIN, _DIAGONAL_2_DOMAIN, _INTERVAL_DOMAIN_2, _STRENGTH_DOMAIN),
    ("diagonal_1", "shear", "diagonal_2"),
    4,
    _predict_random_acceleration_block,
    numbers=_predict_random_acceleration_of_numbers,
)


class PredictContinuousWhiteAcceleration(NamedTuple):
    """Result of `predict_continuous_white_acceleration`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""


def predict_continuous_white_acceleration(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictContinuousWhiteAcceleration:
    """Factors of the covariance after an interval, continuous white acceleration.

        diagonal_1 = d1 + q t^3/12 + (u + t/2)^2 d2 g/(d2 + g),
        shear = ((u + t) d2 + g t/2)/(d2 + g), diagonal_2 = d2 + g,
        g = q t,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    interval: t, time since the covariance given, s; 0 or a number at least 1e-20 and at most 1e20,
        in float32 at least 1e-4 and at most 1e4.
    strength: q, two-sided power density of the acceleration; 0 or a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e6.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 5.51 * 2^-52 (float64), 5.51 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 1.01 * 2^-52
        (float64), 1.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(interval) is float
        and type(strength) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and (1e-20 <= interval <= 1e20 or interval == 0)
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictContinuousWhiteAcceleration,
                _predict_continuous_white_acceleration_of_numbers(
                    diagonal_1, shear, diagonal_2, interval, strength
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictContinuousWhiteAcceleration(
        *evaluate(
            _PREDICT_CONTINUOUS_WHITE_ACCELERATION,
            (diagonal_1, shear, diagonal_2, interval, strength),
            out,
            workers,
        )
    )


def _predict_continuous_white_acceleration_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    interval: float,
    strength: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t5 = strength * interval
    t6 = diagonal_2 + t5
    t10 = interval * 0.5
    t11 = shear + t10
    t13 = ((shear + interval) * diagonal_2) + (t10 * t5)
    t17 = (t11 * t11) * (diagonal_2 * (t5 / t6))
    t20 = strength * (interval * (interval * interval))
    t26 = diagonal_1 + (t17 + ((t20 * 1.0) / 12.0))
    t27 = t13 / t6
    return (t26, t27, t6)


def _predict_continuous_white_acceleration_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 1.0,
    n2: float = 12.0,
) -> None:
    diagonal_1, shear, diagonal_2, interval, strength = given
    diagonal_1_, shear_, diagonal_2_ = out
    w0, w1, w2, w3 = work
    t5 = multiply(strength, interval, w0)
    add(diagonal_2, t5, diagonal_2_)
    t7 = add(shear, interval, w1)
    t8 = multiply(t7, diagonal_2, w1)
    t10 = multiply(interval, n0, w2)
    t11 = add(shear, t10, w3)
    t12 = multiply(t10, t5, w2)
    t13 = add(t8, t12, w1)
    t14 = square(t11, w3)
    t15 = divide(t5, diagonal_2_, w0)
    t16 = multiply(diagonal_2, t15, w0)
    t17 = multiply(t14, t16, w3)
    t18 = square(interval, w0)
    t19 = multiply(interval, t18, w0)
    t20 = multiply(strength, t19, w0)
    t22 = multiply(t20, n1, w0)
    divide(t13, diagonal_2_, shear_)
    t24 = divide(t22, n2, diagonal_1_)
    t25 = add(t17, t24, diagonal_1_)
    add(diagonal_1, t25, diagonal_1_)


_PREDICT_CONTINUOUS_WHITE_ACCELERATION = Signature(
    "predict_continuous_white_acceleration",
    (_DIAGONAL_1_DOMAIN, _SHEAR_DOMAIN, _DIAGONAL_2_DOMAIN, _INTERVAL_DOMAIN_2, _STRENGTH_DOMAIN),
    ("diagonal_1", "shear", "diagonal_2"),
    4,
    _predict_continuous_white_acceleration_block,
    numbers=_predict_continuous_white_acceleration_of_numbers,
)


class StepRandomVelocity(NamedTuple):
    """Result of `step_random_velocity`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""
    position_gain: Real
    """Gain of the position, dimensionless."""
    velocity_gain: Real
    """Gain of the velocity, 1/s."""
    innovation_variance: Real
    """Variance of the innovation, m^2."""


def step_random_velocity(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StepRandomVelocity:
    """An interval, then a measured position: factors and gains, random velocity.

        diagonal_1 = d1 + (u + t)^2 d2 g/(d2 + g),
        shear = ((u + t) d2)/(d2 + g), diagonal_2 = d2 + g,
        g = q, then with these as d1, u, d2
        diagonal_1 = d1 r/(d1 + r), shear = u r/(d1 + r), diagonal_2 = d2 (d1 + r)/S,
        position_gain = (d1 + u^2 d2)/S, velocity_gain = u d2/S,
        S = innovation_variance = d1 + u^2 d2 + r,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    interval: t, time since the covariance given, s; 0 or a number at least 1e-20 and at most 1e20,
        in float32 at least 1e-4 and at most 1e4.
    strength: q, variance of the velocity increment, the same for an interval of any length; 0 or a
        number at least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e6.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 5.51 * 2^-52 (float64), 5.51 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 6.01 * 2^-52 (float64), 6.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 10.51 * 2^-52
        (float64), 10.51 * 2^-23 (float32), proved for every input.
    position_gain: gain of the position, dimensionless. Relative error at most 9.01 * 2^-52
        (float64), 9.01 * 2^-23 (float32), proved for every input.
    velocity_gain: gain of the velocity, 1/s. Relative error at most 6.51 * 2^-52 (float64), 6.51 *
        2^-23 (float32), proved for every input.
    innovation_variance: variance of the innovation, m^2. Relative error at most 5.01 * 2^-52
        (float64), 5.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and (1e-20 <= interval <= 1e20 or interval == 0)
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StepRandomVelocity,
                _step_random_velocity_of_numbers(
                    diagonal_1, shear, diagonal_2, interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StepRandomVelocity(
        *evaluate(
            _STEP_RANDOM_VELOCITY,
            (diagonal_1, shear, diagonal_2, interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _step_random_velocity_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t5 = diagonal_2 + strength
    t6 = shear + interval
    t7 = t6 * diagonal_2
    t11 = (t6 * t6) * (diagonal_2 * (strength / t5))
    t12 = diagonal_1 + t11
    t13 = t7 / t5
    t15 = t12 + measurement_variance
    t17 = t12 + (t13 * t7)
    t18 = t17 + measurement_variance
    t19 = measurement_variance / t15
    t20 = t12 * t19
    t21 = t13 * t19
    t23 = t5 * (t15 / t18)
    t24 = t17 / t18
    t25 = t7 / t18
    return (t20, t21, t23, t24, t25, t18)


def _step_random_velocity_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    diagonal_1, shear, diagonal_2, interval, strength, measurement_variance = given
    diagonal_1_, shear_, diagonal_2_, position_gain, velocity_gain, innovation_variance = out
    w0, w1, w2, w3, w4 = work
    t5 = add(diagonal_2, strength, w0)
    t6 = add(shear, interval, w1)
    t7 = multiply(t6, diagonal_2, w2)
    t8 = square(t6, w1)
    t9 = divide(strength, t5, innovation_variance)
    t10 = multiply(diagonal_2, t9, innovation_variance)
    t11 = multiply(t8, t10, w1)
    t12 = add(diagonal_1, t11, w1)
    t13 = divide(t7, t5, shear_)
    t15 = add(t12, measurement_variance, w3)
    t16 = multiply(t13, t7, innovation_variance)
    t17 = add(t12, t16, w4)
    add(t17, measurement_variance, innovation_variance)
    t19 = divide(measurement_variance, t15, diagonal_2_)
    t22 = divide(t15, innovation_variance, position_gain)
    multiply(t12, t19, diagonal_1_)
    multiply(t13, t19, shear_)
    multiply(t5, t22, diagonal_2_)
    divide(t17, innovation_variance, position_gain)
    divide(t7, innovation_variance, velocity_gain)


_STEP_RANDOM_VELOCITY = Signature(
    "step_random_velocity",
    (
        _DIAGONAL_1_DOMAIN,
        _SHEAR_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _INTERVAL_DOMAIN_2,
        _STRENGTH_DOMAIN,
        _MEASUREMENT_VARIANCE_DOMAIN,
    ),
    ("diagonal_1", "shear", "diagonal_2", "position_gain", "velocity_gain", "innovation_variance"),
    5,
    _step_random_velocity_block,
    numbers=_step_random_velocity_of_numbers,
)


class StepRandomAcceleration(NamedTuple):
    """Result of `step_random_acceleration`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""
    position_gain: Real
    """Gain of the position, dimensionless."""
    velocity_gain: Real
    """Gain of the velocity, 1/s."""
    innovation_variance: Real
    """Variance of the innovation, m^2."""


def step_random_acceleration(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StepRandomAcceleration:
    """An interval, then a measured position: factors and gains, random acceleration.

        diagonal_1 = d1 + (u + t/2)^2 d2 g/(d2 + g),
        shear = ((u + t) d2 + g t/2)/(d2 + g), diagonal_2 = d2 + g,
        g = q t^2, then with these as d1, u, d2
        diagonal_1 = d1 r/(d1 + r), shear = u r/(d1 + r), diagonal_2 = d2 (d1 + r)/S,
        position_gain = (d1 + u^2 d2)/S, velocity_gain = u d2/S,
        S = innovation_variance = d1 + u^2 d2 + r,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    interval: t, time since the covariance given, s; 0 or a number at least 1e-20 and at most 1e20,
        in float32 at least 1e-4 and at most 1e4.
    strength: q, variance of the acceleration, which is constant over the interval; 0 or a number at
        least 1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e6.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 16.51 * 2^-52
        (float64), 16.51 * 2^-23 (float32), proved for every input.
    position_gain: gain of the position, dimensionless. Relative error at most 14.01 * 2^-52
        (float64), 14.01 * 2^-23 (float32), proved for every input.
    velocity_gain: gain of the velocity, 1/s. Relative error at most 10.01 * 2^-52 (float64), 10.01
        * 2^-23 (float32), proved for every input.
    innovation_variance: variance of the innovation, m^2. Relative error at most 7.51 * 2^-52
        (float64), 7.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and (1e-20 <= interval <= 1e20 or interval == 0)
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StepRandomAcceleration,
                _step_random_acceleration_of_numbers(
                    diagonal_1, shear, diagonal_2, interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StepRandomAcceleration(
        *evaluate(
            _STEP_RANDOM_ACCELERATION,
            (diagonal_1, shear, diagonal_2, interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _step_random_acceleration_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t6 = strength * (interval * interval)
    t7 = diagonal_2 + t6
    t11 = interval * 0.5
    t12 = shear + t11
    t14 = ((shear + interval) * diagonal_2) + (t11 * t6)
    t18 = (t12 * t12) * (diagonal_2 * (t6 / t7))
    t19 = diagonal_1 + t18
    t20 = t14 / t7
    t22 = t19 + measurement_variance
    t24 = t19 + (t20 * t14)
    t25 = t24 + measurement_variance
    t26 = measurement_variance / t22
    t27 = t19 * t26
    t28 = t20 * t26
    t30 = t7 * (t22 / t25)
    t31 = t24 / t25
    t32 = t14 / t25
    return (t27, t28, t30, t31, t32, t25)


def _step_random_acceleration_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5
) -> None:
    diagonal_1, shear, diagonal_2, interval, strength, measurement_variance = given
    diagonal_1_, shear_, diagonal_2_, position_gain, velocity_gain, innovation_variance = out
    w0, w1, w2, w3, w4 = work
    t5 = square(interval, w0)
    t6 = multiply(strength, t5, w0)
    t7 = add(diagonal_2, t6, w1)
    t8 = add(shear, interval, w2)
    t9 = multiply(t8, diagonal_2, w2)
    t11 = multiply(interval, n0, w3)
    t12 = add(shear, t11, w4)
    t13 = multiply(t11, t6, w3)
    t14 = add(t9, t13, w2)
    t15 = square(t12, w4)
    t16 = divide(t6, t7, innovation_variance)
    t17 = multiply(diagonal_2, t16, innovation_variance)
    t18 = multiply(t15, t17, w4)
    t19 = add(diagonal_1, t18, w4)
    t20 = divide(t14, t7, shear_)
    t22 = add(t19, measurement_variance, w0)
    t23 = multiply(t20, t14, w3)
    t24 = add(t19, t23, w3)
    add(t24, measurement_variance, innovation_variance)
    t26 = divide(measurement_variance, t22, diagonal_2_)
    t29 = divide(t22, innovation_variance, position_gain)
    multiply(t19, t26, diagonal_1_)
    multiply(t20, t26, shear_)
    multiply(t7, t29, diagonal_2_)
    divide(t24, innovation_variance, position_gain)
    divide(t14, innovation_variance, velocity_gain)


_STEP_RANDOM_ACCELERATION = Signature(
    "step_random_acceleration",
    (
        _DIAGONAL_1_DOMAIN,
        _SHEAR_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _INTERVAL_DOMAIN_2,
        _STRENGTH_DOMAIN,
        _MEASUREMENT_VARIANCE_DOMAIN,
    ),
    ("diagonal_1", "shear", "diagonal_2", "position_gain", "velocity_gain", "innovation_variance"),
    5,
    _step_random_acceleration_block,
    numbers=_step_random_acceleration_of_numbers,
)


class StepContinuousWhiteAcceleration(NamedTuple):
    """Result of `step_continuous_white_acceleration`."""

    diagonal_1: Real
    """D1, variance of the position where the velocity is known, m^2."""
    shear: Real
    """U, covariance of position and velocity over the velocity's variance, s."""
    diagonal_2: Real
    """D2, variance of the velocity, m^2/s^2."""
    position_gain: Real
    """Gain of the position, dimensionless."""
    velocity_gain: Real
    """Gain of the velocity, 1/s."""
    innovation_variance: Real
    """Variance of the innovation, m^2."""


def step_continuous_white_acceleration(
    diagonal_1: ArrayLike,
    shear: ArrayLike,
    diagonal_2: ArrayLike,
    interval: ArrayLike,
    strength: ArrayLike,
    measurement_variance: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StepContinuousWhiteAcceleration:
    """An interval, then a measured position: factors and gains, continuous white acceleration.

        diagonal_1 = d1 + q t^3/12 + (u + t/2)^2 d2 g/(d2 + g),
        shear = ((u + t) d2 + g t/2)/(d2 + g), diagonal_2 = d2 + g,
        g = q t, then with these as d1, u, d2
        diagonal_1 = d1 r/(d1 + r), shear = u r/(d1 + r), diagonal_2 = d2 (d1 + r)/S,
        position_gain = (d1 + u^2 d2)/S, velocity_gain = u d2/S,
        S = innovation_variance = d1 + u^2 d2 + r,
        P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]

    diagonal_1: d1, variance of the position where the velocity is known, m^2; a number at least
        1e-40 and at most 1e40, in float32 at least 1e-7 and at most 1e9.
    shear: u, covariance of position and velocity over the velocity's variance, s; 0 or a number at
        least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4.
    diagonal_2: d2, variance of the velocity, m^2/s^2; a number at least 1e-40 and at most 1e40, in
        float32 at least 1e-7 and at most 1e9.
    interval: t, time since the covariance given, s; 0 or a number at least 1e-20 and at most 1e20,
        in float32 at least 1e-4 and at most 1e4.
    strength: q, two-sided power density of the acceleration; 0 or a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e6.
    measurement_variance: r, variance of the measured position, m^2; a number at least 1e-40 and at
        most 1e40, in float32 at least 1e-7 and at most 1e9.

    diagonal_1: d1, variance of the position where the velocity is known, m^2. Relative error at
        most 8.51 * 2^-52 (float64), 8.51 * 2^-23 (float32), proved for every input.
    shear: u, covariance of position and velocity over the velocity's variance, s. Relative error at
        most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for every input.
    diagonal_2: d2, variance of the velocity, m^2/s^2. Relative error at most 14.51 * 2^-52
        (float64), 14.51 * 2^-23 (float32), proved for every input.
    position_gain: gain of the position, dimensionless. Relative error at most 13.01 * 2^-52
        (float64), 13.01 * 2^-23 (float32), proved for every input.
    velocity_gain: gain of the velocity, 1/s. Relative error at most 8.51 * 2^-52 (float64), 8.51 *
        2^-23 (float32), proved for every input.
    innovation_variance: variance of the innovation, m^2. Relative error at most 6.51 * 2^-52
        (float64), 6.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(diagonal_1) is float
        and type(shear) is float
        and type(diagonal_2) is float
        and type(interval) is float
        and type(strength) is float
        and type(measurement_variance) is float
        and 1e-40 <= diagonal_1 <= 1e40
        and (1e-20 <= shear <= 1e20 or shear == 0)
        and 1e-40 <= diagonal_2 <= 1e40
        and (1e-20 <= interval <= 1e20 or interval == 0)
        and (1e-40 <= strength <= 1e40 or strength == 0)
        and 1e-40 <= measurement_variance <= 1e40
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StepContinuousWhiteAcceleration,
                _step_continuous_white_acceleration_of_numbers(
                    diagonal_1, shear, diagonal_2, interval, strength, measurement_variance
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StepContinuousWhiteAcceleration(
        *evaluate(
            _STEP_CONTINUOUS_WHITE_ACCELERATION,
            (diagonal_1, shear, diagonal_2, interval, strength, measurement_variance),
            out,
            workers,
        )
    )


def _step_continuous_white_acceleration_of_numbers(
    diagonal_1: float,
    shear: float,
    diagonal_2: float,
    interval: float,
    strength: float,
    measurement_variance: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t5 = strength * interval
    t6 = diagonal_2 + t5
    t10 = interval * 0.5
    t11 = shear + t10
    t13 = ((shear + interval) * diagonal_2) + (t10 * t5)
    t17 = (t11 * t11) * (diagonal_2 * (t5 / t6))
    t20 = strength * (interval * (interval * interval))
    t26 = diagonal_1 + (t17 + ((t20 * 1.0) / 12.0))
    t27 = t13 / t6
    t29 = t26 + measurement_variance
    t31 = t26 + (t27 * t13)
    t32 = t31 + measurement_variance
    t33 = measurement_variance / t29
    t34 = t26 * t33
    t35 = t27 * t33
    t37 = t6 * (t29 / t32)
    t38 = t31 / t32
    t39 = t13 / t32
    return (t34, t35, t37, t38, t39, t32)


def _step_continuous_white_acceleration_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 1.0,
    n2: float = 12.0,
) -> None:
    diagonal_1, shear, diagonal_2, interval, strength, measurement_variance = given
    diagonal_1_, shear_, diagonal_2_, position_gain, velocity_gain, innovation_variance = out
    w0, w1, w2, w3, w4 = work
    t5 = multiply(strength, interval, w0)
    t6 = add(diagonal_2, t5, w1)
    t7 = add(shear, interval, w2)
    t8 = multiply(t7, diagonal_2, w2)
    t10 = multiply(interval, n0, w3)
    t11 = add(shear, t10, w4)
    t12 = multiply(t10, t5, w3)
    t13 = add(t8, t12, w2)
    t14 = square(t11, w4)
    t15 = divide(t5, t6, innovation_variance)
    t16 = multiply(diagonal_2, t15, innovation_variance)
    t17 = multiply(t14, t16, w4)
    t18 = square(interval, w0)
    t19 = multiply(interval, t18, w0)
    t20 = multiply(strength, t19, w0)
    t22 = multiply(t20, n1, w0)
    t24 = divide(t22, n2, diagonal_1_)
    t25 = add(t17, t24, w4)
    t26 = add(diagonal_1, t25, w4)
    t27 = divide(t13, t6, shear_)
    t29 = add(t26, measurement_variance, w0)
    t30 = multiply(t27, t13, w3)
    t31 = add(t26, t30, w3)
    add(t31, measurement_variance, innovation_variance)
    t33 = divide(measurement_variance, t29, diagonal_2_)
    t36 = divide(t29, innovation_variance, position_gain)
    multiply(t26, t33, diagonal_1_)
    multiply(t27, t33, shear_)
    multiply(t6, t36, diagonal_2_)
    divide(t31, innovation_variance, position_gain)
    divide(t13, innovation_variance, velocity_gain)


_STEP_CONTINUOUS_WHITE_ACCELERATION = Signature(
    "step_continuous_white_acceleration",
    (
        _DIAGONAL_1_DOMAIN,
        _SHEAR_DOMAIN,
        _DIAGONAL_2_DOMAIN,
        _INTERVAL_DOMAIN_2,
        _STRENGTH_DOMAIN,
        _MEASUREMENT_VARIANCE_DOMAIN,
    ),
    ("diagonal_1", "shear", "diagonal_2", "position_gain", "velocity_gain", "innovation_variance"),
    5,
    _step_continuous_white_acceleration_block,
    numbers=_step_continuous_white_acceleration_of_numbers,
)


class HandOver(NamedTuple):
    """Result of `hand_over`."""

    last_sample: Real
    """Real k; its whole part is the last sample of the fit."""


def hand_over(alpha: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1) -> HandOver:
    """The last sample at which the gain of a line fitted by least squares is not below alpha.

        last_sample = (4 - 3 alpha + sqrt(16 - 16 alpha + alpha^2))/(2 alpha),
        where alpha = 2 (2 k + 1)/((k + 1) (k + 2))

    alpha: steady-state position gain; a number above 0 and below 1.

    last_sample: real k; its whole part is the last sample of the fit. Relative error at most 2.14 *
        2^-52 (float64), 2.14 * 2^-23 (float32), proved for 2.225073858507233e-308 <= alpha <=
        0.9999999999999999 (float64) and 1.1755035e-38 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation recursion-two-states
    """
    if (
        type(alpha) is float
        and 5e-324 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(HandOver, _hand_over_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return HandOver(*evaluate(_HAND_OVER, (alpha,), out, workers))


def _hand_over_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.0 - alpha
    t7 = form.sqrt((t2 * 16.0) + (alpha * alpha))
    t14 = ((1.0 + (t2 * 3.0)) + t7) / (alpha * 2.0)
    return (t14,)


def _hand_over_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 16.0,
    n2: float = 3.0,
    n3: float = 2.0,
) -> None:
    (alpha,) = given
    (last_sample,) = out
    w0, w1, w2 = work
    t2 = subtract(n0, alpha, w0)
    t4 = multiply(t2, n1, w1)
    t5 = square(alpha, w2)
    t6 = add(t4, t5, w1)
    root = sqrt(t6, last_sample)
    t9 = multiply(t2, n2, w0)
    t10 = add(n0, t9, w0)
    t11 = add(t10, root, w0)
    t13 = multiply(alpha, n3, w1)
    divide(t11, t13, last_sample)


_HAND_OVER = Signature(
    "hand_over",
    (_ALPHA_DOMAIN,),
    ("last_sample",),
    3,
    _hand_over_block,
    numbers=_hand_over_of_numbers,
)
