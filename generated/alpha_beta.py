# Made by: gainproof generate alpha-beta
# From: gainproof derive alpha-beta, SymPy 1.14.0
"""Alpha-beta filters with any gains."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, copyto, divide, multiply, negative, sqrt, square, subtract

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
    "Coordinates",
    "GainsOfCoordinates",
    "Lags",
    "MinimumSmoothedVarianceByGain",
    "MinimumSmoothedVarianceByLag",
    "MinimumVarianceByGain",
    "MinimumVarianceByLag",
    "ProcessNoiseVariances",
    "ProcessNoiseVariancesOfCoordinates",
    "RandomAccelerationByGain",
    "RandomAccelerationByLag",
    "RandomVelocityByGain",
    "RandomVelocityByLag",
    "Variances",
    "VariancesOfCoordinates",
    "closed_loop_poles",
    "coordinates",
    "gains_of_coordinates",
    "lags",
    "minimum_smoothed_variance_by_gain",
    "minimum_smoothed_variance_by_lag",
    "minimum_variance_by_gain",
    "minimum_variance_by_lag",
    "process_noise_variances",
    "process_noise_variances_of_coordinates",
    "random_acceleration_by_gain",
    "random_acceleration_by_lag",
    "random_velocity_by_gain",
    "random_velocity_by_lag",
    "variances",
    "variances_of_coordinates",
]

_ALPHA_DOMAIN = Domain(
    "alpha",
    "a number at least 1e-30 and at most 0.9999999, in float32 at least 1e-12 and at most 0.999999",
    (1e-30, 0.9999999),
    (9.999999960041972e-13, 0.9999989867210388),
)
_BETA_DOMAIN = Domain(
    "beta",
    "a number at least 1e-30 and at most 1.9999999, in float32 at least 1e-12 and at most 1.999999",
    (1e-30, 1.9999999),
    (9.999999960041972e-13, 1.9999990463256836),
)
_LINEAR_COEFFICIENT_DOMAIN = Domain(
    "linear_coefficient",
    "a number at least 1e-60 and at most 1e60, in float32 at least 1e-9 and at most 1e9",
    (1e-60, 1e60),
    (9.999999717180685e-10, 1000000000.0),
)
_QUADRATIC_COEFFICIENT_DOMAIN = Domain(
    "quadratic_coefficient",
    "a number at least 1e-60 and at most 1e60, in float32 at least 1e-9 and at most 1e9",
    (1e-60, 1e60),
    (9.999999717180685e-10, 1000000000.0),
)
_LAG_DOMAIN = Domain(
    "lag",
    "a number above 1/4 and at most 1e30, in float32 above 1/4 and at most 1e9",
    (0.25000000000000006, 1e30),
    (0.2500000298023224, 1000000000.0),
)
_LAG_DOMAIN_2 = Domain(
    "lag",
    "a number above 1/2 and at most 1e30, in float32 above 1/2 and at most 1e9",
    (0.5000000000000001, 1e30),
    (0.5000000596046448, 1000000000.0),
)
_LAG_DOMAIN_3 = Domain(
    "lag",
    "a number above 0.6036 and at most 1e30, in float32 above 0.6036 and at most 1e9",
    (0.6036, 1e30),
    (0.603600025177002, 1000000000.0),
)
_ALPHA_DOMAIN_2 = Domain(
    "alpha",
    "a number at least 1e-15 and below 1/2, in float32 at least 1e-9 and below 1/2",
    (1e-15, 0.49999999999999994),
    (9.999999717180685e-10, 0.4999999701976776),
)
_ALPHA_DOMAIN_3 = Domain(
    "alpha",
    "a number at least 1e-15 and below 1, in float32 at least 1e-9 and below 1",
    (1e-15, 0.9999999999999999),
    (9.999999717180685e-10, 0.9999999403953552),
)


class Coordinates(NamedTuple):
    """Result of `coordinates`."""

    margin: Real
    """4 - 2 alpha - beta, positive inside."""
    linear_coefficient: Real
    """X, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the constant one."""
    quadratic_coefficient: Real
    """Y, that of s^2."""


def coordinates(
    alpha: ArrayLike,
    beta: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> Coordinates:
    """How far gains are inside the region of stability.

        margin = 4 - 2 alpha - beta, stable where alpha, beta and margin are positive
        linear_coefficient = 2 alpha/beta, quadratic_coefficient = margin/beta

    alpha: gain of the position; a number at least 1e-30 and at most 0.9999999, in float32 at least
        1e-12 and at most 0.999999.
    beta: gain of the velocity times T; a number at least 1e-30 and at most 1.9999999, in float32 at
        least 1e-12 and at most 1.999999.

    margin: 4 - 2 alpha - beta, positive inside. Relative error at most 1.01 * 2^-52 (float64), 1.01
        * 2^-23 (float32), proved for every input.
    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one. Relative error at most 0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved
        for every input.
    quadratic_coefficient: y, that of s^2. Relative error at most 1.51 * 2^-52 (float64), 1.51 *
        2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and 1e-30 <= alpha <= 0.9999999
        and 1e-30 <= beta <= 1.9999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(Coordinates, _coordinates_of_numbers(alpha, beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Coordinates(*evaluate(_COORDINATES, (alpha, beta), out, workers))


def _coordinates_of_numbers(alpha: float, beta: float, _form: Form = Double) -> tuple[float, ...]:
    t7 = ((1.0 - alpha) * 2.0) + (2.0 - beta)
    t9 = (alpha * 2.0) / beta
    t10 = t7 / beta
    return (t7, t9, t10)


def _coordinates_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 2.0
) -> None:
    alpha, beta = given
    margin, linear_coefficient, quadratic_coefficient = out
    w0, w1 = work
    t3 = subtract(n0, alpha, w0)
    t5 = multiply(t3, n1, w0)
    t6 = subtract(n1, beta, w1)
    add(t5, t6, margin)
    t8 = multiply(alpha, n1, w0)
    divide(t8, beta, linear_coefficient)
    divide(margin, beta, quadratic_coefficient)


_COORDINATES = Signature(
    "coordinates",
    (_ALPHA_DOMAIN, _BETA_DOMAIN),
    ("margin", "linear_coefficient", "quadratic_coefficient"),
    2,
    _coordinates_block,
    numbers=_coordinates_of_numbers,
)


class GainsOfCoordinates(NamedTuple):
    """Result of `gains_of_coordinates`."""

    alpha: Real
    """Gain of the position."""
    beta: Real
    """Gain of the velocity times T."""


def gains_of_coordinates(
    linear_coefficient: ArrayLike,
    quadratic_coefficient: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> GainsOfCoordinates:
    """Gains of any stable alpha-beta filter from its coordinates.

        alpha = 2 x/(1 + x + y), beta = 4/(1 + x + y), all x > 0 and y > 0 are stable

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-60 and at most 1e60, in float32 at least 1e-9 and at most
        1e9.
    quadratic_coefficient: y, that of s^2; a number at least 1e-60 and at most 1e60, in float32 at
        least 1e-9 and at most 1e9.

    alpha: gain of the position. Relative error at most 1.51 * 2^-52 (float64), 1.51 * 2^-23
        (float32), proved for every input.
    beta: gain of the velocity times T. Relative error at most 1.51 * 2^-52 (float64), 1.51 * 2^-23
        (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(linear_coefficient) is float
        and type(quadratic_coefficient) is float
        and 1e-60 <= linear_coefficient <= 1e60
        and 1e-60 <= quadratic_coefficient <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                GainsOfCoordinates,
                _gains_of_coordinates_of_numbers(linear_coefficient, quadratic_coefficient),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainsOfCoordinates(
        *evaluate(_GAINS_OF_COORDINATES, (linear_coefficient, quadratic_coefficient), out, workers)
    )


def _gains_of_coordinates_of_numbers(
    linear_coefficient: float,
    quadratic_coefficient: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = (1.0 + linear_coefficient) + quadratic_coefficient
    t7 = (linear_coefficient * 2.0) / t4
    t9 = 4.0 / t4
    return (t7, t9)


def _gains_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
) -> None:
    linear_coefficient, quadratic_coefficient = given
    alpha, beta = out
    w0, w1 = work
    t3 = add(n0, linear_coefficient, w0)
    t4 = add(t3, quadratic_coefficient, w0)
    t6 = multiply(linear_coefficient, n1, w1)
    divide(t6, t4, alpha)
    divide(n2, t4, beta)


_GAINS_OF_COORDINATES = Signature(
    "gains_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _QUADRATIC_COEFFICIENT_DOMAIN),
    ("alpha", "beta"),
    2,
    _gains_of_coordinates_block,
    numbers=_gains_of_coordinates_of_numbers,
)


class Variances(NamedTuple):
    """Result of `variances`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_22: Real
    """Variance of the predicted velocity over sigma_v^2, times T^2."""
    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity over sigma_v^2, times T."""
    updated_22: Real
    """Variance of the updated velocity over sigma_v^2, times T^2."""


def variances(
    alpha: ArrayLike,
    beta: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> Variances:
    """Covariances under measurement noise alone, from the gains.

        predicted_11 = (2 alpha^2 + 2 beta + alpha beta)/(alpha margin),
        predicted_12 = beta (2 alpha + beta)/(alpha margin),
        predicted_22 = updated_22 = 2 beta^2/(alpha margin),
        updated_11 = (2 alpha^2 - 3 alpha beta + 2 beta)/(alpha margin),
        updated_12 = beta (2 alpha - beta)/(alpha margin), margin = 4 - 2 alpha - beta

    alpha: gain of the position; a number at least 1e-30 and at most 0.9999999, in float32 at least
        1e-12 and at most 0.999999.
    beta: gain of the velocity times T; a number at least 1e-30 and at most 1.9999999, in float32 at
        least 1e-12 and at most 1.999999.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 3.01 *
        2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    predicted_12: covariance of predicted position and velocity over sigma_v^2, times T. Relative
        error at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    predicted_22: variance of the predicted velocity over sigma_v^2, times T^2. Relative error at
        most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.
    updated_11: variance of the updated position over sigma_v^2. Relative error at most 5.33 * 2^-52
        (float64), 5.17 * 2^-23 (float32), proved for every input.
    updated_12: covariance of updated position and velocity over sigma_v^2, times T. Error over
        predicted_12 at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
        Cancellation, condition number 1: changes its sign at beta = 2 alpha. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 8e-8 in float64 and 0.003 in float32 of what its error is relative to; what cancels:
        2*beta/(2*(1 - alpha) + 2 - beta) - beta/alpha*beta/(2*(1 - alpha) + 2 - beta).
    updated_22: variance of the updated velocity over sigma_v^2, times T^2. Relative error at most
        2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and 1e-30 <= alpha <= 0.9999999
        and 1e-30 <= beta <= 1.9999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(Variances, _variances_of_numbers(alpha, beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Variances(*evaluate(_VARIANCES, (alpha, beta), out, workers))


def _variances_of_numbers(alpha: float, beta: float, _form: Form = Double) -> tuple[float, ...]:
    t3 = 1.0 - alpha
    t7 = (t3 * 2.0) + (2.0 - beta)
    t8 = beta / alpha
    t13 = (((alpha * 2.0) + (t8 * 2.0)) + beta) / t7
    t15 = (beta * 2.0) / t7
    t16 = t8 * beta
    t17 = t16 / t7
    t18 = t15 - t17
    t20 = (t16 * 2.0) / t7
    t21 = t15 + t17
    t25 = ((t3 * t3) * t13) + (alpha * alpha)
    return (t13, t21, t20, t25, t18, t20)


def _variances_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 2.0
) -> None:
    alpha, beta = given
    predicted_11, predicted_12, predicted_22, updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3 = work
    t3 = subtract(n0, alpha, w0)
    t5 = multiply(t3, n1, w1)
    t6 = subtract(n1, beta, w2)
    t7 = add(t5, t6, w1)
    t8 = divide(beta, alpha, updated_12)
    t9 = multiply(alpha, n1, w2)
    t10 = multiply(t8, n1, w3)
    t11 = add(t9, t10, w2)
    t12 = add(t11, beta, w2)
    divide(t12, t7, predicted_11)
    t14 = multiply(beta, n1, w2)
    t15 = divide(t14, t7, predicted_12)
    t16 = multiply(t8, beta, updated_12)
    t17 = divide(t16, t7, updated_11)
    t19 = multiply(t16, n1, w2)
    t22 = square(t3, w0)
    t23 = multiply(t22, predicted_11, w0)
    t24 = square(alpha, w3)
    subtract(t15, t17, updated_12)
    divide(t19, t7, predicted_22)
    add(t15, t17, predicted_12)
    add(t23, t24, updated_11)
    copyto(updated_22, predicted_22)


_VARIANCES = Signature(
    "variances",
    (_ALPHA_DOMAIN, _BETA_DOMAIN),
    ("predicted_11", "predicted_12", "predicted_22", "updated_11", "updated_12", "updated_22"),
    4,
    _variances_block,
    numbers=_variances_of_numbers,
)


class VariancesOfCoordinates(NamedTuple):
    """Result of `variances_of_coordinates`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_22: Real
    """Variance of the predicted velocity over sigma_v^2, times T^2."""
    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity over sigma_v^2, times T."""
    updated_22: Real
    """Variance of the updated velocity over sigma_v^2, times T^2."""


def variances_of_coordinates(
    linear_coefficient: ArrayLike,
    quadratic_coefficient: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> VariancesOfCoordinates:
    """Covariances under measurement noise alone, any stable filter.

        predicted_11 = ((1 + x)^2 + y)/(x y), predicted_12 = 2 (1 + x)/(x y),
        predicted_22 = updated_22 = 4/(x y),
        updated_11 = ((x - 1)^2 + y)/(x y), updated_12 = 2 (x - 1)/(x y)

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-60 and at most 1e60, in float32 at least 1e-9 and at most
        1e9.
    quadratic_coefficient: y, that of s^2; a number at least 1e-60 and at most 1e60, in float32 at
        least 1e-9 and at most 1e9.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 3.01 *
        2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    predicted_12: covariance of predicted position and velocity over sigma_v^2, times T. Relative
        error at most 1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
    predicted_22: variance of the predicted velocity over sigma_v^2, times T^2. Relative error at
        most 1.01 * 2^-52 (float64), 1.01 * 2^-23 (float32), proved for every input.
    updated_11: variance of the updated position over sigma_v^2. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.
    updated_12: covariance of updated position and velocity over sigma_v^2, times T. Error over
        predicted_12 at most 1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
        Digits that can be lost: up to 16 of 16 in float64, half or more only where 0.999934 <=
        linear_coefficient <= 1; up to 7 of 7 in float32, half or more only where 0.9 <=
        linear_coefficient <= 1.
    updated_22: variance of the updated velocity over sigma_v^2, times T^2. Relative error at most
        1.01 * 2^-52 (float64), 1.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(linear_coefficient) is float
        and type(quadratic_coefficient) is float
        and 1e-60 <= linear_coefficient <= 1e60
        and 1e-60 <= quadratic_coefficient <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                VariancesOfCoordinates,
                _variances_of_coordinates_of_numbers(linear_coefficient, quadratic_coefficient),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return VariancesOfCoordinates(
        *evaluate(
            _VARIANCES_OF_COORDINATES,
            (linear_coefficient, quadratic_coefficient),
            out,
            workers,
        )
    )


def _variances_of_coordinates_of_numbers(
    linear_coefficient: float,
    quadratic_coefficient: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = 1.0 + linear_coefficient
    t5 = linear_coefficient + -1.0
    t6 = linear_coefficient * quadratic_coefficient
    t9 = ((t3 * t3) + quadratic_coefficient) / t6
    t12 = (t3 * 2.0) / t6
    t14 = 4.0 / t6
    t17 = ((t5 * t5) + quadratic_coefficient) / t6
    t19 = (t5 * 2.0) / t6
    return (t9, t12, t14, t17, t19, t14)


def _variances_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = -1.0,
    n2: float = 2.0,
    n3: float = 4.0,
) -> None:
    linear_coefficient, quadratic_coefficient = given
    predicted_11, predicted_12, predicted_22, updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4 = work
    t3 = add(n0, linear_coefficient, w0)
    t5 = add(linear_coefficient, n1, w1)
    t6 = multiply(linear_coefficient, quadratic_coefficient, w2)
    t7 = square(t3, w3)
    t8 = add(t7, quadratic_coefficient, w3)
    t11 = multiply(t3, n2, w0)
    t15 = square(t5, w4)
    t16 = add(t15, quadratic_coefficient, w4)
    t18 = multiply(t5, n2, w1)
    divide(t8, t6, predicted_11)
    divide(t11, t6, predicted_12)
    divide(n3, t6, predicted_22)
    divide(t16, t6, updated_11)
    divide(t18, t6, updated_12)
    copyto(updated_22, predicted_22)


_VARIANCES_OF_COORDINATES = Signature(
    "variances_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _QUADRATIC_COEFFICIENT_DOMAIN),
    ("predicted_11", "predicted_12", "predicted_22", "updated_11", "updated_12", "updated_22"),
    5,
    _variances_of_coordinates_block,
    numbers=_variances_of_coordinates_of_numbers,
)


class ProcessNoiseVariances(NamedTuple):
    """Result of `process_noise_variances`."""

    predicted_11_by_q_11: Real
    """What q11 adds to predicted_11, over q11."""
    predicted_11_by_q_22: Real
    """What q22 adds to predicted_11, over q22."""
    predicted_12_by_q_11: Real
    """What q11 adds to predicted_12, over q11."""
    predicted_12_by_q_22: Real
    """What q22 adds to predicted_12, over q22."""
    predicted_22_by_q_11: Real
    """What q11 adds to predicted_22, over q11."""
    predicted_22_by_q_12: Real
    """What q12 adds to predicted_22, over q12."""
    updated_11_by_q_11: Real
    """What q11 adds to updated_11, over q11."""
    updated_11_by_q_22: Real
    """What q22 adds to updated_11, over q22."""
    updated_12_by_q_11: Real
    """What q11 adds to updated_12, over q11."""
    updated_12_by_q_22: Real
    """What q22 adds to updated_12, over q22."""
    updated_22_by_q_22: Real
    """What q22 adds to updated_22, over q22."""


def process_noise_variances(
    alpha: ArrayLike,
    beta: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> ProcessNoiseVariances:
    """What each entry of a process noise adds to covariances.

        with T = 1 (q12 is T times, q22 T^2 times what it is with units), added to the variances:
        predicted_11 = (q11 - q12) predicted_11_by_q_11 + q22 predicted_11_by_q_22,
        predicted_12 = (q11 - q12) predicted_12_by_q_11 + q22 predicted_12_by_q_22,
        predicted_22 = updated_22 + q22,
        updated_11 = (q11 - q12) updated_11_by_q_11 + q22 updated_11_by_q_22,
        updated_12 = (q11 - q12) updated_12_by_q_11 + q22 updated_12_by_q_22,
        updated_22 = q11 predicted_22_by_q_11 + q12 predicted_22_by_q_12
        + q22 updated_22_by_q_22

    alpha: gain of the position; a number at least 1e-30 and at most 0.9999999, in float32 at least
        1e-12 and at most 0.999999.
    beta: gain of the velocity times T; a number at least 1e-30 and at most 1.9999999, in float32 at
        least 1e-12 and at most 1.999999.

    predicted_11_by_q_11: what q11 adds to predicted_11, over q11. Relative error at most 2.01 *
        2^-52 (float64), 2.01 * 2^-23 (float32), proved for every input.
    predicted_11_by_q_22: what q22 adds to predicted_11, over q22. Relative error at most 3.01 *
        2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    predicted_12_by_q_11: what q11 adds to predicted_12, over q11. Relative error at most 2.01 *
        2^-52 (float64), 2.01 * 2^-23 (float32), proved for every input.
    predicted_12_by_q_22: what q22 adds to predicted_12, over q22. Relative error at most 3.68 *
        2^-52 (float64), 3.52 * 2^-23 (float32), proved for every input.
    predicted_22_by_q_11: what q11 adds to predicted_22, over q11. Relative error at most 3.01 *
        2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    predicted_22_by_q_12: what q12 adds to predicted_22, over q12. Relative error at most 3.18 *
        2^-52 (float64), 3.02 * 2^-23 (float32), proved for every input.
    updated_11_by_q_11: what q11 adds to updated_11, over q11. Relative error at most 4.01 * 2^-52
        (float64), 4.01 * 2^-23 (float32), proved for every input.
    updated_11_by_q_22: what q22 adds to updated_11, over q22. Relative error at most 5.01 * 2^-52
        (float64), 5.01 * 2^-23 (float32), proved for every input.
    updated_12_by_q_11: what q11 adds to updated_12, over q11. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.
    updated_12_by_q_22: what q22 adds to updated_12, over q22. Error over the sum of its terms'
        sizes at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input.
        Cancellation, condition number 1: changes its sign at beta = alpha (2 - alpha). Digits that
        can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the
        value is below 2e-7 in float64 and 0.004 in float32 of what its error is relative to; what
        cancels: (1 - alpha)*(2 - alpha)/(beta*(2*(1 - alpha) + 2 - beta)) - (1 -
        alpha)/(alpha*(2*(1 - alpha) + 2 - beta)).
    updated_22_by_q_22: what q22 adds to updated_22, over q22. Relative error at most 4.00 * 2^-52
        (float64), 3.92 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and 1e-30 <= alpha <= 0.9999999
        and 1e-30 <= beta <= 1.9999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(ProcessNoiseVariances, _process_noise_variances_of_numbers(alpha, beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ProcessNoiseVariances(*evaluate(_PROCESS_NOISE_VARIANCES, (alpha, beta), out, workers))


def _process_noise_variances_of_numbers(
    alpha: float,
    beta: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = 1.0 - alpha
    t5 = 2.0 - alpha
    t8 = (t3 * 2.0) + (2.0 - beta)
    t9 = beta / alpha
    t10 = alpha * t8
    t11 = beta * t8
    t12 = 2.0 / t10
    t14 = (t5 / alpha) / t11
    t15 = t9 * t3
    t16 = t5 + t15
    t28 = t3 * t3
    t17 = t16 / t11
    t23 = ((alpha * t5) + (t15 * 2.0)) / t11
    t27 = ((t3 * t5) / t11) - (t3 / t10)
    t29 = t9 / t8
    t31 = (t9 * t5) / t8
    t32 = -((t16 * 2.0) / t8)
    t33 = t28 * t12
    t34 = t28 * t14
    t36 = -(t15 / t8)
    return (t12, t14, t29, t17, t31, t32, t33, t34, t36, t27, t23)


def _process_noise_variances_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 2.0
) -> None:
    alpha, beta = given
    (
        predicted_11_by_q_11,
        predicted_11_by_q_22,
        predicted_12_by_q_11,
        predicted_12_by_q_22,
        predicted_22_by_q_11,
        predicted_22_by_q_12,
        updated_11_by_q_11,
        updated_11_by_q_22,
        updated_12_by_q_11,
        updated_12_by_q_22,
        updated_22_by_q_22,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    t3 = subtract(n0, alpha, w0)
    t5 = subtract(n1, alpha, w1)
    t6 = multiply(t3, n1, w2)
    t7 = subtract(n1, beta, w3)
    t8 = add(t6, t7, w2)
    t9 = divide(beta, alpha, predicted_12_by_q_11)
    t10 = multiply(alpha, t8, w3)
    t11 = multiply(beta, t8, w4)
    divide(n1, t10, predicted_11_by_q_11)
    t13 = divide(t5, alpha, predicted_11_by_q_22)
    divide(t13, t11, predicted_11_by_q_22)
    t15 = multiply(t9, t3, w5)
    t16 = add(t5, t15, w6)
    t18 = multiply(t16, n1, w7)
    t19 = divide(t18, t8, predicted_22_by_q_12)
    t20 = multiply(alpha, t5, w7)
    t21 = multiply(t15, n1, w8)
    t22 = add(t20, t21, w7)
    t24 = multiply(t3, t5, w8)
    t25 = divide(t24, t11, updated_12_by_q_22)
    t26 = divide(t3, t10, predicted_22_by_q_11)
    t28 = square(t3, w0)
    t30 = multiply(t9, t5, w1)
    t35 = divide(t15, t8, updated_12_by_q_11)
    divide(t16, t11, predicted_12_by_q_22)
    divide(t22, t11, updated_22_by_q_22)
    subtract(t25, t26, updated_12_by_q_22)
    divide(t9, t8, predicted_12_by_q_11)
    divide(t30, t8, predicted_22_by_q_11)
    negative(t19, predicted_22_by_q_12)
    multiply(t28, predicted_11_by_q_11, updated_11_by_q_11)
    multiply(t28, predicted_11_by_q_22, updated_11_by_q_22)
    negative(t35, updated_12_by_q_11)


_PROCESS_NOISE_VARIANCES = Signature(
    "process_noise_variances",
    (_ALPHA_DOMAIN, _BETA_DOMAIN),
    (
        "predicted_11_by_q_11",
        "predicted_11_by_q_22",
        "predicted_12_by_q_11",
        "predicted_12_by_q_22",
        "predicted_22_by_q_11",
        "predicted_22_by_q_12",
        "updated_11_by_q_11",
        "updated_11_by_q_22",
        "updated_12_by_q_11",
        "updated_12_by_q_22",
        "updated_22_by_q_22",
    ),
    9,
    _process_noise_variances_block,
    numbers=_process_noise_variances_of_numbers,
)


class ProcessNoiseVariancesOfCoordinates(NamedTuple):
    """Result of `process_noise_variances_of_coordinates`."""

    predicted_11_by_q_11: Real
    """What q11 adds to predicted_11, over q11."""
    predicted_11_by_q_22: Real
    """What q22 adds to predicted_11, over q22."""
    predicted_12_by_q_11: Real
    """What q11 adds to predicted_12, over q11."""
    predicted_12_by_q_22: Real
    """What q22 adds to predicted_12, over q22."""
    predicted_22_by_q_11: Real
    """What q11 adds to predicted_22, over q11."""
    predicted_22_by_q_12: Real
    """What q12 adds to predicted_22, over q12."""
    predicted_22_by_q_22: Real
    """What q22 adds to predicted_22, over q22."""


def process_noise_variances_of_coordinates(
    linear_coefficient: ArrayLike,
    quadratic_coefficient: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> ProcessNoiseVariancesOfCoordinates:
    """The same of the prediction, any stable filter.

        with T = 1 (q12 is T times, q22 T^2 times what it is with units), added to the variances:
        predicted_11 = (q11 - q12) predicted_11_by_q_11 + q22 predicted_11_by_q_22,
        predicted_12 = (q11 - q12) predicted_12_by_q_11 + q22 predicted_12_by_q_22,
        predicted_22 = q11 predicted_22_by_q_11 + q12 predicted_22_by_q_12
        + q22 predicted_22_by_q_22

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-60 and at most 1e60, in float32 at least 1e-9 and at most
        1e9.
    quadratic_coefficient: y, that of s^2; a number at least 1e-60 and at most 1e60, in float32 at
        least 1e-9 and at most 1e9.

    predicted_11_by_q_11: what q11 adds to predicted_11, over q11. Relative error at most 3.51 *
        2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input.
    predicted_11_by_q_22: what q22 adds to predicted_11, over q22. Relative error at most 4.51 *
        2^-52 (float64), 4.51 * 2^-23 (float32), proved for every input.
    predicted_12_by_q_11: what q11 adds to predicted_12, over q11. Relative error at most 2.01 *
        2^-52 (float64), 2.01 * 2^-23 (float32), proved for every input.
    predicted_12_by_q_22: what q22 adds to predicted_12, over q22. Relative error at most 3.51 *
        2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input.
    predicted_22_by_q_11: what q11 adds to predicted_22, over q11. Relative error at most 1.51 *
        2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
    predicted_22_by_q_12: what q12 adds to predicted_22, over q12. Relative error at most 2.01 *
        2^-52 (float64), 2.01 * 2^-23 (float32), proved for every input.
    predicted_22_by_q_22: what q22 adds to predicted_22, over q22. Relative error at most 3.01 *
        2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(linear_coefficient) is float
        and type(quadratic_coefficient) is float
        and 1e-60 <= linear_coefficient <= 1e60
        and 1e-60 <= quadratic_coefficient <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                ProcessNoiseVariancesOfCoordinates,
                _process_noise_variances_of_coordinates_of_numbers(
                    linear_coefficient, quadratic_coefficient
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ProcessNoiseVariancesOfCoordinates(
        *evaluate(
            _PROCESS_NOISE_VARIANCES_OF_COORDINATES,
            (linear_coefficient, quadratic_coefficient),
            out,
            workers,
        )
    )


def _process_noise_variances_of_coordinates_of_numbers(
    linear_coefficient: float,
    quadratic_coefficient: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = quadratic_coefficient + 1.0
    t4 = linear_coefficient + t3
    t5 = linear_coefficient * quadratic_coefficient
    t6 = t4 / t5
    t7 = t3 / t5
    t8 = t7 + 1.0
    t9 = t6 * t4
    t24 = ((t3 * t3) / t5) + (linear_coefficient + 4.0)
    t11 = t9 * 0.25
    t14 = (t9 * t3) * 0.0625
    t16 = t6 * 0.5
    t19 = (t4 * t8) * 0.125
    t20 = -t8
    t25 = t24 * 0.25
    return (t11, t14, t16, t19, t7, t20, t25)


def _process_noise_variances_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 4.0,
    n2: float = 0.25,
    n3: float = 0.0625,
    n4: float = 0.5,
    n5: float = 0.125,
) -> None:
    linear_coefficient, quadratic_coefficient = given
    (
        predicted_11_by_q_11,
        predicted_11_by_q_22,
        predicted_12_by_q_11,
        predicted_12_by_q_22,
        predicted_22_by_q_11,
        predicted_22_by_q_12,
        predicted_22_by_q_22,
    ) = out
    w0, w1 = work
    t3 = add(quadratic_coefficient, n0, w0)
    t4 = add(linear_coefficient, t3, predicted_12_by_q_22)
    t5 = multiply(linear_coefficient, quadratic_coefficient, w1)
    t6 = divide(t4, t5, predicted_12_by_q_11)
    divide(t3, t5, predicted_22_by_q_11)
    t8 = add(predicted_22_by_q_11, n0, predicted_22_by_q_12)
    t9 = multiply(t6, t4, predicted_11_by_q_11)
    t12 = multiply(t9, t3, predicted_11_by_q_22)
    t17 = multiply(t4, t8, predicted_12_by_q_22)
    t21 = square(t3, w0)
    t22 = divide(t21, t5, predicted_22_by_q_22)
    t23 = add(linear_coefficient, n1, w0)
    t24 = add(t22, t23, predicted_22_by_q_22)
    multiply(t9, n2, predicted_11_by_q_11)
    multiply(t12, n3, predicted_11_by_q_22)
    multiply(t6, n4, predicted_12_by_q_11)
    multiply(t17, n5, predicted_12_by_q_22)
    negative(t8, predicted_22_by_q_12)
    multiply(t24, n2, predicted_22_by_q_22)


_PROCESS_NOISE_VARIANCES_OF_COORDINATES = Signature(
    "process_noise_variances_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _QUADRATIC_COEFFICIENT_DOMAIN),
    (
        "predicted_11_by_q_11",
        "predicted_11_by_q_22",
        "predicted_12_by_q_11",
        "predicted_12_by_q_22",
        "predicted_22_by_q_11",
        "predicted_22_by_q_12",
        "predicted_22_by_q_22",
    ),
    2,
    _process_noise_variances_of_coordinates_block,
    numbers=_process_noise_variances_of_coordinates_of_numbers,
)


class Lags(NamedTuple):
    """Result of `lags`."""

    predicted_position_lag: Real
    """Truth less predicted position."""
    predicted_velocity_lag: Real
    """Truth less predicted velocity."""
    updated_position_lag: Real
    """Truth less updated position."""
    updated_velocity_lag: Real
    """Truth less updated velocity."""


def lags(
    alpha: ArrayLike,
    beta: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> Lags:
    """Steady errors behind a constant acceleration a, over a T^2 (positions) and a T.

        predicted_position_lag = 1/beta, predicted_velocity_lag = alpha/beta + 1/2,
        updated_position_lag = (1 - alpha)/beta, updated_velocity_lag = alpha/beta - 1/2;
        none behind rest and constant velocity; behind a jerk j the position error grows by
        j T^3/beta a sample

    alpha: gain of the position; a number at least 1e-30 and at most 0.9999999, in float32 at least
        1e-12 and at most 0.999999.
    beta: gain of the velocity times T; a number at least 1e-30 and at most 1.9999999, in float32 at
        least 1e-12 and at most 1.999999.

    predicted_position_lag: truth less predicted position. Relative error at most 0.51 * 2^-52
        (float64), 0.51 * 2^-23 (float32), proved for every input.
    predicted_velocity_lag: truth less predicted velocity. Relative error at most 1.01 * 2^-52
        (float64), 1.01 * 2^-23 (float32), proved for every input.
    updated_position_lag: truth less updated position. Relative error at most 1.01 * 2^-52
        (float64), 1.01 * 2^-23 (float32), proved for every input.
    updated_velocity_lag: truth less updated velocity. Error over predicted_velocity_lag at most
        1.01 * 2^-52 (float64), 1.01 * 2^-23 (float32), proved for every input. Cancellation,
        condition number 1: changes its sign at beta = 2 alpha. Digits that can be lost: up to 16 of
        16 in float64, half or more only where 0.499987 <= alpha/beta <= 0.500021; up to 7 of 7 in
        float32, half or more only where 0.49 <= alpha/beta <= 0.51; what cancels: 2*alpha/(2*beta)
        - beta/(2*beta).

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and 1e-30 <= alpha <= 0.9999999
        and 1e-30 <= beta <= 1.9999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(Lags, _lags_of_numbers(alpha, beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Lags(*evaluate(_LAGS, (alpha, beta), out, workers))


def _lags_of_numbers(alpha: float, beta: float, _form: Form = Double) -> tuple[float, ...]:
    t5 = beta * 2.0
    t7 = (alpha * 2.0) / t5
    t8 = beta / t5
    t9 = t7 - t8
    t10 = 1.0 / beta
    t11 = t7 + t8
    t12 = (1.0 - alpha) / beta
    return (t10, t11, t12, t9)


def _lags_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 2.0
) -> None:
    alpha, beta = given
    predicted_position_lag, predicted_velocity_lag, updated_position_lag, updated_velocity_lag = out
    w0, w1, w2 = work
    t3 = subtract(n0, alpha, w0)
    t5 = multiply(beta, n1, w1)
    t6 = multiply(alpha, n1, w2)
    t7 = divide(t6, t5, predicted_velocity_lag)
    t8 = divide(beta, t5, updated_position_lag)
    subtract(t7, t8, updated_velocity_lag)
    divide(n0, beta, predicted_position_lag)
    add(t7, t8, predicted_velocity_lag)
    divide(t3, beta, updated_position_lag)


_LAGS = Signature(
    "lags",
    (_ALPHA_DOMAIN, _BETA_DOMAIN),
    (
        "predicted_position_lag",
        "predicted_velocity_lag",
        "updated_position_lag",
        "updated_velocity_lag",
    ),
    3,
    _lags_block,
    numbers=_lags_of_numbers,
)


class ClosedLoopPoles(NamedTuple):
    """Result of `closed_loop_poles`."""

    half_sum: Real
    """Half the sum of the poles."""
    modulus: Real
    """Square root of the product of the poles, the modulus of a complex pair."""
    quarter_discriminant: Real
    """The square of half their difference, negative where they are complex."""


def closed_loop_poles(
    alpha: ArrayLike,
    beta: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> ClosedLoopPoles:
    """Closed-loop poles, half_sum +- sqrt(quarter_discriminant).

        half_sum = 1 - (alpha + beta)/2, modulus = sqrt(1 - alpha) (of a complex pair),
        quarter_discriminant = (alpha + beta)^2/4 - beta

    alpha: gain of the position; a number at least 1e-30 and at most 0.9999999, in float32 at least
        1e-12 and at most 0.999999.
    beta: gain of the velocity times T; a number at least 1e-30 and at most 1.9999999, in float32 at
        least 1e-12 and at most 1.999999.

    half_sum: half the sum of the poles. Error over the sum of its terms' sizes at most 0.80 * 2^-52
        (float64), 0.81 * 2^-23 (float32), proved for every input. Cancellation, condition number 1:
        changes its sign. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32;
        half or more only where the value is below 3e-8 in float64 and 0.0007 in float32 of what its
        error is relative to; what cancels: 1 - (alpha + beta)/2.
    modulus: square root of the product of the poles, the modulus of a complex pair. Relative error
        at most 0.76 * 2^-52 (float64), 0.76 * 2^-23 (float32), proved for every input.
    quarter_discriminant: the square of half their difference, negative where they are complex.
        Error over the sum of its terms' sizes at most 2.01 * 2^-52 (float64), 2.01 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: changes its sign where
        poles turn real. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32;
        half or more only where the value is below 6e-8 in float64 and 0.002 in float32 of what its
        error is relative to; what cancels: ((alpha + beta)/2)**2 - beta.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and 1e-30 <= alpha <= 0.9999999
        and 1e-30 <= beta <= 1.9999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(ClosedLoopPoles, _closed_loop_poles_of_numbers(alpha, beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ClosedLoopPoles(*evaluate(_CLOSED_LOOP_POLES, (alpha, beta), out, workers))


def _closed_loop_poles_of_numbers(
    alpha: float,
    beta: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = (alpha + beta) * 0.5
    t7 = 1.0 - t6
    t9 = (t6 * t6) - beta
    t10 = form.sqrt(1.0 - alpha)
    return (t7, t10, t9)


def _closed_loop_poles_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 0.5
) -> None:
    alpha, beta = given
    half_sum, modulus, quarter_discriminant = out
    w0, w1, w2 = work
    t3 = subtract(n0, alpha, w0)
    t4 = add(alpha, beta, w1)
    t6 = multiply(t4, n1, w1)
    t8 = square(t6, w2)
    subtract(n0, t6, half_sum)
    subtract(t8, beta, quarter_discriminant)
    sqrt(t3, modulus)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_ALPHA_DOMAIN, _BETA_DOMAIN),
    ("half_sum", "modulus", "quarter_discriminant"),
    3,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)


class MinimumVarianceByLag(NamedTuple):
    """Result of `minimum_variance_by_lag`."""

    minimum_variance_alpha: Real
    """Gain of the position, minimum variance."""
    minimum_variance_beta: Real
    """Gain of the velocity times T, minimum variance."""
    minimum_variance_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, minimum variance."""


def minimum_variance_by_lag(
    lag: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> MinimumVarianceByLag:
    """The stable filter of least position variance at a lag (MV).

        alpha + beta/2 = sqrt(beta), beta = 1/lag; with x = 2 sqrt(lag) - 1:
        minimum_variance_predicted_11 = (1 + 1/x)^2 - 1

    lag: 1/beta: lag of the predicted position behind a constant acceleration a over a T^2; a number
        above 1/4 and at most 1e30, in float32 above 1/4 and at most 1e9.

    minimum_variance_alpha: gain of the position, minimum variance. Relative error at most 2.51 *
        2^-52 (float64), 2.51 * 2^-23 (float32), proved for 0.25000000000000006 <= lag <= 1e30
        (float64) and 0.25000003 <= lag <= 1e09 (float32).
    minimum_variance_beta: gain of the velocity times T, minimum variance. Relative error at most
        0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for 0.25000000000000006 <= lag <=
        1e30 (float64) and 0.25000003 <= lag <= 1e09 (float32).
    minimum_variance_predicted_11: variance of the predicted position over sigma_v^2, minimum
        variance. Relative error at most 5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32), proved for
        0.25000000000000006 <= lag <= 1e30 (float64) and 0.25000003 <= lag <= 1e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if type(lag) is float and 0.25000000000000006 <= lag <= 1e30 and out is None and workers is ONE:
        try:
            return named(MinimumVarianceByLag, _minimum_variance_by_lag_of_numbers(lag))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MinimumVarianceByLag(*evaluate(_MINIMUM_VARIANCE_BY_LAG, (lag,), out, workers))


def _minimum_variance_by_lag_of_numbers(lag: float, form: Form = Double) -> tuple[float, ...]:
    t10 = ((lag * 4.0) + -1.0) / ((form.sqrt(lag) * 2.0) + 1.0)
    t12 = t10 / (lag * 2.0)
    t13 = 1.0 / lag
    t17 = (((t10 * 2.0) + 1.0) / t10) / t10
    return (t12, t13, t17)


def _minimum_variance_by_lag_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 4.0,
    n2: float = -1.0,
    n3: float = 1.0,
) -> None:
    (lag,) = given
    minimum_variance_alpha, minimum_variance_beta, minimum_variance_predicted_11 = out
    w0, w1 = work
    root = sqrt(lag, w0)
    t3 = multiply(root, n0, w0)
    t5 = multiply(lag, n1, w1)
    t8 = add(t5, n2, w1)
    t9 = add(t3, n3, w0)
    t10 = divide(t8, t9, minimum_variance_predicted_11)
    t11 = multiply(lag, n0, w0)
    t14 = multiply(t10, n0, w1)
    t15 = add(t14, n3, w1)
    t16 = divide(t15, t10, w1)
    divide(t10, t11, minimum_variance_alpha)
    divide(n3, lag, minimum_variance_beta)
    divide(t16, t10, minimum_variance_predicted_11)


_MINIMUM_VARIANCE_BY_LAG = Signature(
    "minimum_variance_by_lag",
    (_LAG_DOMAIN,),
    ("minimum_variance_alpha", "minimum_variance_beta", "minimum_variance_predicted_11"),
    2,
    _minimum_variance_by_lag_block,
    numbers=_minimum_variance_by_lag_of_numbers,
)


class MinimumSmoothedVarianceByLag(NamedTuple):
    """Result of `minimum_smoothed_variance_by_lag`."""

    minimum_smoothed_variance_alpha: Real
    """Gain of the position, minimum smoothed variance."""
    minimum_smoothed_variance_beta: Real
    """Gain of the velocity times T, minimum smoothed variance."""
    minimum_smoothed_variance_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, minimum smoothed variance."""
    minimum_smoothed_variance_updated_11: Real
    """Variance of the smoothed position over sigma_v^2, minimum smoothed variance."""


def minimum_smoothed_variance_by_lag(
    lag: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> MinimumSmoothedVarianceByLag:
    """The stable filter of least smoothed variance (NP-S).

        2 sqrt(beta) (1 - alpha) = 2 alpha - beta, beta = 1/lag; with n = 2 sqrt(lag):
        minimum_smoothed_variance_updated_11 = (2 n + 3)/(n + 1)^2,
        minimum_smoothed_variance_predicted_11 = (2 n^3 + 7 n^2 + 8 n + 2)/((n + 1)^2 (n^2 - 2));
        at a lag of 1/2 and below none smooths better than a single measurement

    lag: 1/beta: lag of the predicted position behind a constant acceleration a over a T^2; a number
        above 1/2 and at most 1e30, in float32 above 1/2 and at most 1e9.

    minimum_smoothed_variance_alpha: gain of the position, minimum smoothed variance. Relative error
        at most 2.52 * 2^-52 (float64), 2.52 * 2^-23 (float32), proved for 0.5000000000000001 <= lag
        <= 1e30 (float64) and 0.50000006 <= lag <= 1e09 (float32).
    minimum_smoothed_variance_beta: gain of the velocity times T, minimum smoothed variance.
        Relative error at most 0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for
        0.5000000000000001 <= lag <= 1e30 (float64) and 0.50000006 <= lag <= 1e09 (float32).
    minimum_smoothed_variance_predicted_11: variance of the predicted position over sigma_v^2,
        minimum smoothed variance. Relative error at most 6.04 * 2^-52 (float64), 6.04 * 2^-23
        (float32), proved for 0.5000000000000001 <= lag <= 1e30 (float64) and 0.50000006 <= lag <=
        1e09 (float32).
    minimum_smoothed_variance_updated_11: variance of the smoothed position over sigma_v^2, minimum
        smoothed variance. Relative error at most 2.52 * 2^-52 (float64), 2.52 * 2^-23 (float32),
        proved for 0.5000000000000001 <= lag <= 1e30 (float64) and 0.50000006 <= lag <= 1e09
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if type(lag) is float and 0.5000000000000001 <= lag <= 1e30 and out is None and workers is ONE:
        try:
            return named(
                MinimumSmoothedVarianceByLag, _minimum_smoothed_variance_by_lag_of_numbers(lag)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MinimumSmoothedVarianceByLag(
        *evaluate(_MINIMUM_SMOOTHED_VARIANCE_BY_LAG, (lag,), out, workers)
    )


def _minimum_smoothed_variance_by_lag_of_numbers(
    lag: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t1 = form.sqrt(lag)
    t3 = t1 * 2.0
    t5 = t3 + 1.0
    t6 = t5 * t5
    t17 = ((((t3 * 2.0) + 7.0) * t3) + 8.0) * t3
    t21 = t5 / (t1 * (t3 + 2.0))
    t22 = 1.0 / lag
    t24 = ((t17 + 2.0) / t6) / ((lag * 4.0) + -2.0)
    t27 = ((t5 * 2.0) + 1.0) / t6
    return (t21, t22, t24, t27)


def _minimum_smoothed_variance_by_lag_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 1.0,
    n2: float = 4.0,
    n3: float = -2.0,
    n4: float = 7.0,
    n5: float = 8.0,
) -> None:
    (lag,) = given
    (
        minimum_smoothed_variance_alpha,
        minimum_smoothed_variance_beta,
        minimum_smoothed_variance_predicted_11,
        minimum_smoothed_variance_updated_11,
    ) = out
    w0, w1, w2, w3, w4 = work
    root = sqrt(lag, minimum_smoothed_variance_alpha)
    t3 = multiply(root, n0, w0)
    t5 = add(t3, n1, w1)
    t6 = square(t5, w2)
    t8 = multiply(lag, n2, w3)
    t10 = add(t8, n3, w3)
    t11 = multiply(t3, n0, w4)
    t13 = add(t11, n4, w4)
    t14 = multiply(t13, t3, w4)
    t16 = add(t14, n5, w4)
    t17 = multiply(t16, t3, w4)
    t18 = add(t17, n0, w4)
    t19 = add(t3, n0, w0)
    t20 = multiply(root, t19, minimum_smoothed_variance_alpha)
    t23 = divide(t18, t6, minimum_smoothed_variance_predicted_11)
    t25 = multiply(t5, n0, w0)
    t26 = add(t25, n1, w0)
    divide(t5, t20, minimum_smoothed_variance_alpha)
    divide(n1, lag, minimum_smoothed_variance_beta)
    divide(t23, t10, minimum_smoothed_variance_predicted_11)
    divide(t26, t6, minimum_smoothed_variance_updated_11)


_MINIMUM_SMOOTHED_VARIANCE_BY_LAG = Signature(
    "minimum_smoothed_variance_by_lag",
    (_LAG_DOMAIN_2,),
    (
        "minimum_smoothed_variance_alpha",
        "minimum_smoothed_variance_beta",
        "minimum_smoothed_variance_predicted_11",
        "minimum_smoothed_variance_updated_11",
    ),
    5,
    _minimum_smoothed_variance_by_lag_block,
    numbers=_minimum_smoothed_variance_by_lag_of_numbers,
)


class RandomAccelerationByLag(NamedTuple):
    """Result of `random_acceleration_by_lag`."""

    random_acceleration_alpha: Real
    """Gain of the position, random acceleration."""
    random_acceleration_beta: Real
    """Gain of the velocity times T, random acceleration."""
    random_acceleration_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, random acceleration."""


def random_acceleration_by_lag(
    lag: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> RandomAccelerationByLag:
    """The random acceleration filter (RA) of a lag.

        (alpha + beta/2)^2 = 2 beta, beta = 1/lag; with x = sqrt(8 lag) - 1:
        random_acceleration_predicted_11 = (3 x + 1)/(x (x - 1))

    lag: 1/beta: lag of the predicted position behind a constant acceleration a over a T^2; a number
        above 1/2 and at most 1e30, in float32 above 1/2 and at most 1e9.

    random_acceleration_alpha: gain of the position, random acceleration. Relative error at most
        2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for 0.5000000000000001 <= lag <= 1e30
        (float64) and 0.50000006 <= lag <= 1e09 (float32).
    random_acceleration_beta: gain of the velocity times T, random acceleration. Relative error at
        most 0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for 0.5000000000000001 <= lag <=
        1e30 (float64) and 0.50000006 <= lag <= 1e09 (float32).
    random_acceleration_predicted_11: variance of the predicted position over sigma_v^2, random
        acceleration. Relative error at most 4.09 * 2^-52 (float64), 4.09 * 2^-23 (float32), proved
        for 0.5000000000000001 <= lag <= 1e30 (float64) and 0.50000006 <= lag <= 1e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if type(lag) is float and 0.5000000000000001 <= lag <= 1e30 and out is None and workers is ONE:
        try:
            return named(RandomAccelerationByLag, _random_acceleration_by_lag_of_numbers(lag))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RandomAccelerationByLag(*evaluate(_RANDOM_ACCELERATION_BY_LAG, (lag,), out, workers))


def _random_acceleration_by_lag_of_numbers(lag: float, form: Form = Double) -> tuple[float, ...]:
    t2 = lag * 8.0
    t3 = form.sqrt(t2)
    t8 = (t2 + -1.0) / (t3 + 1.0)
    t10 = lag * 2.0
    t16 = t8 / t10
    t21 = (((t8 * 3.0) + 1.0) / t8) / (((t10 + -1.0) * 4.0) / (t3 + 2.0))
    t22 = 1.0 / lag
    return (t16, t22, t21)


def _random_acceleration_by_lag_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = -1.0,
    n2: float = 1.0,
    n3: float = 2.0,
    n4: float = 4.0,
    n5: float = 3.0,
) -> None:
    (lag,) = given
    random_acceleration_alpha, random_acceleration_beta, random_acceleration_predicted_11 = out
    w0, w1 = work
    t2 = multiply(lag, n0, w0)
    root = sqrt(t2, random_acceleration_alpha)
    t6 = add(t2, n1, w0)
    t7 = add(root, n2, w1)
    t8 = divide(t6, t7, random_acceleration_predicted_11)
    t10 = multiply(lag, n3, w0)
    t11 = add(t10, n1, w1)
    t13 = multiply(t11, n4, w1)
    t14 = add(root, n3, random_acceleration_alpha)
    t15 = divide(t13, t14, random_acceleration_beta)
    t18 = multiply(t8, n5, w1)
    t19 = add(t18, n2, w1)
    t20 = divide(t19, t8, w1)
    divide(t8, t10, random_acceleration_alpha)
    divide(t20, t15, random_acceleration_predicted_11)
    divide(n2, lag, random_acceleration_beta)


_RANDOM_ACCELERATION_BY_LAG = Signature(
    "random_acceleration_by_lag",
    (_LAG_DOMAIN_2,),
    ("random_acceleration_alpha", "random_acceleration_beta", "random_acceleration_predicted_11"),
    2,
    _random_acceleration_by_lag_block,
    numbers=_random_acceleration_by_lag_of_numbers,
)


class RandomVelocityByLag(NamedTuple):
    """Result of `random_velocity_by_lag`."""

    random_velocity_alpha: Real
    """Gain of the position, random velocity."""
    random_velocity_beta: Real
    """Gain of the velocity times T, random velocity."""
    random_velocity_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, random velocity."""


def random_velocity_by_lag(
    lag: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> RandomVelocityByLag:
    """The random velocity filter (RV) of a lag, where it is stable.

        alpha (alpha + beta) = 2 beta, beta = 1/lag; with x = sqrt(8 lag + 1) - 1:
        random_velocity_predicted_11 = ((1 + x)^2 + y)/(x y), y = (x^2 - 2)/2

    lag: 1/beta: lag of the predicted position behind a constant acceleration a over a T^2; a number
        above 0.6036 and at most 1e30, in float32 above 0.6036 and at most 1e9.

    random_velocity_alpha: gain of the position, random velocity. Relative error at most 1.76 *
        2^-52 (float64), 1.76 * 2^-23 (float32), proved for 0.6036 <= lag <= 1e30 (float64) and
        0.6036 <= lag <= 1e09 (float32).
    random_velocity_beta: gain of the velocity times T, random velocity. Relative error at most 0.51
        * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for 0.6036 <= lag <= 1e30 (float64) and
        0.6036 <= lag <= 1e09 (float32).
    random_velocity_predicted_11: variance of the predicted position over sigma_v^2, random
        velocity. Relative error at most 8.43 * 2^-52 (float64), 8.43 * 2^-23 (float32), proved for
        0.6036 <= lag <= 1e30 (float64) and 0.6036 <= lag <= 1e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if type(lag) is float and 0.6036 <= lag <= 1e30 and out is None and workers is ONE:
        try:
            return named(RandomVelocityByLag, _random_velocity_by_lag_of_numbers(lag))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RandomVelocityByLag(*evaluate(_RANDOM_VELOCITY_BY_LAG, (lag,), out, workers))


def _random_velocity_by_lag_of_numbers(lag: float, form: Form = Double) -> tuple[float, ...]:
    t2 = lag * 4.0
    t4 = lag * 8.0
    t7 = form.sqrt(t4 + 1.0)
    t8 = t7 + 1.0
    t11 = (t2 + -2.414213562373095) + (
        9.500605813173024e-08 if form.single else -1.2537167179050217e-16
    )
    t16 = (t11 * (t2 + 0.41421356237309503)) / (t2 + t7)
    t20 = (((t7 * t7) + t16) / (t4 / t8)) / t16
    t21 = 4.0 / t8
    t22 = 1.0 / lag
    return (t21, t22, t20)


def _random_velocity_by_lag_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 4.0,
    n1: float = 8.0,
    n2: float = 1.0,
    n3: float = -2.414213562373095,
    n4: float = 9.500605813173024e-08,
    n5: float = -1.2537167179050217e-16,
    n6: float = 0.41421356237309503,
) -> None:
    (lag,) = given
    random_velocity_alpha, random_velocity_beta, random_velocity_predicted_11 = out
    w0, w1, w2, w3 = work
    t2 = multiply(lag, n0, w0)
    t4 = multiply(lag, n1, w1)
    t6 = add(t4, n2, w2)
    root = sqrt(t6, random_velocity_predicted_11)
    t8 = add(root, n2, w2)
    t9 = divide(t4, t8, random_velocity_alpha)
    rest = n4 if single else n5
    add(t2, n3, w1)
    t11 = add(w1, rest, w1)
    t13 = add(t2, n6, w3)
    t14 = multiply(t11, t13, w1)
    t15 = add(t2, root, w0)
    t16 = divide(t14, t15, random_velocity_beta)
    t17 = square(root, random_velocity_predicted_11)
    t18 = add(t17, t16, random_velocity_predicted_11)
    t19 = divide(t18, t9, random_velocity_predicted_11)
    divide(t19, t16, random_velocity_predicted_11)
    divide(n0, t8, random_velocity_alpha)
    divide(n2, lag, random_velocity_beta)


_RANDOM_VELOCITY_BY_LAG = Signature(
    "random_velocity_by_lag",
    (_LAG_DOMAIN_3,),
    ("random_velocity_alpha", "random_velocity_beta", "random_velocity_predicted_11"),
    4,
    _random_velocity_by_lag_block,
    numbers=_random_velocity_by_lag_of_numbers,
)


class MinimumVarianceByGain(NamedTuple):
    """Result of `minimum_variance_by_gain`."""

    slow_minimum_variance_beta: Real
    """Gain of the velocity times T, the minimum variance filter of smaller beta."""
    slow_minimum_variance_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, the minimum variance filter of smaller
    beta."""
    fast_minimum_variance_beta: Real
    """Gain of the velocity times T, the minimum variance filter of larger beta."""
    fast_minimum_variance_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, the minimum variance filter of larger
    beta."""


def minimum_variance_by_gain(
    alpha: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> MinimumVarianceByGain:
    """Both minimum variance filters (MV) of one position gain.

        (alpha + beta/2)^2 = beta: beta = (1 - m)^2 (slow), (1 + m)^2 (fast),
        m = sqrt(1 - 2 alpha)

    alpha: gain of the position; a number at least 1e-15 and below 1/2, in float32 at least 1e-9 and
        below 1/2.

    slow_minimum_variance_beta: gain of the velocity times T, the minimum variance filter of smaller
        beta. Relative error at most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32), proved for
        1e-15 <= alpha <= 0.49999999999999994 (float64) and 1e-09 <= alpha <= 0.49999997 (float32).
    slow_minimum_variance_predicted_11: variance of the predicted position over sigma_v^2, the
        minimum variance filter of smaller beta. Relative error at most 4.94 * 2^-52 (float64), 4.95
        * 2^-23 (float32), proved for 1e-15 <= alpha <= 0.49999999999999994 (float64) and 1e-09 <=
        alpha <= 0.49999997 (float32).
    fast_minimum_variance_beta: gain of the velocity times T, the minimum variance filter of larger
        beta. Relative error at most 2.26 * 2^-52 (float64), 2.26 * 2^-23 (float32), proved for
        1e-15 <= alpha <= 0.49999999999999994 (float64) and 1e-09 <= alpha <= 0.49999997 (float32).
    fast_minimum_variance_predicted_11: variance of the predicted position over sigma_v^2, the
        minimum variance filter of larger beta. Relative error at most 4.01 * 2^-52 (float64), 4.01
        * 2^-23 (float32), proved for 1e-15 <= alpha <= 0.49999999999999994 (float64) and 1e-09 <=
        alpha <= 0.49999997 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and 1e-15 <= alpha <= 0.49999999999999994
        and out is None
        and workers is ONE
    ):
        try:
            return named(MinimumVarianceByGain, _minimum_variance_by_gain_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MinimumVarianceByGain(*evaluate(_MINIMUM_VARIANCE_BY_GAIN, (alpha,), out, workers))


def _minimum_variance_by_gain_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t2 = alpha * 2.0
    t5 = form.sqrt(1.0 - t2)
    t6 = t5 + 1.0
    t7 = t2 / t6
    t13 = t6 * t6
    t9 = t7 * t7
    t14 = (t7 * (t5 + 3.0)) / t13
    t19 = (((1.0 - alpha) + t5) / alpha) * ((t6 + alpha) / alpha)
    return (t9, t14, t13, t19)


def _minimum_variance_by_gain_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 1.0,
    n2: float = 3.0,
) -> None:
    (alpha,) = given
    (
        slow_minimum_variance_beta,
        slow_minimum_variance_predicted_11,
        fast_minimum_variance_beta,
        fast_minimum_variance_predicted_11,
    ) = out
    w0, w1, w2 = work
    t2 = multiply(alpha, n0, w0)
    t4 = subtract(n1, t2, w1)
    root = sqrt(t4, slow_minimum_variance_beta)
    t6 = add(root, n1, w1)
    t7 = divide(t2, t6, slow_minimum_variance_predicted_11)
    t8 = subtract(n1, alpha, w0)
    t11 = add(root, n2, w2)
    t12 = multiply(t7, t11, w2)
    square(t6, fast_minimum_variance_beta)
    t15 = add(t8, root, w0)
    t16 = divide(t15, alpha, fast_minimum_variance_predicted_11)
    t17 = add(t6, alpha, w1)
    t18 = divide(t17, alpha, w1)
    square(t7, slow_minimum_variance_beta)
    divide(t12, fast_minimum_variance_beta, slow_minimum_variance_predicted_11)
    multiply(t16, t18, fast_minimum_variance_predicted_11)


_MINIMUM_VARIANCE_BY_GAIN = Signature(
    "minimum_variance_by_gain",
    (_ALPHA_DOMAIN_2,),
    (
        "slow_minimum_variance_beta",
        "slow_minimum_variance_predicted_11",
        "fast_minimum_variance_beta",
        "fast_minimum_variance_predicted_11",
    ),
    3,
    _minimum_variance_by_gain_block,
    numbers=_minimum_variance_by_gain_of_numbers,
)


class MinimumSmoothedVarianceByGain(NamedTuple):
    """Result of `minimum_smoothed_variance_by_gain`."""

    minimum_smoothed_variance_beta: Real
    """Gain of the velocity times T, minimum smoothed variance."""
    minimum_smoothed_variance_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, minimum smoothed variance."""
    minimum_smoothed_variance_updated_11: Real
    """Variance of the smoothed position over sigma_v^2, minimum smoothed variance."""


def minimum_smoothed_variance_by_gain(
    alpha: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> MinimumSmoothedVarianceByGain:
    """The filter of least smoothed variance (NP-S) of a position gain.

        beta = (2 alpha/(1 - alpha + v))^2, v = sqrt(1 + alpha^2), and with u = alpha/(1 + v):
        minimum_smoothed_variance_updated_11 = u (2 + u)

    alpha: gain of the position; a number at least 1e-15 and below 1, in float32 at least 1e-9 and
        below 1.

    minimum_smoothed_variance_beta: gain of the velocity times T, minimum smoothed variance.
        Relative error at most 4.26 * 2^-52 (float64), 4.26 * 2^-23 (float32), proved for 1e-15 <=
        alpha <= 0.9999999999999999 (float64) and 1e-09 <= alpha <= 0.99999994 (float32).
    minimum_smoothed_variance_predicted_11: variance of the predicted position over sigma_v^2,
        minimum smoothed variance. Relative error at most 8.26 * 2^-52 (float64), 8.28 * 2^-23
        (float32), proved for 1e-15 <= alpha <= 0.9999999999999999 (float64) and 1e-09 <= alpha <=
        0.99999994 (float32).
    minimum_smoothed_variance_updated_11: variance of the smoothed position over sigma_v^2, minimum
        smoothed variance. Relative error at most 2.78 * 2^-52 (float64), 2.78 * 2^-23 (float32),
        proved for 1e-15 <= alpha <= 0.9999999999999999 (float64) and 1e-09 <= alpha <= 0.99999994
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and 1e-15 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                MinimumSmoothedVarianceByGain, _minimum_smoothed_variance_by_gain_of_numbers(alpha)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MinimumSmoothedVarianceByGain(
        *evaluate(_MINIMUM_SMOOTHED_VARIANCE_BY_GAIN, (alpha,), out, workers)
    )


def _minimum_smoothed_variance_by_gain_of_numbers(
    alpha: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t1 = alpha * alpha
    t4 = form.sqrt(1.0 + t1)
    t5 = 1.0 - alpha
    t6 = t5 + t4
    t9 = (alpha * 2.0) / t6
    t10 = 1.0 + t4
    t11 = alpha / t10
    t19 = (((t6 * 2.0) + (alpha * 7.0)) * t6) + (t1 * 8.0)
    t24 = t11 * ((t19 * t6) + ((t1 * alpha) * 2.0))
    t28 = t24 / ((t5 * 2.0) * (t10 * t10))
    t29 = t9 * t9
    t31 = t11 * (t11 + 2.0)
    return (t29, t28, t31)


def _minimum_smoothed_variance_by_gain_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 7.0,
    n3: float = 8.0,
) -> None:
    (alpha,) = given
    (
        minimum_smoothed_variance_beta,
        minimum_smoothed_variance_predicted_11,
        minimum_smoothed_variance_updated_11,
    ) = out
    w0, w1, w2, w3, w4 = work
    t1 = square(alpha, w0)
    t3 = add(n0, t1, w1)
    root = sqrt(t3, minimum_smoothed_variance_predicted_11)
    t5 = subtract(n0, alpha, w1)
    t6 = add(t5, root, w2)
    t8 = multiply(alpha, n1, w3)
    t9 = divide(t8, t6, minimum_smoothed_variance_beta)
    t10 = add(n0, root, minimum_smoothed_variance_predicted_11)
    t11 = divide(alpha, t10, minimum_smoothed_variance_updated_11)
    t12 = multiply(t6, n1, w3)
    t14 = multiply(alpha, n2, w4)
    t15 = add(t12, t14, w3)
    t16 = multiply(t15, t6, w3)
    t18 = multiply(t1, n3, w4)
    t19 = add(t16, t18, w3)
    t20 = multiply(t19, t6, w3)
    t21 = multiply(t1, alpha, w0)
    t22 = multiply(t21, n1, w0)
    t23 = add(t20, t22, w3)
    t24 = multiply(t11, t23, w3)
    t25 = multiply(t5, n1, w1)
    t26 = square(t10, minimum_smoothed_variance_predicted_11)
    t27 = multiply(t25, t26, w1)
    t30 = add(t11, n1, w0)
    divide(t24, t27, minimum_smoothed_variance_predicted_11)
    square(t9, minimum_smoothed_variance_beta)
    multiply(t11, t30, minimum_smoothed_variance_updated_11)


_MINIMUM_SMOOTHED_VARIANCE_BY_GAIN = Signature(
    "minimum_smoothed_variance_by_gain",
    (_ALPHA_DOMAIN_3,),
    (
        "minimum_smoothed_variance_beta",
        "minimum_smoothed_variance_predicted_11",
        "minimum_smoothed_variance_updated_11",
    ),
    5,
    _minimum_smoothed_variance_by_gain_block,
    numbers=_minimum_smoothed_variance_by_gain_of_numbers,
)


class RandomAccelerationByGain(NamedTuple):
    """Result of `random_acceleration_by_gain`."""

    random_acceleration_beta: Real
    """Gain of the velocity times T, random acceleration."""
    random_acceleration_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, random acceleration."""


def random_acceleration_by_gain(
    alpha: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> RandomAccelerationByGain:
    """The stable random acceleration filter (RA) of a position gain.

        (alpha + beta/2)^2 = 2 beta: beta = 2 (1 - w)^2, w = sqrt(1 - alpha)

    alpha: gain of the position; a number at least 1e-15 and below 1, in float32 at least 1e-9 and
        below 1.

    random_acceleration_beta: gain of the velocity times T, random acceleration. Relative error at
        most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32), proved for 1e-15 <= alpha <=
        0.9999999999999999 (float64) and 1e-09 <= alpha <= 0.99999994 (float32).
    random_acceleration_predicted_11: variance of the predicted position over sigma_v^2, random
        acceleration. Relative error at most 4.76 * 2^-52 (float64), 4.76 * 2^-23 (float32), proved
        for 1e-15 <= alpha <= 0.9999999999999999 (float64) and 1e-09 <= alpha <= 0.99999994
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and 1e-15 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(RandomAccelerationByGain, _random_acceleration_by_gain_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RandomAccelerationByGain(*evaluate(_RANDOM_ACCELERATION_BY_GAIN, (alpha,), out, workers))


def _random_acceleration_by_gain_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t3 = form.sqrt(1.0 - alpha)
    t4 = t3 + 1.0
    t5 = alpha / t4
    t8 = (t5 * t5) * 2.0
    t12 = (t5 * (t3 + 2.0)) / (t3 * t4)
    return (t8, t12)


def _random_acceleration_by_gain_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 2.0
) -> None:
    (alpha,) = given
    random_acceleration_beta, random_acceleration_predicted_11 = out
    w0, w1, w2 = work
    t2 = subtract(n0, alpha, w0)
    root = sqrt(t2, random_acceleration_beta)
    t4 = add(root, n0, w0)
    t5 = divide(alpha, t4, random_acceleration_predicted_11)
    t6 = square(t5, w1)
    t9 = add(root, n1, w2)
    t10 = multiply(t5, t9, random_acceleration_predicted_11)
    t11 = multiply(root, t4, w0)
    multiply(t6, n1, random_acceleration_beta)
    divide(t10, t11, random_acceleration_predicted_11)


_RANDOM_ACCELERATION_BY_GAIN = Signature(
    "random_acceleration_by_gain",
    (_ALPHA_DOMAIN_3,),
    ("random_acceleration_beta", "random_acceleration_predicted_11"),
    3,
    _random_acceleration_by_gain_block,
    numbers=_random_acceleration_by_gain_of_numbers,
)


class RandomVelocityByGain(NamedTuple):
    """Result of `random_velocity_by_gain`."""

    random_velocity_beta: Real
    """Gain of the velocity times T, random velocity."""
    random_velocity_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, random velocity."""


def random_velocity_by_gain(
    alpha: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> RandomVelocityByGain:
    """The random velocity filter (RV) of a position gain.

        alpha (alpha + beta) = 2 beta: beta = alpha^2/(2 - alpha)

    alpha: gain of the position; a number at least 1e-15 and below 1, in float32 at least 1e-9 and
        below 1.

    random_velocity_beta: gain of the velocity times T, random velocity. Relative error at most 1.51
        * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for 1e-15 <= alpha <= 0.9999999999999999
        (float64) and 1e-09 <= alpha <= 0.99999994 (float32).
    random_velocity_predicted_11: variance of the predicted position over sigma_v^2, random
        velocity. Relative error at most 2.53 * 2^-52 (float64), 2.53 * 2^-23 (float32), proved for
        1e-15 <= alpha <= 0.9999999999999999 (float64) and 1e-09 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta
    """
    if (
        type(alpha) is float
        and 1e-15 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(RandomVelocityByGain, _random_velocity_by_gain_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RandomVelocityByGain(*evaluate(_RANDOM_VELOCITY_BY_GAIN, (alpha,), out, workers))


def _random_velocity_by_gain_of_numbers(alpha: float, _form: Form = Double) -> tuple[float, ...]:
    t5 = alpha * alpha
    t9 = t5 / (2.0 - alpha)
    t13 = (alpha * (6.0 - alpha)) / (((1.0 - alpha) * 8.0) + t5)
    return (t9, t13)


def _random_velocity_by_gain_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 8.0,
    n2: float = 2.0,
    n3: float = 6.0,
) -> None:
    (alpha,) = given
    random_velocity_beta, random_velocity_predicted_11 = out
    w0, w1, w2, w3 = work
    t2 = subtract(n0, alpha, w0)
    t4 = multiply(t2, n1, w0)
    t5 = square(alpha, w1)
    t6 = add(t4, t5, w0)
    t8 = subtract(n2, alpha, w2)
    t11 = subtract(n3, alpha, w3)
    t12 = multiply(alpha, t11, w3)
    divide(t5, t8, random_velocity_beta)
    divide(t12, t6, random_velocity_predicted_11)


_RANDOM_VELOCITY_BY_GAIN = Signature(
    "random_velocity_by_gain",
    (_ALPHA_DOMAIN_3,),
    ("random_velocity_beta", "random_velocity_predicted_11"),
    4,
    _random_velocity_by_gain_block,
    numbers=_random_velocity_by_gain_of_numbers,
)
