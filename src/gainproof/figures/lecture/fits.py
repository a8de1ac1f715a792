"""A mean and a line that grow with each measurement, and their gains: numbers and pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from gainproof.figures.lecture import fixed_gain_track, look
from gainproof.figures.lecture.look import Look
from gainproof.generated import least_squares_line, least_squares_mean
from gainproof.plots.table import Column, Reals, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SAMPLES = 25
DEVIATION = 8.0
"""Of the measured range in m; the lecture's number for another picture."""
INTERVAL = 10.0
STANDING = 5000.0
"""Range of the target that stands, in m."""
FIRST, SPEED = 5000.0, 0.3
"""Range at the first sample in m and range rate in m/s of the target that moves: slow, so that
noise of 8 m is seen beside its course."""
SEED = 9
LAST_GAIN = 30


def mean_and_line() -> Table:
    """A standing target's range by the mean, and a moving one's by the line, sample by sample."""
    k = np.arange(SAMPLES + 0.0)
    time = INTERVAL * k
    noise = DEVIATION * np.random.default_rng(SEED).standard_normal((2, SAMPLES))
    standing, moving = STANDING + noise[0], FIRST + SPEED * time + noise[1]
    mean_gain = _from_one(least_squares_mean.gains(k[1:]).alpha)
    mean, _ = fixed_gain_track.followed(standing, mean_gain, np.zeros(SAMPLES))
    alpha, beta = (_from_one(gain) for gain in least_squares_line.gains(k[1:]))
    line, velocity = fixed_gain_track.followed(moving, alpha, beta)
    mean_variance = least_squares_mean.updated_covariance(k[1:]).updated_11
    line_variance = least_squares_line.updated_covariance(k[1:]).updated_11
    spreads = [
        DEVIATION * np.sqrt(_from_one(variance)) for variance in (mean_variance, line_variance)
    ]
    # the line through all samples, back from the last estimate
    through = line[-1] + velocity[-1] * (k - k[-1])
    return Table(
        "A target that stands, by the mean, and one that moves, by the line",
        (
            Column("time_s", "seconds since the first sample", time),
            Column("standing_observed_m", "measured range of the standing target", standing),
            Column("mean_m", "mean of the measurements so far", mean),
            Column("mean_deviation_m", "its standard deviation", spreads[0]),
            Column("moving_observed_m", "measured range of the moving target", moving),
            Column("line_m", "end of the line through the measurements so far", line),
            Column("line_deviation_m", "its standard deviation", spreads[1]),
            Column("last_line_m", "the line through all measurements", through),
        ),
        {
            "true range rate (m/s)": SPEED,
            "range rate of the line through all (m/s)": float(velocity[-1] / INTERVAL),
        },
        (
            "The lecture gives the recursions; its numbers are not among what we have.",
            f"Ours: standing at {STANDING:g} m; moving from {FIRST:g} m at {SPEED:g} m/s;",
            f"every {INTERVAL:g} s, normal noise of {DEVIATION:g} m, seed {SEED}.",
        ),
    )


def gains() -> Table:
    """alpha and beta of the line, and the gain of the mean, against the sample number."""
    k = np.arange(1.0, LAST_GAIN + 1)
    line = least_squares_line.gains(k)
    mean = least_squares_mean.gains(k)
    return Table(
        "Gains of the linear least-squares filter against the sample number",
        (
            Column("k", "sample number, the first sample is 0", k),
            Column("alpha", "gain of the position, of the line", _reals(line.alpha)),
            Column("beta", "gain of the velocity times T, of the line", _reals(line.beta)),
            Column("mean_alpha", "gain of the mean, 1/(k + 1)", _reals(mean.alpha)),
        ),
        {},
        (f"Ours: k from 1 to {LAST_GAIN}, the gain of the mean beside those of the line.",),
    )


def _reals(values: ArrayLike) -> Reals:
    return np.asarray(values, np.float64)


def _from_one(values: ArrayLike) -> Reals:
    """1 for the first sample, which is taken as measured, then the values."""
    return np.concatenate([np.ones(1), _reals(values)])


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
