"""The named quantities of a three-state steady state, and how they are printed."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real

INDEX = real("tracking_index")
PARAMETER = real("p")
XI, ETA, DELTA = real("xi"), real("eta"), real("delta")
NU, TAU = real("nu"), real("tau")
ALPHA, BETA, GAMMA = real("alpha"), real("beta"), real("gamma")
DEVIATION = real("innovation_deviation")
REST = real("rest")
FALL, SLOWING = real("omega"), real("mu")
GROWTH, BEND = real("psi"), real("chi")
Z, S, U = real("z"), real("s"), real("u")

ENTRIES = ("11", "12", "13", "22", "23", "33")
PREDICTED = tuple(f"predicted_{entry}" for entry in ENTRIES)
UPDATED = tuple(f"updated_{entry}" for entry in ENTRIES)
GAINS = ("alpha", "beta", "gamma")

LATEX = {
    "tracking_index": r"\Lambda",
    "p": "p",
    "xi": r"\xi",
    "eta": r"\eta",
    "delta": r"\delta",
    "nu": r"\nu",
    "tau": r"\tau",
    "alpha": r"\alpha",
    "beta": r"\beta",
    "gamma": r"\gamma",
    "innovation_deviation": r"\sigma",
    "rest": r"(1 - \alpha)",
    "omega": r"\omega",
    "mu": r"\mu",
    "psi": r"\psi",
    "chi": r"\chi",
    "w": "w",
    "transition_matrix": "F",
    "process_noise": "Q",
    "measurement_matrix": "H",
    "measurement_noise": "R",
    "predictor_position": r"(FK)_1",
    "predictor_velocity": r"(FK)_2",
    "z": "z",
    "s": "s",
    "u": "u",
    "b": "b",
    "level": "G",
    "t": "t",
    "a": "a",
    "g": "g",
    "y": "y",
    "real_pole": "z_1",
    "modulus": r"\rho",
    "half_sum": "m",
    "quarter_discriminant": "h",
    "middle_root": "k",
    **{f"root_{n}": rf"\sqrt{{{n}}}" for n in (2, 3, 5, 6, 10, 15, 30)},
    **{f"predicted_{entry}": rf"M_{{{entry}}}" for entry in ENTRIES},
    **{f"updated_{entry}": rf"X_{{{entry}}}" for entry in ENTRIES},
}


def rows(kind: str) -> list[list[str]]:
    """The names of a symmetric 3 x 3 matrix: `kind` is "predicted" or "updated"."""
    return [[f"{kind}_{min(i, j)}{max(i, j)}" for j in (1, 2, 3)] for i in (1, 2, 3)]


def gain_vector() -> sp.ImmutableDenseMatrix:
    """The filter gain (alpha, beta, gamma) in units T = 1."""
    return sp.ImmutableDenseMatrix([[ALPHA], [BETA], [GAMMA]])


def second(name: str) -> sp.Expr:
    """The second derivative of a named quantity by the index."""
    return sp.Derivative(real(name), (INDEX, 2))


def label(prefix: str, name: str) -> str:
    """The id of a step about a named quantity."""
    return f"{prefix}-{name.replace('_', '-')}"
