"""The named quantities of a two-state steady state, and how they are printed."""

from __future__ import annotations

from gainproof.derive.expression import real

INDEX = real("tracking_index")
ROOT = real("p")
ALPHA = real("alpha")
BETA = real("beta")
DEVIATION = real("innovation_deviation")
KAPPA, RHO, ROOT_3 = real("kappa"), real("rho"), real("root_3")
PREDICTED = ("predicted_11", "predicted_12", "predicted_22")
UPDATED = ("updated_11", "updated_12", "updated_22")
GROWTH = real("psi")
Z = real("z")

LATEX = {
    "tracking_index": r"\Lambda",
    "p": r"p",
    "H": r"\eta",
    "s": r"s",
    "kappa": r"\kappa",
    "rho": r"\rho",
    "psi": r"\psi",
    "chi": r"\chi",
    "alpha": r"\alpha",
    "beta": r"\beta",
    "innovation_deviation": r"\sigma",
    "rest": r"(1 - \alpha)",
    "transition_matrix": "F",
    "process_noise": "Q",
    "measurement_matrix": "H",
    "measurement_noise": "R",
    "predictor_position": r"(FK)_1",
    "z": "z",
    "v": "v",
    **{f"predicted_{ij}": rf"M_{{{ij}}}" for ij in ("11", "12", "22")},
    **{f"updated_{ij}": rf"X_{{{ij}}}" for ij in ("11", "12", "22")},
    "pole_real": "a",
    "pole_imaginary": "b",
    "first_pole": "z_1",
    "second_pole": "z_2",
    **{f"root_{n}": rf"\sqrt{{{n}}}" for n in (2, 3, 6)},
    "below": r"\tfrac12\sqrt{|L_1-\Lambda|}",
    "above": r"\tfrac12\sqrt{L_1+\Lambda}",
    "g": "g",
    "x": "x",
    "k": "k",
    "j": "j",
}
