"""Steps on parts of an estimate: properties 6, 7 and 12, (46)-(54), (91)-(95)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation import least_squares_steps
from gainproof.derive.estimation.linear_facts import Facts
from gainproof.derive.estimation.linear_setting import (
    COVARIANCE,
    ESTIMATE,
    GAIN,
    LINEAR,
    MEAN_V,
    MEAN_Z,
    MODEL,
    NOISE,
    ROW,
    TRUTH,
    A,
    N,
    V,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.words.expression import ZERO, symbol
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, prove_equal, prove_order

ONE, PART = symbol("unit_one"), symbol("unit_chosen")
REPLACED = ("observed", "mean_observed", "mean_error")


def parts_steps(known: Facts) -> list[Step]:
    gap = N @ ESTIMATE - N @ TRUTH
    rows, length = equation(N @ N.T, PART), equation(ROW.T @ ROW, ONE)
    return [
        least_squares_steps.equal("part-error", known, gap, N @ GAIN @ NOISE, MODEL).step(
            "Properties 6, 7 and 12: any part `N a` of the unknowns, (46), (51) and (93), is "
            "estimated by the same part of the estimate, unbiased and with the covariance (48), "
            "(53), (95):",
            "`N` times the above.",
        ),
        *together(
            [
                prove_equal(
                    "part-unbiased",
                    Search(
                        LINEAR,
                        [equation(MEAN_Z, A @ TRUTH + MEAN_V), equation(MEAN_V, ZERO)],
                        [known.regular],
                        heavy=REPLACED,
                    ),
                    N @ GAIN @ MEAN_Z,
                    N @ TRUTH,
                ),
                least_squares_steps.equal(
                    "part-covariance", known, N @ GAIN @ V @ GAIN.T @ N.T, COVARIANCE
                ),
            ]
        ),
        *meanings(LINEAR, "chosen_covariance"),
        prove_order(
            "part-definite",
            Search(LINEAR, [rows], [known.covariance_definite]),
            COVARIANCE,
            ZERO,
            [Square(N.T, known.covariance_definite, left_inverse=N)],
            strict=True,
        ).step(
            "(54): if the rows of `N` are rows of a unit matrix, so `N N' = I`, each variance on "
            "the diagonal is positive; `e` is a column of a unit matrix.",
            "`M^-1 > 0` (A7 and A5).",
        ),
        *together(
            [
                prove_order(
                    "part-variance",
                    Search(LINEAR, [rows, length], [known.covariance_definite]),
                    ROW.T @ COVARIANCE @ ROW,
                    ZERO,
                    [Square(N.T @ ROW, known.covariance_definite, left_inverse=ROW.T @ N)],
                    strict=True,
                )
            ]
        ),
    ]
