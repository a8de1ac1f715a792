"""The turning target as a picture: the plan with both tracks, and the error along time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from gainproof.figures.lecture import look
from gainproof.figures.lecture.look import Look
from gainproof.figures.lecture.turn import GAINS, INCREMENTS, RUNS
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIZE = (7.6, 4.6)
GIVEN = "Given: 0.1 g turn, T = 10 s, noise 8 m in range and 0.06° in bearing. "
INSET = (-66, 24, 82, 40)
"""Left, bottom, width and height on the plan, in km."""
STEADY_LAG = "steady lag $(1-\\alpha)\\,aT^2/\\beta$:\n"


def draw_alpha_beta_turn(table: Table, sheet: Figure) -> None:
    """The alpha-beta filter, with the steady lags behind a constant acceleration."""
    looks = {
        name: _look(name, rf"$\alpha = {alpha:g},\ \beta = {beta:g}$")
        for name, (alpha, beta) in GAINS.items()
    }
    error = _draw(table, sheet, looks, "start by least squares. Smoothed positions are shown.")
    lags = table.numbers["steady lag behind a constant 0.1 g (m), from the kernel"]
    for name, lag in lags.items():
        error.axhline(lag, color=looks[name].colour, linewidth=0.8, linestyle=look.DOTTED)
        first = name == "small"
        error.annotate(
            (STEADY_LAG if first else "") + f"{lag:.0f} m",
            (0.02 if first else 0.98, lag),
            xycoords=("axes fraction", "data"),
            xytext=(0, -3 if first else 3),
            textcoords="offset points",
            ha="left" if first else "right",
            va="top" if first else "bottom",
            fontsize=7.5,
        )


def draw_kalman_turn(table: Table, sheet: Figure) -> None:
    """The Kalman filter."""
    looks = {
        name: _look(name, rf"$n_x = n_y = {increment:g}$ m/s")
        for name, increment in INCREMENTS.items()
    }
    _draw(
        table,
        sheet,
        looks,
        "$n_x, n_y$ per sample in velocity, start by two points. Smoothed positions are shown.",
    )


def _look(name: str, label: str) -> Look:
    if name == "small":
        return Look(look.MIDDLE, look.DASHED, f"small: {label}")
    return Look(look.DARK, look.SOLID, f"large: {label}")


def _draw(table: Table, sheet: Figure, looks: Mapping[str, Look], ours: str) -> Axes:
    error: Axes
    plan, error = sheet.subplots(1, 2, width_ratios=(1.12, 1))
    _draw_plan(table, plan, looks)
    _draw_error(table, error, looks)
    handles, labels = error.get_legend_handles_labels()
    more, words = plan.get_legend_handles_labels()
    sheet.legend(
        [*more, *handles],
        [*words, *labels],
        loc="outside upper center",
        ncols=5,
        columnspacing=1.2,
        handlelength=1.8,
    )
    sheet.supxlabel(f"{GIVEN}Ours: 200 m/s, the path,\n{ours}", fontsize=7.5, color="0.25")
    return error


def _draw_plan(table: Table, axes: Axes, looks: Mapping[str, Look]) -> None:
    look.framed(axes, "east (km)", "north (km)")
    axes.plot(
        table["true_x_m"] / 1e3,
        table["true_y_m"] / 1e3,
        color="0.72",
        linewidth=4,
        solid_capstyle="round",
        label="truth",
    )
    axes.plot(
        table["observed_x_m"] / 1e3,
        table["observed_y_m"] / 1e3,
        color="black",
        linestyle="none",
        marker="+",
        markersize=3.5,
        markeredgewidth=0.6,
        label="observed",
    )
    for name, own in looks.items():
        plain: dict[str, Any] = {**own.line, "label": None}
        axes.plot(table[f"{name}_x_m"] / 1e3, table[f"{name}_y_m"] / 1e3, **plain)
    axes.plot(0, 0, marker="^", color="black", markersize=6)
    axes.annotate("radar", (0, 0), xytext=(-8, -3), textcoords="offset points", ha="right")
    axes.set_aspect("equal", adjustable="datalim")
    _draw_straight(table, axes, looks)


def _draw_straight(table: Table, plan: Axes, looks: Mapping[str, Look]) -> None:
    """The course before the turn from its side, widened: what the plan is too coarse to show."""
    before = (table["time_s"] >= table["time_s"][1]) & (table["true_x_m"] <= 0)
    east, course = table["true_x_m"][before] / 1e3, table["true_y_m"][0]
    axes = plan.inset_axes(INSET, transform=plan.transData)
    axes.set_title("off the straight course (m)", fontsize=7.5, pad=3)
    axes.axhline(0, color="0.72", linewidth=2.5)
    marks: dict[str, Any] = {"color": "black", "marker": "+", "markersize": 3, "linestyle": "none"}
    axes.plot(east, table["observed_y_m"][before] - course, markeredgewidth=0.6, **marks)
    for name, own in looks.items():
        line: dict[str, Any] = {**own.line, "label": None, "linewidth": 1.0}
        axes.plot(east, table[f"{name}_y_m"][before] - course, **line)
    axes.tick_params(labelsize=7, length=2)
    axes.set_xlim(-80, 0)


def _draw_error(table: Table, axes: Axes, looks: Mapping[str, Look]) -> None:
    look.framed(axes, "time (s)", f"RMS position error, {RUNS} runs (m)")
    turning = table["time_s"][table["in_turn"] > 0]
    interval = table["time_s"][1]
    axes.axvspan(turning[0] - interval, turning[-1], color="0.93", linewidth=0)
    middle = turning.mean()
    axes.text(middle, 0.02, "turn", transform=axes.get_xaxis_transform(), ha="center")
    errors = table["observed_rms_m"]
    axes.plot(table["time_s"], errors, color="0.45", linewidth=0.8, label="observed (error)")
    for name, own in looks.items():
        axes.plot(table["time_s"], table[f"{name}_rms_m"], **own.line)
    axes.set_yscale("log")
    axes.set_xlim(0, table["time_s"][-1])
    mean = table.numbers[f"RMS position error over the turn (m), mean of {RUNS} runs"]
    spread = table.numbers["RMS position error over the turn (m), its deviation from run to run"]
    lines = [f"{name}: {mean[name]:.0f} ± {spread[name]:.0f} m" for name in mean]
    axes.text(
        0.47,
        0.62,
        "RMS over the turn\n" + "\n".join(lines),
        transform=axes.transAxes,
        va="top",
        fontsize=8,
    )
