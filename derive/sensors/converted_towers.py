"""The parameters under converted measurements, all positive, and what is made of them.

The noise of the azimuth enters as 1/(1 + l) with l above 0: every number between 0 and 1 is
exp(-sigma^2/2) of one deviation. The azimuth itself is a point of a circle, in two parts as the
bearing of polar coordinates.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.sensors import converted_forms as forms
from gainproof.derive.sensors.circles import bearing_circle
from gainproof.derive.sensors.converted_forms import Noise
from gainproof.derive.sensors.converted_names import (
    COS2,
    KEPT,
    LOSS,
    SIGMA_A,
    SIGMA_R,
    SIN2,
    TRUE,
    L,
    R,
)

ONE = sp.Integer(1)
DEVIATIONS = ("range_deviation", "azimuth_deviation", "azimuth_loss")


def main_tower() -> Tower:
    """Moments and covariances along and across the line of sight."""
    measured = Noise(R, SIGMA_R**2, L, 1 - L)
    elements = {"kept_azimuth": 1 / (1 + LOSS)}
    elements |= {"cosine_square": (1 + KEPT**4) / 2, "sine_square": (1 - KEPT**4) / 2}
    pairs = {
        "true_spread": forms.spread(Noise(TRUE, SIGMA_R**2, L, 1 - L)),
        "spread": forms.spread(measured),
        "classical": (SIGMA_R**2, R**2 * SIGMA_A**2),
        "debiased": forms.debiased(measured),
        "unbiased": forms.unbiased(measured),
        "modified": forms.spread(measured),
        "average": _average(),
    }
    for name, pair in pairs.items():
        elements |= {f"{name}_radial": pair[0], f"{name}_cross": pair[1]}
    elements |= {
        "factor_classical": ONE,
        "factor_debiased": 1 + KEPT - KEPT**2,
        "factor_unbiased": 1 / KEPT,
        "factor_modified": KEPT,
    }
    return Tower("main", above_zero("true_range", "slant_range", *DEVIATIONS), (), elements)


def _average() -> tuple[sp.Expr, sp.Expr]:
    """The mean, given the measurement, of the unbiased conversion's covariance given the truth."""
    whole, wider = R**2 + SIGMA_R**2, R**2 + 2 * SIGMA_R**2
    turned = (1 + L**4) / 2, (1 - L**4) / 2
    return wider * turned[0] / L - whole * COS2, wider * turned[1] / L - whole * SIN2


def plane_tower() -> Tower:
    """What the kernels in the plane are made of."""
    circle = bearing_circle()
    elements = {
        "cos_azimuth": circle["cos_bearing"],
        "sin_azimuth": circle["sin_bearing"],
        "kept_azimuth": 1 / (1 + LOSS),
        "change_azimuth": KEPT**2 - 1,
    }
    turned = from_zero("g", "k")
    return Tower("plane", (*above_zero("slant_range", *DEVIATIONS), *turned), (), elements)
