"""Steps on when biases, position and velocity can be estimated: (68)-(85), and the rank of B."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_facts import Found, Known, known, weight
from gainproof.derive.estimation.location_setting import (
    A_CLEAN,
    A_KEPT,
    A_L,
    D11,
    D12,
    F12,
    FULL,
    FULL_B,
    GRAM,
    KEPT_B,
    KEPT_GRAM,
    KEPT_MAP,
    LOCATION,
    N_FULL,
    N_KEPT,
    ORTHONORMAL,
    POSITION,
    POSITIVE,
    UNIT_N,
    A,
    H,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.words.expression import ZERO, symbol
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)

FREE = UNIT_N - H @ H.T
BACK = N_KEPT.T @ N_FULL + KEPT_B @ H.T @ FULL_B.T


def solvable_steps(found: Found) -> list[Step]:
    """Fewer biases can be estimated where all can."""
    return [*_blocks(), *_fewer(found)]


def _schur() -> Statement:
    return prove_order(
        "gram-schur",
        Search(LOCATION, [FULL]),
        D11 - D12 @ D12.T,
        ZERO,
        [Square(N_FULL.T - FULL_B @ D12.T, FULL, left_inverse=N_FULL)],
        strict=True,
    )


def _blocks() -> list[Step]:
    in_blocks = (
        N_FULL.T @ D11 @ N_FULL + N_FULL.T @ D12 @ FULL_B.T + FULL_B @ D12.T @ N_FULL
    ) + FULL_B @ FULL_B.T
    return [
        prove_equal("gram-blocks", Search(LOCATION), A.T @ A, in_blocks).step(
            "Property 11 as the paper shows it. (70) to (72) are `A' A` in blocks; if it is "
            "positive definite, (68), so are (73) and (74).",
            "(73) is the form of `A' A` on `[I; -D12']`, (74) on `[I; 0]`.",
            heading="When all can be estimated",
        ),
        *meanings(LOCATION, "D11 D12 gram"),
        *together(
            [
                _schur(),
                prove_order(
                    "gram-corner",
                    Search(LOCATION, [FULL]),
                    D11,
                    ZERO,
                    [Square(N_FULL.T, FULL, left_inverse=N_FULL)],
                    strict=True,
                ),
            ]
        ),
    ]


def _kept_blocks() -> list[Statement]:
    """(77), (79), (80), (81)."""
    in_blocks = (
        N_KEPT.T @ D11 @ N_KEPT + N_KEPT.T @ F12 @ KEPT_B.T + KEPT_B @ F12.T @ N_KEPT
    ) + KEPT_B @ KEPT_B.T
    projected = A_L.T @ A_L - A_L.T @ H @ H.T @ A_L
    return [
        prove_equal(
            "kept-gram-blocks", Search(LOCATION, [ORTHONORMAL]), A_KEPT.T @ A_KEPT, in_blocks
        ),
        prove_equal(
            "kept-square",
            Search(LOCATION),
            F12 @ F12.T,
            POSITION @ A_L.T @ H @ H.T @ A_L @ POSITION.T,
        ),
        prove_equal(
            "kept-difference",
            Search(LOCATION),
            (D11 - F12 @ F12.T) - (D11 - D12 @ D12.T),
            POSITION @ projected @ POSITION.T,
        ),
        prove_order(
            "projection",
            Search(LOCATION, [ORTHONORMAL]),
            projected,
            ZERO,
            [Square(FREE @ A_L, ("unit", "n"))],
        ),
        prove_order(
            "kept-schur",
            Search(LOCATION, [ORTHONORMAL]),
            D11 - F12 @ F12.T,
            D11 - D12 @ D12.T,
            [Square(FREE @ A_L @ POSITION.T, ("unit", "n"))],
        ),
    ]


def full_information(found: Found) -> Known:
    """A' V^-1 A > 0 under V > 0 and A' A > 0; its inverse."""
    made = found.of(weight)
    gram = prove_invertible("full-gram-regular", Search(LOCATION, [FULL]), "gram", FULL)
    squares = [Square(A, made[2], left_inverse=GRAM.inverse @ A.T)]
    search = Search(LOCATION, [POSITIVE, FULL], [gram, *made])
    return known("full_information", squares, search, made[1:2])


def kept_information(found: Found) -> Known:
    """(69): A_b' V^-1 A_b > 0 under V > 0, A' A > 0 and H' H = I; its inverse."""
    full = found.of(full_information)
    squares = [Square(KEPT_MAP, full.positive, left_inverse=BACK)]
    search = Search(LOCATION, [ORTHONORMAL], [full.positive])
    return known("kept_information", squares, search, found.of(weight)[1:2])


def _fewer(found: Found) -> list[Step]:
    blocks = _kept_blocks()
    schur = _schur()
    return [
        blocks[0].step(
            "With (75), `H' H = I`, which a column of ones over `sqrt(n)` has too, the blocks "
            "(77), (78) of `A_nb' A_nb` and the difference (80) follow; (81) is not negative, "
            "being the square of `(I - H H') A_l`; so (82) and (83), and (84) for no biases.",
            "Multiply out. (83): `A_nb = A U`, and `U` has a left inverse.",
        ),
        *meanings(LOCATION, "F12 kept_map kept_gram"),
        *together(
            [
                *blocks[1:],
                prove_order(
                    "kept-schur-definite",
                    Search(LOCATION, [ORTHONORMAL], [schur]),
                    D11 - F12 @ F12.T,
                    ZERO,
                    [
                        Square(symbol("I_k"), schur, left_inverse=symbol("I_k")),
                        Square(FREE @ A_L @ POSITION.T, ("unit", "n")),
                    ],
                    strict=True,
                ),
                prove_equal("kept-columns", Search(LOCATION), A_KEPT, A @ KEPT_MAP),
                prove_order(
                    "kept-gram-definite",
                    Search(LOCATION, [FULL, ORTHONORMAL]),
                    KEPT_GRAM,
                    ZERO,
                    [Square(KEPT_MAP, FULL, left_inverse=BACK)],
                    strict=True,
                ),
                prove_equal("clean-gram", Search(LOCATION), A_CLEAN.T @ A_CLEAN, D11),
            ]
        ),
        prove_invertible("full-gram-regular", Search(LOCATION, [FULL]), "gram", FULL).step(
            "So (69): what can be estimated with all biases can be with fewer.",
            "`A_nb' V^-1 A_nb = U' (A' V^-1 A) U`.",
        ),
        *together([*found.of(full_information).all, *found.of(kept_information).all]),
        *meanings(LOCATION, "full_information kept_information"),
    ]
