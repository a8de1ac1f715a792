# Made by: gainproof generate converted-measurements
# From: gainproof derive converted-measurements, SymPy 1.14.0
"""Converted measurements: range and angles made Cartesian, with their noise."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, cos, divide, errstate, exp, expm1, multiply, negative, sin, square, subtract

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
    "ClassicalConversion",
    "ClassicalConversionInPlane",
    "CorrelatedModifiedUnbiasedConversionInPlane",
    "CorrelatedUnbiasedConversionInPlane",
    "DebiasedConversion",
    "DebiasedConversionInPlane",
    "ModifiedUnbiasedConversion",
    "ModifiedUnbiasedConversionInPlane",
    "UnbiasedConversion",
    "UnbiasedConversionInPlane",
    "classical_conversion",
    "classical_conversion_in_plane",
    "correlated_modified_unbiased_conversion_in_plane",
    "correlated_unbiased_conversion_in_plane",
    "debiased_conversion",
    "debiased_conversion_in_plane",
    "modified_unbiased_conversion",
    "modified_unbiased_conversion_in_plane",
    "unbiased_conversion",
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
_ELEVATION_DOMAIN = Domain(
    "elevation",
    "0 or of magnitude 1e-20 to 1.5707963267948966, in float32 1e-12 to 1.5707962",
    (1e-20, 1.5707963267948966),
    (9.999999960041972e-13, 1.570796251296997),
    zero=True,
    signed=True,
)
_ELEVATION_DEVIATION_DOMAIN = Domain(
    "elevation_deviation",
    "a number at least 1e-15 and at most 2, in float32 at least 1e-6 and at most 2",
    (1e-15, 2.0),
    (9.999999974752427e-07, 2.0),
)
_CORRELATION_DOMAIN = Domain(
    "correlation",
    "0 or of magnitude 1e-20 to 1, in float32 1e-6 to 1",
    (1e-20, 1.0),
    (9.999999974752427e-07, 1.0),
    zero=True,
    signed=True,
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
    workers: int = 1,
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
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 3e-7 in float64
        and 0.02 in float32 of what its error is relative to; what cancels: range_deviation**2 -
        (slant_range*azimuth_deviation)**2.
    covariance_yy: stated variance of y, m^2. Relative error at most 11.01 * 2^-52 (float64), 11.01
        * 2^-23 (float32), proved for every input, provided np.sin and np.cos err by at most 4 units
        in the last place of the true value.
    radial_variance: stated variance along the measured line of sight, m^2. Relative error at most
        0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved for every input.
    cross_variance: stated variance across the measured line of sight, m^2. Relative error at most
        1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                ClassicalConversionInPlane,
                _classical_conversion_in_plane_of_numbers(
                    slant_range, azimuth, range_deviation, azimuth_deviation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ClassicalConversionInPlane(
        *evaluate(
            _CLASSICAL_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _classical_conversion_in_plane_of_numbers(
    slant_range: float,
    azimuth: float,
    range_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = form.cos(azimuth)
    t5 = form.sin(azimuth)
    t6 = slant_range * azimuth_deviation
    t7 = range_deviation * range_deviation
    t8 = t6 * t6
    t9 = t4 * t4
    t10 = t5 * t5
    t11 = slant_range * t4
    t12 = slant_range * t5
    t15 = (t9 * t7) + (t10 * t8)
    t18 = (t5 * t4) * (t7 - t8)
    t21 = (t10 * t7) + (t9 * t8)
    return (t11, t12, t15, t18, t21, t7, t8)


def _classical_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    t6 = multiply(slant_range, azimuth_deviation, w2)
    square(range_deviation, radial_variance)
    square(t6, cross_variance)
    t9 = square(cos_azimuth, w2)
    t10 = square(sin_azimuth, w3)
    t13 = multiply(t9, radial_variance, w4)
    t14 = multiply(t10, cross_variance, w5)
    t16 = multiply(sin_azimuth, cos_azimuth, w6)
    t17 = subtract(radial_variance, cross_variance, w7)
    t19 = multiply(t10, radial_variance, w3)
    t20 = multiply(t9, cross_variance, w2)
    multiply(slant_range, cos_azimuth, x)
    multiply(slant_range, sin_azimuth, y)
    add(t13, t14, covariance_xx)
    multiply(t16, t17, covariance_xy)
    add(t19, t20, covariance_yy)


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
    numbers=_classical_conversion_in_plane_of_numbers,
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
    workers: int = 1,
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
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.09 in float32 of what its error is relative to; what cancels:
        ((slant_range**2 + range_deviation**2)*... + range_deviation**2*(1 + ...))/2 -
        ...*(slant_range**2*(1 + ...) + range_deviation**2*...)/2.
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
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                DebiasedConversionInPlane,
                _debiased_conversion_in_plane_of_numbers(
                    slant_range, azimuth, range_deviation, azimuth_deviation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return DebiasedConversionInPlane(
        *evaluate(
            _DEBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _debiased_conversion_in_plane_of_numbers(
    slant_range: float,
    azimuth: float,
    range_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = form.cos(azimuth)
    t5 = form.sin(azimuth)
    t6 = azimuth_deviation * azimuth_deviation
    t7 = -t6
    t10 = form.exp(t7 * 0.5)
    t11 = form.expm1(t7)
    t12 = range_deviation * range_deviation
    t13 = t10 * t10
    t14 = -t11
    t19 = slant_range * ((t10 * t14) / (1.0 + t10))
    t20 = slant_range + t19
    t21 = t13 * t13
    t22 = slant_range * slant_range
    t25 = 1.0 + t13
    t28 = (t22 + t12) * ((t14 * t14) * (t25 + t21))
    t37 = t12 * (t25 * ((1.0 - t11) + (t21 * 2.0)))
    t42 = t14 * ((t22 * (1.0 + (t21 * t13))) + t37)
    t43 = (t28 + (t12 * (1.0 + (t21 * t21)))) * 0.5
    t44 = t42 * 0.5
    t45 = t4 * t4
    t46 = t5 * t5
    t47 = t20 * t4
    t48 = t20 * t5
    t51 = (t45 * t43) + (t46 * t44)
    t54 = (t5 * t4) * (t43 - t44)
    t57 = (t46 * t43) + (t45 * t44)
    return (t47, t48, t51, t54, t57, t43, t44)


def _debiased_conversion_in_plane_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 1.0,
    n2: float = 2.0,
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    t6 = square(azimuth_deviation, w2)
    t7 = negative(t6, w2)
    t9 = multiply(t7, n0, w3)
    kept_azimuth = exp(t9, w3)
    change_azimuth = expm1(t7, w2)
    t12 = square(range_deviation, w4)
    t13 = square(kept_azimuth, w5)
    t14 = negative(change_azimuth, w6)
    t15 = multiply(kept_azimuth, t14, w7)
    t17 = add(n1, kept_azimuth, w3)
    t18 = divide(t15, t17, radial_variance)
    t19 = multiply(slant_range, t18, radial_variance)
    t20 = add(slant_range, t19, w3)
    t21 = square(t13, w7)
    t22 = square(slant_range, radial_variance)
    t23 = add(t22, t12, w8)
    t24 = square(t14, w9)
    t25 = add(n1, t13, w10)
    t26 = add(t25, t21, w11)
    t27 = multiply(t24, t26, w9)
    t28 = multiply(t23, t27, w8)
    t29 = square(t21, w9)
    t30 = add(n1, t29, w9)
    t31 = multiply(t12, t30, w9)
    t32 = add(t28, t31, w8)
    t33 = subtract(n1, change_azimuth, w2)
    t34 = multiply(t21, n2, w9)
    t35 = add(t33, t34, w2)
    t36 = multiply(t25, t35, w10)
    t37 = multiply(t12, t36, w4)
    t38 = multiply(t21, t13, w7)
    t39 = add(n1, t38, w7)
    t40 = multiply(t22, t39, radial_variance)
    t41 = add(t40, t37, radial_variance)
    t42 = multiply(t14, t41, w6)
    multiply(t32, n0, radial_variance)
    multiply(t42, n0, cross_variance)
    t45 = square(cos_azimuth, w2)
    t46 = square(sin_azimuth, w4)
    t49 = multiply(t45, radial_variance, w5)
    t50 = multiply(t46, cross_variance, w6)
    t52 = multiply(sin_azimuth, cos_azimuth, w7)
    t53 = subtract(radial_variance, cross_variance, w8)
    t55 = multiply(t46, radial_variance, w4)
    t56 = multiply(t45, cross_variance, w2)
    multiply(t20, cos_azimuth, x)
    multiply(t20, sin_azimuth, y)
    add(t49, t50, covariance_xx)
    multiply(t52, t53, covariance_xy)
    add(t55, t56, covariance_yy)


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
    numbers=_debiased_conversion_in_plane_of_numbers,
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
    workers: int = 1,
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
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 9e-7
        in float64 and 0.06 in float32 of what its error is relative to; what cancels:
        ((slant_range*(-expm1(-azimuth_deviation**2)))**2 + range_deviation**2*(1 +
        (exp((-azimuth_deviation**2)/2)**2)**2))/2 +
        (slant_range*(-expm1(-azimuth_deviation**2)))**2/exp((-azimuth_deviation**2)/2)**2 -
        (slant_range**2 + range_deviation**2)*(-expm1(-azimuth_deviation**2))*(1 +
        exp((-azimuth_deviation**2)/2)**2)/2.
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
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UnbiasedConversionInPlane,
                _unbiased_conversion_in_plane_of_numbers(
                    slant_range, azimuth, range_deviation, azimuth_deviation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UnbiasedConversionInPlane(
        *evaluate(
            _UNBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _unbiased_conversion_in_plane_of_numbers(
    slant_range: float,
    azimuth: float,
    range_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = form.cos(azimuth)
    t5 = form.sin(azimuth)
    t6 = azimuth_deviation * azimuth_deviation
    t7 = -t6
    t10 = form.exp(t7 * 0.5)
    t12 = range_deviation * range_deviation
    t13 = t10 * t10
    t14 = -form.expm1(t7)
    t15 = slant_range / t10
    t16 = slant_range * t14
    t17 = t16 * t16
    t23 = (t17 + (t12 * (1.0 + (t13 * t13)))) * 0.5
    t28 = ((slant_range * slant_range) + t12) * (t14 * (1.0 + t13))
    t29 = t28 * 0.5
    t31 = t23 + (t17 / t13)
    t32 = t4 * t4
    t33 = t5 * t5
    t34 = t15 * t4
    t35 = t15 * t5
    t38 = (t32 * t31) + (t33 * t29)
    t41 = (t5 * t4) * (t31 - t29)
    t44 = (t33 * t31) + (t32 * t29)
    return (t34, t35, t38, t41, t44, t31, t29)


def _unbiased_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5, n1: float = 1.0
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    t6 = square(azimuth_deviation, w2)
    t7 = negative(t6, w2)
    t9 = multiply(t7, n0, w3)
    kept_azimuth = exp(t9, w3)
    change_azimuth = expm1(t7, w2)
    t12 = square(range_deviation, w4)
    t13 = square(kept_azimuth, w5)
    t14 = negative(change_azimuth, w2)
    t15 = divide(slant_range, kept_azimuth, y)
    t16 = multiply(slant_range, t14, w3)
    t17 = square(t16, w3)
    t18 = square(t13, w6)
    t20 = add(n1, t18, w6)
    t21 = multiply(t12, t20, w6)
    t22 = add(t17, t21, w6)
    t23 = multiply(t22, n0, w6)
    t24 = square(slant_range, w7)
    t25 = add(t24, t12, w7)
    t26 = add(n1, t13, w4)
    t27 = multiply(t14, t26, w2)
    t28 = multiply(t25, t27, w7)
    multiply(t28, n0, cross_variance)
    t30 = divide(t17, t13, radial_variance)
    add(t23, t30, radial_variance)
    t32 = square(cos_azimuth, w2)
    t33 = square(sin_azimuth, w3)
    t36 = multiply(t32, radial_variance, w4)
    t37 = multiply(t33, cross_variance, w5)
    t39 = multiply(sin_azimuth, cos_azimuth, w6)
    t40 = subtract(radial_variance, cross_variance, w7)
    t42 = multiply(t33, radial_variance, w3)
    t43 = multiply(t32, cross_variance, w2)
    multiply(t15, cos_azimuth, x)
    multiply(t15, sin_azimuth, y)
    add(t36, t37, covariance_xx)
    multiply(t39, t40, covariance_xy)
    add(t42, t43, covariance_yy)


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
    numbers=_unbiased_conversion_in_plane_of_numbers,
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
    workers: int = 1,
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
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 9e-7
        in float64 and 0.06 in float32 of what its error is relative to; what cancels:
        ((slant_range*(-expm1(-azimuth_deviation**2)))**2 + range_deviation**2*(1 +
        (exp((-azimuth_deviation**2)/2)**2)**2))/2 - (slant_range**2 +
        range_deviation**2)*(-expm1(-azimuth_deviation**2))*(1 +
        exp((-azimuth_deviation**2)/2)**2)/2.
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
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                ModifiedUnbiasedConversionInPlane,
                _modified_unbiased_conversion_in_plane_of_numbers(
                    slant_range, azimuth, range_deviation, azimuth_deviation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ModifiedUnbiasedConversionInPlane(
        *evaluate(
            _MODIFIED_UNBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _modified_unbiased_conversion_in_plane_of_numbers(
    slant_range: float,
    azimuth: float,
    range_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = form.cos(azimuth)
    t5 = form.sin(azimuth)
    t6 = azimuth_deviation * azimuth_deviation
    t7 = -t6
    t10 = form.exp(t7 * 0.5)
    t12 = range_deviation * range_deviation
    t13 = t10 * t10
    t14 = -form.expm1(t7)
    t15 = slant_range * t10
    t16 = slant_range * t14
    t22 = (t16 * t16) + (t12 * (1.0 + (t13 * t13)))
    t23 = t22 * 0.5
    t28 = ((slant_range * slant_range) + t12) * (t14 * (1.0 + t13))
    t29 = t28 * 0.5
    t30 = t4 * t4
    t31 = t5 * t5
    t32 = t15 * t4
    t33 = t15 * t5
    t36 = (t30 * t23) + (t31 * t29)
    t39 = (t5 * t4) * (t23 - t29)
    t42 = (t31 * t23) + (t30 * t29)
    return (t32, t33, t36, t39, t42, t23, t29)


def _modified_unbiased_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5, n1: float = 1.0
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    t6 = square(azimuth_deviation, w2)
    t7 = negative(t6, w2)
    t9 = multiply(t7, n0, w3)
    kept_azimuth = exp(t9, w3)
    change_azimuth = expm1(t7, w2)
    t12 = square(range_deviation, w4)
    t13 = square(kept_azimuth, w5)
    t14 = negative(change_azimuth, w2)
    t15 = multiply(slant_range, kept_azimuth, w3)
    t16 = multiply(slant_range, t14, w6)
    t17 = square(t16, w6)
    t18 = square(t13, w7)
    t20 = add(n1, t18, w7)
    t21 = multiply(t12, t20, w7)
    t22 = add(t17, t21, w6)
    multiply(t22, n0, radial_variance)
    t24 = square(slant_range, w6)
    t25 = add(t24, t12, w6)
    t26 = add(n1, t13, w5)
    t27 = multiply(t14, t26, w2)
    t28 = multiply(t25, t27, w6)
    multiply(t28, n0, cross_variance)
    t30 = square(cos_azimuth, w2)
    t31 = square(sin_azimuth, w4)
    t34 = multiply(t30, radial_variance, w5)
    t35 = multiply(t31, cross_variance, w6)
    t37 = multiply(sin_azimuth, cos_azimuth, w7)
    t38 = subtract(radial_variance, cross_variance, w8)
    t40 = multiply(t31, radial_variance, w4)
    t41 = multiply(t30, cross_variance, w2)
    multiply(t15, cos_azimuth, x)
    multiply(t15, sin_azimuth, y)
    add(t34, t35, covariance_xx)
    multiply(t37, t38, covariance_xy)
    add(t40, t41, covariance_yy)


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
    numbers=_modified_unbiased_conversion_in_plane_of_numbers,
)


class ClassicalConversion(NamedTuple):
    """Result of `classical_conversion`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    z: Real
    """Converted z, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_xz: Real
    """Stated covariance of x and z, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    covariance_yz: Real
    """Stated covariance of y and z, m^2."""
    covariance_zz: Real
    """Stated variance of z, m^2."""


def classical_conversion(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    elevation_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> ClassicalConversion:
    """The measured place, and its covariance to first order, in space.

        x = r cos e cos a, y = r cos e sin a, z = r sin e; the covariance is J D J' with the
        derivatives J of these and D = diag(sr^2, se^2, sa^2)

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    elevation: measured elevation above the plane of x and y, rad; 0 or of magnitude 1e-20 to
        1.5707963267948966, in float32 1e-12 to 1.5707962.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    elevation_deviation: standard deviation of the elevation, rad; a number at least 1e-15 and at
        most 2, in float32 at least 1e-6 and at most 2.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved
        for every input, provided np.cos errs by at most 4 units in the last place of the true
        value.
    y: converted y, m. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved
        for every input, provided np.sin and np.cos err by at most 4 units in the last place of the
        true value.
    z: converted z, m. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved
        for every input, provided np.sin errs by at most 4 units in the last place of the true
        value.
    covariance_xx: stated variance of x, m^2. Relative error at most 20.51 * 2^-52 (float64), 20.51
        * 2^-23 (float32), proved for every input, and 2e-44 (float32) beside it where a product
        underflows, provided np.sin and np.cos err by at most 4 units in the last place of the true
        value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 20.51 * 2^-52 (float64), 20.51 * 2^-23 (float32), proved for every input, and 2e-44
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.04 in float32 of what its error is relative to; what cancels:
        cos(elevation)**2*range_deviation**2 +
        sin(elevation)**2*(slant_range*elevation_deviation)**2 -
        (slant_range*cos(elevation)*azimuth_deviation)**2.
    covariance_xz: stated covariance of x and z, m^2. Error over the sum of its terms taken positive
        at most 15.51 * 2^-52 (float64), 15.51 * 2^-23 (float32), proved for every input, and 2e-44
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 4e-7 in float64
        and 0.03 in float32 of what its error is relative to; what cancels: range_deviation**2 -
        (slant_range*elevation_deviation)**2.
    covariance_yy: stated variance of y, m^2. Relative error at most 20.51 * 2^-52 (float64), 20.51
        * 2^-23 (float32), proved for every input, and 3e-44 (float32) beside it where a product
        underflows, provided np.sin and np.cos err by at most 4 units in the last place of the true
        value.
    covariance_yz: stated covariance of y and z, m^2. Error over the sum of its terms taken positive
        at most 15.51 * 2^-52 (float64), 15.51 * 2^-23 (float32), proved for every input, and 2e-44
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 4e-7 in float64
        and 0.03 in float32 of what its error is relative to; what cancels: range_deviation**2 -
        (slant_range*elevation_deviation)**2.
    covariance_zz: stated variance of z, m^2. Relative error at most 11.01 * 2^-52 (float64), 11.01
        * 2^-23 (float32), proved for every input, provided np.sin and np.cos err by at most 4 units
        in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(elevation_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= elevation_deviation <= 2.0
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                ClassicalConversion,
                _classical_conversion_of_numbers(
                    slant_range,
                    elevation,
                    azimuth,
                    range_deviation,
                    elevation_deviation,
                    azimuth_deviation,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ClassicalConversion(
        *evaluate(
            _CLASSICAL_CONVERSION,
            (
                slant_range,
                elevation,
                azimuth,
                range_deviation,
                elevation_deviation,
                azimuth_deviation,
            ),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _classical_conversion_of_numbers(
    slant_range: float,
    elevation: float,
    azimuth: float,
    range_deviation: float,
    elevation_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = form.cos(elevation)
    t6 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = range_deviation * range_deviation
    t11 = slant_range * elevation_deviation
    t12 = slant_range * t5
    t13 = t12 * azimuth_deviation
    t14 = t11 * t11
    t15 = t5 * t5
    t16 = t6 * t6
    t19 = (t15 * t10) + (t16 * t14)
    t25 = (t5 * t6) * (t10 - t14)
    t26 = t13 * t13
    t30 = t8 * t8
    t31 = t9 * t9
    t22 = (t16 * t10) + (t15 * t14)
    t27 = slant_range * t6
    t28 = t12 * t8
    t29 = t12 * t9
    t34 = (t30 * t19) + (t31 * t26)
    t37 = (t9 * t8) * (t19 - t26)
    t38 = t8 * t25
    t41 = (t31 * t19) + (t30 * t26)
    t42 = t9 * t25
    return (t28, t29, t27, t34, t37, t38, t41, t42, t22)


def _classical_conversion_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    slant_range, elevation, azimuth, range_deviation, elevation_deviation, azimuth_deviation = given
    (
        x,
        y,
        z,
        covariance_xx,
        covariance_xy,
        covariance_xz,
        covariance_yy,
        covariance_yz,
        covariance_zz,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14 = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_azimuth = cos(azimuth, w2)
    sin_azimuth = sin(azimuth, w3)
    t10 = square(range_deviation, w4)
    t11 = multiply(slant_range, elevation_deviation, w5)
    t12 = multiply(slant_range, cos_elevation, w6)
    t13 = multiply(t12, azimuth_deviation, w7)
    t14 = square(t11, w5)
    t15 = square(cos_elevation, w8)
    t16 = square(sin_elevation, w9)
    t17 = multiply(t15, t10, w10)
    t18 = multiply(t16, t14, w11)
    t19 = add(t17, t18, w10)
    t20 = multiply(t16, t10, w9)
    t21 = multiply(t15, t14, w8)
    t23 = multiply(cos_elevation, sin_elevation, w0)
    t24 = subtract(t10, t14, w4)
    t25 = multiply(t23, t24, w0)
    t26 = square(t13, w7)
    t30 = square(cos_azimuth, w4)
    t31 = square(sin_azimuth, w5)
    t32 = multiply(t30, t19, w11)
    t33 = multiply(t31, t26, w12)
    t35 = multiply(sin_azimuth, cos_azimuth, w13)
    t36 = subtract(t19, t26, w14)
    t39 = multiply(t31, t19, w5)
    t40 = multiply(t30, t26, w4)
    add(t20, t21, covariance_zz)
    multiply(slant_range, sin_elevation, z)
    multiply(t12, cos_azimuth, x)
    multiply(t12, sin_azimuth, y)
    add(t32, t33, covariance_xx)
    multiply(t35, t36, covariance_xy)
    multiply(cos_azimuth, t25, covariance_xz)
    add(t39, t40, covariance_yy)
    multiply(sin_azimuth, t25, covariance_yz)


_CLASSICAL_CONVERSION = Signature(
    "classical_conversion",
    (
        _SLANT_RANGE_DOMAIN,
        _ELEVATION_DOMAIN,
        _AZIMUTH_DOMAIN,
        _RANGE_DEVIATION_DOMAIN,
        _ELEVATION_DEVIATION_DOMAIN,
        _AZIMUTH_DEVIATION_DOMAIN,
    ),
    (
        "x",
        "y",
        "z",
        "covariance_xx",
        "covariance_xy",
        "covariance_xz",
        "covariance_yy",
        "covariance_yz",
        "covariance_zz",
    ),
    15,
    _classical_conversion_block,
    numbers=_classical_conversion_of_numbers,
)


class DebiasedConversion(NamedTuple):
    """Result of `debiased_conversion`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    z: Real
    """Converted z, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_xz: Real
    """Stated covariance of x and z, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    covariance_yz: Real
    """Stated covariance of y and z, m^2."""
    covariance_zz: Real
    """Stated variance of z, m^2."""


def debiased_conversion(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    elevation_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> DebiasedConversion:
    """The measured place less its mean bias, and its mean covariance, in space.

        With ke = exp(-se^2/2), k = ke exp(-sa^2/2): x = (1 + k - k^2) r cos e cos a, y likewise,
        z = (1 + ke - ke^2) r sin e; the covariance is the mean, given the measurement, of that
        of the raw conversion given the truth

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    elevation: measured elevation above the plane of x and y, rad; 0 or of magnitude 1e-20 to
        1.5707963267948966, in float32 1e-12 to 1.5707962.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    elevation_deviation: standard deviation of the elevation, rad; a number at least 1e-15 and at
        most 2, in float32 at least 1e-6 and at most 2.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 48.51 * 2^-52 (float64), 48.51 * 2^-23 (float32),
        proved for every input, provided np.cos, np.exp and np.expm1 err by at most 4 units in the
        last place of the true value.
    y: converted y, m. Relative error at most 48.51 * 2^-52 (float64), 48.51 * 2^-23 (float32),
        proved for every input, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units
        in the last place of the true value.
    z: converted z, m. Relative error at most 21.51 * 2^-52 (float64), 21.51 * 2^-23 (float32),
        proved for every input, provided np.sin, np.exp and np.expm1 err by at most 4 units in the
        last place of the true value.
    covariance_xx: stated variance of x, m^2. Relative error at most 104.52 * 2^-52 (float64),
        104.52 * 2^-23 (float32), proved for every input, and 6e-44 (float32) beside it where a
        product underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in
        the last place of the true value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 104.52 * 2^-52 (float64), 104.52 * 2^-23 (float32), proved for every input, and
        5e-44 (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and
        np.expm1 err by at most 4 units in the last place of the true value. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 3e-6 in float64 and 0.2 in float32 of what its error is relative to; what cancels:
        (...*(1 + ...) + ...*...*(1 + ...)/2*...*(1 + ...))/2 - (...*...*(1 + ...) + ...*...*(1 +
        ...)/2*(1 + ...))/2.
    covariance_xz: stated covariance of x and z, m^2. Error over the sum of its terms taken positive
        at most 70.51 * 2^-52 (float64), 70.52 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.2 in float32 of what its error is relative to; what cancels:
        ((slant_range**2 + range_deviation**2)*... + range_deviation**2*(1 + ...))/2 -
        ...*(slant_range**2*(1 + ...) + range_deviation**2*...)/2.
    covariance_yy: stated variance of y, m^2. Relative error at most 104.52 * 2^-52 (float64),
        104.52 * 2^-23 (float32), proved for every input, and 6e-44 (float32) beside it where a
        product underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in
        the last place of the true value.
    covariance_yz: stated covariance of y and z, m^2. Error over the sum of its terms taken positive
        at most 70.51 * 2^-52 (float64), 70.52 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.2 in float32 of what its error is relative to; what cancels:
        ((slant_range**2 + range_deviation**2)*... + range_deviation**2*(1 + ...))/2 -
        ...*(slant_range**2*(1 + ...) + range_deviation**2*...)/2.
    covariance_zz: stated variance of z, m^2. Relative error at most 55.01 * 2^-52 (float64), 55.01
        * 2^-23 (float32), proved for every input, provided np.sin, np.cos, np.exp and np.expm1 err
        by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(elevation_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= elevation_deviation <= 2.0
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                DebiasedConversion,
                _debiased_conversion_of_numbers(
                    slant_range,
                    elevation,
                    azimuth,
                    range_deviation,
                    elevation_deviation,
                    azimuth_deviation,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return DebiasedConversion(
        *evaluate(
            _DEBIASED_CONVERSION,
            (
                slant_range,
                elevation,
                azimuth,
                range_deviation,
                elevation_deviation,
                azimuth_deviation,
            ),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _debiased_conversion_of_numbers(
    slant_range: float,
    elevation: float,
    azimuth: float,
    range_deviation: float,
    elevation_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = form.cos(elevation)
    t6 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = elevation_deviation * elevation_deviation
    t11 = -t10
    t14 = form.exp(t11 * 0.5)
    t15 = form.expm1(t11)
    t16 = t14 * t14
    t17 = -t15
    t18 = azimuth_deviation * azimuth_deviation
    t19 = -t18
    t21 = form.exp(t19 * 0.5)
    t22 = form.expm1(t19)
    t23 = t21 * t21
    t24 = -t22
    t25 = range_deviation * range_deviation
    t26 = t21 * t14
    t33 = (t26 * ((t23 * t17) - t22)) / (1.0 + t26)
    t35 = (slant_range * t5) * (1.0 + t33)
    t42 = t16 * t16
    t43 = 1.0 + t16
    t47 = slant_range * slant_range
    t48 = t47 + t25
    t51 = t5 * t5
    t52 = 1.0 + (t42 * t42)
    t54 = t6 * t6
    t56 = (t51 * t52) + (t54 * ((t17 * t43) * (1.0 + t42)))
    t58 = (t48 + t25) * (t56 * 0.5)
    t64 = (t48 * ((t17 * t17) * (t43 + t42))) + (t25 * t52)
    t69 = t25 * (t43 * ((1.0 - t15) + (t42 * 2.0)))
    t74 = t17 * ((t47 * (1.0 + (t42 * t16))) + t69)
    t75 = t64 * 0.5
    t76 = t74 * 0.5
    t90 = (t23 * ((t51 * t75) + (t54 * t76))) + (((t24 * t24) * t58) * 0.5)
    t92 = t24 * (1.0 + t23)
    t94 = (t58 * t92) * 0.5
    t97 = 1.0 + (t23 * t23)
    t101 = ((t90 * t97) + (t94 * t92)) * 0.5
    t105 = ((t90 * t92) + (t94 * t97)) * 0.5
    t106 = t21 * (t21 * ((t5 * t6) * (t75 - t76)))
    t109 = t8 * t8
    t110 = t9 * t9
    t41 = (slant_range * t6) * (1.0 + ((t14 * t17) / (1.0 + t14)))
    t82 = (t54 * t75) + (t51 * t76)
    t107 = t35 * t8
    t108 = t35 * t9
    t113 = (t109 * t101) + (t110 * t105)
    t116 = (t9 * t8) * (t101 - t105)
    t117 = t8 * t106
    t120 = (t110 * t101) + (t109 * t105)
    t121 = t9 * t106
    return (t107, t108, t41, t113, t116, t117, t120, t121, t82)


def _debiased_conversion_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 1.0,
    n2: float = 2.0,
) -> None:
    slant_range, elevation, azimuth, range_deviation, elevation_deviation, azimuth_deviation = given
    (
        x,
        y,
        z,
        covariance_xx,
        covariance_xy,
        covariance_xz,
        covariance_yy,
        covariance_yz,
        covariance_zz,
    ) = out
    (
        w0,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        w16,
        w17,
        w18,
        w19,
        w20,
        w21,
    ) = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_azimuth = cos(azimuth, w2)
    sin_azimuth = sin(azimuth, w3)
    t10 = square(elevation_deviation, w4)
    t11 = negative(t10, w4)
    t13 = multiply(t11, n0, w5)
    kept_elevation = exp(t13, w5)
    change_elevation = expm1(t11, w4)
    t16 = square(kept_elevation, w6)
    t17 = negative(change_elevation, w7)
    t18 = square(azimuth_deviation, w8)
    t19 = negative(t18, w8)
    t20 = multiply(t19, n0, w9)
    kept_azimuth = exp(t20, w9)
    change_azimuth = expm1(t19, w8)
    t23 = square(kept_azimuth, w10)
    t24 = negative(change_azimuth, w11)
    t25 = square(range_deviation, w12)
    t26 = multiply(kept_azimuth, kept_elevation, w13)
    t27 = multiply(slant_range, cos_elevation, w14)
    t28 = multiply(t23, t17, w15)
    t29 = subtract(t28, change_azimuth, w15)
    t30 = multiply(t26, t29, w15)
    t32 = add(n1, t26, w13)
    t33 = divide(t30, t32, z)
    t34 = add(n1, t33, z)
    t35 = multiply(t27, t34, w14)
    t36 = multiply(slant_range, sin_elevation, w8)
    t37 = multiply(kept_elevation, t17, w13)
    t38 = add(n1, kept_elevation, w5)
    t39 = divide(t37, t38, covariance_zz)
    t40 = add(n1, t39, covariance_zz)
    t42 = square(t16, w5)
    t43 = add(n1, t16, w13)
    t44 = multiply(t17, t43, w15)
    t45 = add(n1, t42, z)
    t46 = multiply(t44, t45, w15)
    t47 = square(slant_range, z)
    t48 = add(t47, t25, w16)
    t49 = add(t48, t25, w17)
    t50 = square(t42, w18)
    t51 = square(cos_elevation, w19)
    t52 = add(n1, t50, w18)
    t53 = multiply(t51, t52, w20)
    t54 = square(sin_elevation, w21)
    t55 = multiply(t54, t46, w15)
    t56 = add(t53, t55, w20)
    t57 = multiply(t56, n0, w20)
    t58 = multiply(t49, t57, w17)
    t59 = square(t17, w15)
    t60 = add(t43, t42, w20)
    t61 = multiply(t59, t60, w15)
    t62 = multiply(t48, t61, w16)
    t63 = multiply(t25, t52, w18)
    t64 = add(t62, t63, w16)
    t65 = subtract(n1, change_elevation, w4)
    t66 = multiply(t42, n2, w15)
    t67 = add(t65, t66, w4)
    t68 = multiply(t43, t67, w13)
    t69 = multiply(t25, t68, w12)
    t70 = multiply(t42, t16, w5)
    t71 = add(n1, t70, w5)
    t72 = multiply(t47, t71, z)
    t73 = add(t72, t69, z)
    t74 = multiply(t17, t73, w7)
    t75 = multiply(t64, n0, w16)
    t76 = multiply(t74, n0, w7)
    t77 = multiply(t51, t75, w4)
    t78 = multiply(t54, t76, w5)
    t79 = add(t77, t78, w4)
    t80 = multiply(t54, t75, w21)
    t81 = multiply(t51, t76, w19)
    t83 = multiply(cos_elevation, sin_elevation, w0)
    t84 = subtract(t75, t76, w16)
    t85 = multiply(t83, t84, w0)
    t86 = multiply(t23, t79, w4)
    t87 = square(t24, w1)
    t88 = multiply(t87, t58, w1)
    t89 = multiply(t88, n0, w1)
    t90 = add(t86, t89, w4)
    t91 = add(n1, t23, w1)
    t92 = multiply(t24, t91, w11)
    t93 = multiply(t58, t92, w17)
    t94 = multiply(t93, n0, w17)
    t95 = multiply(kept_azimuth, t85, w0)
    t96 = square(t23, w10)
    t97 = add(n1, t96, w10)
    t98 = multiply(t90, t97, w1)
    t99 = multiply(t94, t92, w5)
    t100 = add(t98, t99, w1)
    t101 = multiply(t100, n0, w1)
    t102 = multiply(t90, t92, w4)
    t103 = multiply(t94, t97, w17)
    t104 = add(t102, t103, w4)
    t105 = multiply(t104, n0, w4)
    t106 = multiply(kept_azimuth, t95, w9)
    t109 = square(cos_azimuth, w0)
    t110 = square(sin_azimuth, w5)
    t111 = multiply(t109, t101, w6)
    t112 = multiply(t110, t105, w7)
    t114 = multiply(sin_azimuth, cos_azimuth, w10)
    t115 = subtract(t101, t105, w11)
    t118 = multiply(t110, t101, w5)
    t119 = multiply(t109, t105, w0)
    multiply(t36, t40, z)
    add(t80, t81, covariance_zz)
    multiply(t35, cos_azimuth, x)
    multiply(t35, sin_azimuth, y)
    add(t111, t112, covariance_xx)
    multiply(t114, t115, covariance_xy)
    multiply(cos_azimuth, t106, covariance_xz)
    add(t118, t119, covariance_yy)
    multiply(sin_azimuth, t106, covariance_yz)


_DEBIASED_CONVERSION = Signature(
    "debiased_conversion",
    (
        _SLANT_RANGE_DOMAIN,
        _ELEVATION_DOMAIN,
        _AZIMUTH_DOMAIN,
        _RANGE_DEVIATION_DOMAIN,
        _ELEVATION_DEVIATION_DOMAIN,
        _AZIMUTH_DEVIATION_DOMAIN,
    ),
    (
        "x",
        "y",
        "z",
        "covariance_xx",
        "covariance_xy",
        "covariance_xz",
        "covariance_yy",
        "covariance_yz",
        "covariance_zz",
    ),
    22,
    _debiased_conversion_block,
    numbers=_debiased_conversion_of_numbers,
)


class UnbiasedConversion(NamedTuple):
    """Result of `unbiased_conversion`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    z: Real
    """Converted z, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_xz: Real
    """Stated covariance of x and z, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    covariance_yz: Real
    """Stated covariance of y and z, m^2."""
    covariance_zz: Real
    """Stated variance of z, m^2."""


def unbiased_conversion(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    elevation_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> UnbiasedConversion:
    """The conversion without bias given the truth, and its mean square error, in space.

        With ke = exp(-se^2/2), k = ke exp(-sa^2/2): x = r cos e cos a/k, y likewise,
        z = r sin e/ke: given the truth the mean is the truth. The covariance is the mean square
        error given the measurement

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    elevation: measured elevation above the plane of x and y, rad; 0 or of magnitude 1e-20 to
        1.5707963267948966, in float32 1e-12 to 1.5707962.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    elevation_deviation: standard deviation of the elevation, rad; a number at least 1e-15 and at
        most 2, in float32 at least 1e-6 and at most 2.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 20.01 * 2^-52 (float64), 20.01 * 2^-23 (float32),
        proved for every input, provided np.cos and np.exp err by at most 4 units in the last place
        of the true value.
    y: converted y, m. Relative error at most 20.01 * 2^-52 (float64), 20.01 * 2^-23 (float32),
        proved for every input, provided np.sin, np.cos and np.exp err by at most 4 units in the
        last place of the true value.
    z: converted z, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32),
        proved for every input, provided np.sin and np.exp err by at most 4 units in the last place
        of the true value.
    covariance_xx: stated variance of x, m^2. Relative error at most 74.51 * 2^-52 (float64), 74.51
        * 2^-23 (float32), proved for every input, and 4e-44 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 74.51 * 2^-52 (float64), 74.51 * 2^-23 (float32), proved for every input, and 4e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.2 in float32 of what its error is relative to; what cancels: ... +
        (slant_range*cos(elevation)*.../...)**2 - (slant_range**2 + range_deviation**2)*...*...*(1 +
        ...)/2.
    covariance_xz: stated covariance of x and z, m^2. Error over the sum of its terms taken positive
        at most 52.51 * 2^-52 (float64), 52.51 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.09 in float32 of what its error is relative to; what cancels:
        ((slant_range*(-expm1(-elevation_deviation**2)))**2 + range_deviation**2*(1 +
        (exp((-elevation_deviation**2)/2)**2)**2))/2 - (slant_range**2 +
        range_deviation**2)*(-expm1(-elevation_deviation**2))*(1 +
        exp((-elevation_deviation**2)/2)**2)/2.
    covariance_yy: stated variance of y, m^2. Relative error at most 74.51 * 2^-52 (float64), 74.51
        * 2^-23 (float32), proved for every input, and 4e-44 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.
    covariance_yz: stated covariance of y and z, m^2. Error over the sum of its terms taken positive
        at most 52.51 * 2^-52 (float64), 52.51 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.09 in float32 of what its error is relative to; what cancels:
        ((slant_range*(-expm1(-elevation_deviation**2)))**2 + range_deviation**2*(1 +
        (exp((-elevation_deviation**2)/2)**2)**2))/2 - (slant_range**2 +
        range_deviation**2)*(-expm1(-elevation_deviation**2))*(1 +
        exp((-elevation_deviation**2)/2)**2)/2.
    covariance_zz: stated variance of z, m^2. Relative error at most 33.51 * 2^-52 (float64), 33.51
        * 2^-23 (float32), proved for every input, and 8e-45 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(elevation_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= elevation_deviation <= 2.0
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UnbiasedConversion,
                _unbiased_conversion_of_numbers(
                    slant_range,
                    elevation,
                    azimuth,
                    range_deviation,
                    elevation_deviation,
                    azimuth_deviation,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UnbiasedConversion(
        *evaluate(
            _UNBIASED_CONVERSION,
            (
                slant_range,
                elevation,
                azimuth,
                range_deviation,
                elevation_deviation,
                azimuth_deviation,
            ),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _unbiased_conversion_of_numbers(
    slant_range: float,
    elevation: float,
    azimuth: float,
    range_deviation: float,
    elevation_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = form.cos(elevation)
    t6 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = elevation_deviation * elevation_deviation
    t11 = -t10
    t14 = form.exp(t11 * 0.5)
    t16 = t14 * t14
    t17 = -form.expm1(t11)
    t18 = azimuth_deviation * azimuth_deviation
    t19 = -t18
    t21 = form.exp(t19 * 0.5)
    t22 = form.expm1(t19)
    t23 = t21 * t21
    t24 = -t22
    t25 = range_deviation * range_deviation
    t26 = slant_range * t5
    t27 = t21 * t14
    t28 = t26 / t27
    t29 = slant_range * t6
    t33 = (slant_range * slant_range) + t25
    t36 = t17 * (1.0 + t16)
    t37 = t5 * t5
    t38 = 1.0 + (t16 * t16)
    t40 = t6 * t6
    t44 = t33 * (((t37 * t38) + (t40 * t36)) * 0.5)
    t45 = slant_range * t17
    t49 = ((t45 * t45) + (t25 * t38)) * 0.5
    t51 = (t33 * t36) * 0.5
    t65 = (t23 * ((t37 * t49) + (t40 * t51))) + (((t24 * t24) * t44) * 0.5)
    t69 = (t44 * (t24 * (1.0 + t23))) * 0.5
    t74 = (t26 * ((t23 * t17) - t22)) / t27
    t76 = (t29 * t17) / t14
    t78 = t65 + (t74 * t74)
    t82 = (t21 * ((t5 * t6) * (t49 - t51))) + (t74 * t76)
    t85 = t8 * t8
    t86 = t9 * t9
    t30 = t29 / t14
    t80 = ((t40 * t49) + (t37 * t51)) + (t76 * t76)
    t83 = t28 * t8
    t84 = t28 * t9
    t89 = (t85 * t78) + (t86 * t69)
    t92 = (t9 * t8) * (t78 - t69)
    t93 = t8 * t82
    t96 = (t86 * t78) + (t85 * t69)
    t97 = t9 * t82
    return (t83, t84, t30, t89, t92, t93, t96, t97, t80)


def _unbiased_conversion_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5, n1: float = 1.0
) -> None:
    slant_range, elevation, azimuth, range_deviation, elevation_deviation, azimuth_deviation = given
    (
        x,
        y,
        z,
        covariance_xx,
        covariance_xy,
        covariance_xz,
        covariance_yy,
        covariance_yz,
        covariance_zz,
    ) = out
    (
        w0,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        w16,
        w17,
        w18,
        w19,
        w20,
    ) = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_azimuth = cos(azimuth, w2)
    sin_azimuth = sin(azimuth, w3)
    t10 = square(elevation_deviation, w4)
    t11 = negative(t10, w4)
    t13 = multiply(t11, n0, w5)
    kept_elevation = exp(t13, w5)
    change_elevation = expm1(t11, w4)
    t16 = square(kept_elevation, w6)
    t17 = negative(change_elevation, w4)
    t18 = square(azimuth_deviation, w7)
    t19 = negative(t18, w7)
    t20 = multiply(t19, n0, w8)
    kept_azimuth = exp(t20, w8)
    change_azimuth = expm1(t19, w7)
    t23 = square(kept_azimuth, w9)
    t24 = negative(change_azimuth, w10)
    t25 = square(range_deviation, w11)
    t26 = multiply(slant_range, cos_elevation, w12)
    t27 = multiply(kept_azimuth, kept_elevation, w13)
    t28 = divide(t26, t27, y)
    t29 = multiply(slant_range, sin_elevation, w14)
    t31 = square(t16, w15)
    t32 = square(slant_range, w16)
    t33 = add(t32, t25, w16)
    t35 = add(n1, t16, w6)
    t36 = multiply(t17, t35, w6)
    t37 = square(cos_elevation, w17)
    t38 = add(n1, t31, w15)
    t39 = multiply(t37, t38, w18)
    t40 = square(sin_elevation, w19)
    t41 = multiply(t40, t36, w20)
    t42 = add(t39, t41, w18)
    t43 = multiply(t42, n0, w18)
    t44 = multiply(t33, t43, w18)
    t45 = multiply(slant_range, t17, w20)
    t46 = square(t45, w20)
    t47 = multiply(t25, t38, w11)
    t48 = add(t46, t47, w20)
    t49 = multiply(t48, n0, w20)
    t50 = multiply(t33, t36, w16)
    t51 = multiply(t50, n0, w16)
    t52 = multiply(t37, t49, w6)
    t53 = multiply(t40, t51, w11)
    t54 = add(t52, t53, w6)
    t55 = multiply(t40, t49, w19)
    t56 = multiply(t37, t51, w17)
    t57 = add(t55, t56, w19)
    t58 = multiply(cos_elevation, sin_elevation, w0)
    t59 = subtract(t49, t51, w20)
    t60 = multiply(t58, t59, w0)
    t61 = multiply(t23, t54, w6)
    t62 = square(t24, w1)
    t63 = multiply(t62, t44, w1)
    t64 = multiply(t63, n0, w1)
    t65 = add(t61, t64, w6)
    t66 = add(n1, t23, w1)
    t67 = multiply(t24, t66, w10)
    t68 = multiply(t44, t67, w18)
    t69 = multiply(t68, n0, w18)
    t70 = multiply(kept_azimuth, t60, w8)
    t71 = multiply(t23, t17, w9)
    t72 = subtract(t71, change_azimuth, w9)
    t73 = multiply(t26, t72, w12)
    t74 = divide(t73, t27, z)
    t75 = multiply(t29, t17, w4)
    t76 = divide(t75, kept_elevation, covariance_zz)
    t77 = square(t74, w0)
    t78 = add(t65, t77, w6)
    t79 = square(t76, w0)
    t81 = multiply(t74, t76, z)
    t82 = add(t70, t81, w8)
    t85 = square(cos_azimuth, w1)
    t86 = square(sin_azimuth, w4)
    t87 = multiply(t85, t78, w7)
    t88 = multiply(t86, t69, w9)
    t90 = multiply(sin_azimuth, cos_azimuth, w10)
    t91 = subtract(t78, t69, w11)
    t94 = multiply(t86, t78, w4)
    t95 = multiply(t85, t69, w1)
    divide(t29, kept_elevation, z)
    add(t57, t79, covariance_zz)
    multiply(t28, cos_azimuth, x)
    multiply(t28, sin_azimuth, y)
    add(t87, t88, covariance_xx)
    multiply(t90, t91, covariance_xy)
    multiply(cos_azimuth, t82, covariance_xz)
    add(t94, t95, covariance_yy)
    multiply(sin_azimuth, t82, covariance_yz)


_UNBIASED_CONVERSION = Signature(
    "unbiased_conversion",
    (
        _SLANT_RANGE_DOMAIN,
        _ELEVATION_DOMAIN,
        _AZIMUTH_DOMAIN,
        _RANGE_DEVIATION_DOMAIN,
        _ELEVATION_DEVIATION_DOMAIN,
        _AZIMUTH_DEVIATION_DOMAIN,
    ),
    (
        "x",
        "y",
        "z",
        "covariance_xx",
        "covariance_xy",
        "covariance_xz",
        "covariance_yy",
        "covariance_yz",
        "covariance_zz",
    ),
    21,
    _unbiased_conversion_block,
    numbers=_unbiased_conversion_of_numbers,
)


class ModifiedUnbiasedConversion(NamedTuple):
    """Result of `modified_unbiased_conversion`."""

    x: Real
    """Converted x, m."""
    y: Real
    """Converted y, m."""
    z: Real
    """Converted z, m."""
    covariance_xx: Real
    """Stated variance of x, m^2."""
    covariance_xy: Real
    """Stated covariance of x and y, m^2."""
    covariance_xz: Real
    """Stated covariance of x and z, m^2."""
    covariance_yy: Real
    """Stated variance of y, m^2."""
    covariance_yz: Real
    """Stated covariance of y and z, m^2."""
    covariance_zz: Real
    """Stated variance of z, m^2."""


def modified_unbiased_conversion(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    elevation_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> ModifiedUnbiasedConversion:
    """Mean and covariance of the true place given the measurement, in space.

        With ke = exp(-se^2/2), k = ke exp(-sa^2/2): x = k r cos e cos a, y likewise,
        z = ke r sin e, with their covariance: both exact, given the measurement, where nothing
        was known of the truth before

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    elevation: measured elevation above the plane of x and y, rad; 0 or of magnitude 1e-20 to
        1.5707963267948966, in float32 1e-12 to 1.5707962.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    elevation_deviation: standard deviation of the elevation, rad; a number at least 1e-15 and at
        most 2, in float32 at least 1e-6 and at most 2.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.

    x: converted x, m. Relative error at most 20.01 * 2^-52 (float64), 20.01 * 2^-23 (float32),
        proved for every input, provided np.cos and np.exp err by at most 4 units in the last place
        of the true value.
    y: converted y, m. Relative error at most 20.01 * 2^-52 (float64), 20.01 * 2^-23 (float32),
        proved for every input, provided np.sin, np.cos and np.exp err by at most 4 units in the
        last place of the true value.
    z: converted z, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32),
        proved for every input, provided np.sin and np.exp err by at most 4 units in the last place
        of the true value.
    covariance_xx: stated variance of x, m^2. Relative error at most 59.01 * 2^-52 (float64), 59.01
        * 2^-23 (float32), proved for every input, and 4e-44 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 59.01 * 2^-52 (float64), 59.01 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.1 in float32 of what its error is relative to; what cancels: ... -
        (slant_range**2 + range_deviation**2)*...*...*(1 + ...)/2.
    covariance_xz: stated covariance of x and z, m^2. Error over the sum of its terms taken positive
        at most 43.01 * 2^-52 (float64), 43.01 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.07 in float32 of what its error is relative to; what cancels:
        ((slant_range*(-expm1(-elevation_deviation**2)))**2 + range_deviation**2*(1 +
        (exp((-elevation_deviation**2)/2)**2)**2))/2 - (slant_range**2 +
        range_deviation**2)*(-expm1(-elevation_deviation**2))*(1 +
        exp((-elevation_deviation**2)/2)**2)/2.
    covariance_yy: stated variance of y, m^2. Relative error at most 59.01 * 2^-52 (float64), 59.01
        * 2^-23 (float32), proved for every input, and 4e-44 (float32) beside it where a product
        underflows, provided np.sin, np.cos, np.exp and np.expm1 err by at most 4 units in the last
        place of the true value.
    covariance_yz: stated covariance of y and z, m^2. Error over the sum of its terms taken positive
        at most 43.01 * 2^-52 (float64), 43.01 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.07 in float32 of what its error is relative to; what cancels:
        ((slant_range*(-expm1(-elevation_deviation**2)))**2 + range_deviation**2*(1 +
        (exp((-elevation_deviation**2)/2)**2)**2))/2 - (slant_range**2 +
        range_deviation**2)*(-expm1(-elevation_deviation**2))*(1 +
        exp((-elevation_deviation**2)/2)**2)/2.
    covariance_zz: stated variance of z, m^2. Relative error at most 33.01 * 2^-52 (float64), 33.01
        * 2^-23 (float32), proved for every input, provided np.sin, np.cos, np.exp and np.expm1 err
        by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(elevation_deviation) is float
        and type(azimuth_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= elevation_deviation <= 2.0
        and 1e-15 <= azimuth_deviation <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                ModifiedUnbiasedConversion,
                _modified_unbiased_conversion_of_numbers(
                    slant_range,
                    elevation,
                    azimuth,
                    range_deviation,
                    elevation_deviation,
                    azimuth_deviation,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ModifiedUnbiasedConversion(
        *evaluate(
            _MODIFIED_UNBIASED_CONVERSION,
            (
                slant_range,
                elevation,
                azimuth,
                range_deviation,
                elevation_deviation,
                azimuth_deviation,
            ),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _modified_unbiased_conversion_of_numbers(
    slant_range: float,
    elevation: float,
    azimuth: float,
    range_deviation: float,
    elevation_deviation: float,
    azimuth_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = form.cos(elevation)
    t6 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = elevation_deviation * elevation_deviation
    t11 = -t10
    t14 = form.exp(t11 * 0.5)
    t16 = t14 * t14
    t17 = -form.expm1(t11)
    t18 = azimuth_deviation * azimuth_deviation
    t19 = -t18
    t21 = form.exp(t19 * 0.5)
    t23 = t21 * t21
    t24 = -form.expm1(t19)
    t25 = range_deviation * range_deviation
    t28 = (slant_range * t5) * (t21 * t14)
    t33 = (slant_range * slant_range) + t25
    t36 = t17 * (1.0 + t16)
    t37 = t5 * t5
    t38 = 1.0 + (t16 * t16)
    t40 = t6 * t6
    t44 = t33 * (((t37 * t38) + (t40 * t36)) * 0.5)
    t45 = slant_range * t17
    t49 = ((t45 * t45) + (t25 * t38)) * 0.5
    t51 = (t33 * t36) * 0.5
    t65 = (t23 * ((t37 * t49) + (t40 * t51))) + (((t24 * t24) * t44) * 0.5)
    t69 = (t44 * (t24 * (1.0 + t23))) * 0.5
    t70 = t21 * ((t5 * t6) * (t49 - t51))
    t73 = t8 * t8
    t74 = t9 * t9
    t30 = (slant_range * t6) * t14
    t57 = (t40 * t49) + (t37 * t51)
    t71 = t28 * t8
    t72 = t28 * t9
    t77 = (t73 * t65) + (t74 * t69)
    t80 = (t9 * t8) * (t65 - t69)
    t81 = t8 * t70
    t84 = (t74 * t65) + (t73 * t69)
    t85 = t9 * t70
    return (t71, t72, t30, t77, t80, t81, t84, t85, t57)


def _modified_unbiased_conversion_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5, n1: float = 1.0
) -> None:
    slant_range, elevation, azimuth, range_deviation, elevation_deviation, azimuth_deviation = given
    (
        x,
        y,
        z,
        covariance_xx,
        covariance_xy,
        covariance_xz,
        covariance_yy,
        covariance_yz,
        covariance_zz,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16, w17, w18 = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_azimuth = cos(azimuth, w2)
    sin_azimuth = sin(azimuth, w3)
    t10 = square(elevation_deviation, w4)
    t11 = negative(t10, w4)
    t13 = multiply(t11, n0, w5)
    kept_elevation = exp(t13, w5)
    change_elevation = expm1(t11, w4)
    t16 = square(kept_elevation, w6)
    t17 = negative(change_elevation, w4)
    t18 = square(azimuth_deviation, w7)
    t19 = negative(t18, w7)
    t20 = multiply(t19, n0, w8)
    kept_azimuth = exp(t20, w8)
    change_azimuth = expm1(t19, w7)
    t23 = square(kept_azimuth, w9)
    t24 = negative(change_azimuth, w7)
    t25 = square(range_deviation, w10)
    t26 = multiply(slant_range, cos_elevation, w11)
    t27 = multiply(kept_azimuth, kept_elevation, w12)
    t28 = multiply(t26, t27, w11)
    t29 = multiply(slant_range, sin_elevation, w12)
    t31 = square(t16, w13)
    t32 = square(slant_range, w14)
    t33 = add(t32, t25, w14)
    t35 = add(n1, t16, w6)
    t36 = multiply(t17, t35, w6)
    t37 = square(cos_elevation, w15)
    t38 = add(n1, t31, w13)
    t39 = multiply(t37, t38, w16)
    t40 = square(sin_elevation, w17)
    t41 = multiply(t40, t36, w18)
    t42 = add(t39, t41, w16)
    t43 = multiply(t42, n0, w16)
    t44 = multiply(t33, t43, w16)
    t45 = multiply(slant_range, t17, w4)
    t46 = square(t45, w4)
    t47 = multiply(t25, t38, w10)
    t48 = add(t46, t47, w4)
    t49 = multiply(t48, n0, w4)
    t50 = multiply(t33, t36, w14)
    t51 = multiply(t50, n0, w14)
    t52 = multiply(t37, t49, w6)
    t53 = multiply(t40, t51, w10)
    t54 = add(t52, t53, w6)
    t55 = multiply(t40, t49, w17)
    t56 = multiply(t37, t51, w15)
    t58 = multiply(cos_elevation, sin_elevation, w0)
    t59 = subtract(t49, t51, w4)
    t60 = multiply(t58, t59, w0)
    t61 = multiply(t23, t54, w6)
    t62 = square(t24, w1)
    t63 = multiply(t62, t44, w1)
    t64 = multiply(t63, n0, w1)
    t65 = add(t61, t64, w6)
    t66 = add(n1, t23, w9)
    t67 = multiply(t24, t66, w7)
    t68 = multiply(t44, t67, w16)
    t69 = multiply(t68, n0, w16)
    t70 = multiply(kept_azimuth, t60, w8)
    t73 = square(cos_azimuth, w0)
    t74 = square(sin_azimuth, w1)
    t75 = multiply(t73, t65, w4)
    t76 = multiply(t74, t69, w7)
    t78 = multiply(sin_azimuth, cos_azimuth, w9)
    t79 = subtract(t65, t69, w10)
    t82 = multiply(t74, t65, w1)
    t83 = multiply(t73, t69, w0)
    multiply(t29, kept_elevation, z)
    add(t55, t56, covariance_zz)
    multiply(t28, cos_azimuth, x)
    multiply(t28, sin_azimuth, y)
    add(t75, t76, covariance_xx)
    multiply(t78, t79, covariance_xy)
    multiply(cos_azimuth, t70, covariance_xz)
    add(t82, t83, covariance_yy)
    multiply(sin_azimuth, t70, covariance_yz)


_MODIFIED_UNBIASED_CONVERSION = Signature(
    "modified_unbiased_conversion",
    (
        _SLANT_RANGE_DOMAIN,
        _ELEVATION_DOMAIN,
        _AZIMUTH_DOMAIN,
        _RANGE_DEVIATION_DOMAIN,
        _ELEVATION_DEVIATION_DOMAIN,
        _AZIMUTH_DEVIATION_DOMAIN,
    ),
    (
        "x",
        "y",
        "z",
        "covariance_xx",
        "covariance_xy",
        "covariance_xz",
        "covariance_yy",
        "covariance_yz",
        "covariance_zz",
    ),
    19,
    _modified_unbiased_conversion_block,
    numbers=_modified_unbiased_conversion_of_numbers,
)


class CorrelatedUnbiasedConversionInPlane(NamedTuple):
    """Result of `correlated_unbiased_conversion_in_plane`."""

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


def correlated_unbiased_conversion_in_plane(
    slant_range: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    correlation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> CorrelatedUnbiasedConversionInPlane:
    """The conversion without bias given the truth, noises correlated.

        With k = exp(-sa^2/2), c = correlation sr sa: (r/k, -c/k) along and across the measured
        line of sight; the covariance is the mean square error given the measurement

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.
    correlation: correlation of the noises of range and azimuth; 0 or of magnitude 1e-20 to 1, in
        float32 1e-6 to 1.

    x: converted x, m. Error over the sum of its terms taken positive at most 11.51 * 2^-52
        (float64), 11.51 * 2^-23 (float32), proved for every input, provided np.sin, np.cos and
        np.exp err by at most 4 units in the last place of the true value. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        3e-7 in float64 and 0.01 in float32 of what its error is relative to; what cancels:
        slant_range/exp((-azimuth_deviation**2)/2)*cos(azimuth) -
        (-range_deviation*azimuth_deviation*correlation/exp((-azimuth_deviation**2)/2))*sin(azimuth).
    y: converted y, m. Error over the sum of its terms taken positive at most 11.51 * 2^-52
        (float64), 11.51 * 2^-23 (float32), proved for every input, provided np.sin, np.cos and
        np.exp err by at most 4 units in the last place of the true value. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        3e-7 in float64 and 0.01 in float32 of what its error is relative to; what cancels:
        slant_range/exp((-azimuth_deviation**2)/2)*sin(azimuth) +
        (-range_deviation*azimuth_deviation*correlation/exp((-azimuth_deviation**2)/2))*cos(azimuth).
    covariance_xx: stated variance of x, m^2. Error over the sum of its terms taken positive at most
        47.01 * 2^-52 (float64), 47.01 * 2^-23 (float32), proved for every input, and 5e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.08 in float32 of what its error is relative to; what cancels: 1 -
        2*exp((-azimuth_deviation**2)/2)**2.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 47.01 * 2^-52 (float64), 47.01 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.08 in float32 of what its error is relative to; what cancels: ... +
        (slant_range*.../...)**2 - (... - ...*(1 - ...) + ...).
    covariance_yy: stated variance of y, m^2. Error over the sum of its terms taken positive at most
        47.01 * 2^-52 (float64), 47.01 * 2^-23 (float32), proved for every input, and 5e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 2e-6
        in float64 and 0.08 in float32 of what its error is relative to; what cancels: 1 -
        2*exp((-azimuth_deviation**2)/2)**2.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(azimuth_deviation) is float
        and type(correlation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= azimuth_deviation <= 2.0
        and -1.0 <= correlation <= 1.0
        and (abs(correlation) >= 1e-20 or correlation == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                CorrelatedUnbiasedConversionInPlane,
                _correlated_unbiased_conversion_in_plane_of_numbers(
                    slant_range, azimuth, range_deviation, azimuth_deviation, correlation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return CorrelatedUnbiasedConversionInPlane(
        *evaluate(
            _CORRELATED_UNBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation, correlation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _correlated_unbiased_conversion_in_plane_of_numbers(
    slant_range: float,
    azimuth: float,
    range_deviation: float,
    azimuth_deviation: float,
    correlation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = form.cos(azimuth)
    t5 = form.sin(azimuth)
    t7 = azimuth_deviation * azimuth_deviation
    t8 = -t7
    t11 = form.exp(t8 * 0.5)
    t13 = range_deviation * range_deviation
    t14 = t11 * t11
    t15 = -form.expm1(t8)
    t17 = (range_deviation * azimuth_deviation) * correlation
    t18 = t14 * t14
    t21 = 1.0 - (t14 * 2.0)
    t22 = slant_range * t15
    t27 = ((t22 * t22) + (t13 * (1.0 + t18))) * 0.5
    t28 = t17 * t17
    t34 = 1.0 + t14
    t36 = ((slant_range * slant_range) + t13) * (t15 * t34)
    t44 = slant_range / t11
    t46 = -(t17 / t11)
    t47 = t22 / t11
    t50 = -((t17 * t34) / t11)
    t52 = (t27 - ((t18 * t28) * 2.0)) + (t47 * t47)
    t54 = ((t36 * 0.5) - ((t14 * t28) * t21)) + (t50 * t50)
    t56 = (t47 * t50) - ((t14 * (slant_range * t17)) * t21)
    t57 = t4 * t4
    t58 = t5 * t5
    t59 = t5 * t4
    t70 = (t59 * t56) * 2.0
    t62 = (t44 * t4) - (t46 * t5)
    t65 = (t44 * t5) + (t46 * t4)
    t71 = ((t57 * t52) + (t58 * t54)) - t70
    t76 = (t59 * (t52 - t54)) + ((t57 - t58) * t56)
    t80 = ((t58 * t52) + (t57 * t54)) + t70
    return (t62, t65, t71, t76, t80)


def _correlated_unbiased_conversion_in_plane_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 2.0,
    n2: float = 1.0,
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation, correlation = given
    x, y, covariance_xx, covariance_xy, covariance_yy = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    t7 = square(azimuth_deviation, w2)
    t8 = negative(t7, w2)
    t10 = multiply(t8, n0, w3)
    kept_azimuth = exp(t10, w3)
    change_azimuth = expm1(t8, w2)
    t13 = square(range_deviation, w4)
    t14 = square(kept_azimuth, w5)
    t15 = negative(change_azimuth, w2)
    t16 = multiply(range_deviation, azimuth_deviation, w6)
    t17 = multiply(t16, correlation, w6)
    t18 = square(t14, w7)
    t19 = multiply(t14, n1, w8)
    t21 = subtract(n2, t19, w8)
    t22 = multiply(slant_range, t15, w9)
    t23 = square(t22, w10)
    t24 = add(n2, t18, w11)
    t25 = multiply(t13, t24, w11)
    t26 = add(t23, t25, w10)
    t27 = multiply(t26, n0, w10)
    t28 = square(t17, w11)
    t29 = multiply(t18, t28, w7)
    t30 = multiply(t29, n1, w7)
    t31 = subtract(t27, t30, w10)
    t32 = square(slant_range, w7)
    t33 = add(t32, t13, w7)
    t34 = add(n2, t14, w4)
    t35 = multiply(t15, t34, w2)
    t36 = multiply(t33, t35, w7)
    t37 = multiply(t36, n0, w7)
    t38 = multiply(t14, t28, w11)
    t39 = multiply(t38, t21, w11)
    t40 = subtract(t37, t39, w7)
    t41 = multiply(slant_range, t17, w2)
    t42 = multiply(t14, t41, w5)
    t43 = multiply(t42, t21, w5)
    t44 = divide(slant_range, kept_azimuth, x)
    t45 = divide(t17, kept_azimuth, y)
    t46 = negative(t45, y)
    t47 = divide(t22, kept_azimuth, covariance_xx)
    t48 = multiply(t17, t34, w6)
    t49 = divide(t48, kept_azimuth, covariance_xy)
    t50 = negative(t49, covariance_xy)
    t51 = square(t47, w2)
    t52 = add(t31, t51, w10)
    t53 = square(t50, w2)
    t54 = add(t40, t53, w7)
    t55 = multiply(t47, t50, covariance_xx)
    t56 = subtract(t55, t43, covariance_xx)
    t57 = square(cos_azimuth, w2)
    t58 = square(sin_azimuth, w3)
    t59 = multiply(sin_azimuth, cos_azimuth, w4)
    t60 = multiply(t44, cos_azimuth, w5)
    t61 = multiply(t46, sin_azimuth, w6)
    t63 = multiply(t44, sin_azimuth, w1)
    t64 = multiply(t46, cos_azimuth, y)
    t66 = multiply(t57, t52, w0)
    t67 = multiply(t58, t54, w8)
    t68 = add(t66, t67, w0)
    t69 = multiply(t59, t56, w8)
    t70 = multiply(t69, n1, w8)
    t72 = subtract(t52, t54, w9)
    t73 = multiply(t59, t72, w4)
    t74 = subtract(t57, t58, w9)
    t75 = multiply(t74, t56, w9)
    t77 = multiply(t58, t52, w3)
    t78 = multiply(t57, t54, w2)
    t79 = add(t77, t78, w3)
    subtract(t60, t61, x)
    add(t63, t64, y)
    subtract(t68, t70, covariance_xx)
    add(t73, t75, covariance_xy)
    add(t79, t70, covariance_yy)


_CORRELATED_UNBIASED_CONVERSION_IN_PLANE = Signature(
    "correlated_unbiased_conversion_in_plane",
    (
        _SLANT_RANGE_DOMAIN,
        _AZIMUTH_DOMAIN,
        _RANGE_DEVIATION_DOMAIN,
        _AZIMUTH_DEVIATION_DOMAIN,
        _CORRELATION_DOMAIN,
    ),
    ("x", "y", "covariance_xx", "covariance_xy", "covariance_yy"),
    12,
    _correlated_unbiased_conversion_in_plane_block,
    numbers=_correlated_unbiased_conversion_in_plane_of_numbers,
)


class CorrelatedModifiedUnbiasedConversionInPlane(NamedTuple):
    """Result of `correlated_modified_unbiased_conversion_in_plane`."""

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


def correlated_modified_unbiased_conversion_in_plane(
    slant_range: ArrayLike,
    azimuth: ArrayLike,
    range_deviation: ArrayLike,
    azimuth_deviation: ArrayLike,
    correlation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> CorrelatedModifiedUnbiasedConversionInPlane:
    """Mean and covariance of the true place given the measurement, noises correlated.

        With k = exp(-sa^2/2), c = correlation sr sa: (k r, k c) along and across the measured
        line of sight, with the covariance of the true place: both exact, given the measurement

    slant_range: measured range, m; a number at least 1e-20 and at most 1e60, in float32 at least
        1e-3 and at most 1e12.
    azimuth: measured azimuth from x towards y, rad; 0 or of magnitude 1e-20 to 6.2832, in float32
        1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; a number at least 1e-20 and at most 1e60,
        in float32 at least 1e-3 and at most 1e12.
    azimuth_deviation: standard deviation of the azimuth, rad; a number at least 1e-15 and at most
        2, in float32 at least 1e-6 and at most 2.
    correlation: correlation of the noises of range and azimuth; 0 or of magnitude 1e-20 to 1, in
        float32 1e-6 to 1.

    x: converted x, m. Error over the sum of its terms taken positive at most 11.51 * 2^-52
        (float64), 11.51 * 2^-23 (float32), proved for every input, provided np.sin, np.cos and
        np.exp err by at most 4 units in the last place of the true value. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        3e-7 in float64 and 0.01 in float32 of what its error is relative to; what cancels:
        slant_range*exp((-azimuth_deviation**2)/2)*cos(azimuth) -
        range_deviation*azimuth_deviation*correlation*exp((-azimuth_deviation**2)/2)*sin(azimuth).
    y: converted y, m. Error over the sum of its terms taken positive at most 11.51 * 2^-52
        (float64), 11.51 * 2^-23 (float32), proved for every input, provided np.sin, np.cos and
        np.exp err by at most 4 units in the last place of the true value. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        3e-7 in float64 and 0.01 in float32 of what its error is relative to; what cancels:
        slant_range*exp((-azimuth_deviation**2)/2)*sin(azimuth) +
        range_deviation*azimuth_deviation*correlation*exp((-azimuth_deviation**2)/2)*cos(azimuth).
    covariance_xx: stated variance of x, m^2. Error over the sum of its terms taken positive at most
        35.51 * 2^-52 (float64), 35.51 * 2^-23 (float32), proved for every input, and 5e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 9e-7
        in float64 and 0.06 in float32 of what its error is relative to; what cancels: 1 -
        2*exp((-azimuth_deviation**2)/2)**2.
    covariance_xy: stated covariance of x and y, m^2. Error over the sum of its terms taken positive
        at most 35.51 * 2^-52 (float64), 35.51 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 9e-7
        in float64 and 0.06 in float32 of what its error is relative to; what cancels: ... - (... -
        ...*(1 - ...)).
    covariance_yy: stated variance of y, m^2. Error over the sum of its terms taken positive at most
        35.51 * 2^-52 (float64), 35.51 * 2^-23 (float32), proved for every input, and 5e-44
        (float32) beside it where a product underflows, provided np.sin, np.cos, np.exp and np.expm1
        err by at most 4 units in the last place of the true value. Digits that can be lost: up to
        16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below 9e-7
        in float64 and 0.06 in float32 of what its error is relative to; what cancels: 1 -
        2*exp((-azimuth_deviation**2)/2)**2.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation converted-measurements
    """
    if (
        type(slant_range) is float
        and type(azimuth) is float
        and type(range_deviation) is float
        and type(azimuth_deviation) is float
        and type(correlation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= azimuth <= 6.2832
        and (abs(azimuth) >= 1e-20 or azimuth == 0)
        and 1e-20 <= range_deviation <= 1e60
        and 1e-15 <= azimuth_deviation <= 2.0
        and -1.0 <= correlation <= 1.0
        and (abs(correlation) >= 1e-20 or correlation == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                CorrelatedModifiedUnbiasedConversionInPlane,
                _correlated_modified_unbiased_conversion_in_plane_of_numbers(
                    slant_range, azimuth, range_deviation, azimuth_deviation, correlation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return CorrelatedModifiedUnbiasedConversionInPlane(
        *evaluate(
            _CORRELATED_MODIFIED_UNBIASED_CONVERSION_IN_PLANE,
            (slant_range, azimuth, range_deviation, azimuth_deviation, correlation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _correlated_modified_unbiased_conversion_in_plane_of_numbers(
    slant_range: float,
    azimuth: float,
    range_deviation: float,
    azimuth_deviation: float,
    correlation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = form.cos(azimuth)
    t5 = form.sin(azimuth)
    t7 = azimuth_deviation * azimuth_deviation
    t8 = -t7
    t11 = form.exp(t8 * 0.5)
    t13 = range_deviation * range_deviation
    t14 = t11 * t11
    t15 = -form.expm1(t8)
    t17 = (range_deviation * azimuth_deviation) * correlation
    t18 = t14 * t14
    t21 = 1.0 - (t14 * 2.0)
    t22 = slant_range * t15
    t27 = ((t22 * t22) + (t13 * (1.0 + t18))) * 0.5
    t28 = t17 * t17
    t31 = t27 - ((t18 * t28) * 2.0)
    t36 = ((slant_range * slant_range) + t13) * (t15 * (1.0 + t14))
    t40 = (t36 * 0.5) - ((t14 * t28) * t21)
    t44 = -((t14 * (slant_range * t17)) * t21)
    t45 = slant_range * t11
    t46 = t17 * t11
    t47 = t4 * t4
    t48 = t5 * t5
    t49 = t5 * t4
    t60 = (t49 * t44) * 2.0
    t52 = (t45 * t4) - (t46 * t5)
    t55 = (t45 * t5) + (t46 * t4)
    t61 = ((t47 * t31) + (t48 * t40)) - t60
    t66 = (t49 * (t31 - t40)) + ((t47 - t48) * t44)
    t70 = ((t48 * t31) + (t47 * t40)) + t60
    return (t52, t55, t61, t66, t70)


def _correlated_modified_unbiased_conversion_in_plane_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 2.0,
    n2: float = 1.0,
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation, correlation = given
    x, y, covariance_xx, covariance_xy, covariance_yy = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    t7 = square(azimuth_deviation, w2)
    t8 = negative(t7, w2)
    t10 = multiply(t8, n0, w3)
    kept_azimuth = exp(t10, w3)
    change_azimuth = expm1(t8, w2)
    t13 = square(range_deviation, w4)
    t14 = square(kept_azimuth, w5)
    t15 = negative(change_azimuth, w2)
    t16 = multiply(range_deviation, azimuth_deviation, w6)
    t17 = multiply(t16, correlation, w6)
    t18 = square(t14, w7)
    t19 = multiply(t14, n1, w8)
    t21 = subtract(n2, t19, w8)
    t22 = multiply(slant_range, t15, w9)
    t23 = square(t22, w9)
    t24 = add(n2, t18, w10)
    t25 = multiply(t13, t24, w10)
    t26 = add(t23, t25, w9)
    t27 = multiply(t26, n0, w9)
    t28 = square(t17, w10)
    t29 = multiply(t18, t28, w7)
    t30 = multiply(t29, n1, w7)
    t31 = subtract(t27, t30, w9)
    t32 = square(slant_range, w7)
    t33 = add(t32, t13, w7)
    t34 = add(n2, t14, w4)
    t35 = multiply(t15, t34, w2)
    t36 = multiply(t33, t35, w7)
    t37 = multiply(t36, n0, w7)
    t38 = multiply(t14, t28, w10)
    t39 = multiply(t38, t21, w10)
    t40 = subtract(t37, t39, w7)
    t41 = multiply(slant_range, t17, w2)
    t42 = multiply(t14, t41, w5)
    t43 = multiply(t42, t21, w5)
    t44 = negative(t43, w5)
    t45 = multiply(slant_range, kept_azimuth, w2)
    t46 = multiply(t17, kept_azimuth, w6)
    t47 = square(cos_azimuth, w3)
    t48 = square(sin_azimuth, w4)
    t49 = multiply(sin_azimuth, cos_azimuth, w8)
    t50 = multiply(t45, cos_azimuth, w10)
    t51 = multiply(t46, sin_azimuth, w11)
    t53 = multiply(t45, sin_azimuth, w2)
    t54 = multiply(t46, cos_azimuth, w6)
    t56 = multiply(t47, t31, w0)
    t57 = multiply(t48, t40, w1)
    t58 = add(t56, t57, w0)
    t59 = multiply(t49, t44, w1)
    t60 = multiply(t59, n1, w1)
    t62 = subtract(t31, t40, w12)
    t63 = multiply(t49, t62, w8)
    t64 = subtract(t47, t48, w12)
    t65 = multiply(t64, t44, w12)
    t67 = multiply(t48, t31, w4)
    t68 = multiply(t47, t40, w3)
    t69 = add(t67, t68, w4)
    subtract(t50, t51, x)
    add(t53, t54, y)
    subtract(t58, t60, covariance_xx)
    add(t63, t65, covariance_xy)
    add(t69, t60, covariance_yy)


_CORRELATED_MODIFIED_UNBIASED_CONVERSION_IN_PLANE = Signature(
    "correlated_modified_unbiased_conversion_in_plane",
    (
        _SLANT_RANGE_DOMAIN,
        _AZIMUTH_DOMAIN,
        _RANGE_DEVIATION_DOMAIN,
        _AZIMUTH_DEVIATION_DOMAIN,
        _CORRELATION_DOMAIN,
    ),
    ("x", "y", "covariance_xx", "covariance_xy", "covariance_yy"),
    13,
    _correlated_modified_unbiased_conversion_in_plane_block,
    numbers=_correlated_modified_unbiased_conversion_in_plane_of_numbers,
)
