"""A filter run on simulated tracks: what its prediction errors really are.

Independent because no covariance equation is solved or run: tracks are drawn from the model, each
is measured with noise, the filter with the gain under test follows it, and the error of its last
prediction is noted. One error a track, so that the errors are independent of one another and,
being linear in Gaussian draws, exactly normal with mean zero: N times their sample covariance has
a Wishart distribution of N degrees, and intervals of stated confidence are exact.

What it rests on: that the start is forgotten. It is not when the errors begin with those of the
first measurement alone, so that the caller says how many samples to run; their influence dies out
with the powers of the closed loop. The generator is NumPy's with the seed given.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.verify.oracles.state_space import StateSpace

Reals = NDArray[np.float64]


def prediction_errors(
    model: StateSpace, gain: Reals, samples: int, tracks: int, seed: int
) -> Reals:
    """Predicted minus true state at the last sample, one row a track.

    ``model`` must measure every state (H = I): the filter starts at the first measurement, as in
    the appendix of Suzuki (A3). ``gain`` is n x n. Raises ValueError for another H or shape.
    """
    n = model.size
    f, q, h, r = map(_floats, (model.transition, model.process_noise,
                               model.measurement, model.measurement_noise))  # fmt: skip
    if not np.array_equal(h, np.eye(n)) or gain.shape != (n, n):
        raise ValueError(f"needs every state measured and a {n}x{n} gain, got H = {h.tolist()}")
    generator = np.random.default_rng(seed)
    shaken, read = _root(q), _root(r)

    def draw(root: Reals) -> Reals:
        return np.asarray(generator.standard_normal((tracks, n)) @ root.T)

    state = np.zeros((tracks, n))
    estimate = state + draw(read)
    predicted = estimate
    for _ in range(samples):
        state = state @ f.T + draw(shaken)
        predicted = estimate @ f.T
        measured = state + draw(read)
        estimate = predicted + (measured - predicted) @ gain.T
    return np.asarray(predicted - state)


def samples_to_forget(model: StateSpace, gain: Reals, left: float) -> int:
    """After how many samples the closed loop has shrunk what it started with to ``left``."""
    f, h = _floats(model.transition), _floats(model.measurement)
    loop = f @ (np.eye(model.size) - gain @ h)
    samples, power = 1, loop
    while np.linalg.norm(power, 2) > left:
        samples, power = samples + 1, power @ loop
        if samples > 100_000:
            raise ValueError("the closed loop does not shrink")
    return samples


def _root(covariance: Reals) -> Reals:
    """A matrix whose product with its transpose is the covariance, singular ones included."""
    values, vectors = np.linalg.eigh(covariance)
    return np.asarray(vectors * np.sqrt(np.clip(values, 0, None)))


def _floats(rows: Any) -> Reals:
    return np.array([[float(x) for x in row] for row in rows])
