"""The named alpha-beta filters as curves in the region, and filters of one lag or one alpha."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.two_towers import E, X, Y, gain_elements, variance_of


def optimum_tower() -> Tower:
    """Every stable filter, with n the root of 4/beta."""
    root = Generator("n", 1 + X + Y)
    return Tower(
        "optimum",
        above_zero("x", "y"),
        (root,),
        {
            **gain_elements(X, Y),
            "predicted_11": variance_of(X, Y),
            "updated_11": ((X - 1) ** 2 + Y) / (X * Y),
        },
    )


def minimum_variance_tower() -> Tower:
    """y = x (1 + x)."""
    y = X * (1 + X)
    elements = {
        **gain_elements(X, y),
        "predicted_11": (2 * X + 1) / X**2,
        "lag": (1 + X) ** 2 / 4,
        "slow_root": (1 - X) / (1 + X),
    }
    return Tower("minimum_variance", above_zero("x"), (), elements)


def random_acceleration_tower() -> Tower:
    """y = (x^2 - 1)/2, stable or not."""
    elements = {"alpha": 4 * X / (1 + X) ** 2, "beta": 8 / (1 + X) ** 2}
    return Tower("random_acceleration", above_zero("x"), (), elements)


def random_velocity_tower() -> Tower:
    """y = (x^2 - 2)/2, stable or not; the root of 2 says where."""
    root = Generator("root_two", sp.Integer(2))
    elements = {"alpha": 4 / (X + 2), "beta": 8 / (X * (X + 2))}
    return Tower("random_velocity", above_zero("x"), (root,), elements)


def stable_acceleration_tower() -> Tower:
    """x = 1 + e: the stable ones of random acceleration."""
    elements = {
        "alpha": 4 * (1 + E) / (2 + E) ** 2,
        "beta": 8 / (2 + E) ** 2,
        "lag": (2 + E) ** 2 / 8,
        "predicted_11": ((2 + E) ** 2 - (1 + E) * E) / ((1 + E) * E),
    }
    return Tower("stable_acceleration", above_zero("e"), (), elements)


def stable_velocity_tower() -> Tower:
    """y > 0 of random velocity; x is the root of 2 + 2 y."""
    g = real("g")
    elements = {
        "alpha": 4 / (g + 2),
        "beta": 8 / (g**2 + 2 * g),
        "lag": (g**2 + 2 * g) / 8,
        "predicted_11": variance_of(g, Y),
    }
    # the root of 2 is for the kernel, which takes y apart
    roots = (Generator("root_two", sp.Integer(2)), Generator("g", 2 + 2 * Y))
    return Tower("stable_velocity", above_zero("y"), roots, elements)


def same_lag_tower() -> Tower:
    """The three named filters of one beta, from y of random velocity's.

    g: its x; r: 1 + x of random acceleration's; n: 1 + x of minimum variance's.
    """
    g, r, n = map(real, ("g", "r", "n"))
    generators = (
        Generator("g", 2 + 2 * Y),
        Generator("r", 2 + 2 * Y + 2 * g),
        Generator("n", 1 + Y + g),
    )
    third = (Y + g) / (n + 1)
    second = (1 + 2 * Y + 2 * g) / (r + 1)
    rest = r * (Y + (1 + 2 * Y) / (g + 1)) / (r + 2)
    elements = {
        "beta": 4 / (1 + Y + g),
        "velocity_alpha": 2 * g / (1 + Y + g),
        "acceleration_alpha": 2 * second / (1 + Y + g),
        "minimum_alpha": 2 * third / (1 + Y + g),
        "velocity_variance": variance_of(g, Y),
        "acceleration_variance": variance_of(second, rest),
        "minimum_variance": ((n / third) ** 2) - 1,
    }
    return Tower("same_lag", above_zero("y"), generators, elements)


def same_gain_tower() -> Tower:
    """The three of one alpha, x that of minimum variance; v is the root of 1 + x^2."""
    v = real("v")
    outer = 1 + X + v
    elements = {
        "alpha": 2 * X / (1 + X) ** 2,
        "minimum_beta": 4 / (1 + X) ** 2,
        "acceleration_beta": 8 * X**2 / (outer**2 * (1 + X) ** 2),
        "velocity_beta": 2 * X**2 / ((1 + X) ** 2 * (1 + X + X**2)),
        "minimum_variance": (1 + 2 * X) / X**2,
        "acceleration_variance": 2 * (1 + X) ** 2 / (v * outer) - 1,
        "velocity_variance": X
        * (3 + 5 * X + 3 * X**2)
        / (2 + 4 * X + 5 * X**2 + 4 * X**3 + 2 * X**4),
    }
    return Tower("same_gain", above_zero("x"), (Generator("v", 1 + X**2),), elements)


def same_larger_gain_tower() -> Tower:
    """Random acceleration and random velocity of one alpha, x = 1 + e that of the first."""
    x = 1 + E
    other = x + 1 / x
    elements = {
        "alpha": 4 * x / (1 + x) ** 2,
        "acceleration_beta": 8 / (1 + x) ** 2,
        "velocity_beta": 8 / (other * (other + 2)),
    }
    return Tower("same_larger_gain", above_zero("e"), (), elements)


def two_minima_tower() -> Tower:
    """Both filters of minimum variance with one alpha, x = 1 + e that of the slow one."""
    x = 1 + E
    elements = {
        "alpha": 2 * x / (1 + x) ** 2,
        "slow_beta": 4 / (1 + x) ** 2,
        "fast_beta": 4 * x**2 / (1 + x) ** 2,
        "slow_variance": (1 + 2 * x) / x**2,
        "fast_variance": x**2 + 2 * x,
    }
    return Tower("two_minima", above_zero("e"), (), elements)


def named_towers() -> tuple[Tower, ...]:
    """All of them."""
    return (
        optimum_tower(),
        minimum_variance_tower(),
        random_acceleration_tower(),
        random_velocity_tower(),
        stable_acceleration_tower(),
        stable_velocity_tower(),
        same_lag_tower(),
        same_gain_tower(),
        same_larger_gain_tower(),
        two_minima_tower(),
    )
