"""Expressions and points in the source's own symbols."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of
from gainproof.verify.judge.exact.expression_text import written


def shown(expr: Expr, labels: Mapping[str, str]) -> str:
    """The expression as text."""
    names = {name: symbol(labels.get(name, name)) for name in symbols_of(expr)}
    lines, (text,) = written(substituted(expr, names))
    return f"{text} with {', '.join(lines)}" if lines else text
