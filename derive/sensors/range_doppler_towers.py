"""The parameters under the kernels of range and Doppler: every target seen from every station.

Directions are points of the unit circle or sphere, made of tangents of half angles. In the plane
the bearing is B1 + B2 less half a turn, with g = tan(B1/2) and k = tan(B2/2) from 0 on: each part
is below half a turn, so that the bearing is any. In space the angle from the upward direction is
one such part: straight down is left out in the tower `above`, straight up in its mirror image
`below`, so that the two hold every direction.

A relative velocity is given by its parts along the line of sight and across it, the range rate and
those of h along perpendicular unit vectors, each the difference of two numbers from 0 on. What else
may have either sign is u - 1/u of a positive u of its own.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.expression import real
from gainproof.derive.sensors.range_doppler_forms import Sight
from gainproof.derive.sensors.range_doppler_names import (
    PLANE_AXES,
    SPACE_AXES,
    places,
    velocities,
)

Elements = dict[str, sp.Expr]
Axes = tuple[str, ...]
RANGE, RATE = real("slant_range"), real("range_rate")
G, K = real("g"), real("k")
TILT, CARRIER = real("a"), real("carrier_frequency")
COS_B, SIN_B = real("cos_bearing"), real("sin_bearing")
COS_T, SIN_T = real("cos_tilt"), real("sin_tilt")
ZERO = sp.Integer(0)
SIDES = ("tilt", "turn")
"""The two ways across the line of sight; in the plane the last alone."""


def towers() -> tuple[Tower, ...]:
    """The plane, and the two that hold space."""
    tilts = {name: tilt(side) for name, side in (("above", 1), ("below", -1))}
    return (
        _tower("plane", PLANE_AXES, bearing_circle(), ("g", "k")),
        *(
            _tower(name, SPACE_AXES, {**bearing_circle(), **circle}, ("g", "k", "a"))
            for name, circle in tilts.items()
        ),
    )


def bearing_circle() -> Elements:
    """Cosine of the bearing's first part, cosine and sine of the bearing."""
    below = (1 + G**2) * (1 + K**2)
    return {
        "first_cosine": (1 - G**2) / (1 + G**2),
        "cos_bearing": (4 * G * K - (1 - G**2) * (1 - K**2)) / below,
        "sin_bearing": -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / below,
    }


def tilt(side: int) -> Elements:
    """Cosine and sine of the angle from straight up (1) or, mirrored, from straight down (-1)."""
    return {
        "cos_tilt": side * (1 - TILT**2) / (1 + TILT**2),
        "sin_tilt": 2 * TILT / (1 + TILT**2),
    }


def frame(along: Axes) -> list[list[sp.Expr]]:
    """The unit vector u, then those across it."""
    if along == PLANE_AXES:
        return [[SIN_B, COS_B], [COS_B, -SIN_B]]
    return [
        [SIN_T * SIN_B, SIN_T * COS_B, COS_T],
        [COS_T * SIN_B, COS_T * COS_B, -SIN_T],
        [COS_B, -SIN_B, ZERO],
    ]


def of(kind: str, along: Axes) -> list[sp.Symbol]:
    """The named entries of a vector: `unit`, `place`, `velocity`, `turning`."""
    return [real(f"{kind}_{axis}") for axis in along]


def difference(name: str) -> sp.Expr:
    """A number of either sign."""
    return real(f"more_{name}") - real(f"less_{name}")


def signed(name: str) -> sp.Expr:
    """A number of either sign, of one parameter."""
    return real(f"root_of_{name}") - 1 / real(f"root_of_{name}")


def parts(along: Axes) -> tuple[str, ...]:
    """What a relative velocity is made of."""
    return ("range_rate", *SIDES[3 - len(along) :])


def relative(
    along: Axes,
    rows: list[list[sp.Expr]] | None = None,
    either: Callable[[str], sp.Expr] = difference,
) -> Elements:
    """Range rate, direction, h, place and velocity, by the frame, or by these rows in its place;
    `either` writes a number of either sign.
    """
    unit, *aside = rows or frame(along)
    rate, *turns = (either(name) for name in parts(along))
    found: Elements = {"range_rate": rate}
    found |= dict(zip(map(str, of("unit", along)), unit, strict=True))
    for n, name in enumerate(of("turning", along)):
        turned = zip(turns, aside, strict=True)
        found[str(name)] = sp.Add(*(turn * each[n] for turn, each in turned))
    for axis, u, h in zip(along, of("unit", along), of("turning", along), strict=True):
        found[f"place_{axis}"] = RANGE * u
        found[f"velocity_{axis}"] = RATE * u + RANGE * h
    return found


def motions(along: Axes) -> Elements:
    """Positions and velocities of station and target."""
    names = (*places("station", along), *velocities("station", along))
    found = {name: signed(name) for name in names}
    for axis in along:
        found[f"target_{axis}"] = real(f"station_{axis}") + real(f"place_{axis}")
        found[f"target_velocity_{axis}"] = real(f"station_velocity_{axis}") + real(
            f"velocity_{axis}"
        )
    return found


def sight(along: Axes) -> Sight:
    """What the names mean by each other."""
    return Sight(RANGE, of("unit", along), of("velocity", along))


def _tower(name: str, along: Axes, circles: Elements, angles: tuple[str, ...]) -> Tower:
    closed = [*angles, *(f"{side}_{part}" for part in parts(along) for side in ("more", "less"))]
    either = [*places("station", along), *velocities("station", along)]
    parameters = (
        *above_zero("slant_range", "carrier_frequency"),
        *above_zero(*(f"root_of_{each}" for each in either)),
        *from_zero(*closed),
    )
    return Tower(name, parameters, (), {**circles, **relative(along), **motions(along)})
