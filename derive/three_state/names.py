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
HIDDEN = ("updated_22", "updated_23", "updated_33")
"""The entries of the updated covariance that no gain shows."""
GAINS = ("alpha", "beta", "gamma")

LATEX = {
    "rest": r"(1 - \alpha)",
    "predictor_position": r"(FK)_1",
    "predictor_velocity": r"(FK)_2",
}
"""What is printed otherwise than the page calls it."""


def rows(kind: str) -> list[list[str]]:
    """The names of a symmetric 3 x 3 matrix: `kind` is "predicted" or "updated"."""
    return [[f"{kind}_{min(i, j)}{max(i, j)}" for j in (1, 2, 3)] for i in (1, 2, 3)]


def gain_vector() -> sp.ImmutableDenseMatrix:
    """The filter gain (alpha, beta, gamma) in units T = 1."""
    return sp.ImmutableDenseMatrix([[ALPHA], [BETA], [GAMMA]])
