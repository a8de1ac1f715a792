"""Steps on the sample at which a fitted parabola hands over to steady gains."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, limit, monotone, positive

K, ALPHA = real("k"), real("alpha")
TOWER = "samples"


def hand_over_steps() -> list[Step]:
    """Between which k the gain of a fitted parabola passes a given one."""
    return [
        Step(
            "least-squares-gain",
            "A young track is fitted by a parabola, whose position gain is `alpha_k` at sample `k` "
            "(counted from 0): the recursion above without process noise from a start of which "
            "nothing is known.",
            equal(ALPHA, 3 * (3 * K**2 + 3 * K + 2) / ((K + 1) * (K + 2) * (K + 3))),
            "The derivation least-squares-parabola, step on the gain.",
            tower=TOWER,
            heading="Hand-over from least squares",
        ),
        Step(
            "least-squares-gain-falls",
            "It falls from 1, at sample 2, to zero, so that it passes every steady gain `alpha` "
            "just once.",
            monotone(ALPHA, "decreasing", variable="k"),
            "Its derivative has one sign.",
            tower=TOWER,
        ),
        joined(
            "least-squares-gain-start",
            equal(sp.Subs(ALPHA, K, sp.Integer(2)), sp.Integer(1)),
            tower=TOWER,
        ),
        joined(
            "least-squares-gain-end",
            limit(ALPHA, "infinity", sp.Integer(0), variable="k"),
            tower=TOWER,
            hint={"ends": {"0": End(), "infinity": End()}},
        ),
        Step(
            "hand-over-rest",
            "What is left of the oldest errors: `1 - alpha_k` is a quotient of products.",
            equal(1 - ALPHA, K * (K - 1) * (K - 2) / ((K + 1) * (K + 2) * (K + 3))),
            "Multiply out.",
            tower=TOWER,
        ),
        Step(
            "hand-over-above",
            "Where it equals `alpha` is a cubic equation in `k`. Its root is not needed, only "
            "between which whole numbers it lies: below `9/alpha - 5`,",
            positive(9 / ALPHA - 5 - K),
            "Insert step @least-squares-gain: what is left over has no minus sign.",
            tower=TOWER,
        ),
        Step(
            "hand-over-below",
            "and above `9/alpha - 5 - 8/3`. That leaves three whole numbers at most, at which "
            "the gain itself decides: the last one whose `alpha_k` is not below the steady gain. "
            "From the next sample on the steady gains take over.",
            positive(K - (9 / ALPHA - 5 - sp.Rational(8, 3))),
            "As before, with `k = 2` and more. By steps @difference-one-sided and @missed a "
            "filter with process noise that starts from nothing has at each sample a gain above "
            "both, as its covariance is above that of the fit and above the steady one.",
            tower=TOWER,
        ),
    ]
