"""How far a float64 run of the Kalman recursion, or a solved Riccati equation, may be off."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.verify.oracles.ball import Enclosure
from gainproof.verify.oracles.matrices import Matrix
from gainproof.verify.oracles.state_space import StateSpace

EPS = 2.0**-52


def allowance(model: StateSpace, truth: Enclosure) -> Mapping[str, float]:
    """The absolute error allowed for each kind of entry, by first-order perturbation.

    One step F ((I - K H) M (I - K H)' + K R K') F' + Q rounds by a few eps times
    |F|^2 (1 + |K| |H|)^2 |M|; the Lyapunov operator of the closed loop sums that over all steps
    (its inverse's norm); from the predicted covariance it reaches the gain through the division
    by the innovation variance, and the updated covariance through |I - K H|^2. The roundings of
    that last passage are added. Ten covers the few roundings of an entry.
    """
    f, h = floats(model.transition), floats(model.measurement)
    m, k = floats(truth.state.predicted), floats(truth.state.gain)
    loop = f - f @ k @ h
    summed = norm(np.linalg.inv(np.eye(loop.size) - np.kron(loop, loop)))
    kept = 1 + norm(k) * norm(h)
    innovation = float(truth.state.innovation[0][0].mid())
    error = 10 * EPS * (summed * (norm(f) * kept) ** 2 + 1) * norm(m)
    return {
        "predicted": error,
        "updated": error * kept**2 + 10 * EPS * innovation * norm(k) ** 2,
        "innovation": error * norm(h) ** 2 + 10 * EPS * innovation,
        "gain": error * kept * norm(h) / innovation + 10 * EPS * norm(k),
    }


def floats(rows: Matrix) -> NDArray[np.float64]:
    """A matrix of fractions or balls in float64."""
    return np.array([[float(x.mid() if hasattr(x, "mid") else x) for x in row] for row in rows])


def norm(a: NDArray[Any]) -> float:
    """The largest singular value."""
    return float(np.linalg.norm(a, 2))
