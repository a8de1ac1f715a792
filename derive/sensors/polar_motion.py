"""How range, elevation and bearing move: chain rules as expressions with derivatives."""

from __future__ import annotations

from itertools import product

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.sensors.polar_names import (
    COS_E,
    CROSSING,
    OF_BEARING,
    OF_ELEVATION,
    RADIAL,
    RATES,
    RISING,
    SIN_E,
    A,
    G,
    H,
    R,
    by_angles,
)
from gainproof.derive.sensors.polar_steps_jacobian import frame

Coordinate = tuple[str, sp.Symbol, sp.Expr]
"""Name, parameter, and the parameter's derivative by the coordinate."""
POLAR: tuple[Coordinate, ...] = (
    ("range", R, sp.Integer(1)),
    ("elevation", A, OF_ELEVATION),
    ("bearing", G, OF_BEARING),
)
SECOND = tuple(real(f"{each[0]}_acceleration") for each in POLAR)
TANGENT = SIN_E / COS_E

__all__ = [
    "POLAR",
    "RATES",
    "SECOND",
    "TANGENT",
    "Coordinate",
    "acceleration",
    "by",
    "outwards",
    "rate",
    "second",
    "turning",
    "uniform_second_rates",
]


def by(expression: sp.Expr, which: Coordinate) -> sp.Expr:
    """The derivative by a coordinate."""
    return sp.Derivative(expression, which[1]) * which[2]


def rate(which: Coordinate) -> sp.Symbol:
    """The named derivative of a coordinate by time."""
    return real(f"{which[0]}_rate")


def second(which: Coordinate) -> sp.Symbol:
    """The named second derivative of a coordinate by time."""
    return real(f"{which[0]}_acceleration")


def uniform_second_rates() -> dict[str, sp.Expr]:
    """Second derivatives of range, elevation and bearing from the first ones."""
    r, e, b = RATES
    return {
        "range": R * e**2 + R * COS_E**2 * b**2,
        "elevation": -2 * r * e / R - SIN_E * COS_E * b**2,
        "bearing": -2 * r * b / R + 2 * TANGENT * e * b,
    }


def acceleration(
    place: sp.Symbol, polar: tuple[Coordinate, ...], second_rates: dict[str, sp.Expr]
) -> sp.Expr:
    """The second derivative of x, y or z by time."""
    return sp.Add(
        *(by(place, each) * second_rates[each[0]] for each in polar),
        *(
            by(by(place, one), other) * rate(one) * rate(other)
            for one, other in product(polar, repeat=2)
        ),
    )


def outwards() -> sp.Expr:
    """The rate of the horizontal distance."""
    return COS_E * RADIAL - SIN_E * RISING


def turning(which: int) -> sp.Expr:
    """What the turning of one of the frame's columns does to the velocity's component there."""
    u, parts = frame(), (RADIAL, RISING, CROSSING)
    found = []
    for n in range(3):
        by_elevation, by_bearing = by_angles(u[n, which])
        held = sp.Add(*(u[n, each] * parts[each] for each in range(3)))
        found.append((by_elevation * RISING / R + by_bearing * CROSSING / H) * held)
    return sp.Add(*found)
