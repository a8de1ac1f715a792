"""SciPy's Riccati solver, a call a point, for comparison."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.bench.accuracy import ball_outputs

POINTS = 40
MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")


def solver_seconds(model: Mapping[str, Any], names: Sequence[str]) -> float | None:
    """Seconds a point; None without SciPy, where no input is the tracking index, or where the
    model has parameters that are none: a kernel of a limit of the model.

    All inputs are taken from 0.01 to 100. The process noise of the model is that for index 1; an
    entry of a matrix is a number as text, or a graph over the other inputs.
    """
    entries = [entry for key in MATRICES for row in model[key] for entry in row]
    symbols = {
        node[1]
        for entry in entries
        if not isinstance(entry, str)
        for node in entry["nodes"]
        if node[0] == "symbol"
    }
    if not {"tracking_index", *symbols} <= set(names):
        return None
    try:
        from scipy.linalg import solve_discrete_are
    except ImportError:
        return None
    generator = np.random.default_rng(22)
    taken = 0.0
    for _ in range(POINTS):
        point = dict(zip(names, 10.0 ** generator.uniform(-2, 2, len(names)), strict=True))
        transition, noise, measurement, measured = (matrix(model[key], point) for key in MATRICES)
        start = perf_counter()
        solve_discrete_are(
            transition.T, measurement.T, point["tracking_index"] ** 2 * noise, measured
        )
        taken += perf_counter() - start
    return taken / POINTS


def matrix(rows: Sequence[Sequence[Any]], point: Mapping[str, float]) -> NDArray[np.float64]:
    """The matrix at a point."""
    return np.array([[_entry(entry, point) for entry in row] for row in rows])


def _entry(entry: Any, point: Mapping[str, float]) -> float:
    if isinstance(entry, str):
        return float(Fraction(entry))
    (value,) = ball_outputs(entry, point).values()
    return float(value.mid())
