"""The numbers of the source's figures 5 to 7: index and gains against the range."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

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
from gainproof.plots.table import Column, Reals, Table
from gainproof.tracking.conversion import converted
from gainproof.tracking.gains import (
    Point,
    constant_point,
    exact_point,
    recursive_point,
    tracking_index,
)

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
