"""The parameters of alpha-beta filters and what is made of them.

(1 - s)^2 c((1 + s)/(1 - s)) = beta (1 + x s + y s^2): the stable filters are x > 0, y > 0.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, listed, lyapunov, pairs
from gainproof.derive.fixed_gain.steps_filter import EQUATIONS

X, Y, A, B, E = map(real, ("x", "y", "a", "b", "e"))
LOOP = Loop(2)
Elements = dict[str, sp.Expr]


def gains_of(x: sp.Expr, y: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """alpha and beta."""
    return 2 * x / (1 + x + y), 4 / (1 + x + y)


def variance_of(x: sp.Expr, y: sp.Expr) -> sp.Expr:
    """The variance of the predicted position, written without a minus sign."""
    return ((1 + x) ** 2 + y) / (x * y)


def gain_elements(x: sp.Expr, y: sp.Expr) -> Elements:
    alpha, beta = gains_of(x, y)
    return {"alpha": alpha, "beta": beta}


def equations_tower() -> Tower:
    """Any interval; state, observations and gains stand for anything."""
    return Tower(EQUATIONS, above_zero("t"), (), {})


def main_tower() -> Tower:
    """Every stable filter."""
    gains = dict(zip(LOOP.gains, gains_of(X, Y), strict=True))
    seen = LOOP.transition * LOOP.column * LOOP.column.T * LOOP.transition.T
    predicted = lyapunov(LOOP, seen).subs(gains).applyfunc(sp.factor)
    rest = LOOP.rest.subs(gains)
    column = LOOP.column.subs(gains)
    updated = (rest * predicted * rest.T + column * column.T).applyfunc(sp.factor)
    elements = {
        **gain_elements(X, Y),
        **dict(zip((f"predicted_{ij}" for ij in pairs(2)), listed(predicted), strict=True)),
        **dict(zip((f"updated_{ij}" for ij in pairs(2)), listed(updated), strict=True)),
        "innovation_variance": (1 + X) * (1 + X + Y) / (X * Y),
    }
    return Tower("main", above_zero("x", "y"), (), elements)


def real_roots_tower() -> Tower:
    """Two real roots (1 - a)/(1 + a) and (1 - b)/(1 + b): every pair between -1 and 1."""
    elements = {
        "first_root": (1 - A) / (1 + A),
        "second_root": (1 - B) / (1 + B),
        **gain_elements((A + B) / (A * B), 1 / (A * B)),
    }
    return Tower("real_roots", above_zero("a", "b"), (), elements)


def complex_roots_tower() -> Tower:
    """A pair u +- i v inside the unit circle, from s = -a +- i b."""
    size = A**2 + B**2
    below = (1 + A) ** 2 + B**2
    elements = {
        "root_real": (1 - size) / below,
        "root_imaginary": 2 * B / below,
        **gain_elements(2 * A / size, 1 / size),
    }
    return Tower("complex_roots", above_zero("a", "b"), (), elements)


def double_tower() -> Tower:
    """A double root: y = x^2/4."""
    return Tower("double_root", above_zero("x"), (), gain_elements(X, X**2 / 4))


def poles_tower() -> Tower:
    """Any alpha and beta with 0 < alpha < 1, 0 < beta < 2; the modulus is 1/(1 + e)."""
    modulus = 1 / (1 + E)
    elements = {
        "alpha": E * (2 + E) / (1 + E) ** 2,
        "beta": 2 / (1 + X),
        "modulus": modulus,
    }
    return Tower("poles", above_zero("e", "x"), (), elements)


def towers() -> tuple[Tower, ...]:
    """Those of the region; those of the named curves are in `two_named_towers`."""
    return (
        main_tower(),
        equations_tower(),
        real_roots_tower(),
        complex_roots_tower(),
        double_tower(),
        poles_tower(),
    )
