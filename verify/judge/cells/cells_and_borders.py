"""The truth of a statement on open cells, then on their borders, then on the borders of these.

A border is the same statement in one parameter less, so it has cells and borders of its own; with
one parameter left every point is decided exactly.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from gainproof.verify.judge.cells.cell_statement import Budget, OutOfTime, Task, plainly_false
from gainproof.verify.judge.cells.cell_truth import Part, Piece, is_stated
from gainproof.verify.judge.cells.coefficient_signs import keeps_sign
from gainproof.verify.judge.cells.critical_polynomials import CellQuestion
from gainproof.verify.judge.cells.curve import curve_part
from gainproof.verify.judge.cells.lifting import Cell, cells
from gainproof.verify.judge.cells.parameter_polynomials import as_expr, irreducible
from gainproof.verify.judge.cells.projection import projected
from gainproof.verify.judge.cells.subdivision import nowhere_zero
from gainproof.verify.judge.domain import box_conditions
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, neg, number, sqrt
from gainproof.verify.judge.exact.polynomial import Poly, coefficients_in, degree
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.truth import FALSE, NO_VALUE, SKIPPED, Question, truth
from gainproof.verify.judge.exact.truth_survey import Work, survey
from gainproof.verify.judge.exact.work_limits import Undecided


def parts(task: Task, budget: Budget, stated: frozenset[str]) -> Iterator[Part]:
    """The cells of a task, then its borders, depth first. Beside cells where the statement is false
    no border is looked at, unless the budget says so. Raises Undecided for the cells of the first
    task.
    """
    if not budget.is_new(task):
        return
    if len(task.names) < 2:
        yield exact_part(task, budget, stated)
        return
    question = CellQuestion(task, budget.limits)
    if question.cannot_apply():
        return
    equation = question.equation()
    if equation is not None:
        yield Part(task, (), question)
        borders = question.of_relation(equation)
    else:
        part = _open_cells(question, budget, stated)
        yield part
        wrong = any(piece.truth == FALSE for piece in part.pieces)
        empty = question.never_has_value() and not stated
        if not budget.thorough and (wrong or empty):
            return
        borders = question.all_borders() if budget.thorough else question.borders()
    for factor in borders:
        yield from border_parts(question, factor, budget, stated)


def border_parts(
    question: CellQuestion, factor: Poly, budget: Budget, stated: frozenset[str]
) -> Iterator[Part]:
    """The parts of one border. What is not decided there is a gap of the budget: elsewhere the
    statement may still be found false.
    """
    task = question.task
    boxes = [task.boxes[name] for name in task.names]
    if keeps_sign(factor, boxes, closed=True):
        return
    try:
        for below in border_tasks(task, factor):
            yield from parts(below, budget, stated)
    except OutOfTime:
        raise
    except Undecided as reason:
        if nowhere_zero(factor, question.domain_polynomials(), boxes):
            return
        try:
            if len(task.names) != 2:
                raise reason
            yield curve_part(question, factor, budget, stated)
        except OutOfTime:
            raise
        except Undecided as other:
            budget.gaps.append((as_expr(factor, task.names), str(other)))


def _open_cells(question: CellQuestion, budget: Budget, stated: frozenset[str]) -> Part:
    task = question.task
    boxes = [task.boxes[name] for name in task.names]
    cuts = question.cuts()
    budget.check_time()
    projection = projected(cuts, boxes, budget.limits)
    found = cells(projection.levels, boxes, budget.limits)
    budget.spend(len(found))
    pieces = []
    for cell in found:
        budget.check_time()
        pieces.append(piece_of_cell(question, task, cell, stated))
    return Part(task, tuple(pieces), question, tuple(cuts), projection)


def piece_of_cell(question: Question, task: Task, cell: Cell, stated: frozenset[str]) -> Piece:
    """The truth on one open cell. Raises Undecided."""
    local = Local(question.tower, cell)
    found, failing = truth(question, local)
    counted = found != SKIPPED and (found != NO_VALUE or is_stated(task, local, stated))
    return Piece(task, cell, len(cell.sides), found, failing, local, counted)


def exact_part(task: Task, budget: Budget, stated: frozenset[str]) -> Part:
    """All places of a task with at most one parameter."""
    name = next(iter(task.names), None)
    boxes = {n: replace(box, integer=False) for n, box in task.boxes.items()}
    work = Work(task.statement, boxes, name, {}, budget.limits)
    judged = survey(work)
    if work.inexact:
        budget.gaps.append((number(0), "the points where an equation holds were not separated"))
    budget.spend(len(judged))
    pieces = []
    for j in judged:
        counted = j.truth != SKIPPED and (j.truth != NO_VALUE or is_stated(task, j.local, stated))
        size = 1 if j.place.is_cell else 0
        pieces.append(Piece(task, j.place, size, j.truth, j.failing, j.local, counted))
    return Part(task, tuple(pieces))


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
