"""Steps on the gain of three states and the update: textbook form, Joseph's form and factors."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.recursion.triple_names import (
    D1,
    D2,
    D3,
    FACTORS,
    GAINS,
    A,
    B,
    C,
    R,
    sheared,
    symmetric,
)
from gainproof.derive.relation import equal, positive


def rest(gains: tuple[sp.Expr, ...]) -> sp.ImmutableDenseMatrix:
    """I - K H."""
    return sp.ImmutableDenseMatrix(sp.eye(3) - sp.Matrix(gains) * sp.Matrix([[1, 0, 0]]))


def update_steps() -> list[Step]:
    """A position is measured."""
    gains = tuple(map(real, GAINS))
    s, p = real("innovation_variance"), symmetric("covariance")
    column = sp.ImmutableDenseMatrix(gains)
    left = rest(gains)
    names = tuple(real(f"updated_{name}") for name in FACTORS)
    known = D1 + R
    more, mixed = known + (A + C) ** 2 * D2, known + C * (A + C) * D2
    shown = (
        D1 * R / known,
        D2 * known / more,
        D3 * more / (more + A**2 * B**2 * D3),
        A * R / mixed,
        B * mixed / more,
        C * R * more / (known * mixed),
    )
    return [
        Step(
            "innovation",
            "A position is measured with variance `r`. `S` is the variance of the innovation, "
            "`K = P H'/S` the gain.",
            equal(_row(s, *gains), _row(p[0, 0] + R, *(p[i, 0] / (p[0, 0] + R) for i in range(3)))),
            "`S = H P H' + r`.",
            heading="The update",
        ),
        Step(
            "update",
            "The updated covariance `X = (I - K H) P`.",
            equal(symmetric("updated"), sp.MatMul(left, p, evaluate=False)),
            "The least variance that a gain can leave.",
        ),
        Step(
            "joseph",
            "Joseph's form, which holds for every gain, gives the same for this one.",
            equal(
                symmetric("updated"),
                sp.MatAdd(
                    sp.MatMul(left, p, left.T, evaluate=False),
                    sp.MatMul(R, column, column.T, evaluate=False),
                    evaluate=False,
                ),
            ),
            "`X = (I - K H) P (I - K H)' + K r K'`; insert step @innovation.",
        ),
        Step(
            "entry-23",
            "Of `U`, Bierman's update subtracts from entry 23, though the difference is a sum of "
            "positive terms: the minor `u12 u23 - u13` of `U` is `b c`.",
            equal(
                B - A * B * (A + C) * D2 / more,
                B * (known + C * (A + C) * D2) / more,
            ),
            "Bring to one denominator; `u12 = a + c`, `u13 = a b`, `u23 = b`. So the minor has to "
            "be carried as a product, which the shears do.",
        ),
        Step(
            "updated-factors",
            "The updated factors, without a minus sign; `alpha`, `beta`, `gamma` are the shears.",
            equal(_row(*names), _row(*shown)),
            "`d1`, `d2` and `d3` as Bierman has them; `alpha beta` is the new entry 13 of `U`, "
            "`beta` 23, `alpha + gamma` 12.",
        ),
        Step(
            "updated-proof",
            "They are those of `X`.",
            equal(symmetric("updated"), sheared(names)),
            "Insert step @updated-factors and multiply out.",
        ),
        Step(
            "updated-definite",
            "`X` is positive definite.",
            positive(names[0]),
            "Its `e1`, `e2` and `e3` have no minus sign (step @definite).",
        ),
        joined("updated-definite-2", positive(names[1])),
        joined("updated-definite-3", positive(names[2])),
        Step(
            "missed",
            "What the measurement takes away is a square. So a missed detection, a prediction "
            "without an update, never leaves less variance than a detection, in any direction.",
            equal(
                sp.MatAdd(p, -symmetric("updated"), evaluate=False),
                sp.MatMul(s, column, column.T, evaluate=False),
            ),
            "`P - X = K S K'`.",
        ),
    ]


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([entries])
