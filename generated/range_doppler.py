# Made by: gainproof generate range-doppler
# From: gainproof derive range-doppler, SymPy 1.14.0
"""Range and Doppler of moving targets from moving stations."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Required, Signature

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.generated._signature import Arrays, Real

__all__ = [
    "RangeDoppler",
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
    "range_doppler",
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
    return SlantRange(
        *evaluate(
            _SLANT_RANGE,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
        )
    )


def _slant_range_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    t6 = np.subtract(target_x, station_x, w0)
    t7 = np.subtract(target_y, station_y, w1)
    t8 = np.subtract(target_z, station_z, w2)
    t9 = np.square(t6, w0)
    t10 = np.square(t7, w1)
    t11 = np.square(t8, w2)
    t12 = np.add(t9, t10, w0)
    t13 = np.add(t12, t11, w0)
    np.sqrt(t13, slant_range)


def _slant_range_slant_range_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    t6 = np.subtract(target_x, station_x, w0)
    t7 = np.subtract(target_y, station_y, w1)
    t8 = np.subtract(target_z, station_z, w2)
    t9 = np.square(t6, w0)
    t10 = np.square(t7, w1)
    t11 = np.square(t8, w2)
    t12 = np.add(t9, t10, w0)
    t13 = np.add(t12, t11, w0)
    np.sqrt(t13, slant_range)


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
        ),
    ),
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
    return RangeJacobian(
        *evaluate(
            _RANGE_JACOBIAN,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
        )
    )


def _range_jacobian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    range_D_x, range_D_y, range_D_z = out
    w0, w1, w2, w3, w4, w5 = work
    t6 = np.subtract(target_x, station_x, w0)
    t7 = np.subtract(target_y, station_y, w1)
    t8 = np.subtract(target_z, station_z, w2)
    t9 = np.square(t6, w3)
    t10 = np.square(t7, w4)
    t11 = np.square(t8, w5)
    t12 = np.add(t9, t10, w3)
    t13 = np.add(t12, t11, w3)
    slant_range = np.sqrt(t13, range_D_z)
    np.divide(t6, slant_range, range_D_x)
    np.divide(t7, slant_range, range_D_y)
    np.divide(t8, slant_range, range_D_z)


def _range_jacobian_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    t6 = np.subtract(target_x, station_x, w0)
    t7 = np.subtract(target_y, station_y, w1)
    t8 = np.subtract(target_z, station_z, w2)
    t9 = np.square(t6, w0)
    t10 = np.square(t7, w1)
    t11 = np.square(t8, w2)
    t12 = np.add(t9, t10, w0)
    t13 = np.add(t12, t11, w0)
    np.sqrt(t13, slant_range)


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
        ),
    ),
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
        input, and 2e-262 (float64) and 5e-35 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t15 = np.subtract(target_velocity_x, station_velocity_x, w3)
    t16 = np.subtract(target_velocity_y, station_velocity_y, w4)
    t17 = np.subtract(target_velocity_z, station_velocity_z, w5)
    t18 = np.square(t12, w6)
    t19 = np.square(t13, w7)
    t20 = np.square(t14, w8)
    t21 = np.add(t18, t19, w6)
    t22 = np.add(t21, t20, w6)
    slant_range = np.sqrt(t22, range_rate)
    t24 = np.divide(t12, slant_range, w0)
    t25 = np.divide(t13, slant_range, w1)
    t26 = np.divide(t14, slant_range, w2)
    t27 = np.multiply(t24, t15, w0)
    t28 = np.multiply(t25, t16, w1)
    t29 = np.multiply(t26, t17, w2)
    t30 = np.add(t27, t28, w0)
    np.add(t30, t29, range_rate)


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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t18 = np.square(t12, w0)
    t19 = np.square(t13, w1)
    t20 = np.square(t14, w2)
    t21 = np.add(t18, t19, w0)
    t22 = np.add(t21, t20, w0)
    np.sqrt(t22, slant_range)


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
        ),
    ),
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
        a product underflows.
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows.
    range_rate_D_z: derivative of the range rate by the target's position along z, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows.
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t15 = np.subtract(target_velocity_x, station_velocity_x, w3)
    t16 = np.subtract(target_velocity_y, station_velocity_y, w4)
    t17 = np.subtract(target_velocity_z, station_velocity_z, w5)
    t18 = np.square(t12, w6)
    t19 = np.square(t13, w7)
    t20 = np.square(t14, w8)
    t21 = np.add(t18, t19, w6)
    t22 = np.add(t21, t20, w6)
    slant_range = np.sqrt(t22, range_rate_D_z)
    np.divide(t12, slant_range, range_rate_D_velocity_x)
    np.divide(t13, slant_range, range_rate_D_velocity_y)
    np.divide(t14, slant_range, range_rate_D_velocity_z)
    t27 = np.multiply(range_rate_D_velocity_x, t15, w0)
    t28 = np.multiply(range_rate_D_velocity_y, t16, w1)
    t29 = np.multiply(range_rate_D_velocity_z, t17, w2)
    t30 = np.add(t27, t28, w0)
    range_rate = np.add(t30, t29, w0)
    t32 = np.multiply(range_rate, range_rate_D_velocity_x, w1)
    t33 = np.subtract(t15, t32, w3)
    t35 = np.multiply(range_rate, range_rate_D_velocity_y, w1)
    t36 = np.subtract(t16, t35, w4)
    t38 = np.multiply(range_rate, range_rate_D_velocity_z, w0)
    t39 = np.subtract(t17, t38, w5)
    np.divide(t33, slant_range, range_rate_D_x)
    np.divide(t36, slant_range, range_rate_D_y)
    np.divide(t39, slant_range, range_rate_D_z)


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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t18 = np.square(t12, w0)
    t19 = np.square(t13, w1)
    t20 = np.square(t14, w2)
    t21 = np.add(t18, t19, w0)
    t22 = np.add(t21, t20, w0)
    np.sqrt(t22, slant_range)


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
        ),
    ),
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
        input, and 2e-262 (float64) and 5e-35 (float32) beside it where a product underflows.
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
        a product underflows.
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows.
    range_rate_D_z: derivative of the range rate by the target's position along z, 1/s. Error over
        the sum of its terms taken positive at most 10.76 * 2^-52 (float64), 10.76 * 2^-23
        (float32), proved for every input, and 4e-242 (float64) and 9e-29 (float32) beside it where
        a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t15 = np.subtract(target_velocity_x, station_velocity_x, w3)
    t16 = np.subtract(target_velocity_y, station_velocity_y, w4)
    t17 = np.subtract(target_velocity_z, station_velocity_z, w5)
    t18 = np.square(t12, w6)
    t19 = np.square(t13, w7)
    t20 = np.square(t14, w8)
    t21 = np.add(t18, t19, w6)
    t22 = np.add(t21, t20, w6)
    np.sqrt(t22, slant_range)
    np.divide(t12, slant_range, range_D_x)
    np.divide(t13, slant_range, range_D_y)
    np.divide(t14, slant_range, range_D_z)
    t27 = np.multiply(range_D_x, t15, w0)
    t28 = np.multiply(range_D_y, t16, w1)
    t29 = np.multiply(range_D_z, t17, w2)
    t30 = np.add(t27, t28, w0)
    np.add(t30, t29, range_rate)
    t32 = np.multiply(range_rate, range_D_x, w0)
    t33 = np.subtract(t15, t32, w3)
    t35 = np.multiply(range_rate, range_D_y, w0)
    t36 = np.subtract(t16, t35, w4)
    t38 = np.multiply(range_rate, range_D_z, w0)
    t39 = np.subtract(t17, t38, w5)
    np.divide(t33, slant_range, range_rate_D_x)
    np.divide(t36, slant_range, range_rate_D_y)
    np.divide(t39, slant_range, range_rate_D_z)


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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t18 = np.square(t12, w0)
    t19 = np.square(t13, w1)
    t20 = np.square(t14, w2)
    t21 = np.add(t18, t19, w0)
    t22 = np.add(t21, t20, w0)
    np.sqrt(t22, slant_range)


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
        ),
    ),
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
    return RangeHessian(
        *evaluate(
            _RANGE_HESSIAN,
            (target_x, target_y, target_z, station_x, station_y, station_z),
            out,
        )
    )


def _range_hessian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    range_D_xx, range_D_xy, range_D_xz, range_D_yy, range_D_yz, range_D_zz = out
    w0, w1, w2, w3, w4, w5 = work
    t6 = np.subtract(target_x, station_x, w0)
    t7 = np.subtract(target_y, station_y, w1)
    t8 = np.subtract(target_z, station_z, w2)
    t9 = np.square(t6, w3)
    t10 = np.square(t7, w4)
    t11 = np.square(t8, w5)
    t12 = np.add(t9, t10, w3)
    t13 = np.add(t12, t11, w3)
    slant_range = np.sqrt(t13, range_D_zz)
    t15 = np.divide(t6, slant_range, range_D_xx)
    t16 = np.divide(t7, slant_range, range_D_xy)
    t17 = np.divide(t8, slant_range, range_D_xz)
    t18 = np.square(t16, w0)
    t19 = np.square(t17, w1)
    t20 = np.add(t18, t19, w2)
    t21 = np.multiply(t15, t16, w3)
    t22 = np.negative(t21, w3)
    t23 = np.multiply(t15, t17, w4)
    t24 = np.negative(t23, w4)
    t25 = np.square(t15, range_D_xx)
    t26 = np.add(t25, t19, w1)
    t27 = np.multiply(t16, t17, range_D_xy)
    t28 = np.negative(t27, w5)
    t29 = np.add(t25, t18, w0)
    np.divide(t20, slant_range, range_D_xx)
    np.divide(t22, slant_range, range_D_xy)
    np.divide(t24, slant_range, range_D_xz)
    np.divide(t26, slant_range, range_D_yy)
    np.divide(t28, slant_range, range_D_yz)
    np.divide(t29, slant_range, range_D_zz)


def _range_hessian_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, target_z, station_x, station_y, station_z = given
    (slant_range,) = out
    w0, w1, w2 = work
    t6 = np.subtract(target_x, station_x, w0)
    t7 = np.subtract(target_y, station_y, w1)
    t8 = np.subtract(target_z, station_z, w2)
    t9 = np.square(t6, w0)
    t10 = np.square(t7, w1)
    t11 = np.square(t8, w2)
    t12 = np.add(t9, t10, w0)
    t13 = np.add(t12, t11, w0)
    np.sqrt(t13, slant_range)


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
        ),
    ),
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
        beside it where a product underflows.
    range_rate_D_xy: second derivative of the range rate by the target's position along x and y,
        1/(m s). Error over the sum of its terms taken positive at most 17.26 * 2^-52 (float64),
        17.26 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 5e-22 (float32)
        beside it where a product underflows.
    range_rate_D_xz: second derivative of the range rate by the target's position along x and z,
        1/(m s). Error over the sum of its terms taken positive at most 17.26 * 2^-52 (float64),
        17.26 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 5e-22 (float32)
        beside it where a product underflows.
    range_rate_D_yy: second derivative of the range rate by the target's position along y, twice,
        1/(m s). Error over the sum of its terms taken positive at most 16.76 * 2^-52 (float64),
        16.76 * 2^-23 (float32), proved for every input, and 3e-221 (float64) and 7e-22 (float32)
        beside it where a product underflows.
    range_rate_D_yz: second derivative of the range rate by the target's position along y and z,
        1/(m s). Error over the sum of its terms taken positive at most 17.26 * 2^-52 (float64),
        17.26 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 5e-22 (float32)
        beside it where a product underflows.
    range_rate_D_zz: second derivative of the range rate by the target's position along z, twice,
        1/(m s). Error over the sum of its terms taken positive at most 16.76 * 2^-52 (float64),
        16.76 * 2^-23 (float32), proved for every input, and 3e-221 (float64) and 7e-22 (float32)
        beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


def _range_rate_hessian_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t15 = np.subtract(target_velocity_x, station_velocity_x, w3)
    t16 = np.subtract(target_velocity_y, station_velocity_y, w4)
    t17 = np.subtract(target_velocity_z, station_velocity_z, w5)
    t18 = np.square(t12, w6)
    t19 = np.square(t13, w7)
    t20 = np.square(t14, w8)
    t21 = np.add(t18, t19, w6)
    t22 = np.add(t21, t20, w6)
    slant_range = np.sqrt(t22, range_rate_D_zz)
    t24 = np.divide(t12, slant_range, range_rate_D_xx)
    t25 = np.divide(t13, slant_range, range_rate_D_xy)
    t26 = np.divide(t14, slant_range, range_rate_D_xz)
    t27 = np.multiply(t24, t15, w0)
    t28 = np.multiply(t25, t16, w1)
    t29 = np.multiply(t26, t17, w2)
    t30 = np.add(t27, t28, w0)
    range_rate = np.add(t30, t29, w0)
    t32 = np.multiply(range_rate, t24, w1)
    t33 = np.subtract(t15, t32, w3)
    turning_x = np.divide(t33, slant_range, range_rate_D_yy)
    t35 = np.multiply(range_rate, t25, w1)
    t36 = np.subtract(t16, t35, w4)
    turning_y = np.divide(t36, slant_range, range_rate_D_yz)
    t38 = np.multiply(range_rate, t26, w1)
    t39 = np.subtract(t17, t38, w5)
    turning_z = np.divide(t39, slant_range, w5)
    t41 = np.divide(range_rate, slant_range, w0)
    t42 = np.square(t25, w1)
    t43 = np.square(t26, w2)
    t44 = np.add(t42, t43, w3)
    t45 = np.multiply(t24, t25, w4)
    t46 = np.negative(t45, w4)
    t47 = np.multiply(t24, t26, w6)
    t48 = np.negative(t47, w6)
    t49 = np.square(t24, w7)
    t50 = np.add(t49, t43, w2)
    t51 = np.multiply(t25, t26, w8)
    t52 = np.negative(t51, w8)
    t53 = np.add(t49, t42, w7)
    t54 = np.multiply(t24, turning_x, w1)
    t56 = np.multiply(t54, 2.0, w1)
    t57 = np.multiply(t41, t44, w3)
    t58 = np.add(t56, t57, w1)
    t59 = np.negative(t58, w1)
    t61 = np.multiply(t24, turning_y, w3)
    t62 = np.multiply(t25, turning_x, w9)
    t63 = np.add(t61, t62, w3)
    t64 = np.multiply(t41, t46, w4)
    t65 = np.add(t63, t64, w3)
    t66 = np.negative(t65, w3)
    t68 = np.multiply(t24, turning_z, range_rate_D_xx)
    t69 = np.multiply(t26, turning_x, range_rate_D_yy)
    t70 = np.add(t68, t69, range_rate_D_xx)
    t71 = np.multiply(t41, t48, w6)
    t72 = np.add(t70, t71, range_rate_D_xx)
    t73 = np.negative(t72, w4)
    t75 = np.multiply(t25, turning_y, w6)
    t76 = np.multiply(t75, 2.0, w6)
    t77 = np.multiply(t41, t50, w2)
    t78 = np.add(t76, t77, w6)
    t79 = np.negative(t78, w6)
    t81 = np.multiply(t25, turning_z, range_rate_D_xy)
    t82 = np.multiply(t26, turning_y, range_rate_D_yz)
    t83 = np.add(t81, t82, range_rate_D_xy)
    t84 = np.multiply(t41, t52, w8)
    t85 = np.add(t83, t84, range_rate_D_xy)
    t86 = np.negative(t85, w2)
    t88 = np.multiply(t26, turning_z, range_rate_D_xz)
    t89 = np.multiply(t88, 2.0, range_rate_D_xz)
    t90 = np.multiply(t41, t53, w0)
    t91 = np.add(t89, t90, range_rate_D_xz)
    t92 = np.negative(t91, w0)
    np.divide(t59, slant_range, range_rate_D_xx)
    np.divide(t66, slant_range, range_rate_D_xy)
    np.divide(t73, slant_range, range_rate_D_xz)
    np.divide(t79, slant_range, range_rate_D_yy)
    np.divide(t86, slant_range, range_rate_D_yz)
    np.divide(t92, slant_range, range_rate_D_zz)


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
    t12 = np.subtract(target_x, station_x, w0)
    t13 = np.subtract(target_y, station_y, w1)
    t14 = np.subtract(target_z, station_z, w2)
    t18 = np.square(t12, w0)
    t19 = np.square(t13, w1)
    t20 = np.square(t14, w2)
    t21 = np.add(t18, t19, w0)
    t22 = np.add(t21, t20, w0)
    np.sqrt(t22, slant_range)


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
        ),
    ),
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
    return SlantRangeInPlane(
        *evaluate(_SLANT_RANGE_IN_PLANE, (target_x, target_y, station_x, station_y), out)
    )


def _slant_range_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    t4 = np.subtract(target_x, station_x, w0)
    t5 = np.subtract(target_y, station_y, w1)
    t6 = np.square(t4, w0)
    t7 = np.square(t5, w1)
    t8 = np.add(t6, t7, w0)
    np.sqrt(t8, slant_range)


def _slant_range_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    t4 = np.subtract(target_x, station_x, w0)
    t5 = np.subtract(target_y, station_y, w1)
    t6 = np.square(t4, w0)
    t7 = np.square(t5, w1)
    t8 = np.add(t6, t7, w0)
    np.sqrt(t8, slant_range)


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
        ),
    ),
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
    return RangeJacobianInPlane(
        *evaluate(_RANGE_JACOBIAN_IN_PLANE, (target_x, target_y, station_x, station_y), out)
    )


def _range_jacobian_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    range_D_x, range_D_y = out
    w0, w1, w2, w3 = work
    t4 = np.subtract(target_x, station_x, w0)
    t5 = np.subtract(target_y, station_y, w1)
    t6 = np.square(t4, w2)
    t7 = np.square(t5, w3)
    t8 = np.add(t6, t7, w2)
    slant_range = np.sqrt(t8, range_D_y)
    np.divide(t4, slant_range, range_D_x)
    np.divide(t5, slant_range, range_D_y)


def _range_jacobian_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    t4 = np.subtract(target_x, station_x, w0)
    t5 = np.subtract(target_y, station_y, w1)
    t6 = np.square(t4, w0)
    t7 = np.square(t5, w1)
    t8 = np.add(t6, t7, w0)
    np.sqrt(t8, slant_range)


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
        ),
    ),
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
        input, and 1e-262 (float64) and 3e-35 (float32) beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


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
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t10 = np.subtract(target_velocity_x, station_velocity_x, w2)
    t11 = np.subtract(target_velocity_y, station_velocity_y, w3)
    t12 = np.square(t8, w4)
    t13 = np.square(t9, w5)
    t14 = np.add(t12, t13, w4)
    slant_range = np.sqrt(t14, range_rate)
    t16 = np.divide(t8, slant_range, w0)
    t17 = np.divide(t9, slant_range, w1)
    t18 = np.multiply(t16, t10, w0)
    t19 = np.multiply(t17, t11, w1)
    np.add(t18, t19, range_rate)


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
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t12 = np.square(t8, w0)
    t13 = np.square(t9, w1)
    t14 = np.add(t12, t13, w0)
    np.sqrt(t14, slant_range)


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
        ),
    ),
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
        underflows.
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32),
        proved for every input, and 3e-242 (float64) and 6e-29 (float32) beside it where a product
        underflows.
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


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
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t10 = np.subtract(target_velocity_x, station_velocity_x, w2)
    t11 = np.subtract(target_velocity_y, station_velocity_y, w3)
    t12 = np.square(t8, w4)
    t13 = np.square(t9, w5)
    t14 = np.add(t12, t13, w4)
    slant_range = np.sqrt(t14, range_rate_D_y)
    np.divide(t8, slant_range, range_rate_D_velocity_x)
    np.divide(t9, slant_range, range_rate_D_velocity_y)
    t18 = np.multiply(range_rate_D_velocity_x, t10, w0)
    t19 = np.multiply(range_rate_D_velocity_y, t11, w1)
    range_rate = np.add(t18, t19, w0)
    t21 = np.multiply(range_rate, range_rate_D_velocity_x, w1)
    t22 = np.subtract(t10, t21, w2)
    t24 = np.multiply(range_rate, range_rate_D_velocity_y, w0)
    t25 = np.subtract(t11, t24, w3)
    np.divide(t22, slant_range, range_rate_D_x)
    np.divide(t25, slant_range, range_rate_D_y)


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
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t12 = np.square(t8, w0)
    t13 = np.square(t9, w1)
    t14 = np.add(t12, t13, w0)
    np.sqrt(t14, slant_range)


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
        ),
    ),
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
        input, and 1e-262 (float64) and 3e-35 (float32) beside it where a product underflows.
    range_D_x: derivative of the range by the target's position along x, dimensionless. Relative
        error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_D_y: derivative of the range by the target's position along y, dimensionless. Relative
        error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input, and
        3e-323 (float64) and 8e-45 (float32) beside it where a product underflows.
    range_rate_D_x: derivative of the range rate by the target's position along x, 1/s. Error over
        the sum of its terms taken positive at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32),
        proved for every input, and 3e-242 (float64) and 6e-29 (float32) beside it where a product
        underflows.
    range_rate_D_y: derivative of the range rate by the target's position along y, 1/s. Error over
        the sum of its terms taken positive at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32),
        proved for every input, and 3e-242 (float64) and 6e-29 (float32) beside it where a product
        underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


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
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t10 = np.subtract(target_velocity_x, station_velocity_x, w2)
    t11 = np.subtract(target_velocity_y, station_velocity_y, w3)
    t12 = np.square(t8, w4)
    t13 = np.square(t9, w5)
    t14 = np.add(t12, t13, w4)
    np.sqrt(t14, slant_range)
    np.divide(t8, slant_range, range_D_x)
    np.divide(t9, slant_range, range_D_y)
    t18 = np.multiply(range_D_x, t10, w0)
    t19 = np.multiply(range_D_y, t11, w1)
    np.add(t18, t19, range_rate)
    t21 = np.multiply(range_rate, range_D_x, w0)
    t22 = np.subtract(t10, t21, w2)
    t24 = np.multiply(range_rate, range_D_y, w0)
    t25 = np.subtract(t11, t24, w3)
    np.divide(t22, slant_range, range_rate_D_x)
    np.divide(t25, slant_range, range_rate_D_y)


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
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t12 = np.square(t8, w0)
    t13 = np.square(t9, w1)
    t14 = np.add(t12, t13, w0)
    np.sqrt(t14, slant_range)


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
        ),
    ),
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
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
    return RangeHessianInPlane(
        *evaluate(_RANGE_HESSIAN_IN_PLANE, (target_x, target_y, station_x, station_y), out)
    )


def _range_hessian_in_plane_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    target_x, target_y, station_x, station_y = given
    range_D_xx, range_D_xy, range_D_yy = out
    w0, w1, w2, w3 = work
    t4 = np.subtract(target_x, station_x, w0)
    t5 = np.subtract(target_y, station_y, w1)
    t6 = np.square(t4, w2)
    t7 = np.square(t5, w3)
    t8 = np.add(t6, t7, w2)
    slant_range = np.sqrt(t8, range_D_yy)
    t10 = np.divide(t4, slant_range, range_D_xx)
    t11 = np.divide(t5, slant_range, range_D_xy)
    t12 = np.square(t11, w0)
    t13 = np.multiply(t10, t11, range_D_xy)
    t14 = np.negative(t13, range_D_xy)
    t15 = np.square(t10, w1)
    np.divide(t12, slant_range, range_D_xx)
    np.divide(t14, slant_range, range_D_xy)
    np.divide(t15, slant_range, range_D_yy)


def _range_hessian_in_plane_slant_range_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool
) -> None:
    target_x, target_y, station_x, station_y = given
    (slant_range,) = out
    w0, w1 = work
    t4 = np.subtract(target_x, station_x, w0)
    t5 = np.subtract(target_y, station_y, w1)
    t6 = np.square(t4, w0)
    t7 = np.square(t5, w1)
    t8 = np.add(t6, t7, w0)
    np.sqrt(t8, slant_range)


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
        ),
    ),
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
        beside it where a product underflows.
    range_rate_D_xy: second derivative of the range rate by the target's position along x and y,
        1/(m s). Error over the sum of its terms taken positive at most 15.51 * 2^-52 (float64),
        15.51 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 4e-22 (float32)
        beside it where a product underflows.
    range_rate_D_yy: second derivative of the range rate by the target's position along y, twice,
        1/(m s). Error over the sum of its terms taken positive at most 15.01 * 2^-52 (float64),
        15.01 * 2^-23 (float32), proved for every input, and 2e-221 (float64) and 4e-22 (float32)
        beside it where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation range-doppler
    """
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
        )
    )


def _range_rate_hessian_in_plane_block(
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
    range_rate_D_xx, range_rate_D_xy, range_rate_D_yy = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t10 = np.subtract(target_velocity_x, station_velocity_x, w2)
    t11 = np.subtract(target_velocity_y, station_velocity_y, w3)
    t12 = np.square(t8, w4)
    t13 = np.square(t9, w5)
    t14 = np.add(t12, t13, w4)
    slant_range = np.sqrt(t14, range_rate_D_yy)
    t16 = np.divide(t8, slant_range, range_rate_D_xx)
    t17 = np.divide(t9, slant_range, range_rate_D_xy)
    t18 = np.multiply(t16, t10, w0)
    t19 = np.multiply(t17, t11, w1)
    range_rate = np.add(t18, t19, w0)
    t21 = np.multiply(range_rate, t16, w1)
    t22 = np.subtract(t10, t21, w2)
    turning_x = np.divide(t22, slant_range, w2)
    t24 = np.multiply(range_rate, t17, w1)
    t25 = np.subtract(t11, t24, w3)
    turning_y = np.divide(t25, slant_range, w3)
    t27 = np.divide(range_rate, slant_range, w0)
    t28 = np.square(t17, w1)
    t29 = np.multiply(t16, t17, w4)
    t30 = np.negative(t29, w4)
    t31 = np.square(t16, w5)
    t32 = np.multiply(t16, turning_x, w6)
    t34 = np.multiply(t32, 2.0, w6)
    t35 = np.multiply(t27, t28, w1)
    t36 = np.add(t34, t35, w6)
    t37 = np.negative(t36, w6)
    t39 = np.multiply(t16, turning_y, range_rate_D_xx)
    t40 = np.multiply(t17, turning_x, w2)
    t41 = np.add(t39, t40, range_rate_D_xx)
    t42 = np.multiply(t27, t30, w4)
    t43 = np.add(t41, t42, range_rate_D_xx)
    t44 = np.negative(t43, w1)
    t46 = np.multiply(t17, turning_y, range_rate_D_xy)
    t47 = np.multiply(t46, 2.0, range_rate_D_xy)
    t48 = np.multiply(t27, t31, w0)
    t49 = np.add(t47, t48, range_rate_D_xy)
    t50 = np.negative(t49, w0)
    np.divide(t37, slant_range, range_rate_D_xx)
    np.divide(t44, slant_range, range_rate_D_xy)
    np.divide(t50, slant_range, range_rate_D_yy)


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
    t8 = np.subtract(target_x, station_x, w0)
    t9 = np.subtract(target_y, station_y, w1)
    t12 = np.square(t8, w0)
    t13 = np.square(t9, w1)
    t14 = np.add(t12, t13, w0)
    np.sqrt(t14, slant_range)


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
        ),
    ),
)
