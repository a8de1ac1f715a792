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
    NEVER,
    PADDED,
    Q_L,
    Q_S,
    SELECTION,
    UNIT_B,
    UNIT_N,
    UNIT_T,
    WEIGHT,
)
from gainproof.derive.estimation.spoken import meanings, said, together
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
    """From the columns of the unit matrix to the order of what biases take away."""
    return [*_columns(), *_shares()]


def _columns() -> list[Step]:
    free = UNIT_N - H_L @ H_L.T
    return [
        said(
            SELECTION,
            "two-choices",
            "Two choices of clean ranges, (111): the first `u` are clean in both, the next `w` in "
            "the larger choice only, the last `b` in neither; `E1`, `E2`, `E3` are their columns "
            "of the unit matrix. `H_L = E3` and `H_S`, of `E2` and `E3`, are (59); `T2` and `T3` "
            "are the columns of the unit matrix of `t` rows that pick the one and the other from "
            "`H_S`. Each of the three numbers may be 0, which the blocks of (114) to (117) then "
            "lack; with `b = 0`, `n_b = n`, `H` has no columns and (101) is the zero matrix (102).",
            "u = n_bS, u + w = n_bL, u + w + b = n, t = w + b",
            "The order of the ranges is arbitrary.",
            heading="More clean ranges",
        ),
        prove_equal("columns-large", Search(SELECTION), H_L.T @ H_L, UNIT_B).step(
            "(75), (76) and (81):",
            "`E_i' E_i = I`, `E_i' E_j = 0` for other `j`, and their squares add to `I`.",
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


def facts() -> list[Statement]:
    return [
        *definite_inverse("F22", H_S, H_S.T),
        *definite_inverse("C33", H_L, H_L.T),
    ]


def padded_below(facts: list[Statement]) -> Statement:
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
    known = facts()
    parts = [
        one @ symbol(f"C{i}{j}") @ other.T if i <= j else one @ symbol(f"C{j}{i}").T @ other.T
        for i, one in enumerate((ALWAYS, BETWEEN, NEVER), 1)
        for j, other in enumerate((ALWAYS, BETWEEN, NEVER), 1)
    ]
    blocks = sum(parts[1:], start=parts[0])
    order = padded_below(known)
    return [
        prove_equal("weight-blocks", Search(SELECTION, [symmetric("G11")]), G11, blocks).step(
            "(114) and (115) are `G11` in blocks, and `F22 = H_S' G11 H_S`; with `G11 > 0` its "
            "blocks have inverses.",
            "`E1 E1' + E2 E2' + E3 E3' = I` on both sides.",
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
                *known,
            ]
        ),
        order.step(
            "(118), which is (A.3): the inverse of a block with zeros around it is not above the "
            "inverse. So (119), and (120) of the zero matrix: `Q_S >= Q_L >= 0`, with (116) and "
            "(117) for both.",
            "`F22^-1 - Q_t` is the square of itself around `F22`; and `Q_L = H_S Q_t H_S'`.",
        ),
        *meanings(SELECTION, "padded Q_small Q_large"),
        *together(_ordered(order, known)),
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
