"""Whether a graph is what was proved, with functions in the places of symbols."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gainproof.derive.printer.graph import Graph, operands
from gainproof.derive.stable_form.function_atoms import ARGUMENT, patterns

Place = tuple[Graph, int]
"""A node of a graph."""


def require_instance(
    printed: Graph, output: str, programs: Mapping[str, Graph], kinds: Mapping[str, str]
) -> None:
    """ValueError unless an output is that of its program, node by node, where a function may stand
    for what `kinds` of atoms say of a symbol: of one argument, which is that of its own program.

    `programs`: graphs of outputs and of atoms' arguments, with one output of the name.
    """
    known: set[tuple[str, int, int]] = set()
    left = [(output, printed["outputs"][output], programs[output]["outputs"][output])]
    while left:
        step = left.pop()
        if step in known:
            continue
        known.add(step)
        program, first, second = step
        graph = programs[program]
        for name, argument in _functions((printed, first), (graph, second), kinds):
            left.append((name, argument, programs[name]["outputs"][name]))
            break
        else:
            one, other = printed["nodes"][first], graph["nodes"][second]
            if _texts(one) != _texts(other):
                raise ValueError(f"node {first} {one} is printed, the certificate has {other}")
            left += [(program, *pair) for pair in zip(operands(one), operands(other), strict=True)]


def _functions(
    printed: Place, proved: Place, kinds: Mapping[str, str]
) -> Iterator[tuple[str, int]]:
    """The atom of which both are the same, and the node of its argument."""
    for name, kind in kinds.items():
        for symbols, functions in patterns(name, kind):
            if _matched(_end(symbols), proved) == set():
                found = _matched(_end(functions), printed)
                if found is not None and len(found) == 1:
                    yield name, found.pop()


def _end(graph: Graph) -> Place:
    (end,) = graph["outputs"].values()
    return graph, end


def _matched(pattern: Place, place: Place) -> set[int] | None:
    """The nodes in the places of the argument; None if the pattern is not that of the place."""
    (form, end), (graph, number) = pattern, place
    one, other = form["nodes"][end], graph["nodes"][number]
    if one == ["symbol", ARGUMENT]:
        return {number}
    if _texts(one) != _texts(other):
        return None
    found: set[int] = set()
    for pair in zip(operands(one), operands(other), strict=True):
        part = _matched((form, pair[0]), (graph, pair[1]))
        if part is None:
            return None
        found |= part
    return found


def _texts(node: list[str | int]) -> list[str | None]:
    """What a node says besides its operands, whose places are None."""
    return [None if isinstance(entry, int) else entry for entry in node]
