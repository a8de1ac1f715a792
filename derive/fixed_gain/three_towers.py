"""The parameters of alpha-beta-gamma filters and what is made of them.

(1 - s)^3 c((1 + s)/(1 - s)) = gamma (1 + x s + y s^2 + d s^3): the stable filters are x > 0, d > 0
and m = x y - d > 0, Hurwitz' determinant.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, listed, pairs
from gainproof.derive.fixed_gain.steps_filter import EQUATIONS

X, Y, D, M, A, B, E, P, T = map(real, ("x", "y", "d", "m", "a", "b", "e", "p", "t"))
LOOP = Loop(3)
Elements = dict[str, sp.Expr]


def gain_elements(x: sp.Expr, y: sp.Expr, d: sp.Expr) -> Elements:
    """alpha, beta and gamma of the coordinates."""
    below = 1 + x + y + d
    return {"alpha": 2 * (1 + y) / below, "beta": 4 * x / below, "gamma": 8 / below}


def equations_tower() -> Tower:
    """Any interval; state, observations and gains stand for anything."""
    return Tower(EQUATIONS, above_zero("t"), (), {})


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


def real_roots_tower() -> Tower:
    """Three real roots (1 - a)/(1 + a), and so with b and e."""
    x = (A * B + B * E + E * A) / (A * B * E)
    y = (A + B + E) / (A * B * E)
    elements = {
        "first_root": (1 - A) / (1 + A),
        "second_root": (1 - B) / (1 + B),
        "third_root": (1 - E) / (1 + E),
        **gain_elements(x, y, 1 / (A * B * E)),
    }
    return Tower("real_roots", above_zero("a", "b", "e"), (), elements)


def complex_roots_tower() -> Tower:
    """One real root (1 - a)/(1 + a) and a pair from s = -b +- i e."""
    size, below = B**2 + E**2, (1 + B) ** 2 + E**2
    elements = {
        "first_root": (1 - A) / (1 + A),
        "root_real": (1 - size) / below,
        "root_imaginary": 2 * E / below,
        **gain_elements((2 * A * B + size) / (A * size), (A + 2 * B) / (A * size), 1 / (A * size)),
    }
    return Tower("complex_roots", above_zero("a", "b", "e"), (), elements)


def optimum_tower() -> Tower:
    """All filters of the lag (1 + p)^3/8, from their x = p t^2."""
    return Tower("optimum", above_zero("p", "t"), (), {})


def equal_minors_tower() -> Tower:
    """The stable filters with d = m, which is x y = 2 d."""
    return Tower("equal_minors", above_zero("x", "y"), (), gain_elements(X, Y, X * Y / 2))


def minimum_variance_tower() -> Tower:
    """y = 2 x (1 + x), d = x^2 (1 + x)."""
    elements = {
        "alpha": 2 * (2 * X**2 + 2 * X + 1) / (1 + X) ** 3,
        "beta": 4 * X / (1 + X) ** 3,
        "gamma": 8 / (1 + X) ** 3,
        "lag": (1 + X) ** 3 / 8,
        "predicted_11": (3 * X**2 + 3 * X + 1) / X**3,
        "cube": (1 + X) / 2,
    }
    return Tower("minimum_variance", above_zero("x"), (), elements)


def random_acceleration_tower() -> Tower:
    """y = x^2/2 - 1, d = x (x^2 - 4)/8, stable or not."""
    elements = {
        "alpha": 8 * X / (X + 2) ** 2,
        "beta": 32 / (X + 2) ** 2,
        "gamma": 64 / (X * (X + 2) ** 2),
    }
    return Tower("random_acceleration", above_zero("x"), (), elements)


def stable_acceleration_tower() -> Tower:
    """x = 2 + e: the stable ones of random acceleration."""
    x = 2 + E
    elements = {
        "alpha": 8 * x / (x + 2) ** 2,
        "beta": 32 / (x + 2) ** 2,
        "gamma": 64 / (x * (x + 2) ** 2),
        "lag": x * (x + 2) ** 2 / 64,
        "predicted_11": (20 * x**2 + 24 * x) / ((x - 2) * (3 * x**2 - 4)),
    }
    return Tower("stable_acceleration", above_zero("e"), (), elements)


def random_jerk_tower() -> Tower:
    """y = x^2/2 - 5/6 and d = (3 x^4 - 10 x^2 - 1)/(24 x), x = 1 + e, stable or not."""
    x = 1 + E
    below = sp.expand(3 * x**4 + 12 * x**3 + 14 * x**2 + 4 * x - 1)
    elements = {
        "x": x,
        "alpha": 8 * x * (3 * x**2 + 1) / below,
        "beta": 96 * x**2 / below,
        "gamma": 192 * x / below,
    }
    return Tower("random_jerk", above_zero("e"), (), elements)


def same_lag_tower() -> Tower:
    """Random jerk with x >= 2, and a random acceleration filter of more lag, whose x is `bound`."""
    below = sp.expand(3 * X**4 + 12 * X**3 + 14 * X**2 + 4 * X - 1)
    size = below / (24 * X)
    d = (3 * X**4 - 10 * X**2 - 1) / (24 * X)
    m = (9 * X**2 - 1) * (X**2 - 1) / (24 * X)
    bound = X + (2 * X**2 + 4 * X - 1) / (3 * X * (3 * X + 2) * (X + 2))
    elements = {
        "alpha": 8 * X * (3 * X**2 + 1) / below,
        "beta": 96 * X**2 / below,
        "gamma": 192 * X / below,
        "lag": size / 8,
        "predicted_11": size * (X * (1 + X) + m) / (d * m) - 1,
        "bound": bound,
        "bound_lag": bound * (bound + 2) ** 2 / 64,
        "bound_variance": (20 * bound**2 + 24 * bound) / ((bound - 2) * (3 * bound**2 - 4)),
    }
    return Tower("same_lag", (Parameter("x", above=None, start="2"),), (), elements)


def towers() -> tuple[Tower, ...]:
    """All of them."""
    return (
        main_tower(),
        equations_tower(),
        real_roots_tower(),
        complex_roots_tower(),
        optimum_tower(),
        equal_minors_tower(),
        minimum_variance_tower(),
        random_acceleration_tower(),
        stable_acceleration_tower(),
        random_jerk_tower(),
        same_lag_tower(),
    )
