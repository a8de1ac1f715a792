"""The growing mean and line, and their gains, as pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gainproof.figures.lecture import look
from gainproof.figures.lecture.fits import DEVIATION, FIRST, INTERVAL, SPEED, STANDING
from gainproof.figures.lecture.look import Look
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FITS_SIZE = (7.6, 3.9)
GAINS_SIZE = (5.6, 4.0)
OBSERVED: dict[str, Any] = {"color": "black", "linestyle": "none", "marker": "+", "markersize": 5}


def draw_mean_and_line(table: Table, sheet: Figure) -> None:
    """Left the standing target, right the moving one."""
    standing, moving = sheet.subplots(1, 2)
    time = table["time_s"]
    look.framed(standing, "time (s)", "range (m)")
    standing.set_title("standing target: the mean")
    standing.axhline(STANDING, color="0.72", linewidth=3, label="truth", zorder=1)
    _draw(standing, table, "mean")
    look.framed(moving, "time (s)", "range (m)")
    moving.set_title("moving target: the line")
    true = FIRST + SPEED * time
    moving.plot(time, true, color="0.72", linewidth=3, label="truth", zorder=1)
    _draw(moving, table, "line")
    through = Look(look.MIDDLE, look.DASHED, "line through all")
    moving.plot(time, table["last_line_m"], **through.line)
    handles, labels = moving.get_legend_handles_labels()
    sheet.legend(handles, labels, loc="outside upper center", ncols=5, columnspacing=1.3)
    found = table.numbers["range rate of the line through all (m/s)"]
    sheet.supxlabel(
        f"Ours: noise {DEVIATION:g} m, T = {INTERVAL:g} s, seeded. "
        f"Range rate: true {SPEED:g} m/s, of the line {found:.3f} m/s.",
        fontsize=7.5,
        color="0.25",
    )


def _draw(axes: Axes, table: Table, name: str) -> None:
    time, estimate = table["time_s"], table[f"{name}_m"]
    spread = table[f"{name}_deviation_m"]
    observed = table["standing_observed_m" if name == "mean" else "moving_observed_m"]
    band: dict[str, Any] = {"color": "0.9", "linewidth": 0, "zorder": 0.5}
    axes.fill_between(time, estimate - spread, estimate + spread, label="± 1 deviation", **band)
    axes.plot(time, observed, label="observed", **OBSERVED)
    axes.plot(time, estimate, **Look(look.DARK, look.SOLID, "estimate so far").line)


def draw_gains(table: Table, sheet: Figure) -> None:
    """The gains at each sample, marked by shapes."""
    axes = sheet.subplots()
    look.framed(axes, "sample number k", "gain")
    curves = (
        ("alpha", look.DARK, "o", r"$\alpha_k = 2(2k+1)/((k+1)(k+2))$"),
        ("beta", look.MIDDLE, "s", r"$\beta_k = 6/((k+1)(k+2))$"),
        ("mean_alpha", look.LIGHT, "^", r"mean: $1/(k+1)$"),
    )
    for name, colour, mark, label in curves:
        axes.plot(
            table["k"],
            table[name],
            color=colour,
            marker=mark,
            markersize=4,
            linewidth=0.9,
            label=label,
        )
    axes.set_xlim(0, table["k"][-1] + 0.5)
    axes.set_ylim(0, 1.05)
    axes.legend(loc="upper right")
