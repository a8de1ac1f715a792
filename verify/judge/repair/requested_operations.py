"""What a formula asks for: a derivative, a mean, an integral, a determinant. What stands there is
computed from what the source declares, so that a misprint is looked for on the other side.
"""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.exact.expression import Expr, symbol, walk
from gainproof.verify.judge.repair.printed_formula import Printed
from gainproof.verify.judge.repair.tree_construction import Path, places

COMPUTED = frozenset(("expectation", "integral", "det", "tr", "trace", "Tr"))


ENTRY = "the entry"
"""A symbol for what the entry of a matrix should be; no source can declare it."""


def is_computed(node: Expr) -> bool:
    """Whether it is computed from its parts by more than arithmetic; a value put into such a node
    changes nothing of that.
    """
    if node.kind == "at":
        return is_computed(node.parts[0])
    return node.kind == "derivative" or (node.kind == "call" and node.name in COMPUTED)


def asked_sides(formula: Printed) -> frozenset[int]:
    """The sides that are computed and nothing else; the first one where all are, as one side is
    there to answer the other.
    """
    claimed = formula.claimed()
    found = [n for n in claimed if _is_asked(formula.sides[n])]
    return frozenset(found[:1] if len(found) == len(claimed) else found)


def open_sides(formula: Printed) -> tuple[int, ...]:
    """The sides in which a misprint is looked for."""
    asked = asked_sides(formula)
    return tuple(n for n in formula.claimed() if n not in asked)


def open_places(side: Expr) -> Iterator[tuple[Path, Expr]]:
    """Every occurrence of a node of a side in which a misprint is looked for: none of a node that
    is computed, nor inside it; but inside a side that is computed as a whole.
    """
    closed = () if is_computed(side) else _computed_paths(side)
    for path, node in places(side):
        if not any(path[: len(above)] == above for above in closed):
            yield path, node


def asked_names(*sides: Expr) -> frozenset[str]:
    """Symbols and functions that stand in what is computed."""
    inside = (
        part for side in sides for node in walk(side) if is_computed(node) for part in walk(node)
    )
    return frozenset(part.name for part in inside if part.kind in ("symbol", "call"))


def _is_asked(side: Expr) -> bool:
    """Up to its sign and a number in front."""
    if side.kind == "neg":
        return _is_asked(side.parts[0])
    if side.kind in ("mul", "div"):
        rest = [part for part in side.parts if part.kind != "number"]
        return len(rest) == 1 and _is_asked(rest[0])
    return is_computed(side) or side == symbol(ENTRY)


def _computed_paths(side: Expr) -> tuple[Path, ...]:
    return tuple(path for path, node in places(side) if is_computed(node))
