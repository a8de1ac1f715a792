"""Range, bearing and range rate of a target in the plane, with all derivatives."""

import sympy as sp

from gainproof.derive.own_expressions.expressions import (
    Argument,
    Condition,
    ExpressionKernel,
    ExpressionSet,
    Result,
    derivatives,
)
from gainproof.derive.quantity import METRE, ONE, SECOND, Quantity

X = Quantity("x", "x", "distance east", METRE)
Y = Quantity("y", "y", "distance north", METRE)
U = Quantity("u", "u", "velocity east", METRE / SECOND)
V = Quantity("v", "v", "velocity north", METRE / SECOND)
RANGE = Quantity("range", "r", "range", METRE)
BEARING = Quantity("bearing", "b", "bearing, clockwise from north", ONE)
RATE = Quantity("rate", "g", "range rate", METRE / SECOND)
x, y, u, v = (each.symbol for each in (X, Y, U, V))
r = sp.sqrt(x**2 + y**2)

PLACES = tuple(Argument(each, "1e-3", "1e7", signed=True) for each in (X, Y))
SPEEDS = tuple(Argument(each, "1e-3", "1e4", signed=True) for each in (U, V))
OFF = (Condition(r >= 1, "range"),)
PLACE = (Result(RANGE, r), Result(BEARING, sp.atan2(x, y)))
RADIAL = (Result(RATE, (x * u + y * v) / r, by_terms=True),)

EXPRESSIONS = ExpressionSet(
    name="line-of-sight",
    title="Line of sight in the plane",
    kernels=(
        ExpressionKernel("place", "Range and bearing", PLACES, PLACE, conditions=OFF),
        ExpressionKernel(
            "place_jacobian",
            "Derivatives of range and bearing",
            PLACES,
            derivatives(PLACE, (X, Y)),
            conditions=OFF,
        ),
        ExpressionKernel("radial", "Range rate", PLACES + SPEEDS, RADIAL, conditions=OFF),
        ExpressionKernel(
            "radial_jacobian",
            "Derivatives of the range rate",
            PLACES + SPEEDS,
            derivatives(RADIAL, (X, Y, U, V)),
            conditions=OFF,
        ),
    ),
)
