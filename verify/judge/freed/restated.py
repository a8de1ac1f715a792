"""Implications with functions as other statements, from each of which they follow.

s = f, A => B follows from A => B with f in the place of s, for whatever values f takes;
H => C follows from not C => not H, where C has values everywhere. Bounds of a symbol among the
conditions are bounds of its domain.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of, walk
from gainproof.verify.judge.exact.statement import Rel, Statement

_OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}


Boxes = Mapping[str, Box]


def restated(statement: Statement, boxes: Boxes) -> Iterator[tuple[Statement, Boxes]]:
    """Statements that imply this one, which may be false where it is true, with their domains."""
    if statement.connective != "if":
        return
    put, _ = _put_in(statement)
    if put is not statement:
        yield put, boxes
    bounded = _bounded(statement, boxes)
    if bounded is not None:
        yield bounded
    turned = _turned_round(statement)
    if turned is not None:
        yield turned, boxes


def put_in(statement: Statement, boxes: Boxes) -> Statement | None:
    """An implication without the symbols that conditions give, false where this one is: that their
    values lie in the domains of these symbols is among its conditions. None if no condition gives
    one, or one that is to be a whole number.
    """
    if statement.connective != "if":
        return None
    put, values = _put_in(statement)
    within = list[Rel]()
    for name, value in values.items():
        box = boxes.get(name, Box())
        if box.integer:
            return None
        if box.lower is not None:
            within.append(Rel(">" if box.lower_open else ">=", value, number(box.lower)))
        if box.upper is not None:
            within.append(Rel("<" if box.upper_open else "<=", value, number(box.upper)))
    return replace(put, given=(*put.given, *within)) if values else None


def _put_in(statement: Statement) -> tuple[Statement, Mapping[str, Expr]]:
    """Without the symbols that conditions give, and their values. The domains of these symbols are
    left out: what is proved is proved of more.
    """
    values: dict[str, Expr] = {}
    while (given := next(_definitions(statement), None)) is not None:
        rel, name, value = given
        others = replace(
            statement,
            conditions=tuple(r for r in statement.conditions if r is not rel),
            given=tuple(r for r in statement.given if r is not rel),
        )
        statement = others.mapped(partial(substituted, values={name: value}))
        values = {n: substituted(e, {name: value}) for n, e in values.items()} | {name: value}
    return statement, values


def _definitions(statement: Statement) -> Iterator[tuple[Rel, str, Expr]]:
    """Conditions that say what a symbol is, the symbol and its value."""
    for rel in statement.domain:
        for side, other in ((rel.left, rel.right), (rel.right, rel.left)):
            if rel.operator == "=" and side.kind == "symbol" and side.name not in symbols_of(other):
                yield rel, side.name, other


def _bounded(statement: Statement, boxes: Boxes) -> tuple[Statement, Boxes] | None:
    """Without the conditions that bound a symbol by a number. None if there are none, or if nothing
    lies within all of them.
    """
    found, left = dict(boxes), list[Rel]()
    for rel in statement.domain:
        name, end = _bound(rel)
        if name is None or end is None or rel.operator not in _OPPOSITE:
            left.append(rel)
            continue
        found[name] = _cut(found.get(name, Box(stated=False)), rel, end)
        if found[name].is_empty:
            return None
    if len(left) == len(statement.domain):
        return None
    return replace(statement, conditions=tuple(left), given=()), found


def _bound(rel: Rel) -> tuple[str | None, Fraction | None]:
    if rel.right.kind == "symbol":
        return rel.right.name, constant_value(rel.left)
    return (rel.left.name if rel.left.kind == "symbol" else None), constant_value(rel.right)


def _cut(box: Box, rel: Rel, end: Fraction) -> Box:
    """The box as far as a symbol fulfils a relation to the number that is its end."""
    is_strict = rel.operator in ("<", ">")
    if (rel.operator in ("<", "<=")) == (rel.left.kind == "symbol"):
        if box.upper is None or end < box.upper or (end == box.upper and is_strict):
            return replace(box, upper=end, upper_open=is_strict)
    elif box.lower is None or end > box.lower or (end == box.lower and is_strict):
        return replace(box, lower=end, lower_open=is_strict)
    return box


def _turned_round(statement: Statement) -> Statement | None:
    """The contrapositive of an implication between two inequalities, of which the first has
    functions and the second none and no divisor.
    """
    if len(statement.relations) != 1 or len(statement.conditions) != 1:
        return None
    ((then,), (first,)) = statement.relations, statement.conditions
    if not {then.operator, first.operator} <= _OPPOSITE.keys() or not _is_polynomial(then):
        return None
    if not any(node.kind == "call" for node in walk(first.left, first.right)):
        return None
    return replace(statement, relations=(_negated(first),), conditions=(_negated(then),))


def _negated(rel: Rel) -> Rel:
    return Rel(_OPPOSITE[rel.operator], rel.left, rel.right)


def _is_polynomial(rel: Rel) -> bool:
    return all(
        node.kind in ("number", "symbol", "add", "mul", "neg")
        or (node.kind == "pow" and node.fraction.denominator == 1 and node.fraction > 0)
        for node in walk(rel.left, rel.right)
    )
