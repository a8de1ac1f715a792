"""Where a statement was decided, in words."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.box import Box, bounds_text
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.statement import ORDERS, Rel, Statement
from gainproof.verify.judge.transcendental.induction import open_sums


def domain_text(statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]) -> str:
    """The bounds of its symbols and the numbers that are taken out, or everywhere that its other
    conditions hold.
    """
    over = {s.parts[1].name for s in open_sums(statement)}
    named = sorted(n for n in symbols_of(*statement.exprs()) - over if n in boxes)
    words = bounds_text({name: boxes[name] for name in named}, labels)
    for rel in statement.domain:
        value = constant_value(rel.right)
        if rel.operator == "!=" and rel.left.kind == "symbol" and value is not None:
            words.append(f"{labels.get(rel.left.name, rel.left.name)} != {value}")
        elif rel.operator in ORDERS and _is_bound(rel):
            sides = (labelled(side, labels) for side in (rel.left, rel.right))
            words.append(f" {rel.operator} ".join(sides))
    return ", ".join(words) or "everywhere"


def _is_bound(rel: Rel) -> bool:
    """Whether it bounds a symbol by a number, which is not a rational one: those are in boxes."""
    sides = (rel.left, rel.right)
    return sorted(len(symbols_of(side)) for side in sides) == [0, 1] and any(
        side.kind == "symbol" for side in sides
    )
