"""Steps on the sample at which least squares hands over to steady gains."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, limit, monotone, positive

K, ALPHA, ROOT = real("k"), real("alpha"), real("root")
TOWER = "samples"


def hand_over_steps() -> list[Step]:
    """The largest k at which the gain of a fitted line is not below a given one."""
    ends = {"0": End(), "infinity": End()}
    return [
        Step(
            "least-squares-gain",
            "A young track is fitted by a line, whose position gain is `alpha_k` at sample `k` "
            "(counted from 0): the recursion above without process noise from a start of which "
            "nothing is known.",
            equal(ALPHA, 2 * (2 * K + 1) / ((K + 1) * (K + 2))),
            "The derivation least-squares-line, step on the gain.",
            tower=TOWER,
            heading="Hand-over from least squares",
        ),
        Step(
            "least-squares-gain-falls",
            "It falls from 1, at sample 1, to zero, so that it passes every steady gain `alpha` "
            "just once.",
            monotone(ALPHA, "decreasing", variable="k"),
            "Its derivative has one sign.",
            tower=TOWER,
        ),
        joined(
            "least-squares-gain-start",
            equal(sp.Subs(ALPHA, K, sp.Integer(1)), sp.Integer(1)),
            tower=TOWER,
        ),
        joined(
            "least-squares-gain-end",
            limit(ALPHA, "infinity", sp.Integer(0), variable="k"),
            tower=TOWER,
            hint={"ends": ends},
        ),
        Step(
            "hand-over-root",
            "Where it equals `alpha`, with `rho` the positive root of `16 (1 - alpha) + alpha^2`:",
            equal(ROOT**2, 16 * (1 - ALPHA) + ALPHA**2),
            "`alpha (k + 1) (k + 2) = 2 (2 k + 1)` is a quadratic in `k` with this discriminant.",
            tower=TOWER,
        ),
        joined("hand-over-root-positive", positive(ROOT), tower=TOWER),
        Step(
            "hand-over",
            "Up to this `k` the fit's gain is not below the steady one; from the next sample on it "
            "is, and the steady gain takes over.",
            equal(K, (1 + 3 * (1 - ALPHA) + ROOT) / (2 * ALPHA)),
            "The larger root of the quadratic, without a difference of computed numbers. The "
            "smaller one is below 1. By steps @difference-one-sided and @missed a filter with "
            "process noise that starts from nothing has at each sample a gain above both, as its "
            "covariance is above that of the fit and above the steady one.",
            tower=TOWER,
        ),
    ]
