"""Definitions that come back to themselves, or that go too deep."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gainproof.verify.judge.claim.record import SymbolEntry

MOST_DEEP = 50
"""Definitions inside one another; each is resolved inside the one that uses it."""


def find_circle(entries: Mapping[str, SymbolEntry]) -> tuple[str, ...]:
    """Names of definitions each of which uses the next, the first again at the end; empty if there
    is no circle.
    """
    *_, last = _layers(entries)
    return _one_circle(last) if last else ()


def find_deepest(entries: Mapping[str, SymbolEntry]) -> tuple[str, int]:
    """A definition with the most others inside one another, and their number, itself counted; there
    must be no circle.
    """
    layers = list(_layers(entries))
    deepest = min(layers[-2]) if len(layers) > 1 else ""
    return deepest, len(layers) - 1


def _layers(entries: Mapping[str, SymbolEntry]) -> Iterator[dict[str, frozenset[str]]]:
    """What waits to be settled with what it uses, before and after each round of settling.

    Without recursion: a long chain of definitions is no danger here.
    """
    waiting = {name: definition_uses(entry) for name, entry in entries.items() if entry.definition}
    yield waiting
    while waiting:
        rest = {name: used for name, used in waiting.items() if used & waiting.keys()}
        yield rest
        if len(rest) == len(waiting):
            return
        waiting = rest


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
