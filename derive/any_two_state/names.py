"""The named quantities of a steady state of two states, and how they are printed."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real

INDEX = real("tracking_index")
ROOT = real("p")
D0, D1, D2 = (real(f"d{i}") for i in range(3))
DEVIATION = real("innovation_deviation")
ALPHA, BETA = real("alpha"), real("beta")
PREDICTED = ("predicted_11", "predicted_12", "predicted_22")
UPDATED = ("updated_11", "updated_12", "updated_22")
GAIN_ROWS = (("alpha",), ("beta",))
Z, S = real("z"), real("s")
ODDS = "_odds"
"""What the name of a parameter below 1 has after it for x in 1/(1 + x)."""

LATEX = {
    "tracking_index": r"\Lambda",
    "p": "p",
    "d0": "d_0",
    "d1": "d_1",
    "d2": "d_2",
    "d0_scaled": r"\tilde d_0",
    "d1_scaled": r"\tilde d_1",
    "d2_scaled": r"\tilde d_2",
    "product": "w",
    "innovation_deviation": r"\sigma",
    "alpha": r"\alpha",
    "beta": r"\beta",
    "transition_matrix": "F",
    "process_noise": "Q",
    "measurement_matrix": "H",
    "measurement_noise": "R",
    **{f"n{k}": f"n_{k}" for k in range(3)},
    "z": "z",
    "s": "s",
    **{f"predicted_{ij}": rf"M_{{{ij}}}" for ij in ("11", "12", "22")},
    **{f"updated_{ij}": rf"X_{{{ij}}}" for ij in ("11", "12", "22")},
}


def symmetric(names: tuple[str, str, str]) -> sp.ImmutableDenseMatrix:
    """The symmetric matrix of three named entries 11, 12, 22."""
    first, cross, second = map(real, names)
    return sp.ImmutableDenseMatrix([[first, cross], [cross, second]])


def row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    """Several expressions of which one step speaks."""
    return sp.ImmutableDenseMatrix([list(entries)])
