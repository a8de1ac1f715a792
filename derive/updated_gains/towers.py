"""The towers: three indices, each by the innovation's deviation 1 + e of its filter; others."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.updated_gains.forms import (
    Elements,
    excesses,
    followed_covariances,
    gains_of,
    held_covariances,
    index_of,
    slopes_of,
    steady_covariances,
)
from gainproof.derive.updated_gains.names import (
    ALPHA,
    ALPHA_SLOPE,
    BETA,
    BETA_SLOPE,
    FIRST_ALPHA,
    FIRST_BETA,
    FOLLOWING,
    INDEX,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    RATIO,
    E,
    G,
    K,
    N,
)

AXIS, BOUNDS, CIRCLE, SIGHT, WITHIN = "axis", "bounds", "circle", "sight", "within"
S, U, V = (sp.Symbol(name, real=True) for name in "suv")


def main_tower() -> Tower:
    """Three indices, the gains of each, what first order makes of them, and what it costs."""
    backward = excesses(E, N)
    elements: Elements = {
        "tracking_index": index_of(E),
        "nominal_index": index_of(N),
        "following_index": index_of(G),
        "innovation_deviation": 1 + E,
    }
    for prefix, e in (("", E), ("nominal_", N), ("following_", G)):
        elements |= dict(zip((f"{prefix}alpha", f"{prefix}beta"), gains_of(e), strict=True))
    elements |= steady_covariances(E)
    elements |= dict(zip(("alpha_slope", "beta_slope"), slopes_of(N), strict=True))
    elements |= dict(zip(("next_alpha_slope", "next_beta_slope"), slopes_of(E), strict=True))
    elements |= {
        "first_order_alpha": NOMINAL_ALPHA + ALPHA_SLOPE * (INDEX - NOMINAL),
        "first_order_beta": NOMINAL_BETA + BETA_SLOPE * (INDEX - NOMINAL),
        "alpha_excess": FIRST_ALPHA - ALPHA,
        "beta_excess": FIRST_BETA - BETA,
        "backward_alpha_excess": backward[0],
        "backward_beta_excess": backward[1],
        "position_variance": 1 / INDEX**2,
        "nominal_variance": 1 / NOMINAL**2,
        "following_variance": 1 / FOLLOWING**2,
        "index_ratio": INDEX / NOMINAL,
        **held_covariances(N, RATIO),
    }
    return Tower("main", above_zero("e", "n", "g"), (), elements)


def within_tower() -> Tower:
    """First-order gains as long as they are stable, and the covariances of both filters."""
    elements: Elements = {"tracking_index": 4 * N * K / (1 + K), "nominal_index": index_of(N)}
    elements |= dict(zip(("nominal_alpha", "nominal_beta"), gains_of(N), strict=True))
    elements |= dict(zip(("alpha_slope", "beta_slope"), slopes_of(N), strict=True))
    elements |= {
        "first_order_alpha": NOMINAL_ALPHA + ALPHA_SLOPE * (INDEX - NOMINAL),
        "first_order_beta": NOMINAL_BETA + BETA_SLOPE * (INDEX - NOMINAL),
        "index_ratio": INDEX / NOMINAL,
        **held_covariances(N, RATIO),
        **followed_covariances(),
    }
    return Tower(WITHIN, above_zero("n", "k"), (), elements)


def axis_tower() -> Tower:
    """The index of an axis, over the deviation of its measurement."""
    names = ("acceleration_deviation", "interval", "d")
    w, t, d = (sp.Symbol(name, real=True) for name in names)
    elements = {"variance": d**2, "axis_index": w * t**2 / d}
    return Tower(AXIS, above_zero(*names), (), elements)


def bounds_tower() -> Tower:
    """Where updated gains and their variances are as far off as held ones: roots over n."""
    generators = (
        Generator("s", 5 * N**2 + 10 * N + 1),
        Generator("u", 4 * N**2 + 8 * N + 1),
        Generator("v", 5 * N**2 + 4 * N + 4),
    )
    elements = {
        "nominal_index": index_of(N),
        "alpha_place": (S + N - 1) / 2,
        "beta_place": (U + 2 * N + 1) / 2,
        "alpha_bound": (S + N - 1) ** 2 / (S + N + 1),
        "beta_bound": (U + 2 * N + 1) ** 2 / (U + 2 * N + 3),
        "variance_ratio": (N + 2 + V) / (2 * N),
    }
    return Tower(BOUNDS, (Parameter("n"),), generators, elements)


def circle_tower() -> Tower:
    """Two angles of the line of sight, from 0 to below half a turn, by the tangents of halves."""
    elements: Elements = {}
    parameters = []
    for prefix in ("", "later_"):
        tau = sp.Symbol(f"{prefix}half_tangent", real=True)
        elements[f"{prefix}cosine"] = (1 - tau**2) / (1 + tau**2)
        elements[f"{prefix}sine"] = 2 * tau / (1 + tau**2)
        parameters.append(Parameter(str(tau), above=None, start="0"))
    return Tower(CIRCLE, tuple(parameters), (), elements)


def sight_tower() -> Tower:
    """Gains along and across the line of sight; cosine and sine of either sign."""
    left, right = ({name: f"{side}_{name}" for name in ("cosine", "sine")} for side in SIDES)
    elements = {
        name: sp.Symbol(right[name], real=True) - sp.Symbol(left[name], real=True)
        for name in ("cosine", "sine")
    }
    sides = (*left.values(), *right.values())
    parameters = (
        Parameter("along"),
        Parameter("across"),
        *(Parameter(name, above=None, start="0") for name in sides),
    )
    return Tower(SIGHT, parameters, (), elements)


SIDES = ("less", "more")
