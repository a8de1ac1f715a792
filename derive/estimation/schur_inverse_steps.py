"""Steps on the inverse of a symmetric matrix in four blocks: (A.2), its converse, and (A.3)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.order_setting import BLOCKS, BOTH, E1, E2, WHOLE
from gainproof.derive.estimation.schur_steps import (
    FIRST,
    REGULAR,
    SECOND,
    SYMMETRIC,
    Corner,
    block_facts,
    positive,
)
from gainproof.derive.estimation.spoken import by_columns, known_inverse, together
from gainproof.derive.words.expression import ZERO, symbol
from gainproof.derive.words.hypotheses import invertible
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)


def inverse_steps() -> list[Step]:
    """The inverse from either corner, that either will do, and what it is not below."""
    first, second = _inverse(FIRST), _inverse(SECOND)
    return [
        first[0].step(
            "(A.2), the inverse from either corner. The form with `H1` takes inverses of `D22` and "
            "`H1`, that with `H2` takes those of `D11` and `H2`; neither needs `D >= 0`.",
            "Multiply by `D`, block by block.",
        ),
        *together([*first[1:], *second]),
        *_converse(),
        *_below(),
    ]


def _inverse(corner: Corner) -> list[Statement]:
    """The inverse by the complement of one block."""
    bases = [
        prove_invertible(
            f"{name}-given", Search(BLOCKS, [invertible(name)]), name, invertible(name)
        )
        for name in (corner.other, corner.complement)
    ]
    turned = prove_equal(
        f"{corner.other}-given-symmetric",
        Search(BLOCKS, [SYMMETRIC], bases[:1], rounds=1),
        symbol(corner.other).inverse.T,
        symbol(corner.other).inverse,
    )
    known = [*bases, turned]
    name = f"inverse-by-{corner.complement}"
    product = by_columns(
        f"{name}-product", Search(BLOCKS, [SYMMETRIC], known), corner.inverse @ WHOLE, BOTH, "t"
    )
    return [*known, *product, *known_inverse(name, WHOLE, corner.inverse, product[-1])]


def _converse() -> list[Step]:
    """Under (A.1) either pair of inverses makes D positive definite."""
    found = {corner.block: _from_pair(corner) for corner in (FIRST, SECOND)}
    return [
        found["D11"][0].step(
            "The converse under (A.1), `D >= 0`: if `D22` and `H1` have inverses, or `D11` and "
            "`H2`, then `D` is positive definite. So all four have inverses, and both forms of "
            "(A.2) hold. Without `D >= 0` the one pair does not give the other: the matrix with "
            "the rows `(0, 1)` and `(1, 1)` has `D22 = 1` and `H1 = -1`, and no `D11^-1`.",
            "A block and a complement that are `>= 0` with an inverse are `> 0`; `D` is the sum of "
            "the squares of `E1'` around `H1` and of `D22^-1 E2' D` around `D22`.",
        ),
        *together([*found["D11"][1:], *found["D22"]]),
    ]


def _from_pair(corner: Corner) -> list[Statement]:
    """D22 > 0, H1 > 0 and D > 0."""
    block, rest, whole = symbol(corner.other), symbol(corner.complement), REGULAR[0]
    columns = E2 if corner is FIRST else E1
    given = invertible(corner.other)
    known = [
        prove_invertible(f"{corner.other}-given", Search(BLOCKS, [given]), corner.other, given)
    ]
    one = prove_order(
        f"{corner.other}-from-inverse",
        Search(BLOCKS, [whole], known[:1]),
        block,
        ZERO,
        [Square(columns, whole, left_inverse=block.inverse @ columns.T, through=True)],
        strict=True,
    )
    regular = prove_invertible(
        f"{corner.complement}-given",
        Search(BLOCKS, [invertible(corner.complement)]),
        corner.complement,
        invertible(corner.complement),
    )
    other = prove_order(
        f"{corner.complement}-from-inverse",
        Search(BLOCKS, [whole], [*known, regular], rounds=1),
        rest,
        ZERO,
        [
            Square(
                corner.square,
                whole,
                left_inverse=rest.inverse @ corner.rows.T,
                through=True,
            )
        ],
        strict=True,
    )
    total = prove_order(
        f"definite-by-{corner.complement}",
        Search(BLOCKS, [whole], [*known, one, other], rounds=1, heavy=(corner.rows.value,)),
        WHOLE,
        ZERO,
        [
            Square(corner.rows.T, other, left_inverse=corner.square),
            Square(block.inverse @ columns.T @ WHOLE, one, left_inverse=columns),
        ],
        strict=True,
    )
    return [one, other, total]


def _below() -> list[Step]:
    """diag(0, D22^-1) <= D^-1, the difference being a square."""
    regular, whole = positive()
    inverse = prove_order(
        "blocked-inverse-definite",
        Search(BLOCKS, REGULAR, [regular], rounds=1),
        WHOLE.inverse,
        ZERO,
        [Square(WHOLE.inverse, REGULAR[0], left_inverse=BOTH, through=True)],
        strict=True,
    )
    below = []
    for corner in (FIRST, SECOND):
        known = block_facts(corner, whole)
        part = corner.rows @ symbol(corner.block).inverse @ corner.rows.T
        below.append(
            prove_order(
                f"inverse-above-{corner.block}",
                Search(BLOCKS, REGULAR, [regular, *known], rounds=1),
                WHOLE.inverse,
                part,
                [Square(WHOLE.inverse - part, REGULAR[0])],
            )
        )
    return [
        inverse.step(
            "(A.3): the inverse is not below the inverse of a block, with zeros around it. That "
            "takes `D > 0`: for `D = diag(-1, 1)` and its lower block it fails.",
            "`D^-1 - E2 D22^-1 E2'` is the square of itself around `D`.",
        ),
        *together([below[1], below[0]]),
    ]
