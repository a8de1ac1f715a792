"""The drift of the recursive update: a target that stands still, measured with noise."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.lecture.look import framed
from gainproof.figures.patent_scene import (
    ACCELERATION,
    BEARING_DEVIATION,
    CONVERSION,
    INTERVAL,
    RANGE_DEVIATION,
    SEED,
    polar,
)
from gainproof.plots.table import Column, Reals, Table
from gainproof.tracking.conversion import converted
from gainproof.tracking.gains import (
    Point,
    exact_point,
    is_usable,
    recursive_point,
    tracking_index,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SIZE = (7.0, 4.4)
RUNS, SAMPLES = 500, 361
"""Half an hour."""
PLACES = {
    "40 km at 45°": (40e3, 45.0, "#3f7f4b"),
    "40 km at 5°": (40e3, 5.0, "#c04a26"),
    "80 km at 2°": (80e3, 2.0, "#14335c"),
}
"""Range in m, degrees from the x axis, colour."""
ENDS = (0.025, 0.5, 0.975)


def drift() -> Table:
    """alpha of x after each scan, exact at the first: median and the middle 95 % of all runs."""
    draw = np.random.default_rng(SEED)
    noise = draw.standard_normal((2, SAMPLES, len(PLACES), RUNS))
    far, degrees = (np.array([place[k] for place in PLACES.values()])[:, None] for k in (0, 1))
    # the angle counts from x, which is north here: the second coordinate
    measured = polar(
        far + RANGE_DEVIATION * noise[0], np.deg2rad(degrees) + BEARING_DEVIATION * noise[1]
    )
    index = tracking_index(ACCELERATION, INTERVAL, converted(measured, CONVERSION).variances)
    index = index[..., 1]
    last = exact_point(index[0])
    alpha, usable = [last.alpha], [np.ones((len(PLACES), RUNS), np.bool_)]
    for k in range(1, SAMPLES):
        last = recursive_point(last, index[k])
        alpha.append(last.alpha)
        usable.append(is_usable(last))
    middle = np.moveaxis(np.quantile(np.array(alpha), ENDS, axis=-1), 0, -1)
    exact = _exact(far[:, 0], np.deg2rad(degrees[:, 0]))
    columns = [Column("time_s", "s", INTERVAL * np.arange(float(SAMPLES)))]
    numbers: dict[str, object] = {"exact alpha": dict(zip(PLACES, exact.tolist(), strict=True))}
    for i, name in enumerate(PLACES):
        key = name.replace(" ", "_").replace("°", "_deg")
        columns += [
            Column(f"alpha_{end}_{key}", f"alpha, {words}, {name}", middle[:, i, j])
            for j, (end, words) in enumerate(
                (("low", "exceeded by 97.5 %"), ("median", "median"), ("high", "by 2.5 %"))
            )
        ]
        shares = np.mean(~np.array(usable)[:, i], -1)
        numbers[f"share of runs with alpha above 1 or unstable, {name}"] = {
            f"after {k * INTERVAL / 60:g} min": float(shares[k]) for k in (60, 180, 360)
        }
    return Table(
        "Position gain of the recursive update, target at rest",
        tuple(columns),
        numbers,
        (
            "Partial derivatives of the last scan, (26), (27); the index is that of each",
            f"measurement, noise of 50 m and 1 degree, {INTERVAL:g} s. Ours: places, {RUNS} runs,",
            f"seed {SEED}. Each way there and back leaves alpha larger (see updated-gains).",
        ),
    )


def draw_drift(table: Table, sheet: Figure) -> None:
    """Medians with bands, beside the exact gains."""
    axes = sheet.add_subplot()
    minutes = table["time_s"] / 60
    framed(axes, "time (min)", r"position gain $\alpha$ of $x$, (26)")
    for name, (_, _, colour) in PLACES.items():
        key = name.replace(" ", "_").replace("°", "_deg")
        low, high = (table[f"alpha_{end}_{key}"] for end in ("low", "high"))
        axes.fill_between(minutes, low, high, color=colour, alpha=0.2, lw=0)
        axes.plot(minutes, table[f"alpha_median_{key}"], color=colour, label=f"at rest, {name}")
        axes.axhline(table.numbers["exact alpha"][name], color=colour, lw=0.8, ls=":")
    axes.axhline(1.0, color="0.3", lw=0.8)
    axes.set_xlim(0, minutes[-1])
    axes.set_ylim(0, 2.5)
    sheet.legend(loc="outside upper center", ncols=len(PLACES))
    words = f"Bearings from the x axis. Bands: the middle 95 % of {RUNS} runs; dotted: exact gains."
    sheet.supxlabel(words, fontsize=8, color="0.25")


def _exact(far: Reals, angle: Reals) -> Reals:
    found = converted(polar(far, angle), CONVERSION).variances[..., 1]
    point: Point = exact_point(tracking_index(ACCELERATION, INTERVAL, found))
    return point.alpha
