"""Steps that show that no gain of the position is best in the order of matrices: an example."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
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
from gainproof.derive.relation import Relation, equal
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import prove_equal

POSITION = sp.ImmutableDenseMatrix(
    [[sp.Rational(1, 2), sp.Rational(1, 16)], [1, sp.Rational(1, 2)]]
)
VELOCITY = sp.eye(2).as_immutable()
PHI_2 = sp.ImmutableDenseMatrix(4, 4, lambda i, j: int(i == j or j == i + 2))
SEEN = sp.ImmutableDenseMatrix(2, 4, lambda i, j: int(i == j))
GAIN = POSITION.col_join(VELOCITY).as_immutable()
LATEX = {"half": "k_{11}", "memory": "k_{12}", "one": "k_{21}", "none": "k_{32}"}
NAMES = (("half", "memory"), ("one", "half"), ("one", "none"), ("none", "one"))
"""The entries of the gain by name."""


SECOND_STEADY = equation(OTHER, F @ OTHER @ F.T + PHI @ K @ SECOND_NOISE @ K.T @ PHI.T)


def tower() -> Tower:
    """The numbers of the example."""
    numbers = {NAMES[i][j]: GAIN[i, j] for i in range(4) for j in range(2)}
    return Tower(EXAMPLE, (), (), numbers)


def example_covariance() -> sp.ImmutableDenseMatrix:
    """The steady covariance of the example, from its linear equations."""
    loop = PHI_2 * (sp.eye(4) - GAIN * SEEN)
    entries = {(i, j): sp.Symbol(f"w{i}{j}") for j in range(4) for i in range(j + 1)}
    found = sp.Matrix(4, 4, lambda i, j: entries[min(i, j), max(i, j)])
    added = PHI_2 * GAIN * GAIN.T * PHI_2.T
    solved = sp.solve(list(found - loop * found * loop.T - added), list(entries.values()))
    return sp.ImmutableDenseMatrix(found.subs(solved))


def _model() -> dict[str, object]:
    def rows(matrix: sp.MatrixBase) -> list[list[str]]:
        return [[str(entry) for entry in matrix.row(i)] for i in range(matrix.rows)]

    return {
        "name": "two-coordinates",
        "title": "Two coordinates at constant velocity",
        "transition": rows(PHI_2),
        "process_noise": rows(sp.zeros(4, 4)),
        "measurement": rows(SEEN),
        "measurement_noise": rows(sp.eye(2)),
    }


def _schur_cohn() -> dict[str, list[sp.Expr]]:
    """The hint of the stability: coefficients, and a_n - a_0 and a_n + a_0 of each degree."""
    z = real("z")
    loop = PHI_2 * (sp.eye(4) - GAIN * SEEN)
    coefficients = (z * sp.eye(4) - loop).det().as_poly(z).all_coeffs()[::-1]
    rest, values = coefficients, []
    while len(rest) > 1:
        low, high = rest[0], rest[-1]
        values += [high - low, high + low]
        rest = [high * rest[k + 1] - low * rest[-k - 2] for k in range(len(rest) - 1)]
    return {"coefficients": coefficients[:-1], "values": values}


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
    found = example_covariance()
    loop = sp.ImmutableDenseMatrix(PHI_2 * (sp.eye(4) - GAIN * SEEN))
    noise = sp.ImmutableDenseMatrix(PHI_2 * GAIN)
    names = sp.ImmutableDenseMatrix([[real(name) for name in row] for row in NAMES])
    return [
        Step(
            "example-stable",
            "The same with the coordinates exchanged: a best `K1` is diagonal, each coordinate an "
            "alpha-beta filter with `beta = 1`, and its variance not below 3 (step @sharing-least "
            "with `r = 1`). But here is a stable filter that interacts, its `K1` having the rows "
            "`(1/2, 1/16)` and `(1, 1/2)`,",
            Relation("stable", {"model": _model(), "gain": [list(row) for row in NAMES]}),
            "Schur-Cohn, in numbers.",
            EXAMPLE,
            _schur_cohn(),
        ),
        joined("example-gain", equal(names, GAIN), EXAMPLE),
        Step(
            "example-steady",
            "with the steady covariance",
            equal(
                found,
                sp.MatAdd(
                    sp.MatMul(loop, found, loop.T.as_immutable()),
                    sp.MatMul(noise, noise.T.as_immutable()),
                ),
            ),
            "Multiply out.",
            EXAMPLE,
        ),
        Step(
            "example-smaller",
            "whose first variance is smaller: the second coordinate serves the first as a memory. "
            "So no `K1` is best in the order of matrices; which one is depends on the direction, "
            "or the trace, that is asked for.",
            equal(sp.Add(sp.Integer(3), -found[0, 0], evaluate=False), sp.Rational(2, 45)),
            "Subtract.",
            EXAMPLE,
        ),
    ]
