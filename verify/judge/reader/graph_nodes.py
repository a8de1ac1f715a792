"""Nodes of an expression graph, equal ones shared, and which of them are matrices."""

from __future__ import annotations

from collections.abc import Sequence, Set

from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.words import CARRIES_SHAPE, MATRIX_VALUED

Node = tuple[str | int, ...]
_MATRICES = frozenset(("matrix", "transpose", "inverse", "kronecker"))
_FIRST_ONLY = frozenset(("div", "pow", "derivative", "at"))


def arguments_of(node: Node) -> tuple[int, ...]:
    """The numbers of the nodes that `node` is made of."""
    kind, *rest = node
    match kind:
        case "number" | "symbol":
            return ()
        case "pow" | "derivative":
            return (int(rest[0]),)
        case "at":
            return (int(rest[0]), int(rest[2]))
        case "call":
            rest = rest[1:]
        case "matrix":
            rest = rest[2:]
    return tuple(int(number) for number in rest)


def with_arguments(node: Node, numbers: Sequence[int]) -> Node:
    """The same node made of other nodes."""
    kind, *rest = node
    match kind:
        case "number" | "symbol":
            return node
        case "pow" | "derivative":
            return (kind, numbers[0], rest[1])
        case "at":
            return (kind, numbers[0], rest[1], numbers[1])
        case "call":
            return (kind, rest[0], *numbers)
        case "matrix":
            return (kind, *rest[:2], *numbers)
    return (kind, *numbers)


class NodeList:
    """Collects nodes; an equal node gets the number it already has. `matrices` are the declared
    names whose value is a matrix.
    """

    def __init__(self, matrices: Set[str] = frozenset()) -> None:
        self._numbers: dict[Node, int] = {}
        self._nodes: list[Node] = []
        self._is_matrix: list[bool] = []
        self._names = matrices

    def add(self, *node: str | int) -> int:
        """The number of `node`, whose arguments are numbers of nodes already added."""
        number = self._numbers.setdefault(node, len(self._nodes))
        if number == len(self._nodes):
            self._nodes.append(node)
            self._is_matrix.append(self._finds_matrix(node))
        return number

    def is_matrix(self, number: int) -> bool:
        """Whether that node is a matrix, as far as its parts are declared as such."""
        return self._is_matrix[number]

    def node(self, number: int) -> Node:
        """The node with that number."""
        return self._nodes[number]

    def symbols_in(self, value: int) -> set[str]:
        """The names of all symbols below a node."""
        found: set[str] = set()
        seen: set[int] = set()
        waiting = [value]
        while waiting:
            number = waiting.pop()
            if number in seen:
                continue
            seen.add(number)
            node = self._nodes[number]
            if node[0] == "symbol":
                found.add(str(node[1]))
            waiting += arguments_of(node)
        return found

    def _finds_matrix(self, node: Node) -> bool:
        kind = node[0]
        parts = [self._is_matrix[number] for number in arguments_of(node)]
        if kind == "symbol":
            return node[1] in self._names
        if kind == "call":
            carries = node[1] in CARRIES_SHAPE and parts[0]
            return carries or node[1] in MATRIX_VALUED or node[1] in self._names
        if kind in _FIRST_ONLY:
            return parts[0]
        return kind in _MATRICES or any(parts)

    def graph(self, value: int) -> Graph:
        """The plain graph with the output `value`: its nodes in the order in which they are met
        from left to right, arguments first.
        """
        numbers: dict[int, int] = {}
        nodes: list[list[str | int]] = []
        waiting = [(value, False)]
        while waiting:
            number, arguments_done = waiting.pop()
            if number in numbers:
                continue
            node = self._nodes[number]
            if arguments_done:
                numbers[number] = len(nodes)
                nodes.append(list(with_arguments(node, [numbers[n] for n in arguments_of(node)])))
                continue
            waiting.append((number, True))
            waiting += [(part, False) for part in reversed(arguments_of(node))]
        return {"nodes": nodes, "outputs": {"value": numbers[value]}}
