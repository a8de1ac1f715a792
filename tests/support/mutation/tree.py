"""Expression graphs as nested tuples, for cutting and grafting.

("number", Fraction) ("symbol", name) ("add", a, b, ...) ("mul", ...) ("div", a, b) ("neg", a)
("pow", a, Fraction) ("call", name, a, ...) ("matrix", rows, columns, a, ...) ("derivative", a,
name) ("at", a, name, b)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any

Tree = tuple[Any, ...]


def to_tree(graph: Mapping[str, Any]) -> Tree:
    """The output "value" of a graph."""
    made: list[Tree] = []
    for node in graph["nodes"]:
        kind = node[0]
        match kind:
            case "number":
                made.append(("number", Fraction(node[1])))
            case "symbol":
                made.append(("symbol", node[1]))
            case "pow":
                made.append(("pow", made[node[1]], Fraction(node[2])))
            case "call":
                made.append(("call", node[1], *[made[i] for i in node[2:]]))
            case "matrix":
                made.append(("matrix", node[1], node[2], *[made[i] for i in node[3:]]))
            case "derivative":
                made.append(("derivative", made[node[1]], node[2]))
            case "at":
                made.append(("at", made[node[1]], node[2], made[node[3]]))
            case _:
                made.append((kind, *[made[i] for i in node[1:]]))
    value: int = graph["outputs"]["value"]
    return made[value]


def to_graph(tree: Tree) -> dict[str, Any]:
    """The graph of a tree, equal parts shared."""
    nodes: list[list[Any]] = []
    places: dict[Tree, int] = {}

    def place(part: Tree) -> int:
        if part not in places:
            entry = [place(x) if isinstance(x, tuple) else _plain(x) for x in part]
            places[part] = len(nodes)
            nodes.append(entry)
        return places[part]

    value = place(tree)
    return {"nodes": nodes, "outputs": {"value": value}}


def _plain(x: Any) -> Any:
    return str(x) if isinstance(x, Fraction) else x


def parts(tree: Tree) -> Iterator[tuple[Tree, Callable[[Tree], Tree]]]:
    """Every part with a function that puts another in its place."""
    yield tree, lambda new: new
    for position, child in enumerate(tree):
        if isinstance(child, tuple):
            for part, graft in parts(child):
                yield part, _grafted(tree, position, graft)


def _grafted(tree: Tree, position: int, graft: Callable[[Tree], Tree]) -> Callable[[Tree], Tree]:
    return lambda new: (*tree[:position], graft(new), *tree[position + 1 :])


def symbols(tree: Tree) -> set[str]:
    """Names of symbols."""
    return {part[1] for part, _ in parts(tree) if part[0] == "symbol"}


def number(value: int | str | Fraction) -> Tree:
    """A number."""
    return ("number", Fraction(value))
