"""Exact rational points, tried where no method decides: they can refute and never prove."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import chain

from gainproof.verify.judge.exact.ball_text import enclosure, separated, value_shown
from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved, compared, enclosed
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, walk
from gainproof.verify.judge.exact.expression_text import is_series
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.simple_points import at_bounds, at_ends, simple_points
from gainproof.verify.judge.exact.statement import (
    NEGATED,
    NOT_EVALUATED,
    Outcome,
    Rel,
    Statement,
    Witness,
    refuted,
)
from gainproof.verify.judge.verdict_words import BOTH_EQUAL, LACKS_VALUE

PRECISIONS = (128, 512, 2048)
AGREED_BITS = 400
LEAST = 8


def try_points(
    statement: Statement,
    boxes: Mapping[str, Box],
    labels: Mapping[str, str],
    *,
    exactly: bool = False,
) -> Outcome | None:
    """`refuted` with a witness, `held` if at least LEAST points agree and none differs, or None.

    Only for statements of the form `relations if conditions`. A strict relation fails `exactly`
    where both sides are one number, too.
    """
    if statement.connective != "if":
        return None
    agreed = 0
    points = chain(simple_points(sorted(statement.symbols()), boxes), at_bounds(statement, boxes))
    for tried, point in enumerate(points, start=1):
        found = _at(statement, point, labels, exactly=exactly)
        if isinstance(found, Witness):
            return refuted(found, "balls at an exact point", tried)
        agreed += found
    if agreed < LEAST:
        return None
    reason = f"agrees at {agreed} exact points to {AGREED_BITS * 3 // 10} digits; no proof"
    return Outcome("held", "", reason, "balls at exact points")


def without_value(
    statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Outcome | None:
    """`refuted` with a point of a domain that is stated for all symbols where a side has no value;
    None if no such point is found. Only for statements of the form `relations if conditions`.
    """
    names = sorted(statement.symbols())
    # the index of a sum is no symbol of a point: it runs between bounds
    sums = any(map(is_series, walk(*statement.exprs())))
    stated = all(n in boxes and boxes[n].stated for n in names)
    if statement.connective != "if" or sums or not stated:
        return None
    points = chain(simple_points(names, boxes), at_ends(names, boxes))
    for tried, point in enumerate(points, start=1):
        balls = Balls(point, PRECISIONS[0])
        try:
            if not all(_is_certain(rel, point, balls) for rel in statement.domain):
                continue
        except (NoValue, Unresolved):
            continue
        for rel in statement.relations:
            left, right = value_shown(rel.left, balls), value_shown(rel.right, balls)
            reasons = {left.undefined, right.undefined} - {None}
            if reasons and NOT_EVALUATED not in reasons:
                where = {labels.get(name, name): str(value) for name, value in point.items()}
                found = Witness(where, rel.operator, left, right, note=LACKS_VALUE)
                return refuted(found, "no value at an exact point", tried)
    return None


def failure_at(
    statement: Statement, point: Mapping[str, Fraction], labels: Mapping[str, str]
) -> Witness | None:
    """The witness if a statement of the form `relations if conditions` is seen to fail there."""
    found = _at(statement, point, labels) if statement.connective == "if" else None
    return found if isinstance(found, Witness) else None


def failure_where(
    other: Witness, statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Outcome | None:
    """`refuted` if the statement is seen to fail where another one has its witness, at a rational
    point of the domain.
    """
    try:
        point = {n: Fraction(other.point[labels.get(n, n)]) for n in sorted(statement.symbols())}
    except (KeyError, ValueError):
        return None
    if not all(boxes.get(name, Box()).holds(value) for name, value in point.items()):
        return None
    found = failure_at(statement, point, labels)
    return None if found is None else refuted(found, "balls at an exact point")


def is_seen(rel: Rel) -> bool:
    """Whether balls show an inequality between numbers."""
    opposite = NEGATED.get(rel.operator)
    if opposite is None:
        return False
    return failure_at(Statement((Rel(opposite, rel.left, rel.right),)), {}, {}) is not None


def _at(
    statement: Statement,
    point: Mapping[str, Fraction],
    labels: Mapping[str, str],
    *,
    exactly: bool = False,
) -> Witness | int:
    """A witness, 1 if the statement was seen to hold at the point, 0 if it says nothing there."""
    for precision in PRECISIONS:
        balls = Balls(point, precision)
        try:
            if not all(_holds(rel, balls) for rel in statement.domain):
                return 0
            for needed in statement.needed:
                balls.round(needed)
            for rel in statement.relations:
                if _holds(rel, balls, exactly=exactly):
                    continue
                if not all(_is_certain(each, point, balls) for each in statement.domain):
                    return 0
                left, right = balls.round(rel.left), balls.round(rel.right)
                where = {labels.get(name, name): str(value) for name, value in point.items()}
                if _are_one_number(left, right):
                    both = enclosure(left, 12)
                    return Witness(where, rel.operator, both, both, exact=True, note=BOTH_EQUAL)
                shown = separated(left, right)
                if shown is None:
                    raise Unresolved("sides too close")
                return Witness(where, rel.operator, *shown)
            return 1
        except Unresolved:
            continue
        except NoValue:
            return 0
    return 0


def _holds(rel: Rel, balls: Balls, *, exactly: bool = False) -> bool:
    """Truth by balls; two sides that agree to AGREED_BITS count as equal, for a strict relation
    only if they are `exactly` one number. Raises Unresolved, NoValue.
    """
    a, b = balls.round(rel.left), balls.round(rel.right)
    if (known := compared(rel.operator, a, b)) is not None:
        return known
    if exactly and _are_one_number(a, b):
        return rel.operator in ("=", "<=", ">=")
    gap = a - b
    if rel.operator in ("=", "<=", ">=") and gap.abs_upper() * 2**AGREED_BITS < a.abs_upper() + 1:
        return True
    raise Unresolved("sides that overlap")


def _is_certain(rel: Rel, point: Mapping[str, Fraction], balls: Balls) -> bool:
    """Whether a relation is seen to hold at a point: sides that only agree to many digits may
    differ. Raises Unresolved, NoValue.
    """
    if not _holds(rel, balls, exactly=True):
        return False
    a, b = balls.round(rel.left), balls.round(rel.right)
    if not a.overlaps(b) or rel.left == rel.right or _are_one_number(a, b):
        return True
    put_in = {name: number(value) for name, value in point.items()}
    left, right = (constant_value(substituted(side, put_in)) for side in (rel.left, rel.right))
    return left is not None and left == right


def _are_one_number(a: Ball, b: Ball) -> bool:
    return bool(a.is_exact() and b.is_exact() and a == b)


def with_values(
    witness: Witness, quantities: Mapping[str, Expr], labels: Mapping[str, str]
) -> Witness:
    """The witness with the values of named quantities at its point, where the point is rational."""
    try:
        point = {
            name: Fraction(witness.point[label])
            for name, label in labels.items()
            if label in witness.point
        }
    except ValueError:
        return witness
    values = {}
    for token, expr in quantities.items():
        try:
            values[token] = enclosure(enclosed(expr, point, PRECISIONS[0]), 12)
        except (NoValue, Unresolved):
            continue
    return replace(witness, values=values)
