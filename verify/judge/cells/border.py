"""Borders between cells: a polynomial that is zero is solved for a variable, which is put in."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from gainproof.verify.judge.cells.ground import as_expr, irreducible
from gainproof.verify.judge.cells.one_sign import keeps_sign
from gainproof.verify.judge.cells.task import Task, plainly_false
from gainproof.verify.judge.domain import box_conditions
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, neg, number, sqrt
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.poly import Poly, coefficients_in, degree
from gainproof.verify.judge.exact.statement import Rel


def border_tasks(task: Task, factor: Poly) -> Iterator[Task]:
    """The same statement where an irreducible polynomial is zero, in one parameter less each.

    The graphs of the solutions, of degree one or two in the variable that is solved for, and what
    the graphs leave out: where the leading coefficient is zero. Raises Undecided if the degree is
    higher in every variable.
    """
    names = task.names
    boxes = [task.boxes[name] for name in names]
    index = _best_variable(factor, boxes)
    parts = coefficients_in(factor, index)
    for value in _solutions(parts, names):
        made = _with_value(task, names[index], value, as_expr(factor, names))
        if made is not None:
            yield made
    for lead in irreducible([parts[-1]]):
        if not keeps_sign(lead, boxes, closed=True):
            zero = Rel("=", as_expr(factor, names), number(0))
            both = replace(task.statement, given=(*task.statement.given, zero))
            yield from border_tasks(replace(task, statement=both), lead)


def _best_variable(factor: Poly, boxes: Sequence[Box]) -> int:
    """The variable of lowest degree; of several, one whose leading coefficient is nowhere zero."""

    def cost(index: int) -> tuple[int, bool, int]:
        lead = coefficients_in(factor, index)[-1]
        firm = lead.is_constant() or keeps_sign(lead, boxes, closed=True)
        return degree(factor, index), not firm, index

    index = min((i for i in range(len(boxes)) if degree(factor, i) > 0), key=cost)
    if degree(factor, index) > 2:
        raise Undecided("a border of degree three or more in every variable")
    return index


def _solutions(parts: Sequence[Poly], names: Sequence[str]) -> list[Expr]:
    """The real roots of a polynomial of degree one or two, from its coefficients."""
    lead = parts[-1]
    if lead.is_constant():
        parts = [part / lead.leading_coefficient() for part in parts]
    below = None if lead.is_constant() else as_expr(lead, names)
    if len(parts) == 2:
        return [_over(as_expr(-parts[0], names), below)]
    root = sqrt(as_expr(parts[1] ** 2 / 4 - parts[0] * parts[2], names))
    if parts[1].is_zero():
        return [_over(root, below), _over(neg(root), below)]
    middle = as_expr(-parts[1] / 2, names)
    return [_over(middle + root, below), _over(middle - root, below)]


def _over(top: Expr, bottom: Expr | None) -> Expr:
    return top if bottom is None else top / bottom


def _with_value(task: Task, name: str, value: Expr, what: Expr) -> Task | None:
    """The task with an expression for a parameter; None where its conditions are plainly false."""

    def change(expr: Expr) -> Expr:
        return substituted(expr, {name: value})

    moved = task.statement.mapped(change)
    # no point of the border where the expression has no value: a condition, not part of the claim
    domain = (Rel("<=", value, value), *box_conditions(name, value, task.boxes[name]))
    left = {n: box for n, box in task.boxes.items() if n != name}
    solved = (*task.solved, (name, value))
    if any(plainly_false(rel) for rel in (*domain, *moved.domain)):
        return None
    statement = replace(moved, given=(*domain, *moved.given))
    return replace(
        task, statement=statement, boxes=left, solved=solved, border=(*task.border, what)
    )
