"""Steps on the variances of a filter whose gains belong to another index than the target's."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, product, row, symmetric, total
from gainproof.derive.relation import Relation, cited, equal, limit, same_sign
from gainproof.derive.source import MATRICES
from gainproof.derive.updated_gains.forms import held_covariances
from gainproof.derive.updated_gains.names import (
    ENTRIES,
    INDEX,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    RATIO,
    E,
    N,
)

LOOP = Loop(2)
SHAPE = sp.ImmutableDenseMatrix([[sp.Rational(1, 4), sp.Rational(1, 2)], [sp.Rational(1, 2), 1]])


def mismatch_steps() -> list[Step]:
    """Gains of the nominal index, a target of another: variances, and how far from the least."""
    return [*_variances(), *_losses(), *_ends()]


def with_gains(alpha: sp.Expr, beta: sp.Expr) -> tuple[sp.ImmutableDenseMatrix, ...]:
    """F (I - K H), I - K H, F K K' F', K and the process noise, with these gains."""
    gains = dict(zip(LOOP.gains, (alpha, beta), strict=True))
    closed, rest, column = (
        sp.ImmutableDenseMatrix(x.subs(gains)) for x in (LOOP.closed, LOOP.rest, LOOP.column)
    )
    step = LOOP.transition * column
    noise = sp.ImmutableDenseMatrix(INDEX**2 * SHAPE)
    return closed, rest, sp.ImmutableDenseMatrix(step * step.T), column, noise


def _entries(prefix: str) -> sp.ImmutableDenseMatrix:
    return row(*(real(f"{prefix}_{ij}") for ij in ENTRIES))


def _variances() -> list[Step]:
    forms = held_covariances(N, RATIO)
    return [
        *held_equations(),
        Step(
            "held-unique",
            "There are no others, as the filter is stable (step @stable, at the nominal index).",
            cited(
                "A discrete Lyapunov equation of a stable matrix has one solution.",
                MATRICES.text(),
            ),
            "The theorem is cited; `gainproof derive alpha-beta` shows the determinant.",
        ),
        Step(
            "held-predicted",
            "With the ratio `c` of `Lambda` to the nominal index, in `n`:",
            equal(RATIO, INDEX / NOMINAL),
            "Solve the linear equations. What has no `c` is the noise of the measurement, all that "
            "is left of a target that goes straight.",
        ),
        joined(
            "held-predicted-value",
            equal(
                _entries("held_predicted"),
                row(*(forms[f"held_predicted_{ij}"] for ij in ENTRIES)),
            ),
        ),
        joined(
            "held-updated-value",
            equal(
                _entries("held_updated"),
                row(*(forms[f"held_updated_{ij}"] for ij in ENTRIES)),
            ),
        ),
    ]


def held_equations() -> list[Step]:
    """The covariances of held gains, before and after the update."""
    before, after = symmetric("held_predicted", 2), symmetric("held_updated", 2)
    closed, rest, moved, column, noise = with_gains(NOMINAL_ALPHA, NOMINAL_BETA)
    return [
        Step(
            "held",
            "A filter keeps the gains of the nominal index, while the target's manoeuvres and the "
            "measurement have the index `Lambda`. Its errors settle to the covariances for which",
            equal(before, total(product(closed, before, closed.T), moved, noise)),
            "Errors of the prediction become `F (I - K H) e`, less `F K` times the measurement's "
            "noise, plus the manoeuvre.",
            heading="A target of another index than the gains",
        ),
        joined(
            "held-updated",
            equal(after, total(product(rest, before, rest.T), product(column, column.T))),
        ),
    ]


def _losses() -> list[Step]:
    def loss(kind: str, ij: str) -> sp.Expr:
        return real(f"held_{kind}_{ij}") - real(f"{kind}_{ij}")

    square = (INDEX - NOMINAL) ** 2
    first = Relation(
        "equal",
        {
            "left": row(loss("updated", "11"), loss("updated", "22")),
            "right": row(*_excess()),
            "free": (),
        },
    )
    return [
        Step(
            "loss",
            "Less the least variances, those of the exact gains:",
            first,
            "Subtract steps @covariances and insert.",
        ),
        Step(
            "loss-positive",
            "That is never negative, and zero at the nominal index alone, for every entry of both "
            "matrices.",
            same_sign(loss("updated", "11"), square),
            "But for the square there is no minus sign.",
        ),
        *(
            joined(f"loss-positive-{kind}-{ij}", same_sign(loss(kind, ij), square))
            for kind in ("updated", "predicted")
            for ij in ENTRIES
            if (kind, ij) != ("updated", "11")
        ),
    ]


def _excess() -> tuple[sp.Expr, sp.Expr]:
    square = (E - N) ** 2
    below = (N + 1) * (N + 2) * (E + 1) ** 2
    first = N**3 + 2 * N**2 * E + 3 * N**2 + N * E**2 + 2 * N * E + E**2
    second = (N * E + N + E) ** 2 + 2 * N * E**2 + 2 * E**2
    return square * first / (N**3 * below), 2 * square * second / (N * below)


def _ends() -> list[Step]:
    ratio = real("held_updated_11") / real("updated_11")
    velocity = real("held_updated_22") / real("updated_22")
    ends = {"0": End(), "infinity": End()}

    def tends(name: str, expression: sp.Expr, point: str, variable: str) -> Step:
        return joined(
            name,
            limit(expression, point, "infinity", variable=variable),
            hint={"ends": ends},
        )

    first = tends("loss-large", ratio, "infinity", "tracking_index")
    return [
        Step(
            first.id,
            "The loss has no bound: neither for a target much livelier than the gains expect, nor "
            "for one much calmer.",
            first.relation,
            "Leading powers of `e`.",
            hint=first.hint,
        ),
        tends("loss-large-velocity", velocity, "infinity", "tracking_index"),
        tends("loss-small", ratio, "0", "tracking_index"),
        tends("loss-small-velocity", velocity, "0", "tracking_index"),
    ]
