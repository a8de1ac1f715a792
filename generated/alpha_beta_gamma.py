# Made by: gainproof generate alpha-beta-gamma
# From: gainproof derive alpha-beta-gamma, SymPy 1.14.0
"""Alpha-beta-gamma filters with any gains."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from gainproof.generated._runtime import Domain, Signature, evaluate, near_cbrt

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.generated._runtime import Arrays, Real

__all__ = [
    "Coordinates",
    "GainsOfCoordinates",
    "Lags",
    "MinimumVarianceByLag",
    "RandomAccelerationByGain",
    "Variances",
    "VariancesOfCoordinates",
    "coordinates",
    "gains_of_coordinates",
    "lags",
    "minimum_variance_by_lag",
    "random_acceleration_by_gain",
    "variances",
    "variances_of_coordinates",
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
_LAG_DOMAIN = Domain(
    "lag",
    "a number above 1/8 and at most 1e30, in float32 above 1/8 and at most 1e9",
    (0.12500000000000003, 1e30),
    (0.1250000149011612, 1000000000.0),
)
_ALPHA_DOMAIN_2 = Domain(
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation alpha-beta-gamma
    """
    return Coordinates(*evaluate(_COORDINATES, (alpha, beta, share), out))


def _coordinates_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    alpha, beta, share = given
    gamma, margin, linear_coefficient, cubic_coefficient, hurwitz_determinant = out
    w0, w1, w2, w3 = work
    t4 = np.subtract(1.0, alpha, w0)
    t6 = np.subtract(2.0, alpha, w1)
    t7 = np.subtract(1.0, share, w2)
    t8 = np.multiply(t4, 2.0, w0)
    t9 = np.subtract(2.0, beta, w3)
    np.add(t8, t9, margin)
    t11 = np.multiply(beta, 2.0, w0)
    t12 = np.divide(t11, t6, gamma)
    t13 = np.multiply(alpha, share, w0)
    np.multiply(t13, t12, gamma)
    t15 = np.divide(beta, gamma, linear_coefficient)
    t17 = np.multiply(margin, 2.0, w0)
    t19 = np.divide(alpha, gamma, cubic_coefficient)
    t20 = np.multiply(t19, t15, cubic_coefficient)
    t21 = np.multiply(t20, t7, w2)
    np.multiply(t15, 2.0, linear_coefficient)
    np.divide(t17, gamma, cubic_coefficient)
    np.multiply(t21, 8.0, hurwitz_determinant)


_COORDINATES = Signature(
    "coordinates",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _SHARE_DOMAIN),
    ("gamma", "margin", "linear_coefficient", "cubic_coefficient", "hurwitz_determinant"),
    4,
    _coordinates_block,
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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation alpha-beta-gamma
    """
    return GainsOfCoordinates(
        *evaluate(
            _GAINS_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
        )
    )


def _gains_of_coordinates_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    alpha, beta, gamma = out
    w0, w1 = work
    t3 = np.add(cubic_coefficient, hurwitz_determinant, w0)
    t4 = np.divide(t3, linear_coefficient, alpha)
    t6 = np.add(1.0, linear_coefficient, w0)
    t7 = np.add(t6, t4, w0)
    t8 = np.add(t7, cubic_coefficient, w0)
    t9 = np.add(1.0, t4, alpha)
    t11 = np.multiply(t9, 2.0, alpha)
    t14 = np.multiply(linear_coefficient, 4.0, w1)
    np.divide(t11, t8, alpha)
    np.divide(t14, t8, beta)
    np.divide(8.0, t8, gamma)


_GAINS_OF_COORDINATES = Signature(
    "gains_of_coordinates",
    (_LINEAR_COEFFICIENT_DOMAIN, _CUBIC_COEFFICIENT_DOMAIN, _HURWITZ_DETERMINANT_DOMAIN),
    ("alpha", "beta", "gamma"),
    2,
    _gains_of_coordinates_block,
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
        updated_23 = 2 beta gamma (2 beta - gamma)/(g margin); updated_12_scale and
        updated_13_scale are updated_12 and updated_13 with plus between their terms

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
    updated_12: covariance of updated position and velocity over sigma_v^2, times T. Error over
        updated_12_scale at most 7.00 * 2^-52 (float64), 7.00 * 2^-23 (float32), proved for every
        input. Cancellation in updated_12_difference, condition number 1: changes its sign; error
        over the sum of its terms.
    updated_13: covariance of updated position and acceleration over sigma_v^2, times T^2. Error
        over updated_13_scale at most 8.00 * 2^-52 (float64), 8.00 * 2^-23 (float32), proved for
        every input. Cancellation in updated_13_difference, condition number 1: changes its sign;
        error over the sum of its terms.
    updated_22: variance of the updated velocity over sigma_v^2, times T^2. Relative error at most
        10.00 * 2^-52 (float64), 10.00 * 2^-23 (float32), proved for every input.
    updated_23: covariance of updated velocity and acceleration over sigma_v^2, times T^3. Relative
        error at most 7.50 * 2^-52 (float64), 7.50 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation alpha-beta-gamma
    """
    return Variances(*evaluate(_VARIANCES, (alpha, beta, share), out))


def _variances_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
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
    t4 = np.subtract(1.0, alpha, w0)
    t6 = np.subtract(2.0, alpha, w1)
    t7 = np.subtract(1.0, share, w2)
    t8 = np.multiply(t4, 2.0, w3)
    t9 = np.subtract(2.0, beta, w4)
    t10 = np.add(t8, t9, w4)
    t11 = np.multiply(beta, 2.0, w5)
    t12 = np.divide(t11, t6, predicted_11)
    t13 = np.multiply(alpha, share, w6)
    t14 = np.multiply(t13, t12, w6)
    t15 = np.multiply(alpha, t7, w7)
    t16 = np.add(t8, t15, w3)
    t17 = np.multiply(t12, t16, w3)
    t18 = np.multiply(t6, t7, predicted_11)
    t19 = np.divide(share, t18, predicted_33)
    t20 = np.multiply(t15, t10, w8)
    t21 = np.add(t11, t14, w5)
    t23 = np.multiply(beta, 4.0, predicted_11)
    t24 = np.divide(t23, t20, updated_12)
    t25 = np.add(t24, alpha, updated_12)
    np.divide(t25, t6, predicted_11)
    t27 = np.multiply(beta, t19, w1)
    t28 = np.multiply(t27, t21, updated_12)
    t29 = np.divide(t28, t10, predicted_23)
    t30 = np.multiply(t27, t17, updated_12)
    t31 = np.divide(t30, t10, updated_23)
    t32 = np.multiply(t27, 4.0, w1)
    t33 = np.multiply(t32, t14, w1)
    t35 = np.multiply(t7, t10, updated_12)
    t36 = np.divide(t17, t35, updated_13)
    t37 = np.multiply(beta, 0.5, updated_12)
    t38 = np.multiply(t37, t17, updated_12)
    t39 = np.divide(t38, t20, predicted_12)
    t40 = np.multiply(t14, 2.0, updated_12)
    t41 = np.divide(t40, t10, predicted_13)
    t44 = np.multiply(alpha, 2.0, updated_12)
    t45 = np.add(t44, beta, updated_12)
    t46 = np.multiply(t45, t21, w5)
    t47 = np.multiply(t20, 2.0, w8)
    t50 = np.add(beta, t14, updated_12)
    t51 = np.multiply(beta, t50, updated_12)
    t52 = np.divide(t51, t15, predicted_22)
    t53 = np.divide(share, t7, updated_11)
    t54 = np.multiply(t14, t53, updated_11)
    t55 = np.add(t52, t54, predicted_22)
    t56 = np.multiply(t55, 2.0, predicted_22)
    t59 = np.square(t4, w0)
    t60 = np.multiply(t59, predicted_11, w0)
    t61 = np.square(alpha, w2)
    t63 = np.square(t17, w3)
    t64 = np.divide(t63, t47, updated_22)
    t65 = np.multiply(t14, t19, w6)
    np.divide(t33, t10, predicted_33)
    np.subtract(t36, t39, updated_12)
    np.subtract(t41, t31, updated_13)
    np.divide(t46, t47, predicted_12)
    np.add(t41, t29, predicted_13)
    np.divide(t56, t10, predicted_22)
    np.multiply(t29, 2.0, predicted_23)
    np.add(t60, t61, updated_11)
    np.add(t64, t65, updated_22)
    np.multiply(t31, 2.0, updated_23)


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
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation alpha-beta-gamma
    """
    return VariancesOfCoordinates(
        *evaluate(
            _VARIANCES_OF_COORDINATES,
            (linear_coefficient, cubic_coefficient, hurwitz_determinant),
            out,
        )
    )


def _variances_of_coordinates_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    linear_coefficient, cubic_coefficient, hurwitz_determinant = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    t4 = np.add(1.0, linear_coefficient, w0)
    t5 = np.multiply(linear_coefficient, t4, w1)
    t6 = np.multiply(cubic_coefficient, hurwitz_determinant, w2)
    t7 = np.add(t5, hurwitz_determinant, w3)
    t8 = np.multiply(t5, t4, w4)
    t9 = np.add(hurwitz_determinant, t8, w5)
    t10 = np.multiply(cubic_coefficient, t9, w5)
    t11 = np.square(t7, w6)
    t12 = np.add(t10, t11, w5)
    t13 = np.multiply(t6, linear_coefficient, w6)
    t15 = np.add(t7, cubic_coefficient, w7)
    t16 = np.multiply(t4, t15, w0)
    t18 = np.multiply(t16, 2.0, w0)
    t21 = np.multiply(t7, 4.0, w3)
    t23 = np.add(cubic_coefficient, t8, w4)
    t24 = np.multiply(t23, 4.0, w4)
    t27 = np.multiply(t5, 8.0, w1)
    t30 = np.multiply(linear_coefficient, 16.0, w7)
    np.divide(t12, t13, predicted_11)
    np.divide(t18, t6, predicted_12)
    np.divide(t21, t6, predicted_13)
    np.divide(t24, t6, predicted_22)
    np.divide(t27, t6, predicted_23)
    np.divide(t30, t6, predicted_33)


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
        3.51 * 2^-52 (float64), 3.50 * 2^-23 (float32), proved for every input. Cancellation in
        updated_velocity_lag_difference, condition number 1: changes its sign; error over the sum of
        its terms.
    updated_acceleration_lag: truth less updated acceleration. Relative error at most 4.01 * 2^-52
        (float64), 4.01 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation alpha-beta-gamma
    """
    return Lags(*evaluate(_LAGS, (alpha, beta, share), out))


def _lags_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
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
    t4 = np.subtract(1.0, alpha, w0)
    t6 = np.subtract(2.0, alpha, w1)
    t7 = np.subtract(1.0, share, w2)
    t8 = np.multiply(t4, 2.0, w3)
    t9 = np.multiply(beta, 2.0, w4)
    t10 = np.divide(t9, t6, updated_velocity_lag)
    t11 = np.multiply(alpha, share, w1)
    t12 = np.multiply(t11, t10, w1)
    t13 = np.multiply(alpha, t7, w2)
    t14 = np.add(t8, t13, w3)
    t15 = np.multiply(t10, t14, w3)
    t16 = np.divide(alpha, t12, predicted_position_lag)
    t18 = np.add(t16, 0.08333333333333333, w2)
    t19 = np.multiply(t12, 2.0, w4)
    t20 = np.divide(beta, t19, predicted_velocity_lag)
    t24 = np.divide(beta, t12, predicted_acceleration_lag)
    np.subtract(t18, t20, updated_velocity_lag)
    np.divide(1.0, t12, predicted_position_lag)
    np.add(t18, t20, predicted_velocity_lag)
    np.add(t24, 0.5, predicted_acceleration_lag)
    np.divide(t4, t12, updated_position_lag)
    np.divide(t15, t19, updated_acceleration_lag)


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
    lag: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None
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
        variance. Relative error at most 13.80 * 2^-52 (float64), 13.79 * 2^-23 (float32), proved
        for 0.12500000000000003 <= lag <= 1e30 (float64) and 0.12500001 <= lag <= 1e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation alpha-beta-gamma
    """
    return MinimumVarianceByLag(*evaluate(_MINIMUM_VARIANCE_BY_LAG, (lag,), out))


def _minimum_variance_by_lag_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (lag,) = given
    (
        minimum_variance_alpha,
        minimum_variance_beta,
        minimum_variance_gamma,
        minimum_variance_predicted_11,
    ) = out
    w0, w1 = work
    t1 = near_cbrt(lag, w0, single)
    t3 = np.multiply(lag, t1, w1)
    t4 = np.sqrt(t3, minimum_variance_alpha)
    t5 = np.sqrt(t4, minimum_variance_beta)
    t7 = np.multiply(lag, 0.25, w1)
    t8 = np.multiply(t4, t5, minimum_variance_alpha)
    t9 = np.multiply(t5, t8, minimum_variance_beta)
    t10 = np.multiply(t7, t1, w0)
    t11 = np.subtract(t9, t10, minimum_variance_beta)
    t12 = np.subtract(t8, t7, minimum_variance_alpha)
    t13 = np.divide(t11, t12, minimum_variance_gamma)
    t15 = np.multiply(lag, t13, w0)
    t16 = np.sqrt(t15, minimum_variance_predicted_11)
    t17 = np.sqrt(t16, w0)
    t18 = np.multiply(t16, t17, minimum_variance_predicted_11)
    t19 = np.multiply(t17, t18, w0)
    t20 = np.multiply(t7, t13, minimum_variance_gamma)
    t21 = np.subtract(t19, t20, w0)
    t22 = np.subtract(t18, t7, minimum_variance_predicted_11)
    t23 = np.divide(t21, t22, w0)
    t25 = np.multiply(lag, t23, minimum_variance_alpha)
    t26 = np.sqrt(t25, minimum_variance_alpha)
    t27 = np.sqrt(t26, minimum_variance_beta)
    t28 = np.multiply(t26, t27, minimum_variance_alpha)
    t29 = np.multiply(t27, t28, minimum_variance_beta)
    t30 = np.multiply(t7, t23, w0)
    t31 = np.subtract(t29, t30, minimum_variance_beta)
    t32 = np.subtract(t28, t7, minimum_variance_alpha)
    t33 = np.divide(t31, t32, minimum_variance_beta)
    t35 = np.multiply(lag, t33, minimum_variance_beta)
    root_of_map = np.sqrt(t35, minimum_variance_beta)
    root = np.sqrt(root_of_map, minimum_variance_beta)
    t39 = np.multiply(root, 2.0, minimum_variance_beta)
    t41 = np.multiply(lag, 8.0, w0)
    t44 = np.add(t41, -1.0, w0)
    t45 = np.add(t39, 1.0, w1)
    t46 = np.multiply(t45, t39, w1)
    t47 = np.add(t46, 1.0, w1)
    t48 = np.divide(t44, t47, w0)
    t49 = np.add(t48, 1.0, w1)
    t50 = np.multiply(t48, t49, w1)
    t51 = np.multiply(t50, 2.0, minimum_variance_alpha)
    t52 = np.add(t51, 1.0, minimum_variance_alpha)
    t54 = np.multiply(lag, 4.0, minimum_variance_beta)
    t56 = np.multiply(lag, 2.0, minimum_variance_gamma)
    t60 = np.multiply(t50, 3.0, w1)
    t61 = np.add(t60, 1.0, w1)
    t62 = np.divide(t61, t48, w1)
    t63 = np.divide(t62, t48, w1)
    np.divide(t52, t54, minimum_variance_alpha)
    np.divide(t48, t56, minimum_variance_beta)
    np.divide(1.0, lag, minimum_variance_gamma)
    np.divide(t63, t48, minimum_variance_predicted_11)


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
    alpha: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
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
        acceleration. Relative error at most 3.89 * 2^-52 (float64), 3.86 * 2^-23 (float32), proved
        for 1e-15 <= alpha <= 0.9999999999999999 (float64) and 1e-06 <= alpha <= 0.99999994
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation alpha-beta-gamma
    """
    return RandomAccelerationByGain(*evaluate(_RANDOM_ACCELERATION_BY_GAIN, (alpha,), out))


def _random_acceleration_by_gain_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (alpha,) = given
    random_acceleration_beta, random_acceleration_gamma, random_acceleration_predicted_11 = out
    w0, w1, w2 = work
    t2 = np.subtract(1.0, alpha, w0)
    root = np.sqrt(t2, random_acceleration_beta)
    t4 = np.add(root, 1.0, w0)
    t5 = np.divide(alpha, t4, random_acceleration_gamma)
    t6 = np.square(t5, random_acceleration_gamma)
    t9 = np.square(t6, w0)
    t10 = np.multiply(t9, 2.0, w0)
    t13 = np.add(root, 4.0, w1)
    t14 = np.multiply(alpha, t13, w2)
    t15 = np.multiply(t13, root, w1)
    t16 = np.add(t15, 1.0, w1)
    t17 = np.multiply(root, t16, w1)
    np.multiply(t6, 2.0, random_acceleration_beta)
    np.divide(t10, alpha, random_acceleration_gamma)
    np.divide(t14, t17, random_acceleration_predicted_11)


_RANDOM_ACCELERATION_BY_GAIN = Signature(
    "random_acceleration_by_gain",
    (_ALPHA_DOMAIN_2,),
    ("random_acceleration_beta", "random_acceleration_gamma", "random_acceleration_predicted_11"),
    3,
    _random_acceleration_by_gain_block,
)
