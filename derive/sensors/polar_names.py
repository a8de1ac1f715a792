"""The named quantities of polar coordinates, and how they are printed.

Range R above zero; elevation E above the horizontal, within a quarter turn of it; bearing B from
north, clockwise as seen from above. In the plane there is no elevation. x points east, y north, z
up. Angles are in radians.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real

R, A, G, K = map(real, ("slant_range", "a", "g", "k"))
COS_E, SIN_E = real("cos_elevation"), real("sin_elevation")
COS_B, SIN_B = real("cos_bearing"), real("sin_bearing")
X, Y, Z, H = map(real, ("x", "y", "z", "horizontal_distance"))
SIGMA_R, SIGMA_E, SIGMA_B = map(
    real, ("range_deviation", "elevation_deviation", "bearing_deviation")
)
LOSS_E, LOSS_B = real("elevation_loss"), real("bearing_loss")
KEPT_E, KEPT_B = real("elevation_kept"), real("bearing_kept")
RADIAL, RISING, CROSSING = real("w_R"), real("w_E"), real("w_B")
"""Components of a velocity along, upwards across and to the right across the line of sight."""

PLACES = ("x", "y", "z")
POLAR = ("slant_range", "elevation", "bearing")
PAIRS = (("x", "x"), ("x", "y"), ("x", "z"), ("y", "y"), ("y", "z"), ("z", "z"))
JACOBIAN = {(place, polar): real(f"{place}_D_{polar}") for place in PLACES for polar in POLAR}
INVERSE = {(polar, place): real(f"{polar}_D_{place}") for polar in POLAR for place in PLACES}
VELOCITY = {place: real(f"velocity_{place}") for place in PLACES}
RATES = tuple(real(f"{name}_rate") for name in ("range", "elevation", "bearing"))

OF_ELEVATION = (1 + A**2) / 2
"""The derivative of a by the elevation, whose half and an eighth of a turn it is the tangent of."""
OF_BEARING = (1 + G**2) / 2
"""The derivative of g by the bearing: its first part is twice the angle whose tangent is g."""

LATEX = {
    "slant_range": "R",
    "a": "a",
    "g": "g",
    "k": "k",
    "cos_elevation": "c_E",
    "sin_elevation": "s_E",
    "cos_bearing": "c_B",
    "sin_bearing": "s_B",
    "first_cosine": "c_1",
    "x": "x",
    "y": "y",
    "z": "z",
    "horizontal_distance": "h",
    "range_deviation": r"\sigma_R",
    "elevation_deviation": r"\sigma_E",
    "bearing_deviation": r"\sigma_B",
    "elevation_loss": r"\ell_E",
    "bearing_loss": r"\ell_B",
    "elevation_kept": r"\lambda_E",
    "bearing_kept": r"\lambda_B",
    "w_R": "w_R",
    "w_E": "w_E",
    "w_B": "w_B",
    "t": "t",
    "range_rate": "R'",
    "elevation_rate": "E'",
    "bearing_rate": "B'",
    "range_acceleration": "R''",
    "elevation_acceleration": "E''",
    "bearing_acceleration": "B''",
    **{f"velocity_{place}": f"v_{place}" for place in PLACES},
    **{
        f"{place}_D_{polar}": f"J_{{{place}{letter}}}"
        for place in PLACES
        for polar, letter in zip(POLAR, "REB", strict=True)
    },
    **{
        f"{polar}_D_{place}": f"G_{{{letter}{place}}}"
        for place in PLACES
        for polar, letter in zip(POLAR, "REB", strict=True)
    },
    **{f"covariance_{a}{b}": f"P_{{{a}{b}}}" for a, b in PAIRS},
    **{f"mean_{place}": f"m_{place}" for place in PLACES},
    **{f"bias_{place}": f"b_{place}" for place in PLACES},
}


def covariance() -> sp.ImmutableDenseMatrix:
    """The named entries of a covariance of places."""
    return sp.ImmutableDenseMatrix(
        [[real("covariance_" + "".join(sorted((a, b)))) for b in PLACES] for a in PLACES]
    )


def by_angles(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The derivatives by elevation and bearing."""
    return (
        sp.Derivative(expression, A) * OF_ELEVATION,
        sp.Derivative(expression, G) * OF_BEARING,
    )
