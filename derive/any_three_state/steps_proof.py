"""Steps that prove the steady state: Riccati equation, stability, definiteness, uniqueness."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.positive import NoPlainSign
from gainproof.derive.algebra.riccati import definite_evidence
from gainproof.derive.any_three_state import forms
from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.names import (
    AREA,
    GAIN_ROWS,
    GAINS,
    ROOTS,
    TOTAL,
    entries,
    symmetric,
)
from gainproof.derive.derivation import Step, joined
from gainproof.derive.model import ModelError
from gainproof.derive.relation import Relation, cited, equal, positive
from gainproof.derive.source import RICCATI


def proof_steps(c: Context) -> list[Step]:
    """The Riccati equation, stability, definiteness and uniqueness."""
    return [*_riccati(c), _stable(c), *_definite(c), _unique()]


def _riccati(c: Context) -> list[Step]:
    """The equations entry by entry, for the checker to reduce."""
    before, after = symmetric("predicted"), symmetric("updated")
    gain = sp.ImmutableDenseMatrix(GAINS)
    column = before[:, 0]
    moved = sp.MatMul(c.model.transition, after, c.model.transition.T, evaluate=False)
    noise = sp.ImmutableDenseMatrix(AREA * c.model.process_noise)
    return [
        Step(
            "riccati",
            "So far we assumed that there is a steady state and found what it must be. Now the "
            "proof: these `K`, `M` and `X` satisfy the equations of the Kalman filter. First "
            "`M = F X F' + Lambda^2 Q0`,",
            equal(before, sp.MatAdd(moved, noise, evaluate=False)),
            "Insert the entries: the difference of both sides vanishes in every entry by the "
            "equations that define the roots. `H M H' + R` is positive.",
            heading="The proof that this is the steady state",
        ),
        joined(
            "riccati-gain",
            equal(sp.ImmutableDenseMatrix(gain * (column[0] + 1)), sp.ImmutableDenseMatrix(column)),
        ),
        joined("riccati-update", equal(after, sp.ImmutableDenseMatrix(before - gain * column.T))),
        joined("riccati-innovation", positive(column[0] + 1), hint={"form": TOTAL**2 / 64}),
    ]


def _stable(c: Context) -> Step:
    """The quantities of Schur and Cohn over the roots: sums, and d1 d2 - d0 d3."""
    d0, d1, d2, d3 = ROOTS
    apart = c.basis.determinant
    values = [
        2 * (d1 + d3) / TOTAL,
        2 * (d0 + d2) / TOTAL,
        8 * apart / TOTAL**2,
        8 * (d0 * d1 + 2 * d0 * d3 + d2 * d3) / TOTAL**2,
        128 * d3 * (d0 + d2) * apart / TOTAL**4,
        128 * d0 * (d1 + d3) * apart / TOTAL**4,
    ]
    coefficients = [
        (d0 - d1 + d2 - d3) / TOTAL,
        (3 * d0 - d1 - d2 + 3 * d3) / TOTAL,
        (3 * d0 + d1 - d2 - 3 * d3) / TOTAL,
    ]
    return Step(
        "stable",
        "All poles lie inside the unit circle, so the errors of a start die out.",
        Relation("stable", {"model": c.model.data(), "gain": [list(line) for line in GAIN_ROWS]}),
        "The criterion of Schur and Cohn: six quantities made of the coefficients of `c(z)` are "
        "positive. They are sums of the roots, and `d1 d2 - d0 d3` of step @hurwitz times such.",
        hint={"values": values, "coefficients": coefficients},
    )


def _definite(c: Context) -> list[Step]:
    """Positive definite by leading minors where their forms show it, else by a cited theorem."""
    steps: list[Step] = []
    try:
        for kind in ("predicted", "updated"):
            step = Step(
                f"definite-{kind}",
                "Both covariances are positive definite for every positive index.",
                Relation("positive_definite", {"matrix": entries(kind)}),
                "The leading minors are made of sums without a minus sign.",
                hint={"minors": _minors(c, kind)},
            )
            definite_evidence(step, c.tower)
            steps.append(step if not steps else joined(step.id, step.relation, hint=step.hint))
    except (ModelError, NoPlainSign):
        return [_cited_definite()]
    return steps


def _minors(c: Context, kind: str) -> list[sp.Expr]:
    """Raises NoPlainSign where one has no form without a subtraction."""
    if len(c.tower.parameters) > 2:
        raise NoPlainSign("with several free numbers the search takes too long")
    matrix = symmetric(kind)
    found = [c.quantities.value(c.basis, f"{kind}_11").value]
    for size in (2, 3):
        form = forms.find(c.shape, c.tower, c.tower.fraction(matrix[:size, :size].det()))
        value = c.basis.valued(form)
        if not value.is_positive:
            raise NoPlainSign(f"a leading minor of {kind}")
        found.append(value.plus)
    return found


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
        "`Q0`, `F Q0 F'` and `F^2 Q0 F^2'` together are positive definite. The theorem is cited, "
        "not proved here: where `M v = 0`, `Q0 v = 0` and `X F' v = 0`, hence `M F' v = 0`, and so "
        "on.",
    )


def _unique() -> Step:
    return Step(
        "uniqueness",
        "So this is the steady state: no other solution of the Riccati equation stabilises.",
        cited(
            "A discrete algebraic Riccati equation has at most one stabilising solution.",
            RICCATI.text(),
        ),
        "`M` is one, by steps @riccati and @stable. The theorem is cited, not proved here.",
    )
