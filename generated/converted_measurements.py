# Made by: gainproof generate converted-measurements
# From: gainproof derive converted-measurements, SymPy 1.14.0
"""Converted measurements: range and angles made Cartesian, with their noise."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Signature

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.generated._signature import Arrays, Real

__all__ = [
    "ClassicalConversionInPlane",
    "DebiasedConversionInPlane",
    "ModifiedUnbiasedConversionInPlane",
    "UnbiasedConversionInPlane",
    "classical_conversion_in_plane",
    "debiased_conversion_in_plane",
    "modified_unbiased_conversion_in_plane",
    "unbiased_conversion_in_plane",
]

_SLANT_RANGE_DOMAIN = Domain(
    "slant_range",
    "a number at least 1e-20 and at most 1e60, in float32 at least 1e-3 and at most 1e12",
    (1e-20, 1e60),
    (0.0010000000474974513, 999999995904.0),
)
_AZIMUTH_DOMAIN = Domain(
    "azimuth",
    "0 or of magnitude 1e-20 to 6.2832, in float32 1e-12 to 6.2832",
    (1e-20, 6.2832),
    (9.999999960041972e-13, 6.283199787139893),
    zero=True,
    signed=True,
)
_RANGE_DEVIATION_DOMAIN = Domain(
    "range_deviation",
    "a number at least 1e-20 and at most 1e60, in float32 at least 1e-3 and at most 1e12",
    (1e-20, 1e60),
    (0.0010000000474974513, 999999995904.0),
)
_AZIMUTH_DEVIATION_DOMAIN = Domain(
    "azimuth_deviation",
    "a number at least 1e-15 and at most 2, in float32 at least 1e-6 and at most 2",
    (1e-15, 2.0),
    (9.999999974752427e-07, 2.0),
)


class ClassicalConversionInPlane(NamedTuple):
    """Result of `classical_conversion_in_plane`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    radial_variance: Real
    """Stated variance along the measured line of sight, m^2."""
    cross_variance: Real
    """Stated variance across the measured line of sight, m^2."""


def classical_conversion_in_plane(
    slant_range: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real] | None = None,
) -> ClassicalConversionInPlane:
    """The measured place, and its covariance to first order.

        x = r cos a, y = r sin a; along the line of sight the variance sr^2, across it (r sa)^2.
        Biased given the truth by exp(-sa^2/2) - 1 times the range; a covariance to first order
        only, too small along the line of sight where r^2 tanh(sa^2/2) > sr^2

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved
        for every input, provided np.cos errs by at most 4 units in the last place of the true
        value.
    y: converted y, m. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved
        for every input, provided np.sin errs by at most 4 units in the last place of the true
        value.
    covariance_xx: stated variance of x, m^2. Relative error at most 11.01 * 2^-52 (float64), 11.01
        * 2^-23 (float32), proved for every input, and 8e-45 (float32) beside it where a product
        underflows, provided np.sin and np.cos err by at most 4 units in the last place of the true
        value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 11.01 * 2^-52 (float64), 11.01 * 2^-23 (float32), proved for every input, and 8e-45
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value.
    covariance_yy: stated variance of y, m^2. Relative error at most 11.01 * 2^-52 (float64), 11.01
        * 2^-23 (float32), proved for every input, provided np.sin and np.cos err by at most 4 units
        in the last place of the true value.
    radial_variance: stated variance along the measured line of sight, m^2. Relative error at most
        0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for every input.
    cross_variance: stated variance across the measured line of sight, m^2. Relative error at most
        1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation converted-measurements
    """
    return ClassicalConversionInPlane(
        *evaluate(
            _CLASSICAL_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
        )
    )


def _classical_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    cos_azimuth = np.cos(azimuth, w0)
    sin_azimuth = np.sin(azimuth, w1)
    t6 = np.multiply(slant_range, azimuth_deviation, w2)
    np.square(range_deviation, radial_variance)
    np.square(t6, cross_variance)
    t9 = np.square(cos_azimuth, w2)
    t10 = np.square(sin_azimuth, w3)
    t13 = np.multiply(t9, radial_variance, w4)
    t14 = np.multiply(t10, cross_variance, w5)
    t16 = np.multiply(sin_azimuth, cos_azimuth, w6)
    t17 = np.subtract(radial_variance, cross_variance, w7)
    t19 = np.multiply(t10, radial_variance, w3)
    t20 = np.multiply(t9, cross_variance, w2)
    np.multiply(slant_range, cos_azimuth, x)
    np.multiply(slant_range, sin_azimuth, y)
    np.add(t13, t14, covariance_xx)
    np.multiply(t16, t17, covariance_xy)
    np.add(t19, t20, covariance_yy)


_CLASSICAL_CONVERSION_IN_PLANE = Signature(
    "classical_conversion_in_plane",
    (_SLANT_RANGE_DOMAIN, _AZIMUTH_DOMAIN, _RANGE_DEVIATION_DOMAIN, _AZIMUTH_DEVIATION_DOMAIN),
    (
        "x",
        "y",
        "covariance_xx",
        "covariance_xy",
        "covariance_yy",
        "radial_variance",
        "cross_variance",
    ),
    8,
    _classical_conversion_in_plane_block,
)


class DebiasedConversionInPlane(NamedTuple):
    """Result of `debiased_conversion_in_plane`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    radial_variance: Real
    """Stated variance along the measured line of sight, m^2."""
    cross_variance: Real
    """Stated variance across the measured line of sight, m^2."""


def debiased_conversion_in_plane(
    slant_range: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real] | None = None,
) -> DebiasedConversionInPlane:
    """The measured place less its mean bias, and its mean covariance.

        With k = exp(-sa^2/2): x = (1 + k - k^2) r cos a, y likewise; the covariance is the mean,
        given the measurement, of that of the raw conversion given the truth (Lerro, Bar-Shalom
        1993). What is left of the bias given the truth is -(1 - k)^2 (1 + k) times the range

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 21.51 * 2^-52 (float64), 21.51 * 2^-23 (float32),
        proved for every input, provided np.cos, np.exp and np.expm1 err by at most 4 units in the
        last place of the true value.
    y: converted y, m. Relative error at most 21.51 * 2^-52 (float64), 21.51 * 2^-23 (float32),
        proved for every input, provided np.sin, np.exp and np.expm1 err by at most 4 units in the
        last place of the true value.
    covariance_xx: stated variance of x, m^2. Relative error at most 55.01 * 2^-52 (float64), 55.01
        * 2^-23 (float32), proved for every input, and 8e-45 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 55.01 * 2^-52 (float64), 55.01 * 2^-23 (float32), proved for every input, and 8e-45
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value.
    covariance_yy: stated variance of y, m^2. Relative error at most 55.01 * 2^-52 (float64), 55.01
        * 2^-23 (float32), proved for every input, provided np.sin, np.cos, np.exp and np.expm1 err
        by at most 4 units in the last place of the true value.
    radial_variance: stated variance along the measured line of sight, m^2. Relative error at most
        45.51 * 2^-52 (float64), 45.51 * 2^-23 (float32), proved for every input, provided np.exp
        and np.expm1 err by at most 4 units in the last place of the true value.
    cross_variance: stated variance across the measured line of sight, m^2. Relative error at most
        40.01 * 2^-52 (float64), 40.01 * 2^-23 (float32), proved for every input, provided np.exp
        and np.expm1 err by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation converted-measurements
    """
    return DebiasedConversionInPlane(
        *evaluate(
            _DEBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
        )
    )


def _debiased_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    cos_azimuth = np.cos(azimuth, w0)
    sin_azimuth = np.sin(azimuth, w1)
    t6 = np.square(azimuth_deviation, w2)
    t7 = np.negative(t6, w2)
    t9 = np.multiply(t7, 0.5, w3)
    kept_azimuth = np.exp(t9, w3)
    change_azimuth = np.expm1(t7, w2)
    t12 = np.square(range_deviation, w4)
    t13 = np.square(kept_azimuth, w5)
    t14 = np.negative(change_azimuth, w6)
    t15 = np.multiply(kept_azimuth, t14, w7)
    t17 = np.add(1.0, kept_azimuth, w3)
    t18 = np.divide(t15, t17, radial_variance)
    t19 = np.multiply(slant_range, t18, radial_variance)
    t20 = np.add(slant_range, t19, w3)
    t21 = np.square(t13, w7)
    t22 = np.square(slant_range, radial_variance)
    t23 = np.add(t22, t12, w8)
    t24 = np.square(t14, w9)
    t25 = np.add(1.0, t13, w10)
    t26 = np.add(t25, t21, w11)
    t27 = np.multiply(t24, t26, w9)
    t28 = np.multiply(t23, t27, w8)
    t29 = np.square(t21, w9)
    t30 = np.add(1.0, t29, w9)
    t31 = np.multiply(t12, t30, w9)
    t32 = np.add(t28, t31, w8)
    t33 = np.subtract(1.0, change_azimuth, w2)
    t34 = np.multiply(t21, 2.0, w9)
    t35 = np.add(t33, t34, w2)
    t36 = np.multiply(t25, t35, w10)
    t37 = np.multiply(t12, t36, w4)
    t38 = np.multiply(t21, t13, w7)
    t39 = np.add(1.0, t38, w7)
    t40 = np.multiply(t22, t39, radial_variance)
    t41 = np.add(t40, t37, radial_variance)
    t42 = np.multiply(t14, t41, w6)
    np.multiply(t32, 0.5, radial_variance)
    np.multiply(t42, 0.5, cross_variance)
    t45 = np.square(cos_azimuth, w2)
    t46 = np.square(sin_azimuth, w4)
    t49 = np.multiply(t45, radial_variance, w5)
    t50 = np.multiply(t46, cross_variance, w6)
    t52 = np.multiply(sin_azimuth, cos_azimuth, w7)
    t53 = np.subtract(radial_variance, cross_variance, w8)
    t55 = np.multiply(t46, radial_variance, w4)
    t56 = np.multiply(t45, cross_variance, w2)
    np.multiply(t20, cos_azimuth, x)
    np.multiply(t20, sin_azimuth, y)
    np.add(t49, t50, covariance_xx)
    np.multiply(t52, t53, covariance_xy)
    np.add(t55, t56, covariance_yy)


_DEBIASED_CONVERSION_IN_PLANE = Signature(
    "debiased_conversion_in_plane",
    (_SLANT_RANGE_DOMAIN, _AZIMUTH_DOMAIN, _RANGE_DEVIATION_DOMAIN, _AZIMUTH_DEVIATION_DOMAIN),
    (
        "x",
        "y",
        "covariance_xx",
        "covariance_xy",
        "covariance_yy",
        "radial_variance",
        "cross_variance",
    ),
    12,
    _debiased_conversion_in_plane_block,
)


class UnbiasedConversionInPlane(NamedTuple):
    """Result of `unbiased_conversion_in_plane`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    radial_variance: Real
    """Stated variance along the measured line of sight, m^2."""
    cross_variance: Real
    """Stated variance across the measured line of sight, m^2."""


def unbiased_conversion_in_plane(
    slant_range: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real] | None = None,
) -> UnbiasedConversionInPlane:
    """The conversion without bias given the truth, and its mean square error.

        With k = exp(-sa^2/2): x = r cos a/k, y likewise: given the truth the mean is the truth.
        The covariance is the mean square error given the measurement (Longbin et al. 1998, (7)):
        along (r^2 (1 - k^2)^2 (2 + k^2)/k^2 + sr^2 (1 + k^4))/2, across (r^2 + sr^2)(1 - k^4)/2

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32),
        proved for every input, provided np.cos and np.exp err by at most 4 units in the last place
        of the true value.
    y: converted y, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32),
        proved for every input, provided np.sin and np.exp err by at most 4 units in the last place
        of the true value.
    covariance_xx: stated variance of x, m^2. Relative error at most 33.51 * 2^-52 (float64), 33.51
        * 2^-23 (float32), proved for every input, and 8e-45 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 33.51 * 2^-52 (float64), 33.51 * 2^-23 (float32), proved for every input, and 8e-45
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value.
    covariance_yy: stated variance of y, m^2. Relative error at most 33.51 * 2^-52 (float64), 33.51
        * 2^-23 (float32), proved for every input, provided np.sin, np.cos, np.exp and np.expm1 err
        by at most 4 units in the last place of the true value.
    radial_variance: stated variance along the measured line of sight, m^2. Relative error at most
        24.01 * 2^-52 (float64), 24.01 * 2^-23 (float32), proved for every input, provided np.exp
        and np.expm1 err by at most 4 units in the last place of the true value.
    cross_variance: stated variance across the measured line of sight, m^2. Relative error at most
        17.51 * 2^-52 (float64), 17.51 * 2^-23 (float32), proved for every input, provided np.exp
        and np.expm1 err by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation converted-measurements
    """
    return UnbiasedConversionInPlane(
        *evaluate(
            _UNBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
        )
    )


def _unbiased_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    cos_azimuth = np.cos(azimuth, w0)
    sin_azimuth = np.sin(azimuth, w1)
    t6 = np.square(azimuth_deviation, w2)
    t7 = np.negative(t6, w2)
    t9 = np.multiply(t7, 0.5, w3)
    kept_azimuth = np.exp(t9, w3)
    change_azimuth = np.expm1(t7, w2)
    t12 = np.square(range_deviation, w4)
    t13 = np.square(kept_azimuth, w5)
    t14 = np.negative(change_azimuth, w2)
    t15 = np.divide(slant_range, kept_azimuth, y)
    t16 = np.multiply(slant_range, t14, w3)
    t17 = np.square(t16, w3)
    t18 = np.square(t13, w6)
    t20 = np.add(1.0, t18, w6)
    t21 = np.multiply(t12, t20, w6)
    t22 = np.add(t17, t21, w6)
    t23 = np.multiply(t22, 0.5, w6)
    t24 = np.square(slant_range, w7)
    t25 = np.add(t24, t12, w7)
    t26 = np.add(1.0, t13, w4)
    t27 = np.multiply(t14, t26, w2)
    t28 = np.multiply(t25, t27, w7)
    np.multiply(t28, 0.5, cross_variance)
    t30 = np.divide(t17, t13, radial_variance)
    np.add(t23, t30, radial_variance)
    t32 = np.square(cos_azimuth, w2)
    t33 = np.square(sin_azimuth, w3)
    t36 = np.multiply(t32, radial_variance, w4)
    t37 = np.multiply(t33, cross_variance, w5)
    t39 = np.multiply(sin_azimuth, cos_azimuth, w6)
    t40 = np.subtract(radial_variance, cross_variance, w7)
    t42 = np.multiply(t33, radial_variance, w3)
    t43 = np.multiply(t32, cross_variance, w2)
    np.multiply(t15, cos_azimuth, x)
    np.multiply(t15, sin_azimuth, y)
    np.add(t36, t37, covariance_xx)
    np.multiply(t39, t40, covariance_xy)
    np.add(t42, t43, covariance_yy)


_UNBIASED_CONVERSION_IN_PLANE = Signature(
    "unbiased_conversion_in_plane",
    (_SLANT_RANGE_DOMAIN, _AZIMUTH_DOMAIN, _RANGE_DEVIATION_DOMAIN, _AZIMUTH_DEVIATION_DOMAIN),
    (
        "x",
        "y",
        "covariance_xx",
        "covariance_xy",
        "covariance_yy",
        "radial_variance",
        "cross_variance",
    ),
    8,
    _unbiased_conversion_in_plane_block,
)


class ModifiedUnbiasedConversionInPlane(NamedTuple):
    """Result of `modified_unbiased_conversion_in_plane`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    radial_variance: Real
    """Stated variance along the measured line of sight, m^2."""
    cross_variance: Real
    """Stated variance across the measured line of sight, m^2."""


def modified_unbiased_conversion_in_plane(
    slant_range: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real] | None = None,
) -> ModifiedUnbiasedConversionInPlane:
    """Mean and covariance of the true place given the measurement.

        With k = exp(-sa^2/2): x = k r cos a, y likewise; along the line of sight the variance
        (r^2 (1 - k^2)^2 + sr^2 (1 + k^4))/2, across it (r^2 + sr^2)(1 - k^4)/2 (Duan, Han, Li
        2004). Both exact, given the measurement, where nothing was known of the truth before

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32),
        proved for every input, provided np.cos and np.exp err by at most 4 units in the last place
        of the true value.
    y: converted y, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32),
        proved for every input, provided np.sin and np.exp err by at most 4 units in the last place
        of the true value.
    covariance_xx: stated variance of x, m^2. Relative error at most 33.01 * 2^-52 (float64), 33.01
        * 2^-23 (float32), proved for every input, and 8e-45 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 33.01 * 2^-52 (float64), 33.01 * 2^-23 (float32), proved for every input, and 8e-45
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value.
    covariance_yy: stated variance of y, m^2. Relative error at most 33.01 * 2^-52 (float64), 33.01
        * 2^-23 (float32), proved for every input, provided np.sin, np.cos, np.exp and np.expm1 err
        by at most 4 units in the last place of the true value.
    radial_variance: stated variance along the measured line of sight, m^2. Relative error at most
        23.51 * 2^-52 (float64), 23.51 * 2^-23 (float32), proved for every input, provided np.exp
        and np.expm1 err by at most 4 units in the last place of the true value.
    cross_variance: stated variance across the measured line of sight, m^2. Relative error at most
        17.51 * 2^-52 (float64), 17.51 * 2^-23 (float32), proved for every input, provided np.exp
        and np.expm1 err by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation converted-measurements
    """
    return ModifiedUnbiasedConversionInPlane(
        *evaluate(
            _MODIFIED_UNBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
        )
    )


def _modified_unbiased_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    cos_azimuth = np.cos(azimuth, w0)
    sin_azimuth = np.sin(azimuth, w1)
    t6 = np.square(azimuth_deviation, w2)
    t7 = np.negative(t6, w2)
    t9 = np.multiply(t7, 0.5, w3)
    kept_azimuth = np.exp(t9, w3)
    change_azimuth = np.expm1(t7, w2)
    t12 = np.square(range_deviation, w4)
    t13 = np.square(kept_azimuth, w5)
    t14 = np.negative(change_azimuth, w2)
    t15 = np.multiply(slant_range, kept_azimuth, w3)
    t16 = np.multiply(slant_range, t14, w6)
    t17 = np.square(t16, w6)
    t18 = np.square(t13, w7)
    t20 = np.add(1.0, t18, w7)
    t21 = np.multiply(t12, t20, w7)
    t22 = np.add(t17, t21, w6)
    np.multiply(t22, 0.5, radial_variance)
    t24 = np.square(slant_range, w6)
    t25 = np.add(t24, t12, w6)
    t26 = np.add(1.0, t13, w5)
    t27 = np.multiply(t14, t26, w2)
    t28 = np.multiply(t25, t27, w6)
    np.multiply(t28, 0.5, cross_variance)
    t30 = np.square(cos_azimuth, w2)
    t31 = np.square(sin_azimuth, w4)
    t34 = np.multiply(t30, radial_variance, w5)
    t35 = np.multiply(t31, cross_variance, w6)
    t37 = np.multiply(sin_azimuth, cos_azimuth, w7)
    t38 = np.subtract(radial_variance, cross_variance, w8)
    t40 = np.multiply(t31, radial_variance, w4)
    t41 = np.multiply(t30, cross_variance, w2)
    np.multiply(t15, cos_azimuth, x)
    np.multiply(t15, sin_azimuth, y)
    np.add(t34, t35, covariance_xx)
    np.multiply(t37, t38, covariance_xy)
    np.add(t40, t41, covariance_yy)


_MODIFIED_UNBIASED_CONVERSION_IN_PLANE = Signature(
    "modified_unbiased_conversion_in_plane",
    (_SLANT_RANGE_DOMAIN, _AZIMUTH_DOMAIN, _RANGE_DEVIATION_DOMAIN, _AZIMUTH_DEVIATION_DOMAIN),
    (
        "x",
        "y",
        "covariance_xx",
        "covariance_xy",
        "covariance_yy",
        "radial_variance",
        "cross_variance",
    ),
    9,
    _modified_unbiased_conversion_in_plane_block,
)
