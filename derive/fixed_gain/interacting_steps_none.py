"""Steps that show that no gain of the position is best in the order of matrices: an example."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.interacting_example import Example
from gainproof.derive.fixed_gain.interacting_setting import (
    EVERYWHERE,
    K1,
    K2,
    OTHER,
    PHI,
    SCALE,
    SCALED,
    SCALED_GAIN,
    SECOND_NOISE,
    SETTING,
    STEADY,
    B,
    F,
    K,
    W,
    closed,
)
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning
from gainproof.derive.fixed_gain.interacting_steps_sharing import EXAMPLE
from gainproof.derive.relation import equal
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import prove_equal

A = real("alpha")
PREDICTION = Example("p", EXAMPLE, sp.ImmutableDenseMatrix([["1/2", "1/16"], [1, "1/2"]]))
UPDATE = Example("s", EXAMPLE, sp.ImmutableDenseMatrix([["3/4", "1/20"], [1, 1]]))
LATEX = {**PREDICTION.latex, **UPDATE.latex}
SECOND_STEADY = equation(OTHER, F @ OTHER @ F.T + PHI @ K @ SECOND_NOISE @ K.T @ PHI.T)


def tower() -> Tower:
    """The numbers of both examples."""
    return Tower(EXAMPLE, (), (), {**PREDICTION.elements, **UPDATE.elements})


def none_steps() -> list[Step]:
    """Scaling one coordinate leaves only diagonal gains, and one that is not does better."""
    return [*_scaling(), *_example()]


def _scaling() -> list[Step]:
    commuting = [equation(SCALED @ SCALE, SCALE @ K1), equation(SCALE @ K2, K2 @ SCALE)]
    loop = closed(SCALED_GAIN)
    covariance = EVERYWHERE @ W @ EVERYWHERE.T
    return [
        prove_equal(
            "scaled-steady",
            Search(SETTING, [STEADY, *commuting], taken=[(EVERYWHERE, STEADY, EVERYWHERE.T)]),
            covariance,
            loop @ covariance @ loop.T
            + PHI @ SCALED_GAIN @ (SCALE @ B @ SCALE.T) @ SCALED_GAIN.T @ PHI.T,
        ).step(
            "Among gains that interact there is no best one in the order of matrices, even where "
            "all is symmetric: `d = 2`, `T = 1`, `K2 = I`, `B = I`. To see it, first change "
            "units: let a matrix `A` commute with `K2`. If `W` is steady for `K1` and the noise "
            "`B`, the same in the units of `A` is steady for `A K1 A^-1` and `A B A'`, and one "
            "filter is as stable as the other.",
            "`A` on positions and velocities commutes with `Phi` and takes `H` along.",
            heading="No best gain in the order of matrices",
        ),
        meaning("everywhere"),
        meaning("scaled_gain"),
        prove_equal(
            "noise-adds",
            Search(SETTING, [STEADY, SECOND_STEADY]),
            W + OTHER,
            F @ (W + OTHER) @ F.T + PHI @ K @ (B + SECOND_NOISE) @ K.T @ PHI.T,
        ).step(
            "Suppose `K1` is best, and let `V1` and `V2` be its steady covariances for the noises "
            "`diag(1, 0)` and `diag(0, 1)`; for `diag(1, b)` it is `V1 + b V2`, since noises add. "
            "With `A = diag(1, 2)` the gain `A K1 A^-1` has, for the noise `I = A diag(1, 1/4) "
            "A'`, the first variance that `K1` has for `diag(1, 1/4)`. As `K1` is best this is "
            "not below the one for `I`: so `V2` has no part in the first variance. By step "
            "@position-floor, with `B = diag(0, 1)`, the entry of `K1` from the second coordinate "
            "to the first is then 0.",
            "Add the two equations.",
        ),
    ]


def _example() -> list[Step]:
    first, second = PREDICTION.covariance[0, 0], UPDATE.updated[0, 0]
    least = sp.Rational(7, 9)
    return [
        *PREDICTION.stable(
            "The same with the coordinates exchanged: a best `K1` is diagonal, each coordinate an "
            "alpha-beta filter with `beta = 1`, and its variance not below 3 (step @sharing-least "
            "with `r = 1`). But here is a stable filter that interacts, its `K1` having the rows "
            "`(1/2, 1/16)` and `(1, 1/2)`,",
            "Schur-Cohn, in numbers.",
        ),
        PREDICTION.steady("with the steady covariance", "Multiply out."),
        Step(
            "prediction-smaller",
            "whose first variance is smaller: the second coordinate serves the first as a memory. "
            "So no `K1` is best in the order of matrices; which one is depends on the direction, "
            "or the trace, that is asked for.",
            equal(sp.Add(sp.Integer(3), -first, evaluate=False), 3 - first),
            "Subtract.",
            EXAMPLE,
        ),
        Step(
            "updated-axis-least",
            "Nor is there one for the covariance of the updated position (NP-S). It is carried "
            "along by step @scaled-steady as `W` is, linear in the noise, and not below `K1 B "
            "K1'` (step @updated-floor): again a best `K1` is diagonal. By step @axis-updated "
            "with `beta = 1` its variances are not below `7/9`:",
            equal(
                (2 * A**2 - 3 * A + 2) / (A * (3 - 2 * A)) - least,
                2 * (4 * A - 3) ** 2 / (9 * A * (3 - 2 * A)),
                free=("alpha",),
            ),
            "Common denominator; `0 < alpha < 3/2` are the stable ones.",
            EXAMPLE,
        ),
        *UPDATE.stable(
            "But here is a stable filter that interacts, its `K1` having the rows `(3/4, 1/20)` "
            "and `(1, 1)`,",
            "Schur-Cohn, in numbers.",
        ),
        UPDATE.steady("with the steady covariance", "Multiply out."),
        Step(
            "update-smaller",
            "from which the first variance of the update, `(I - K1) W11 (I - K1)' + K1 K1'`, is "
            "smaller:",
            equal(UPDATE.updated, _updated()),
            "Multiply out, and subtract.",
            EXAMPLE,
        ),
        joined(
            "update-smaller-by",
            equal(sp.Add(least, -second, evaluate=False), least - second),
            EXAMPLE,
        ),
    ]


def _updated() -> sp.MatAdd:
    rest = (sp.eye(2) - UPDATE.position).as_immutable()
    predicted = UPDATE.covariance[:2, :2].as_immutable()
    return sp.MatAdd(
        sp.MatMul(rest, predicted, rest.T.as_immutable()),
        sp.MatMul(UPDATE.position, UPDATE.position.T.as_immutable()),
    )
