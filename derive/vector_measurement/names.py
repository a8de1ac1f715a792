"""The named quantities of a steady state with position and velocity measured."""

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
    "v": "v",
    "pole_mean": "a",
    "positive_from": "y_{+}",
    "negative_up_to": "y_{-}",
    **{f"only_predicted_{ij}": f"P_{{{ij}}}^{{o}}" for ij in ("11", "12", "22")},
    **{f"only_updated_{ij}": f"U_{{{ij}}}^{{o}}" for ij in ("11", "12", "22")},
    "only_innovation_deviation": r"\sigma^{o}",
    "known_predicted_11": "P_{11}^{d}",
    "known_updated_11": "U_{11}^{d}",
    **{f"root_{n}": rf"\sqrt{{{n}}}" for n in (2, 3, 6)},
    "source_k": r"\mathrm{k}",
    **{f"source_p{n}": rf"\mathrm{{p}}_{n}" for n in (1, 2, 3)},
}
"""Of what the page cannot say: the other names are printed as it writes them."""


def in_words(expression: sp.Expr) -> str:
    """A product of named quantities as people write it: a^2 b/c."""
    return str(sp.sstr(expression)).replace("**", "^").replace("*", " ")


def gain_matrix() -> sp.ImmutableDenseMatrix:
    """The filter gain over its named entries."""
    return sp.ImmutableDenseMatrix([[real(name) for name in row] for row in GAIN_ROWS])
