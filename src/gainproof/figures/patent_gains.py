"""Numbers and pictures of the source's figures 5 to 7: index and gains against the range."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.lecture import look
from gainproof.figures.lecture.look import DASHED, DOTTED, GREY
from gainproof.figures.patent_look import ENDS, NOMINAL_COLOURS
from gainproof.figures.patent_scene import (
    ACCELERATION,
    CONVERSION,
    INTERVAL,
    NOMINAL,
    SPEED,
    diagonal_index,
    nominal_points,
    polar,
)
from gainproof.generated import updated_gains
from gainproof.plots import canvas
from gainproof.plots.table import Column, Reals, Table
from gainproof.tracking.conversion import converted
from gainproof.tracking.gains import (
    Point,
    constant_point,
    exact_point,
    recursive_point,
    tracking_index,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

NEAREST, FARTHEST = 1e3, 100e3
GIVEN = (
    "The source gives sigma_w = 0.98 m/s^2, 50 m, 1 degree and 5 s;",
    f"the covariance is that of the {CONVERSION} conversion, its own.",
)
OURS = (
    *GIVEN,
    "Ours: a bearing of 45 degrees, where x and y have the same index;",
    "nominal points at 80, 40 and 10 km; the recursive update runs from each of them",
    f"towards the radar and away from it, {SPEED * INTERVAL / 1e3:g} km from scan to scan.",
)


def ranges() -> Reals:
    """From 1 to 100 km, five to a scan of a radial path, the nominal points among them."""
    return np.arange(NEAREST, FARTHEST + 1, 250.0)


def figure_5() -> Table:
    """The tracking index along the line of sight, across it, and of x and y at 45 degrees."""
    far = ranges()
    sight = converted(polar(far, np.zeros_like(far)), CONVERSION).sight
    along, across = tracking_index(ACCELERATION, INTERVAL, sight).T
    return Table(
        "Tracking index against the range",
        (
            Column("range_m", "measured range, m", far),
            Column("index_along", "of the line of sight", along),
            Column("index_across", "across the line of sight", across),
            Column("index_45", "of x and of y at a bearing of 45 degrees", _index(far)),
        ),
        {"index at the nominal points": _at_nominal(nominal_points())},
        (*GIVEN, "Ours: ranges and nominal points."),
    )


def figure_6() -> Table:
    """alpha: exact, fixed, to first order with constant and with recursive partial derivatives."""
    return _gains("alpha", "position gain alpha")


def figure_7() -> Table:
    """The same for beta."""
    return _gains("beta", "velocity gain beta")


def _gains(which: str, meaning: str) -> Table:
    far = ranges()
    index = _index(far)
    columns = [
        Column("range_m", "measured range, m", far),
        Column("index", "tracking index of x and of y", index),
        Column("exact", f"{meaning} of the index", _of(exact_point(index), which)),
    ]
    for name, point in nominal_points().items():
        near = point.part((0, 0))
        constant = _of(constant_point(near, index), which)
        columns += [
            Column(
                f"fixed_{name}",
                f"that of the {name} nominal point",
                np.full_like(far, _of(near, which)),
            ),
            Column(f"constant_{name}", f"to first order from the {name} nominal point", constant),
            Column(
                f"recursive_{name}",
                f"to first order from scan to scan, beginning at the {name} nominal point",
                _stepped(near, name, far, which),
            ),
        ]
    numbers: dict[str, object] = {"nominal gains": _at_nominal(nominal_points(), which)}
    if which == "alpha":
        numbers["range (m) within which the constant update has alpha above 1"] = {
            name: _alpha_one(float(point.index[0, 0])) for name, point in nominal_points().items()
        }
    return Table(f"{meaning} against the range", tuple(columns), numbers, OURS)


def _alpha_one(nominal_index: float) -> float | str:
    """Where the index has reached the limit of the derivation updated-gains; "never" where it does
    so at none of these ranges.
    """
    limit = float(updated_gains.update_limits(nominal_index).alpha_one_ratio) * nominal_index
    # the variance is a number plus a multiple of the square of the range
    ends = np.array([NEAREST, FARTHEST])
    variances = _index(ends) ** -2
    if limit**-2 < variances[0]:
        return "never"
    return float(np.sqrt(np.interp(limit**-2, variances, ends**2)))


def _stepped(start: Point, name: str, far: Reals, which: str) -> Reals:
    """The recursive update from the nominal range inwards and outwards; NaN between scans."""
    found = np.full(far.shape, np.nan)
    begin = int(np.flatnonzero(far == NOMINAL[name])[0])
    step = round(SPEED * INTERVAL / (far[1] - far[0]))
    found[begin] = _of(start, which)
    for places in (range(begin - step, -1, -step), range(begin + step, far.size, step)):
        last = start
        for place in places:
            last = recursive_point(last, _index(far[place : place + 1])[0])
            found[place] = _of(last, which)
    return found


def _index(far: Reals) -> Reals:
    """Of x at 45 degrees."""
    return diagonal_index(far)[..., 0]


def _of(point: Point, which: str) -> Reals:
    return point.alpha if which == "alpha" else point.beta


def _at_nominal(points: Mapping[str, Point], which: str = "index") -> dict[str, float]:
    return {name: float(getattr(point, which)[0, 0]) for name, point in points.items()}


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
