"""Which expressions have a value wherever their symbols have, and what others divide by."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.expression_text import TERM


def is_total(*exprs: Expr) -> bool:
    """Whether they have values wherever their symbols have, at a glance: nothing else needs to
    where it cancels, or in all terms of a sum.
    """
    return all(map(_is_total, walk(*exprs)))


def _is_total(node: Expr) -> bool:
    """Whether it has a value wherever its parts have: also pi, and the term of a sequence."""
    match node.kind:
        case "number" | "symbol" | "add" | "mul" | "neg":
            return True
        case "pow":
            return node.fraction.denominator == 1 and node.fraction >= 0
        case "div":
            return node.parts[1].kind == "number" and node.parts[1].fraction != 0
        case "call":
            return node.name == "pi" or node.name.startswith(TERM)
    return False


def divisors(*exprs: Expr) -> Iterator[Expr]:
    """What is divided by in them, also as a power below 0."""
    for node in walk(*exprs):
        if node.kind == "div":
            yield node.parts[1]
        elif node.kind == "pow" and node.fraction < 0:
            yield node.parts[0]
