"""Inequalities with functions decided by slopes; strict ones that are equalities at a point."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial

from gainproof.verify.judge.exact.box import Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.exact.rational_points import is_seen, try_points
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.readable_expression import readable
from gainproof.verify.judge.transcendental.algebraic_form import has_functions
from gainproof.verify.judge.transcendental.certificate import Decides, certificate_of
from gainproof.verify.judge.transcendental.domain_text import domain_text
from gainproof.verify.judge.transcendental.failing_points import equal_somewhere, fails_near
from gainproof.verify.judge.transcendental.growth import Rising
from gainproof.verify.judge.transcendental.interval_parts import Part
from gainproof.verify.judge.transcendental.mean_value_theorem import by_slopes
from gainproof.verify.judge.transcendental.positive_by_balls import Pieces, by_pieces
from gainproof.verify.judge.transcendental.smoothness import Proves
from gainproof.verify.judge.transcendental.symbols_over_pi import scaled

MOST_SLOPES = 5
"""Slopes of slopes: a function beside its series up to that power."""
MOST_QUESTIONS = 20
"""With functions in them. What was proved in trials needed ten at most, one may take seconds."""
METHOD = "its value at a point and slopes away from it"
LONGEST = 300


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
    told: dict[Rel, Sequence[Part]] = {}
    questions = iter(range(MOST_QUESTIONS))
    proves = _prover(parameter, freely, MOST_SLOPES, told, questions)
    turned = scaled(statement, boxes, labels)
    try:
        found = by_slopes(turned.statement, turned.boxes, proves)
    except Undecided:
        told_of = turned.statement, turned.boxes, turned.labels
        fails = fails_near(*told_of) or equal_somewhere(*told_of, proves)
        if fails is None:
            raise
        return fails
    where = domain_text(turned.statement, turned.boxes, turned.labels)
    how = {"slopes": slope_lines(found, told, turned.labels)}
    certificate = certificate_of(statement, boxes, parameter, labels, how)
    return Outcome("proved", where, "holds on the whole domain", METHOD, None, certificate)


def _prover(
    parameter: str | None,
    freely: Decides,
    most: int,
    told: dict[Rel, Sequence[Part]],
    questions: Iterator[int],
) -> Proves:
    """What is proved without points, with at most so many slopes in one another; how is `told`.
    When the `questions` are used up nothing more is.
    """

    def by_more_slopes(
        part: Statement, boxes: Boxes, parameter: str | None, _labels: Mapping[str, str]
    ) -> Outcome:
        inner = _prover(parameter, freely, most - 1, told, questions)
        # the first proof rests on what was told before it; a later one may rest on this itself
        told.setdefault(part.relations[0], by_slopes(part, boxes, inner))
        return Outcome("proved", "", "", METHOD)

    def proves(rel: Rel, boxes: Boxes) -> bool:
        part = Statement((rel,))
        where = {name: boxes[name] for name in part.symbols()}
        if not has_functions(part):
            return _is_proved(partial(settle, only_proof=True), part, where, parameter)
        if not where and is_seen(rel):
            return True
        seen = try_points(part, where, {})
        if (seen is not None and seen.verdict == "refuted") or next(questions, None) is None:
            return False
        pieces = by_pieces(rel, *where.values()) if len(where) == 1 else None
        if pieces is not None:
            told[rel] = [pieces]
            return True
        ways: list[Decides] = [freely, by_more_slopes] if most > 1 else [freely]
        return any(_is_proved(way, part, where, parameter) for way in ways)

    return proves


def _is_proved(way: Decides, part: Statement, boxes: Boxes, parameter: str | None) -> bool:
    try:
        return way(part, boxes, parameter, {}).verdict == "proved"
    except Undecided:
        return False


def slope_lines(
    found: Iterable[Part], told: Mapping[Rel, Sequence[Part]], labels: Mapping[str, str]
) -> list[str]:
    """What is above 0, then each slope on which it rests, if not all its signs are plain."""
    return list(dict.fromkeys(_lines(found, told, labels)))


def _lines(
    found: Iterable[Part], told: Mapping[Rel, Sequence[Part]], labels: Mapping[str, str]
) -> Iterator[str]:
    for each in found:
        if isinstance(each, Rising) and each.ratio is not None:
            first, second = (labels.get(n, n) for n in each.ratio)
            labels = {**labels, each.name: f"({first}/{second})"}
        name = labels.get(each.name, each.name)
        stated = f"{_text(each.relation.left, labels)} {each.relation.operator} 0"
        if isinstance(each, Pieces):
            reach = f"{each.lower} <= {name} <= {each.upper}"
            yield f"{reach}: {stated}: balls show it on pieces, {each.count} of them"
            continue
        where = f"{name} = {each.point}"
        value = _text(each.value, labels)
        known = " and ".join(
            f"{_text(rel.left, labels)} {rel.operator} 0" for rel in dict.fromkeys(each.slopes)
        )
        turned = f"with 1/{name} in the place of {name}, " if each.turned else ""
        within = "" if each.within is None else f"{each.within.text(name)}: "
        yield f"{within}{turned}{stated}: it is {value} at {where}; slope away from there: {known}"
        below = (part for rel in each.slopes for part in told.get(rel, ()))
        yield from _lines(below, told, labels)


def _text(expr: Expr, labels: Mapping[str, str]) -> str:
    names = {name: symbol(labels.get(name, name)) for name in symbols_of(expr)}
    lines, (text,) = written(readable(substituted(expr, names)))
    text = "; ".join([text, *lines])
    return text if len(text) <= LONGEST else "(a long formula)"
