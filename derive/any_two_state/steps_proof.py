"""Steps that prove the steady state: Riccati equation, stability, definiteness, uniqueness."""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.algebra.positive import NoPlainSign
from gainproof.derive.algebra.riccati import definite_evidence
from gainproof.derive.any_two_state import covariance_forms, forms
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.names import (
    ALPHA,
    BETA,
    D0,
    D1,
    D2,
    GAIN_ROWS,
    PREDICTED,
    UPDATED,
    symmetric,
)
from gainproof.derive.any_two_state.towers import AREA
from gainproof.derive.derivation import Step, joined
from gainproof.derive.model import ModelError
from gainproof.derive.relation import Relation, cited, equal, positive
from gainproof.derive.source import RICCATI


def proof_steps(c: Context) -> list[Step]:
    """The Riccati equation, stability, definiteness and uniqueness."""
    total = D0 + D1 + D2
    values = [2 * D1 / total, 2 * (D0 + D2) / total]
    values += [8 * D1 * D2 / total**2, 8 * D0 * D1 / total**2]
    return [
        *_riccati(c),
        Step(
            "stable",
            "Both poles lie inside the unit circle, so the errors of a start die out.",
            Relation(
                "stable",
                {"model": c.model.data(), "gain": [list(line) for line in GAIN_ROWS]},
            ),
            "For a quadratic `c(z)` that starts with `z^2` it is enough that `1 - c(0)`, `c(1)` "
            "and `c(-1)` are positive. They are `d1/(2 sigma)`, `d0/sigma` and `d2/sigma`.",
            hint={
                "values": values,
                "coefficients": [1 - values[0], 2 * (D0 - D2) / total],
            },
        ),
        *_definite(c),
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


def _riccati(c: Context) -> list[Step]:
    sentence = (
        "So far we assumed that there is a steady state and found what it must be. Now the proof: "
        "these `K`, `M` and `X` satisfy the equations of the Kalman filter."
    )
    entries = [*c.model.transition.flat(), *c.model.process_noise.flat()]
    short = all(generator.symbol != "product" for generator in c.tower.generators)
    # the checker takes an entry as it is written, and cancels nothing in it
    written = all(sp.sympify(entry).is_polynomial() for entry in entries)
    if (
        short
        and written
        and all(c.tower.fraction(each).den == c.tower.ring.one for each in entries)
    ):
        claim: dict[str, Any] = {
            "model": c.model.data(),
            "predicted": _square(PREDICTED),
            "updated": _square(UPDATED),
            "gain": [list(line) for line in GAIN_ROWS],
            "index": "tracking_index",
        }
        return [
            Step(
                "riccati",
                sentence,
                Relation("riccati", claim),
                "Insert the entries: the difference of both sides is in every entry a combination "
                "of the equations that define the roots, and so zero.",
                hint={"innovation": [(D0 + D1 + D2) ** 2 / 16]},
                heading="The proof that this is the steady state",
            )
        ]
    return _written_riccati(c, sentence)


def _written_riccati(c: Context, sentence: str) -> list[Step]:
    """The same equations entry by entry, for the checker to reduce: where the transition is no
    polynomial in the tower, or a long radicand makes written cofactors longer than the proof.
    """
    before, after = symmetric(PREDICTED), symmetric(UPDATED)
    gain = sp.ImmutableDenseMatrix([[ALPHA], [BETA]])
    column = before[:, 0]
    moved = sp.MatMul(c.model.transition, after, c.model.transition.T, evaluate=False)
    noise = sp.ImmutableDenseMatrix(AREA * c.model.process_noise)
    return [
        Step(
            "riccati",
            f"{sentence} First `M = F X F' + Lambda^2 Q0`,",
            equal(before, sp.MatAdd(moved, noise, evaluate=False)),
            "Insert the entries: the difference of both sides vanishes in every entry by the "
            "equations that define the roots. `H M H' + R` is positive.",
            heading="The proof that this is the steady state",
        ),
        joined(
            "riccati-gain",
            equal(sp.ImmutableDenseMatrix(gain * (column[0] + 1)), sp.ImmutableDenseMatrix(column)),
        ),
        joined(
            "riccati-update",
            equal(after, sp.ImmutableDenseMatrix(before - gain * column.T)),
        ),
        joined(
            "riccati-innovation",
            positive(column[0] + 1),
            hint={"form": (D0 + D1 + D2) ** 2 / 16},
        ),
    ]


def _square(names: tuple[str, str, str]) -> list[list[str]]:
    first, cross, second = names
    return [[first, cross], [cross, second]]


def _definite(c: Context) -> list[Step]:
    """Positive definite by leading minors where their forms show it, else by a cited theorem."""
    steps: list[Step] = []
    try:
        determinant = covariance_forms.updated_determinant(c.basis)
        share = (D0 + D1 + D2) ** 2 / 16
        for word, names, first, factor in (
            ("predicted", PREDICTED, forms.variance_excess(c.basis), share),
            ("updated", UPDATED, forms.alpha(c.basis), sp.Integer(1)),
        ):
            step = Step(
                f"definite-{word}",
                "Both covariances are positive definite for every positive index.",
                Relation("positive_definite", {"matrix": _square(names)}),
                "The first entry and the determinant are made of sums without a minus sign. That "
                "of the determinants follows from `det M = sigma^2 det X`, by step @covariances, "
                "and from `M = F X F' + Lambda^2 Q0`.",
                hint={"minors": [first, factor * determinant]},
            )
            definite_evidence(step, c.tower)
            steps.append(step if not steps else joined(step.id, step.relation, hint=step.hint))
    except (ModelError, NoPlainSign):
        return [_cited_definite()]
    return steps


def _cited_definite() -> Step:
    return Step(
        "definite",
        "Both covariances are positive definite for every positive index. Here no form without a "
        "minus sign was found; it follows from a theorem.",
        cited(
            "Where the process noise reaches every state, the stabilising solution of a discrete "
            "algebraic Riccati equation is positive definite.",
            RICCATI.text(),
        ),
        "`Q0` and `F Q0 F'` together are positive definite. The theorem is cited, not proved here: "
        "where `M v = 0`, `Q0 v = 0` and `X F' v = 0`, hence `M F' v = 0`, and so on.",
    )
