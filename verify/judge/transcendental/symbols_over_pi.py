"""A symbol whose domain ends at multiples of pi, as pi times another one that ends at rationals.

`0 < x < pi/2` says that x = pi s for one s with 0 < s < 1/2, so that a statement about all such x
is one about all such s.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, mul, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.statement import ORDERS, TURNED, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.monomials import monomials
from gainproof.verify.judge.transcendental.pi import LABEL, PI, TURN


@dataclass(frozen=True)
class Scaled:
    """The statement about the new symbols, where these live, what to call them, and in words what
    was said of symbols that are gone.
    """

    statement: Statement
    boxes: Mapping[str, Box]
    labels: Mapping[str, str]
    words: tuple[str, ...] = ()


def scaled(statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]) -> Scaled:
    """With every symbol replaced of which all conditions are such bounds, or one such value."""
    if statement.connective != "if" or PI not in walk(*_sides(statement.domain)):
        return Scaled(statement, boxes, labels)
    words: list[str] = []
    for name in sorted(symbols_of(*_sides(statement.domain))):
        own = [rel for rel in statement.domain if name in symbols_of(rel.left, rel.right)]
        box, value = boxes.get(name, Box()), _value(own, name)
        over = _box(box, own, name)
        if value is not None and not box.integer and box.lower is box.upper is None:
            put_in: Expr = mul(PI, number(value))
            words.append(f"{labels.get(name, name)} = {value} {LABEL}")
        elif over is not None:
            new = f"{name}/{LABEL}"
            put_in = mul(PI, symbol(new))
            boxes = {**{n: b for n, b in boxes.items() if n != name}, new: over}
            labels = {**labels, new: f"{labels.get(name, name)}/{LABEL}"}
        else:
            continue
        conditions, given = (
            tuple(rel for rel in rels if rel not in own)
            for rels in (statement.conditions, statement.given)
        )
        without = replace(statement, conditions=conditions, given=given)
        statement = without.mapped(partial(substituted, values={name: put_in}))
    return Scaled(statement, boxes, labels, tuple(words))


def _sides(rels: Iterable[Rel]) -> list[Expr]:
    return [side for rel in rels for side in (rel.left, rel.right)]


def _box(box: Box, conditions: Iterable[Rel], name: str) -> Box | None:
    """Where the symbol over pi lives; None if it is no interval with rational ends."""
    if box.integer or any(end not in (None, 0) for end in (box.lower, box.upper)):
        return None
    bounds = [_bound(rel, name) for rel in conditions]
    known = [bound for bound in bounds if bound is not None]
    if len(known) < len(bounds) or not any(end for _, end in known):
        return None  # what is only compared with 0 is no angle
    for bound in known:
        box = _cut(box, *bound)
    return None if box.is_empty else replace(box, stated=True)


def _value(conditions: list[Rel], name: str) -> Fraction | None:
    """The c of a condition `x = c pi` that is the only one."""
    if len(conditions) != 1 or conditions[0].operator != "=":
        return None
    found = _bound(replace(conditions[0], operator="<="), name)
    return None if found is None else found[1]


def _bound(rel: Rel, name: str) -> tuple[str, Fraction] | None:
    """`x < c pi` as < and c."""
    if rel.operator not in ORDERS:
        return None
    operator, other = rel.operator, rel.right
    if rel.left != symbol(name):
        operator, other = TURNED[rel.operator], rel.left
    if symbol(name) not in (rel.left, rel.right) or symbols_of(other):
        return None
    try:
        terms = monomials(other)
    except Undecided:
        return None
    return (operator, terms.get(TURN, Fraction(0))) if set(terms) <= {TURN} else None


def _cut(box: Box, operator: str, end: Fraction) -> Box:
    """A box up to one bound more."""
    is_open = operator in ("<", ">")
    if operator in ("<", "<="):
        if box.upper is not None and (box.upper, not box.upper_open) < (end, not is_open):
            return box
        return replace(box, upper=end, upper_open=is_open)
    if box.lower is not None and (box.lower, box.lower_open) > (end, is_open):
        return box
    return replace(box, lower=end, lower_open=is_open)
