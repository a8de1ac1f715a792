"""Steps that prove the steady state: covariances, residuals, stability, positivity, uniqueness."""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, cited, equal, increasing_onto, positive
from gainproof.derive.source import RICCATI
from gainproof.derive.steady_state import covariance_forms, forms
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, INDEX, PREDICTED, UPDATED
from gainproof.derive.steady_state.towers import rational


def _names(entries: tuple[str, str, str]) -> list[list[str]]:
    first, cross, second = entries
    return [[first, cross], [cross, second]]


def covariance_steps(c: Context) -> list[Step]:
    """Predicted and updated covariance in terms of the gains, then as stable forms."""
    m11, m12, m22 = map(real, PREDICTED)
    x11, x12, x22 = map(real, UPDATED)
    n = rational(c.n)
    steps = [
        Step(
            "predicted-covariance",
            "The predicted covariance in terms of the gains.",
            equal(
                sp.ImmutableDenseMatrix([[m11, m12, m22]]),
                sp.ImmutableDenseMatrix(
                    [
                        [
                            ALPHA / (1 - ALPHA),
                            BETA / (1 - ALPHA),
                            BETA * (ALPHA + (1 - n) * BETA) / (1 - ALPHA),
                        ]
                    ]
                ),
            ),
            "K = M H'/S gives the first column; the Riccati equation gives the last entry.",
        ),
        Step(
            "updated-covariance",
            "The updated covariance in terms of the gains.",
            equal(
                sp.ImmutableDenseMatrix([[x11, x12, x22]]),
                sp.ImmutableDenseMatrix([[ALPHA, BETA, BETA * (ALPHA - n * BETA) / (1 - ALPHA)]]),
            ),
            "X = (I - K H) M.",
        ),
    ]
    stable = {
        **covariance_forms.predicted_covariance(c.basis),
        **covariance_forms.updated_covariance(c.basis),
    }
    steps += [
        Step(
            f"stable-{name.replace('_', '-')}",
            f"{name.replace('_', ' ')} without a subtraction.",
            equal(real(name), stable[name]),
            "1/(1 - alpha) = sigma^2; rho - 1/2 is (rho^2 - 1/4)/(rho + 1/2).",
        )
        for name in (*PREDICTED, "updated_22")
    ]
    return steps


def proof_steps(c: Context) -> list[Step]:
    """The Riccati equation, stability, definiteness, uniqueness and the range of the gains."""
    model: dict[str, Any] = c.model_data
    largest = 2 / (1 + sp.sqrt(rational(c.e)))
    derivative = forms.gain_derivatives(c.basis)
    return [
        Step(
            "riccati",
            "M solves the Riccati equation, K is its gain and X its updated covariance.",
            Relation(
                "riccati",
                {
                    "model": model,
                    "predicted": _names(PREDICTED),
                    "updated": _names(UPDATED),
                    "gain": ["alpha", "beta"],
                    "index": "tracking_index",
                },
            ),
            "Each residual is a combination of the relations that define eta and s.",
        ),
        Step(
            "stable",
            "Both poles lie inside the unit circle for every positive index.",
            Relation("stable", {"model": model, "gain": ["alpha", "beta"]}),
            "Every Schur-Cohn quantity is a quotient of polynomials without a minus sign.",
        ),
        *(
            Step(
                f"definite-{label}",
                f"The {label} covariance is positive definite for every positive index.",
                Relation("positive_definite", {"matrix": _names(entries)}),
                "Its leading minors are quotients of polynomials without a minus sign.",
            )
            for label, entries in (("predicted", PREDICTED), ("updated", UPDATED))
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
        Step(
            "alpha-range",
            "The position gain grows with the index and takes every value between 0 and 1.",
            increasing_onto(ALPHA, sp.Integer(0), sp.Integer(1)),
            "Its derivative is positive; the limits close the range.",
            hint={"form": derivative["alpha"], "ends": c.ends},
        ),
        Step(
            "beta-range",
            "The velocity gain grows with the index and takes every value below its limit.",
            increasing_onto(BETA, sp.Integer(0), sp.radsimp(largest)),
            "Its derivative is positive; the limits close the range.",
            hint={"form": derivative["beta"], "ends": c.ends},
        ),
        Step(
            "rest",
            "What the position gain leaves to 1 is one over the innovation variance.",
            equal(1 - ALPHA, real("rest")),
            "1 - alpha = 1/sigma^2.",
        ),
        Step(
            "alpha-below-one",
            "The position gain stays below 1.",
            positive(1 - ALPHA),
            "1/sigma^2 is positive.",
        ),
        Step(
            "noise-ratio",
            "The gains give back the index.",
            equal(INDEX**2, BETA**2 / (1 - ALPHA)),
            "q noise(0) = sigma^2 c(1)^2, with q = Lambda^2.",
        ),
    ]
