"""Filters whose velocity gain is held: best smoothed position, and gains that fit their covariance.

n is 2/sqrt(beta), so that beta held is n held. The least smoothed variance has one branch for beta
below 2 (`smoothed_slow`) and one above (`smoothed_fast`); between them, at 2, none is least.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.two_towers import E, X, gain_elements, variance_of

N = real("n")


def updated_of(x: sp.Expr, y: sp.Expr) -> sp.Expr:
    """The variance of the smoothed position."""
    return ((x - 1) ** 2 + y) / (x * y)


def smoothed_any_tower() -> Tower:
    """x = n (n + 1)/(n + 2), stable or not."""
    elements = {"alpha": 2 * (N + 1) / (N * (N + 2)), "beta": 4 / N**2}
    return Tower("smoothed_any", above_zero("n"), (), elements)


def smoothed_slow_tower() -> Tower:
    """The same with n = sqrt(2) + e: the stable ones."""
    n = real("root_two") + E
    elements = {
        "n": n,
        "alpha": 2 * (n + 1) / (n * (n + 2)),
        "beta": 4 / n**2,
        "lag": n**2 / 4,
        "predicted_11": (2 * n**3 + 7 * n**2 + 8 * n + 2)
        / ((n + 1) ** 2 * E * (E + 2 * real("root_two"))),
        "updated_11": (2 * n + 3) / (n + 1) ** 2,
        "rest": (n**2 + 2 * n + 2) / (n * (n + 2)),
    }
    roots = (Generator("root_two", sp.Integer(2)),)
    return Tower("smoothed_slow", above_zero("e"), roots, elements)


def smoothed_fast_tower() -> Tower:
    """x = n (n - 1)/(2 - n) with n = (1 + 2 e)/(1 + e) between 1 and 2, stable or not."""
    n = (1 + 2 * E) / (1 + E)
    elements = {
        "n": n,
        "alpha": 2 * (n - 1) / (n * (2 - n)),
        "beta": 4 / n**2,
        "updated_11": (3 - 2 * n) / (n - 1) ** 2,
    }
    return Tower("smoothed_fast", above_zero("e"), (), elements)


def smoothed_border_tower() -> Tower:
    """All stable filters with beta = 2."""
    x, y = 1 / (1 + E), E / (1 + E)
    elements = {**gain_elements(x, y), "updated_11": updated_of(x, y)}
    return Tower("smoothed_border", above_zero("e"), (), elements)


def fitting_smoothed_tower() -> Tower:
    """y = x^2 - 1, x = 1 + e: alpha = P/(P + B) of its own P; n is the root of x (x + 1)."""
    x = 1 + E
    y = E * (E + 2)
    elements = {
        **gain_elements(x, y),
        "predicted_11": variance_of(x, y),
        "updated_11": updated_of(x, y),
    }
    return Tower("fitting_smoothed", above_zero("e"), (Generator("n", x * (x + 1)),), elements)


def fitting_predicted_tower() -> Tower:
    """y = (x + 1)^2: alpha + beta fits the covariance; n is the root of (x + 1) (x + 2)."""
    y = (X + 1) ** 2
    elements = {**gain_elements(X, y), "predicted_11": variance_of(X, y)}
    return Tower(
        "fitting_predicted", above_zero("x"), (Generator("n", (X + 1) * (X + 2)),), elements
    )


def held_gain_towers() -> tuple[Tower, ...]:
    """All of them."""
    return (
        smoothed_any_tower(),
        smoothed_slow_tower(),
        smoothed_fast_tower(),
        smoothed_border_tower(),
        fitting_smoothed_tower(),
        fitting_predicted_tower(),
    )
