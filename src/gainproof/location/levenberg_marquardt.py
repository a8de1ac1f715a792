"""Levenberg-Marquardt steps for the starts from which Gauss-Newton did not settle.

Where residuals are large or the model bends, full steps zigzag in a valley or run off. A damped
step is the least-squares solution of the whitened, column-scaled Jacobian over rows of damping
times identity, by QR; never by normal equations.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.gauss_newton import (
    AWAY,
    CONVERGED,
    DEFICIENT,
    EPSILON,
    ON_STATION,
    SMALL_STEP,
    Iterated,
    costs,
    rounding,
    step,
)
from gainproof.location.problem import Linear, Problem, linearised

MOST_DAMPED = 300
FIRST_DAMPING = 1e-3
LEAST_DAMPING, MOST_DAMPING = 1e-18, 1e18
"""Of the squared scaled columns."""
SETTLED_STEP = 1e-4
"""In deviations: where the cost has no digit left to fall by, a step of this length is the last."""


def damped(asked: Problem, starts: Reals, iterated: Iterated) -> Iterated:
    """The starts (N, k) that did not settle once more: those that ran away or lost their rank from
    where they began, the others from where they ended. What does not settle here either keeps how
    it ended; ran it on to a lower cost, its place and cost are those.
    """
    again = np.flatnonzero((iterated.ended != CONVERGED) & (iterated.ended != ON_STATION))
    if not again.size:
        return iterated
    back = np.isin(iterated.ended[again], (AWAY, DEFICIENT))
    begin = np.where(back[:, None], starts[again], iterated.unknowns[again])
    x, cost, length, count, settled = _descend(asked, begin)
    lost = iterated.ended[again] == DEFICIENT
    better = settled | (~lost & (cost < iterated.cost[again]))
    done = {name: np.array(value) for name, value in vars(iterated).items()}
    at = again[better]
    done["unknowns"][at], done["cost"][at] = x[better], cost[better]
    done["step"][at] = length[better]
    done["iterations"][at] += count[better]
    done["ended"][again[settled]] = CONVERGED
    return replace(iterated, **done)


def _descend(
    asked: Problem, begin: Reals
) -> tuple[Reals, Reals, Reals, NDArray[np.intp], NDArray[np.bool_]]:
    """Places (n, k), costs, lengths of the last undamped step, iterations, and which settled."""
    x = np.array(begin)
    n = len(x)
    observed = np.broadcast_to(asked.used.values, (n, len(asked.used.values)))
    cost = costs(asked, x, observed)
    enough = np.maximum(SMALL_STEP, rounding(asked, observed))
    damping, growth = np.full(n, FIRST_DAMPING), np.full(n, 2.0)
    length, count = np.full(n, np.inf), np.zeros(n, np.intp)
    settled = np.zeros(n, np.bool_)
    running = np.isfinite(cost)
    for _ in range(MOST_DAMPED):
        now = np.flatnonzero(running)
        if not now.size:
            break
        linear = linearised(asked, x[now], observed[now])
        plain = step(asked, linear)
        length[now] = plain.length
        settled[now] = plain.full_rank & (plain.length <= enough[now])
        change, expected = _step(linear, damping[now])
        trial = x[now] + change
        found = costs(asked, trial, observed[now])
        gain = cost[now] - found
        # a fall that is lost in the cost's last digits cannot be told from none
        blind = expected <= 8 * EPSILON * cost[now]
        flat = blind & (plain.length <= np.maximum(SETTLED_STEP, 1e-7 * np.sqrt(cost[now])))
        settled[now] |= plain.full_rank & flat
        taken = (gain > 0) & ~settled[now]
        share = np.where(taken, gain / np.maximum(expected, 1e-300), 0.0)
        less = np.maximum(1 / 3, 1 - (2 * np.clip(share, 0, 1.5) - 1) ** 3)
        x[now[taken]], cost[now[taken]] = trial[taken], found[taken]
        damping[now] = np.maximum(damping[now] * np.where(taken, less, growth[now]), LEAST_DAMPING)
        growth[now] = np.where(taken, 2.0, 2 * growth[now])
        count[now] += 1
        running[now] = ~settled[now] & (damping[now] < MOST_DAMPING)
    return x, cost, length, count, settled


def _step(linear: Linear, damping: Reals) -> tuple[Reals, Reals]:
    """Damped steps (n, k), and by how much the linear model says the cost falls."""
    m, k = linear.jacobian.shape[1:]
    rows = np.sqrt(damping)[:, None, None] * np.eye(k)
    orthogonal, triangle = np.linalg.qr(np.concatenate([linear.jacobian, rows], axis=1))
    right = np.einsum("nmk,nm->nk", orthogonal[:, :m], linear.residual)
    scaled = np.linalg.solve(triangle, right[..., None])[..., 0]
    expected = np.square(right).sum(axis=1) + damping * np.square(scaled).sum(axis=1)
    return scaled / linear.scale, expected
