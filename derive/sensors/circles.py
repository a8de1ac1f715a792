"""Points of unit circles over the tangents of half angles: an elevation, and a bearing.

a = tan(E/2 + pi/4) is any positive number where E is within a quarter turn of the horizontal. The
bearing is B1 + B2 less half a turn, with g = tan(B1/2) and k = tan(B2/2) from 0 on: each part is
any angle from 0 to below half a turn, so that B is any angle from half a turn to the left to below
half a turn to the right.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real

Elements = dict[str, sp.Expr]
A, G, K = map(real, ("a", "g", "k"))


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
