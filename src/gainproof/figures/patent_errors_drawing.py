"""Figures 8 and 9 and the comparison as pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.lecture.look import framed
from gainproof.figures.patent_look import ENDS, LOOKS
from gainproof.figures.patent_runs import NOMINAL_FILTERS, OTHERS
from gainproof.figures.patent_scene import NOMINAL, PATHS, RUNS
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIZE = (8.4, 10.4)
COMPARISON_SIZE = (8.4, 6.6)


def draw_figure_8(table: Table, sheet: Figure) -> None:
    """A row for every path, a column for every nominal point."""
    _draw(table, sheet, "rms_position_m", "RMS position error (m)")


def draw_figure_9(table: Table, sheet: Figure) -> None:
    """The same for the velocity."""
    _draw(table, sheet, "rms_velocity_m_s", "RMS velocity error (m/s)")


def _draw(table: Table, sheet: Figure, column: str, label: str) -> None:
    from matplotlib.ticker import FuncFormatter, LogLocator

    grid = sheet.subplots(len(PATHS), len(NOMINAL), sharex=True, sharey="row")
    paths, filters = (np.array(table.words(name)) for name in ("path", "filter"))
    for row, path in zip(grid, PATHS, strict=True):
        for axes, nominal in zip(row, NOMINAL, strict=True):
            framed(axes, "", "")
            axes.set_yscale("log")
            axes.yaxis.set_major_formatter(FuncFormatter(_plain))
            axes.yaxis.set_minor_locator(LogLocator(subs=(2.0, 5.0)))
            axes.yaxis.set_minor_formatter(FuncFormatter(_plain))
            axes.tick_params(axis="y", which="both", labelsize=7.5)
            for name, own in LOOKS.items():
                called = f"{name}, {nominal}" if name in NOMINAL_FILTERS else name
                here = (paths == path) & (filters == called)
                time = table["time_s"][here]
                ends = (table[f"{column}_{end}"][here] for end in ("lower", "upper"))
                axes.fill_between(time, *ends, color=own.colour, alpha=0.18, lw=0)
                axes.plot(time, table[column][here], **{**own.line, "linewidth": own.width * 0.75})
            axes.set_xlim(0, 300)
            if path == next(iter(PATHS)):
                axes.set_title(f"nominal point at {ENDS[nominal]}", fontsize=9)
        row[0].set_ylabel(path)
    for axes in grid[-1]:
        axes.set_xlabel("time (s)")
    handles, labels = grid[0, 0].get_legend_handles_labels()
    sheet.legend(handles, labels, loc="outside upper center", ncols=3)
    sheet.supylabel(label, fontsize=10)
    words = f"{RUNS} runs each; bands: intervals of 95 %. Paths and nominal points are ours."
    sheet.supxlabel(words, fontsize=8, color="0.25")


def draw_comparison(table: Table, sheet: Figure) -> None:
    """RMS over that of the Kalman filter: dots with intervals of 95 %."""
    grid = sheet.subplots(2, len(PATHS), sharey=True)
    names = [f"{name}, {nominal}" for nominal in NOMINAL for name in NOMINAL_FILTERS]
    names += [name for name in OTHERS if name != "kalman"]
    paths, filters = (np.array(table.words(name)) for name in ("path", "filter"))
    for row, kind in zip(grid, ("position", "velocity"), strict=True):
        for axes, path in zip(row, PATHS, strict=True):
            _dots(axes, table, f"{kind}_over_kalman", paths == path, filters, names)
            axes.set_title(f"{path}, {kind}", fontsize=9)
        row[0].set_yticks(range(len(names)), [_label(name) for name in names], fontsize=8)
    grid[0, 0].invert_yaxis()
    words = "RMS error over that of the Kalman filter; lines: intervals of 95 %, often hidden"
    sheet.supxlabel(words, fontsize=10)


def _dots(
    axes: Axes, table: Table, column: str, on_path: object, filters: object, names: list[str]
) -> None:
    framed(axes, "", "")
    axes.axvline(1.0, color="0.45", lw=1.0)
    for place, name in enumerate(names):
        (row,) = np.flatnonzero(np.asarray(on_path) & (np.asarray(filters) == name))
        own = LOOKS[name.partition(",")[0]]
        ends = [float(table[f"{column}_{end}"][row]) for end in ("lower", "upper")]
        axes.plot(ends, [place, place], color=own.colour, lw=1.6)
        axes.plot(table[column][row], place, "o", color=own.colour, ms=4)
    axes.set_xscale("log")
    axes.set_xticks([0.5, 1, 2, 4], ["0.5", "1", "2", "4"])
    axes.minorticks_off()
    axes.set_xlim(0.4, 4)


def _plain(value: float, _place: int | None = None) -> str:
    return f"{value:g}"


def _label(name: str) -> str:
    filter_name, _, nominal = name.partition(", ")
    words = LOOKS[filter_name].label
    return f"{words}, {ENDS[nominal]}" if nominal else words
