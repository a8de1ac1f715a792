"""The named quantities of a steady state of three states, and how they are printed."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real

INDEX = real("tracking_index")
ROOT = real("p")
AREA = INDEX**2
"""q."""
ROOTS = (real("d0"), real("d1"), real("d2"), real("d3"))
TOTAL = sp.Add(*ROOTS)
DETERMINANT = ROOTS[1] * ROOTS[2] - ROOTS[0] * ROOTS[3]
"""Of the equations for the derivatives of d1 and d2; positive, and written so where it divides."""
DEVIATION = real("innovation_deviation")
GAINS = (real("alpha"), real("beta"), real("gamma"))
PLACES = ("11", "12", "13", "22", "23", "33")
GAIN_ROWS = (("alpha",), ("beta",), ("gamma",))
Z, S = real("z"), real("s")

LATEX = {
    "tracking_index": r"\Lambda",
    "p": "p",
    **{f"d{k}": f"d_{k}" for k in range(4)},
    **{f"d{k}_scaled": rf"\tilde d_{k}" for k in range(4)},
    "innovation_deviation": r"\sigma",
    "inverse_deviation": r"\sigma^{-1}",
    "alpha": r"\alpha",
    "beta": r"\beta",
    "gamma": r"\gamma",
    "transition_matrix": "F",
    "process_noise": "Q",
    "measurement_matrix": "H",
    "measurement_noise": "R",
    **{f"n{k}": f"n_{k}" for k in range(3)},
    "z": "z",
    "s": "s",
    **{f"predicted_{place}": rf"M_{{{place}}}" for place in PLACES},
    **{f"updated_{place}": rf"X_{{{place}}}" for place in PLACES},
}


def entries(kind: str) -> list[list[str]]:
    """The names of the entries of a symmetric matrix."""
    return [[f"{kind}_{min(i, j)}{max(i, j)}" for j in (1, 2, 3)] for i in (1, 2, 3)]


def symmetric(kind: str) -> sp.ImmutableDenseMatrix:
    """The predicted or the updated covariance."""
    return sp.ImmutableDenseMatrix([[real(name) for name in row] for row in entries(kind)])
