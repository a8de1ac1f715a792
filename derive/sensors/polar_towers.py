"""The parameters under polar coordinates, all positive, and what is made of them.

A direction enters as points on unit circles. a = tan(E/2 + pi/4) is any positive number where E is
within a quarter turn of the horizontal. The bearing is B1 + B2 less half a turn, with
g = tan(B1/2) and k = tan(B2/2) from 0 on: each part is any angle from 0 to below half a turn, so
that B is any angle from half a turn to the left to below half a turn to the right.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.expression import real
from gainproof.derive.sensors import polar_forms as forms
from gainproof.derive.sensors.polar_forms import Direction, Place
from gainproof.derive.sensors.polar_names import (
    COS_B,
    COS_E,
    KEPT_B,
    KEPT_E,
    LOSS_B,
    LOSS_E,
    SIGMA_B,
    SIGMA_E,
    SIGMA_R,
    SIN_B,
    SIN_E,
    VELOCITY,
    A,
    G,
    H,
    K,
    R,
    X,
    Y,
    Z,
)

Elements = dict[str, sp.Expr]
DIRECTION = Direction(COS_E, SIN_E, COS_B, SIN_B)
DEVIATIONS = tuple(str(each) for each in (SIGMA_R, SIGMA_E, SIGMA_B))
LEFT, RIGHT = ({place: f"{side}_{place}" for place in "xyz"} for side in ("less", "more"))
"""A velocity of either sign is the difference of two numbers from 0 on."""


def elevation_circle() -> Elements:
    """Cosine and sine of the elevation."""
    return {
        "cos_elevation": 2 * A / (1 + A**2),
        "sin_elevation": (A**2 - 1) / (1 + A**2),
    }


def bearing_circle() -> Elements:
    """Cosine of the bearing's first part, cosine and sine of the bearing."""
    below = (1 + G**2) * (1 + K**2)
    return {
        "first_cosine": (1 - G**2) / (1 + G**2),
        "cos_bearing": (4 * G * K - (1 - G**2) * (1 - K**2)) / below,
        "sin_bearing": -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / below,
    }


def main_tower() -> Tower:
    """Place, derivatives, noise and its losses, in space."""
    elements = {**elevation_circle(), **bearing_circle(), **_place()}
    for (place, polar), value in forms.derivatives(R, DIRECTION).items():
        elements[f"{place}_D_{polar}"] = value
    for (polar, place), value in forms.inverse_derivatives(Place(X, Y, Z, H, R)).items():
        elements[f"{polar}_D_{place}"] = value
    elements |= forms.noise_covariance(R, DIRECTION, SIGMA_R, SIGMA_E, SIGMA_B)
    elements |= {
        "elevation_kept": 1 / (1 + LOSS_E),
        "bearing_kept": 1 / (1 + LOSS_B),
        "kept_upwards": KEPT_E,
        "kept_level": KEPT_E * KEPT_B,
        "change_upwards": KEPT_E - 1,
        "change_level": KEPT_E * KEPT_B - 1,
    }
    elements |= _converted(("x", "y"), "level") | _converted(("z",), "upwards")
    closed = ("g", "k", *DEVIATIONS, "elevation_loss", "bearing_loss")
    return Tower("main", (*above_zero("slant_range", "a"), *from_zero(*closed)), (), elements)


def course_tower() -> Tower:
    """Place and a velocity of either sign, in space."""
    elements = {**elevation_circle(), **bearing_circle(), **_place(), **_velocity("xyz")}
    found = forms.rates(forms.sight(Place(X, Y, Z, H, R), tuple(VELOCITY.values())))
    elements |= {
        "w_R": found["range_rate"],
        "w_E": found["elevation_rate"] * R,
        "w_B": found["bearing_rate"] * H,
    }
    parameters = (*above_zero("slant_range", "a"), *from_zero("g", "k", *_sides("xyz")))
    return Tower("course", parameters, (), elements | found)


def plane_tower() -> Tower:
    """All of these in the plane."""
    elements = {**bearing_circle(), "x": R * SIN_B, "y": R * COS_B}
    elements |= {
        "covariance_xx": SIN_B**2 * SIGMA_R**2 + COS_B**2 * (R * SIGMA_B) ** 2,
        "covariance_xy": SIN_B * COS_B * (SIGMA_R**2 - (R * SIGMA_B) ** 2),
        "covariance_yy": COS_B**2 * SIGMA_R**2 + SIN_B**2 * (R * SIGMA_B) ** 2,
        "bearing_kept": 1 / (1 + LOSS_B),
        "kept_level": KEPT_B,
        "change_level": KEPT_B - 1,
    }
    elements |= _converted(("x", "y"), "level") | _velocity("xy")
    vx, vy = VELOCITY["x"], VELOCITY["y"]
    radial, crossing = SIN_B * vx + COS_B * vy, COS_B * vx - SIN_B * vy
    elements |= {
        "range_rate": radial,
        "bearing_rate": crossing / R,
        "range_acceleration": crossing**2 / R,
        "bearing_acceleration": -2 * crossing * radial / R**2,
    }
    closed = ("g", "k", "range_deviation", "bearing_deviation", "bearing_loss")
    parameters = (*above_zero("slant_range"), *from_zero(*closed, *_sides("xy")))
    return Tower("plane", parameters, (), elements)


def _place() -> Elements:
    x, y, z = forms.place(R, DIRECTION)
    return {"horizontal_distance": R * COS_E, "x": x, "y": y, "z": z}


def _converted(places: tuple[str, ...], which: str) -> Elements:
    """Means and biases of converted measurements."""
    found: Elements = {}
    for place in places:
        found[f"mean_{place}"] = real(place) * real(f"kept_{which}")
        found[f"bias_{place}"] = real(place) * real(f"change_{which}")
    return found


def _velocity(places: str) -> Elements:
    return {f"velocity_{place}": real(RIGHT[place]) - real(LEFT[place]) for place in places}


def _sides(places: str) -> tuple[str, ...]:
    return tuple(side[place] for place in places for side in (LEFT, RIGHT))
