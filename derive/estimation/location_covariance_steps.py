"""Steps on the covariance of position and velocity with fewer biases: property 13, (96)-(110)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_facts import Found, Known, known, noise_blocks, weight
from gainproof.derive.estimation.location_setting import (
    BIAS_M,
    CLEAN_M,
    K11,
    K12,
    KEPT_B,
    KEPT_C,
    KEPT_M,
    LOCATION,
    N_FULL,
    N_KEPT,
    ORTHONORMAL,
    UNIT_K,
    H,
    P,
    Q,
)
from gainproof.derive.estimation.location_solvable_steps import full_information, kept_information
from gainproof.derive.estimation.spoken import known_inverse, meanings, together
from gainproof.derive.words.expression import ZERO, Expression
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, Statement, prove_equal, prove_order

UNIT = Expression("unit", "k")


def bias_information(found: Found) -> Known:
    """H' G11 H > 0, its inverse."""
    made = found.of(weight)
    inner = found.of(noise_blocks)["G11"]
    squares = [Square(H, inner.positive, left_inverse=H.T)]
    search = Search(LOCATION, [ORTHONORMAL], [inner.positive])
    return known("bias_information", squares, search, made[1:2])


def covariance_steps(found: Found) -> list[Step]:
    """The inverse of the covariance, and what of it the biases take away."""
    return [*_blocks(found), *_inverse(found), *_not_negative(found), *_clean(found)]


def _blocks(found: Found) -> list[Step]:
    turned = found.of(weight)[1]
    in_blocks = (
        N_KEPT.T @ K11 @ N_KEPT + N_KEPT.T @ K12 @ KEPT_B.T + KEPT_B @ K12.T @ N_KEPT
    ) + KEPT_B @ BIAS_M @ KEPT_B.T
    return [
        prove_equal("information-blocks", Search(LOCATION, [], [turned]), KEPT_M, in_blocks).step(
            "Property 13: (105) is `A_nb' V^-1 A_nb` in blocks, with (97) to (100) and (106), and "
            "(107) says how its corner comes from (98).",
            "Multiply out; `V^-1` is symmetric.",
            heading="Covariance of position and velocity",
        ),
        *meanings(LOCATION, "G12 G22 J11 J12 K11 K12 P bias_information"),
        *together(
            [prove_equal("information-corner", Search(LOCATION, [], [turned]), K12, P.T @ H)]
        ),
    ]


def kept_inverse(found: Found) -> list[Statement]:
    """(108), (103): the inverse of the covariance with fewer biases."""
    turned, kept, biases = (
        found.of(weight)[1],
        found.of(kept_information),
        found.of(bias_information),
    )
    value = K11 - K12 @ BIAS_M.inverse @ K12.T
    inverse = ("inverse", kept.regular.id, "right")
    product = prove_equal(
        "kept-covariance-product",
        Search(
            LOCATION,
            [],
            [turned, *biases.equations],
            aside=[kept.regular],
            taken=[
                (N_KEPT, inverse, N_KEPT.T),
                (-K12 @ BIAS_M.inverse @ KEPT_B.T, inverse, N_KEPT.T),
            ],
        ),
        value @ KEPT_C,
        UNIT_K,
    )
    made = [product, *known_inverse("kept-covariance-inverse", KEPT_C, value, product)]
    short = prove_equal(
        "kept-covariance-inverse-short",
        Search(
            LOCATION,
            [],
            [turned, *biases.equations],
            aside=[made[-1]],
            taken=[(UNIT, made[-1], UNIT)],
        ),
        KEPT_C.inverse,
        K11 - P.T @ Q @ P,
    )
    return [*made, short]


def _inverse(found: Found) -> list[Step]:
    biases, inverse = found.of(bias_information), found.of(kept_inverse)
    return [
        biases.positive.step(
            "The biases alone have the information `G_b = H' G11 H > 0`. Without the biases' part "
            "the inverse of the covariance (95) would be `K11`; they take away `P' Q_nb P`, (103), "
            "(108), (101):",
            "Multiply (105) by its inverse, and eliminate the corner: theorem 1.",
        ),
        *together([biases.regular, biases.symmetric, *inverse]),
        *meanings(LOCATION, "kept_covariance Q"),
    ]


def _not_negative(found: Found) -> list[Step]:
    biases = found.of(bias_information)
    inverse = prove_order(
        "bias-weight-definite",
        Search(LOCATION, [], [*biases.equations, biases.positive]),
        BIAS_M.inverse,
        ZERO,
        [Square(BIAS_M.inverse, biases.positive, left_inverse=BIAS_M)],
        strict=True,
    )
    return [
        inverse.step("(104): what they take away is not negative.", "A7 twice."),
        *together(
            [
                prove_order(
                    "bias-share",
                    Search(LOCATION, [], [inverse]),
                    Q,
                    ZERO,
                    [Square(H.T, inverse)],
                ),
                prove_order(
                    "taken-away",
                    Search(LOCATION, [], [inverse]),
                    P.T @ Q @ P,
                    ZERO,
                    [Square(H.T @ P, inverse)],
                ),
            ]
        ),
    ]


def clean_information(found: Found) -> Known:
    """A_n' V^-1 A_n > 0 under V > 0 and A' A > 0."""
    full = found.of(full_information)
    squares = [Square(N_FULL.T, full.positive, left_inverse=N_FULL)]
    search = Search(LOCATION, [], [full.positive])
    return known("clean_information", squares, search, found.of(weight)[1:2])


def _clean(found: Found) -> list[Step]:
    clean = found.of(clean_information)
    return [
        prove_equal("clean-blocks", Search(LOCATION, [], found.of(weight)[1:2]), CLEAN_M, K11).step(
            "(109), (110) and (102): with no bias unknown nothing is taken away, `Q_n = 0`.",
            "`N` is the unit matrix there.",
        ),
        *together(clean.all),
        *meanings(LOCATION, "clean_information"),
    ]
