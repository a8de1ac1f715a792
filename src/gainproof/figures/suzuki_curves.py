"""Numbers and pictures of the source's figures 1 to 3, from the kernels (Suzuki, section 4).

The quantities are those of the captions; the ranges are ours, since the pictures themselves are
not among what we have. r = 4/Lambda is the normalised deviation of the measured position, S that
of the measured velocity, G1 the variance of the predicted position over sigma_o^2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.plots.canvas import logarithmic
from gainproof.plots.table import Column, Table, decades, grid
from gainproof.position_velocity import velocity_ratio_for
from gainproof.position_velocity.variance import position_variance

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POSITION = "4 sigma_o/(sigma_a T^2), normalised deviation of the measured position"
VELOCITY = "sigma_d T/sigma_o, normalised deviation of the measured velocity"
STEP = 1.1
"""The source's factor that says where the step of G1 begins."""
PER_DECADE = 16


def figure_1() -> Table:
    """G1 against S, r as parameter: one curve for each decade of r."""
    r, s = grid(decades(-2, 4, 1), decades(-5, 5, PER_DECADE))
    variance = position_variance().at(4 / r, s)
    return Table(
        "Velocity measurement error S and predicted position error G1",
        (
            Column("r", POSITION, r),
            Column("S", VELOCITY, s),
            Column("G1", "variance of the predicted position over sigma_o^2", variance),
        ),
    )


def figure_2() -> Table:
    """S against r where G1 = 1.1 G1(S=0), and where G1 = G1(S=infinity)/1.1: the step's ends."""
    r = decades(-3, 6, PER_DECADE)
    index = 4 / r
    variance = position_variance()
    begin, end = (
        np.asarray(velocity_ratio_for(index, wanted))
        for wanted in (variance.known_exactly(index) * STEP, variance.not_measured(index) / STEP)
    )
    return Table(
        "Where G1 = 1.1 G1(S=0): r and S",
        (
            Column("r", POSITION, r),
            Column("S", "S at which G1 = 1.1 G1(S=0)", begin),
            Column("S_end", "S at which G1 = G1(S=infinity)/1.1", end),
            Column("width", "S_end/S, the width of the step of G1", end / begin),
        ),
    )


def figure_3() -> Table:
    """G1(S=0)/G1(S=infinity) against r."""
    r = decades(-3, 6, PER_DECADE)
    index = 4 / r
    variance = position_variance()
    known, missing = variance.known_exactly(index), variance.not_measured(index)
    ratio = known / missing
    return Table(
        "Improvement of the predicted position error",
        (
            Column("r", POSITION, r),
            Column("ratio", "G1(S=0)/G1(S=infinity)", ratio),
            Column("G1_zero", "G1 in the limit S to 0", known),
            Column("G1_infinity", "G1 in the limit S to infinity", missing),
        ),
        {"ratio at the least r": float(ratio[0])},
    )


R_LABEL = r"$r = 4\sigma_o/(\sigma_a T^2)$"
S_LABEL = r"$S = \sigma_d T/\sigma_o$"
G_LABEL = r"$G_1 = \tilde{P}_1/\sigma_o^2$"
FIRST_COLOUR, SECOND_COLOUR = "#1f4e79", "#b5482a"
SMALL_RATIO = 4 - 2 * np.sqrt(3.0)
"""G1(S=0)/G1(S=infinity) as r goes to 0; the source prints 0.536."""


def draw_figure_1(table: Table, sheet: Figure) -> None:
    """G1 against S for each r, the curves named at their right end."""
    axes = sheet.subplots()
    logarithmic(axes, S_LABEL, G_LABEL)
    parameters = np.unique(table["r"])
    from matplotlib import colormaps

    colours = colormaps["viridis"](np.linspace(0.0, 0.78, parameters.size))
    for r, colour in zip(parameters, colours, strict=True):
        chosen = table["r"] == r
        s, g = table["S"][chosen], table["G1"][chosen]
        axes.plot(s, g, color=colour)
        power = round(np.log10(r))
        name = {0: "1", 1: "10"}.get(power, f"10^{{{power}}}")
        prefix = "r = " if r == parameters[-1] or r == parameters[0] else ""
        axes.annotate(
            f"${prefix}{name}$",
            (s[-1], g[-1]),
            xytext=(5, 0),
            textcoords="offset points",
            va="center",
            color=colour,
            annotation_clip=False,
            fontsize=9,
        )
    axes.set_xlim(table["S"].min(), table["S"].max())


def draw_figure_2(table: Table, sheet: Figure) -> None:
    """Where the step of G1 begins, and, thinner, where it ends."""
    axes = sheet.subplots()
    logarithmic(axes, R_LABEL, S_LABEL)
    r = table["r"]
    axes.fill_between(r, table["S"], table["S_end"], color="0.93", linewidth=0)
    axes.plot(r, table["S"], color=FIRST_COLOUR, label=r"$G_1 = 1.1\,G_1|_{S=0}$")
    axes.plot(
        r,
        table["S_end"],
        color=SECOND_COLOUR,
        linewidth=1,
        linestyle=(0, (5, 3)),
        label=r"$G_1 = G_1|_{S=\infty}/1.1$",
    )
    axes.set_xlim(r.min(), r.max())
    axes.set_ylim(1e-7, 1e5)
    axes.legend(loc="upper right")
    words: dict[str, Any] = {
        "transform": axes.transAxes,
        "ha": "center",
        "va": "center",
        "color": "0.25",
    }
    axes.text(0.20, 0.22, "within 10 % of a\nvelocity known exactly", **words)
    axes.text(0.62, 0.80, "within 10 % of\nposition alone", **words)
    axes.text(0.76, 0.35, "the step of $G_1$", **words)


def draw_figure_3(table: Table, sheet: Figure) -> None:
    """The improvement ratio, with its limit for small r."""
    axes = sheet.subplots()
    label = r"$\tilde{P}_1|_{S=0}\,/\,\tilde{P}_1|_{S=\infty}$"
    logarithmic(axes, R_LABEL, label)
    r = table["r"]
    axes.axhline(SMALL_RATIO, color="0.5", linewidth=0.9, linestyle=(0, (5, 3)))
    axes.annotate(
        rf"$4 - 2\sqrt{{3}} = {SMALL_RATIO:.4f}$",
        (r.max(), SMALL_RATIO),
        xytext=(-6, 4),
        textcoords="offset points",
        ha="right",
        color="0.3",
    )
    axes.plot(r, table["ratio"], color=FIRST_COLOUR)
    axes.set_xlim(r.min(), r.max())
    axes.set_ylim(top=1.0)
