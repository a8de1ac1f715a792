"""Graphs of kernels with angles: inputs, roots and calls of a library, each with its name.

The name of a call is that of the quantity that it stands for in proofs (see `algebraic`).
"""

from __future__ import annotations

from dataclasses import dataclass, field

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.sensors.polar_forms import Direction


@dataclass
class Draft:
    """A builder with names for the nodes of calls."""

    builder: GraphBuilder = field(default_factory=GraphBuilder)
    names: dict[str, Node] = field(default_factory=dict)

    def given(self, *names: str) -> tuple[Node, ...]:
        """Inputs."""
        return tuple(self.builder.symbol(name) for name in names)

    def called(self, name: str, function: str, *parts: Node) -> Node:
        """The value of a library's function."""
        self.names[name] = self.builder.call(function, *parts)
        return self.names[name]

    def root(self, name: str, *squared: Node) -> Node:
        """The square root of a sum of squares."""
        first, *others = (each * each for each in squared)
        total = first
        for other in others:
            total = total + other
        self.names[name] = self.builder.sqrt(total)
        return self.names[name]

    def circle(self, angle: str) -> tuple[Node, Node]:
        """Cosine and sine of an input."""
        (x,) = self.given(angle)
        return self.called(f"cos_{angle}", "cos", x), self.called(f"sin_{angle}", "sin", x)

    def direction(self) -> Direction:
        """Of the inputs elevation and bearing."""
        return Direction(*self.circle("elevation"), *self.circle("bearing"))

    def graph(self, outputs: dict[str, Node]) -> Graph:
        """With the names."""
        return self.builder.graph(outputs, self.names)
