"""Polar coordinates in forms that take anything with + - * /.

SymPy's symbols, where they are proved, and the nodes of graphs, from which kernels are printed. An
angle is its cosine and its sine; `u_R`, `u_E`, `u_B` are the unit vectors along which the place
moves when range, elevation and bearing grow.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Direction:
    """Cosines and sines of elevation and bearing."""

    cos_e: Any
    sin_e: Any
    cos_b: Any
    sin_b: Any

    @property
    def along(self) -> tuple[Any, Any, Any]:
        """u_R."""
        return self.cos_e * self.sin_b, self.cos_e * self.cos_b, self.sin_e

    @property
    def upwards(self) -> tuple[Any, Any, Any]:
        """u_E."""
        return -(self.sin_e * self.sin_b), -(self.sin_e * self.cos_b), self.cos_e


def place(r: Any, d: Direction) -> tuple[Any, Any, Any]:
    """x east, y north, z up."""
    h = r * d.cos_e
    return h * d.sin_b, h * d.cos_b, r * d.sin_e


def derivatives(r: Any, d: Direction) -> dict[tuple[str, str], Any]:
    """Of the place by the polar coordinates, without that of z by the bearing, which is 0."""
    h, v = r * d.cos_e, r * d.sin_e
    (along_x, along_y, along_z) = d.along
    return {
        ("x", "slant_range"): along_x,
        ("x", "elevation"): -(v * d.sin_b),
        ("x", "bearing"): h * d.cos_b,
        ("y", "slant_range"): along_y,
        ("y", "elevation"): -(v * d.cos_b),
        ("y", "bearing"): -(h * d.sin_b),
        ("z", "slant_range"): along_z,
        ("z", "elevation"): h,
    }


@dataclass(frozen=True)
class Place:
    """x, y, z with the distance from the vertical axis and from the origin."""

    x: Any
    y: Any
    z: Any
    h: Any
    r: Any

    @property
    def direction(self) -> Direction:
        """Cosines and sines."""
        return Direction(self.h / self.r, self.z / self.r, self.y / self.h, self.x / self.h)


def inverse_derivatives(p: Place) -> dict[tuple[str, str], Any]:
    """Of the polar coordinates by the place, without that of the bearing by z, which is 0."""
    d = p.direction
    tilt = d.sin_e / p.r
    return {
        ("slant_range", "x"): p.x / p.r,
        ("slant_range", "y"): p.y / p.r,
        ("slant_range", "z"): d.sin_e,
        ("elevation", "x"): -(tilt * d.sin_b),
        ("elevation", "y"): -(tilt * d.cos_b),
        ("elevation", "z"): d.cos_e / p.r,
        ("bearing", "x"): d.cos_b / p.h,
        ("bearing", "y"): -(d.sin_b / p.h),
    }


def noise_covariance(
    r: Any, d: Direction, range_: Any, elevation: Any, bearing: Any
) -> dict[str, Any]:
    """Entries xx, xy, xz, yy, yz, zz of the covariance to first order, from the deviations.

    Along the horizontal direction of the target and across it the covariance has the entries
    `ahead` and `across`; entries on the diagonal are sums of squares.
    """
    rising, crossing = r * elevation, (r * d.cos_e) * bearing
    a, b = d.cos_e * range_, d.sin_e * rising
    ahead = a * a + b * b
    across = crossing * crossing
    c, e = d.sin_e * range_, d.cos_e * rising
    steep = (d.cos_e * d.sin_e) * (range_ * range_ - rising * rising)
    east, north = d.sin_b * d.sin_b, d.cos_b * d.cos_b
    return {
        "covariance_xx": east * ahead + north * across,
        "covariance_xy": (d.sin_b * d.cos_b) * (ahead - across),
        "covariance_xz": d.sin_b * steep,
        "covariance_yy": north * ahead + east * across,
        "covariance_yz": d.cos_b * steep,
        "covariance_zz": c * c + e * e,
    }


@dataclass(frozen=True)
class Sight:
    """Place and velocity along the line of sight: distances, and components of the velocity."""

    r: Any
    h: Any
    radial: Any
    rising: Any
    crossing: Any
    outwards: Any
    sin_e: Any


def sight(p: Place, velocity: tuple[Any, ...]) -> Sight:
    """`outwards` is the growth of the horizontal distance."""
    vx, vy, vz = velocity
    d = p.direction
    outwards = d.sin_b * vx + d.cos_b * vy
    return Sight(
        p.r,
        p.h,
        (p.x / p.r) * vx + (p.y / p.r) * vy + d.sin_e * vz,
        d.cos_e * vz - d.sin_e * outwards,
        d.cos_b * vx - d.sin_b * vy,
        outwards,
        d.sin_e,
    )


def rates(s: Sight) -> dict[str, Any]:
    """First and second derivatives of range, elevation and bearing on a straight uniform course."""
    rising, crossing = s.rising / s.r, s.crossing / s.h
    turn = s.crossing / s.r
    return {
        "range_rate": s.radial,
        "elevation_rate": rising,
        "bearing_rate": crossing,
        "range_acceleration": (s.rising * s.rising + s.crossing * s.crossing) / s.r,
        "elevation_acceleration": -(2 * (s.radial / s.r) * rising + s.sin_e * (crossing * turn)),
        "bearing_acceleration": -(2 * crossing * (s.outwards / s.h)),
    }
