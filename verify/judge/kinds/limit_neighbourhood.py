"""Conditions near the point of a limit, and on other symbols for the limit to have a meaning."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import islice, product

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of, walk
from gainproof.verify.judge.exact.statement import ALLOWED, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.kinds.claim_domain import Frame
from gainproof.verify.judge.kinds.conditions_for_values import where_valued
from gainproof.verify.judge.kinds.limit_point import SMALL, Approach
from gainproof.verify.judge.series.expression_series import expanded
from gainproof.verify.judge.series.series import ProvingOracle, leading, neat

TRIED = tuple(Fraction(n) for n in ("1", "2", "-1", "1/2", "0", "-1/2", "3", "-2"))
MOST_TRIED = 100


def others_frame(frame: Frame, approach: Approach) -> tuple[Frame, bool]:
    """The frame without the variable of the limit; whether what was left out of it does more than
    to say from which side the variable comes, so that nothing is refuted.
    """
    on_it = _on_it(frame, approach)
    kept = tuple(c for c in frame.conditions if c not in on_it)
    boxes: Mapping[str, Box] = {n: b for n, b in frame.boxes.items() if n != approach.name}
    around = replace(frame, boxes=boxes, conditions=kept)
    left = [rel for c in on_it for rel in _left_of(c, approach, around)]
    around = replace(around, conditions=(*kept, *left))
    unclear = any(None in _near(c, approach, around).values() for c in on_it)
    inside = _inside(approach, (">", "<"))
    return around, unclear or (bool(inside) and not around.holds(*inside))


def _left_of(rel: Rel, approach: Approach, around: Frame) -> list[Rel]:
    """What an order between polynomials asks of the other symbols if it is to hold close to the
    limit: c0 + c1 v + ... > 0 for all small v > 0 asks for c0 >= 0, and for c0 > 0 where c1 < 0 and
    all that follows is zero.
    """
    sides = () if isinstance(approach.point, str) else approach.sides()
    if rel.operator not in ("<", "<=", ">", ">=") or len(sides) != 1:
        return []
    positive = rel.left - rel.right if rel.operator in (">", ">=") else rel.right - rel.left
    moved = approach.moved(positive, sides[0])
    if not _is_polynomial(moved):
        return []
    zero = number(0)
    first, slope = neat(substituted(moved, {SMALL: zero})), neat(differentiated(moved, SMALL))
    if constant_value(first) is not None:
        return []
    falls = SMALL not in symbols_of(slope) and around.holds(Rel("<", slope, zero))
    return [Rel(">" if falls else ">=", first, zero)]


def _is_polynomial(expr: Expr) -> bool:
    plain = ("number", "symbol", "add", "mul", "neg")
    return all(
        n.kind in plain or (n.kind == "pow" and n.fraction.denominator == 1 and n.fraction > 0)
        for n in walk(expr)
    )


def open_sides(approach: Approach, frame: Frame, around: Frame) -> list[int]:
    """The sides on which no condition excludes points close to the limit. Raises Undecided."""
    inside = _inside(approach, (">=", "<="))
    if inside and not around.holds(*inside):
        raise Undecided(f"the point may lie outside of the domain of {approach.label}")
    near = [_near(c, approach, around) for c in _on_it(frame, approach)]
    shut = {side for known in near for side, holds in known.items() if holds is False}
    sides = [side for side in approach.sides() if side not in shut]
    if not sides:
        raise Undecided("the conditions hold nowhere close to the limit")
    unclear = any(known[side] is None for known in near for side in sides)
    if unclear and not any(_is_met(approach, frame, side) for side in sides):
        raise Undecided(
            "the conditions tie the variable of the limit to other symbols: no values of these "
            "are known for which they hold close to the limit"
        )
    return sides


def constant_parts(name: str, *exprs: Expr) -> tuple[Expr, ...]:
    """The largest parts without the variable of a limit, divisors as what they divide 1 by: an
    expansion may cancel them, and yet the expressions have a value only where these have one.
    """
    found: dict[bytes, Expr] = {}
    seen: set[tuple[bytes, bool]] = set()
    pending = [(expr, False) for expr in exprs]
    while pending:
        node, divides = pending.pop()
        if (node.key, divides) in seen:
            continue
        seen.add((node.key, divides))
        if name in symbols_of(node):
            pending += zip(node.parts, _dividing(node, divides), strict=True)
        elif divides or node.parts:
            part = number(1) / node if divides else node
            found[part.key] = part
    return tuple(found.values())


def _dividing(node: Expr, divides: bool) -> list[bool]:
    """Of which parts it is seen that they must not be zero, if the node `divides` something."""
    match node.kind:
        case "div":
            return [divides, True]
        case "mul" | "neg":
            return [divides] * len(node.parts)
        case "pow":
            return [divides or node.fraction < 0]
        case _:
            return [False] * len(node.parts)


def with_values(needed: tuple[Expr, ...], *relations: Rel) -> Statement:
    """That relations hold, and nothing else than that these have values if there is none."""
    zero = number(0)
    return Statement(relations or (Rel("=", zero, zero),), needed=needed)


def _on_it(frame: Frame, approach: Approach) -> list[Rel]:
    return [c for c in frame.conditions if approach.name in symbols_of(c.left, c.right)]


def _inside(approach: Approach, orders: tuple[str, str]) -> list[Rel]:
    """That a point which is no number lies in the domain of the variable."""
    point, box = approach.point, approach.box
    if isinstance(point, str) or constant_value(point) is not None:
        return []
    ends = zip(orders, (box.lower, box.upper), strict=True)
    return [Rel(operator, point, number(end)) for operator, end in ends if end is not None]


def _near(rel: Rel, approach: Approach, around: Frame) -> dict[int, bool | None]:
    """For each side whether a condition holds close to the limit; None where that is not known."""
    return {side: _holds(rel, approach, side, around) for side in approach.sides()}


def _holds(rel: Rel, approach: Approach, side: int, around: Frame) -> bool | None:
    difference = neat(approach.moved(rel.left - rel.right, side))
    if difference == number(0):
        return 0 in ALLOWED[rel.operator]
    oracle = Coefficients(around)
    try:
        first = leading(expanded(difference, SMALL, oracle, Fraction(4)), oracle)
    except Undecided:
        return None
    for sign in (1, -1):
        if first is not None and oracle.is_positive(first[1] if sign > 0 else -first[1]):
            return sign in ALLOWED[rel.operator]
    return None


def _is_met(approach: Approach, frame: Frame, side: int) -> bool:
    """Whether for some values of the other symbols all conditions hold close to the limit."""
    bare = replace(frame, boxes={}, conditions=())
    for values in _samples(approach, frame):
        there = approach
        if not isinstance(approach.point, str):
            there = replace(approach, point=substituted(approach.point, values))
        put_in = (
            Rel(c.operator, substituted(c.left, values), substituted(c.right, values))
            for c in frame.conditions
        )
        if all(_holds(c, there, side, bare) for c in put_in):
            return True
    return False


def _samples(approach: Approach, frame: Frame) -> Iterator[dict[str, Expr]]:
    sides = [side for c in frame.conditions for side in (c.left, c.right)]
    point = () if isinstance(approach.point, str) else (approach.point,)
    names = sorted(symbols_of(*sides, *point) - {approach.name})
    boxes = [frame.boxes.get(name, Box()) for name in names]
    tried = [[number(v) for v in TRIED if box.holds(v)] for box in boxes]
    for values in islice(product(*tried), MOST_TRIED):
        yield dict(zip(names, values, strict=True))


class Coefficients(ProvingOracle):
    """What a frame knows of coefficients: the oracle of expansions. `valued` are constant parts of
    the formula that is expanded: nothing is asked about where these have no values.
    """

    def __init__(self, frame: Frame, valued: tuple[Expr, ...] = ()) -> None:
        self.frame = frame
        self._valued = where_valued(*valued)
        self._known: dict[tuple[str, Expr], bool] = {}

    def holds(self, operator: str, coefficient: Expr) -> bool:
        """Whether it is proved, which is asked once."""
        key = (operator, coefficient)
        if key not in self._known:
            self._known[key] = self._follows(operator, coefficient) or self.frame.holds(
                Rel(operator, coefficient, number(0))
            )
        return self._known[key]

    def _follows(self, operator: str, coefficient: Expr) -> bool:
        """Whether it is that of an expression of which a value asks as much."""
        stronger = [
            r.left for r in self._valued if set(ALLOWED[r.operator]) <= set(ALLOWED[operator])
        ]
        return any(self.frame.holds(Rel("=", coefficient, other)) for other in stronger)
