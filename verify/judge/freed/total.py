"""Expressions that have a value wherever their symbols have."""

from __future__ import annotations

from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.freed.circle import PI
from gainproof.verify.judge.meaning.sequences import is_term


def is_total(expr: Expr) -> bool:
    """Whether it is one, at a glance: nothing else needs to have a value where it cancels, or in
    all terms of a sum.
    """
    return all(
        n.kind in ("number", "symbol", "add", "mul", "neg")
        or n == PI
        or (n.kind == "pow" and n.fraction.denominator == 1 and n.fraction >= 0)
        or (n.kind == "div" and n.parts[1].kind == "number" and n.parts[1].fraction != 0)
        or is_term(n)
        for n in walk(expr)
    )
