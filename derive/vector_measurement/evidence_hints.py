"""What evidence for the page `position-velocity` needs: forms that show a sign or a limit."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.expression import real
from gainproof.derive.vector_measurement import forms, poles
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.corner_towers import T, W, fixed_index_ends, narrow_ends
from gainproof.derive.vector_measurement.derivatives_by_noise_ratio import updated_by_ratio
from gainproof.derive.vector_measurement.first_derivatives import Rates
from gainproof.derive.vector_measurement.limit_towers import (
    improvement_ends,
    index_ends,
    index_tower,
    ratio_ends,
)
from gainproof.derive.vector_measurement.names import (
    GAINS,
    INDEX,
    RATIO,
    ROOT,
    UPDATED,
)
from gainproof.derive.vector_measurement.page_slots import end_level, in_tower, start_level
from gainproof.derive.vector_measurement.pole_kernels import POSITIVE, turning_index
from gainproof.derive.vector_measurement.process_noise import Noise
from gainproof.derive.vector_measurement.towers import rational

Hints = dict[str, dict[str, Any]]
SIDES = ("main", "ends", "fixed_velocity_index", "narrow")
"""Towers in which the covariances and gains are the steady state."""


def hints(c: Context) -> Hints:
    """By step of the page; formulas as text are in its names."""
    found = {**_steady_state(), **_without_velocity(c), **_velocity_known(c), **_corners(c)}
    found |= {**_trends(c), **_poles(c.noise)}
    return {**found, **(_improvement(c.noise) if c.noise.determinant else {})}


def _steady_state() -> Hints:
    found: Hints = {}
    values = ["delta/sigma", "m/sigma", "delta eta/sigma^2", "delta one_end/sigma^2"]
    for tower in SIDES:
        prefix = "" if tower == "main" else f"{tower.replace('_', '-')}-"
        found[f"{prefix}riccati"] = {"innovation": ["P11 + 1", "sigma^2 S^2"]}
        found[f"{prefix}stable"] = {"values": values}
    added = "2 h/sigma + {velocity} + {first} Lambda^2"
    found["definite-predicted"] = {
        "minors": [f"(g + ({added}) sigma)/delta", "S^2 g sigma"],
    }
    found["definite-updated"] = {"minors": [f"(g + ({added})/sigma)/delta", "S^2 g/sigma"]}
    return found


def _stable(c: Context) -> dict[str, sp.Expr]:
    """Every entry and gain in its form without a subtraction."""
    x = c.basis
    return {**forms.gains(x), **forms.predicted_covariance(x), **forms.updated_covariance(x)}


def _without_velocity(c: Context) -> Hints:
    """Limits for large S, where the short forms of the tower, which subtract, do not show them."""
    stable = _stable(c)
    names = [*(UPDATED if c.noise.interval else UPDATED[:2]), *GAINS]
    if not c.noise.interval:
        names.remove("gain_22")
    times = {"gain_12": RATIO**2, "gain_22": RATIO**2}
    return {_id("velocity-absent", x): {"limit_form": stable[x] * times.get(x, 1)} for x in names}


def _velocity_known(c: Context) -> Hints:
    """Limits for S falling to 0."""
    stable = _stable(c)
    names = ["updated_12", "gain_12", "gain_21"]
    if c.noise.interval:
        names += ["updated_22", "gain_22"]
    if c.noise.settles:
        names += ["updated_11", "gain_11"]
    found = {_id("velocity-known", x): {"limit_form": stable[x]} for x in names}
    if c.noise.settles:
        found["velocity-known-leading-11"] = {"limit_form": stable["updated_11"] / RATIO}
    return found


def _corners(c: Context) -> Hints:
    """Limits in the corners of the domain."""
    stable, noise = _stable(c), c.noise
    small = {"updated_12": ROOT**4, **({"updated_22": ROOT**4} if noise.interval else {})}
    large = {"updated_11": 1, "updated_12": 1}
    if noise.settles:
        large["updated_22"] = ROOT**2
    return {
        _id(f"{corner}-velocity-index", x): {"limit_form": stable[x] / power}
        for corner, powers in (("small", small), ("large", large))
        for x, power in powers.items()
    }


def _id(place: str, name: str) -> str:
    return f"{place}-{name.replace('_', '-')}"


def _trends(c: Context) -> Hints:
    stable = _stable(c)
    found: Hints = {
        "turning-gain-21-large": {"limit_form": stable["gain_21"]},
        "without-trend-corner": {"limit_form": stable["gain_12"]},
        "bends-down-change-22": {"form": -_bend(c, "updated_22")},
    }
    if c.noise.settles:
        found["bends-down-change-11"] = {"form": -_bend(c, "updated_11")}
    if not c.noise.interval:
        form = updated_by_ratio(Rates(c.basis))["updated_11"]
        for name in ("updated-11", "gain-11"):
            found[f"increasing-{name}-velocity-ratio"] = {"form": form}
    return found


def _bend(c: Context, updated: str) -> sp.Expr:
    """The derivative of an entry of D, evaluated."""
    change = c.tower.expression(derivative(c.tower, real(updated), "tracking_index")) / (2 * INDEX)
    return c.tower.expression(derivative(c.tower, change, "tracking_index"))


def _poles(noise: Noise) -> Hints:
    f = poles.slope(noise)
    found: Hints = {"real-poles": {"form": "Lambda^4/(sigma delta)^2"}}
    if not f:
        return {**found, "pole-sum": {"form": "(4 + {linear})/(m sigma)"}}
    both = rational(f) ** 2 * (INDEX + rational(turning_index(noise)))
    return {
        **found,
        "pole-sum": {"form": "Lambda^2/(m sigma)"},
        "negative-poles": {"form": both / (INDEX**2 * real(POSITIVE))},
    }


def _improvement(noise: Noise) -> Hints:
    return {
        "improvement-range": {"form": _rising(index_tower(noise))},
        "width-start-large": {"form": _crossing_factor(noise, start_level(noise))},
        "width-end-large": {"form": _crossing_factor(noise, end_level(noise))},
    }


def _rising(tower: Tower) -> Fraction:
    """The derivative over (1 + root), which clears differences between a number and the root."""
    slope = derivative(tower, real("improvement"), "tracking_index")
    names = [name for name in tower.variables if name.startswith("root_")]
    factor = tower.fraction(sp.Add(1, *map(real, names)))
    return tower.make(slope.num * factor.num, slope.den * factor.num)


def _crossing_factor(noise: Noise, level: sp.Expr) -> sp.Expr:
    """The positive factor share e/(b - e w), its denominator over the conjugate."""
    e, b = rational(noise.e), real("b")
    share = in_tower(noise, level) + (1 - e) / 4
    square = (e - e**2) + (e / 4 - e**3 / 4) * T**2
    return share * e * (b + e * W) / square


def tower_ends(noise: Noise) -> Mapping[str, Mapping[str, End]]:
    """The ends of towers with roots."""
    found = {
        "main": index_ends(noise),
        "ends": ratio_ends(noise),
        "fixed_velocity_index": fixed_index_ends(noise),
        "narrow": narrow_ends(noise),
    }
    return {
        **found,
        **({"without_ratio": improvement_ends(noise)} if noise.determinant else {}),
    }
