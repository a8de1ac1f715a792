"""Steps on what has no trend: the cross term with the index, and K12 with either parameter."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, limit, monotone
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.corners import GAMMA, T, fixed_index_ends
from gainproof.derive.vector_measurement.names import RATIO
from gainproof.derive.vector_measurement.steps_limits import stable_forms

CORNER = "fixed_velocity_index"
EITHER = "`K12` has no trend in `S` either."
K12, K21, U12 = map(real, ("gain_12", "gain_21", "updated_12"))


def without_trend_steps(c: Context) -> list[Step]:
    """Why some entries rise and fall; what they rest on is in the steps on limits and trends."""
    return [*_with_index(c), *_with_ratio(c)]


def _settled(c: Context) -> bool:
    """Whether K21 tends to a positive value with the index: its limits alone show no fall."""
    return c.noise.interval and not c.noise.e


def _with_index(c: Context) -> list[Step]:
    if _settled(c):
        return []
    return [
        Step(
            "without-trend-index",
            "So not everything has a trend: `K21` is zero at both ends and positive between, it "
            "rises and falls with the index. So do `U12` and `K12`, which are the same but for "
            "`S^2`.",
            equal(
                sp.ImmutableDenseMatrix([[U12, RATIO**2 * K12]]),
                sp.ImmutableDenseMatrix([[K21, K21]]),
            ),
            "Step @turning-gain-21-small gives both ends, step @gain the equations.",
        )
    ]


def _with_ratio(c: Context) -> list[Step]:
    lead = "Not everything has a trend: `K12` has none in `S`." if _settled(c) else EITHER
    value = GAMMA / (GAMMA + T) if c.noise.interval else 4 / (GAMMA + T) ** 2
    return [
        Step(
            "without-trend-corner",
            f"{lead} For a small index, `t = Lambda/S` held, it tends to this function of `t`.",
            limit(K12, "0", value, "p"),
            "Step @small-velocity-index-updated-12 over `S^2`, where `S = p^2/t`.",
            tower=CORNER,
            hint={"ends": fixed_index_ends(c.noise), "limit_form": stable_forms(c)["gain_12"]},
        ),
        Step(
            "without-trend-rises",
            "The function falls as `t` grows, so `K12` rises with `S` there; but it falls to zero "
            "when `S` grows without bound.",
            monotone(value, "decreasing", "t"),
            "The derivative of `gamma` is `t/gamma`, less than 1. For large `S`, `S^2 K12` has a "
            "limit (step @velocity-absent-gain-12).",
            tower=CORNER,
        ),
    ]
