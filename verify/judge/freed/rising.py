"""Inequalities with functions decided by slopes; strict ones that are equalities at a point."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.certificate import statement_data
from gainproof.verify.judge.exact.enclose import Balls, NoValue, Unresolved
from gainproof.verify.judge.exact.enclosure import enclosure
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.points import try_points
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement, Witness
from gainproof.verify.judge.freed.domain_words import domain_text
from gainproof.verify.judge.freed.folding import folded
from gainproof.verify.judge.freed.rewriting import has_functions
from gainproof.verify.judge.freed.slope_words import slope_lines
from gainproof.verify.judge.freed.slopes import Rising, by_slopes, points, sides
from gainproof.verify.judge.freed.smooth import Boxes, Proves
from gainproof.verify.judge.hypothesis import settle

MOST_SLOPES = 5
"""Slopes of slopes: a function beside its series up to that power."""
MOST_QUESTIONS = 20
"""With functions in them. What was proved in trials needed ten at most, one may take seconds."""
PRECISION = 128
METHOD = "its value at a point and slopes away from it"

Decides = Callable[[Statement, Boxes, str | None, Mapping[str, str]], Outcome]


def rising(
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    freely: Decides,
) -> Outcome:
    """Proved by slopes; false where both sides of a strict one are equal at a point. `freely`
    decides what holds for whatever values functions take. Raises Undecided.
    """
    count = iter(range(MOST_QUESTIONS))

    def limited(*question: Any) -> Outcome:
        if next(count, None) is None:
            raise Undecided("too many slopes")
        return freely(*question)

    told: dict[Rel, Rising] = {}
    proves = _prover(parameter, limited, MOST_SLOPES, told)
    try:
        found = by_slopes(statement, boxes, proves)
    except Undecided:
        equal = _equal(statement, boxes, labels, proves)
        if equal is None:
            raise
        return equal
    where = domain_text(statement, boxes, labels)
    own = {name: box for name, box in boxes.items() if name in statement.symbols()}
    certificate = {
        "checked": "replayed",
        "engine": "functions",
        "statement": statement_data(statement, own, parameter, labels),
        "slopes": slope_lines(found, told, labels),
    }
    return Outcome("proved", where, "holds on the whole domain", METHOD, None, certificate)


def _prover(parameter: str | None, freely: Decides, most: int, told: dict[Rel, Rising]) -> Proves:
    """What is proved without points, with at most so many slopes in one another; how is `told`."""

    def by_more_slopes(
        part: Statement, boxes: Boxes, parameter: str | None, _labels: Mapping[str, str]
    ) -> Outcome:
        told[part.relations[0]], *_ = by_slopes(
            part, boxes, _prover(parameter, freely, most - 1, told)
        )
        return Outcome("proved", "", "", METHOD)

    def proves(rel: Rel, boxes: Boxes) -> bool:
        part = Statement((rel,))
        where = {name: boxes[name] for name in part.symbols()}
        if not has_functions(part):
            return _is_proved(partial(settle, only_proof=True), part, where, parameter)
        seen = try_points(part, where, {})
        if seen is not None and seen.verdict == "refuted":
            return False
        ways: list[Decides] = [freely, by_more_slopes] if most > 1 else [freely]
        return any(_is_proved(way, part, where, parameter) for way in ways)

    return proves


def _is_proved(way: Decides, part: Statement, boxes: Boxes, parameter: str | None) -> bool:
    try:
        return way(part, boxes, parameter, {}).verdict == "proved"
    except Undecided:
        return False


def _equal(
    statement: Statement, boxes: Boxes, labels: Mapping[str, str], proves: Proves
) -> Outcome | None:
    """A strict inequality in one symbol that is an equality at a point."""
    names = sorted(statement.symbols())
    if len(names) != 1 or statement.connective != "if" or statement.domain or statement.needed:
        return None
    (name,) = names
    box = replace(boxes.get(name, Box()), stated=True)
    for point in filter(box.holds, points(box)):
        for rel in statement.relations:
            witness = _equal_at(rel, name, point, labels, proves)
            if witness is not None:
                return _but_there(statement, name, point, box, witness, labels, proves)
    return None


def _equal_at(
    rel: Rel, name: str, point: Fraction, labels: Mapping[str, str], proves: Proves
) -> Witness | None:
    if rel.operator not in ("<", ">", "!="):
        return None
    here = {name: number(point)}
    both = (folded(substituted(side, here)) for side in (rel.left, rel.right))
    if not proves(Rel("=", *both), {}):
        return None
    try:
        ball = enclosure(Balls({name: point}, PRECISION).round(rel.left), 12)
    except (NoValue, Unresolved):
        return None
    where = {labels.get(name, name): str(point)}
    note = "both sides are equal, exactly"
    return Witness(where, rel.operator, ball, ball, exact=True, note=note)


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
        for side in beside:
            by_slopes(statement, {name: side}, proves)
    except Undecided:
        reason = f"fails {witness.text()}; where it may hold is not determined"
        return Outcome("refuted", "", reason, "both sides at an exact point", witness, {}, 1)
    held = " or ".join(side.text(labels.get(name, name)) for side in reversed(beside))
    reason = f"fails {witness.text()}; holds exactly for {held}"
    return Outcome("conditional", f"for {held}", reason, METHOD, witness, {}, 1)
