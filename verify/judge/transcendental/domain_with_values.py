"""Verdicts on a stated domain at some points of which a side has no value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbol, walk
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.certificate import Decides
from gainproof.verify.judge.transcendental.free_values import where_valued
from gainproof.verify.judge.transcendental.growth import sides
from gainproof.verify.judge.transcendental.symbols_over_pi import Scaled, scaled
from gainproof.verify.judge.verdict_words import DECIDES


def but_where_it_has(
    nowhere: Outcome,
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
    as_it_stands: Decides,
) -> Outcome:
    """`conditional` if the statement holds somewhere of all points where every part has a value,
    everywhere of these or not; else as it is.
    """
    if not statement.symbols():
        return nowhere
    turned = scaled(statement, boxes, labels)
    if (outside := _without_slices(turned, nowhere)) is not None:
        with suppress(Undecided):
            found = as_it_stands(*outside, parameter, turned.labels)
            if found.verdict == "proved":
                return _on_a_part(nowhere, found, found.domain, turned.words)
    loose = {name: replace(box, stated=False) for name, box in turned.boxes.items()}
    with suppress(Undecided):
        found = decides(turned.statement, loose, parameter, turned.labels)
        if found.verdict == "conditional":
            return found
        if found.verdict == "proved":
            return _on_a_part(nowhere, found, where_valued(found.domain), turned.words)
    for parts in _without_points(turned, statement, boxes, labels, nowhere):
        with suppress(Undecided):
            # where a value is missing once more no further part is taken
            proofs = [as_it_stands(each, where, parameter, names) for each, where, names in parts]
            if all(found.verdict == "proved" for found in proofs):
                held = " or ".join(found.domain for found in proofs)
                return _on_a_part(nowhere, proofs[0], held, turned.words)
    return nowhere


def _on_a_part(nowhere: Outcome, found: Outcome, held: str, words: Sequence[str]) -> Outcome:
    """What fails at a point and is proved on a part of the domain."""
    held = ", ".join([*words, held])
    held = held if held.startswith("where") else f"for {held}"
    return replace(
        found,
        verdict="conditional",
        domain=held,
        reason=f"fails {nowhere.witness.text() if nowhere.witness else ''}; holds {held}",
        witness=nowhere.witness,
        certificate={**found.certificate, DECIDES: found.verdict},
    )


def _without_slices(turned: Scaled, nowhere: Outcome) -> tuple[Statement, Boxes] | None:
    """The domain without those values of single symbols at the point that was found with which
    nothing has a value, whatever the others are; None if there are none.
    """
    statement, boxes = turned.statement, dict(turned.boxes)
    point = nowhere.witness.point if nowhere.witness else {}
    given = list(statement.given)
    for name in sorted(statement.symbols()):
        try:
            at = Fraction(point[turned.labels.get(name, name)])
        except (KeyError, ValueError):
            continue
        box = boxes.get(name, Box())
        if not box.stated or not any(_never(node, name, at) for node in walk(*statement.exprs())):
            continue
        if at in (box.lower, box.upper):
            low, high = box.lower_open or at == box.lower, box.upper_open or at == box.upper
            boxes[name] = replace(box, lower_open=low, upper_open=high)
        else:
            given.append(Rel("!=", symbol(name), number(at)))
    statement = replace(statement, given=tuple(given))
    changed = (statement, boxes) != (turned.statement, dict(turned.boxes))
    return (statement, boxes) if changed else None


def _never(node: Expr, name: str, at: Fraction) -> bool:
    """Whether a quotient or a logarithm has no value with this one of a symbol, whatever the others
    are.
    """
    match node.kind:
        case "div":
            part = node.parts[1]
        case "pow" if node.fraction < 0:
            part = node.parts[0]
        case "call" if node.name == "log":
            part = node.parts[0]
        case _:
            return False
    value = constant_value(tidied(substituted(part, {name: number(at)})))
    return value is not None and (value <= 0 if node.kind == "call" else value == 0)


Parts = list[tuple[Statement, Boxes, Mapping[str, str]]]


def _without_points(
    turned: Scaled, statement: Statement, boxes: Boxes, labels: Mapping[str, str], nowhere: Outcome
) -> Iterator[Parts]:
    """The domain without its ends, or in two parts without the point that was found."""
    for where in _with_open_ends(turned.statement, turned.boxes):
        yield [(turned.statement, where, turned.labels)]
    opened = _opened(statement)
    if opened != statement:
        yield [(opened, boxes, labels)]
    names = list(statement.symbols())
    point = nowhere.witness.point if nowhere.witness else {}
    if len(names) != 1 or statement.domain:
        return
    (name,) = names
    with suppress(KeyError, ValueError):
        at = Fraction(point[labels.get(name, name)])
        beside = [side for _, side in sides(boxes.get(name, Box()), at)]
        if len(beside) == 2:
            yield [(statement, {name: side}, labels) for side in reversed(beside)]


def _opened(statement: Statement) -> Statement:
    """With strict relations as conditions."""

    def each(rels: Sequence[Rel]) -> tuple[Rel, ...]:
        strict = {"<=": "<", ">=": ">"}
        return tuple(replace(rel, operator=strict.get(rel.operator, rel.operator)) for rel in rels)

    return replace(statement, conditions=each(statement.conditions), given=each(statement.given))


def but_where_they_differ(
    equal: Outcome,
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
) -> Outcome:
    """`conditional` if a statement that fails where both sides are one number holds with <= and >=
    in place of < and >; else as it is.
    """
    loose = {"<": "<=", ">": ">="}
    rels = [replace(r, operator=loose.get(r.operator, r.operator)) for r in statement.relations]
    if not equal.witness or not equal.witness.exact or tuple(rels) == statement.relations:
        return equal
    with suppress(Undecided):
        found = decides(replace(statement, relations=tuple(rels)), boxes, parameter, labels)
        if found.verdict == "proved":
            held = found.domain.removeprefix("everywhere")
            held = ", ".join([*([held] if held else []), "where both sides differ"])
            return _on_a_part(equal, found, held, ())
    return equal


def _with_open_ends(statement: Statement, boxes: Boxes) -> Iterator[Boxes]:
    """The domain of the one symbol without one of its ends or both."""
    names = statement.symbols()
    if len(names) != 1:
        return
    (name,) = names
    box = boxes.get(name, Box())
    for lower, upper in ((False, True), (True, False), (True, True)):
        opened = replace(
            box, lower_open=box.lower_open or lower, upper_open=box.upper_open or upper
        )
        if opened != box:
            yield {name: opened}
