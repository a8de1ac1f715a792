"""SciPy's Riccati solver, a call a point, for comparison."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from fractions import Fraction
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.bench.accuracy import ball_outputs
from gainproof.bench.timing import one_thread_clock

POINTS = 8
REPEATED = 3
MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")


def solver_seconds(model: Mapping[str, Any], names: Sequence[str]) -> float | None:
    """Seconds a point: the best of a few calls at each of a few points, as their mean. None without
    SciPy, where no input is the tracking index, or where the model has parameters that are none: a
    kernel of a limit of the model.

    It is the time of this thread, with one thread of the linear algebra library where threadpoolctl
    is installed: on a loaded machine its threads wait for each other a hundred times as long as
    such small matrices take.

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
    taken, clock = 0.0, one_thread_clock()
    for _ in range(POINTS):
        point = dict(zip(names, 10.0 ** generator.uniform(-2, 2, len(names)), strict=True))
        transition, noise, measurement, measured = (matrix(model[key], point) for key in MATRICES)
        noise = point["tracking_index"] ** 2 * noise
        best = math.inf
        for _ in range(REPEATED):
            with _one_thread():
                start = clock()
                solve_discrete_are(transition.T, measurement.T, noise, measured)
                best = min(best, clock() - start)
        taken += best
    return taken / POINTS


def _one_thread() -> AbstractContextManager[object]:
    try:
        limits: AbstractContextManager[object] = import_module("threadpoolctl").threadpool_limits(1)
    except ImportError:
        return nullcontext()
    return limits


def matrix(rows: Sequence[Sequence[Any]], point: Mapping[str, float]) -> NDArray[np.float64]:
    """The matrix at a point."""
    return np.array([[_entry(entry, point) for entry in row] for row in rows])


def _entry(entry: Any, point: Mapping[str, float]) -> float:
    if isinstance(entry, str):
        return float(Fraction(entry))
    (value,) = ball_outputs(entry, point).values()
    return float(value.mid())
