"""Steps on the variances of a filter that follows the index to first order, against held gains."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import product, row, symmetric, total
from gainproof.derive.model import ScaledModel
from gainproof.derive.relation import Relation, equal, positive, same_sign
from gainproof.derive.updated_gains.forms import gains_of, index_of, slopes_of
from gainproof.derive.updated_gains.names import (
    ALPHA_SLOPE,
    BETA_SLOPE,
    FIRST_ALPHA,
    FIRST_BETA,
    INDEX,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    RATIO,
    K,
    N,
)
from gainproof.derive.updated_gains.steps_held import tends
from gainproof.derive.updated_gains.steps_mismatch import held_equations, with_gains
from gainproof.derive.updated_gains.towers import BOUNDS, WITHIN, V

BOUND = real("variance_ratio")
SIGN = 1 + RATIO * (1 + 2 / N) - RATIO**2
REST = NOMINAL**2 + 2 * INDEX * N * (2 + N) / (1 + N) - INDEX**2


def followed_steps(model: ScaledModel) -> list[Step]:
    """The covariances of the updated filter, when they are below the held one's, until where."""
    return [*_within(model), *_covariances(), *_against(), *_bound()]


def _quiet(name: str, relation: Relation) -> Step:
    return Step(name, "What the names mean.", relation, "As before.", tower=WITHIN, shown=False)


def _within(model: ScaledModel) -> list[Step]:
    gains = ["first_order_alpha", "first_order_beta"]
    step = INDEX - NOMINAL
    return [
        Step(
            "within",
            "Now first-order gains at the index `Lambda`. As long as they are stable (step "
            "@unstable), `Lambda` is below `4 n`, and any such index has one `k > 0`.",
            equal(row(INDEX, NOMINAL), row(4 * N * K / (1 + K), index_of(N))),
            "`2 n (2 + n)/(1 + n)` more than `2 n^2/(1 + n)` is `4 n`.",
            tower=WITHIN,
            heading="Updated gains against held ones: the variances",
        ),
        _quiet("within-gains", equal(row(NOMINAL_ALPHA, NOMINAL_BETA), row(*gains_of(N)))),
        _quiet("within-slopes", equal(row(ALPHA_SLOPE, BETA_SLOPE), row(*slopes_of(N)))),
        joined(
            "within-first-order",
            equal(
                row(FIRST_ALPHA, FIRST_BETA),
                row(NOMINAL_ALPHA + ALPHA_SLOPE * step, NOMINAL_BETA + BETA_SLOPE * step),
            ),
            tower=WITHIN,
        ),
        Step(
            "within-stable",
            "There the filter is stable,",
            Relation("stable", {"model": model.data(), "gain": gains}),
            "The Schur-Cohn quantities are positive.",
            tower=WITHIN,
        ),
    ]


def _covariances() -> list[Step]:
    before, after = symmetric("followed_predicted", 2), symmetric("followed_updated", 2)
    closed, rest, moved, column, noise = with_gains(FIRST_ALPHA, FIRST_BETA)
    first, second = (
        replace(step, id=f"within-{step.id}", tower=WITHIN, shown=False, joins=False, heading="")
        for step in held_equations()
    )
    return [
        Step(
            "followed",
            "and its errors have the covariances `S` and `Z`, as in step @held.",
            equal(before, total(product(closed, before, closed.T), moved, noise)),
            "Insert.",
            tower=WITHIN,
        ),
        joined(
            "followed-updated",
            equal(after, total(product(rest, before, rest.T), product(column, column.T))),
            tower=WITHIN,
        ),
        replace(first, sentence="The same of held gains.", reason="Insert."),
        replace(second, sentence="The same of held gains.", reason="Insert."),
    ]


def _against() -> list[Step]:
    def gained(kind: str, ij: str) -> Step:
        entry = real(f"held_{kind}_{ij}") - real(f"followed_{kind}_{ij}")
        return joined(
            f"followed-{kind}-{ij}",
            same_sign(entry, (INDEX - NOMINAL) ** 2 * REST),
            tower=WITHIN,
        )

    first = gained("updated", "11")
    return [
        Step(
            first.id,
            "What the update gains against held gains has one sign for the positions and the "
            "velocities, before and after the measurement:",
            first.relation,
            "Subtract; all but these factors is positive.",
            tower=WITHIN,
        ),
        *(gained(kind, ij) for kind, ij in (("updated", "22"), ("predicted", "11"))),
        gained("predicted", "22"),
        _quiet("within-ratio", equal(RATIO, INDEX / NOMINAL)),
    ]


def _bound() -> list[Step]:
    ratio = BOUND
    return [
        Step(
            "followed-ratio",
            "With the ratio `c` of `Lambda` to the nominal index, as in step @held-predicted, the "
            "last factor is the square of the nominal index times a quadratic of `c`:",
            equal(REST, NOMINAL**2 * SIGN),
            "`n (2 + n)/(1 + n)` is `1/2 + 1/n` times the nominal index.",
            tower=WITHIN,
        ),
        Step(
            "variance-bound",
            "So the update lowers all four variances while this ratio, if not 1, is below one "
            "number, `c_v`, and raises all four where it is above, as far as it is stable. Over "
            "`v = sqrt(5 n^2 + 4 n + 4)`:",
            equal(SIGN, (BOUND - RATIO) * (RATIO + 1 / BOUND), free=(str(RATIO),)),
            "The quadratic's roots have the product -1 and the sum `1 + 2/n`, which is `sqrt(1 + "
            "8/Lambda_0)`.",
            tower=BOUNDS,
        ),
        joined("variance-bound-value", equal(ratio, (N + 2 + V) / (2 * N)), tower=BOUNDS),
        joined("variance-bound-ratio", equal(ratio - 1 / ratio, 1 + 2 / N), tower=BOUNDS),
        Step(
            "variance-bound-between",
            "The ratio `c_v` is beyond that from which on `alpha` exceeds 1, and below that at "
            "which the filter becomes unstable. So as long as the updated `alpha` is at most 1, it "
            "is better to update than to hold.",
            positive(ratio - (sp.Rational(3, 2) + 1 / N)),
            "`v > 2 n` and `v < 3 n + 2`.",
            tower=BOUNDS,
            hint={"form": (N**2 + 4 * N + 4) / ((V + 2 * N) * 2 * N)},
        ),
        joined(
            "variance-bound-stable",
            positive(2 + 2 / N - ratio),
            tower=BOUNDS,
            hint={"form": (4 * N**2 + 8 * N) / ((V + 3 * N + 2) * 2 * N)},
        ),
        tends("variance-bound-large", ratio, "infinity", (1 + sp.sqrt(5)) / 2),
        tends("variance-bound-small", ratio, "0", "infinity"),
    ]
