"""The limits of the first-order update, in closed form, as numbers and as a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.lecture.look import DASH_DOT, DASHED, DOTTED
from gainproof.figures.patent_look import ENDS, NOMINAL_COLOURS
from gainproof.figures.patent_scene import nominal_points
from gainproof.generated import updated_gains
from gainproof.plots.canvas import logarithmic
from gainproof.plots.table import Column, Table, decades

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SIZE = (7.0, 4.8)
SHOWN = {
    "unstable_ratio": ("from here on the filter is unstable", "#14335c", "-"),
    "alpha_one_ratio": (r"beyond this $\alpha > 1$", "#14335c", DASHED),
    "beta_gain_ratio": (r"beyond this $\beta$ is nearer when left fixed", "#c04a26", DASH_DOT),
    "alpha_gain_ratio": (r"beyond this $\alpha$ is nearer when left fixed", "#c04a26", DASHED),
    "variance_ratio": ("beyond this fixed gains have smaller variances", "0.35", DOTTED),
}
"""What each curve means, its colour and its dashes."""


def limits() -> Table:
    """Of the update with constant derivatives: ratios Lambda/L against the nominal index L."""
    index = decades(-3, 1, 24)
    found = updated_gains.update_limits(index)
    columns = [
        Column(name, f"Lambda/L: {words.replace('$', '')}", np.asarray(getattr(found, name)))
        for name, (words, _, _) in SHOWN.items()
    ]
    points = {name: float(point.index[0, 0]) for name, point in nominal_points().items()}
    told = {
        f"ratios at the {name} nominal point": {
            each: float(getattr(updated_gains.update_limits(place), each)) for each in SHOWN
        }
        for name, place in points.items()
    }
    return Table(
        "How far from its nominal index the first-order update is of use",
        (Column("nominal_index", "L, at which the gains are exact", index), *columns),
        {"index at the nominal points": points, **told},
        (
            "Derivatives held at the nominal point, (32), (33); closed forms that the derivation",
            "updated-gains proves. Below L (ratios under 1) the update is always nearer.",
        ),
    )


def draw_limits(table: Table, sheet: Figure) -> None:
    """Ratios against the nominal index, with the experiment's nominal points."""
    axes = sheet.add_subplot()
    label = r"index over nominal index, $\Lambda/\bar\Lambda$"
    logarithmic(axes, r"nominal index $\bar\Lambda$", label)
    index = table["nominal_index"]
    for name, (words, colour, dashes) in SHOWN.items():
        axes.plot(index, table[name], color=colour, ls=dashes, label=words)
    for name, place in table.numbers["index at the nominal points"].items():
        axes.axvline(place, color=NOMINAL_COLOURS[name], lw=0.8)
        axes.annotate(
            ENDS[name],
            (place, 0.02),
            xycoords=("data", "axes fraction"),
            xytext=(3, 0),
            textcoords="offset points",
            fontsize=8,
            color=NOMINAL_COLOURS[name],
        )
    axes.set_xlim(index[0], index[-1])
    axes.set_ylim(1, None)
    sheet.legend(loc="outside upper center", ncols=2)
