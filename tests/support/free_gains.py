"""Claims about filters with free gains, and the same filters in plain numbers.

The numbers share nothing with the judge: poles are eigenvalues, covariances the solution of the
Lyapunov equation by a Kronecker product, lags the end of a run without noise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import factorial

import numpy as np
from numpy.typing import NDArray
from small_claims import judged

from gainproof.verify.judge.verdict import ClaimVerdict

Array = NDArray[np.float64]

TWO = {
    r"\alpha": "{ quantity = 'filter_gain.1', meaning = 'gain of the position' }",
    r"\beta": "{ quantity = 'filter_gain.2', meaning = 'gain of the velocity' }",
    "T": "{ quantity = 'sampling_interval', meaning = 'sampling interval' }",
    "B": "{ quantity = 'measurement_noise_variance', meaning = 'variance of the noise' }",
    "k": "{ quantity = 'sample_number', meaning = 'sample' }",
    "a_c": "{ quantity = 'target_motion.2', meaning = 'acceleration of the target' }",
    "j_c": "{ quantity = 'target_motion.3', meaning = 'jerk of the target' }",
    **{
        f"{letter}_{{{i}{j}}}": f"{{ quantity = '{which}_covariance.{i}.{j}', meaning = 'entry' }}"
        for letter, which in (("p", "predicted"), ("s", "updated"))
        for i in (1, 2)
        for j in (1, 2)
        if i <= j
    },
    **{
        f"{letter}_{{{i}{m}}}": f"{{ quantity = '{which}_lag.{i}.{m}', meaning = 'lag' }}"
        for letter, which in (("e", "predicted"), ("f", "updated"))
        for i in (1, 2)
        for m in range(4)
    },
}
THREE = {
    **TWO,
    r"\gamma": "{ quantity = 'filter_gain.3', meaning = 'gain of the acceleration' }",
    "p_{33}": "{ quantity = 'predicted_covariance.3.3', meaning = 'entry' }",
    "e_{33}": "{ quantity = 'predicted_lag.3.3', meaning = 'lag' }",
}
FILTERS = r"""
[settings.s.filters]
MV = ['\alpha = -\frac{\beta}{2} + \sqrt{\beta}']
RA = ['(\alpha + \frac{\beta}{2})^2 = 2\beta']
RV = ['\alpha(\alpha + \beta) = 2\beta']
"""


def verdict(kind: str, fields: str, states: int = 2, more: str = "") -> ClaimVerdict:
    """The verdict on one claim about a kinematic filter of two or three states."""
    symbols: Mapping[str, str] = TWO if states == 2 else THREE
    return judged(kind, fields, symbols, f"kind = 'fixed_gain'\nstates = {states}\n{more}")


def closed_loop(gains: Sequence[float]) -> tuple[Array, Array, Array]:
    """F, H and F (I - K H) of a kinematic filter, T = 1."""
    size = len(gains)
    transition = np.array(
        [[1 / factorial(j - i) if j >= i else 0.0 for j in range(size)] for i in range(size)]
    )
    measurement = np.eye(1, size)
    column = np.array(gains, dtype=float).reshape(-1, 1)
    return transition, measurement, transition @ (np.eye(size) - column @ measurement)


def radius(gains: Sequence[float]) -> float:
    """The largest absolute value of a pole."""
    return float(max(abs(np.linalg.eigvals(closed_loop(gains)[2]))))


def predicted_covariance(gains: Sequence[float], noise: Array | None = None) -> Array:
    """Under measurement noise of variance 1 and process noise of this covariance."""
    transition, _, loop = closed_loop(gains)
    size = len(gains)
    column = transition @ np.array(gains, dtype=float).reshape(-1, 1)
    source = column @ column.T + (np.zeros((size, size)) if noise is None else noise)
    whole = np.eye(size * size) - np.kron(loop, loop)
    solved = np.linalg.solve(whole, source.reshape(-1)).reshape(size, size)
    return solved.astype(np.float64)


def lags(gains: Sequence[float], order: int, samples: int = 4000) -> tuple[Array, Array]:
    """True minus predicted and minus updated state after many samples of a target whose derivative
    of this order is 1.
    """
    transition, measurement, _ = closed_loop(gains)
    size, column = len(gains), np.array(gains, dtype=float)
    state = np.zeros(size)
    predicted = updated = state
    for sample in range(samples + 1):
        truth = np.array(
            [
                sample ** (order - i) / factorial(order - i) if i <= order else 0.0
                for i in range(size)
            ]
        )
        before = transition @ state
        state = before + column * (truth[0] - float((measurement @ before)[0]))
        predicted, updated = truth - before, truth - state
    return predicted, updated
