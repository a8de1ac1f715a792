"""How far a float64 run of a filter with several measured quantities may be off."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from float_rounding import EPS, floats, norm

from gainproof.verify.oracles.state_space import StateSpace, SteadyState


def allowance(model: StateSpace, truth: SteadyState) -> Mapping[str, float]:
    """The absolute error allowed for each kind of entry, by first-order perturbation.

    As in ``float_rounding``: one step rounds by a few eps times |F|^2 (1 + |K| |H|)^2 |M|, the
    Lyapunov operator of the closed loop sums that over all steps. With several measured
    quantities the gain passes through the inverse of the innovation covariance, which multiplies
    its rounding by the condition of that matrix. Ten covers the few roundings of an entry.
    """
    f, h, r = map(floats, (model.transition, model.measurement, model.measurement_noise))
    m, k, innovation = map(floats, (truth.predicted, truth.gain, truth.innovation))
    loop = f - f @ k @ h
    summed = norm(np.linalg.inv(np.eye(loop.size) - np.kron(loop, loop)))
    kept = 1 + norm(k) * norm(h)
    inverse = norm(np.linalg.inv(innovation))
    error = 10 * EPS * (summed * (norm(f) * kept) ** 2 + 1) * norm(m)
    return {
        "predicted": error,
        "updated": error * kept**2 + 10 * EPS * norm(r) * norm(k) ** 2,
        "gain": error * kept * norm(h) * inverse + 10 * EPS * norm(k) * norm(innovation) * inverse,
    }
