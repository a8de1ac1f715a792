"""The named alpha-beta filters as pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gainproof.figures.lecture import look
from gainproof.figures.lecture.curves import COMPARED
from gainproof.figures.lecture.look import Look
from gainproof.figures.lecture.turn import GAINS
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

VARIANCE_SIZE = (6.3, 5.2)
STABILITY_SIZE = (5.6, 5.4)
LOOKS = {
    "mv": Look(look.DARK, look.SOLID, "MV"),
    "nps": Look("0.45", look.DOTTED, "NP-S", 2.0),
    "ra": Look(look.MIDDLE, look.DASHED, "RA"),
    "rv": Look(look.LIGHT, look.DASH_DOT, "RV"),
}
CURVES = {
    "mv": r"MV (NP-P): $(\alpha+\beta/2)^2 = \beta$",
    "nps": r"NP-S: $2\sqrt{\beta}\,(1-\alpha) = 2\alpha-\beta$",
    "ra": r"RA: $(\alpha+\beta/2)^2 = 2\beta$",
    "rv": r"RV: $\alpha(\alpha+\beta) = 2\beta$",
}


def draw_minimum_variance(table: Table, sheet: Figure) -> None:
    """Above the variances, below how much more than the least."""
    variance, ratio = sheet.subplots(2, 1, sharex=True, height_ratios=(1.6, 1))
    look.framed(variance, "", r"$\sigma_p^2/B$, predicted position")
    look.framed(ratio, r"lag $1/\beta$, of a constant acceleration over $aT^2$", "over that of MV")
    for name in COMPARED:
        own = LOOKS[name]
        variance.plot(table["lag"], table[f"{name}_variance"], **own.line)
        if name != "mv":
            ratio.plot(table["lag"], table[f"{name}_over_mv"], **own.line)
    ratio.axhline(1.0, **LOOKS["mv"].line)
    variance.set_xscale("log")
    variance.set_yscale("log")
    variance.set_ylim(0.1, 30)
    ratio.set_ylim(0.95, 2.0)
    variance.set_xlim(table["lag"][0], table["lag"][-1])
    variance.legend(loc="upper right")


def draw_stability(table: Table, sheet: Figure) -> None:
    """The triangle, the curves of the named filters, the lecture's two gain pairs."""
    axes = sheet.subplots()
    look.framed(axes, r"$\alpha$", r"$\beta$")
    axes.fill([0, 2, 0], [0, 0, 4], color="0.92", linewidth=0)
    axes.plot([0, 2], [4, 0], color="0.35", linewidth=0.9)
    axes.annotate(r"$\beta = 4 - 2\alpha$", (1.2, 1.6), xytext=(8, 6), textcoords="offset points")
    for name, own in LOOKS.items():
        plain = {**own.line, "label": CURVES[name]}
        axes.plot(table[f"{name}_alpha"], table[f"{name}_beta"], **plain)
    for name, (alpha, beta) in GAINS.items():
        label = "the lecture's gain pairs" if name == "small" else None
        mark: dict[str, Any] = {"color": "white", "markeredgecolor": "black", "zorder": 5}
        axes.plot(alpha, beta, "o", label=label, clip_on=False, **mark)
    axes.text(0.95, 0.12, "stable inside", color="0.3")
    axes.set_xlim(0, 2.1)
    axes.set_ylim(0, 4.2)
    axes.legend(loc="upper right")
