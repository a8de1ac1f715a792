"""The relations of the tracking filters as a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gainproof.figures.lecture.diagram import Box, arrow, empty_axes, put
from gainproof.figures.lecture.relations import ORDER
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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
