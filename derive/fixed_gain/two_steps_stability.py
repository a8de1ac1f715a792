"""Steps on the stability of alpha-beta filters: the region, both ways, its borders, the poles."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.steps_answer import Z
from gainproof.derive.fixed_gain.steps_filter import EQUATIONS
from gainproof.derive.fixed_gain.two_towers import LOOP, A, B, X, Y
from gainproof.derive.relation import Relation, equal, positive

ALPHA, BETA = LOOP.gains
MARGIN = 4 - 2 * ALPHA - BETA
S = real("s")
GAINS = ("alpha", "beta")


def stability_steps() -> list[Step]:
    """0 < alpha, 0 < beta < 4 - 2 alpha, as an equivalence."""
    return [*_region(), *_necessary(), *_outside()]


def _region() -> list[Step]:
    inserted = (1 - S) ** 2 * sp.Subs(LOOP.polynomial(Z), Z, (1 + S) / (1 - S))
    return [
        Step(
            "half-plane",
            "The disc of stable roots becomes a half-plane by `z = (1 + s)/(1 - s)`.",
            equal(inserted, BETA + 2 * ALPHA * S + MARGIN * S**2, free=("s", "z", *GAINS)),
            "Insert and expand; `|z| < 1` is where the real part of `s` is negative.",
            tower=EQUATIONS,
            heading="Stability",
        ),
        Step(
            "coordinates",
            "Hence two coordinates: the coefficients over the first. With `x > 0` and `y > 0` they "
            "are all filters with `alpha > 0` and `0 < beta < 4 - 2 alpha`, each once.",
            equal(row(X, Y), row(2 * ALPHA / BETA, MARGIN / BETA)),
            "`beta = 4/(1 + x + y)` and `alpha = 2 x/(1 + x + y)`, as the three coefficients of "
            "step @half-plane add up to 4.",
        ),
        joined(
            "gains-of-coordinates",
            equal(row(ALPHA, BETA), row(2 * X / (1 + X + Y), 4 / (1 + X + Y))),
        ),
        joined("alpha-positive", positive(ALPHA)),
        joined("beta-positive", positive(BETA)),
        joined("margin-positive", positive(MARGIN)),
        Step(
            "stable",
            "All of these are stable.",
            Relation("stable", {"model": LOOP.model, "gain": list(GAINS)}),
            "The Schur-Cohn quantities of `c(z)` are positive.",
        ),
    ]


def _necessary() -> list[Step]:
    first, second = real("first_root"), real("second_root")
    u, v = real("root_real"), real("root_imaginary")
    return [
        Step(
            "real-roots",
            "And no others are. Two real roots between -1 and 1 are `(1 - a)/(1 + a)` and `(1 - "
            "b)/(1 + b)` with `a = (1 - z)/(1 + z)` and likewise `b`, both above zero.",
            equal((Z - first) * (Z - second), LOOP.polynomial(Z), free=("z",)),
            "A polynomial is the product of its roots' factors.",
            tower="real_roots",
        ),
        Step(
            "real-roots-alpha",
            "They give gains that satisfy all three inequalities.",
            positive(ALPHA),
            "Without a minus sign in `a` and `b`.",
            tower="real_roots",
        ),
        joined("real-roots-beta", positive(BETA), tower="real_roots"),
        joined("real-roots-margin", positive(MARGIN), tower="real_roots"),
        Step(
            "complex-roots",
            "A pair `u + i v`, `u - i v` inside the unit circle comes from `s = -a + i b` and its "
            "conjugate with `a > 0` and `b > 0`.",
            equal((Z - u) ** 2 + v**2, LOOP.polynomial(Z), free=("z",)),
            "As step @real-roots.",
            tower="complex_roots",
        ),
        joined("complex-roots-inside", positive(1 - u**2 - v**2), tower="complex_roots"),
        joined(
            "complex-roots-half-plane",
            equal(row(-A, B), _back(u, v)),
            tower="complex_roots",
        ),
        Step(
            "complex-roots-alpha",
            "It satisfies them too. So stable is the same as `0 < alpha` and `0 < beta < 4 - 2 "
            "alpha`, as the lecture has it; `alpha < 1` is not asked for.",
            positive(ALPHA),
            "Without a minus sign again. A real quadratic has two real roots or such a pair.",
            tower="complex_roots",
        ),
        joined("complex-roots-beta", positive(BETA), tower="complex_roots"),
        joined("complex-roots-margin", positive(MARGIN), tower="complex_roots"),
    ]


def _back(u: sp.Expr, v: sp.Expr) -> sp.ImmutableDenseMatrix:
    """Real and imaginary part of s = (z - 1)/(z + 1)."""
    below = (u + 1) ** 2 + v**2
    return row((u**2 + v**2 - 1) / below, 2 * v / below)


def _outside() -> list[Step]:
    return [
        Step(
            "witness",
            "Which root leaves the disc: with `beta <= 0` there is a real root of 1 or more, with "
            "`beta >= 4 - 2 alpha` one of -1 or less, with `alpha <= 0` the roots' product is 1 or "
            "more.",
            equal(
                row(*(sp.Subs(LOOP.polynomial(Z), Z, sp.Integer(z)) for z in (1, -1, 0))),
                row(BETA, MARGIN, 1 - ALPHA),
                free=("z", *GAINS),
            ),
            "`c(1)`, `c(-1)` and `c(0)`: far out on both sides `c` is positive, so that it has a "
            "root where its value at 1 or -1 is not.",
            tower=EQUATIONS,
        ),
        Step(
            "discriminant",
            "Inside: the roots are real, equal or complex as `(alpha + beta)^2` is above `4 beta`, "
            "equal to it or below, which is `x^2` against `4 y`.",
            equal(
                (ALPHA + BETA) ** 2 - 4 * BETA,
                sp.Rational(1, 4) * BETA**2 * (X**2 - 4 * Y),
            ),
            "The discriminant of `c(z)`.",
            heading="Poles",
        ),
        joined(
            "discriminant-of-polynomial",
            equal(
                (ALPHA + BETA) ** 2 - 4 * BETA,
                (2 - ALPHA - BETA) ** 2 - 4 * (1 - ALPHA),
                free=GAINS,
            ),
            tower=EQUATIONS,
        ),
        Step(
            "double-root",
            "On the border, `y = x^2/4`, both are `(x - 2)/(x + 2)`.",
            equal(LOOP.polynomial(Z), (Z - (X - 2) / (X + 2)) ** 2, free=("z",)),
            "Insert.",
            tower="double_root",
        ),
        Step(
            "modulus",
            "A complex pair has the modulus `sqrt(1 - alpha)`; so it needs `alpha < 1`.",
            equal(
                real("root_real") ** 2 + real("root_imaginary") ** 2,
                1 - ALPHA,
            ),
            "The last coefficient of `c(z)`.",
            tower="complex_roots",
        ),
    ]
