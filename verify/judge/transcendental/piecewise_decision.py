"""Statements in which functions jump, decided part by part of the domain."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial

from gainproof.verify.judge.exact.ball_text import value_shown
from gainproof.verify.judge.exact.balls import Balls
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of, walk
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.functions import has_jumps
from gainproof.verify.judge.exact.rational_points import try_points
from gainproof.verify.judge.exact.statement import (
    NOT_EVALUATED,
    Enclosure,
    Outcome,
    Rel,
    Statement,
    Witness,
)
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.witness import inside
from gainproof.verify.judge.exact.work_limits import Nowhere, Undecided
from gainproof.verify.judge.transcendental.certificate import Decides, certificate_of
from gainproof.verify.judge.transcendental.constant_folding import folded
from gainproof.verify.judge.transcendental.domain_parts import (
    EVERY,
    Part,
    Sides,
    Signs,
    is_above,
    operator_of,
)
from gainproof.verify.judge.transcendental.domain_text import domain_text
from gainproof.verify.judge.transcendental.free_values import where_valued
from gainproof.verify.judge.transcendental.jump_functions import parts_of
from gainproof.verify.judge.transcendental.monomials import monomials, terms_expr
from gainproof.verify.judge.transcendental.special_points import point_text
from gainproof.verify.judge.verdict_words import LACKS_VALUE

PRECISION = 128
NO_VALUE = "no value on any part of the domain"
METHOD = "one part of the domain after the other"
Told = Mapping[Sides, Signs]


def jumps(statement: Statement) -> bool:
    """Whether a function with jumps stands anywhere in it."""
    return any(map(has_jumps, walk(*statement.exprs())))


def by_parts(
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
) -> Outcome:
    """The verdict on a statement with functions that jump. Raises Undecided."""
    boxes = {n: boxes.get(n, Box(stated=False)) for n in statement.symbols()}
    found: list[tuple[Part, Outcome]] = []
    reasons: list[str] = []
    nothing: list[Told] = []
    empty = False
    try:
        parts = parts_of(statement, boxes, labels, partial(_holds, decides=decides))
    except Undecided as why:
        parts, reasons = [], [str(why)]
    for part in parts:
        if part.lacks and not _counts(part):
            nothing.append(part.told)
            continue
        try:
            if part.lacks:
                came = _without_value(part, statement, parameter, decides)
            else:
                came = decides(*part.within(), parameter, part.labels)
            found.append((part, came))
        except Nowhere:
            empty = True
        except Undecided as why:
            reasons.append(str(why))
    if not reasons and all(p.only_values and o.verdict == "proved" for p, o in found):
        # that there are values is not yet that anything is true of them
        if empty and not nothing:
            raise Nowhere
        if found:
            raise Undecided(NO_VALUE)
    certificate = certificate_of(statement, boxes, parameter, labels)
    if found and not reasons and all(outcome.verdict == "proved" for _, outcome in found):
        everywhere = domain_text(statement, boxes, labels)
        loose = nothing or not all(_has_values(part, parameter, decides) for part, _ in found)
        domain = where_valued(everywhere) if loose else everywhere
        reason = "holds on the whole domain"
        method = "; ".join(dict.fromkeys([METHOD, *(o.method for _, o in found)]))
        return Outcome("proved", domain, reason, method, None, certificate)
    failing = [(p, o) for p, o in found if o.verdict in ("refuted", "conditional")]
    if not failing:
        points = try_points(statement, boxes, labels)
        if points is not None:
            return replace(points, certificate=certificate if points.witness else {})
        raise Undecided("; ".join(dict.fromkeys(reasons)) or NO_VALUE)
    failing.sort(key=lambda each: (each[1].verdict != "refuted", not _is_wide(each[0])))
    part, fails = failing[0]
    witness = fails.witness if part.lacks else _told_anew(fails.witness, part, statement)
    assert witness is not None
    method = f"{METHOD}; {fails.method}"
    claimed = [(p, o) for p, o in found if not p.only_values]
    holding = [(p, o) for p, o in claimed if o.verdict in ("proved", "conditional")]
    if not any(_is_wide(p) for p, _ in holding):
        first = _in_first_steps(statement, boxes, parameter, labels, decides, part.steps)
        if first is not None:
            reason = f"fails {witness.text()}; holds at least {first}"
            return Outcome("conditional", first, reason, method, witness, certificate, fails.reach)
        reason = f"fails {witness.text()}; where it may hold is not determined"
        return Outcome("refuted", "", reason, method, witness, certificate, fails.reach)
    told = _merged([*nothing, *[p.told for p, o in holding if o.verdict == "proved"]])
    words = [_text(each, labels, parts) for each in told]
    words += [_partly(p, o, parts) for p, o in holding if o.verdict == "conditional"]
    domain = "everywhere" if {} in told else f"for {' or '.join(dict.fromkeys(words))}"
    if any(p.only_values for p, _ in failing):
        domain = where_valued(domain)
    extent = "holds at least" if reasons else "holds"
    reason = f"fails {witness.text()}; {extent} {domain}"
    return Outcome("conditional", domain, reason, method, witness, certificate, fails.reach)


def _in_first_steps(
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
    steps: Iterable[Expr],
) -> str | None:
    """Where a statement is proved whose whole parts are 0, as angles within a turn; None if it is
    not.
    """
    own = [over for over in steps if symbols_of(over) <= statement.symbols()]
    rels = [Rel(o, over, number(k)) for over in own for o, k in ((">=", 0), ("<", 1))]
    within = Part(statement, boxes, labels).under(*rels)
    if not own or within is None or not {*within.within()[0].given} - {*statement.given}:
        return None
    try:
        found = decides(*within.within(), parameter, labels)
    except Undecided:
        return None
    return f"for {_text(within.told, labels, ())}" if found.verdict == "proved" else None


def _holds(rel: Rel, part: Part, decides: Decides) -> bool:
    """Whether a relation follows from what is said of a part without functions that jump."""
    statement, boxes = part.within()
    given = [r for r in statement.domain if not any(map(has_jumps, walk(r.left, r.right)))]
    try:
        asked = Statement((rel,), given=tuple(given))
        return decides(asked, boxes, None, part.labels).verdict == "proved"
    except Undecided:
        return False


def _counts(part: Part) -> bool:
    """Whether it matters that there is no value: in what is claimed, on a stated domain."""
    names = symbols_of(*[side for sides in part.told for side in sides])
    return any(part.boxes.get(name, Box(stated=False)).stated for name in names)


def _has_values(part: Part, parameter: str | None, decides: Decides) -> bool:
    """Whether what is proved on a part has values everywhere on it."""
    within, boxes = part.within()
    if all(box.stated for box in boxes.values()) or is_total(*within.exprs()):
        return True
    stated = {name: replace(box, stated=True) for name, box in boxes.items()}
    try:
        return decides(within, stated, parameter, part.labels).verdict == "proved"
    except Undecided:
        return False


def _without_value(
    part: Part, statement: Statement, parameter: str | None, decides: Decides
) -> Outcome:
    """Refuted at a point of a part on which a function has no value."""
    within, boxes = part.within()
    false = Statement((Rel("=", number(0), number(1)),), given=within.domain)
    found = decides(false, boxes, parameter, part.labels)
    if found.witness is None:
        raise Undecided("a function without a value")
    point = _told_anew(found.witness, part, statement).point
    names = {part.labels.get(name, name): name for name in statement.symbols()}
    try:
        balls = Balls({names[label]: Fraction(v) for label, v in point.items()}, PRECISION)
    except (KeyError, ValueError):
        balls = Balls({}, PRECISION)
    none = Enclosure("", "", part.lacks)
    for rel in statement.relations:
        left, right = (value_shown(side, balls) for side in (rel.left, rel.right))
        if not {left.undefined, right.undefined} <= {None, NOT_EVALUATED}:
            break
    else:
        left, right = none, none
    lacking = Witness(point, rel.operator, left, right, note=LACKS_VALUE)
    return replace(found, verdict="refuted", witness=lacking)


def _is_wide(part: Part) -> bool:
    """Whether it has an inside, as far as what tells it goes."""
    return all(signs != {0} for signs in part.told.values())


def _merged(found: Iterable[Told]) -> list[Told]:
    """The same union told by fewer parts: those that differ in the sign of one difference."""
    parts = list(found)
    while True:
        pair = next(
            (
                (a, b, c)
                for a in parts
                for b in parts
                if a is not b and (c := _union(a, b)) is not None
            ),
            None,
        )
        if pair is None:
            return parts
        parts = [*[each for each in parts if each is not pair[0] and each is not pair[1]], pair[2]]


def _union(a: Told, b: Told) -> Told | None:
    keys = [k for k in dict.fromkeys((*a, *b)) if a.get(k, EVERY) != b.get(k, EVERY)]
    if len(keys) > 1:
        return None
    union = {k: a.get(k, EVERY) | b.get(k, EVERY) for k in dict.fromkeys((*a, *b))}
    # what is above a whole part is never below 0
    return {k: s for k, s in union.items() if s != EVERY and not (s == {0, 1} and is_above(k[0]))}


def _text(told: Told, labels: Mapping[str, str], parts: Iterable[Part]) -> str:
    names = dict(labels)
    for part in parts:
        names |= part.labels
    rels = [
        f"{labelled(left, names)} {operator_of(signs)} {labelled(right, names)}"
        for (left, right), signs in told.items()
    ]
    return ", ".join(rels) or "all values"


def _partly(part: Part, outcome: Outcome, parts: Iterable[Part]) -> str:
    own = [_text(part.told, part.labels, parts)] if part.told else []
    rest = outcome.domain.removeprefix("for ")
    return ", ".join([*own, *([] if rest in ("", "everywhere", *own) else [rest])])


def _told_anew(witness: Witness | None, part: Part, statement: Statement) -> Witness:
    """In the symbols of the statement, where a part replaced some, and with those that are no
    longer in it.
    """
    if witness is None:
        raise Undecided("false on a part of the domain, but no point that shows it was found")
    shown = {n: witness.point.get(part.labels.get(n, n)) for n in part.boxes}
    try:
        values = {n: number(Fraction(v)) for n, v in shown.items() if v is not None}
    except ValueError:
        return witness
    fixed = part.fixed
    for name in part.boxes.keys() - values.keys() - fixed.keys():
        value = inside(part.within()[1][name], 1)
        if value is None:
            return witness
        values[name] = number(value)
    values |= {name: substituted(value, values) for name, value in fixed.items()}
    point = {n: folded(terms_expr(monomials(substituted(e, values)))) for n, e in part.back.items()}
    point |= {n: values[n] for n in statement.symbols() if n in values and n not in point}
    if any(symbols_of(value) for value in point.values()):
        return witness
    return replace(witness, point=point_text(point, part.labels))
