"""Nodes of an expression graph, equal ones shared."""

from __future__ import annotations

from gainproof.verify.judge.formula import Graph

Node = tuple[str | int, ...]


class NodeList:
    """Collects nodes in the order in which they are first met; an equal node gets the number it
    already has.
    """

    def __init__(self) -> None:
        self._numbers: dict[Node, int] = {}

    def add(self, *node: str | int) -> int:
        """The number of `node`, whose arguments are numbers of nodes already added."""
        return self._numbers.setdefault(node, len(self._numbers))

    def graph(self, value: int) -> Graph:
        """The plain graph with the output `value`; every node collected is part of it."""
        return {"nodes": [list(node) for node in self._numbers], "outputs": {"value": value}}
