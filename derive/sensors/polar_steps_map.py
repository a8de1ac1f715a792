"""Steps on angles as points of circles, the map to Cartesian coordinates, and its inverse."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column, real
from gainproof.derive.relation import (
    cited,
    described,
    equal,
    increasing_onto,
    monotone,
    positive,
)
from gainproof.derive.sensors.polar_names import (
    COS_B,
    COS_E,
    OF_BEARING,
    OF_ELEVATION,
    SIN_B,
    SIN_E,
    A,
    G,
    H,
    K,
    R,
    X,
    Y,
    Z,
)
from gainproof.derive.source import ELEMENTARY

ENDS = {"0": End(), "infinity": End()}
BELOW = (1 + G**2) * (1 + K**2)


def elevation_steps() -> list[Step]:
    """The elevation as a point of a circle."""
    return [
        Step(
            "coordinates",
            "A sensor at the origin measures the range `R`, the elevation `E` above the horizontal "
            "and the bearing `B` from north, clockwise as seen from above; `x` points east, `y` "
            "north, `z` up.",
            described("R > 0, -pi/2 < E < pi/2, -pi <= B < pi; angles in radians"),
            "North-referenced Cartesian coordinates.",
            heading="Angles as points of a circle",
        ),
        Step(
            "elevation",
            "The elevation stands in what follows as its cosine `c_E` and its sine `s_E`. Let "
            "`a` be the tangent of half the angle from straight down: in `a` they are fractions of "
            "polynomials:",
            equal(column(COS_E, SIN_E), column(2 * A / (1 + A**2), (A**2 - 1) / (1 + A**2))),
            "The tangent of half an angle makes every point of the circle but one rational.",
        ),
        joined("elevation-circle", equal(COS_E**2 + SIN_E**2, sp.Integer(1))),
        Step(
            "elevation-onto",
            "Every elevation between straight down and straight up has its `a`, and no other "
            "has one.",
            increasing_onto(SIN_E, sp.Integer(-1), sp.Integer(1), "a"),
            "The sine increases with `a` from -1 to 1, and the cosine is above zero.",
            hint={"ends": ENDS},
        ),
        joined("elevation-cosine", positive(COS_E)),
        Step(
            "elevation-slopes",
            "With the elevation `a` grows at the rate `(1 + a^2)/2`: then cosine and sine have the "
            "derivatives that are theirs.",
            equal(
                column(*(sp.Derivative(each, A) * OF_ELEVATION for each in (COS_E, SIN_E))),
                column(-SIN_E, COS_E),
            ),
            "This fixes the elevation itself: it is 0 where `a = 1`, and grows as the point "
            "moves on the circle with unit speed.",
        ),
    ]


def bearing_steps() -> list[Step]:
    """The bearing as a point of a circle."""
    first = real("first_cosine")
    return [
        Step(
            "bearing",
            "The bearing is taken in two parts, `B_1 + B_2` less half a turn, both from 0 to below "
            "half a turn, so that the whole circle is there. `g` and `k`, from 0 on, are the "
            "tangents of their halves. Cosine and sine of the bearing are `c_B` and `s_B`.",
            equal(
                column(COS_B, SIN_B),
                column(
                    (4 * G * K - (1 - G**2) * (1 - K**2)) / BELOW,
                    -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / BELOW,
                ),
            ),
            "Cosine and sine of a sum, each part as in step @elevation.",
        ),
        joined("bearing-circle", equal(COS_B**2 + SIN_B**2, sp.Integer(1))),
        Step(
            "bearing-onto",
            "Each part takes every angle of its half circle once.",
            equal(first, (1 - G**2) / (1 + G**2)),
            "Its cosine, `c_1` of the first, decreases from 1 to -1.",
        ),
        joined("bearing-falls", monotone(first, "decreasing", "g")),
        joined(
            "bearing-half",
            increasing_onto(-first, sp.Integer(-1), sp.Integer(1), "g"),
            hint={"ends": ENDS},
        ),
        Step(
            "bearing-slopes",
            "With the bearing `g` grows at the rate `(1 + g^2)/2`, `k` being held:",
            equal(
                column(*(sp.Derivative(each, G) * OF_BEARING for each in (COS_B, SIN_B))),
                column(-SIN_B, COS_B),
            ),
            "As in step @elevation-slopes.",
        ),
    ]


def map_steps() -> list[Step]:
    """To Cartesian coordinates and back."""
    return [
        Step(
            "map",
            "The map to Cartesian coordinates; `h` is the distance from the vertical axis.",
            equal(column(X, Y, Z), column(R * COS_E * SIN_B, R * COS_E * COS_B, R * SIN_E)),
            "The lecture's transformation: bearings are counted from north, so that the sine is in "
            "the east.",
            heading="The map and its inverse",
        ),
        joined("horizontal", equal(H, R * COS_E)),
        Step(
            "range",
            "Range and horizontal distance are those of the place.",
            equal(column(X**2 + Y**2 + Z**2, X**2 + Y**2), column(R**2, H**2)),
            "Steps @elevation-circle and @bearing-circle.",
        ),
        joined("range-positive", positive(R)),
        joined("horizontal-positive", positive(H)),
        Step(
            "inverse",
            "The way back: the circles' points are quotients of distances, so that `E` is the "
            "angle of the point `(h, z)` and `B`, counted from north, that of `(y, x)`.",
            equal(column(COS_E, SIN_E, COS_B, SIN_B), column(H / R, Z / R, Y / H, X / H)),
            "Insert step @map.",
        ),
        Step(
            "atan2",
            "An angle is determined by its point on the circle.",
            cited(
                "Every point of the unit circle is (cos t, sin t) for exactly one t with "
                "-pi <= t < pi; of the point (x, y)/sqrt(x^2 + y^2) it is called atan2(y, x), up "
                "to the sign of pi.",
                ELEMENTARY.text(),
            ),
            "So the map is one to one between `R > 0`, elevations within a quarter turn of the "
            "horizontal and all bearings on the one side, and all places off the vertical axis on "
            "the other. On the axis nothing determines the bearing.",
        ),
    ]
