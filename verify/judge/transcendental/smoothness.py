"""Whether a formula has a slope throughout: a sufficient test, part by part."""

from __future__ import annotations

from collections.abc import Callable

from gainproof.verify.judge.exact.box import Boxes
from gainproof.verify.judge.exact.expression import Expr, number, walk
from gainproof.verify.judge.exact.statement import Rel

EVERYWHERE = ("exp", "sin", "cos", "atan", "erf", "pi")
"""Functions that are analytic on the whole line."""

Proves = Callable[[Rel, Boxes], bool]
"""Whether a relation is proved on a domain, every part of it having a value there."""


def is_smooth(g: Expr, within: Boxes, closed: Boxes, proves: Proves) -> bool:
    """Whether every part of g is analytic on one domain and has a value and is continuous on the
    other, which may have an end more. No says nothing.
    """

    def apart(expr: Expr) -> bool:
        return proves(Rel(">", expr, number(0)), closed) or proves(
            Rel("<", expr, number(0)), closed
        )

    def smooth(node: Expr) -> bool:
        first = node.parts[0] if node.parts else node
        match node.kind:
            case "number" | "symbol" | "add" | "mul" | "neg":
                return True
            case "div":
                return apart(node.parts[1])
            case "pow" if node.fraction.denominator == 1:
                return node.fraction >= 0 or apart(first)
            case "pow" if node.fraction > 0:
                # a root is continuous at 0, where it has no slope
                return proves(Rel(">", first, number(0)), within) and proves(
                    Rel(">=", first, number(0)), closed
                )
            case "pow":
                return proves(Rel(">", first, number(0)), closed)
            case "call" if node.name in EVERYWHERE:
                return True
            case "call" if node.name == "tan":
                return apart(Expr("call", "cos", node.parts))
            case "call" if node.name in ("log", "power"):
                return proves(Rel(">", first, number(0)), closed)
        return False

    return all(map(smooth, walk(g)))
