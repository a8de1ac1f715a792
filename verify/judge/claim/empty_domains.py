"""Domains that nothing can lie in: orders that go round in a circle, intervals without a number.

Found are contradictions among comparisons as they stand: `x < y` and `y < x`; `x > 2` and `x < 1`;
`0 < k < 1` for an integer. What needs algebra, such as `x^2 < 0`, is left to the judge.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.domain import bounded
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.formula import Relation
from gainproof.verify.judge.reader.latex_printer import relations_to_latex

MOST_RELATIONS = 100
"""More comparisons than these at once are not searched for contradictions."""
_ORDERS = ("<", "<=", ">", ">=", "=", "!=")


@dataclass(frozen=True)
class _Step:
    """Left is at most right; `strict`: less. `source` is the number of the comparison that says
    so, if one does.
    """

    left: bytes
    right: bytes
    strict: bool
    source: int | None


def contradiction(relations: Sequence[Relation], symbols: Mapping[str, SymbolEntry]) -> str | None:
    """The comparisons that contradict one another, in words; None if none were found."""
    if len(relations) > MOST_RELATIONS:
        return None
    kept = [relation for relation in relations if relation.operator in _ORDERS]
    try:
        read = [Rel(r.operator, read_graph(r.left), read_graph(r.right)) for r in kept]
    except Malformed:
        return None  # reported where the claim is judged
    guilty = _circle(read)
    if guilty is None:
        guilty = _empty_interval(read, symbols)
    if guilty is None:
        return None
    shown = " and ".join(dict.fromkeys(relations_to_latex([kept[n]]) for n in sorted(guilty)))
    return f"nothing satisfies {shown}"


def relations_of(tokens: Iterable[str], symbols: Mapping[str, SymbolEntry]) -> list[Relation]:
    """The domains of these symbols."""
    return [relation for token in tokens if token in symbols for relation in symbols[token].domain]


def _empty_interval(
    relations: Sequence[Rel], symbols: Mapping[str, SymbolEntry]
) -> set[int] | None:
    sides = [(side, n) for n, rel in enumerate(relations) for side in (rel.left, rel.right)]
    using: dict[str, set[int]] = {}
    for side, n in sides:
        if side.kind == "symbol" and side.name in symbols:
            using.setdefault(side.name, set()).add(n)
    boxes = {token: Box(integer=symbols[token].integer) for token in using}
    found, _ = bounded(boxes, relations)
    for token, box in found.items():
        if box.is_empty:
            return {n for n in using[token] if relations[n].operator != "!="}
    return None


def _circle(relations: Sequence[Rel]) -> set[int] | None:
    """Numbers of the comparisons on a circle of which one step is strict."""
    steps = [step for n, rel in enumerate(relations) for step in _steps(n, rel)]
    steps += _between_numbers([side for rel in relations for side in (rel.left, rel.right)])
    after: dict[bytes, list[_Step]] = {}
    for step in steps:
        after.setdefault(step.left, []).append(step)
    for step in steps:
        if step.strict:
            back = _path(step.right, step.left, after)
            if back is not None:
                return {s.source for s in (step, *back) if s.source is not None}
    for n, rel in enumerate(relations):
        if rel.operator == "!=":
            there = _path(rel.left.key, rel.right.key, after)
            back = _path(rel.right.key, rel.left.key, after)
            if there is not None and back is not None:
                return {n, *(s.source for s in (*there, *back) if s.source is not None)}
    return None


def _steps(number: int, rel: Rel) -> list[_Step]:
    low, high = rel.left.key, rel.right.key
    match rel.operator:
        case "<" | "<=":
            return [_Step(low, high, rel.operator == "<", number)]
        case ">" | ">=":
            return [_Step(high, low, rel.operator == ">", number)]
        case "=":
            return [_Step(low, high, False, number), _Step(high, low, False, number)]
        case _:
            return []


def _between_numbers(sides: Iterable[Expr]) -> list[_Step]:
    """The order of the numbers that stand in the comparisons."""
    values = {side.key: constant_value(side) for side in sides}
    known = sorted((value, key) for key, value in values.items() if value is not None)
    steps = []
    for (low, first), (high, second) in pairwise(known):
        steps.append(_Step(first, second, low < high, None))
        if low == high:
            steps.append(_Step(second, first, False, None))
    return steps


def _path(
    start: bytes, goal: bytes, after: Mapping[bytes, Sequence[_Step]]
) -> tuple[_Step, ...] | None:
    """Steps from start to goal, the fewest; none if they are the same, None if there is no way."""
    ways: dict[bytes, tuple[_Step, ...]] = {start: ()}
    waiting = [start]
    for place in waiting:
        if place == goal:
            return ways[place]
        for step in after.get(place, ()):
            if step.right not in ways:
                ways[step.right] = (*ways[place], step)
                waiting.append(step.right)
    return None
