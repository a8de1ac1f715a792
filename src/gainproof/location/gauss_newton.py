"""The iterated Taylor series: Gauss-Newton steps for many targets at once.

Every step solves the linear model by the QR factorisation of its scaled, whitened Jacobian, never
by normal equations. Where a full step does not lower the cost it is halved.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.problem import Linear, Problem, linearised, residual

MOST_ITERATIONS = 60
MOST_HALVINGS = 24
SMALL_STEP = 1e-10
"""In units of the deviations: a step of this length is the last."""
EPSILON = float(np.finfo(np.float64).eps)
FAR = 1e7
"""A target this many times the stations' spread away (and no start so far) is running away."""

RUNNING, CONVERGED, DEFICIENT, STUCK, ENDLESS, ON_STATION, AWAY = range(7)


@dataclass(frozen=True, eq=False)
class Iterated:
    """Of N targets: unknowns (N, k), how each ended, iterations, halvings, cost, and the length of
    the last step in deviations.
    """

    unknowns: Reals
    ended: NDArray[np.intp]
    iterations: NDArray[np.intp]
    halvings: NDArray[np.intp]
    cost: Reals
    step: Reals


@dataclass(frozen=True, eq=False)
class Step:
    """Steps (N, k), their lengths in deviations, and whether the rank is full, (N,)."""

    change: Reals
    length: Reals
    full_rank: NDArray[np.bool_]


def rank_tolerance(asked: Problem) -> float:
    """Singular values below this share of the largest are rounding: a few eps an entry."""
    return 8 * EPSILON * len(asked.used.values) * asked.unknowns


def rounding(asked: Problem, observed: Reals) -> Reals:
    """What rounding leaves of white residuals of observations (N, m), in deviations, (N,)."""
    sizes = np.abs(observed) @ np.abs(asked.white).T
    return np.asarray(16 * EPSILON * np.linalg.norm(sizes, axis=1))


def step(asked: Problem, linear: Linear) -> Step:
    """The least-squares solution of the linear model. Zero where the rank is deficient."""
    orthogonal, triangle = np.linalg.qr(linear.jacobian)
    fine = _full_rank(triangle, rank_tolerance(asked))
    triangle[~fine] = np.eye(triangle.shape[1])
    right = np.einsum("nmk,nm->nk", orthogonal, linear.residual)
    scaled = np.linalg.solve(triangle, right[..., None])[..., 0]
    change = np.where(fine[:, None], scaled / linear.scale, 0.0)
    return Step(change, np.linalg.norm(right, axis=1), fine)


def _full_rank(triangle: Reals, tolerance: float) -> NDArray[np.bool_]:
    """Whether the least singular value is above this share of the largest, of each triangle.

    |det| is at most least * largest^(k - 1), and the largest at most the Frobenius norm: where that
    is enough no singular values are computed.
    """
    size = np.sqrt(np.square(triangle).sum(axis=(1, 2)))
    diagonal = np.abs(np.diagonal(triangle, axis1=1, axis2=2))
    with np.errstate(all="ignore"):
        fine = np.asarray((diagonal / size[:, None]).prod(axis=1) > tolerance)
    doubtful = np.flatnonzero(~fine)
    if doubtful.size:
        singular = np.linalg.svd(triangle[doubtful], compute_uv=False)
        fine[doubtful] = singular[:, -1] > tolerance * singular[:, 0]
    return fine


def iterate(asked: Problem, starts: Reals, observed: Reals) -> Iterated:
    """From starts (N, k) for observations (N, m) or (m,), until no step is left to take."""
    x = np.array(starts, np.float64)
    n = len(x)
    z = np.broadcast_to(observed, (n, len(asked.used.values)))
    ended = np.full(n, RUNNING)
    iterations, halvings = np.zeros(n, np.intp), np.zeros(n, np.intp)
    last = np.full(n, np.inf)
    cost = costs(asked, x, z)
    ended[~np.isfinite(cost)] = ON_STATION
    far = FAR * np.maximum(asked.stations.spread, _distance(asked, x))
    rest = rounding(asked, z)
    for _ in range(MOST_ITERATIONS):
        now = np.flatnonzero(ended == RUNNING)
        if not now.size:
            break
        taken = step(asked, linearised(asked, x[now], z[now]))
        last[now] = taken.length
        lost = ~taken.full_rank
        ended[now[lost]] = DEFICIENT
        now, change, length = now[~lost], taken.change[~lost], taken.length[~lost]
        iterations[now] += 1
        enough = length <= np.maximum(SMALL_STEP, rest[now])
        # (r + d)^2 - r^2 for a residual r with rounding d
        slack = rest[now] * (2 * np.sqrt(cost[now]) + rest[now])
        halved = _descend(asked, x, z, cost, now, change, slack)
        halvings[now] += np.maximum(halved, 0)
        ended[now[halved < 0]] = STUCK
        ended[now[enough]] = CONVERGED
        gone = _distance(asked, x[now]) > far[now]
        ended[now[gone]] = AWAY
    ended[ended == RUNNING] = ENDLESS
    return Iterated(x, ended, iterations, halvings, cost, last)


def _descend(
    asked: Problem,
    x: Reals,
    z: Reals,
    cost: Reals,
    now: NDArray[np.intp],
    change: Reals,
    slack: Reals,
) -> NDArray[np.intp]:
    """Take the steps in place, each halved until the cost does not grow: how often; -1: never."""
    limit = cost[now] * (1 + 8 * EPSILON) + slack
    halved = np.full(now.size, -1)
    trial = x[now] + change
    found = costs(asked, trial, z[now])
    fine = found <= limit
    x[now[fine]], cost[now[fine]], halved[fine] = trial[fine], found[fine], 0
    left = np.flatnonzero(~fine)
    if not left.size:
        return halved
    # every share at once: most that need halving need it often
    shares = 0.5 ** np.arange(1, MOST_HALVINGS + 1)
    at, m = now[left], len(asked.used.values)
    trials = x[at][:, None, :] + change[left][:, None, :] * shares[:, None]
    rows = np.repeat(z[at], len(shares), axis=0).reshape(-1, m)
    along = costs(asked, trials.reshape(-1, x.shape[1]), rows).reshape(len(at), -1)
    lower = along <= limit[left][:, None]
    first = np.argmax(lower, axis=1)
    some = np.flatnonzero(lower.any(axis=1))
    taken = first[some]
    x[at[some]], cost[at[some]] = trials[some, taken], along[some, taken]
    halved[left[some]] = taken + 1
    return halved


def costs(asked: Problem, x: Reals, z: Reals) -> Reals:
    """Of targets (N, k) for observations (N, m); infinite on a station."""
    with np.errstate(all="ignore"):
        found = np.square(residual(asked, x, z)).sum(axis=1)
    return np.where(np.isnan(found), np.inf, found)


def _distance(asked: Problem, x: Reals) -> Reals:
    place = asked.split(x)[0]
    return np.asarray(np.linalg.norm(place - asked.stations.centre, axis=1))
