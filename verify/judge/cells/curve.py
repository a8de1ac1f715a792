"""All of a curve in two parameters: its arcs, each by one point, and the points between them.

The curve is f = 0. Let x be the base and y the other variable. Where the leading coefficient and
the discriminant of f in y are not zero, nor its resultants with all other polynomials at which
anything can change, the real points over an open interval of x are arcs, graphs of functions of x,
on each of which the truth is that of one point. The points over the ends of these intervals have
algebraic coordinates and are decided one by one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.cells.cell_statement import Budget, Task
from gainproof.verify.judge.cells.cell_truth import Part, Piece, is_stated
from gainproof.verify.judge.cells.coefficient_signs import keeps_sign
from gainproof.verify.judge.cells.critical_polynomials import CellQuestion
from gainproof.verify.judge.cells.irrational_points import Corner, is_zero_at, vanishing_at
from gainproof.verify.judge.cells.parameter_polynomials import as_expr, irreducible, leading, put_in
from gainproof.verify.judge.cells.projection import discriminants, face_values, resultants
from gainproof.verify.judge.exact.algebraic_numbers import Algebraic, compare, real_roots
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.connected_sets import Connected
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.exact.places import Place, places
from gainproof.verify.judge.exact.polynomial import Poly, constant, degree, univariate
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.truth import NO_VALUE, SKIPPED, Question, truth
from gainproof.verify.judge.exact.truth_survey import Work


def curve_part(
    question: CellQuestion, factor: Poly, budget: Budget, stated: frozenset[str]
) -> Part:
    """The arcs and points of a curve in the box of a task with two parameters. Raises Undecided."""
    task = question.task
    boxes = [task.boxes[name] for name in task.names]
    budget.check_time()
    others = [p for p in question.careful_cuts() if str(p) != str(factor)]
    others = [p for p in others if not keeps_sign(p, boxes, closed=True)]
    upper = max(range(2), key=lambda i: (degree(factor, i) > 0, -degree(factor, i)))
    curve = replace(task, border=(*task.border, as_expr(factor, task.names)))
    pieces: list[Piece] = []
    for place in _base(factor, others, upper, boxes, budget):
        budget.check_time()
        for piece in _over(question, curve, factor, place, upper, budget, stated):
            pieces.append(piece)
            budget.spend(1)
    return Part(curve, tuple(pieces), sampled=True)


def _base(
    factor: Poly, others: list[Poly], upper: int, boxes: list[Box], budget: Budget
) -> list[Place]:
    """The intervals of the base variable over which nothing happens, and their ends."""
    lower = 1 - upper
    with_upper = [p for p in others if degree(p, upper) > 0]
    below = [p for p in others if degree(p, upper) <= 0]
    made = [leading(factor, upper), *face_values(factor, upper, boxes[upper])]
    made += discriminants([factor], upper, budget.limits)
    for other in with_upper:
        made += resultants([factor, other], upper, budget.limits)
    cuts = [univariate(p, lower) for p in irreducible([*below, *made])]
    return places(cuts, boxes[lower])


def _over(
    question: CellQuestion,
    curve: Task,
    factor: Poly,
    place: Place,
    upper: int,
    budget: Budget,
    stated: frozenset[str],
) -> Iterator[Piece]:
    """The points of the curve over one place of the base."""
    lower = 1 - upper
    base, other = curve.names[lower], curve.names[upper]
    size = 1 if place.is_cell else 0
    if place.at is None or place.at.is_rational:
        value = place.samples[0] if place.at is None else place.at.low
        here = put_in(factor, factor.context().names()[lower], value)
        for root in _roots(here, upper, curve.boxes[other]):
            yield _on_line(curve, base, value, other, root, size, budget, stated)
        return
    for root in _candidates(factor, place.at, upper, curve.boxes[other]):
        pair = (place.at, root) if lower == 0 else (root, place.at)
        if not is_zero_at(factor, pair, (0, 1)):
            continue
        if root.is_rational:
            yield _on_line(curve, other, root.low, base, place.at, 0, budget, stated)
        else:
            corner = Corner(pair)
            indices = question.tower.parameter_indices
            local = Local(question.tower, corner, vanishing_at(corner, indices))
            yield _piece(question, curve, corner, 0, local, stated)


def _roots(p: Poly, index: int, box: Box) -> list[Algebraic]:
    """The real roots in the box, closed faces included."""
    found = [r for f, _ in univariate(p, index).factor()[1] for r in real_roots(f)]
    return [r for r in found if _inside(r, box)]


def _inside(root: Algebraic, box: Box) -> bool:
    if box.lower is not None:
        above = compare(root, box.lower)
        if above < 0 or (above == 0 and box.lower_open):
            return False
    if box.upper is not None:
        below = compare(root, box.upper)
        if below > 0 or (below == 0 and box.upper_open):
            return False
    return True


def _candidates(factor: Poly, at: Algebraic, upper: int, box: Box) -> list[Algebraic]:
    """Numbers of the box among which the other coordinates are, over an irrational point."""
    lower = 1 - upper
    context = factor.context()
    minimal: Poly = constant(context, 0)
    for k, c in enumerate(at.coefficients):
        minimal = minimal + context.gen(lower) ** k * c
    return _roots(minimal.resultant(factor, lower), upper, box)


def _on_line(
    curve: Task,
    name: str,
    value: Fraction,
    other: str,
    root: Algebraic,
    size: int,
    budget: Budget,
    stated: frozenset[str],
) -> Piece:
    """The point where one variable has a rational value: a point of a task with one parameter."""
    change = {name: number(value)}
    statement = curve.statement.mapped(lambda expr: substituted(expr, change))
    box = replace(curve.boxes[other], integer=False)
    solved = (*curve.solved, (name, number(value)))
    line = replace(curve, statement=statement, boxes={other: box}, solved=solved)
    work = Work(statement, {other: box}, other, {}, budget.limits)
    place = Place(at=root)
    return _piece(work, line, place, size, Local(work.tower, place), stated)


def _piece(
    question: Question,
    task: Task,
    place: Connected,
    size: int,
    local: Local,
    stated: frozenset[str],
) -> Piece:
    found, failing = truth(question, local)
    counted = found != SKIPPED and (found != NO_VALUE or is_stated(task, local, stated))
    return Piece(task, place, size, found, failing, local, counted)
