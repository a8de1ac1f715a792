"""How the tracking filters with the uniform motion model hang together: a table and a picture.

Of the lecture's picture its title and one label (linear filter) are left. Each line here is a
definition or is derived; ``derivation`` names where. What the lecture leaves open is the reading of
NP-S and NP-P: here their covariance is the steady one, in which NP-P of one coordinate is MV.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from gainproof.figures.lecture.diagram import Box, arrow, empty_axes, put
from gainproof.plots.table import Table, Words

if TYPE_CHECKING:
    from matplotlib.figure import Figure


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


SIZE = (8.4, 4.9)
WIDTH, HEIGHT = 130.0, 76.0
LINEAR = Box(
    65,
    38,
    129,
    75,
    "Linear filters",
    r"update  $\hat x(+) = \hat x(-) + K\,(z - H\hat x(-))$  with any gain matrix"
    " $K = (K_1, K_2)$; not diagonal: interacting",
    "0.96",
)
ALPHA_BETA = Box(
    65,
    27,
    125,
    35,
    r"$\mathbf{\alpha}$-$\mathbf{\beta}$ filters",
    r"$K_1$, $K_2$ diagonal (non-interacting): each coordinate by itself, $\alpha$ and $\beta/T$",
    "0.9",
)
GENERAL = {
    "Kalman filter": Box(
        39, 67, 56, 12, "Kalman filter", "least error covariance for a model with noise $Q$, $B$"
    ),
    "NP-S": Box(90, 67, 24, 12, "NP-S", "$Q = 0$, $K_2$ held, least\nsmoothed covariance"),
    "NP-P": Box(115.5, 67, 24, 12, "NP-P", "$Q = 0$, $K_2$ held, least\npredicted covariance"),
}
LINE = "$\\alpha_k = \\dfrac{2(2k+1)}{(k+1)(k+2)}$\n$\\beta_k = \\dfrac{6}{(k+1)(k+2)}$"
SPECIAL = {
    "least squares": Box(16, 27, 24, 18, "least squares", LINE, spacing=3.4),
    "RV": Box(39, 27, 18, 18, "RV", r"$\alpha(\alpha + \beta) = 2\beta$"),
    "RA": Box(62, 27, 24, 18, "RA", r"$(\alpha + \beta/2)^2 = 2\beta$"),
    "NP-S of one coordinate": Box(
        90, 27, 26, 18, "NP-S, one coordinate", r"$2\sqrt{\beta}\,(1-\alpha) = 2\alpha - \beta$"
    ),
    "MV": Box(115.5, 27, 21, 18, "MV", r"$(\alpha + \beta/2)^2 = \beta$"),
}
WORDS = {
    "least squares": "$Q = 0$, nothing\nknown before,\nequal $B$ and $T$",
    "RV": "steady state,\nvelocity steps\nat each sample",
    "RA": "steady state,\nacceleration constant\nover each interval",
    "NP-S of one coordinate": "steady\ncovariance,\n" + r"$\beta < 2$",
    "MV": "steady\ncovariance",
}
"""On the arrows, which are those of one coordinate."""
FRAME_TOP = ALPHA_BETA.top[1]


def draw_relations(table: Table, sheet: Figure) -> None:
    """Frames for the general kinds, boxes for the filters, an arrow for each derived line."""
    axes = empty_axes(sheet, WIDTH, HEIGHT)
    put(axes, LINEAR, frame=True)
    put(axes, ALPHA_BETA, frame=True)
    for box in [*GENERAL.values(), *SPECIAL.values()]:
        put(axes, box)
    lines = zip(table.words("from"), table.words("to"), strict=True)
    for general, special in lines:
        # what lies within a frame needs no arrow
        if general in GENERAL and special in SPECIAL:
            start, end = GENERAL[general], SPECIAL[special]
            offset = (end.x - start.x) * 0.8 if general == "Kalman filter" else 0.0
            begin = (start.x + offset, start.bottom[1])
            # above the frame of the special filters, so that no words lie on its border
            place = 0.5 * (begin[1] - FRAME_TOP) / (begin[1] - end.top[1])
            arrow(axes, begin, end.top, WORDS[special], place=place)
    order = "  <  ".join(ORDER)
    words = rf"at equal lag $1/\beta$, variance of the predicted position:  {order}"
    axes.text(125, 14.6, words, ha="right", fontsize=8)
