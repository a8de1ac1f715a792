"""Random statements in several parameters: verdicts over cells against plain evaluation."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from random import Random
from typing import Any

import flint
from random_surfaces import Point, Trial, trial

from gainproof.verify.judge.cells import decision as decision_module
from gainproof.verify.judge.cells.cell_statement import Budget
from gainproof.verify.judge.cells.cell_truth import Part
from gainproof.verify.judge.cells.cells_and_borders import parts
from gainproof.verify.judge.cells.parameter_polynomials import value_at
from gainproof.verify.judge.cells.sign_conditions import separating
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.truth import FALSE, NO_VALUE, SKIPPED, TRUE
from gainproof.verify.judge.exact.work_limits import Limits, Undecided

BITS = 400
LIMITS = Limits(cells=150, borders=30, projection_degree=40, projection_factors=40)


class NoValue(Exception):
    """The expression has no value at the point."""


class Unclear(Exception):
    """A ball contains zero where its sign matters."""


def value(expr: Expr, point: Point) -> Any:
    """A ball by plain evaluation of the tree. Raises NoValue, Unclear."""
    with flint.ctx.workprec(BITS):
        done: dict[bytes, Any] = {}
        for node in walk(expr):
            parts_ = [done[p.key] for p in node.parts]
            done[node.key] = _node(node, parts_, point)
        return done[expr.key]


def _node(node: Expr, below: list[Any], point: Point) -> Any:
    match node.kind:
        case "number" | "symbol":
            exact = node.fraction if node.kind == "number" else point[node.name]
            return flint.arb(flint.fmpq(exact.numerator, exact.denominator))
        case "add" | "mul":
            total = below[0]
            for part in below[1:]:
                total = total + part if node.kind == "add" else total * part
            return total
        case "neg":
            return -below[0]
        case "div":
            if below[1].is_zero():
                raise NoValue
            if below[1].contains(0):
                raise Unclear
            return below[0] / below[1]
        case _:
            return _power(below[0], node.fraction)


def _power(base: Any, exponent: Fraction) -> Any:
    if exponent.denominator == 2 and not base.is_zero():
        if base < 0:
            raise NoValue
        if not base > 0:
            raise Unclear
        base = base.sqrt()
    if exponent.denominator == 3 and not base.is_zero():
        if base.contains(0):
            raise Unclear
        base = base.root(3) if base > 0 else -((-base).root(3))
    product = flint.arb(1)
    for _ in range(exponent.numerator):
        product = product * base
    return product


def compared(rel: Rel, point: Point) -> str:
    """The sides as <, = or >; balls of BITS bits that overlap count as equal. Raises NoValue,
    Unclear.
    """
    a, b = value(rel.left, point), value(rel.right, point)
    if a.overlaps(b):
        return "="
    return "<" if a < b else ">"


def holds(rel: Rel, point: Point) -> bool:
    """The truth of a relation. Raises NoValue, Unclear."""
    order = compared(rel, point)
    allowed = {"=": "=", "!=": "<>", "<": "<", "<=": "<=", ">": ">", ">=": ">="}
    return order in allowed[rel.operator]


def truth_at(statement: Statement, point: Point) -> str:
    """The truth of a statement at a point. Raises Unclear."""
    if statement.connective == "iff":
        try:
            sides = [holds(rel, point) for rel in statement.all_relations()]
        except NoValue:
            return NO_VALUE
        return TRUE if sides[0] == sides[1] else FALSE
    try:
        if not all(holds(rel, point) for rel in statement.conditions):
            return SKIPPED
    except NoValue:
        return SKIPPED
    try:
        return TRUE if all(holds(rel, point) for rel in statement.relations) else FALSE
    except NoValue:
        return NO_VALUE


def points(random: Random, case: Trial, count: int) -> list[Point]:
    """Random points of the boxes, small integers often, and the special ones."""
    found = list(case.special)
    for _ in range(count):
        scale = random.choice((1, 1, 2, 5, 30))
        found.append(
            {n: Fraction(random.randint(-3 * scale, 4 * scale), scale) for n in case.boxes}
        )
    return [p for p in found if all(case.boxes[n].holds(v) for n, v in p.items())]


def disagreements(
    seed: int, count: int, limits: Limits = LIMITS, tried: int = 40
) -> tuple[list[str], Counter[str]]:
    """Every point at which a verdict disagrees with plain evaluation, and the count of verdicts."""
    random = Random(seed)
    wrong: list[str] = []
    verdicts: Counter[str] = Counter()
    for k in range(count):
        case = trial(random)
        cloud = points(random, case, tried)
        try:
            outcome = decision_module.decide_in_cells(case.statement, case.boxes, {}, limits)
        except Undecided as reason:
            verdicts[f"undecided: {str(reason)[:60]}"] += 1
            continue
        verdicts[outcome.verdict] += 1
        faults = _faults(case, outcome.verdict, cloud, limits)
        wrong += [f"seed {seed} number {k}: {outcome.verdict}, {fault}" for fault in faults]
    return wrong, verdicts


def _faults(case: Trial, verdict: str, cloud: list[Point], limits: Limits) -> list[str]:
    task = decision_module._task(case.statement, case.boxes)
    stated = frozenset(n for n, box in case.boxes.items() if box.stated)
    first = next(iter(parts(task, Budget(limits), stated)))
    found = []
    for point in cloud:
        try:
            seen = truth_at(case.statement, point)
        except Unclear:
            continue
        shown = ", ".join(f"{n} = {v}" for n, v in point.items())
        if verdict == "proved" and (seen == FALSE or (seen == NO_VALUE and stated == set(point))):
            found.append(f"{seen} at {shown}")
        # an equation may hold on a thin set all the same
        equal = any(rel.operator == "=" for rel in case.statement.relations)
        if verdict == "refuted" and seen == TRUE and not equal and _generic(case, first, point):
            found.append(f"{seen} at {shown}")
        if verdict == "conditional" and seen != SKIPPED and _generic(case, first, point):
            inside = _in_region(first, point)
            if inside is not None and inside != (seen == TRUE) and (inside or not equal):
                found.append(f"{seen} at {shown}, in the region: {inside}")
    return found


def _generic(case: Trial, first: Part, point: Point) -> bool:
    """Whether the point lies in an open cell, and no equation holds by chance."""
    if not first.cuts and not first.pieces:
        return False
    coordinates = [point[n] for n in first.task.names]
    if any(value_at(cut, coordinates) == 0 for cut in first.cuts):
        return False
    rels = (*case.statement.relations, *case.statement.conditions)
    try:
        return all(compared(rel, point) != "=" for rel in rels if rel.operator != "=")
    except (NoValue, Unclear):
        return True


def _in_region(first: Part, point: Point) -> bool | None:
    """Whether the point lies where the verdict says that the statement holds."""
    literals = separating(first)
    if literals is None:
        return None
    coordinates = [point[n] for n in first.task.names]
    return all(value_at(p, coordinates) * sign > 0 for p, sign in literals)
