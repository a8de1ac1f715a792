"""The named quantities of gains that follow the index: symbols, and how they are printed.

e belongs to the index of now, n to the nominal one (or the one before), g to one that follows.
"""

from __future__ import annotations

from gainproof.derive.expression import real
from gainproof.derive.steady_state.names import LATEX as STEADY

E, N, G, K = map(real, ("e", "n", "g", "k"))
INDEX, NOMINAL, FOLLOWING = map(real, ("tracking_index", "nominal_index", "following_index"))
ALPHA, BETA = map(real, ("alpha", "beta"))
NOMINAL_ALPHA, NOMINAL_BETA = map(real, ("nominal_alpha", "nominal_beta"))
FOLLOWING_ALPHA, FOLLOWING_BETA = map(real, ("following_alpha", "following_beta"))
ALPHA_SLOPE, BETA_SLOPE = map(real, ("alpha_slope", "beta_slope"))
NEXT_ALPHA_SLOPE, NEXT_BETA_SLOPE = map(real, ("next_alpha_slope", "next_beta_slope"))
FIRST_ALPHA, FIRST_BETA = map(real, ("first_order_alpha", "first_order_beta"))
ALPHA_EXCESS, BETA_EXCESS = map(real, ("alpha_excess", "beta_excess"))
RATIO = real("index_ratio")
"""Of the index to the nominal one."""
DEVIATION = real("innovation_deviation")
ENTRIES = ("11", "12", "22")

LATEX = {
    **STEADY,
    "e": "e",
    "n": "n",
    "g": "g",
    "s": "s",
    "u": "u",
    "v": "v",
    "k": "k",
    "variance_ratio": "c_v",
    "index_ratio": "c",
    "d": r"\sigma_i",
    "half_tangent": r"\tau",
    "acceleration_deviation": r"\sigma_w",
    "interval": "T",
    "variance": "R_i",
    "axis_index": r"\Lambda_i",
    "nominal_index": r"\Lambda_0",
    "nominal_alpha": r"\alpha_0",
    "nominal_beta": r"\beta_0",
    "alpha_slope": r"\alpha_0'",
    "beta_slope": r"\beta_0'",
    "next_alpha_slope": r"\alpha'",
    "next_beta_slope": r"\beta'",
    "first_order_alpha": "a",
    "first_order_beta": "b",
    "alpha_excess": r"E_\alpha",
    "beta_excess": r"E_\beta",
    "backward_alpha_excess": r"G_\alpha",
    "backward_beta_excess": r"G_\beta",
    "following_index": r"\Lambda_2",
    "following_alpha": r"\alpha_2",
    "following_beta": r"\beta_2",
    "position_variance": "R",
    "nominal_variance": "R_0",
    "following_variance": "R_2",
    "variance_along": "R_r",
    "variance_across": r"R_\theta",
    "alpha_so_far": "A",
    "beta_so_far": "B",
    "alpha_bound": r"\Lambda_\alpha",
    "beta_bound": r"\Lambda_\beta",
    "alpha_along": r"\alpha_r",
    "alpha_across": r"\alpha_\theta",
    "beta_along": r"\beta_r",
    "beta_across": r"\beta_\theta",
    "alpha_place": r"e_\alpha",
    "beta_place": r"e_\beta",
    "cosine": r"c_\theta",
    "sine": r"s_\theta",
    "later_cosine": "c_2",
    "later_sine": "s_2",
    "later_half_tangent": r"\tau_2",
    **{f"held_predicted_{ij}": f"P_{{{ij}}}" for ij in ENTRIES},
    **{f"held_updated_{ij}": f"Y_{{{ij}}}" for ij in ENTRIES},
    **{f"followed_predicted_{ij}": f"S_{{{ij}}}" for ij in ENTRIES},
    **{f"followed_updated_{ij}": f"Z_{{{ij}}}" for ij in ENTRIES},
    **{f"root_{n}": rf"\sqrt{{{n}}}" for n in (3, 5)},
}
