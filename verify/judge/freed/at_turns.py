"""Angles that are multiples of pi/12, at which a side may have no value: none is rational."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.enclose import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.expression import Expr, div, mul, number, symbols_of, walk
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.points import without_value
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.freed.atoms import ANGLES
from gainproof.verify.judge.freed.circle import LABEL, PI, PRECISION, exact_angles, pi_box
from gainproof.verify.judge.freed.monomials import monomials
from gainproof.verify.judge.freed.rewriting import bound_names
from gainproof.verify.judge.freed.scaled import scaled
from gainproof.verify.judge.hypothesis import settle

TWELFTHS = (0, 6, -6, 12, -12, 3, -3, 9, -9, 4, -4, 8, -8, 2, -2, 10, -10, 18, 24)
"""Multiples of pi/12, those where functions of angles are 0 or have no value first."""


def without_value_at_turns(
    statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Outcome | None:
    """What `without_value` finds where one symbol is a multiple of pi."""
    turned = scaled(statement, boxes, labels)
    for name in sorted(_asked_for(turned.statement) - bound_names(statement)):
        is_turn = name not in boxes
        label = turned.labels.get(name, name) if is_turn else f"{labels.get(name, name)}/{LABEL}"
        for turn, value in _multiples(turned.boxes.get(name, Box(stated=False)), is_turn):
            part = turned.statement.mapped(partial(_at_angle, name=name, angle=value))
            found = without_value(part, _spoken_of(part, turned.boxes), turned.labels)
            if found is not None and found.witness is not None:
                point = {label: str(turn), **found.witness.point}
                witness = replace(found.witness, point=point)
                reason = found.reason.replace(found.witness.text(), witness.text())
                return replace(found, witness=witness, reason=reason)
    return None


def _asked_for(statement: Statement) -> set[str]:
    """Symbols on which it may depend whether a side has a value, where there are angles at all."""
    sides = [side for rel in statement.relations for side in (rel.left, rel.right)]
    calls = {node.name for node in walk(*sides) if node.kind == "call"}
    if not calls & {*ANGLES, PI.name}:
        return set()
    return symbols_of(*(part for node in walk(*sides) for part in _risky(node)))


def _risky(node: Expr) -> tuple[Expr, ...]:
    """The parts that may leave it without a value."""
    if node.kind == "div":
        return node.parts[1:]
    if node.kind == "call" and node.name in ("tan", "log"):
        return node.parts
    return node.parts if node.kind == "pow" and node.fraction < 0 else ()


def _spoken_of(statement: Statement, boxes: Mapping[str, Box]) -> Mapping[str, Box]:
    """All boxes as stated ones where a divisor is 0 whatever the symbols are."""
    sides = [side for rel in statement.relations for side in (rel.left, rel.right)]
    if not any(node.kind == "div" and node.parts[1] == number(0) for node in walk(*sides)):
        return boxes
    return {n: replace(boxes.get(n, Box()), stated=True) for n in statement.symbols()}


def _at_angle(expr: Expr, name: str, angle: Expr) -> Expr:
    """The expression with this put in, the values of functions there, and divisors that are 0."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        return div(parts[0], number(0)) if node.kind == "div" and _is_zero(parts[1]) else None

    return rebuilt(exact_angles(substituted(expr, {name: angle})), change)


def _is_zero(expr: Expr) -> bool:
    """Whether an expression of numbers only is shown to be 0 exactly."""
    with suppress(Undecided):
        if not monomials(expr) and all(n.kind != "div" and n.kind != "pow" for n in walk(expr)):
            return True
    if symbols_of(expr) or any(node.kind == "call" for node in walk(expr)):
        return False
    try:
        if not enclosed(expr, {}, PRECISION).contains(0):
            return False
        found = settle(Statement((Rel("=", expr, number(0)),)), {}, None, {}, only_proof=True)
    except (NoValue, Unresolved, Undecided):
        return False
    return found.verdict == "proved"


def _multiples(box: Box, is_turn: bool) -> Iterator[tuple[Fraction, Expr]]:
    """Numbers q and what to put in so that an angle is pi q, where that lies in a stated domain;
    `is_turn`: the symbol is the angle over pi already.
    """
    if not box.stated or box.integer:
        return
    around = pi_box()
    assert around.lower is not None
    assert around.upper is not None
    for count in TWELFTHS:
        turn = Fraction(count, 12)
        if is_turn and box.holds(turn):
            yield turn, number(turn)
        elif not is_turn and box.holds(turn * around.lower) and box.holds(turn * around.upper):
            yield turn, mul(PI, number(turn))
