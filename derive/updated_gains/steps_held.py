"""Steps on updated gains against held ones: which is nearer to the exact gains, and until where."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.relation import equal, limit, positive, same_sign
from gainproof.derive.updated_gains.names import (
    ALPHA,
    ALPHA_EXCESS,
    BETA,
    BETA_EXCESS,
    FIRST_ALPHA,
    FIRST_BETA,
    INDEX,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    E,
    N,
)
from gainproof.derive.updated_gains.towers import BOUNDS, S, U

STEP = INDEX - NOMINAL
ALPHA_BOUND, BETA_BOUND = real("alpha_bound"), real("beta_bound")


def held_steps() -> list[Step]:
    """The comparison of gains, its bounds, and their limits."""
    return [*_against_held(), *_bounds(), *_ends()]


def _against_held() -> list[Step]:
    alpha = N**2 + 3 * N + N * E - E - E**2
    beta = N + E + 2 * N * E - E**2
    return [
        Step(
            "falling-between",
            "Against the nominal gains held: where the index falls, the updated gain is between "
            "the nominal and the exact one, and so always nearer.",
            same_sign(NOMINAL_ALPHA - FIRST_ALPHA, -STEP),
            "Steps @first-order and @never-below.",
            heading="Against gains that are held",
        ),
        joined("falling-between-beta", same_sign(NOMINAL_BETA - FIRST_BETA, -STEP)),
        Step(
            "rising-alpha",
            "Where the index grows, the held `alpha` is too small and the updated one too large. "
            "The updated one is nearer where this difference of distances is positive:",
            same_sign((ALPHA - NOMINAL_ALPHA) - ALPHA_EXCESS, STEP * alpha),
            "Step @excess; all but these factors is positive.",
        ),
        Step(
            "rising-beta",
            "And `beta`, likewise:",
            same_sign((BETA - NOMINAL_BETA) - BETA_EXCESS, STEP * beta),
            "As before.",
        ),
    ]


def _bounds() -> list[Step]:
    alpha, beta = real("alpha_place"), real("beta_place")
    index = real("nominal_index")
    return [
        Step(
            "alpha-bound",
            "The factor of `alpha` in step @rising-alpha has one positive root in `e`, `e_alpha`, "
            "over `s = sqrt(5 n^2 + 10 n + 1)`, and is positive below it:",
            equal(
                N**2 + 3 * N + N * E - E - E**2,
                (alpha - E) * (E + (S - N + 1) / 2),
                free=("e",),
            ),
            "Multiply out; `s > n`, so that the other root is negative.",
            tower=BOUNDS,
        ),
        joined("alpha-place", equal(alpha, (S + N - 1) / 2), tower=BOUNDS),
        joined(
            "alpha-bound-other",
            positive(S - N + 1),
            tower=BOUNDS,
            hint={"form": (4 * N**2 + 10 * N + 1) / (S + N) + 1},
        ),
        joined(
            "alpha-place-beyond",
            positive(alpha - N),
            tower=BOUNDS,
            hint={"form": 2 * N * (N + 2) / (S + N + 1)},
        ),
        Step(
            "beta-bound",
            "That of `beta` has `e_beta`, over `u = sqrt(4 n^2 + 8 n + 1)`:",
            equal(
                N + E + 2 * N * E - E**2,
                (beta - E) * (E + (U - 2 * N - 1) / 2),
                free=("e",),
            ),
            "Multiply out; `u > 2 n + 1`.",
            tower=BOUNDS,
        ),
        joined("beta-place", equal(beta, (U + 2 * N + 1) / 2), tower=BOUNDS),
        joined(
            "beta-bound-other",
            positive(U - 2 * N - 1),
            tower=BOUNDS,
            hint={"form": 4 * N / (U + 2 * N + 1)},
        ),
        Step(
            "bound-indices",
            "As indices:",
            equal(
                row(ALPHA_BOUND, BETA_BOUND),
                row(*(2 * place**2 / (1 + place) for place in (alpha, beta))),
            ),
            "Step @gains at these places.",
            tower=BOUNDS,
        ),
        joined("bounds-nominal", equal(index, 2 * N**2 / (1 + N)), tower=BOUNDS),
        Step(
            "beta-longer",
            "The `beta` of the update stays the better one for longer than its `alpha`.",
            positive(beta - alpha),
            "`u - s + n + 2` is positive, as `u + n + 2 > s`.",
            tower=BOUNDS,
            hint={"form": ((U + N + 2) ** 2 - S**2) / (2 * (U + N + 2 + S))},
        ),
    ]


ENDS = {
    "0": End(constants={}, boundary={"s": sp.Integer(1), "u": sp.Integer(1), "v": sp.Integer(2)}),
    "infinity": End(
        weights={"s": 1, "u": 1, "v": 1},
        constants={"root_5": 5},
        boundary={"s": real("root_5"), "u": sp.Integer(2), "v": real("root_5")},
    ),
}


def tends(name: str, expression: sp.Expr, point: str, value: sp.Expr | int | str) -> Step:
    at = value if isinstance(value, str) else sp.sympify(value)
    return joined(
        name,
        limit(expression, point, at, variable="nominal_index"),
        tower=BOUNDS,
        hint={"ends": ENDS},
    )


def _ends() -> list[Step]:
    alpha, beta = ALPHA_BOUND / NOMINAL, BETA_BOUND / NOMINAL
    rise = (S + N - 1) / (2 * N)
    golden = (1 + sp.sqrt(5)) / 2
    first = tends("alpha-bound-small", alpha, "0", 9)
    return [
        Step(
            first.id,
            "Over the nominal index the bound of `alpha` goes from 9 at small indices to `(1 + "
            "sqrt(5))/2` at large ones, that of `beta` from infinity to 2.",
            first.relation,
            "Leading powers of `n`.",
            tower=BOUNDS,
            hint={**first.hint, "limit_form": _rising_form()},
        ),
        tends("alpha-bound-large", alpha, "infinity", golden),
        tends("beta-bound-small", beta, "0", "infinity"),
        tends("beta-bound-large", beta, "infinity", 2),
        joined("alpha-bound-rise", equal(rise, (1 + (5 * N + 10) / (S + 1)) / 2), tower=BOUNDS),
    ]


def _rising_form() -> sp.Expr:
    """The ratio of alpha's bound without a difference."""
    rise = (1 + (5 * N + 10) / (S + 1)) / 2
    return rise**2 * 2 * (1 + N) / (S + N + 1)
