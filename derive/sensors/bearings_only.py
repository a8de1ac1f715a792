"""Bearings and elevations of targets from stations, with derivatives: a sensor of a few lines."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.own_expressions.expressions import (
    Argument,
    Condition,
    ExpressionKernel,
    ExpressionSet,
    Result,
    derivatives,
)
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.quantity import METRE, ONE, Quantity
from gainproof.derive.subject import Subject

AXES = {"x": "east", "y": "north", "z": "up"}
TARGET, STATION = (
    [
        Quantity(f"{who}_{axis}", f"{axis}_{who[0]}", f"{who} {way}", METRE)
        for axis, way in AXES.items()
    ]
    for who in ("target", "station")
)
BEARING = Quantity("bearing", "B", "bearing from north, clockwise seen from above, rad", ONE)
ELEVATION = Quantity("elevation", "E", "elevation above the horizontal, rad", ONE)
x, y, z = (one.symbol - other.symbol for one, other in zip(TARGET, STATION, strict=True))
LEVEL = sp.sqrt(x**2 + y**2)
ANGLES = (Result(BEARING, sp.atan2(x, y)), Result(ELEVATION, sp.atan2(z, LEVEL)))
SOURCE = "the definitions of the angles"
LEAST = sp.Rational(1, 10**20)
APART = (
    Condition(LEVEL >= LEAST, "level distance of target and station", single="1e-6"),
    Condition(
        sp.sqrt(x**2 + y**2 + z**2) >= LEAST, "distance of target and station", single="1e-6"
    ),
)


def _kernels(name: str, count: int) -> tuple[ExpressionKernel, ...]:
    """The angles in so many dimensions, and their derivatives by the target's position."""
    places = (*TARGET[:count], *STATION[:count])
    inputs = tuple(Argument(each, "0", "1e60", ("0", "1e12"), signed=True) for each in places)
    results, conditions = ANGLES[: count - 1], APART[: count - 1]
    slopes = derivatives(results, TARGET[:count])
    title = f"{name.capitalize()} of a target from a station"
    return (
        ExpressionKernel(name, title, inputs, results, SOURCE, conditions),
        ExpressionKernel(
            f"{name}_jacobian",
            f"Derivatives of {name} by the target's position",
            inputs,
            slopes,
            SOURCE,
            conditions,
        ),
    )


def build() -> Subject:
    """Derive bearings in the plane, and bearings with elevations in space."""
    kernels = (*_kernels("bearing", 2), *_kernels("angles", 3))
    return derive_expressions(
        ExpressionSet("bearings-only", "Bearings and elevations of targets from stations", kernels)
    )
