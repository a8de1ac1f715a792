"""How the tracking filters with the uniform motion model hang together, as lines of a table.

Of the lecture's picture its title and one label (linear filter) are left. Each line here is a
definition or is derived; ``derivation`` names where. What the lecture leaves open is the reading of
NP-S and NP-P: here their covariance is the steady one, in which NP-P of one coordinate is MV.
"""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.plots.table import Table, Words


@dataclass(frozen=True)
class Line:
    """An arrow from the general filter to the special one; ``condition`` is what makes it so."""

    general: str
    special: str
    condition: str
    relation: str
    derivation: str


DEFINITION = "definition"
LINES = (
    Line(
        "linear filter",
        "Kalman filter",
        "gain of least error covariance for a model with noise Q, B",
        "K = P H' (H P H' + B)^-1",
        "interacting-gains",
    ),
    Line("linear filter", "NP-S", "Q = 0, K2 held, least smoothed covariance", "", DEFINITION),
    Line("linear filter", "NP-P", "Q = 0, K2 held, least predicted covariance", "", DEFINITION),
    Line(
        "linear filter",
        "alpha-beta filter",
        "diagonal gains: each coordinate by itself",
        "K1 = diag(alpha), T K2 = diag(beta)",
        "interacting-gains",
    ),
    Line(
        "Kalman filter",
        "least squares",
        "one coordinate, Q = 0, nothing known before, equal B and T",
        "alpha = 2 (2 k + 1)/((k + 1) (k + 2)), beta = 6/((k + 1) (k + 2))",
        "least-squares-line",
    ),
    Line(
        "Kalman filter",
        "RV",
        "one coordinate, steady state, the velocity is incremented at each sample",
        "alpha (alpha + beta) = 2 beta",
        "random-velocity",
    ),
    Line(
        "Kalman filter",
        "RA",
        "one coordinate, steady state, acceleration constant over each interval",
        "(alpha + beta/2)^2 = 2 beta",
        "random-acceleration",
    ),
    Line(
        "NP-S",
        "NP-S of one coordinate",
        "one coordinate, steady covariance, beta < 2",
        "2 sqrt(beta) (1 - alpha) = 2 alpha - beta",
        "alpha-beta",
    ),
    Line(
        "NP-P",
        "MV",
        "one coordinate, steady covariance",
        "(alpha + beta/2)^2 = beta",
        "alpha-beta",
    ),
    *(
        Line("alpha-beta filter", special, "these gains", "", DEFINITION)
        for special in ("least squares", "RV", "RA", "NP-S of one coordinate", "MV")
    ),
)
ORDER = ("MV", "RA", "RV")
"""From the least variance of the predicted position to the largest, at equal lag (alpha-beta)."""


def relations() -> Table:
    """The lines of the diagram."""
    return Table(
        "Relations between the tracking filters with the uniform motion model",
        (
            Words("from", "the general filter", tuple(line.general for line in LINES)),
            Words("to", "the special filter", tuple(line.special for line in LINES)),
            Words("condition", "what makes it so", tuple(line.condition for line in LINES)),
            Words("relation", "of the gains", tuple(line.relation for line in LINES)),
            Words("derivation", "where it is derived", tuple(line.derivation for line in LINES)),
        ),
        {"variance of the predicted position at equal lag": " < ".join(ORDER)},
        (
            "Of the lecture's picture its title and one label, linear filter, are left; ours is",
            "what follows from the derivations. The lecture leaves open whether NP-S and NP-P",
            "minimise the steady covariance, as here, or that of each sample: the gain best for",
            "each sample settles at other filters (derivation alpha-beta). Of several coordinates",
            "there need be none that is least in the order of matrices (interacting-gains).",
        ),
    )
