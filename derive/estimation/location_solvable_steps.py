"""Steps on when biases, position and velocity can be estimated: (68)-(85), and the rank of B."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_facts import Found, Known, known, weight
from gainproof.derive.estimation.location_setting import (
    A_CLEAN,
    A_KEPT,
    A_L,
    BENT,
    D11,
    D12,
    DOPPLER,
    DOPPLER_GRAM,
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
    RANGE,
    UNIT_N,
    A,
    B,
    H,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.relation import cited
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import ZERO, symbol
from gainproof.derive.words.hypotheses import definite
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
    """Fewer biases can be estimated where all can; and what that takes of the Doppler."""
    return [*_blocks(), *_fewer(found), *_doppler(found)]


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
            "With (75), `H' H = I`, the blocks (77), (78) of `A_nb' A_nb` and the difference (80) "
            "follow; (81) is not negative, being the square of `(I - H H') A_l`; so (82) and (83), "
            "and (84) for no biases.",
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


def doppler_gram(_: Found) -> list[Statement]:
    """B' B > 0 under A' A > 0, and its inverse."""
    positive = prove_order(
        "doppler-gram-definite",
        Search(LOCATION, [FULL]),
        DOPPLER_GRAM,
        ZERO,
        [Square(BENT, FULL, left_inverse=N_FULL)],
        strict=True,
    )
    regular = prove_invertible(
        "doppler-gram-regular", Search(LOCATION, using=[positive]), "doppler_gram", positive
    )
    return [positive, regular]


def _doppler(found: Found) -> list[Step]:
    given = definite("doppler_gram")
    return [
        prove_equal("bent-columns", Search(LOCATION), A @ BENT, DOPPLER @ B).step(
            "(68) is a statement on the Doppler alone: `A' A > 0` if and only if `B' B > 0` for "
            "the `n` by `2 d` matrix `B` of (123). Position and velocity with the biases that "
            "undo them in every range leave the Doppler.",
            "`A' A` is the sum of the squares of `E_l' A` and of `B N_a`; `[N_a' - S_b A_l T_l', "
            "S_b]` is invertible.",
        ),
        *meanings(LOCATION, "B bent doppler_gram"),
        *together(
            [
                found.of(doppler_gram)[0],
                prove_order(
                    "gram-from-doppler",
                    Search(LOCATION, [given]),
                    GRAM,
                    ZERO,
                    [
                        Square(RANGE.T @ A, ("unit", "n"), left_inverse=FULL_B),
                        Square(N_FULL, given, left_inverse=BENT),
                    ],
                    strict=True,
                ),
            ]
        ),
        Step(
            "station-count",
            "So the detection of biases, and Doppler alone, take at least as many stations as "
            "there are unknowns of the course, 6 in space and 4 in a plane, however many ranges.",
            cited(
                "A matrix with fewer rows than columns takes some column other than 0 to 0.",
                MATRICES.text(),
            ),
            "`B' B > 0` needs independent columns of `B`, and `B` has `n` rows.",
            LOCATION.name,
        ),
    ]
