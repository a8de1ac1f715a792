"""What a certificate holds of a graph with parts: polynomials, each part a symbol of its name.

The arguments of a part are outputs of their own, of which it is claimed what they are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gainproof.derive.own_expressions.graphs import UNDER
from gainproof.derive.own_expressions.parts import OVER
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, operands


def held(graph: Graph) -> Graph:
    """The graph with a symbol for each named part; the same if it has none.

    ValueError for a division by what is neither a number nor named.
    """
    names = graph.get("names", {})
    parts = {number: name for name, number in names.items() if name.startswith("part_")}
    unders = {
        number: name.replace(UNDER, OVER)
        for name, number in names.items()
        if name.startswith(f"{UNDER}_")
    }
    return _Holding(graph, parts, unders).run() if parts or unders else graph


def arguments_of(name: str, count: int) -> list[str]:
    """The outputs that are the arguments of a part."""
    return [f"{name}_of"] if count == 1 else [f"{name}_of_{n}" for n in range(1, count + 1)]


class _Holding:
    def __init__(self, graph: Graph, parts: Mapping[int, str], unders: Mapping[int, str]) -> None:
        self.graph, self.parts, self.unders = graph, parts, unders
        self.builder = GraphBuilder()
        self.made: list[Node] = []
        self.outputs: dict[str, Node] = {}

    def run(self) -> Graph:
        for number, node in enumerate(self.graph["nodes"]):
            places = operands(node)
            if number in self.parts:
                name = self.parts[number]
                given = zip(arguments_of(name, len(places)), places, strict=True)
                self.outputs |= {output: self.made[place] for output, place in given}
                self.made.append(self.builder.symbol(name))
            elif node[0] == "div":
                self.made.append(self.made[places[0]] * self._over(places[1]))
            else:
                self.made.append(self.builder.operation_of(node, self._made(places)))
        ends = {name: self.made[number] for name, number in self.graph["outputs"].items()}
        return self.builder.graph({**self.outputs, **ends})

    def _made(self, places: Sequence[int]) -> list[Node]:
        return [self.made[place] for place in places]

    def _over(self, number: int) -> Node:
        """One over a node."""
        node = self.graph["nodes"][number]
        if number in self.unders:
            name = self.unders[number]
            self.outputs[f"{name}_of"] = self.made[number]
            return self.builder.symbol(name)
        if node[0] == "number":
            return 1 / self.made[number]
        if node[0] == "mul":
            first, *others = (self._over(place) for place in operands(node))
            for other in others:
                first = first * other
            return first
        raise ValueError(f"node {number} {node} divides and has no name")
