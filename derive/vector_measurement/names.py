"""The named quantities of a steady state with position and velocity measured, and their LaTeX."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real

INDEX = real("tracking_index")
RATIO = real("velocity_ratio")
ROOT = real("p")
LEVEL = real("level")
ETA = real("eta")
MEAN = real("mean_root")
DELTA = real("delta")
SIGMA = real("innovation_ratio")
SPEED = real("velocity_index")
COUPLING = real("coupling")
CROSS = real("cross_mean")
REST = real("cross_rest")
Z = real("z")

PREDICTED = ("predicted_11", "predicted_12", "predicted_22")
UPDATED = ("updated_11", "updated_12", "updated_22")
GAINS = ("gain_11", "gain_12", "gain_21", "gain_22")
GAIN_ROWS = (("gain_11", "gain_12"), ("gain_21", "gain_22"))

LATEX = {
    "tracking_index": r"\Lambda",
    "velocity_ratio": "S",
    "p": "p",
    "level": "w",
    "eta": r"\eta",
    "mean_root": "m",
    "delta": r"\delta",
    "innovation_ratio": r"\sigma",
    "velocity_index": "t",
    "coupling": r"\kappa",
    "cross_mean": "h",
    "cross_rest": "g",
    "transition_matrix": "F",
    "process_noise": "Q",
    "measurement_matrix": "H",
    "measurement_noise": "R",
    "z": "z",
    "v": "v",
    **{f"predicted_{ij}": f"P_{{{ij}}}" for ij in ("11", "12", "22")},
    **{f"updated_{ij}": f"U_{{{ij}}}" for ij in ("11", "12", "22")},
    **{f"gain_{ij}": f"K_{{{ij}}}" for ij in ("11", "12", "21", "22")},
}


def in_words(expression: sp.Expr) -> str:
    """A product of named quantities as people write it: a^2 b/c."""
    return str(sp.sstr(expression)).replace("**", "^").replace("*", " ")


def symmetric(names: tuple[str, str, str]) -> sp.ImmutableDenseMatrix:
    """The symmetric 2 x 2 matrix of three named entries 11, 12, 22."""
    first, cross, second = map(real, names)
    return sp.ImmutableDenseMatrix([[first, cross], [cross, second]])


def gain_matrix() -> sp.ImmutableDenseMatrix:
    """The filter gain over its named entries."""
    return sp.ImmutableDenseMatrix([[real(name) for name in row] for row in GAIN_ROWS])


def row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    """Several expressions of which one step speaks, as a matrix of one row."""
    return sp.ImmutableDenseMatrix([list(entries)])
