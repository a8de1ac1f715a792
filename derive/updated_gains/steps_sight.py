"""Steps on gains along and across the line of sight."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, product, row
from gainproof.derive.relation import equal
from gainproof.derive.updated_gains.towers import CIRCLE

Angle = tuple[sp.Expr, sp.Expr]
TAU, LATER_TAU = real("half_tangent"), real("later_half_tangent")
ANGLE = real("cosine"), real("sine")
LATER = real("later_cosine"), real("later_sine")
COSINE, SINE = ANGLE
GAINS = ("alpha_along", "beta_along", "alpha_across", "beta_across")


def sight_steps() -> list[Step]:
    """The rotated gain and its loop, at one angle and at two."""
    return [*_gain(), *_loop(), *_turning()]


def turn(angle: Angle = ANGLE) -> sp.ImmutableDenseMatrix:
    """D: from along and across the line of sight to x and y."""
    cosine, sine = angle
    return sp.ImmutableDenseMatrix([[cosine, -sine], [sine, cosine]])


def blocks(first: sp.MatrixBase, second: sp.MatrixBase) -> sp.ImmutableDenseMatrix:
    """Block diagonal."""
    return sp.ImmutableDenseMatrix(sp.diag(first, second))


def doubled(matrix: sp.MatrixBase) -> sp.ImmutableDenseMatrix:
    """D for the state x, x', y, y'."""
    return sp.ImmutableDenseMatrix(sp.kronecker_product(matrix, sp.eye(2)))


def _rotated(angle: Angle = ANGLE) -> tuple[sp.ImmutableDenseMatrix, sp.ImmutableDenseMatrix]:
    """blkdiag of both gains, and D2 blkdiag D' by entries."""
    a, b, c, d = map(real, GAINS)
    cosine, sine = angle
    own = blocks(sp.ImmutableDenseMatrix([a, b]), sp.ImmutableDenseMatrix([c, d]))
    lines = []
    for first, second in ((0, 0), (0, 1), (1, 0), (1, 1)):
        along, across = ((a, c), (b, d))[second]
        mixed = (along - across) * cosine * sine
        straight = along * cosine**2 + across * sine**2
        crossed = along * sine**2 + across * cosine**2
        lines.append([straight, mixed] if first == 0 else [mixed, crossed])
    return own, sp.ImmutableDenseMatrix(lines)


def _gain() -> list[Step]:
    own, entries = _rotated()
    a, b, c, d = map(real, GAINS)
    return [
        Step(
            "sight-gain",
            "Range and bearing have errors of their own: gains along the line of sight and across "
            "it, turned into `x` and `y` by the angle `theta`, with cosine `c_theta` and sine "
            "`s_theta`. The matrix on the right is `D'`: `D` turns two coordinates; that on the "
            "left is `D2`, `D` for the positions and for the velocities of the state `x, x', y, "
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
            "It has the form of two filters, one an axis, only where the entries with "
            "`c_theta s_theta` are 0: where the gains along and across are equal, or the angle is "
            "a multiple of a right angle. What one axis gets more than the mean of both gains, the "
            "other gets less:",
            equal(
                row(entries[0, 0] + entries[2, 1], entries[1, 0] + entries[3, 1]),
                row(a + c, b + d),
                free=GAINS,
            ),
            "`c_theta^2 + s_theta^2 = 1`.",
            tower=CIRCLE,
        ),
    ]


def _loops(angle: Angle) -> tuple[sp.ImmutableDenseMatrix, sp.ImmutableDenseMatrix]:
    """(I - K H) F of both filters, and of the turned gain."""
    loop = Loop(2)
    move = blocks(loop.transition, loop.transition)
    seen = blocks(loop.row, loop.row)
    own, entries = (
        sp.ImmutableDenseMatrix((sp.eye(4) - gain * seen) * move) for gain in _rotated(angle)
    )
    return own, entries


def _loop() -> list[Step]:
    inner, outer = _loops(ANGLE)
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
    ]


def _turning() -> list[Step]:
    inner, outer = _loops(LATER)
    (cosine, sine), (later_cosine, later_sine) = ANGLE, LATER
    between = (
        later_cosine * cosine + later_sine * sine,
        later_cosine * sine - later_sine * cosine,
    )
    return [
        Step(
            "sight-turning",
            "Where the angle turns between two scans, to one of cosine `c_2` and sine `s_2`, the "
            "errors in the line of sight are first turned by the difference of the angles: its "
            "cosine and, but for the sign, its sine are the entries of the last matrix. The sine "
            "couples both filters.",
            equal(
                product(doubled(turn(LATER)).T.as_immutable(), outer, doubled(turn())),
                product(inner, doubled(turn(between))),
                free=GAINS,
            ),
            "Step @sight-loop at the later angle; of `D2'` and `D2` at both angles the product is "
            "left.",
            tower=CIRCLE,
        ),
        joined(
            "later-circle",
            equal(
                row(later_cosine, later_sine),
                row((1 - LATER_TAU**2) / (1 + LATER_TAU**2), 2 * LATER_TAU / (1 + LATER_TAU**2)),
            ),
            tower=CIRCLE,
        ),
    ]
