"""Simple rational points in the domains of symbols, at which statements are tried."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.statement import Statement
from gainproof.verify.judge.exact.witness import inside

WANTED = 50
"""All scales of all patterns: what is false far out only shows at the last."""
PATTERNS = (
    (1, 2, 3, 5, 7, 11),
    (2, 3, 5, 7, 11, 13),
    (5, 1, 7, 2, 3, 1),
    (1, 1, 1, 1, 1, 1),
    (9, 4, 1, 6, 2, 8),
    (-1, 2, -3, 5, -7, 11),
    (1, -2, -1, 3, 5, -4),
    (7, -2, 5, -1, 3, -1),
    (-1, -2, -3, -5, -7, -11),
    (-2, -1, 5, -3, 2, -7),
)


def simple_points(names: list[str], boxes: Mapping[str, Box]) -> Iterator[dict[str, Fraction]]:
    """Simple points inside the boxes, then the same with halves and thirds, and far out."""
    made: set[tuple[Fraction, ...]] = set()
    for scale in (1, Fraction(1, 2), 10, Fraction(1, 30), 1000):
        for pattern in PATTERNS:
            values = []
            for k, name in enumerate(names):
                wanted = Fraction(pattern[k % len(pattern)] + 20 * (k // len(pattern))) * scale
                value = inside(boxes.get(name, Box(stated=False)), wanted)
                if value is None:
                    break
                values.append(value)
            if len(values) < len(names):
                continue
            if tuple(values) not in made and len(made) < WANTED:
                made.add(tuple(values))
                yield dict(zip(names, values, strict=True))


def at_ends(names: list[str], boxes: Mapping[str, Box]) -> Iterator[dict[str, Fraction]]:
    """Points where a symbol is 0, or at an end of its domain that belongs to it."""
    others = next(simple_points(names, boxes), None)
    if others is None:
        return
    for name in names:
        for end in (Fraction(0), boxes[name].lower, boxes[name].upper):
            if end is not None and boxes[name].holds(end):
                yield {**others, name: end}


def at_bounds(statement: Statement, boxes: Mapping[str, Box]) -> Iterator[dict[str, Fraction]]:
    """Of an implication points where a symbol is, or nearly is, what it is compared with: where a
    conclusion just fails its premise has to fail.
    """
    names = sorted(statement.symbols())
    others = next(simple_points(names, boxes), None)
    if others is None or not statement.domain:
        return
    for rel in statement.all_relations():
        for side, other in ((rel.left, rel.right), (rel.right, rel.left)):
            if side.kind != "symbol" or other.kind != "number":
                continue
            for step in (0, 1, -1):
                value = other.fraction + Fraction(step, 64)
                if boxes.get(side.name, Box()).holds(value):
                    yield {**others, side.name: value}
