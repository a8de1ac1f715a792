"""Steps that prove the steady state: residuals, factorisation, stability, uniqueness, forms."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, cited, equal
from gainproof.derive.source import RICCATI
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    CROSS,
    DELTA,
    ETA,
    GAIN_ROWS,
    INDEX,
    MEAN,
    PREDICTED,
    RATIO,
    REST,
    SIGMA,
    UPDATED,
    Z,
)
from gainproof.derive.vector_measurement.spectrum import V
from gainproof.derive.vector_measurement.steps_entries import P11, P12, P22, U11, U12, U22
from gainproof.derive.vector_measurement.towers import rational


def _names(entries: tuple[str, str, str]) -> list[list[str]]:
    first, cross, second = entries
    return [[first, cross], [cross, second]]


def proof_steps(c: Context) -> list[Step]:
    """The Riccati equation, stability, definiteness and uniqueness."""
    gain = [list(row) for row in GAIN_ROWS]
    v = 2 - Z - 1 / Z
    step = CROSS / SIGMA * 2 + _rate(c) + rational(c.noise.first) * INDEX**2
    return [
        Step(
            "riccati",
            "Now the proof. P and U solve the equations of the filter, and K is their gain.",
            Relation(
                "riccati",
                {
                    "model": c.model_data,
                    "predicted": _names(PREDICTED),
                    "updated": _names(UPDATED),
                    "gain": gain,
                    "index": "tracking_index",
                },
            ),
            "Each residual is a combination of the relations that define the roots.",
            hint={"innovation": [real("predicted_11") + 1, SIGMA**2 * RATIO**2]},
        ),
        Step(
            "factorisation",
            "With this gain the spectrum is what was assumed of it.",
            equal(
                c.spectrum.polynomial.subs(V, v),
                SIGMA**2 * c.closed_loop * c.closed_loop.subs(Z, 1 / Z),
                free=("z",),
            ),
            "Both sides agree for every z.",
        ),
        Step(
            "stable",
            "Both poles lie inside the unit circle for all positive Lambda and S.",
            Relation("stable", {"model": c.model_data, "gain": gain}),
            "c(1), c(-1), 1 - c(0) and 1 + c(0) are Lambda w, eta, delta and m over sigma.",
            hint={
                "values": [
                    DELTA / SIGMA,
                    MEAN / SIGMA,
                    DELTA * ETA / SIGMA**2,
                    DELTA * INDEX * c.level / SIGMA**2,
                ]
            },
        ),
        *(
            Step(
                f"definite-{label}",
                f"The {label} covariance is positive definite for all positive Lambda and S.",
                Relation("positive_definite", {"matrix": _names(entries)}),
                "Its leading minors are positive: det U = S^2 g/sigma, det P = S^2 g sigma.",
                hint={"minors": [corner, RATIO**2 * REST * power]},
            )
            for label, entries, corner, power in (
                ("predicted", PREDICTED, (REST + step * SIGMA) / DELTA, SIGMA),
                ("updated", UPDATED, (REST + step / SIGMA) / DELTA, 1 / SIGMA),
            )
        ),
        Step(
            "uniqueness",
            "So this is the steady state: no other solution of the Riccati equation stabilises.",
            cited(
                "A discrete algebraic Riccati equation has at most one stabilising solution.",
                RICCATI.text(),
            ),
            "Cited, not proved here.",
        ),
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
    return [
        Step(
            "result",
            "The result. sigma, delta, kappa, h and g are sums, products, quotients and roots of "
            "positive terms, and so is every entry: computed like this no digit is lost.",
            equal(
                sp.ImmutableDenseMatrix([list(entries)]),
                sp.ImmutableDenseMatrix([list(entries.values())]),
            ),
            "Collected from the steps above.",
        )
    ]
