"""Counterexamples: exact rational points, the simplest first, with both sides in balls that do not
overlap.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from math import ceil, floor

import flint

from gainproof.verify.judge.exact.ball_text import enclosure, separated
from gainproof.verify.judge.exact.balls import compared
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.connected_sets import Connected, Sample
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.radicands import Element
from gainproof.verify.judge.exact.statement import NOT_EVALUATED, Enclosure, Rel, Statement, Witness
from gainproof.verify.judge.exact.tower import Tower
from gainproof.verify.judge.exact.tower_at_place import FIRST_PRECISION, Local
from gainproof.verify.judge.exact.truth import FALSE, NO_VALUE, TRUE, Question, truth
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.verdict_words import BOTH_EQUAL, LACKS_VALUE, NOT_COMPARED, Shown

FREE_PATTERNS = (
    (1, 2, 3, 5, 7, 11, 13, 17),
    (2, 3, 5, 7, 11, 13, 17, 19),
    (3, 1, 4, 1, 5, 9, 2, 6),
    (1, 1, 1, 1, 1, 1, 1, 1),
)


def value_ball(
    local: Local,
    element: Element,
    sample: Sample | None,
    precision: int,
    free: tuple[Fraction, ...],
) -> Ball | None:
    """A ball round num / den, or None where it is not resolved."""
    top = local.ball(element.num, sample, precision, free)
    bottom = local.ball(element.den, sample, precision, free)
    if top is None or bottom is None or bottom.contains(0):
        return None
    with flint.ctx.workprec(precision):
        return top / bottom


def free_values(names: tuple[str, ...], boxes: Mapping[str, Box]) -> Iterator[tuple[Fraction, ...]]:
    """A few simple rational values for the free symbols, inside their domains."""
    for pattern in FREE_PATTERNS:
        values = []
        for k, name in enumerate(names):
            value = inside(boxes[name], pattern[k % len(pattern)] + 20 * (k // len(pattern)))
            if value is None:
                return
            values.append(value)
        yield tuple(values)
        if not names:
            return


def inside(box: Box, wanted: Fraction | int) -> Fraction | None:
    """A number of the box: the wanted one if it lies there, else one made from it; None if none is
    found.
    """
    wanted = Fraction(ceil(wanted)) if box.integer else Fraction(wanted)
    if box.holds(wanted):
        return wanted
    if box.lower is None:
        assert box.upper is not None
        made = floor(box.upper) - wanted
    elif box.upper is None:
        made = ceil(box.lower) + wanted
    elif box.integer:
        first = floor(box.lower) + 1 if box.lower_open else ceil(box.lower)
        last = ceil(box.upper) - 1 if box.upper_open else floor(box.upper)
        made = Fraction(first + int(wanted) % (last - first + 1) if last >= first else first)
    else:
        made = box.lower + (box.upper - box.lower) * wanted / (abs(wanted) + 1)
    return Fraction(made) if box.holds(Fraction(made)) else None


def sample_points(place: Connected, integer: bool) -> Iterable[Fraction | None]:
    """Points of a place to try, the simplest first; None is the point of a place that is one."""
    if not isinstance(place, Place) or not place.is_cell:
        return (None,)
    whole = [Fraction(n) for n in place.integers(12)]
    if integer:
        return whole
    spread: tuple[Fraction, ...] = place.samples
    return [*whole[:6], *[s for s in spread if s not in whole[:6]]]


def find_witness(
    local: Local, rel: Rel, boxes: Mapping[str, Box], labels: Mapping[str, str], integer: bool
) -> tuple[Witness, int] | None:
    """A point of the place where the relation fails, and how many points were tried."""
    tower = local.tower
    sides = tower.element(rel.left), tower.element(rel.right)
    tried = 0
    for precision in (FIRST_PRECISION, 256, 1024, tower.limits.precision):
        for sample in sample_points(local.place, integer):
            for free in free_values(tower.free, boxes):
                tried += 1
                a, b = (value_ball(local, side, sample, precision, free) for side in sides)
                if a is None or b is None:
                    continue
                shown = separated(a, b)
                if shown is None or compared(rel.operator, a, b):
                    continue
                point = point_text(local, sample, free, labels)
                return Witness(point, rel.operator, *shown), tried
    return None


def point_text(
    local: Local, sample: Fraction | None, free: tuple[Fraction, ...], labels: Mapping[str, str]
) -> dict[str, str]:
    """The point as symbol -> value."""
    point: dict[str, str] = {}
    parameter = local.tower.parameter
    if parameter is not None:
        if sample is not None:
            point[labels.get(parameter, parameter)] = str(sample)
        elif local.place.at is not None:
            point[labels.get(parameter, parameter)] = local.place.at.text()
    for name, value in zip(local.tower.free, free, strict=True):
        point[labels.get(name, name)] = str(value)
    return point


def equal_sides_witness(
    local: Local, rel: Rel, boxes: Mapping[str, Box], labels: Mapping[str, str], integer: bool
) -> Witness:
    """Where a strict inequality (or !=) fails because both sides are exactly equal. Raises
    Undecided.
    """
    for sample in sample_points(local.place, integer):
        for free in free_values(local.tower.free, boxes):
            ball = value_ball(local, local.tower.element(rel.left), sample, FIRST_PRECISION, free)
            if ball is not None:
                both = enclosure(ball, 12)
                point = point_text(local, sample, free, labels)
                note = BOTH_EQUAL
                return Witness(point, rel.operator, both, both, exact=True, note=note)
    raise Undecided("no simple point of the set where both sides are equal was found")


def undefined_witness(
    local: Local, rel: Rel, boxes: Mapping[str, Box], labels: Mapping[str, str], integer: bool
) -> Witness | None:
    """A point of the place where one side has no value."""
    samples = list(sample_points(local.place, integer))
    if not samples:
        return None
    free = next(free_values(local.tower.free, boxes), None)
    if free is None:
        return None
    sides = []
    for expr in (rel.left, rel.right):
        why = local.undefined(expr)
        ball = (
            None
            if why
            else value_ball(local, local.tower.element(expr), samples[0], FIRST_PRECISION, free)
        )
        if why is None and ball is not None:
            sides.append(enclosure(ball, 12))
        else:
            sides.append(Enclosure("", "", why or NOT_EVALUATED))
    point = point_text(local, samples[0], free, labels)
    return Witness(point, rel.operator, sides[0], sides[1], note=LACKS_VALUE)


SAID = {TRUE: "holds", FALSE: "does not hold", NO_VALUE: "has no value"}


class _Side(Question):
    """One side of an equivalence or implication, in the tower of the whole."""

    def __init__(self, relations: tuple[Rel, ...], tower: Tower) -> None:
        self.statement, self.boxes, self.tower = Statement(relations), {}, tower
        self.differences = {rel: rel.left - rel.right for rel in relations}


def truth_of_sides(what: str, first: str, second: str) -> str:
    """The note of a witness against an equivalence or implication: what each side comes to."""
    return f"the left side of the {what} {first}, the right {second}"


def sides_witness(statement: Statement, local: Local, point: Mapping[str, str]) -> Witness:
    """Against an equivalence or implication: what each side comes to at a point of the place, in
    whose tower the statement is.
    """
    first, second = (
        SAID[truth(_Side(rels, local.tower), local)[0]]
        for rels in (statement.relations, statement.conditions)
    )
    what = "equivalence" if statement.connective == "iff" else "implication"
    note = truth_of_sides(what, first, second)
    none = Enclosure("", "", NOT_COMPARED)
    return Witness(
        point, statement.relations[0].operator, none, none, exact=True, note=note, shows=Shown.TRUTH
    )
