"""The parameters under the kernels of range and Doppler: every target seen from every station.

Directions are points of the unit circle or sphere, made of tangents of half angles. In the plane
the bearing is that of polar coordinates, of two parts that are each below half a turn, so that it
is any. In space the angle from the upward direction is one such part: straight down is left out in
the tower `above`, straight up in its mirror image `below`, so that the two hold every direction.
A velocity relative to the station is the difference of two numbers from 0 on; what else may have
either sign is u - 1/u of a positive u of its own.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.sensors.polar_towers import LEFT, RIGHT, bearing_circle
from gainproof.derive.sensors.range_doppler_forms import Sight
from gainproof.derive.sensors.range_doppler_names import (
    PLANE_AXES,
    SPACE_AXES,
    places,
    velocities,
)

Elements = dict[str, sp.Expr]
RANGE = real("slant_range")
TILT = real("a")
COS_B, SIN_B = real("cos_bearing"), real("sin_bearing")
COS_T, SIN_T = real("cos_tilt"), real("sin_tilt")


def towers() -> tuple[Tower, ...]:
    """The plane, and the two that hold space."""
    return plane_tower(), space_tower("above", 1), space_tower("below", -1)


def of(kind: str, along: tuple[str, ...]) -> list[sp.Symbol]:
    """The named entries of a vector: `unit`, `place`, `velocity`, `turning`."""
    return [real(f"{kind}_{axis}") for axis in along]


def plane_tower() -> Tower:
    """Every direction of the plane."""
    direction = {"unit_x": SIN_B, "unit_y": COS_B}
    return _tower("plane", PLANE_AXES, {**bearing_circle(), **direction}, ("g", "k"))


def space_tower(name: str, side: int) -> Tower:
    """Every direction of space but one: straight down, or straight up."""
    tilt: Elements = {
        "cos_tilt": side * (1 - TILT**2) / (1 + TILT**2),
        "sin_tilt": 2 * TILT / (1 + TILT**2),
    }
    direction = {"unit_x": SIN_T * SIN_B, "unit_y": SIN_T * COS_B, "unit_z": COS_T}
    circles = {**bearing_circle(), **tilt, **direction}
    return _tower(name, SPACE_AXES, circles, ("g", "k", "a"))


def meanings(along: tuple[str, ...]) -> Elements:
    """What the names mean, but for the direction."""
    unit, place, velocity = (of(kind, along) for kind in ("unit", "place", "velocity"))
    sides = zip(velocity, along, strict=True)
    found: Elements = {str(v): real(RIGHT[axis]) - real(LEFT[axis]) for v, axis in sides}
    found |= {str(p): RANGE * u for p, u in zip(place, unit, strict=True)}
    for name in (*places("station", along), *velocities("station", along)):
        found[name] = real(f"root_of_{name}") - 1 / real(f"root_of_{name}")
    for names, other, relative in (
        (places("target", along), places("station", along), place),
        (velocities("target", along), velocities("station", along), velocity),
    ):
        for name, station, each in zip(names, other, relative, strict=True):
            found[name] = real(station) + each
    seen = Sight(RANGE, unit, velocity)
    found["range_rate"] = seen.rate
    found |= {str(h): each for h, each in zip(of("turning", along), seen.turning, strict=True)}
    return found


def _tower(name: str, along: tuple[str, ...], circles: Elements, angles: Sequence[str]) -> Tower:
    closed = [*angles, *(side[axis] for axis in along for side in (LEFT, RIGHT))]
    signed = [*places("station", along), *velocities("station", along)]
    parameters = (
        Parameter("slant_range"),
        *(Parameter(f"root_of_{each}") for each in signed),
        *(Parameter(each, above=None, start="0") for each in closed),
    )
    return Tower(name, parameters, (), {**circles, **meanings(along)})
