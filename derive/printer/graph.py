"""Expression graphs: the plain data from which kernels are printed.

A graph is ``{"nodes": [...], "outputs": {"alpha": 7}, "names": {"p": 3}}``; a node refers to
earlier nodes only::

    ["number", "p/q"] | ["symbol", "name"] | ["add", i, j, ...] | ["mul", i, j, ...]
    | ["div", i, j] | ["neg", i] | ["pow", i, "1/2"]
    | ["call", "abs", i] | ["call", "select", a, b, x, y] | ["call", "pi"]

`fixed_point` tells of three more calls.

``GraphBuilder`` writes such data from ordinary Python operators. The order of operations is the
author's: nothing is reordered, flattened or simplified, since every rounding counts. The same
operation on the same operands is one node.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NotRequired, TypedDict

GraphNode = list[str | int]
"""Name of the operation, then operands: node numbers, or text for numbers and symbols."""

Number = int | Fraction | str
"""An exact rational number; text is "p" or "p/q". Floats are refused: 0.1 is not one tenth."""


class Graph(TypedDict):
    """Plain data of an expression graph; `names` gives readable names to some nodes."""

    nodes: list[GraphNode]
    outputs: dict[str, int]
    names: NotRequired[dict[str, int]]


def symbols_of(graph: Graph) -> list[str]:
    """The names of its symbols, in order."""
    return [str(node[1]) for node in graph["nodes"] if node[0] == "symbol"]


def exact_fraction(value: Number) -> Fraction:
    """The exact value of an integer, a fraction, or their text; TypeError for floats and others."""
    if isinstance(value, bool) or not isinstance(value, int | Fraction | str):
        raise TypeError(
            f"wanted an integer, a fraction or its text, got {value!r} ({type(value).__name__})"
        )
    return Fraction(value)


def fraction_text(value: Fraction) -> str:
    """The text of a fraction in a graph: "3", "-1/2"."""
    return (
        str(value.numerator) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"
    )


@dataclass(frozen=True, slots=True, eq=False)
class Node:
    """One node of a `GraphBuilder`; the operators + - * / and unary minus append nodes to it."""

    builder: GraphBuilder
    number: int

    def __add__(self, other: Node | Number) -> Node:
        return self.builder.operation("add", self, other)

    def __radd__(self, other: Number) -> Node:
        return self.builder.operation("add", other, self)

    def __sub__(self, other: Node | Number) -> Node:
        return self.builder.operation("add", self, -self.builder.node(other))

    def __rsub__(self, other: Number) -> Node:
        return self.builder.operation("add", other, -self)

    def __mul__(self, other: Node | Number) -> Node:
        return self.builder.operation("mul", self, other)

    def __rmul__(self, other: Number) -> Node:
        return self.builder.operation("mul", other, self)

    def __truediv__(self, other: Node | Number) -> Node:
        return self.builder.operation("div", self, other)

    def __rtruediv__(self, other: Number) -> Node:
        return self.builder.operation("div", other, self)

    def __neg__(self) -> Node:
        return self.builder.operation("neg", self)


class GraphBuilder:
    """Collects nodes while expressions are written with ordinary operators.

    >>> b = GraphBuilder()
    >>> x = b.symbol("x")
    >>> b.graph({"y": b.sqrt(x * x + 1)})["outputs"]
    {'y': 4}
    """

    def __init__(self) -> None:
        self._nodes: list[tuple[str | int, ...]] = []
        self._numbers: dict[tuple[str | int, ...], int] = {}

    def _append(self, *entry: str | int) -> Node:
        number = self._numbers.setdefault(entry, len(self._nodes))
        if number == len(self._nodes):
            self._nodes.append(entry)
        return Node(self, number)

    def node(self, value: Node | Number) -> Node:
        """The node itself, or a number node; ValueError for a node of another builder."""
        if not isinstance(value, Node):
            return self.number(value)
        if value.builder is not self:
            raise ValueError(f"node {value.number} belongs to another GraphBuilder")
        return value

    def operation(self, name: str, *operands: Node | Number) -> Node:
        """Appends one operation of the format on nodes or numbers."""
        return self._append(name, *(self.node(operand).number for operand in operands))

    def operation_of(self, node: GraphNode, parts: Sequence[Node] = ()) -> Node:
        """A node of another graph, its operands replaced by `parts`, one for each."""
        left = iter(part.number for part in map(self.node, parts))
        entries = (next(left) if isinstance(entry, int) else entry for entry in node[1:])
        return self._append(str(node[0]), *entries)

    def call(self, name: str, *operands: Node | Number) -> Node:
        """Appends a call of a named function."""
        return self._append("call", name, *(self.node(operand).number for operand in operands))

    def number(self, value: Number) -> Node:
        """An exact rational constant."""
        return self._append("number", fraction_text(exact_fraction(value)))

    def symbol(self, name: str) -> Node:
        """An input of the kernel, or in certificates a named quantity."""
        if not name.isidentifier():
            raise ValueError(f"a symbol's name must be an identifier, got {name!r}")
        return self._append("symbol", name)

    def sqrt(self, x: Node | Number) -> Node:
        """The nonnegative square root."""
        return self._append("pow", self.node(x).number, "1/2")

    def absolute(self, x: Node | Number) -> Node:
        """The absolute value."""
        return self._append("call", "abs", self.node(x).number)

    def select(
        self, a: Node | Number, b: Node | Number, x: Node | Number, y: Node | Number
    ) -> Node:
        """x where a < b, else y."""
        operands = (self.node(operand).number for operand in (a, b, x, y))
        return self._append("call", "select", *operands)

    def graph(
        self, outputs: Mapping[str, Node | Number], names: Mapping[str, Node] | None = None
    ) -> Graph:
        """Plain data with the nodes that the outputs use; names of unused nodes are dropped.

        ValueError if there is no output, or a node belongs to another builder.
        """
        if not outputs:
            raise ValueError("a graph needs at least one output")
        ends = {name: self.node(node).number for name, node in outputs.items()}
        used = set(ends.values())
        for number in range(len(self._nodes) - 1, -1, -1):
            if number in used:
                used.update(operands(self._nodes[number]))
        order = {old: new for new, old in enumerate(sorted(used))}
        result: Graph = {
            "nodes": [_renumbered(self._nodes[old], order) for old in sorted(used)],
            "outputs": {name: order[end] for name, end in ends.items()},
        }
        named = {name: self.node(node).number for name, node in (names or {}).items()}
        kept = {name: order[old] for name, old in named.items() if old in order}
        if kept:
            result["names"] = kept
        return result


def operands(node: GraphNode | tuple[str | int, ...]) -> tuple[int, ...]:
    """The node numbers that a node refers to."""
    return tuple(entry for entry in node[1:] if isinstance(entry, int))


def _renumbered(node: tuple[str | int, ...], order: Mapping[int, int]) -> GraphNode:
    return [order[entry] if isinstance(entry, int) else entry for entry in node]
