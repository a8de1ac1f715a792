"""Steps on two covariances of three states under the same measurements."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.recursion.triple_names import ENTRIES, GAINS, R, T, filled, transition
from gainproof.derive.recursion.triple_steps_update import rest
from gainproof.derive.relation import equal


def difference_steps() -> list[Step]:
    """From one sample to the next the difference is multiplied from both sides."""
    names = [[f"{letter}{ij}" for ij in ENTRIES] for letter in ("p", "b", "g")]
    p, b, g = (filled([real(name) for name in each]) for each in names)
    free = (*names[0], *names[1])
    taken = _updated(p) - _updated(b)
    gap = sp.ImmutableDenseMatrix(p - b)
    share = sp.ImmutableDenseMatrix(g[:, 0] / (g[0, 0] + R))
    left = rest(tuple(share))
    z, gains = real("z"), tuple(map(real, GAINS))
    loop = transition(T) * rest(gains)
    return [
        Step(
            "difference",
            "Two covariances `P` and `B` under the same measurement, with gains `K` and `C`: their "
            "updates differ by `(I - K H) (P - B) (I - C H)'`. A motion `F` on both sides makes "
            "closed loops of both matrices, and the process noise drops out.",
            equal(
                sp.ImmutableDenseMatrix(taken),
                sp.MatMul(_loop(p), gap, _loop(b).T, evaluate=False),
                free=free,
            ),
            "Insert `X = P - P H' H P/(P11 + r)` for both; multiply out.",
            tower="pair",
            heading="How fast a start is forgotten",
        ),
        Step(
            "difference-left",
            "With the matrix of `B` on both sides a square is left over.",
            equal(
                sp.ImmutableDenseMatrix(taken),
                sp.MatMul(
                    _loop(b),
                    gap - gap[:, 0] * gap[:, 0].T / (p[0, 0] + R),
                    _loop(b).T,
                    evaluate=False,
                ),
                free=free,
            ),
            "Insert both updates.",
            tower="pair",
        ),
        Step(
            "difference-one-sided",
            "What is left of a matrix `G`, here `P - B`, after this square is taken away is not "
            "below zero where `G` is not, and never above `G`. So a start above the steady state "
            "stays above it, and after `k` samples its distance is at most `A^k (P - B) (A^k)'` "
            "with the steady closed loop `A`: it falls like `|z|^(2 k)` at least, where `z` is the "
            "largest pole of `A`. (So does that of any other start, which is not proved here.)",
            equal(
                sp.ImmutableDenseMatrix(g - g[:, 0] * g[:, 0].T / (g[0, 0] + R)),
                sp.MatAdd(
                    sp.MatMul(left, g, left.T, evaluate=False),
                    sp.MatMul(R, share, share.T, evaluate=False),
                    evaluate=False,
                ),
                free=tuple(names[2]),
            ),
            "It is the update of `G` by a measurement with the variance of `B`'s innovation, in "
            "Joseph's form a sum of two squares; here that variance is written `r`. (`P11 + r` is "
            "`P11 - B11` and the variance of `B`'s innovation.)",
            tower="pair",
        ),
        Step(
            "poles",
            "The poles of a closed loop `A = F (I - K H)` are the roots of this polynomial. With "
            "the steady gains of equal intervals its roots lie inside the unit circle, as the "
            "derivations of the four steady states prove.",
            equal((z * sp.eye(3) - loop).det(), _polynomial(z, gains), free=("z", *GAINS)),
            "The determinant of `z I - F (I - K H)`.",
            tower="pair",
        ),
        Step(
            "poles-product",
            "So the determinant of the difference shrinks by `1 - K1` and `1 - C1` from sample to "
            "sample, near the steady state by the square of the product of its poles.",
            equal(loop.det(), 1 - gains[0], free=(GAINS[0],)),
            "That of `F` is 1; take determinants in step @difference.",
            tower="pair",
        ),
    ]


def _polynomial(z: sp.Expr, gains: tuple[sp.Expr, ...]) -> sp.Expr:
    """Sorted by powers of z."""
    loop = transition(T) * rest(gains)
    found = sp.Poly((z * sp.eye(3) - loop).det(), z)
    _, square, linear, last = found.all_coeffs()
    return z**3 - sp.expand(-square) * z**2 + sp.expand(linear) * z - sp.expand(-last)


def _updated(p: sp.ImmutableDenseMatrix) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix(p - p[:, 0] * p[:, 0].T / (p[0, 0] + R))


def _loop(p: sp.ImmutableDenseMatrix) -> sp.ImmutableDenseMatrix:
    return rest(tuple(p[i, 0] / (p[0, 0] + R) for i in range(3)))
