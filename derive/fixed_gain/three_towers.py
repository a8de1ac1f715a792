"""The parameters of alpha-beta-gamma filters and what is made of them.

(1 - s)^3 c((1 + s)/(1 - s)) = gamma (1 + x s + y s^2 + d s^3): the stable filters are x > 0, d > 0
and m = x y - d > 0, Hurwitz' determinant.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, listed, pairs

X, D, M = map(real, ("x", "d", "m"))
LOOP = Loop(3)
ALPHA, BETA, GAMMA = LOOP.gains
MARGIN = 4 - 2 * ALPHA - BETA
Elements = dict[str, sp.Expr]


def gain_elements(x: sp.Expr, y: sp.Expr, d: sp.Expr) -> Elements:
    """alpha, beta and gamma of the coordinates."""
    below = 1 + x + y + d
    return {"alpha": 2 * (1 + y) / below, "beta": 4 * x / below, "gamma": 8 / below}


def main_tower() -> Tower:
    """Every stable filter."""
    y = (D + M) / X
    predicted = sp.Matrix(
        [
            [
                (1 + X + y + D) * (X * (1 + X) + M) / (D * M) - 1,
                2 * X * (X + 1) * (X + y + 1) / (D * M),
                4 * (X**2 + X + M) / (D * M),
            ],
            [0, 4 * (D + X * (X + 1) ** 2) / (D * M), 8 * X * (X + 1) / (D * M)],
            [0, 0, 16 * X / (D * M)],
        ]
    )
    predicted = sp.Matrix(3, 3, lambda i, j: predicted[min(i, j), max(i, j)])
    gains = gain_elements(X, y, D)
    known = {real(name): value for name, value in gains.items()}
    rest, column = LOOP.rest.subs(known), LOOP.column.subs(known)
    updated = (rest * predicted * rest.T + column * column.T).applyfunc(sp.factor)
    elements = {
        "y": y,
        **gains,
        **dict(zip((f"predicted_{ij}" for ij in pairs(3)), listed(predicted), strict=True)),
        **dict(zip((f"updated_{ij}" for ij in pairs(3)), listed(updated), strict=True)),
        "innovation_variance": (1 + X + y + D) * (X * (1 + X) + M) / (D * M),
        "share": (D + X) / (D + X + M),
    }
    return Tower("main", above_zero("x", "d", "m"), (), elements)


def lecture_variance() -> sp.Expr:
    """The lecture's smoothing index, the variance of the predicted position."""
    g = (2 * ALPHA * BETA - GAMMA * (2 - ALPHA)) * MARGIN
    return 8 * BETA**2 / ((2 - ALPHA) * g) + ALPHA / (2 - ALPHA)
