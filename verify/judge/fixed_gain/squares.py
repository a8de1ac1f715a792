"""Positive symbols under square roots, written as squares: a relation of degree two stays one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    power,
    symbol,
    symbols_of,
    walk,
    whole_power,
)
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.tidy import tidied
from gainproof.verify.judge.kinds.framing import Frame


def as_squares(statement: Statement, frame: Frame) -> tuple[Statement, Frame] | None:
    """The statement over the roots of those symbols whose square roots it holds, and its frame;
    None if there are none. They must be positive by a condition, or by their box, and have no other
    bound, so that their roots are all positive numbers.
    """
    known = {rel.left.name for rel in statement.conditions if _says_positive(rel)}
    found: dict[str, Expr] = {}
    for name in sorted(symbols_of(*statement.exprs())):
        box = frame.boxes.get(name, Box())
        free = box.upper is None and not box.integer and box.lower in (None, 0)
        if free and (name in known or box.is_positive) and _is_rooted(name, statement):
            found[name] = whole_power(symbol(root_name(name)), 2)
    if not found:
        return None
    boxes = {name: box for name, box in frame.boxes.items() if name not in found}
    boxes |= {root_name(name): Box(lower=number(0).fraction) for name in found}
    labels = {**frame.labels}
    labels |= {root_name(name): f"root of {labels.get(name, name)}" for name in found}
    moved = statement.mapped(lambda expr: tidied(_put_in(expr, found)))
    return moved, replace(frame, boxes=boxes, labels=labels)


def root_name(name: str) -> str:
    """The symbol for the positive square root of another."""
    return f"root of {name}"


def _says_positive(rel: Rel) -> bool:
    return rel.operator == ">" and rel.left.kind == "symbol" and rel.right == number(0)


def _is_rooted(name: str, statement: Statement) -> bool:
    return any(
        node.kind == "pow" and node.fraction.denominator == 2 and node.parts[0] == symbol(name)
        for node in walk(*statement.exprs())
    )


def _put_in(expr: Expr, found: Mapping[str, Expr]) -> Expr:
    """A root becomes the new symbol itself: the root of its square would be its absolute value."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind == "symbol":
            return found.get(node.name)
        if node.kind == "pow" and node.parts[0].kind == "symbol" and node.parts[0].name in found:
            doubled = node.fraction * 2
            if doubled.denominator == 1:
                return whole_power(symbol(root_name(node.parts[0].name)), int(doubled))
            return power(parts[0], node.fraction)
        return None

    return rebuilt(expr, change)
