"""Where the source's printed closed form loses its digits in float64."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gainproof.figures.suzuki_curves import POSITION, VELOCITY
from gainproof.figures.suzuki_printed import printed_form
from gainproof.plots.table import Column, Reals, Table, decades, grid
from gainproof.position_velocity.process_noise import DEFAULT, kernels

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
