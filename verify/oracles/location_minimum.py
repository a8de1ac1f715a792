"""Position, velocity and biases by SciPy's least squares over the plain formulas.

Independent because SciPy's trust region does the search, over position, velocity and biases as
equal unknowns; derivatives are complex-step differences of the residuals, which are written as a
tracker's textbook has them (length of a difference, its derivative as r.w/|r|), and the noise is
weighted by a symmetric root of the inverse covariance from its eigenvalues.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

Reals = NDArray[np.float64]


def minimum(
    positions: Reals,
    velocities: Reals,
    rows: Sequence[tuple[int, bool]],
    observed: Reals,
    covariance: Reals,
    columns: Reals,
    start: Reals,
    moving: bool = True,
) -> tuple[Reals, float]:
    """The unknowns at the minimum (position, velocity where `moving`, biases) and the cost there.

    rows: of each observation the station and whether it is a range rate; columns (m, q): what each
    bias adds; start: where to begin, in the order of the unknowns.
    """
    where = [i for i, _ in rows]
    rate = np.array([is_rate for _, is_rate in rows])
    values, vectors = np.linalg.eigh(covariance)
    root = (vectors / np.sqrt(values)) @ vectors.T
    d = positions.shape[1]
    k = 2 * d if moving else d

    def residual(unknowns: NDArray[Any]) -> NDArray[Any]:
        apart = unknowns[:d] - positions[where]
        motion = (unknowns[d:k] if moving else 0) - velocities[where]
        length = np.sqrt((apart * apart).sum(axis=1))
        speed = (apart * motion).sum(axis=1) / length
        seen = np.where(rate, speed, length) + columns @ unknowns[k:]
        return np.asarray(root @ (seen - observed))

    done = least_squares(
        residual, start, jac="cs", x_scale="jac", xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=400
    )
    return np.asarray(done.x, np.float64), float(2 * done.cost)
