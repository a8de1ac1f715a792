"""Where a statement was decided, in words."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import symbols_of
from gainproof.verify.judge.exact.statement import Statement
from gainproof.verify.judge.freed.induction import open_sums


def domain_text(statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]) -> str:
    """The bounds of its symbols and the numbers that are taken out, or everywhere."""
    over = {s.parts[1].name for s in open_sums(statement)}
    named = sorted(n for n in symbols_of(*statement.exprs()) - over if n in boxes)
    bounded = [n for n in named if boxes[n].lower is not None or boxes[n].upper is not None]
    words = [boxes[n].text(labels.get(n, n)) for n in bounded]
    for rel in statement.domain:
        value = constant_value(rel.right)
        if rel.operator == "!=" and rel.left.kind == "symbol" and value is not None:
            words.append(f"{labels.get(rel.left.name, rel.left.name)} != {value}")
    return ", ".join(words) or "everywhere"
