# Made by: gainproof generate range-doppler
# From: gainproof derive range-doppler, SymPy 1.14.0
"""Range and Doppler of moving targets from moving stations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, multiply, negative, sqrt, square, subtract

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
    "BistaticRangeDoppler",
    "BistaticRangeDopplerInPlane",
    "DopplerShift",
    "DopplerShiftInPlane",
    "RangeDoppler",
    "RangeDopplerDifference",
    "RangeDopplerDifferenceInPlane",
    "RangeDopplerInPlane",
    "RangeHessian",
    "RangeHessianInPlane",
    "RangeJacobian",
    "RangeJacobianInPlane",
    "RangeRate",
    "RangeRateHessian",
    "RangeRateHessianInPlane",
    "RangeRateInPlane",
    "RangeRateJacobian",
    "RangeRateJacobianInPlane",
    "SlantRange",
    "SlantRangeInPlane",
    "bistatic_range_doppler",
    "bistatic_range_doppler_in_plane",
    "doppler_shift",
    "doppler_shift_in_plane",
    "range_doppler",
    "range_doppler_difference",
    "range_doppler_difference_in_plane",
    "range_doppler_in_plane",
    "range_hessian",
    "range_hessian_in_plane",
    "range_jacobian",
    "range_jacobian_in_plane",
    "range_rate",
    "range_rate_hessian",
    "range_rate_hessian_in_plane",
    "range_rate_in_plane",
    "range_rate_jacobian",
    "range_rate_jacobian_in_plane",
    "slant_range",
    "slant_range_in_plane",
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
_TARGET_Z_DOMAIN = Domain(
    "target_z",
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
_STATION_Z_DOMAIN = Domain(
    "station_z",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_TARGET_VELOCITY_X_DOMAIN = Domain(
    "target_velocity_x",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_TARGET_VELOCITY_Y_DOMAIN = Domain(
    "target_velocity_y",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_TARGET_VELOCITY_Z_DOMAIN = Domain(
    "target_velocity_z",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_STATION_VELOCITY_X_DOMAIN = Domain(
    "station_velocity_x",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_STATION_VELOCITY_Y_DOMAIN = Domain(
    "station_velocity_y",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_STATION_VELOCITY_Z_DOMAIN = Domain(
    "station_velocity_z",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_CARRIER_FREQUENCY_DOMAIN = Domain(
    "carrier_frequency",
    "a number at least 1e-10 and at most 1e30, in float32 at least 1e-3 and at most 1e15",
    (1e-10, 1e30),
    (0.0010000000474974513, 999999986991104.0),
)
_FIRST_STATION_X_DOMAIN = Domain(
    "first_station_x",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_Y_DOMAIN = Domain(
    "first_station_y",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_Z_DOMAIN = Domain(
    "first_station_z",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_VELOCITY_X_DOMAIN = Domain(
    "first_station_velocity_x",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_VELOCITY_Y_DOMAIN = Domain(
    "first_station_velocity_y",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_VELOCITY_Z_DOMAIN = Domain(
    "first_station_velocity_z",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_X_DOMAIN = Domain(
    "second_station_x",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_Y_DOMAIN = Domain(
    "second_station_y",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_Z_DOMAIN = Domain(
    "second_station_z",
    "of magnitude at most 1e60, in float32 1e12",
    (0.0, 1e60),
    (0.0, 999999995904.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_VELOCITY_X_DOMAIN = Domain(
    "second_station_velocity_x",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_VELOCITY_Y_DOMAIN = Domain(
    "second_station_velocity_y",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_VELOCITY_Z_DOMAIN = Domain(
    "second_station_velocity_z",
    "of magnitude at most 1e60, in float32 1e9",
    (0.0, 1e60),
    (0.0, 1000000000.0),
    zero=True,
    signed=True,
)
_TARGET_X_DOMAIN_2 = Domain(
    "target_x",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_TARGET_Y_DOMAIN_2 = Domain(
    "target_y",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_TARGET_Z_DOMAIN_2 = Domain(
    "target_z",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_TARGET_VELOCITY_X_DOMAIN_2 = Domain(
    "target_velocity_x",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_TARGET_VELOCITY_Y_DOMAIN_2 = Domain(
    "target_velocity_y",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_TARGET_VELOCITY_Z_DOMAIN_2 = Domain(
    "target_velocity_z",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_X_DOMAIN_2 = Domain(
    "first_station_x",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_Y_DOMAIN_2 = Domain(
    "first_station_y",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_Z_DOMAIN_2 = Domain(
    "first_station_z",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_VELOCITY_X_DOMAIN_2 = Domain(
    "first_station_velocity_x",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_VELOCITY_Y_DOMAIN_2 = Domain(
    "first_station_velocity_y",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_FIRST_STATION_VELOCITY_Z_DOMAIN_2 = Domain(
    "first_station_velocity_z",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_X_DOMAIN_2 = Domain(
    "second_station_x",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_Y_DOMAIN_2 = Domain(
    "second_station_y",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_Z_DOMAIN_2 = Domain(
    "second_station_z",
    "of magnitude at most 1e40, in float32 1e10",
    (0.0, 1e40),
    (0.0, 10000000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_VELOCITY_X_DOMAIN_2 = Domain(
    "second_station_velocity_x",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_VELOCITY_Y_DOMAIN_2 = Domain(
    "second_station_velocity_y",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)
_SECOND_STATION_VELOCITY_Z_DOMAIN_2 = Domain(
    "second_station_velocity_z",
    "of magnitude at most 1e30, in float32 1e6",
    (0.0, 1e30),
    (0.0, 1000000.0),
    zero=True,
    signed=True,
)


class SlantRange(NamedTuple):
    """Result of `slant_range`."""

    slant_range: Real
    """Distance of the target from the station, m."""


def slant_range(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    *,
    out: tuple[Real] | None = None,
    workers: int = 1,
) -> SlantRange:
    """Distance of targets from stations.

        r = target - station, f = |r|

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    slant_range: distance of the target from the station, m. Relative error at most 1.76 * 2^-52
        (float64), 1.76 * 2^-23 (float32), proved for every input.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
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
                SlantRange,
                _slant_range_of_numbers(
                    target_x, target_y, target_z, station_x, station_y, station_z
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return SlantRange(
        *evaluate(
            _SLANT_RANGE,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
            workers,
        )
    )


def _slant_range_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = target_x - station_x
    t7 = target_y - station_y
    t8 = target_z - station_z
    t14 = form.sqrt(((t6 * t6) + (t7 * t7)) + (t8 * t8))
    if not t14 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t14,)


def _slant_range_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t9 = square(place_x, w0)
    t10 = square(place_y, w1)
    t11 = square(place_z, w2)
    t12 = add(t9, t10, w0)
    t13 = add(t12, t11, w0)
    sqrt(t13, slant_range)


def _slant_range_slant_range_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t9 = square(place_x, w0)
    t10 = square(place_y, w1)
    t11 = square(place_z, w2)
    t12 = add(t9, t10, w0)
    t13 = add(t12, t11, w0)
    sqrt(t13, slant_range)


_SLANT_RANGE = Signature(
    "slant_range",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
    ),
    ("slant_range",),
    3,
    _slant_range_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _slant_range_slant_range_block,
            (0, 3),
        ),
    ),
    numbers=_slant_range_of_numbers,
)


class RangeJacobian(NamedTuple):
    """Result of `range_jacobian`."""

    range_D_x: Real
    """Derivative of the range by the target's position along x, dimensionless."""
    range_D_y: Real
    """Derivative of the range by the target's position along y, dimensionless."""
    range_D_z: Real
    """Derivative of the range by the target's position along z, dimensionless."""


def range_jacobian(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeJacobian:
    """Derivative of the range: the unit vector from station to target.

        u = r/f, r = target - station, f = |r|.
        By the station's position the derivative is -u

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_D_x: derivative of the range by the target's position along x, dimensionless. Relative
        error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_D_y: derivative of the range by the target's position along y, dimensionless. Relative
        error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_D_z: derivative of the range by the target's position along z, dimensionless. Relative
        error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
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
                RangeJacobian,
                _range_jacobian_of_numbers(
                    target_x, target_y, target_z, station_x, station_y, station_z
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeJacobian(
        *evaluate(
            _RANGE_JACOBIAN,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
            workers,
        )
    )


def _range_jacobian_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = target_x - station_x
    t7 = target_y - station_y
    t8 = target_z - station_z
    t14 = form.sqrt(((t6 * t6) + (t7 * t7)) + (t8 * t8))
    t15 = t6 / t14
    t16 = t7 / t14
    t17 = t8 / t14
    if not t14 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t15, t16, t17)


def _range_jacobian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    range_D_x, range_D_y, range_D_z = out
    w0, w1, w2, w3, w4, w5 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t9 = square(place_x, w3)
    t10 = square(place_y, w4)
    t11 = square(place_z, w5)
    t12 = add(t9, t10, w3)
    t13 = add(t12, t11, w3)
    slant_range = sqrt(t13, range_D_z)
    divide(place_x, slant_range, range_D_x)
    divide(place_y, slant_range, range_D_y)
    divide(place_z, slant_range, range_D_z)


def _range_jacobian_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t9 = square(place_x, w0)
    t10 = square(place_y, w1)
    t11 = square(place_z, w2)
    t12 = add(t9, t10, w0)
    t13 = add(t12, t11, w0)
    sqrt(t13, slant_range)


_RANGE_JACOBIAN = Signature(
    "range_jacobian",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
    ),
    ("range_D_x", "range_D_y", "range_D_z"),
    6,
    _range_jacobian_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _range_jacobian_slant_range_block,
            (0, 3),
        ),
    ),
    numbers=_range_jacobian_of_numbers,
)


class RangeRate(NamedTuple):
    """Result of `range_rate`."""

    range_rate: Real
    """Its rate, m/s, above 0 where the target goes away."""


def range_rate(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    target_velocity_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    station_velocity_z: ArrayLike,
    *,
    out: tuple[Real] | None = None,
    workers: int = 1,
) -> RangeRate:
    """Range rate of moving targets from moving stations.

        g = u'w, r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        The terms of g, |u_i w_i|, add up to at most |w|

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_z: velocity of the target along z, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_z: velocity of the station along z, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_rate: its rate, m/s, above 0 where the target goes away. Error over the sum of its terms
        taken positive at most 4.76 * 2^-52 (float64), 4.76 * 2^-23 (float32), proved for every
        input, and 2e-262 (float64) and 5e-35 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 3e-7 in float64 and 0.008 in float32 of what its error is relative to;
        values below 2e-247 (float64) and 8e-29 (float32) apart; what cancels: the terms of
        range_rate.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(target_velocity_z) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_z) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and type(station_velocity_z) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= target_velocity_z <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_z <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and -1e60 <= station_velocity_z <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeRate,
                _range_rate_of_numbers(
                    target_x,
                    target_y,
                    target_z,
                    target_velocity_x,
                    target_velocity_y,
                    target_velocity_z,
                    station_x,
                    station_y,
                    station_z,
                    station_velocity_x,
                    station_velocity_y,
                    station_velocity_z,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeRate(
        *evaluate(
            _RANGE_RATE,
            (
                target_x,
                target_y,
                target_z,
                target_velocity_x,
                target_velocity_y,
                target_velocity_z,
                station_x,
                station_y,
                station_z,
                station_velocity_x,
                station_velocity_y,
                station_velocity_z,
            ),
            out,
            workers,
        )
    )


def _range_rate_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    target_velocity_x: float,
    target_velocity_y: float,
    target_velocity_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    station_velocity_x: float,
    station_velocity_y: float,
    station_velocity_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t12 = target_x - station_x
    t13 = target_y - station_y
    t14 = target_z - station_z
    t15 = target_velocity_x - station_velocity_x
    t16 = target_velocity_y - station_velocity_y
    t17 = target_velocity_z - station_velocity_z
    t22 = ((t12 * t12) + (t13 * t13)) + (t14 * t14)
    t23 = form.sqrt(t22)
    t30 = ((t12 / t23) * t15) + ((t13 / t23) * t16)
    t31 = t30 + ((t14 / t23) * t17)
    if not t23 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t31,)


def _range_rate_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        target_x,
        target_y,
        target_z,
        target_velocity_x,
        target_velocity_y,
        target_velocity_z,
        station_x,
        station_y,
        station_z,
        station_velocity_x,
        station_velocity_y,
        station_velocity_z,
    ) = given
    (range_rate,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w3)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w4)
    velocity_z = subtract(target_velocity_z, station_velocity_z, w5)
    t18 = square(place_x, w6)
    t19 = square(place_y, w7)
    t20 = square(place_z, w8)
    t21 = add(t18, t19, w6)
    t22 = add(t21, t20, w6)
    slant_range = sqrt(t22, range_rate)
    t24 = divide(place_x, slant_range, w0)
    t25 = divide(place_y, slant_range, w1)
    t27 = multiply(t24, velocity_x, w0)
    t28 = multiply(t25, velocity_y, w1)
    t30 = add(t27, t28, w0)
    t26 = divide(place_z, slant_range, range_rate)
    t29 = multiply(t26, velocity_z, range_rate)
    add(t30, t29, range_rate)


def _range_rate_slant_range_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        station_x,
        station_y,
        station_z,
        _station_velocity_x,
        _station_velocity_y,
        _station_velocity_z,
    ) = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t18 = square(place_x, w0)
    t19 = square(place_y, w1)
    t20 = square(place_z, w2)
    t21 = add(t18, t19, w0)
    t22 = add(t21, t20, w0)
    sqrt(t22, slant_range)


_RANGE_RATE = Signature(
    "range_rate",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _TARGET_VELOCITY_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
        _STATION_VELOCITY_Z_DOMAIN,
    ),
    ("range_rate",),
    9,
    _range_rate_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _range_rate_slant_range_block,
            (0, 6),
        ),
    ),
    numbers=_range_rate_of_numbers,
)


class RangeRateJacobian(NamedTuple):
    """Result of `range_rate_jacobian`."""

    range_rate_D_x: Real
    """Derivative of the range rate by the target's position along x, 1/s."""
    range_rate_D_y: Real
    """Derivative of the range rate by the target's position along y, 1/s."""
    range_rate_D_z: Real
    """Derivative of the range rate by the target's position along z, 1/s."""
    range_rate_D_velocity_x: Real
    """Derivative of the range rate by the target's velocity along x, dimensionless."""
    range_rate_D_velocity_y: Real
    """Derivative of the range rate by the target's velocity along y, dimensionless."""
    range_rate_D_velocity_z: Real
    """Derivative of the range rate by the target's velocity along z, dimensionless."""


def range_rate_jacobian(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    target_velocity_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    station_velocity_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeRateJacobian:
    """Derivative of the range rate by position and velocity.

        by the position h = (w - g u)/f with g = u'w, by the velocity u;
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        By the station's position and velocity the derivatives are these with the other sign.
        The terms of h add up to at most 2 |w|/f: where the target moves nearly along the line of
        sight, w and g u nearly agree, and h has lost as many digits as |w| is larger than |h| f

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_z: velocity of the target along z, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_z: velocity of the station along z, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_rate_D_x: derivative of the range rate by the target's position along x, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 2e-227 (float64) and 7e-23 (float32) apart; what
        cancels: target_velocity_x - station_velocity_x - (... + ...*(target_velocity_z -
        station_velocity_z))*(target_x - station_x)/....
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 2e-227 (float64) and 7e-23 (float32) apart; what
        cancels: target_velocity_y - station_velocity_y - (... + ...*(target_velocity_z -
        station_velocity_z))*(target_y - station_y)/....
    range_rate_D_z: derivative of the range rate by the target's position along z, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 2e-227 (float64) and 7e-23 (float32) apart; what
        cancels: target_velocity_z - station_velocity_z - (... + ...*(target_velocity_z -
        station_velocity_z))*(target_z - station_z)/....
    range_rate_D_velocity_x: derivative of the range rate by the target's velocity along x,
        dimensionless. Relative error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved
        for every input, and 3e-323 (float64) and 8e-45 (float32) beside it where a product
        underflows.
    range_rate_D_velocity_y: derivative of the range rate by the target's velocity along y,
        dimensionless. Relative error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved
        for every input, and 3e-323 (float64) and 8e-45 (float32) beside it where a product
        underflows.
    range_rate_D_velocity_z: derivative of the range rate by the target's velocity along z,
        dimensionless. Relative error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved
        for every input, and 3e-323 (float64) and 8e-45 (float32) beside it where a product
        underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(target_velocity_z) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_z) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and type(station_velocity_z) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= target_velocity_z <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_z <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and -1e60 <= station_velocity_z <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeRateJacobian,
                _range_rate_jacobian_of_numbers(
                    target_x,
                    target_y,
                    target_z,
                    target_velocity_x,
                    target_velocity_y,
                    target_velocity_z,
                    station_x,
                    station_y,
                    station_z,
                    station_velocity_x,
                    station_velocity_y,
                    station_velocity_z,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeRateJacobian(
        *evaluate(
            _RANGE_RATE_JACOBIAN,
            (
                target_x,
                target_y,
                target_z,
                target_velocity_x,
                target_velocity_y,
                target_velocity_z,
                station_x,
                station_y,
                station_z,
                station_velocity_x,
                station_velocity_y,
                station_velocity_z,
            ),
            out,
            workers,
        )
    )


def _range_rate_jacobian_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    target_velocity_x: float,
    target_velocity_y: float,
    target_velocity_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    station_velocity_x: float,
    station_velocity_y: float,
    station_velocity_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t12 = target_x - station_x
    t13 = target_y - station_y
    t14 = target_z - station_z
    t15 = target_velocity_x - station_velocity_x
    t16 = target_velocity_y - station_velocity_y
    t17 = target_velocity_z - station_velocity_z
    t22 = ((t12 * t12) + (t13 * t13)) + (t14 * t14)
    t23 = form.sqrt(t22)
    t24 = t12 / t23
    t25 = t13 / t23
    t26 = t14 / t23
    t31 = ((t24 * t15) + (t25 * t16)) + (t26 * t17)
    t34 = (t15 - (t31 * t24)) / t23
    t37 = (t16 - (t31 * t25)) / t23
    t40 = (t17 - (t31 * t26)) / t23
    if not t23 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t34, t37, t40, t24, t25, t26)


def _range_rate_jacobian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        target_x,
        target_y,
        target_z,
        target_velocity_x,
        target_velocity_y,
        target_velocity_z,
        station_x,
        station_y,
        station_z,
        station_velocity_x,
        station_velocity_y,
        station_velocity_z,
    ) = given
    (
        range_rate_D_x,
        range_rate_D_y,
        range_rate_D_z,
        range_rate_D_velocity_x,
        range_rate_D_velocity_y,
        range_rate_D_velocity_z,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w3)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w4)
    velocity_z = subtract(target_velocity_z, station_velocity_z, w5)
    t18 = square(place_x, w6)
    t19 = square(place_y, w7)
    t20 = square(place_z, w8)
    t21 = add(t18, t19, w6)
    t22 = add(t21, t20, w6)
    slant_range = sqrt(t22, range_rate_D_z)
    divide(place_x, slant_range, range_rate_D_velocity_x)
    divide(place_y, slant_range, range_rate_D_velocity_y)
    divide(place_z, slant_range, range_rate_D_velocity_z)
    t27 = multiply(range_rate_D_velocity_x, velocity_x, w0)
    t28 = multiply(range_rate_D_velocity_y, velocity_y, w1)
    t29 = multiply(range_rate_D_velocity_z, velocity_z, w2)
    t30 = add(t27, t28, w0)
    range_rate = add(t30, t29, w0)
    t32 = multiply(range_rate, range_rate_D_velocity_x, w1)
    t33 = subtract(velocity_x, t32, w3)
    t35 = multiply(range_rate, range_rate_D_velocity_y, w1)
    t36 = subtract(velocity_y, t35, w4)
    t38 = multiply(range_rate, range_rate_D_velocity_z, w0)
    t39 = subtract(velocity_z, t38, w5)
    divide(t33, slant_range, range_rate_D_x)
    divide(t36, slant_range, range_rate_D_y)
    divide(t39, slant_range, range_rate_D_z)


def _range_rate_jacobian_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        station_x,
        station_y,
        station_z,
        _station_velocity_x,
        _station_velocity_y,
        _station_velocity_z,
    ) = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t18 = square(place_x, w0)
    t19 = square(place_y, w1)
    t20 = square(place_z, w2)
    t21 = add(t18, t19, w0)
    t22 = add(t21, t20, w0)
    sqrt(t22, slant_range)


_RANGE_RATE_JACOBIAN = Signature(
    "range_rate_jacobian",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _TARGET_VELOCITY_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
        _STATION_VELOCITY_Z_DOMAIN,
    ),
    (
        "range_rate_D_x",
        "range_rate_D_y",
        "range_rate_D_z",
        "range_rate_D_velocity_x",
        "range_rate_D_velocity_y",
        "range_rate_D_velocity_z",
    ),
    9,
    _range_rate_jacobian_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _range_rate_jacobian_slant_range_block,
            (0, 6),
        ),
    ),
    numbers=_range_rate_jacobian_of_numbers,
)


class RangeDoppler(NamedTuple):
    """Result of `range_doppler`."""

    slant_range: Real
    """Distance of the target from the station, m."""
    range_rate: Real
    """Its rate, m/s, above 0 where the target goes away."""
    range_D_x: Real
    """Derivative of the range by the target's position along x, dimensionless."""
    range_D_y: Real
    """Derivative of the range by the target's position along y, dimensionless."""
    range_D_z: Real
    """Derivative of the range by the target's position along z, dimensionless."""
    range_rate_D_x: Real
    """Derivative of the range rate by the target's position along x, 1/s."""
    range_rate_D_y: Real
    """Derivative of the range rate by the target's position along y, 1/s."""
    range_rate_D_z: Real
    """Derivative of the range rate by the target's position along z, 1/s."""


def range_doppler(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    target_velocity_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    station_velocity_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeDoppler:
    """Range and range rate with their derivatives.

        f, g = u'w, their derivatives by the position u and h = (w - g u)/f, that of g by the
        velocity, u;
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        By the station's position and velocity the derivatives are these with the other sign.
        The terms of g, |u_i w_i|, add up to at most |w|.
        The terms of h add up to at most 2 |w|/f: where the target moves nearly along the line of
        sight, w and g u nearly agree, and h has lost as many digits as |w| is larger than |h| f

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_z: velocity of the target along z, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_z: velocity of the station along z, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    slant_range: distance of the target from the station, m. Relative error at most 1.76 * 2^-52
        (float64), 1.76 * 2^-23 (float32), proved for every input.
    range_rate: its rate, m/s, above 0 where the target goes away. Error over the sum of its terms
        taken positive at most 4.76 * 2^-52 (float64), 4.76 * 2^-23 (float32), proved for every
        input, and 2e-262 (float64) and 5e-35 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 3e-7 in float64 and 0.008 in float32 of what its error is relative to;
        values below 2e-247 (float64) and 8e-29 (float32) apart; what cancels: the terms of
        range_rate.
    range_D_x: derivative of the range by the target's position along x, dimensionless. Relative
        error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_D_y: derivative of the range by the target's position along y, dimensionless. Relative
        error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_D_z: derivative of the range by the target's position along z, dimensionless. Relative
        error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_rate_D_x: derivative of the range rate by the target's position along x, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 2e-227 (float64) and 7e-23 (float32) apart; what
        cancels: target_velocity_x - station_velocity_x - (... + .../slant_range*(target_velocity_z
        - station_velocity_z))*(target_x - station_x)/....
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 2e-227 (float64) and 7e-23 (float32) apart; what
        cancels: target_velocity_y - station_velocity_y - (... + .../slant_range*(target_velocity_z
        - station_velocity_z))*(target_y - station_y)/....
    range_rate_D_z: derivative of the range rate by the target's position along z, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 2e-227 (float64) and 7e-23 (float32) apart; what
        cancels: target_velocity_z - station_velocity_z - (... + .../slant_range*(target_velocity_z
        - station_velocity_z))*(target_z - station_z)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(target_velocity_z) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_z) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and type(station_velocity_z) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= target_velocity_z <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_z <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and -1e60 <= station_velocity_z <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeDoppler,
                _range_doppler_of_numbers(
                    target_x,
                    target_y,
                    target_z,
                    target_velocity_x,
                    target_velocity_y,
                    target_velocity_z,
                    station_x,
                    station_y,
                    station_z,
                    station_velocity_x,
                    station_velocity_y,
                    station_velocity_z,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeDoppler(
        *evaluate(
            _RANGE_DOPPLER,
            (
                target_x,
                target_y,
                target_z,
                target_velocity_x,
                target_velocity_y,
                target_velocity_z,
                station_x,
                station_y,
                station_z,
                station_velocity_x,
                station_velocity_y,
                station_velocity_z,
            ),
            out,
            workers,
        )
    )


def _range_doppler_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    target_velocity_x: float,
    target_velocity_y: float,
    target_velocity_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    station_velocity_x: float,
    station_velocity_y: float,
    station_velocity_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t12 = target_x - station_x
    t13 = target_y - station_y
    t14 = target_z - station_z
    t15 = target_velocity_x - station_velocity_x
    t16 = target_velocity_y - station_velocity_y
    t17 = target_velocity_z - station_velocity_z
    t22 = ((t12 * t12) + (t13 * t13)) + (t14 * t14)
    t23 = form.sqrt(t22)
    t24 = t12 / t23
    t25 = t13 / t23
    t26 = t14 / t23
    t31 = ((t24 * t15) + (t25 * t16)) + (t26 * t17)
    t34 = (t15 - (t31 * t24)) / t23
    t37 = (t16 - (t31 * t25)) / t23
    t40 = (t17 - (t31 * t26)) / t23
    if not t23 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t23, t31, t24, t25, t26, t34, t37, t40)


def _range_doppler_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        target_x,
        target_y,
        target_z,
        target_velocity_x,
        target_velocity_y,
        target_velocity_z,
        station_x,
        station_y,
        station_z,
        station_velocity_x,
        station_velocity_y,
        station_velocity_z,
    ) = given
    (
        slant_range,
        range_rate,
        range_D_x,
        range_D_y,
        range_D_z,
        range_rate_D_x,
        range_rate_D_y,
        range_rate_D_z,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w3)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w4)
    velocity_z = subtract(target_velocity_z, station_velocity_z, w5)
    t18 = square(place_x, w6)
    t19 = square(place_y, w7)
    t20 = square(place_z, w8)
    t21 = add(t18, t19, w6)
    t22 = add(t21, t20, w6)
    sqrt(t22, slant_range)
    divide(place_x, slant_range, range_D_x)
    divide(place_y, slant_range, range_D_y)
    divide(place_z, slant_range, range_D_z)
    t27 = multiply(range_D_x, velocity_x, w0)
    t28 = multiply(range_D_y, velocity_y, w1)
    t29 = multiply(range_D_z, velocity_z, w2)
    t30 = add(t27, t28, w0)
    add(t30, t29, range_rate)
    t32 = multiply(range_rate, range_D_x, w0)
    t33 = subtract(velocity_x, t32, w3)
    t35 = multiply(range_rate, range_D_y, w0)
    t36 = subtract(velocity_y, t35, w4)
    t38 = multiply(range_rate, range_D_z, w0)
    t39 = subtract(velocity_z, t38, w5)
    divide(t33, slant_range, range_rate_D_x)
    divide(t36, slant_range, range_rate_D_y)
    divide(t39, slant_range, range_rate_D_z)


def _range_doppler_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        station_x,
        station_y,
        station_z,
        _station_velocity_x,
        _station_velocity_y,
        _station_velocity_z,
    ) = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t18 = square(place_x, w0)
    t19 = square(place_y, w1)
    t20 = square(place_z, w2)
    t21 = add(t18, t19, w0)
    t22 = add(t21, t20, w0)
    sqrt(t22, slant_range)


_RANGE_DOPPLER = Signature(
    "range_doppler",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _TARGET_VELOCITY_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
        _STATION_VELOCITY_Z_DOMAIN,
    ),
    (
        "slant_range",
        "range_rate",
        "range_D_x",
        "range_D_y",
        "range_D_z",
        "range_rate_D_x",
        "range_rate_D_y",
        "range_rate_D_z",
    ),
    9,
    _range_doppler_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _range_doppler_slant_range_block,
            (0, 6),
        ),
    ),
    numbers=_range_doppler_of_numbers,
)


class RangeHessian(NamedTuple):
    """Result of `range_hessian`."""

    range_D_xx: Real
    """Second derivative of the range by the target's position along x, twice, 1/m."""
    range_D_xy: Real
    """Second derivative of the range by the target's position along x and y, 1/m."""
    range_D_xz: Real
    """Second derivative of the range by the target's position along x and z, 1/m."""
    range_D_yy: Real
    """Second derivative of the range by the target's position along y, twice, 1/m."""
    range_D_yz: Real
    """Second derivative of the range by the target's position along y and z, 1/m."""
    range_D_zz: Real
    """Second derivative of the range by the target's position along z, twice, 1/m."""


def range_hessian(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeHessian:
    """Second derivatives of the range by the position.

        (I - u u')/f, u = r/f, r = target - station, f = |r|.
        Of the range rate these are the second derivatives by a position and a velocity; by two
        velocities these are 0. Each time that the station's is taken for the target's the sign
        changes

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_D_xx: second derivative of the range by the target's position along x, twice, 1/m.
        Relative error at most 8.76 * 2^-52 (float64), 8.76 * 2^-23 (float32), proved for every
        input, and 2e-302 (float64) and 5e-38 (float32) beside it where a product underflows.
    range_D_xy: second derivative of the range by the target's position along x and y, 1/m. Relative
        error at most 8.26 * 2^-52 (float64), 8.26 * 2^-23 (float32), proved for every input, and
        8e-303 (float64) and 3e-38 (float32) beside it where a product underflows.
    range_D_xz: second derivative of the range by the target's position along x and z, 1/m. Relative
        error at most 8.26 * 2^-52 (float64), 8.26 * 2^-23 (float32), proved for every input, and
        8e-303 (float64) and 3e-38 (float32) beside it where a product underflows.
    range_D_yy: second derivative of the range by the target's position along y, twice, 1/m.
        Relative error at most 8.76 * 2^-52 (float64), 8.76 * 2^-23 (float32), proved for every
        input, and 2e-302 (float64) and 5e-38 (float32) beside it where a product underflows.
    range_D_yz: second derivative of the range by the target's position along y and z, 1/m. Relative
        error at most 8.26 * 2^-52 (float64), 8.26 * 2^-23 (float32), proved for every input, and
        8e-303 (float64) and 3e-38 (float32) beside it where a product underflows.
    range_D_zz: second derivative of the range by the target's position along z, twice, 1/m.
        Relative error at most 8.76 * 2^-52 (float64), 8.76 * 2^-23 (float32), proved for every
        input, and 2e-302 (float64) and 5e-38 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
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
                RangeHessian,
                _range_hessian_of_numbers(
                    target_x, target_y, target_z, station_x, station_y, station_z
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeHessian(
        *evaluate(
            _RANGE_HESSIAN,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
            workers,
        )
    )


def _range_hessian_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = target_x - station_x
    t7 = target_y - station_y
    t8 = target_z - station_z
    t14 = form.sqrt(((t6 * t6) + (t7 * t7)) + (t8 * t8))
    t15 = t6 / t14
    t16 = t7 / t14
    t17 = t8 / t14
    t18 = t16 * t16
    t19 = t17 * t17
    t25 = t15 * t15
    t30 = (t18 + t19) / t14
    t31 = -(t15 * t16) / t14
    t32 = -(t15 * t17) / t14
    t33 = (t25 + t19) / t14
    t34 = -(t16 * t17) / t14
    t35 = (t25 + t18) / t14
    if not t14 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t30, t31, t32, t33, t34, t35)


def _range_hessian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    range_D_xx, range_D_xy, range_D_xz, range_D_yy, range_D_yz, range_D_zz = out
    w0, w1, w2, w3, w4, w5 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t9 = square(place_x, w3)
    t10 = square(place_y, w4)
    t11 = square(place_z, w5)
    t12 = add(t9, t10, w3)
    t13 = add(t12, t11, w3)
    slant_range = sqrt(t13, range_D_zz)
    t15 = divide(place_x, slant_range, range_D_xx)
    t16 = divide(place_y, slant_range, range_D_xy)
    t17 = divide(place_z, slant_range, range_D_xz)
    t18 = square(t16, w0)
    t19 = square(t17, w1)
    t20 = add(t18, t19, w2)
    t21 = multiply(t15, t16, w3)
    t22 = negative(t21, w3)
    t23 = multiply(t15, t17, w4)
    t24 = negative(t23, w4)
    t25 = square(t15, range_D_xx)
    t26 = add(t25, t19, w1)
    t27 = multiply(t16, t17, range_D_xy)
    t28 = negative(t27, w5)
    t29 = add(t25, t18, w0)
    divide(t20, slant_range, range_D_xx)
    divide(t22, slant_range, range_D_xy)
    divide(t24, slant_range, range_D_xz)
    divide(t26, slant_range, range_D_yy)
    divide(t28, slant_range, range_D_yz)
    divide(t29, slant_range, range_D_zz)


def _range_hessian_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t9 = square(place_x, w0)
    t10 = square(place_y, w1)
    t11 = square(place_z, w2)
    t12 = add(t9, t10, w0)
    t13 = add(t12, t11, w0)
    sqrt(t13, slant_range)


_RANGE_HESSIAN = Signature(
    "range_hessian",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
    ),
    ("range_D_xx", "range_D_xy", "range_D_xz", "range_D_yy", "range_D_yz", "range_D_zz"),
    6,
    _range_hessian_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _range_hessian_slant_range_block,
            (0, 3),
        ),
    ),
    numbers=_range_hessian_of_numbers,
)


class RangeRateHessian(NamedTuple):
    """Result of `range_rate_hessian`."""

    range_rate_D_xx: Real
    """Second derivative of the range rate by the target's position along x, twice, 1/(m s)."""
    range_rate_D_xy: Real
    """Second derivative of the range rate by the target's position along x and y, 1/(m s)."""
    range_rate_D_xz: Real
    """Second derivative of the range rate by the target's position along x and z, 1/(m s)."""
    range_rate_D_yy: Real
    """Second derivative of the range rate by the target's position along y, twice, 1/(m s)."""
    range_rate_D_yz: Real
    """Second derivative of the range rate by the target's position along y and z, 1/(m s)."""
    range_rate_D_zz: Real
    """Second derivative of the range rate by the target's position along z, twice, 1/(m s)."""


def range_rate_hessian(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    target_velocity_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    station_velocity_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeRateHessian:
    """Second derivatives of the range rate by the position.

        -(u h' + h u' + (g/f) (I - u u'))/f, g = u'w, h = (w - g u)/f,
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity;
        by position and velocity see `range_hessian`, by two velocities it is 0. The terms of an
        entry add up to at most 5 |w|/f^2

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_z: velocity of the target along z, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_z: velocity of the station along z, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_rate_D_xx: second derivative of the range rate by the target's position along x, twice,
        1/(m s). Error over the sum of its terms taken positive at most 16.76 * 2^-52 (float64),
        16.76 * 2^-23 (float32), proved for every input, and 3e-221 (float64) and 7e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 9e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 6e-207 (float64) and 4e-16 (float32)
        apart; what cancels: target_velocity_x - station_velocity_x - (... + ...*(target_velocity_z
        - station_velocity_z))*(target_x - station_x)/....
    range_rate_D_xy: second derivative of the range rate by the target's position along x and y,
        1/(m s). Error over the sum of its terms taken positive at most 17.26 * 2^-52 (float64),
        17.26 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 5e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 9e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 5e-207 (float64) and 3e-16 (float32)
        apart; what cancels: (target_x - station_x)/...*... + (target_y - station_y)/...*... + ....
    range_rate_D_xz: second derivative of the range rate by the target's position along x and z,
        1/(m s). Error over the sum of its terms taken positive at most 17.26 * 2^-52 (float64),
        17.26 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 5e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 9e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 5e-207 (float64) and 3e-16 (float32)
        apart; what cancels: (target_x - station_x)/...*... + (target_z - station_z)/...*... + ....
    range_rate_D_yy: second derivative of the range rate by the target's position along y, twice,
        1/(m s). Error over the sum of its terms taken positive at most 16.76 * 2^-52 (float64),
        16.76 * 2^-23 (float32), proved for every input, and 3e-221 (float64) and 7e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 9e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 6e-207 (float64) and 4e-16 (float32)
        apart; what cancels: target_velocity_y - station_velocity_y - (... + ...*(target_velocity_z
        - station_velocity_z))*(target_y - station_y)/....
    range_rate_D_yz: second derivative of the range rate by the target's position along y and z,
        1/(m s). Error over the sum of its terms taken positive at most 17.26 * 2^-52 (float64),
        17.26 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 5e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 9e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 5e-207 (float64) and 3e-16 (float32)
        apart; what cancels: target_velocity_z - station_velocity_z - (... + ...*(target_velocity_z
        - station_velocity_z))*(target_z - station_z)/....
    range_rate_D_zz: second derivative of the range rate by the target's position along z, twice,
        1/(m s). Error over the sum of its terms taken positive at most 16.76 * 2^-52 (float64),
        16.76 * 2^-23 (float32), proved for every input, and 3e-221 (float64) and 7e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 9e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 6e-207 (float64) and 4e-16 (float32)
        apart; what cancels: target_velocity_z - station_velocity_z - (... + ...*(target_velocity_z
        - station_velocity_z))*(target_z - station_z)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(target_velocity_z) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_z) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and type(station_velocity_z) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= target_velocity_z <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_z <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and -1e60 <= station_velocity_z <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeRateHessian,
                _range_rate_hessian_of_numbers(
                    target_x,
                    target_y,
                    target_z,
                    target_velocity_x,
                    target_velocity_y,
                    target_velocity_z,
                    station_x,
                    station_y,
                    station_z,
                    station_velocity_x,
                    station_velocity_y,
                    station_velocity_z,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeRateHessian(
        *evaluate(
            _RANGE_RATE_HESSIAN,
            (
                target_x,
                target_y,
                target_z,
                target_velocity_x,
                target_velocity_y,
                target_velocity_z,
                station_x,
                station_y,
                station_z,
                station_velocity_x,
                station_velocity_y,
                station_velocity_z,
            ),
            out,
            workers,
        )
    )


def _range_rate_hessian_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    target_velocity_x: float,
    target_velocity_y: float,
    target_velocity_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    station_velocity_x: float,
    station_velocity_y: float,
    station_velocity_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t12 = target_x - station_x
    t13 = target_y - station_y
    t14 = target_z - station_z
    t15 = target_velocity_x - station_velocity_x
    t16 = target_velocity_y - station_velocity_y
    t17 = target_velocity_z - station_velocity_z
    t22 = ((t12 * t12) + (t13 * t13)) + (t14 * t14)
    t23 = form.sqrt(t22)
    t24 = t12 / t23
    t25 = t13 / t23
    t26 = t14 / t23
    t31 = ((t24 * t15) + (t25 * t16)) + (t26 * t17)
    t34 = (t15 - (t31 * t24)) / t23
    t37 = (t16 - (t31 * t25)) / t23
    t40 = (t17 - (t31 * t26)) / t23
    t41 = t31 / t23
    t42 = t25 * t25
    t43 = t26 * t26
    t49 = t24 * t24
    t58 = ((t24 * t34) * 2.0) + (t41 * (t42 + t43))
    t65 = ((t24 * t37) + (t25 * t34)) + (t41 * -(t24 * t25))
    t72 = ((t24 * t40) + (t26 * t34)) + (t41 * -(t24 * t26))
    t78 = ((t25 * t37) * 2.0) + (t41 * (t49 + t43))
    t85 = ((t25 * t40) + (t26 * t37)) + (t41 * -(t25 * t26))
    t91 = ((t26 * t40) * 2.0) + (t41 * (t49 + t42))
    t60 = -t58 / t23
    t67 = -t65 / t23
    t74 = -t72 / t23
    t80 = -t78 / t23
    t87 = -t85 / t23
    t93 = -t91 / t23
    if not t23 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t60, t67, t74, t80, t87, t93)


def _range_rate_hessian_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 2.0
) -> None:
    (
        target_x,
        target_y,
        target_z,
        target_velocity_x,
        target_velocity_y,
        target_velocity_z,
        station_x,
        station_y,
        station_z,
        station_velocity_x,
        station_velocity_y,
        station_velocity_z,
    ) = given
    (
        range_rate_D_xx,
        range_rate_D_xy,
        range_rate_D_xz,
        range_rate_D_yy,
        range_rate_D_yz,
        range_rate_D_zz,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w3)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w4)
    velocity_z = subtract(target_velocity_z, station_velocity_z, w5)
    t18 = square(place_x, w6)
    t19 = square(place_y, w7)
    t20 = square(place_z, w8)
    t21 = add(t18, t19, w6)
    t22 = add(t21, t20, w6)
    slant_range = sqrt(t22, range_rate_D_zz)
    t24 = divide(place_x, slant_range, range_rate_D_xx)
    t25 = divide(place_y, slant_range, range_rate_D_xy)
    t26 = divide(place_z, slant_range, range_rate_D_xz)
    t27 = multiply(t24, velocity_x, w0)
    t28 = multiply(t25, velocity_y, w1)
    t29 = multiply(t26, velocity_z, w2)
    t30 = add(t27, t28, w0)
    range_rate = add(t30, t29, w0)
    t32 = multiply(range_rate, t24, w1)
    t33 = subtract(velocity_x, t32, w3)
    turning_x = divide(t33, slant_range, range_rate_D_yy)
    t35 = multiply(range_rate, t25, w1)
    t36 = subtract(velocity_y, t35, w4)
    turning_y = divide(t36, slant_range, range_rate_D_yz)
    t38 = multiply(range_rate, t26, w1)
    t39 = subtract(velocity_z, t38, w5)
    turning_z = divide(t39, slant_range, w5)
    t41 = divide(range_rate, slant_range, w0)
    t42 = square(t25, w1)
    t43 = square(t26, w2)
    t44 = add(t42, t43, w3)
    t45 = multiply(t24, t25, w4)
    t46 = negative(t45, w4)
    t47 = multiply(t24, t26, w6)
    t48 = negative(t47, w6)
    t49 = square(t24, w7)
    t50 = add(t49, t43, w2)
    t51 = multiply(t25, t26, w8)
    t52 = negative(t51, w8)
    t53 = add(t49, t42, w7)
    t54 = multiply(t24, turning_x, w1)
    t56 = multiply(t54, n0, w1)
    t57 = multiply(t41, t44, w3)
    t58 = add(t56, t57, w1)
    t59 = negative(t58, w1)
    t61 = multiply(t24, turning_y, w3)
    t62 = multiply(t25, turning_x, w9)
    t63 = add(t61, t62, w3)
    t64 = multiply(t41, t46, w4)
    t65 = add(t63, t64, w3)
    t66 = negative(t65, w3)
    t68 = multiply(t24, turning_z, range_rate_D_xx)
    t69 = multiply(t26, turning_x, range_rate_D_yy)
    t70 = add(t68, t69, range_rate_D_xx)
    t71 = multiply(t41, t48, w6)
    t72 = add(t70, t71, range_rate_D_xx)
    t73 = negative(t72, w4)
    t75 = multiply(t25, turning_y, w6)
    t76 = multiply(t75, n0, w6)
    t77 = multiply(t41, t50, w2)
    t78 = add(t76, t77, w6)
    t79 = negative(t78, w6)
    t81 = multiply(t25, turning_z, range_rate_D_xy)
    t82 = multiply(t26, turning_y, range_rate_D_yz)
    t83 = add(t81, t82, range_rate_D_xy)
    t84 = multiply(t41, t52, w8)
    t85 = add(t83, t84, range_rate_D_xy)
    t86 = negative(t85, w2)
    t88 = multiply(t26, turning_z, range_rate_D_xz)
    t89 = multiply(t88, n0, range_rate_D_xz)
    t90 = multiply(t41, t53, w0)
    t91 = add(t89, t90, range_rate_D_xz)
    t92 = negative(t91, w0)
    divide(t59, slant_range, range_rate_D_xx)
    divide(t66, slant_range, range_rate_D_xy)
    divide(t73, slant_range, range_rate_D_xz)
    divide(t79, slant_range, range_rate_D_yy)
    divide(t86, slant_range, range_rate_D_yz)
    divide(t92, slant_range, range_rate_D_zz)


def _range_rate_hessian_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        station_x,
        station_y,
        station_z,
        _station_velocity_x,
        _station_velocity_y,
        _station_velocity_z,
    ) = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t18 = square(place_x, w0)
    t19 = square(place_y, w1)
    t20 = square(place_z, w2)
    t21 = add(t18, t19, w0)
    t22 = add(t21, t20, w0)
    sqrt(t22, slant_range)


_RANGE_RATE_HESSIAN = Signature(
    "range_rate_hessian",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _TARGET_VELOCITY_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
        _STATION_VELOCITY_Z_DOMAIN,
    ),
    (
        "range_rate_D_xx",
        "range_rate_D_xy",
        "range_rate_D_xz",
        "range_rate_D_yy",
        "range_rate_D_yz",
        "range_rate_D_zz",
    ),
    10,
    _range_rate_hessian_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _range_rate_hessian_slant_range_block,
            (0, 6),
        ),
    ),
    numbers=_range_rate_hessian_of_numbers,
)


class DopplerShift(NamedTuple):
    """Result of `doppler_shift`."""

    doppler_shift: Real
    """Received less sent frequency, Hz, below 0 where the target goes away."""
    doppler_shift_D_x: Real
    """Derivative of the shift by the target's position along x, Hz/m."""
    doppler_shift_D_y: Real
    """Derivative of the shift by the target's position along y, Hz/m."""
    doppler_shift_D_z: Real
    """Derivative of the shift by the target's position along z, Hz/m."""
    doppler_shift_D_velocity_x: Real
    """Derivative of the shift by the target's velocity along x, Hz s/m."""
    doppler_shift_D_velocity_y: Real
    """Derivative of the shift by the target's velocity along y, Hz s/m."""
    doppler_shift_D_velocity_z: Real
    """Derivative of the shift by the target's velocity along z, Hz s/m."""


def doppler_shift(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    target_velocity_z: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_z: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    station_velocity_z: ArrayLike,
    carrier_frequency: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> DopplerShift:
    """Doppler shift of a carrier that the target sends, with its derivatives.

        -(fc/c) g and its derivatives -(fc/c) h, -(fc/c) u, c = 299792458 m/s, g = u'w,
        h = (w - g u)/f;
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        This is the narrow-band shift of one way, of first order in speeds over c: at a station
        at rest the classical one is fc/(1 + g/c) - fc, fc g^2/(c (c + g)) above it. An echo has
        twice the shift

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_z: velocity of the target along z, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_z: position of the station along z, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_z: velocity of the station along z, m/s; of magnitude at most 1e60, in float32
        1e9.
    carrier_frequency: frequency of the carrier, Hz; a number at least 1e-10 and at most 1e30, in
        float32 at least 1e-3 and at most 1e15.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    doppler_shift: received less sent frequency, Hz, below 0 where the target goes away. Error over
        the sum of its terms taken positive at most 5.76 * 2^-52 (float64), 6.26 * 2^-23 (float32),
        proved for every input, and 6e-241 (float64) and 2e-28 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 3e-7 in float64 and 0.01 in float32 of what its error
        is relative to; values below 4e-226 (float64) and 2e-22 (float32) apart.
    doppler_shift_D_x: derivative of the shift by the target's position along x, Hz/m. Error over
        the sum of its terms taken positive at most 11.76 * 2^-52 (float64), 12.26 * 2^-23
        (float32), proved for every input, and 2e-220 (float64) and 3e-22 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 4e-206 (float64) and 2e-16 (float32) apart; what
        cancels: target_velocity_x - station_velocity_x - (... + ...*(target_velocity_z -
        station_velocity_z))*(target_x - station_x)/....
    doppler_shift_D_y: derivative of the shift by the target's position along y, Hz/m. Error over
        the sum of its terms taken positive at most 11.76 * 2^-52 (float64), 12.26 * 2^-23
        (float32), proved for every input, and 2e-220 (float64) and 3e-22 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 4e-206 (float64) and 2e-16 (float32) apart; what
        cancels: target_velocity_y - station_velocity_y - (... + ...*(target_velocity_z -
        station_velocity_z))*(target_y - station_y)/....
    doppler_shift_D_z: derivative of the shift by the target's position along z, Hz/m. Error over
        the sum of its terms taken positive at most 11.76 * 2^-52 (float64), 12.26 * 2^-23
        (float32), proved for every input, and 2e-220 (float64) and 3e-22 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 4e-206 (float64) and 2e-16 (float32) apart; what
        cancels: target_velocity_z - station_velocity_z - (... + ...*(target_velocity_z -
        station_velocity_z))*(target_z - station_z)/....
    doppler_shift_D_velocity_x: derivative of the shift by the target's velocity along x, Hz s/m.
        Relative error at most 3.76 * 2^-52 (float64), 4.26 * 2^-23 (float32), proved for every
        input, and 9e-302 (float64) and 3e-38 (float32) beside it where a product underflows.
    doppler_shift_D_velocity_y: derivative of the shift by the target's velocity along y, Hz s/m.
        Relative error at most 3.76 * 2^-52 (float64), 4.26 * 2^-23 (float32), proved for every
        input, and 9e-302 (float64) and 3e-38 (float32) beside it where a product underflows.
    doppler_shift_D_velocity_z: derivative of the shift by the target's velocity along z, Hz s/m.
        Relative error at most 3.76 * 2^-52 (float64), 4.26 * 2^-23 (float32), proved for every
        input, and 9e-302 (float64) and 3e-38 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(target_velocity_z) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_z) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and type(station_velocity_z) is float
        and type(carrier_frequency) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= target_velocity_z <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_z <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and -1e60 <= station_velocity_z <= 1e60
        and 1e-10 <= carrier_frequency <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                DopplerShift,
                _doppler_shift_of_numbers(
                    target_x,
                    target_y,
                    target_z,
                    target_velocity_x,
                    target_velocity_y,
                    target_velocity_z,
                    station_x,
                    station_y,
                    station_z,
                    station_velocity_x,
                    station_velocity_y,
                    station_velocity_z,
                    carrier_frequency,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return DopplerShift(
        *evaluate(
            _DOPPLER_SHIFT,
            (
                target_x,
                target_y,
                target_z,
                target_velocity_x,
                target_velocity_y,
                target_velocity_z,
                station_x,
                station_y,
                station_z,
                station_velocity_x,
                station_velocity_y,
                station_velocity_z,
                carrier_frequency,
            ),
            out,
            workers,
        )
    )


def _doppler_shift_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    target_velocity_x: float,
    target_velocity_y: float,
    target_velocity_z: float,
    station_x: float,
    station_y: float,
    station_z: float,
    station_velocity_x: float,
    station_velocity_y: float,
    station_velocity_z: float,
    carrier_frequency: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t12 = target_x - station_x
    t13 = target_y - station_y
    t14 = target_z - station_z
    t15 = target_velocity_x - station_velocity_x
    t16 = target_velocity_y - station_velocity_y
    t17 = target_velocity_z - station_velocity_z
    t22 = ((t12 * t12) + (t13 * t13)) + (t14 * t14)
    t23 = form.sqrt(t22)
    t24 = t12 / t23
    t25 = t13 / t23
    t26 = t14 / t23
    t30 = -(carrier_frequency / 299792458.0)
    t35 = ((t24 * t15) + (t25 * t16)) + (t26 * t17)
    t36 = t35 * t30
    t46 = ((t15 - (t35 * t24)) / t23) * t30
    t47 = ((t16 - (t35 * t25)) / t23) * t30
    t48 = ((t17 - (t35 * t26)) / t23) * t30
    t49 = t24 * t30
    t50 = t25 * t30
    t51 = t26 * t30
    if not t23 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t36, t46, t47, t48, t49, t50, t51)


def _doppler_shift_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 299792458.0
) -> None:
    (
        target_x,
        target_y,
        target_z,
        target_velocity_x,
        target_velocity_y,
        target_velocity_z,
        station_x,
        station_y,
        station_z,
        station_velocity_x,
        station_velocity_y,
        station_velocity_z,
        carrier_frequency,
    ) = given
    (
        doppler_shift,
        doppler_shift_D_x,
        doppler_shift_D_y,
        doppler_shift_D_z,
        doppler_shift_D_velocity_x,
        doppler_shift_D_velocity_y,
        doppler_shift_D_velocity_z,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w3)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w4)
    velocity_z = subtract(target_velocity_z, station_velocity_z, w5)
    t18 = square(place_x, w6)
    t19 = square(place_y, w7)
    t20 = square(place_z, w8)
    t21 = add(t18, t19, w6)
    t22 = add(t21, t20, w6)
    slant_range = sqrt(t22, doppler_shift)
    t24 = divide(place_x, slant_range, doppler_shift_D_velocity_x)
    t25 = divide(place_y, slant_range, doppler_shift_D_velocity_y)
    t26 = divide(place_z, slant_range, doppler_shift_D_velocity_z)
    t29 = divide(carrier_frequency, n0, doppler_shift_D_x)
    t30 = negative(t29, w0)
    t31 = multiply(t24, velocity_x, w1)
    t32 = multiply(t25, velocity_y, w2)
    t33 = multiply(t26, velocity_z, w6)
    t34 = add(t31, t32, w1)
    range_rate = add(t34, t33, w1)
    t37 = multiply(range_rate, t24, w2)
    t38 = subtract(velocity_x, t37, w3)
    turning_x = divide(t38, slant_range, doppler_shift_D_y)
    t40 = multiply(range_rate, t25, w2)
    t41 = subtract(velocity_y, t40, w4)
    turning_y = divide(t41, slant_range, doppler_shift_D_z)
    t43 = multiply(range_rate, t26, w2)
    t44 = subtract(velocity_z, t43, w5)
    turning_z = divide(t44, slant_range, w5)
    multiply(range_rate, t30, doppler_shift)
    multiply(turning_x, t30, doppler_shift_D_x)
    multiply(turning_y, t30, doppler_shift_D_y)
    multiply(turning_z, t30, doppler_shift_D_z)
    multiply(t24, t30, doppler_shift_D_velocity_x)
    multiply(t25, t30, doppler_shift_D_velocity_y)
    multiply(t26, t30, doppler_shift_D_velocity_z)


def _doppler_shift_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        station_x,
        station_y,
        station_z,
        _station_velocity_x,
        _station_velocity_y,
        _station_velocity_z,
        _carrier_frequency,
    ) = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    place_z = subtract(target_z, station_z, w2)
    t18 = square(place_x, w0)
    t19 = square(place_y, w1)
    t20 = square(place_z, w2)
    t21 = add(t18, t19, w0)
    t22 = add(t21, t20, w0)
    sqrt(t22, slant_range)


_DOPPLER_SHIFT = Signature(
    "doppler_shift",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _TARGET_VELOCITY_Z_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_Z_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
        _STATION_VELOCITY_Z_DOMAIN,
        _CARRIER_FREQUENCY_DOMAIN,
    ),
    (
        "doppler_shift",
        "doppler_shift_D_x",
        "doppler_shift_D_y",
        "doppler_shift_D_z",
        "doppler_shift_D_velocity_x",
        "doppler_shift_D_velocity_y",
        "doppler_shift_D_velocity_z",
    ),
    9,
    _doppler_shift_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _doppler_shift_slant_range_block,
            (0, 6),
        ),
    ),
    numbers=_doppler_shift_of_numbers,
)


class SlantRangeInPlane(NamedTuple):
    """Result of `slant_range_in_plane`."""

    slant_range: Real
    """Distance of the target from the station, m."""


def slant_range_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    *,
    out: tuple[Real] | None = None,
    workers: int = 1,
) -> SlantRangeInPlane:
    """Distance of targets from stations in the plane.

        r = target - station, f = |r|

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    slant_range: distance of the target from the station, m. Relative error at most 1.51 * 2^-52
        (float64), 1.51 * 2^-23 (float32), proved for every input.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
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
                SlantRangeInPlane,
                _slant_range_in_plane_of_numbers(target_x, target_y, station_x, station_y),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return SlantRangeInPlane(
        *evaluate(_SLANT_RANGE_IN_PLANE, (target_x, target_y, station_x, station_y), out, workers)
    )


def _slant_range_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    station_x: float,
    station_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = target_x - station_x
    t5 = target_y - station_y
    t9 = form.sqrt((t4 * t4) + (t5 * t5))
    if not t9 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t9,)


def _slant_range_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t6 = square(place_x, w0)
    t7 = square(place_y, w1)
    t8 = add(t6, t7, w0)
    sqrt(t8, slant_range)


def _slant_range_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t6 = square(place_x, w0)
    t7 = square(place_y, w1)
    t8 = add(t6, t7, w0)
    sqrt(t8, slant_range)


_SLANT_RANGE_IN_PLANE = Signature(
    "slant_range_in_plane",
    (_TARGET_X_DOMAIN, _TARGET_Y_DOMAIN, _STATION_X_DOMAIN, _STATION_Y_DOMAIN),
    ("slant_range",),
    2,
    _slant_range_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _slant_range_in_plane_slant_range_block,
            (0, 2),
        ),
    ),
    numbers=_slant_range_in_plane_of_numbers,
)


class RangeJacobianInPlane(NamedTuple):
    """Result of `range_jacobian_in_plane`."""

    range_D_x: Real
    """Derivative of the range by the target's position along x, dimensionless."""
    range_D_y: Real
    """Derivative of the range by the target's position along y, dimensionless."""


def range_jacobian_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> RangeJacobianInPlane:
    """Derivative of the range: the unit vector from station to target in the plane.

        u = r/f, r = target - station, f = |r|.
        By the station's position the derivative is -u

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_D_x: derivative of the range by the target's position along x, dimensionless. Relative
        error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_D_y: derivative of the range by the target's position along y, dimensionless. Relative
        error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
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
                RangeJacobianInPlane,
                _range_jacobian_in_plane_of_numbers(target_x, target_y, station_x, station_y),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeJacobianInPlane(
        *evaluate(
            _RANGE_JACOBIAN_IN_PLANE,
            (target_x, target_y, station_x, station_y),
            out,
            workers,
        )
    )


def _range_jacobian_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    station_x: float,
    station_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = target_x - station_x
    t5 = target_y - station_y
    t9 = form.sqrt((t4 * t4) + (t5 * t5))
    t10 = t4 / t9
    t11 = t5 / t9
    if not t9 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t10, t11)


def _range_jacobian_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    range_D_x, range_D_y = out
    w0, w1, w2, w3 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t6 = square(place_x, w2)
    t7 = square(place_y, w3)
    t8 = add(t6, t7, w2)
    slant_range = sqrt(t8, range_D_y)
    divide(place_x, slant_range, range_D_x)
    divide(place_y, slant_range, range_D_y)


def _range_jacobian_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t6 = square(place_x, w0)
    t7 = square(place_y, w1)
    t8 = add(t6, t7, w0)
    sqrt(t8, slant_range)


_RANGE_JACOBIAN_IN_PLANE = Signature(
    "range_jacobian_in_plane",
    (_TARGET_X_DOMAIN, _TARGET_Y_DOMAIN, _STATION_X_DOMAIN, _STATION_Y_DOMAIN),
    ("range_D_x", "range_D_y"),
    4,
    _range_jacobian_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _range_jacobian_in_plane_slant_range_block,
            (0, 2),
        ),
    ),
    numbers=_range_jacobian_in_plane_of_numbers,
)


class RangeRateInPlane(NamedTuple):
    """Result of `range_rate_in_plane`."""

    range_rate: Real
    """Its rate, m/s, above 0 where the target goes away."""


def range_rate_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    *,
    out: tuple[Real] | None = None,
    workers: int = 1,
) -> RangeRateInPlane:
    """Range rate of moving targets from moving stations in the plane.

        g = u'w, r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        The terms of g, |u_i w_i|, add up to at most |w|

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_rate: its rate, m/s, above 0 where the target goes away. Error over the sum of its terms
        taken positive at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every
        input, and 1e-262 (float64) and 3e-35 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 3e-7 in float64 and 0.007 in float32 of what its error is relative to;
        values below 2e-247 (float64) and 6e-29 (float32) apart; what cancels: (target_x -
        station_x)/sqrt((target_x - station_x)**2 + (target_y - station_y)**2)*(target_velocity_x -
        station_velocity_x) + (target_y - station_y)/sqrt((target_x - station_x)**2 + (target_y -
        station_y)**2)*(target_velocity_y - station_velocity_y).

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeRateInPlane,
                _range_rate_in_plane_of_numbers(
                    target_x,
                    target_y,
                    target_velocity_x,
                    target_velocity_y,
                    station_x,
                    station_y,
                    station_velocity_x,
                    station_velocity_y,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeRateInPlane(
        *evaluate(
            _RANGE_RATE_IN_PLANE,
            (
                target_x,
                target_y,
                target_velocity_x,
                target_velocity_y,
                station_x,
                station_y,
                station_velocity_x,
                station_velocity_y,
            ),
            out,
            workers,
        )
    )


def _range_rate_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    target_velocity_x: float,
    target_velocity_y: float,
    station_x: float,
    station_y: float,
    station_velocity_x: float,
    station_velocity_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t8 = target_x - station_x
    t9 = target_y - station_y
    t10 = target_velocity_x - station_velocity_x
    t11 = target_velocity_y - station_velocity_y
    t15 = form.sqrt((t8 * t8) + (t9 * t9))
    t20 = ((t8 / t15) * t10) + ((t9 / t15) * t11)
    if not t15 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t20,)


def _range_rate_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        target_x,
        target_y,
        target_velocity_x,
        target_velocity_y,
        station_x,
        station_y,
        station_velocity_x,
        station_velocity_y,
    ) = given
    (range_rate,) = out
    w0, w1, w2, w3, w4, w5 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w2)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w3)
    t12 = square(place_x, w4)
    t13 = square(place_y, w5)
    t14 = add(t12, t13, w4)
    slant_range = sqrt(t14, range_rate)
    t17 = divide(place_y, slant_range, w1)
    t19 = multiply(t17, velocity_y, w1)
    t16 = divide(place_x, slant_range, range_rate)
    t18 = multiply(t16, velocity_x, range_rate)
    add(t18, t19, range_rate)


def _range_rate_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        station_x,
        station_y,
        _station_velocity_x,
        _station_velocity_y,
    ) = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t12 = square(place_x, w0)
    t13 = square(place_y, w1)
    t14 = add(t12, t13, w0)
    sqrt(t14, slant_range)


_RANGE_RATE_IN_PLANE = Signature(
    "range_rate_in_plane",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
    ),
    ("range_rate",),
    6,
    _range_rate_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _range_rate_in_plane_slant_range_block,
            (0, 4),
        ),
    ),
    numbers=_range_rate_in_plane_of_numbers,
)


class RangeRateJacobianInPlane(NamedTuple):
    """Result of `range_rate_jacobian_in_plane`."""

    range_rate_D_x: Real
    """Derivative of the range rate by the target's position along x, 1/s."""
    range_rate_D_y: Real
    """Derivative of the range rate by the target's position along y, 1/s."""
    range_rate_D_velocity_x: Real
    """Derivative of the range rate by the target's velocity along x, dimensionless."""
    range_rate_D_velocity_y: Real
    """Derivative of the range rate by the target's velocity along y, dimensionless."""


def range_rate_jacobian_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeRateJacobianInPlane:
    """Derivative of the range rate by position and velocity in the plane.

        by the position h = (w - g u)/f with g = u'w, by the velocity u;
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        By the station's position and velocity the derivatives are these with the other sign.
        The terms of h add up to at most 2 |w|/f: where the target moves nearly along the line of
        sight, w and g u nearly agree, and h has lost as many digits as |w| is larger than |h| f

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_rate_D_x: derivative of the range rate by the target's position along x, 1/s. Error over
        the sum of its terms taken positive at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32),
        proved for every input, and 3e-242 (float64) and 6e-29 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 5e-7 in float64 and 0.02 in float32 of what its error
        is relative to; values below 1e-227 (float64) and 6e-23 (float32) apart; what cancels:
        target_velocity_x - station_velocity_x - ...*(target_x - station_x)/....
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32),
        proved for every input, and 3e-242 (float64) and 6e-29 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 5e-7 in float64 and 0.02 in float32 of what its error
        is relative to; values below 1e-227 (float64) and 6e-23 (float32) apart; what cancels:
        target_velocity_y - station_velocity_y - ...*(target_y - station_y)/....
    range_rate_D_velocity_x: derivative of the range rate by the target's velocity along x,
        dimensionless. Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved
        for every input, and 3e-323 (float64) and 8e-45 (float32) beside it where a product
        underflows.
    range_rate_D_velocity_y: derivative of the range rate by the target's velocity along y,
        dimensionless. Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved
        for every input, and 3e-323 (float64) and 8e-45 (float32) beside it where a product
        underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeRateJacobianInPlane,
                _range_rate_jacobian_in_plane_of_numbers(
                    target_x,
                    target_y,
                    target_velocity_x,
                    target_velocity_y,
                    station_x,
                    station_y,
                    station_velocity_x,
                    station_velocity_y,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeRateJacobianInPlane(
        *evaluate(
            _RANGE_RATE_JACOBIAN_IN_PLANE,
            (
                target_x,
                target_y,
                target_velocity_x,
                target_velocity_y,
                station_x,
                station_y,
                station_velocity_x,
                station_velocity_y,
            ),
            out,
            workers,
        )
    )


def _range_rate_jacobian_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    target_velocity_x: float,
    target_velocity_y: float,
    station_x: float,
    station_y: float,
    station_velocity_x: float,
    station_velocity_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t8 = target_x - station_x
    t9 = target_y - station_y
    t10 = target_velocity_x - station_velocity_x
    t11 = target_velocity_y - station_velocity_y
    t15 = form.sqrt((t8 * t8) + (t9 * t9))
    t16 = t8 / t15
    t17 = t9 / t15
    t20 = (t16 * t10) + (t17 * t11)
    t23 = (t10 - (t20 * t16)) / t15
    t26 = (t11 - (t20 * t17)) / t15
    if not t15 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t23, t26, t16, t17)


def _range_rate_jacobian_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_velocity_x,
        target_velocity_y,
        station_x,
        station_y,
        station_velocity_x,
        station_velocity_y,
    ) = given
    range_rate_D_x, range_rate_D_y, range_rate_D_velocity_x, range_rate_D_velocity_y = out
    w0, w1, w2, w3, w4, w5 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w2)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w3)
    t12 = square(place_x, w4)
    t13 = square(place_y, w5)
    t14 = add(t12, t13, w4)
    slant_range = sqrt(t14, range_rate_D_y)
    divide(place_x, slant_range, range_rate_D_velocity_x)
    divide(place_y, slant_range, range_rate_D_velocity_y)
    t18 = multiply(range_rate_D_velocity_x, velocity_x, w0)
    t19 = multiply(range_rate_D_velocity_y, velocity_y, w1)
    range_rate = add(t18, t19, w0)
    t21 = multiply(range_rate, range_rate_D_velocity_x, w1)
    t22 = subtract(velocity_x, t21, w2)
    t24 = multiply(range_rate, range_rate_D_velocity_y, w0)
    t25 = subtract(velocity_y, t24, w3)
    divide(t22, slant_range, range_rate_D_x)
    divide(t25, slant_range, range_rate_D_y)


def _range_rate_jacobian_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        station_x,
        station_y,
        _station_velocity_x,
        _station_velocity_y,
    ) = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t12 = square(place_x, w0)
    t13 = square(place_y, w1)
    t14 = add(t12, t13, w0)
    sqrt(t14, slant_range)


_RANGE_RATE_JACOBIAN_IN_PLANE = Signature(
    "range_rate_jacobian_in_plane",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
    ),
    ("range_rate_D_x", "range_rate_D_y", "range_rate_D_velocity_x", "range_rate_D_velocity_y"),
    6,
    _range_rate_jacobian_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _range_rate_jacobian_in_plane_slant_range_block,
            (0, 4),
        ),
    ),
    numbers=_range_rate_jacobian_in_plane_of_numbers,
)


class RangeDopplerInPlane(NamedTuple):
    """Result of `range_doppler_in_plane`."""

    slant_range: Real
    """Distance of the target from the station, m."""
    range_rate: Real
    """Its rate, m/s, above 0 where the target goes away."""
    range_D_x: Real
    """Derivative of the range by the target's position along x, dimensionless."""
    range_D_y: Real
    """Derivative of the range by the target's position along y, dimensionless."""
    range_rate_D_x: Real
    """Derivative of the range rate by the target's position along x, 1/s."""
    range_rate_D_y: Real
    """Derivative of the range rate by the target's position along y, 1/s."""


def range_doppler_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeDopplerInPlane:
    """Range and range rate with their derivatives in the plane.

        f, g = u'w, their derivatives by the position u and h = (w - g u)/f, that of g by the
        velocity, u;
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        By the station's position and velocity the derivatives are these with the other sign.
        The terms of g, |u_i w_i|, add up to at most |w|.
        The terms of h add up to at most 2 |w|/f: where the target moves nearly along the line of
        sight, w and g u nearly agree, and h has lost as many digits as |w| is larger than |h| f

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    slant_range: distance of the target from the station, m. Relative error at most 1.51 * 2^-52
        (float64), 1.51 * 2^-23 (float32), proved for every input.
    range_rate: its rate, m/s, above 0 where the target goes away. Error over the sum of its terms
        taken positive at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every
        input, and 1e-262 (float64) and 3e-35 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 3e-7 in float64 and 0.007 in float32 of what its error is relative to;
        values below 2e-247 (float64) and 6e-29 (float32) apart; what cancels: (target_x -
        station_x)/sqrt((target_x - station_x)**2 + (target_y - station_y)**2)*(target_velocity_x -
        station_velocity_x) + (target_y - station_y)/sqrt((target_x - station_x)**2 + (target_y -
        station_y)**2)*(target_velocity_y - station_velocity_y).
    range_D_x: derivative of the range by the target's position along x, dimensionless. Relative
        error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_D_y: derivative of the range by the target's position along y, dimensionless. Relative
        error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_rate_D_x: derivative of the range rate by the target's position along x, 1/s. Error over
        the sum of its terms taken positive at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32),
        proved for every input, and 3e-242 (float64) and 6e-29 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 5e-7 in float64 and 0.02 in float32 of what its error
        is relative to; values below 1e-227 (float64) and 6e-23 (float32) apart; what cancels:
        target_velocity_x - station_velocity_x - ...*(target_x - station_x)/....
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32),
        proved for every input, and 3e-242 (float64) and 6e-29 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 5e-7 in float64 and 0.02 in float32 of what its error
        is relative to; values below 1e-227 (float64) and 6e-23 (float32) apart; what cancels:
        target_velocity_y - station_velocity_y - ...*(target_y - station_y)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeDopplerInPlane,
                _range_doppler_in_plane_of_numbers(
                    target_x,
                    target_y,
                    target_velocity_x,
                    target_velocity_y,
                    station_x,
                    station_y,
                    station_velocity_x,
                    station_velocity_y,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeDopplerInPlane(
        *evaluate(
            _RANGE_DOPPLER_IN_PLANE,
            (
                target_x,
                target_y,
                target_velocity_x,
                target_velocity_y,
                station_x,
                station_y,
                station_velocity_x,
                station_velocity_y,
            ),
            out,
            workers,
        )
    )


def _range_doppler_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    target_velocity_x: float,
    target_velocity_y: float,
    station_x: float,
    station_y: float,
    station_velocity_x: float,
    station_velocity_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t8 = target_x - station_x
    t9 = target_y - station_y
    t10 = target_velocity_x - station_velocity_x
    t11 = target_velocity_y - station_velocity_y
    t15 = form.sqrt((t8 * t8) + (t9 * t9))
    t16 = t8 / t15
    t17 = t9 / t15
    t20 = (t16 * t10) + (t17 * t11)
    t23 = (t10 - (t20 * t16)) / t15
    t26 = (t11 - (t20 * t17)) / t15
    if not t15 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t15, t20, t16, t17, t23, t26)


def _range_doppler_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        target_x,
        target_y,
        target_velocity_x,
        target_velocity_y,
        station_x,
        station_y,
        station_velocity_x,
        station_velocity_y,
    ) = given
    slant_range, range_rate, range_D_x, range_D_y, range_rate_D_x, range_rate_D_y = out
    w0, w1, w2, w3, w4, w5 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w2)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w3)
    t12 = square(place_x, w4)
    t13 = square(place_y, w5)
    t14 = add(t12, t13, w4)
    sqrt(t14, slant_range)
    divide(place_x, slant_range, range_D_x)
    divide(place_y, slant_range, range_D_y)
    t18 = multiply(range_D_x, velocity_x, w0)
    t19 = multiply(range_D_y, velocity_y, w1)
    add(t18, t19, range_rate)
    t21 = multiply(range_rate, range_D_x, w0)
    t22 = subtract(velocity_x, t21, w2)
    t24 = multiply(range_rate, range_D_y, w0)
    t25 = subtract(velocity_y, t24, w3)
    divide(t22, slant_range, range_rate_D_x)
    divide(t25, slant_range, range_rate_D_y)


def _range_doppler_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        station_x,
        station_y,
        _station_velocity_x,
        _station_velocity_y,
    ) = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t12 = square(place_x, w0)
    t13 = square(place_y, w1)
    t14 = add(t12, t13, w0)
    sqrt(t14, slant_range)


_RANGE_DOPPLER_IN_PLANE = Signature(
    "range_doppler_in_plane",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
    ),
    ("slant_range", "range_rate", "range_D_x", "range_D_y", "range_rate_D_x", "range_rate_D_y"),
    6,
    _range_doppler_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _range_doppler_in_plane_slant_range_block,
            (0, 4),
        ),
    ),
    numbers=_range_doppler_in_plane_of_numbers,
)


class RangeHessianInPlane(NamedTuple):
    """Result of `range_hessian_in_plane`."""

    range_D_xx: Real
    """Second derivative of the range by the target's position along x, twice, 1/m."""
    range_D_xy: Real
    """Second derivative of the range by the target's position along x and y, 1/m."""
    range_D_yy: Real
    """Second derivative of the range by the target's position along y, twice, 1/m."""


def range_hessian_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeHessianInPlane:
    """Second derivatives of the range by the position in the plane.

        (I - u u')/f, u = r/f, r = target - station, f = |r|.
        Of the range rate these are the second derivatives by a position and a velocity; by two
        velocities these are 0. Each time that the station's is taken for the target's the sign
        changes

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_D_xx: second derivative of the range by the target's position along x, twice, 1/m.
        Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for every
        input, and 8e-303 (float64) and 3e-38 (float32) beside it where a product underflows.
    range_D_xy: second derivative of the range by the target's position along x and y, 1/m. Relative
        error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for every input, and
        8e-303 (float64) and 3e-38 (float32) beside it where a product underflows.
    range_D_yy: second derivative of the range by the target's position along y, twice, 1/m.
        Relative error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for every
        input, and 8e-303 (float64) and 3e-38 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
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
                RangeHessianInPlane,
                _range_hessian_in_plane_of_numbers(target_x, target_y, station_x, station_y),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeHessianInPlane(
        *evaluate(_RANGE_HESSIAN_IN_PLANE, (target_x, target_y, station_x, station_y), out, workers)
    )


def _range_hessian_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    station_x: float,
    station_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t4 = target_x - station_x
    t5 = target_y - station_y
    t9 = form.sqrt((t4 * t4) + (t5 * t5))
    t10 = t4 / t9
    t11 = t5 / t9
    t16 = (t11 * t11) / t9
    t17 = -(t10 * t11) / t9
    t18 = (t10 * t10) / t9
    if not t9 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t16, t17, t18)


def _range_hessian_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    range_D_xx, range_D_xy, range_D_yy = out
    w0, w1, w2, w3 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t6 = square(place_x, w2)
    t7 = square(place_y, w3)
    t8 = add(t6, t7, w2)
    slant_range = sqrt(t8, range_D_yy)
    t10 = divide(place_x, slant_range, range_D_xx)
    t11 = divide(place_y, slant_range, range_D_xy)
    t12 = square(t11, w0)
    t13 = multiply(t10, t11, range_D_xy)
    t14 = negative(t13, range_D_xy)
    t15 = square(t10, w1)
    divide(t12, slant_range, range_D_xx)
    divide(t14, slant_range, range_D_xy)
    divide(t15, slant_range, range_D_yy)


def _range_hessian_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t6 = square(place_x, w0)
    t7 = square(place_y, w1)
    t8 = add(t6, t7, w0)
    sqrt(t8, slant_range)


_RANGE_HESSIAN_IN_PLANE = Signature(
    "range_hessian_in_plane",
    (_TARGET_X_DOMAIN, _TARGET_Y_DOMAIN, _STATION_X_DOMAIN, _STATION_Y_DOMAIN),
    ("range_D_xx", "range_D_xy", "range_D_yy"),
    4,
    _range_hessian_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _range_hessian_in_plane_slant_range_block,
            (0, 2),
        ),
    ),
    numbers=_range_hessian_in_plane_of_numbers,
)


class RangeRateHessianInPlane(NamedTuple):
    """Result of `range_rate_hessian_in_plane`."""

    range_rate_D_xx: Real
    """Second derivative of the range rate by the target's position along x, twice, 1/(m s)."""
    range_rate_D_xy: Real
    """Second derivative of the range rate by the target's position along x and y, 1/(m s)."""
    range_rate_D_yy: Real
    """Second derivative of the range rate by the target's position along y, twice, 1/(m s)."""


def range_rate_hessian_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeRateHessianInPlane:
    """Second derivatives of the range rate by the position in the plane.

        -(u h' + h u' + (g/f) (I - u u'))/f, g = u'w, h = (w - g u)/f,
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity;
        by position and velocity see `range_hessian`, by two velocities it is 0. The terms of an
        entry add up to at most 5 |w|/f^2

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    range_rate_D_xx: second derivative of the range rate by the target's position along x, twice,
        1/(m s). Error over the sum of its terms taken positive at most 15.01 * 2^-52 (float64),
        15.01 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 4e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 8e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 4e-207 (float64) and 2e-16 (float32)
        apart; what cancels: target_velocity_x - station_velocity_x - ...*(target_x -
        station_x)/....
    range_rate_D_xy: second derivative of the range rate by the target's position along x and y,
        1/(m s). Error over the sum of its terms taken positive at most 15.51 * 2^-52 (float64),
        15.51 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 4e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 8e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 4e-207 (float64) and 2e-16 (float32)
        apart; what cancels: (target_x - station_x)/...*... + (target_y - station_y)/...*... + ....
    range_rate_D_yy: second derivative of the range rate by the target's position along y, twice,
        1/(m s). Error over the sum of its terms taken positive at most 15.01 * 2^-52 (float64),
        15.01 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 4e-22 (float32)
        beside it where a product underflows. Digits that can be lost: up to 16 of 16 in float64 and
        7 of 7 in float32; half or more only where the value is below 8e-7 in float64 and 0.03 in
        float32 of what its error is relative to; values below 4e-207 (float64) and 2e-16 (float32)
        apart; what cancels: target_velocity_y - station_velocity_y - ...*(target_y -
        station_y)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeRateHessianInPlane,
                _range_rate_hessian_in_plane_of_numbers(
                    target_x,
                    target_y,
                    target_velocity_x,
                    target_velocity_y,
                    station_x,
                    station_y,
                    station_velocity_x,
                    station_velocity_y,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeRateHessianInPlane(
        *evaluate(
            _RANGE_RATE_HESSIAN_IN_PLANE,
            (
                target_x,
                target_y,
                target_velocity_x,
                target_velocity_y,
                station_x,
                station_y,
                station_velocity_x,
                station_velocity_y,
            ),
            out,
            workers,
        )
    )


def _range_rate_hessian_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    target_velocity_x: float,
    target_velocity_y: float,
    station_x: float,
    station_y: float,
    station_velocity_x: float,
    station_velocity_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t8 = target_x - station_x
    t9 = target_y - station_y
    t10 = target_velocity_x - station_velocity_x
    t11 = target_velocity_y - station_velocity_y
    t15 = form.sqrt((t8 * t8) + (t9 * t9))
    t16 = t8 / t15
    t17 = t9 / t15
    t20 = (t16 * t10) + (t17 * t11)
    t23 = (t10 - (t20 * t16)) / t15
    t26 = (t11 - (t20 * t17)) / t15
    t27 = t20 / t15
    t36 = ((t16 * t23) * 2.0) + (t27 * (t17 * t17))
    t43 = ((t16 * t26) + (t17 * t23)) + (t27 * -(t16 * t17))
    t49 = ((t17 * t26) * 2.0) + (t27 * (t16 * t16))
    t38 = -t36 / t15
    t45 = -t43 / t15
    t51 = -t49 / t15
    if not t15 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t38, t45, t51)


def _range_rate_hessian_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 2.0
) -> None:
    (
        target_x,
        target_y,
        target_velocity_x,
        target_velocity_y,
        station_x,
        station_y,
        station_velocity_x,
        station_velocity_y,
    ) = given
    range_rate_D_xx, range_rate_D_xy, range_rate_D_yy = out
    w0, w1, w2, w3, w4, w5, w6 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w2)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w3)
    t12 = square(place_x, w4)
    t13 = square(place_y, w5)
    t14 = add(t12, t13, w4)
    slant_range = sqrt(t14, range_rate_D_yy)
    t16 = divide(place_x, slant_range, range_rate_D_xx)
    t17 = divide(place_y, slant_range, range_rate_D_xy)
    t18 = multiply(t16, velocity_x, w0)
    t19 = multiply(t17, velocity_y, w1)
    range_rate = add(t18, t19, w0)
    t21 = multiply(range_rate, t16, w1)
    t22 = subtract(velocity_x, t21, w2)
    turning_x = divide(t22, slant_range, w2)
    t24 = multiply(range_rate, t17, w1)
    t25 = subtract(velocity_y, t24, w3)
    turning_y = divide(t25, slant_range, w3)
    t27 = divide(range_rate, slant_range, w0)
    t28 = square(t17, w1)
    t29 = multiply(t16, t17, w4)
    t30 = negative(t29, w4)
    t31 = square(t16, w5)
    t32 = multiply(t16, turning_x, w6)
    t34 = multiply(t32, n0, w6)
    t35 = multiply(t27, t28, w1)
    t36 = add(t34, t35, w6)
    t37 = negative(t36, w6)
    t39 = multiply(t16, turning_y, range_rate_D_xx)
    t40 = multiply(t17, turning_x, w2)
    t41 = add(t39, t40, range_rate_D_xx)
    t42 = multiply(t27, t30, w4)
    t43 = add(t41, t42, range_rate_D_xx)
    t44 = negative(t43, w1)
    t46 = multiply(t17, turning_y, range_rate_D_xy)
    t47 = multiply(t46, n0, range_rate_D_xy)
    t48 = multiply(t27, t31, w0)
    t49 = add(t47, t48, range_rate_D_xy)
    t50 = negative(t49, w0)
    divide(t37, slant_range, range_rate_D_xx)
    divide(t44, slant_range, range_rate_D_xy)
    divide(t50, slant_range, range_rate_D_yy)


def _range_rate_hessian_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        station_x,
        station_y,
        _station_velocity_x,
        _station_velocity_y,
    ) = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t12 = square(place_x, w0)
    t13 = square(place_y, w1)
    t14 = add(t12, t13, w0)
    sqrt(t14, slant_range)


_RANGE_RATE_HESSIAN_IN_PLANE = Signature(
    "range_rate_hessian_in_plane",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
    ),
    ("range_rate_D_xx", "range_rate_D_xy", "range_rate_D_yy"),
    7,
    _range_rate_hessian_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _range_rate_hessian_in_plane_slant_range_block,
            (0, 4),
        ),
    ),
    numbers=_range_rate_hessian_in_plane_of_numbers,
)


class DopplerShiftInPlane(NamedTuple):
    """Result of `doppler_shift_in_plane`."""

    doppler_shift: Real
    """Received less sent frequency, Hz, below 0 where the target goes away."""
    doppler_shift_D_x: Real
    """Derivative of the shift by the target's position along x, Hz/m."""
    doppler_shift_D_y: Real
    """Derivative of the shift by the target's position along y, Hz/m."""
    doppler_shift_D_velocity_x: Real
    """Derivative of the shift by the target's velocity along x, Hz s/m."""
    doppler_shift_D_velocity_y: Real
    """Derivative of the shift by the target's velocity along y, Hz s/m."""


def doppler_shift_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    station_x: ArrayLike,
    station_y: ArrayLike,
    station_velocity_x: ArrayLike,
    station_velocity_y: ArrayLike,
    carrier_frequency: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> DopplerShiftInPlane:
    """Doppler shift of a carrier that the target sends, with its derivatives in the plane.

        -(fc/c) g and its derivatives -(fc/c) h, -(fc/c) u, c = 299792458 m/s, g = u'w,
        h = (w - g u)/f;
        r = target - station, f = |r|, u = r/f, w = target velocity - station velocity.
        This is the narrow-band shift of one way, of first order in speeds over c: at a station
        at rest the classical one is fc/(1 + g/c) - fc, fc g^2/(c (c + g)) above it. An echo has
        twice the shift

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_x: position of the station along x, m; of magnitude at most 1e60, in float32 1e12.
    station_y: position of the station along y, m; of magnitude at most 1e60, in float32 1e12.
    station_velocity_x: velocity of the station along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    station_velocity_y: velocity of the station along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    carrier_frequency: frequency of the carrier, Hz; a number at least 1e-10 and at most 1e30, in
        float32 at least 1e-3 and at most 1e15.

    The distance of the target from the station, of the inputs together, must be at least 1e-20, in
        float32 1e-6.

    doppler_shift: received less sent frequency, Hz, below 0 where the target goes away. Error over
        the sum of its terms taken positive at most 5.01 * 2^-52 (float64), 5.51 * 2^-23 (float32),
        proved for every input, and 4e-241 (float64) and 10e-29 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 3e-7 in float64 and 0.009 in float32 of what its error
        is relative to; values below 3e-226 (float64) and 2e-22 (float32) apart; what cancels:
        (target_x - station_x)/sqrt((target_x - station_x)**2 + (target_y -
        station_y)**2)*(target_velocity_x - station_velocity_x) + (target_y -
        station_y)/sqrt((target_x - station_x)**2 + (target_y - station_y)**2)*(target_velocity_y -
        station_velocity_y).
    doppler_shift_D_x: derivative of the shift by the target's position along x, Hz/m. Error over
        the sum of its terms taken positive at most 10.51 * 2^-52 (float64), 11.01 * 2^-23
        (float32), proved for every input, and 7e-221 (float64) and 2e-22 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 3e-206 (float64) and 2e-16 (float32) apart; what
        cancels: target_velocity_x - station_velocity_x - ...*(target_x - station_x)/....
    doppler_shift_D_y: derivative of the shift by the target's position along y, Hz/m. Error over
        the sum of its terms taken positive at most 10.51 * 2^-52 (float64), 11.01 * 2^-23
        (float32), proved for every input, and 7e-221 (float64) and 2e-22 (float32) beside it where
        a product underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in
        float32; half or more only where the value is below 6e-7 in float64 and 0.02 in float32 of
        what its error is relative to; values below 3e-206 (float64) and 2e-16 (float32) apart; what
        cancels: target_velocity_y - station_velocity_y - ...*(target_y - station_y)/....
    doppler_shift_D_velocity_x: derivative of the shift by the target's velocity along x, Hz s/m.
        Relative error at most 3.51 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every
        input, and 9e-302 (float64) and 3e-38 (float32) beside it where a product underflows.
    doppler_shift_D_velocity_y: derivative of the shift by the target's velocity along y, Hz s/m.
        Relative error at most 3.51 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every
        input, and 9e-302 (float64) and 3e-38 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(station_x) is float
        and type(station_y) is float
        and type(station_velocity_x) is float
        and type(station_velocity_y) is float
        and type(carrier_frequency) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= station_x <= 1e60
        and -1e60 <= station_y <= 1e60
        and -1e60 <= station_velocity_x <= 1e60
        and -1e60 <= station_velocity_y <= 1e60
        and 1e-10 <= carrier_frequency <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                DopplerShiftInPlane,
                _doppler_shift_in_plane_of_numbers(
                    target_x,
                    target_y,
                    target_velocity_x,
                    target_velocity_y,
                    station_x,
                    station_y,
                    station_velocity_x,
                    station_velocity_y,
                    carrier_frequency,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return DopplerShiftInPlane(
        *evaluate(
            _DOPPLER_SHIFT_IN_PLANE,
            (
                target_x,
                target_y,
                target_velocity_x,
                target_velocity_y,
                station_x,
                station_y,
                station_velocity_x,
                station_velocity_y,
                carrier_frequency,
            ),
            out,
            workers,
        )
    )


def _doppler_shift_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    target_velocity_x: float,
    target_velocity_y: float,
    station_x: float,
    station_y: float,
    station_velocity_x: float,
    station_velocity_y: float,
    carrier_frequency: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t8 = target_x - station_x
    t9 = target_y - station_y
    t10 = target_velocity_x - station_velocity_x
    t11 = target_velocity_y - station_velocity_y
    t15 = form.sqrt((t8 * t8) + (t9 * t9))
    t16 = t8 / t15
    t17 = t9 / t15
    t21 = -(carrier_frequency / 299792458.0)
    t24 = (t16 * t10) + (t17 * t11)
    t25 = t24 * t21
    t32 = ((t10 - (t24 * t16)) / t15) * t21
    t33 = ((t11 - (t24 * t17)) / t15) * t21
    t34 = t16 * t21
    t35 = t17 * t21
    if not t15 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t25, t32, t33, t34, t35)


def _doppler_shift_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 299792458.0
) -> None:
    (
        target_x,
        target_y,
        target_velocity_x,
        target_velocity_y,
        station_x,
        station_y,
        station_velocity_x,
        station_velocity_y,
        carrier_frequency,
    ) = given
    (
        doppler_shift,
        doppler_shift_D_x,
        doppler_shift_D_y,
        doppler_shift_D_velocity_x,
        doppler_shift_D_velocity_y,
    ) = out
    w0, w1, w2, w3, w4, w5 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    velocity_x = subtract(target_velocity_x, station_velocity_x, w2)
    velocity_y = subtract(target_velocity_y, station_velocity_y, w3)
    t12 = square(place_x, w4)
    t13 = square(place_y, w5)
    t14 = add(t12, t13, w4)
    slant_range = sqrt(t14, doppler_shift)
    t16 = divide(place_x, slant_range, doppler_shift_D_velocity_x)
    t17 = divide(place_y, slant_range, doppler_shift_D_velocity_y)
    t20 = divide(carrier_frequency, n0, doppler_shift_D_x)
    t21 = negative(t20, w0)
    t22 = multiply(t16, velocity_x, w1)
    t23 = multiply(t17, velocity_y, w4)
    range_rate = add(t22, t23, w1)
    t26 = multiply(range_rate, t16, w4)
    t27 = subtract(velocity_x, t26, w2)
    turning_x = divide(t27, slant_range, doppler_shift_D_y)
    t29 = multiply(range_rate, t17, w2)
    t30 = subtract(velocity_y, t29, w3)
    turning_y = divide(t30, slant_range, w3)
    multiply(range_rate, t21, doppler_shift)
    multiply(turning_x, t21, doppler_shift_D_x)
    multiply(turning_y, t21, doppler_shift_D_y)
    multiply(t16, t21, doppler_shift_D_velocity_x)
    multiply(t17, t21, doppler_shift_D_velocity_y)


def _doppler_shift_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        station_x,
        station_y,
        _station_velocity_x,
        _station_velocity_y,
        _carrier_frequency,
    ) = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, station_x, w0)
    place_y = subtract(target_y, station_y, w1)
    t12 = square(place_x, w0)
    t13 = square(place_y, w1)
    t14 = add(t12, t13, w0)
    sqrt(t14, slant_range)


_DOPPLER_SHIFT_IN_PLANE = Signature(
    "doppler_shift_in_plane",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _STATION_X_DOMAIN,
        _STATION_Y_DOMAIN,
        _STATION_VELOCITY_X_DOMAIN,
        _STATION_VELOCITY_Y_DOMAIN,
        _CARRIER_FREQUENCY_DOMAIN,
    ),
    (
        "doppler_shift",
        "doppler_shift_D_x",
        "doppler_shift_D_y",
        "doppler_shift_D_velocity_x",
        "doppler_shift_D_velocity_y",
    ),
    6,
    _doppler_shift_in_plane_block,
    (
        Required(
            "distance of the target from the station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _doppler_shift_in_plane_slant_range_block,
            (0, 4),
        ),
    ),
    numbers=_doppler_shift_in_plane_of_numbers,
)


class BistaticRangeDoppler(NamedTuple):
    """Result of `bistatic_range_doppler`."""

    bistatic_range: Real
    """Sum of the target's distances from both stations, m."""
    bistatic_range_rate: Real
    """Its rate, m/s."""
    bistatic_range_D_x: Real
    """Derivative of the bistatic range by the target's position along x, dimensionless."""
    bistatic_range_D_y: Real
    """Derivative of the bistatic range by the target's position along y, dimensionless."""
    bistatic_range_D_z: Real
    """Derivative of the bistatic range by the target's position along z, dimensionless."""
    bistatic_range_rate_D_x: Real
    """Derivative of the rate of the bistatic range by the target's position along x, 1/s."""
    bistatic_range_rate_D_y: Real
    """Derivative of the rate of the bistatic range by the target's position along y, 1/s."""
    bistatic_range_rate_D_z: Real
    """Derivative of the rate of the bistatic range by the target's position along z, 1/s."""


def bistatic_range_doppler(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    target_velocity_z: ArrayLike,
    first_station_x: ArrayLike,
    first_station_y: ArrayLike,
    first_station_z: ArrayLike,
    first_station_velocity_x: ArrayLike,
    first_station_velocity_y: ArrayLike,
    first_station_velocity_z: ArrayLike,
    second_station_x: ArrayLike,
    second_station_y: ArrayLike,
    second_station_z: ArrayLike,
    second_station_velocity_x: ArrayLike,
    second_station_velocity_y: ArrayLike,
    second_station_velocity_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> BistaticRangeDoppler:
    """Range and range rate over two stations, with their derivatives.

        f_1 + f_2, g_1 + g_2, u_1 + u_2, h_1 + h_2 with f, g, u, h of `range_doppler` from each
        station; the derivative of the rate by the target's velocity is u_1 + u_2 too, by a
        station's position and velocity they are -u, -h and -u of its own. Terms are those of
        `range_doppler`

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_z: position of the target along z, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_z: velocity of the target along z, m/s; of magnitude at most 1e60, in float32
        1e9.
    first_station_x: position of the first station along x, m; of magnitude at most 1e60, in float32
        1e12.
    first_station_y: position of the first station along y, m; of magnitude at most 1e60, in float32
        1e12.
    first_station_z: position of the first station along z, m; of magnitude at most 1e60, in float32
        1e12.
    first_station_velocity_x: velocity of the first station along x, m/s; of magnitude at most 1e60,
        in float32 1e9.
    first_station_velocity_y: velocity of the first station along y, m/s; of magnitude at most 1e60,
        in float32 1e9.
    first_station_velocity_z: velocity of the first station along z, m/s; of magnitude at most 1e60,
        in float32 1e9.
    second_station_x: position of the second station along x, m; of magnitude at most 1e60, in
        float32 1e12.
    second_station_y: position of the second station along y, m; of magnitude at most 1e60, in
        float32 1e12.
    second_station_z: position of the second station along z, m; of magnitude at most 1e60, in
        float32 1e12.
    second_station_velocity_x: velocity of the second station along x, m/s; of magnitude at most
        1e60, in float32 1e9.
    second_station_velocity_y: velocity of the second station along y, m/s; of magnitude at most
        1e60, in float32 1e9.
    second_station_velocity_z: velocity of the second station along z, m/s; of magnitude at most
        1e60, in float32 1e9.

    The distance of the target from the first station, of the inputs together, must be at least
        1e-20, in float32 1e-6.
    The distance of the target from the second station, of the inputs together, must be at least
        1e-20, in float32 1e-6.

    bistatic_range: sum of the target's distances from both stations, m. Relative error at most 2.26
        * 2^-52 (float64), 2.26 * 2^-23 (float32), proved for every input.
    bistatic_range_rate: its rate, m/s. Error over the sum of its terms taken positive at most 5.26
        * 2^-52 (float64), 5.26 * 2^-23 (float32), proved for every input, and 4e-262 (float64) and
        9e-35 (float32) beside it where a product underflows. Digits that can be lost: up to 16 of
        16 in float64 and 7 of 7 in float32; half or more only where the value is below 3e-7 in
        float64 and 0.009 in float32 of what its error is relative to; values below 3e-247 (float64)
        and 2e-28 (float32) apart; what cancels: ... + ...*(target_velocity_z -
        first_station_velocity_z) + ... + ...*(target_velocity_z - second_station_velocity_z).
    bistatic_range_D_x: derivative of the bistatic range by the target's position along x,
        dimensionless. Error over the sum of its terms taken positive at most 3.26 * 2^-52
        (float64), 3.26 * 2^-23 (float32), proved for every input, and 5e-323 (float64) and 2e-44
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-7 in float64
        and 0.006 in float32 of what its error is relative to; what cancels: (target_x -
        first_station_x)/sqrt((target_x - first_station_x)**2 + (target_y - first_station_y)**2 +
        (target_z - first_station_z)**2) + (target_x - second_station_x)/sqrt((target_x -
        second_station_x)**2 + (target_y - second_station_y)**2 + (target_z - second_station_z)**2).
    bistatic_range_D_y: derivative of the bistatic range by the target's position along y,
        dimensionless. Error over the sum of its terms taken positive at most 3.26 * 2^-52
        (float64), 3.26 * 2^-23 (float32), proved for every input, and 5e-323 (float64) and 2e-44
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-7 in float64
        and 0.006 in float32 of what its error is relative to; what cancels: (target_y -
        first_station_y)/sqrt((target_x - first_station_x)**2 + (target_y - first_station_y)**2 +
        (target_z - first_station_z)**2) + (target_y - second_station_y)/sqrt((target_x -
        second_station_x)**2 + (target_y - second_station_y)**2 + (target_z - second_station_z)**2).
    bistatic_range_D_z: derivative of the bistatic range by the target's position along z,
        dimensionless. Error over the sum of its terms taken positive at most 3.26 * 2^-52
        (float64), 3.26 * 2^-23 (float32), proved for every input, and 5e-323 (float64) and 2e-44
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-7 in float64
        and 0.006 in float32 of what its error is relative to; what cancels: (target_z -
        first_station_z)/sqrt((target_x - first_station_x)**2 + (target_y - first_station_y)**2 +
        (target_z - first_station_z)**2) + (target_z - second_station_z)/sqrt((target_x -
        second_station_x)**2 + (target_y - second_station_y)**2 + (target_z - second_station_z)**2).
    bistatic_range_rate_D_x: derivative of the rate of the bistatic range by the target's position
        along x, 1/s. Error over the sum of its terms taken positive at most 11.26 * 2^-52
        (float64), 11.26 * 2^-23 (float32), proved for every input, and 7e-242 (float64) and 2e-28
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 3e-227 (float64) and
        2e-22 (float32) apart; what cancels: target_velocity_x - first_station_velocity_x - (... +
        ...*(target_velocity_z - first_station_velocity_z))*(target_x - first_station_x)/....
    bistatic_range_rate_D_y: derivative of the rate of the bistatic range by the target's position
        along y, 1/s. Error over the sum of its terms taken positive at most 11.26 * 2^-52
        (float64), 11.26 * 2^-23 (float32), proved for every input, and 7e-242 (float64) and 2e-28
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 3e-227 (float64) and
        2e-22 (float32) apart; what cancels: target_velocity_y - second_station_velocity_y -
        ...*(target_y - second_station_y)/....
    bistatic_range_rate_D_z: derivative of the rate of the bistatic range by the target's position
        along z, 1/s. Error over the sum of its terms taken positive at most 11.26 * 2^-52
        (float64), 11.26 * 2^-23 (float32), proved for every input, and 7e-242 (float64) and 2e-28
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 3e-227 (float64) and
        2e-22 (float32) apart; what cancels: target_velocity_z - first_station_velocity_z - (... +
        ...*(target_velocity_z - first_station_velocity_z))*(target_z - first_station_z)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(target_velocity_z) is float
        and type(first_station_x) is float
        and type(first_station_y) is float
        and type(first_station_z) is float
        and type(first_station_velocity_x) is float
        and type(first_station_velocity_y) is float
        and type(first_station_velocity_z) is float
        and type(second_station_x) is float
        and type(second_station_y) is float
        and type(second_station_z) is float
        and type(second_station_velocity_x) is float
        and type(second_station_velocity_y) is float
        and type(second_station_velocity_z) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_z <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= target_velocity_z <= 1e60
        and -1e60 <= first_station_x <= 1e60
        and -1e60 <= first_station_y <= 1e60
        and -1e60 <= first_station_z <= 1e60
        and -1e60 <= first_station_velocity_x <= 1e60
        and -1e60 <= first_station_velocity_y <= 1e60
        and -1e60 <= first_station_velocity_z <= 1e60
        and -1e60 <= second_station_x <= 1e60
        and -1e60 <= second_station_y <= 1e60
        and -1e60 <= second_station_z <= 1e60
        and -1e60 <= second_station_velocity_x <= 1e60
        and -1e60 <= second_station_velocity_y <= 1e60
        and -1e60 <= second_station_velocity_z <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                BistaticRangeDoppler,
                _bistatic_range_doppler_of_numbers(
                    target_x,
                    target_y,
                    target_z,
                    target_velocity_x,
                    target_velocity_y,
                    target_velocity_z,
                    first_station_x,
                    first_station_y,
                    first_station_z,
                    first_station_velocity_x,
                    first_station_velocity_y,
                    first_station_velocity_z,
                    second_station_x,
                    second_station_y,
                    second_station_z,
                    second_station_velocity_x,
                    second_station_velocity_y,
                    second_station_velocity_z,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return BistaticRangeDoppler(
        *evaluate(
            _BISTATIC_RANGE_DOPPLER,
            (
                target_x,
                target_y,
                target_z,
                target_velocity_x,
                target_velocity_y,
                target_velocity_z,
                first_station_x,
                first_station_y,
                first_station_z,
                first_station_velocity_x,
                first_station_velocity_y,
                first_station_velocity_z,
                second_station_x,
                second_station_y,
                second_station_z,
                second_station_velocity_x,
                second_station_velocity_y,
                second_station_velocity_z,
            ),
            out,
            workers,
        )
    )


def _bistatic_range_doppler_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    target_velocity_x: float,
    target_velocity_y: float,
    target_velocity_z: float,
    first_station_x: float,
    first_station_y: float,
    first_station_z: float,
    first_station_velocity_x: float,
    first_station_velocity_y: float,
    first_station_velocity_z: float,
    second_station_x: float,
    second_station_y: float,
    second_station_z: float,
    second_station_velocity_x: float,
    second_station_velocity_y: float,
    second_station_velocity_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t18 = target_x - first_station_x
    t19 = target_y - first_station_y
    t20 = target_z - first_station_z
    t21 = target_velocity_x - first_station_velocity_x
    t22 = target_velocity_y - first_station_velocity_y
    t23 = target_velocity_z - first_station_velocity_z
    t28 = ((t18 * t18) + (t19 * t19)) + (t20 * t20)
    t29 = form.sqrt(t28)
    t30 = t18 / t29
    t31 = t19 / t29
    t32 = t20 / t29
    t33 = target_x - second_station_x
    t34 = target_y - second_station_y
    t35 = target_z - second_station_z
    t36 = target_velocity_x - second_station_velocity_x
    t37 = target_velocity_y - second_station_velocity_y
    t38 = target_velocity_z - second_station_velocity_z
    t43 = ((t33 * t33) + (t34 * t34)) + (t35 * t35)
    t44 = form.sqrt(t43)
    t45 = t33 / t44
    t46 = t34 / t44
    t47 = t35 / t44
    t53 = ((t30 * t21) + (t31 * t22)) + (t32 * t23)
    t58 = ((t45 * t36) + (t46 * t37)) + (t47 * t38)
    t48 = t29 + t44
    t59 = t53 + t58
    t60 = t30 + t45
    t61 = t31 + t46
    t62 = t32 + t47
    t81 = ((t21 - (t53 * t30)) / t29) + ((t36 - (t58 * t45)) / t44)
    t82 = ((t22 - (t53 * t31)) / t29) + ((t37 - (t58 * t46)) / t44)
    t83 = ((t23 - (t53 * t32)) / t29) + ((t38 - (t58 * t47)) / t44)
    if not t29 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    if not t44 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t48, t59, t60, t61, t62, t81, t82, t83)


def _bistatic_range_doppler_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        target_x,
        target_y,
        target_z,
        target_velocity_x,
        target_velocity_y,
        target_velocity_z,
        first_station_x,
        first_station_y,
        first_station_z,
        first_station_velocity_x,
        first_station_velocity_y,
        first_station_velocity_z,
        second_station_x,
        second_station_y,
        second_station_z,
        second_station_velocity_x,
        second_station_velocity_y,
        second_station_velocity_z,
    ) = given
    (
        bistatic_range,
        bistatic_range_rate,
        bistatic_range_D_x,
        bistatic_range_D_y,
        bistatic_range_D_z,
        bistatic_range_rate_D_x,
        bistatic_range_rate_D_y,
        bistatic_range_rate_D_z,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    place_z = subtract(target_z, first_station_z, w2)
    velocity_x = subtract(target_velocity_x, first_station_velocity_x, w3)
    velocity_y = subtract(target_velocity_y, first_station_velocity_y, w4)
    velocity_z = subtract(target_velocity_z, first_station_velocity_z, w5)
    t24 = square(place_x, w6)
    t25 = square(place_y, w7)
    t26 = square(place_z, w8)
    t27 = add(t24, t25, w6)
    t28 = add(t27, t26, w6)
    slant_range = sqrt(t28, bistatic_range)
    t30 = divide(place_x, slant_range, bistatic_range_D_x)
    t31 = divide(place_y, slant_range, bistatic_range_D_y)
    t32 = divide(place_z, slant_range, bistatic_range_D_z)
    other_place_x = subtract(target_x, second_station_x, w0)
    other_place_y = subtract(target_y, second_station_y, w1)
    other_place_z = subtract(target_z, second_station_z, w2)
    other_velocity_x = subtract(target_velocity_x, second_station_velocity_x, w6)
    other_velocity_y = subtract(target_velocity_y, second_station_velocity_y, w7)
    other_velocity_z = subtract(target_velocity_z, second_station_velocity_z, w8)
    t39 = square(other_place_x, w9)
    t40 = square(other_place_y, w10)
    t41 = square(other_place_z, w11)
    t42 = add(t39, t40, w9)
    t43 = add(t42, t41, w9)
    other_range = sqrt(t43, bistatic_range_rate)
    t45 = divide(other_place_x, other_range, bistatic_range_rate_D_x)
    t46 = divide(other_place_y, other_range, bistatic_range_rate_D_y)
    t47 = divide(other_place_z, other_range, bistatic_range_rate_D_z)
    t49 = multiply(t30, velocity_x, w0)
    t50 = multiply(t31, velocity_y, w1)
    t51 = multiply(t32, velocity_z, w2)
    t52 = add(t49, t50, w0)
    range_rate = add(t52, t51, w0)
    t54 = multiply(t45, other_velocity_x, w1)
    t55 = multiply(t46, other_velocity_y, w2)
    t56 = multiply(t47, other_velocity_z, w9)
    t57 = add(t54, t55, w1)
    other_range_rate = add(t57, t56, w1)
    t63 = multiply(range_rate, t30, w2)
    t64 = subtract(velocity_x, t63, w3)
    turning_x = divide(t64, slant_range, w3)
    t66 = multiply(range_rate, t31, w2)
    t67 = subtract(velocity_y, t66, w4)
    turning_y = divide(t67, slant_range, w4)
    t69 = multiply(range_rate, t32, w2)
    t70 = subtract(velocity_z, t69, w5)
    turning_z = divide(t70, slant_range, w5)
    t72 = multiply(other_range_rate, t45, w2)
    t73 = subtract(other_velocity_x, t72, w6)
    other_turning_x = divide(t73, other_range, w6)
    t75 = multiply(other_range_rate, t46, w2)
    t76 = subtract(other_velocity_y, t75, w7)
    other_turning_y = divide(t76, other_range, w7)
    t78 = multiply(other_range_rate, t47, w2)
    t79 = subtract(other_velocity_z, t78, w8)
    other_turning_z = divide(t79, other_range, w8)
    add(slant_range, other_range, bistatic_range)
    add(range_rate, other_range_rate, bistatic_range_rate)
    add(t30, t45, bistatic_range_D_x)
    add(t31, t46, bistatic_range_D_y)
    add(t32, t47, bistatic_range_D_z)
    add(turning_x, other_turning_x, bistatic_range_rate_D_x)
    add(turning_y, other_turning_y, bistatic_range_rate_D_y)
    add(turning_z, other_turning_z, bistatic_range_rate_D_z)


def _bistatic_range_doppler_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        first_station_x,
        first_station_y,
        first_station_z,
        _first_station_velocity_x,
        _first_station_velocity_y,
        _first_station_velocity_z,
        _second_station_x,
        _second_station_y,
        _second_station_z,
        _second_station_velocity_x,
        _second_station_velocity_y,
        _second_station_velocity_z,
    ) = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    place_z = subtract(target_z, first_station_z, w2)
    t24 = square(place_x, w0)
    t25 = square(place_y, w1)
    t26 = square(place_z, w2)
    t27 = add(t24, t25, w0)
    t28 = add(t27, t26, w0)
    sqrt(t28, slant_range)


def _bistatic_range_doppler_other_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        _first_station_x,
        _first_station_y,
        _first_station_z,
        _first_station_velocity_x,
        _first_station_velocity_y,
        _first_station_velocity_z,
        second_station_x,
        second_station_y,
        second_station_z,
        _second_station_velocity_x,
        _second_station_velocity_y,
        _second_station_velocity_z,
    ) = given
    (other_range,) = out
    w0, w1, w2 = work
    other_place_x = subtract(target_x, second_station_x, w0)
    other_place_y = subtract(target_y, second_station_y, w1)
    other_place_z = subtract(target_z, second_station_z, w2)
    t39 = square(other_place_x, w0)
    t40 = square(other_place_y, w1)
    t41 = square(other_place_z, w2)
    t42 = add(t39, t40, w0)
    t43 = add(t42, t41, w0)
    sqrt(t43, other_range)


_BISTATIC_RANGE_DOPPLER = Signature(
    "bistatic_range_doppler",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_Z_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _TARGET_VELOCITY_Z_DOMAIN,
        _FIRST_STATION_X_DOMAIN,
        _FIRST_STATION_Y_DOMAIN,
        _FIRST_STATION_Z_DOMAIN,
        _FIRST_STATION_VELOCITY_X_DOMAIN,
        _FIRST_STATION_VELOCITY_Y_DOMAIN,
        _FIRST_STATION_VELOCITY_Z_DOMAIN,
        _SECOND_STATION_X_DOMAIN,
        _SECOND_STATION_Y_DOMAIN,
        _SECOND_STATION_Z_DOMAIN,
        _SECOND_STATION_VELOCITY_X_DOMAIN,
        _SECOND_STATION_VELOCITY_Y_DOMAIN,
        _SECOND_STATION_VELOCITY_Z_DOMAIN,
    ),
    (
        "bistatic_range",
        "bistatic_range_rate",
        "bistatic_range_D_x",
        "bistatic_range_D_y",
        "bistatic_range_D_z",
        "bistatic_range_rate_D_x",
        "bistatic_range_rate_D_y",
        "bistatic_range_rate_D_z",
    ),
    12,
    _bistatic_range_doppler_block,
    (
        Required(
            "distance of the target from the first station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _bistatic_range_doppler_slant_range_block,
            (0, 6),
        ),
        Required(
            "distance of the target from the second station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            3,
            _bistatic_range_doppler_other_range_block,
            (0, 12),
        ),
    ),
    numbers=_bistatic_range_doppler_of_numbers,
)


class RangeDopplerDifference(NamedTuple):
    """Result of `range_doppler_difference`."""

    range_difference: Real
    """Distance from the first station less that from the second, m."""
    range_rate_difference: Real
    """Its rate, m/s."""
    range_difference_D_x: Real
    """Derivative of the difference of the ranges by the target's position along x,
    dimensionless."""
    range_difference_D_y: Real
    """Derivative of the difference of the ranges by the target's position along y,
    dimensionless."""
    range_difference_D_z: Real
    """Derivative of the difference of the ranges by the target's position along z,
    dimensionless."""
    range_rate_difference_D_x: Real
    """Derivative of the difference of the range rates by the target's position along x, 1/s."""
    range_rate_difference_D_y: Real
    """Derivative of the difference of the range rates by the target's position along y, 1/s."""
    range_rate_difference_D_z: Real
    """Derivative of the difference of the range rates by the target's position along z, 1/s."""


def range_doppler_difference(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_z: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    target_velocity_z: ArrayLike,
    first_station_x: ArrayLike,
    first_station_y: ArrayLike,
    first_station_z: ArrayLike,
    first_station_velocity_x: ArrayLike,
    first_station_velocity_y: ArrayLike,
    first_station_velocity_z: ArrayLike,
    second_station_x: ArrayLike,
    second_station_y: ArrayLike,
    second_station_z: ArrayLike,
    second_station_velocity_x: ArrayLike,
    second_station_velocity_y: ArrayLike,
    second_station_velocity_z: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeDopplerDifference:
    """Differences of range and range rate at two stations (TDOA, FDOA).

        f_1 - f_2 = s'(r_1 + r_2)/(f_1 + f_2), r = target - station, s = second - first station,
        so that errors are parts of |s| and not of the ranges: terms, those of r_1 and of r_2
        each for itself, add up to at most |s|;
        u_1 - u_2 = (s - (f_1 - f_2) u_2)/f_1, g_1 - g_2 = u_1's_v + (u_1 - u_2)'w_2,
        h_1 - h_2 = (s_v - (g_1 - g_2) u_1 - g_2 (u_1 - u_2) - (f_1 - f_2) h_2)/f_1 with the
        f, g, u, h of `range_doppler`; derivatives by a station's position and velocity are those
        of its own range and rate

    target_x: position of the target along x, m; of magnitude at most 1e40, in float32 1e10.
    target_y: position of the target along y, m; of magnitude at most 1e40, in float32 1e10.
    target_z: position of the target along z, m; of magnitude at most 1e40, in float32 1e10.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e30, in float32
        1e6.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e30, in float32
        1e6.
    target_velocity_z: velocity of the target along z, m/s; of magnitude at most 1e30, in float32
        1e6.
    first_station_x: position of the first station along x, m; of magnitude at most 1e40, in float32
        1e10.
    first_station_y: position of the first station along y, m; of magnitude at most 1e40, in float32
        1e10.
    first_station_z: position of the first station along z, m; of magnitude at most 1e40, in float32
        1e10.
    first_station_velocity_x: velocity of the first station along x, m/s; of magnitude at most 1e30,
        in float32 1e6.
    first_station_velocity_y: velocity of the first station along y, m/s; of magnitude at most 1e30,
        in float32 1e6.
    first_station_velocity_z: velocity of the first station along z, m/s; of magnitude at most 1e30,
        in float32 1e6.
    second_station_x: position of the second station along x, m; of magnitude at most 1e40, in
        float32 1e10.
    second_station_y: position of the second station along y, m; of magnitude at most 1e40, in
        float32 1e10.
    second_station_z: position of the second station along z, m; of magnitude at most 1e40, in
        float32 1e10.
    second_station_velocity_x: velocity of the second station along x, m/s; of magnitude at most
        1e30, in float32 1e6.
    second_station_velocity_y: velocity of the second station along y, m/s; of magnitude at most
        1e30, in float32 1e6.
    second_station_velocity_z: velocity of the second station along z, m/s; of magnitude at most
        1e30, in float32 1e6.

    The distance of the target from the first station, of the inputs together, must be at least
        1e-20, in float32 1.
    The distance of the target from the second station, of the inputs together, must be at least
        1e-20, in float32 1.

    range_difference: distance from the first station less that from the second, m. Error over the
        sum of its terms taken positive at most 5.76 * 2^-52 (float64), 5.76 * 2^-23 (float32),
        proved for every input, and 8e-303 (float64) and 3e-44 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 3e-7 in float64 and 0.01 in float32 of what its error
        is relative to; values below 6e-288 (float64) apart; what cancels: (second_station_x -
        first_station_x)*(target_x - first_station_x + target_x - second_station_x) +
        (second_station_y - first_station_y)*(target_y - first_station_y + target_y -
        second_station_y) + (second_station_z - first_station_z)*(target_z - first_station_z +
        target_z - second_station_z).
    range_rate_difference: its rate, m/s. Error over the sum of its terms taken positive at most
        14.26 * 2^-52 (float64), 14.26 * 2^-23 (float32), proved for every input, and 4e-171
        (float64) and 2e-16 (float32) beside it where a product underflows. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        8e-7 in float64 and 0.03 in float32 of what its error is relative to; values below 2e-156
        (float64) and 7e-11 (float32) apart; what cancels: second_station_y - first_station_y - (...
        + (second_station_z - first_station_z)*...)/...*(target_y - second_station_y)/....
    range_difference_D_x: derivative of the difference of the ranges by the target's position along
        x, dimensionless. Error over the sum of its terms taken positive at most 11.76 * 2^-52
        (float64), 11.76 * 2^-23 (float32), proved for every input, and 7e-202 (float64) and 2e-23
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 3e-187 (float64) and
        2e-17 (float32) apart; what cancels: second_station_x - first_station_x - (... +
        (second_station_z - first_station_z)*...)/...*(target_x - second_station_x)/....
    range_difference_D_y: derivative of the difference of the ranges by the target's position along
        y, dimensionless. Error over the sum of its terms taken positive at most 11.76 * 2^-52
        (float64), 11.76 * 2^-23 (float32), proved for every input, and 7e-202 (float64) and 2e-23
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 3e-187 (float64) and
        2e-17 (float32) apart; what cancels: second_station_y - first_station_y - (... +
        (second_station_z - first_station_z)*...)/...*(target_y - second_station_y)/....
    range_difference_D_z: derivative of the difference of the ranges by the target's position along
        z, dimensionless. Error over the sum of its terms taken positive at most 11.76 * 2^-52
        (float64), 11.76 * 2^-23 (float32), proved for every input, and 7e-202 (float64) and 2e-23
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 3e-187 (float64) and
        2e-17 (float32) apart; what cancels: second_station_z - first_station_z - (... +
        (second_station_z - first_station_z)*...)/...*(target_z - second_station_z)/....
    range_rate_difference_D_x: derivative of the difference of the range rates by the target's
        position along x, 1/s. Error over the sum of its terms taken positive at most 21.26 * 2^-52
        (float64), 21.26 * 2^-23 (float32), proved for every input, and 3e-150 (float64) and 7e-16
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-6 in float64
        and 0.04 in float32 of what its error is relative to; values below 5e-136 (float64) and
        3e-10 (float32) apart; what cancels: second_station_velocity_x - first_station_velocity_x -
        ... - ... - ...*(target_velocity_x - second_station_velocity_x - ...)/....
    range_rate_difference_D_y: derivative of the difference of the range rates by the target's
        position along y, 1/s. Error over the sum of its terms taken positive at most 21.26 * 2^-52
        (float64), 21.26 * 2^-23 (float32), proved for every input, and 3e-150 (float64) and 7e-16
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-6 in float64
        and 0.04 in float32 of what its error is relative to; values below 5e-136 (float64) and
        3e-10 (float32) apart; what cancels: target_velocity_y - second_station_velocity_y -
        ...*(target_y - second_station_y)/....
    range_rate_difference_D_z: derivative of the difference of the range rates by the target's
        position along z, 1/s. Error over the sum of its terms taken positive at most 21.26 * 2^-52
        (float64), 21.26 * 2^-23 (float32), proved for every input, and 3e-150 (float64) and 7e-16
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-6 in float64
        and 0.04 in float32 of what its error is relative to; values below 5e-136 (float64) and
        3e-10 (float32) apart; what cancels: second_station_velocity_z - first_station_velocity_z -
        ... - ... - ...*(target_velocity_z - second_station_velocity_z - ...)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_z) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(target_velocity_z) is float
        and type(first_station_x) is float
        and type(first_station_y) is float
        and type(first_station_z) is float
        and type(first_station_velocity_x) is float
        and type(first_station_velocity_y) is float
        and type(first_station_velocity_z) is float
        and type(second_station_x) is float
        and type(second_station_y) is float
        and type(second_station_z) is float
        and type(second_station_velocity_x) is float
        and type(second_station_velocity_y) is float
        and type(second_station_velocity_z) is float
        and -1e40 <= target_x <= 1e40
        and -1e40 <= target_y <= 1e40
        and -1e40 <= target_z <= 1e40
        and -1e30 <= target_velocity_x <= 1e30
        and -1e30 <= target_velocity_y <= 1e30
        and -1e30 <= target_velocity_z <= 1e30
        and -1e40 <= first_station_x <= 1e40
        and -1e40 <= first_station_y <= 1e40
        and -1e40 <= first_station_z <= 1e40
        and -1e30 <= first_station_velocity_x <= 1e30
        and -1e30 <= first_station_velocity_y <= 1e30
        and -1e30 <= first_station_velocity_z <= 1e30
        and -1e40 <= second_station_x <= 1e40
        and -1e40 <= second_station_y <= 1e40
        and -1e40 <= second_station_z <= 1e40
        and -1e30 <= second_station_velocity_x <= 1e30
        and -1e30 <= second_station_velocity_y <= 1e30
        and -1e30 <= second_station_velocity_z <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeDopplerDifference,
                _range_doppler_difference_of_numbers(
                    target_x,
                    target_y,
                    target_z,
                    target_velocity_x,
                    target_velocity_y,
                    target_velocity_z,
                    first_station_x,
                    first_station_y,
                    first_station_z,
                    first_station_velocity_x,
                    first_station_velocity_y,
                    first_station_velocity_z,
                    second_station_x,
                    second_station_y,
                    second_station_z,
                    second_station_velocity_x,
                    second_station_velocity_y,
                    second_station_velocity_z,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeDopplerDifference(
        *evaluate(
            _RANGE_DOPPLER_DIFFERENCE,
            (
                target_x,
                target_y,
                target_z,
                target_velocity_x,
                target_velocity_y,
                target_velocity_z,
                first_station_x,
                first_station_y,
                first_station_z,
                first_station_velocity_x,
                first_station_velocity_y,
                first_station_velocity_z,
                second_station_x,
                second_station_y,
                second_station_z,
                second_station_velocity_x,
                second_station_velocity_y,
                second_station_velocity_z,
            ),
            out,
            workers,
        )
    )


def _range_doppler_difference_of_numbers(
    target_x: float,
    target_y: float,
    target_z: float,
    target_velocity_x: float,
    target_velocity_y: float,
    target_velocity_z: float,
    first_station_x: float,
    first_station_y: float,
    first_station_z: float,
    first_station_velocity_x: float,
    first_station_velocity_y: float,
    first_station_velocity_z: float,
    second_station_x: float,
    second_station_y: float,
    second_station_z: float,
    second_station_velocity_x: float,
    second_station_velocity_y: float,
    second_station_velocity_z: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t18 = target_x - first_station_x
    t19 = target_y - first_station_y
    t20 = target_z - first_station_z
    t25 = ((t18 * t18) + (t19 * t19)) + (t20 * t20)
    t26 = form.sqrt(t25)
    t27 = t18 / t26
    t28 = t19 / t26
    t29 = t20 / t26
    t30 = target_x - second_station_x
    t31 = target_y - second_station_y
    t32 = target_z - second_station_z
    t33 = target_velocity_x - second_station_velocity_x
    t34 = target_velocity_y - second_station_velocity_y
    t35 = target_velocity_z - second_station_velocity_z
    t40 = ((t30 * t30) + (t31 * t31)) + (t32 * t32)
    t41 = form.sqrt(t40)
    t42 = t30 / t41
    t43 = t31 / t41
    t44 = t32 / t41
    t45 = second_station_x - first_station_x
    t46 = second_station_y - first_station_y
    t47 = second_station_z - first_station_z
    t48 = second_station_velocity_x - first_station_velocity_x
    t49 = second_station_velocity_y - first_station_velocity_y
    t50 = second_station_velocity_z - first_station_velocity_z
    t57 = (t45 * (t18 + t30)) + (t46 * (t19 + t31))
    t60 = (t57 + (t47 * (t20 + t32))) / (t26 + t41)
    t63 = (t45 - (t60 * t42)) / t26
    t66 = (t46 - (t60 * t43)) / t26
    t69 = (t47 - (t60 * t44)) / t26
    t74 = ((t27 * t48) + (t28 * t49)) + (t29 * t50)
    t79 = ((t63 * t33) + (t66 * t34)) + (t69 * t35)
    t80 = t74 + t79
    t85 = ((t42 * t33) + (t43 * t34)) + (t44 * t35)
    t100 = ((t48 - (t80 * t27)) - (t85 * t63)) - (t60 * ((t33 - (t85 * t42)) / t41))
    t107 = ((t49 - (t80 * t28)) - (t85 * t66)) - (t60 * ((t34 - (t85 * t43)) / t41))
    t114 = ((t50 - (t80 * t29)) - (t85 * t69)) - (t60 * ((t35 - (t85 * t44)) / t41))
    t101 = t100 / t26
    t108 = t107 / t26
    t115 = t114 / t26
    if not t26 >= (1.0 if form.single else 1e-20):
        raise ValueError
    if not t41 >= (1.0 if form.single else 1e-20):
        raise ValueError
    return (t60, t80, t63, t66, t69, t101, t108, t115)


def _range_doppler_difference_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        target_velocity_x,
        target_velocity_y,
        target_velocity_z,
        first_station_x,
        first_station_y,
        first_station_z,
        first_station_velocity_x,
        first_station_velocity_y,
        first_station_velocity_z,
        second_station_x,
        second_station_y,
        second_station_z,
        second_station_velocity_x,
        second_station_velocity_y,
        second_station_velocity_z,
    ) = given
    (
        range_difference,
        range_rate_difference,
        range_difference_D_x,
        range_difference_D_y,
        range_difference_D_z,
        range_rate_difference_D_x,
        range_rate_difference_D_y,
        range_rate_difference_D_z,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16, w17, w18, w19 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    place_z = subtract(target_z, first_station_z, w2)
    t21 = square(place_x, w3)
    t22 = square(place_y, w4)
    t23 = square(place_z, w5)
    t24 = add(t21, t22, w3)
    t25 = add(t24, t23, w3)
    slant_range = sqrt(t25, range_rate_difference_D_z)
    t27 = divide(place_x, slant_range, range_rate_difference_D_x)
    t28 = divide(place_y, slant_range, range_rate_difference_D_y)
    t29 = divide(place_z, slant_range, w3)
    other_place_x = subtract(target_x, second_station_x, w4)
    other_place_y = subtract(target_y, second_station_y, w5)
    other_place_z = subtract(target_z, second_station_z, w6)
    other_velocity_x = subtract(target_velocity_x, second_station_velocity_x, w7)
    other_velocity_y = subtract(target_velocity_y, second_station_velocity_y, w8)
    other_velocity_z = subtract(target_velocity_z, second_station_velocity_z, w9)
    t36 = square(other_place_x, w10)
    t37 = square(other_place_y, w11)
    t38 = square(other_place_z, w12)
    t39 = add(t36, t37, w10)
    t40 = add(t39, t38, w10)
    other_range = sqrt(t40, w10)
    t42 = divide(other_place_x, other_range, w11)
    t43 = divide(other_place_y, other_range, w12)
    t44 = divide(other_place_z, other_range, w13)
    baseline_x = subtract(second_station_x, first_station_x, w14)
    baseline_y = subtract(second_station_y, first_station_y, w15)
    baseline_z = subtract(second_station_z, first_station_z, w16)
    drift_x = subtract(second_station_velocity_x, first_station_velocity_x, w17)
    drift_y = subtract(second_station_velocity_y, first_station_velocity_y, w18)
    drift_z = subtract(second_station_velocity_z, first_station_velocity_z, w19)
    reach_x = add(place_x, other_place_x, w0)
    reach_y = add(place_y, other_place_y, w1)
    reach_z = add(place_z, other_place_z, w2)
    t54 = multiply(baseline_x, reach_x, w0)
    t55 = multiply(baseline_y, reach_y, w1)
    t56 = multiply(baseline_z, reach_z, w2)
    t57 = add(t54, t55, w0)
    t58 = add(t57, t56, w0)
    t59 = add(slant_range, other_range, w1)
    divide(t58, t59, range_difference)
    t61 = multiply(range_difference, t42, w0)
    t62 = subtract(baseline_x, t61, w14)
    divide(t62, slant_range, range_difference_D_x)
    t64 = multiply(range_difference, t43, w0)
    t65 = subtract(baseline_y, t64, w15)
    divide(t65, slant_range, range_difference_D_y)
    t67 = multiply(range_difference, t44, w0)
    t68 = subtract(baseline_z, t67, w16)
    divide(t68, slant_range, range_difference_D_z)
    t70 = multiply(t27, drift_x, w0)
    t71 = multiply(t28, drift_y, w1)
    t72 = multiply(t29, drift_z, w2)
    t73 = add(t70, t71, w0)
    t74 = add(t73, t72, w0)
    t75 = multiply(range_difference_D_x, other_velocity_x, w1)
    t76 = multiply(range_difference_D_y, other_velocity_y, w2)
    t77 = multiply(range_difference_D_z, other_velocity_z, w4)
    t78 = add(t75, t76, w1)
    t79 = add(t78, t77, w1)
    add(t74, t79, range_rate_difference)
    t81 = multiply(t42, other_velocity_x, w0)
    t82 = multiply(t43, other_velocity_y, w1)
    t83 = multiply(t44, other_velocity_z, w2)
    t84 = add(t81, t82, w0)
    other_range_rate = add(t84, t83, w0)
    t86 = multiply(other_range_rate, t42, w11)
    t87 = subtract(other_velocity_x, t86, w7)
    other_turning_x = divide(t87, other_range, w7)
    t89 = multiply(other_range_rate, t43, w12)
    t90 = subtract(other_velocity_y, t89, w8)
    other_turning_y = divide(t90, other_range, w8)
    t92 = multiply(other_range_rate, t44, w13)
    t93 = subtract(other_velocity_z, t92, w9)
    other_turning_z = divide(t93, other_range, w9)
    t95 = multiply(range_rate_difference, t27, range_rate_difference_D_x)
    t96 = subtract(drift_x, t95, w17)
    t97 = multiply(other_range_rate, range_difference_D_x, w1)
    t98 = subtract(t96, t97, w17)
    t99 = multiply(range_difference, other_turning_x, w7)
    t100 = subtract(t98, t99, w17)
    t102 = multiply(range_rate_difference, t28, range_rate_difference_D_y)
    t103 = subtract(drift_y, t102, w18)
    t104 = multiply(other_range_rate, range_difference_D_y, w1)
    t105 = subtract(t103, t104, w18)
    t106 = multiply(range_difference, other_turning_y, w8)
    t107 = subtract(t105, t106, w18)
    t109 = multiply(range_rate_difference, t29, w3)
    t110 = subtract(drift_z, t109, w19)
    t111 = multiply(other_range_rate, range_difference_D_z, w0)
    t112 = subtract(t110, t111, w19)
    t113 = multiply(range_difference, other_turning_z, w9)
    t114 = subtract(t112, t113, w19)
    divide(t100, slant_range, range_rate_difference_D_x)
    divide(t107, slant_range, range_rate_difference_D_y)
    divide(t114, slant_range, range_rate_difference_D_z)


def _range_doppler_difference_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        first_station_x,
        first_station_y,
        first_station_z,
        _first_station_velocity_x,
        _first_station_velocity_y,
        _first_station_velocity_z,
        _second_station_x,
        _second_station_y,
        _second_station_z,
        _second_station_velocity_x,
        _second_station_velocity_y,
        _second_station_velocity_z,
    ) = given
    (slant_range,) = out
    w0, w1, w2 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    place_z = subtract(target_z, first_station_z, w2)
    t21 = square(place_x, w0)
    t22 = square(place_y, w1)
    t23 = square(place_z, w2)
    t24 = add(t21, t22, w0)
    t25 = add(t24, t23, w0)
    sqrt(t25, slant_range)


def _range_doppler_difference_other_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_z,
        _target_velocity_x,
        _target_velocity_y,
        _target_velocity_z,
        _first_station_x,
        _first_station_y,
        _first_station_z,
        _first_station_velocity_x,
        _first_station_velocity_y,
        _first_station_velocity_z,
        second_station_x,
        second_station_y,
        second_station_z,
        _second_station_velocity_x,
        _second_station_velocity_y,
        _second_station_velocity_z,
    ) = given
    (other_range,) = out
    w0, w1, w2 = work
    other_place_x = subtract(target_x, second_station_x, w0)
    other_place_y = subtract(target_y, second_station_y, w1)
    other_place_z = subtract(target_z, second_station_z, w2)
    t36 = square(other_place_x, w0)
    t37 = square(other_place_y, w1)
    t38 = square(other_place_z, w2)
    t39 = add(t36, t37, w0)
    t40 = add(t39, t38, w0)
    sqrt(t40, other_range)


_RANGE_DOPPLER_DIFFERENCE = Signature(
    "range_doppler_difference",
    (
        _TARGET_X_DOMAIN_2,
        _TARGET_Y_DOMAIN_2,
        _TARGET_Z_DOMAIN_2,
        _TARGET_VELOCITY_X_DOMAIN_2,
        _TARGET_VELOCITY_Y_DOMAIN_2,
        _TARGET_VELOCITY_Z_DOMAIN_2,
        _FIRST_STATION_X_DOMAIN_2,
        _FIRST_STATION_Y_DOMAIN_2,
        _FIRST_STATION_Z_DOMAIN_2,
        _FIRST_STATION_VELOCITY_X_DOMAIN_2,
        _FIRST_STATION_VELOCITY_Y_DOMAIN_2,
        _FIRST_STATION_VELOCITY_Z_DOMAIN_2,
        _SECOND_STATION_X_DOMAIN_2,
        _SECOND_STATION_Y_DOMAIN_2,
        _SECOND_STATION_Z_DOMAIN_2,
        _SECOND_STATION_VELOCITY_X_DOMAIN_2,
        _SECOND_STATION_VELOCITY_Y_DOMAIN_2,
        _SECOND_STATION_VELOCITY_Z_DOMAIN_2,
    ),
    (
        "range_difference",
        "range_rate_difference",
        "range_difference_D_x",
        "range_difference_D_y",
        "range_difference_D_z",
        "range_rate_difference_D_x",
        "range_rate_difference_D_y",
        "range_rate_difference_D_z",
    ),
    20,
    _range_doppler_difference_block,
    (
        Required(
            "distance of the target from the first station",
            "at least 1e-20, in float32 1",
            1e-20,
            1.0,
            3,
            _range_doppler_difference_slant_range_block,
            (0, 6),
        ),
        Required(
            "distance of the target from the second station",
            "at least 1e-20, in float32 1",
            1e-20,
            1.0,
            3,
            _range_doppler_difference_other_range_block,
            (0, 12),
        ),
    ),
    numbers=_range_doppler_difference_of_numbers,
)


class BistaticRangeDopplerInPlane(NamedTuple):
    """Result of `bistatic_range_doppler_in_plane`."""

    bistatic_range: Real
    """Sum of the target's distances from both stations, m."""
    bistatic_range_rate: Real
    """Its rate, m/s."""
    bistatic_range_D_x: Real
    """Derivative of the bistatic range by the target's position along x, dimensionless."""
    bistatic_range_D_y: Real
    """Derivative of the bistatic range by the target's position along y, dimensionless."""
    bistatic_range_rate_D_x: Real
    """Derivative of the rate of the bistatic range by the target's position along x, 1/s."""
    bistatic_range_rate_D_y: Real
    """Derivative of the rate of the bistatic range by the target's position along y, 1/s."""


def bistatic_range_doppler_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    first_station_x: ArrayLike,
    first_station_y: ArrayLike,
    first_station_velocity_x: ArrayLike,
    first_station_velocity_y: ArrayLike,
    second_station_x: ArrayLike,
    second_station_y: ArrayLike,
    second_station_velocity_x: ArrayLike,
    second_station_velocity_y: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> BistaticRangeDopplerInPlane:
    """Range and range rate over two stations, with their derivatives in the plane.

        f_1 + f_2, g_1 + g_2, u_1 + u_2, h_1 + h_2 with f, g, u, h of `range_doppler` from each
        station; the derivative of the rate by the target's velocity is u_1 + u_2 too, by a
        station's position and velocity they are -u, -h and -u of its own. Terms are those of
        `range_doppler`

    target_x: position of the target along x, m; of magnitude at most 1e60, in float32 1e12.
    target_y: position of the target along y, m; of magnitude at most 1e60, in float32 1e12.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e60, in float32
        1e9.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e60, in float32
        1e9.
    first_station_x: position of the first station along x, m; of magnitude at most 1e60, in float32
        1e12.
    first_station_y: position of the first station along y, m; of magnitude at most 1e60, in float32
        1e12.
    first_station_velocity_x: velocity of the first station along x, m/s; of magnitude at most 1e60,
        in float32 1e9.
    first_station_velocity_y: velocity of the first station along y, m/s; of magnitude at most 1e60,
        in float32 1e9.
    second_station_x: position of the second station along x, m; of magnitude at most 1e60, in
        float32 1e12.
    second_station_y: position of the second station along y, m; of magnitude at most 1e60, in
        float32 1e12.
    second_station_velocity_x: velocity of the second station along x, m/s; of magnitude at most
        1e60, in float32 1e9.
    second_station_velocity_y: velocity of the second station along y, m/s; of magnitude at most
        1e60, in float32 1e9.

    The distance of the target from the first station, of the inputs together, must be at least
        1e-20, in float32 1e-6.
    The distance of the target from the second station, of the inputs together, must be at least
        1e-20, in float32 1e-6.

    bistatic_range: sum of the target's distances from both stations, m. Relative error at most 2.01
        * 2^-52 (float64), 2.01 * 2^-23 (float32), proved for every input.
    bistatic_range_rate: its rate, m/s. Error over the sum of its terms taken positive at most 4.51
        * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for every input, and 2e-262 (float64) and
        6e-35 (float32) beside it where a product underflows. Digits that can be lost: up to 16 of
        16 in float64 and 7 of 7 in float32; half or more only where the value is below 3e-7 in
        float64 and 0.008 in float32 of what its error is relative to; values below 2e-247 (float64)
        and 2e-28 (float32) apart.
    bistatic_range_D_x: derivative of the bistatic range by the target's position along x,
        dimensionless. Error over the sum of its terms taken positive at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input, and 5e-323 (float64) and 2e-44
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-7 in float64
        and 0.005 in float32 of what its error is relative to; what cancels: (target_x -
        first_station_x)/sqrt((target_x - first_station_x)**2 + (target_y - first_station_y)**2) +
        (target_x - second_station_x)/sqrt((target_x - second_station_x)**2 + (target_y -
        second_station_y)**2).
    bistatic_range_D_y: derivative of the bistatic range by the target's position along y,
        dimensionless. Error over the sum of its terms taken positive at most 3.01 * 2^-52
        (float64), 3.01 * 2^-23 (float32), proved for every input, and 5e-323 (float64) and 2e-44
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 2e-7 in float64
        and 0.005 in float32 of what its error is relative to; what cancels: (target_y -
        first_station_y)/sqrt((target_x - first_station_x)**2 + (target_y - first_station_y)**2) +
        (target_y - second_station_y)/sqrt((target_x - second_station_x)**2 + (target_y -
        second_station_y)**2).
    bistatic_range_rate_D_x: derivative of the rate of the bistatic range by the target's position
        along x, 1/s. Error over the sum of its terms taken positive at most 10.01 * 2^-52
        (float64), 10.01 * 2^-23 (float32), proved for every input, and 5e-242 (float64) and 2e-28
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 2e-227 (float64) and
        1e-22 (float32) apart; what cancels: target_velocity_x - first_station_velocity_x -
        ...*(target_x - first_station_x)/....
    bistatic_range_rate_D_y: derivative of the rate of the bistatic range by the target's position
        along y, 1/s. Error over the sum of its terms taken positive at most 10.01 * 2^-52
        (float64), 10.01 * 2^-23 (float32), proved for every input, and 5e-242 (float64) and 2e-28
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 2e-227 (float64) and
        1e-22 (float32) apart; what cancels: target_velocity_y - second_station_velocity_y -
        ...*(target_y - second_station_y)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(first_station_x) is float
        and type(first_station_y) is float
        and type(first_station_velocity_x) is float
        and type(first_station_velocity_y) is float
        and type(second_station_x) is float
        and type(second_station_y) is float
        and type(second_station_velocity_x) is float
        and type(second_station_velocity_y) is float
        and -1e60 <= target_x <= 1e60
        and -1e60 <= target_y <= 1e60
        and -1e60 <= target_velocity_x <= 1e60
        and -1e60 <= target_velocity_y <= 1e60
        and -1e60 <= first_station_x <= 1e60
        and -1e60 <= first_station_y <= 1e60
        and -1e60 <= first_station_velocity_x <= 1e60
        and -1e60 <= first_station_velocity_y <= 1e60
        and -1e60 <= second_station_x <= 1e60
        and -1e60 <= second_station_y <= 1e60
        and -1e60 <= second_station_velocity_x <= 1e60
        and -1e60 <= second_station_velocity_y <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                BistaticRangeDopplerInPlane,
                _bistatic_range_doppler_in_plane_of_numbers(
                    target_x,
                    target_y,
                    target_velocity_x,
                    target_velocity_y,
                    first_station_x,
                    first_station_y,
                    first_station_velocity_x,
                    first_station_velocity_y,
                    second_station_x,
                    second_station_y,
                    second_station_velocity_x,
                    second_station_velocity_y,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return BistaticRangeDopplerInPlane(
        *evaluate(
            _BISTATIC_RANGE_DOPPLER_IN_PLANE,
            (
                target_x,
                target_y,
                target_velocity_x,
                target_velocity_y,
                first_station_x,
                first_station_y,
                first_station_velocity_x,
                first_station_velocity_y,
                second_station_x,
                second_station_y,
                second_station_velocity_x,
                second_station_velocity_y,
            ),
            out,
            workers,
        )
    )


def _bistatic_range_doppler_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    target_velocity_x: float,
    target_velocity_y: float,
    first_station_x: float,
    first_station_y: float,
    first_station_velocity_x: float,
    first_station_velocity_y: float,
    second_station_x: float,
    second_station_y: float,
    second_station_velocity_x: float,
    second_station_velocity_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t12 = target_x - first_station_x
    t13 = target_y - first_station_y
    t14 = target_velocity_x - first_station_velocity_x
    t15 = target_velocity_y - first_station_velocity_y
    t19 = form.sqrt((t12 * t12) + (t13 * t13))
    t20 = t12 / t19
    t21 = t13 / t19
    t22 = target_x - second_station_x
    t23 = target_y - second_station_y
    t24 = target_velocity_x - second_station_velocity_x
    t25 = target_velocity_y - second_station_velocity_y
    t29 = form.sqrt((t22 * t22) + (t23 * t23))
    t30 = t22 / t29
    t31 = t23 / t29
    t35 = (t20 * t14) + (t21 * t15)
    t38 = (t30 * t24) + (t31 * t25)
    t32 = t19 + t29
    t39 = t35 + t38
    t40 = t20 + t30
    t41 = t21 + t31
    t54 = ((t14 - (t35 * t20)) / t19) + ((t24 - (t38 * t30)) / t29)
    t55 = ((t15 - (t35 * t21)) / t19) + ((t25 - (t38 * t31)) / t29)
    if not t19 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    if not t29 >= (9.999999974752427e-07 if form.single else 1e-20):
        raise ValueError
    return (t32, t39, t40, t41, t54, t55)


def _bistatic_range_doppler_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_velocity_x,
        target_velocity_y,
        first_station_x,
        first_station_y,
        first_station_velocity_x,
        first_station_velocity_y,
        second_station_x,
        second_station_y,
        second_station_velocity_x,
        second_station_velocity_y,
    ) = given
    (
        bistatic_range,
        bistatic_range_rate,
        bistatic_range_D_x,
        bistatic_range_D_y,
        bistatic_range_rate_D_x,
        bistatic_range_rate_D_y,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    velocity_x = subtract(target_velocity_x, first_station_velocity_x, w2)
    velocity_y = subtract(target_velocity_y, first_station_velocity_y, w3)
    t16 = square(place_x, w4)
    t17 = square(place_y, w5)
    t18 = add(t16, t17, w4)
    slant_range = sqrt(t18, bistatic_range)
    t20 = divide(place_x, slant_range, bistatic_range_D_x)
    t21 = divide(place_y, slant_range, bistatic_range_D_y)
    other_place_x = subtract(target_x, second_station_x, w0)
    other_place_y = subtract(target_y, second_station_y, w1)
    other_velocity_x = subtract(target_velocity_x, second_station_velocity_x, w4)
    other_velocity_y = subtract(target_velocity_y, second_station_velocity_y, w5)
    t26 = square(other_place_x, w6)
    t27 = square(other_place_y, w7)
    t28 = add(t26, t27, w6)
    other_range = sqrt(t28, bistatic_range_rate)
    t30 = divide(other_place_x, other_range, bistatic_range_rate_D_x)
    t31 = divide(other_place_y, other_range, bistatic_range_rate_D_y)
    t33 = multiply(t20, velocity_x, w0)
    t34 = multiply(t21, velocity_y, w1)
    range_rate = add(t33, t34, w0)
    t36 = multiply(t30, other_velocity_x, w1)
    t37 = multiply(t31, other_velocity_y, w6)
    other_range_rate = add(t36, t37, w1)
    t42 = multiply(range_rate, t20, w6)
    t43 = subtract(velocity_x, t42, w2)
    turning_x = divide(t43, slant_range, w2)
    t45 = multiply(range_rate, t21, w6)
    t46 = subtract(velocity_y, t45, w3)
    turning_y = divide(t46, slant_range, w3)
    t48 = multiply(other_range_rate, t30, w6)
    t49 = subtract(other_velocity_x, t48, w4)
    other_turning_x = divide(t49, other_range, w4)
    t51 = multiply(other_range_rate, t31, w6)
    t52 = subtract(other_velocity_y, t51, w5)
    other_turning_y = divide(t52, other_range, w5)
    add(slant_range, other_range, bistatic_range)
    add(range_rate, other_range_rate, bistatic_range_rate)
    add(t20, t30, bistatic_range_D_x)
    add(t21, t31, bistatic_range_D_y)
    add(turning_x, other_turning_x, bistatic_range_rate_D_x)
    add(turning_y, other_turning_y, bistatic_range_rate_D_y)


def _bistatic_range_doppler_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        first_station_x,
        first_station_y,
        _first_station_velocity_x,
        _first_station_velocity_y,
        _second_station_x,
        _second_station_y,
        _second_station_velocity_x,
        _second_station_velocity_y,
    ) = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    t16 = square(place_x, w0)
    t17 = square(place_y, w1)
    t18 = add(t16, t17, w0)
    sqrt(t18, slant_range)


def _bistatic_range_doppler_in_plane_other_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        _first_station_x,
        _first_station_y,
        _first_station_velocity_x,
        _first_station_velocity_y,
        second_station_x,
        second_station_y,
        _second_station_velocity_x,
        _second_station_velocity_y,
    ) = given
    (other_range,) = out
    w0, w1 = work
    other_place_x = subtract(target_x, second_station_x, w0)
    other_place_y = subtract(target_y, second_station_y, w1)
    t26 = square(other_place_x, w0)
    t27 = square(other_place_y, w1)
    t28 = add(t26, t27, w0)
    sqrt(t28, other_range)


_BISTATIC_RANGE_DOPPLER_IN_PLANE = Signature(
    "bistatic_range_doppler_in_plane",
    (
        _TARGET_X_DOMAIN,
        _TARGET_Y_DOMAIN,
        _TARGET_VELOCITY_X_DOMAIN,
        _TARGET_VELOCITY_Y_DOMAIN,
        _FIRST_STATION_X_DOMAIN,
        _FIRST_STATION_Y_DOMAIN,
        _FIRST_STATION_VELOCITY_X_DOMAIN,
        _FIRST_STATION_VELOCITY_Y_DOMAIN,
        _SECOND_STATION_X_DOMAIN,
        _SECOND_STATION_Y_DOMAIN,
        _SECOND_STATION_VELOCITY_X_DOMAIN,
        _SECOND_STATION_VELOCITY_Y_DOMAIN,
    ),
    (
        "bistatic_range",
        "bistatic_range_rate",
        "bistatic_range_D_x",
        "bistatic_range_D_y",
        "bistatic_range_rate_D_x",
        "bistatic_range_rate_D_y",
    ),
    8,
    _bistatic_range_doppler_in_plane_block,
    (
        Required(
            "distance of the target from the first station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _bistatic_range_doppler_in_plane_slant_range_block,
            (0, 4),
        ),
        Required(
            "distance of the target from the second station",
            "at least 1e-20, in float32 1e-6",
            1e-20,
            9.999999974752427e-07,
            2,
            _bistatic_range_doppler_in_plane_other_range_block,
            (0, 8),
        ),
    ),
    numbers=_bistatic_range_doppler_in_plane_of_numbers,
)


class RangeDopplerDifferenceInPlane(NamedTuple):
    """Result of `range_doppler_difference_in_plane`."""

    range_difference: Real
    """Distance from the first station less that from the second, m."""
    range_rate_difference: Real
    """Its rate, m/s."""
    range_difference_D_x: Real
    """Derivative of the difference of the ranges by the target's position along x,
    dimensionless."""
    range_difference_D_y: Real
    """Derivative of the difference of the ranges by the target's position along y,
    dimensionless."""
    range_rate_difference_D_x: Real
    """Derivative of the difference of the range rates by the target's position along x, 1/s."""
    range_rate_difference_D_y: Real
    """Derivative of the difference of the range rates by the target's position along y, 1/s."""


def range_doppler_difference_in_plane(
    target_x: ArrayLike,
    target_y: ArrayLike,
    target_velocity_x: ArrayLike,
    target_velocity_y: ArrayLike,
    first_station_x: ArrayLike,
    first_station_y: ArrayLike,
    first_station_velocity_x: ArrayLike,
    first_station_velocity_y: ArrayLike,
    second_station_x: ArrayLike,
    second_station_y: ArrayLike,
    second_station_velocity_x: ArrayLike,
    second_station_velocity_y: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> RangeDopplerDifferenceInPlane:
    """Differences of range and range rate at two stations (TDOA, FDOA) in the plane.

        f_1 - f_2 = s'(r_1 + r_2)/(f_1 + f_2), r = target - station, s = second - first station,
        so that errors are parts of |s| and not of the ranges: terms, those of r_1 and of r_2
        each for itself, add up to at most |s|;
        u_1 - u_2 = (s - (f_1 - f_2) u_2)/f_1, g_1 - g_2 = u_1's_v + (u_1 - u_2)'w_2,
        h_1 - h_2 = (s_v - (g_1 - g_2) u_1 - g_2 (u_1 - u_2) - (f_1 - f_2) h_2)/f_1 with the
        f, g, u, h of `range_doppler`; derivatives by a station's position and velocity are those
        of its own range and rate

    target_x: position of the target along x, m; of magnitude at most 1e40, in float32 1e10.
    target_y: position of the target along y, m; of magnitude at most 1e40, in float32 1e10.
    target_velocity_x: velocity of the target along x, m/s; of magnitude at most 1e30, in float32
        1e6.
    target_velocity_y: velocity of the target along y, m/s; of magnitude at most 1e30, in float32
        1e6.
    first_station_x: position of the first station along x, m; of magnitude at most 1e40, in float32
        1e10.
    first_station_y: position of the first station along y, m; of magnitude at most 1e40, in float32
        1e10.
    first_station_velocity_x: velocity of the first station along x, m/s; of magnitude at most 1e30,
        in float32 1e6.
    first_station_velocity_y: velocity of the first station along y, m/s; of magnitude at most 1e30,
        in float32 1e6.
    second_station_x: position of the second station along x, m; of magnitude at most 1e40, in
        float32 1e10.
    second_station_y: position of the second station along y, m; of magnitude at most 1e40, in
        float32 1e10.
    second_station_velocity_x: velocity of the second station along x, m/s; of magnitude at most
        1e30, in float32 1e6.
    second_station_velocity_y: velocity of the second station along y, m/s; of magnitude at most
        1e30, in float32 1e6.

    The distance of the target from the first station, of the inputs together, must be at least
        1e-20, in float32 1.
    The distance of the target from the second station, of the inputs together, must be at least
        1e-20, in float32 1.

    range_difference: distance from the first station less that from the second, m. Error over the
        sum of its terms taken positive at most 5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32),
        proved for every input, and 5e-303 (float64) and 3e-44 (float32) beside it where a product
        underflows. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 3e-7 in float64 and 0.008 in float32 of what its error
        is relative to; values below 5e-288 (float64) apart; what cancels: target_x -
        first_station_x + target_x - second_station_x.
    range_rate_difference: its rate, m/s. Error over the sum of its terms taken positive at most
        12.51 * 2^-52 (float64), 12.51 * 2^-23 (float32), proved for every input, and 2e-171
        (float64) and 5e-17 (float32) beside it where a product underflows. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        7e-7 in float64 and 0.02 in float32 of what its error is relative to; values below 6e-157
        (float64) and 4e-11 (float32) apart; what cancels: second_station_x - first_station_x -
        ...*(target_x - second_station_x)/....
    range_difference_D_x: derivative of the difference of the ranges by the target's position along
        x, dimensionless. Error over the sum of its terms taken positive at most 10.51 * 2^-52
        (float64), 10.51 * 2^-23 (float32), proved for every input, and 5e-202 (float64) and 2e-23
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 2e-187 (float64) and
        1e-17 (float32) apart; what cancels: second_station_x - first_station_x - ...*(target_x -
        second_station_x)/....
    range_difference_D_y: derivative of the difference of the ranges by the target's position along
        y, dimensionless. Error over the sum of its terms taken positive at most 10.51 * 2^-52
        (float64), 10.51 * 2^-23 (float32), proved for every input, and 5e-202 (float64) and 2e-23
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 6e-7 in float64
        and 0.02 in float32 of what its error is relative to; values below 2e-187 (float64) and
        1e-17 (float32) apart; what cancels: second_station_y - first_station_y - ...*(target_y -
        second_station_y)/....
    range_rate_difference_D_x: derivative of the difference of the range rates by the target's
        position along x, 1/s. Error over the sum of its terms taken positive at most 19.01 * 2^-52
        (float64), 19.01 * 2^-23 (float32), proved for every input, and 1e-150 (float64) and 3e-16
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 1e-6 in float64
        and 0.04 in float32 of what its error is relative to; values below 3e-136 (float64) and
        2e-10 (float32) apart; what cancels: second_station_x - first_station_x - ...*(target_x -
        second_station_x)/....
    range_rate_difference_D_y: derivative of the difference of the range rates by the target's
        position along y, 1/s. Error over the sum of its terms taken positive at most 19.01 * 2^-52
        (float64), 19.01 * 2^-23 (float32), proved for every input, and 1e-150 (float64) and 3e-16
        (float32) beside it where a product underflows. Digits that can be lost: up to 16 of 16 in
        float64 and 7 of 7 in float32; half or more only where the value is below 1e-6 in float64
        and 0.04 in float32 of what its error is relative to; values below 3e-136 (float64) and
        2e-10 (float32) apart; what cancels: second_station_y - first_station_y - ...*(target_y -
        second_station_y)/....

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation range-doppler
    """
    if (
        type(target_x) is float
        and type(target_y) is float
        and type(target_velocity_x) is float
        and type(target_velocity_y) is float
        and type(first_station_x) is float
        and type(first_station_y) is float
        and type(first_station_velocity_x) is float
        and type(first_station_velocity_y) is float
        and type(second_station_x) is float
        and type(second_station_y) is float
        and type(second_station_velocity_x) is float
        and type(second_station_velocity_y) is float
        and -1e40 <= target_x <= 1e40
        and -1e40 <= target_y <= 1e40
        and -1e30 <= target_velocity_x <= 1e30
        and -1e30 <= target_velocity_y <= 1e30
        and -1e40 <= first_station_x <= 1e40
        and -1e40 <= first_station_y <= 1e40
        and -1e30 <= first_station_velocity_x <= 1e30
        and -1e30 <= first_station_velocity_y <= 1e30
        and -1e40 <= second_station_x <= 1e40
        and -1e40 <= second_station_y <= 1e40
        and -1e30 <= second_station_velocity_x <= 1e30
        and -1e30 <= second_station_velocity_y <= 1e30
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RangeDopplerDifferenceInPlane,
                _range_doppler_difference_in_plane_of_numbers(
                    target_x,
                    target_y,
                    target_velocity_x,
                    target_velocity_y,
                    first_station_x,
                    first_station_y,
                    first_station_velocity_x,
                    first_station_velocity_y,
                    second_station_x,
                    second_station_y,
                    second_station_velocity_x,
                    second_station_velocity_y,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RangeDopplerDifferenceInPlane(
        *evaluate(
            _RANGE_DOPPLER_DIFFERENCE_IN_PLANE,
            (
                target_x,
                target_y,
                target_velocity_x,
                target_velocity_y,
                first_station_x,
                first_station_y,
                first_station_velocity_x,
                first_station_velocity_y,
                second_station_x,
                second_station_y,
                second_station_velocity_x,
                second_station_velocity_y,
            ),
            out,
            workers,
        )
    )


def _range_doppler_difference_in_plane_of_numbers(
    target_x: float,
    target_y: float,
    target_velocity_x: float,
    target_velocity_y: float,
    first_station_x: float,
    first_station_y: float,
    first_station_velocity_x: float,
    first_station_velocity_y: float,
    second_station_x: float,
    second_station_y: float,
    second_station_velocity_x: float,
    second_station_velocity_y: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t12 = target_x - first_station_x
    t13 = target_y - first_station_y
    t17 = form.sqrt((t12 * t12) + (t13 * t13))
    t18 = t12 / t17
    t19 = t13 / t17
    t20 = target_x - second_station_x
    t21 = target_y - second_station_y
    t22 = target_velocity_x - second_station_velocity_x
    t23 = target_velocity_y - second_station_velocity_y
    t27 = form.sqrt((t20 * t20) + (t21 * t21))
    t28 = t20 / t27
    t29 = t21 / t27
    t30 = second_station_x - first_station_x
    t31 = second_station_y - first_station_y
    t32 = second_station_velocity_x - first_station_velocity_x
    t33 = second_station_velocity_y - first_station_velocity_y
    t38 = (t30 * (t12 + t20)) + (t31 * (t13 + t21))
    t40 = t38 / (t17 + t27)
    t43 = (t30 - (t40 * t28)) / t17
    t46 = (t31 - (t40 * t29)) / t17
    t53 = ((t18 * t32) + (t19 * t33)) + ((t43 * t22) + (t46 * t23))
    t56 = (t28 * t22) + (t29 * t23)
    t68 = ((t32 - (t53 * t18)) - (t56 * t43)) - (t40 * ((t22 - (t56 * t28)) / t27))
    t75 = ((t33 - (t53 * t19)) - (t56 * t46)) - (t40 * ((t23 - (t56 * t29)) / t27))
    t69 = t68 / t17
    t76 = t75 / t17
    if not t17 >= (1.0 if form.single else 1e-20):
        raise ValueError
    if not t27 >= (1.0 if form.single else 1e-20):
        raise ValueError
    return (t40, t53, t43, t46, t69, t76)


def _range_doppler_difference_in_plane_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        target_velocity_x,
        target_velocity_y,
        first_station_x,
        first_station_y,
        first_station_velocity_x,
        first_station_velocity_y,
        second_station_x,
        second_station_y,
        second_station_velocity_x,
        second_station_velocity_y,
    ) = given
    (
        range_difference,
        range_rate_difference,
        range_difference_D_x,
        range_difference_D_y,
        range_rate_difference_D_x,
        range_rate_difference_D_y,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    t14 = square(place_x, w2)
    t15 = square(place_y, w3)
    t16 = add(t14, t15, w2)
    slant_range = sqrt(t16, range_rate_difference_D_y)
    t18 = divide(place_x, slant_range, range_rate_difference_D_x)
    t19 = divide(place_y, slant_range, w2)
    other_place_x = subtract(target_x, second_station_x, w3)
    other_place_y = subtract(target_y, second_station_y, w4)
    other_velocity_x = subtract(target_velocity_x, second_station_velocity_x, w5)
    other_velocity_y = subtract(target_velocity_y, second_station_velocity_y, w6)
    t24 = square(other_place_x, w7)
    t25 = square(other_place_y, w8)
    t26 = add(t24, t25, w7)
    other_range = sqrt(t26, w7)
    t28 = divide(other_place_x, other_range, w8)
    t29 = divide(other_place_y, other_range, w9)
    baseline_x = subtract(second_station_x, first_station_x, w10)
    baseline_y = subtract(second_station_y, first_station_y, w11)
    drift_x = subtract(second_station_velocity_x, first_station_velocity_x, w12)
    drift_y = subtract(second_station_velocity_y, first_station_velocity_y, w13)
    reach_x = add(place_x, other_place_x, w0)
    reach_y = add(place_y, other_place_y, w1)
    t36 = multiply(baseline_x, reach_x, w0)
    t37 = multiply(baseline_y, reach_y, w1)
    t38 = add(t36, t37, w0)
    t39 = add(slant_range, other_range, w1)
    divide(t38, t39, range_difference)
    t41 = multiply(range_difference, t28, w0)
    t42 = subtract(baseline_x, t41, w10)
    divide(t42, slant_range, range_difference_D_x)
    t44 = multiply(range_difference, t29, w0)
    t45 = subtract(baseline_y, t44, w11)
    divide(t45, slant_range, range_difference_D_y)
    t47 = multiply(t18, drift_x, w0)
    t48 = multiply(t19, drift_y, w1)
    t49 = add(t47, t48, w0)
    t50 = multiply(range_difference_D_x, other_velocity_x, w1)
    t51 = multiply(range_difference_D_y, other_velocity_y, w3)
    t52 = add(t50, t51, w1)
    add(t49, t52, range_rate_difference)
    t54 = multiply(t28, other_velocity_x, w0)
    t55 = multiply(t29, other_velocity_y, w1)
    other_range_rate = add(t54, t55, w0)
    t57 = multiply(other_range_rate, t28, w8)
    t58 = subtract(other_velocity_x, t57, w5)
    other_turning_x = divide(t58, other_range, w5)
    t60 = multiply(other_range_rate, t29, w9)
    t61 = subtract(other_velocity_y, t60, w6)
    other_turning_y = divide(t61, other_range, w6)
    t63 = multiply(range_rate_difference, t18, range_rate_difference_D_x)
    t64 = subtract(drift_x, t63, w12)
    t65 = multiply(other_range_rate, range_difference_D_x, w1)
    t66 = subtract(t64, t65, w12)
    t67 = multiply(range_difference, other_turning_x, w5)
    t68 = subtract(t66, t67, w12)
    t70 = multiply(range_rate_difference, t19, w2)
    t71 = subtract(drift_y, t70, w13)
    t72 = multiply(other_range_rate, range_difference_D_y, w0)
    t73 = subtract(t71, t72, w13)
    t74 = multiply(range_difference, other_turning_y, w6)
    t75 = subtract(t73, t74, w13)
    divide(t68, slant_range, range_rate_difference_D_x)
    divide(t75, slant_range, range_rate_difference_D_y)


def _range_doppler_difference_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        first_station_x,
        first_station_y,
        _first_station_velocity_x,
        _first_station_velocity_y,
        _second_station_x,
        _second_station_y,
        _second_station_velocity_x,
        _second_station_velocity_y,
    ) = given
    (slant_range,) = out
    w0, w1 = work
    place_x = subtract(target_x, first_station_x, w0)
    place_y = subtract(target_y, first_station_y, w1)
    t14 = square(place_x, w0)
    t15 = square(place_y, w1)
    t16 = add(t14, t15, w0)
    sqrt(t16, slant_range)


def _range_doppler_difference_in_plane_other_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    (
        target_x,
        target_y,
        _target_velocity_x,
        _target_velocity_y,
        _first_station_x,
        _first_station_y,
        _first_station_velocity_x,
        _first_station_velocity_y,
        second_station_x,
        second_station_y,
        _second_station_velocity_x,
        _second_station_velocity_y,
    ) = given
    (other_range,) = out
    w0, w1 = work
    other_place_x = subtract(target_x, second_station_x, w0)
    other_place_y = subtract(target_y, second_station_y, w1)
    t24 = square(other_place_x, w0)
    t25 = square(other_place_y, w1)
    t26 = add(t24, t25, w0)
    sqrt(t26, other_range)


_RANGE_DOPPLER_DIFFERENCE_IN_PLANE = Signature(
    "range_doppler_difference_in_plane",
    (
        _TARGET_X_DOMAIN_2,
        _TARGET_Y_DOMAIN_2,
        _TARGET_VELOCITY_X_DOMAIN_2,
        _TARGET_VELOCITY_Y_DOMAIN_2,
        _FIRST_STATION_X_DOMAIN_2,
        _FIRST_STATION_Y_DOMAIN_2,
        _FIRST_STATION_VELOCITY_X_DOMAIN_2,
        _FIRST_STATION_VELOCITY_Y_DOMAIN_2,
        _SECOND_STATION_X_DOMAIN_2,
        _SECOND_STATION_Y_DOMAIN_2,
        _SECOND_STATION_VELOCITY_X_DOMAIN_2,
        _SECOND_STATION_VELOCITY_Y_DOMAIN_2,
    ),
    (
        "range_difference",
        "range_rate_difference",
        "range_difference_D_x",
        "range_difference_D_y",
        "range_rate_difference_D_x",
        "range_rate_difference_D_y",
    ),
    14,
    _range_doppler_difference_in_plane_block,
    (
        Required(
            "distance of the target from the first station",
            "at least 1e-20, in float32 1",
            1e-20,
            1.0,
            2,
            _range_doppler_difference_in_plane_slant_range_block,
            (0, 4),
        ),
        Required(
            "distance of the target from the second station",
            "at least 1e-20, in float32 1",
            1e-20,
            1.0,
            2,
            _range_doppler_difference_in_plane_other_range_block,
            (0, 8),
        ),
    ),
    numbers=_range_doppler_difference_in_plane_of_numbers,
)
