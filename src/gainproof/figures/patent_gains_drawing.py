"""Figures 5 to 7 as pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.lecture import look
from gainproof.figures.lecture.look import DASHED, DOTTED, GREY
from gainproof.figures.patent_look import ENDS, NOMINAL_COLOURS
from gainproof.figures.patent_scene import NOMINAL
from gainproof.plots import canvas
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

GAINS_SIZE = (8.2, 4.4)
SIZE = (canvas.WIDTH, canvas.HEIGHT)
TICKS = (1, 2, 5, 10, 20, 50, 100)
DASH = 4
"""In line widths; gaps have room for a dash of each other nominal point: curves nearly coincide."""


def draw_figure_5(table: Table, sheet: Figure) -> None:
    """The index falls with the range as the deviation across the line of sight grows."""
    axes = sheet.add_subplot()
    far = table["range_m"] / 1e3
    axes.plot(far, table["index_along"], color="0.5", label="along the line of sight")
    axes.plot(far, table["index_across"], ls=DASHED, color="#c04a26", label="across it")
    axes.plot(far, table["index_45"], color="#14335c", label="x and y at a bearing of 45°")
    _circles(axes, table.numbers["index at the nominal points"])
    _range_axis(axes, r"tracking index $\Lambda = \sigma_w T^2/\sqrt{R}$")
    axes.set_yscale("log")
    axes.legend(title="circles: nominal points (ours)")


def draw_figure_6(table: Table, sheet: Figure) -> None:
    """Left the constant partial derivatives, right the recursive ones."""
    _draw_gains(table, sheet, r"position gain $\alpha$", 1.6)


def draw_figure_7(table: Table, sheet: Figure) -> None:
    """The same for the velocity gain."""
    _draw_gains(table, sheet, r"velocity gain $\beta$", 0.75)


def _draw_gains(table: Table, sheet: Figure, label: str, top: float) -> None:
    left, right = sheet.subplots(1, 2, sharey=True)
    far = table["range_m"] / 1e3
    for axes, kind, title in (
        (left, "constant", "partials held at the nominal point, (32), (33)"),
        (right, "recursive", "partials of the last scan, (26), (27)"),
    ):
        axes.plot(far, table["exact"], color=GREY, lw=3.2, label="exact")
        for place, name in enumerate(NOMINAL):
            colour = NOMINAL_COLOURS[name]
            dashes = (-DASH * place, (DASH, DASH * (len(NOMINAL) - 1)))
            axes.axhline(table[f"fixed_{name}"][0], color=colour, lw=0.7, ls=DOTTED)
            values = table[f"{kind}_{name}"]
            known = np.isfinite(values)
            words = f"from {ENDS[name]}"
            axes.plot(far[known], values[known], ls=dashes, color=colour, label=words)
        _circles(axes, table.numbers["nominal gains"])
        if top > 1:
            axes.axhline(1.0, color="0.3", lw=0.8)
        _range_axis(axes, label if axes is left else "")
        axes.set_title(title, fontsize=9)
        axes.set_ylim(0, top)
    left.legend(title="dotted: fixed", handlelength=4)


def _circles(axes: Axes, values: dict[str, float]) -> None:
    for name, value in values.items():
        axes.plot(
            NOMINAL[name] / 1e3, value, "o", mfc="white", color=NOMINAL_COLOURS[name], zorder=5
        )


def _range_axis(axes: Axes, label: str) -> None:
    look.framed(axes, "range (km)", label)
    axes.set_xscale("log")
    axes.set_xticks(TICKS, [str(tick) for tick in TICKS])
    axes.minorticks_off()
    axes.set_xlim(1, 100)
