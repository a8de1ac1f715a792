"""Kernels of what a process noise adds to covariances, for each entry of its covariance Q.

Every entry of D = A D A' + Q is linear in q11, q12 and q22; each coefficient has one sign on the
whole region but one, and q12 counts as -q11 but in one entry.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, pairs
from gainproof.derive.fixed_gain.process_noise import noise_shares
from gainproof.derive.fixed_gain.two_kernels import SCALE, difference
from gainproof.derive.printer.graph import Graph, GraphBuilder

BY = "_by_q_"
TURNING = f"updated_12{BY}22"
EQUATIONS = (
    "with T = 1 (q12 is T times, q22 T^2 times what it is with units), added to the variances:",
    "predicted_11 = (q11 - q12) predicted_11_by_q_11 + q22 predicted_11_by_q_22,",
    "predicted_12 = (q11 - q12) predicted_12_by_q_11 + q22 predicted_12_by_q_22,",
)
AHEAD = (
    *EQUATIONS,
    "predicted_22 = q11 predicted_22_by_q_11 + q12 predicted_22_by_q_12",
    "+ q22 predicted_22_by_q_22",
)
AFTER = (
    *EQUATIONS,
    "predicted_22 = updated_22 + q22,",
    "updated_11 = (q11 - q12) updated_11_by_q_11 + q22 updated_11_by_q_22,",
    "updated_12 = (q11 - q12) updated_12_by_q_11 + q22 updated_12_by_q_22,",
    "updated_22 = q11 predicted_22_by_q_11 + q12 predicted_22_by_q_12",
    "+ q22 updated_22_by_q_22",
)


def noise_variances() -> Graph:
    """Over the gains: prediction and update."""
    builder = GraphBuilder()
    alpha, beta = builder.symbol("alpha"), builder.symbol("beta")
    rest, beyond = 1 - alpha, 2 - alpha
    margin = rest * 2 + (2 - beta)
    ratio = beta / alpha
    base, far = alpha * margin, beta * margin
    first, last = 2 / base, beyond / alpha / far
    cross = (beyond + ratio * rest) / far
    both = (beyond + ratio * rest) * 2 / margin
    after = (alpha * beyond + ratio * rest * 2) / far
    near, other = rest * beyond / far, rest / base
    turning = near - other
    square = rest * rest
    return builder.graph(
        {
            f"predicted_11{BY}11": first,
            f"predicted_11{BY}22": last,
            f"predicted_12{BY}11": ratio / margin,
            f"predicted_12{BY}22": cross,
            f"predicted_22{BY}11": ratio * beyond / margin,
            f"predicted_22{BY}12": -both,
            f"updated_11{BY}11": square * first,
            f"updated_11{BY}22": square * last,
            f"updated_12{BY}11": -(ratio * rest / margin),
            TURNING: turning,
            f"updated_22{BY}22": after,
            TURNING + SCALE: near + other,
        },
        {difference(TURNING): turning},
    )


def noise_variances_of_coordinates() -> Graph:
    """Over the coordinates of every stable filter: the prediction."""
    builder = GraphBuilder()
    x, y = builder.symbol("linear_coefficient"), builder.symbol("quadratic_coefficient")
    more = y + 1
    total, area = x + more, x * y
    size = total / area
    wide = more / area + 1
    return builder.graph(
        {
            f"predicted_11{BY}11": size * total / 4,
            f"predicted_11{BY}22": size * total * more / 16,
            f"predicted_12{BY}11": size / 2,
            f"predicted_12{BY}22": total * wide / 8,
            f"predicted_22{BY}11": more / area,
            f"predicted_22{BY}12": -wide,
            f"predicted_22{BY}22": (more * more / area + (x + 4)) / 4,
        }
    )


def noise_meanings(loop: Loop) -> dict[str, sp.Expr]:
    """What the outputs stand for, over the gains: the solved equation's coefficients."""
    shares = noise_shares(loop)
    known = {
        f"{kind}_{ij}{BY}{kl}": shares[kind][ij, kl]
        for kind in ("predicted", "updated")
        for ij in pairs(loop.size)
        for kl in pairs(loop.size)
    }
    alpha, beta = map(real, ("alpha", "beta"))
    below = alpha * beta * (4 - 2 * alpha - beta)
    known[TURNING + SCALE] = (1 - alpha) * (alpha * (2 - alpha) + beta) / below
    return known
