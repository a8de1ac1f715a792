"""Steps on the closed-loop poles: where they are complex, where real, and what they are."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step, joined
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
            f"The two poles are a complex pair while `Lambda` is below {limit}, meet at {limit} "
            "and are real beyond.",
            same_sign(DISCRIMINANT, INDEX - limit),
            "The left side is the discriminant of `c(z)` (step @closed-loop); in `rho` and `sigma` "
            f"it is a positive multiple of `Lambda - {limit}`.",
            hint={
                "form": (1 - rational(c.e)) ** 2
                * (INDEX + limit)
                / (16 * (c.basis.rho * DEVIATION) ** 2)
            },
            heading="The poles",
        ),
        *_complex(c, limit),
        *_real(c, limit),
    ]


def _never_real(c: Context) -> list[Step]:
    width = poles.half_width(c.basis, None, None)
    return [
        Step(
            "discriminant",
            "The two poles are a complex pair for every index.",
            positive(-DISCRIMINANT),
            "The discriminant of `c(z)` (step @closed-loop) is `(alpha + beta)^2 - 4 beta`, here "
            "`-4/(sigma rho)^2`.",
            hint={"form": 4 * width**2},
            heading="The poles",
        ),
        Step(
            "poles",
            "Their real part is `(2 - alpha - beta)/2`, their imaginary parts are `1/(sigma rho)` "
            "and `-1/(sigma rho)`.",
            equal(-DISCRIMINANT / 4, width**2),
            "Solve the quadratic `c(z) = 0`.",
        ),
        Step(
            "pole-modulus",
            "Their modulus is one over the standard deviation of the innovations.",
            equal(1 - ALPHA, 1 / DEVIATION**2),
            "The product of the poles is `c(0) = 1 - alpha`; step @variance.",
        ),
    ]


def _complex(c: Context, limit: sp.Rational) -> list[Step]:
    name = "complex_poles"
    return [
        Step(
            "complex-range",
            "",
            increasing_onto(INDEX, sp.Integer(0), limit, variable="x"),
            "",
            tower=name,
            hint={"form": 2 * limit * X / SIDE**2, "ends": complex_ends(c.e)},
            shown=False,
        ),
        Step(
            "complex-poles",
            f"Below {limit} write the poles as `a + i b` and `a - i b` with positive `b`. Their "
            "modulus is `1/sigma`.",
            equal(
                sp.ImmutableDenseMatrix([[2 * RE, RE**2 + IM**2]]),
                sp.ImmutableDenseMatrix([[2 - ALPHA - BETA, 1 - ALPHA]]),
            ),
            "Sum and product of the roots, from the coefficients of `c(z)`; `1 - alpha = "
            "1/sigma^2` by step @variance.",
            tower=name,
        ),
    ]


def _real(c: Context, limit: sp.Rational) -> list[Step]:
    name = "real_poles"
    return [
        Step(
            "real-range",
            "",
            increasing_onto(INDEX, limit, "infinity", variable="g"),
            "",
            tower=name,
            hint={"form": 2 * G, "ends": real_ends(c.e)},
            shown=False,
        ),
        Step(
            "real-poles",
            f"From {limit} on the poles are two negative numbers `z1` and `z2`. They start "
            "together, and the square of their distance is the discriminant.",
            equal(
                sp.ImmutableDenseMatrix([[FIRST + SECOND, FIRST * SECOND]]),
                sp.ImmutableDenseMatrix([[2 - ALPHA - BETA, 1 - ALPHA]]),
            ),
            "Sum and product from the coefficients of `c(z)`; `(z2 - z1)^2 = (z1 + z2)^2 - "
            "4 z1 z2`.",
            tower=name,
        ),
        joined("real-distance", equal((SECOND - FIRST) ** 2, DISCRIMINANT), name),
    ]
