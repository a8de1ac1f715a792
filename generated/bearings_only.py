# Made by: gainproof generate bearings-only
# From: gainproof derive bearings-only, SymPy 1.14.0
"""Bearings and elevations of targets from stations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, arctan2, divide, errstate, multiply, sqrt, square, subtract

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
    "Angles",
    "AnglesJacobian",
    "Bearing",
    "BearingJacobian",
    "angles",
    "angles_jacobian",
    "bearing",
    "bearing_jacobian",
]

_TARGET_X_DOMAIN = Domain(
    "target_x",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_TARGET_Y_DOMAIN = Domain(
    "target_y",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_STATION_X_DOMAIN = Domain(
    "station_x",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_STATION_Y_DOMAIN = Domain(
    "station_y",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_TARGET_Z_DOMAIN = Domain(
    "target_z",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_STATION_Z_DOMAIN = Domain(
    "station_z",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)


class Bearing(NamedTuple):
    """Result of `bearing`."""

    bearing: Real
    """Bearing from north, clockwise seen from above, rad."""


def bearing(
    target_x: ArrayLike,
    target_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    *,
    out: tuple[Real] | None = None,
    workers: int = 1,
) -> Bearing:
    """Bearing of a target from a station.

        bearing = atan2(-station_x + target_x, -station_y + target_y)
        where y = 0 and x < 0 the sign of the zero decides between pi and -pi for atan2(y, x):
        bounds are of the one that it gives

    target_x: target east, m; of magnitude at most 1e60, in float32 1e12.
    target_y: target north, m; of magnitude at most 1e60, in float32 1e12.
    station_x: station east, m; of magnitude at most 1e60, in float32 1e12.
    station_y: station north, m; of magnitude at most 1e60, in float32 1e12.

    The level distance of target and station, of the inputs together, must be at least 1e-20, in
        float32 0.000001.

    bearing: bearing from north, clockwise seen from above, rad. Relative error at most 5.01 * 2^-52
        (float64), 5.01 * 2^-23 (float32), proved for every input, and 3e-323 (float64) and 8e-45
        (float32) beside it where a product underflows, provided np.arctan2 errs by at most 4 units
        in the last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: the definitions of the angles
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(station_x) is float
        and type(station_y) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(Bearing, _bearing_of_numbers(target_x, target_y, station_x, station_y))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Bearing(*evaluate(_BEARING, (target_x, target_y, station_x, station_y), out, workers))


@errstate(all="ignore")
def _bearing_of_numbers(
    target_x: float,
    target_y: float,
    station_x: float,
    station_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = target_x - station_x
    t6 = target_y - station_y
    t9 = form.sqrt((t2 * t2) + (t6 * t6))
    t10 = form.atan2(t2, t6)
    if not t9 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t10,)


def _bearing_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    (bearing,) = out
    w0, w1 = work
    t2 = subtract(target_x, station_x, w0)
    t6 = subtract(target_y, station_y, w1)
    arctan2(t2, t6, bearing)


def _bearing_condition_1_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    (condition_1,) = out
    w0, w1 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w0)
    t6 = subtract(target_y, station_y, w1)
    t7 = square(t6, w1)
    t8 = add(t3, t7, w0)
    sqrt(t8, condition_1)


_BEARING = Signature(
    "bearing",
    (_TARGET_X_DOMAIN, _TARGET_Y_DOMAIN, _STATION_X_DOMAIN, _STATION_Y_DOMAIN),
    ("bearing",),
    2,
    _bearing_block,
    (
        Required(
            "level distance of target and station",
            "at least 1e-20, in float32 0.000001",
            1e-20,
            9.999999974752427e-07,
            2,
            _bearing_condition_1_block,
            (0, 2),
        ),
    ),
    numbers=_bearing_of_numbers,
)


class BearingJacobian(NamedTuple):
    """Result of `bearing_jacobian`."""

    bearing_D_target_x: Real
    """Derivative of bearing by target_x, m^-1."""
    bearing_D_target_y: Real
    """Derivative of bearing by target_y, m^-1."""


def bearing_jacobian(
    target_x: ArrayLike,
    target_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> BearingJacobian:
    """Derivatives of bearing by the target's position.

        bearing_D_target_x = (-station_y + target_y)/((-station_x + target_x)**2 + (-station_y +
            target_y)**2)
        bearing_D_target_y = (station_x - target_x)/((-station_x + target_x)**2 + (-station_y +
            target_y)**2)

    target_x: target east, m; of magnitude at most 1e60, in float32 1e12.
    target_y: target north, m; of magnitude at most 1e60, in float32 1e12.
    station_x: station east, m; of magnitude at most 1e60, in float32 1e12.
    station_y: station north, m; of magnitude at most 1e60, in float32 1e12.

    The level distance of target and station, of the inputs together, must be at least 1e-20, in
        float32 0.000001.

    bearing_D_target_x: derivative of bearing by target_x, m^-1. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input, and 3e-323 (float64) and 8e-45
        (float32) beside it where a product underflows.
    bearing_D_target_y: derivative of bearing by target_y, m^-1. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input, and 3e-323 (float64) and 8e-45
        (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: the definitions of the angles
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(station_x) is float
        and type(station_y) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                BearingJacobian,
                _bearing_jacobian_of_numbers(target_x, target_y, station_x, station_y),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return BearingJacobian(
        *evaluate(_BEARING_JACOBIAN, (target_x, target_y, station_x, station_y), out, workers)
    )


def _bearing_jacobian_of_numbers(
    target_x: float,
    target_y: float,
    station_x: float,
    station_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = target_x - station_x
    t6 = target_y - station_y
    t9 = form.sqrt((t2 * t2) + (t6 * t6))
    t11 = t9 * t9
    t12 = t6 / t11
    t13 = (station_x - target_x) / t11
    if not t9 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t12, t13)


def _bearing_jacobian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    bearing_D_target_x, bearing_D_target_y = out
    w0, w1, w2 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w0)
    t6 = subtract(target_y, station_y, w1)
    t7 = square(t6, w2)
    t8 = add(t3, t7, w0)
    under_2 = sqrt(t8, bearing_D_target_x)
    t10 = subtract(station_x, target_x, w0)
    t11 = square(under_2, w2)
    divide(t6, t11, bearing_D_target_x)
    divide(t10, t11, bearing_D_target_y)


def _bearing_jacobian_condition_1_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, station_x, station_y = given
    (condition_1,) = out
    w0, w1 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w0)
    t6 = subtract(target_y, station_y, w1)
    t7 = square(t6, w1)
    t8 = add(t3, t7, w0)
    sqrt(t8, condition_1)


_BEARING_JACOBIAN = Signature(
    "bearing_jacobian",
    (_TARGET_X_DOMAIN, _TARGET_Y_DOMAIN, _STATION_X_DOMAIN, _STATION_Y_DOMAIN),
    ("bearing_D_target_x", "bearing_D_target_y"),
    3,
    _bearing_jacobian_block,
    (
        Required(
            "level distance of target and station",
            "at least 1e-20, in float32 0.000001",
            1e-20,
            9.999999974752427e-07,
            2,
            _bearing_jacobian_condition_1_block,
            (0, 2),
        ),
    ),
    numbers=_bearing_jacobian_of_numbers,
)


class Angles(NamedTuple):
    """Result of `angles`."""

    bearing: Real
    """Bearing from north, clockwise seen from above, rad."""
    elevation: Real
    """Elevation above the horizontal, rad."""


def angles(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> Angles:
    """Angles of a target from a station.

        bearing = atan2(-station_x + target_x, -station_y + target_y)
        elevation = atan2(-station_z + target_z, sqrt((-station_x + target_x)**2 + (-station_y +
            target_y)**2))
        where y = 0 and x < 0 the sign of the zero decides between pi and -pi for atan2(y, x):
        bounds are of the one that it gives

    target_x: target east, m; of magnitude at most 1e60, in float32 1e12.
    target_y: target north, m; of magnitude at most 1e60, in float32 1e12.
    target_z: target up, m; of magnitude at most 1e60, in float32 1e12.
    station_x: station east, m; of magnitude at most 1e60, in float32 1e12.
    station_y: station north, m; of magnitude at most 1e60, in float32 1e12.
    station_z: station up, m; of magnitude at most 1e60, in float32 1e12.

    The level distance of target and station, of the inputs together, must be at least 1e-20, in
        float32 0.000001.
    The distance of target and station, of the inputs together, must be at least 1e-20, in float32
        0.000001.

    bearing: bearing from north, clockwise seen from above, rad. Relative error at most 5.01 * 2^-52
        (float64), 5.01 * 2^-23 (float32), proved for every input, and 3e-323 (float64) and 8e-45
        (float32) beside it where a product underflows, provided np.arctan2 errs by at most 4 units
        in the last place of the true value.
    elevation: elevation above the horizontal, rad. Relative error at most 6.01 * 2^-52 (float64),
        6.01 * 2^-23 (float32), proved for every input, and 3e-323 (float64) and 8e-45 (float32)
        beside it where a product underflows, provided np.arctan2 errs by at most 4 units in the
        last place of the true value.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: the definitions of the angles
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_z) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_z <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                Angles,
                _angles_of_numbers(target_x, target_y, target_z, station_x, station_y, station_z),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Angles(
        *evaluate(
            _ANGLES,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
            workers,
        )
    )


@errstate(all="ignore")
def _angles_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = target_x - station_x
    t6 = target_y - station_y
    t8 = (t2 * t2) + (t6 * t6)
    t9 = form.sqrt(t8)
    t12 = target_z - station_z
    t15 = form.sqrt(t8 + (t12 * t12))
    t16 = form.atan2(t2, t6)
    t17 = form.atan2(t12, t9)
    if not t9 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    if not t15 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t16, t17)


def _angles_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    bearing, elevation = out
    w0, w1, w2, w3 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w1)
    t6 = subtract(target_y, station_y, w2)
    t7 = square(t6, w3)
    t8 = add(t3, t7, w1)
    part_1 = sqrt(t8, elevation)
    t12 = subtract(target_z, station_z, w1)
    arctan2(t2, t6, bearing)
    arctan2(t12, part_1, elevation)


def _angles_condition_1_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, _target_z, station_x, station_y, _station_z = given
    (condition_1,) = out
    w0, w1 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w0)
    t6 = subtract(target_y, station_y, w1)
    t7 = square(t6, w1)
    t8 = add(t3, t7, w0)
    sqrt(t8, condition_1)


def _angles_condition_2_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (condition_2,) = out
    w0, w1 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w0)
    t6 = subtract(target_y, station_y, w1)
    t7 = square(t6, w1)
    t8 = add(t3, t7, w0)
    t12 = subtract(target_z, station_z, w1)
    t13 = square(t12, w1)
    t14 = add(t8, t13, w0)
    sqrt(t14, condition_2)


_ANGLES = Signature(
    "angles",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
    ),
    ("bearing", "elevation"),
    4,
    _angles_block,
    (
        Required(
            "level distance of target and station",
            "at least 1e-20, in float32 0.000001",
            1e-20,
            9.999999974752427e-07,
            2,
            _angles_condition_1_block,
            (0, 3),
        ),
        Required(
            "distance of target and station",
            "at least 1e-20, in float32 0.000001",
            1e-20,
            9.999999974752427e-07,
            2,
            _angles_condition_2_block,
            (0, 3),
        ),
    ),
    numbers=_angles_of_numbers,
)


class AnglesJacobian(NamedTuple):
    """Result of `angles_jacobian`."""

    bearing_D_target_x: Real
    """Derivative of bearing by target_x, m^-1."""
    bearing_D_target_y: Real
    """Derivative of bearing by target_y, m^-1."""
    elevation_D_target_x: Real
    """Derivative of elevation by target_x, m^-1."""
    elevation_D_target_y: Real
    """Derivative of elevation by target_y, m^-1."""
    elevation_D_target_z: Real
    """Derivative of elevation by target_z, m^-1."""


def angles_jacobian(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> AnglesJacobian:
    """Derivatives of angles by the target's position.

        bearing_D_target_x = (-station_y + target_y)/((-station_x + target_x)**2 + (-station_y +
            target_y)**2)
        bearing_D_target_y = (station_x - target_x)/((-station_x + target_x)**2 + (-station_y +
            target_y)**2)
        elevation_D_target_x = (-station_x + target_x)*(station_z - target_z)/(sqrt((-station_x
            + target_x)**2 + (-station_y + target_y)**2)*((-station_x + target_x)**2 +
            (-station_y + target_y)**2 + (-station_z + target_z)**2))
        elevation_D_target_y = (-station_y + target_y)*(station_z - target_z)/(sqrt((-station_x
            + target_x)**2 + (-station_y + target_y)**2)*((-station_x + target_x)**2 +
            (-station_y + target_y)**2 + (-station_z + target_z)**2))
        elevation_D_target_z = sqrt((-station_x + target_x)**2 + (-station_y +
            target_y)**2)/((-station_x + target_x)**2 + (-station_y + target_y)**2 + (-station_z
            + target_z)**2)

    target_x: target east, m; of magnitude at most 1e60, in float32 1e12.
    target_y: target north, m; of magnitude at most 1e60, in float32 1e12.
    target_z: target up, m; of magnitude at most 1e60, in float32 1e12.
    station_x: station east, m; of magnitude at most 1e60, in float32 1e12.
    station_y: station north, m; of magnitude at most 1e60, in float32 1e12.
    station_z: station up, m; of magnitude at most 1e60, in float32 1e12.

    The level distance of target and station, of the inputs together, must be at least 1e-20, in
        float32 0.000001.
    The distance of target and station, of the inputs together, must be at least 1e-20, in float32
        0.000001.

    bearing_D_target_x: derivative of bearing by target_x, m^-1. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input, and 3e-323 (float64) and 8e-45
        (float32) beside it where a product underflows.
    bearing_D_target_y: derivative of bearing by target_y, m^-1. Relative error at most 4.51 * 2^-52
        (float64), 4.51 * 2^-23 (float32), proved for every input, and 3e-323 (float64) and 8e-45
        (float32) beside it where a product underflows.
    elevation_D_target_x: derivative of elevation by target_x, m^-1. Relative error at most 8.01 *
        2^-52 (float64), 8.01 * 2^-23 (float32), proved for every input, and 5e-223 (float64) and
        2e-20 (float32) beside it where a product underflows.
    elevation_D_target_y: derivative of elevation by target_y, m^-1. Relative error at most 8.01 *
        2^-52 (float64), 8.01 * 2^-23 (float32), proved for every input, and 5e-223 (float64) and
        2e-20 (float32) beside it where a product underflows.
    elevation_D_target_z: derivative of elevation by target_z, m^-1. Relative error at most 6.01 *
        2^-52 (float64), 6.01 * 2^-23 (float32), proved for every input.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: the definitions of the angles
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_z) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_z <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                AnglesJacobian,
                _angles_jacobian_of_numbers(
                    target_x, target_y, target_z, station_x, station_y, station_z
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return AnglesJacobian(
        *evaluate(
            _ANGLES_JACOBIAN,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
            workers,
        )
    )


def _angles_jacobian_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = target_x - station_x
    t6 = target_y - station_y
    t8 = (t2 * t2) + (t6 * t6)
    t9 = form.sqrt(t8)
    t13 = target_z - station_z
    t16 = form.sqrt(t8 + (t13 * t13))
    t18 = t9 * t9
    t23 = ((station_z - target_z) / t16) / t16
    t19 = t6 / t18
    t20 = (station_x - target_x) / t18
    t24 = (t2 / t9) * t23
    t26 = (t6 / t9) * t23
    t28 = t9 / (t16 * t16)
    if not t9 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    if not t16 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t19, t20, t24, t26, t28)


def _angles_jacobian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (
        bearing_D_target_x,
        bearing_D_target_y,
        elevation_D_target_x,
        elevation_D_target_y,
        elevation_D_target_z,
    ) = out
    w0, w1, w2, w3, w4 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w1)
    t6 = subtract(target_y, station_y, w2)
    t7 = square(t6, w3)
    t8 = add(t3, t7, w1)
    under_3 = sqrt(t8, elevation_D_target_z)
    t10 = subtract(station_x, target_x, w3)
    t13 = subtract(target_z, station_z, w4)
    t14 = square(t13, w4)
    t15 = add(t8, t14, w1)
    under_4 = sqrt(t15, bearing_D_target_x)
    t17 = subtract(station_z, target_z, w1)
    t18 = square(under_3, w4)
    t21 = divide(t2, under_3, elevation_D_target_x)
    t22 = divide(t17, under_4, bearing_D_target_y)
    t23 = divide(t22, under_4, elevation_D_target_y)
    t25 = divide(t6, under_3, w0)
    t27 = square(under_4, w1)
    divide(t6, t18, bearing_D_target_x)
    divide(t10, t18, bearing_D_target_y)
    multiply(t21, t23, elevation_D_target_x)
    multiply(t25, t23, elevation_D_target_y)
    divide(under_3, t27, elevation_D_target_z)


def _angles_jacobian_condition_1_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, _target_z, station_x, station_y, _station_z = given
    (condition_1,) = out
    w0, w1 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w0)
    t6 = subtract(target_y, station_y, w1)
    t7 = square(t6, w1)
    t8 = add(t3, t7, w0)
    sqrt(t8, condition_1)


def _angles_jacobian_condition_2_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (condition_2,) = out
    w0, w1 = work
    t2 = subtract(target_x, station_x, w0)
    t3 = square(t2, w0)
    t6 = subtract(target_y, station_y, w1)
    t7 = square(t6, w1)
    t8 = add(t3, t7, w0)
    t13 = subtract(target_z, station_z, w1)
    t14 = square(t13, w1)
    t15 = add(t8, t14, w0)
    sqrt(t15, condition_2)


_ANGLES_JACOBIAN = Signature(
    "angles_jacobian",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
    ),
    (
        "bearing_D_target_x",
        "bearing_D_target_y",
        "elevation_D_target_x",
        "elevation_D_target_y",
        "elevation_D_target_z",
    ),
    5,
    _angles_jacobian_block,
    (
        Required(
            "level distance of target and station",
            "at least 1e-20, in float32 0.000001",
            1e-20,
            9.999999974752427e-07,
            2,
            _angles_jacobian_condition_1_block,
            (0, 3),
        ),
        Required(
            "distance of target and station",
            "at least 1e-20, in float32 0.000001",
            1e-20,
            9.999999974752427e-07,
            2,
            _angles_jacobian_condition_2_block,
            (0, 3),
        ),
    ),
    numbers=_angles_jacobian_of_numbers,
)
