"""Steps on a symmetric matrix in four blocks: theorem 1 of the appendix, with its converse."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.order_setting import (
    B11,
    B12,
    B22,
    BLOCKS,
    BOTH,
    E1,
    E2,
    H1,
    H2,
    WHOLE,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.words.expression import ZERO, Expression, symbol
from gainproof.derive.words.hypotheses import (
    Hypothesis,
    invertible,
    semidefinite,
    symmetric,
)
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)

SYMMETRIC = symmetric("blocked")
REGULAR = [semidefinite("blocked"), invertible("blocked")]
LOWER_CORNER = E2 - E1 @ B11.inverse @ B12
UPPER_CORNER = E1 - E2 @ B22.inverse @ B12.T
BY_LOWER = UPPER_CORNER @ H1.inverse @ UPPER_CORNER.T + E2 @ B22.inverse @ E2.T
BY_UPPER = LOWER_CORNER @ H2.inverse @ LOWER_CORNER.T + E1 @ B11.inverse @ E1.T


@dataclass(frozen=True)
class Corner:
    """One of the two blocks on the diagonal, with the Schur complement of the other."""

    block: str
    complement: str
    other: str
    rows: Expression
    square: Expression
    inverse: Expression

    @property
    def given(self) -> list[Hypothesis]:
        """The other block and the complement have inverses."""
        return [SYMMETRIC, invertible(self.other), invertible(self.complement)]


FIRST = Corner("D11", "H1", "D22", E1, UPPER_CORNER, BY_LOWER)
SECOND = Corner("D22", "H2", "D11", E2, LOWER_CORNER, BY_UPPER)


def schur_steps() -> list[Step]:
    """D >= 0 with an inverse is positive definite, and so are its corners; the inverse."""
    regular, whole = positive()
    blocks = {corner.block: block_facts(corner, whole) for corner in (FIRST, SECOND)}
    complements = [
        statement
        for corner in (FIRST, SECOND)
        for statement in _complement(corner, whole, blocks[corner.other])
    ]
    return [
        regular.step(
            "Theorem 1, (A.1): let `D >= 0` be symmetric with an inverse. Then it is positive "
            "definite, and so are the blocks on its diagonal and the complements `H1` and `H2`.",
            "`x' D x = 0` makes `D x = 0`, hence `x = D^-1 D x = 0`. The complement is the form of "
            "`D` on `[I; -D22^-1 D12']`.",
            heading="Appendix: a matrix in four blocks",
        ),
        *together([whole, *(s for found in blocks.values() for s in found), *complements]),
        *meanings(BLOCKS, "D11 D12 D22 H1 H2"),
    ]


def positive() -> list[Statement]:
    """D > 0 since D x = 0 where x' D x is 0."""
    regular = prove_invertible("blocked-regular", Search(BLOCKS, REGULAR), "blocked", REGULAR[1])
    whole = prove_order(
        "regular-definite",
        Search(BLOCKS, REGULAR, [regular]),
        WHOLE,
        ZERO,
        [Square(BOTH, REGULAR[0], left_inverse=WHOLE.inverse, through=True)],
        strict=True,
    )
    return [regular, whole]


def block_facts(corner: Corner, whole: Statement) -> list[Statement]:
    """The block is positive definite, has an inverse, and that is symmetric."""
    above = prove_order(
        f"{corner.block}-definite",
        Search(BLOCKS, using=[whole]),
        symbol(corner.block),
        ZERO,
        [Square(corner.rows, whole, left_inverse=corner.rows.T)],
        strict=True,
    )
    regular = prove_invertible(
        f"{corner.block}-regular", Search(BLOCKS, using=[above]), corner.block, above
    )
    turned = prove_equal(
        f"{corner.block}-inverse-symmetric",
        Search(BLOCKS, [REGULAR[0]], [regular], rounds=1),
        symbol(corner.block).inverse.T,
        symbol(corner.block).inverse,
    )
    return [above, regular, turned]


def _complement(corner: Corner, whole: Statement, other: list[Statement]) -> list[Statement]:
    """The complement of the other block is positive definite and has an inverse."""
    above = prove_order(
        f"{corner.complement}-definite",
        Search(BLOCKS, [REGULAR[0]], [whole, *other]),
        symbol(corner.complement),
        ZERO,
        [Square(corner.square, whole, left_inverse=corner.rows.T)],
        strict=True,
    )
    regular = prove_invertible(
        f"{corner.complement}-regular", Search(BLOCKS, using=[above]), corner.complement, above
    )
    return [above, regular]
