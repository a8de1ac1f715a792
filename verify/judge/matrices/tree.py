"""Formulas of matrices as trees, as printed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction

from gainproof.verify.judge.matrices.size import Size


@dataclass(frozen=True)
class Node:
    """`kind` is name, number, unit, zero, sum, product, negative, transpose, inverse, matrix (parts
    row by row, `size` their numbers) or expectation. `unit` and `zero` have their shape in `shape`;
    a zero without one is the number 0, or the zero matrix that its place wants.
    """

    kind: str
    parts: tuple[Node, ...] = ()
    name: str = ""
    number: Fraction = Fraction(0)
    shape: tuple[Size, Size] | None = None
    size: tuple[int, int] = (0, 0)
    position: int = field(default=0, compare=False)

    def walk(self) -> Iterator[Node]:
        """The node and all below it."""
        yield self
        for part in self.parts:
            yield from part.walk()


REGULAR = "regular"
FRACTION = "fraction"
"""The name of an inverse that is printed below a line."""
INNER = "inner"
"""The name of a product that is printed as (x, y), of two columns."""


@dataclass(frozen=True)
class Chain:
    """sides[0] operators[0] sides[1] ...; operators are =, <, <=, >, >=. One side with the operator
    `REGULAR`: it has an inverse.
    """

    sides: tuple[Node, ...]
    operators: tuple[str, ...]


@dataclass(frozen=True)
class Bound:
    """left <= right of sizes over steps, or < where `strict`."""

    left: Size
    right: Size
    strict: bool


@dataclass(frozen=True)
class Statement:
    """Chains that hold together; `connective` is "" or => or <=> with what stands behind it; a lone
    expression is a chain without operators.
    """

    chains: tuple[Chain, ...]
    connective: str = ""
    after: tuple[Chain, ...] = ()
    bounds: tuple[Bound, ...] = ()
    text: str = ""


def transposed(node: Node) -> Node:
    """The transpose, without two of them in a row."""
    return node.parts[0] if node.kind == "transpose" else Node("transpose", (node,))


def product(*parts: Node) -> Node:
    """The product of one or more."""
    return parts[0] if len(parts) == 1 else Node("product", parts)
