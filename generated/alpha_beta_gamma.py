# Made by: gainproof generate alpha-beta-gamma
# From: gainproof derive alpha-beta-gamma, SymPy 1.14.0
"""Alpha-beta-gamma filters with any gains."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, multiply, sqrt, square, subtract

from gainproof.generated._bits import near_cbrt
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
    "AccelerationNoiseVariances",
    "AccelerationNoiseVariancesOfCoordinates",
    "ClosedLoopPoles",
    "Coordinates",
    "GainsOfCoordinates",
    "JerkNoiseVariances",
    "JerkNoiseVariancesOfCoordinates",
    "Lags",
    "MinimumVarianceByLag",
    "RandomAccelerationByGain",
    "RandomAccelerationByLag",
    "RandomJerkByGain",
    "RandomJerkByLag",
    "UpdatedVariancesOfCoordinates",
    "Variances",
    "VariancesOfCoordinates",
    "WhiteJerkNoiseVariances",
    "WhiteJerkNoiseVariancesOfCoordinates",
    "acceleration_noise_variances",
    "acceleration_noise_variances_of_coordinates",
    "closed_loop_poles",
    "coordinates",
    "gains_of_coordinates",
    "jerk_noise_variances",
    "jerk_noise_variances_of_coordinates",
    "lags",
    "minimum_variance_by_lag",
    "random_acceleration_by_gain",
    "random_acceleration_by_lag",
    "random_jerk_by_gain",
    "random_jerk_by_lag",
    "updated_variances_of_coordinates",
    "variances",
    "variances_of_coordinates",
    "white_jerk_noise_variances",
    "white_jerk_noise_variances_of_coordinates",
]

_ALPHA_DOMAIN = Domain(
    "alpha",
    "a number at least 1e-20 and at most 0.999999, in float32 at least 1e-5 and at most 0.99999",
    (1e-20, 0.999999),
    (9.999999747378752e-06, 0.9999899864196777),
)
_BETA_DOMAIN = Domain(
    "beta",
    "a number at least 1e-20 and at most 1.9999999, in float32 at least 1e-5 and at most 1.99999",
    (1e-20, 1.9999999),
    (9.999999747378752e-06, 1.9999899864196777),
)
_SHARE_DOMAIN = Domain(
    "share",
    "a number at least 1e-20 and at most 0.999999, in float32 at least 1e-5 and at most 0.99999",
    (1e-20, 0.999999),
    (9.999999747378752e-06, 0.9999899864196777),
)
_LINEAR_COEFFICIENT_DOMAIN = Domain(
    "linear_coefficient",
    "a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4",
    (1e-20, 1e20),
    (9.999999747378752e-05, 10000.0),
)
_CUBIC_COEFFICIENT_DOMAIN = Domain(
    "cubic_coefficient",
    "a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4",
    (1e-20, 1e20),
    (9.999999747378752e-05, 10000.0),
)
_HURWITZ_DETERMINANT_DOMAIN = Domain(
    "hurwitz_determinant",
    "a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most 1e4",
    (1e-20, 1e20),
    (9.999999747378752e-05, 10000.0),
)
_ALPHA_DOMAIN_2 = Domain(
    "alpha",
    "a number at least 1e-20 and at most 2, in float32 at least 1e-4 and at most 2",
    (1e-20, 2.0),
    (9.999999747378752e-05, 2.0),
)
_BETA_DOMAIN_2 = Domain(
    "beta",
    "a number at least 1e-20 and at most 4, in float32 at least 1e-4 and at most 4",
    (1e-20, 4.0),
    (9.999999747378752e-05, 4.0),
)
_GAMMA_DOMAIN = Domain(
    "gamma",
    "a number at least 1e-20 and at most 8, in float32 at least 1e-4 and at most 8",
    (1e-20, 8.0),
    (9.999999747378752e-05, 8.0),
)
_LAG_DOMAIN = Domain(
    "lag",
    "a number above 1/8 and at most 1e30, in float32 above 1/8 and at most 1e9",
    (0.12500000000000003, 1e30),
    (0.1250000149011612, 1000000000.0),
)
_LAG_DOMAIN_2 = Domain(
    "lag",
    "a number above 1/2 and at most 1e30, in float32 above 1/2 and at most 1e9",
    (0.5000000000000001, 1e30),
    (0.5000000596046448, 1000000000.0),
)
_LAG_DOMAIN_3 = Domain(
    "lag",
    "a number above 69/128 and at most 1e30, in float32 above 69/128 and at most 1e9",
    (0.5390625000000001, 1e30),
    (0.5390625596046448, 1000000000.0),
)
_ALPHA_DOMAIN_3 = Domain(
    "alpha",
    "a number at least 1e-15 and below 1, in float32 at least 1e-6 and below 1",
    (1e-15, 0.9999999999999999),
    (9.999999974752427e-07, 0.9999999403953552),
)


class Coordinates(NamedTuple):
    """Result of `coordinates`."""

    gamma: Real
    """Gain of the acceleration times T^2."""
    margin: Real
    """4 - 2 alpha - beta, positive inside."""
    linear_coefficient: Real
    """X, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the constant one."""
    cubic_coefficient: Real
    """D, that of s^3."""
    hurwitz_determinant: Real
    """M = x y - d with y the coefficient of s^2."""


def coordinates(
    alpha: ArrayLike,
    beta: ArrayLike,
    share: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> Coordinates:
    """How far gains are inside the region of stability.

        gamma = 2 alpha beta share/(2 - alpha), margin = 4 - 2 alpha - beta,
        linear_coefficient = 2 beta/gamma, cubic_coefficient = 2 margin/gamma,
        hurwitz_determinant = 8 (alpha beta - gamma (1 - alpha/2))/gamma^2

    alpha: gain of the position; a number at least 1e-20 and at most 0.999999, in float32 at least
        1e-5 and at most 0.99999.
    beta: gain of the velocity times T; a number at least 1e-20 and at most 1.9999999, in float32 at
        least 1e-5 and at most 1.99999.
    share: gamma over its largest stable value 2 alpha beta/(2 - alpha); a number at least 1e-20 and
        at most 0.999999, in float32 at least 1e-5 and at most 0.99999.

    gamma: gain of the acceleration times T^2. Relative error at most 2.01 * 2^-52 (float64), 2.01 *
        2^-23 (float32), proved for every input.
    margin: 4 - 2 alpha - beta, positive inside. Relative error at most 1.01 * 2^-52 (float64), 1.01
        * 2^-23 (float32), proved for every input.
    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one. Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved
        for every input.
    cubic_coefficient: d, that of s^3. Relative error at most 3.51 * 2^-52 (float64), 3.51 * 2^-23
        (float32), proved for every input.
    hurwitz_determinant: m = x y - d with y the coefficient of s^2. Relative error at most 6.51 *
        2^-52 (float64), 6.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(share) is float
        and 1e-20 <= alpha <= 0.999999
        and 1e-20 <= beta <= 1.9999999
        and 1e-20 <= share <= 0.999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(Coordinates, _coordinates_of_numbers(alpha, beta, share))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Coordinates(*evaluate(_COORDINATES, (alpha, beta, share), out, workers))


def _coordinates_of_numbers(
    alpha: float,
    beta: float,
    share: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t10 = ((1.0 - alpha) * 2.0) + (2.0 - beta)
    t14 = (alpha * share) * ((beta * 2.0) / (2.0 - alpha))
    t15 = beta / t14
    t21 = ((alpha / t14) * t15) * (1.0 - share)
    t16 = t15 * 2.0
    t18 = (t10 * 2.0) / t14
    t23 = t21 * 8.0
    return (t14, t10, t16, t18, t23)


def _coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 8.0,
) -> None:
    alpha, beta, share = given
    gamma, margin, linear_coefficient, cubic_coefficient, hurwitz_determinant = out
    w0, w1, w2, w3 = work
    t4 = subtract(n0, alpha, w0)
    t6 = subtract(n1, alpha, w1)
    t7 = subtract(n0, share, w2)
    t8 = multiply(t4, n1, w0)
    t9 = subtract(n1, beta, w3)
    add(t8, t9, margin)
    t11 = multiply(beta, n1, w0)
    t12 = divide(t11, t6, gamma)
    t13 = multiply(alpha, share, w0)
    multiply(t13, t12, gamma)
    t15 = divide(beta, gamma, linear_coefficient)
    t17 = multiply(margin, n1, w0)
    t19 = divide(alpha, gamma, cubic_coefficient)
    t20 = multiply(t19, t15, cubic_coefficient)
    t21 = multiply(t20, t7, w2)
    multiply(t15, n1, linear_coefficient)
    divide(t17, gamma, cubic_coefficient)
    multiply(t21, n2, hurwitz_determinant)


_COORDINATES = Signature(
    "coordinates",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _SHARE_DOMAIN),
    ("gamma", "margin", "linear_coefficient", "cubic_coefficient", "hurwitz_determinant"),
    4,
    _coordinates_block,
    numbers=_coordinates_of_numbers,
)


class GainsOfCoordinates(NamedTuple):
    """Result of `gains_of_coordinates`."""

    alpha: Real
    """Gain of the position."""
    beta: Real
    """Gain of the velocity times T."""
    gamma: Real
    """Gain of the acceleration times T^2."""


def gains_of_coordinates(
    linear_coefficient: ArrayLike,
    cubic_coefficient: ArrayLike,
    hurwitz_determinant: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> GainsOfCoordinates:
    """Gains of any stable alpha-beta-gamma filter from its coordinates.

        alpha = 2 (1 + y)/n, beta = 4 x/n, gamma = 8/n, n = 1 + x + y + d, y = (d + m)/x,
        all x > 0, d > 0 and m > 0 are stable

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most
        1e4.
    cubic_coefficient: d, that of s^3; a number at least 1e-20 and at most 1e20, in float32 at least
        1e-4 and at most 1e4.
    hurwitz_determinant: m = x y - d with y the coefficient of s^2; a number at least 1e-20 and at
        most 1e20, in float32 at least 1e-4 and at most 1e4.

    alpha: gain of the position. Relative error at most 3.51 * 2^-52 (float64), 3.42 * 2^-23
        (float32), proved for every input.
    beta: gain of the velocity times T. Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23
        (float32), proved for every input.
    gamma: gain of the acceleration times T^2. Relative error at most 2.51 * 2^-52 (float64), 2.51 *
        2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(linear_coefficient) is float
        and type(cubic_coefficient) is float
        and type(hurwitz_determinant) is float
        and 1e-20 <= linear_coefficient <= 1e20
        and 1e-20 <= cubic_coefficient <= 1e20
        and 1e-20 <= hurwitz_determinant <= 1e20
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                GainsOfCoordinates,
                _gains_of_coordinates_of_numbers(
                    linear_coefficient, cubic_coefficient, hurwitz_determinant
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainsOfCoordinates(
        *evaluate(
            _GAINS_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
            workers,
        )
    )


def _gains_of_coordinates_of_numbers(
    linear_coefficient: float,
    cubic_coefficient: float,
    hurwitz_determinant: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = cubic_coefficient + hurwitz_determinant
    t4 = t3 / linear_coefficient
    t8 = ((1.0 + linear_coefficient) + t4) + cubic_coefficient
    t12 = ((1.0 + t4) * 2.0) / t8
    t15 = (linear_coefficient * 4.0) / t8
    t17 = 8.0 / t8
    return (t12, t15, t17)


def _gains_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = 8.0,
) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    alpha, beta, gamma = out
    w0, w1 = work
    t3 = add(cubic_coefficient, hurwitz_determinant, w0)
    t4 = divide(t3, linear_coefficient, alpha)
    t6 = add(n0, linear_coefficient, w0)
    t7 = add(t6, t4, w0)
    t8 = add(t7, cubic_coefficient, w0)
    t9 = add(n0, t4, alpha)
    t11 = multiply(t9, n1, alpha)
    t14 = multiply(linear_coefficient, n2, w1)
    divide(t11, t8, alpha)
    divide(t14, t8, beta)
    divide(n3, t8, gamma)


_GAINS_OF_COORDINATES = Signature(
    "gains_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _CUBIC_COEFFICIENT_DOMAIN, _HURWITZ_DETERMINANT_DOMAIN),
    ("alpha", "beta", "gamma"),
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
    predicted_13: Real
    """Covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Variance of the predicted acceleration over sigma_v^2, times T^4."""
    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity over sigma_v^2, times T."""
    updated_13: Real
    """Covariance of updated position and acceleration over sigma_v^2, times T^2."""
    updated_22: Real
    """Variance of the updated velocity over sigma_v^2, times T^2."""
    updated_23: Real
    """Covariance of updated velocity and acceleration over sigma_v^2, times T^3."""


def variances(
    alpha: ArrayLike,
    beta: ArrayLike,
    share: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> Variances:
    """Covariances under measurement noise alone, from the gains.

        gamma = 2 alpha beta share/(2 - alpha), margin = 4 - 2 alpha - beta,
        g = 2 alpha beta - gamma (2 - alpha),
        predicted_11 = 8 beta^2/((2 - alpha) g margin) + alpha/(2 - alpha),
        predicted_12 = beta (2 alpha + beta) (2 beta + gamma)/(g margin),
        predicted_13 = gamma (2 g + beta (2 beta + gamma))/(g margin),
        predicted_22 = 2 (2 beta^2 (beta + gamma) + gamma^2 (2 - alpha))/(g margin),
        predicted_23 = 2 beta gamma (2 beta + gamma)/(g margin),
        predicted_33 = 4 beta gamma^2/(g margin), also after the update,
        updated_11 = (1 - alpha)^2 predicted_11 + alpha^2,
        updated_12 = beta (2 alpha - beta) (2 beta - gamma)/(g margin),
        updated_13 = gamma (2 g - beta (2 beta - gamma))/(g margin),
        updated_22 = (beta (2 beta - gamma)^2 + gamma^2 margin)/(g margin),
        updated_23 = 2 beta gamma (2 beta - gamma)/(g margin)

    alpha: gain of the position; a number at least 1e-20 and at most 0.999999, in float32 at least
        1e-5 and at most 0.99999.
    beta: gain of the velocity times T; a number at least 1e-20 and at most 1.9999999, in float32 at
        least 1e-5 and at most 1.99999.
    share: gamma over its largest stable value 2 alpha beta/(2 - alpha); a number at least 1e-20 and
        at most 0.999999, in float32 at least 1e-5 and at most 0.99999.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 4.51 *
        2^-52 (float64), 4.51 * 2^-23 (float32), proved for every input.
    predicted_12: covariance of predicted position and velocity over sigma_v^2, times T. Relative
        error at most 5.50 * 2^-52 (float64), 5.50 * 2^-23 (float32), proved for every input.
    predicted_13: covariance of predicted position and acceleration over sigma_v^2, times T^2.
        Relative error at most 6.50 * 2^-52 (float64), 6.50 * 2^-23 (float32), proved for every
        input.
    predicted_22: variance of the predicted velocity over sigma_v^2, times T^2. Relative error at
        most 5.84 * 2^-52 (float64), 5.84 * 2^-23 (float32), proved for every input.
    predicted_23: covariance of predicted velocity and acceleration over sigma_v^2, times T^3.
        Relative error at most 6.00 * 2^-52 (float64), 6.00 * 2^-23 (float32), proved for every
        input.
    predicted_33: variance of the predicted acceleration over sigma_v^2, times T^4. Relative error
        at most 6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for every input.
    updated_11: variance of the updated position over sigma_v^2. Relative error at most 7.01 * 2^-52
        (float64), 7.01 * 2^-23 (float32), proved for every input.
    updated_12: covariance of updated position and velocity over sigma_v^2, times T. Error over the
        sum of its terms' sizes at most 7.00 * 2^-52 (float64), 7.00 * 2^-23 (float32), proved for
        every input. Cancellation, condition number 1: changes its sign. Digits that can be lost: up
        to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        2e-7 in float64 and 0.006 in float32 of what its error is relative to; what cancels:
        2*beta/(2 - alpha)*(2*(1 - alpha) + alpha*(1 - share))/((1 - share)*(2*(1 - alpha) + 2 -
        beta)) - beta/2*2*beta/(2 - alpha)*(2*(1 - alpha) + alpha*(1 - share))/(alpha*(1 -
        share)*(2*(1 - alpha) + 2 - beta)).
    updated_13: covariance of updated position and acceleration over sigma_v^2, times T^2. Error
        over the sum of its terms' sizes at most 8.00 * 2^-52 (float64), 8.00 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: changes its sign. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 3e-7 in float64 and 0.007 in float32 of what its error is relative to; what
        cancels: 2*alpha*share*2*beta/(2 - alpha)/(2*(1 - alpha) + 2 - beta) - beta*share/((2 -
        alpha)*(1 - share))*2*beta/(2 - alpha)*(2*(1 - alpha) + alpha*(1 - share))/(2*(1 - alpha) +
        2 - beta).
    updated_22: variance of the updated velocity over sigma_v^2, times T^2. Relative error at most
        10.00 * 2^-52 (float64), 10.00 * 2^-23 (float32), proved for every input.
    updated_23: covariance of updated velocity and acceleration over sigma_v^2, times T^3. Relative
        error at most 7.50 * 2^-52 (float64), 7.50 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(share) is float
        and 1e-20 <= alpha <= 0.999999
        and 1e-20 <= beta <= 1.9999999
        and 1e-20 <= share <= 0.999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(Variances, _variances_of_numbers(alpha, beta, share))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Variances(*evaluate(_VARIANCES, (alpha, beta, share), out, workers))


def _variances_of_numbers(
    alpha: float,
    beta: float,
    share: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = 1.0 - alpha
    t6 = 2.0 - alpha
    t7 = 1.0 - share
    t8 = t4 * 2.0
    t10 = t8 + (2.0 - beta)
    t11 = beta * 2.0
    t12 = t11 / t6
    t14 = (alpha * share) * t12
    t15 = alpha * t7
    t17 = t12 * (t8 + t15)
    t19 = share / (t6 * t7)
    t20 = t15 * t10
    t21 = t11 + t14
    t26 = (((beta * 4.0) / t20) + alpha) / t6
    t27 = beta * t19
    t29 = (t27 * t21) / t10
    t31 = (t27 * t17) / t10
    t41 = (t14 * 2.0) / t10
    t47 = t20 * 2.0
    t55 = ((beta * (beta + t14)) / t15) + (t14 * (share / t7))
    t34 = ((t27 * 4.0) * t14) / t10
    t42 = (t17 / (t7 * t10)) - (((beta * 0.5) * t17) / t20)
    t43 = t41 - t31
    t48 = (((alpha * 2.0) + beta) * t21) / t47
    t49 = t41 + t29
    t57 = (t55 * 2.0) / t10
    t58 = t29 * 2.0
    t62 = ((t4 * t4) * t26) + (alpha * alpha)
    t66 = ((t17 * t17) / t47) + (t14 * t19)
    t67 = t31 * 2.0
    return (t26, t48, t49, t57, t58, t34, t62, t42, t43, t66, t67)


def _variances_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = 0.5,
) -> None:
    alpha, beta, share = given
    (
        predicted_11,
        predicted_12,
        predicted_13,
        predicted_22,
        predicted_23,
        predicted_33,
        updated_11,
        updated_12,
        updated_13,
        updated_22,
        updated_23,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    t4 = subtract(n0, alpha, w0)
    t6 = subtract(n1, alpha, w1)
    t7 = subtract(n0, share, w2)
    t8 = multiply(t4, n1, w3)
    t9 = subtract(n1, beta, w4)
    t10 = add(t8, t9, w4)
    t11 = multiply(beta, n1, w5)
    t12 = divide(t11, t6, predicted_11)
    t13 = multiply(alpha, share, w6)
    t14 = multiply(t13, t12, w6)
    t15 = multiply(alpha, t7, w7)
    t16 = add(t8, t15, w3)
    t17 = multiply(t12, t16, w3)
    t18 = multiply(t6, t7, predicted_11)
    t19 = divide(share, t18, predicted_33)
    t20 = multiply(t15, t10, w8)
    t21 = add(t11, t14, w5)
    t23 = multiply(beta, n2, predicted_11)
    t24 = divide(t23, t20, updated_12)
    t25 = add(t24, alpha, updated_12)
    divide(t25, t6, predicted_11)
    t27 = multiply(beta, t19, w1)
    t28 = multiply(t27, t21, updated_12)
    t29 = divide(t28, t10, predicted_23)
    t30 = multiply(t27, t17, updated_12)
    t31 = divide(t30, t10, updated_23)
    t32 = multiply(t27, n2, w1)
    t33 = multiply(t32, t14, w1)
    t35 = multiply(t7, t10, updated_12)
    t36 = divide(t17, t35, updated_13)
    t37 = multiply(beta, n3, updated_12)
    t38 = multiply(t37, t17, updated_12)
    t39 = divide(t38, t20, predicted_12)
    t40 = multiply(t14, n1, updated_12)
    t41 = divide(t40, t10, predicted_13)
    t44 = multiply(alpha, n1, updated_12)
    t45 = add(t44, beta, updated_12)
    t46 = multiply(t45, t21, w5)
    t47 = multiply(t20, n1, w8)
    t50 = add(beta, t14, updated_12)
    t51 = multiply(beta, t50, updated_12)
    t52 = divide(t51, t15, predicted_22)
    t53 = divide(share, t7, updated_11)
    t54 = multiply(t14, t53, updated_11)
    t55 = add(t52, t54, predicted_22)
    t56 = multiply(t55, n1, predicted_22)
    t59 = square(t4, w0)
    t60 = multiply(t59, predicted_11, w0)
    t61 = square(alpha, w2)
    t63 = square(t17, w3)
    t64 = divide(t63, t47, updated_22)
    t65 = multiply(t14, t19, w6)
    divide(t33, t10, predicted_33)
    subtract(t36, t39, updated_12)
    subtract(t41, t31, updated_13)
    divide(t46, t47, predicted_12)
    add(t41, t29, predicted_13)
    divide(t56, t10, predicted_22)
    multiply(t29, n1, predicted_23)
    add(t60, t61, updated_11)
    add(t64, t65, updated_22)
    multiply(t31, n1, updated_23)


_VARIANCES = Signature(
    "variances",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _SHARE_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
        "updated_11",
        "updated_12",
        "updated_13",
        "updated_22",
        "updated_23",
    ),
    9,
    _variances_block,
    numbers=_variances_of_numbers,
)


class VariancesOfCoordinates(NamedTuple):
    """Result of `variances_of_coordinates`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_13: Real
    """Covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Variance of the predicted acceleration over sigma_v^2, times T^4."""


def variances_of_coordinates(
    linear_coefficient: ArrayLike,
    cubic_coefficient: ArrayLike,
    hurwitz_determinant: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> VariancesOfCoordinates:
    """Covariance of the prediction, any stable filter.

        predicted_11 = (1 + x + y + d) (x (1 + x) + m)/(d m) - 1, y = (d + m)/x,
        predicted_12 = 2 (1 + x) (x (1 + x) + d + m)/(d m),
        predicted_13 = 4 (x (1 + x) + m)/(d m),
        predicted_22 = 4 (d + x (1 + x)^2)/(d m), predicted_23 = 8 x (1 + x)/(d m),
        predicted_33 = 16 x/(d m)

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most
        1e4.
    cubic_coefficient: d, that of s^3; a number at least 1e-20 and at most 1e20, in float32 at least
        1e-4 and at most 1e4.
    hurwitz_determinant: m = x y - d with y the coefficient of s^2; a number at least 1e-20 and at
        most 1e20, in float32 at least 1e-4 and at most 1e4.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 5.51 *
        2^-52 (float64), 5.51 * 2^-23 (float32), proved for every input.
    predicted_12: covariance of predicted position and velocity over sigma_v^2, times T. Relative
        error at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input.
    predicted_13: covariance of predicted position and acceleration over sigma_v^2, times T^2.
        Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every
        input.
    predicted_22: variance of the predicted velocity over sigma_v^2, times T^2. Relative error at
        most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input.
    predicted_23: covariance of predicted velocity and acceleration over sigma_v^2, times T^3.
        Relative error at most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32), proved for every
        input.
    predicted_33: variance of the predicted acceleration over sigma_v^2, times T^4. Relative error
        at most 1.01 * 2^-52 (float64), 1.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(linear_coefficient) is float
        and type(cubic_coefficient) is float
        and type(hurwitz_determinant) is float
        and 1e-20 <= linear_coefficient <= 1e20
        and 1e-20 <= cubic_coefficient <= 1e20
        and 1e-20 <= hurwitz_determinant <= 1e20
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                VariancesOfCoordinates,
                _variances_of_coordinates_of_numbers(
                    linear_coefficient, cubic_coefficient, hurwitz_determinant
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return VariancesOfCoordinates(
        *evaluate(
            _VARIANCES_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
            workers,
        )
    )


def _variances_of_coordinates_of_numbers(
    linear_coefficient: float,
    cubic_coefficient: float,
    hurwitz_determinant: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = 1.0 + linear_coefficient
    t5 = linear_coefficient * t4
    t6 = cubic_coefficient * hurwitz_determinant
    t7 = t5 + hurwitz_determinant
    t8 = t5 * t4
    t10 = cubic_coefficient * (hurwitz_determinant + t8)
    t18 = (t4 * (t7 + cubic_coefficient)) * 2.0
    t14 = (t10 + (t7 * t7)) / (t6 * linear_coefficient)
    t19 = t18 / t6
    t22 = (t7 * 4.0) / t6
    t25 = ((cubic_coefficient + t8) * 4.0) / t6
    t28 = (t5 * 8.0) / t6
    t31 = (linear_coefficient * 16.0) / t6
    return (t14, t19, t22, t25, t28, t31)


def _variances_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = 8.0,
    n4: float = 16.0,
) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    t4 = add(n0, linear_coefficient, w0)
    t5 = multiply(linear_coefficient, t4, w1)
    t6 = multiply(cubic_coefficient, hurwitz_determinant, w2)
    t7 = add(t5, hurwitz_determinant, w3)
    t8 = multiply(t5, t4, w4)
    t9 = add(hurwitz_determinant, t8, w5)
    t10 = multiply(cubic_coefficient, t9, w5)
    t11 = square(t7, w6)
    t12 = add(t10, t11, w5)
    t13 = multiply(t6, linear_coefficient, w6)
    t15 = add(t7, cubic_coefficient, w7)
    t16 = multiply(t4, t15, w0)
    t18 = multiply(t16, n1, w0)
    t21 = multiply(t7, n2, w3)
    t23 = add(cubic_coefficient, t8, w4)
    t24 = multiply(t23, n2, w4)
    t27 = multiply(t5, n3, w1)
    t30 = multiply(linear_coefficient, n4, w7)
    divide(t12, t13, predicted_11)
    divide(t18, t6, predicted_12)
    divide(t21, t6, predicted_13)
    divide(t24, t6, predicted_22)
    divide(t27, t6, predicted_23)
    divide(t30, t6, predicted_33)


_VARIANCES_OF_COORDINATES = Signature(
    "variances_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _CUBIC_COEFFICIENT_DOMAIN, _HURWITZ_DETERMINANT_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    8,
    _variances_of_coordinates_block,
    numbers=_variances_of_coordinates_of_numbers,
)


class UpdatedVariancesOfCoordinates(NamedTuple):
    """Result of `updated_variances_of_coordinates`."""

    updated_12: Real
    """Covariance of updated position and velocity over sigma_v^2, times T."""
    updated_13: Real
    """Covariance of updated position and acceleration over sigma_v^2, times T^2."""
    updated_23: Real
    """Covariance of updated velocity and acceleration over sigma_v^2, times T^3."""
    updated_22: Real
    """Variance of the updated velocity over sigma_v^2, times T^2."""


def updated_variances_of_coordinates(
    linear_coefficient: ArrayLike,
    cubic_coefficient: ArrayLike,
    hurwitz_determinant: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdatedVariancesOfCoordinates:
    """What the update leaves of it, any stable filter.

        updated_12 = 2 x (x - 1) (1 + y - x)/(d m),
        updated_13 = 4 (m + x - x^2)/(d m),
        updated_22 = 4 x (x - 1)^2/(d m) + 4/m, updated_23 = 8 x (x - 1)/(d m), y = (d + m)/x;
        updated_33 is predicted_33, updated_11 is (1 - alpha)^2 predicted_11 + alpha^2

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most
        1e4.
    cubic_coefficient: d, that of s^3; a number at least 1e-20 and at most 1e20, in float32 at least
        1e-4 and at most 1e4.
    hurwitz_determinant: m = x y - d with y the coefficient of s^2; a number at least 1e-20 and at
        most 1e20, in float32 at least 1e-4 and at most 1e4.

    updated_12: covariance of updated position and velocity over sigma_v^2, times T. Error over the
        sum of its terms' sizes at most 4.51 * 2^-52 (float64), 4.50 * 2^-23 (float32), proved for
        every input. Cancellation, condition number 1: changes its sign. Digits that can be lost: up
        to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        2e-7 in float64 and 0.004 in float32 of what its error is relative to; what cancels:
        ((cubic_coefficient + hurwitz_determinant)/linear_coefficient + 1 +
        1)*linear_coefficient*2*linear_coefficient/(cubic_coefficient*hurwitz_determinant) -
        (linear_coefficient**2 + (cubic_coefficient + hurwitz_determinant)/linear_coefficient +
        1)*2*linear_coefficient/(cubic_coefficient*hurwitz_determinant).
    updated_13: covariance of updated position and acceleration over sigma_v^2, times T^2. Error
        over the sum of its terms' sizes at most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: changes its sign. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 6e-8 in float64 and 0.002 in float32 of what its error is relative to; what
        cancels: 4*(hurwitz_determinant +
        linear_coefficient)/(cubic_coefficient*hurwitz_determinant) -
        4*linear_coefficient**2/(cubic_coefficient*hurwitz_determinant).
    updated_23: covariance of updated velocity and acceleration over sigma_v^2, times T^3. Error
        over the sum of its terms' sizes at most 2.01 * 2^-52 (float64), 2.00 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: changes its sign. Digits that can
        be lost: up to 16 of 16 in float64, half or more only where 0.999824 <= linear_coefficient
        <= 1.00018; up to 7 of 7 in float32, half or more only where 0.9 <= linear_coefficient <=
        1.1; what cancels:
        8*linear_coefficient/(cubic_coefficient*hurwitz_determinant)*linear_coefficient -
        8*linear_coefficient/(cubic_coefficient*hurwitz_determinant).
    updated_22: variance of the updated velocity over sigma_v^2, times T^2. Relative error at most
        3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(linear_coefficient) is float
        and type(cubic_coefficient) is float
        and type(hurwitz_determinant) is float
        and 1e-20 <= linear_coefficient <= 1e20
        and 1e-20 <= cubic_coefficient <= 1e20
        and 1e-20 <= hurwitz_determinant <= 1e20
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UpdatedVariancesOfCoordinates,
                _updated_variances_of_coordinates_of_numbers(
                    linear_coefficient, cubic_coefficient, hurwitz_determinant
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedVariancesOfCoordinates(
        *evaluate(
            _UPDATED_VARIANCES_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
            workers,
        )
    )


def _updated_variances_of_coordinates_of_numbers(
    linear_coefficient: float,
    cubic_coefficient: float,
    hurwitz_determinant: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = cubic_coefficient + hurwitz_determinant
    t6 = (t3 / linear_coefficient) + 1.0
    t7 = cubic_coefficient * hurwitz_determinant
    t8 = linear_coefficient * linear_coefficient
    t11 = (linear_coefficient / t7) * 2.0
    t14 = ((t6 + 1.0) * linear_coefficient) * t11
    t17 = hurwitz_determinant + linear_coefficient
    t24 = linear_coefficient + -1.0
    t27 = (linear_coefficient * 8.0) / t7
    t29 = t14 - ((t8 + t6) * t11)
    t31 = ((t17 / t7) * 4.0) - ((t8 / t7) * 4.0)
    t33 = (t27 * linear_coefficient) - t27
    t39 = (((t27 * t24) * t24) * 0.5) + (4.0 / hurwitz_determinant)
    return (t29, t31, t33, t39)


def _updated_variances_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = -1.0,
    n4: float = 8.0,
    n5: float = 0.5,
) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    updated_12, updated_13, updated_23, updated_22 = out
    w0, w1, w2, w3, w4 = work
    t3 = add(cubic_coefficient, hurwitz_determinant, w0)
    t4 = divide(t3, linear_coefficient, updated_12)
    t6 = add(t4, n0, updated_12)
    t7 = multiply(cubic_coefficient, hurwitz_determinant, w0)
    t8 = square(linear_coefficient, w1)
    t9 = divide(linear_coefficient, t7, updated_13)
    t11 = multiply(t9, n1, updated_13)
    t12 = add(t6, n0, w2)
    t13 = multiply(t12, linear_coefficient, w2)
    t14 = multiply(t13, t11, w2)
    t15 = add(t8, t6, updated_12)
    t16 = multiply(t15, t11, updated_12)
    t17 = add(hurwitz_determinant, linear_coefficient, updated_13)
    t18 = divide(t17, t7, updated_23)
    t20 = multiply(t18, n2, updated_23)
    t21 = divide(t8, t7, updated_22)
    t22 = multiply(t21, n2, updated_22)
    t24 = add(linear_coefficient, n3, w1)
    t26 = multiply(linear_coefficient, n4, updated_13)
    t27 = divide(t26, t7, w0)
    t28 = multiply(t27, linear_coefficient, w3)
    t35 = multiply(t27, t24, updated_13)
    t36 = multiply(t35, t24, updated_13)
    t37 = multiply(t36, n5, w1)
    t38 = divide(n2, hurwitz_determinant, w4)
    subtract(t14, t16, updated_12)
    subtract(t20, t22, updated_13)
    subtract(t28, t27, updated_23)
    add(t37, t38, updated_22)


_UPDATED_VARIANCES_OF_COORDINATES = Signature(
    "updated_variances_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _CUBIC_COEFFICIENT_DOMAIN, _HURWITZ_DETERMINANT_DOMAIN),
    ("updated_12", "updated_13", "updated_23", "updated_22"),
    5,
    _updated_variances_of_coordinates_block,
    numbers=_updated_variances_of_coordinates_of_numbers,
)


class AccelerationNoiseVariances(NamedTuple):
    """Result of `acceleration_noise_variances`."""

    predicted_11: Real
    """Added to the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Added to the covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_13: Real
    """Added to the covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Added to the variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Added to the covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Added to the variance of the predicted acceleration over sigma_v^2, times T^4."""
    updated_11: Real
    """Added to the variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Added to the covariance of updated position and velocity over sigma_v^2, times T."""
    updated_13: Real
    """Added to the covariance of updated position and acceleration over sigma_v^2, times T^2."""
    updated_22: Real
    """Added to the variance of the updated velocity over sigma_v^2, times T^2."""
    updated_23: Real
    """Added to the covariance of updated velocity and acceleration over sigma_v^2, times T^3."""
    updated_33: Real
    """Added to the variance of the updated acceleration over sigma_v^2, times T^4."""


def acceleration_noise_variances(
    alpha: ArrayLike,
    beta: ArrayLike,
    share: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real]
    | None = None,
    workers: int = 1,
) -> AccelerationNoiseVariances:
    """What a process noise of the acceleration adds to covariances.

        D = F (I - K H) D (F (I - K H))' + Q with q = (sigma_w T^2/sigma_v)^2,
        Q = q (1/2, 1, 1)' (1/2, 1, 1);
        times q sigma_v^2 the entries are what the noise adds to the variances;
        of increments that act at the next sample (acceleration increments) all is the same but
        predicted_33, 1 more, and updated_33, which is predicted_33 here;
        with n = 1 + x + y + d, y = (d + m)/x,
        N = 64, a = 1, f = 0, h = 0, K = 1 + y, V = (1 + y)^2,
        predicted_11 = K n^2/(N m), predicted_13 = 4 n (a + K/m)/N,
        predicted_23 = 8 ((1 + x) V/m + a x + f)/N, predicted_33 = 16 (V/m + a x + h)/N
        and after the update (I - K H) D (I - K H)'; x, d and m are those of `coordinates`

    alpha: gain of the position; a number at least 1e-20 and at most 0.999999, in float32 at least
        1e-5 and at most 0.99999.
    beta: gain of the velocity times T; a number at least 1e-20 and at most 1.9999999, in float32 at
        least 1e-5 and at most 1.99999.
    share: gamma over its largest stable value 2 alpha beta/(2 - alpha); a number at least 1e-20 and
        at most 0.999999, in float32 at least 1e-5 and at most 0.99999.

    predicted_11: added to the variance of the predicted position over sigma_v^2. Relative error at
        most 5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32), proved for every input.
    predicted_12: added to the covariance of predicted position and velocity over sigma_v^2, times
        T. Relative error at most 6.01 * 2^-52 (float64), 6.01 * 2^-23 (float32), proved for every
        input.
    predicted_13: added to the covariance of predicted position and acceleration over sigma_v^2,
        times T^2. Relative error at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for
        every input.
    predicted_22: added to the variance of the predicted velocity over sigma_v^2, times T^2.
        Relative error at most 7.01 * 2^-52 (float64), 7.01 * 2^-23 (float32), proved for every
        input.
    predicted_23: added to the covariance of predicted velocity and acceleration over sigma_v^2,
        times T^3. Relative error at most 7.50 * 2^-52 (float64), 7.50 * 2^-23 (float32), proved for
        every input.
    predicted_33: added to the variance of the predicted acceleration over sigma_v^2, times T^4.
        Relative error at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for every
        input.
    updated_11: added to the variance of the updated position over sigma_v^2. Relative error at most
        6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for every input.
    updated_12: added to the covariance of updated position and velocity over sigma_v^2, times T.
        Error over the sum of its terms' sizes at most 6.51 * 2^-52 (float64), 6.51 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 2e-7 in float64 and 0.006 in float32 of what its error is relative
        to; what cancels: 4*alpha/(alpha*share*2*beta/(2 - alpha))*4*alpha*2*8*(1 -
        alpha)/(8*alpha*beta*(1 - share))/64 - 4*alpha/(alpha*share*2*beta/(2 -
        alpha))*2*beta*2*8*(1 - alpha)/(8*alpha*beta*(1 - share))/64.
    updated_13: added to the covariance of updated position and acceleration over sigma_v^2, times
        T^2. Error over the sum of its terms' sizes at most 4.01 * 2^-52 (float64), 4.01 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 2e-7 in float64 and 0.004 in float32 of what its error is relative
        to; what cancels: 4*1/(alpha*share*2*beta/(2 - alpha))*8*(1 - alpha)/64 -
        4*4*alpha/(8*alpha*beta*(1 - share))*8*(1 - alpha)/64.
    updated_22: added to the variance of the updated velocity over sigma_v^2, times T^2. Error over
        the sum of its terms' sizes at most 8.01 * 2^-52 (float64), 8.01 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: terms of both signs. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 3e-7 in float64 and 0.007 in float32 of what its error is relative to; what cancels:
        (4*alpha/(alpha*share*2*beta/(2 - alpha))*(4*alpha + 2*beta)*(4*alpha + 2*beta) + 2*(2*(1 -
        alpha) + 2 - beta)*(1*2*(2*(1 - alpha) + 2 - beta) + 1*2*beta))*4/(8*alpha*beta*(1 -
        share))/64 - 4*4*alpha/(alpha*share*2*beta/(2 - alpha))*4*alpha*2*beta*4/(8*alpha*beta*(1 -
        share))/64.
    updated_23: added to the covariance of updated velocity and acceleration over sigma_v^2, times
        T^3. Error over the sum of its terms' sizes at most 9.00 * 2^-52 (float64), 9.01 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 3e-7 in float64 and 0.008 in float32 of what its error is relative
        to; what cancels: 8*2*beta/(2 - alpha)*(2*(1 - alpha) + alpha*(1 -
        share))/(alpha*share*2*beta/(2 - alpha))*(4*alpha)**2/(8*alpha*beta*(1 - share))/64 -
        8*1*2*beta/(alpha*share*2*beta/(2 - alpha))/64.
    updated_33: added to the variance of the updated acceleration over sigma_v^2, times T^4. Error
        over the sum of its terms' sizes at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: terms of both signs. Digits that
        can be lost: up to 16 of 16 in float64, half or more only where alpha >= 5.6e-12 and share
        >= 0.0031; up to 7 of 7 in float32, half or more only where alpha >= 8.6e-5 and share >=
        0.11; what cancels: 16*((4*alpha)**2/(8*alpha*beta*(1 - share)) +
        1*2*beta/(alpha*share*2*beta/(2 - alpha)))/64 - 1*(1 - share + share).

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(share) is float
        and 1e-20 <= alpha <= 0.999999
        and 1e-20 <= beta <= 1.9999999
        and 1e-20 <= share <= 0.999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                AccelerationNoiseVariances,
                _acceleration_noise_variances_of_numbers(alpha, beta, share),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return AccelerationNoiseVariances(
        *evaluate(_ACCELERATION_NOISE_VARIANCES, (alpha, beta, share), out, workers)
    )


def _acceleration_noise_variances_of_numbers(
    alpha: float,
    beta: float,
    share: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = 1.0 - alpha
    t7 = 1.0 - share
    t8 = t4 * 2.0
    t11 = beta * 2.0
    t12 = t11 / (2.0 - alpha)
    t14 = (alpha * share) * t12
    t19 = alpha * 4.0
    t20 = (t8 + (2.0 - beta)) * 2.0
    t24 = ((alpha * beta) * t7) * 8.0
    t25 = t19 + t11
    t29 = (t19 * t25) / t14
    t30 = t19 / t14
    t31 = 8.0 / t24
    t37 = t11 * 1.0
    t39 = t20 * ((t20 * 1.0) + t37)
    t42 = (t19 * t19) / t24
    t43 = t37 / t14
    t51 = t19 / t24
    t52 = 1.0 / t14
    t60 = ((((t11 + t14) / t14) * t42) + t43) * 8.0
    t64 = ((t42 + t43) * 16.0) * 0.015625
    t65 = t4 * 8.0
    t67 = t65 / t24
    t72 = (t67 * 2.0) * 0.015625
    t73 = t30 * t19
    t79 = (4.0 / t24) * 0.015625
    t93 = ((t12 * (t8 + (alpha * t7))) / t14) * t42
    t35 = ((t30 * t31) * 8.0) * 0.015625
    t50 = ((t29 * 2.0) * t31) * 0.015625
    t56 = (((t51 + t52) * 8.0) * 4.0) * 0.015625
    t59 = ((((t29 * t25) + t39) * 4.0) / t24) * 0.015625
    t61 = t60 * 0.015625
    t70 = ((t30 * t67) * t65) * 0.015625
    t99 = (t73 * t72) - ((t30 * t11) * t72)
    t101 = (((t52 * t65) * 4.0) * 0.015625) - (((t51 * t65) * 4.0) * 0.015625)
    t103 = ((((t30 * t25) * t25) + t39) * t79) - (((t73 * t11) * 4.0) * t79)
    t105 = ((t93 * 8.0) * 0.015625) - ((t43 * 8.0) * 0.015625)
    t107 = t64 - ((t7 + share) * 1.0)
    return (t35, t50, t56, t59, t61, t64, t70, t99, t101, t103, t105, t107)


def _acceleration_noise_variances_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = 8.0,
    n4: float = 16.0,
    n5: float = 0.015625,
) -> None:
    alpha, beta, share = given
    (
        predicted_11,
        predicted_12,
        predicted_13,
        predicted_22,
        predicted_23,
        predicted_33,
        updated_11,
        updated_12,
        updated_13,
        updated_22,
        updated_23,
        updated_33,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12 = work
    t4 = subtract(n0, alpha, w0)
    t6 = subtract(n1, alpha, w1)
    t7 = subtract(n0, share, w2)
    t8 = multiply(t4, n1, w3)
    t9 = subtract(n1, beta, w4)
    t10 = add(t8, t9, w4)
    t11 = multiply(beta, n1, w5)
    t12 = divide(t11, t6, predicted_33)
    t13 = multiply(alpha, share, w1)
    t14 = multiply(t13, t12, w1)
    t15 = multiply(alpha, t7, w6)
    t16 = add(t8, t15, w3)
    t17 = multiply(t12, t16, w3)
    t19 = multiply(alpha, n2, w6)
    t20 = multiply(t10, n1, w4)
    t21 = multiply(alpha, beta, predicted_33)
    t22 = multiply(t21, t7, predicted_33)
    t24 = multiply(t22, n3, w7)
    t25 = add(t19, t11, w8)
    t26 = square(t19, predicted_33)
    t27 = add(t11, t14, w9)
    t28 = multiply(t19, t25, w10)
    t29 = divide(t28, t14, predicted_11)
    t30 = divide(t19, t14, predicted_12)
    t31 = divide(n3, t24, predicted_13)
    t32 = multiply(t30, t31, w10)
    t33 = multiply(t32, n3, w10)
    t36 = multiply(t20, n0, w11)
    t37 = multiply(t11, n0, w12)
    t38 = add(t36, t37, w11)
    t39 = multiply(t20, t38, w4)
    t40 = multiply(t29, t25, w11)
    t41 = add(t40, t39, w11)
    t42 = divide(t26, t24, predicted_22)
    t43 = divide(t37, t14, predicted_23)
    t44 = divide(t27, t14, updated_11)
    t45 = multiply(t44, t42, updated_11)
    t46 = add(t45, t43, updated_11)
    t47 = add(t42, t43, w9)
    t48 = multiply(t29, n1, predicted_11)
    t49 = multiply(t48, t31, predicted_13)
    t51 = divide(t19, t24, updated_12)
    t52 = divide(n0, t14, updated_13)
    t53 = add(t51, t52, w12)
    t54 = multiply(t53, n3, w12)
    t55 = multiply(t54, n2, w12)
    t57 = multiply(t41, n2, w11)
    t58 = divide(t57, t24, updated_22)
    t60 = multiply(t46, n3, updated_11)
    t63 = multiply(t47, n4, w9)
    multiply(t63, n5, predicted_33)
    t65 = multiply(t4, n3, w0)
    t66 = add(t7, share, w2)
    t67 = divide(t65, t24, updated_23)
    t68 = multiply(t30, t67, w9)
    t69 = multiply(t68, t65, w9)
    t71 = multiply(t67, n1, updated_23)
    t72 = multiply(t71, n5, updated_23)
    t73 = multiply(t30, t19, w6)
    t74 = multiply(t30, t11, w11)
    t75 = multiply(t30, t25, predicted_12)
    t76 = multiply(t75, t25, predicted_12)
    t77 = add(t76, t39, predicted_12)
    t78 = divide(n2, t24, updated_33)
    t79 = multiply(t78, n5, updated_33)
    t80 = multiply(t73, t72, w4)
    t81 = multiply(t74, t72, w11)
    t82 = multiply(t52, t65, updated_13)
    t83 = multiply(t82, n2, updated_13)
    t84 = multiply(t83, n5, updated_13)
    t85 = multiply(t51, t65, updated_12)
    t86 = multiply(t85, n2, updated_12)
    t87 = multiply(t86, n5, w0)
    t88 = multiply(t77, t79, w7)
    t89 = multiply(t73, t11, w6)
    t90 = multiply(t89, n2, w6)
    t91 = multiply(t90, t79, w6)
    t92 = divide(t17, t14, w3)
    t93 = multiply(t92, t42, w3)
    t94 = multiply(t93, n3, w3)
    t95 = multiply(t94, n5, w3)
    t96 = multiply(t43, n3, predicted_23)
    t97 = multiply(t96, n5, w1)
    t98 = multiply(t66, n0, w2)
    multiply(t33, n5, predicted_11)
    multiply(t49, n5, predicted_12)
    multiply(t55, n5, predicted_13)
    multiply(t58, n5, predicted_22)
    multiply(t60, n5, predicted_23)
    multiply(t69, n5, updated_11)
    subtract(t80, t81, updated_12)
    subtract(t84, t87, updated_13)
    subtract(t88, t91, updated_22)
    subtract(t95, t97, updated_23)
    subtract(predicted_33, t98, updated_33)


_ACCELERATION_NOISE_VARIANCES = Signature(
    "acceleration_noise_variances",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _SHARE_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
        "updated_11",
        "updated_12",
        "updated_13",
        "updated_22",
        "updated_23",
        "updated_33",
    ),
    13,
    _acceleration_noise_variances_block,
    numbers=_acceleration_noise_variances_of_numbers,
)


class JerkNoiseVariances(NamedTuple):
    """Result of `jerk_noise_variances`."""

    predicted_11: Real
    """Added to the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Added to the covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_13: Real
    """Added to the covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Added to the variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Added to the covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Added to the variance of the predicted acceleration over sigma_v^2, times T^4."""
    updated_11: Real
    """Added to the variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Added to the covariance of updated position and velocity over sigma_v^2, times T."""
    updated_13: Real
    """Added to the covariance of updated position and acceleration over sigma_v^2, times T^2."""
    updated_22: Real
    """Added to the variance of the updated velocity over sigma_v^2, times T^2."""
    updated_23: Real
    """Added to the covariance of updated velocity and acceleration over sigma_v^2, times T^3."""
    updated_33: Real
    """Added to the variance of the updated acceleration over sigma_v^2, times T^4."""


def jerk_noise_variances(
    alpha: ArrayLike,
    beta: ArrayLike,
    share: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real]
    | None = None,
    workers: int = 1,
) -> JerkNoiseVariances:
    """What a jerk that is constant over each interval adds to covariances.

        D = F (I - K H) D (F (I - K H))' + Q with q = (sigma_j T^3/sigma_v)^2,
        Q = q (1/6, 1/2, 1)' (1/6, 1/2, 1);
        times q sigma_v^2 the entries are what the noise adds to the variances;
        with n = 1 + x + y + d, y = (d + m)/x,
        N = 576, a = 9, f = 9, h = 18, K = 9 y + 6 + x/d,
        V = (1 + y) (9 y + 6) + 1 + x/d,
        predicted_11 = K n^2/(N m), predicted_13 = 4 n (a + K/m)/N,
        predicted_23 = 8 ((1 + x) V/m + a x + f)/N, predicted_33 = 16 (V/m + a x + h)/N
        and after the update (I - K H) D (I - K H)'; x, d and m are those of `coordinates`

    alpha: gain of the position; a number at least 1e-20 and at most 0.999999, in float32 at least
        1e-5 and at most 0.99999.
    beta: gain of the velocity times T; a number at least 1e-20 and at most 1.9999999, in float32 at
        least 1e-5 and at most 1.99999.
    share: gamma over its largest stable value 2 alpha beta/(2 - alpha); a number at least 1e-20 and
        at most 0.999999, in float32 at least 1e-5 and at most 0.99999.

    predicted_11: added to the variance of the predicted position over sigma_v^2. Relative error at
        most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for every input.
    predicted_12: added to the covariance of predicted position and velocity over sigma_v^2, times
        T. Relative error at most 11.01 * 2^-52 (float64), 11.01 * 2^-23 (float32), proved for every
        input.
    predicted_13: added to the covariance of predicted position and acceleration over sigma_v^2,
        times T^2. Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for
        every input.
    predicted_22: added to the variance of the predicted velocity over sigma_v^2, times T^2.
        Relative error at most 11.51 * 2^-52 (float64), 11.51 * 2^-23 (float32), proved for every
        input.
    predicted_23: added to the covariance of predicted velocity and acceleration over sigma_v^2,
        times T^3. Relative error at most 15.50 * 2^-52 (float64), 15.50 * 2^-23 (float32), proved
        for every input.
    predicted_33: added to the variance of the predicted acceleration over sigma_v^2, times T^4.
        Relative error at most 11.00 * 2^-52 (float64), 11.00 * 2^-23 (float32), proved for every
        input.
    updated_11: added to the variance of the updated position over sigma_v^2. Relative error at most
        11.51 * 2^-52 (float64), 11.51 * 2^-23 (float32), proved for every input.
    updated_12: added to the covariance of updated position and velocity over sigma_v^2, times T.
        Error over the sum of its terms' sizes at most 11.51 * 2^-52 (float64), 11.51 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 3e-7 in float64 and 0.01 in float32 of what its error is relative
        to.
    updated_13: added to the covariance of updated position and acceleration over sigma_v^2, times
        T^2. Error over the sum of its terms' sizes at most 8.51 * 2^-52 (float64), 8.51 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 3e-7 in float64 and 0.007 in float32 of what its error is relative
        to; what cancels: 4*9/(alpha*share*2*beta/(2 - alpha))*8*(1 - alpha)/576 -
        4*(2*alpha*(beta*(1 - share) + 2*(1 - alpha) + 2 - beta)/(2 - alpha)*9 +
        6*alpha*share*2*beta/(2 - alpha) + 1*2*beta/(2*(2*(1 - alpha) + 2 -
        beta))*alpha*share*2*beta/(2 - alpha))/(8*alpha*beta*(1 - share))*8*(1 - alpha)/576.
    updated_22: added to the variance of the updated velocity over sigma_v^2, times T^2. Error over
        the sum of its terms' sizes at most 14.00 * 2^-52 (float64), 14.00 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: terms of both signs. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 4e-7 in float64 and 0.02 in float32 of what its error is relative to.
    updated_23: added to the covariance of updated velocity and acceleration over sigma_v^2, times
        T^3. Error over the sum of its terms' sizes at most 17.00 * 2^-52 (float64), 17.00 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 5e-7 in float64 and 0.02 in float32 of what its error is relative
        to.
    updated_33: added to the variance of the updated acceleration over sigma_v^2, times T^4. Error
        over the sum of its terms' sizes at most 11.00 * 2^-52 (float64), 11.00 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: terms of both signs. Digits that
        can be lost: up to 16 of 16 in float64, half or more only where alpha >= 5.6e-12 and share
        >= 0.0031; up to 7 of 7 in float32, half or more only where alpha >= 4.2e-5 and share >=
        0.056.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(share) is float
        and 1e-20 <= alpha <= 0.999999
        and 1e-20 <= beta <= 1.9999999
        and 1e-20 <= share <= 0.999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(JerkNoiseVariances, _jerk_noise_variances_of_numbers(alpha, beta, share))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return JerkNoiseVariances(*evaluate(_JERK_NOISE_VARIANCES, (alpha, beta, share), out, workers))


def _jerk_noise_variances_of_numbers(
    alpha: float,
    beta: float,
    share: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = 1.0 - alpha
    t6 = 2.0 - alpha
    t7 = 1.0 - share
    t8 = t4 * 2.0
    t10 = t8 + (2.0 - beta)
    t11 = beta * 2.0
    t12 = t11 / t6
    t14 = (alpha * share) * t12
    t17 = t12 * (t8 + (alpha * t7))
    t19 = alpha * 4.0
    t24 = ((alpha * 2.0) * ((beta * t7) + t10)) / t6
    t25 = t10 * 2.0
    t29 = ((alpha * beta) * t7) * 8.0
    t30 = t19 + t11
    t35 = (t24 * 9.0) + (6.0 * t14)
    t37 = (t11 * 1.0) / t25
    t39 = t37 + 1.0
    t44 = t35 + (t37 * t14)
    t45 = t11 + t14
    t47 = (t35 * t30) / t14
    t48 = t44 / t14
    t49 = 8.0 / t29
    t57 = t25 * ((t25 * 9.0) + (t11 * 6.0))
    t58 = t14 * 1.0
    t65 = (t19 * t14) * 1.0
    t69 = (t47 * t30) + (t57 + (((t45 * t45) * t39) + t65))
    t70 = ((t19 * t35) + ((t39 * t14) * t14)) / t29
    t72 = (t11 * 9.0) / t14
    t76 = t70 + t72
    t78 = ((t47 + (t58 + (t37 * t45))) * 2.0) * t49
    t80 = t44 / t29
    t81 = 9.0 / t14
    t90 = ((((t45 / t14) * t70) + t72) + 9.0) * 8.0
    t97 = t4 * 8.0
    t99 = t97 / t29
    t103 = t35 / t14
    t105 = (t99 * 2.0) / 576.0
    t106 = t103 * t19
    t117 = ((t103 * t30) * t30) + (t57 + (((t17 * t17) * t39) + t65))
    t119 = (4.0 / t29) / 576.0
    t136 = ((((t17 / t14) * t70) + 9.0) * 8.0) / 576.0
    t53 = ((t48 * t49) * 8.0) / 576.0
    t79 = t78 / 576.0
    t85 = (((t80 + t81) * 8.0) * 4.0) / 576.0
    t88 = ((t69 * 4.0) / t29) / 576.0
    t91 = t90 / 576.0
    t96 = ((t76 + 18.0) * 16.0) / 576.0
    t102 = ((t48 * t99) * t97) / 576.0
    t143 = ((t106 + t58) * t105) - (((t103 * t11) + (t37 * t17)) * t105)
    t145 = (((t81 * t97) * 4.0) / 576.0) - (((t80 * t97) * 4.0) / 576.0)
    t147 = (t117 * t119) - (((t106 * t11) * 4.0) * t119)
    t149 = t136 - ((t72 * 8.0) / 576.0)
    t151 = ((t76 * 16.0) / 576.0) - ((t7 + share) * 0.5)
    return (t53, t79, t85, t88, t91, t96, t102, t143, t145, t147, t149, t151)


def _jerk_noise_variances_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = 8.0,
    n4: float = 9.0,
    n5: float = 6.0,
    n6: float = 18.0,
    n7: float = 16.0,
    n8: float = 576.0,
    n9: float = 0.5,
) -> None:
    alpha, beta, share = given
    (
        predicted_11,
        predicted_12,
        predicted_13,
        predicted_22,
        predicted_23,
        predicted_33,
        updated_11,
        updated_12,
        updated_13,
        updated_22,
        updated_23,
        updated_33,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16, w17 = work
    t4 = subtract(n0, alpha, w0)
    t6 = subtract(n1, alpha, w1)
    t7 = subtract(n0, share, w2)
    t8 = multiply(t4, n1, w3)
    t9 = subtract(n1, beta, w4)
    t10 = add(t8, t9, w4)
    t11 = multiply(beta, n1, w5)
    t12 = divide(t11, t6, predicted_11)
    t13 = multiply(alpha, share, w6)
    t14 = multiply(t13, t12, w6)
    t15 = multiply(alpha, t7, w7)
    t16 = add(t8, t15, w3)
    t17 = multiply(t12, t16, predicted_11)
    t19 = multiply(alpha, n2, w3)
    t20 = multiply(alpha, n1, w7)
    t21 = multiply(beta, t7, w8)
    t22 = add(t21, t10, w8)
    t23 = multiply(t20, t22, w7)
    t24 = divide(t23, t6, predicted_12)
    t25 = multiply(t10, n1, w4)
    t26 = multiply(alpha, beta, w1)
    t27 = multiply(t26, t7, w1)
    t29 = multiply(t27, n3, w1)
    t30 = add(t19, t11, w7)
    t32 = multiply(t24, n4, predicted_12)
    t34 = multiply(n5, t14, w8)
    t35 = add(t32, t34, predicted_12)
    t36 = multiply(t11, n0, w8)
    t37 = divide(t36, t25, predicted_13)
    t38 = multiply(t19, t35, w8)
    t39 = add(t37, n0, w9)
    t40 = multiply(t39, t14, w10)
    t41 = multiply(t40, t14, w10)
    t42 = add(t38, t41, w8)
    t43 = multiply(t37, t14, w10)
    t44 = add(t35, t43, w10)
    t45 = add(t11, t14, w11)
    t46 = multiply(t35, t30, w12)
    t47 = divide(t46, t14, predicted_22)
    t48 = divide(t44, t14, predicted_23)
    t49 = divide(n3, t29, predicted_33)
    t50 = multiply(t48, t49, w12)
    t51 = multiply(t50, n3, w12)
    t54 = multiply(t25, n4, w13)
    t55 = multiply(t11, n5, w14)
    t56 = add(t54, t55, w13)
    t57 = multiply(t25, t56, w4)
    t58 = multiply(t14, n0, w13)
    t59 = multiply(t37, t45, w14)
    t60 = add(t58, t59, w14)
    t61 = add(t47, t60, w14)
    t62 = square(t45, w15)
    t63 = multiply(t62, t39, w15)
    t64 = multiply(t19, t14, w16)
    t65 = multiply(t64, n0, w16)
    t66 = add(t63, t65, w15)
    t67 = add(t57, t66, w15)
    t68 = multiply(t47, t30, predicted_22)
    t69 = add(t68, t67, predicted_22)
    t70 = divide(t42, t29, updated_11)
    t71 = multiply(t11, n4, w8)
    t72 = divide(t71, t14, updated_12)
    t73 = divide(t45, t14, updated_13)
    t74 = multiply(t73, t70, updated_13)
    t75 = add(t74, t72, updated_13)
    t76 = add(t70, t72, w8)
    t77 = multiply(t61, n1, w14)
    t78 = multiply(t77, t49, w14)
    t80 = divide(t44, t29, updated_22)
    t81 = divide(n4, t14, updated_23)
    t82 = add(t80, t81, w10)
    t83 = multiply(t82, n3, w10)
    t84 = multiply(t83, n2, w10)
    t86 = multiply(t69, n2, predicted_22)
    t87 = divide(t86, t29, updated_33)
    t89 = add(t75, n4, updated_13)
    t90 = multiply(t89, n3, updated_13)
    t93 = add(t76, n6, w11)
    t95 = multiply(t93, n7, w11)
    t97 = multiply(t4, n3, w0)
    t98 = add(t7, share, w2)
    t99 = divide(t97, t29, w15)
    t100 = multiply(t48, t99, predicted_23)
    t101 = multiply(t100, t97, w17)
    t103 = divide(t35, t14, predicted_12)
    t104 = multiply(t99, n1, w15)
    t105 = divide(t104, n8, w15)
    t106 = multiply(t103, t19, w3)
    t107 = multiply(t103, t11, predicted_22)
    t108 = add(t106, t58, w13)
    t109 = multiply(t37, t17, predicted_13)
    t110 = add(t107, t109, predicted_22)
    t111 = square(t17, predicted_13)
    t112 = multiply(t111, t39, predicted_13)
    t113 = add(t112, t65, predicted_13)
    t114 = add(t57, t113, w4)
    t115 = multiply(t103, t30, predicted_12)
    t116 = multiply(t115, t30, predicted_12)
    t117 = add(t116, t114, predicted_12)
    t118 = divide(n2, t29, w1)
    t119 = divide(t118, n8, w1)
    t120 = multiply(t108, t105, w13)
    t121 = multiply(t110, t105, w15)
    t122 = multiply(t81, t97, updated_23)
    t123 = multiply(t122, n2, updated_23)
    t124 = divide(t123, n8, updated_23)
    t125 = multiply(t80, t97, updated_22)
    t126 = multiply(t125, n2, updated_22)
    t127 = divide(t126, n8, updated_22)
    t128 = multiply(t117, t119, w0)
    t129 = multiply(t106, t11, w3)
    t130 = multiply(t129, n2, w3)
    t131 = multiply(t130, t119, w3)
    t132 = divide(t17, t14, predicted_11)
    t133 = multiply(t132, t70, predicted_11)
    t134 = add(t133, n4, predicted_11)
    t135 = multiply(t134, n3, predicted_11)
    t136 = divide(t135, n8, w1)
    t137 = multiply(t72, n3, updated_12)
    t138 = divide(t137, n8, w4)
    t139 = multiply(t76, n7, w8)
    t140 = divide(t139, n8, w8)
    t142 = multiply(t98, n9, w2)
    divide(t51, n8, predicted_11)
    divide(t78, n8, predicted_12)
    divide(t84, n8, predicted_13)
    divide(t87, n8, predicted_22)
    divide(t90, n8, predicted_23)
    divide(t95, n8, predicted_33)
    divide(t101, n8, updated_11)
    subtract(t120, t121, updated_12)
    subtract(t124, t127, updated_13)
    subtract(t128, t131, updated_22)
    subtract(t136, t138, updated_23)
    subtract(t140, t142, updated_33)


_JERK_NOISE_VARIANCES = Signature(
    "jerk_noise_variances",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _SHARE_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
        "updated_11",
        "updated_12",
        "updated_13",
        "updated_22",
        "updated_23",
        "updated_33",
    ),
    18,
    _jerk_noise_variances_block,
    numbers=_jerk_noise_variances_of_numbers,
)


class WhiteJerkNoiseVariances(NamedTuple):
    """Result of `white_jerk_noise_variances`."""

    predicted_11: Real
    """Added to the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Added to the covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_13: Real
    """Added to the covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Added to the variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Added to the covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Added to the variance of the predicted acceleration over sigma_v^2, times T^4."""
    updated_11: Real
    """Added to the variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Added to the covariance of updated position and velocity over sigma_v^2, times T."""
    updated_13: Real
    """Added to the covariance of updated position and acceleration over sigma_v^2, times T^2."""
    updated_22: Real
    """Added to the variance of the updated velocity over sigma_v^2, times T^2."""
    updated_23: Real
    """Added to the covariance of updated velocity and acceleration over sigma_v^2, times T^3."""
    updated_33: Real
    """Added to the variance of the updated acceleration over sigma_v^2, times T^4."""


def white_jerk_noise_variances(
    alpha: ArrayLike,
    beta: ArrayLike,
    share: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real, Real]
    | None = None,
    workers: int = 1,
) -> WhiteJerkNoiseVariances:
    """What a white jerk adds to covariances.

        D = F (I - K H) D (F (I - K H))' + Q with q = density T^5/sigma_v^2,
        Q = q (1/20, 1/8, 1/6; 1/8, 1/3, 1/2; 1/6, 1/2, 1);
        times q sigma_v^2 the entries are what the noise adds to the variances;
        with n = 1 + x + y + d, y = (d + m)/x,
        N = 960, a = 15, f = 10, h = 30, K = 15 y + 15 + 2 x/d,
        V = 15 (1 + y)^2 + 2 + 2 x/d,
        predicted_11 = K n^2/(N m), predicted_13 = 4 n (a + K/m)/N,
        predicted_23 = 8 ((1 + x) V/m + a x + f)/N, predicted_33 = 16 (V/m + a x + h)/N
        and after the update (I - K H) D (I - K H)'; x, d and m are those of `coordinates`

    alpha: gain of the position; a number at least 1e-20 and at most 0.999999, in float32 at least
        1e-5 and at most 0.99999.
    beta: gain of the velocity times T; a number at least 1e-20 and at most 1.9999999, in float32 at
        least 1e-5 and at most 1.99999.
    share: gamma over its largest stable value 2 alpha beta/(2 - alpha); a number at least 1e-20 and
        at most 0.999999, in float32 at least 1e-5 and at most 0.99999.

    predicted_11: added to the variance of the predicted position over sigma_v^2. Relative error at
        most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for every input.
    predicted_12: added to the covariance of predicted position and velocity over sigma_v^2, times
        T. Relative error at most 11.01 * 2^-52 (float64), 11.01 * 2^-23 (float32), proved for every
        input.
    predicted_13: added to the covariance of predicted position and acceleration over sigma_v^2,
        times T^2. Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for
        every input.
    predicted_22: added to the variance of the predicted velocity over sigma_v^2, times T^2.
        Relative error at most 11.51 * 2^-52 (float64), 11.51 * 2^-23 (float32), proved for every
        input.
    predicted_23: added to the covariance of predicted velocity and acceleration over sigma_v^2,
        times T^3. Relative error at most 15.50 * 2^-52 (float64), 15.50 * 2^-23 (float32), proved
        for every input.
    predicted_33: added to the variance of the predicted acceleration over sigma_v^2, times T^4.
        Relative error at most 11.00 * 2^-52 (float64), 11.00 * 2^-23 (float32), proved for every
        input.
    updated_11: added to the variance of the updated position over sigma_v^2. Relative error at most
        11.51 * 2^-52 (float64), 11.51 * 2^-23 (float32), proved for every input.
    updated_12: added to the covariance of updated position and velocity over sigma_v^2, times T.
        Error over the sum of its terms' sizes at most 11.51 * 2^-52 (float64), 11.51 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 3e-7 in float64 and 0.01 in float32 of what its error is relative
        to.
    updated_13: added to the covariance of updated position and acceleration over sigma_v^2, times
        T^2. Error over the sum of its terms' sizes at most 8.51 * 2^-52 (float64), 8.51 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 3e-7 in float64 and 0.007 in float32 of what its error is relative
        to; what cancels: 4*15/(alpha*share*2*beta/(2 - alpha))*8*(1 - alpha)/960 -
        4*(2*alpha*(beta*(1 - share) + 2*(1 - alpha) + 2 - beta)/(2 - alpha)*15 +
        15*alpha*share*2*beta/(2 - alpha) + 2*2*beta/(2*(2*(1 - alpha) + 2 -
        beta))*alpha*share*2*beta/(2 - alpha))/(8*alpha*beta*(1 - share))*8*(1 - alpha)/960.
    updated_22: added to the variance of the updated velocity over sigma_v^2, times T^2. Error over
        the sum of its terms' sizes at most 14.00 * 2^-52 (float64), 14.00 * 2^-23 (float32), proved
        for every input. Cancellation, condition number 1: terms of both signs. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 4e-7 in float64 and 0.02 in float32 of what its error is relative to.
    updated_23: added to the covariance of updated velocity and acceleration over sigma_v^2, times
        T^3. Error over the sum of its terms' sizes at most 17.00 * 2^-52 (float64), 17.00 * 2^-23
        (float32), proved for every input. Cancellation, condition number 1: terms of both signs.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 5e-7 in float64 and 0.02 in float32 of what its error is relative
        to.
    updated_33: added to the variance of the updated acceleration over sigma_v^2, times T^4. Error
        over the sum of its terms' sizes at most 11.00 * 2^-52 (float64), 11.00 * 2^-23 (float32),
        proved for every input. Cancellation, condition number 1: terms of both signs. Digits that
        can be lost: up to 16 of 16 in float64, half or more only where alpha >= 5.6e-12 and share
        >= 0.0031; up to 7 of 7 in float32, half or more only where alpha >= 4.2e-5 and share >=
        0.056.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(share) is float
        and 1e-20 <= alpha <= 0.999999
        and 1e-20 <= beta <= 1.9999999
        and 1e-20 <= share <= 0.999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                WhiteJerkNoiseVariances, _white_jerk_noise_variances_of_numbers(alpha, beta, share)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return WhiteJerkNoiseVariances(
        *evaluate(_WHITE_JERK_NOISE_VARIANCES, (alpha, beta, share), out, workers)
    )


def _white_jerk_noise_variances_of_numbers(
    alpha: float,
    beta: float,
    share: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = 1.0 - alpha
    t6 = 2.0 - alpha
    t7 = 1.0 - share
    t8 = t4 * 2.0
    t10 = t8 + (2.0 - beta)
    t11 = beta * 2.0
    t12 = t11 / t6
    t14 = (alpha * share) * t12
    t17 = t12 * (t8 + (alpha * t7))
    t19 = alpha * 4.0
    t24 = ((alpha * 2.0) * ((beta * t7) + t10)) / t6
    t25 = t10 * 2.0
    t29 = ((alpha * beta) * t7) * 8.0
    t30 = t19 + t11
    t34 = (t24 * 15.0) + (15.0 * t14)
    t36 = (t11 * 2.0) / t25
    t38 = t36 + 2.0
    t43 = t34 + (t36 * t14)
    t44 = t11 + t14
    t46 = (t34 * t30) / t14
    t47 = t43 / t14
    t48 = 8.0 / t29
    t54 = t11 * 15.0
    t56 = t25 * ((t25 * 15.0) + t54)
    t57 = t14 * 2.0
    t64 = (t19 * t14) * 2.0
    t68 = (t46 * t30) + (t56 + (((t44 * t44) * t38) + t64))
    t69 = ((t19 * t34) + ((t38 * t14) * t14)) / t29
    t70 = t54 / t14
    t74 = t69 + t70
    t76 = ((t46 + (t57 + (t36 * t44))) * 2.0) * t48
    t78 = t43 / t29
    t79 = 15.0 / t14
    t89 = ((((t44 / t14) * t69) + t70) + 10.0) * 8.0
    t96 = t4 * 8.0
    t98 = t96 / t29
    t102 = t34 / t14
    t104 = (t98 * 2.0) / 960.0
    t105 = t102 * t19
    t116 = ((t102 * t30) * t30) + (t56 + (((t17 * t17) * t38) + t64))
    t118 = (4.0 / t29) / 960.0
    t135 = ((((t17 / t14) * t69) + 10.0) * 8.0) / 960.0
    t52 = ((t47 * t48) * 8.0) / 960.0
    t77 = t76 / 960.0
    t83 = (((t78 + t79) * 8.0) * 4.0) / 960.0
    t86 = ((t68 * 4.0) / t29) / 960.0
    t90 = t89 / 960.0
    t95 = ((t74 + 30.0) * 16.0) / 960.0
    t101 = ((t47 * t98) * t96) / 960.0
    t142 = ((t105 + t57) * t104) - (((t102 * t11) + (t36 * t17)) * t104)
    t144 = (((t79 * t96) * 4.0) / 960.0) - (((t78 * t96) * 4.0) / 960.0)
    t146 = (t116 * t118) - (((t105 * t11) * 4.0) * t118)
    t148 = t135 - ((t70 * 8.0) / 960.0)
    t150 = ((t74 * 16.0) / 960.0) - ((t7 + share) * 0.5)
    return (t52, t77, t83, t86, t90, t95, t101, t142, t144, t146, t148, t150)


def _white_jerk_noise_variances_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = 8.0,
    n4: float = 15.0,
    n5: float = 10.0,
    n6: float = 30.0,
    n7: float = 16.0,
    n8: float = 960.0,
    n9: float = 0.5,
) -> None:
    alpha, beta, share = given
    (
        predicted_11,
        predicted_12,
        predicted_13,
        predicted_22,
        predicted_23,
        predicted_33,
        updated_11,
        updated_12,
        updated_13,
        updated_22,
        updated_23,
        updated_33,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16, w17 = work
    t4 = subtract(n0, alpha, w0)
    t6 = subtract(n1, alpha, w1)
    t7 = subtract(n0, share, w2)
    t8 = multiply(t4, n1, w3)
    t9 = subtract(n1, beta, w4)
    t10 = add(t8, t9, w4)
    t11 = multiply(beta, n1, w5)
    t12 = divide(t11, t6, predicted_11)
    t13 = multiply(alpha, share, w6)
    t14 = multiply(t13, t12, w6)
    t15 = multiply(alpha, t7, w7)
    t16 = add(t8, t15, w3)
    t17 = multiply(t12, t16, predicted_11)
    t19 = multiply(alpha, n2, w3)
    t20 = multiply(alpha, n1, w7)
    t21 = multiply(beta, t7, w8)
    t22 = add(t21, t10, w8)
    t23 = multiply(t20, t22, w7)
    t24 = divide(t23, t6, predicted_12)
    t25 = multiply(t10, n1, w4)
    t26 = multiply(alpha, beta, w1)
    t27 = multiply(t26, t7, w1)
    t29 = multiply(t27, n3, w1)
    t30 = add(t19, t11, w7)
    t32 = multiply(t24, n4, predicted_12)
    t33 = multiply(n4, t14, w8)
    t34 = add(t32, t33, predicted_12)
    t35 = multiply(t11, n1, w8)
    t36 = divide(t35, t25, predicted_13)
    t37 = multiply(t19, t34, w8)
    t38 = add(t36, n1, w9)
    t39 = multiply(t38, t14, w10)
    t40 = multiply(t39, t14, w10)
    t41 = add(t37, t40, w8)
    t42 = multiply(t36, t14, w10)
    t43 = add(t34, t42, w10)
    t44 = add(t11, t14, w11)
    t45 = multiply(t34, t30, w12)
    t46 = divide(t45, t14, predicted_22)
    t47 = divide(t43, t14, predicted_23)
    t48 = divide(n3, t29, predicted_33)
    t49 = multiply(t47, t48, w12)
    t50 = multiply(t49, n3, w12)
    t53 = multiply(t25, n4, w13)
    t54 = multiply(t11, n4, w14)
    t55 = add(t53, t54, w13)
    t56 = multiply(t25, t55, w4)
    t57 = multiply(t14, n1, w13)
    t58 = multiply(t36, t44, w15)
    t59 = add(t57, t58, w15)
    t60 = add(t46, t59, w15)
    t61 = square(t44, w16)
    t62 = multiply(t61, t38, w16)
    t63 = multiply(t19, t14, w17)
    t64 = multiply(t63, n1, w17)
    t65 = add(t62, t64, w16)
    t66 = add(t56, t65, w16)
    t67 = multiply(t46, t30, predicted_22)
    t68 = add(t67, t66, predicted_22)
    t69 = divide(t41, t29, updated_11)
    t70 = divide(t54, t14, updated_12)
    t71 = divide(t44, t14, updated_13)
    t72 = multiply(t71, t69, updated_13)
    t73 = add(t72, t70, updated_13)
    t74 = add(t69, t70, w8)
    t75 = multiply(t60, n1, w15)
    t76 = multiply(t75, t48, w15)
    t78 = divide(t43, t29, updated_22)
    t79 = divide(n4, t14, updated_23)
    t80 = add(t78, t79, w10)
    t81 = multiply(t80, n3, w10)
    t82 = multiply(t81, n2, w10)
    t84 = multiply(t68, n2, predicted_22)
    t85 = divide(t84, t29, updated_33)
    t88 = add(t73, n5, updated_13)
    t89 = multiply(t88, n3, updated_13)
    t92 = add(t74, n6, w11)
    t94 = multiply(t92, n7, w11)
    t96 = multiply(t4, n3, w0)
    t97 = add(t7, share, w2)
    t98 = divide(t96, t29, w14)
    t99 = multiply(t47, t98, predicted_23)
    t100 = multiply(t99, t96, w16)
    t102 = divide(t34, t14, predicted_12)
    t103 = multiply(t98, n1, w14)
    t104 = divide(t103, n8, w14)
    t105 = multiply(t102, t19, w3)
    t106 = multiply(t102, t11, predicted_22)
    t107 = add(t105, t57, w13)
    t108 = multiply(t36, t17, predicted_13)
    t109 = add(t106, t108, predicted_22)
    t110 = square(t17, predicted_13)
    t111 = multiply(t110, t38, predicted_13)
    t112 = add(t111, t64, predicted_13)
    t113 = add(t56, t112, w4)
    t114 = multiply(t102, t30, predicted_12)
    t115 = multiply(t114, t30, predicted_12)
    t116 = add(t115, t113, predicted_12)
    t117 = divide(n2, t29, w1)
    t118 = divide(t117, n8, w1)
    t119 = multiply(t107, t104, w13)
    t120 = multiply(t109, t104, w14)
    t121 = multiply(t79, t96, updated_23)
    t122 = multiply(t121, n2, updated_23)
    t123 = divide(t122, n8, updated_23)
    t124 = multiply(t78, t96, updated_22)
    t125 = multiply(t124, n2, updated_22)
    t126 = divide(t125, n8, updated_22)
    t127 = multiply(t116, t118, w0)
    t128 = multiply(t105, t11, w3)
    t129 = multiply(t128, n2, w3)
    t130 = multiply(t129, t118, w3)
    t131 = divide(t17, t14, predicted_11)
    t132 = multiply(t131, t69, predicted_11)
    t133 = add(t132, n5, predicted_11)
    t134 = multiply(t133, n3, predicted_11)
    t135 = divide(t134, n8, w1)
    t136 = multiply(t70, n3, updated_12)
    t137 = divide(t136, n8, w4)
    t138 = multiply(t74, n7, w8)
    t139 = divide(t138, n8, w8)
    t141 = multiply(t97, n9, w2)
    divide(t50, n8, predicted_11)
    divide(t76, n8, predicted_12)
    divide(t82, n8, predicted_13)
    divide(t85, n8, predicted_22)
    divide(t89, n8, predicted_23)
    divide(t94, n8, predicted_33)
    divide(t100, n8, updated_11)
    subtract(t119, t120, updated_12)
    subtract(t123, t126, updated_13)
    subtract(t127, t130, updated_22)
    subtract(t135, t137, updated_23)
    subtract(t139, t141, updated_33)


_WHITE_JERK_NOISE_VARIANCES = Signature(
    "white_jerk_noise_variances",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _SHARE_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
        "updated_11",
        "updated_12",
        "updated_13",
        "updated_22",
        "updated_23",
        "updated_33",
    ),
    18,
    _white_jerk_noise_variances_block,
    numbers=_white_jerk_noise_variances_of_numbers,
)


class AccelerationNoiseVariancesOfCoordinates(NamedTuple):
    """Result of `acceleration_noise_variances_of_coordinates`."""

    predicted_11: Real
    """Added to the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Added to the covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_13: Real
    """Added to the covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Added to the variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Added to the covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Added to the variance of the predicted acceleration over sigma_v^2, times T^4."""


def acceleration_noise_variances_of_coordinates(
    linear_coefficient: ArrayLike,
    cubic_coefficient: ArrayLike,
    hurwitz_determinant: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> AccelerationNoiseVariancesOfCoordinates:
    """What a process noise of the acceleration adds, any stable filter.

        D = F (I - K H) D (F (I - K H))' + Q with q = (sigma_w T^2/sigma_v)^2,
        Q = q (1/2, 1, 1)' (1/2, 1, 1);
        times q sigma_v^2 the entries are what the noise adds to the variances;
        of increments that act at the next sample (acceleration increments) all is the same but
        predicted_33, 1 more, and updated_33, which is predicted_33 here;
        with n = 1 + x + y + d, y = (d + m)/x,
        N = 64, a = 1, f = 0, h = 0, K = 1 + y, V = (1 + y)^2,
        predicted_11 = K n^2/(N m), predicted_13 = 4 n (a + K/m)/N,
        predicted_23 = 8 ((1 + x) V/m + a x + f)/N, predicted_33 = 16 (V/m + a x + h)/N

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most
        1e4.
    cubic_coefficient: d, that of s^3; a number at least 1e-20 and at most 1e20, in float32 at least
        1e-4 and at most 1e4.
    hurwitz_determinant: m = x y - d with y the coefficient of s^2; a number at least 1e-20 and at
        most 1e20, in float32 at least 1e-4 and at most 1e4.

    predicted_11: added to the variance of the predicted position over sigma_v^2. Relative error at
        most 8.01 * 2^-52 (float64), 8.01 * 2^-23 (float32), proved for every input.
    predicted_12: added to the covariance of predicted position and velocity over sigma_v^2, times
        T. Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for every
        input.
    predicted_13: added to the covariance of predicted position and acceleration over sigma_v^2,
        times T^2. Relative error at most 5.51 * 2^-52 (float64), 5.50 * 2^-23 (float32), proved for
        every input.
    predicted_22: added to the variance of the predicted velocity over sigma_v^2, times T^2.
        Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for every
        input.
    predicted_23: added to the covariance of predicted velocity and acceleration over sigma_v^2,
        times T^3. Relative error at most 5.51 * 2^-52 (float64), 5.51 * 2^-23 (float32), proved for
        every input.
    predicted_33: added to the variance of the predicted acceleration over sigma_v^2, times T^4.
        Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(linear_coefficient) is float
        and type(cubic_coefficient) is float
        and type(hurwitz_determinant) is float
        and 1e-20 <= linear_coefficient <= 1e20
        and 1e-20 <= cubic_coefficient <= 1e20
        and 1e-20 <= hurwitz_determinant <= 1e20
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                AccelerationNoiseVariancesOfCoordinates,
                _acceleration_noise_variances_of_coordinates_of_numbers(
                    linear_coefficient, cubic_coefficient, hurwitz_determinant
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return AccelerationNoiseVariancesOfCoordinates(
        *evaluate(
            _ACCELERATION_NOISE_VARIANCES_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
            workers,
        )
    )


def _acceleration_noise_variances_of_coordinates_of_numbers(
    linear_coefficient: float,
    cubic_coefficient: float,
    hurwitz_determinant: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = cubic_coefficient + hurwitz_determinant
    t6 = (t3 / linear_coefficient) + 1.0
    t7 = t6 + linear_coefficient
    t8 = t7 + cubic_coefficient
    t11 = t6 * t7
    t12 = t8 / hurwitz_determinant
    t18 = linear_coefficient * 1.0
    t20 = cubic_coefficient * ((cubic_coefficient * 1.0) + t18)
    t23 = (t6 * t6) / hurwitz_determinant
    t25 = ((linear_coefficient + 1.0) * t23) + t18
    t33 = ((t6 / hurwitz_determinant) + 1.0) * t8
    t38 = (((t11 * t7) + t20) * 4.0) / hurwitz_determinant
    t16 = ((t6 * t12) * t8) * 0.015625
    t30 = ((t11 * 2.0) * t12) * 0.015625
    t36 = (t33 * 4.0) * 0.015625
    t39 = t38 * 0.015625
    t42 = (t25 * 8.0) * 0.015625
    t45 = ((t23 + t18) * 16.0) * 0.015625
    return (t16, t30, t36, t39, t42, t45)


def _acceleration_noise_variances_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
    n3: float = 8.0,
    n4: float = 16.0,
    n5: float = 0.015625,
) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    t3 = add(cubic_coefficient, hurwitz_determinant, w0)
    t4 = divide(t3, linear_coefficient, predicted_11)
    t6 = add(t4, n0, predicted_11)
    t7 = add(t6, linear_coefficient, w0)
    t8 = add(t7, cubic_coefficient, w1)
    t9 = square(t6, w2)
    t10 = add(linear_coefficient, n0, w3)
    t11 = multiply(t6, t7, w4)
    t12 = divide(t8, hurwitz_determinant, predicted_12)
    t13 = multiply(t6, t12, w5)
    t14 = multiply(t13, t8, w5)
    t17 = multiply(cubic_coefficient, n0, w6)
    t18 = multiply(linear_coefficient, n0, w7)
    t19 = add(t17, t18, w6)
    t20 = multiply(cubic_coefficient, t19, w6)
    t21 = multiply(t11, t7, w0)
    t22 = add(t21, t20, w0)
    t23 = divide(t9, hurwitz_determinant, predicted_13)
    t24 = multiply(t10, t23, w3)
    t25 = add(t24, t18, w3)
    t26 = add(t23, t18, predicted_13)
    t28 = multiply(t11, n1, w4)
    t29 = multiply(t28, t12, w4)
    t31 = divide(t6, hurwitz_determinant, predicted_22)
    t32 = add(t31, n0, predicted_22)
    t33 = multiply(t32, t8, predicted_22)
    t35 = multiply(t33, n2, predicted_22)
    t37 = multiply(t22, n2, w0)
    t38 = divide(t37, hurwitz_determinant, predicted_23)
    t41 = multiply(t25, n3, w3)
    t44 = multiply(t26, n4, w0)
    multiply(t14, n5, predicted_11)
    multiply(t29, n5, predicted_12)
    multiply(t35, n5, predicted_13)
    multiply(t38, n5, predicted_22)
    multiply(t41, n5, predicted_23)
    multiply(t44, n5, predicted_33)


_ACCELERATION_NOISE_VARIANCES_OF_COORDINATES = Signature(
    "acceleration_noise_variances_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _CUBIC_COEFFICIENT_DOMAIN, _HURWITZ_DETERMINANT_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    8,
    _acceleration_noise_variances_of_coordinates_block,
    numbers=_acceleration_noise_variances_of_coordinates_of_numbers,
)


class JerkNoiseVariancesOfCoordinates(NamedTuple):
    """Result of `jerk_noise_variances_of_coordinates`."""

    predicted_11: Real
    """Added to the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Added to the covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_13: Real
    """Added to the covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Added to the variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Added to the covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Added to the variance of the predicted acceleration over sigma_v^2, times T^4."""


def jerk_noise_variances_of_coordinates(
    linear_coefficient: ArrayLike,
    cubic_coefficient: ArrayLike,
    hurwitz_determinant: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> JerkNoiseVariancesOfCoordinates:
    """What a jerk that is constant over each interval adds, any stable filter.

        D = F (I - K H) D (F (I - K H))' + Q with q = (sigma_j T^3/sigma_v)^2,
        Q = q (1/6, 1/2, 1)' (1/6, 1/2, 1);
        times q sigma_v^2 the entries are what the noise adds to the variances;
        with n = 1 + x + y + d, y = (d + m)/x,
        N = 576, a = 9, f = 9, h = 18, K = 9 y + 6 + x/d,
        V = (1 + y) (9 y + 6) + 1 + x/d,
        predicted_11 = K n^2/(N m), predicted_13 = 4 n (a + K/m)/N,
        predicted_23 = 8 ((1 + x) V/m + a x + f)/N, predicted_33 = 16 (V/m + a x + h)/N

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most
        1e4.
    cubic_coefficient: d, that of s^3; a number at least 1e-20 and at most 1e20, in float32 at least
        1e-4 and at most 1e4.
    hurwitz_determinant: m = x y - d with y the coefficient of s^2; a number at least 1e-20 and at
        most 1e20, in float32 at least 1e-4 and at most 1e4.

    predicted_11: added to the variance of the predicted position over sigma_v^2. Relative error at
        most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32), proved for every input.
    predicted_12: added to the covariance of predicted position and velocity over sigma_v^2, times
        T. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved for every
        input.
    predicted_13: added to the covariance of predicted position and acceleration over sigma_v^2,
        times T^2. Relative error at most 7.01 * 2^-52 (float64), 7.00 * 2^-23 (float32), proved for
        every input.
    predicted_22: added to the variance of the predicted velocity over sigma_v^2, times T^2.
        Relative error at most 8.51 * 2^-52 (float64), 8.51 * 2^-23 (float32), proved for every
        input.
    predicted_23: added to the covariance of predicted velocity and acceleration over sigma_v^2,
        times T^3. Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for
        every input.
    predicted_33: added to the variance of the predicted acceleration over sigma_v^2, times T^4.
        Relative error at most 6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(linear_coefficient) is float
        and type(cubic_coefficient) is float
        and type(hurwitz_determinant) is float
        and 1e-20 <= linear_coefficient <= 1e20
        and 1e-20 <= cubic_coefficient <= 1e20
        and 1e-20 <= hurwitz_determinant <= 1e20
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                JerkNoiseVariancesOfCoordinates,
                _jerk_noise_variances_of_coordinates_of_numbers(
                    linear_coefficient, cubic_coefficient, hurwitz_determinant
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return JerkNoiseVariancesOfCoordinates(
        *evaluate(
            _JERK_NOISE_VARIANCES_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
            workers,
        )
    )


def _jerk_noise_variances_of_coordinates_of_numbers(
    linear_coefficient: float,
    cubic_coefficient: float,
    hurwitz_determinant: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = cubic_coefficient + hurwitz_determinant
    t4 = t3 / linear_coefficient
    t6 = t4 + 1.0
    t7 = t6 + linear_coefficient
    t8 = t7 + cubic_coefficient
    t12 = (t4 * 9.0) + 6.0
    t14 = (linear_coefficient * 1.0) / cubic_coefficient
    t16 = t14 + 1.0
    t18 = t12 + t14
    t19 = linear_coefficient + 1.0
    t20 = t12 * t7
    t21 = t8 / hurwitz_determinant
    t28 = (cubic_coefficient * 9.0) + (linear_coefficient * 6.0)
    t37 = (cubic_coefficient * t28) + (((t19 * t19) * t16) + (t6 * 1.0))
    t40 = ((t6 * t12) + t16) / hurwitz_determinant
    t41 = linear_coefficient * 9.0
    t47 = ((t20 + (1.0 + (t14 * t19))) * 2.0) * t21
    t51 = ((t18 / hurwitz_determinant) + 9.0) * t8
    t56 = (((t20 * t7) + t37) * 4.0) / hurwitz_determinant
    t25 = ((t18 * t21) * t8) / 576.0
    t48 = t47 / 576.0
    t54 = (t51 * 4.0) / 576.0
    t57 = t56 / 576.0
    t61 = ((((t19 * t40) + t41) + 9.0) * 8.0) / 576.0
    t66 = (((t40 + t41) + 18.0) * 16.0) / 576.0
    return (t25, t48, t54, t57, t61, t66)


def _jerk_noise_variances_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 9.0,
    n2: float = 6.0,
    n3: float = 2.0,
    n4: float = 4.0,
    n5: float = 8.0,
    n6: float = 18.0,
    n7: float = 16.0,
    n8: float = 576.0,
) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    t3 = add(cubic_coefficient, hurwitz_determinant, w0)
    t4 = divide(t3, linear_coefficient, predicted_11)
    t6 = add(t4, n0, w0)
    t7 = add(t6, linear_coefficient, w1)
    t8 = add(t7, cubic_coefficient, w2)
    t10 = multiply(t4, n1, predicted_11)
    t12 = add(t10, n2, predicted_11)
    t13 = multiply(linear_coefficient, n0, w3)
    t14 = divide(t13, cubic_coefficient, predicted_12)
    t15 = multiply(t6, t12, w3)
    t16 = add(t14, n0, w4)
    t17 = add(t15, t16, w3)
    t18 = add(t12, t14, w5)
    t19 = add(linear_coefficient, n0, w6)
    t20 = multiply(t12, t7, predicted_11)
    t21 = divide(t8, hurwitz_determinant, predicted_13)
    t22 = multiply(t18, t21, w7)
    t23 = multiply(t22, t8, w7)
    t26 = multiply(cubic_coefficient, n1, w8)
    t27 = multiply(linear_coefficient, n2, w9)
    t28 = add(t26, t27, w8)
    t29 = multiply(cubic_coefficient, t28, w8)
    t30 = multiply(t14, t19, predicted_12)
    t31 = add(n0, t30, predicted_12)
    t32 = add(t20, t31, predicted_12)
    t33 = square(t19, w9)
    t34 = multiply(t33, t16, w9)
    t35 = multiply(t6, n0, w0)
    t36 = add(t34, t35, w9)
    t37 = add(t29, t36, w8)
    t38 = multiply(t20, t7, predicted_11)
    t39 = add(t38, t37, predicted_11)
    t40 = divide(t17, hurwitz_determinant, predicted_22)
    t41 = multiply(linear_coefficient, n1, w0)
    t42 = multiply(t19, t40, w6)
    t43 = add(t42, t41, w6)
    t44 = add(t40, t41, predicted_22)
    t46 = multiply(t32, n3, predicted_12)
    t47 = multiply(t46, t21, predicted_12)
    t49 = divide(t18, hurwitz_determinant, predicted_23)
    t50 = add(t49, n1, predicted_23)
    t51 = multiply(t50, t8, predicted_23)
    t53 = multiply(t51, n4, predicted_23)
    t55 = multiply(t39, n4, predicted_11)
    t56 = divide(t55, hurwitz_determinant, predicted_33)
    t58 = add(t43, n1, w6)
    t60 = multiply(t58, n5, w6)
    t63 = add(t44, n6, predicted_22)
    t65 = multiply(t63, n7, w0)
    divide(t23, n8, predicted_11)
    divide(t47, n8, predicted_12)
    divide(t53, n8, predicted_13)
    divide(t56, n8, predicted_22)
    divide(t60, n8, predicted_23)
    divide(t65, n8, predicted_33)


_JERK_NOISE_VARIANCES_OF_COORDINATES = Signature(
    "jerk_noise_variances_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _CUBIC_COEFFICIENT_DOMAIN, _HURWITZ_DETERMINANT_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    10,
    _jerk_noise_variances_of_coordinates_block,
    numbers=_jerk_noise_variances_of_coordinates_of_numbers,
)


class WhiteJerkNoiseVariancesOfCoordinates(NamedTuple):
    """Result of `white_jerk_noise_variances_of_coordinates`."""

    predicted_11: Real
    """Added to the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Added to the covariance of predicted position and velocity over sigma_v^2, times T."""
    predicted_13: Real
    """Added to the covariance of predicted position and acceleration over sigma_v^2, times T^2."""
    predicted_22: Real
    """Added to the variance of the predicted velocity over sigma_v^2, times T^2."""
    predicted_23: Real
    """Added to the covariance of predicted velocity and acceleration over sigma_v^2, times T^3."""
    predicted_33: Real
    """Added to the variance of the predicted acceleration over sigma_v^2, times T^4."""


def white_jerk_noise_variances_of_coordinates(
    linear_coefficient: ArrayLike,
    cubic_coefficient: ArrayLike,
    hurwitz_determinant: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> WhiteJerkNoiseVariancesOfCoordinates:
    """What a white jerk adds, any stable filter.

        D = F (I - K H) D (F (I - K H))' + Q with q = density T^5/sigma_v^2,
        Q = q (1/20, 1/8, 1/6; 1/8, 1/3, 1/2; 1/6, 1/2, 1);
        times q sigma_v^2 the entries are what the noise adds to the variances;
        with n = 1 + x + y + d, y = (d + m)/x,
        N = 960, a = 15, f = 10, h = 30, K = 15 y + 15 + 2 x/d,
        V = 15 (1 + y)^2 + 2 + 2 x/d,
        predicted_11 = K n^2/(N m), predicted_13 = 4 n (a + K/m)/N,
        predicted_23 = 8 ((1 + x) V/m + a x + f)/N, predicted_33 = 16 (V/m + a x + h)/N

    linear_coefficient: x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over the
        constant one; a number at least 1e-20 and at most 1e20, in float32 at least 1e-4 and at most
        1e4.
    cubic_coefficient: d, that of s^3; a number at least 1e-20 and at most 1e20, in float32 at least
        1e-4 and at most 1e4.
    hurwitz_determinant: m = x y - d with y the coefficient of s^2; a number at least 1e-20 and at
        most 1e20, in float32 at least 1e-4 and at most 1e4.

    predicted_11: added to the variance of the predicted position over sigma_v^2. Relative error at
        most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32), proved for every input.
    predicted_12: added to the covariance of predicted position and velocity over sigma_v^2, times
        T. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved for every
        input.
    predicted_13: added to the covariance of predicted position and acceleration over sigma_v^2,
        times T^2. Relative error at most 7.01 * 2^-52 (float64), 7.00 * 2^-23 (float32), proved for
        every input.
    predicted_22: added to the variance of the predicted velocity over sigma_v^2, times T^2.
        Relative error at most 8.51 * 2^-52 (float64), 8.51 * 2^-23 (float32), proved for every
        input.
    predicted_23: added to the covariance of predicted velocity and acceleration over sigma_v^2,
        times T^3. Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for
        every input.
    predicted_33: added to the variance of the predicted acceleration over sigma_v^2, times T^4.
        Relative error at most 6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(linear_coefficient) is float
        and type(cubic_coefficient) is float
        and type(hurwitz_determinant) is float
        and 1e-20 <= linear_coefficient <= 1e20
        and 1e-20 <= cubic_coefficient <= 1e20
        and 1e-20 <= hurwitz_determinant <= 1e20
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                WhiteJerkNoiseVariancesOfCoordinates,
                _white_jerk_noise_variances_of_coordinates_of_numbers(
                    linear_coefficient, cubic_coefficient, hurwitz_determinant
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return WhiteJerkNoiseVariancesOfCoordinates(
        *evaluate(
            _WHITE_JERK_NOISE_VARIANCES_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
            workers,
        )
    )


def _white_jerk_noise_variances_of_coordinates_of_numbers(
    linear_coefficient: float,
    cubic_coefficient: float,
    hurwitz_determinant: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t3 = cubic_coefficient + hurwitz_determinant
    t4 = t3 / linear_coefficient
    t6 = t4 + 1.0
    t7 = t6 + linear_coefficient
    t8 = t7 + cubic_coefficient
    t11 = (t4 * 15.0) + 15.0
    t14 = (linear_coefficient * 2.0) / cubic_coefficient
    t16 = t14 + 2.0
    t18 = t11 + t14
    t19 = linear_coefficient + 1.0
    t20 = t11 * t7
    t21 = t8 / hurwitz_determinant
    t27 = linear_coefficient * 15.0
    t29 = cubic_coefficient * ((cubic_coefficient * 15.0) + t27)
    t37 = t29 + (((t19 * t19) * t16) + (t6 * 2.0))
    t40 = ((t6 * t11) + t16) / hurwitz_determinant
    t45 = ((t20 + (2.0 + (t14 * t19))) * 2.0) * t21
    t49 = ((t18 / hurwitz_determinant) + 15.0) * t8
    t54 = (((t20 * t7) + t37) * 4.0) / hurwitz_determinant
    t25 = ((t18 * t21) * t8) / 960.0
    t46 = t45 / 960.0
    t52 = (t49 * 4.0) / 960.0
    t55 = t54 / 960.0
    t60 = ((((t19 * t40) + t27) + 10.0) * 8.0) / 960.0
    t65 = (((t40 + t27) + 30.0) * 16.0) / 960.0
    return (t25, t46, t52, t55, t60, t65)


def _white_jerk_noise_variances_of_coordinates_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 15.0,
    n2: float = 2.0,
    n3: float = 4.0,
    n4: float = 10.0,
    n5: float = 8.0,
    n6: float = 30.0,
    n7: float = 16.0,
    n8: float = 960.0,
) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    t3 = add(cubic_coefficient, hurwitz_determinant, w0)
    t4 = divide(t3, linear_coefficient, predicted_11)
    t6 = add(t4, n0, w0)
    t7 = add(t6, linear_coefficient, w1)
    t8 = add(t7, cubic_coefficient, w2)
    t10 = multiply(t4, n1, predicted_11)
    t11 = add(t10, n1, predicted_11)
    t13 = multiply(linear_coefficient, n2, w3)
    t14 = divide(t13, cubic_coefficient, predicted_12)
    t15 = multiply(t6, t11, w3)
    t16 = add(t14, n2, w4)
    t17 = add(t15, t16, w3)
    t18 = add(t11, t14, w5)
    t19 = add(linear_coefficient, n0, w6)
    t20 = multiply(t11, t7, predicted_11)
    t21 = divide(t8, hurwitz_determinant, predicted_13)
    t22 = multiply(t18, t21, w7)
    t23 = multiply(t22, t8, w7)
    t26 = multiply(cubic_coefficient, n1, w8)
    t27 = multiply(linear_coefficient, n1, w9)
    t28 = add(t26, t27, w8)
    t29 = multiply(cubic_coefficient, t28, w8)
    t30 = multiply(t14, t19, predicted_12)
    t31 = add(n2, t30, predicted_12)
    t32 = add(t20, t31, predicted_12)
    t33 = square(t19, w10)
    t34 = multiply(t33, t16, w10)
    t35 = multiply(t6, n2, w0)
    t36 = add(t34, t35, w10)
    t37 = add(t29, t36, w8)
    t38 = multiply(t20, t7, predicted_11)
    t39 = add(t38, t37, predicted_11)
    t40 = divide(t17, hurwitz_determinant, predicted_22)
    t41 = multiply(t19, t40, w6)
    t42 = add(t41, t27, w6)
    t43 = add(t40, t27, predicted_22)
    t44 = multiply(t32, n2, predicted_12)
    t45 = multiply(t44, t21, predicted_12)
    t47 = divide(t18, hurwitz_determinant, predicted_23)
    t48 = add(t47, n1, predicted_23)
    t49 = multiply(t48, t8, predicted_23)
    t51 = multiply(t49, n3, predicted_23)
    t53 = multiply(t39, n3, predicted_11)
    t54 = divide(t53, hurwitz_determinant, predicted_33)
    t57 = add(t42, n4, w6)
    t59 = multiply(t57, n5, w6)
    t62 = add(t43, n6, predicted_22)
    t64 = multiply(t62, n7, w0)
    divide(t23, n8, predicted_11)
    divide(t45, n8, predicted_12)
    divide(t51, n8, predicted_13)
    divide(t54, n8, predicted_22)
    divide(t59, n8, predicted_23)
    divide(t64, n8, predicted_33)


_WHITE_JERK_NOISE_VARIANCES_OF_COORDINATES = Signature(
    "white_jerk_noise_variances_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _CUBIC_COEFFICIENT_DOMAIN, _HURWITZ_DETERMINANT_DOMAIN),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    11,
    _white_jerk_noise_variances_of_coordinates_block,
    numbers=_white_jerk_noise_variances_of_coordinates_of_numbers,
)


class Lags(NamedTuple):
    """Result of `lags`."""

    predicted_position_lag: Real
    """Truth less predicted position."""
    predicted_velocity_lag: Real
    """Truth less predicted velocity."""
    predicted_acceleration_lag: Real
    """Truth less predicted acceleration."""
    updated_position_lag: Real
    """Truth less updated position."""
    updated_velocity_lag: Real
    """Truth less updated velocity."""
    updated_acceleration_lag: Real
    """Truth less updated acceleration."""


def lags(
    alpha: ArrayLike,
    beta: ArrayLike,
    share: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> Lags:
    """Steady errors behind a constant jerk j, over j T^3 (positions), j T^2 and j T.

        gamma = 2 alpha beta share/(2 - alpha), margin = 4 - 2 alpha - beta,
        predicted_position_lag = 1/gamma, predicted_acceleration_lag = beta/gamma + 1/2,
        predicted_velocity_lag = (12 alpha + 6 beta + gamma)/(12 gamma),
        updated_position_lag = (1 - alpha)/gamma, updated_acceleration_lag = beta/gamma - 1/2,
        updated_velocity_lag = (12 alpha - 6 beta + gamma)/(12 gamma);
        none behind rest, constant velocity and constant acceleration

    alpha: gain of the position; a number at least 1e-20 and at most 0.999999, in float32 at least
        1e-5 and at most 0.99999.
    beta: gain of the velocity times T; a number at least 1e-20 and at most 1.9999999, in float32 at
        least 1e-5 and at most 1.99999.
    share: gamma over its largest stable value 2 alpha beta/(2 - alpha); a number at least 1e-20 and
        at most 0.999999, in float32 at least 1e-5 and at most 0.99999.

    predicted_position_lag: truth less predicted position. Relative error at most 2.51 * 2^-52
        (float64), 2.51 * 2^-23 (float32), proved for every input.
    predicted_velocity_lag: truth less predicted velocity. Relative error at most 3.51 * 2^-52
        (float64), 3.50 * 2^-23 (float32), proved for every input.
    predicted_acceleration_lag: truth less predicted acceleration. Relative error at most 3.01 *
        2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input.
    updated_position_lag: truth less updated position. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.
    updated_velocity_lag: truth less updated velocity. Error over predicted_velocity_lag at most
        3.51 * 2^-52 (float64), 3.50 * 2^-23 (float32), proved for every input. Cancellation,
        condition number 1: changes its sign. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 9e-8 in float64 and 0.003 in
        float32 of what its error is relative to; what cancels: alpha/(alpha*share*2*beta/(2 -
        alpha)) + 1/12 - beta/(2*alpha*share*2*beta/(2 - alpha)).
    updated_acceleration_lag: truth less updated acceleration. Relative error at most 4.01 * 2^-52
        (float64), 4.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(share) is float
        and 1e-20 <= alpha <= 0.999999
        and 1e-20 <= beta <= 1.9999999
        and 1e-20 <= share <= 0.999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(Lags, _lags_of_numbers(alpha, beta, share))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Lags(*evaluate(_LAGS, (alpha, beta, share), out, workers))


def _lags_of_numbers(
    alpha: float,
    beta: float,
    share: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = 1.0 - alpha
    t10 = (beta * 2.0) / (2.0 - alpha)
    t12 = (alpha * share) * t10
    t15 = t10 * ((t4 * 2.0) + (alpha * (1.0 - share)))
    t18 = (alpha / t12) + 0.08333333333333333
    t19 = t12 * 2.0
    t20 = beta / t19
    t21 = t18 - t20
    t22 = 1.0 / t12
    t23 = t18 + t20
    t26 = (beta / t12) + 0.5
    t27 = t4 / t12
    t28 = t15 / t19
    return (t22, t23, t26, t27, t21, t28)


def _lags_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.08333333333333333,
    n3: float = 0.5,
) -> None:
    alpha, beta, share = given
    (
        predicted_position_lag,
        predicted_velocity_lag,
        predicted_acceleration_lag,
        updated_position_lag,
        updated_velocity_lag,
        updated_acceleration_lag,
    ) = out
    w0, w1, w2, w3, w4 = work
    t4 = subtract(n0, alpha, w0)
    t6 = subtract(n1, alpha, w1)
    t7 = subtract(n0, share, w2)
    t8 = multiply(t4, n1, w3)
    t9 = multiply(beta, n1, w4)
    t10 = divide(t9, t6, updated_velocity_lag)
    t11 = multiply(alpha, share, w1)
    t12 = multiply(t11, t10, w1)
    t13 = multiply(alpha, t7, w2)
    t14 = add(t8, t13, w3)
    t15 = multiply(t10, t14, w3)
    t16 = divide(alpha, t12, predicted_position_lag)
    t18 = add(t16, n2, w2)
    t19 = multiply(t12, n1, w4)
    t20 = divide(beta, t19, predicted_velocity_lag)
    t24 = divide(beta, t12, predicted_acceleration_lag)
    subtract(t18, t20, updated_velocity_lag)
    divide(n0, t12, predicted_position_lag)
    add(t18, t20, predicted_velocity_lag)
    add(t24, n3, predicted_acceleration_lag)
    divide(t4, t12, updated_position_lag)
    divide(t15, t19, updated_acceleration_lag)


_LAGS = Signature(
    "lags",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _SHARE_DOMAIN),
    (
        "predicted_position_lag",
        "predicted_velocity_lag",
        "predicted_acceleration_lag",
        "updated_position_lag",
        "updated_velocity_lag",
        "updated_acceleration_lag",
    ),
    5,
    _lags_block,
    numbers=_lags_of_numbers,
)


class ClosedLoopPoles(NamedTuple):
    """Result of `closed_loop_poles`."""

    mean_distance: Real
    """1 less the mean of the poles."""
    reduced_linear: Real
    """P of the reduced cubic."""
    reduced_constant: Real
    """Q of the reduced cubic."""
    discriminant: Real
    """P^3 - q^2, 0 or more where all poles are real."""


def closed_loop_poles(
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> ClosedLoopPoles:
    """Closed-loop poles, 1 - mean_distance + w with w^3 = 3 p w + 2 q, of any positive gains.

        s = alpha + beta + gamma/2, b = beta + 3 gamma/2, mean_distance = s/3,
        p = reduced_linear = s^2/9 - b/3, q = reduced_constant = s b/6 - s^3/27 - gamma/2,
        discriminant = p^3 - q^2 = (s^2 b^2 + 18 s b gamma - 4 b^3 - 4 s^3 gamma - 27 gamma^2)/108.
        Three real poles where it is not negative: w = 2 sqrt(p) cos(t + 2 pi k/3), cos(3 t) =
        q/p^(3/2); else with r = (|q| + sqrt(-discriminant))^(1/3) and the sign of q the real one
        has w = +-(r + p/r), the pair real parts of -1/2 and imaginary parts of +-sqrt(3)/2 times
        r + p/r and r - p/r. No bound of the poles themselves holds everywhere: next to a threefold
        pole they move by the cube root of what p and q move by. The domain holds all stable gains
        from 1e-20 on, and others

    alpha: gain of the position; a number at least 1e-20 and at most 2, in float32 at least 1e-4 and
        at most 2.
    beta: gain of the velocity times T; a number at least 1e-20 and at most 4, in float32 at least
        1e-4 and at most 4.
    gamma: gain of the acceleration times T^2; a number at least 1e-20 and at most 8, in float32 at
        least 1e-4 and at most 8.

    mean_distance: 1 less the mean of the poles. Relative error at most 1.51 * 2^-52 (float64), 1.50
        * 2^-23 (float32), proved for every input.
    reduced_linear: p of the reduced cubic. Error over the sum of its terms' sizes at most 3.51 *
        2^-52 (float64), 3.50 * 2^-23 (float32), proved for every input. Cancellation, condition
        number 1: changes its sign. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 9e-8 in float64 and 0.003 in float32 of
        what its error is relative to; what cancels: (alpha + beta + gamma/2)**2/9 - (beta + gamma +
        gamma/2)/3.
    reduced_constant: q of the reduced cubic. Error over the sum of its terms' sizes at most 5.51 *
        2^-52 (float64), 5.50 * 2^-23 (float32), proved for every input. Cancellation, condition
        number 1: changes its sign. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 2e-7 in float64 and 0.005 in float32 of
        what its error is relative to; what cancels: (alpha + beta + gamma/2)*(beta + gamma +
        gamma/2)/6 - ((alpha + beta + gamma/2)**2*(alpha + beta + gamma/2)/27 + gamma/2).
    discriminant: p^3 - q^2, 0 or more where all poles are real. Error over the sum of its terms'
        sizes at most 7.00 * 2^-52 (float64), 6.97 * 2^-23 (float32), proved for every input.
        Cancellation, condition number 1: changes its sign. Digits that can be lost: up to 16 of 16
        in float64 and 7 of 7 in float32; half or more only where the value is below 2e-7 in float64
        and 0.006 in float32 of what its error is relative to; what cancels: ((alpha + beta +
        gamma/2)*(beta + gamma + gamma/2) + gamma*18)*(alpha + beta + gamma/2)*(beta + gamma +
        gamma/2)/108 - (4*((beta + gamma + gamma/2)**2*(beta + gamma + gamma/2) + (alpha + beta +
        gamma/2)**2*(alpha + beta + gamma/2)*gamma) + gamma**2*27)/108.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(gamma) is float
        and 1e-20 <= alpha <= 2.0
        and 1e-20 <= beta <= 4.0
        and 1e-20 <= gamma <= 8.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(ClosedLoopPoles, _closed_loop_poles_of_numbers(alpha, beta, gamma))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ClosedLoopPoles(*evaluate(_CLOSED_LOOP_POLES, (alpha, beta, gamma), out, workers))


def _closed_loop_poles_of_numbers(
    alpha: float,
    beta: float,
    gamma: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = gamma * 0.5
    t6 = (alpha + beta) + t4
    t8 = (beta + gamma) + t4
    t9 = t6 * t6
    t10 = t6 * t8
    t17 = t9 * t6
    t26 = (((t8 * t8) * t8) + (t17 * gamma)) * 4.0
    t35 = ((t10 + (gamma * 18.0)) * t10) / 108.0
    t36 = (t26 + ((gamma * gamma) * 27.0)) / 108.0
    t37 = t6 / 3.0
    t38 = (t9 / 9.0) - (t8 / 3.0)
    t40 = (t10 / 6.0) - ((t17 / 27.0) + t4)
    t42 = t35 - t36
    return (t37, t38, t40, t42)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 9.0,
    n2: float = 3.0,
    n3: float = 6.0,
    n4: float = 27.0,
    n5: float = 4.0,
    n6: float = 18.0,
    n7: float = 108.0,
) -> None:
    alpha, beta, gamma = given
    mean_distance, reduced_linear, reduced_constant, discriminant = out
    w0, w1, w2, w3, w4 = work
    t4 = multiply(gamma, n0, w0)
    t5 = add(alpha, beta, w1)
    t6 = add(t5, t4, w1)
    t7 = add(beta, gamma, w2)
    t8 = add(t7, t4, w2)
    t9 = square(t6, w3)
    t10 = multiply(t6, t8, w4)
    t12 = divide(t9, n1, reduced_linear)
    t14 = divide(t8, n2, reduced_constant)
    t16 = divide(t10, n3, discriminant)
    t17 = multiply(t9, t6, w3)
    t19 = divide(t17, n4, mean_distance)
    t20 = add(t19, t4, w0)
    t21 = square(t8, mean_distance)
    t22 = multiply(t21, t8, mean_distance)
    t23 = multiply(t17, gamma, w3)
    t24 = add(t22, t23, mean_distance)
    t26 = multiply(t24, n5, mean_distance)
    t27 = square(gamma, w2)
    t28 = multiply(t27, n4, w2)
    t29 = add(t26, t28, mean_distance)
    t31 = multiply(gamma, n6, w2)
    t32 = add(t10, t31, w2)
    t33 = multiply(t32, t10, w2)
    t35 = divide(t33, n7, w2)
    t36 = divide(t29, n7, w3)
    divide(t6, n2, mean_distance)
    subtract(t12, t14, reduced_linear)
    subtract(t16, t20, reduced_constant)
    subtract(t35, t36, discriminant)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_ALPHA_DOMAIN_2, _BETA_DOMAIN_2, _GAMMA_DOMAIN),
    ("mean_distance", "reduced_linear", "reduced_constant", "discriminant"),
    5,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)


class MinimumVarianceByLag(NamedTuple):
    """Result of `minimum_variance_by_lag`."""

    minimum_variance_alpha: Real
    """Gain of the position, minimum variance."""
    minimum_variance_beta: Real
    """Gain of the velocity times T, minimum variance."""
    minimum_variance_gamma: Real
    """Gain of the acceleration times T^2, minimum variance."""
    minimum_variance_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, minimum variance."""


def minimum_variance_by_lag(
    lag: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> MinimumVarianceByLag:
    """The stable filter of least position variance at a lag (MV).

        with x = 2 lag^(1/3) - 1: alpha = 2 (2 x^2 + 2 x + 1)/(1 + x)^3, beta = 4 x/(1 + x)^3,
        gamma = 8/(1 + x)^3, minimum_variance_predicted_11 = (1 + 1/x)^3 - 1

    lag: 1/gamma, lag of the predicted position behind a constant jerk j over j T^3; a number above
        1/8 and at most 1e30, in float32 above 1/8 and at most 1e9.

    minimum_variance_alpha: gain of the position, minimum variance. Relative error at most 14.03 *
        2^-52 (float64), 14.01 * 2^-23 (float32), proved for 0.12500000000000003 <= lag <= 1e30
        (float64) and 0.12500001 <= lag <= 1e09 (float32).
    minimum_variance_beta: gain of the velocity times T, minimum variance. Relative error at most
        6.52 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for 0.12500000000000003 <= lag <=
        1e30 (float64) and 0.12500001 <= lag <= 1e09 (float32).
    minimum_variance_gamma: gain of the acceleration times T^2, minimum variance. Relative error at
        most 0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for 0.12500000000000003 <= lag
        <= 1e30 (float64) and 0.12500001 <= lag <= 1e09 (float32).
    minimum_variance_predicted_11: variance of the predicted position over sigma_v^2, minimum
        variance. Relative error at most 13.78 * 2^-52 (float64), 13.76 * 2^-23 (float32), proved
        for 0.12500000000000003 <= lag <= 1e30 (float64) and 0.12500001 <= lag <= 1e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if type(lag) is float and 0.12500000000000003 <= lag <= 1e30 and out is None and workers is ONE:
        try:
            return named(MinimumVarianceByLag, _minimum_variance_by_lag_of_numbers(lag))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MinimumVarianceByLag(*evaluate(_MINIMUM_VARIANCE_BY_LAG, (lag,), out, workers))


def _minimum_variance_by_lag_of_numbers(lag: float, form: Form = Double) -> tuple[float, ...]:
    t1 = form.near_cbrt(lag)
    t4 = form.sqrt(lag * t1)
    t5 = form.sqrt(t4)
    t7 = lag * 0.25
    t8 = t4 * t5
    t13 = ((t5 * t8) - (t7 * t1)) / (t8 - t7)
    t16 = form.sqrt(lag * t13)
    t17 = form.sqrt(t16)
    t18 = t16 * t17
    t23 = ((t17 * t18) - (t7 * t13)) / (t18 - t7)
    t26 = form.sqrt(lag * t23)
    t27 = form.sqrt(t26)
    t28 = t26 * t27
    t33 = ((t27 * t28) - (t7 * t23)) / (t28 - t7)
    t39 = form.sqrt(form.sqrt(lag * t33)) * 2.0
    t48 = ((lag * 8.0) + -1.0) / (((t39 + 1.0) * t39) + 1.0)
    t50 = t48 * (t48 + 1.0)
    t55 = ((t50 * 2.0) + 1.0) / (lag * 4.0)
    t57 = t48 / (lag * 2.0)
    t58 = 1.0 / lag
    t64 = ((((t50 * 3.0) + 1.0) / t48) / t48) / t48
    return (t55, t57, t58, t64)


def _minimum_variance_by_lag_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 0.25,
    n1: float = 2.0,
    n2: float = 8.0,
    n3: float = -1.0,
    n4: float = 1.0,
    n5: float = 4.0,
    n6: float = 3.0,
) -> None:
    (lag,) = given
    (
        minimum_variance_alpha,
        minimum_variance_beta,
        minimum_variance_gamma,
        minimum_variance_predicted_11,
    ) = out
    w0, w1 = work
    t1 = near_cbrt(lag, w0, single)
    t3 = multiply(lag, t1, w1)
    t4 = sqrt(t3, minimum_variance_alpha)
    t5 = sqrt(t4, minimum_variance_beta)
    t7 = multiply(lag, n0, w1)
    t8 = multiply(t4, t5, minimum_variance_alpha)
    t9 = multiply(t5, t8, minimum_variance_beta)
    t10 = multiply(t7, t1, w0)
    t11 = subtract(t9, t10, minimum_variance_beta)
    t12 = subtract(t8, t7, minimum_variance_alpha)
    t13 = divide(t11, t12, minimum_variance_gamma)
    t15 = multiply(lag, t13, w0)
    t16 = sqrt(t15, minimum_variance_predicted_11)
    t17 = sqrt(t16, w0)
    t18 = multiply(t16, t17, minimum_variance_predicted_11)
    t19 = multiply(t17, t18, w0)
    t20 = multiply(t7, t13, minimum_variance_gamma)
    t21 = subtract(t19, t20, w0)
    t22 = subtract(t18, t7, minimum_variance_predicted_11)
    t23 = divide(t21, t22, w0)
    t25 = multiply(lag, t23, minimum_variance_alpha)
    t26 = sqrt(t25, minimum_variance_alpha)
    t27 = sqrt(t26, minimum_variance_beta)
    t28 = multiply(t26, t27, minimum_variance_alpha)
    t29 = multiply(t27, t28, minimum_variance_beta)
    t30 = multiply(t7, t23, w0)
    t31 = subtract(t29, t30, minimum_variance_beta)
    t32 = subtract(t28, t7, minimum_variance_alpha)
    t33 = divide(t31, t32, minimum_variance_beta)
    t35 = multiply(lag, t33, minimum_variance_beta)
    root_of_map = sqrt(t35, minimum_variance_beta)
    root = sqrt(root_of_map, minimum_variance_beta)
    t39 = multiply(root, n1, minimum_variance_beta)
    t41 = multiply(lag, n2, w0)
    t44 = add(t41, n3, w0)
    t45 = add(t39, n4, w1)
    t46 = multiply(t45, t39, w1)
    t47 = add(t46, n4, w1)
    t48 = divide(t44, t47, w0)
    t49 = add(t48, n4, w1)
    t50 = multiply(t48, t49, w1)
    t51 = multiply(t50, n1, minimum_variance_alpha)
    t52 = add(t51, n4, minimum_variance_alpha)
    t54 = multiply(lag, n5, minimum_variance_beta)
    t56 = multiply(lag, n1, minimum_variance_gamma)
    t60 = multiply(t50, n6, w1)
    t61 = add(t60, n4, w1)
    t62 = divide(t61, t48, w1)
    t63 = divide(t62, t48, w1)
    divide(t52, t54, minimum_variance_alpha)
    divide(t48, t56, minimum_variance_beta)
    divide(n4, lag, minimum_variance_gamma)
    divide(t63, t48, minimum_variance_predicted_11)


_MINIMUM_VARIANCE_BY_LAG = Signature(
    "minimum_variance_by_lag",
    (_LAG_DOMAIN,),
    (
        "minimum_variance_alpha",
        "minimum_variance_beta",
        "minimum_variance_gamma",
        "minimum_variance_predicted_11",
    ),
    2,
    _minimum_variance_by_lag_block,
    numbers=_minimum_variance_by_lag_of_numbers,
)


class RandomAccelerationByLag(NamedTuple):
    """Result of `random_acceleration_by_lag`."""

    random_acceleration_alpha: Real
    """Gain of the position, random acceleration."""
    random_acceleration_beta: Real
    """Gain of the velocity times T, random acceleration."""
    random_acceleration_gamma: Real
    """Gain of the acceleration times T^2, random acceleration."""
    random_acceleration_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, random acceleration."""


def random_acceleration_by_lag(
    lag: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> RandomAccelerationByLag:
    """The stable random acceleration filter (RA) of a lag.

        alpha (alpha + beta + gamma/2) = 2 beta, beta^2 = 2 alpha gamma, gamma = 1/lag; with
        x (x + 2)^2 = 64 lag: random_acceleration_predicted_11 =
        4 x (5 x + 6)/((x - 2) (3 x^2 - 4))

    lag: 1/gamma, lag of the predicted position behind a constant jerk j over j T^3; a number above
        1/2 and at most 1e30, in float32 above 1/2 and at most 1e9.

    random_acceleration_alpha: gain of the position, random acceleration. Relative error at most
        10.36 * 2^-52 (float64), 10.34 * 2^-23 (float32), proved for 0.5000000000000001 <= lag <=
        1e30 (float64) and 0.50000006 <= lag <= 1e09 (float32).
    random_acceleration_beta: gain of the velocity times T, random acceleration. Relative error at
        most 5.18 * 2^-52 (float64), 5.17 * 2^-23 (float32), proved for 0.5000000000000001 <= lag <=
        1e30 (float64) and 0.50000006 <= lag <= 1e09 (float32).
    random_acceleration_gamma: gain of the acceleration times T^2, random acceleration. Relative
        error at most 0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for 0.5000000000000001
        <= lag <= 1e30 (float64) and 0.50000006 <= lag <= 1e09 (float32).
    random_acceleration_predicted_11: variance of the predicted position over sigma_v^2, random
        acceleration. Relative error at most 35.39 * 2^-52 (float64), 35.33 * 2^-23 (float32),
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

    Source: derivation alpha-beta-gamma
    """
    if type(lag) is float and 0.5000000000000001 <= lag <= 1e30 and out is None and workers is ONE:
        try:
            return named(RandomAccelerationByLag, _random_acceleration_by_lag_of_numbers(lag))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RandomAccelerationByLag(*evaluate(_RANDOM_ACCELERATION_BY_LAG, (lag,), out, workers))


def _random_acceleration_by_lag_of_numbers(lag: float, form: Form = Double) -> tuple[float, ...]:
    t2 = lag * 0.5
    t5 = form.near_cbrt(lag) + 0.18
    t8 = t5 * 0.25
    t9 = t8 + lag
    t12 = form.sqrt((t9 * t5) + t2)
    t13 = form.sqrt(t12)
    t17 = t8 + ((t9 * 4.0) * 0.25)
    t19 = (t12 * 4.0) * t13
    t24 = ((t13 * t19) - (t17 * t5)) / (t19 - t17)
    t26 = t24 * 0.25
    t27 = t26 + lag
    t30 = form.sqrt((t27 * t24) + t2)
    t31 = form.sqrt(t30)
    t34 = t26 + ((t27 * 4.0) * 0.25)
    t36 = (t30 * 4.0) * t31
    t41 = ((t31 * t36) - (t34 * t24)) / (t36 - t34)
    t43 = t41 * 0.25
    t44 = t43 + lag
    t47 = form.sqrt((t44 * t41) + t2)
    t48 = form.sqrt(t47)
    t51 = t43 + ((t44 * 4.0) * 0.25)
    t53 = (t47 * 4.0) * t48
    t58 = ((t48 * t53) - (t51 * t41)) / (t53 - t51)
    t60 = t58 * 0.25
    t61 = t60 + lag
    t64 = form.sqrt((t61 * t58) + t2)
    t65 = form.sqrt(t64)
    t68 = t60 + ((t61 * 4.0) * 0.25)
    t70 = (t64 * 4.0) * t65
    t75 = ((t65 * t70) - (t68 * t58)) / (t70 - t68)
    t81 = form.sqrt((((t75 * 0.25) + lag) * t75) + t2)
    t82 = form.sqrt(t81)
    t83 = t82 * t82
    t85 = (lag * 4.0) / t83
    t97 = (((lag * 2.0) + -1.0) * 32.0) / (((t85 + 6.0) * t85) + 16.0)
    t103 = ((((t85 * 5.0) + 6.0) * 4.0) * t85) / t97
    t110 = t103 / (((t97 * (t85 + 2.0)) * 3.0) + 8.0)
    t112 = t85 / (t83 * 2.0)
    t113 = 2.0 / t83
    t114 = 1.0 / lag
    return (t112, t113, t114, t110)


def _random_acceleration_by_lag_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 0.5,
    n1: float = 0.18,
    n2: float = 0.25,
    n3: float = 4.0,
    n4: float = 2.0,
    n5: float = -1.0,
    n6: float = 32.0,
    n7: float = 6.0,
    n8: float = 16.0,
    n9: float = 5.0,
    n10: float = 3.0,
    n11: float = 8.0,
    n12: float = 1.0,
) -> None:
    (lag,) = given
    (
        random_acceleration_alpha,
        random_acceleration_beta,
        random_acceleration_gamma,
        random_acceleration_predicted_11,
    ) = out
    w0, w1, w2, w3, w4 = work
    t2 = multiply(lag, n0, w0)
    t3 = near_cbrt(lag, w1, single)
    t5 = add(t3, n1, w1)
    t8 = multiply(t5, n2, w2)
    t9 = add(t8, lag, w3)
    t10 = multiply(t9, t5, w4)
    t11 = add(t10, t2, w4)
    t12 = sqrt(t11, random_acceleration_predicted_11)
    t13 = sqrt(t12, random_acceleration_alpha)
    t15 = multiply(t9, n3, w3)
    t16 = multiply(t15, n2, w3)
    t17 = add(t8, t16, w2)
    t18 = multiply(t12, n3, random_acceleration_predicted_11)
    t19 = multiply(t18, t13, random_acceleration_predicted_11)
    t20 = multiply(t13, t19, random_acceleration_alpha)
    t21 = multiply(t17, t5, w1)
    t22 = subtract(t20, t21, random_acceleration_alpha)
    t23 = subtract(t19, t17, random_acceleration_predicted_11)
    t24 = divide(t22, t23, random_acceleration_beta)
    t26 = multiply(t24, n2, w1)
    t27 = add(t26, lag, w2)
    t28 = multiply(t27, t24, w3)
    t29 = add(t28, t2, w3)
    t30 = sqrt(t29, random_acceleration_gamma)
    t31 = sqrt(t30, w3)
    t32 = multiply(t27, n3, w2)
    t33 = multiply(t32, n2, w2)
    t34 = add(t26, t33, w1)
    t35 = multiply(t30, n3, random_acceleration_gamma)
    t36 = multiply(t35, t31, random_acceleration_gamma)
    t37 = multiply(t31, t36, w3)
    t38 = multiply(t34, t24, random_acceleration_beta)
    t39 = subtract(t37, t38, w3)
    t40 = subtract(t36, t34, random_acceleration_gamma)
    t41 = divide(t39, t40, w3)
    t43 = multiply(t41, n2, w1)
    t44 = add(t43, lag, w2)
    t45 = multiply(t44, t41, w4)
    t46 = add(t45, t2, w4)
    t47 = sqrt(t46, w4)
    t48 = sqrt(t47, random_acceleration_alpha)
    t49 = multiply(t44, n3, w2)
    t50 = multiply(t49, n2, w2)
    t51 = add(t43, t50, w1)
    t52 = multiply(t47, n3, w4)
    t53 = multiply(t52, t48, w4)
    t54 = multiply(t48, t53, random_acceleration_alpha)
    t55 = multiply(t51, t41, w3)
    t56 = subtract(t54, t55, random_acceleration_alpha)
    t57 = subtract(t53, t51, w4)
    t58 = divide(t56, t57, random_acceleration_alpha)
    t60 = multiply(t58, n2, w1)
    t61 = add(t60, lag, w2)
    t62 = multiply(t61, t58, w3)
    t63 = add(t62, t2, w3)
    t64 = sqrt(t63, w3)
    t65 = sqrt(t64, w4)
    t66 = multiply(t61, n3, w2)
    t67 = multiply(t66, n2, w2)
    t68 = add(t60, t67, w1)
    t69 = multiply(t64, n3, w3)
    t70 = multiply(t69, t65, w3)
    t71 = multiply(t65, t70, w4)
    t72 = multiply(t68, t58, random_acceleration_alpha)
    t73 = subtract(t71, t72, w4)
    t74 = subtract(t70, t68, w3)
    t75 = divide(t73, t74, w4)
    t77 = multiply(t75, n2, w1)
    t78 = add(t77, lag, w1)
    t79 = multiply(t78, t75, w1)
    t80 = add(t79, t2, w1)
    root_of_map = sqrt(t80, w1)
    root = sqrt(root_of_map, w1)
    t83 = square(root, w1)
    t84 = multiply(lag, n3, w0)
    t85 = divide(t84, t83, w0)
    t86 = multiply(lag, n4, w2)
    t89 = add(t86, n5, w2)
    t91 = multiply(t89, n6, w2)
    t93 = add(t85, n7, w3)
    t94 = multiply(t93, t85, w3)
    t96 = add(t94, n8, w3)
    t97 = divide(t91, t96, w2)
    t99 = multiply(t85, n9, w3)
    t100 = add(t99, n7, w3)
    t101 = multiply(t100, n3, w3)
    t102 = multiply(t101, t85, w3)
    t103 = divide(t102, t97, w3)
    t104 = add(t85, n4, w4)
    t105 = multiply(t97, t104, w2)
    t107 = multiply(t105, n10, w2)
    t109 = add(t107, n11, w2)
    t111 = multiply(t83, n4, w4)
    divide(t103, t109, random_acceleration_predicted_11)
    divide(t85, t111, random_acceleration_alpha)
    divide(n4, t83, random_acceleration_beta)
    divide(n12, lag, random_acceleration_gamma)


_RANDOM_ACCELERATION_BY_LAG = Signature(
    "random_acceleration_by_lag",
    (_LAG_DOMAIN_2,),
    (
        "random_acceleration_alpha",
        "random_acceleration_beta",
        "random_acceleration_gamma",
        "random_acceleration_predicted_11",
    ),
    5,
    _random_acceleration_by_lag_block,
    numbers=_random_acceleration_by_lag_of_numbers,
)


class RandomJerkByLag(NamedTuple):
    """Result of `random_jerk_by_lag`."""

    random_jerk_alpha: Real
    """Gain of the position, random jerk."""
    random_jerk_beta: Real
    """Gain of the velocity times T, random jerk."""
    random_jerk_gamma: Real
    """Gain of the acceleration times T^2, random jerk."""


def random_jerk_by_lag(
    lag: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> RandomJerkByLag:
    """The random jerk filter (RJ) of a lag.

        2 alpha gamma - beta^2 = gamma^2/12, gamma = 1/lag,
        2 alpha^2 + 2 alpha beta - 4 beta + alpha gamma = gamma^2/18; with x = 2 beta/gamma:
        192 lag x = 3 x^4 + 12 x^3 + 14 x^2 + 4 x - 1, alpha = (3 x^2 + 1)/(24 lag);
        alpha is below 1, as of a Kalman filter, for lags above (2 + sqrt(3))/6

    lag: 1/gamma, lag of the predicted position behind a constant jerk j over j T^3; a number above
        69/128 and at most 1e30, in float32 above 69/128 and at most 1e9.

    random_jerk_alpha: gain of the position, random jerk. Relative error at most 16.34 * 2^-52
        (float64), 16.60 * 2^-23 (float32), proved for 0.5390625000000001 <= lag <= 1e30 (float64)
        and 0.53906256 <= lag <= 1e09 (float32).
    random_jerk_beta: gain of the velocity times T, random jerk. Relative error at most 7.42 * 2^-52
        (float64), 7.51 * 2^-23 (float32), proved for 0.5390625000000001 <= lag <= 1e30 (float64)
        and 0.53906256 <= lag <= 1e09 (float32).
    random_jerk_gamma: gain of the acceleration times T^2, random jerk. Relative error at most 0.51
        * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for 0.5390625000000001 <= lag <= 1e30
        (float64) and 0.53906256 <= lag <= 1e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if type(lag) is float and 0.5390625000000001 <= lag <= 1e30 and out is None and workers is ONE:
        try:
            return named(RandomJerkByLag, _random_jerk_by_lag_of_numbers(lag))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RandomJerkByLag(*evaluate(_RANDOM_JERK_BY_LAG, (lag,), out, workers))


def _random_jerk_by_lag_of_numbers(lag: float, form: Form = Double) -> tuple[float, ...]:
    t2 = lag * 4.0
    t3 = form.near_cbrt(t2)
    t6 = form.sqrt(t2 * t3)
    t7 = form.sqrt(t6)
    t9 = t2 * 0.25
    t10 = t6 * t7
    t15 = ((t7 * t10) - (t9 * t3)) / (t10 - t9)
    t18 = form.sqrt(t2 * t15)
    t19 = form.sqrt(t18)
    t20 = t18 * t19
    t25 = ((t19 * t20) - (t9 * t15)) / (t20 - t9)
    t28 = form.sqrt(t2 * t25)
    t29 = form.sqrt(t28)
    t30 = t28 * t29
    t35 = ((t29 * t30) - (t9 * t25)) / (t30 - t9)
    t39 = form.sqrt(form.sqrt(t2 * t35))
    t43 = t39 + 1.0
    t46 = (t2 + -1.0) / ((t43 * t39) + 1.0)
    t47 = t39 * t39
    t51 = t47 * ((t39 * t46) + 0.3333333333333333)
    t52 = t46 * t43
    t61 = ((t52 + 0.6666666666666666) * t39) * 2.0
    t70 = (((t39 + 0.64) * t39) + 0.2) / ((t47 * t39) * 0.26)
    t71 = t61 / t51
    t72 = ((t52 * 6.0) + 5.666666666666667) / t51
    t74 = (t39 * 4.0) / t51
    t75 = 1.0 / t51
    t77 = (t71 * t71) + t72
    t81 = ((t71 * t77) + (t72 * t71)) + t74
    t86 = ((t71 * t81) + (t72 * t77)) + (t74 * t71)
    t87 = t86 + t75
    t92 = ((t71 * t87) + (t72 * t81)) + (t74 * t77)
    t94 = t92 + (t75 * t71)
    t99 = ((t72 * t87) + (t74 * t81)) + (t75 * t77)
    t102 = (t74 * t87) + (t75 * t81)
    t103 = t75 * t87
    t105 = t94 * t70
    t107 = (t105 + t99) * t70
    t108 = t107 + t102
    t111 = form.sqrt((t108 * t70) + t103)
    t112 = form.sqrt(t111)
    t113 = form.sqrt(t112)
    t119 = ((t105 * t70) * 0.125) + (t107 * 0.125)
    t120 = t119 + (t108 * 0.125)
    t122 = (t111 * t112) * t113
    t127 = ((t113 * t122) - (t120 * t70)) / (t122 - t120)
    t129 = t94 * t127
    t131 = (t129 + t99) * t127
    t132 = t131 + t102
    t135 = form.sqrt((t132 * t127) + t103)
    t136 = form.sqrt(t135)
    t137 = form.sqrt(t136)
    t142 = ((t129 * t127) * 0.125) + (t131 * 0.125)
    t143 = t142 + (t132 * 0.125)
    t145 = (t135 * t136) * t137
    t150 = ((t137 * t145) - (t143 * t127)) / (t145 - t143)
    t152 = t94 * t150
    t154 = (t152 + t99) * t150
    t155 = t154 + t102
    t158 = form.sqrt((t155 * t150) + t103)
    t159 = form.sqrt(t158)
    t160 = form.sqrt(t159)
    t165 = ((t152 * t150) * 0.125) + (t154 * 0.125)
    t166 = t165 + (t155 * 0.125)
    t168 = (t158 * t159) * t160
    t173 = ((t160 * t168) - (t166 * t150)) / (t168 - t166)
    t175 = t94 * t173
    t177 = (t175 + t99) * t173
    t178 = t177 + t102
    t181 = form.sqrt((t178 * t173) + t103)
    t182 = form.sqrt(t181)
    t183 = form.sqrt(t182)
    t188 = ((t175 * t173) * 0.125) + (t177 * 0.125)
    t189 = t188 + (t178 * 0.125)
    t191 = (t181 * t182) * t183
    t196 = ((t183 * t191) - (t189 * t173)) / (t191 - t189)
    t202 = ((((t94 * t196) + t99) * t196) + t102) * t196
    t206 = form.sqrt(form.sqrt(form.sqrt(t202 + t103)))
    t210 = ((t46 + (1.0 / t206)) * 2.0) + 1.0
    t217 = (((t210 * t210) * 3.0) + 1.0) / (lag * 24.0)
    t219 = t210 / (lag * 2.0)
    t220 = 1.0 / lag
    return (t217, t219, t220)


def _random_jerk_by_lag_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 4.0,
    n1: float = 0.25,
    n2: float = -1.0,
    n3: float = 1.0,
    n4: float = 0.3333333333333333,
    n5: float = 6.0,
    n6: float = 5.666666666666667,
    n7: float = 0.6666666666666666,
    n8: float = 2.0,
    n9: float = 0.64,
    n10: float = 0.2,
    n11: float = 0.26,
    n12: float = 0.125,
    n13: float = 3.0,
    n14: float = 24.0,
) -> None:
    (lag,) = given
    random_jerk_alpha, random_jerk_beta, random_jerk_gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    t2 = multiply(lag, n0, w0)
    t3 = near_cbrt(t2, w1, single)
    t5 = multiply(t2, t3, w2)
    t6 = sqrt(t5, random_jerk_alpha)
    t7 = sqrt(t6, random_jerk_beta)
    t9 = multiply(t2, n1, w2)
    t10 = multiply(t6, t7, random_jerk_alpha)
    t11 = multiply(t7, t10, random_jerk_beta)
    t12 = multiply(t9, t3, w1)
    t13 = subtract(t11, t12, random_jerk_beta)
    t14 = subtract(t10, t9, random_jerk_alpha)
    t15 = divide(t13, t14, random_jerk_gamma)
    t17 = multiply(t2, t15, w1)
    t18 = sqrt(t17, w1)
    t19 = sqrt(t18, random_jerk_alpha)
    t20 = multiply(t18, t19, w1)
    t21 = multiply(t19, t20, random_jerk_alpha)
    t22 = multiply(t9, t15, random_jerk_gamma)
    t23 = subtract(t21, t22, random_jerk_alpha)
    t24 = subtract(t20, t9, w1)
    t25 = divide(t23, t24, random_jerk_alpha)
    t27 = multiply(t2, t25, w1)
    t28 = sqrt(t27, w1)
    t29 = sqrt(t28, random_jerk_beta)
    t30 = multiply(t28, t29, w1)
    t31 = multiply(t29, t30, random_jerk_beta)
    t32 = multiply(t9, t25, random_jerk_alpha)
    t33 = subtract(t31, t32, random_jerk_beta)
    t34 = subtract(t30, t9, w1)
    t35 = divide(t33, t34, random_jerk_beta)
    t37 = multiply(t2, t35, random_jerk_beta)
    c_of_map = sqrt(t37, random_jerk_beta)
    c = sqrt(c_of_map, random_jerk_beta)
    t42 = add(t2, n2, w0)
    t43 = add(c, n3, w1)
    t44 = multiply(t43, c, w2)
    t45 = add(t44, n3, w2)
    t46 = divide(t42, t45, w0)
    t47 = square(c, w2)
    t48 = multiply(c, t46, random_jerk_alpha)
    t50 = add(t48, n4, random_jerk_alpha)
    t51 = multiply(t47, t50, random_jerk_alpha)
    t52 = multiply(t46, t43, w1)
    t54 = multiply(t52, n5, random_jerk_gamma)
    t56 = add(t54, n6, random_jerk_gamma)
    t58 = add(t52, n7, w1)
    t59 = multiply(t58, c, w1)
    t61 = multiply(t59, n8, w1)
    t63 = add(c, n9, w3)
    t64 = multiply(t63, c, w3)
    t66 = add(t64, n10, w3)
    t67 = multiply(t47, c, w2)
    t69 = multiply(t67, n11, w2)
    t70 = divide(t66, t69, w3)
    t71 = divide(t61, t51, w1)
    t72 = divide(t56, t51, random_jerk_gamma)
    t73 = multiply(c, n0, random_jerk_beta)
    t74 = divide(t73, t51, random_jerk_beta)
    t75 = divide(n3, t51, random_jerk_alpha)
    t76 = square(t71, w2)
    t77 = add(t76, t72, w2)
    t78 = multiply(t71, t77, w4)
    t79 = multiply(t72, t71, w5)
    t80 = add(t78, t79, w4)
    t81 = add(t80, t74, w4)
    t82 = multiply(t71, t81, w5)
    t83 = multiply(t72, t77, w6)
    t84 = add(t82, t83, w5)
    t85 = multiply(t74, t71, w6)
    t86 = add(t84, t85, w5)
    t87 = add(t86, t75, w5)
    t88 = multiply(t71, t87, w6)
    t89 = multiply(t72, t81, w7)
    t90 = add(t88, t89, w6)
    t91 = multiply(t74, t77, w7)
    t92 = add(t90, t91, w6)
    t93 = multiply(t75, t71, w1)
    t94 = add(t92, t93, w6)
    t95 = multiply(t72, t87, random_jerk_gamma)
    t96 = multiply(t74, t81, w1)
    t97 = add(t95, t96, random_jerk_gamma)
    t98 = multiply(t75, t77, w2)
    t99 = add(t97, t98, random_jerk_gamma)
    t100 = multiply(t74, t87, random_jerk_beta)
    t101 = multiply(t75, t81, w4)
    t102 = add(t100, t101, random_jerk_beta)
    t103 = multiply(t75, t87, random_jerk_alpha)
    t105 = multiply(t94, t70, w1)
    t106 = add(t105, t99, w2)
    t107 = multiply(t106, t70, w2)
    t108 = add(t107, t102, w4)
    t109 = multiply(t108, t70, w5)
    t110 = add(t109, t103, w5)
    t111 = sqrt(t110, w5)
    t112 = sqrt(t111, w7)
    t113 = sqrt(t112, w8)
    t115 = multiply(t105, t70, w1)
    t116 = multiply(t115, n12, w1)
    t117 = multiply(t107, n12, w2)
    t118 = multiply(t108, n12, w4)
    t119 = add(t116, t117, w1)
    t120 = add(t119, t118, w1)
    t121 = multiply(t111, t112, w5)
    t122 = multiply(t121, t113, w5)
    t123 = multiply(t113, t122, w8)
    t124 = multiply(t120, t70, w3)
    t125 = subtract(t123, t124, w8)
    t126 = subtract(t122, t120, w5)
    t127 = divide(t125, t126, w8)
    t129 = multiply(t94, t127, w1)
    t130 = add(t129, t99, w2)
    t131 = multiply(t130, t127, w2)
    t132 = add(t131, t102, w3)
    t133 = multiply(t132, t127, w4)
    t134 = add(t133, t103, w4)
    t135 = sqrt(t134, w4)
    t136 = sqrt(t135, w5)
    t137 = sqrt(t136, w7)
    t138 = multiply(t129, t127, w1)
    t139 = multiply(t138, n12, w1)
    t140 = multiply(t131, n12, w2)
    t141 = multiply(t132, n12, w3)
    t142 = add(t139, t140, w1)
    t143 = add(t142, t141, w1)
    t144 = multiply(t135, t136, w4)
    t145 = multiply(t144, t137, w4)
    t146 = multiply(t137, t145, w7)
    t147 = multiply(t143, t127, w8)
    t148 = subtract(t146, t147, w7)
    t149 = subtract(t145, t143, w4)
    t150 = divide(t148, t149, w7)
    t152 = multiply(t94, t150, w1)
    t153 = add(t152, t99, w2)
    t154 = multiply(t153, t150, w2)
    t155 = add(t154, t102, w3)
    t156 = multiply(t155, t150, w4)
    t157 = add(t156, t103, w4)
    t158 = sqrt(t157, w4)
    t159 = sqrt(t158, w5)
    t160 = sqrt(t159, w8)
    t161 = multiply(t152, t150, w1)
    t162 = multiply(t161, n12, w1)
    t163 = multiply(t154, n12, w2)
    t164 = multiply(t155, n12, w3)
    t165 = add(t162, t163, w1)
    t166 = add(t165, t164, w1)
    t167 = multiply(t158, t159, w4)
    t168 = multiply(t167, t160, w4)
    t169 = multiply(t160, t168, w8)
    t170 = multiply(t166, t150, w7)
    t171 = subtract(t169, t170, w8)
    t172 = subtract(t168, t166, w4)
    t173 = divide(t171, t172, w8)
    t175 = multiply(t94, t173, w1)
    t176 = add(t175, t99, w2)
    t177 = multiply(t176, t173, w2)
    t178 = add(t177, t102, w3)
    t179 = multiply(t178, t173, w4)
    t180 = add(t179, t103, w4)
    t181 = sqrt(t180, w4)
    t182 = sqrt(t181, w5)
    t183 = sqrt(t182, w7)
    t184 = multiply(t175, t173, w1)
    t185 = multiply(t184, n12, w1)
    t186 = multiply(t177, n12, w2)
    t187 = multiply(t178, n12, w3)
    t188 = add(t185, t186, w1)
    t189 = add(t188, t187, w1)
    t190 = multiply(t181, t182, w4)
    t191 = multiply(t190, t183, w4)
    t192 = multiply(t183, t191, w7)
    t193 = multiply(t189, t173, w8)
    t194 = subtract(t192, t193, w7)
    t195 = subtract(t191, t189, w4)
    t196 = divide(t194, t195, w7)
    t198 = multiply(t94, t196, w6)
    t199 = add(t198, t99, w6)
    t200 = multiply(t199, t196, w6)
    t201 = add(t200, t102, w6)
    t202 = multiply(t201, t196, w6)
    t203 = add(t202, t103, w6)
    z_inside = sqrt(t203, w6)
    z_of_map = sqrt(z_inside, w6)
    z = sqrt(z_of_map, w6)
    t207 = divide(n3, z, w6)
    t208 = add(t46, t207, w0)
    t209 = multiply(t208, n8, w0)
    t210 = add(t209, n3, w0)
    t211 = square(t210, w1)
    t213 = multiply(t211, n13, w1)
    t214 = add(t213, n3, w1)
    t216 = multiply(lag, n14, w2)
    t218 = multiply(lag, n8, w3)
    divide(t214, t216, random_jerk_alpha)
    divide(t210, t218, random_jerk_beta)
    divide(n3, lag, random_jerk_gamma)


_RANDOM_JERK_BY_LAG = Signature(
    "random_jerk_by_lag",
    (_LAG_DOMAIN_3,),
    ("random_jerk_alpha", "random_jerk_beta", "random_jerk_gamma"),
    9,
    _random_jerk_by_lag_block,
    numbers=_random_jerk_by_lag_of_numbers,
)


class RandomAccelerationByGain(NamedTuple):
    """Result of `random_acceleration_by_gain`."""

    random_acceleration_beta: Real
    """Gain of the velocity times T, random acceleration."""
    random_acceleration_gamma: Real
    """Gain of the acceleration times T^2, random acceleration."""
    random_acceleration_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, random acceleration."""


def random_acceleration_by_gain(
    alpha: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> RandomAccelerationByGain:
    """The stable random acceleration filter (RA) of a position gain.

        beta = 2 (1 - w)^2, gamma = beta^2/(2 alpha), w = sqrt(1 - alpha),
        random_acceleration_predicted_11 = alpha (4 + w)/(w (1 + 4 w + w^2))

    alpha: gain of the position; a number at least 1e-15 and below 1, in float32 at least 1e-6 and
        below 1.

    random_acceleration_beta: gain of the velocity times T, random acceleration. Relative error at
        most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32), proved for 1e-15 <= alpha <=
        0.9999999999999999 (float64) and 1e-06 <= alpha <= 0.99999994 (float32).
    random_acceleration_gamma: gain of the acceleration times T^2, random acceleration. Relative
        error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for 1e-15 <= alpha <=
        0.9999999999999999 (float64) and 1e-06 <= alpha <= 0.99999994 (float32).
    random_acceleration_predicted_11: variance of the predicted position over sigma_v^2, random
        acceleration. Relative error at most 3.86 * 2^-52 (float64), 3.86 * 2^-23 (float32), proved
        for 1e-15 <= alpha <= 0.9999999999999999 (float64) and 1e-06 <= alpha <= 0.99999994
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
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
    t5 = alpha / (t3 + 1.0)
    t6 = t5 * t5
    t13 = t3 + 4.0
    t8 = t6 * 2.0
    t11 = ((t6 * t6) * 2.0) / alpha
    t18 = (alpha * t13) / (t3 * ((t13 * t3) + 1.0))
    return (t8, t11, t18)


def _random_acceleration_by_gain_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 4.0,
) -> None:
    (alpha,) = given
    random_acceleration_beta, random_acceleration_gamma, random_acceleration_predicted_11 = out
    w0, w1, w2 = work
    t2 = subtract(n0, alpha, w0)
    root = sqrt(t2, random_acceleration_beta)
    t4 = add(root, n0, w0)
    t5 = divide(alpha, t4, random_acceleration_gamma)
    t6 = square(t5, random_acceleration_gamma)
    t9 = square(t6, w0)
    t10 = multiply(t9, n1, w0)
    t13 = add(root, n2, w1)
    t14 = multiply(alpha, t13, w2)
    t15 = multiply(t13, root, w1)
    t16 = add(t15, n0, w1)
    t17 = multiply(root, t16, w1)
    multiply(t6, n1, random_acceleration_beta)
    divide(t10, alpha, random_acceleration_gamma)
    divide(t14, t17, random_acceleration_predicted_11)


_RANDOM_ACCELERATION_BY_GAIN = Signature(
    "random_acceleration_by_gain",
    (_ALPHA_DOMAIN_3,),
    ("random_acceleration_beta", "random_acceleration_gamma", "random_acceleration_predicted_11"),
    3,
    _random_acceleration_by_gain_block,
    numbers=_random_acceleration_by_gain_of_numbers,
)


class RandomJerkByGain(NamedTuple):
    """Result of `random_jerk_by_gain`."""

    random_jerk_beta: Real
    """Gain of the velocity times T, random jerk."""
    random_jerk_gamma: Real
    """Gain of the acceleration times T^2, random jerk."""
    random_jerk_predicted_11: Real
    """Variance of the predicted position over sigma_v^2, random jerk."""


def random_jerk_by_gain(
    alpha: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> RandomJerkByGain:
    """The random jerk filter (RJ) of a position gain.

        2 alpha gamma - beta^2 = gamma^2/12,
        2 alpha^2 + 2 alpha beta - 4 beta + alpha gamma = gamma^2/18; with x = 2 beta/gamma:
        alpha = 8 x (3 x^2 + 1)/(3 x^4 + 12 x^3 + 14 x^2 + 4 x - 1),
        random_jerk_predicted_11 = (1 + x + y + d) (x (1 + x) + m)/(d m) - 1 with
        y = (d + m)/x, d = (3 x^4 - 10 x^2 - 1)/(24 x), m = (9 x^2 - 1) (x^2 - 1)/(24 x)

    alpha: gain of the position; a number at least 1e-15 and below 1, in float32 at least 1e-6 and
        below 1.

    random_jerk_beta: gain of the velocity times T, random jerk. Relative error at most 17.06 *
        2^-52 (float64), 17.09 * 2^-23 (float32), proved for 1e-15 <= alpha <= 0.9999999999999999
        (float64) and 1e-06 <= alpha <= 0.99999994 (float32).
    random_jerk_gamma: gain of the acceleration times T^2, random jerk. Relative error at most 21.34
        * 2^-52 (float64), 21.36 * 2^-23 (float32), proved for 1e-15 <= alpha <= 0.9999999999999999
        (float64) and 1e-06 <= alpha <= 0.99999994 (float32).
    random_jerk_predicted_11: variance of the predicted position over sigma_v^2, random jerk.
        Relative error at most 14.34 * 2^-52 (float64), 14.60 * 2^-23 (float32), proved for 1e-15 <=
        alpha <= 0.9999999999999999 (float64) and 1e-06 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation alpha-beta-gamma
    """
    if (
        type(alpha) is float
        and 1e-15 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(RandomJerkByGain, _random_jerk_by_gain_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RandomJerkByGain(*evaluate(_RANDOM_JERK_BY_GAIN, (alpha,), out, workers))


def _random_jerk_by_gain_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.0 - alpha
    t4 = alpha * 3.0
    t7 = (t2 * 17.0) + 1.0
    t17 = t7 + (((t2 * alpha) * 1.6) / (t2 + 0.075))
    t20 = form.sqrt(((t2 * t2) * 36.0) + (t4 * t17))
    t25 = alpha * alpha
    t27 = t2 * 4.0
    t29 = (t7 * alpha) / 3.0
    t33 = ((t2 * 10.0) * t25) / 3.0
    t38 = ((t2 * 2.0) * (t25 * alpha)) / 3.0
    t40 = (t27 * t27) + t29
    t44 = ((t27 * t40) + (t29 * t27)) + t33
    t49 = ((t27 * t44) + (t29 * t40)) + (t33 * t27)
    t50 = t49 + t38
    t55 = ((t27 * t50) + (t29 * t44)) + (t33 * t40)
    t57 = t55 + (t38 * t27)
    t62 = ((t29 * t50) + (t33 * t44)) + (t38 * t40)
    t65 = (t33 * t50) + (t38 * t44)
    t66 = t38 * t50
    t67 = (((t2 * 6.0) + t20) / t4) * alpha
    t69 = t57 * t67
    t71 = (t69 + t62) * t67
    t72 = t71 + t65
    t75 = form.sqrt((t72 * t67) + t66)
    t76 = form.sqrt(t75)
    t77 = form.sqrt(t76)
    t83 = ((t69 * t67) * 0.125) + (t71 * 0.125)
    t84 = t83 + (t72 * 0.125)
    t86 = (t75 * t76) * t77
    t91 = ((t77 * t86) - (t84 * t67)) / (t86 - t84)
    t93 = t57 * t91
    t95 = (t93 + t62) * t91
    t96 = t95 + t65
    t99 = form.sqrt((t96 * t91) + t66)
    t100 = form.sqrt(t99)
    t101 = form.sqrt(t100)
    t106 = ((t93 * t91) * 0.125) + (t95 * 0.125)
    t107 = t106 + (t96 * 0.125)
    t109 = (t99 * t100) * t101
    t114 = ((t101 * t109) - (t107 * t91)) / (t109 - t107)
    t116 = t57 * t114
    t118 = (t116 + t62) * t114
    t119 = t118 + t65
    t122 = form.sqrt((t119 * t114) + t66)
    t123 = form.sqrt(t122)
    t124 = form.sqrt(t123)
    t129 = ((t116 * t114) * 0.125) + (t118 * 0.125)
    t130 = t129 + (t119 * 0.125)
    t132 = (t122 * t123) * t124
    t137 = ((t124 * t132) - (t130 * t114)) / (t132 - t130)
    t139 = t57 * t137
    t141 = (t139 + t62) * t137
    t142 = t141 + t65
    t145 = form.sqrt((t142 * t137) + t66)
    t146 = form.sqrt(t145)
    t147 = form.sqrt(t146)
    t152 = ((t139 * t137) * 0.125) + (t141 * 0.125)
    t153 = t152 + (t142 * 0.125)
    t155 = (t145 * t146) * t147
    t160 = ((t147 * t155) - (t153 * t137)) / (t155 - t153)
    t166 = ((((t57 * t160) + t62) * t160) + t65) * t160
    t170 = form.sqrt(form.sqrt(form.sqrt(t166 + t66)))
    t171 = t170 / alpha
    t173 = (t171 * 2.0) + 1.0
    t174 = t171 + 1.0
    t175 = t174 * t174
    t176 = t171 * 3.0
    t179 = ((t176 + 6.0) * t171) + 2.0
    t180 = t175 * t179
    t185 = t173 * 3.0
    t186 = ((t2 * (t175 / t171)) * (t179 / t171)) * t175
    t194 = ((t176 + 1.0) * (t176 + 2.0)) * (t171 * t174)
    t196 = (t194 * 2.0) / t185
    t203 = t173 + 1.0
    t204 = t173 * t203
    t205 = t204 + t196
    t209 = t205 / (((t186 * 2.0) + t173) / t185)
    t212 = ((t196 + (t204 * t203)) / t196) + (t209 * (t205 / t196))
    t199 = ((t173 * t173) * 6.0) / t180
    t202 = (t173 * 12.0) / t180
    t213 = t212 / t173
    return (t199, t202, t213)


def _random_jerk_by_gain_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 3.0,
    n2: float = 17.0,
    n3: float = 1.6,
    n4: float = 0.075,
    n5: float = 36.0,
    n6: float = 6.0,
    n7: float = 4.0,
    n8: float = 10.0,
    n9: float = 2.0,
    n10: float = 0.125,
    n11: float = 12.0,
) -> None:
    (alpha,) = given
    random_jerk_beta, random_jerk_gamma, random_jerk_predicted_11 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    t2 = subtract(n0, alpha, w0)
    t4 = multiply(alpha, n1, w1)
    t6 = multiply(t2, n2, w2)
    t7 = add(t6, n0, w2)
    t8 = multiply(t2, alpha, w3)
    t10 = multiply(t8, n3, w3)
    t12 = add(t2, n4, w4)
    t13 = divide(t10, t12, random_jerk_beta)
    t14 = square(t2, w3)
    t16 = multiply(t14, n5, w3)
    t17 = add(t7, t13, random_jerk_beta)
    t18 = multiply(t4, t17, random_jerk_beta)
    t19 = add(t16, t18, w3)
    half = sqrt(t19, random_jerk_gamma)
    t22 = multiply(t2, n6, w3)
    t23 = add(t22, half, w3)
    t24 = divide(t23, t4, random_jerk_predicted_11)
    t25 = square(alpha, w1)
    t27 = multiply(t2, n7, w3)
    t28 = multiply(t7, alpha, w2)
    t29 = divide(t28, n1, w2)
    t31 = multiply(t2, n8, w4)
    t32 = multiply(t31, t25, w4)
    t33 = divide(t32, n1, w4)
    t35 = multiply(t2, n9, random_jerk_beta)
    t36 = multiply(t25, alpha, w1)
    t37 = multiply(t35, t36, random_jerk_beta)
    t38 = divide(t37, n1, random_jerk_beta)
    t39 = square(t27, w1)
    t40 = add(t39, t29, w1)
    t41 = multiply(t27, t40, random_jerk_gamma)
    t42 = multiply(t29, t27, w5)
    t43 = add(t41, t42, random_jerk_gamma)
    t44 = add(t43, t33, random_jerk_gamma)
    t45 = multiply(t27, t44, w5)
    t46 = multiply(t29, t40, w6)
    t47 = add(t45, t46, w5)
    t48 = multiply(t33, t27, w6)
    t49 = add(t47, t48, w5)
    t50 = add(t49, t38, w5)
    t51 = multiply(t27, t50, w6)
    t52 = multiply(t29, t44, w7)
    t53 = add(t51, t52, w6)
    t54 = multiply(t33, t40, w7)
    t55 = add(t53, t54, w6)
    t56 = multiply(t38, t27, w3)
    t57 = add(t55, t56, w6)
    t58 = multiply(t29, t50, w2)
    t59 = multiply(t33, t44, w3)
    t60 = add(t58, t59, w2)
    t61 = multiply(t38, t40, w1)
    t62 = add(t60, t61, w2)
    t63 = multiply(t33, t50, w4)
    t64 = multiply(t38, t44, random_jerk_gamma)
    t65 = add(t63, t64, w4)
    t66 = multiply(t38, t50, random_jerk_beta)
    t67 = multiply(t24, alpha, random_jerk_predicted_11)
    t69 = multiply(t57, t67, w1)
    t70 = add(t69, t62, w3)
    t71 = multiply(t70, t67, w3)
    t72 = add(t71, t65, w5)
    t73 = multiply(t72, t67, w7)
    t74 = add(t73, t66, w7)
    t75 = sqrt(t74, w7)
    t76 = sqrt(t75, random_jerk_gamma)
    t77 = sqrt(t76, w8)
    t79 = multiply(t69, t67, w1)
    t80 = multiply(t79, n10, w1)
    t81 = multiply(t71, n10, w3)
    t82 = multiply(t72, n10, w5)
    t83 = add(t80, t81, w1)
    t84 = add(t83, t82, w1)
    t85 = multiply(t75, t76, w7)
    t86 = multiply(t85, t77, w7)
    t87 = multiply(t77, t86, w8)
    t88 = multiply(t84, t67, random_jerk_predicted_11)
    t89 = subtract(t87, t88, w8)
    t90 = subtract(t86, t84, w7)
    t91 = divide(t89, t90, w8)
    t93 = multiply(t57, t91, w1)
    t94 = add(t93, t62, w3)
    t95 = multiply(t94, t91, w3)
    t96 = add(t95, t65, w5)
    t97 = multiply(t96, t91, w7)
    t98 = add(t97, t66, w7)
    t99 = sqrt(t98, w7)
    t100 = sqrt(t99, random_jerk_gamma)
    t101 = sqrt(t100, random_jerk_predicted_11)
    t102 = multiply(t93, t91, w1)
    t103 = multiply(t102, n10, w1)
    t104 = multiply(t95, n10, w3)
    t105 = multiply(t96, n10, w5)
    t106 = add(t103, t104, w1)
    t107 = add(t106, t105, w1)
    t108 = multiply(t99, t100, w7)
    t109 = multiply(t108, t101, w7)
    t110 = multiply(t101, t109, random_jerk_predicted_11)
    t111 = multiply(t107, t91, w8)
    t112 = subtract(t110, t111, random_jerk_predicted_11)
    t113 = subtract(t109, t107, w7)
    t114 = divide(t112, t113, random_jerk_predicted_11)
    t116 = multiply(t57, t114, w1)
    t117 = add(t116, t62, w3)
    t118 = multiply(t117, t114, w3)
    t119 = add(t118, t65, w5)
    t120 = multiply(t119, t114, w7)
    t121 = add(t120, t66, w7)
    t122 = sqrt(t121, w7)
    t123 = sqrt(t122, w8)
    t124 = sqrt(t123, random_jerk_gamma)
    t125 = multiply(t116, t114, w1)
    t126 = multiply(t125, n10, w1)
    t127 = multiply(t118, n10, w3)
    t128 = multiply(t119, n10, w5)
    t129 = add(t126, t127, w1)
    t130 = add(t129, t128, w1)
    t131 = multiply(t122, t123, w7)
    t132 = multiply(t131, t124, w7)
    t133 = multiply(t124, t132, random_jerk_gamma)
    t134 = multiply(t130, t114, random_jerk_predicted_11)
    t135 = subtract(t133, t134, random_jerk_gamma)
    t136 = subtract(t132, t130, w7)
    t137 = divide(t135, t136, random_jerk_gamma)
    t139 = multiply(t57, t137, w1)
    t140 = add(t139, t62, w3)
    t141 = multiply(t140, t137, w3)
    t142 = add(t141, t65, w5)
    t143 = multiply(t142, t137, w7)
    t144 = add(t143, t66, w7)
    t145 = sqrt(t144, w7)
    t146 = sqrt(t145, w8)
    t147 = sqrt(t146, random_jerk_predicted_11)
    t148 = multiply(t139, t137, w1)
    t149 = multiply(t148, n10, w1)
    t150 = multiply(t141, n10, w3)
    t151 = multiply(t142, n10, w5)
    t152 = add(t149, t150, w1)
    t153 = add(t152, t151, w1)
    t154 = multiply(t145, t146, w7)
    t155 = multiply(t154, t147, w7)
    t156 = multiply(t147, t155, random_jerk_predicted_11)
    t157 = multiply(t153, t137, random_jerk_gamma)
    t158 = subtract(t156, t157, random_jerk_predicted_11)
    t159 = subtract(t155, t153, w7)
    t160 = divide(t158, t159, random_jerk_predicted_11)
    t162 = multiply(t57, t160, w6)
    t163 = add(t162, t62, w6)
    t164 = multiply(t163, t160, w6)
    t165 = add(t164, t65, w6)
    t166 = multiply(t165, t160, w6)
    t167 = add(t166, t66, w6)
    w_inside = sqrt(t167, w6)
    w_of_map = sqrt(w_inside, w6)
    w = sqrt(w_of_map, w6)
    t171 = divide(w, alpha, w6)
    t172 = multiply(t171, n9, w1)
    t173 = add(t172, n0, w1)
    t174 = add(t171, n0, w2)
    t175 = square(t174, w3)
    t176 = multiply(t171, n1, w4)
    t177 = add(t176, n6, w5)
    t178 = multiply(t177, t171, w5)
    t179 = add(t178, n9, w5)
    t180 = multiply(t175, t179, w7)
    t181 = divide(t175, t171, w8)
    t182 = multiply(t2, t181, w0)
    t183 = divide(t179, t171, w5)
    t184 = multiply(t182, t183, w0)
    t185 = multiply(t173, n1, w5)
    t186 = multiply(t184, t175, w0)
    t187 = multiply(t186, n9, w0)
    t188 = add(t187, t173, w0)
    t189 = divide(t188, t185, w0)
    t190 = add(t176, n0, w3)
    t191 = add(t176, n9, w4)
    t192 = multiply(t190, t191, w3)
    t193 = multiply(t171, t174, w6)
    t194 = multiply(t192, t193, w3)
    t195 = multiply(t194, n9, w3)
    t196 = divide(t195, t185, w3)
    t197 = square(t173, w2)
    t198 = multiply(t197, n6, w2)
    t201 = multiply(t173, n11, w4)
    t203 = add(t173, n0, w5)
    t204 = multiply(t173, t203, w6)
    t205 = add(t204, t196, w8)
    t206 = multiply(t204, t203, w6)
    t207 = add(t196, t206, w6)
    t208 = divide(t207, t196, w6)
    t209 = divide(t205, t189, w0)
    t210 = divide(t205, t196, w8)
    t211 = multiply(t209, t210, w0)
    t212 = add(t208, t211, w6)
    divide(t198, t180, random_jerk_beta)
    divide(t201, t180, random_jerk_gamma)
    divide(t212, t173, random_jerk_predicted_11)


_RANDOM_JERK_BY_GAIN = Signature(
    "random_jerk_by_gain",
    (_ALPHA_DOMAIN_3,),
    ("random_jerk_beta", "random_jerk_gamma", "random_jerk_predicted_11"),
    9,
    _random_jerk_by_gain_block,
    numbers=_random_jerk_by_gain_of_numbers,
)
