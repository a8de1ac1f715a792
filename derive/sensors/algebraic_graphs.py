"""Graphs with calls of a library as graphs of + - * / and roots, which a certificate can hold.

Sine, cosine, exponential and atan2 are no polynomials. What a certificate can decide of a kernel
with such calls is everything around them: each call's value stands as a symbol, the quantity of
that name, and each call's arguments are outputs of their own, of which it is claimed what they are.
A cosine or sine is taken of an input alone, and then named for it; an exponential is what noise
leaves of a mean, `kept_...`, and expm1 what it takes away, `change_...`. An output that is itself
an atan2 goes: its two arguments remain, opposite and adjacent side of the angle.
"""

from __future__ import annotations

from gainproof.derive.printer.graph import (
    Graph,
    GraphBuilder,
    GraphNode,
    Node,
    operands,
    symbols_of,
)
from gainproof.derive.printer.program import FUNCTIONS

EXPONENTIALS = {"exp": "kept_", "expm1": "change_"}
"""How their names begin."""


def algebraic(graph: Graph) -> Graph:
    """The graph without calls, the same if it has none.

    ValueError for a call without a name, or named for another angle, and for what is computed with
    an angle.
    """
    if not any(_is_call(node) for node in graph["nodes"]):
        return graph
    labels = {number: name for name, number in graph.get("names", {}).items()}
    inputs = set(symbols_of(graph))
    builder, made = GraphBuilder(), list[Node]()
    outputs: dict[str, Node] = {}
    angles: dict[int, str] = {}
    for number, node in enumerate(graph["nodes"]):
        parts = [made[part] for part in operands(node)]
        if not _is_call(node):
            made.append(builder.operation_of(node, parts))
            continue
        name, function = labels.get(number), str(node[1])
        if name is None or name in inputs:
            own = "no name" if name is None else f"the name of the input {name}"
            raise ValueError(f"node {number}: the call of {function} has {own}")
        if function == "atan2":
            outputs |= {f"{name}_opposite": parts[0], f"{name}_adjacent": parts[1]}
            angles[number] = name
        elif function in ("sin", "cos"):
            angle = graph["nodes"][operands(node)[0]]
            if angle[0] != "symbol" or name != f"{function}_{angle[1]}":
                raise ValueError(f"node {number}: {function} of {angle} is called {name}")
        elif function in EXPONENTIALS:
            if not name.startswith(EXPONENTIALS[function]):
                raise ValueError(f"node {number}: {function} is called {name}")
            outputs[f"{name}_of"] = parts[0]
        else:
            raise ValueError(f"node {number}: {function} is no function of an angle or exponent")
        made.append(builder.symbol(name))
    for name, number in graph["outputs"].items():
        if name in outputs:
            raise ValueError(f"output {name} has the name of an argument of a call")
        if number not in angles:
            outputs[name] = made[number]
        elif angles[number] != name:
            raise ValueError(f"output {name} is the angle {angles[number]}")
    _refuse_angles(graph, angles)
    kept = {
        name: made[number]
        for name, number in graph.get("names", {}).items()
        if graph["nodes"][number][0] == "pow"
    }
    return builder.graph(outputs, kept)


def _is_call(node: GraphNode) -> bool:
    return node[0] == "call" and node[1] in FUNCTIONS


def _refuse_angles(graph: Graph, angles: dict[int, str]) -> None:
    """An angle is an output and nothing else: no polynomial says what is computed with it."""
    for number, node in enumerate(graph["nodes"]):
        for part in operands(node):
            if part in angles:
                raise ValueError(f"node {number}: computes with the angle {angles[part]}")
