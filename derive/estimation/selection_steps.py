"""Steps on more clean ranges: property 14 as the paper shows it, (75)-(81), (111)-(121)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.selection_setting import (
    ALWAYS,
    BETWEEN,
    C33,
    F22,
    G11,
    H_L,
    H_S,
    LOWER,
    M_L,
    M_S,
    NEVER,
    PADDED,
    Q_L,
    Q_S,
    SELECTION,
    SOLVABLE,
    UNIT_B,
    UNIT_N,
    UNIT_T,
    WEIGHT,
    P,
)
from gainproof.derive.estimation.spoken import inverse_symmetric, meanings, said, together
from gainproof.derive.words.expression import ZERO, Expression, symbol, unit
from gainproof.derive.words.hypotheses import symmetric
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)


def selection_steps() -> list[Step]:
    """From the columns of the unit matrix to the order of the covariances."""
    return [*_columns(), *_shares(), *_order()]


def _columns() -> list[Step]:
    free = UNIT_N - H_L @ H_L.T
    return [
        said(
            SELECTION,
            "two-choices",
            "Two choices of clean ranges, (111): the first `u` are clean in both, the next `w` in "
            "the larger choice only, the last `b` in neither; `E_1`, `E_2`, `E_3` are their "
            "columns of the unit matrix. `H_L = E_3` and `H_S`, of `E_2` and `E_3`, are (59). Each "
            "of the three numbers may be 0, which the blocks of (114) to (117) then lack; with "
            "`b = 0`, `n_b = n`, `H` has no columns and (101) is the zero matrix (102).",
            "u = n_bS, u + w = n_bL, u + w + b = n",
            "The order of the ranges is arbitrary.",
            heading="More clean ranges",
        ),
        prove_equal("columns-large", Search(SELECTION), H_L.T @ H_L, UNIT_B).step(
            "(75), (76) and (81):", "`E_i' E_i = I`, `E_i' E_j = 0`, and their squares add to `I`."
        ),
        *meanings(SELECTION, "H_small H_large"),
        *together(
            [
                prove_equal("columns-small", Search(SELECTION), H_S.T @ H_S, UNIT_T),
                prove_equal("rows-large", Search(SELECTION), H_L @ H_L.T, NEVER @ NEVER.T),
                prove_equal(
                    "rows-clean",
                    Search(SELECTION),
                    free,
                    ALWAYS @ ALWAYS.T + BETWEEN @ BETWEEN.T,
                ),
                prove_equal("columns-nested", Search(SELECTION), H_S @ LOWER, H_L),
            ]
        ),
    ]


def definite_inverse(letter: str, rows: Expression, left: Expression) -> list[Statement]:
    """The letter is rows' G11 rows > 0; its inverse, symmetric and positive definite."""
    matrix = symbol(letter)
    name = letter.lower()
    positive = prove_order(
        f"{name}-definite",
        Search(SELECTION, [WEIGHT]),
        matrix,
        ZERO,
        [Square(rows, WEIGHT, left_inverse=left)],
        strict=True,
    )
    regular = prove_invertible(
        f"{name}-regular", Search(SELECTION, using=[positive]), letter, positive
    )
    turned = prove_equal(
        f"{name}-symmetric",
        Search(SELECTION, [WEIGHT], [regular], rounds=1),
        matrix.inverse.T,
        matrix.inverse,
    )
    return [positive, regular, turned]


def _facts() -> list[Statement]:
    return [
        *definite_inverse("F22", H_S, H_S.T),
        *definite_inverse("C33", H_L, H_L.T),
    ]


def _padded(facts: list[Statement]) -> Statement:
    """(118)."""
    whole, regular = unit("t"), facts[1].id
    left, right = ("inverse", regular, "left"), ("inverse", regular, "right")
    taken = [(-whole, left, F22.inverse), (whole, left, PADDED), (PADDED, right, whole)]
    return prove_order(
        "padded-below",
        Search(SELECTION, [WEIGHT], facts, taken=taken),
        F22.inverse,
        PADDED,
        [Square(F22.inverse - PADDED, facts[0])],
    )


def _shares() -> list[Step]:
    facts = _facts()
    parts = [
        one @ symbol(f"C{i}{j}") @ other.T if i <= j else one @ symbol(f"C{j}{i}").T @ other.T
        for i, one in enumerate((ALWAYS, BETWEEN, NEVER), 1)
        for j, other in enumerate((ALWAYS, BETWEEN, NEVER), 1)
    ]
    blocks = sum(parts[1:], start=parts[0])
    order = _padded(facts)
    return [
        prove_equal("weight-blocks", Search(SELECTION, [symmetric("G11")]), G11, blocks).step(
            "(114) and (115) are `G11` in blocks, and `F22 = H_S' G11 H_S`; with `G11 > 0` its "
            "blocks have inverses.",
            "`E_1 E_1' + E_2 E_2' + E_3 E_3' = I` on both sides.",
        ),
        *meanings(SELECTION, "C11 C12 C13 C22 C23 C33 F22"),
        *together(
            [
                prove_equal(
                    "small-block",
                    Search(SELECTION, [symmetric("G11")]),
                    F22,
                    H_S.T @ G11 @ H_S,
                ),
                *facts,
            ]
        ),
        order.step(
            "(118), which is (A.3): the inverse of a block with zeros around it is not above the "
            "inverse. So (119), and (120) of the zero matrix: `Q_S >= Q_L >= 0`, with (116) and "
            "(117) for both.",
            "`F22^-1 - Q_t` is the square of itself around `F22`; and `Q_L = H_S Q_t H_S'`.",
        ),
        *meanings(SELECTION, "padded Q_small Q_large"),
        *together(_ordered(order, facts)),
    ]


def _ordered(order: Statement, facts: list[Statement]) -> list[Statement]:
    inverse = prove_order(
        "c33-inverse-definite",
        Search(SELECTION, [], facts[3:]),
        C33.inverse,
        ZERO,
        [Square(C33.inverse, facts[3], left_inverse=C33)],
        strict=True,
    )
    return [
        prove_equal("large-share", Search(SELECTION), Q_L, H_S @ PADDED @ H_S.T),
        prove_order(
            "shares-ordered", Search(SELECTION, [], [order]), Q_S, Q_L, [Square(H_S.T, order)]
        ),
        inverse,
        prove_order(
            "share-not-negative",
            Search(SELECTION, [], [inverse]),
            Q_L,
            ZERO,
            [Square(H_L.T, inverse)],
        ),
    ]


def _order() -> list[Step]:
    facts = _facts()
    padded = _padded(facts)
    larger = prove_order(
        "information-ordered",
        Search(SELECTION, [], [padded]),
        M_L,
        M_S,
        [Square(H_S.T @ P, padded)],
    )
    gap = prove_equal("information-gap", Search(SELECTION), M_L - M_S, P.T @ (Q_S - Q_L) @ P)
    return [
        gap.step(
            "(113) and (121): by (103) the inverses of the covariances are `M_S = K11 - P' Q_S P` "
            "and `M_L = K11 - P' Q_L P`; the larger choice has the larger one.",
            "(119) between `P'` and `P`: A7.",
        ),
        *meanings(SELECTION, "small_information large_information"),
        *together([larger]),
        *_covariances(facts, larger),
    ]


def _covariances(facts: list[Statement], larger: Statement) -> list[Step]:
    whole, turned = unit("k"), [facts[1], facts[2], facts[4], facts[5]]
    above = prove_order(
        "large-definite",
        Search(SELECTION, [SOLVABLE], [larger]),
        M_L,
        ZERO,
        [Square(whole, larger), Square(whole, SOLVABLE, left_inverse=whole)],
        strict=True,
    )
    small = prove_invertible(
        "small-regular", Search(SELECTION, [SOLVABLE]), "small_information", SOLVABLE
    )
    large = prove_invertible(
        "large-regular", Search(SELECTION, using=[above]), "large_information", above
    )
    given = [SOLVABLE, WEIGHT]
    gap = prove_equal(
        "gap-symmetric", Search(SELECTION, [WEIGHT], turned), (M_L - M_S).T, M_L - M_S
    )
    inverses = [
        inverse_symmetric("small-inverse-symmetric", Search(SELECTION, given), M_S, small),
        inverse_symmetric(
            "large-inverse-symmetric",
            Search(
                SELECTION,
                [SOLVABLE],
                aside=[gap],
                taken=[(whole, SOLVABLE, whole), (whole, gap, whole)],
            ),
            M_L,
            large,
        ),
    ]
    last = [found[-1] for found in inverses]
    left = ("inverse", small.id, "left")
    taken = [
        (-whole, left, M_S.inverse),
        (whole, left, M_L.inverse),
        (M_L.inverse, ("inverse", small.id, "right"), whole),
        (-whole, ("inverse", large.id, "left"), M_L.inverse),
    ]
    order = prove_order(
        "covariances-ordered",
        Search(SELECTION, given, [*turned, *last, larger], aside=[small, large], taken=taken),
        M_S.inverse,
        M_L.inverse,
        [Square(M_S.inverse - M_L.inverse, SOLVABLE), Square(M_L.inverse, larger)],
    )
    return [
        above.step(
            "(112), property 14: so the covariance of position and velocity from more clean "
            "ranges is not above that from fewer, and by A6 no variance on its diagonal is. It is "
            "step @fewer-unknowns for columns of the unit matrix.",
            "A4 for `M_L >= M_S > 0`.",
        ),
        *together([small, large, gap, *inverses[0], *inverses[1], order]),
    ]
