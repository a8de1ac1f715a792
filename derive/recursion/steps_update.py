"""Steps on the gain and the update: textbook form, Joseph's form and factors are one."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.recursion.names import D1, D2, FACTORS, GAINS, R, U, rows, sheared, symmetric
from gainproof.derive.relation import Relation, equal, positive


def rest(position: sp.Expr, velocity: sp.Expr) -> sp.ImmutableDenseMatrix:
    """I - K H."""
    return sp.ImmutableDenseMatrix([[1 - position, 0], [-velocity, 1]])


def update_steps() -> list[Step]:
    """A position is measured."""
    k1, k2 = map(real, GAINS)
    s = real("innovation_variance")
    p = symmetric("covariance")
    p11, p12, p22 = p[0, 0], p[0, 1], p[1, 1]
    f1, v, f2 = (real(f"updated_{factor}") for factor in FACTORS)
    gain = sp.ImmutableDenseMatrix([[k1], [k2]])
    left = rest(k1, k2)
    return [
        Step(
            "innovation",
            "A position is measured with variance `r`. `S` is the variance of the innovation, "
            "and the gain `K = P H'/S`.",
            equal(
                sp.ImmutableDenseMatrix([[s, k1, k2]]),
                sp.ImmutableDenseMatrix([[p11 + R, p11 / (p11 + R), p12 / (p11 + R)]]),
            ),
            "`S = H P H' + r`. Both gains are quotients of sums without a minus sign.",
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
                    sp.MatMul(R, gain, gain.T, evaluate=False),
                    evaluate=False,
                ),
            ),
            "`X = (I - K H) P (I - K H)' + K r K'`; insert step @innovation.",
        ),
        Step(
            "entries",
            "Written in the entries of `P`, the first two are quotients, but the last is a "
            "difference that loses all digits when one measurement tells nearly everything about "
            "the velocity.",
            equal(
                sp.ImmutableDenseMatrix([[real(f"updated_{ij}") for ij in ("11", "12", "22")]]),
                sp.ImmutableDenseMatrix(
                    [[p11 * R / (p11 + R), p12 * R / (p11 + R), p22 - p12**2 / (p11 + R)]]
                ),
            ),
            "Multiply out step @update.",
        ),
        Step(
            "determinant",
            "The determinant would mend it, `X22 = (P22 r + det P)/S`, and `det X = r det P/S`; "
            "but a prediction needs differences again to carry it.",
            equal(
                sp.ImmutableDenseMatrix(
                    [[real("updated_22"), f1 * f2]],
                ),
                sp.ImmutableDenseMatrix(
                    [[(p22 * R + D1 * D2) / s, R * D1 * D2 / s]],
                ),
            ),
            "`det P = d1 d2`, and of `X` it is `f1 f2`.",
        ),
        Step(
            "updated-factors",
            "The factors have no such difference: a measurement divides `u` and `d1` alike, and "
            "`d2` by a quotient of two innovations' variances, that without and that with the "
            "velocity's part.",
            equal(
                sp.ImmutableDenseMatrix([[f1, v, f2]]),
                sp.ImmutableDenseMatrix(
                    [
                        [
                            D1 * R / (D1 + R),
                            U * R / (D1 + R),
                            D2 * (D1 + R) / (D1 + R + U**2 * D2),
                        ]
                    ]
                ),
            ),
            "From `X`: `f2 = X22`, `v = X12/X22`, `f1 f2 = det X`.",
        ),
        Step(
            "updated-proof",
            "They are those of `X`.",
            equal(symmetric("updated"), sheared(f1, v, f2)),
            "Insert step @updated-factors and multiply out.",
        ),
        Step(
            "updated-definite",
            "`X` is positive definite.",
            Relation("positive_definite", {"matrix": rows("updated")}),
            "By step @definite: its `f1` and `f2` are above zero.",
        ),
        joined("updated-first", positive(f1)),
        joined("updated-last", positive(f2)),
        Step(
            "missed",
            "What the measurement takes away is a square. So a missed detection, which is a "
            "prediction without an update, never leaves less variance than a detection, in any "
            "direction.",
            equal(
                sp.MatAdd(p, -symmetric("updated"), evaluate=False),
                sp.ImmutableDenseMatrix(
                    [[p11 * p11 / s, p11 * p12 / s], [p11 * p12 / s, p12 * p12 / s]]
                ),
            ),
            "`P - X = K S K'`.",
        ),
    ]
