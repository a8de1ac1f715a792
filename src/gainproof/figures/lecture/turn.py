"""The turning target as two filters see it, each with a slow and a fast choice: numbers, pictures.

One seeded run is shown; the errors are those of a hundred runs.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.figures.lecture import fixed_gain_track, kalman_track, look
from gainproof.figures.lecture.look import Look
from gainproof.figures.lecture.scene import Scene, Seen, seen
from gainproof.generated import alpha_beta
from gainproof.plots.table import Column, Reals, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

RUNS = 100
SEED = 18
GAINS: Mapping[str, tuple[float, float]] = {"small": (0.095, 0.01), "large": (0.4571, 0.5)}
"""alpha and beta as the lecture gives them."""
INCREMENTS: Mapping[str, float] = {"small": 0.01, "large": 10.0}
"""The lecture's driving noise n_x = n_y in m/s."""
SETTLED = 10
"""Samples before the turn in which errors are told too."""


def alpha_beta_turn() -> Table:
    """The alpha-beta filter with the small and the large pair of gains."""
    scene = Scene()
    drawn = seen(scene, RUNS, SEED)
    measured = np.moveaxis(drawn.positions, 1, 0)
    tracks = {}
    for name, (alpha, beta) in GAINS.items():
        gains = fixed_gain_track.handed_over(alpha, beta, len(measured))
        tracks[name] = np.moveaxis(fixed_gain_track.followed(measured, *gains)[0], 0, 1)
    unit = scene.acceleration * scene.interval**2
    lags = {
        name: unit * float(alpha_beta.lags(*gains).updated_position_lag)
        for name, gains in GAINS.items()
    }
    return _table(
        "Turning target, alpha-beta filter with small and large gains",
        scene,
        drawn,
        tracks,
        {"steady lag behind a constant 0.1 g (m), from the kernel": lags},
        (
            "alpha and beta are the lecture's; the same gains in x and in y.",
            "Ours: least-squares gains first, until their alpha falls below the fixed one.",
        ),
    )


def kalman_turn() -> Table:
    """The Kalman filter of constant velocity with small and large driving noise."""
    scene = Scene()
    drawn = seen(scene, RUNS, SEED)
    noise = drawn.covariances(scene)
    tracks = {
        name: kalman_track.followed(drawn.positions, noise, scene.interval, increment)
        for name, increment in INCREMENTS.items()
    }
    return _table(
        "Turning target, Kalman filter (constant velocity) with small and large driving noise",
        scene,
        drawn,
        tracks,
        {},
        (
            "Driving noise n_x = n_y = 0.01 m/s and 10 m/s is the lecture's.",
            "Ours: it is the deviation of an increment of each velocity at every sample.",
            "Ours: the covariance of the measured x and y is to first order, at the measurement.",
            "Ours: the track starts with the first two measurements.",
        ),
    )


def rms(errors: Reals) -> Reals:
    """The root of the mean square over the last axis."""
    return np.asarray(np.sqrt(np.mean(errors**2, axis=-1)))


def _table(
    title: str,
    scene: Scene,
    drawn: Seen,
    tracks: Mapping[str, Reals],
    more: Mapping[str, object],
    notes: tuple[str, ...],
) -> Table:
    true = scene.positions()
    shown = {"observed": drawn.positions, **tracks}
    errors = {name: np.linalg.norm(track - true, axis=-1) for name, track in shown.items()}
    columns = [
        Column("time_s", "seconds since the first sample", scene.times),
        Column("in_turn", "1 while the target turns", scene.in_turn.astype(float)),
        *_pair("true", "the target, m east and north of the radar", true),
        Column("observed_range_m", "measured range of the run shown", drawn.range[0]),
        Column(
            "observed_bearing_deg",
            "measured bearing from north of the run shown",
            np.rad2deg(drawn.bearing[0]),
        ),
        *(
            column
            for name, track in shown.items()
            for column in _pair(name, f"{name}: position in the run shown", track[0])
        ),
        *(
            Column(f"{name}_rms_m", f"{name}: RMS position error of {RUNS} runs", rms(error.T))
            for name, error in errors.items()
        ),
    ]
    turn = scene.in_turn
    before = (scene.times <= scene.turn_begins) & (
        scene.times > scene.turn_begins - SETTLED * scene.interval
    )
    numbers: dict[str, object] = {}
    for stretch, words in ((turn, "over the turn"), (before, f"over {SETTLED} samples before it")):
        each = {name: rms(error[:, stretch]) for name, error in errors.items()}
        numbers[f"RMS position error {words} (m), mean of {RUNS} runs"] = {
            name: float(values.mean()) for name, values in each.items()
        }
        numbers[f"RMS position error {words} (m), its deviation from run to run"] = {
            name: float(values.std(ddof=1)) for name, values in each.items()
        }
    return Table(title, tuple(columns), {**numbers, **more}, (*_scene_notes(scene), *notes))


def _pair(name: str, meaning: str, positions: Reals) -> list[Column]:
    return [Column(f"{name}_{axis}_m", meaning, positions[:, k]) for k, axis in enumerate("xy")]


def _scene_notes(scene: Scene) -> tuple[str, ...]:
    x, y = (value / 1e3 for value in scene.start)
    degrees = np.rad2deg([scene.heading, scene.turned, scene.bearing_deviation])
    heading, turned, deviation = (f"{value:g}" for value in degrees.tolist())
    return (
        f"The lecture gives a turn of 0.1 g and sampling every {scene.interval:g} s,",
        f"noise of {scene.range_deviation:g} m in range and {deviation} degrees in bearing.",
        f"Ours: {scene.speed:g} m/s, start {x:g} km east and {y:g} km north of the radar,",
        f"heading {heading} degrees, turning right by {turned} after {scene.turn_begins:g} s,",
        f"{scene.last_sample + 1} samples, all in one plane; seed {SEED}, {RUNS} runs.",
        "Smoothed positions are shown; normal noise, independent from sample to sample.",
    )


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
