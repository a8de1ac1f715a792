"""The truth of a statement on open cells, then on their borders, then on the borders of these.

A border is the same statement in one parameter less, so it has cells and borders of its own; with
one parameter left every point is decided exactly.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gainproof.verify.judge.cells.border import border_tasks
from gainproof.verify.judge.cells.curve import curve_part
from gainproof.verify.judge.cells.ground import as_expr
from gainproof.verify.judge.cells.lifting import Cell, cells
from gainproof.verify.judge.cells.one_sign import keeps_sign
from gainproof.verify.judge.cells.piece import Part, Piece, is_stated
from gainproof.verify.judge.cells.projection import projected
from gainproof.verify.judge.cells.question import CellQuestion
from gainproof.verify.judge.cells.subdivision import nowhere_zero
from gainproof.verify.judge.cells.task import Budget, OutOfTime, Task
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.local import Local
from gainproof.verify.judge.exact.poly import Poly
from gainproof.verify.judge.exact.survey import Work, survey
from gainproof.verify.judge.exact.truth import FALSE, NO_VALUE, SKIPPED, Question, truth


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
