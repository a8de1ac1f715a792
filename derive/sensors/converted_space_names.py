"""The named quantities of converted measurements in space, and how they are printed.

Matrices stand in the frame of the bearing: horizontally ahead, across, and up. The elevation is
that above the plane of x and y.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.sensors.converted_names import CONVERSIONS, KEPT, SIGMA_R, R

SIGMA_E = real("elevation_deviation")
LOSS_E, KEPT_E = real("elevation_loss"), real("kept_elevation")
LA, LE = KEPT**2, KEPT_E**2
COS_E, SIN_E = real("cos_elevation"), real("sin_elevation")
A = real("a")
ENTRIES = ("ahead", "across", "up", "tilt")
MATRICES = ("space_classical", "space_debiased", "space_unbiased", "space_modified")
ENTRY = {name: tuple(real(f"{name}_{e}") for e in ENTRIES) for name in MATRICES}
UPRIGHT = tuple(real(f"upright_{e}") for e in ("ahead", "up", "tilt"))
"""The covariance with a noise of the range and the elevation alone."""

WHOLE, WIDER = R**2 + SIGMA_R**2, R**2 + 2 * SIGMA_R**2
ONCE, TWICE = (
    tuple(real(f"{entry}_square_{times}") for entry in ("level", "height", "slope"))
    for times in ("once", "twice")
)
"""Mean squares of cosine and sine of an elevation with noise, once and twice, and mean products."""

BOTH = KEPT * KEPT_E

LATEX = {
    "elevation": r"\eta",
    "elevation_deviation": r"\sigma_\eta",
    "elevation_loss": r"\ell_\eta",
    "kept_elevation": r"\lambda_\eta",
    "change_elevation": r"\delta_\eta",
    "cos_elevation": r"c_\eta",
    "sin_elevation": r"s_\eta",
    "a": "a",
    **{
        f"{entry}_square_{times}": f"{letter}_{number}"
        for entry, letter in (("level", "C"), ("height", "S"), ("slope", "B"))
        for number, times in ((1, "once"), (2, "twice"))
    },
    **{f"level_{name}": f"f_{name[0]}" for name in CONVERSIONS},
    **{f"upwards_{name}": f"g_{name[0]}" for name in CONVERSIONS},
    **{
        f"upright_{entry}": f"W_{{{short}}}"
        for entry, short in (("ahead", "aa"), ("up", "uu"), ("tilt", "au"))
    },
    **{
        f"{name}_{entry}": f"{letter}_{{{short}}}"
        for name, letter in zip(MATRICES, "KDUV", strict=True)
        for entry, short in zip(ENTRIES, ("aa", "cc", "uu", "au"), strict=True)
    },
}


def _factors(which: str) -> dict[str, sp.Symbol]:
    return {name: real(f"{which}_{name}") for name in CONVERSIONS}


LEVEL, UPWARDS = _factors("level"), _factors("upwards")
"""What the conversions multiply the measured place ahead and the height by."""


def squares(kept: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Mean squares of cosine and sine of the noisy elevation, and the mean of their product, where
    noise keeps `kept` of the mean cosine of its double.
    """
    double = COS_E**2 - SIN_E**2
    return (1 + kept * double) / 2, (1 - kept * double) / 2, kept * COS_E * SIN_E
