"""Where the printed closed form loses its digits, as maps over (r, S)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gainproof.plots.table import Reals, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PANELS = (
    ("16a", r"$\tilde{P}_1$ (16a)"),
    ("16b", r"$\tilde{P}_2$ (16b)"),
    ("16c", r"$\tilde{P}_3$ (16c)"),
    ("18a", r"$K_{11}, \hat{P}_1$ (18a, 19a)"),
    ("18c", r"$K_{12}, K_{21}, \hat{P}_2$ (18b, 18c, 19b)"),
    ("18d", r"$K_{22}, \hat{P}_3$ (18d, 19c)"),
)
TICKS = (1e-4, 1.0, 1e4)
WORST, BEST = 0, -16
"""Powers of ten of the error at the two ends of the colours."""
NO_NUMBER = "#4a6fa5"


def draw_digits(table: Table, sheet: Figure) -> None:
    """Six maps of the relative error, one for each formula that differs from the others."""
    from matplotlib import colormaps
    from matplotlib.colors import BoundaryNorm
    from matplotlib.patches import Patch

    grid = sheet.subplots(2, 3, sharex=True, sharey=True)
    r, s = np.unique(table["r"]), np.unique(table["S"])
    levels = np.arange(BEST, WORST + 1, 2)
    norm = BoundaryNorm(levels, 256)
    colours = colormaps["YlOrBr"].with_extremes(bad=NO_NUMBER)
    shares = table.numbers["share off by more than 1e-8"]
    mesh = None
    for axes, (number, title) in zip(grid.ravel(), PANELS, strict=True):
        powers = _powers(table[f"error_{number}"]).reshape(r.size, s.size).T
        mesh = axes.pcolormesh(
            r, s, np.ma.masked_invalid(powers), cmap=colours, norm=norm, rasterized=True
        )
        axes.set_xscale("log")
        axes.set_yscale("log")
        share = f"{100 * shares[number]:.0f} %"
        axes.set_title(f"{title}\n$> 10^{{-8}}$ on {share}", fontsize=8.5)
        axes.set_xticks(TICKS)
        axes.set_yticks(TICKS)
    assert mesh is not None
    bar = sheet.colorbar(mesh, ax=grid, shrink=0.9, aspect=28, anchor=(0.0, 1.0), ticks=levels)
    bar.ax.set_yticklabels([f"$10^{{{power}}}$" if power else "1" for power in levels])
    bar.set_label("relative error in float64")
    sheet.suptitle("The printed closed form: on which share of the domain it is off", fontsize=10)
    sheet.supxlabel(r"$r = 4\sigma_o/(\sigma_a T^2)$", fontsize=10)
    sheet.supylabel(r"$S = \sigma_d T/\sigma_o$", fontsize=10)
    sheet.legend(handles=[Patch(color=NO_NUMBER, label="no number")], loc="lower right", fontsize=8)


def _powers(errors: Reals) -> Reals:
    """log10 of the errors, within the colours; NaN stays NaN."""
    with np.errstate(invalid="ignore"):
        clipped = np.clip(errors, 10.0**BEST, 10.0**WORST * (1 - 1e-9))
    return np.asarray(np.log10(clipped))
