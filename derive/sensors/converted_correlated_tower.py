"""Noises of range and azimuth that are correlated: names and towers, in the plane."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.expression import real
from gainproof.derive.sensors.circles import bearing_circle
from gainproof.derive.sensors.converted_names import KEPT, SIGMA_A, SIGMA_R, TRUE, L, R

C, MORE, LESS = map(real, ("noise_covariance", "covariance_more", "covariance_less"))
S, K = real("scale"), real("turns")
GROWN, TURNED = real("exponent"), real("phase")
SQUARE = SIGMA_R**2 - 4 * C**2
"""What is left of the squared noise of the range where its azimuth is doubled, of lambda^4."""
MEAN = real("correlated_ahead"), real("correlated_beside")
SPREAD = tuple(real(f"correlated_{axis}") for axis in ("radial", "cross", "mixed"))
MEAN_SQUARE = tuple(real(f"correlated_unbiased_{axis}") for axis in ("radial", "cross", "mixed"))
LATEX = {
    "scale": "t",
    "turns": "k",
    "noise_covariance": "c",
    "covariance_more": "c_+",
    "covariance_less": "c_-",
    "exponent": "p",
    "phase": "q",
    "correlated_ahead": r"m_\rho",
    "correlated_beside": r"m_\kappa",
    **{
        f"{name}_{axis}": rf"{letter}_{{{short}}}"
        for name, letter in (("correlated", "N"), ("correlated_unbiased", "B"))
        for axis, short in (
            ("radial", r"\rho\rho"),
            ("cross", r"\kappa\kappa"),
            ("mixed", r"\rho\kappa"),
        )
    },
}


def correlated_tower() -> Tower:
    """Identities: the covariance of the noises is of either sign."""
    radial, cross, mixed = spread()
    level, beside = bias()
    elements = {
        "noise_covariance": MORE - LESS,
        "exponent": (S**2 * SIGMA_R**2 - K**2 * SIGMA_A**2) / 2,
        "phase": K * S * C,
        "correlated_ahead": KEPT * TRUE,
        "correlated_beside": KEPT * C,
        "correlated_radial": radial,
        "correlated_cross": cross,
        "correlated_mixed": mixed,
        "correlated_unbiased_radial": radial + level**2,
        "correlated_unbiased_cross": cross + beside**2,
        "correlated_unbiased_mixed": mixed + level * beside,
    }
    free = ("covariance_more", "covariance_less", "scale", "turns")
    own = above_zero(
        "true_range", "slant_range", "range_deviation", "azimuth_deviation", "kept_azimuth"
    )
    closed = from_zero(*free)
    return Tower("correlated", (*own, *closed), (), elements)


def spread() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Along, across, and of the two, with little that cancels."""
    return (
        (R**2 * (1 - L) ** 2 + SIGMA_R**2 * (1 + L**2)) / 2 - 2 * L**2 * C**2,
        (R**2 + SIGMA_R**2) * (1 - L) * (1 + L) / 2 - L * C**2 * (1 - 2 * L),
        -L * R * C * (1 - 2 * L),
    )


def bias() -> tuple[sp.Expr, sp.Expr]:
    """Of the unbiased conversion given the measurement, along and across."""
    return R * (1 - L) / KEPT, -C * (1 + L) / KEPT


def turned_correlated_tower() -> Tower:
    """What the kernels for correlated noises are made of."""
    circle = bearing_circle()
    elements = {
        "cos_azimuth": circle["cos_bearing"],
        "sin_azimuth": circle["sin_bearing"],
        "change_azimuth": KEPT**2 - 1,
        "correlation": MORE - LESS,
    }
    own = above_zero("slant_range", "range_deviation", "azimuth_deviation", "kept_azimuth")
    names = ("covariance_more", "covariance_less", "g", "k")
    closed = from_zero(*names)
    return Tower("correlated_plane", (*own, *closed), (), elements)
