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
    t6 = range_deviation * range_deviation
    t7 = slant_range * azimuth_deviation
    t8 = t7 * t7
    t11 = t4 * t4
    t12 = t5 * t5
    t9 = slant_range * t4
    t10 = slant_range * t5
    t16 = (t11 * t6) + (t12 * t8)
    t18 = (t5 * t4) * (t6 - t8)
    t21 = (t12 * t6) + (t11 * t8)
    return (t9, t10, t16, t18, t21, t6, t8)


def _classical_conversion_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation = given
    x, y, covariance_xx, covariance_xy, covariance_yy, radial_variance, cross_variance = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    square(range_deviation, radial_variance)
    t7 = multiply(slant_range, azimuth_deviation, w2)
    square(t7, cross_variance)
    t11 = square(cos_azimuth, w2)
    t12 = square(sin_azimuth, w3)
    t13 = multiply(sin_azimuth, cos_azimuth, w4)
    t14 = multiply(t11, radial_variance, w5)
    t15 = multiply(t12, cross_variance, w6)
    t17 = subtract(radial_variance, cross_variance, w7)
    t19 = multiply(t12, radial_variance, w3)
    t20 = multiply(t11, cross_variance, w2)
    multiply(slant_range, cos_azimuth, x)
    multiply(slant_range, sin_azimuth, y)
    add(t14, t15, covariance_xx)
    multiply(t13, t17, covariance_xy)
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
    t12 = t10 * t10
    t13 = -t11
    t18 = slant_range * ((t10 * t13) / (1.0 + t10))
    t19 = slant_range + t18
    t20 = t12 * t12
    t21 = range_deviation * range_deviation
    t22 = slant_range * slant_range
    t25 = 1.0 + t12
    t28 = (t22 + t21) * ((t13 * t13) * (t25 + t20))
    t33 = (t28 + (t21 * (1.0 + (t20 * t20)))) * 0.5
    t41 = t21 * (t25 * ((1.0 - t11) + (t20 * 2.0)))
    t43 = t13 * ((t22 * (1.0 + (t20 * t12))) + t41)
    t44 = t43 * 0.5
    t47 = t4 * t4
    t48 = t5 * t5
    t45 = t19 * t4
    t46 = t19 * t5
    t52 = (t47 * t33) + (t48 * t44)
    t54 = (t5 * t4) * (t33 - t44)
    t57 = (t48 * t33) + (t47 * t44)
    return (t45, t46, t52, t54, t57, t33, t44)


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
    t12 = square(kept_azimuth, w4)
    t13 = negative(change_azimuth, w5)
    t14 = multiply(kept_azimuth, t13, w6)
    t16 = add(n1, kept_azimuth, w3)
    t17 = divide(t14, t16, radial_variance)
    t18 = multiply(slant_range, t17, radial_variance)
    t19 = add(slant_range, t18, w3)
    t20 = square(t12, w6)
    t21 = square(range_deviation, w7)
    t22 = square(slant_range, w8)
    t23 = add(t22, t21, radial_variance)
    t24 = square(t13, w9)
    t25 = add(n1, t12, w10)
    t26 = add(t25, t20, w11)
    t27 = multiply(t24, t26, w9)
    t28 = multiply(t23, t27, radial_variance)
    t29 = square(t20, w9)
    t30 = add(n1, t29, w9)
    t31 = multiply(t21, t30, w9)
    t32 = add(t28, t31, radial_variance)
    multiply(t32, n0, radial_variance)
    t34 = multiply(t20, t12, w4)
    t35 = add(n1, t34, w4)
    t36 = multiply(t22, t35, w8)
    t37 = subtract(n1, change_azimuth, w2)
    t38 = multiply(t20, n2, w6)
    t39 = add(t37, t38, w2)
    t40 = multiply(t25, t39, w10)
    t41 = multiply(t21, t40, w7)
    t42 = add(t36, t41, w8)
    t43 = multiply(t13, t42, w5)
    multiply(t43, n0, cross_variance)
    t47 = square(cos_azimuth, w2)
    t48 = square(sin_azimuth, w4)
    t49 = multiply(sin_azimuth, cos_azimuth, w5)
    t50 = multiply(t47, radial_variance, w6)
    t51 = multiply(t48, cross_variance, w7)
    t53 = subtract(radial_variance, cross_variance, w8)
    t55 = multiply(t48, radial_variance, w4)
    t56 = multiply(t47, cross_variance, w2)
    multiply(t19, cos_azimuth, x)
    multiply(t19, sin_azimuth, y)
    add(t50, t51, covariance_xx)
    multiply(t49, t53, covariance_xy)
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
    t12 = t10 * t10
    t13 = -form.expm1(t7)
    t14 = slant_range / t10
    t16 = range_deviation * range_deviation
    t19 = slant_range * t13
    t20 = t19 * t19
    t25 = (t20 + (t16 * (1.0 + (t12 * t12)))) * 0.5
    t27 = t25 + (t20 / t12)
    t30 = ((slant_range * slant_range) + t16) * (t13 * (1.0 + t12))
    t31 = t30 * 0.5
    t34 = t4 * t4
    t35 = t5 * t5
    t32 = t14 * t4
    t33 = t14 * t5
    t39 = (t34 * t27) + (t35 * t31)
    t41 = (t5 * t4) * (t27 - t31)
    t44 = (t35 * t27) + (t34 * t31)
    return (t32, t33, t39, t41, t44, t27, t31)


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
    t12 = square(kept_azimuth, w4)
    t13 = negative(change_azimuth, w2)
    t14 = divide(slant_range, kept_azimuth, y)
    t15 = square(t12, w3)
    t16 = square(range_deviation, w5)
    t17 = square(slant_range, w6)
    t18 = add(t17, t16, w6)
    t19 = multiply(slant_range, t13, w7)
    t20 = square(t19, w7)
    t22 = add(n1, t15, w3)
    t23 = multiply(t16, t22, w5)
    t24 = add(t20, t23, w5)
    t25 = multiply(t24, n0, w5)
    t26 = divide(t20, t12, radial_variance)
    add(t25, t26, radial_variance)
    t28 = add(n1, t12, w4)
    t29 = multiply(t13, t28, w2)
    t30 = multiply(t18, t29, w6)
    multiply(t30, n0, cross_variance)
    t34 = square(cos_azimuth, w2)
    t35 = square(sin_azimuth, w3)
    t36 = multiply(sin_azimuth, cos_azimuth, w4)
    t37 = multiply(t34, radial_variance, w5)
    t38 = multiply(t35, cross_variance, w6)
    t40 = subtract(radial_variance, cross_variance, w7)
    t42 = multiply(t35, radial_variance, w3)
    t43 = multiply(t34, cross_variance, w2)
    multiply(t14, cos_azimuth, x)
    multiply(t14, sin_azimuth, y)
    add(t37, t38, covariance_xx)
    multiply(t36, t40, covariance_xy)
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
    t12 = t10 * t10
    t13 = -form.expm1(t7)
    t14 = slant_range * t10
    t16 = range_deviation * range_deviation
    t19 = slant_range * t13
    t24 = (t19 * t19) + (t16 * (1.0 + (t12 * t12)))
    t25 = t24 * 0.5
    t28 = ((slant_range * slant_range) + t16) * (t13 * (1.0 + t12))
    t29 = t28 * 0.5
    t32 = t4 * t4
    t33 = t5 * t5
    t30 = t14 * t4
    t31 = t14 * t5
    t37 = (t32 * t25) + (t33 * t29)
    t39 = (t5 * t4) * (t25 - t29)
    t42 = (t33 * t25) + (t32 * t29)
    return (t30, t31, t37, t39, t42, t25, t29)


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
    t12 = square(kept_azimuth, w4)
    t13 = negative(change_azimuth, w2)
    t14 = multiply(slant_range, kept_azimuth, w3)
    t15 = square(t12, w5)
    t16 = square(range_deviation, w6)
    t17 = square(slant_range, w7)
    t18 = add(t17, t16, w7)
    t19 = multiply(slant_range, t13, w8)
    t20 = square(t19, w8)
    t22 = add(n1, t15, w5)
    t23 = multiply(t16, t22, w6)
    t24 = add(t20, t23, w8)
    multiply(t24, n0, radial_variance)
    t26 = add(n1, t12, w4)
    t27 = multiply(t13, t26, w2)
    t28 = multiply(t18, t27, w7)
    multiply(t28, n0, cross_variance)
    t32 = square(cos_azimuth, w2)
    t33 = square(sin_azimuth, w4)
    t34 = multiply(sin_azimuth, cos_azimuth, w5)
    t35 = multiply(t32, radial_variance, w6)
    t36 = multiply(t33, cross_variance, w7)
    t38 = subtract(radial_variance, cross_variance, w8)
    t40 = multiply(t33, radial_variance, w4)
    t41 = multiply(t32, cross_variance, w2)
    multiply(t14, cos_azimuth, x)
    multiply(t14, sin_azimuth, y)
    add(t35, t36, covariance_xx)
    multiply(t34, t38, covariance_xy)
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
    t6 = form.cos(elevation)
    t7 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = slant_range * t6
    t12 = range_deviation * range_deviation
    t13 = slant_range * elevation_deviation
    t14 = t13 * t13
    t15 = t6 * t6
    t16 = t7 * t7
    t19 = (t15 * t12) + (t16 * t14)
    t25 = (t6 * t7) * (t12 - t14)
    t26 = t10 * azimuth_deviation
    t27 = t26 * t26
    t30 = t8 * t8
    t31 = t9 * t9
    t11 = slant_range * t7
    t22 = (t16 * t12) + (t15 * t14)
    t28 = t10 * t8
    t29 = t10 * t9
    t35 = (t30 * t19) + (t31 * t27)
    t37 = (t9 * t8) * (t19 - t27)
    t38 = t8 * t25
    t41 = (t31 * t19) + (t30 * t27)
    t42 = t9 * t25
    return (t28, t29, t11, t35, t37, t38, t41, t42, t22)


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
    t10 = multiply(slant_range, cos_elevation, w4)
    t12 = square(range_deviation, w5)
    t13 = multiply(slant_range, elevation_deviation, w6)
    t14 = square(t13, w6)
    t15 = square(cos_elevation, w7)
    t16 = square(sin_elevation, w8)
    t17 = multiply(t15, t12, w9)
    t18 = multiply(t16, t14, w10)
    t19 = add(t17, t18, w9)
    t20 = multiply(t16, t12, w8)
    t21 = multiply(t15, t14, w7)
    t23 = multiply(cos_elevation, sin_elevation, w0)
    t24 = subtract(t12, t14, w5)
    t25 = multiply(t23, t24, w0)
    t26 = multiply(t10, azimuth_deviation, w5)
    t27 = square(t26, w5)
    t30 = square(cos_azimuth, w6)
    t31 = square(sin_azimuth, w10)
    t32 = multiply(sin_azimuth, cos_azimuth, w11)
    t33 = multiply(t30, t19, w12)
    t34 = multiply(t31, t27, w13)
    t36 = subtract(t19, t27, w14)
    t39 = multiply(t31, t19, w10)
    t40 = multiply(t30, t27, w6)
    multiply(slant_range, sin_elevation, z)
    add(t20, t21, covariance_zz)
    multiply(t10, cos_azimuth, x)
    multiply(t10, sin_azimuth, y)
    add(t33, t34, covariance_xx)
    multiply(t32, t36, covariance_xy)
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
    t6 = form.cos(elevation)
    t7 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = elevation_deviation * elevation_deviation
    t11 = -t10
    t14 = form.exp(t11 * 0.5)
    t15 = form.expm1(t11)
    t16 = azimuth_deviation * azimuth_deviation
    t17 = -t16
    t19 = form.exp(t17 * 0.5)
    t20 = form.expm1(t17)
    t21 = t14 * t14
    t22 = -t15
    t23 = t19 * t19
    t24 = -t20
    t25 = t19 * t14
    t32 = (t25 * ((t23 * t22) - t20)) / (1.0 + t25)
    t34 = (slant_range * t6) * (1.0 + t32)
    t41 = t21 * t21
    t42 = range_deviation * range_deviation
    t43 = slant_range * slant_range
    t44 = t43 + t42
    t46 = 1.0 + t21
    t51 = 1.0 + (t41 * t41)
    t53 = (t44 * ((t22 * t22) * (t46 + t41))) + (t42 * t51)
    t54 = t53 * 0.5
    t62 = t42 * (t46 * ((1.0 - t15) + (t41 * 2.0)))
    t64 = t22 * ((t43 * (1.0 + (t41 * t21))) + t62)
    t65 = t64 * 0.5
    t66 = t6 * t6
    t67 = t7 * t7
    t83 = (t66 * t51) + (t67 * ((t22 * t46) * (1.0 + t41)))
    t85 = (t44 + t42) * (t83 * 0.5)
    t90 = (t23 * ((t66 * t54) + (t67 * t65))) + (((t24 * t24) * t85) * 0.5)
    t92 = t24 * (1.0 + t23)
    t94 = (t85 * t92) * 0.5
    t96 = 1.0 + (t23 * t23)
    t100 = ((t90 * t96) + (t94 * t92)) * 0.5
    t104 = ((t90 * t92) + (t94 * t96)) * 0.5
    t106 = t19 * (t19 * ((t6 * t7) * (t54 - t65)))
    t109 = t8 * t8
    t110 = t9 * t9
    t40 = (slant_range * t7) * (1.0 + ((t14 * t22) / (1.0 + t14)))
    t73 = (t67 * t54) + (t66 * t65)
    t107 = t34 * t8
    t108 = t34 * t9
    t114 = (t109 * t100) + (t110 * t104)
    t116 = (t9 * t8) * (t100 - t104)
    t117 = t8 * t106
    t120 = (t110 * t100) + (t109 * t104)
    t121 = t9 * t106
    return (t107, t108, t40, t114, t116, t117, t120, t121, t73)


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
    t16 = square(azimuth_deviation, w6)
    t17 = negative(t16, w6)
    t18 = multiply(t17, n0, w7)
    kept_azimuth = exp(t18, w7)
    change_azimuth = expm1(t17, w6)
    t21 = square(kept_elevation, w8)
    t22 = negative(change_elevation, w9)
    t23 = square(kept_azimuth, w10)
    t24 = negative(change_azimuth, w11)
    t25 = multiply(kept_azimuth, kept_elevation, w12)
    t26 = multiply(t23, t22, w13)
    t27 = subtract(t26, change_azimuth, w13)
    t28 = multiply(slant_range, cos_elevation, w6)
    t29 = multiply(t25, t27, w13)
    t31 = add(n1, t25, w12)
    t32 = divide(t29, t31, z)
    t33 = add(n1, t32, z)
    t34 = multiply(t28, t33, w6)
    t35 = multiply(slant_range, sin_elevation, w12)
    t36 = multiply(kept_elevation, t22, w13)
    t37 = add(n1, kept_elevation, w5)
    t38 = divide(t36, t37, covariance_zz)
    t39 = add(n1, t38, covariance_zz)
    t41 = square(t21, w5)
    t42 = square(range_deviation, w13)
    t43 = square(slant_range, z)
    t44 = add(t43, t42, w14)
    t45 = square(t22, w15)
    t46 = add(n1, t21, w16)
    t47 = add(t46, t41, w17)
    t48 = multiply(t45, t47, w15)
    t49 = multiply(t44, t48, w15)
    t50 = square(t41, w17)
    t51 = add(n1, t50, w17)
    t52 = multiply(t42, t51, w18)
    t53 = add(t49, t52, w15)
    t54 = multiply(t53, n0, w15)
    t55 = multiply(t41, t21, w8)
    t56 = add(n1, t55, w8)
    t57 = multiply(t43, t56, z)
    t58 = subtract(n1, change_elevation, w4)
    t59 = multiply(t41, n2, w8)
    t60 = add(t58, t59, w4)
    t61 = multiply(t46, t60, w4)
    t62 = multiply(t42, t61, w4)
    t63 = add(t57, t62, z)
    t64 = multiply(t22, t63, z)
    t65 = multiply(t64, n0, z)
    t66 = square(cos_elevation, w4)
    t67 = square(sin_elevation, w8)
    t68 = multiply(t66, t54, w18)
    t69 = multiply(t67, t65, w19)
    t70 = add(t68, t69, w18)
    t71 = multiply(t67, t54, w19)
    t72 = multiply(t66, t65, w20)
    t74 = multiply(cos_elevation, sin_elevation, w0)
    t75 = subtract(t54, t65, w15)
    t76 = multiply(t74, t75, w0)
    t77 = add(t44, t42, w14)
    t78 = multiply(t66, t51, w4)
    t79 = multiply(t22, t46, w9)
    t80 = add(n1, t41, w5)
    t81 = multiply(t79, t80, w9)
    t82 = multiply(t67, t81, w8)
    t83 = add(t78, t82, w4)
    t84 = multiply(t83, n0, w4)
    t85 = multiply(t77, t84, w14)
    t86 = multiply(t23, t70, w18)
    t87 = square(t24, w1)
    t88 = multiply(t87, t85, w1)
    t89 = multiply(t88, n0, w1)
    t90 = add(t86, t89, w18)
    t91 = add(n1, t23, w1)
    t92 = multiply(t24, t91, w11)
    t93 = multiply(t85, t92, w14)
    t94 = multiply(t93, n0, w14)
    t95 = square(t23, w10)
    t96 = add(n1, t95, w10)
    t97 = multiply(t90, t96, w1)
    t98 = multiply(t94, t92, w4)
    t99 = add(t97, t98, w1)
    t100 = multiply(t99, n0, w1)
    t101 = multiply(t90, t92, w18)
    t102 = multiply(t94, t96, w14)
    t103 = add(t101, t102, w18)
    t104 = multiply(t103, n0, w18)
    t105 = multiply(kept_azimuth, t76, w0)
    t106 = multiply(kept_azimuth, t105, w7)
    t109 = square(cos_azimuth, w0)
    t110 = square(sin_azimuth, w4)
    t111 = multiply(sin_azimuth, cos_azimuth, w5)
    t112 = multiply(t109, t100, w8)
    t113 = multiply(t110, t104, w9)
    t115 = subtract(t100, t104, w10)
    t118 = multiply(t110, t100, w4)
    t119 = multiply(t109, t104, w0)
    multiply(t35, t39, z)
    add(t71, t72, covariance_zz)
    multiply(t34, cos_azimuth, x)
    multiply(t34, sin_azimuth, y)
    add(t112, t113, covariance_xx)
    multiply(t111, t115, covariance_xy)
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
    21,
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
    t6 = form.cos(elevation)
    t7 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = elevation_deviation * elevation_deviation
    t11 = -t10
    t14 = form.exp(t11 * 0.5)
    t16 = azimuth_deviation * azimuth_deviation
    t17 = -t16
    t19 = form.exp(t17 * 0.5)
    t20 = form.expm1(t17)
    t21 = t14 * t14
    t22 = -form.expm1(t11)
    t23 = t19 * t19
    t24 = -t20
    t25 = t19 * t14
    t28 = slant_range * t6
    t29 = t28 / t25
    t30 = slant_range * t7
    t33 = range_deviation * range_deviation
    t35 = (slant_range * slant_range) + t33
    t36 = slant_range * t22
    t39 = 1.0 + (t21 * t21)
    t42 = ((t36 * t36) + (t33 * t39)) * 0.5
    t44 = t22 * (1.0 + t21)
    t46 = (t35 * t44) * 0.5
    t47 = t6 * t6
    t48 = t7 * t7
    t56 = (t30 * t22) / t14
    t66 = t35 * (((t47 * t39) + (t48 * t44)) * 0.5)
    t71 = (t23 * ((t47 * t42) + (t48 * t46))) + (((t24 * t24) * t66) * 0.5)
    t75 = (t66 * (t24 * (1.0 + t23))) * 0.5
    t77 = (t28 * ((t23 * t22) - t20)) / t25
    t79 = t71 + (t77 * t77)
    t82 = (t19 * ((t6 * t7) * (t42 - t46))) + (t77 * t56)
    t85 = t8 * t8
    t86 = t9 * t9
    t31 = t30 / t14
    t58 = ((t48 * t42) + (t47 * t46)) + (t56 * t56)
    t83 = t29 * t8
    t84 = t29 * t9
    t90 = (t85 * t79) + (t86 * t75)
    t92 = (t9 * t8) * (t79 - t75)
    t93 = t8 * t82
    t96 = (t86 * t79) + (t85 * t75)
    t97 = t9 * t82
    return (t83, t84, t31, t90, t92, t93, t96, t97, t58)


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
        w21,
        w22,
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
    t16 = square(azimuth_deviation, w6)
    t17 = negative(t16, w6)
    t18 = multiply(t17, n0, w7)
    kept_azimuth = exp(t18, w7)
    change_azimuth = expm1(t17, w6)
    t21 = square(kept_elevation, w8)
    t22 = negative(change_elevation, w4)
    t23 = square(kept_azimuth, w9)
    t24 = negative(change_azimuth, w10)
    t25 = multiply(kept_azimuth, kept_elevation, w11)
    t26 = multiply(t23, t22, w12)
    t27 = subtract(t26, change_azimuth, w12)
    t28 = multiply(slant_range, cos_elevation, w6)
    t29 = divide(t28, t25, y)
    t30 = multiply(slant_range, sin_elevation, w13)
    t32 = square(t21, w14)
    t33 = square(range_deviation, w15)
    t34 = square(slant_range, w16)
    t35 = add(t34, t33, w16)
    t36 = multiply(slant_range, t22, w17)
    t37 = square(t36, w17)
    t39 = add(n1, t32, w14)
    t40 = multiply(t33, t39, w15)
    t41 = add(t37, t40, w17)
    t42 = multiply(t41, n0, w17)
    t43 = add(n1, t21, w8)
    t44 = multiply(t22, t43, w8)
    t45 = multiply(t35, t44, w15)
    t46 = multiply(t45, n0, w15)
    t47 = square(cos_elevation, w18)
    t48 = square(sin_elevation, w19)
    t49 = multiply(t47, t42, w20)
    t50 = multiply(t48, t46, w21)
    t51 = add(t49, t50, w20)
    t52 = multiply(t48, t42, w21)
    t53 = multiply(t47, t46, w22)
    t54 = add(t52, t53, w21)
    t55 = multiply(t30, t22, w4)
    t56 = divide(t55, kept_elevation, z)
    t57 = square(t56, w4)
    t59 = multiply(cos_elevation, sin_elevation, w0)
    t60 = subtract(t42, t46, w17)
    t61 = multiply(t59, t60, w0)
    t62 = multiply(t47, t39, w18)
    t63 = multiply(t48, t44, w19)
    t64 = add(t62, t63, w18)
    t65 = multiply(t64, n0, w18)
    t66 = multiply(t35, t65, w16)
    t67 = multiply(t23, t51, w20)
    t68 = square(t24, w1)
    t69 = multiply(t68, t66, w1)
    t70 = multiply(t69, n0, w1)
    t71 = add(t67, t70, w20)
    t72 = add(n1, t23, w9)
    t73 = multiply(t24, t72, w10)
    t74 = multiply(t66, t73, w16)
    t75 = multiply(t74, n0, w16)
    t76 = multiply(t28, t27, w6)
    t77 = divide(t76, t25, covariance_zz)
    t78 = square(t77, w1)
    t79 = add(t71, t78, w20)
    t80 = multiply(kept_azimuth, t61, w7)
    t81 = multiply(t77, t56, covariance_zz)
    t82 = add(t80, t81, w7)
    t85 = square(cos_azimuth, w0)
    t86 = square(sin_azimuth, w1)
    t87 = multiply(sin_azimuth, cos_azimuth, w6)
    t88 = multiply(t85, t79, w8)
    t89 = multiply(t86, t75, w9)
    t91 = subtract(t79, t75, w10)
    t94 = multiply(t86, t79, w1)
    t95 = multiply(t85, t75, w0)
    divide(t30, kept_elevation, z)
    add(t54, t57, covariance_zz)
    multiply(t29, cos_azimuth, x)
    multiply(t29, sin_azimuth, y)
    add(t88, t89, covariance_xx)
    multiply(t87, t91, covariance_xy)
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
    23,
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
    t6 = form.cos(elevation)
    t7 = form.sin(elevation)
    t8 = form.cos(azimuth)
    t9 = form.sin(azimuth)
    t10 = elevation_deviation * elevation_deviation
    t11 = -t10
    t14 = form.exp(t11 * 0.5)
    t16 = azimuth_deviation * azimuth_deviation
    t17 = -t16
    t19 = form.exp(t17 * 0.5)
    t21 = t14 * t14
    t22 = -form.expm1(t11)
    t23 = t19 * t19
    t24 = -form.expm1(t17)
    t27 = (slant_range * t6) * (t19 * t14)
    t31 = range_deviation * range_deviation
    t33 = (slant_range * slant_range) + t31
    t34 = slant_range * t22
    t37 = 1.0 + (t21 * t21)
    t40 = ((t34 * t34) + (t31 * t37)) * 0.5
    t42 = t22 * (1.0 + t21)
    t44 = (t33 * t42) * 0.5
    t45 = t6 * t6
    t46 = t7 * t7
    t60 = t33 * (((t45 * t37) + (t46 * t42)) * 0.5)
    t65 = (t23 * ((t45 * t40) + (t46 * t44))) + (((t24 * t24) * t60) * 0.5)
    t69 = (t60 * (t24 * (1.0 + t23))) * 0.5
    t70 = t19 * ((t6 * t7) * (t40 - t44))
    t73 = t8 * t8
    t74 = t9 * t9
    t29 = (slant_range * t7) * t14
    t52 = (t46 * t40) + (t45 * t44)
    t71 = t27 * t8
    t72 = t27 * t9
    t78 = (t73 * t65) + (t74 * t69)
    t80 = (t9 * t8) * (t65 - t69)
    t81 = t8 * t70
    t84 = (t74 * t65) + (t73 * t69)
    t85 = t9 * t70
    return (t71, t72, t29, t78, t80, t81, t84, t85, t52)


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
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16, w17, w18, w19 = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_azimuth = cos(azimuth, w2)
    sin_azimuth = sin(azimuth, w3)
    t10 = square(elevation_deviation, w4)
    t11 = negative(t10, w4)
    t13 = multiply(t11, n0, w5)
    kept_elevation = exp(t13, w5)
    change_elevation = expm1(t11, w4)
    t16 = square(azimuth_deviation, w6)
    t17 = negative(t16, w6)
    t18 = multiply(t17, n0, w7)
    kept_azimuth = exp(t18, w7)
    change_azimuth = expm1(t17, w6)
    t21 = square(kept_elevation, w8)
    t22 = negative(change_elevation, w4)
    t23 = square(kept_azimuth, w9)
    t24 = negative(change_azimuth, w6)
    t25 = multiply(kept_azimuth, kept_elevation, w10)
    t26 = multiply(slant_range, cos_elevation, w11)
    t27 = multiply(t26, t25, w11)
    t28 = multiply(slant_range, sin_elevation, w10)
    t30 = square(t21, w12)
    t31 = square(range_deviation, w13)
    t32 = square(slant_range, w14)
    t33 = add(t32, t31, w14)
    t34 = multiply(slant_range, t22, w15)
    t35 = square(t34, w15)
    t37 = add(n1, t30, w12)
    t38 = multiply(t31, t37, w13)
    t39 = add(t35, t38, w15)
    t40 = multiply(t39, n0, w15)
    t41 = add(n1, t21, w8)
    t42 = multiply(t22, t41, w4)
    t43 = multiply(t33, t42, w8)
    t44 = multiply(t43, n0, w8)
    t45 = square(cos_elevation, w13)
    t46 = square(sin_elevation, w16)
    t47 = multiply(t45, t40, w17)
    t48 = multiply(t46, t44, w18)
    t49 = add(t47, t48, w17)
    t50 = multiply(t46, t40, w18)
    t51 = multiply(t45, t44, w19)
    t53 = multiply(cos_elevation, sin_elevation, w0)
    t54 = subtract(t40, t44, w15)
    t55 = multiply(t53, t54, w0)
    t56 = multiply(t45, t37, w13)
    t57 = multiply(t46, t42, w16)
    t58 = add(t56, t57, w13)
    t59 = multiply(t58, n0, w13)
    t60 = multiply(t33, t59, w14)
    t61 = multiply(t23, t49, w17)
    t62 = square(t24, w1)
    t63 = multiply(t62, t60, w1)
    t64 = multiply(t63, n0, w1)
    t65 = add(t61, t64, w17)
    t66 = add(n1, t23, w9)
    t67 = multiply(t24, t66, w6)
    t68 = multiply(t60, t67, w14)
    t69 = multiply(t68, n0, w14)
    t70 = multiply(kept_azimuth, t55, w7)
    t73 = square(cos_azimuth, w0)
    t74 = square(sin_azimuth, w1)
    t75 = multiply(sin_azimuth, cos_azimuth, w4)
    t76 = multiply(t73, t65, w6)
    t77 = multiply(t74, t69, w8)
    t79 = subtract(t65, t69, w9)
    t82 = multiply(t74, t65, w1)
    t83 = multiply(t73, t69, w0)
    multiply(t28, kept_elevation, z)
    add(t50, t51, covariance_zz)
    multiply(t27, cos_azimuth, x)
    multiply(t27, sin_azimuth, y)
    add(t76, t77, covariance_xx)
    multiply(t75, t79, covariance_xy)
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
    20,
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
    t5 = form.cos(azimuth)
    t6 = form.sin(azimuth)
    t7 = azimuth_deviation * azimuth_deviation
    t8 = -t7
    t11 = form.exp(t8 * 0.5)
    t13 = t11 * t11
    t14 = -form.expm1(t8)
    t15 = slant_range / t11
    t16 = t13 * t13
    t17 = range_deviation * range_deviation
    t20 = slant_range * t14
    t26 = ((t20 * t20) + (t17 * (1.0 + t16))) * 0.5
    t28 = (range_deviation * azimuth_deviation) * correlation
    t29 = t28 * t28
    t33 = t20 / t11
    t35 = (t26 - ((t16 * t29) * 2.0)) + (t33 * t33)
    t36 = 1.0 + t13
    t38 = ((slant_range * slant_range) + t17) * (t14 * t36)
    t42 = 1.0 - (t13 * 2.0)
    t47 = -((t28 * t36) / t11)
    t49 = ((t38 * 0.5) - ((t13 * t29) * t42)) + (t47 * t47)
    t52 = -(t28 / t11)
    t58 = t5 * t5
    t59 = t6 * t6
    t60 = t6 * t5
    t68 = (t33 * t47) - ((t13 * (slant_range * t28)) * t42)
    t70 = (t60 * t68) * 2.0
    t54 = (t15 * t5) - (t52 * t6)
    t57 = (t15 * t6) + (t52 * t5)
    t71 = ((t58 * t35) + (t59 * t49)) - t70
    t76 = (t60 * (t35 - t49)) + ((t58 - t59) * t68)
    t80 = ((t59 * t35) + (t58 * t49)) + t70
    return (t54, t57, t71, t76, t80)


def _correlated_unbiased_conversion_in_plane_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 1.0,
    n2: float = 2.0,
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
    t13 = square(kept_azimuth, w4)
    t14 = negative(change_azimuth, w2)
    t15 = divide(slant_range, kept_azimuth, x)
    t16 = square(t13, w5)
    t17 = square(range_deviation, w6)
    t18 = square(slant_range, w7)
    t19 = add(t18, t17, w7)
    t20 = multiply(slant_range, t14, w8)
    t21 = square(t20, w9)
    t23 = add(n1, t16, w10)
    t24 = multiply(t17, t23, w6)
    t25 = add(t21, t24, w9)
    t26 = multiply(t25, n0, w9)
    t27 = multiply(range_deviation, azimuth_deviation, w6)
    t28 = multiply(t27, correlation, w6)
    t29 = square(t28, w10)
    t30 = multiply(t16, t29, w5)
    t31 = multiply(t30, n2, w5)
    t32 = subtract(t26, t31, w9)
    t33 = divide(t20, kept_azimuth, y)
    t34 = square(t33, w5)
    t35 = add(t32, t34, w9)
    t36 = add(n1, t13, w5)
    t37 = multiply(t14, t36, w2)
    t38 = multiply(t19, t37, w7)
    t39 = multiply(t38, n0, w7)
    t40 = multiply(t13, t29, w10)
    t41 = multiply(t13, n2, w2)
    t42 = subtract(n1, t41, w2)
    t43 = multiply(t40, t42, w10)
    t44 = subtract(t39, t43, w7)
    t45 = multiply(t28, t36, w5)
    t46 = divide(t45, kept_azimuth, covariance_xx)
    t47 = negative(t46, covariance_xx)
    t48 = square(t47, w5)
    t49 = add(t44, t48, w7)
    t50 = multiply(t15, cos_azimuth, w5)
    t51 = divide(t28, kept_azimuth, covariance_xy)
    t52 = negative(t51, covariance_xy)
    t53 = multiply(t52, sin_azimuth, w3)
    t55 = multiply(t15, sin_azimuth, w8)
    t56 = multiply(t52, cos_azimuth, covariance_xy)
    t58 = square(cos_azimuth, w10)
    t59 = square(sin_azimuth, x)
    t60 = multiply(sin_azimuth, cos_azimuth, w1)
    t61 = multiply(t58, t35, w0)
    t62 = multiply(t59, t49, w11)
    t63 = add(t61, t62, w0)
    t64 = multiply(slant_range, t28, w6)
    t65 = multiply(t13, t64, w4)
    t66 = multiply(t65, t42, w4)
    t67 = multiply(t33, t47, y)
    t68 = subtract(t67, t66, y)
    t69 = multiply(t60, t68, w2)
    t70 = multiply(t69, n2, w2)
    t72 = subtract(t35, t49, w4)
    t73 = multiply(t60, t72, w1)
    t74 = subtract(t58, t59, w4)
    t75 = multiply(t74, t68, w4)
    t77 = multiply(t59, t35, x)
    t78 = multiply(t58, t49, w10)
    t79 = add(t77, t78, w10)
    subtract(t50, t53, x)
    add(t55, t56, y)
    subtract(t63, t70, covariance_xx)
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
    t5 = form.cos(azimuth)
    t6 = form.sin(azimuth)
    t7 = azimuth_deviation * azimuth_deviation
    t8 = -t7
    t11 = form.exp(t8 * 0.5)
    t13 = t11 * t11
    t14 = -form.expm1(t8)
    t15 = slant_range * t11
    t16 = t13 * t13
    t17 = range_deviation * range_deviation
    t20 = slant_range * t14
    t26 = ((t20 * t20) + (t17 * (1.0 + t16))) * 0.5
    t28 = (range_deviation * azimuth_deviation) * correlation
    t29 = t28 * t28
    t32 = t26 - ((t16 * t29) * 2.0)
    t35 = ((slant_range * slant_range) + t17) * (t14 * (1.0 + t13))
    t39 = 1.0 - (t13 * 2.0)
    t41 = (t35 * 0.5) - ((t13 * t29) * t39)
    t43 = t28 * t11
    t49 = t5 * t5
    t50 = t6 * t6
    t51 = t6 * t5
    t58 = -((t13 * (slant_range * t28)) * t39)
    t60 = (t51 * t58) * 2.0
    t45 = (t15 * t5) - (t43 * t6)
    t48 = (t15 * t6) + (t43 * t5)
    t61 = ((t49 * t32) + (t50 * t41)) - t60
    t66 = (t51 * (t32 - t41)) + ((t49 - t50) * t58)
    t70 = ((t50 * t32) + (t49 * t41)) + t60
    return (t45, t48, t61, t66, t70)


def _correlated_modified_unbiased_conversion_in_plane_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 1.0,
    n2: float = 2.0,
) -> None:
    slant_range, azimuth, range_deviation, azimuth_deviation, correlation = given
    x, y, covariance_xx, covariance_xy, covariance_yy = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13 = work
    cos_azimuth = cos(azimuth, w0)
    sin_azimuth = sin(azimuth, w1)
    t7 = square(azimuth_deviation, w2)
    t8 = negative(t7, w2)
    t10 = multiply(t8, n0, w3)
    kept_azimuth = exp(t10, w3)
    change_azimuth = expm1(t8, w2)
    t13 = square(kept_azimuth, w4)
    t14 = negative(change_azimuth, w2)
    t15 = multiply(slant_range, kept_azimuth, w5)
    t16 = square(t13, w6)
    t17 = square(range_deviation, w7)
    t18 = square(slant_range, w8)
    t19 = add(t18, t17, w8)
    t20 = multiply(slant_range, t14, w9)
    t21 = square(t20, w9)
    t23 = add(n1, t16, w10)
    t24 = multiply(t17, t23, w7)
    t25 = add(t21, t24, w9)
    t26 = multiply(t25, n0, w9)
    t27 = multiply(range_deviation, azimuth_deviation, w7)
    t28 = multiply(t27, correlation, w7)
    t29 = square(t28, w10)
    t30 = multiply(t16, t29, w6)
    t31 = multiply(t30, n2, w6)
    t32 = subtract(t26, t31, w9)
    t33 = add(n1, t13, w6)
    t34 = multiply(t14, t33, w2)
    t35 = multiply(t19, t34, w8)
    t36 = multiply(t35, n0, w8)
    t37 = multiply(t13, t29, w10)
    t38 = multiply(t13, n2, w2)
    t39 = subtract(n1, t38, w2)
    t40 = multiply(t37, t39, w10)
    t41 = subtract(t36, t40, w8)
    t42 = multiply(t15, cos_azimuth, w6)
    t43 = multiply(t28, kept_azimuth, w3)
    t44 = multiply(t43, sin_azimuth, w10)
    t46 = multiply(t15, sin_azimuth, w5)
    t47 = multiply(t43, cos_azimuth, w3)
    t49 = square(cos_azimuth, w11)
    t50 = square(sin_azimuth, w12)
    t51 = multiply(sin_azimuth, cos_azimuth, w1)
    t52 = multiply(t49, t32, w0)
    t53 = multiply(t50, t41, w13)
    t54 = add(t52, t53, w0)
    t55 = multiply(slant_range, t28, w7)
    t56 = multiply(t13, t55, w4)
    t57 = multiply(t56, t39, w4)
    t58 = negative(t57, w4)
    t59 = multiply(t51, t58, w2)
    t60 = multiply(t59, n2, w2)
    t62 = subtract(t32, t41, w7)
    t63 = multiply(t51, t62, w1)
    t64 = subtract(t49, t50, w7)
    t65 = multiply(t64, t58, w7)
    t67 = multiply(t50, t32, w12)
    t68 = multiply(t49, t41, w11)
    t69 = add(t67, t68, w12)
    subtract(t42, t44, x)
    add(t46, t47, y)
    subtract(t54, t60, covariance_xx)
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
    14,
    _correlated_modified_unbiased_conversion_in_plane_block,
    numbers=_correlated_modified_unbiased_conversion_in_plane_of_numbers,
)
