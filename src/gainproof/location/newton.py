"""Newton steps with all second derivatives, where the model bends more than it is steep.

In a valley whose floor is curved, steps of the linear model are short or leave it: they neglect
residual times second derivative. Here these come from the printed kernels. In coordinates in which
the linear model is an isometry (those of the triangle of its QR factorisation, so that no normal
equations are formed) the cost's second derivative is the unit matrix less that part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.generated import range_doppler
from gainproof.location.gauss_newton import (
    CONVERGED,
    EPSILON,
    ON_STATION,
    SMALL_STEP,
    Iterated,
    costs,
    rank_tolerance,
    rounding,
)
from gainproof.location.problem import Problem, linearised, residual

MOST_NEWTON = 200
MOST_STARTS = 6
AS_GOOD = 9.0
"""Only starts whose cost is at most so much above the least are gone on with."""
LEAST_CURVATURE = 1e-12
LAST_STEP = 1e-6
"""In deviations: where the cost has no digit left to fall by, a step of this length is the last."""
SHARES = 0.5 ** np.arange(0, 30)


def newton(asked: Problem, iterated: Iterated) -> Iterated:
    """The starts that did not settle and came near the least cost, gone on with. A start settles
    where its step is short and the cost bends upwards in every direction; others keep how they
    ended.
    """
    open_ = (iterated.ended != CONVERGED) & (iterated.ended != ON_STATION)
    near = open_ & (iterated.cost <= iterated.cost.min(initial=np.inf) + AS_GOOD)
    chosen = np.flatnonzero(near)
    chosen = chosen[np.argsort(iterated.cost[chosen], kind="stable")][:MOST_STARTS]
    done = {name: np.array(value) for name, value in vars(iterated).items()}
    for i in chosen.tolist():
        x, cost, length, count, settled = _descend(asked, iterated.unknowns[i])
        if settled:
            done["unknowns"][i], done["cost"][i], done["step"][i] = x, cost, length
            done["iterations"][i] += count
            done["ended"][i] = CONVERGED
    return replace(iterated, **done)


def _descend(asked: Problem, begin: Reals) -> tuple[Reals, float, float, int, bool]:
    """Place (k,), cost, length of the last step in deviations, steps, and whether it settled."""
    x = np.array(begin)
    observed = asked.used.values[None, :]
    cost = float(costs(asked, x[None, :], observed)[0])
    enough = max(SMALL_STEP, float(rounding(asked, observed)[0]))
    length = float("inf")
    for count in range(MOST_NEWTON):
        with np.errstate(all="ignore"):
            linear = linearised(asked, x[None, :], observed)
            jacobian, scale = linear.jacobian[0], linear.scale[0]
            orthogonal, triangle = np.linalg.qr(jacobian)
            singular = np.linalg.svd(triangle, compute_uv=False)
            if not singular[-1] > rank_tolerance(asked) * singular[0]:
                return x, cost, length, count, False
            back = np.linalg.solve(triangle, np.eye(len(x))) / scale[:, None]
            bent = back.T @ bending(asked, x) @ back
        if not np.isfinite(bent).all():
            return x, cost, length, count, False
        values, vectors = np.linalg.eigh(np.eye(len(x)) - (bent + bent.T) / 2)
        slope = vectors.T @ (orthogonal.T @ linear.residual[0])
        size = np.maximum(np.abs(values), LEAST_CURVATURE)
        length = float(np.linalg.norm(slope / np.sqrt(size)))
        upwards = bool(values[0] > 0)
        fall = float(np.square(slope / np.sqrt(size)).sum())
        blind = fall <= 8 * EPSILON * cost and length <= LAST_STEP
        if upwards and (length <= enough or blind):
            return x, cost, length, count, True
        step = back @ (vectors @ (slope / size))
        trials = x + SHARES[:, None] * step
        found = costs(asked, trials, np.broadcast_to(observed, (len(SHARES), observed.shape[1])))
        lower = np.flatnonzero(found < cost)
        if not lower.size:
            return x, cost, length, count, upwards and length <= LAST_STEP
        x, cost = trials[lower[0]], float(found[lower[0]])
    return x, cost, length, MOST_NEWTON, False


def bending(asked: Problem, x: Reals) -> Reals:
    """The sum (k, k) of white residual times second derivative."""
    observed = asked.used.values[None, :]
    weights = asked.white.T @ residual(asked, x[None, :], observed)[0]
    place, velocity = (each[0] for each in asked.split(x[None, :]))
    d, given = len(place), asked.stations
    space = d == 3
    of_range = range_doppler.range_hessian if space else range_doppler.range_hessian_in_plane
    of_rate = (
        range_doppler.range_rate_hessian if space else range_doppler.range_rate_hessian_in_plane
    )
    rate, number = asked.used.is_rate, asked.used.station
    stations, motions = given.positions.T, given.velocities.T
    across = _square(of_range(*place, *stations), d)
    total = np.zeros((len(x), len(x)))
    total[:d, :d] = np.einsum("i,ijk->jk", weights[~rate], across[number[~rate]])
    if asked.velocity:
        turned = _square(of_rate(*place, *velocity, *stations, *motions), d)
        total[:d, :d] += np.einsum("i,ijk->jk", weights[rate], turned[number[rate]])
        # a rate bends by place and velocity as a range does by place twice
        mixed = np.einsum("i,ijk->jk", weights[rate], across[number[rate]])
        total[:d, d:] = total[d:, :d] = mixed
    return total


def _square(entries: Sequence[Any], d: int) -> Reals:
    """Symmetric matrices (n, d, d) of their entries in the order xx, xy, ..."""
    rows, columns = np.triu_indices(d)
    full = np.zeros((len(entries[0]), d, d))
    stacked = np.stack([np.asarray(each, np.float64) for each in entries], axis=1)
    full[:, rows, columns] = full[:, columns, rows] = stacked
    return full
