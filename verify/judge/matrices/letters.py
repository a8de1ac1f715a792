"""What a setting of matrices declares: sizes, and letters with what they stand for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gainproof.verify.judge.matrices.size import Shape, Size, Sizes
from gainproof.verify.judge.matrices.tree import Node, Statement

DEFINITE, SEMIDEFINITE = "positive definite", "positive semidefinite"
SYMMETRIC, INVERTIBLE = "symmetric", "invertible"
UNIT = " I_{"
"""What stands behind the name of a number in that of the number times a unit matrix."""
FACTS = (SYMMETRIC, DEFINITE, SEMIDEFINITE, INVERTIBLE)


@dataclass(frozen=True)
class Letter:
    """A free letter, any matrix of its shape with these `facts`; or one with a `definition`. With a
    `variance` it is a random vector with mean 0. With a `scalar` it is that letter, of one row and
    column, times the unit matrix.
    """

    name: str
    meaning: str
    shape: Shape
    facts: tuple[str, ...] = ()
    definition: Node | None = None
    variance: Node | None = None
    scalar: str = ""

    def spread(self, size: Size, sizes: Sizes) -> Letter:
        """A letter of one row and column times the unit matrix of a size."""
        name = f"{self.name}{UNIT}{sizes.shown(size)}}}"
        return Letter(
            name, self.meaning, (size, size), self.facts or (SYMMETRIC,), scalar=self.name
        )


@dataclass(frozen=True)
class MatrixSetting:
    """All letters in an order in which each definition uses earlier ones only."""

    sizes: Sizes
    letters: Mapping[str, Letter]


@dataclass(frozen=True)
class MatrixClaim:
    """What a claim of such a setting says: a statement (shapes not yet compared), or of kind
    `dimension` and `invertible` one expression; `shape` is what is said of the left side.
    `premises` are the earlier claims that may be used.
    """

    id: str
    kind: str
    statement: Statement
    shape: Shape | None = None
    given: tuple[Statement, ...] = ()
    invertible: tuple[Node, ...] = ()
    hints: tuple[Node, ...] = ()
    premises: tuple[MatrixClaim, ...] = field(default=())
