"""Steps on the index of an axis, the gains in a parameter without roots, and their derivatives."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row, rows
from gainproof.derive.model import ScaledModel
from gainproof.derive.relation import Relation, equal, monotone, positive
from gainproof.derive.updated_gains.forms import gains_of, index_of, slopes_of
from gainproof.derive.updated_gains.names import (
    ALPHA,
    ALPHA_SLOPE,
    BETA,
    BETA_SLOPE,
    DEVIATION,
    ENTRIES,
    FOLLOWING,
    FOLLOWING_ALPHA,
    FOLLOWING_BETA,
    INDEX,
    NEXT_ALPHA_SLOPE,
    NEXT_BETA_SLOPE,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    E,
    G,
    N,
)
from gainproof.derive.updated_gains.towers import AXIS


def gain_steps(model: ScaledModel) -> list[Step]:
    """Index, gains, proof that they are the steady state, first and second derivatives."""
    return [*_index(), *_steady(model), *_others(), *_slopes(), *_bend()]


def _index() -> list[Step]:
    w, t, d = map(real, ("acceleration_deviation", "interval", "d"))
    return [
        Step(
            "axis-index",
            "Each axis has a filter of its own. A measurement turned from polar to Cartesian "
            "coordinates has another variance `R_i` along each axis and at each range, and so the "
            "index of axis `i` is, with a random acceleration of deviation `sigma_w` and "
            "`sigma_i = sqrt(R_i)`:",
            equal(real("axis_index") ** 2 * real("variance"), w**2 * t**4),
            "`Lambda_i = sigma_w T^2/sqrt(R_i)`.",
            tower=AXIS,
            heading="An index for each axis",
        ),
        joined(
            "axis-index-ratio",
            monotone(real("axis_index"), "decreasing", variable="d"),
            tower=AXIS,
        ),
        joined("axis-index-root", equal(real("axis_index"), w * t**2 / d), tower=AXIS),
    ]


def _steady(model: ScaledModel) -> list[Step]:
    claim = {
        "model": model.data(),
        "predicted": rows("predicted", 2),
        "updated": rows("updated", 2),
        "gain": ["alpha", "beta"],
        "index": "tracking_index",
    }
    root = 2 * E * (2 + E) / (1 + E)
    return [
        Step(
            "gains",
            "Now one axis, in units of its `R` and of `T`. With `sigma = 1 + e`, the deviation of "
            "the innovation, nothing has a root: each `e > 0` is one index, each index one `e`.",
            equal(row(INDEX, ALPHA, BETA), row(index_of(E), *gains_of(E))),
            "The gains of the random acceleration filter satisfy `alpha = 1 - 1/sigma^2` and "
            "`Lambda = beta sigma`.",
            heading="Gains without roots",
        ),
        joined("deviation", equal(DEVIATION, 1 + E)),
        joined("index-grows", monotone(INDEX, "increasing", variable="e")),
        Step(
            "riccati",
            "They are those of the Kalman filter in its steady state, with these covariances `M` "
            "before and `X` after the update.",
            Relation("riccati", claim),
            "Insert.",
        ),
        Step(
            "covariances",
            "In `e`:",
            equal(
                row(*(real(f"predicted_{ij}") for ij in ENTRIES)),
                row(E * (2 + E), 2 * E**2, 4 * E**3 / (1 + E)),
            ),
            "As before.",
        ),
        joined(
            "updated-covariances",
            equal(
                row(*(real(f"updated_{ij}") for ij in ENTRIES)),
                row(*gains_of(E), 4 * E**3 / (1 + E) ** 2),
            ),
        ),
        Step(
            "stable",
            "This filter is stable at every index.",
            Relation("stable", {"model": model.data(), "gain": ["alpha", "beta"]}),
            "The Schur-Cohn quantities are positive.",
        ),
        Step(
            "margin",
            "How far inside the region of stability it is: of `0 < alpha`, `0 < beta` and `2 alpha "
            "+ beta < 4` the last has",
            equal(4 - 2 * ALPHA - BETA, 4 / (1 + E)),
            "Insert. (The region is that of `gainproof derive alpha-beta`.)",
        ),
        Step(
            "source-root",
            "The root in printed formulas over the index is rational in `e`:",
            equal(INDEX**2 + 8 * INDEX, root**2),
            "Insert step @gains; so `sqrt(1 + 8/Lambda) = 1 + 2/e`.",
        ),
        joined("source-alpha", equal(ALPHA, -(INDEX**2 + 8 * INDEX - (INDEX + 4) * root) / 8)),
        joined("source-beta", equal(BETA, (INDEX**2 + 4 * INDEX - INDEX * root) / 4)),
    ]


def _others() -> list[Step]:
    """The same at a nominal index and at one that follows."""
    there = [sp.Subs(value, E, N) for value in (INDEX, ALPHA, BETA)]
    after = [sp.Subs(value, E, G) for value in (INDEX, ALPHA, BETA)]
    return [
        Step(
            "nominal",
            "The same at another index, the nominal one, with `n` in place of `e`.",
            equal(row(NOMINAL, NOMINAL_ALPHA, NOMINAL_BETA), row(*there)),
            "Insert `n`.",
        ),
        Step(
            "following",
            "And at one that follows, with `g`.",
            equal(row(FOLLOWING, FOLLOWING_ALPHA, FOLLOWING_BETA), row(*after)),
            "Insert `g`.",
            shown=False,
        ),
    ]


def _slopes() -> list[Step]:
    derivatives = row(*(sp.Derivative(gain, INDEX) for gain in (ALPHA, BETA)))
    return [
        Step(
            "slopes",
            "The derivatives of the gains by the index:",
            equal(derivatives, row(*slopes_of(E))),
            "Differentiate by `e` and divide by the derivative of the index.",
            heading="Derivatives",
        ),
        joined("slope-names", equal(derivatives, row(NEXT_ALPHA_SLOPE, NEXT_BETA_SLOPE))),
        Step(
            "nominal-slopes",
            "Those at the nominal index are called",
            equal(
                row(ALPHA_SLOPE, BETA_SLOPE),
                row(*(sp.Derivative(gain, NOMINAL) for gain in (NOMINAL_ALPHA, NOMINAL_BETA))),
            ),
            "As before.",
        ),
        joined("nominal-slopes-value", equal(row(ALPHA_SLOPE, BETA_SLOPE), row(*slopes_of(N)))),
    ]


def _bend() -> list[Step]:
    alpha = (3 * E**2 + 6 * E + 2) / (2 * E**3 * (2 + E) ** 3)
    beta = (3 + 2 * E) / (E * (2 + E) ** 3)
    second = [sp.Derivative(gain, (INDEX, 2)) for gain in (ALPHA, BETA)]
    return [
        Step(
            "second",
            "Both gains bend down at every index; neither ever bends up.",
            equal(row(*second), row(-alpha, -beta)),
            "Differentiate once more.",
        ),
        joined("bends-alpha", positive(-second[0]), hint={"form": alpha}),
        joined("bends-beta", positive(-second[1]), hint={"form": beta}),
        Step(
            "direction",
            "There `beta` grows `2 n` times as fast as `alpha`.",
            equal(BETA_SLOPE, 2 * N * ALPHA_SLOPE),
            "Step @nominal-slopes.",
        ),
    ]
