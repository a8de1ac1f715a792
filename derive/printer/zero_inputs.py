"""Inputs that may be 0: what a kernel is there, so that its bounds hold there too.

A sum with a term 0 is the other term, exactly; a product with a factor 0 and a quotient of 0 are 0,
exactly, as long as the other operand is finite and no divisor is 0. So where some inputs are 0 the
kernel computes bit for bit what the graph without the zeros computes, and that graph's inputs are
positive again. Each operand that a 0 makes vanish becomes an output of its own, whose bound proves
it finite.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from gainproof.derive.printer.graph import Graph, GraphBuilder, GraphNode, Node, operands
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.kernel import Kernel, Output
from gainproof.derive.printer.step_ranges import PrintingError


@dataclass(frozen=True)
class ZeroCase:
    """A kernel where some inputs are 0; `rows`: its outputs' numbers in the whole kernel.

    Outputs beyond those of `rows` are operands that have to be finite. Outputs that are not in
    `rows` are 0, exactly.
    """

    kernel: Kernel
    rows: tuple[int, ...]

    def of(self, whole: Array) -> Array:
        """The entries of this case; of operands that need only be finite, infinity."""
        found = np.full(len(self.kernel.outputs), np.inf)
        found[: len(self.rows)] = whole[list(self.rows)]
        return found

    def greater(self, whole: Array, own: Array | None) -> Array:
        """The greater of the whole kernel's entries and those of this case."""
        found = whole.copy()
        if own is not None:
            rows = list(self.rows)
            found[rows] = np.maximum(found[rows], own[: len(rows)])
        return found


def zero_cases(kernel: Kernel) -> Iterator[ZeroCase]:
    """One case for every choice of inputs that are 0.

    Raises PrintingError where 0 divides 0 or is compared, and for a kernel of one input.
    """
    names = [given.name for given in kernel.inputs if given.zero]
    if names and len(kernel.inputs) == 1:
        raise PrintingError(f"{names[0]}: 0 is admitted where there are several inputs only")
    for count in range(1, len(names) + 1):
        for chosen in combinations(names, count):
            yield _case(kernel, chosen)


def _case(kernel: Kernel, names: Sequence[str]) -> ZeroCase:
    folded = _Folded(kernel.graph, names)
    rows, outputs, kept = [], [], {}
    for row, output in enumerate(kernel.outputs):
        value = folded.output(output.name)
        if value is None:
            continue
        rows.append(row)
        outputs.append(output)
        for name in {output.name, output.relative_to or output.name}:
            scale = folded.output(name)
            if scale is None:
                raise PrintingError(f"output {output.name}: its scale is 0 where {names} are 0")
            kept[name] = scale
    for number, node in enumerate(folded.finite):
        kept[f"_finite_{number}"] = node
        outputs.append(Output(f"_finite_{number}", "an operand that has to be finite"))
    inputs = tuple(given for given in kernel.inputs if given.name not in names)
    if not kept or not inputs:
        raise PrintingError(f"nothing is left to compute where {', '.join(names)} are 0")
    graph = folded.builder.graph(kept, folded.names)
    remaining = replace(kernel, inputs=inputs, outputs=tuple(outputs), graph=graph)
    return ZeroCase(remaining, tuple(rows))


class _Folded:
    """A graph without some symbols: None stands for a node that is 0."""

    def __init__(self, graph: Graph, zeros: Sequence[str]) -> None:
        self.builder, self.zeros, self.ends = GraphBuilder(), zeros, graph["outputs"]
        self.nodes: list[Node | None] = []
        self.plain: list[bool] = []  # finite without a proof: an input or a number
        self.finite: list[Node] = []
        for number, node in enumerate(graph["nodes"]):
            self.plain.append(node[0] in ("symbol", "number"))
            self.nodes.append(self._folded(number, node))
        named = {name: self.nodes[number] for name, number in graph.get("names", {}).items()}
        self.names = {name: node for name, node in named.items() if node is not None}

    def output(self, name: str) -> Node | None:
        """A node of an output of the graph."""
        return self.nodes[self.ends[name]]

    def _folded(self, number: int, node: GraphNode) -> Node | None:
        if node[0] == "symbol" and node[1] in self.zeros:
            return None
        if node[0] in ("symbol", "number"):
            return self.builder.operation_of(node)
        parts = operands(node)
        left = [folded for part in parts if (folded := self.nodes[part]) is not None]
        if len(left) == len(parts):
            return self.builder.operation_of(node, left)
        match node[0]:
            case "add" if len(left) > 1:
                return self.builder.operation("add", *left)
            case "add":
                return left[0] if left else None
            case "mul" | "div" if node[0] == "mul" or self.nodes[parts[1]] is not None:
                self._require_finite([part for part in parts if self.nodes[part] is not None])
                return None
            case "neg" | "pow":
                return None
        raise PrintingError(f"node {number}: {node[0]} has no value where {self.zeros} are 0")

    def _require_finite(self, parts: Sequence[int]) -> None:
        nodes = [node for part in parts if (node := self.nodes[part]) is not None]
        if not all(self.plain[part] for part in parts) or len(nodes) > 1:
            whole = nodes[0] if len(nodes) == 1 else self.builder.operation("mul", *nodes)
            if whole.number not in (node.number for node in self.finite):
                self.finite.append(whole)
