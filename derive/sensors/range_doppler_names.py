"""The named quantities of range and Doppler: what kernels take and give, in which order."""

from __future__ import annotations

from itertools import combinations_with_replacement

SPACE_AXES, PLANE_AXES = ("x", "y", "z"), ("x", "y")
LIGHT = 299_792_458
"""The speed of light in vacuum, m/s, by definition."""


def places(who: str, along: tuple[str, ...]) -> tuple[str, ...]:
    """The entries of a position."""
    return tuple(f"{who}_{axis}" for axis in along)


def velocities(who: str, along: tuple[str, ...]) -> tuple[str, ...]:
    """The entries of a velocity."""
    return tuple(f"{who}_velocity_{axis}" for axis in along)


def pairs(along: tuple[str, ...]) -> tuple[tuple[str, str], ...]:
    """The entries of a symmetric matrix, the lower half left out."""
    return tuple(combinations_with_replacement(along, 2))
