"""Inequalities with functions that fail at or beside a simple point, or where they are lowest."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from gainproof.verify.judge.exact.ball_text import enclosure
from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.exact.rational_points import failure_at
from gainproof.verify.judge.exact.statement import (
    ORDERS,
    STRICT,
    Outcome,
    Rel,
    Statement,
    Witness,
    refuted,
)
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.constant_folding import folded
from gainproof.verify.judge.transcendental.growth import sides
from gainproof.verify.judge.transcendental.lowest_points import lowest
from gainproof.verify.judge.transcendental.mean_value_theorem import above_zero, by_slopes, points
from gainproof.verify.judge.transcendental.smoothness import Proves
from gainproof.verify.judge.verdict_words import BOTH_EQUAL

PRECISION = 128
SIDES = "both sides at an exact point, slopes away from it"
NEAR = tuple(Fraction(sign, 10**n) for n in (3, 6, 9, 12) for sign in (1, -1))
"""How far beside a point is looked: what agrees with a series there may fail close to it only."""
FAR = tuple(Fraction(sign * 10**n) for n in (4, 6, 9, 12) for sign in (1, -1))
"""How far out: what comes close to a limit may fail there only."""


def fails_near(statement: Statement, boxes: Boxes, labels: Mapping[str, str]) -> Outcome | None:
    """Refuted by balls at a simple point of its one symbol, close to one, far out, or where it is
    lowest.
    """
    names = sorted(statement.symbols())
    if len(names) != 1:
        return None
    (name,) = names
    box = boxes.get(name, Box())
    below = [
        point
        for rel in statement.relations
        if rel.operator in ORDERS
        for point in lowest(above_zero(rel), name, box)
    ]
    for tried, point in enumerate([*_near(box), *below], start=1):
        witness = failure_at(statement, {name: point}, labels)
        if witness is not None:
            return refuted(witness, "balls at an exact point", tried)
    return None


def _near(box: Box) -> Iterator[Fraction]:
    simple = list(points(box))
    yield from filter(box.holds, simple)
    yield from (at for point in simple for step in NEAR if box.holds(at := point + step))
    yield from filter(box.holds, FAR)


def equal_somewhere(
    statement: Statement, boxes: Boxes, labels: Mapping[str, str], proves: Proves
) -> Outcome | None:
    """A strict inequality in one symbol that is an equality at a point."""
    names = sorted(statement.symbols())
    if statement.connective != "if" or statement.needed:
        return None
    if len(names) in (2, 3) and not statement.domain:
        return _equal_for_several(statement, names, boxes, labels, proves)
    if len(names) != 1:
        return None
    without = {rel.right.fraction for rel in statement.domain if _takes_out_a_number(rel)}
    if len(without) != len(set(statement.domain)):
        return None
    (name,) = names
    box = replace(boxes.get(name, Box()), stated=True)
    for point in filter(box.holds, points(box)):
        if point in without:
            continue
        for rel in statement.relations:
            witness = _equal_at(rel, {name: point}, labels, proves)
            if witness is not None:
                return _but_there(statement, name, point, box, witness, labels, proves)
    return None


def _equal_for_several(
    statement: Statement,
    names: Sequence[str],
    boxes: Boxes,
    labels: Mapping[str, str],
    proves: Proves,
) -> Outcome | None:
    """Refuted where all symbols are 1, -1 or 0."""
    for values in product((Fraction(1), Fraction(0), Fraction(-1)), repeat=len(names)):
        point = dict(zip(names, values, strict=True))
        if not all(boxes.get(name, Box()).holds(value) for name, value in point.items()):
            continue
        for rel in statement.relations:
            witness = _equal_at(rel, point, labels, proves)
            if witness is not None:
                return refuted(witness, "both sides at an exact point")
    return None


def _takes_out_a_number(rel: Rel) -> bool:
    return rel.operator == "!=" and (rel.left.kind, rel.right.kind) == ("symbol", "number")


def _equal_at(
    rel: Rel, point: Mapping[str, Fraction], labels: Mapping[str, str], proves: Proves
) -> Witness | None:
    if rel.operator not in STRICT:
        return None
    here = {name: number(value) for name, value in point.items()}
    left, right = (folded(substituted(side, here)) for side in (rel.left, rel.right))
    if not proves(Rel("=", left, right), {}):
        return None
    try:
        Balls(point, PRECISION).round(rel.left)  # which must have a value as it is printed
        ball = enclosure(Balls({}, PRECISION).round(left), 12)
    except (NoValue, Unresolved):
        return None
    where = {labels.get(name, name): str(value) for name, value in point.items()}
    return Witness(where, rel.operator, ball, ball, exact=True, note=BOTH_EQUAL)


def _but_there(
    statement: Statement,
    name: str,
    point: Fraction,
    box: Box,
    witness: Witness,
    labels: Mapping[str, str],
    proves: Proves,
) -> Outcome:
    """Conditional where it is proved on both sides of the point, else refuted."""
    beside = [replace(side, integer=box.integer) for _, side in sides(box, point)]
    try:
        if statement.domain:
            raise Undecided("where it holds would be more than two intervals")
        for side in beside:
            by_slopes(statement, {name: side}, proves)
    except Undecided:
        return refuted(witness, "both sides at an exact point")
    held = " or ".join(side.text(labels.get(name, name)) for side in reversed(beside))
    reason = f"fails {witness.text()}; holds exactly for {held}"
    return Outcome("conditional", f"for {held}", reason, SIDES, witness, {}, 1)
