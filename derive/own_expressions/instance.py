"""Whether a graph is another one with functions in the places of some of its symbols."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, operands


def require_instance(printed: Graph, abstract: Graph) -> None:
    """ValueError unless each output of `abstract` is that of `printed`, node by node, where a call
    may stand for a symbol: for the same symbol always the same call.
    """
    bound: dict[str, int] = {}
    known: set[tuple[int, int]] = set()
    left = [(printed["outputs"][name], end) for name, end in abstract["outputs"].items()]
    while left:
        pair = left.pop()
        if pair in known:
            continue
        known.add(pair)
        first, second = (
            graph["nodes"][n] for graph, n in zip((printed, abstract), pair, strict=True)
        )
        if second[0] == "symbol" and first[0] == "call":
            if bound.setdefault(str(second[1]), pair[0]) != pair[0]:
                raise ValueError(f"{second[1]} stands for two functions")
            continue
        parts = operands(first), operands(second)
        texts = [
            [entry for entry in node if not isinstance(entry, int)] for node in (first, second)
        ]
        if texts[0] != texts[1] or len(parts[0]) != len(parts[1]):
            raise ValueError(f"node {pair[0]} {first} is printed, the certificate has {second}")
        left += zip(*parts, strict=True)
