"""Steps on two covariances under the same measurements: how a start is forgotten."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.recursion.names import GAINS, R, T, shear_matrix, symmetric
from gainproof.derive.recursion.steps_update import rest
from gainproof.derive.relation import equal


def difference_steps() -> list[Step]:
    """From one sample to the next the difference is multiplied from both sides."""
    p, b = symmetric("covariance"), symmetric("other")
    x, y = symmetric("updated"), symmetric("other_updated")
    k1, k2 = map(real, GAINS)
    c1, c2 = (real(f"other_{gain}") for gain in GAINS)
    move = shear_matrix(T)
    one, other = move * rest(k1, k2), move * rest(c1, c2)
    gap = sp.ImmutableDenseMatrix(p - b)
    s = p[0, 0] + R
    square = sp.ImmutableDenseMatrix(
        [[gap[0, 0] ** 2, gap[0, 0] * gap[0, 1]], [gap[0, 0] * gap[0, 1], gap[0, 1] ** 2]]
    )
    z = real("z")
    first, cross, last = map(real, ("g11", "g12", "g22"))
    g = sp.ImmutableDenseMatrix([[first, cross], [cross, last]])
    share = sp.ImmutableDenseMatrix([[first], [cross]]) / (first + R)
    left = rest(share[0, 0], share[1, 0])
    return [
        Step(
            "difference",
            "Let `P` and `B` be two predicted covariances at one sample, `K` and `C` their gains, "
            "`X` and `Y` their updates. One sample on, whatever the process noise, the predictions "
            "differ by `A (P - B) A'`, where the left `A` is the closed loop `F (I - K H)` of the "
            "one and the right that of the other.",
            equal(
                sp.MatMul(move, x - y, move.T, evaluate=False),
                sp.MatMul(one, gap, other.T, evaluate=False),
            ),
            "`Q` drops out of `F X F' + Q - F Y F' - Q`; insert step @update for both. If `B` is "
            "the steady state, `C` is its gain and stays: after `k` samples the difference is "
            "that of the start with the product of all closed loops on the left and the `k`-th "
            "power of the steady one, transposed, on the right.",
            tower="pair",
            heading="How fast a start is forgotten",
        ),
        Step(
            "difference-left",
            "With the same closed loop, that of `B`, on both sides a square is left over.",
            equal(
                sp.MatMul(move, x - y, move.T, evaluate=False),
                sp.MatMul(other, gap - square / s, other.T, evaluate=False),
            ),
            "Insert both updates.",
            tower="pair",
        ),
        Step(
            "difference-one-sided",
            "What is left of a matrix `G`, here `P - B`, after this "
            "square is taken away, is not below zero where `G` is not, and never above `G`. So a "
            "start above the steady state stays above it, and after `k` samples its distance is at "
            "most `A^k (P - B) (A^k)'` with the steady closed loop `A`. It falls like `|z|^(2 k)` "
            "at least, where `z` is the larger pole of `A`. (So does that of any other start, "
            "which is measured here, not proved.)",
            equal(
                _taken(g, R),
                sp.MatAdd(
                    sp.MatMul(left, g, left.T, evaluate=False),
                    sp.MatMul(R, share, share.T, evaluate=False),
                    evaluate=False,
                ),
                free=("g11", "g12", "g22"),
            ),
            "It is the update of `G` by a measurement with the variance of `B`'s innovation, in "
            "Joseph's form a sum of two squares; here that variance is written `r`. (`P11 + r` is "
            "`P11 - B11` and the variance of `B`'s innovation.)",
            tower="pair",
        ),
        Step(
            "difference-determinant",
            "The determinant of the difference shrinks by `1 - K1` and `1 - C1`, near the steady "
            "state by the square of the product of its poles.",
            equal(
                (x - y).det(),
                (1 - k1) * (1 - c1) * gap.det(),
            ),
            "The determinant of step @difference; that of `F (I - K H)` is `1 - K1`.",
            tower="pair",
        ),
        Step(
            "poles",
            "The poles of a closed loop are the roots of this polynomial.",
            equal(
                (z * sp.eye(2) - one).det(),
                z**2 - (2 - k1 - T * k2) * z + 1 - k1,
                free=("z",),
            ),
            "The determinant of `z I - F (I - K H)`.",
            tower="pair",
        ),
    ]


def _taken(g: sp.ImmutableDenseMatrix, variance: sp.Expr) -> sp.ImmutableDenseMatrix:
    """G - G H' H G/(H G H' + variance)."""
    column = g[:, 0]
    return sp.ImmutableDenseMatrix(g - column * column.T / (g[0, 0] + variance))
