"""Whether programs proved on several sides of a choice are proved on all of them.

A kernel that chooses (`select`), takes a magnitude (`abs`) or has inputs of either sign is proved
by a statement a side, each in a tower of its own, and each is true without the others. That one is
missing shows in the certificate itself, in two ways: the branches that its other statements take,
and other outputs that are proved on the towers together.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

Place = tuple[str, str]
"""A program and one of its outputs."""


def missing_sides(certificate: Mapping[str, Any]) -> str:
    """What is proved on some sides of a choice only, in words; "" if nothing is.

    `certificate`: one that the checker has accepted, so that the branches it names are those that
    are taken. Not found out: that the side is missing of each output, where no node of a graph
    chooses between the sides.
    """
    proved: dict[Place, list[Mapping[str, Any]]] = defaultdict(list)
    for statement in certificate["statements"]:
        if statement["kind"] == "program":
            for output in statement["claim"]["outputs"]:
                proved[statement["claim"]["program"], output].append(statement)
    graphs = {name: program["graph"] for name, program in certificate["programs"].items()}
    return "; ".join((*_untaken(proved, graphs), *_apart(proved)))


def _untaken(
    proved: Mapping[Place, Sequence[Mapping[str, Any]]], graphs: Mapping[str, Mapping[str, Any]]
) -> Iterator[str]:
    """Choices of which one side is taken by no statement.

    A magnitude may have one sign wherever it is computed, if it is computed on one side only of a
    choice whose two sides are both there: it is asked of those that every statement computes.
    """
    for (program, output), statements in proved.items():
        taken: dict[str, list[str]] = defaultdict(list)
        for statement in statements:
            for index, branch in statement["evidence"]["branches"].items():
                taken[index].append(branch)
        for index, branches in taken.items():
            function = graphs[program]["nodes"][int(index)][1]
            everywhere = len(branches) == len(statements)
            if len(set(branches)) == 1 and (function == "select" or everywhere):
                yield (
                    f"{program}.{output} is proved only where its {function!r}, node {index}, "
                    f"takes the side {branches[0]!r}"
                )


def _apart(proved: Mapping[Place, Sequence[Mapping[str, Any]]]) -> Iterator[str]:
    """Outputs that are proved on some of the towers on which others are proved together."""
    towers = {
        place: frozenset(statement["tower"] for statement in statements)
        for place, statements in proved.items()
    }
    together: dict[str, frozenset[str]] = {}
    for sides in towers.values():
        for side in sides:
            together[side] = max(together.get(side, sides), sides, key=len)
    for (program, output), sides in towers.items():
        lacking = frozenset().union(*(together[side] for side in sides)) - sides
        if lacking:
            yield f"{program}.{output} is not proved on {', '.join(sorted(lacking))}"
