"""Steps on the first-order update with constant derivatives: its errors and its limits."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.relation import equal, limit, monotone, positive, same_sign
from gainproof.derive.updated_gains.forms import excesses
from gainproof.derive.updated_gains.names import (
    ALPHA,
    ALPHA_EXCESS,
    ALPHA_SLOPE,
    BETA,
    BETA_EXCESS,
    BETA_SLOPE,
    FIRST_ALPHA,
    FIRST_BETA,
    INDEX,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    E,
    N,
)

STEP = INDEX - NOMINAL
MARGIN = 4 - 2 * FIRST_ALPHA - FIRST_BETA


def update_steps() -> list[Step]:
    """Errors, and the borders that are crossed."""
    return [*_errors(), *_borders()]


def _errors() -> list[Step]:
    alpha, beta = excesses(N, E)
    small = (INDEX - NOMINAL) ** 2
    return [
        Step(
            "first-order",
            "The update with constant derivatives: gains on the tangents at the nominal index.",
            equal(
                row(FIRST_ALPHA, FIRST_BETA),
                row(NOMINAL_ALPHA + ALPHA_SLOPE * STEP, NOMINAL_BETA + BETA_SLOPE * STEP),
            ),
            "What the update is.",
            heading="Constant derivatives: the error",
        ),
        Step(
            "step-of-index",
            "The index changes with `e` by",
            equal(STEP, 2 * (E - N) * (E + N + E * N) / ((1 + E) * (1 + N))),
            "Step @gains; the index grows with `e`.",
        ),
        Step(
            "excess",
            "The errors against the exact gains.",
            equal(row(ALPHA_EXCESS, BETA_EXCESS), row(FIRST_ALPHA - ALPHA, FIRST_BETA - BETA)),
            "Their names.",
        ),
        joined("excess-value", equal(row(ALPHA_EXCESS, BETA_EXCESS), row(alpha, beta))),
        Step(
            "never-below",
            "So first-order gains are never too small, for either gain and on either side of the "
            "nominal index; they are exact at the nominal index alone.",
            same_sign(ALPHA_EXCESS, small),
            "All but the square is positive: a curve that bends down is below its tangents.",
        ),
        joined("never-below-beta", same_sign(BETA_EXCESS, small)),
        Step(
            "second-order",
            "Near the nominal index the error is half the second derivative times the square of "
            "the step, as it has to be.",
            equal(
                row(*(sp.Subs(value, E, N) for value in _over_square())),
                row(*(-sp.Derivative(gain, (NOMINAL, 2)) / 2 for gain in GAINS)),
            ),
            "Divide the errors by the square of the step and let `e = n`.",
        ),
    ]


GAINS = (NOMINAL_ALPHA, NOMINAL_BETA)


def _over_square() -> list[sp.Expr]:
    """Errors over the square of the step of the index, without the common factor."""
    below = 4 * (E + N + E * N) ** 2 / ((1 + E) * (1 + N)) ** 2
    return [value / (E - N) ** 2 / below for value in excesses(N, E)]


def _borders() -> list[Step]:
    place = N * (2 + N) / (1 + N)
    return [
        Step(
            "first-order-positive",
            "At no index, however small, does a first-order gain fall to 0: the tangents meet the "
            "axis of gains above it.",
            equal(
                row(NOMINAL_ALPHA - ALPHA_SLOPE * NOMINAL, NOMINAL_BETA - BETA_SLOPE * NOMINAL),
                row(
                    N * (N**2 + 4 * N + 2) / ((1 + N) ** 2 * (2 + N)),
                    2 * N**3 / ((1 + N) ** 2 * (2 + N)),
                ),
            ),
            "Both on the right are positive, and the slopes are.",
            heading="Constant derivatives: where they end",
        ),
        joined("first-order-alpha-positive", positive(FIRST_ALPHA)),
        joined("first-order-beta-positive", positive(FIRST_BETA)),
        Step(
            "beyond-one",
            "But `alpha` exceeds 1 once the index has grown by `n (2 + n)/(1 + n)`: beyond `1 + "
            "sqrt(1 + 8/Lambda_0)/2` times the nominal index.",
            same_sign(FIRST_ALPHA - 1, STEP - place),
            "The tangent at 1.",
        ),
        joined("beyond-one-ratio", equal((NOMINAL + place) / NOMINAL, 1 + (1 + 2 / N) / 2)),
        Step(
            "unstable",
            "And the filter becomes unstable after just twice that step: beyond `1 + sqrt(1 + "
            "8/Lambda_0)` times the nominal index. The other borders of the region are never met.",
            same_sign(MARGIN, 2 * place - STEP),
            "`2 alpha + beta = 4` (step @margin) along the tangents.",
        ),
        joined("unstable-ratio", equal((NOMINAL + 2 * place) / NOMINAL, 2 + 2 / N)),
        joined("source-root-nominal", equal(1 + 8 / NOMINAL, (1 + 2 / N) ** 2)),
        Step(
            "limits-fall",
            "The smaller the nominal index, the farther the update reaches: both ratios fall with "
            "it, from infinity to 3/2 and to 2.",
            monotone(1 + (1 + 2 / N) / 2, "decreasing", variable="nominal_index"),
            "`n` grows with the nominal index.",
        ),
        joined("limits-fall-unstable", monotone(2 + 2 / N, "decreasing", variable="nominal_index")),
        _tends("beyond-one-large", sp.Rational(3, 2) + 1 / N, "infinity", sp.Rational(3, 2)),
        _tends("unstable-large", 2 + 2 / N, "infinity", 2),
        _tends("beyond-one-small", sp.Rational(3, 2) + 1 / N, "0", "infinity"),
    ]


def _tends(name: str, expression: sp.Expr, point: str, value: sp.Expr | int | str) -> Step:
    at = value if isinstance(value, str) else sp.sympify(value)
    ends = {"0": End(), "infinity": End()}
    return joined(name, limit(expression, point, at, variable="nominal_index"), hint={"ends": ends})
