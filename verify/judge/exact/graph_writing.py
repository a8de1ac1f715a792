"""Expression trees written as expression graphs, plain data; `graph` reads them."""

from __future__ import annotations

from typing import Any

from gainproof.verify.judge.exact.expression import Expr, walk


def graph_of(expr: Expr) -> dict[str, Any]:
    """The expression as plain data."""
    nodes: list[list[Any]] = []
    places: dict[bytes, int] = {}
    for node in walk(expr):
        parts = [places[p.key] for p in node.parts]
        match node.kind:
            case "number":
                entry: list[Any] = ["number", str(node.value)]
            case "symbol":
                entry = ["symbol", node.name]
            case "pow":
                entry = ["pow", parts[0], str(node.value)]
            case "call":
                entry = ["call", node.name, *parts]
            case "derivative":
                entry = ["derivative", parts[0], node.name]
            case "at":
                entry = ["at", parts[0], node.name, parts[1]]
            case "matrix":
                entry = ["matrix", *[int(n) for n in node.name.split()], *parts]
            case _:
                entry = [node.kind, *parts]
        places[node.key] = len(nodes)
        nodes.append(entry)
    return {"nodes": nodes, "outputs": {"value": places[expr.key]}}
