"""Counterexamples of several parameters: small integers first, then points of cells and borders."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain, islice

from gainproof.verify.judge.cells.cell_statement import Task
from gainproof.verify.judge.cells.cell_truth import Piece
from gainproof.verify.judge.exact.ball_text import enclosure, separated
from gainproof.verify.judge.exact.balls import compared
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.connected_sets import Sample
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.rational_points import failure_at
from gainproof.verify.judge.exact.statement import NOT_EVALUATED, STRICT, Enclosure, Rel, Witness
from gainproof.verify.judge.exact.truth import FALSE
from gainproof.verify.judge.exact.witness import sides_witness, value_ball
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.readable_expression import readable
from gainproof.verify.judge.verdict_words import BOTH_EQUAL, LACKS_VALUE

PRECISIONS = (64, 256, 1024, 4096)
MOST_SIMPLE = 60
MOST_LOOKED_AT = 20_000
"""Of points that may lie outside of the domain: all, for five symbols."""
FARTHEST = 3
"""Of a number from one."""


def counterexample(
    task: Task, failed: Sequence[Piece], labels: Mapping[str, str]
) -> tuple[Witness, int]:
    """A point where the statement fails, the simplest that is found, and how many were tried.

    Raises Undecided if none of the cells gives one.
    """
    tried = 0
    exact = not any(rel.operator == "=" for rel in task.statement.domain)
    if exact and any(p.truth == FALSE and p.task is task for p in failed):
        for point in simple_points(task):
            tried += 1
            witness = failure_at(task.statement, point, labels)
            if witness is not None:
                return _with_solved(witness, task, labels), tried
    ordered = sorted(failed, key=lambda p: (p.truth != FALSE, -p.dimension))
    for piece in ordered:
        for sample in _samples(piece):
            tried += 1
            witness = _at(piece, sample, labels)
            if witness is not None:
                return witness, tried
    raise Undecided("the statement is false, but no rational point that shows it was found")


def simple_points(task: Task) -> Iterator[dict[str, Fraction]]:
    """Small integers, then halves, inside the boxes; those nearest to one first."""
    names = task.names
    count = 0
    for scale in (1, 2):
        steps = chain.from_iterable(
            _points(len(names), n) for n in range(len(names) * FARTHEST + 1)
        )
        for point in islice(steps, MOST_LOOKED_AT):
            values = [Fraction(n, scale) for n in point]
            if scale > 1 and all(v.denominator == 1 for v in values):
                continue
            if all(task.boxes[name].holds(v) for name, v in zip(names, values, strict=True)):
                count += 1
                if count > MOST_SIMPLE * scale:
                    break
                yield dict(zip(names, values, strict=True))


def _points(count: int, steps: int) -> Iterator[tuple[int, ...]]:
    """So many whole numbers that are together so many steps away from one, up to FARTHEST each."""
    if not count:
        yield from [()] if not steps else []
        return
    for far in range(min(steps, FARTHEST) + 1):
        for first in sorted({1 + far, 1 - far} - {1 + FARTHEST}, reverse=True):
            yield from ((first, *rest) for rest in _points(count - 1, steps - far))


def _samples(piece: Piece) -> tuple[Sample | None, ...]:
    return (*piece.place.samples, *piece.place.moved) or (None,)


def _at(piece: Piece, sample: Sample | None, labels: Mapping[str, str]) -> Witness | None:
    """The witness at a point of a piece, by balls that do not overlap or by exact equality."""
    local, rel = piece.local, piece.failing or piece.task.statement.relations[0]
    point = _point(piece, sample, labels)
    if piece.truth != FALSE:
        sides = [_side(piece, expr, sample) for expr in (rel.left, rel.right)]
        return Witness(point, rel.operator, sides[0], sides[1], note=LACKS_VALUE)
    if piece.task.statement.connective != "if":
        return sides_witness(piece.task.statement, piece.local, point)
    elements = local.tower.element(rel.left), local.tower.element(rel.right)
    for precision in PRECISIONS:
        a, b = (value_ball(local, e, sample, precision, ()) for e in elements)
        if a is None or b is None:
            continue
        apart = separated(a, b)
        if apart is not None:
            return None if compared(rel.operator, a, b) else Witness(point, rel.operator, *apart)
    if rel.operator in STRICT and _equal(piece, rel):
        a = value_ball(local, elements[0], sample, PRECISIONS[0], ())
        if a is not None:
            both = enclosure(a, 12)
            return Witness(point, rel.operator, both, both, exact=True, note=BOTH_EQUAL)
    return None


def _equal(piece: Piece, rel: Rel) -> bool:
    """Whether both sides are the same on the whole piece."""
    tower = piece.local.tower
    difference = rel.left - rel.right
    return difference.key in tower.elements and piece.local.vanishes(tower.element(difference).num)


def _side(piece: Piece, expr: Expr, sample: Sample | None) -> Enclosure:
    why = piece.local.undefined(expr)
    if why is not None:
        return Enclosure("", "", why)
    ball = value_ball(piece.local, piece.local.tower.element(expr), sample, PRECISIONS[0], ())
    return Enclosure("", "", NOT_EVALUATED) if ball is None else enclosure(ball, 12)


def _point(piece: Piece, sample: Sample | None, labels: Mapping[str, str]) -> dict[str, str]:
    """The point in the source's symbols, with what the solved symbols come to there."""
    names = piece.task.names
    values: dict[str, Fraction] = {}
    found: dict[str, str] = {}
    if isinstance(sample, tuple):
        for name, value in zip(names, sample, strict=True):
            if isinstance(value, Fraction):
                values[name] = value
            else:
                found[labels.get(name, name)] = value.text()
    elif sample is not None:
        values = {names[0]: sample}
    elif piece.place.at is not None:
        if piece.place.at.is_rational:
            values = {names[0]: piece.place.at.low}
        else:
            found[labels.get(names[0], names[0])] = piece.place.at.text()
    found |= {labels.get(name, name): str(value) for name, value in values.items()}
    known: dict[str, Expr] = {name: number(value) for name, value in values.items()}
    for name, expr in reversed(piece.task.solved):
        here = readable(rebuilt(substituted(expr, known), _rational))
        exact = constant_value(here)
        known[name] = here if exact is None else number(exact)
        found[labels.get(name, name)] = str(exact) if exact is not None else labelled(here, labels)
    return dict(sorted(found.items()))


def _rational(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
    value = constant_value(node)
    return None if value is None else number(value)


def _with_solved(witness: Witness, task: Task, labels: Mapping[str, str]) -> Witness:
    more = {labels.get(name, name): str(constant_value(expr)) for name, expr in task.solved}
    return replace(witness, point=dict(sorted({**witness.point, **more}.items())))
