"""Steps on the covariances and the proof that they are the steady state."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, cited, equal
from gainproof.derive.source import RICCATI
from gainproof.derive.steady_state import covariance_forms
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, PREDICTED, UPDATED
from gainproof.derive.steady_state.steps_gains import eta_text
from gainproof.derive.steady_state.towers import rational


def _names(entries: tuple[str, str, str]) -> list[list[str]]:
    first, cross, second = entries
    return [[first, cross], [cross, second]]


def covariance_steps(c: Context) -> list[Step]:
    """Predicted and updated covariance in terms of the gains, then as stable forms."""
    m11, m12, m22 = map(real, PREDICTED)
    x11, x12, x22 = map(real, UPDATED)
    n = rational(c.n)
    stable = {
        **covariance_forms.predicted_covariance(c.basis),
        **covariance_forms.updated_covariance(c.basis),
    }
    first, *others = (
        (f"stable-{name.replace('_', '-')}", equal(real(name), stable[name]))
        for name in (*PREDICTED, "updated_22")
    )
    return [
        Step(
            "predicted-covariance",
            "The covariance of the predicted state's error is `M`, that of the updated state's "
            "error `X`; their entries are `M11`, `M12`, `M22` and `X11`, `X12`, `X22`. The gains "
            "give them all.",
            equal(
                _row(m11, m12, m22),
                _row(
                    ALPHA / (1 - ALPHA),
                    BETA / (1 - ALPHA),
                    BETA * (ALPHA + (1 - n) * BETA) / (1 - ALPHA),
                ),
            ),
            "`K = M H'/(H M H' + R)`, where `H M H' + R = sigma^2`, gives the first column of `M` "
            "(step @variance), `X = (I - K H) M` that of `X`; entry 12 of "
            "`M = F X F' + Lambda^2 Q0` gives `X22` and entry 22 `M22`, with `Lambda^2` from step "
            "@noise-ratio.",
            heading="The covariances",
        ),
        joined(
            "updated-covariance",
            equal(_row(x11, x12, x22), _row(ALPHA, BETA, BETA * (ALPHA - n * BETA) / (1 - ALPHA))),
        ),
        Step(
            first[0],
            "The same entries without a subtraction of computed numbers.",
            first[1],
            f"Insert steps @stable-gains and @variance: `M11 = rho Lambda sigma`, `M12 = Lambda "
            f"sigma`, `M22 = X22 + Lambda^2` and {_velocity_text(c.n)}.",
        ),
        *(joined(name, relation) for name, relation in others),
    ]


def _velocity_text(n: Fraction) -> str:
    """X22 in a sentence; n = Q12/Q22."""
    if n == 0:
        return "`X22 = Lambda^2 rho`"
    half = "`rho - 1/2 = (rho^2 - 1/4)/(rho + 1/2)`"
    if n == Fraction(1, 2):
        return f"`X22 = Lambda^2 (rho - 1/2)`, where {half}"
    return (
        f"`X22 = Lambda^2 (rho - {n})`, where `rho - {n} = {1 - 2 * n} rho + {2 * n} (rho - 1/2)` "
        f"and {half}"
    )


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([entries])


def proof_steps(c: Context) -> list[Step]:
    """The Riccati equation, stability, definiteness and uniqueness."""
    model: dict[str, Any] = c.model_data
    roots = "`eta` and `s` (steps @eta and @root-s)" if c.e else "`s` (step @root-s)"
    predicted, updated = (
        Relation("positive_definite", {"matrix": _names(entries)})
        for entries in (PREDICTED, UPDATED)
    )
    return [
        Step(
            "riccati",
            "So far we assumed that there is a steady state and found what it must be. Now the "
            "proof: these `K`, `M` and `X` satisfy the equations of the Kalman filter.",
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
            "Insert the entries: the difference of both sides is in every entry a combination of "
            f"the equations that define {roots}, and so zero.",
            heading="The proof that this is the steady state",
        ),
        Step(
            "stable",
            "Both poles lie inside the unit circle for every positive index, so the errors of a "
            "start die out.",
            Relation("stable", {"model": model, "gain": ["alpha", "beta"]}),
            "For a quadratic `c(z)` that starts with `z^2` it is enough that `1 - c(0)`, `c(1)` "
            f"and `c(-1)` are positive. They are `alpha`, `beta` and `{eta_text(c.e)}/sigma`.",
        ),
        Step(
            "definite-predicted",
            "Both covariances are positive definite for every positive index.",
            predicted,
            "The first entry and the determinant are quotients of sums without a minus sign.",
        ),
        joined("definite-updated", updated),
        Step(
            "uniqueness",
            "So this is the steady state: no other solution of the Riccati equation stabilises.",
            cited(
                "A discrete algebraic Riccati equation has at most one stabilising solution.",
                RICCATI.text(),
            ),
            "`M` is one, by steps @riccati and @stable. The theorem is cited, not proved here.",
        ),
    ]
