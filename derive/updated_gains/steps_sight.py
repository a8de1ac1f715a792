"""Steps on gains along and across the line of sight, and on their like for each axis."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, product, row
from gainproof.derive.relation import described, equal, same_sign
from gainproof.derive.updated_gains.forms import gains_of, index_of
from gainproof.derive.updated_gains.names import ALPHA, BETA, NOMINAL_ALPHA, NOMINAL_BETA, E, N
from gainproof.derive.updated_gains.towers import CIRCLE

TAU = real("half_tangent")
COSINE, SINE = real("cosine"), real("sine")
GAINS = ("alpha_along", "beta_along", "alpha_across", "beta_across")


def sight_steps() -> list[Step]:
    """The rotated gain, its loop, and what averaging over the variance makes of gains."""
    return [*_gain(), *_loop(), *_averaged()]


def turn() -> sp.ImmutableDenseMatrix:
    """D: from along and across the line of sight to x and y."""
    return sp.ImmutableDenseMatrix([[COSINE, -SINE], [SINE, COSINE]])


def blocks(first: sp.MatrixBase, second: sp.MatrixBase) -> sp.ImmutableDenseMatrix:
    """Block diagonal."""
    return sp.ImmutableDenseMatrix(sp.diag(first, second))


def doubled(matrix: sp.MatrixBase) -> sp.ImmutableDenseMatrix:
    """D for the state x, x', y, y'."""
    return sp.ImmutableDenseMatrix(sp.kronecker_product(matrix, sp.eye(2)))


def _rotated() -> tuple[sp.ImmutableDenseMatrix, sp.ImmutableDenseMatrix]:
    """blkdiag of both gains, and D2 blkdiag D' by entries."""
    a, b, c, d = map(real, GAINS)
    own = blocks(sp.ImmutableDenseMatrix([a, b]), sp.ImmutableDenseMatrix([c, d]))
    lines = []
    for first, second in ((0, 0), (0, 1), (1, 0), (1, 1)):
        along, across = ((a, c), (b, d))[second]
        mixed = (along - across) * COSINE * SINE
        straight = along * COSINE**2 + across * SINE**2
        crossed = along * SINE**2 + across * COSINE**2
        lines.append([straight, mixed] if first == 0 else [mixed, crossed])
    return own, sp.ImmutableDenseMatrix(lines)


def _gain() -> list[Step]:
    own, entries = _rotated()
    a, b, c, d = map(real, GAINS)
    return [
        Step(
            "sight-gain",
            "Range and bearing have errors of their own: gains along the line of sight and across "
            "it, turned into `x` and `y` by the angle `theta` with `D`, for the state `x, x', y, "
            "y'`. With `tau = tan(theta/2)` from 0 on the angle is below half a turn, and half a "
            "turn more changes nothing, as `D` stands on both sides.",
            equal(product(doubled(turn()), own, turn().T.as_immutable()), entries, free=GAINS),
            "Multiply out.",
            tower=CIRCLE,
            heading="Gains along the line of sight",
        ),
        joined(
            "circle",
            equal(row(COSINE, SINE), row((1 - TAU**2) / (1 + TAU**2), 2 * TAU / (1 + TAU**2))),
            tower=CIRCLE,
        ),
        Step(
            "sight-decoupled",
            "It has the form of two filters, one an axis, only where the entries with `c s` are "
            "0: where the gains along and across are equal, or the angle is a multiple of a right "
            "angle. What one axis gets more than the mean of both gains, the other gets less:",
            equal(
                row(entries[0, 0] + entries[2, 1], entries[1, 0] + entries[3, 1]),
                row(a + c, b + d),
                free=GAINS,
            ),
            "`c^2 + s^2 = 1`.",
            tower=CIRCLE,
        ),
    ]


def _loop() -> list[Step]:
    own, entries = _rotated()
    loop = Loop(2)
    move = blocks(loop.transition, loop.transition)
    seen = blocks(loop.row, loop.row)
    inner = sp.ImmutableDenseMatrix((sp.eye(4) - own * seen) * move)
    outer = sp.ImmutableDenseMatrix((sp.eye(4) - entries * seen) * move)
    return [
        Step(
            "sight-loop",
            "Errors of the estimates, carried on by `(I - K H) F`: turned into the line of sight "
            "they are those of two filters, one along and one across. So at a steady angle the "
            "filter is stable where both are, whatever the angle is.",
            equal(
                outer,
                product(doubled(turn()), inner, doubled(turn()).T.as_immutable()),
                free=GAINS,
            ),
            "`D2` commutes with `F`, and `H D2 = D H`.",
            tower=CIRCLE,
        ),
        Step(
            "sight-turning",
            "Where the angle turns from scan to scan, the errors in the line of sight are turned "
            "by the difference of angles between two scans; that couples them.",
            described("D2(theta_{k+1})' D2(theta_k) stands between two steps"),
            "Step @sight-loop at both angles.",
        ),
    ]


def _averaged() -> list[Step]:
    here, there = real("position_variance"), real("nominal_variance")
    gap = there - here

    def above(gain: sp.Expr, other: sp.Expr) -> sp.Expr:
        slope = sp.Derivative(gain, here)
        return other - (gain + slope * gap)

    def form(number: int) -> dict[str, sp.Expr]:
        """The factor that is positive."""
        gain, variance = gains_of(E)[number], 1 / index_of(E) ** 2
        slope = sp.diff(gain, E) / sp.diff(variance, E)
        tangent = gain + slope * (1 / index_of(N) ** 2 - variance)
        return {"form": sp.factor((gains_of(N)[number] - tangent) / (E - N) ** 2)}

    return [
        Step(
            "variance",
            "Against variances: in units of `(sigma_w T^2)^2` the variance of an axis is",
            equal(
                row(here, there),
                row((1 + E) ** 2 / (4 * E**4), (1 + N) ** 2 / (4 * N**4)),
            ),
            "`R = 1/Lambda^2`.",
            heading="An axis between both",
        ),
        Step(
            "convex",
            "Over the variance the gains bend up: each is above its tangents.",
            same_sign(above(ALPHA, NOMINAL_ALPHA), (E - N) ** 2),
            "But for the square there is no minus sign.",
            hint=form(0),
        ),
        joined("convex-beta", same_sign(above(BETA, NOMINAL_BETA), (E - N) ** 2), hint=form(1)),
        Step(
            "mixture",
            "The variance of axis `x` is `R_r cos^2 theta + R_theta sin^2 theta`. By step @convex "
            "the gain for that variance is below the same mixture of the gains along and across: "
            "the filters of the axes are slower than the filter of the line of sight in both "
            "diagonal entries, but where it has the form of theirs.",
            described("a function that bends up is at a mean at most the mean of its values"),
            "The tangent at the mean, step @convex, at both places, weighed with `cos^2` and "
            "`sin^2`: the terms of the slope cancel.",
        ),
    ]
