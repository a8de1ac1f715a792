"""The named quantities of converted measurements, and how they are printed.

The azimuth counts from the x axis towards the y axis. In the main tower matrices stand in the frame
of the line of sight: along it (`radial`) and across it (`cross`); there every covariance of
independent noises is diagonal.
"""

from __future__ import annotations

from gainproof.derive.expression import real

TRUE, R = real("true_range"), real("slant_range")
SIGMA_R, SIGMA_A = real("range_deviation"), real("azimuth_deviation")
LOSS, KEPT = real("azimuth_loss"), real("kept_azimuth")
L = KEPT**2
"""exp(-sigma^2) of the azimuth: in it all covariances are polynomials."""
COS2, SIN2 = real("cosine_square"), real("sine_square")
COS_A, SIN_A = real("cos_azimuth"), real("sin_azimuth")
G, K = real("g"), real("k")

TRUE_SPREAD = real("true_spread_radial"), real("true_spread_cross")
SPREAD = real("spread_radial"), real("spread_cross")
"""The covariance V of the raw conversion, at the true and at the measured range."""

CONVERSIONS = ("classical", "debiased", "unbiased", "modified")
FACTOR = {name: real(f"factor_{name}") for name in CONVERSIONS}
STATED = {
    name: (real(f"{name}_radial"), real(f"{name}_cross")) for name in (*CONVERSIONS, "average")
}
"""The covariances that the papers state; `average`: the other one of the unbiased conversion."""

LATEX = {
    "true_range": "r",
    "slant_range": "r_m",
    "azimuth": r"\theta",
    "measured_azimuth": r"\theta_m",
    "range_deviation": r"\sigma_r",
    "azimuth_deviation": r"\sigma_\theta",
    "azimuth_loss": r"\ell",
    "kept_azimuth": r"\lambda",
    "change_azimuth": r"\delta",
    "cosine_square": "C",
    "sine_square": "S",
    "cos_azimuth": r"c_\theta",
    "sin_azimuth": r"s_\theta",
    "g": "g",
    "k": "k",
    "true_spread_radial": r"V_\rho(r)",
    "true_spread_cross": r"V_\kappa(r)",
    "spread_radial": r"V_\rho",
    "spread_cross": r"V_\kappa",
    **{f"factor_{name}": f"f_{name[0]}" for name in CONVERSIONS},
    **{
        f"{name}_{axis}": rf"{letter}_\{greek}"
        for name, letter in zip((*CONVERSIONS, "average"), "KDUMA", strict=True)
        for axis, greek in (("radial", "rho"), ("cross", "kappa"))
    },
}
