"""Steps on three states: the factored covariance and its update."""

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
    T,
    first_shear,
    rows,
    second_shear,
    sheared,
    symmetric,
    transition,
    upper,
)
from gainproof.derive.relation import Relation, described, equal, positive


def model_steps() -> list[Step]:
    """What is filtered, and how its covariance is kept."""
    s = real("s")
    return [
        Step(
            "model",
            "A target's position, velocity and acceleration are estimated; the position is "
            "measured with variance `r`, at any times, an interval `t` apart; `H = [1, 0, 0]`.",
            described("position, velocity and acceleration, position measured, over any interval"),
            "All in units that fit together. What disturbs the acceleration is the process noise "
            "`Q`, below.",
            heading="The model and its covariance",
        ),
        Step(
            "intervals-add",
            "The motion `F` over two intervals, one after the other, is that over their sum.",
            equal(
                sp.MatMul(transition(T), transition(s), evaluate=False),
                transition(s + T),
            ),
            "Multiply out.",
            tower="intervals",
        ),
        Step(
            "motion",
            "`F` is a product of three shears: some of the velocity to the position, some of the "
            "acceleration to the velocity, and the first once more.",
            equal(
                transition(T),
                sp.MatMul(first_shear(T / 2), second_shear(T), first_shear(T / 2), evaluate=False),
            ),
            "Multiply out.",
            tower="intervals",
        ),
        Step(
            "shears",
            "The covariance is kept like this: `P = U diag(d1, d2, d3) U'`, where `U` is a product "
            "of the same three shears by `a`, `b` and `c`, none of them negative.",
            equal(
                upper(A, B, C),
                sp.MatMul(first_shear(A), second_shear(B), first_shear(C), evaluate=False),
            ),
            "Multiply out. The entries of `U` alone will not do, as the update shows.",
        ),
        Step(
            "factors",
            "Its entries are sums without a minus sign.",
            equal(symmetric("covariance"), sheared((D1, D2, D3, A, B, C))),
            "Multiply out.",
        ),
        Step(
            "definite",
            "With `d1`, `d2` and `d3` above zero it is positive definite, whatever the shears; no "
            "rounding can take that away.",
            Relation("positive_definite", {"matrix": rows("covariance")}),
            "Its leading minors have no minus sign.",
        ),
    ]


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
