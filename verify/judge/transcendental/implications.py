"""Implications with functions, reduced to statements from each of which they follow.

s = f, A => B follows from A => B with f in the place of s, for whatever values f takes;
H => C follows from not C => not H, where C has values everywhere. Bounds of a symbol among the
conditions are bounds of its domain.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from gainproof.verify.judge.domain import bounded, box_conditions
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of, walk
from gainproof.verify.judge.exact.statement import NEGATED, Rel, Statement
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.transcendental.inverse_functions import unwrapped

MOST_UNWRAPPED = 2
"""Functions in one another."""


def restated(statement: Statement, boxes: Boxes) -> Iterator[tuple[Statement, Boxes]]:
    """Statements that imply this one, which may be false where it is true, with their domains."""
    if statement.connective != "if":
        return
    base = statement
    for _ in range(1 + MOST_UNWRAPPED):
        put, turned = put_in(base, boxes), _turned_round(base)
        others = [(base, boxes)]
        if put is not None:
            where = _with_domains(put, boxes)
            others += [(put.statement, where), (put.within, where)]
        if turned is not None:
            others.append((turned, boxes))
        for other, where in others:
            if other is not statement:
                yield other, where
            within = _bounded(other, where)
            if within is not None:
                yield within
        inner = _unwrapped(base)
        if inner is None:
            return
        base = inner


def _unwrapped(statement: Statement) -> Statement | None:
    """With the arguments of functions in the place of these; None where there are none."""

    def each(relations: tuple[Rel, ...], *, condition: bool) -> tuple[Rel, ...]:
        found = [unwrapped(rel, condition=condition) or [rel] for rel in relations]
        return tuple(rel for group in found for rel in group)

    made = replace(
        statement,
        relations=each(statement.relations, condition=False),
        conditions=each(statement.conditions, condition=True),
        given=each(statement.given, condition=True),
    )
    return None if made == statement else made


class PutIn(NamedTuple):
    """A statement without the symbols that conditions give; the same `within` the domains of these;
    their values.
    """

    statement: Statement
    within: Statement
    values: Mapping[str, Expr]


def put_in(statement: Statement, boxes: Boxes) -> PutIn | None:
    """An implication without the symbols that conditions give. With it this one is true; where it
    fails `within`, that is where their values exist and lie in the domains of these symbols, this
    one does. None if no condition gives one, or one that is to be a whole number.
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
    if not values or any(boxes.get(name, Box()).integer for name in values):
        return None
    within = list(statement.given)
    for name, value in values.items():
        within.append(Rel("<=", value, value))
        within += box_conditions(name, value, boxes.get(name, Box(stated=False)))
    return PutIn(statement, replace(statement, given=tuple(within)), values)


def _with_domains(put: PutIn, boxes: Boxes) -> Boxes:
    """Where a symbol that was put away has a stated domain, what it is made of has one too: there
    no side may be without a value.
    """
    stated = [name for name in put.values if name in boxes and boxes[name].stated]
    behind = symbols_of(*(put.values[name] for name in stated))
    return {**boxes, **{n: replace(boxes.get(n, Box()), stated=True) for n in behind}}


def _definitions(statement: Statement) -> Iterator[tuple[Rel, str, Expr]]:
    """Conditions that say what a symbol, or a multiple of it, is: the symbol and its value."""
    for rel in statement.domain:
        for side, other in ((rel.left, rel.right), (rel.right, rel.left)):
            name, factor = _multiple(side)
            if rel.operator == "=" and name is not None and name not in symbols_of(other):
                yield rel, name, other if factor == 1 else other / number(factor)


def _multiple(side: Expr) -> tuple[str | None, Fraction]:
    """A symbol and by what number it is multiplied."""
    if side.kind == "symbol":
        return side.name, Fraction(1)
    if side.kind == "neg":
        name, factor = _multiple(side.parts[0])
        return name, -factor
    if side.kind == "mul" and len(side.parts) == 2 and side.parts[0].kind == "number":
        name, factor = _multiple(side.parts[1])
        return (name if side.parts[0].fraction else None), side.parts[0].fraction * factor
    return None, Fraction(1)


def _bounded(statement: Statement, boxes: Boxes) -> tuple[Statement, Boxes] | None:
    """Without the conditions that bound a symbol by a number. None if there are none, or if nothing
    lies within all of them.
    """
    found, left = bounded(boxes, statement.domain)
    if len(left) == len(statement.domain) or any(box.is_empty for box in found.values()):
        return None
    return replace(statement, conditions=left, given=()), found


def _turned_round(statement: Statement) -> Statement | None:
    """The contrapositive of an implication between two inequalities, of which the first has
    functions and the second none and no divisor.
    """
    if len(statement.relations) != 1 or len(statement.conditions) != 1:
        return None
    ((then,), (first,)) = statement.relations, statement.conditions
    if not {then.operator, first.operator} <= NEGATED.keys() or not is_total(then.left, then.right):
        return None
    if not any(node.kind == "call" for node in walk(first.left, first.right)):
        return None
    return replace(statement, relations=(_negated(first),), conditions=(_negated(then),))


def _negated(rel: Rel) -> Rel:
    return Rel(NEGATED[rel.operator], rel.left, rel.right)
