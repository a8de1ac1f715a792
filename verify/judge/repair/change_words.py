"""Changes in words."""

from __future__ import annotations

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.reader.latex_printer import graph_to_latex
from gainproof.verify.judge.repair.whole_formula import Change, Step

MOST_CHARACTERS = 60


def in_words(change: Change) -> list[str]:
    """One line for each step."""
    return [_step(step) for step in change.steps]


def _step(step: Step) -> str:
    if step.part is not None:
        part = _latex(step.part)
        return f"{step.what}: {part}" if part else step.what
    before, after = (None if e is None else _latex(e) for e in (step.before, step.after))
    return f"{step.what}: {before} becomes {after}" if before and after else step.what


def _latex(expr: Expr) -> str | None:
    """The expression as LaTeX, or None if that is long."""
    try:
        text = graph_to_latex(graph_of(expr))
    except ValueError:
        return None
    return text if len(text) <= MOST_CHARACTERS else None
