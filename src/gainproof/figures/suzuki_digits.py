"""Where the source's printed closed form loses its digits in float64, as maps over (r, S)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.suzuki_curves import POSITION, VELOCITY
from gainproof.figures.suzuki_printed import printed_form
from gainproof.plots.table import Column, Reals, Table, decades, grid
from gainproof.position_velocity.process_noise import DEFAULT, kernels

if TYPE_CHECKING:
    from matplotlib.figure import Figure

QUANTITIES: Mapping[str, str] = {
    "16a": "predicted_11",
    "16b": "predicted_12",
    "16c": "predicted_22",
    "18a": "gain_11",
    "18b": "gain_12",
    "18c": "gain_21",
    "18d": "gain_22",
    "19a": "updated_11",
    "19b": "updated_12",
    "19c": "updated_22",
}
"""What each printed equation is the value of, by the name of the kernels' output."""
FIRST, LAST = -6, 6
TOLERANCE = 1e-8
FINE, COARSE = 8, 2
"""Points to a decade: of the picture, and of the grid on which shares are counted."""


def figure_digits() -> Table:
    """Relative error of each printed quantity over (r, S), the kernels taken as true; and the
    share of the half-decade grid on which it is off by more than 1e-8.

    The kernels' own error is a few units in the last place, proved. A value that is no number
    (the root of a negative number, 0/0) has no relative error: its cell is empty, and it counts
    as off.
    """
    axis = decades(FIRST, LAST, FINE)
    r, s = grid(axis, axis)
    return Table(
        "Relative error of the printed closed form in float64",
        (
            Column("r", POSITION, r),
            Column("S", VELOCITY, s),
            *(
                Column(
                    f"error_{number}",
                    f"relative error of ({number}), {QUANTITIES[number]}, to three digits",
                    _short(error),
                )
                for number, error in errors(r, s).items()
            ),
        ),
        {"share off by more than 1e-8": shares()},
    )


def errors(r: Reals, s: Reals) -> dict[str, Reals]:
    """The relative error of each printed quantity at these points; NaN where it is no number."""
    with np.errstate(all="ignore"):
        printed = printed_form(r, s, np.sqrt)
    true = _true(4 / r, s)
    found = {}
    for number, name in QUANTITIES.items():
        with np.errstate(all="ignore"):
            error = np.abs(np.asarray(printed[number]) / true[name] - 1)
        # an infinite value is no number either
        found[number] = np.where(np.isfinite(error), error, np.nan)
    return found


def _short(errors: Reals) -> Reals:
    """To three digits: more of an error is noise, and a line of the CSV stays short."""
    return np.array([float(f"{error:.2e}") for error in errors.tolist()])


def shares() -> dict[str, float]:
    """The share of the 25 x 25 points, half a decade apart, where each quantity is off."""
    axis = decades(FIRST, LAST, COARSE)
    # a comparison with NaN is false: what is no number counts as off
    return {
        number: float(np.mean(~(error <= TOLERANCE)))
        for number, error in errors(*grid(axis, axis)).items()
    }


def _true(index: Reals, ratio: Reals) -> dict[str, Reals]:
    both = kernels(DEFAULT)
    found: dict[str, Reals] = {}
    for kernel in (both.predicted_covariance, both.updated_covariance, both.gains):
        named = kernel(index, ratio)._asdict()
        found |= {name: np.asarray(entry) for name, entry in named.items()}
    return found


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
