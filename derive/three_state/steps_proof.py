"""Steps on the covariances and the proof that they are the steady state."""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, cited, equal, positive
from gainproof.derive.source import RICCATI
from gainproof.derive.three_state import covariance_entries, shown_signs
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import (
    ALPHA,
    BETA,
    DELTA,
    DEVIATION,
    ETA,
    GAINS,
    GAMMA,
    PREDICTED,
    TAU,
    UPDATED,
    XI,
    rows,
)


def covariance_steps(c: Context) -> list[Step]:
    """Predicted and updated covariance: first rows by the gains, the others over xi and eta."""
    a1, a2, _ = c.numbers
    noise = c.model.process_noise
    predicted = covariance_entries.predicted(noise)
    updated = covariance_entries.updated(noise, a1)
    variance = DEVIATION**2
    first = [real(f"predicted_1{j}") for j in (1, 2, 3)]
    return [
        Step(
            "tau",
            "One more short name, `tau`; it is positive, though a difference.",
            equal(TAU, XI * ETA - DELTA),
            "Insert `2 delta xi = eta^2 - a2` and `xi^2 = a1 + 2 eta` with the numbers "
            f"`a1 = {a1}` and `a2 = {a2}` (step @three-equations).",
            heading="The covariances",
        ),
        joined("tau-positive-form", equal(TAU, (3 * ETA**2 + 2 * a1 * ETA + a2) / (2 * XI))),
        Step("positive-tau", "", positive(TAU), "", shown=False),
        Step(
            "predicted-covariance",
            "The covariance of the predicted state's error is `M`, that of the updated state's "
            "error `X`; their entries are `M11`, `M12`, `M13`, `M22`, `M23`, `M33` and `X11`, "
            "`X12`, `X13`, `X22`, `X23`, `X33`. The gains give the first row of both.",
            equal(
                sp.ImmutableDenseMatrix([first]),
                sp.ImmutableDenseMatrix([[ALPHA * variance, BETA * variance, GAMMA * variance]]),
            ),
            "`K = M H'/(H M H' + R)`, where `H M H' + R = sigma^2`; and `X = (I - K H) M`, where "
            "`1 - alpha = 1/sigma^2` (step @variance).",
        ),
        joined(
            "updated-covariance",
            equal(
                sp.ImmutableDenseMatrix([[real(f"updated_1{j}") for j in (1, 2, 3)]]),
                sp.ImmutableDenseMatrix([[ALPHA, BETA, GAMMA]]),
            ),
        ),
        Step(
            "predicted-33",
            "The other entries are `Lambda^2` times an expression in `xi`, `eta` and `tau`.",
            equal(real("predicted_33"), predicted["predicted_33"]),
            "Entries 23, 13 and 12 of `M = F X F' + Lambda^2 Q0` give `X33`, `X23` and `X22`, "
            "`X = M - K H M` the same entries of `M`. Write products of gains by step @gains: "
            "`sigma^2 beta gamma = Lambda^2 xi/2`, `4 sigma^2 alpha gamma = Lambda^2 (eta + 1)`, "
            "`8 sigma^2 alpha beta = Lambda^2 xi (eta + 1)`.",
        ),
        *(
            joined(name.replace("_", "-"), equal(real(name), form[name]))
            for form, name in (
                (predicted, "predicted_23"),
                (predicted, "predicted_22"),
                (updated, "updated_33"),
                (updated, "updated_23"),
                (updated, "updated_22"),
            )
        ),
    ]


def proof_steps(c: Context) -> list[Step]:
    """The Riccati equation, stability, definiteness and uniqueness."""
    model: dict[str, Any] = c.model_data
    return [
        Step(
            "riccati",
            "So far we assumed that there is a steady state and found what it must be. Now the "
            "proof: these `K`, `M` and `X` satisfy the equations of the Kalman filter.",
            Relation(
                "riccati",
                {
                    "model": model,
                    "predicted": rows("predicted"),
                    "updated": rows("updated"),
                    "gain": list(GAINS),
                    "index": "tracking_index",
                },
            ),
            "Insert the entries over `p`: the difference of both sides vanishes in every entry, "
            "by no more than the squares of the roots that occur.",
            heading="The proof that this is the steady state",
        ),
        Step(
            "stable",
            "All poles lie inside the unit circle for every positive index, so the errors of a "
            "start die out.",
            Relation("stable", {"model": model, "gain": list(GAINS)}),
            "The test of Schur and Cohn: the three pairs of numbers that it forms from "
            "`c(z) = z^3 + c2 z^2 + c1 z + c0` are positive. They are `1 - c0` and `1 + c0`; with "
            "`d = 1 - c0^2` and `f = c1 - c0 c2` then `d - f` and `d + f`; with `e = c2 - c0 c1` "
            "at last `(d - f)(d + f - e)` and `(d - f)(d + f + e)`. (In the half plane it is that "
            "of Hurwitz: `xi`, `eta`, `delta` and `tau` are positive.)",
            hint=shown_signs.schur_cohn(c),
        ),
        Step(
            "definite-predicted",
            "Both covariances are positive definite for every positive index.",
            Relation("positive_definite", {"matrix": rows("predicted")}),
            "The leading minors are quotients of sums without a minus sign.",
            hint=shown_signs.minors(c, "predicted"),
        ),
        joined(
            "definite-updated",
            Relation("positive_definite", {"matrix": rows("updated")}),
            hint=shown_signs.minors(c, "updated"),
        ),
        Step(
            "positive-entries",
            "All entries of both are positive as well.",
            positive(real(PREDICTED[0])),
            "Over `p` no minus sign is left in them.",
            shown=False,
        ),
        *(
            Step(f"positive-{name.replace('_', '-')}", "", positive(real(name)), "", shown=False)
            for name in (*PREDICTED[1:], *UPDATED)
        ),
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
