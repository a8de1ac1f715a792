"""Steps on weighted least squares: the minimum, means and covariances (properties 4 to 9, 12)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.linear_facts import Facts, facts
from gainproof.derive.estimation.linear_setting import (
    ANY,
    COST,
    ESTIMATE,
    GAIN,
    LEAST,
    LEFT_OUT,
    LEFT_VALUES,
    LINEAR,
    MEAN_V,
    MEAN_Z,
    MODEL,
    NOISE,
    POSITIVE,
    TRUTH,
    UNIT,
    A,
    M,
    V,
    Z,
)
from gainproof.derive.estimation.spoken import meanings, said, together
from gainproof.derive.words.expression import ZERO, Expression, symbol
from gainproof.derive.words.hypotheses import Hypothesis, equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_equal_by_definite,
    prove_order,
)

ONE, PART = symbol("unit_one"), symbol("unit_chosen")
REPLACED = ("observed", "mean_observed", "mean_error")


def least_squares_steps() -> list[Step]:
    """The estimate, why it is the least, its mean and its covariance."""
    known = facts()
    return [*_minimum(known), *_mean(known), *_covariance(known)]


def equal(
    name: str, known: Facts, left: Expression, right: Expression, *given: Hypothesis
) -> Statement:
    search = Search(LINEAR, [POSITIVE, *given], known.equations, heavy=REPLACED)
    return prove_equal(name, search, left, right)


def _minimum(known: Facts) -> list[Step]:
    change = ANY - ESTIMATE
    same = equation(COST, LEAST)
    return [
        said(
            LINEAR,
            "model",
            "Any linear model: measurements `z`, unknowns `a`, noise `v` of mean 0 and covariance "
            "`V > 0`, (30), (35), (36). The sizes have names and no values, and may be 0.",
            "z = A a + v; M: A' V^-1 A",
            "What follows holds for every `A`: (32) of the detection of biases, (61) of the "
            "method with fewer unknowns, and any other.",
            heading="Weighted least squares",
        ),
        known.noise_regular.step(
            "The weight `V^-1` exists, is symmetric and positive definite. If `M` has an inverse, "
            "both are positive definite too.",
            "`V^-1` is the square of itself around `V`, `M` that of `A` around `V^-1`.",
        ),
        *together(
            [
                known.noise_symmetric,
                known.noise_definite,
                known.regular,
                known.definite,
                known.symmetric,
                known.covariance_definite,
            ]
        ),
        *meanings(LINEAR, "information"),
        equal("normal-equations", known, A.T @ V.inverse @ (Z - A @ ESTIMATE), ZERO).step(
            "Properties 4 and 8: the estimate (40), (65) solves the normal equations, and the "
            "cost (64) of any other `x` exceeds its own by a square. So it is the minimum, and no "
            "other `x` has this cost.",
            "Multiply out; the mixed terms are the normal equations.",
        ),
        *meanings(LINEAR, "estimator estimate cost least_cost"),
        *together(
            [
                equal("completed-square", known, COST, LEAST + change.T @ M @ change),
                prove_order(
                    "least-cost",
                    Search(LINEAR, [POSITIVE], [*known.equations, known.definite]),
                    COST,
                    LEAST,
                    [Square(change, known.definite)],
                ),
                prove_equal_by_definite(
                    "only-estimate",
                    Search(LINEAR, [POSITIVE, same], [*known.equations, known.definite]),
                    ANY,
                    ESTIMATE,
                    known.definite,
                    "left",
                ),
            ]
        ),
    ]


def _mean(known: Facts) -> list[Step]:
    mean = [equation(MEAN_Z, A @ TRUTH + MEAN_V), equation(MEAN_V, ZERO)]
    missed = equation(Z, A @ TRUTH + LEFT_OUT @ LEFT_VALUES + NOISE)
    return [
        equal("unit-response", known, GAIN @ A, UNIT).step(
            "Properties 5 and 9, (41) and (66): the estimate is linear in `z`, and the mean is "
            "linear, so it is unbiased: with the means `z_m` of `z` and `v_m = 0` of `v`",
            "`K A = I`.",
        ),
        *together(
            [
                equal("error-of-estimate", known, ESTIMATE - TRUTH, GAIN @ NOISE, MODEL),
                prove_equal(
                    "unbiased",
                    Search(LINEAR, mean, [known.regular], heavy=REPLACED),
                    GAIN @ MEAN_Z,
                    TRUTH,
                ),
            ]
        ),
        equal(
            "left-out",
            known,
            ESTIMATE - TRUTH,
            GAIN @ LEFT_OUT @ LEFT_VALUES + GAIN @ NOISE,
            missed,
        ).step(
            "That takes the model to be right: where unknowns `c` with columns `T` are left out "
            "though they are not 0, as biases of ranges that pass as clean, their share stays. And "
            "it takes the columns to be chosen beforehand: if (55) chooses them by the same `z`, "
            "(66) and (67) hold of each choice, not of the mixture.",
            "Insert.",
        ),
    ]


def _covariance(known: Facts) -> list[Step]:
    gap = ESTIMATE - TRUTH
    return [
        prove_equal(
            "product-of-errors",
            Search(LINEAR, [MODEL], [known.regular], heavy=REPLACED),
            gap @ gap.T,
            GAIN @ NOISE @ NOISE.T @ GAIN.T,
        ).step(
            "(42) and (67): the mean of `v v'` is `V`, so the covariance of the estimate is",
            "The mean of the product of the errors, which is linear in `v v'`.",
        ),
        *together([equal("covariance", known, GAIN @ V @ GAIN.T, M.inverse)]),
    ]
