"""The figures of example 1 as pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.doppler.example import (
    BIASES,
    FALSE_ALARM,
    MODELS,
    POINTS,
    RUNS,
    SETS,
)
from gainproof.figures.lecture import look
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ERRORS_SIZE, RATES_SIZE, GEOMETRY_SIZE = (7.6, 4.3), (6.3, 4.2), (7.6, 4.2)
MARKS = {"0 clean ranges": "s", "2 clean ranges": "^", "4 clean ranges": "v", "adaptive": "o"}
COLOURS = dict(zip(MARKS, (look.DARK, look.LIGHT, look.GREY, look.MIDDLE), strict=True))
MEANT = {
    "0 clean ranges": "none known to be clean: bias detection",
    "2 clean ranges": "B1, B2 known to be clean",
    "4 clean ranges": "all four known to be clean: no bias",
    "adaptive": "adaptive: what the test finds",
}


def draw_monte_carlo(table: Table, sheet: Figure) -> None:
    """Position left, velocity right, a group of marks for each set of biases."""
    for axes, names, title in zip(
        sheet.subplots(1, 2),
        (("x_m", "y_m"), ("vx_m_s", "vy_m_s")),
        ("position (m)", "velocity (m/s)"),
        strict=True,
    ):
        _errors(axes, table, names, title)
    handles, labels = sheet.axes[0].get_legend_handles_labels()
    sheet.legend(handles, labels, loc="outside upper center", ncols=3, columnspacing=1.3)
    sheet.supxlabel(
        f"biases of B1 to B4 (m).  {RUNS} draws each, seeded; false alarms {100 * FALSE_ALARM:g} %",
        fontsize=8.5,
    )


def _errors(axes: Axes, table: Table, names: tuple[str, str], title: str) -> None:
    method = np.array(table.words("ranges"))
    places = np.arange(len(SETS))
    for number, name in enumerate(MARKS):
        rows = method == name
        found = np.hypot(*(table[f"rms_{each}"][rows] for each in names))
        wanted = np.hypot(*(table[f"promised_{each}"][rows] for each in names))
        at = places + 0.17 * (number - 1.5)
        axes.plot(at, found, MARKS[name], color=COLOURS[name], ms=5.5, label=MEANT[name], zorder=3)
        told = "by the covariance" if name == "0 clean ranges" else None
        axes.plot(at, wanted, "_", color="black", ms=12, mew=1.1, label=told, zorder=2)
    axes.grid(True, axis="y")
    axes.set_title(f"RMS error of the {title}")
    labels = ["\n".join(f"{bias:g}" for bias in biases) for biases in SETS]
    axes.set_xticks(places, labels)
    axes.set_ylim(bottom=0)


def draw_detection(table: Table, sheet: Figure) -> None:
    """Rates against the bias: lines of theory, marks of what was counted."""
    axes = sheet.subplots()
    look.framed(axes, "bias of the range (m)", "called biased")
    looks = (
        (look.DARK, look.SOLID, "o"),
        (look.MIDDLE, look.DASHED, "^"),
        (look.LIGHT, look.DASH_DOT, "s"),
        (look.GREY, look.DOTTED, "D"),
    )
    deviations = table.numbers["1-sigma of the bias found (m)"]
    for i, (colour, dashes, mark) in enumerate(looks, 1):
        words = f"B{i}: $\\sigma$ of the bias {deviations[f'B{i}']:.1f} m"
        line = look.Look(colour, dashes, words).line
        axes.plot(table["bias_m"], table[f"theory_B{i}"], **line)
        axes.plot(table["bias_m"], table[f"counted_B{i}"], mark, color=colour, ms=5)
    axes.axhline(FALSE_ALARM, color="0.4", linewidth=0.8)
    axes.annotate(
        f"false alarms {100 * FALSE_ALARM:g} %", (118, FALSE_ALARM), xytext=(0, 4),
        textcoords="offset points", ha="right", color="0.3",
    )  # fmt: skip
    axes.set_xlim(0, 120)
    axes.set_ylim(0, 1.03)
    axes.set_title("lines: noncentral chi-square; marks: counted in draws of the noise")
    axes.legend(loc="center right")


def draw_geometry(table: Table, sheet: Figure) -> None:
    """Left the stations and the target, right the ellipses and single estimates."""
    left, right = sheet.subplots(1, 2, width_ratios=(1.0, 1.15))
    what = np.array(table.words("what"))
    _places(left, table, what)
    for name, colour, size in (("bias detection", "0.75", 5), ("adaptive", look.MIDDLE, 5)):
        rows = what == name
        right.plot(
            table["x_m"][rows], table["y_m"][rows], ".", color=colour, ms=size, mew=0,
            alpha=0.75, label=f"{name}, {POINTS} draws",
        )  # fmt: skip
    dashes = (look.SOLID, look.DASHED, look.DOTTED)
    for (name, _), each, colour in zip(MODELS, dashes, ("0.25", look.DARK, "black"), strict=True):
        rows = what == name
        label = f"95 %, {MEANT[name].replace(': no bias', '')}"
        line = look.Look(colour, each, label, 1.5).line
        right.plot(table["x_m"][rows], table["y_m"][rows], zorder=4, **line)
    look.framed(right, "x less the truth (m)", "y less the truth (m)")
    right.set_aspect("equal", adjustable="datalim")
    biases = ", ".join(f"{bias:g}" for bias in BIASES)
    right.set_title(f"position; biases of {biases} m")
    handles, labels = right.get_legend_handles_labels()
    sheet.legend(handles, labels, loc="outside lower center", ncols=2, markerscale=2)


def _places(axes: Axes, table: Table, what: np.ndarray) -> None:
    for i in range(1, 5):
        (row,) = np.flatnonzero(what == f"B{i}")
        x, y = table["x_m"][row] / 1e3, table["y_m"][row] / 1e3
        axes.plot(x, y, "^", color=look.DARK, ms=8)
        axes.annotate(f"B{i}", (x, y), xytext=(0, 8), textcoords="offset points", ha="center")
    (target,), (speed,) = np.flatnonzero(what == "target"), np.flatnonzero(what == "velocity")
    x, y = table["x_m"][target] / 1e3, table["y_m"][target] / 1e3
    axes.plot(x, y, "o", color=look.MIDDLE)
    axes.annotate(
        "", (x + 4.5, y), xytext=(x, y), arrowprops={"arrowstyle": "->", "color": look.MIDDLE}
    )
    axes.annotate(f"{table['x_m'][speed]:g} m/s", (x + 4.6, y), va="center", color=look.MIDDLE)
    look.framed(axes, "x (km)", "y (km)")
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.18)
    axes.set_title("example 1: stations and target")
