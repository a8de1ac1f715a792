"""Definitions that come back to themselves."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.claim_record import SymbolEntry


def find_circle(entries: Mapping[str, SymbolEntry]) -> tuple[str, ...]:
    """Names of definitions each of which uses the next, the first again at the end; empty if there
    is no circle.

    Definitions are settled one after the other, without recursion: a long chain of them is no
    danger.
    """
    waiting = {name: definition_uses(entry) for name, entry in entries.items() if entry.definition}
    while waiting:
        settled = [name for name, used in waiting.items() if not used & waiting.keys()]
        if not settled:
            return _one_circle(waiting)
        for name in settled:
            del waiting[name]
    return ()


def definition_uses(entry: SymbolEntry) -> frozenset[str]:
    """The symbols and functions on the right of a definition, its own arguments left out."""
    used: set[str] = set()
    for reading in entry.definition.readings if entry.definition else ():
        for node in reading.relations[0].right["nodes"]:
            if node[0] in ("symbol", "call"):
                used.add(node[1])
    return frozenset(used.difference(entry.arguments))


def _one_circle(waiting: Mapping[str, frozenset[str]]) -> tuple[str, ...]:
    path = [min(waiting)]
    while path[-1] not in path[:-1]:
        path.append(min(waiting[path[-1]] & waiting.keys()))
    return tuple(path[path.index(path[-1]) :])
