"""Steps on the closed-loop poles: where they are complex, where real, and what they are."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, increasing_onto, positive, same_sign
from gainproof.derive.steady_state import poles
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX
from gainproof.derive.steady_state.pole_towers import (
    SIDE,
    G,
    X,
    complex_ends,
    complex_tower,
    real_ends,
    real_tower,
)
from gainproof.derive.steady_state.towers import rational

DISCRIMINANT = (ALPHA + BETA) ** 2 - 4 * BETA
FIRST, SECOND = real("first_pole"), real("second_pole")
RE, IM = real("pole_real"), real("pole_imaginary")


def pole_towers(c: Context) -> tuple[Tower, ...]:
    """The towers of both sides; none where the poles are never real."""
    return () if c.e == 1 else (complex_tower(c.e, c.n), real_tower(c.e, c.n))


def pole_steps(c: Context) -> list[Step]:
    """Sign of the discriminant, then the poles on each side of its zero."""
    if c.e == 1:
        return _never_real(c)
    limit = rational(8 / (1 - c.e))
    return [
        Step(
            "discriminant",
            f"The poles are complex below Lambda = {limit}, double there and real above.",
            same_sign(DISCRIMINANT, INDEX - limit),
            f"The discriminant of c(z) is a positive multiple of Lambda - {limit}.",
            hint={
                "form": (1 - rational(c.e)) ** 2
                * (INDEX + limit)
                / (16 * (c.basis.rho * DEVIATION) ** 2)
            },
        ),
        *_complex(c, limit),
        *_real(c, limit),
    ]


def _never_real(c: Context) -> list[Step]:
    width = poles.half_width(c.basis, None, None)
    return [
        Step(
            "discriminant",
            "The poles are complex for every index.",
            positive(-DISCRIMINANT),
            "The discriminant of c(z) is negative.",
            hint={"form": 4 * width**2},
        ),
        Step(
            "poles",
            "The poles are z = (2 - alpha - beta)/2 -+ i w, with this w.",
            equal(-DISCRIMINANT / 4, width**2),
            "Solve the quadratic c(z) = 0.",
        ),
        Step(
            "pole-modulus",
            "Their modulus is one over the innovation's standard deviation.",
            equal(1 - ALPHA, 1 / DEVIATION**2),
            "The product of the poles is c(0).",
        ),
    ]


def _complex(c: Context, limit: sp.Rational) -> list[Step]:
    name = "complex_poles"
    return [
        Step(
            "complex-range",
            f"Below the turning index put Lambda = {limit} x^2/(1 + x^2).",
            increasing_onto(INDEX, sp.Integer(0), limit, variable="x"),
            f"Increasing in x, from 0 to {limit}.",
            tower=name,
            hint={"form": 2 * limit * X / SIDE**2, "ends": complex_ends(c.e)},
        ),
        Step(
            "complex-poles",
            "There the poles are Re z -+ i Im z with sum 2 - alpha - beta and product 1 - alpha.",
            equal(
                sp.ImmutableDenseMatrix([[2 * RE, RE**2 + IM**2]]),
                sp.ImmutableDenseMatrix([[2 - ALPHA - BETA, 1 - ALPHA]]),
            ),
            "Coefficients of c(z).",
            tower=name,
        ),
    ]


def _real(c: Context, limit: sp.Rational) -> list[Step]:
    name = "real_poles"
    return [
        Step(
            "real-range",
            f"From the turning index on put Lambda = {limit} + g^2.",
            increasing_onto(INDEX, limit, "infinity", variable="g"),
            f"Increasing in g, from {limit} without bound.",
            tower=name,
            hint={"form": 2 * G, "ends": real_ends(c.e)},
        ),
        Step(
            "real-poles",
            "There both poles are real and negative, with sum 2 - alpha - beta and product "
            "1 - alpha.",
            equal(
                sp.ImmutableDenseMatrix([[FIRST + SECOND, FIRST * SECOND]]),
                sp.ImmutableDenseMatrix([[2 - ALPHA - BETA, 1 - ALPHA]]),
            ),
            "Coefficients of c(z); the larger modulus is a sum of positive terms.",
            tower=name,
        ),
        Step(
            "real-distance",
            "The square of their distance is the discriminant: both meet at the turning index.",
            equal((SECOND - FIRST) ** 2, DISCRIMINANT),
            "(z1 + z2)^2 - 4 z1 z2.",
            tower=name,
        ),
    ]
