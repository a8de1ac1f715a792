"""Where a statement holds, in words, and whether that is the whole set."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from gainproof.verify.judge.cells.exclusions import exclusions
from gainproof.verify.judge.cells.ground import as_expr
from gainproof.verify.judge.cells.names import shown
from gainproof.verify.judge.cells.pieces import Part, all_pieces, border_parts, parts
from gainproof.verify.judge.cells.question import CellQuestion
from gainproof.verify.judge.cells.region import Literal, alternatives, separating
from gainproof.verify.judge.cells.task import Budget, Task
from gainproof.verify.judge.exact.expression import number, symbols_of
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.truth import FALSE, SKIPPED, TRUE

MOST_BORDERS = 60


def domain_text(
    task: Task,
    found: Sequence[Part],
    budget: Budget,
    stated: frozenset[str],
    labels: Mapping[str, str],
) -> tuple[str, bool]:
    """The set of truth as text; False if it may hold on more borders than are named."""
    texts = [
        box.text(labels.get(name, name))
        for name, box in task.boxes.items()
        if box.lower is not None or box.upper is not None
    ]
    literals = separating(found[0])
    gaps = list(budget.gaps)
    whole = True
    if literals is None:
        texts.append(alternatives(found[0], labels))
        return _joined(texts), False
    inside = list(found)
    if any(p.truth == FALSE for p in found[0].pieces):
        # the borders inside the region of truth were not looked at yet
        again = Budget(budget.limits)
        try:
            inside = list(parts(_within(task, literals, ">"), again, stated))
        except Undecided:
            whole = False
        gaps += again.gaps
        whole = whole and _nowhere_else(task, literals, budget, stated)
    for k in range(len(literals)):
        text, clear = _literal_text(task, literals, k, budget, stated, labels)
        texts.append(text)
        whole = whole and clear
    used = {as_expr(p, task.names) for p, _ in literals}
    pieces = [p for p in all_pieces(inside) if not p.task.border or p.task.border[0] not in used]
    texts += exclusions(pieces, labels)
    texts += [f"{shown(expr, labels)} != 0" for expr, _ in gaps if symbols_of(expr)]
    return _joined(texts), whole and not gaps


def _nowhere_else(
    task: Task, literals: Sequence[Literal], budget: Budget, stated: frozenset[str]
) -> bool:
    """Whether it is shown that the statement holds on no thin set outside the region either."""
    limits = replace(budget.limits, borders=MOST_BORDERS)
    for p, sign in literals:
        again = Budget(limits, thorough=True)
        try:
            beyond = list(parts(_within(task, [(p, -sign)], ">"), again, stated))
        except Undecided:
            return False
        if again.gaps or any(piece.truth == TRUE for piece in all_pieces(beyond)):
            return False
    return True


def _joined(texts: Sequence[str]) -> str:
    return "for " + ", ".join(texts) if texts else "everywhere"


def _within(task: Task, literals: Sequence[Literal], above: str) -> Task:
    """The task where the polynomials have their signs; `above` is > or >=."""
    below = {">": "<", ">=": "<="}[above]
    more = tuple(
        Rel(above if sign > 0 else below, as_expr(p, task.names), number(0)) for p, sign in literals
    )
    given = (*task.statement.given, *more)
    return replace(task, statement=replace(task.statement, given=given))


def _literal_text(
    task: Task,
    literals: Sequence[Literal],
    k: int,
    budget: Budget,
    stated: frozenset[str],
    labels: Mapping[str, str],
) -> tuple[str, bool]:
    """The condition, with equality where the statement holds on the border too; False if it holds
    on a part of the border, or if that is not known.
    """
    p, sign = literals[k]
    others = [literal for j, literal in enumerate(literals) if j != k]
    again = Budget(budget.limits, thorough=True)
    present = {TRUE, FALSE}
    try:
        question = CellQuestion(_within(task, others, ">="), budget.limits)
        below = all_pieces(list(border_parts(question, p, again, stated)))
        if not again.gaps:
            present = {piece.truth for piece in below} - {SKIPPED}
    except Undecided:
        pass
    equal = "=" if present == {TRUE} else ""
    strict = ">" if sign > 0 else "<"
    text = f"{shown(as_expr(p, task.names), labels)} {strict}{equal} 0"
    return text, present == {TRUE} or TRUE not in present
