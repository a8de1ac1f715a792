"""Steps on the stability of alpha-beta-gamma filters: the region, both ways, and the poles."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.steps_answer import Z
from gainproof.derive.fixed_gain.steps_filter import EQUATIONS
from gainproof.derive.fixed_gain.three_towers import LOOP, A, B, D, E, M, X
from gainproof.derive.relation import Relation, equal, positive

ALPHA, BETA, GAMMA = LOOP.gains
MARGIN = 4 - 2 * ALPHA - BETA
DETERMINANT = ALPHA * BETA - GAMMA * (1 - ALPHA / 2)
S, Y = real("s"), real("y")
GAINS = ("alpha", "beta", "gamma")
INEQUALITIES = {
    "alpha": ALPHA,
    "beta": BETA,
    "gamma": GAMMA,
    "margin": MARGIN,
    "determinant": DETERMINANT,
}


def stability_steps() -> list[Step]:
    """The lecture's inequalities, as an equivalence."""
    return [*_region(), *_necessary(), *_outside(), *_poles()]


def _region() -> list[Step]:
    inserted = (1 - S) ** 3 * sp.Subs(LOOP.polynomial(Z), Z, (1 + S) / (1 - S))
    return [
        Step(
            "half-plane",
            "The disc of stable roots becomes a half-plane by `z = (1 + s)/(1 - s)`.",
            equal(
                inserted,
                GAMMA + 2 * BETA * S + (4 * ALPHA - GAMMA) * S**2 + 2 * MARGIN * S**3,
                free=("s", "z", *GAINS),
            ),
            "Insert and expand; `|z| < 1` is where the real part of `s` is negative.",
            tower=EQUATIONS,
            heading="Stability",
        ),
        Step(
            "coordinates",
            "Hence three coordinates, the coefficients over the first, and `m = x y - d`. With "
            "`x`, "
            "`d` and `m` above zero they are all filters with `0 < gamma`, `0 < beta < 4 - 2 "
            "alpha` and `gamma (1 - alpha/2) < alpha beta`, each once.",
            equal(
                row(X, Y, D, M),
                row(
                    2 * BETA / GAMMA,
                    (4 * ALPHA - GAMMA) / GAMMA,
                    2 * MARGIN / GAMMA,
                    8 * DETERMINANT / GAMMA**2,
                ),
            ),
            "`gamma = 8/(1 + x + y + d)`, as the coefficients of step @half-plane add up to 8, and "
            "`y = (d + m)/x`.",
        ),
        joined("hurwitz", equal(M, X * Y - D)),
        joined(
            "gains-of-coordinates",
            equal(
                row(ALPHA, BETA, GAMMA),
                row(*(x / (1 + X + Y + D) for x in (2 * (1 + Y), 4 * X, sp.Integer(8)))),
            ),
        ),
        *(joined(f"{name}-positive", positive(value)) for name, value in INEQUALITIES.items()),
        Step(
            "alpha-needs-no-mention",
            "`0 < alpha` follows from the others.",
            equal(ALPHA, (DETERMINANT + GAMMA) / (BETA + GAMMA / 2), free=GAINS),
            "Solve for `alpha`.",
            tower=EQUATIONS,
        ),
        Step(
            "stable",
            "All of these are stable.",
            Relation("stable", {"model": LOOP.model, "gain": list(GAINS)}),
            "The Schur-Cohn quantities of `c(z)` are positive.",
        ),
    ]


def _necessary() -> list[Step]:
    first, second, third = map(real, ("first_root", "second_root", "third_root"))
    u, v = real("root_real"), real("root_imaginary")
    both = (("real-roots", "real_roots"), ("complex-roots", "complex_roots"))
    kept = {
        (prefix, name): joined(f"{prefix}-{name}", positive(value), tower=tower)
        for prefix, tower in both
        for name, value in INEQUALITIES.items()
    }
    below = (u + 1) ** 2 + v**2
    return [
        Step(
            "real-roots",
            "And no others are. Three real roots between -1 and 1 are `(1 - a)/(1 + a)` with "
            "`a > 0`, and so with `b` and `e`: they satisfy all the inequalities.",
            equal((Z - first) * (Z - second) * (Z - third), LOOP.polynomial(Z), free=("z",)),
            "A polynomial is the product of its roots' factors; no minus sign is left.",
            tower="real_roots",
        ),
        *(step for (prefix, _), step in kept.items() if prefix == "real-roots"),
        Step(
            "complex-roots",
            "One real root and a pair `u + i v`, `u - i v` inside the unit circle, which comes "
            "from "
            "`s = -b + i e` and its conjugate with `b > 0` and `e > 0`, do too. So the "
            "inequalities, which are the lecture's, are the same as stability.",
            equal((Z - first) * ((Z - u) ** 2 + v**2), LOOP.polynomial(Z), free=("z",)),
            "As before. A real cubic has three real roots or one and a pair.",
            tower="complex_roots",
        ),
        joined("complex-roots-inside", positive(1 - u**2 - v**2), tower="complex_roots"),
        joined(
            "complex-roots-half-plane",
            equal(row(-B, E), row((u**2 + v**2 - 1) / below, 2 * v / below)),
            tower="complex_roots",
        ),
        joined(
            "real-root-half-plane",
            equal(A, (1 - first) / (1 + first)),
            tower="complex_roots",
        ),
        *(step for (prefix, _), step in kept.items() if prefix == "complex-roots"),
    ]


def _outside() -> list[Step]:
    return [
        Step(
            "witness",
            "Which root leaves the disc: with `gamma <= 0` there is a real root of 1 or more, with "
            "`beta >= 4 - 2 alpha` one of -1 or less; on the border of the last inequality a pair "
            "is on the circle.",
            equal(
                row(*(sp.Subs(LOOP.polynomial(Z), Z, sp.Integer(z)) for z in (1, -1, 0))),
                row(GAMMA, -2 * MARGIN, ALPHA - 1),
                free=("z", *GAINS),
            ),
            "`c(1)`, `c(-1)` and `c(0)`: far out `c` has the sign of `z`, so that it has a root "
            "where its value at 1 or -1 has the other.",
            tower=EQUATIONS,
        ),
        Step(
            "hurwitz-border",
            "There, at `x y = d`, the half-plane's polynomial has the roots `s^2 = -x/d`.",
            equal(
                1 + X * S + Y * S**2 + X * Y * S**3,
                (1 + X * S) * (1 + Y * S**2),
                free=("s",),
            ),
            "Multiply out.",
        ),
    ]


def _poles() -> list[Step]:
    polynomial = sp.Poly(LOOP.polynomial(Z), Z)
    half_plane = X**2 * Y**2 - 4 * Y**3 - 4 * D * X**3 + 18 * D * X * Y - 27 * D**2
    return [
        Step(
            "discriminant",
            "The poles are all real where the discriminant is not negative, with a double one "
            "where "
            "it is 0, else one is real and two are complex:",
            equal(polynomial.discriminant(), GAMMA**4 / 64 * half_plane),
            "The discriminant of `c(z)`, and of `1 + x s + y s^2 + d s^3`.",
            heading="Poles",
        ),
    ]
