# Made by: gainproof generate polar-coordinates
# From: gainproof derive polar-coordinates, SymPy 1.14.0
"""Polar coordinates: range, elevation and bearing from north."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import (
    add,
    arctan2,
    cos,
    divide,
    errstate,
    exp,
    expm1,
    multiply,
    negative,
    sin,
    sqrt,
    square,
    subtract,
)

from gainproof.generated._numbers import ONE, Double, named
from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Required, Signature

if TYPE_CHECKING:
    from typing import NamedTuple

    from gainproof.generated._numbers import Form
    from gainproof.generated._signature import ArrayLike, Arrays, Real
else:
    from gainproof.generated._result import NamedTuple

__all__ = [
    "CartesianDerivatives",
    "CartesianDerivativesInPlane",
    "MeanOfConverted",
    "MeanOfConvertedInPlane",
    "NoiseCovariance",
    "NoiseCovarianceInPlane",
    "PolarDerivatives",
    "PolarDerivativesInPlane",
    "StraightCourseRates",
    "StraightCourseRatesInPlane",
    "ToCartesian",
    "ToCartesianInPlane",
    "ToPolar",
    "ToPolarInPlane",
    "cartesian_derivatives",
    "cartesian_derivatives_in_plane",
    "mean_of_converted",
    "mean_of_converted_in_plane",
    "noise_covariance",
    "noise_covariance_in_plane",
    "polar_derivatives",
    "polar_derivatives_in_plane",
    "straight_course_rates",
    "straight_course_rates_in_plane",
    "to_cartesian",
    "to_cartesian_in_plane",
    "to_polar",
    "to_polar_in_plane",
]

_SLANT_RANGE_DOMAIN = Domain(
    "slant_range",
    "a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at most 1e12",
    (1e-20, 1e60),
    (9.999999974752427e-07, 999999995904.0),
)
_ELEVATION_DOMAIN = Domain(
    "elevation",
    "0 or of magnitude 1e-20 to 1.5707963267948966, in float32 1e-12 to 1.5707962",
    (1e-20, 1.5707963267948966),
    (9.999999960041972e-13, 1.570796251296997),
    zero=True,
    signed=True,
)
_BEARING_DOMAIN = Domain(
    "bearing",
    "0 or of magnitude 1e-20 to 6.2832, in float32 1e-12 to 6.2832",
    (1e-20, 6.2832),
    (9.999999960041972e-13, 6.283199787139893),
    zero=True,
    signed=True,
)
_X_DOMAIN = Domain(
    "x",
    "0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18",
    (1e-150, 1e150),
    (1.000000045813705e-18, 9.999999843067494e17),
    zero=True,
    signed=True,
)
_Y_DOMAIN = Domain(
    "y",
    "0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18",
    (1e-150, 1e150),
    (1.000000045813705e-18, 9.999999843067494e17),
    zero=True,
    signed=True,
)
_Z_DOMAIN = Domain(
    "z",
    "0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18",
    (1e-150, 1e150),
    (1.000000045813705e-18, 9.999999843067494e17),
    zero=True,
    signed=True,
)
_X_DOMAIN_2 = Domain(
    "x",
    "0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12",
    (1e-20, 1e30),
    (9.999999974752427e-07, 999999995904.0),
    zero=True,
    signed=True,
)
_Y_DOMAIN_2 = Domain(
    "y",
    "0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12",
    (1e-20, 1e30),
    (9.999999974752427e-07, 999999995904.0),
    zero=True,
    signed=True,
)
_Z_DOMAIN_2 = Domain(
    "z",
    "0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12",
    (1e-20, 1e30),
    (9.999999974752427e-07, 999999995904.0),
    zero=True,
    signed=True,
)
_RANGE_DEVIATION_DOMAIN = Domain(
    "range_deviation",
    "0 or a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at most 1e12",
    (1e-20, 1e60),
    (9.999999974752427e-07, 999999995904.0),
    zero=True,
)
_ELEVATION_DEVIATION_DOMAIN = Domain(
    "elevation_deviation",
    "0 or a number at least 1e-20 and at most 2, in float32 at least 1e-9 and at most 2",
    (1e-20, 2.0),
    (9.999999717180685e-10, 2.0),
    zero=True,
)
_BEARING_DEVIATION_DOMAIN = Domain(
    "bearing_deviation",
    "0 or a number at least 1e-20 and at most 2, in float32 at least 1e-9 and at most 2",
    (1e-20, 2.0),
    (9.999999717180685e-10, 2.0),
    zero=True,
)
_VELOCITY_X_DOMAIN = Domain(
    "velocity_x",
    "0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9",
    (1e-20, 1e30),
    (9.999999717180685e-10, 1000000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_Y_DOMAIN = Domain(
    "velocity_y",
    "0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9",
    (1e-20, 1e30),
    (9.999999717180685e-10, 1000000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_Z_DOMAIN = Domain(
    "velocity_z",
    "0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9",
    (1e-20, 1e30),
    (9.999999717180685e-10, 1000000000.0),
    zero=True,
    signed=True,
)


class ToCartesian(NamedTuple):
    """Result of `to_cartesian`."""

    x: Real
    """Distance east, m."""
    y: Real
    """Distance north, m."""
    z: Real
    """Height, m."""


def to_cartesian(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    bearing: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> ToCartesian:
    """East, north and up from range, elevation and bearing.

        x = R cos E sin B, y = R cos E cos B, z = R sin E

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    elevation: elevation above the horizontal, rad; 0 or of magnitude 1e-20 to 1.5707963267948966,
        in float32 1e-12 to 1.5707962.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.

    x: distance east, m. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32),
        proved for every input, provided np.sin and np.cos err by at most 4 units in the last place
        of the true value.
    y: distance north, m. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32),
        proved for every input, provided np.cos errs by at most 4 units in the last place of the
        true value.
    z: height, m. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for
        every input, provided np.sin errs by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(bearing) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(ToCartesian, _to_cartesian_of_numbers(slant_range, elevation, bearing))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ToCartesian(*evaluate(_TO_CARTESIAN, (slant_range, elevation, bearing), out, workers))


@errstate(all="ignore")
def _to_cartesian_of_numbers(
    slant_range: float,
    elevation: float,
    bearing: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t7 = slant_range * form.cos(elevation)
    t8 = t7 * form.sin(bearing)
    t9 = t7 * form.cos(bearing)
    t10 = slant_range * form.sin(elevation)
    return (t8, t9, t10)


def _to_cartesian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    slant_range, elevation, bearing = given
    x, y, z = out
    w0, w1, w2, w3 = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_bearing = cos(bearing, w2)
    sin_bearing = sin(bearing, w3)
    t7 = multiply(slant_range, cos_elevation, w0)
    multiply(t7, sin_bearing, x)
    multiply(t7, cos_bearing, y)
    multiply(slant_range, sin_elevation, z)


_TO_CARTESIAN = Signature(
    "to_cartesian",
    (_SLANT_RANGE_DOMAIN, _ELEVATION_DOMAIN, _BEARING_DOMAIN),
    ("x", "y", "z"),
    4,
    _to_cartesian_block,
    numbers=_to_cartesian_of_numbers,
)


class ToPolar(NamedTuple):
    """Result of `to_polar`."""

    slant_range: Real
    """Range, m."""
    elevation: Real
    """Elevation above the horizontal, between -pi/2 and pi/2, rad."""
    bearing: Real
    """Bearing from north, clockwise seen from above, between -pi and pi, rad."""


def to_polar(
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> ToPolar:
    """Range, elevation and bearing from east, north and up.

        R = sqrt(x^2 + y^2 + z^2), E = atan2(z, sqrt(x^2 + y^2)), B = atan2(x, y).
        In the south the sign of a zero x decides between B = pi and -pi; where x = y = 0 nothing
        determines the bearing, and signs of zeros make it 0 or +-pi

    x: distance east, m; 0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18.
    y: distance north, m; 0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18.
    z: height, m; 0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18.

    slant_range: range, m. Relative error at most 1.26 * 2^-52 (float64), 1.26 * 2^-23 (float32),
        proved for every input.
    elevation: elevation above the horizontal, between -pi/2 and pi/2, rad. Relative error at most
        5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32), proved for every input, provided np.arctan2
        errs by at most 4 units in the last place of the true value.
    bearing: bearing from north, clockwise seen from above, between -pi and pi, rad. Relative error
        at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, provided
        np.arctan2 errs by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(x) is float
        and type(y) is float
        and type(z) is float
        and -1e150 <= x <= 1e150
        and (abs(x) >= 1e-150 or x == 0)
        and -1e150 <= y <= 1e150
        and (abs(y) >= 1e-150 or y == 0)
        and -1e150 <= z <= 1e150
        and (abs(z) >= 1e-150 or z == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(ToPolar, _to_polar_of_numbers(x, y, z))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ToPolar(*evaluate(_TO_POLAR, (x, y, z), out, workers))


@errstate(all="ignore")
def _to_polar_of_numbers(x: float, y: float, z: float, form: Form = Double) -> tuple[float, ...]:
    t5 = (x * x) + (y * y)
    t9 = form.sqrt(t5 + (z * z))
    t10 = form.atan2(z, form.sqrt(t5))
    t11 = form.atan2(x, y)
    return (t9, t10, t11)


def _to_polar_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    x, y, z = given
    slant_range, elevation, bearing = out
    w0, w1 = work
    t3 = square(x, w0)
    t4 = square(y, w1)
    t5 = add(t3, t4, w0)
    horizontal_distance = sqrt(t5, elevation)
    t7 = square(z, w1)
    t8 = add(t5, t7, w0)
    sqrt(t8, slant_range)
    arctan2(z, horizontal_distance, elevation)
    arctan2(x, y, bearing)


_TO_POLAR = Signature(
    "to_polar",
    (_X_DOMAIN, _Y_DOMAIN, _Z_DOMAIN),
    ("slant_range", "elevation", "bearing"),
    2,
    _to_polar_block,
    numbers=_to_polar_of_numbers,
)


class CartesianDerivatives(NamedTuple):
    """Result of `cartesian_derivatives`."""

    x_D_slant_range: Real
    """Derivative of x by the range, dimensionless."""
    x_D_elevation: Real
    """Derivative of x by the elevation, m/rad."""
    x_D_bearing: Real
    """Derivative of x by the bearing, m/rad."""
    y_D_slant_range: Real
    """Derivative of y by the range, dimensionless."""
    y_D_elevation: Real
    """Derivative of y by the elevation, m/rad."""
    y_D_bearing: Real
    """Derivative of y by the bearing, m/rad."""
    z_D_slant_range: Real
    """Derivative of z by the range, dimensionless."""
    z_D_elevation: Real
    """Derivative of z by the elevation, m/rad."""


def cartesian_derivatives(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    bearing: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> CartesianDerivatives:
    """Derivatives of x, y, z by range, elevation and bearing.

        x_D_slant_range = cos E sin B, x_D_elevation = -R sin E sin B, x_D_bearing = y,
        y_D_slant_range = cos E cos B, y_D_elevation = -R sin E cos B, y_D_bearing = -x,
        z_D_slant_range = sin E, z_D_elevation = R cos E; z_D_bearing is 0

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    elevation: elevation above the horizontal, rad; 0 or of magnitude 1e-20 to 1.5707963267948966,
        in float32 1e-12 to 1.5707962.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.

    x_D_slant_range: derivative of x by the range, dimensionless. Relative error at most 8.51 *
        2^-52 (float64), 8.51 * 2^-23 (float32), proved for every input, provided np.sin and np.cos
        err by at most 4 units in the last place of the true value.
    x_D_elevation: derivative of x by the elevation, m/rad. Relative error at most 9.01 * 2^-52
        (float64), 9.01 * 2^-23 (float32), proved for every input, provided np.sin errs by at most 4
        units in the last place of the true value.
    x_D_bearing: derivative of x by the bearing, m/rad. Relative error at most 9.01 * 2^-52
        (float64), 9.01 * 2^-23 (float32), proved for every input, provided np.cos errs by at most 4
        units in the last place of the true value.
    y_D_slant_range: derivative of y by the range, dimensionless. Relative error at most 8.51 *
        2^-52 (float64), 8.51 * 2^-23 (float32), proved for every input, provided np.cos errs by at
        most 4 units in the last place of the true value.
    y_D_elevation: derivative of y by the elevation, m/rad. Relative error at most 9.01 * 2^-52
        (float64), 9.01 * 2^-23 (float32), proved for every input, provided np.sin and np.cos err by
        at most 4 units in the last place of the true value.
    y_D_bearing: derivative of y by the bearing, m/rad. Relative error at most 9.01 * 2^-52
        (float64), 9.01 * 2^-23 (float32), proved for every input, provided np.sin and np.cos err by
        at most 4 units in the last place of the true value.
    z_D_slant_range: derivative of z by the range, dimensionless. Relative error at most 4.01 *
        2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, provided np.sin errs by at
        most 4 units in the last place of the true value.
    z_D_elevation: derivative of z by the elevation, m/rad. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input, provided np.cos errs by at most 4
        units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(bearing) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                CartesianDerivatives,
                _cartesian_derivatives_of_numbers(slant_range, elevation, bearing),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return CartesianDerivatives(
        *evaluate(_CARTESIAN_DERIVATIVES, (slant_range, elevation, bearing), out, workers)
    )


@errstate(all="ignore")
def _cartesian_derivatives_of_numbers(
    slant_range: float,
    elevation: float,
    bearing: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = form.cos(elevation)
    t3 = form.sin(elevation)
    t5 = form.cos(bearing)
    t6 = form.sin(bearing)
    t7 = slant_range * t2
    t8 = slant_range * t3
    t9 = t2 * t6
    t10 = t2 * t5
    t12 = -(t8 * t6)
    t13 = t7 * t5
    t15 = -(t8 * t5)
    t17 = -(t7 * t6)
    return (t9, t12, t13, t10, t15, t17, t3, t7)


def _cartesian_derivatives_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    slant_range, elevation, bearing = given
    (
        x_D_slant_range,
        x_D_elevation,
        x_D_bearing,
        y_D_slant_range,
        y_D_elevation,
        y_D_bearing,
        z_D_slant_range,
        z_D_elevation,
    ) = out
    w0, w1, w2, w3, w4, w5 = work
    cos_elevation = cos(elevation, w0)
    sin(elevation, z_D_slant_range)
    cos_bearing = cos(bearing, w1)
    sin_bearing = sin(bearing, w2)
    multiply(slant_range, cos_elevation, z_D_elevation)
    t8 = multiply(slant_range, z_D_slant_range, w3)
    t11 = multiply(t8, sin_bearing, w4)
    t14 = multiply(t8, cos_bearing, w3)
    t16 = multiply(z_D_elevation, sin_bearing, w5)
    multiply(cos_elevation, sin_bearing, x_D_slant_range)
    multiply(cos_elevation, cos_bearing, y_D_slant_range)
    negative(t11, x_D_elevation)
    multiply(z_D_elevation, cos_bearing, x_D_bearing)
    negative(t14, y_D_elevation)
    negative(t16, y_D_bearing)


_CARTESIAN_DERIVATIVES = Signature(
    "cartesian_derivatives",
    (_SLANT_RANGE_DOMAIN, _ELEVATION_DOMAIN, _BEARING_DOMAIN),
    (
        "x_D_slant_range",
        "x_D_elevation",
        "x_D_bearing",
        "y_D_slant_range",
        "y_D_elevation",
        "y_D_bearing",
        "z_D_slant_range",
        "z_D_elevation",
    ),
    6,
    _cartesian_derivatives_block,
    numbers=_cartesian_derivatives_of_numbers,
)


class PolarDerivatives(NamedTuple):
    """Result of `polar_derivatives`."""

    slant_range_D_x: Real
    """Derivative of the range by x, dimensionless."""
    slant_range_D_y: Real
    """Derivative of the range by y, dimensionless."""
    slant_range_D_z: Real
    """Derivative of the range by z, dimensionless."""
    elevation_D_x: Real
    """Derivative of the elevation by x, rad/m."""
    elevation_D_y: Real
    """Derivative of the elevation by y, rad/m."""
    elevation_D_z: Real
    """Derivative of the elevation by z, rad/m."""
    bearing_D_x: Real
    """Derivative of the bearing by x, rad/m."""
    bearing_D_y: Real
    """Derivative of the bearing by y, rad/m."""


def polar_derivatives(
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> PolarDerivatives:
    """Derivatives of range, elevation and bearing by x, y, z.

        slant_range_D_x = x/R and so on, elevation_D_x = -x z/(h R^2),
        elevation_D_y = -y z/(h R^2), elevation_D_z = h/R^2, bearing_D_x = y/h^2,
        bearing_D_y = -x/h^2, h = sqrt(x^2 + y^2), R = sqrt(h^2 + z^2); bearing_D_z is 0

    x: distance east, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    y: distance north, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    z: height, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.

    The distance from the vertical axis, of the inputs together, must be at least 1e-20, in float32
        1e-3.

    slant_range_D_x: derivative of the range by x, dimensionless. Relative error at most 2.51 *
        2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.
    slant_range_D_y: derivative of the range by y, dimensionless. Relative error at most 2.51 *
        2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.
    slant_range_D_z: derivative of the range by z, dimensionless. Relative error at most 2.51 *
        2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input.
    elevation_D_x: derivative of the elevation by x, rad/m. Relative error at most 7.01 * 2^-52
        (float64), 7.01 * 2^-23 (float32), proved for every input, and 8e-45 (float32) beside it
        where a product underflows.
    elevation_D_y: derivative of the elevation by y, rad/m. Relative error at most 7.01 * 2^-52
        (float64), 7.01 * 2^-23 (float32), proved for every input, and 8e-45 (float32) beside it
        where a product underflows.
    elevation_D_z: derivative of the elevation by z, rad/m. Relative error at most 6.01 * 2^-52
        (float64), 6.01 * 2^-23 (float32), proved for every input.
    bearing_D_x: derivative of the bearing by x, rad/m. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.
    bearing_D_y: derivative of the bearing by y, rad/m. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(x) is float
        and type(y) is float
        and type(z) is float
        and -1e30 <= x <= 1e30
        and (abs(x) >= 1e-20 or x == 0)
        and -1e30 <= y <= 1e30
        and (abs(y) >= 1e-20 or y == 0)
        and -1e30 <= z <= 1e30
        and (abs(z) >= 1e-20 or z == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(PolarDerivatives, _polar_derivatives_of_numbers(x, y, z))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PolarDerivatives(*evaluate(_POLAR_DERIVATIVES, (x, y, z), out, workers))


def _polar_derivatives_of_numbers(
    x: float,
    y: float,
    z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = form.sqrt((x * x) + (y * y))
    t10 = form.sqrt((t6 * t6) + (z * z))
    t12 = z / t10
    t13 = y / t6
    t14 = x / t6
    t15 = t12 / t10
    t16 = x / t10
    t17 = y / t10
    t19 = -(t15 * t14)
    t21 = -(t15 * t13)
    t22 = (t6 / t10) / t10
    t23 = t13 / t6
    t25 = -(t14 / t6)
    if not t6 >= (0.0010000000474974513 if form.single else 1e-20):
        raise ValueError
    return (t16, t17, t12, t19, t21, t22, t23, t25)


def _polar_derivatives_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    x, y, z = given
    (
        slant_range_D_x,
        slant_range_D_y,
        slant_range_D_z,
        elevation_D_x,
        elevation_D_y,
        elevation_D_z,
        bearing_D_x,
        bearing_D_y,
    ) = out
    w0, w1, w2, w3 = work
    t3 = square(x, w0)
    t4 = square(y, w1)
    t5 = add(t3, t4, w0)
    horizontal_distance = sqrt(t5, bearing_D_y)
    t7 = square(horizontal_distance, w0)
    t8 = square(z, w1)
    t9 = add(t7, t8, w0)
    slant_range = sqrt(t9, elevation_D_z)
    t11 = divide(horizontal_distance, slant_range, w0)
    divide(z, slant_range, slant_range_D_z)
    t13 = divide(y, horizontal_distance, bearing_D_x)
    t14 = divide(x, horizontal_distance, w1)
    t15 = divide(slant_range_D_z, slant_range, slant_range_D_x)
    t18 = multiply(t15, t14, w2)
    t20 = multiply(t15, t13, w3)
    divide(x, slant_range, slant_range_D_x)
    divide(y, slant_range, slant_range_D_y)
    negative(t18, elevation_D_x)
    negative(t20, elevation_D_y)
    divide(t11, slant_range, elevation_D_z)
    divide(t13, horizontal_distance, bearing_D_x)
    t24 = divide(t14, horizontal_distance, bearing_D_y)
    negative(t24, bearing_D_y)


def _polar_derivatives_horizontal_distance_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    x, y, _z = given
    (horizontal_distance,) = out
    w0, w1 = work
    t3 = square(x, w0)
    t4 = square(y, w1)
    t5 = add(t3, t4, w0)
    sqrt(t5, horizontal_distance)


_POLAR_DERIVATIVES = Signature(
    "polar_derivatives",
    (_X_DOMAIN_2, _Y_DOMAIN_2, _Z_DOMAIN_2),
    (
        "slant_range_D_x",
        "slant_range_D_y",
        "slant_range_D_z",
        "elevation_D_x",
        "elevation_D_y",
        "elevation_D_z",
        "bearing_D_x",
        "bearing_D_y",
    ),
    4,
    _polar_derivatives_block,
    (
        Required(
            "distance from the vertical axis",
            "at least 1e-20, in float32 1e-3",
            1e-20,
            0.0010000000474974513,
            2,
            _polar_derivatives_horizontal_distance_block,
        ),
    ),
    numbers=_polar_derivatives_of_numbers,
)


class NoiseCovariance(NamedTuple):
    """Result of `noise_covariance`."""

    covariance_xx: Real
    """Variance of x, m^2."""
    covariance_xy: Real
    """Covariance of x and y, m^2."""
    covariance_xz: Real
    """Covariance of x and z, m^2."""
    covariance_yy: Real
    """Variance of y, m^2."""
    covariance_yz: Real
    """Covariance of y and z, m^2."""
    covariance_zz: Real
    """Variance of z, m^2."""


def noise_covariance(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    bearing: ArrayLike,
    range_deviation: ArrayLike,
    elevation_deviation: ArrayLike,
    bearing_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> NoiseCovariance:
    """Covariance of a converted measurement to first order in its noise.

        J diag(sR^2, sE^2, sB^2) J' with J of `cartesian_derivatives`: at the true place the
        covariance of the converted position to first order, at the measured one its estimate

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    elevation: elevation above the horizontal, rad; 0 or of magnitude 1e-20 to 1.5707963267948966,
        in float32 1e-12 to 1.5707962.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; 0 or a number at least 1e-20 and at most
        1e60, in float32 at least 1e-6 and at most 1e12.
    elevation_deviation: standard deviation of the elevation, rad; 0 or a number at least 1e-20 and
        at most 2, in float32 at least 1e-9 and at most 2.
    bearing_deviation: standard deviation of the bearing, rad; 0 or a number at least 1e-20 and at
        most 2, in float32 at least 1e-9 and at most 2.

    covariance_xx: variance of x, m^2. Relative error at most 20.51 * 2^-52 (float64), 20.51 * 2^-23
        (float32), proved for every input, and 3e-44 (float32) beside it where a product underflows,
        provided np.sin and np.cos err by at most 4 units in the last place of the true value.
    covariance_xy: covariance of x and y, m^2. Error over the sum of its terms taken positive at
        most 20.51 * 2^-52 (float64), 20.51 * 2^-23 (float32), proved for every input, and 3e-44
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.04 in float32 of what its error is relative to; what cancels:
        (cos(elevation)*range_deviation)**2 + (sin(elevation)*slant_range*elevation_deviation)**2 -
        (slant_range*cos(elevation)*bearing_deviation)**2.
    covariance_xz: covariance of x and z, m^2. Error over the sum of its terms taken positive at
        most 15.51 * 2^-52 (float64), 15.51 * 2^-23 (float32), proved for every input, and 2e-44
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 4e-7 in float64
        and 0.03 in float32 of what its error is relative to; what cancels: range_deviation**2 -
        (slant_range*elevation_deviation)**2.
    covariance_yy: variance of y, m^2. Relative error at most 20.51 * 2^-52 (float64), 20.51 * 2^-23
        (float32), proved for every input, and 3e-44 (float32) beside it where a product underflows,
        provided np.sin and np.cos err by at most 4 units in the last place of the true value.
    covariance_yz: covariance of y and z, m^2. Error over the sum of its terms taken positive at
        most 15.51 * 2^-52 (float64), 15.51 * 2^-23 (float32), proved for every input, and 2e-44
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 4e-7 in float64
        and 0.03 in float32 of what its error is relative to; what cancels: range_deviation**2 -
        (slant_range*elevation_deviation)**2.
    covariance_zz: variance of z, m^2. Relative error at most 11.01 * 2^-52 (float64), 11.01 * 2^-23
        (float32), proved for every input, and 8e-45 (float32) beside it where a product underflows,
        provided np.sin and np.cos err by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(bearing) is float
        and type(range_deviation) is float
        and type(elevation_deviation) is float
        and type(bearing_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and (1e-20 <= range_deviation <= 1e60 or range_deviation == 0)
        and (1e-20 <= elevation_deviation <= 2.0 or elevation_deviation == 0)
        and (1e-20 <= bearing_deviation <= 2.0 or bearing_deviation == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                NoiseCovariance,
                _noise_covariance_of_numbers(
                    slant_range,
                    elevation,
                    bearing,
                    range_deviation,
                    elevation_deviation,
                    bearing_deviation,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return NoiseCovariance(
        *evaluate(
            _NOISE_COVARIANCE,
            (
                slant_range,
                elevation,
                bearing,
                range_deviation,
                elevation_deviation,
                bearing_deviation,
            ),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _noise_covariance_of_numbers(
    slant_range: float,
    elevation: float,
    bearing: float,
    range_deviation: float,
    elevation_deviation: float,
    bearing_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = form.cos(elevation)
    t6 = form.sin(elevation)
    t8 = form.cos(bearing)
    t9 = form.sin(bearing)
    t10 = slant_range * elevation_deviation
    t12 = (slant_range * t5) * bearing_deviation
    t13 = t5 * range_deviation
    t14 = t6 * t10
    t17 = (t13 * t13) + (t14 * t14)
    t18 = t12 * t12
    t19 = t6 * range_deviation
    t20 = t5 * t10
    t24 = (range_deviation * range_deviation) - (t10 * t10)
    t25 = (t5 * t6) * t24
    t26 = t9 * t9
    t27 = t8 * t8
    t30 = (t26 * t17) + (t27 * t18)
    t33 = (t9 * t8) * (t17 - t18)
    t34 = t9 * t25
    t37 = (t27 * t17) + (t26 * t18)
    t38 = t8 * t25
    t41 = (t19 * t19) + (t20 * t20)
    return (t30, t33, t34, t37, t38, t41)


def _noise_covariance_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    slant_range, elevation, bearing, range_deviation, elevation_deviation, bearing_deviation = given
    covariance_xx, covariance_xy, covariance_xz, covariance_yy, covariance_yz, covariance_zz = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12 = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_bearing = cos(bearing, w2)
    sin_bearing = sin(bearing, w3)
    t10 = multiply(slant_range, elevation_deviation, w4)
    t11 = multiply(slant_range, cos_elevation, w5)
    t12 = multiply(t11, bearing_deviation, w5)
    t13 = multiply(cos_elevation, range_deviation, w6)
    t14 = multiply(sin_elevation, t10, w7)
    t15 = square(t13, w6)
    t16 = square(t14, w7)
    t17 = add(t15, t16, w6)
    t18 = square(t12, w5)
    t19 = multiply(sin_elevation, range_deviation, w7)
    t20 = multiply(cos_elevation, t10, w8)
    t21 = multiply(cos_elevation, sin_elevation, w0)
    t22 = square(range_deviation, w1)
    t23 = square(t10, w4)
    t24 = subtract(t22, t23, w1)
    t25 = multiply(t21, t24, w0)
    t26 = square(sin_bearing, w1)
    t27 = square(cos_bearing, w4)
    t28 = multiply(t26, t17, w9)
    t29 = multiply(t27, t18, w10)
    t31 = multiply(sin_bearing, cos_bearing, w11)
    t32 = subtract(t17, t18, w12)
    t35 = multiply(t27, t17, w4)
    t36 = multiply(t26, t18, w1)
    t39 = square(t19, w7)
    t40 = square(t20, w8)
    add(t28, t29, covariance_xx)
    multiply(t31, t32, covariance_xy)
    multiply(sin_bearing, t25, covariance_xz)
    add(t35, t36, covariance_yy)
    multiply(cos_bearing, t25, covariance_yz)
    add(t39, t40, covariance_zz)


_NOISE_COVARIANCE = Signature(
    "noise_covariance",
    (
        _SLANT_RANGE_DOMAIN,
        _ELEVATION_DOMAIN,
        _BEARING_DOMAIN,
        _RANGE_DEVIATION_DOMAIN,
        _ELEVATION_DEVIATION_DOMAIN,
        _BEARING_DEVIATION_DOMAIN,
    ),
    (
        "covariance_xx",
        "covariance_xy",
        "covariance_xz",
        "covariance_yy",
        "covariance_yz",
        "covariance_zz",
    ),
    13,
    _noise_covariance_block,
    numbers=_noise_covariance_of_numbers,
)


class MeanOfConverted(NamedTuple):
    """Result of `mean_of_converted`."""

    mean_x: Real
    """Mean of the converted x, m."""
    mean_y: Real
    """Mean of the converted y, m."""
    mean_z: Real
    """Mean of the converted z, m."""
    bias_x: Real
    """Mean less true value of x, m."""
    bias_y: Real
    """Mean less true value of y, m."""
    bias_z: Real
    """Mean less true value of z, m."""


def mean_of_converted(
    slant_range: ArrayLike,
    elevation: ArrayLike,
    bearing: ArrayLike,
    elevation_deviation: ArrayLike,
    bearing_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> MeanOfConverted:
    """Mean and bias of a converted measurement under Gaussian angle noise.

        mean_x = x exp(-(sE^2 + sB^2)/2), mean_y likewise, mean_z = z exp(-sE^2/2),
        bias = mean - true value, with x, y, z of `to_cartesian` at the true place. Exact where
        the noises are independent, of mean 0, and those of the angles Gaussian

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    elevation: elevation above the horizontal, rad; 0 or of magnitude 1e-20 to 1.5707963267948966,
        in float32 1e-12 to 1.5707962.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.
    elevation_deviation: standard deviation of the elevation, rad; 0 or a number at least 1e-20 and
        at most 2, in float32 at least 1e-9 and at most 2.
    bearing_deviation: standard deviation of the bearing, rad; 0 or a number at least 1e-20 and at
        most 2, in float32 at least 1e-9 and at most 2.

    mean_x: mean of the converted x, m. Relative error at most 17.51 * 2^-52 (float64), 17.51 *
        2^-23 (float32), proved for every input, provided np.sin, np.cos and np.exp err by at most 4
        units in the last place of the true value.
    mean_y: mean of the converted y, m. Relative error at most 17.51 * 2^-52 (float64), 17.51 *
        2^-23 (float32), proved for every input, provided np.cos and np.exp err by at most 4 units
        in the last place of the true value.
    mean_z: mean of the converted z, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 *
        2^-23 (float32), proved for every input, provided np.sin and np.exp err by at most 4 units
        in the last place of the true value.
    bias_x: mean less true value of x, m. Relative error at most 14.51 * 2^-52 (float64), 14.51 *
        2^-23 (float32), proved for every input, and 8e-45 (float32) beside it where a product
        underflows, provided np.sin, np.cos and np.expm1 err by at most 4 units in the last place of
        the true value.
    bias_y: mean less true value of y, m. Relative error at most 14.51 * 2^-52 (float64), 14.51 *
        2^-23 (float32), proved for every input, and 8e-45 (float32) beside it where a product
        underflows, provided np.cos and np.expm1 err by at most 4 units in the last place of the
        true value.
    bias_z: mean less true value of z, m. Relative error at most 9.51 * 2^-52 (float64), 9.51 *
        2^-23 (float32), proved for every input, provided np.sin and np.expm1 err by at most 4 units
        in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(elevation) is float
        and type(bearing) is float
        and type(elevation_deviation) is float
        and type(bearing_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -1.5707963267948966 <= elevation <= 1.5707963267948966
        and (abs(elevation) >= 1e-20 or elevation == 0)
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and (1e-20 <= elevation_deviation <= 2.0 or elevation_deviation == 0)
        and (1e-20 <= bearing_deviation <= 2.0 or bearing_deviation == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                MeanOfConverted,
                _mean_of_converted_of_numbers(
                    slant_range, elevation, bearing, elevation_deviation, bearing_deviation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MeanOfConverted(
        *evaluate(
            _MEAN_OF_CONVERTED,
            (slant_range, elevation, bearing, elevation_deviation, bearing_deviation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _mean_of_converted_of_numbers(
    slant_range: float,
    elevation: float,
    bearing: float,
    elevation_deviation: float,
    bearing_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t9 = slant_range * form.cos(elevation)
    t10 = t9 * form.sin(bearing)
    t11 = t9 * form.cos(bearing)
    t12 = slant_range * form.sin(elevation)
    t13 = elevation_deviation * elevation_deviation
    t16 = -t13 * 0.5
    t17 = bearing_deviation * bearing_deviation
    t20 = -(t13 + t17) * 0.5
    t22 = form.exp(t20)
    t24 = form.expm1(t20)
    t25 = t10 * t22
    t26 = t11 * t22
    t27 = t12 * form.exp(t16)
    t28 = t10 * t24
    t29 = t11 * t24
    t30 = t12 * form.expm1(t16)
    return (t25, t26, t27, t28, t29, t30)


def _mean_of_converted_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5
) -> None:
    slant_range, elevation, bearing, elevation_deviation, bearing_deviation = given
    mean_x, mean_y, mean_z, bias_x, bias_y, bias_z = out
    w0, w1, w2, w3, w4, w5, w6 = work
    cos_elevation = cos(elevation, w0)
    sin_elevation = sin(elevation, w1)
    cos_bearing = cos(bearing, w2)
    sin_bearing = sin(bearing, w3)
    t9 = multiply(slant_range, cos_elevation, w0)
    t10 = multiply(t9, sin_bearing, w3)
    t11 = multiply(t9, cos_bearing, w0)
    t12 = multiply(slant_range, sin_elevation, w1)
    t13 = square(elevation_deviation, w2)
    t14 = negative(t13, w4)
    t16 = multiply(t14, n0, w4)
    t17 = square(bearing_deviation, w5)
    t18 = add(t13, t17, w2)
    t19 = negative(t18, w2)
    t20 = multiply(t19, n0, w2)
    kept_upwards = exp(t16, w5)
    kept_level = exp(t20, w6)
    change_upwards = expm1(t16, w4)
    change_level = expm1(t20, w2)
    multiply(t10, kept_level, mean_x)
    multiply(t11, kept_level, mean_y)
    multiply(t12, kept_upwards, mean_z)
    multiply(t10, change_level, bias_x)
    multiply(t11, change_level, bias_y)
    multiply(t12, change_upwards, bias_z)


_MEAN_OF_CONVERTED = Signature(
    "mean_of_converted",
    (
        _SLANT_RANGE_DOMAIN,
        _ELEVATION_DOMAIN,
        _BEARING_DOMAIN,
        _ELEVATION_DEVIATION_DOMAIN,
        _BEARING_DEVIATION_DOMAIN,
    ),
    ("mean_x", "mean_y", "mean_z", "bias_x", "bias_y", "bias_z"),
    7,
    _mean_of_converted_block,
    numbers=_mean_of_converted_of_numbers,
)


class StraightCourseRates(NamedTuple):
    """Result of `straight_course_rates`."""

    range_rate: Real
    """Range rate, m/s (Doppler shift: -2 times it over the wavelength)."""
    elevation_rate: Real
    """Rate of the elevation, rad/s."""
    bearing_rate: Real
    """Rate of the bearing, rad/s."""
    range_acceleration: Real
    """Second derivative of the range, m/s^2, never negative."""
    elevation_acceleration: Real
    """Second derivative of the elevation, rad/s^2."""
    bearing_acceleration: Real
    """Second derivative of the bearing, rad/s^2."""


def straight_course_rates(
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    velocity_x: ArrayLike,
    velocity_y: ArrayLike,
    velocity_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StraightCourseRates:
    """Rates of range and angles, and theirs, on a straight uniform course.

        With the components w_R, w_E, w_B of the velocity in the directions in which range,
        elevation and bearing grow: R' = w_R, E' = w_E/R, B' = w_B/h, R'' = (w_E^2 + w_B^2)/R,
        E'' = -(2 w_R w_E + tan E w_B^2)/R^2, B'' = -2 B' h'/h; h = sqrt(x^2 + y^2)

    x: distance east, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    y: distance north, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    z: height, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    velocity_x: velocity east, m/s; 0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9.
    velocity_y: velocity north, m/s; 0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9.
    velocity_z: velocity upwards, m/s; 0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9.

    The distance from the vertical axis, of the inputs together, must be at least 1e-20, in float32
        1e-3.

    range_rate: range rate, m/s (Doppler shift: -2 times it over the wavelength). Error over the sum
        of its terms taken positive at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved
        for every input. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32;
        half or more only where the value is below 2e-7 in float64 and 0.004 in float32 of what its
        error is relative to; what cancels: x/sqrt(sqrt(x**2 + y**2)**2 + z**2)*velocity_x +
        y/sqrt(sqrt(x**2 + y**2)**2 + z**2)*velocity_y + z/sqrt(sqrt(x**2 + y**2)**2 +
        z**2)*velocity_z.
    elevation_rate: rate of the elevation, rad/s. Error over the sum of its terms taken positive at
        most 8.51 * 2^-52 (float64), 8.51 * 2^-23 (float32), proved for every input, and 8e-42
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 3e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 7e-36 (float32) apart;
        what cancels: sqrt(x**2 + y**2)/sqrt(sqrt(x**2 + y**2)**2 + z**2)*velocity_z -
        z/sqrt(sqrt(x**2 + y**2)**2 + z**2)*(x/sqrt(x**2 + y**2)*velocity_x + y/sqrt(x**2 +
        y**2)*velocity_y).
    bearing_rate: rate of the bearing, rad/s. Error over the sum of its terms taken positive at most
        4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, and 8e-45 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 2e-7 in float64 and 0.007 in
        float32 of what its error is relative to; what cancels: y/sqrt(x**2 + y**2)*velocity_x -
        x/sqrt(x**2 + y**2)*velocity_y.
    range_acceleration: second derivative of the range, m/s^2, never negative. Error over the sum of
        its terms taken positive at most 15.51 * 2^-52 (float64), 15.51 * 2^-23 (float32), proved
        for every input, and 3e-323 (float64) and 5e-32 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 8e-7 in float64 and 0.03 in float32 of what its error
        is relative to; values below 3e-26 (float32) apart; what cancels: (sqrt(x**2 +
        y**2)/sqrt(sqrt(x**2 + y**2)**2 + z**2)*velocity_z - z/sqrt(sqrt(x**2 + y**2)**2 +
        z**2)*(x/sqrt(x**2 + y**2)*velocity_x + y/sqrt(x**2 + y**2)*velocity_y))**2 + (y/sqrt(x**2 +
        y**2)*velocity_x - x/sqrt(x**2 + y**2)*velocity_y)**2.
    elevation_acceleration: second derivative of the elevation, rad/s^2. Error over the sum of its
        terms taken positive at most 16.01 * 2^-52 (float64), 16.01 * 2^-23 (float32), proved for
        every input, and 3e-323 (float64) and 5e-29 (float32) beside it where a product underflows.
        Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only
        where the value is below 9e-7 in float64 and 0.03 in float32 of what its error is relative
        to; values below 3e-23 (float32) apart; what cancels: y/sqrt(x**2 + y**2)*velocity_x -
        x/sqrt(x**2 + y**2)*velocity_y.
    bearing_acceleration: second derivative of the bearing, rad/s^2. Error over the sum of its terms
        taken positive at most 8.51 * 2^-52 (float64), 8.51 * 2^-23 (float32), proved for every
        input, and 8e-32 (float32) beside it where a product underflows. Digits that can be lost: up
        to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        3e-7 in float64 and 0.02 in float32 of what its error is relative to; values below 7e-26
        (float32) apart; what cancels: y/sqrt(x**2 + y**2)*velocity_x - x/sqrt(x**2 +
        y**2)*velocity_y.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(x) is float
        and type(y) is float
        and type(z) is float
        and type(velocity_x) is float
        and type(velocity_y) is float
        and type(velocity_z) is float
        and -1e30 <= x <= 1e30
        and (abs(x) >= 1e-20 or x == 0)
        and -1e30 <= y <= 1e30
        and (abs(y) >= 1e-20 or y == 0)
        and -1e30 <= z <= 1e30
        and (abs(z) >= 1e-20 or z == 0)
        and -1e30 <= velocity_x <= 1e30
        and (abs(velocity_x) >= 1e-20 or velocity_x == 0)
        and -1e30 <= velocity_y <= 1e30
        and (abs(velocity_y) >= 1e-20 or velocity_y == 0)
        and -1e30 <= velocity_z <= 1e30
        and (abs(velocity_z) >= 1e-20 or velocity_z == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StraightCourseRates,
                _straight_course_rates_of_numbers(x, y, z, velocity_x, velocity_y, velocity_z),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StraightCourseRates(
        *evaluate(
            _STRAIGHT_COURSE_RATES,
            (x, y, z, velocity_x, velocity_y, velocity_z),
            out,
            workers,
        )
    )


def _straight_course_rates_of_numbers(
    x: float,
    y: float,
    z: float,
    velocity_x: float,
    velocity_y: float,
    velocity_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = form.sqrt((x * x) + (y * y))
    t10 = form.sqrt((t6 * t6) + (z * z))
    t15 = z / t10
    t16 = y / t6
    t17 = x / t6
    t20 = (t17 * velocity_x) + (t16 * velocity_y)
    t25 = ((x / t10) * velocity_x) + ((y / t10) * velocity_y)
    t27 = t25 + (t15 * velocity_z)
    t30 = ((t6 / t10) * velocity_z) - (t15 * t20)
    t33 = (t16 * velocity_x) - (t17 * velocity_y)
    t34 = t30 / t10
    t35 = t33 / t6
    t47 = (((t27 / t10) * 2.0) * t34) + (t15 * (t35 * (t33 / t10)))
    t40 = ((t30 * t30) + (t33 * t33)) / t10
    t48 = -t47
    t52 = -((t35 * 2.0) * (t20 / t6))
    if not t6 >= (0.0010000000474974513 if form.single else 1e-20):
        raise ValueError
    return (t27, t34, t35, t40, t48, t52)


def _straight_course_rates_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 2.0
) -> None:
    x, y, z, velocity_x, velocity_y, velocity_z = given
    (
        range_rate,
        elevation_rate,
        bearing_rate,
        range_acceleration,
        elevation_acceleration,
        bearing_acceleration,
    ) = out
    w0, w1, w2, w3 = work
    t3 = square(x, w0)
    t4 = square(y, w1)
    t5 = add(t3, t4, w0)
    horizontal_distance = sqrt(t5, range_acceleration)
    t7 = square(horizontal_distance, w0)
    t8 = square(z, w1)
    t9 = add(t7, t8, w0)
    slant_range = sqrt(t9, elevation_acceleration)
    t14 = divide(horizontal_distance, slant_range, elevation_rate)
    t15 = divide(z, slant_range, bearing_acceleration)
    t16 = divide(y, horizontal_distance, bearing_rate)
    t17 = divide(x, horizontal_distance, w0)
    t18 = multiply(t17, velocity_x, w1)
    t19 = multiply(t16, velocity_y, w2)
    t20 = add(t18, t19, w1)
    t21 = divide(x, slant_range, range_rate)
    t22 = multiply(t21, velocity_x, range_rate)
    t23 = divide(y, slant_range, w2)
    t24 = multiply(t23, velocity_y, w2)
    t25 = add(t22, t24, range_rate)
    t26 = multiply(t15, velocity_z, w2)
    add(t25, t26, range_rate)
    t28 = multiply(t14, velocity_z, elevation_rate)
    t29 = multiply(t15, t20, w2)
    t30 = subtract(t28, t29, w2)
    t31 = multiply(t16, velocity_x, bearing_rate)
    t32 = multiply(t17, velocity_y, w0)
    t33 = subtract(t31, t32, w0)
    divide(t30, slant_range, elevation_rate)
    divide(t33, horizontal_distance, bearing_rate)
    t36 = divide(t33, slant_range, w3)
    t37 = square(t30, w2)
    t38 = square(t33, w0)
    t39 = add(t37, t38, w2)
    t41 = divide(range_rate, slant_range, w0)
    t43 = multiply(t41, n0, w0)
    t44 = multiply(t43, elevation_rate, w0)
    t45 = multiply(bearing_rate, t36, w3)
    t46 = multiply(t15, t45, bearing_acceleration)
    t47 = add(t44, t46, w0)
    t49 = multiply(bearing_rate, n0, w3)
    t50 = divide(t20, horizontal_distance, w1)
    t51 = multiply(t49, t50, w3)
    divide(t39, slant_range, range_acceleration)
    negative(t47, elevation_acceleration)
    negative(t51, bearing_acceleration)


def _straight_course_rates_horizontal_distance_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    x, y, _z, _velocity_x, _velocity_y, _velocity_z = given
    (horizontal_distance,) = out
    w0, w1 = work
    t3 = square(x, w0)
    t4 = square(y, w1)
    t5 = add(t3, t4, w0)
    sqrt(t5, horizontal_distance)


_STRAIGHT_COURSE_RATES = Signature(
    "straight_course_rates",
    (
        _X_DOMAIN_2,
        _Y_DOMAIN_2,
        _Z_DOMAIN_2,
        _VELOCITY_X_DOMAIN,
        _VELOCITY_Y_DOMAIN,
        _VELOCITY_Z_DOMAIN,
    ),
    (
        "range_rate",
        "elevation_rate",
        "bearing_rate",
        "range_acceleration",
        "elevation_acceleration",
        "bearing_acceleration",
    ),
    4,
    _straight_course_rates_block,
    (
        Required(
            "distance from the vertical axis",
            "at least 1e-20, in float32 1e-3",
            1e-20,
            0.0010000000474974513,
            2,
            _straight_course_rates_horizontal_distance_block,
        ),
    ),
    numbers=_straight_course_rates_of_numbers,
)


class ToCartesianInPlane(NamedTuple):
    """Result of `to_cartesian_in_plane`."""

    x: Real
    """Distance east, m."""
    y: Real
    """Distance north, m."""


def to_cartesian_in_plane(
    slant_range: ArrayLike,
    bearing: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> ToCartesianInPlane:
    """East and north from range and bearing in the plane.

        x = R sin B, y = R cos B

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.

    x: distance east, m. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32),
        proved for every input, provided np.sin errs by at most 4 units in the last place of the
        true value.
    y: distance north, m. Relative error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32),
        proved for every input, provided np.cos errs by at most 4 units in the last place of the
        true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(bearing) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                ToCartesianInPlane, _to_cartesian_in_plane_of_numbers(slant_range, bearing)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ToCartesianInPlane(
        *evaluate(_TO_CARTESIAN_IN_PLANE, (slant_range, bearing), out, workers)
    )


@errstate(all="ignore")
def _to_cartesian_in_plane_of_numbers(
    slant_range: float,
    bearing: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = slant_range * form.sin(bearing)
    t5 = slant_range * form.cos(bearing)
    return (t4, t5)


def _to_cartesian_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    slant_range, bearing = given
    x, y = out
    w0, w1 = work
    cos_bearing = cos(bearing, w0)
    sin_bearing = sin(bearing, w1)
    multiply(slant_range, sin_bearing, x)
    multiply(slant_range, cos_bearing, y)


_TO_CARTESIAN_IN_PLANE = Signature(
    "to_cartesian_in_plane",
    (_SLANT_RANGE_DOMAIN, _BEARING_DOMAIN),
    ("x", "y"),
    2,
    _to_cartesian_in_plane_block,
    numbers=_to_cartesian_in_plane_of_numbers,
)


class ToPolarInPlane(NamedTuple):
    """Result of `to_polar_in_plane`."""

    slant_range: Real
    """Range, m."""
    bearing: Real
    """Bearing from north, clockwise seen from above, between -pi and pi, rad."""


def to_polar_in_plane(
    x: ArrayLike, y: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> ToPolarInPlane:
    """Range and bearing from east and north in the plane.

        R = sqrt(x^2 + y^2), B = atan2(x, y). In the south the sign of a zero x decides between
        B = pi and -pi; at the origin signs of zeros make it 0 or +-pi

    x: distance east, m; 0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18.
    y: distance north, m; 0 or of magnitude 1e-150 to 1e150, in float32 1e-18 to 1e18.

    slant_range: range, m. Relative error at most 1.01 * 2^-52 (float64), 1.01 * 2^-23 (float32),
        proved for every input.
    bearing: bearing from north, clockwise seen from above, between -pi and pi, rad. Relative error
        at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, provided
        np.arctan2 errs by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(x) is float
        and type(y) is float
        and -1e150 <= x <= 1e150
        and (abs(x) >= 1e-150 or x == 0)
        and -1e150 <= y <= 1e150
        and (abs(y) >= 1e-150 or y == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(ToPolarInPlane, _to_polar_in_plane_of_numbers(x, y))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ToPolarInPlane(*evaluate(_TO_POLAR_IN_PLANE, (x, y), out, workers))


@errstate(all="ignore")
def _to_polar_in_plane_of_numbers(x: float, y: float, form: Form = Double) -> tuple[float, ...]:
    t5 = form.sqrt((x * x) + (y * y))
    t6 = form.atan2(x, y)
    return (t5, t6)


def _to_polar_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    x, y = given
    slant_range, bearing = out
    w0, w1 = work
    t2 = square(x, w0)
    t3 = square(y, w1)
    t4 = add(t2, t3, w0)
    sqrt(t4, slant_range)
    arctan2(x, y, bearing)


_TO_POLAR_IN_PLANE = Signature(
    "to_polar_in_plane",
    (_X_DOMAIN, _Y_DOMAIN),
    ("slant_range", "bearing"),
    2,
    _to_polar_in_plane_block,
    numbers=_to_polar_in_plane_of_numbers,
)


class CartesianDerivativesInPlane(NamedTuple):
    """Result of `cartesian_derivatives_in_plane`."""

    x_D_slant_range: Real
    """Derivative of x by the range, dimensionless."""
    x_D_bearing: Real
    """Derivative of x by the bearing, m/rad."""
    y_D_slant_range: Real
    """Derivative of y by the range, dimensionless."""
    y_D_bearing: Real
    """Derivative of y by the bearing, m/rad."""


def cartesian_derivatives_in_plane(
    slant_range: ArrayLike,
    bearing: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> CartesianDerivativesInPlane:
    """Derivatives of x and y by range and bearing in the plane.

        x_D_slant_range = sin B, x_D_bearing = y, y_D_slant_range = cos B, y_D_bearing = -x

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.

    x_D_slant_range: derivative of x by the range, dimensionless. Relative error at most 4.01 *
        2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, provided np.sin errs by at
        most 4 units in the last place of the true value.
    x_D_bearing: derivative of x by the bearing, m/rad. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input, provided np.cos errs by at most 4
        units in the last place of the true value.
    y_D_slant_range: derivative of y by the range, dimensionless. Relative error at most 4.01 *
        2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, provided np.cos errs by at
        most 4 units in the last place of the true value.
    y_D_bearing: derivative of y by the bearing, m/rad. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input, provided np.sin errs by at most 4
        units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(bearing) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                CartesianDerivativesInPlane,
                _cartesian_derivatives_in_plane_of_numbers(slant_range, bearing),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return CartesianDerivativesInPlane(
        *evaluate(_CARTESIAN_DERIVATIVES_IN_PLANE, (slant_range, bearing), out, workers)
    )


@errstate(all="ignore")
def _cartesian_derivatives_in_plane_of_numbers(
    slant_range: float,
    bearing: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = form.cos(bearing)
    t3 = form.sin(bearing)
    t4 = slant_range * t2
    t6 = -(slant_range * t3)
    return (t3, t4, t2, t6)


def _cartesian_derivatives_in_plane_block(
    given: Arrays, out: Arrays, _work: Arrays, _single: bool
) -> None:
    slant_range, bearing = given
    x_D_slant_range, x_D_bearing, y_D_slant_range, y_D_bearing = out
    cos(bearing, y_D_slant_range)
    sin(bearing, x_D_slant_range)
    t5 = multiply(slant_range, x_D_slant_range, y_D_bearing)
    multiply(slant_range, y_D_slant_range, x_D_bearing)
    negative(t5, y_D_bearing)


_CARTESIAN_DERIVATIVES_IN_PLANE = Signature(
    "cartesian_derivatives_in_plane",
    (_SLANT_RANGE_DOMAIN, _BEARING_DOMAIN),
    ("x_D_slant_range", "x_D_bearing", "y_D_slant_range", "y_D_bearing"),
    0,
    _cartesian_derivatives_in_plane_block,
    numbers=_cartesian_derivatives_in_plane_of_numbers,
)


class PolarDerivativesInPlane(NamedTuple):
    """Result of `polar_derivatives_in_plane`."""

    slant_range_D_x: Real
    """Derivative of the range by x, dimensionless."""
    slant_range_D_y: Real
    """Derivative of the range by y, dimensionless."""
    bearing_D_x: Real
    """Derivative of the bearing by x, rad/m."""
    bearing_D_y: Real
    """Derivative of the bearing by y, rad/m."""


def polar_derivatives_in_plane(
    x: ArrayLike,
    y: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> PolarDerivativesInPlane:
    """Derivatives of range and bearing by x and y in the plane.

        slant_range_D_x = x/R, slant_range_D_y = y/R, bearing_D_x = y/R^2, bearing_D_y = -x/R^2

    x: distance east, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    y: distance north, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.

    The distance from the origin, of the inputs together, must be at least 1e-20, in float32 1e-3.

    slant_range_D_x: derivative of the range by x, dimensionless. Relative error at most 1.51 *
        2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
    slant_range_D_y: derivative of the range by y, dimensionless. Relative error at most 1.51 *
        2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input.
    bearing_D_x: derivative of the bearing by x, rad/m. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.
    bearing_D_y: derivative of the bearing by y, rad/m. Relative error at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(x) is float
        and type(y) is float
        and -1e30 <= x <= 1e30
        and (abs(x) >= 1e-20 or x == 0)
        and -1e30 <= y <= 1e30
        and (abs(y) >= 1e-20 or y == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(PolarDerivativesInPlane, _polar_derivatives_in_plane_of_numbers(x, y))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PolarDerivativesInPlane(*evaluate(_POLAR_DERIVATIVES_IN_PLANE, (x, y), out, workers))


def _polar_derivatives_in_plane_of_numbers(
    x: float,
    y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = form.sqrt((x * x) + (y * y))
    t6 = x / t5
    t7 = y / t5
    t8 = t7 / t5
    t10 = -(t6 / t5)
    if not t5 >= (0.0010000000474974513 if form.single else 1e-20):
        raise ValueError
    return (t6, t7, t8, t10)


def _polar_derivatives_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    x, y = given
    slant_range_D_x, slant_range_D_y, bearing_D_x, bearing_D_y = out
    w0, w1 = work
    t2 = square(x, w0)
    t3 = square(y, w1)
    t4 = add(t2, t3, w0)
    slant_range = sqrt(t4, bearing_D_x)
    divide(x, slant_range, slant_range_D_x)
    divide(y, slant_range, slant_range_D_y)
    t9 = divide(slant_range_D_x, slant_range, bearing_D_y)
    divide(slant_range_D_y, slant_range, bearing_D_x)
    negative(t9, bearing_D_y)


def _polar_derivatives_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    x, y = given
    (slant_range,) = out
    w0, w1 = work
    t2 = square(x, w0)
    t3 = square(y, w1)
    t4 = add(t2, t3, w0)
    sqrt(t4, slant_range)


_POLAR_DERIVATIVES_IN_PLANE = Signature(
    "polar_derivatives_in_plane",
    (_X_DOMAIN_2, _Y_DOMAIN_2),
    ("slant_range_D_x", "slant_range_D_y", "bearing_D_x", "bearing_D_y"),
    2,
    _polar_derivatives_in_plane_block,
    (
        Required(
            "distance from the origin",
            "at least 1e-20, in float32 1e-3",
            1e-20,
            0.0010000000474974513,
            2,
            _polar_derivatives_in_plane_slant_range_block,
        ),
    ),
    numbers=_polar_derivatives_in_plane_of_numbers,
)


class NoiseCovarianceInPlane(NamedTuple):
    """Result of `noise_covariance_in_plane`."""

    covariance_xx: Real
    """Variance of x, m^2."""
    covariance_xy: Real
    """Covariance of x and y, m^2."""
    covariance_yy: Real
    """Variance of y, m^2."""


def noise_covariance_in_plane(
    slant_range: ArrayLike,
    bearing: ArrayLike,
    range_deviation: ArrayLike,
    bearing_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> NoiseCovarianceInPlane:
    """Covariance of a converted measurement to first order, in the plane.

        J diag(sR^2, sB^2) J' with J of `cartesian_derivatives_in_plane`: at the true place the
        covariance of the converted position to first order, at the measured one its estimate

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.
    range_deviation: standard deviation of the range, m; 0 or a number at least 1e-20 and at most
        1e60, in float32 at least 1e-6 and at most 1e12.
    bearing_deviation: standard deviation of the bearing, rad; 0 or a number at least 1e-20 and at
        most 2, in float32 at least 1e-9 and at most 2.

    covariance_xx: variance of x, m^2. Relative error at most 11.01 * 2^-52 (float64), 11.01 * 2^-23
        (float32), proved for every input, and 8e-45 (float32) beside it where a product underflows,
        provided np.sin and np.cos err by at most 4 units in the last place of the true value.
    covariance_xy: covariance of x and y, m^2. Error over the sum of its terms taken positive at
        most 11.01 * 2^-52 (float64), 11.01 * 2^-23 (float32), proved for every input, and 8e-45
        (float32) beside it where a product underflows, provided np.sin and np.cos err by at most 4
        units in the last place of the true value. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 3e-7 in float64
        and 0.02 in float32 of what its error is relative to; what cancels: range_deviation**2 -
        (slant_range*bearing_deviation)**2.
    covariance_yy: variance of y, m^2. Relative error at most 11.01 * 2^-52 (float64), 11.01 * 2^-23
        (float32), proved for every input, and 8e-45 (float32) beside it where a product underflows,
        provided np.sin and np.cos err by at most 4 units in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(bearing) is float
        and type(range_deviation) is float
        and type(bearing_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and (1e-20 <= range_deviation <= 1e60 or range_deviation == 0)
        and (1e-20 <= bearing_deviation <= 2.0 or bearing_deviation == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                NoiseCovarianceInPlane,
                _noise_covariance_in_plane_of_numbers(
                    slant_range, bearing, range_deviation, bearing_deviation
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return NoiseCovarianceInPlane(
        *evaluate(
            _NOISE_COVARIANCE_IN_PLANE,
            (slant_range, bearing, range_deviation, bearing_deviation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _noise_covariance_in_plane_of_numbers(
    slant_range: float,
    bearing: float,
    range_deviation: float,
    bearing_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = form.cos(bearing)
    t5 = form.sin(bearing)
    t6 = slant_range * bearing_deviation
    t7 = range_deviation * range_deviation
    t8 = t6 * t6
    t9 = t5 * t5
    t10 = t4 * t4
    t13 = (t9 * t7) + (t10 * t8)
    t16 = (t5 * t4) * (t7 - t8)
    t19 = (t10 * t7) + (t9 * t8)
    return (t13, t16, t19)


def _noise_covariance_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    slant_range, bearing, range_deviation, bearing_deviation = given
    covariance_xx, covariance_xy, covariance_yy = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    cos_bearing = cos(bearing, w0)
    sin_bearing = sin(bearing, w1)
    t6 = multiply(slant_range, bearing_deviation, w2)
    t7 = square(range_deviation, w3)
    t8 = square(t6, w2)
    t9 = square(sin_bearing, w4)
    t10 = square(cos_bearing, w5)
    t11 = multiply(t9, t7, w6)
    t12 = multiply(t10, t8, w7)
    t14 = multiply(sin_bearing, cos_bearing, w1)
    t15 = subtract(t7, t8, w0)
    t17 = multiply(t10, t7, w5)
    t18 = multiply(t9, t8, w4)
    add(t11, t12, covariance_xx)
    multiply(t14, t15, covariance_xy)
    add(t17, t18, covariance_yy)


_NOISE_COVARIANCE_IN_PLANE = Signature(
    "noise_covariance_in_plane",
    (_SLANT_RANGE_DOMAIN, _BEARING_DOMAIN, _RANGE_DEVIATION_DOMAIN, _BEARING_DEVIATION_DOMAIN),
    ("covariance_xx", "covariance_xy", "covariance_yy"),
    8,
    _noise_covariance_in_plane_block,
    numbers=_noise_covariance_in_plane_of_numbers,
)


class MeanOfConvertedInPlane(NamedTuple):
    """Result of `mean_of_converted_in_plane`."""

    mean_x: Real
    """Mean of the converted x, m."""
    mean_y: Real
    """Mean of the converted y, m."""
    bias_x: Real
    """Mean less true value of x, m."""
    bias_y: Real
    """Mean less true value of y, m."""


def mean_of_converted_in_plane(
    slant_range: ArrayLike,
    bearing: ArrayLike,
    bearing_deviation: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> MeanOfConvertedInPlane:
    """Mean and bias of a converted measurement in the plane.

        mean = exp(-sB^2/2) (x, y), bias = mean - (x, y), x and y of `to_cartesian_in_plane` at
        the true place. Exact where the noises are independent, of mean 0, and that of the
        bearing Gaussian

    slant_range: range, m; a number at least 1e-20 and at most 1e60, in float32 at least 1e-6 and at
        most 1e12.
    bearing: bearing from north, clockwise seen from above, rad; 0 or of magnitude 1e-20 to 6.2832,
        in float32 1e-12 to 6.2832.
    bearing_deviation: standard deviation of the bearing, rad; 0 or a number at least 1e-20 and at
        most 2, in float32 at least 1e-9 and at most 2.

    mean_x: mean of the converted x, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 *
        2^-23 (float32), proved for every input, provided np.sin and np.exp err by at most 4 units
        in the last place of the true value.
    mean_y: mean of the converted y, m. Relative error at most 10.01 * 2^-52 (float64), 10.01 *
        2^-23 (float32), proved for every input, provided np.cos and np.exp err by at most 4 units
        in the last place of the true value.
    bias_x: mean less true value of x, m. Relative error at most 9.51 * 2^-52 (float64), 9.51 *
        2^-23 (float32), proved for every input, provided np.sin and np.expm1 err by at most 4 units
        in the last place of the true value.
    bias_y: mean less true value of y, m. Relative error at most 9.51 * 2^-52 (float64), 9.51 *
        2^-23 (float32), proved for every input, provided np.cos and np.expm1 err by at most 4 units
        in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(slant_range) is float
        and type(bearing) is float
        and type(bearing_deviation) is float
        and 1e-20 <= slant_range <= 1e60
        and -6.2832 <= bearing <= 6.2832
        and (abs(bearing) >= 1e-20 or bearing == 0)
        and (1e-20 <= bearing_deviation <= 2.0 or bearing_deviation == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                MeanOfConvertedInPlane,
                _mean_of_converted_in_plane_of_numbers(slant_range, bearing, bearing_deviation),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MeanOfConvertedInPlane(
        *evaluate(
            _MEAN_OF_CONVERTED_IN_PLANE,
            (slant_range, bearing, bearing_deviation),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _mean_of_converted_in_plane_of_numbers(
    slant_range: float,
    bearing: float,
    bearing_deviation: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = slant_range * form.sin(bearing)
    t6 = slant_range * form.cos(bearing)
    t7 = bearing_deviation * bearing_deviation
    t10 = -t7 * 0.5
    t11 = form.exp(t10)
    t12 = form.expm1(t10)
    t13 = t5 * t11
    t14 = t6 * t11
    t15 = t5 * t12
    t16 = t6 * t12
    return (t13, t14, t15, t16)


def _mean_of_converted_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5
) -> None:
    slant_range, bearing, bearing_deviation = given
    mean_x, mean_y, bias_x, bias_y = out
    w0, w1, w2, w3 = work
    cos_bearing = cos(bearing, w0)
    sin_bearing = sin(bearing, w1)
    t5 = multiply(slant_range, sin_bearing, w1)
    t6 = multiply(slant_range, cos_bearing, w0)
    t7 = square(bearing_deviation, w2)
    t8 = negative(t7, w2)
    t10 = multiply(t8, n0, w2)
    kept_level = exp(t10, w3)
    change_level = expm1(t10, w2)
    multiply(t5, kept_level, mean_x)
    multiply(t6, kept_level, mean_y)
    multiply(t5, change_level, bias_x)
    multiply(t6, change_level, bias_y)


_MEAN_OF_CONVERTED_IN_PLANE = Signature(
    "mean_of_converted_in_plane",
    (_SLANT_RANGE_DOMAIN, _BEARING_DOMAIN, _BEARING_DEVIATION_DOMAIN),
    ("mean_x", "mean_y", "bias_x", "bias_y"),
    4,
    _mean_of_converted_in_plane_block,
    numbers=_mean_of_converted_in_plane_of_numbers,
)


class StraightCourseRatesInPlane(NamedTuple):
    """Result of `straight_course_rates_in_plane`."""

    range_rate: Real
    """Range rate, m/s (Doppler shift: -2 times it over the wavelength)."""
    bearing_rate: Real
    """Rate of the bearing, rad/s."""
    range_acceleration: Real
    """Second derivative of the range, m/s^2, never negative."""
    bearing_acceleration: Real
    """Second derivative of the bearing, rad/s^2."""


def straight_course_rates_in_plane(
    x: ArrayLike,
    y: ArrayLike,
    velocity_x: ArrayLike,
    velocity_y: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StraightCourseRatesInPlane:
    """Rates of range and bearing, and theirs, on a straight uniform course in the plane.

        With the components w_R, w_B of the velocity along and across the line of sight
        R' = w_R, B' = w_B/R, R'' = w_B^2/R, B'' = -2 B' R'/R

    x: distance east, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    y: distance north, m; 0 or of magnitude 1e-20 to 1e30, in float32 1e-6 to 1e12.
    velocity_x: velocity east, m/s; 0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9.
    velocity_y: velocity north, m/s; 0 or of magnitude 1e-20 to 1e30, in float32 1e-9 to 1e9.

    The distance from the origin, of the inputs together, must be at least 1e-20, in float32 1e-3.

    range_rate: range rate, m/s (Doppler shift: -2 times it over the wavelength). Error over the sum
        of its terms taken positive at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved
        for every input. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32;
        half or more only where the value is below 7e-8 in float64 and 0.002 in float32 of what its
        error is relative to; what cancels: x/sqrt(x**2 + y**2)*velocity_x + y/sqrt(x**2 +
        y**2)*velocity_y.
    bearing_rate: rate of the bearing, rad/s. Error over the sum of its terms taken positive at most
        4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, and 8e-45 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 2e-7 in float64 and 0.007 in
        float32 of what its error is relative to; what cancels: y/sqrt(x**2 + y**2)*velocity_x -
        x/sqrt(x**2 + y**2)*velocity_y.
    range_acceleration: second derivative of the range, m/s^2, never negative. Error over the sum of
        its terms taken positive at most 7.01 * 2^-52 (float64), 7.01 * 2^-23 (float32), proved for
        every input, and 8e-42 (float32) beside it where a product underflows. Digits that can be
        lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is
        below 2e-7 in float64 and 0.02 in float32 of what its error is relative to; values below
        9e-36 (float32) apart; what cancels: y/sqrt(x**2 + y**2)*velocity_x - x/sqrt(x**2 +
        y**2)*velocity_y.
    bearing_acceleration: second derivative of the bearing, rad/s^2. Error over the sum of its terms
        taken positive at most 8.51 * 2^-52 (float64), 8.51 * 2^-23 (float32), proved for every
        input, and 8e-32 (float32) beside it where a product underflows. Digits that can be lost: up
        to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        3e-7 in float64 and 0.02 in float32 of what its error is relative to; values below 7e-26
        (float32) apart; what cancels: y/sqrt(x**2 + y**2)*velocity_x - x/sqrt(x**2 +
        y**2)*velocity_y.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation polar-coordinates
    """
    if (
        type(x) is float
        and type(y) is float
        and type(velocity_x) is float
        and type(velocity_y) is float
        and -1e30 <= x <= 1e30
        and (abs(x) >= 1e-20 or x == 0)
        and -1e30 <= y <= 1e30
        and (abs(y) >= 1e-20 or y == 0)
        and -1e30 <= velocity_x <= 1e30
        and (abs(velocity_x) >= 1e-20 or velocity_x == 0)
        and -1e30 <= velocity_y <= 1e30
        and (abs(velocity_y) >= 1e-20 or velocity_y == 0)
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StraightCourseRatesInPlane,
                _straight_course_rates_in_plane_of_numbers(x, y, velocity_x, velocity_y),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StraightCourseRatesInPlane(
        *evaluate(_STRAIGHT_COURSE_RATES_IN_PLANE, (x, y, velocity_x, velocity_y), out, workers)
    )


def _straight_course_rates_in_plane_of_numbers(
    x: float,
    y: float,
    velocity_x: float,
    velocity_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t7 = form.sqrt((x * x) + (y * y))
    t8 = x / t7
    t9 = y / t7
    t12 = (t8 * velocity_x) + (t9 * velocity_y)
    t15 = (t9 * velocity_x) - (t8 * velocity_y)
    t16 = t15 / t7
    t18 = (t15 * t15) / t7
    t23 = -((t16 * 2.0) * (t12 / t7))
    if not t7 >= (0.0010000000474974513 if form.single else 1e-20):
        raise ValueError
    return (t12, t16, t18, t23)


def _straight_course_rates_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 2.0
) -> None:
    x, y, velocity_x, velocity_y = given
    range_rate, bearing_rate, range_acceleration, bearing_acceleration = out
    w0, w1 = work
    t4 = square(x, w0)
    t5 = square(y, w1)
    t6 = add(t4, t5, w0)
    slant_range = sqrt(t6, bearing_acceleration)
    t8 = divide(x, slant_range, bearing_rate)
    t9 = divide(y, slant_range, range_acceleration)
    t10 = multiply(t8, velocity_x, w0)
    t11 = multiply(t9, velocity_y, w1)
    add(t10, t11, range_rate)
    t13 = multiply(t9, velocity_x, range_acceleration)
    t14 = multiply(t8, velocity_y, bearing_rate)
    t15 = subtract(t13, t14, range_acceleration)
    divide(t15, slant_range, bearing_rate)
    t17 = square(t15, range_acceleration)
    t20 = multiply(bearing_rate, n0, w0)
    divide(t17, slant_range, range_acceleration)
    t21 = divide(range_rate, slant_range, bearing_acceleration)
    t22 = multiply(t20, t21, bearing_acceleration)
    negative(t22, bearing_acceleration)


def _straight_course_rates_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    x, y, _velocity_x, _velocity_y = given
    (slant_range,) = out
    w0, w1 = work
    t4 = square(x, w0)
    t5 = square(y, w1)
    t6 = add(t4, t5, w0)
    sqrt(t6, slant_range)


_STRAIGHT_COURSE_RATES_IN_PLANE = Signature(
    "straight_course_rates_in_plane",
    (_X_DOMAIN_2, _Y_DOMAIN_2, _VELOCITY_X_DOMAIN, _VELOCITY_Y_DOMAIN),
    ("range_rate", "bearing_rate", "range_acceleration", "bearing_acceleration"),
    2,
    _straight_course_rates_in_plane_block,
    (
        Required(
            "distance from the origin",
            "at least 1e-20, in float32 1e-3",
            1e-20,
            0.0010000000474974513,
            2,
            _straight_course_rates_in_plane_slant_range_block,
        ),
    ),
    numbers=_straight_course_rates_in_plane_of_numbers,
)
