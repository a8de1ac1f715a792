"""Steps that prove the steady state: residuals, factorisation, stability, uniqueness, forms."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import Relation, cited, equal
from gainproof.derive.source import RICCATI
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    CROSS,
    DELTA,
    INDEX,
    PREDICTED,
    RATIO,
    REST,
    SIGMA,
    UPDATED,
    Z,
    gain_matrix,
)
from gainproof.derive.vector_measurement.spectrum import V
from gainproof.derive.vector_measurement.steps_entries import P11, P12, P22, U11, U12, U22
from gainproof.derive.vector_measurement.steps_spectrum import one_end_text
from gainproof.derive.vector_measurement.steps_ties import riccati_step, square, stable_step
from gainproof.derive.vector_measurement.towers import rational

K11, K12, K21, K22 = gain_matrix()


def proof_steps(c: Context) -> list[Step]:
    """The Riccati equation, stability, definiteness and uniqueness."""
    v = 2 - Z - 1 / Z
    one_end = one_end_text(c)
    w, level = ("`w`, ", "@level, ") if c.noise.determinant else ("", "")
    roots = f"{w}`eta` and `delta` (steps {level}@at-minus-one and @delta)"
    return [
        riccati_step(
            c,
            "riccati",
            "main",
            sentence="So far we assumed that there is a steady state and found what it must be. "
            "Now the proof: these `K`, `P` and `U` satisfy the equations of the filter.",
            reason="Insert the entries: the difference of both sides is in every entry a "
            f"combination of the equations that define {roots}, and so zero.",
            heading="The proof that this is the steady state",
        ),
        Step(
            "factorisation",
            "With this gain the spectrum is what step @at-one took it for.",
            equal(
                c.spectrum.polynomial.subs(V, v),
                SIGMA**2 * c.closed_loop * c.closed_loop.subs(Z, 1 / Z),
                free=("z",),
            ),
            "Both sides agree for every `z`.",
        ),
        stable_step(
            c,
            "stable",
            "main",
            sentence="Both poles lie inside the unit circle for all positive `Lambda` and `S`, so "
            "the errors of a start die out.",
            reason="For a quadratic `c(z)` that starts with `z^2` it is enough that `1 - c(0)`, "
            "`1 + c(0)`, `c(1)` and `c(-1)` are positive. They are `delta`, `m`, "
            f"`{one_end}` and `eta`, each over `sigma`.",
        ),
        *_definite(c),
        Step(
            "uniqueness",
            "So this is the steady state: no other solution of the Riccati equation stabilises.",
            cited(
                "A discrete algebraic Riccati equation has at most one stabilising solution.",
                RICCATI.text(),
            ),
            "`P` is one, by steps @riccati and @stable. The theorem is cited, not proved here.",
        ),
    ]


def _definite(c: Context) -> list[Step]:
    step = CROSS / SIGMA * 2 + _rate(c) + rational(c.noise.first) * INDEX**2
    predicted, updated = (
        (
            Relation("positive_definite", {"matrix": square(entries)}),
            {"minors": [corner, RATIO**2 * REST * power]},
        )
        for entries, corner, power in (
            (PREDICTED, (REST + step * SIGMA) / DELTA, SIGMA),
            (UPDATED, (REST + step / SIGMA) / DELTA, 1 / SIGMA),
        )
    )
    return [
        Step(
            "definite-predicted",
            "Both covariances are positive definite for all positive `Lambda` and `S`.",
            predicted[0],
            "The first entries (step @position) and the determinants, `det P = S^2 g sigma` and "
            "`det U = S^2 g/sigma` (steps @rest and @at-zero), are sums without a minus sign.",
            hint=predicted[1],
        ),
        joined("definite-updated", updated[0], hint=updated[1]),
    ]


def _rate(c: Context) -> sp.Expr:
    """U22 without a subtraction."""
    if not c.noise.interval:
        return DELTA * CROSS
    return (RATIO**2 * REST + INDEX**2 / SIGMA) / DELTA


def form_steps(c: Context) -> list[Step]:
    """Every entry and gain without a subtraction."""
    n, area = rational(c.noise.n), INDEX**2
    step = 2 * U12 + U22 + rational(c.noise.first) * area
    entries = {
        U12: CROSS / SIGMA,
        U22: _rate(c),
        U11: (REST + step / SIGMA) / DELTA,
        P11: (REST + step * SIGMA) / DELTA,
        P12: CROSS * SIGMA,
        P22: DELTA * CROSS + (1 - n) * area,
    }
    velocity = "@velocity-from-cross" + (", @velocity-from-rest" if c.noise.interval else "")
    return [
        Step(
            "result",
            "The result. `sigma`, `delta`, `kappa`, `h` and `g` are sums, products, quotients and "
            "roots of positive terms, and so is every entry. No two computed numbers are "
            "subtracted, so no digit cancels in a computer.",
            equal(
                sp.ImmutableDenseMatrix([list(entries)]),
                sp.ImmutableDenseMatrix([list(entries.values())]),
            ),
            f"Collected from steps @cross, {velocity} and @position. The gains follow by step "
            "@gain.",
            heading="The steady state",
        ),
        Step(
            "first-from-determinant",
            "The position's own gain follows from the other three too, again without a "
            "subtraction. With these fewer operations it is computed.",
            equal(K11, (REST / SIGMA + K21 * K12) / K22),
            "Written with `K = U R^-1`, `det K` is `det U/S^2`, which is `g/sigma` (step @rest): "
            "solve `det K = K11 K22 - K12 K21` for `K11`.",
        ),
    ]
